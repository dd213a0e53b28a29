"""What tops do at the start, against formulas in many digits and against the motion itself."""

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode import analysis, rotation, systems
from polhode.errors import InvalidInput

E3 = np.array([0.0, 0.0, 1.0])
TURNED = rotation.as_matrix(rotation.normalize([0.9, 0.2, -0.3, 0.1]))


@pytest.mark.parametrize("degrees", [0, 7, 30, 90, 135, 180])
def test_a_leaning_axis_has_its_angle_and_azimuth(degrees):
    """It points to (0, −sin θ, cos θ), whatever its place in the body; quarter turns are exact in the given axes."""
    angle = float(mpmath.radians(degrees))
    wanted = [0.0, -float(mpmath.sin(mpmath.radians(degrees))), float(mpmath.cos(mpmath.radians(degrees)))]
    top = systems.HeavyTop((1.0, 2.0, 2.5), 3.0, (1.0, 2.0, -2.0), TURNED)
    attitude = top.leaning(angle)
    assert analysis.axis_in_space(top, attitude) == pytest.approx(wanted, abs=1e-15)
    assert analysis.axis_tilt(top, attitude) == pytest.approx(angle, abs=3e-8)  # arccos at its ends
    plain = systems.HeavyTop((1.0, 1.0, 0.5), 1.0)
    found = plain.leaning(angle)
    if degrees == 90:
        assert found[0] == found[1]  # a top so placed swings in a plane exactly
    # from its given axes it gets upright by the shortest turn, which for this one is none
    assert found == pytest.approx([np.cos(0.5 * angle), np.sin(0.5 * angle), 0.0, 0.0], abs=1e-15)


def test_a_free_body_does_not_lean():
    with pytest.raises(InvalidInput, match="mgl = 0"):
        systems.HeavyTop((1.0, 1.0, 0.5), 0.0).leaning(0.1)
    with pytest.raises(InvalidInput, match="`angle` must be a finite number"):
        systems.HeavyTop((1.0, 1.0, 0.5), 1.0).leaning(np.nan)


@pytest.mark.long
def test_the_period_is_that_of_a_small_swing():
    """Simulated from 1e-4 rad off hanging, across the axis of largest moment, it is back after one period."""
    top = systems.HeavyTop((1.0, 2.0, 1.5), 3.0, (0.0, 0.0, 1.0))
    period = analysis.top_period(top, np.zeros(3))
    assert period == pytest.approx(float(2 * mpmath.pi * mpmath.sqrt(mpmath.mpf(2) / 3)), rel=1e-15)
    half = 0.5 * (np.pi - 1e-4)
    start = top.pack((np.cos(half), 0.0, np.sin(half), 0.0))  # turned about the second axis
    found = ph.simulate(top, start, [0.0, 0.25 * period, 0.5 * period, period], step=period / 400)
    leaned = analysis.axis_in_space(top, found.attitude)[:, 0]
    assert leaned == pytest.approx(1e-4 * np.array([1.0, 0.0, -1.0, 1.0]), abs=1e-11)
    free = systems.HeavyTop((1.0, 2.0, 1.5), 0.0)
    assert analysis.top_period(free, (0.0, 4.0, 0.0)) == pytest.approx(np.pi) and not analysis.top_period(
        free, np.zeros(3)
    )


def test_the_spin_about_a_principal_axis():
    top = systems.HeavyTop((1.0, 2.0, 4.0), 1.0, (0.0, -3.0, 0.0))
    assert analysis.axial_spin(top, (7.0, 5.0, 3.0)) == -2.5
    assert analysis.axial_spin(systems.HeavyTop((1.0, 2.0, 4.0), 1.0, (0.0, 1.0, 1.0)), (7.0, 5.0, 3.0)) == 0.0
    with pytest.raises(InvalidInput, match="`momentum` must be three finite numbers"):
        analysis.axial_spin(top, (1.0, np.inf, 0.0))


@pytest.mark.long
def test_steady_rates_keep_the_tilt():
    """Thrown with either rate, a top of this tilt and spin goes round at that rate, at constant tilt."""
    moments, mgl, spin, tilt = (1.0, 1.0, 0.5), 1.0, 5.0, 0.9
    attitude = (np.cos(0.5 * tilt), np.sin(0.5 * tilt), 0.0, 0.0)
    thrown = ph.LagrangeMotion(moments, mgl=mgl, momentum=(0.3, 0.0, 0.5 * spin), attitude=attitude)
    rates = analysis.steady_precession_of(thrown)
    assert rates is not None and not analysis.is_steady_precession(thrown)
    for rate in rates:
        # Ω across the axis, φ̇ sin θ, lies up along the body's second axis
        steady = ph.LagrangeMotion(moments, mgl=mgl, momentum=(0.0, rate * np.sin(tilt), 0.5 * spin), attitude=attitude)
        assert analysis.is_steady_precession(steady)
        axis = rotation.rotate(steady.attitude(np.array([0.0, 0.1])), E3)
        turned = np.diff(np.unwrap(np.arctan2(axis[:, 1], axis[:, 0])))[0]
        assert turned == pytest.approx(0.1 * rate, rel=1e-9)
    for height in (0.0, np.pi):
        standing = ph.LagrangeMotion(
            moments, mgl=mgl, momentum=(0, 0, 2.5), attitude=(np.cos(height / 2), np.sin(height / 2), 0.0, 0.0)
        )
        assert analysis.steady_precession_of(standing) is None


@pytest.mark.long
def test_a_motion_is_the_same_top_as_a_system():
    """Along the given axes of a body too: splitting follows the closed form."""
    cone = ph.shapes.cone(0.1, 0.03, 0.05).placed((0.6, 0.8, 0.0, 0.0))
    pivot = ph.rotation.rotate(np.array([0.6, 0.8, 0.0, 0.0]), np.array([0.0, 0.0, 0.0375]))
    motion = ph.LagrangeMotion.from_body(
        cone, pivot=pivot, angular_velocity=(20.0, -30.0, 50.0), attitude=(0.8, 0.6, 0.0, 0.0)
    )
    top = systems.HeavyTop.from_motion(motion)
    assert np.linalg.norm(top.weight) == pytest.approx(0.1 * 9.80665 * 0.0375, rel=1e-12)
    assert np.asarray(top.weight) == pytest.approx((cone.center_of_mass - pivot) * 0.1 * 9.80665, abs=1e-15)
    state = top.pack((0.8, 0.6, 0.0, 0.0), angular_velocity=(20.0, -30.0, 50.0))
    found = ph.simulate(top, state, [0.0, 0.05, 0.1], step=1e-4)
    given = rotation.multiply(found.attitude, rotation.conjugate(rotation.from_matrix(np.asarray(top.axes))))
    assert rotation.angle_between(given, motion.attitude(found.times)).max() < 1e-9
    with pytest.raises(InvalidInput, match="must be of one top"):
        systems.HeavyTop.from_motion(ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=np.array([1.0, 2.0]), momentum=(0, 0, 1.0)))
