"""Kepler's orbit against mpmath, and against the law of gravity itself."""

import equinox as eqx
import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.systems.kepler_orbit import KeplerOrbit, solve_kepler
from sweeping import first

ULPS = 6e-16  # relative: three roundings of E
ANGLE = 2e-15  # rad, rounding of angles up to a turn
DERIVATIVE = 1e-12  # relative
ECCENTRICITIES = (0.0, 1e-9, 0.0549, 0.5, 0.9, 0.99, 0.999999, 1.0 - 2.0**-50)
ANOMALIES = (0.0, 1e-300, 1e-20, 1e-12, 1e-6, 1e-3, 0.05, 0.5, 1.0, 2.0, 3.0, 3.14159, np.pi)


def true_eccentric(M, e):
    """Bisection in 60 digits: what is under test must not guide it."""
    with mpmath.workdps(60):
        M, e = mpmath.mpf(float(M)), mpmath.mpf(float(e))
        low, high = M, M / (1 - e)
        for _ in range(400):
            middle = mpmath.sqrt(low * high) if low > 0 else (low + high) / 2
            if middle - e * mpmath.sin(middle) < M:
                low = middle
            else:
                high = middle
        return (low + high) / 2


@pytest.mark.parametrize("e", ECCENTRICITIES)
def test_keplers_equation_is_solved_to_rounding(e):
    found = np.asarray(solve_kepler(jnp.array(ANOMALIES), jnp.asarray(e)))
    for M, E in zip(ANOMALIES, found, strict=True):
        assert abs(E - true_eccentric(M, e)) <= ULPS * abs(E), (M, e)
    assert (np.asarray(solve_kepler(-jnp.array(ANOMALIES), jnp.asarray(e))) == -found).all()


@pytest.mark.long_cases("0.0")
@pytest.mark.parametrize("e", [0.0, 0.3, 0.99, 0.999999])
def test_anomalies_distance_and_direction_agree_with_mpmath(e):
    orbit = KeplerOrbit(1.0, e)
    times = np.array([1e-9, 0.01, 0.4, 2.0, 3.1, -2.5])
    f, ratio, way = (np.asarray(g(times)) for g in (orbit.true_anomaly, orbit.distance_ratio, orbit.direction))
    for k, t in enumerate(times):
        with mpmath.workdps(40):
            E = mpmath.sign(t) * true_eccentric(abs(t), e)
            exact = mpmath.mpf(float(e))
            r = 1 - exact * mpmath.cos(E)
            x, y = (mpmath.cos(E) - exact) / r, mpmath.sqrt(1 - exact**2) * mpmath.sin(E) / r
            assert abs(ratio[k] / r - 1) < ANGLE
            assert abs(f[k] - mpmath.atan2(y, x)) < ANGLE
            assert max(abs(way[k, 0] - x), abs(way[k, 1] - y)) < ANGLE
    assert not way[:, 2].any()


@pytest.mark.long
def test_anomalies_grow_through_apoapsis_and_repeat():
    orbit = KeplerOrbit(0.5, 0.7, mean_anomaly=1.0)
    times = np.linspace(-40.0, 40.0, 4001)
    assert (np.diff(orbit.true_anomaly(times)) > 0).all() and (np.diff(orbit.eccentric_anomaly(times)) > 0).all()
    turn = orbit.true_anomaly(times + float(orbit.period)) - orbit.true_anomaly(times)
    assert np.abs(turn - 2 * np.pi).max() < 1e-13
    assert float(KeplerOrbit(2.0, 0.4, 0.3).mean_anomaly(0.0)) == 0.3


@pytest.mark.long
@pytest.mark.parametrize("e", first(1, [0.2, 0.0, 0.9]))
def test_it_falls_as_gravity_says(e):
    """r'' = −r/r³ with n = a = 1, by differentiating the position twice: derivatives and mechanics in one."""
    orbit = KeplerOrbit(1.0, e)
    place = lambda t: orbit.distance_ratio(t) * orbit.direction(t)  # noqa: E731
    speed = jax.jacfwd(place)
    motion = jax.jit(lambda t: (place(t), speed(t), jax.jacfwd(speed)(t)))
    for t in (0.0, 0.7, 3.0, np.pi, 11.0):
        r, v, a = map(np.asarray, motion(t))
        expected = -r / np.linalg.norm(r) ** 3
        assert np.abs(a - expected).max() < DERIVATIVE * np.abs(expected).max()
        assert abs(np.cross(r, v)[2] - np.sqrt(1 - e**2)) < DERIVATIVE


@pytest.mark.long
def test_derivatives_by_eccentricity_are_those_of_differences_and_finite_at_periapsis():
    for e, M in ((0.3, 1.2), (0.95, 0.02), (0.95, 3.0)):
        slope = float(jax.grad(solve_kepler, argnums=1)(M, e))
        with mpmath.workdps(60):
            h = mpmath.mpf(10) ** -20
            low, high = (
                mpmath.findroot(lambda E, e=near, M=M: E - e * mpmath.sin(E) - mpmath.mpf(M), true_eccentric(M, e))
                for near in (mpmath.mpf(e) - h, mpmath.mpf(e) + h)
            )
            assert abs(slope - (high - low) / (2 * h)) < DERIVATIVE * abs(slope)
    gradient = eqx.filter_grad(lambda orbit: orbit.true_anomaly(0.0))(KeplerOrbit(1.0, 0.0))
    assert np.isfinite(jax.tree.leaves(gradient)).all()
    second = jax.grad(jax.grad(solve_kepler))(0.0, 0.0)
    assert np.isfinite(second)


def test_from_semi_major_axis():
    geostationary = KeplerOrbit.from_semi_major_axis(42_164.17e3, 3.986004418e14, 0.0)
    assert abs(float(geostationary.period) - 86_164.1) < 0.1  # the sidereal day


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: KeplerOrbit(0.0, 0.1), "`mean_motion` must be positive and finite"),
        (lambda: KeplerOrbit(1.0, 1.0), "below 1"),
        (lambda: KeplerOrbit(1.0, -0.1), "`eccentricity`"),
        (lambda: KeplerOrbit(1.0, np.nan), "`eccentricity`"),
        (lambda: KeplerOrbit(1.0, 0.1, np.inf), "`mean_anomaly`"),
        (lambda: KeplerOrbit("fast", 0.1), "`mean_motion`"),
        (lambda: KeplerOrbit.from_semi_major_axis(-1.0, 1.0, 0.0), "`semi_major_axis`"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
