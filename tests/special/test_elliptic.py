"""Elliptic integrals and functions and theta functions against mpmath, in NumPy, strict arrays and JAX."""

import array_api_strict
import jax
import mpmath
import numpy as np
import pytest
from flint import acb, ctx
from scipy.special import ellipj

from polhode.errors import InvalidInput
from polhode.special.carlson import carlson_rc, carlson_rd, carlson_rf, carlson_rj
from polhode.special.elliptic import amplitude, complete_k, incomplete_e, incomplete_f, incomplete_pi, jacobi
from polhode.special.theta import theta, theta1, theta2, theta3, theta4

mpmath.mp.dps = 60
RELATIVE = 4e-15
"""Twenty-two duplications lose no more than the roundings of their sums."""
ABSOLUTE = 2e-15
DECADES = 100
"""Products of three square roots of 1e±100 stay representable."""
BALL_BITS = 3000
"""Enough for balls to stay small at these ratios; mpmath's own R_J goes wrong there without a word."""


def draw(count, arguments, decades, seed):
    return 10.0 ** np.random.default_rng(seed).uniform(-decades, decades, (arguments, count))


def worst(found, wanted):
    return max(abs((mpmath.mpf(float(f)) - w) / w) for f, w in zip(found, wanted, strict=True))


@pytest.mark.long_cases("carlson_rj-elliptic_rj-4-100")
@pytest.mark.parametrize("decades", [1, DECADES])
@pytest.mark.parametrize(
    ("ours", "theirs", "count"),
    [
        (carlson_rf, acb.elliptic_rf, 3),
        (carlson_rc, acb.elliptic_rc, 2),
        (carlson_rd, lambda x, y, z: acb.elliptic_rj(x, y, z, z), 3),
        (carlson_rj, acb.elliptic_rj, 4),
    ],
)
def test_carlson(ours, theirs, count, decades):
    arguments = draw(60, count, decades, count)
    with ctx.workprec(BALL_BITS):
        balls = [theirs(*map(acb, map(float, column))).real for column in arguments.T]
    wanted = [mpmath.mpf(ball.str(50, radius=False)) for ball in balls]
    assert worst(ours(*arguments), wanted) < RELATIVE
    with jax.enable_x64(True):
        assert worst(jax.jit(ours)(*map(jax.numpy.asarray, arguments)), wanted) < RELATIVE
    strict = ours(*map(array_api_strict.asarray, arguments))
    assert worst(np.asarray(strict), wanted) < RELATIVE


def test_carlson_at_zeros_and_below():
    assert carlson_rf(0.0, 1.0, 1.0) == pytest.approx(np.pi / 2, rel=RELATIVE)
    assert carlson_rf(0.0, 1e-300, 1.0) == pytest.approx(float(mpmath.elliprf(0, mpmath.mpf(1e-300), 1)), rel=RELATIVE)
    assert carlson_rc(0.25, -2.0) == pytest.approx(float(mpmath.elliprc(0.25, -2.0)), rel=RELATIVE)
    assert carlson_rj(0.0, 1.0, 2.0, 1e-8) == pytest.approx(float(mpmath.elliprj(0, 1, 2, mpmath.mpf(1e-8))), rel=1e-13)


@pytest.mark.parametrize(
    "call",
    [
        lambda: carlson_rf(-1.0, 1.0, 1.0),
        lambda: carlson_rf(0.0, 0.0, 1.0),
        lambda: carlson_rc(1.0, 0.0),
        lambda: carlson_rd(1.0, 1.0, 0.0),
        lambda: carlson_rj(1.0, 1.0, 1.0, 0.0),
        lambda: jacobi(1.0, 1.5),
        lambda: theta1(0.3, 0.5),
        lambda: theta(5, 0.3, 0.0, 0.1),
    ],
)
def test_arguments_outside(call):
    with pytest.raises(InvalidInput):
        call()


def exact_jacobi(u, m1):
    """By R_F's inverse through mpmath's theta functions at high precision, with m1 as given."""
    m = 1 - mpmath.mpf(m1)
    return [mpmath.ellipfun(name, mpmath.mpf(u), m=m) for name in ("sn", "cn", "dn")]


CASES = [(u, m1) for u in (1e-8, 0.3, 1.9, -5.0, 17.0, 80.0) for m1 in (1.0, 0.9, 0.5, 0.3, 1e-3, 1e-10, 1e-16, 1e-30)]


@pytest.mark.parametrize("engine", ["numpy", "jax", "strict"])
def test_jacobi(engine):
    u, m1 = np.array(CASES).T
    if engine == "jax":
        with jax.enable_x64(True):
            found = np.asarray(jax.jit(jacobi)(jax.numpy.asarray(u), jax.numpy.asarray(m1)))
    else:
        convert = array_api_strict.asarray if engine == "strict" else np.asarray
        found = np.stack([np.asarray(x) for x in jacobi(convert(u), convert(m1))])
    for k, case in enumerate(CASES):
        for value, wanted in zip(found[:, k], exact_jacobi(*case), strict=True):
            # u carries a rounding of its own, and K one for each period
            assert abs(value - wanted) < ABSOLUTE * (1.0 + abs(case[0])), case


def test_jacobi_where_others_fail():
    u, m1 = 40.0, 1e-16
    wanted = exact_jacobi(u, m1)
    assert abs(jacobi(u, m1)[1] - wanted[1]) < ABSOLUTE * u
    assert abs(ellipj(u, 1.0 - m1)[1] - wanted[1]) > 0.1


def test_separatrix_is_hyperbolic():
    u = np.array([-3.0, 0.0, 1.0, 30.0])
    sn, cn, dn = jacobi(u, 0.0)
    assert np.abs(sn - np.tanh(u)).max() < ABSOLUTE
    assert np.abs(cn * np.cosh(u) - 1.0).max() < 3 * ABSOLUTE
    assert np.array_equal(cn, dn)


def test_amplitude_is_continuous_and_inverts_f():
    u = np.linspace(-12.0, 12.0, 4001)
    angles = amplitude(u, 0.2)
    assert np.abs(np.diff(angles)).max() < 0.01
    assert np.abs(np.sin(angles) - jacobi(u, 0.2)[0]).max() < 10 * ABSOLUTE
    assert incomplete_f(amplitude(1.1, 0.2), 0.2) == pytest.approx(1.1, rel=RELATIVE)


@pytest.mark.parametrize("m1", [1.0, 0.7, 0.2, 1e-8])
def test_legendre(m1):
    m = 1 - mpmath.mpf(m1)
    assert complete_k(m1) == pytest.approx(float(mpmath.ellipk(m)), rel=RELATIVE)
    for angle in (1e-5, 0.6, 1.5):
        assert incomplete_f(angle, m1) == pytest.approx(float(mpmath.ellipf(angle, m)), rel=RELATIVE)
        assert incomplete_e(angle, m1) == pytest.approx(float(mpmath.ellipe(angle, m)), rel=RELATIVE)
        for n in (-2.0, 0.0, 0.4):
            wanted = float(mpmath.ellippi(n, angle, m))
            assert incomplete_pi(n, angle, m1) == pytest.approx(wanted, rel=RELATIVE)


@pytest.mark.sweep
def test_jacobi_derivatives():
    with jax.enable_x64(True):
        for u, m1 in ((0.7, 0.3), (2.5, 0.8)):
            _, cn, dn = jacobi(u, m1)
            assert float(jax.grad(lambda x, m1=m1: jacobi(x, m1)[0])(u)) == pytest.approx(cn * dn, rel=1e-13)
            by_m1 = mpmath.diff(lambda x, u=u: mpmath.ellipfun("sn", u, m=1 - x), m1)
            assert float(jax.grad(lambda x, u=u: jacobi(u, x)[0])(m1)) == pytest.approx(float(by_m1), rel=1e-11)


@pytest.mark.parametrize("q", [0.0, 1e-9, 0.043, 0.2])
def test_theta(q):
    z = np.array([-2.0, 0.3, 5.0])
    for kind, ours in enumerate((theta1, theta2, theta3, theta4), start=1):
        wanted = [float(mpmath.jtheta(kind, x, q)) for x in z]
        assert ours(z, q) == pytest.approx(wanted, rel=RELATIVE, abs=ABSOLUTE)
        real, imaginary = theta(kind, z, 0.7, q)
        complex_ = [mpmath.jtheta(kind, mpmath.mpc(x, 0.7), q) for x in z]
        assert real == pytest.approx([float(w.real) for w in complex_], rel=1e-14, abs=4 * ABSOLUTE)
        assert imaginary == pytest.approx([float(w.imag) for w in complex_], rel=1e-14, abs=4 * ABSOLUTE)


def test_theta_of_a_larger_nome_is_refused():
    with pytest.raises(InvalidInput, match=r"`q` must lie in \[0, 0\.2\]"):
        theta3(0.3, np.nextafter(0.2, 1.0))


def test_theta_in_strict_arrays_and_a_broken_one():
    strict = array_api_strict.asarray([0.3, 1.0])
    value = np.asarray(theta3(strict, array_api_strict.asarray(0.04)))
    assert value == pytest.approx(theta3(np.array([0.3, 1.0]), 0.04), rel=RELATIVE)
    # θ3⁴ = θ2⁴ + θ4⁴ (Jacobi) fails if one sign is flipped
    assert theta3(0.0, 0.1) ** 4 == pytest.approx(theta2(0.0, 0.1) ** 4 + theta4(0.0, 0.1) ** 4, rel=RELATIVE)
    assert theta3(0.0, 0.1) ** 4 != pytest.approx(theta2(0.0, 0.1) ** 4 + theta4(0.0, 0.1001) ** 4, rel=1e-6)
