"""Spin, precession and nutation of a top at the start, against derivatives of its Euler angles and steady motion."""

import math

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode import analysis, rotation, systems
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top.steady_precession import least_spin_rate, steady_precession

LEANING = systems.HeavyTop((1.0, 2.0, 2.5), 3.0, (1.0, 2.0, -2.0))  # its axis is not a principal one
SYMMETRIC = systems.HeavyTop((1.0, 1.0, 0.5), 1.0)


def turned(axis, angle):
    """The rotation matrix about x or z, in many digits."""
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    rows = [[c, -s, 0], [s, c, 0], [0, 0, 1]] if axis == "z" else [[1, 0, 0], [0, c, -s], [0, s, c]]
    return mpmath.matrix(rows)


def velocity_of(angles, rates, upright):
    """RᵀdR/dt of R = Rz(φ) Rx(θ) Rz(ψ) U by differences in many digits, U taking the body upright."""
    with mpmath.workdps(50):
        step = mpmath.mpf(10) ** -16
        U = mpmath.matrix(upright.tolist())

        def at(time):
            phi, theta, psi = (angle + time * rate for angle, rate in zip(angles, rates, strict=True))
            return turned("z", phi) * turned("x", theta) * turned("z", psi) * U

        hat = at(0).T * (at(step) - at(-step)) / (2 * step)
        return np.array([float(hat[2, 1]), float(hat[0, 2]), float(hat[1, 0])]), at(0)


@pytest.mark.parametrize("top", [LEANING, SYMMETRIC], ids=["any axis", "symmetric"])
@pytest.mark.parametrize("angles", [(0.3, 0.7, -1.1), (-2.0, 3.0, 0.4), (5.0, math.pi / 2, 2.0)])
def test_rates_are_those_of_the_euler_angles(top, angles):
    rates = (0.6, -0.35, 4.2)  # φ̇, θ̇, ψ̇
    upright = rotation.as_matrix(rotation.shortest_between(np.asarray(top.axis), (0.0, 0.0, 1.0)))
    wanted, attitude = velocity_of(angles, rates, upright)
    matrix = np.array(attitude.tolist(), dtype=float)
    found = analysis.top_velocity(top, rotation.from_matrix(matrix), 4.2, 0.6, -0.35)
    assert found == pytest.approx(wanted, abs=1e-14)


def test_a_positive_nutation_leans_the_axis_further():
    attitude = LEANING.leaning(0.5)
    velocity = analysis.top_velocity(LEANING, attitude, nutation_rate=0.2)
    later = rotation.multiply(attitude, rotation.from_rotation_vector(1e-6 * velocity))
    assert analysis.axis_tilt(LEANING, later) - 0.5 == pytest.approx(2e-7, rel=1e-6)


@pytest.mark.parametrize("tilt", [20.0, 60.0, 90.0, 120.0])
@pytest.mark.parametrize("which", ["slow", "fast"])
def test_steady_precession_keeps_the_tilt(tilt, which):
    """The exact motion stays at its tilt, and turns about the axis and the vertical at the rates asked for."""
    lean = math.radians(tilt)
    rates = analysis.steady_precession_at(SYMMETRIC, lean, 3.0)
    rate = getattr(rates, which)
    if rate is None:
        assert (tilt, which) == (90.0, "fast")
        return
    attitude = SYMMETRIC.leaning(lean)
    velocity = analysis.top_velocity(SYMMETRIC, attitude, 3.0, rate)
    motion = ph.LagrangeMotion(
        (1.0, 1.0, 0.5), mgl=1.0, momentum=np.array([1.0, 1.0, 0.5]) * velocity, attitude=attitude
    )
    tilts = analysis.axis_tilt(SYMMETRIC, motion.sample(np.linspace(0.0, 50.0, 300)).attitude)
    assert np.abs(tilts - lean).max() < 5e-15
    assert (motion.precession_rate, motion.spin_rate) == pytest.approx((rate, 3.0), rel=1e-13)


@pytest.mark.parametrize("cosine", [0.9, 0.1, -0.5])
def test_both_rates_are_roots_in_many_digits(cosine):
    I1, I3, mgl, spin = 1.3, 0.4, 0.8, 7.0
    found = steady_precession((I1, I1, I3), mgl, math.acos(cosine), spin_rate=spin)
    with mpmath.workdps(40):
        a, b = (mpmath.mpf(I1) - I3) * mpmath.cos(math.acos(cosine)), -mpmath.mpf(I3) * spin
        root = mpmath.sqrt(b * b - 4 * a * mpmath.mpf(mgl))
        roots = [(-b - root) / (2 * a), (-b + root) / (2 * a)]
    assert sorted(found, key=abs) == pytest.approx(sorted(map(float, roots), key=abs), rel=1e-14)


def test_a_body_of_equal_moments_has_one():
    found = steady_precession((1.0, 1.0, 1.0), 2.0, 0.4, spin_rate=4.0)
    assert found == (0.5, None)


def test_the_least_spin_is_where_the_roots_meet():
    least = least_spin_rate((1.0, 1.0, 0.5), 1.0, 0.5)
    above, below = (steady_precession((1.0, 1.0, 0.5), 1.0, 0.5, spin_rate=k * least) for k in (1.0 + 1e-9, 1.0 - 1e-9))
    assert below is None and above.fast / above.slow == pytest.approx(1.0, abs=1e-3)
    assert least_spin_rate((1.0, 1.0, 0.5), 1.0, 2.5) == least_spin_rate((1.0, 1.0, 1.5), 1.0, 0.5) == 0.0
    with pytest.raises(InvalidInput, match=rf"the least spin is {least:.6g} rad/s, either way round"):
        analysis.steady_precession_at(SYMMETRIC, 0.5, -0.9 * least)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: analysis.top_velocity(SYMMETRIC, SYMMETRIC.leaning(0.0), nutation_rate=1.0), "axis that leans"),
        (lambda: analysis.top_velocity(SYMMETRIC, SYMMETRIC.leaning(0.3), math.nan), "`spin_rate` must be"),
        (lambda: analysis.steady_precession_at(LEANING, 0.5, 9.0), "symmetric about the line"),
        (lambda: analysis.steady_precession_at(systems.HeavyTop((1.0, 1.0, 0.5), 0.0), 0.5, 9.0), "which lie apart"),
        (lambda: analysis.steady_precession_at(SYMMETRIC, 0.0, 9.0), "got a tilt of 0°"),
        (lambda: analysis.steady_precession_at(SYMMETRIC, math.pi / 2, 0.0), "needs some spin"),
        (lambda: steady_precession((1.0, 1.0, 0.5), 1.0, 0.5), "give either"),
        (lambda: steady_precession((1.0, 1.0, 0.5), 1.0, 0.5, 1.0, spin_rate=2.0), "give either"),
        (lambda: least_spin_rate((1.0, 1.0, 0.5), 1.0, math.inf), "`tilt` must be finite"),
    ],
)
def test_what_is_refused(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
