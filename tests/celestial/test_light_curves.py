"""Light of ellipsoids against quadrature over the lit and visible part, and frequencies against long light curves."""

import numpy as np
import pytest

import polhode as ph
from polhode.celestial import (
    ellipsoid_brightness,
    equivalent_ellipsoid,
    fit_tumbling,
    internal_damping_time,
    light_curve,
    light_curve_lines,
)

SUN, OBSERVER = np.array([0.6, 0.5, 0.3]), np.array([0.9, 0.0, 0.4])


def quadrature(semi_axes, sun, observer, law):
    """Return twice the light of an ellipsoid over π a b, by a rule on the sphere."""
    x, w = np.polynomial.legendre.leggauss(300)
    angle = 2 * np.pi * np.arange(600) / 600
    ring = np.sqrt(1 - x**2)[:, None]
    u = np.stack([ring * np.cos(angle), ring * np.sin(angle), x[:, None] + 0 * angle], axis=-1)
    normal = u / semi_axes
    size = np.linalg.norm(normal, axis=-1)
    incidence, emission = (normal @ (v / np.linalg.norm(v)) / size for v in (sun, observer))
    lit = (incidence > 0) & (emission > 0)
    light = np.where(lit, law(incidence, emission), 0.0) * size * np.prod(semi_axes)
    return 2 * (light * w[:, None]).sum() * (2 * np.pi / 600) / (np.pi * semi_axes[0] * semi_axes[1])


def lommel_seeliger(incidence, emission):
    return incidence * emission / np.where(incidence + emission > 0, incidence + emission, 1.0)


def test_light_is_the_integral_over_what_is_lit_and_seen():
    rng = np.random.default_rng(1)
    for _ in range(6):
        axes = np.sort(rng.uniform(0.3, 2.0, 3))[::-1]
        sun, observer = rng.standard_normal((2, 3))
        found = float(ellipsoid_brightness(axes, sun, observer))
        assert found == pytest.approx(quadrature(axes, sun, observer, lommel_seeliger), abs=2e-5)
        assert found != pytest.approx(quadrature(axes, sun, observer, lambda x, y: x * y), abs=2e-3)  # Lambert's law


def test_a_sphere_darkens_by_its_phase_alone():
    phase = np.radians([0.0, 1e-9, 60.0, 120.0, 180.0])
    sun = np.stack([np.sin(phase), 0 * phase, np.cos(phase)], axis=-1)
    half = 0.5 * phase[1:-1]
    expected = 1.0 - np.sin(half) * np.tan(half) * np.log(1.0 / np.tan(0.5 * half))  # Muinonen & Lumme 2015, eq. 1
    found = ellipsoid_brightness([2.0, 2.0, 2.0], sun, [0.0, 0.0, 1.0])
    assert found[0] == 1.0
    assert found[1:-1] == pytest.approx(expected, rel=1e-12)
    assert found[-1] == pytest.approx(0.0, abs=1e-12)


def test_frequencies_are_those_of_a_long_light_curve():
    motion = fit_tumbling(27.38, 263.0, [0.61, 0.965, 1.0])[0].motion
    axes = equivalent_ellipsoid([0.61, 0.965, 1.0])
    lines = light_curve_lines(motion, axes, SUN, OBSERVER, 8)
    times = np.linspace(0.0, 26300.0, 40001)[:-1]
    seen = light_curve(motion, times, axes, SUN, OBSERVER)
    window = 2 * np.hanning(len(times)) * (seen - seen.mean())
    measured = [2 * abs((window * np.exp(-2j * np.pi * f * times)).mean()) for f in lines.frequency]
    assert lines.amplitude == pytest.approx(measured, abs=2e-5)
    assert (lines.precession_order[0], lines.rotation_order[0]) == (2, -2)
    assert lines.frequency[0] == pytest.approx(2 / 27.38 - 2 / 263.0, rel=1e-12)


def test_the_ellipsoid_has_the_moments():
    a, b, c = equivalent_ellipsoid([0.61, 0.965, 1.0])
    found = np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    assert found / found[2] == pytest.approx([0.61, 0.965, 1.0], rel=1e-14)


def test_damping_is_harris_rule():
    year = 365.25 * 86400
    assert internal_damping_time(3600.0, 1000.0) / (1e9 * year) == pytest.approx(17.0**-3, rel=0.03)


@pytest.mark.parametrize(("call", "words"), [
    (lambda: ellipsoid_brightness([1.0, 1.0, 0.0], SUN, OBSERVER), "three positive"),
    (lambda: ellipsoid_brightness([1.0, 1.0, 1.0], [0.0, 0.0, 0.0], OBSERVER), "not zero"),
    (lambda: ellipsoid_brightness([1.0, 1.0, 1.0], SUN, [np.nan, 0.0, 0.0]), "finite"),
    (lambda: equivalent_ellipsoid([1.0, 2.0, 3.0]), "solid"), 
    (lambda: equivalent_ellipsoid([2.0, 1.0, 2.5]), "in ascending order"),
    (lambda: internal_damping_time(-1.0, 1.0), "period"), (lambda: internal_damping_time(1.0, 1.0, np.inf), "density"),
    (lambda: light_curve_lines(ph.FreeMotion([1, 2, 2.5], momentum=[0, 0, 1]), [3, 2, 1], SUN, OBSERVER), "tumble"),
    (lambda: light_curve(ph.FreeMotion([1, 2, 2.5], momentum=[0, 1, 1]), [0.0], [3, 2, 1], SUN, -SUN), "lit side"),
])  # fmt: skip
def test_bad_input_is_refused(call, words):
    with pytest.raises(ph.InvalidInput, match=words):
        call()
