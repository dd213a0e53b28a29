"""Our loop of embedded Runge–Kutta steps against diffrax's own, and against motions known in closed form."""

import subprocess
import sys
from typing import Any

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.integrators import _embedded as embedded
from polhode.integrators._sampled import sample_motion
from polhode.motion._outcome import Ending, Status
from polhode.systems import AbstractSystem
from sweeping import first

TIMES = np.linspace(0.0, 6.0, 13)
START = np.array([1.0, 0.2])
BY_ROUNDING = 1e-13  # of two loops that take the same steps
TOLERANCE = jnp.asarray(1e-10)


class Pendulum(AbstractSystem):
    """φ̈ = −sin φ + cos 2t / 2, up to φ = 3; the work of the drive is known."""

    def vector_field(self, t: Any, state: Any) -> Any:
        return jnp.stack([state[..., 1], 0.5 * jnp.cos(2.0 * t) - jnp.sin(state[..., 0])], axis=-1)

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}

    def balances(self, t: Any, state: Any) -> dict[str, Any]:
        energy = 0.5 * state[..., 1] ** 2 - jnp.cos(state[..., 0])
        return {"energy": ph.systems.Balance(energy, 0.5 * state[..., 1] * jnp.cos(2.0 * t))}

    @property
    def events(self) -> dict[str, Any]:
        return {"turned over": lambda t, state: 3.0 - state[..., 0]}


def run(start=START, times=TIMES, method=None, every=1, **more):
    times = jnp.asarray(times)
    method = diffrax.Dopri8() if method is None else method
    return sample_motion(Pendulum(), method, jnp.asarray(start), times, times[::every], None, TOLERANCE, **more)


@pytest.mark.sweep
@pytest.mark.parametrize("method", first(1, [diffrax.Dopri8, diffrax.Tsit5, diffrax.Heun]))
def test_a_motion_is_that_of_diffrax_and_takes_no_more_steps(method):
    method = method()
    # the second, in reverse mode, goes through diffrax.diffeqsolve; its first step is chosen otherwise
    ours, theirs = (run(method=method, reverse=reverse) for reverse in (False, True))
    assert ours.status == theirs.status == Status.COMPLETED and ours.event == theirs.event == -1
    close = 5e-7 if isinstance(method, diffrax.Heun) else 1e-9  # a hundred steps and more at 1e-10
    assert np.abs(ours.saved - theirs.saved).max() < close
    assert np.abs(ours.received["energy"] - theirs.received["energy"]).max() < close
    assert 0.8 * theirs.steps < ours.steps < 1.1 * theirs.steps + 5


@pytest.mark.sweep
def test_events_of_both_loops_agree():
    ours, theirs = (run(start=[1.0, 2.0], reverse=reverse) for reverse in (False, True))
    assert ours.status == theirs.status == Status.EVENT and ours.event == theirs.event == 0
    assert abs(ours.end - theirs.end) < 1e-9 and abs(ours.end_state[0] - 3.0) < BY_ROUNDING
    assert np.isinf(ours.saved[TIMES > ours.end]).all() and np.isfinite(ours.saved[TIMES < ours.end]).all()


@pytest.mark.long
def test_backwards_in_time_it_comes_back():
    there = run()
    back = run(there.saved[-1], TIMES[::-1])
    assert np.abs(back.saved[-1] - START).max() < 1e-9


@pytest.mark.long
def test_every_third_sample_is_one_of_all():
    assert np.array_equal(run(every=3).saved, run().saved[::3])


def test_a_run_that_is_left_and_entered_again_is_the_same():
    times, method = jnp.asarray(TIMES), diffrax.Dopri8()
    system = Pendulum()
    problem = embedded.Problem(system.vector_field, None, lambda t, y: y)

    @jax.jit
    def advanced(run, limit):
        return embedded.advance(run, method, problem, times, times, None, TOLERANCE, limit)

    begun = embedded.begin(jnp.asarray(START), times, times, problem.seen)
    whole, parts = advanced(begun, 10_000), begun
    for limit in range(4, 200, 4):
        parts = advanced(parts, limit)
    assert whole.status == parts.status == Status.COMPLETED and whole.steps > 8
    assert all(np.array_equal(a, b) for a, b in zip(jax.tree.leaves(whole), jax.tree.leaves(parts), strict=True))
    assert advanced(begun, 4).status == embedded.RUNNING and advanced(begun, 4).steps == 4


@pytest.mark.long
def test_complex_states_and_nests_are_integrated():
    times = jnp.asarray(TIMES)
    problem = embedded.Problem(
        lambda t, y: {"z": 1j * y["z"], "x": -y["x"]}, lambda t, y: jnp.real(y["z"][0]), lambda t, y: y["z"]
    )
    start = {"z": jnp.asarray([1.0 + 0j, 2.0j]), "x": jnp.ones(3)}
    run = embedded.begin(start, times, times, problem.seen)
    run = embedded.advance(run, diffrax.Dopri8(), problem, times, times, None, jnp.asarray(1e-13), 1000)
    assert run.status == Status.EVENT and abs(run.end - np.pi / 2) < 1e-11
    assert np.abs(run.end_state["x"] - np.exp(-np.pi / 2)).max() < 1e-11
    assert np.abs(run.saved[1] - np.exp(0.5j) * np.asarray(start["z"])).max() < 1e-11


@pytest.mark.long
def test_the_time_of_an_event_moves_with_what_it_depends_on():
    """z̈ = −g from height z with speed v reaches the ground at T = (v + √(v² + 2gz))/g."""
    times = jnp.linspace(0.0, 9.0, 4)

    def landing(gravity, start):
        problem = embedded.Problem(
            lambda t, y: jnp.stack([y[1], -gravity]), lambda t, y: y[0], lambda t, y: y
        )
        run = embedded.begin(start, times, times, problem.seen)
        run = embedded.advance(run, diffrax.Dopri5(), problem, times, times, None, TOLERANCE, 1000)
        return embedded.at_event(run, problem.rates, problem.margin)

    exact = lambda g, y: (y[1] + jnp.sqrt(y[1] ** 2 + 2.0 * g * y[0])) / g  # noqa: E731
    given, way = (jnp.asarray(2.0), jnp.asarray([3.0, 0.7])), (jnp.asarray(0.3), jnp.asarray([-0.2, 1.1]))
    (time, _), (later, moved) = jax.jvp(landing, given, way)
    expected, change = jax.jvp(exact, given, way)
    assert abs(time - expected) < BY_ROUNDING and abs(later - change) < BY_ROUNDING
    assert abs(moved[0]) < BY_ROUNDING  # on the ground it stays
    assert abs(moved[1] - (way[1][1] - way[0] * time - given[0] * change)) < BY_ROUNDING


@pytest.mark.parametrize("rates", [lambda t, y: y**2, lambda t, y: jnp.nan * y, lambda t, y: y / (2.0 - t) ** 3])
def test_what_has_no_motion_up_to_the_end_says_so(rates):
    times = jnp.linspace(0.0, 4.0, 3)
    problem = embedded.Problem(rates, None, lambda t, y: y)
    run = embedded.begin(jnp.ones(2), times, times, problem.seen)
    run = embedded.advance(run, diffrax.Dopri8(), problem, times, times, None, TOLERANCE, 100_000)
    assert run.status == Status.NOT_CONVERGED and run.steps < 5000 and run.time < 2.0 + 1e-9


class Decaying(AbstractSystem):
    """ẏ = −y, or anything else, up to an event."""

    rates: Any = eqx.field(static=True, default=None)
    event: Any = eqx.field(static=True, default=None)

    def vector_field(self, t: Any, state: Any) -> Any:
        return -state if self.rates is None else self.rates(t, state)

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}

    @property
    def events(self) -> dict[str, Any]:
        return {} if self.event is None else {"end": self.event}


@pytest.mark.parametrize("start", [1e6, 1e9, 1e12])
def test_far_from_time_zero_the_state_keeps_to_the_times_as_they_are_rounded(start, stepper):
    times = start + np.linspace(0.0, 5.0, 6)
    found = ph.simulate(Decaying(), [1.0], times, stepper)
    assert np.abs(found.states[:, 0] - np.exp(start - times)).max() < 1e-13
    assert found.error_estimate < 1e-12


@pytest.mark.parametrize("backward", [False, True])
def test_an_event_at_time_zero_of_a_run_from_elsewhere_is_found(backward, stepper):
    sign = -1.0 if backward else 1.0
    system = Decaying(lambda t, y: jnp.ones_like(y), lambda t, y: -sign * t)
    found = ph.simulate(system, [-2.0], np.array([-2.0, 3.0]) * sign, stepper)
    assert found.outcome.event == "end" and abs(found.times[-1]) < 1e-15


def test_a_start_past_its_event_ends_at_once():
    found = ph.solve(Decaying(event=lambda t, y: y[0] - 0.5), jnp.asarray([0.4]), jnp.asarray([0.0, 1.0, 2.0]))
    assert found.status == Status.EVENT and found.end == 0.0 and found.end_state[0] == 0.4
    assert np.isinf(found.saved[1:]).all()


def test_an_event_that_ceases_to_be_a_number_ends_the_motion_there(stepper):
    system = Decaying(lambda t, y: jnp.ones_like(y), lambda t, y: jnp.sqrt(2.0 - t))
    found = ph.simulate(system, [0.0], [0.0, 5.0], stepper)
    assert found.outcome.event == "end" and abs(found.times[-1] - 2.0) < 1e-14


@pytest.mark.parametrize(
    ("rates", "event", "words"),
    [
        (lambda t, y: y[:1], None, r"in its shape; got shape \(1,\) for \(2,\)"),
        (lambda t, y: y[0], None, r"in its shape; got shape \(\)"),
        (lambda t, y: [y[1], -y[0]], None, r"array; got a list. Join the rates by jnp.stack\(\[…\]\), in .* \(2,\)"),
        (lambda t, y: [y[1], -t * y[0]], None, "as an array; got a list"),
        (lambda t, y: None, None, "as an array; got a NoneType. Return the rates, in the state's shape"),
        (lambda t, y: 1j * y, None, "complex rates of change of a real state"),
        (None, lambda t, y: y[:1], r"event 'end' must be one real number at a time and a state.*got shape \(1,\)"),
        (None, lambda t, y: y[0] < 0.5, "got one of type bool. Give what is compared instead"),
        (None, lambda t, y: y[0] + 1j, "got one of type complex128"),
        (None, lambda t, y: None, "got None. Write it with jax.numpy"),
        (None, lambda t, y: jnp.log(-y[0]), "number at the start; end is NaN there. Start where"),
    ],
)
def test_rates_and_events_of_a_wrong_form_are_refused(rates, event, words, stepper):
    with pytest.raises(InvalidInput, match=words):
        ph.simulate(Decaying(rates, event), [1.0, 2.0], [0.0, 1.0], stepper)


@pytest.mark.parametrize(
    ("rates", "states", "words"),
    [
        (lambda t, y: jnp.log(y), [1.0, -1.0], r"`vector_field` of Decaying must be finite .*; got \[0.0, nan\]"),
        (lambda t, y: jnp.sqrt(y) * t, [1.0, -1.0], r"at the start; got \[0.0, nan\] at 0 s. Start elsewhere"),
        (lambda t, y: 1.0 / y, [1.0, 0.0], r"got \[1.0, inf\]"),
        (lambda t, y: jnp.abs(y) / jnp.abs(y), [1.0, 0.0], r"got \[1.0, nan\]"),
        (lambda t, y: jnp.log(y), [[1.0, 1.0], [1.0, -1.0]], r"at the start in 1 of 2 copies, first \(1,\); got"),
    ],
)
@pytest.mark.filterwarnings("error::RuntimeWarning")
def test_rates_that_are_no_numbers_at_the_start_are_refused(rates, states, words):
    with pytest.raises(InvalidInput, match=words):
        ph.simulate(Decaying(rates), states, [0.0, 1.0])


def test_rates_that_are_no_numbers_at_the_start_are_refused_by_each_method(stepper):
    system = Decaying(lambda t, y: jnp.log(y))
    with pytest.raises(InvalidInput, match="must be finite at the start"):
        ph.simulate(system, [-1.0], [0.0, 1.0], stepper)
    with pytest.raises(InvalidInput, match="must be finite at the start"):
        ph.section(system, [-1.0], lambda t, y: y[0], [0.0, 1.0])
    found = ph.simulate(system, [-1.0], [0.0, 1.0], stepper, throw=False)
    assert found.outcome.ending is Ending.NOT_CONVERGED


class Listed(Decaying):
    """One whose event has no name."""

    @property
    def events(self) -> Any:
        return [self.event]


@pytest.mark.parametrize(
    "run",
    [ph.simulate, ph.solve, lambda system, *given: ph.section(system, given[0], lambda t, y: y[0] - 0.5, given[1])],
    ids=["simulate", "solve", "section"],
)
def test_events_without_names_are_refused(run):
    with pytest.raises(InvalidInput, match=r"`events` of Listed must be functions .*, {name: function}; got \["):
        run(Listed(event=lambda t, y: y[0] - 0.5), jnp.asarray([1.0]), [0.0, 1.0])


@pytest.mark.sweep
def test_an_interrupt_ends_a_long_adaptive_run_soon():
    code = (
        "import os, signal, threading, numpy as np, polhode as ph\n"
        "from polhode.celestial import SpinOrbit\n"
        "orbit = SpinOrbit(0.9, 0.1, 1.0)\n"
        "def run(end):\n"
        "    ph.simulate(orbit, (0.3, 1.8), np.linspace(0, end, 3), estimate_error=False)\n"
        "run(1.0)\n"
        "threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "try:\n"
        "    run(1e6)\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted')\n"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert found.stdout == "interrupted\n", found.stderr[-2000:]
