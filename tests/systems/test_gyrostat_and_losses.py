"""Rotors inside and losses inside: what is kept, what falls at which rate, and where motions end."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.systems import DoubleBracket, FreeRigidBody, Gyrostat, TorquedGyrostat

MOMENTS = (1.0, 2.0, 3.0)
BALANCE = 1e-10
ROUNDING = 4 * 2.0**-52  # of an energy that has settled
START = np.array([1.0, 0.0, 0.0, 0.0, 1.0, 0.1, 0.2])


@pytest.mark.sweep
def test_a_gyrostat_keeps_its_momentum_and_without_rotor_is_free():
    times = np.linspace(0.0, 100.0, 11)
    found = ph.simulate(Gyrostat(MOMENTS, (0.1, 0.2, 0.5)), START, times, step=0.01, order=6)
    assert max(found.drift.values()) < 1e-13
    still = ph.simulate(Gyrostat(MOMENTS, (0.0, 0.0, 0.0)), START, times, step=0.01)
    free = ph.simulate(FreeRigidBody(MOMENTS), START, times, step=0.01)
    assert (still.states == free.states).all()


@pytest.mark.long
def test_a_symmetric_gyrostat_precesses_at_a_rate_known_by_hand():
    """I1 = I2, rotor along the axis: Π turns about it at (I3 − I1)Ω3/I1 + h/I1, with Π3 = I3 Ω3 + h."""
    I1, I3, h, spin = 2.0, 3.0, 0.7, 0.4
    start = np.array([0.3, 0.0, I3 * spin + h])
    times = np.linspace(0.0, 5.0, 6)
    found = ph.simulate(Gyrostat((I1, I1, I3), (0.0, 0.0, h)), start, times, step=0.01, order=6)
    angle = ((I3 - I1) * spin + h) / I1 * times
    wanted = np.stack([0.3 * np.cos(angle), 0.3 * np.sin(angle), np.full(6, start[2])], axis=-1)
    assert np.abs(found.states - wanted).max() < 1e-11


def test_a_rotor_steadies_the_middle_axis():
    """About axis 2 with Π = (0, p, 0), λ = (p − h)/I2: stable iff λ I1 < p and λ I3 < p, or both the other way."""
    p = 1.0
    for h, verdict in ((0.0, "unstable"), (1 - 2 / 3 - 1e-6, "unstable"), (1 - 2 / 3 + 1e-6, "stable"), (0.9, "stable"),
                       (-1.0 + 1e-6, "unstable"), (-1.0 - 1e-6, "stable")):  # fmt: skip
        assert ph.stability(Gyrostat(MOMENTS, (0.0, h, 0.0)), np.array([0.0, p, 0.0])).verdict == verdict, h


@pytest.mark.long
def test_a_motor_turns_the_rotor_and_the_balance_closes():
    system = TorquedGyrostat(MOMENTS, (0.0, 0.0, 2.0), rotor_moment=0.1, torque=0.01)
    found = ph.simulate(system, np.append(START, 0.05), np.linspace(0.0, 100.0, 51), step=0.5)
    assert found.states[:, 7] == pytest.approx(0.05 + 0.01 * found.times, rel=1e-10)
    assert found.drift["energy"] < BALANCE and max(found.drift.values()) < 10 * BALANCE
    assert np.ptp(found.balances["energy"]) > 0.1


@pytest.mark.sweep
def test_a_motor_at_rest_leaves_the_gyrostat():
    still = TorquedGyrostat(MOMENTS, (0.0, 0.0, 1.0), rotor_moment=0.1, torque=0.0)
    times = np.linspace(0.0, 20.0, 5)
    found = ph.simulate(still, np.append(START, 0.3), times, step=0.2)
    same = ph.simulate(Gyrostat(MOMENTS, (0.0, 0.0, 0.3)), START, times, step=0.01, order=6)
    assert np.abs(found.states[:, :7] - same.states).max() < 1e-9


@pytest.mark.long
def test_losses_inside_end_at_the_major_axis():
    """Explorer 1: spun about its axis of least inertia, it ends in a flat spin; |L| stays."""
    found = ph.simulate(DoubleBracket(MOMENTS, 0.2), [1, 0, 0, 0, 1.0, 0.01, 0.02], np.linspace(0, 400, 41), step=0.05)
    assert max(found.drift[name] for name in ("|L|²", "momentum_space")) < 1e-13
    assert np.abs(found.momentum[-1]) == pytest.approx([0, 0, np.linalg.norm(found.momentum[0])], abs=1e-6)
    energy = found.balances["energy"]
    assert (np.diff(energy) <= ROUNDING * energy[0]).all() and energy[-1] == pytest.approx(energy[0] / 3.0, rel=1e-3)


def test_energy_falls_at_the_stated_rate():
    system = DoubleBracket(MOMENTS, 0.2)
    state = jnp.array([1.0, 0.4, -0.7])
    rate = jax.jvp(system.energy, (state,), (system.vector_field(0.0, state),))[1]
    balance = system.balances(0.0, state)["energy"]
    assert float(balance.rate) == pytest.approx(float(rate), rel=1e-14) and float(rate) < 0
    assert "energy" not in system.invariants(state)


def test_losses_leave_only_the_major_axis_stable():
    system = DoubleBracket(MOMENTS, 0.05)
    assert [ph.stability(system, axis).verdict for axis in np.eye(3)] == ["unstable", "unstable", "stable"]
    # beside axis 1 the growth by hand: α ((1/I1 − 1/I2) + (1/I1 − 1/I3))/2 at |Π| = 1
    assert ph.stability(system, np.eye(3)[0]).rate == pytest.approx(0.05 * ((1 - 1 / 2) + (1 - 1 / 3)) / 2, rel=1e-12)


@pytest.mark.long
@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Gyrostat(MOMENTS, (1.0, 2.0)), "`rotor` must be three"),
        (lambda: DoubleBracket(MOMENTS, -1.0), "`rate` must be finite and not negative"),
        (lambda: TorquedGyrostat(MOMENTS, (0, 0, 0), 0.1, 0.0), "`axis` must be a direction"),
        (lambda: TorquedGyrostat(MOMENTS, (0, 0, 1), -0.1, 0.0), "`rotor_moment`"),
        (lambda: TorquedGyrostat(MOMENTS, (0, 0, 1), 0.1, np.nan), "`torque`"),
        (lambda: TorquedGyrostat(MOMENTS, (0, 0, 1), 0.1, 0.0).check_state(np.ones(7)), r"shape \(…, 8\)"),
    ],
)
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()


def test_energy_casimir_and_spectrum_agree_on_gyrostats():
    """Against δΠ̇ = δΠ × Ω + Π × δΠ/I on the sphere, and a definite (1/I − λ) across Π, with Ω = λΠ."""
    rotor, moments = (0.1, -0.2, 0.1), np.array(MOMENTS)
    system = Gyrostat(MOMENTS, rotor)
    found = ph.find_equilibria(system, np.array([0.5, 0.6, 0.62]))
    assert len(found) in (4, 6)
    for point in found:
        velocity = (point - rotor) / moments
        cross = lambda v: np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])  # noqa: E731
        growth = np.linalg.eigvals(-cross(velocity) + cross(point) / moments).real.max()
        basis = np.linalg.svd(point[None])[2][1:].T
        curvature = np.linalg.eigvalsh(basis.T @ np.diag(1 / moments - velocity @ point / (point @ point)) @ basis)
        unstable = ph.stability(system, point).verdict == "unstable"
        assert unstable == (curvature.prod() < 0) == (growth > 1e-6)
