"""Sections, exponents and resonances of the spin-orbit problem, against other methods and published numbers."""

import itertools
import math

import jax
import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.celestial import SpinOrbit
from polhode.celestial.spin_orbit.resonances import (
    lyapunov_exponent,
    overlap_asphericity,
    overlap_threshold,
    poincare_section,
    resonance_strength,
    resonances,
    tangent_map,
)
from polhode.errors import InvalidInput
from polhode.systems import KeplerOrbit
from sweeping import first

AGREEMENT = 1e-9  # rad, of the composition and Dopri8 over ten orbits of regular motion
AREA = 1e-12  # relative to the square of the tangent map's entries, whose products the determinant subtracts
STRENGTH = 1e-14  # absolute, times the largest (a/r)³
REGULAR = np.array([[0.02, 1.0], [0.3, 2.4], [-1.0, 3.0]])
HYPERION = SpinOrbit(0.89, 0.1)


@pytest.mark.parametrize(("asphericity", "eccentricity"), first(0, [(0.2, 0.1), (0.2, 0.0), (0.05, 0.5)]))
def test_sections_are_those_of_adaptive_steps(asphericity, eccentricity):
    n, periods = 0.5, 10
    system = SpinOrbit(asphericity, eccentricity, n)
    start = REGULAR * [1.0, n]
    found = poincare_section(system, start, periods)
    times = 2 * np.pi / n * np.arange(periods + 1)
    other = ph.simulate(system, start, times).states
    off = np.remainder(found[..., 0] - other[..., 0] + np.pi, 2 * np.pi) - np.pi
    assert found.shape == (3, 11, 2) and (found[:, 0] == start).all()
    assert np.abs(off).max() < AGREEMENT and np.abs(found[..., 1] - other[..., 1]).max() < AGREEMENT
    assert np.abs(found[..., 0]).max() <= np.pi


@pytest.mark.sweep
def test_the_map_has_order_six():
    system = SpinOrbit(0.2, 0.3)
    ends = [poincare_section(system, REGULAR, 3, steps)[:, -1] for steps in (12, 16, 24, 200)]
    errors = [np.abs(np.sin(0.5 * (end - ends[-1]))).max() for end in ends[:-1]]
    slopes = np.log(np.array(errors[:-1]) / errors[1:]) / np.log([16 / 12, 24 / 16])
    assert np.abs(slopes - 6.0).max() < 0.6 and errors[-1] > 1e-11


@pytest.mark.long
def test_the_map_keeps_area_in_chaos_too():
    rng = np.random.default_rng(4)
    states = np.stack([rng.uniform(-np.pi, np.pi, 40), rng.uniform(0.0, 3.0, 40)], axis=-1)
    for system in (HYPERION, SpinOrbit(0.5, 0.7)):
        matrices = tangent_map(system, states, 2, steps=20)  # area needs no accuracy
        size = np.abs(matrices).max(axis=(-2, -1)) ** 2
        assert np.abs((np.linalg.det(matrices) - 1.0) / np.maximum(size, 1.0)).max() < AREA


def test_the_tangent_map_is_the_derivative_of_the_section():
    start, h = np.array([0.4, 1.1]), 1e-4
    sides = np.concatenate([np.eye(2), -np.eye(2), 2 * np.eye(2), -2 * np.eye(2)])
    ends = poincare_section(HYPERION, start + h * sides, 1)[:, 1]
    near, far = (ends[0:2] - ends[2:4]) / (2 * h), (ends[4:6] - ends[6:8]) / (4 * h)
    assert np.abs(((4 * near - far) / 3).T - tangent_map(HYPERION, start)).max() < 1e-8


def test_small_librations_in_synchronous_rotation():
    """Frequency n ω0 √H(1, e) up to ω0²: read from the rotation of the tangent map about its fixed point."""
    for asphericity, tolerance in ((0.02, 2e-4), (0.005, 2e-5)):
        system = SpinOrbit(asphericity, 0.05, 2.0)
        turn = 0.5 * np.trace(tangent_map(system, fixed_point(system)))
        frequency = math.acos(turn) / (2 * np.pi) * 2.0
        assert abs(frequency / resonances(system, 1.0)[1].half_width - 1.0) < tolerance


def fixed_point(system):
    """Newton's method on the rate: synchronous rotation is symmetric about periapsis, θ = 0."""
    n, rate = float(system.mean_motion), float(system.mean_motion)
    for _ in range(8):
        angle = poincare_section(system, [0.0, rate], 1)[1, 0]
        rate -= n * angle / tangent_map(system, [0.0, rate])[0, 1]
    return [0.0, rate]


@pytest.mark.long
def test_hyperion_tumbles_in_its_plane():
    """Wisdom, Peale & Mignard (1984): for ω0 = 0.89, e = 0.1 one large chaotic zone, its exponent about 0.1 n."""
    chaotic = np.array([[np.pi / 2, 1.0], [0.8, 0.5], [0.0, 1.5]])
    regular = np.array([[np.pi / 2, 2.7], [0.2, 3.5], [0.3, 0.8]])
    exponents = lyapunov_exponent(HYPERION, np.concatenate([chaotic, regular]), 2000)
    assert exponents.shape == (6, 2000) and (np.abs(exponents[:3, -1] - 0.12) < 0.03).all()
    times = 2 * np.pi * np.arange(1, 2001)
    assert (np.abs(exponents[3:, [500, -1]]) < 1.2 * np.log(times[[500, -1]]) / times[[500, -1]]).all()
    rates = poincare_section(HYPERION, np.concatenate([chaotic, regular]), 2000)[..., 1]
    assert (np.ptp(rates[:3], axis=1) > 2.0).all() and (np.ptp(rates[3:], axis=1) < 1.0).all()


def test_a_harmless_moon_is_regular():
    states = np.array([[0.1, 1.0], [0.7, 1.2], [0.0, 1.4]])
    exponents = lyapunov_exponent(SpinOrbit(0.05, 0.01, 3.0), states, 1000)
    times = 2 * np.pi / 3.0 * np.arange(1, 1001)
    assert (np.abs(exponents[:, [200, -1]]) < 2 * np.log(3.0 * times[[200, -1]]) / times[[200, -1]]).all()


SERIES = {
    0.0: lambda e: 0.0,
    0.5: lambda e: -e / 2 + e**3 / 16,
    1.0: lambda e: 1 - 5 * e**2 / 2 + 13 * e**4 / 16,
    1.5: lambda e: 7 * e / 2 - 123 * e**3 / 16,
    2.0: lambda e: 17 * e**2 / 2 - 115 * e**4 / 6,
    2.5: lambda e: 845 * e**3 / 48,
}


def test_strengths_begin_as_the_published_series():
    """Goldreich & Peale (1966), table; Murray & Dermott (1999), section 5.4. What is left out is of higher order."""
    for order, series in SERIES.items():
        for e in (0.01, 0.02):
            assert abs(resonance_strength(order, e) - series(e)) < 50 * e**5
    assert [r.strength for r in resonances(SpinOrbit(0.1, 0.0), 2.0)] == [0.0, 1.0, 0.0, 0.0]


@pytest.mark.long_after(2)
@pytest.mark.parametrize("e", [0.05, 0.206, 0.7, 0.95])
def test_strengths_are_the_integrals(e):
    """In mean anomaly by mpmath's quadrature, Kepler's equation solved again: another variable, another rule."""
    for order in (0.5, 1.5, -1.0, 4.0):
        with mpmath.workdps(25):

            def integrand(f, order=order):
                half = mpmath.atan(mpmath.sqrt((1 - mpmath.mpf(e)) / (1 + mpmath.mpf(e))) * mpmath.tan(f / 2))
                M = 2 * half - e * mpmath.sin(2 * half)
                root = mpmath.sqrt(1 - mpmath.mpf(e) ** 2)
                return (1 + e * mpmath.cos(f)) / root**3 * mpmath.cos(2 * f - 2 * order * M)

            exact = mpmath.quad(integrand, mpmath.linspace(0, mpmath.pi, 9)) / mpmath.pi
            assert abs(resonance_strength(order, e) - exact) < STRENGTH * (1 - e) ** -3


def test_zones_touch_at_the_threshold():
    for e in (1e-4, 1e-3):
        first, second = resonances(SpinOrbit(float(overlap_threshold(e)), e), 1.5)[1:]
        assert abs(first.half_width + second.half_width - 0.5) < 3 * e
    assert (np.diff(overlap_threshold([0.0, 0.1, 0.5])) < 0).all() and float(overlap_threshold(0.0)) == 0.5
    assert float(overlap_threshold(0.1)) < 0.89


def test_resonances_say_where_the_spin_librates():
    """Started at the stable angle the spin stays about it; started across from it it leaves."""
    system = SpinOrbit(0.05, 0.1, 2.0)
    for resonance in resonances(system, 2.0):
        angle = resonance.stable_angle
        near = poincare_section(system, [angle + 0.05, resonance.rate], 400)[:, 0]
        far = poincare_section(system, [angle + np.pi / 2 + 0.05, resonance.rate], 400)[:, 0]
        assert np.abs(np.sin(near - angle)).max() < 0.35 and np.abs(np.sin(far - angle)).min() < 0.35
    edge = resonances(system, 1.0)[1]
    for share, librates in ((0.85, True), (1.15, False)):
        end = poincare_section(system, [0.0, edge.rate + share * edge.half_width], 400)[:, 0]
        assert (np.abs(np.sin(end)).max() < 0.999 and np.cos(end).min() > 0) == librates


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: poincare_section(HYPERION, [0.0, 1.0], 0), "`periods` must be a whole number, at least 1"),
        (lambda: poincare_section(HYPERION, [0.0, 1.0], 5, 1.5), "`steps` must be a whole number, at least 1"),
        (lambda: poincare_section(HYPERION, [0.0, 1.0, 2.0], 5), r"shape \(…, 2\)"),
        (lambda: lyapunov_exponent(HYPERION, [0.0, np.nan], 5), "finite"),
        (lambda: resonance_strength(0.3, 0.1), "half an integer"),
        (lambda: resonance_strength(0.5, 1.1), "`eccentricity`"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


def test_zones_touch_at_the_overlap():
    """There the half-widths of two neighbours add up to their distance, and of no others to more."""
    least = overlap_asphericity(resonances(SpinOrbit(0.1, 0.1), 3.0))
    assert least is not None
    at = resonances(SpinOrbit(least, 0.1), 3.0)
    gaps = [b.rate - a.rate - a.half_width - b.half_width for a, b in itertools.pairwise(at)]
    assert min(gaps) == pytest.approx(0.0, abs=1e-14)
    assert overlap_asphericity(resonances(SpinOrbit(0.1, 0.0), 3.0)) is None
    # near a circle it is Wisdom's threshold, to first order in √e
    small = overlap_asphericity(resonances(SpinOrbit(0.1, 1e-4), 3.0))
    assert small == pytest.approx(float(overlap_threshold(1e-4)), rel=1e-3)


def test_the_orbit_is_fastest_at_periapsis():
    orbit = KeplerOrbit(0.7, 0.4)
    slope = float(jax.grad(orbit.true_anomaly)(0.0))
    assert float(orbit.rate_at_periapsis) == pytest.approx(slope, rel=1e-14)
