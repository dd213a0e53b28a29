"""The rolling disk: Newton's and Euler's laws, conserved quantities and losses, starts and ends."""

import equinox as eqx
import jax
import jax.numpy as jnp
import mpmath as mp
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.rolling import (
    AirLayer,
    BoundaryLayer,
    DrillingFriction,
    DryContourFriction,
    EulerDisk,
    RollingCouple,
    ViscousContourFriction,
)
from polhode.rolling.euler_disk._mechanics import RollingMechanics
from polhode.rolling.euler_disk.dissipation import couples
from spacecraft.newton_euler import DIGITS, accelerations, cross, dot, vector
from sweeping import first

MASS, RADIUS, THICKNESS = 0.4387, 0.0381, 0.0127
LAWS = (
    AirLayer(1.8e-4), BoundaryLayer(1e-9), ViscousContourFriction(1e-7), DryContourFriction(1e-5), RollingCouple(1e-6),
    DrillingFriction(1e-5),
)  # fmt: skip
ROUNDING = 1e-12  # of accelerations, relative to the largest term; the oracle itself has 40 digits
SAMPLES = 100  # of every run: another number compiles its solver again
KEPT = 1e-10  # of conserved quantities over some hundred turns, at the solver's tolerance of 1e-12 a step
thin, thick = EulerDisk(MASS, RADIUS), EulerDisk(MASS, RADIUS, THICKNESS)
slowed = EulerDisk(MASS, RADIUS, dissipation=LAWS)
slowed_thick = EulerDisk(MASS, RADIUS, THICKNESS, dissipation=LAWS)
WOBBLING = thin.rolling_state(0.6).at[5].set(3.0).at[7].add(2.0)


def random_states(count, seed=0):
    rng = np.random.default_rng(seed)
    tilts = rng.uniform(0.05, 1.5, size=(count, 1))
    return jnp.asarray(np.hstack([tilts, rng.normal(size=(count, 4)), 20 * rng.normal(size=(count, 3))]))


def missed(disk, state):
    """Return by how much the field misses Newton's and Euler's laws, relative to its size, and the same of N."""
    theta, phi = mp.mpf(float(state[0])), mp.mpf(float(state[1]))
    s, c, p, q = mp.sin(theta), mp.cos(theta), mp.sin(phi), mp.cos(phi)
    frame = vector(q, p, 0), vector(-c * p, c * q, s), vector(s * p, -s * q, c)
    rates = [mp.mpf(float(x)) for x in state[5:]]
    omega = rates[0] * frame[0] + rates[1] * frame[1] + rates[2] * frame[2]
    k = disk.mechanics
    tau = couples(k, disk.dissipation, state[0], state[6], state[7])
    couple = float(tau[0]) * frame[1] + float(tau[1]) * frame[2]
    sizes = (k.mass, k.radius, k.half_thickness, k.diametral_moment, k.axial_moment, k.gravity)
    alpha, force = accelerations(sizes, frame[2], omega, couple)
    # the frame turns with θ̇ e1 + φ̇ z
    turning = rates[0] * frame[0] + rates[1] / s * vector(0, 0, 1)
    wanted = alpha - cross(turning, omega)
    found = disk.vector_field(jnp.zeros(()), state)[5:]
    off = max(abs(dot(wanted, e) - float(x)) for e, x in zip(frame, found, strict=True))
    scale = max(abs(x) for x in map(float, found)) + max(abs(x) for x in rates) ** 2 / s
    return float(off / scale), float(abs(force[2] - float(disk.normal_force(state))) / abs(force[2]))


@pytest.mark.parametrize("disk", [thin, thick, slowed, slowed_thick], ids=["thin", "thick", "slowed", "slowed thick"])
def test_newton_and_euler(disk):
    with mp.workdps(DIGITS):
        for state in random_states(4):
            field, force = missed(disk, state)
            assert field < ROUNDING and force < ROUNDING * 100  # N is a difference of large accelerations


class Slip(RollingMechanics):
    def transport(self, theta, w2, w3):
        d2, d3 = super().transport(theta, w2, w3)
        return d2 * (1.0 + 1e-9), d3


def test_a_broken_disk_is_caught():
    k = thick.mechanics
    slip = Slip(k.mass, k.radius, k.half_thickness, k.diametral_moment, k.axial_moment, k.gravity)
    broken = eqx.tree_at(lambda d: d.mechanics, thick, slip)
    with mp.workdps(DIGITS):
        assert max(missed(broken, state)[0] for state in random_states(4)) > 30 * ROUNDING


@pytest.mark.sweep
@pytest.mark.parametrize("disk", first(1, [slowed_thick, slowed]), ids=["thick", "thin"])
def test_kinematics_and_power(disk):
    states = random_states(20)
    rates = jax.jit(disk.vector_field)(jnp.zeros(()), states)
    along = lambda function: jax.jit(lambda x, v: jax.jvp(function, (x,), (v,))[1])(states, rates)  # noqa: E731
    velocity = along(disk.center)
    assert np.abs(velocity - disk.center_velocity(states)).max() < 1e-13
    attitude, momentum, omega = disk.vectors(states)
    turning = along(lambda x: disk.vectors(x).attitude)
    pure = jnp.concatenate([jnp.zeros((20, 1)), 0.5 * omega], axis=-1)
    assert np.abs(turning - rotation.multiply(attitude, pure)).max() < 1e-12
    moments = jnp.array([disk.mechanics.diametral_moment] * 2 + [disk.mechanics.axial_moment])
    assert np.abs(momentum - moments * omega).max() < 1e-15
    lost = -along(disk.energy)
    assert np.abs(lost / disk.power(states) - 1).max() < 1e-9  # a small difference of large rates


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_each_law_takes_its_power(law):
    disk = EulerDisk(MASS, RADIUS, dissipation=law)
    state = disk.rolling_state(0.1)
    wanted = law.power(disk.mechanics, state[0], jnp.abs(disk.precession(state)))
    assert abs(float(disk.power(state) / wanted) - 1) < 1e-14
    # where the braked rate is zero, the couple is zero and finite
    still = state.at[7].set(state[6] * (-jnp.tan(0.1) if law.vertical else 1.0 / jnp.tan(0.1)))
    assert float(disk.power(still)) < 1e-20 and np.isfinite(disk.vector_field(jnp.zeros(()), still)).all()


def test_the_sum_of_laws_takes_the_sum():
    state = slowed.rolling_state(0.1)
    parts = [EulerDisk(MASS, RADIUS, dissipation=law).power(state) for law in LAWS]
    assert abs(float(slowed.power(state) / sum(parts)) - 1) < 1e-14


@pytest.mark.long
def test_energy_and_linear_integrals_are_kept():
    found = ph.simulate(thin, WOBBLING, np.linspace(0.0, 10.0, SAMPLES))
    assert found.outcome.event is None and np.ptp(found.states[:, 0]) > 0.15
    assert set(found.drift) == {"energy", "linear_integral_1", "linear_integral_2"}
    assert max(found.drift.values()) < KEPT
    back = ph.simulate(thin, found.states[-1], np.linspace(10.0, 0.0, SAMPLES))
    assert np.abs(back.states[-1] - WOBBLING).max() < 1e-8


@pytest.mark.long
def test_linear_integrals_foretell_the_spin():
    """ω3 at another tilt from mpmath's hypergeometric function, whose degree is complex."""
    found = ph.simulate(thin, WOBBLING, np.linspace(0.0, 0.3, SAMPLES))
    c1, c2 = (float(x) for x in thin.linear_integrals(WOBBLING))
    with mp.workdps(30):
        nu = (-1 + mp.sqrt(1 - mp.mpf(16) / 3)) / 2
        for state in found.states[::12]:
            x = mp.sin(mp.mpf(state[0]) / 2) ** 2
            parts = [mp.re(mp.hyp2f1(-nu, nu + 1, 1, y)) for y in (x, 1 - x)]
            assert abs(c1 * parts[0] + c2 * parts[1] - state[7]) < KEPT * (abs(c1) + abs(c2))


@pytest.mark.sweep
def test_a_thick_disk_moves_along_its_linear_equations():
    from scipy.integrate import solve_ivp

    start = thick.rolling_state(0.6).at[5].set(3.0).at[7].add(2.0)
    found = ph.simulate(thick, start, np.linspace(0.0, 3.0, SAMPLES))
    assert found.drift["energy"] < KEPT
    tilts = found.states[:, 0]
    for target in (np.argmin(tilts), np.argmax(tilts)):
        rate = lambda theta, w: np.array(thick.mechanics.transport(jnp.asarray(theta), *w))  # noqa: E731
        carried = solve_ivp(rate, (tilts[0], tilts[target]), np.asarray(start[6:]), "DOP853", rtol=1e-12, atol=1e-12)
        assert np.abs(carried.y[:, -1] - found.states[target, 6:]).max() < 1e-8


@pytest.mark.long
@pytest.mark.parametrize("disk", first(1, [thin, thick]), ids=["thin", "thick"])
def test_steady_motion_stays(disk):
    start = disk.rolling_state(0.3, heading=0.4, contact=(0.1, 0.2))
    found = ph.simulate(disk, start, np.linspace(0.0, 1.0, SAMPLES))
    assert np.abs(found.states[:, 0] - 0.3).max() < 1e-11
    centers = np.asarray(disk.center(found.states))
    assert np.abs(centers - centers[0]).max() < KEPT
    circle = ph.simulate(disk, disk.rolling_state(0.9, precession=-4.0), np.linspace(0.0, 1.0, SAMPLES))
    assert np.abs(circle.states[:, 0] - 0.9).max() < 1e-9  # the slow motion's exponents are small, not its own


def test_rolling_rate_goes_as_one_over_the_root_of_the_tilt():
    rates = [float(thin.precession(thin.rolling_state(tilt))) for tilt in (1e-4, 4e-4)]
    assert abs(rates[0] / rates[1] - 2.0) < 1e-6
    assert abs(rates[0] ** 2 * RADIUS * np.sin(1e-4) / (4 * 9.80665) - 1) < 1e-12


@pytest.mark.sweep
@pytest.mark.parametrize("disk", [slowed, slowed_thick], ids=["thin", "thick"])
def test_energy_balance_and_flat_end(disk):
    found = ph.simulate(disk, disk.rolling_state(0.05), np.linspace(0.0, 60.0, SAMPLES))
    assert found.outcome.event == "flat" and found.times[-1] < 60.0 and found.invariants == {}
    assert np.sin(found.states[-1, 0]) == pytest.approx(1e-6, rel=1e-6)
    assert len(found.times) == len(found.states) and (np.diff(found.times) > 0).all()
    assert found.drift["energy"] < KEPT and found.received["energy"][-1] < -0.5 * found.balances["energy"][0]
    assert ph.as_dataset(found)["contact_x"].shape == found.times.shape


@pytest.mark.sweep
def test_the_slow_manifold_does_not_ring():
    """Without the slow rate of the tilt the nutation rings by as much as the tilt falls in a radian."""
    start = slowed.rolling_state(0.05)
    times = np.linspace(0.0, 0.2, SAMPLES)
    rates = [ph.simulate(slowed, x, times).states[:, 5] for x in (start, start.at[5].set(0.0))]
    smooth = [rate - np.polyval(np.polyfit(times, rate, 3), times) for rate in rates]
    assert np.abs(smooth[0]).max() < 0.05 * np.abs(smooth[1]).max()


@pytest.mark.sweep
def test_lift_off_and_the_edge():
    leap = thin.check_state([0.05, 0.0, 0.0, 0.0, 0.0, 20.0, 0.0, 0.0])
    found = ph.simulate(thin, leap, np.linspace(0.0, 0.1, SAMPLES))
    assert found.outcome.event == "lift-off" and abs(float(thin.normal_force(found.states[-1]))) < 1e-10
    # the force from the centre's motion: z̈ = −g there
    state = jnp.asarray(found.states[-1])
    field = lambda x: jax.jvp(thin.center, (x,), (thin.vector_field(jnp.zeros(()), x),))[1]  # noqa: E731
    fall = jax.jvp(field, (state,), (thin.vector_field(jnp.zeros(()), state),))[1]
    assert abs(float(fall[2]) + 9.80665) < 1e-8
    rising = thick.check_state([1.3, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0])
    found = ph.simulate(thick, rising, np.linspace(0.0, 1.0, SAMPLES))
    assert found.outcome.event == "on edge" and abs(found.states[-1, 0] - np.pi / 2) < 1e-12


@pytest.mark.sweep
def test_a_disk_that_falls_over_lies_flat():
    found = ph.simulate(thin, [1.0, 0, 0, 0, 0, 0, 0, 0], np.linspace(0.0, 1.0, SAMPLES))
    fast = np.sqrt(2 * 9.80665 * RADIUS * np.sin(1.0) / (1.25 * RADIUS**2))
    assert found.outcome.event == "flat" and abs(found.states[-1, 5] + fast) < 1e-4


def test_states_from_attitude_and_angular_velocity():
    for state in random_states(5, seed=3):
        attitude, _, omega = thick.vectors(state)
        again = thick.pack(attitude, omega, state[3:5], thick.center_velocity(state))
        assert np.abs(again[5:] - state[5:]).max() < 1e-12
        assert np.abs(thick.vectors(again).attitude - attitude).max() < 1e-14
        assert np.abs(thick.center(again) - thick.center(state)).max() < 1e-15


UPRIGHT = (np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: EulerDisk(MASS, RADIUS, 0.1), "not thicker than wide"),
        (lambda: EulerDisk(MASS, RADIUS, -0.1), "`thickness`"),
        (lambda: EulerDisk(-MASS, RADIUS), "`mass` must be positive and finite"),
        (lambda: EulerDisk(MASS, 0.0), "`radius` must be positive and finite"),
        (lambda: EulerDisk(MASS, RADIUS, axial_moment=1.0, diametral_moment=0.1), "at most twice"),
        (lambda: EulerDisk(MASS, RADIUS, dissipation=["air"]), "must be laws"),
        (lambda: AirLayer(-1.8e-5), "`viscosity` must be positive and finite"),
        (lambda: thin.pack(UPRIGHT, (0, 0, 5.0), center_velocity=(0.1, 0.0, 0.0)), "does not roll.*slip at 0.2905"),
        (lambda: thin.pack((1.0, 0.0, 0.0, 0.0), (0, 0, 5.0)), "lies flat"),
        (lambda: thin.pack((0.0, 1.0, 0.0, 0.0), (0, 0, 5.0)), "lies flat"),
        (lambda: thin.rolling_state(0.0), "lies flat"),
        (lambda: ph.simulate(thin, np.zeros(8), [0.0, 1.0]), "lies flat"),
        (lambda: thick.rolling_state(2.0), "turn it over"),
        (lambda: ph.simulate(thin, np.ones(7), [0.0, 1.0]), r"shape \(…, 8\)"),
        (lambda: ph.simulate(thin, np.full(8, np.nan), [0.0, 1.0]), "finite"),
        (lambda: ph.simulate(thin, [1.4, 0, 0, 0, 0, -30.0, 3, 30], [0.0, 1.0]), "past the event.*lift-off"),
        (lambda: ph.simulate(thin, WOBBLING, [0.0, 1.0], ph.integrators.LieMidpoint), "not a Lie–Poisson system"),
        (lambda: thin.rolling_state(0.3, precession=10.0, spin=1.0), "not steady"),
        (lambda: thin.rolling_state(np.pi / 2, precession=0.0), "`spin` must be given"),
        (lambda: slowed.rolling_state(np.pi / 2, 0.0, 1.0), "unstable"),
        (lambda: thick.rolling_state(1.35), "centre at rest"),
        (lambda: thick.linear_integrals(random_states(1)[0]), "thin disk only"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
