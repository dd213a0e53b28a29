"""simulate: what it chooses, warns of, refuses, and reports."""

import functools
import warnings

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import fields, systems
from polhode.errors import InvalidInput, NotConverged
from polhode.formats.dataset import write_dataset
from polhode.formats.dataset_reading import read_dataset
from polhode.integrators import LieMidpoint, MuntheKaas, SphericalMidpoint, Splitting
from polhode.motion import Ending
from specimens import in_su3, spins
from sweeping import first

MOMENTS, MOMENTUM = (1.0, 2.0, 3.0), np.array([0.3, 1.8, 1.5])
body = systems.FreeRigidBody(MOMENTS)
other_body = systems.FreeRigidBody((1.0, 2.0, 2.5))
START = np.concatenate([[1.0, 0, 0, 0], MOMENTUM])
TIMES = np.linspace(0.0, 5.0, 11)


@pytest.mark.long
def test_against_the_exact_motion():
    found = ph.simulate(body, START, TIMES)
    motion = ph.FreeMotion(MOMENTS, momentum=MOMENTUM)
    assert np.abs(found.attitude - motion.attitude(TIMES)).max() < 1e-11
    assert np.abs(found.momentum - motion.momentum(TIMES)).max() < 1e-11
    assert np.abs(found.angular_velocity - motion.angular_velocity(TIMES)).max() < 1e-11
    assert (found.times == TIMES).all() and found.states.shape == (11, 7)
    assert isinstance(found.states, np.ndarray)


@pytest.mark.long
def test_a_batch_is_its_members():
    many = np.stack([START, np.concatenate([[0.5, 0.5, 0.5, 0.5], [2.0, -1.0, 0.4]])]).reshape(2, 1, 7)
    both = ph.simulate(body, many, TIMES, step=0.02)
    assert both.states.shape == (2, 1, 11, 7) and both.drift["energy"].shape == (2, 1)
    for k in range(2):
        one = ph.simulate(body, many[k, 0], TIMES, step=0.02)
        assert np.abs(both.states[k, 0] - one.states).max() < 1e-14


def test_defaults_go_with_the_system():
    pair = systems.LiePoisson(lie.Power(lie.SO3(), 2), spins)
    eight = systems.LiePoisson(lie.SU(3), in_su3)
    line = systems.LiePoisson(lie.AffineLine(), lambda m: jnp.sum(m**2))
    from polhode.integrators._choice import orbit_solver

    for system, wanted in ((body, Splitting), (pair, SphericalMidpoint), (eight, LieMidpoint), (line, LieMidpoint)):
        assert type(orbit_solver(system, None, None)) is wanted
    assert orbit_solver(eight, None, None).coordinates == "cayley"
    assert orbit_solver(line, None, None).coordinates == "exp"


@pytest.mark.long
def test_steps_fit_between_uneven_samples_and_are_counted():
    found = ph.simulate(body, START, [0.0, 0.1, 0.35, 1.0], LieMidpoint, step=0.1)
    assert found.statistics["steps"] == 1 + 3 + 7
    assert found.statistics["iterations"] > found.statistics["steps"]


def test_a_diffrax_solver_may_be_given():
    found = ph.simulate(body, START, TIMES, diffrax.Dopri8())
    assert np.abs(found.momentum - ph.FreeMotion(MOMENTS, momentum=MOMENTUM).momentum(TIMES)).max() < 1e-9


@pytest.mark.parametrize("scale", first(1, [1e-200, 1e200]))
@pytest.mark.parametrize("heavy", first(1, [True, False]))
def test_states_whose_squares_are_no_numbers(scale, heavy):
    moments, times = np.array(MOMENTS) * (scale if heavy else 1.0), TIMES * (1.0 if heavy else 1.0 / scale)
    with pytest.warns(UserWarning, match="beyond double precision"):
        found = ph.simulate(systems.FreeRigidBody(moments), scale * MOMENTUM, times, LieMidpoint)
    wanted = ph.FreeMotion(MOMENTS, momentum=MOMENTUM).momentum(TIMES)
    assert np.abs(found.states / scale - wanted).max() < 1e-9
    assert "|L|²" not in found.drift and all(value < 1e-12 for value in found.drift.values())
    assert found.error_estimate < 1e-9


@pytest.mark.sweep
def test_equilibria_stay():
    pair = systems.LiePoisson(lie.Power(lie.SO3(), 2), spins)
    up = np.array([[0.0, 0, 1], [0, 0, 1]])
    assert np.abs(ph.simulate(pair, up, TIMES).states - up).max() == 0.0
    rest = ph.simulate(body, np.zeros(3), TIMES)
    assert not rest.states.any()
    well = systems.LiePoisson(lie.SO3(), lambda m: 0.5 * jnp.sum((m - jnp.array([0.3, 0.1, 0.7])) ** 2))
    near = np.array([0.3, 0.1, 0.7]) * (1 + 1e-15)
    assert np.abs(ph.simulate(well, near, TIMES, LieMidpoint, step=0.1).states - near).max() < 1e-14


@pytest.mark.long
def test_a_long_step_draws_a_warning():
    with pytest.warns(UserWarning, match="turns the fastest rotation by"):
        ph.simulate(body, START, np.array([0.0, 10.0]), step=2.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ph.simulate(body, START, TIMES)
        ph.simulate(body, START, TIMES, step=2.0)  # samples are nearer than that


@pytest.mark.long
@pytest.mark.filterwarnings("ignore:a step of")
def test_a_step_that_does_not_converge_says_so():
    with pytest.raises(NotConverged, match="shorter `step`"):
        ph.simulate(body, START, [0.0, 20.0], LieMidpoint, step=5.0)
    found = ph.simulate(body, START, [0.0, 20.0, 40.0], LieMidpoint, step=5.0, throw=False)
    assert found.outcome.ending is Ending.NOT_CONVERGED
    assert not np.isfinite(found.states[-1]).any()


@pytest.mark.long
def test_progress_is_shown_on_standard_error(capfd):
    ph.simulate(body, START, np.linspace(0.0, 1.0, 50), step=0.01, progress=True)
    out, err = capfd.readouterr()
    assert "100.00%" in err and not out


@pytest.mark.long
def test_as_dataset_and_netcdf(tmp_path):
    found = ph.simulate(body, START, TIMES)
    dataset = ph.as_dataset(found)
    assert dataset["momentum"].dims == ("time", "axis") and dataset["energy"].attrs["drift"] < 1e-3
    from polhode.formats.dataset import write_dataset

    assert write_dataset(found, tmp_path / "run.nc").stat().st_size > 0
    kinds = ph.simulate(systems.Manakov((1.0, 2.0, 3.0, 4.0)), np.zeros((4, 4)) + np.triu(np.ones((4, 4)), 1)
                        - np.tril(np.ones((4, 4)), -1), TIMES)  # fmt: skip
    assert ph.as_dataset(kinds)["state"].shape == (11, 4, 4)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ph.simulate(body, np.ones(5), TIMES), r"shape \(…, 3\) or \(…, 7\)"),
        (lambda: ph.simulate(body, [1.0, np.nan, 0.0], TIMES), "finite"),
        (lambda: ph.simulate(body, np.ones(7), TIMES), "unit quaternion"),
        (lambda: ph.simulate(body, START, [0.0]), "at least two"),
        (lambda: ph.simulate(body, np.ones((0, 3)), TIMES), r"no copies to move; got shape \(0, 3\)"),
        (lambda: ph.simulate(body, START, ["a", "b"]), "must be numbers"),
        (lambda: systems.BodyInPotential(MOMENTS, lambda up: up), "real scalar"),
        (lambda: systems.BodyInPotential(MOMENTS, lambda up: np.sin(up[2])), "jax.numpy"),
        (lambda: ph.simulate(body, START, [0.0, 1.0, 0.5]), "one direction.*; got 0.5 after 1.0 at index 2. Sort them"),
        (lambda: ph.simulate(body, START, [1.0, 1.0]), "got 1.0 after 1.0 at index 1"),
        (lambda: ph.simulate(body, START, [0.0, np.nan]), r"`times` must be finite \[s\]; got nan at index 1"),
        (lambda: ph.simulate(body, START, TIMES, step=0.0), "`step` must be a positive"),
        (lambda: ph.simulate(body, START, TIMES, step=-1.0), "`step` must be a positive"),
        (lambda: ph.simulate(body, START, TIMES, step=np.nan), "`step` must be a positive"),
        (lambda: ph.simulate(body, START, TIMES, method="rk4"), "`method` must be"),
        (lambda: ph.simulate(body, START, TIMES, order=3), "2, 4, 6 or 8"),
        (lambda: ph.simulate(body, START, TIMES, Splitting(body, jnp.asarray(0.1)), step=0.1), "made with its own"),
        (lambda: ph.simulate(body, START, TIMES, Splitting(other_body, jnp.asarray(0.1))), "another system"),
        (lambda: ph.simulate(body, START, TIMES, SphericalMidpoint), "not an attitude"),
        (lambda: ph.simulate(3.0, START, TIMES), "`system` must be"),
        (lambda: ph.simulate(systems.LiePoisson(lie.SU(3), in_su3), np.zeros((3, 3)), TIMES, Splitting), "exact flows"),
        (lambda: systems.LiePoisson(lie.SO3(), lambda m: m), "real scalar"),
        (lambda: systems.LiePoisson(lie.SO3(), lambda m: 1j * m[0]), "real scalar"),
        (lambda: systems.LiePoisson(lie.SO3(), lambda m: m[7, 7]), "cannot be evaluated"),
        (lambda: systems.LiePoisson(lie.SO3(), jnp.sum, sign=0), "sign"),
        (lambda: systems.FreeRigidBody((1.0, 2.0, -3.0)), "positive"),
        (lambda: systems.Kirchhoff(np.diag([1.0, 1, 1, 1, 1, -1])), "positive definite"),
        (lambda: systems.Kirchhoff(np.ones(5)), "shape"),
        (lambda: systems.Manakov((1.0, 2.0)), "at least three"),
        (lambda: systems.Manakov((1.0, 2.0, -1.5)), "positive sums"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


@pytest.mark.long_after(1)
@pytest.mark.parametrize("copies", [(), (3,)])
def test_a_trajectory_goes_on_to_the_same_bits(copies, tmp_path):
    """Through a file where there is one copy; without its memory the same steps end in other roundings."""
    state = np.random.default_rng(2).normal(size=(*copies, 3))
    times = np.linspace(0.0, 6.0, 25)
    run = functools.partial(ph.simulate, body, method=LieMidpoint, step=0.05, order=2, estimate_error=False)
    whole, half = run(state, times), run(state, times[:13], resumable=True)
    if not copies:
        half = read_dataset(write_dataset(half, tmp_path / "half.nc"))
    last = half.states[..., -1, :]
    assert np.array_equal(run(last, times[12:], memory=half.memory).states, whole.states[..., 12:, :])
    assert not np.array_equal(run(last, times[12:]).states, whole.states[..., 12:, :])
    assert run(state, times).memory is None


def test_what_cannot_go_on_is_refused():
    memory = ph.simulate(body, (0.1, 1.0, 0.3), (0.0, 1.0), LieMidpoint, 0.1, resumable=True).memory
    for given, words in (
        ({"method": MuntheKaas, "step": 0.1, "memory": memory[:-1]}, "must be that of a run of MuntheKaas"),
        ({"method": diffrax.Dopri8(), "memory": memory}, "Taylor series of large arrays; others start over"),
        ({"method": diffrax.Dopri8(), "resumable": True}, "Taylor series of large arrays; others start over"),
        ({"method": LieMidpoint, "tolerance": 1e-6, "memory": memory}, "goes with the earlier run's `step`"),
        ({"resumable": True, "save": 2}, "needs the last time among"),
    ):
        with pytest.raises(InvalidInput, match=words):
            ph.simulate(body, (0.1, 1.0, 0.3), (0.0, 0.4, 0.7, 1.0), **given)


def test_derivatives_of_simulate_by_what_a_function_encloses_say_so():
    def last(rate):
        system = systems.LiePoisson(lie.SO3(), lambda L: rate * L[2] ** 2 + L[0] ** 2)
        return ph.simulate(system, MOMENTUM, TIMES).states[-1, 0]

    with pytest.raises(InvalidInput, match="the arguments of `simulate` must be known numbers, not traced by JAX"):
        jnp.asarray(jax.grad(last)(0.7))


def test_an_estimate_is_not_below_what_the_energy_shows():
    """Steps of two lengths miss a corner that they do not know by almost the same."""

    def own(part):
        return ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: 0.5 * part(L[0]) ** 2 + 0.3 * L[1] ** 2 + 0.2 * L[2])

    start = np.random.default_rng(7).normal(size=3) * 1.5
    unknown = own(lambda x: jnp.sort(jnp.stack([x, 0.0 * x]))[1])  # of which there is no series
    found = ph.simulate(unknown, start, [0.0, 20.0])
    truth = ph.simulate(own(lambda x: jnp.where(x > 0.0, x, 0.0)), start, [0.0, 20.0])
    off = np.abs(found.states - truth.states).max() / np.linalg.norm(start)
    assert truth.error_estimate < 1e-13 and off > 1e-3
    assert off / 30.0 < found.error_estimate < 30.0 * off


def test_an_energy_that_is_no_number_is_said():
    own = ph.systems.LiePoisson(ph.algebra.Heisenberg(1), lambda m: jnp.log(m[1] - 5.0))
    with pytest.warns(UserWarning, match="the energy of LiePoisson is not a number along the motion"):
        ph.simulate(own, [1.0, -1.0, 1.0], [0.0, 1.0])


def test_a_singularity_is_named():
    fall = ph.systems.LiePoisson(ph.algebra.Heisenberg(1), lambda m: 0.5 * m[1] ** 2 - 1.0 / m[0])
    with pytest.raises(NotConverged, match="singularity between 1 and 2 s"):  # at π/√8 = 1.11
        ph.simulate(fall, [1.0, 0.0, 1.0], np.linspace(0.0, 5.0, 6))


def test_steps_that_jump_over_a_singularity_do_not_count():
    """Vortices of 2, 2, −1 that collapse into one: steps of midpoint went on with an estimated error of 2.4."""
    three = fields.PlaneVortices([2.0, 2.0, -1.0])
    start = three.pack(np.array([[-1.0, 0.0], [1.0, 0.0], [1.0, 2.0**0.5]]))
    assert ph.simulate(three, start, [0.0, 10.0]).error_estimate < 1e-13
    with pytest.raises(NotConverged, match="comes to a singularity between 0 and 20 s"):
        ph.simulate(three, start, [0.0, 20.0])
