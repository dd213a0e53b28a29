"""Rests on a circular orbit, against differentiated equations, integrated motions and published conditions."""

import itertools
import math

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from polhode.analysis import orbital_equilibria, orbiting_body, spinning_equilibria
from polhode.analysis.gravity_gradient import CYLINDRICAL, DEBRA_DELP, GYROSCOPIC, LAGRANGE, STATIC, UNSTABLE
from polhode.celestial import SpinOrbit, libration_period
from polhode.errors import InvalidInput
from polhode.systems import KeplerOrbit

GM = 3.986004418e14
GEOSAT = (85.0, 2530.0, 2530.0)
BODIES = [(85.0, 2500.0, 2530.0), (2.0, 2.05, 2.9), (3.0, 5.0, 7.8), (2.9, 2.0, 2.05)]
SPINS = [(2.0, 1.0, 20.0), (2.0, 1.0, -20.0), (2.0, 1.0, -1.0), (1.0, 1.8, 0.3), (1.0, 1.8, 3.0), (2.0, 1.0, 1.2)]


def imaginary(stability, n):
    """Return the frequencies of exponents over n, ascending."""
    spectrum = np.asarray(stability.spectrum) / n
    return np.sort(spectrum.imag[(spectrum.imag > 1e-6) & (np.abs(spectrum.real) < 1e-6)])


@pytest.mark.long
@pytest.mark.parametrize("moments", BODIES)
def test_rates_are_those_of_the_differentiated_equations(moments):
    """The closed forms against exponents of the Lie–Poisson equations, which JAX differentiates."""
    n = 0.0011
    for rest in orbital_equilibria(moments, n):
        verdict = rest.stability
        assert rest.growth == pytest.approx(verdict.rate, abs=1e-9 * n)
        assert verdict.verdict == {LAGRANGE: "stable", DEBRA_DELP: "undecided", UNSTABLE: "unstable"}[rest.region]
        if rest.region != UNSTABLE:
            own = np.sort([rest.pitch_rate, *rest.roll_yaw_rates]) / n
            np.testing.assert_allclose(imaginary(verdict, n), own, rtol=1e-7)


def test_regions_are_those_of_the_map():
    """Lagrange's triangle is I_pitch > I_roll > I_yaw; DeBra and Delp's needs 1 + 3k₁ + k₁k₃ > 4√(k₁k₃) below zero."""
    noise, seen = np.random.default_rng(3), set()
    for _ in range(300):
        moments = noise.uniform(1.0, 2.0, 3)
        for rest in orbital_equilibria(moments, 1.0):
            roll, pitch, yaw = moments[[rest.roll - 1, rest.pitch - 1, rest.yaw - 1]]
            assert (rest.region == LAGRANGE) == (pitch > roll > yaw)
            k1, k3 = (pitch - yaw) / roll, (pitch - roll) / yaw
            gyro = k3 < k1 < 0.0 and 1.0 + 3.0 * k1 + k1 * k3 > 4.0 * math.sqrt(k1 * k3)
            assert (rest.region == DEBRA_DELP) == gyro
            seen.add(rest.region)
    assert seen == {LAGRANGE, DEBRA_DELP, UNSTABLE}


def test_attitudes_are_all_24_rotations_of_the_axes():
    found = np.concatenate([rest.attitudes for rest in orbital_equilibria((1.0, 2.0, 2.5), 1.0)])
    assert len(np.unique(found.round(), axis=0)) == 24
    np.testing.assert_allclose(np.linalg.det(found), 1.0)


def test_the_libration_of_geosat():
    """A body of 85, 2530, 2530 kg m² 5° off at 800 km: 3561.363 s, 4K(sin 5°)/(n √(3·2445/2530)) at 30 digits."""
    orbit = KeplerOrbit.from_semi_major_axis(7178.137e3, GM, 0.0)
    n = float(orbit.mean_motion)
    rest = next(one for one in orbital_equilibria(GEOSAT, n) if one.yaw == 1 and one.pitch == 3)
    with mpmath.workdps(30):
        exact = 4 * mpmath.ellipk(mpmath.sin(mpmath.radians(5)) ** 2) / (
            mpmath.sqrt(mpmath.mpf(GM) / mpmath.mpf("7178137") ** 3) * mpmath.sqrt(mpmath.mpf(3 * 2445) / 2530))
    assert rest.libration_period(math.radians(5.0)) == pytest.approx(float(exact), rel=1e-14)
    assert float(exact) == pytest.approx(3561.363, abs=5e-4)
    system = SpinOrbit(math.sqrt(3 * 2445 / 2530), 0.0, n)
    assert libration_period(system, (math.radians(5.0), n)) == pytest.approx(float(exact), rel=1e-14)


@pytest.mark.parametrize(("angle", "rate"), [(0.3, 1.0), (1.4, 1.0), (0.2, 1.9), (-0.2, 0.4), (math.pi + 0.1, 1.0)])
def test_libration_periods_are_those_of_the_motion(angle, rate):
    """θ̈ = −½ n² ω0² sin 2(θ − n t), integrated over two zeros of θ̇ − n in the same sense."""
    system, turns = SpinOrbit(1.3, 0.0, 1.0), lambda t, s: s[1] - 1.0
    turns.direction = 1.0
    force = lambda t, s: [s[1], -0.5 * 1.3**2 * math.sin(2.0 * (s[0] - t))]  # noqa: E731
    found = solve_ivp(force, (0.0, 40.0), (angle, rate), "DOP853", events=turns, rtol=1e-12, atol=1e-13).t_events[0]
    assert libration_period(system, (angle, rate)) == pytest.approx(found[-1] - found[-2], rel=1e-9)


def test_a_spin_that_circulates_has_no_libration():
    assert libration_period(SpinOrbit(1.3, 0.0, 1.0), (0.2, 2.5)) is None
    assert libration_period(SpinOrbit(0.0, 0.0, 1.0), (0.2, 1.0)) is None
    with pytest.raises(InvalidInput, match="must be a circle"):
        libration_period(SpinOrbit(1.3, 0.1, 1.0), (0.2, 1.0))


@pytest.mark.long
@pytest.mark.parametrize(("transverse", "axial", "spin"), SPINS)
def test_spinning_rests_by_the_differentiated_equations(transverse, axial, spin):
    n = 0.0011
    for rest in spinning_equilibria(transverse, axial, n, spin * n):
        verdict = rest.stability
        assert rest.growth == pytest.approx(verdict.rate, abs=1e-8 * n)
        assert verdict.verdict == {STATIC: "stable", GYROSCOPIC: "undecided", UNSTABLE: "unstable"}[rest.region]
        if rest.rates is not None:
            np.testing.assert_allclose(imaginary(verdict, n), np.sort(rest.rates) / n, rtol=1e-6)


@pytest.mark.sweep
def test_their_axes_rest_in_an_integrated_motion():
    """Each axis stays within 1e-9 over an orbit, of a start that only it and the spin determine."""
    A, C, n, s = 1.0, 1.8, 1.0, 0.3
    system = orbiting_body((A, A, C), n)
    for rest in spinning_equilibria(A, C, n, s):
        across = np.linalg.svd(rest.axis[None, :])[2][1:]
        body = np.stack([across[0], np.cross(rest.axis, across[0]), rest.axis])  # principal axes by rows, in the frame
        normal, radius = body[:, 2], body[:, 0]
        start = np.concatenate([[A * n * normal[0], A * n * normal[1], C * s], normal, radius])
        field = lambda t, x: np.asarray(system.vector_field(t, x))  # noqa: E731
        path = solve_ivp(field, (0.0, 1.0), start, "DOP853", rtol=1e-11, atol=1e-12).y
        assert np.ptp(path[5]) < 1e-9 and np.ptp(path[8]) < 1e-9, rest.case


def test_thomsons_conditions():
    """Along the normal with s = n (1 + α): stable by energy where Cs > An and Cs + 3(C − A)n > An, Thomson's two."""
    for shape, alpha in itertools.product(np.linspace(0.2, 1.9, 12), np.linspace(-3.2, 3.1, 15)):
        rest = spinning_equilibria(1.0, shape, 1.0, 1.0 + alpha)[0]
        assert rest.case == CYLINDRICAL
        p = shape * (1.0 + alpha)
        assert (rest.region == STATIC) == (p > 1.0 and p + 3.0 * (shape - 1.0) > 1.0)


@pytest.mark.long
def test_a_wrong_gravity_would_be_seen():
    """Twice the moments' difference in the gravity alone moves the frequency in pitch by √2, which the law rejects."""
    rest = next(one for one in orbital_equilibria((3.0, 5.0, 7.8), 1.0) if one.region == LAGRANGE)
    wrong = math.sqrt(2.0) * rest.pitch_rate
    assert np.min(np.abs(imaginary(rest.stability, 1.0) - wrong)) > 0.1


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: orbital_equilibria((1.0, -2.0, 2.0), 1.0), "moments"),
        (lambda: orbital_equilibria((1.0, 2.0, 2.0), 0.0), "mean_motion"),
        (lambda: spinning_equilibria(1.0, 1.0, 1.0, math.inf), "spin"),
        (lambda: orbital_equilibria((1.0, 2.0, 2.5), 1.0)[0].libration_period(0.1), "no libration in pitch"),
        (lambda: orbital_equilibria((1.0, 2.0, 2.5), 1.0)[3].libration_period(1.6), "below π/2"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
