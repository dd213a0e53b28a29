"""Enclosures of numbers within limits, and of motions along Kepler's orbit, against mpmath and closed forms."""

import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
from flint import acb, arb, ctx

import polhode as ph
from polhode.errors import InvalidInput
from polhode.proving.enclosures._taylor_balls import BallSystem, eccentric_anomaly
from proving.test_enclosures import Scalar


def growing(scale):
    return Scalar(lambda t, x: x, jnp.asarray(scale))


@pytest.mark.parametrize("broken", [False, True])
def test_numbers_between_two_systems_are_held(monkeypatch, broken):
    """ẋ = x/s with s from 3 to 3.01: e^{t/s}; it fails without what the numbers change."""
    if broken:
        monkeypatch.setattr(BallSystem, "changes", lambda self, y, p, radii: [y[0] * 0])
    result = ph.certify(growing(3.0), [1.0], [0.0, 2.0, 4.0], other=growing(3.01))
    at, radius = result.states[-1, 0], result.radii[-1, 0]
    ends = np.exp(4.0 / np.linspace(3.0, 3.01, 7))
    assert (np.abs(ends - at) <= radius).all() == (not broken)
    if not broken:
        assert radius < 1.1 * np.ptp(ends)  # and no more than twice the half of it


@pytest.mark.long
def test_starts_and_numbers_of_a_top_are_held():
    moments = np.array([1.3, 1.3, 0.7])
    one, other = ph.systems.HeavyTop(moments, 1.0), ph.systems.HeavyTop(moments * (1.0 + 1e-5), 1.0 - 2e-5)
    start = one.pack((1.0, 0.0, 0.0, 0.0), momentum=(0.3, 0.2, 1.5))
    radii = np.where((np.arange(10) > 3) & (np.arange(10) < 7), 1e-6, 0.0)  # of the momentum
    result = ph.certify(one, start, [0.0, 1.5], other=other, state_radii=radii)
    rng, most = np.random.default_rng(2), np.zeros(10)
    for k in range(8):
        share = (0.0, 1.0)[k] if k < 2 else rng.uniform()
        between = ph.systems.HeavyTop(moments * (1.0 + 1e-5 * share), 1.0 - 2e-5 * rng.uniform())
        moved = ph.simulate(between, start + radii * rng.uniform(-1.0, 1.0, 10), [0.0, 1.5]).states[-1]
        most = np.maximum(most, np.abs(moved - result.states[-1]))
    assert (most <= result.radii[-1]).all() and result.radii[-1].max() < 30.0 * most.max()


def solved(mean_anomaly, eccentricity):
    """Return E by mpmath, from a bracket."""
    with mpmath.workdps(60):
        M, e = mpmath.mpf(mean_anomaly), mpmath.mpf(eccentricity)
        result = mpmath.findroot(lambda E: E - e * mpmath.sin(E) - M, (M - 1, M + 1), solver="anderson", tol=1e-100)
        return arb(mpmath.nstr(result, 55))


@pytest.mark.parametrize("eccentricity", [0.01, 0.3, 0.9, 0.999])
def test_keplers_equation_is_solved_in_balls(eccentricity):
    for M in (0.0, 1e-9, 0.3, 3.0, -2.0, 40.0):
        with ctx.workprec(160):
            result = eccentric_anomaly(arb(M), eccentricity)
            assert float(result.rad()) < 1e-40 * max(abs(M), 1e-5)
            assert abs(result - solved(M, eccentricity)) < 1e-40 * max(abs(M), 1e-5)
    with ctx.workprec(120):
        wide = eccentric_anomaly(arb(3.0, 1e-3), eccentricity)
        assert all(wide.contains(solved(M, eccentricity)) for M in (2.9991, 3.0, 3.0009))
        off_axis = eccentric_anomaly(acb(arb(3.0, 1e-3), arb(0.1, 1e-3)), eccentricity)
        back = off_axis - eccentricity * off_axis.sin()
        assert off_axis.is_finite() and back.contains(acb(3.0005, 0.1005))


def test_no_ball_is_found_where_there_are_several_solutions():
    assert not eccentric_anomaly(acb(arb(0.0, 0.5), arb(0.0, 0.5)), 0.99).is_finite()


@pytest.mark.sweep
def test_a_moon_in_an_eccentric_orbit_is_where_mpmath_says():
    moon = ph.celestial.SpinOrbit(0.26, 0.1, 1.0)
    start = np.array([0.2, 1.1])
    result = ph.certify(moon, start, [0.0, 0.5])
    with mpmath.workdps(30):
        e, strength = mpmath.mpf(0.1), mpmath.mpf(0.26) ** 2

        def field(t, y):
            E = mpmath.findroot(lambda E: E - e * mpmath.sin(E) - t, t)
            true = 2 * mpmath.atan(mpmath.sqrt((1 + e) / (1 - e)) * mpmath.tan(E / 2))
            r = 1 - e * mpmath.cos(E)
            return [y[1], -strength / 2 * mpmath.sin(2 * (y[0] - true)) / r**3]

        exact = mpmath.odefun(field, 0, [mpmath.mpf(x) for x in start], tol=mpmath.mpf(10) ** -22)(mpmath.mpf(0.5))
        assert all(abs(mpmath.mpf(float(x)) - y) <= mpmath.mpf(float(r)) + mpmath.mpf(10) ** -19
                   for x, y, r in zip(result.states[-1], exact, result.radii[-1], strict=True))  # fmt: skip


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"other": ph.systems.FreeRigidBody((1.0, 2.0, 3.0))}, "`other` must be a Scalar of the same form"),
        ({"state_radii": -1.0}, "`state_radii` must be numbers that are not negative, one or of shape"),
        ({"state_radii": [1.0, 2.0]}, "one or of shape"),
        ({"state_radii": "small"}, "one or of shape .* got 'small'"),
    ],
)
def test_limits_that_are_none_are_refused(more, words):
    with pytest.raises(InvalidInput, match=words):
        ph.certify(growing(3.0), [1.0], [0.0, 1.0], **more)


def test_orbits_of_two_eccentricities_are_refused():
    with pytest.raises(InvalidInput, match="the same eccentricity"):
        ph.certify(ph.celestial.SpinOrbit(0.26, 0.1, 1.0), [0.2, 1.1], [0.0, 1.0],
                   other=ph.celestial.SpinOrbit(0.26, 0.2, 1.0))  # fmt: skip
