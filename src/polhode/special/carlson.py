"""Carlson's symmetric elliptic integrals, by duplication, on any array namespace.

Arguments are scaled by powers of four first, so that only their ratios matter. Source: Carlson, Numer. Algorithms 10
(1995) 13; the closing series to the seventh order are DLMF 19.36.1 and 19.36.2.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode._base.arrays import as_float64, forward_columns, is_jax, is_traced, iterate, iterate_until, namespace
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real


class DuplicationLimits(NamedTuple):
    """When duplication ends."""

    steps: int = 22  # halve the exponent of the largest ratio about nine times, then divide the spread by four
    max_steps: int = 600  # of R_J, as a large p shrinks by four a step only
    max_spread: float = 2e-3  # relative, of R_J; the closing series leaves its eighth power


LIMITS = DuplicationLimits()


def carlson_rf(
    x: Real[ArrayLike, "*#shape"], y: Real[ArrayLike, "*#shape"], z: Real[ArrayLike, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return R_F(x, y, z) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z)), at most one argument zero.

    Raises:
        InvalidInput: for negative arguments or two zeros.

    >>> round(float(carlson_rf(1.0, 2.0, 0.0)), 14)
    1.31102877714606
    """
    xp, (x, y, z) = _arguments(x=x, y=y, z=z)
    _check(xp, {"x": x, "y": y, "z": z}, (x + y > 0) & (y + z > 0) & (z + x > 0))
    root, (x, y, z) = _scale(xp, x, y, z)

    # duplication, which leaves the integral and divides the spread of its arguments by four (DLMF §19.26(iii))
    def step(now: tuple[Array, ...]) -> tuple[Array, ...]:
        a, b, c = now
        lam = _lambda(xp, a, b, c)
        return 0.25 * (a + lam), 0.25 * (b + lam), 0.25 * (c + lam)

    x, y, z = iterate(LIMITS.steps, step, (x, y, z), like=x)
    mean = (x + y + z) / 3.0
    # the elementary symmetric functions of X, Y, Z, of which the first, X + Y + Z, is zero
    X, Y = 1.0 - x / mean, 1.0 - y / mean
    Z = -(X + Y)
    E2, E3 = X * Y - Z * Z, X * Y * Z
    tail = -3.0 * E2 * E3 / 44.0 - 5.0 * E2**3 / 208.0 + 3.0 * E3 * E3 / 104.0 + E2 * E2 * E3 / 16.0
    return (1.0 - E2 / 10.0 + E3 / 14.0 + E2 * E2 / 24.0 + tail) / xp.sqrt(mean) / root


def carlson_rc(x: Real[ArrayLike, "*#shape"], y: Real[ArrayLike, "*#shape"]) -> Float64[Array, "*shape"]:
    """Return R_C(x, y) = R_F(x, y, y); for y < 0 its Cauchy principal value.

    Raises:
        InvalidInput: for x < 0 or y = 0.
    """
    xp, (x, y) = _arguments(x=x, y=y)
    _check(xp, {"x": x}, y != 0)
    # DLMF 19.2.20: R_C(x, y) = √(x/(x−y)) R_C(x−y, −y) is Cauchy's principal value for y < 0
    below = y < 0
    factor = xp.where(below, xp.sqrt(x / xp.where(below, x - y, 1.0)), 1.0)
    first, second = xp.where(below, x - y, x), xp.abs(y)
    return factor * carlson_rf(first, second, second)


def carlson_rd(
    x: Real[ArrayLike, "*#shape"], y: Real[ArrayLike, "*#shape"], z: Real[ArrayLike, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return R_D(x, y, z) = R_J(x, y, z, z), with z > 0 and at most one of x and y zero.

    Raises:
        InvalidInput: for arguments outside.
    """
    xp, (x, y, z) = _arguments(x=x, y=y, z=z)
    _check(xp, {"x": x, "y": y, "z": z}, (x + y > 0) & (z > 0))
    root, (x, y, z) = _scale(xp, x, y, z)

    def step(now: tuple[Array, ...]) -> tuple[Array, ...]:
        a, b, c, total, power = now
        lam = _lambda(xp, a, b, c)
        # R_D(a, b, c) = ¼ R_D((a+λ)/4, …) + 3/(√c (c+λ)): the sum Σ 4⁻ⁿ/(√c_n (c_n+λ_n)) is tripled at the end
        total = total + power / (xp.sqrt(c) * (c + lam))
        return 0.25 * (a + lam), 0.25 * (b + lam), 0.25 * (c + lam), total, 0.25 * power

    zero = 0.0 * (x + y + z)
    x, y, z, total, power = iterate(LIMITS.steps, step, (x + zero, y + zero, z + zero, zero, 1.0 + zero), like=x)
    # c counts three times: E_k are the symmetric functions of (X, Y, Z, Z, Z), where X + Y + 3Z = 0
    mean = (x + y + 3.0 * z) / 5.0
    X, Y = 1.0 - x / mean, 1.0 - y / mean
    Z = -(X + Y) / 3.0
    E2, E3 = X * Y - 6.0 * Z * Z, (3.0 * X * Y - 8.0 * Z * Z) * Z
    E4, E5 = 3.0 * (X * Y - Z * Z) * Z * Z, X * Y * Z**3
    return (power * _closing_series(E2, E3, E4, E5) / (mean * xp.sqrt(mean)) + 3.0 * total) / root**3


def carlson_rj(
    x: Real[ArrayLike, "*#shape"],
    y: Real[ArrayLike, "*#shape"],
    z: Real[ArrayLike, "*#shape"],
    p: Real[ArrayLike, "*#shape"],
) -> Float64[Array, "*shape"]:
    """Return R_J(x, y, z, p) = 3/2 ∫₀^∞ dt / ((t+p) √((t+x)(t+y)(t+z))), p > 0, at most one of x, y, z zero.

    JAX differentiates it once, in either mode.

    Raises:
        InvalidInput: for arguments outside.
    """
    xp, (x, y, z, p) = _arguments(x=x, y=y, z=z, p=p)
    _check(xp, {"x": x, "y": y, "z": z, "p": p}, (x + y > 0) & (y + z > 0) & (z + x > 0) & (p > 0))
    if not is_jax(x):
        return _third_kind(x, y, z, p)
    columns = xp.stack(xp.broadcast_arrays(x, y, z, p), axis=-1)
    # its loop ends where it has converged, and reverse mode would need the number of its steps beforehand
    return forward_columns(lambda v: _third_kind(*(v[..., k] for k in range(4))), "carlson_rj")(columns)


def _third_kind(x: Array, y: Array, z: Array, p: Array) -> Array:
    xp = namespace(x)
    root, (x, y, z, p) = _scale(xp, x, y, z, p)

    def step(*now: Array) -> tuple[Array, ...]:
        a, b, c, r, total, power = now
        lam = _lambda(xp, a, b, c)
        # Carlson 1995: R_J = 4⁻ⁿ R_J(a_n, …) + 6 Σ 4⁻ⁿ R_C(1, 1+e_n)/d_n, d = (√r+√a)(√r+√b)(√r+√c) and
        # e = (r−a)(r−b)(r−c)/d²
        sa, sb, sc, sr = xp.sqrt(a), xp.sqrt(b), xp.sqrt(c), xp.sqrt(r)
        total = total + power * _rc_beside_one(xp, sa, sb, sc, sr) / ((sr + sa) * (sr + sb) * (sr + sc))
        quarter = (0.25 * (v + lam) for v in (a, b, c, r))
        return (*quarter, total, 0.25 * power)

    def finished(*now: Array) -> Array:
        mean = (now[0] + now[1] + now[2] + 2.0 * now[3]) / 5.0
        close = [xp.abs(v - mean) < LIMITS.max_spread * mean for v in now[:4]]
        return close[0] & close[1] & close[2] & close[3]

    zero = 0.0 * (x + y + z + p)
    start = (x + zero, y + zero, z + zero, p + zero, zero, 1.0 + zero)
    x, y, z, p, total, power = iterate_until(step, finished, start, at_once=6, most=LIMITS.max_steps)
    # p counts twice: E_k are the symmetric functions of (X, Y, Z, P, P), where X + Y + Z + 2P = 0
    mean = (x + y + z + 2.0 * p) / 5.0
    X, Y, Z = 1.0 - x / mean, 1.0 - y / mean, 1.0 - z / mean
    P = -(X + Y + Z) / 2.0
    E2 = X * Y + X * Z + Y * Z - 3.0 * P * P
    E3 = X * Y * Z + 2.0 * E2 * P + 4.0 * P**3
    E4, E5 = (2.0 * X * Y * Z + E2 * P + 3.0 * P**3) * P, X * Y * Z * P * P
    return (power * _closing_series(E2, E3, E4, E5) / (mean * xp.sqrt(mean)) + 6.0 * total) / root**3


def _rc_beside_one(xp: Any, sa: Array, sb: Array, sc: Array, sr: Array) -> Array:
    """Return R_C(1, 1 + e) with e = Π (sr − s)/(sr + s): artanh √−e/√−e or atan √e/√e, a series where e is small.

    Where e is near −1, 1 + e comes from the small τ = 2 min(sr, s)/(sr + s), |factor| = 1 − τ, without cancelling.
    """
    e = ((sr - sa) / (sr + sa)) * ((sr - sb) / (sr + sb)) * ((sr - sc) / (sr + sc))
    t, u, v = (2.0 * xp.minimum(sr, x) / (sr + x) for x in (sa, sb, sc))
    # 1 − |e| = 1 − (1−t)(1−u)(1−v), without the difference
    above = t + (1.0 - t) * (u + (1.0 - u) * v)
    small = xp.abs(e) < 1e-3
    size = xp.sqrt(xp.where(small, 0.25, xp.abs(e)))
    # Σ (−e)ⁿ/(2n+1); the next term is below e⁶/13 = 1e-19
    series = 1.0 - e * (1.0 / 3.0 - e * (1.0 / 5.0 - e * (1.0 / 7.0 - e * (1.0 / 9.0 - e / 11.0))))
    # artanh s = ½ ln((1+s)/(1−s)) = ln((1+s)/√(1−s²)), with 1 − s² = 1 + e
    artanh = xp.log((1.0 + size) / xp.sqrt(above))
    return xp.where(small, series, xp.where(e < 0, artanh, xp.atan(size)) / size)


def _closing_series(E2: Array, E3: Array, E4: Array, E5: Array) -> Array:
    # DLMF 19.36.2, for R_D and R_J alike
    value = 1.0 - 3.0 * E2 / 14.0 + E3 / 6.0 + 9.0 * E2 * E2 / 88.0 - 3.0 * E4 / 22.0 - 9.0 * E2 * E3 / 52.0
    value = value + 3.0 * E5 / 26.0 - E2**3 / 16.0 + 3.0 * E3 * E3 / 40.0 + 3.0 * E2 * E4 / 20.0
    return value + 45.0 * E2 * E2 * E3 / 272.0 - 9.0 * (E3 * E4 + E2 * E5) / 68.0


def _lambda(xp: Any, x: Array, y: Array, z: Array) -> Array:
    a, b, c = xp.sqrt(x), xp.sqrt(y), xp.sqrt(z)
    return a * b + b * c + c * a


def _scale(xp: Any, *values: Array) -> tuple[Array, tuple[Array, ...]]:
    """Return √s and the values over s, a power of four near the largest."""
    largest = values[0]
    for value in values[1:]:
        largest = xp.maximum(largest, value)
    # R_F(sx, sy, sz) = R_F/√s, R_D and R_J by s^(−3/2): with s = 4ⁿ the root and the quotients are exact
    half = xp.round(0.5 * xp.log2(xp.where(largest > 0, largest, 1.0)))
    root = 2.0**half
    return root, tuple(value / root / root for value in values)


def _arguments(**named: Array) -> tuple[Any, list[Array]]:
    xp = namespace(*named.values())
    return xp, [as_float64(xp, value, name) for name, value in named.items()]


def _check(xp: Any, nonnegative: dict[str, Array], rule: Array) -> None:
    if is_traced(rule, *nonnegative.values()):
        return
    for name, value in nonnegative.items():
        if not bool(xp.all(value >= 0)):
            raise InvalidInput(f"`{name}` must not be negative in Carlson's integrals.")
    if not bool(xp.all(rule)):
        raise InvalidInput("Carlson's integral diverges: at most one of x, y, z may vanish, and the last argument not.")
