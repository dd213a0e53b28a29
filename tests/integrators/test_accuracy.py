"""The error that a trajectory says, beside the error that it has."""

from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import celestial, spacecraft, systems
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import LieMidpoint, MuntheKaas, Splitting
from polhode.integrators import _equal_steps as equal_steps
from polhode.integrators._difference import starts_a_rounding_away
from sweeping import first
from taylor.test_coefficients import OwnField

FACTOR = 10.0  # between an estimate and the error
# of estimates by Taylor, which are four times what moves of all numbers by their last places grow to: roundings come
# later and are smaller, and where they only add up, estimates are 10 to 60 times too large
TAYLOR = 100.0
ROUNDING = 1e-13  # errors below it are claimed by no estimate
DEFAULT = 1e-9  # state error of the default method and step at t = 100
MOMENTS = (1.0, 2.0, 3.0)
START = np.array([0.5, -0.5, 0.1, 0.7, 0.3, 1.8, 1.5])
START[:4] /= np.linalg.norm(START[:4])
EXACT = ph.FreeMotion(MOMENTS, momentum=START[4:], attitude=START[:4])
SPARSE = np.linspace(0.0, 100.0, 11)
body = systems.FreeRigidBody(MOMENTS)


def error_of(found: Any, exact: Any = EXACT) -> float:
    attitude, momentum = exact.state(found.times)
    off = np.abs(found.momentum - momentum).max() / np.abs(momentum).max()
    return max(off, np.abs(found.attitude - attitude).max())


def check(found: Any, exact: Any = EXACT, most: float = FACTOR) -> None:
    estimate, error = float(found.error_estimate), error_of(found, exact)
    assert error / FACTOR <= estimate <= most * error or max(error, estimate) < ROUNDING, (estimate, error)


@pytest.mark.long_cases("None-more0")
@pytest.mark.parametrize(
    ("method", "more"),
    [
        (None, {}), (Splitting, {}), (Splitting, {"order": 4, "step": 0.2}),
        *(pytest.param(method, more, marks=pytest.mark.sweep) for method, more in [
            (Splitting, {"order": 2}), (Splitting, {"order": 8, "step": 0.5}), (MuntheKaas, {"step": 0.1}),
            (LieMidpoint, {"order": 6}),
        ]),
    ],
)  # fmt: skip
def test_estimate_beside_the_exact_motion(method, more):
    found = ph.simulate(body, START, SPARSE, method, **more)
    check(found, most=TAYLOR if method is None else FACTOR)


def test_the_default_is_exact_enough():
    for method in (None, Splitting):
        assert error_of(ph.simulate(body, START, SPARSE, method)) < DEFAULT


@pytest.mark.parametrize(
    "times", first(1, [np.cumsum(np.random.default_rng(0).uniform(0.01, 2.0, 100)), np.linspace(0.0, 100.0, 801)]),
    ids=["uneven", "a step apart"],
)  # fmt: skip
def test_estimate_whatever_the_samples(times):
    found = ph.simulate(body, START, times, step=0.5, order=4)
    check(found, ph.FreeMotion(MOMENTS, momentum=START[4:], attitude=START[:4], epoch=times[0]))


@pytest.mark.sweep
def test_estimate_beside_the_exact_top():
    moments, attitude = (1.0, 1.0, 0.5), np.array([0.9, 0.3, 0.2, 0.1]) / np.linalg.norm([0.9, 0.3, 0.2, 0.1])
    top = systems.HeavyTop(moments, 1.0)
    state = np.asarray(top.pack(attitude, angular_velocity=(0.3, 0.2, 6.0)))
    exact = ph.LagrangeMotion(moments, mgl=1.0, momentum=state[4:7], attitude=attitude)
    for order, step in ((None, None), (2, None), (6, 0.1)):
        found = ph.simulate(top, state, SPARSE, Splitting, order=order, step=step)
        check(found, exact)
    found = ph.simulate(top, state, SPARSE)
    assert error_of(found, exact) / 3.0 < found.error_estimate < TAYLOR * error_of(found, exact)
    assert error_of(ph.simulate(top, state, SPARSE), exact) < DEFAULT


class Shaken(systems.FreeRigidBody):
    """Turned to and fro from outside, hard enough for chaos."""

    def generator(self, t, point):
        return super().generator(t, point) + 2.0 * jnp.sin(t) * jnp.array([0.6, 0.0, 1.0])

    @property
    def conserves_energy(self):
        return False


@pytest.mark.long
def test_a_chaotic_motion_says_that_it_is_lost():
    shaken: Any = Shaken
    momentum = START[4:]
    found: Any = ph.simulate(shaken(MOMENTS), momentum, [0.0, 200.0], MuntheKaas, step=0.1)
    turn = lambda t, L: np.cross(L, L / MOMENTS + 2.0 * np.sin(t) * np.array([0.6, 0.0, 1.0]))  # noqa: E731
    true = solve_ivp(turn, (0.0, 200.0), momentum, "DOP853", rtol=1e-13, atol=1e-13).y[:, -1]
    assert np.abs(found.states[-1] - true).max() > 0.1, "not lost: choose a harder drive"
    assert found.drift["|L|²"] < ROUNDING
    assert found.error_estimate > 0.1


@pytest.mark.parametrize("tolerance", [1e-3, 1e-8, 1e-12])
def test_tolerance_chooses_the_step(tolerance):
    found = ph.simulate(body, START, SPARSE, order=6, tolerance=tolerance)
    assert found.error_estimate <= tolerance
    assert error_of(found) < 2.0 * tolerance


@pytest.mark.long
def test_a_tolerance_that_rounding_does_not_let_through():
    with pytest.raises(NotConverged, match="`tolerance` 3e-16 could not be met"):
        ph.simulate(body, START, SPARSE, order=6, tolerance=3e-16)


def test_a_tolerance_below_rounding_is_refused_before_the_run():
    with pytest.raises(InvalidInput, match=r"`tolerance` must be at least 2\.2e-16"):
        ph.simulate(body, START, 0.1 * SPARSE, order=6, tolerance=1e-18)


@pytest.mark.parametrize("tolerance", [None, 1e-8])
def test_estimate_of_adaptive_steps(tolerance):
    found = ph.simulate(body, START, SPARSE, diffrax.Dopri8(), tolerance=tolerance)
    check(found)


def test_no_estimate_is_none():
    assert ph.simulate(body, START, SPARSE, estimate_error=False).error_estimate is None
    assert EXACT.sample(SPARSE).error_estimate is None


@pytest.mark.long
def test_estimate_and_tolerance_compile_nothing_more():
    run: Any = equal_steps._go_one
    compiled = run._cached
    ph.simulate(body, START, SPARSE, order=6, estimate_error=False)
    before = compiled._cache_size()
    ph.simulate(body, START, SPARSE, order=6, tolerance=1e-12)
    ph.simulate(body, START, 2.0 * SPARSE, order=6, step=0.3)
    assert compiled._cache_size() == before
    ph.simulate(body, START, SPARSE[:5], order=6)
    assert compiled._cache_size() == before + 1


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"tolerance": 0.0}, "`tolerance` must be a positive"),
        ({"tolerance": np.nan}, "`tolerance` must be a positive"),
        ({"tolerance": 1e-6, "step": 0.1}, "not both"),
        ({"tolerance": 1e-6, "method": Splitting(body, jnp.asarray(0.1))}, "made with its own"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(more, words):
    with pytest.raises(InvalidInput, match=words):
        ph.simulate(body, START, SPARSE, **more)


def beside_the_separatrix(rng: Any, count: int, low: float, high: float) -> Any:
    """Return momenta of the body off its separatrix by 10^low to 10^high of the third component."""
    momenta = rng.normal(size=(count, 3))
    off = 10.0 ** rng.uniform(low, high, count) * rng.choice([-1.0, 1.0], count)
    momenta[:, 2] = momenta[:, 0] * np.sqrt((1.0 - 1.0 / 2.0) / (1.0 / 2.0 - 1.0 / 3.0)) * (1.0 + off)
    return momenta


def errors_over_estimates(system: Any, momenta: Any, times: Any, method: Any) -> Any:
    found = ph.simulate(system, momenta, times, method)
    exact = np.moveaxis(np.stack([ph.FreeMotion(MOMENTS, momentum=momenta).state(t)[1] for t in times]), 0, 1)
    off = np.linalg.norm(found.states - exact, axis=-1).max(axis=-1) / np.linalg.norm(momenta, axis=-1)
    return off / np.asarray(found.error_estimate)


any_function: Any = systems.LiePoisson(ph.algebra.SO3(), lambda L: 0.5 * jnp.sum(L**2 / np.array(MOMENTS), axis=-1))


@pytest.mark.long
@pytest.mark.parametrize("method", [None, LieMidpoint])
def test_the_estimate_holds_near_a_separatrix(method):
    """Rounding grows there to all of the error; divided as truncation it made the median 214, the worst 2,840."""
    momenta = beside_the_separatrix(np.random.default_rng(0), 64, -12.0, -7.0)
    shares = errors_over_estimates(any_function, momenta, np.linspace(0.0, 40.0, 21), method)
    assert shares.max() < 10.0 and 0.02 < np.median(shares) < 5.0, (shares.max(), np.median(shares))


@pytest.mark.sweep
@pytest.mark.parametrize(("system", "method"), [(body, Splitting), (any_function, LieMidpoint), (any_function, None)])
@pytest.mark.parametrize(("low", "high"), [(-15.0, -12.0), (-12.0, -7.0), (-7.0, -3.0), (-3.0, -1.0)])
def test_a_thousand_starts_near_a_separatrix(system, method, low, high):
    momenta = beside_the_separatrix(np.random.default_rng(1), 250, low, high)
    for times in (np.linspace(0.0, 40.0, 21), np.linspace(0.0, 10.0, 11)):
        shares = errors_over_estimates(system, momenta, times, method)
        assert shares.max() < 30.0 and np.median(shares) > 0.02, (shares.max(), np.median(shares))


@pytest.mark.parametrize("method", [None, Splitting])
def test_what_rests_on_a_saddle_has_no_error(method):
    """A rounding would grow to everything there; where none was made the estimate does not claim it."""
    found = ph.simulate(body, np.array([0.0, 2.0, 0.0]), SPARSE, method)
    assert np.abs(found.states - [0.0, 2.0, 0.0]).max() == 0.0 and found.error_estimate < ROUNDING


@pytest.mark.sweep
def test_samples_that_make_the_steps_do_not_hide_the_error():
    """Chaos: a hundred orbits of Hyperion are lost to rounding and truncation; it was said to be 5e-17 off."""
    hyperion = celestial.SpinOrbit(asphericity=0.89, eccentricity=0.1)
    start, times = np.array([np.pi / 2, 1.0]), np.linspace(0.0, 60.0 * np.pi, 2001)
    found = ph.simulate(hyperion, start, times, diffrax.Dopri8())
    # samples elsewhere are steps elsewhere
    other = ph.simulate(hyperion, start, np.linspace(0.0, 60.0 * np.pi, 1501), diffrax.Dopri8(), estimate_error=False)
    apart = np.abs(found.states[-1] - other.states[-1]).max() / np.abs(found.states).max()
    assert apart > 1e-13 and found.error_estimate > 0.1 * apart


LEFT_THE_SADDLE = [
    # splitting, ends at the other saddle: told 9.6e-7
    (body, Splitting, [-2.8334101348668622e-11, 4.680678258523867, -2.858871617749798e-11], 2),
    # adaptive steps: error 3.5e-4, told 2.2e-6
    (spacecraft.RigidBody(MOMENTS), diffrax.Dopri8(), [1e-12, 2.0, 1e-12], 13),
]


@pytest.mark.long_cases("system1-method1-start1-13")
@pytest.mark.parametrize(("system", "method", "start", "count"), LEFT_THE_SADDLE)
def test_runs_that_are_at_the_same_saddle_by_chance_do_not_vouch_for_each_other(system, method, start, count):
    start, times = np.array(start), np.linspace(0.0, 60.0, count)
    found = ph.simulate(system, start, times, method)
    exact = ph.FreeMotion(MOMENTS, momentum=start).state(times)[1]
    error = np.linalg.norm(found.states[:, -3:] - exact, axis=-1).max() / np.linalg.norm(start)
    assert error > 1e-5 and error < 30.0 * found.error_estimate


@pytest.mark.long
def test_steps_too_long_for_the_law_of_their_order_are_not_trusted():
    """Order 8 by steps of 2 s: error 3.9e-4, told 4.3e-5 by Richardson's law, as the runs are 2.5e-3 apart only."""
    moving = systems.Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0))
    start = np.array([-0.08707444838262461, -0.027187197313766513, -0.05568395359055866,
                      1.0167638919422743, 0.06037187320480484, -0.04595385454645717])  # fmt: skip
    times = np.linspace(0.0, 80.0, 9)
    found = ph.simulate(moving, start, times, Splitting)
    rates = jax.jit(lambda y: moving.vector_field(0.0, y))
    exact = solve_ivp(lambda t, y: rates(y), (0.0, 80.0), start, "DOP853", times, rtol=1e-13, atol=1e-15).y.T
    error = np.abs(found.states - exact).max()
    assert error > 3e-4 and error < 3.0 * found.error_estimate < 10.0 * error


def test_a_rounding_is_the_last_place_of_a_number():
    """A share ε of π is one and a half last places, and was rounded to two: pendulums had twice the estimate."""
    pendulum: Any = OwnField(lambda t, y: jnp.stack([y[1], -jnp.sin(y[0])]))
    start = np.array([np.pi, 0.0])
    for kicked in starts_a_rounding_away(pendulum, start):
        assert abs(kicked[0] - np.pi) == np.spacing(np.pi) and kicked[1] == 0.0
    momentum = np.array([1.9, -1e-12, 0.0])
    for kicked in starts_a_rounding_away(body, momentum):
        assert (np.abs(kicked - momentum) == [np.spacing(1.9), np.spacing(1e-12), 0.0]).all()
    twist = 3.0 + 1e-9j
    for kicked in starts_a_rounding_away(pendulum, np.array([twist])):
        assert abs(kicked[0].real - 3.0) == np.spacing(3.0) and abs(kicked[0].imag - 1e-9) == np.spacing(1e-9)
