"""A rotor in a body: its motion is that of the parts put together by hand."""

import numpy as np
import pytest

import polhode as ph
from polhode import analysis, rotation, spacecraft, systems
from polhode.errors import InvalidInput

BODY = ph.Body(2.0, (0.0, 0.0, 0.0), [[3.0, 0.2, 0.1], [0.2, 2.5, 0.0], [0.1, 0.0, 4.0]])
AXIS, MOMENT, RATE = np.array([2.0, 0.0, 1.0]), 0.1, 7.0
VELOCITY, TURNED = np.array([0.3, -0.2, 0.5]), rotation.normalize([0.9, 0.1, 0.3, -0.2])


@pytest.mark.parametrize("free", [False, True])
def test_momentum_and_energy_are_those_of_the_parts(free):
    """L = JΩ + J_r σ a along the given axes, whether the rotor is driven or free."""
    made = systems.rotor_in_body(BODY, AXIS, MOMENT, RATE, VELOCITY, TURNED, free=free)
    a = AXIS / np.sqrt(5.0)
    wanted = BODY.inertia @ VELOCITY + MOMENT * RATE * a
    assert made.axes @ made.total == pytest.approx(wanted, rel=1e-14)
    assert made.axes @ made.velocity == pytest.approx(VELOCITY, rel=1e-14)
    assert made.axes @ made.along == pytest.approx(a, abs=1e-15)
    # the moments of a carrier with a free rotor lack the rotor's axial one
    inertia = BODY.inertia - (MOMENT * np.outer(a, a) if free else 0.0)
    assert made.axes @ np.diag(made.moments) @ made.axes.T == pytest.approx(inertia, abs=1e-14)
    given = rotation.multiply(made.attitude, rotation.conjugate(rotation.from_matrix(made.axes)))
    assert rotation.angle_between(given, TURNED) < 1e-14
    assert made.usual_rate >= np.linalg.norm(VELOCITY) - 1e-15


@pytest.mark.sweep
def test_it_moves_like_a_body_put_together_of_mounts():
    """A free rotor by ``RigidBody`` and its ``Wheel``, whose moments are those of the whole."""
    made = systems.rotor_in_body(BODY, AXIS, MOMENT, RATE, VELOCITY, TURNED, free=True)
    times = np.linspace(0.0, 2.0, 5)
    ours = ph.simulate(made.gyrostat, np.concatenate([made.attitude, made.total]), times, step=1e-3)
    principal = BODY.principal_axes
    whole = spacecraft.RigidBody(BODY.principal_moments, [spacecraft.Wheel(principal.T @ AXIS, MOMENT)])
    attitude = rotation.multiply(TURNED, rotation.from_matrix(principal))
    start = whole.pack(attitude=attitude, angular_velocity=principal.T @ VELOCITY, rates=[RATE])
    theirs = ph.simulate(whole, start, times)
    back = rotation.conjugate(rotation.from_matrix(made.axes)), rotation.conjugate(rotation.from_matrix(principal))
    one, other = (rotation.multiply(found.attitude, turn) for found, turn in zip((ours, theirs), back, strict=True))
    assert rotation.angle_between(one, other).max() < 1e-9


@pytest.mark.long
def test_of_a_carrier_of_revolution_the_rates_are_seen_in_the_motion():
    gyrostat, velocity = systems.Gyrostat((2.0, 2.0, 3.0), (0.0, 0.0, 0.5)), np.array([0.3, 0.0, 1.0])
    rates = analysis.symmetric_rates(gyrostat, velocity)
    assert rates is not None
    start = np.array([1.0, 0.0, 0.0, 0.0, *(gyrostat.moments * velocity + gyrostat.rotor)])
    found = ph.simulate(gyrostat, start, [0.0, 0.1], step=1e-3)
    turned = np.diff(np.arctan2(found.momentum[:, 1], found.momentum[:, 0]))[0]
    assert turned == pytest.approx(0.1 * rates.nutation, rel=1e-9)
    L = start[4:]
    axis = rotation.rotate(found.attitude, np.array([0.0, 0.0, 1.0]))
    across = axis - np.outer(axis @ L, L) / (L @ L)
    around = np.arctan2(np.cross(across[0], across[1]) @ L / np.linalg.norm(L), across[0] @ across[1])
    assert around == pytest.approx(0.1 * rates.precession, rel=1e-9)
    assert analysis.symmetric_rates(systems.Gyrostat((1.0, 2.0, 3.0), (0.0, 0.0, 0.5)), velocity) is None
    vectors = [[0.0, 0.0, 2.0], [1.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 0.0]]
    assert analysis.angle_from_axis(vectors, (0.0, 0.0, 1.0)) == pytest.approx([0.0, np.pi / 4, np.pi, 0.0])


def test_rotors_that_do_not_fit_are_refused():
    with pytest.raises(InvalidInput, match=r"`rotor_moment` must be that of a part of the body; got 3 kg m²"):
        systems.rotor_in_body(BODY, AXIS, 3.0, RATE, VELOCITY)
    with pytest.raises(InvalidInput, match="an axis must be three finite numbers"):
        systems.rotor_in_body(BODY, (0.0, 0.0, 0.0), MOMENT, RATE, VELOCITY)
    # however long or short, it is a direction
    for size in (1e-300, 1e300):
        made = systems.rotor_in_body(BODY, size * np.array([1.0, 0.0, 0.0]), MOMENT, RATE, VELOCITY)
        assert np.linalg.norm(made.along) == pytest.approx(1.0, rel=1e-15)
