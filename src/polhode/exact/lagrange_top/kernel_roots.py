"""The steps of ``roots`` for a block of tops, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode.exact.kernel_arithmetic import (
    Pair,
    add,
    called,
    choice,
    divide,
    inlined,
    multiply,
    multiply_float,
    pair,
    put,
    root,
    scale,
    square,
    square_root,
    subtract,
)
from polhode.exact.lagrange_top import kernel_store as at

CONVERGED = 2.0**-60  # of the last change over the root: what is left is smaller by a float64's precision
ONE, ZERO = (1.0, 0.0), (0.0, 0.0)
BEGIN, SLOPE, CURVE = 0.8660254, 0.1642, -0.0302  # of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4


@inlined
def _sharp_root(b: float, c: float, d: float) -> tuple[float, float, float]:
    """Return b/3, r and cos 3φ of Viète's formula for x³ + bx² + cx + d, ``roots._largest_root``."""
    third = b / 3.0
    P, Q = c - b * third, 2.0 * (third * third) * third - third * c + d
    r = square_root(max(-P / 3.0, 0.0))
    cosine = -0.5 * Q / (r * r * r) if r > 0.0 else 1.0
    return third, r, min(max(cosine, -1.0), 1.0)


@inlined
def _polished(x: Pair, b: Pair, c: Pair, d: Pair) -> tuple[Pair, float]:
    """Return the root after a step of Newton's, whose slope need not be sharp, and the change."""
    value = add(multiply(add(multiply(add(x, b), x), c), x), d)
    slope = (3.0 * x[0] + 2.0 * b[0]) * x[0] + c[0]
    change = -value[0] / slope
    return add(x, (change, 0.0)), change


@inlined
def _quotient(x: Pair, y: Pair) -> Pair:
    """Return x / y, and zero for x = 0 whatever y."""
    zero = x[0] == 0.0
    return choice(zero, x, divide(x, choice(zero, ONE, y)))


@inlined
def _larger_and_smaller(total: Pair, difference: Pair, product: Pair) -> tuple[Pair, Pair]:
    """Return ``roots._larger_and_smaller``."""
    positive = total[0] >= 0.0
    larger = scale(add(difference, choice(positive, total, (-total[0], -total[1]))), 0.5)
    smaller = choice(larger[0] > 0.0, _quotient(product, larger), ZERO)
    return choice(positive, larger, smaller), choice(positive, smaller, larger)


@inlined
def _root(x: Pair) -> Pair:
    """Return √x, zero for x = 0."""
    zero = x[0] == 0.0
    return choice(zero, ZERO, root(choice(zero, ONE, x)))


@called
def _apart(w: Any, count: int) -> None:
    """Put the root that stands apart into Y; UP says whether it is the upper one, or that it has not been found."""
    for i in range(count):
        g, c2, p2 = pair(w, at.G + i), square(pair(w, at.C + i)), square(pair(w, at.P + i))
        a, u0, w2 = w[at.L3 + i], pair(w, at.U0 + i), pair(w, at.W2 + i)
        f1 = subtract(scale(multiply_float(pair(w, at.TWIST + i), a), 2.0),
                      multiply(g, multiply(pair(w, at.S0 + i), pair(w, at.T0 + i))))  # fmt: skip
        f1 = subtract(f1, scale(multiply(u0, w2), 2.0))
        f2 = subtract(subtract(scale(multiply(g, u0), 2.0), w2), multiply_float((a, 0.0), a))
        gf, gp = multiply(g, f1), multiply(square(g), p2)
        third, r, cosine = _sharp_root(f2[0], gf[0], gp[0])
        inverse = divide(ONE, g)
        d, f, c = multiply(pair(w, at.D + i), inverse), multiply(pair(w, at.F + i), inverse), multiply(c2, inverse)
        d, f = (-d[0], -d[1]), scale(f, -2.0)
        other_third, other_r, other = _sharp_root(d[0], f[0], c[0])
        upper = cosine >= 0.0
        x = cosine if upper else max(other, 0.0)
        y = BEGIN + x * (SLOPE + x * CURVE)
        y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
        y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0)
        start = 2.0 * (r if upper else other_r) * y - (third if upper else other_third)
        b, c, d = choice(upper, f2, d), choice(upper, gf, f), choice(upper, gp, c)
        found, _ = _polished((start, 0.0), b, c, d)
        found, change = _polished(found, b, c, d)
        good = (found[0] > 0.0) & (abs(change) <= CONVERGED * found[0])
        w[at.UP + i] = (1.0 if upper else 0.0) if (w[at.UP + i] == 0.0) & good else -1.0
        put(w, at.Y + i, found)
        put(w, at.A + i, f1)


Points = tuple[Pair, Pair, Pair, Pair, Pair, Pair, Pair, Pair, Pair]


@inlined
def _upper_root_apart(g: Pair, s0: Pair, c2: Pair, p2: Pair, f1: Pair, Y0: Pair) -> Points:
    """Return ``roots._upper_root_apart``."""
    product = _quotient(p2, Y0)
    total = divide(add(f1, multiply(g, product)), Y0)
    gap = _root(add(square(total), scale(product, 4.0)))
    upper, lower = _larger_and_smaller(total, gap, product)
    s1, s2, z = add(s0, lower), subtract(s0, upper), subtract(Y0, multiply(g, s0))
    take = z[0] >= multiply(g, s2)[0]
    other = _quotient(c2, multiply(s1, choice(take, z, s2)))
    s2, z = choice(take, other, s2), choice(take, z, other)
    return lower, upper, gap, s1, s2, add(Y0, multiply(g, lower)), subtract(Y0, multiply(g, upper)), Y0, z


@inlined
def _lower_root_apart(g: Pair, s0: Pair, c2: Pair, p2: Pair, f: Pair, s1: Pair) -> Points:
    """Return ``roots._lower_root_apart``."""
    gs = multiply(g, s1)
    product = _quotient(c2, gs)
    total = divide(add(scale(f, -2.0), _quotient(c2, s1)), gs)
    between = _root(add(square(total), scale(product, 4.0)))
    s2, minus_s3 = _larger_and_smaller(total, between, product)
    z = multiply(g, minus_s3)
    Y0 = add(multiply(g, s0), z)
    upper, lower = subtract(s0, s2), subtract(s1, s0)
    take = upper[0] >= lower[0]
    other = _quotient(_quotient(p2, Y0), choice(take, upper, lower))
    upper, lower = choice(take, upper, other), choice(take, other, lower)
    return lower, upper, subtract(s1, s2), s1, s2, multiply(g, add(s1, minus_s3)), multiply(g, between), Y0, z


@called
def _points(w: Any, count: int) -> None:
    """Put the turning points into the store."""
    for i in range(count):
        g, s0, c2, p2 = pair(w, at.G + i), pair(w, at.S0 + i), square(pair(w, at.C + i)), square(pair(w, at.P + i))
        found, is_upper = pair(w, at.Y + i), w[at.UP + i] > 0.0
        a = _upper_root_apart(g, s0, c2, p2, pair(w, at.A + i), found)
        b = _lower_root_apart(g, s0, c2, p2, pair(w, at.F + i), found)
        upper, Y0, t0 = choice(is_upper, a[1], b[1]), choice(is_upper, a[7], b[7]), pair(w, at.T0 + i)
        t2, z = add(t0, upper), add(Y0, multiply(g, t0))
        put(w, at.LOWER + i, choice(is_upper, a[0], b[0]))
        put(w, at.UPPER + i, upper)
        put(w, at.GAP + i, choice(is_upper, a[2], b[2]))
        put(w, at.S1 + i, choice(is_upper, a[3], b[3]))
        put(w, at.S2 + i, choice(is_upper, a[4], b[4]))
        put(w, at.A + i, choice(is_upper, a[5], b[5]))
        put(w, at.B + i, choice(is_upper, a[6], b[6]))
        put(w, at.Y + i, Y0)
        put(w, at.Z_MINUS + i, choice(is_upper, a[8], b[8]))
        put(w, at.T2 + i, t2)
        put(w, at.Z_PLUS + i, z)
        put(w, at.T1 + i, _quotient(square(pair(w, at.C_PLUS + i)), multiply(t2, z)))


@called
def turning_points(w: Any, count: int) -> None:
    """Put ``roots.turning_points`` into the store; where UP is below zero they are left to NumPy."""
    _apart(w, count)
    _points(w, count)
