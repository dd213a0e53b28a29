"""Jacobi's elliptic functions and Legendre's integrals, given the *complementary* parameter m1 = 1 − m.

The parameter m = k² is the square of the modulus. Near m = 1 it loses the information: 1 − m then has few
digits or none, and functions that take m are wrong by order one beyond u = K, the quarter period. The nome of m is
q = exp(−πK(m1)/K(m)), in whose powers theta functions are short series. Source: Whittaker & Watson, ch. 21–22; DLMF
19, 20, 22.
"""

from __future__ import annotations

import math
from typing import Any

from polhode._base.arrays import as_float64, known_false, namespace
from polhode.errors import InvalidInput
from polhode.special import _doubledouble as dd
from polhode.special.carlson import carlson_rd, carlson_rf, carlson_rj
from polhode.types import Array, ArrayLike, ArrayOrFloat, Bool, Float64, Real

Operand = Float64[ArrayOrFloat, "*#shape"]
Result = Float64[Array, "*shape"]
SMALLEST_SQUARE = math.exp(-2.0 * 340.0)  # of e^−x, whose inverse is the integral's size


def jacobi(u: Real[ArrayLike, "*#shape"], m1: Real[ArrayLike, "*#shape"]) -> tuple[Result, Result, Result]:
    """Return (sn, cn, dn) of u with complementary parameter m1 in [0, 1].

    Errors are a few 1e-16 plus 1e-16 |u| times the slope, the effect of rounding u itself. cn and dn keep their
    relative accuracy where they are small.

    Raises:
        InvalidInput: for m1 outside [0, 1].

    >>> [round(float(x), 12) for x in jacobi(1.0, 0.5)]
    [0.803001824896, 0.595976567672, 0.823161001632]
    """
    sn, cn, dn, _ = _jacobi(u, m1)
    return sn, cn, dn


def amplitude(u: Real[ArrayLike, "*#shape"], m1: Real[ArrayLike, "*#shape"]) -> Result:
    """Return am u, the continuous angle with sin am = sn and cos am = cn."""
    sn, cn, _, turns = _jacobi(u, m1)
    xp = namespace(sn)
    # am(u + 2K) = am u + π: sn and cn change sign, dn does not
    odd = 1.0 - 2.0 * (turns - 2.0 * xp.floor(0.5 * turns))
    return xp.atan2(odd * sn, odd * cn) + math.pi * turns


def complete_k(m1: Real[ArrayLike, "*shape"]) -> Result:
    """Return K, the quarter period; infinite for m1 = 0."""
    xp, m1 = _parameter(m1)
    q, full = _nome_of(xp, m1)
    return _quarter_period(xp, q, full)


def incomplete_f(angle: Real[ArrayLike, "*#shape"], m1: Real[ArrayLike, "*#shape"]) -> Result:
    """Return F(φ | m) for |φ| ≤ π/2."""
    xp, m1 = _parameter(m1, angle)
    s, cc, dd_ = _amplitude_squares(xp, angle, m1)
    # DLMF 19.25.5, scaled so that csc²φ becomes 1
    return s * carlson_rf(cc, dd_, 1.0 + 0.0 * cc)


def incomplete_e(angle: Real[ArrayLike, "*#shape"], m1: Real[ArrayLike, "*#shape"]) -> Result:
    """Return E(φ | m) for |φ| ≤ π/2."""
    xp, m1 = _parameter(m1, angle)
    s, cc, dd_ = _amplitude_squares(xp, angle, m1)
    one = 1.0 + 0.0 * cc
    # DLMF 19.25.10: of its three forms that in which all terms have one sign for 0 ≤ m ≤ 1
    return m1 * s * carlson_rf(cc, dd_, one) + m1 * (1.0 - m1) / 3.0 * s**3 * carlson_rd(cc, one, dd_) + (
        1.0 - m1
    ) * s * xp.sqrt(cc) / xp.sqrt(dd_)


def incomplete_pi(
    n: Real[ArrayLike, "*#shape"], angle: Real[ArrayLike, "*#shape"], m1: Real[ArrayLike, "*#shape"]
) -> Result:
    """Return Π(n; φ | m) = ∫₀^φ dθ / ((1 − n sin²θ) √(1 − m sin²θ)) for |φ| ≤ π/2 and n sin²φ < 1."""
    xp, m1 = _parameter(m1, angle, n)
    n = as_float64(xp, n, "n")
    s, cc, dd_ = _amplitude_squares(xp, angle, m1)
    one = 1.0 + 0.0 * cc
    # DLMF 19.25.14, likewise
    return s * carlson_rf(cc, dd_, one) + n / 3.0 * s**3 * carlson_rj(cc, dd_, one, 1.0 - n * s * s)


def _amplitude_squares(xp: Any, angle: Array, m1: Array) -> tuple[Array, Array, Array]:
    """Return sin φ, cos² φ and 1 − m sin² φ = cos² φ + m1 sin² φ."""
    angle = as_float64(xp, angle, "angle")
    s, c = xp.sin(angle), xp.cos(angle)
    return s, c * c + 0.0 * m1, c * c + m1 * s * s


def _jacobi(u: Array, m1: Array) -> tuple[Array, Array, Array, Array]:
    xp, m1 = _parameter(m1, u)
    u = as_float64(xp, u, "u")
    u, m1 = xp.broadcast_arrays(u, m1)
    q, full = _nome_of(xp, m1)
    K = _quarter_period(xp, q, full)
    finite = m1 > 0
    safe = xp.where(finite, K, 1.0)
    # u less whole half periods 2K, in double-double: the rounding of 2K · turns would be that of the phase
    turns = xp.where(finite, xp.round(u / (2.0 * safe)), 0.0)
    product, error = dd.two_product(2.0 * safe, turns)
    rest = dd.two_sum(u - product, -error)
    to_quarter = xp.where(finite, (safe - xp.abs(rest[0])), math.inf)
    sn, cn, dn, _ = jacobi_at_reduced_phase(q, full, rest, to_quarter)
    odd = 1.0 - 2.0 * (turns - 2.0 * xp.floor(0.5 * turns))
    return odd * sn, odd * cn, dn, turns


def _parameter(m1: Array, *others: Array) -> tuple[Any, Array]:
    xp = namespace(m1, *others)
    m1 = as_float64(xp, m1, "m1")
    if known_false(xp.all((m1 >= 0) & (m1 <= 1))):
        raise InvalidInput("`m1`, the complementary parameter 1 − m, must lie in [0, 1].")
    return xp, m1


def _nome_of(xp: Any, m1: Array) -> tuple[Array, Array]:
    full = m1 >= 0.5
    return nome(xp.where(full, 1.0 - m1, m1)), full


def _quarter_period(xp: Any, q: Array, full: Array) -> Array:
    # K = (π/2) θ3² of its own nome; of the complementary one K = K′ · (−ln q)/π, as ln q = −πK/K′ (DLMF 22.2.1, 22.2.2)
    t3 = 1.0 + 2.0 * (q + q**4 + q**9)
    own = 0.5 * math.pi * t3 * t3
    positive = q > 0
    other = -own * xp.log(xp.where(positive, q, 0.5)) / math.pi
    return xp.where(full, own, xp.where(positive, other, math.inf))


def nome(parameter: Operand) -> Result:
    """Return the nome q = exp(−πK'/K) of a parameter in [0, ½], relatively accurate, without logarithms.

    Source: the inversion q = ε + 2ε⁵ + 15ε⁹ + …, ε = (1−√k)/(2(1+√k)), k = √(1−m) (Whittaker & Watson, 21.8).
    """
    return parameter * nome_per_parameter(parameter, namespace(parameter).sqrt(1.0 - parameter))


def nome_per_parameter(parameter: Operand, k: Operand) -> Result:
    """Return nome/parameter, with k = √(1 − parameter) given; nothing cancels."""
    xp = namespace(k)
    # ε = (1−√k)/(2(1+√k)) with 1 − √k = m/((1+√k)(1+k)), so that m is a factor
    root = 1.0 + xp.sqrt(k)
    ratio = 0.5 / ((1.0 + k) * root * root)
    e = ratio * parameter
    e4 = (e * e) * (e * e)
    return ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))))


def jacobi_at_reduced_phase(
    q: Operand, full: Bool[Array, "*#shape"], rest: tuple[Operand, Operand], to_quarter: Operand
) -> tuple[Result, Result, Result, Result]:
    """Return sn, cn, dn and ∫₀ᵘ (sn/dn)² at |u| ≤ K, from the smaller nome.

    Args:
        q: nome of m where ``full``, else of m1.
        full: whether m ≤ ½.
        rest: u in double-double.
        to_quarter: K − |u|, given without cancellation.
    """
    xp = namespace(q)
    t2, t3, t4 = thetas = theta_constants(q)
    # ∫₀ᵘ (sn/dn)² = θ3⁶/(θ2⁴ θ4⁴) [θ3′(z)/θ3(z) − z θ3″/θ3], z = u/θ3²: its derivative by u is θ3⁴ θ1(z)²/(θ2² θ4²
    # θ3(z)²), by (ln θ3)″ = θ3″/θ3 + θ2² θ4² θ1²/θ3². A factor 4q is taken out of the brackets: θ3″ = −4q kq, and
    # θ2⁴ = 16q t2⁴ cancels it.
    c2 = t3**6 / (4.0 * t2**4 * t4**4)
    kq = 2.0 + 8.0 * q**3 + 18.0 * q**8
    circular = _circular(q, thetas, c2, kq, xp.where(full, (rest[0] + rest[1]) / t3**2, 0.5))
    hyperbolic = _hyperbolic(q, thetas, c2, kq, rest, to_quarter, full)
    sn, cn, dn, integral = (xp.where(full, x, y) for x, y in zip(circular, hyperbolic, strict=True))
    return sn, cn, dn, integral


def sd_squared_over_half_period(q: Operand, full: Bool[Array, "*#shape"]) -> Result:
    """Return ∫ (sn/dn)² du over 2K; where not ``full``, q must not vanish."""
    xp = namespace(q)
    t2, t3, t4 = theta_constants(q)
    c2 = t3**6 / (4.0 * t2**4 * t4**4)
    kq = 2.0 + 8.0 * q**3 + 18.0 * q**8
    # z grows by π over 2K and θ3′/θ3 comes back. By the other nome z grows by πτ = −i ln q, over which θ3′/θ3 falls by
    # 2i (DLMF §20.2(ii)): that is the 1/(2q).
    safe = xp.where(full, 1.0, q)
    return xp.where(full, c2 * kq * math.pi / t3, c2 * (0.5 / safe + kq * xp.log(safe) / t3))


def theta_constants(q: Operand) -> tuple[Result, Result, Result]:
    """Return θ2/(2 q^¼), θ3 and θ4 at zero, for q ≤ e^−π."""
    return 1.0 + q**2 + q**6, 1.0 + 2.0 * (q + q**4 + q**9), 1.0 - 2.0 * (q - q**4 + q**9)


def _circular(q: Array, thetas: tuple[Array, ...], c2: Array, kq: Array, z: Array) -> tuple[Array, ...]:
    xp = namespace(q)
    t2, t3, t4 = thetas
    # sines and cosines of 2z, …, 6z by addition theorems; terms beyond them are below e^(−12π) = 4e-17
    first = (xp.sin(z), xp.cos(z))
    sines, cosines = [first[0]], [first[1]]
    for _ in range(5):
        s, c = sines[-1], cosines[-1]
        sines.append(s * first[1] + c * first[0])
        cosines.append(c * first[1] - s * first[0])
    s1, s2, s3, s4, s5, s6 = sines
    e1, e2, e3, e4, e5, e6 = cosines
    # θ1(z) and θ2(z) over 2q^¼, θ3(z), θ4(z); then sn = θ3 θ1(z)/(θ2 θ4(z)), cn = θ4 θ2(z)/(θ2 θ4(z)), dn = θ4
    # θ3(z)/(θ3 θ4(z)) (DLMF 22.2.4–22.2.6)
    a1, a2 = s1 - q**2 * s3 + q**6 * s5, e1 + q**2 * e3 + q**6 * e5
    a3 = 1.0 + 2.0 * (q * e2 + q**4 * e4 + q**9 * e6)
    a4 = 1.0 - 2.0 * (q * e2 - q**4 * e4 + q**9 * e6)
    F = c2 * (kq * z / t3 - (s2 + 2.0 * q**3 * s4 + 3.0 * q**8 * s6) / a3)
    return t3 / t2 * a1 / a4, t4 / t2 * a2 / a4, t4 / t3 * a3 / a4, F


def _hyperbolic(
    q: Array, thetas: tuple[Array, ...], c2: Array, kq: Array, rest: tuple[Array, Array], to_quarter: Array, full: Array
) -> tuple[Array, ...]:
    xp = namespace(q)
    t2, t3, t4 = thetas
    # Jacobi's imaginary transformation (DLMF §22.6(iv)): sn(u|m) = −i sc(iu|m1), cn = nc(iu|m1), dn = dc(iu|m1), with
    # thetas of ix, x = u/θ3². All are divided by e^x/2 (or 1), so that nothing overflows: h = e^(−2x), r = q
    # e^(2x) ≤ 1.
    side = xp.where(rest[0] < 0, -1.0, xp.ones_like(rest[0]))
    e = t3 - 1.0
    shrink = e * (2.0 + e) / t3**2  # 1 − 1/θ3²
    v = xp.where(full, 0.5, side * rest[0])
    x, low = dd.two_sum(v, -v * shrink)
    low = low + xp.where(full, 0.0, side * rest[1]) * (1.0 - shrink)
    x = xp.minimum(x, 700.0 + 0.0 * x)  # beyond it e^x overflows
    decay = xp.exp(-x) * (1.0 - low)
    h = xp.maximum(decay * decay, SMALLEST_SQUARE + 0.0 * decay)
    r = xp.where(q > 0, xp.exp(-2.0 * xp.where(full, 0.0, to_quarter) / t3**2), 0.0)  # = q e^2x ≤ 1
    q1r, q2r, q3r = q * r, q * q * r, q**3 * r
    h3, h5 = h**3, h**5
    # θ1(ix)/i and θ2(ix) over q^¼ e^x: the pairs e^((2n+1)x) ∓ e^(−(2n+1)x) have weights q^(n(n+1)) e^(2nx) = (qⁿ r)ⁿ
    g1 = (1.0 - h) - q1r * (1.0 - h3) + q2r**2 * (1.0 - h5) - q3r**3 * (1.0 - h5 * h * h)
    g2 = (1.0 + h) + q1r * (1.0 + h3) + q2r**2 * (1.0 + h5) + q3r**3 * (1.0 + h5 * h * h)
    # θ3(ix) = 1 + Σ oₙ, θ4(ix) = 1 + Σ (−1)ⁿ oₙ with oₙ = q^(n²) (e^(2nx) + e^(−2nx)), of which (q^(n−1) r)ⁿ is the
    # first
    o1, o2, o3, o4 = r + q * h, q1r**2 + (q * q * h) ** 2, q2r**3 + (q**3 * h) ** 3, q3r**4
    g3, g4 = 1.0 + o1 + o2 + o3 + o4, 1.0 - o1 + o2 - o3 + o4
    sn, cn, dn = side * t3 / t4 * g1 / g2, t2 / t4 * 2.0 * decay * g4 / g2, t2 / t3 * 2.0 * decay * g3 / g2
    # i times the integral of ``_circular`` at ix, with θ3′(ix) = −4iq Σ n q^(n²−1) sinh 2nx
    sinh = 0.5 / h * ((1.0 - h * h) + 2.0 * q * q1r * (1.0 - h**4) + 3.0 * q**6 * r**2 * (1.0 - h**6))
    return sn, cn, dn, side * c2 * (sinh / g3 - kq * x / t3)
