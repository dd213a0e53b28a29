"""Double-double arithmetic: unevaluated sums ``high + low`` with about 32 digits, on any array namespace.

A number is a pair ``(high, low)`` of float64 arrays with |low| ≤ ulp(high)/2. Every operation here keeps about
1e-31 relative accuracy; ``add`` and ``subtract`` do so unless the leading digits cancel, where an error of
1e-32 of the larger operand remains.

Source: Dekker, Numer. Math. 18 (1971) 224; Hida, Li & Bailey, ARITH-15 (2001).
"""

from __future__ import annotations

import numpy as np

from polhode._base.arrays import is_jax, iterate, namespace, split_halves
from polhode.types import Array, ArrayOrFloat, Bool, Float64

DoubleDouble = tuple[Float64[ArrayOrFloat, "..."], Float64[ArrayOrFloat, "..."]]

# of the functions here, which broadcast
Operand = Float64[ArrayOrFloat, "*#shape"]
Result = Float64[ArrayOrFloat, "*shape"]
Pair = tuple[Operand, ...]  # high and low; a slice of a value that a loop carries has no static length
Pairs = tuple[Result, Result]
Sum = tuple[Operand, ...]  # of floats, never added up

PI: DoubleDouble = (np.pi, 1.2246467991473532e-16)
INVERSE_TWO_PI: DoubleDouble = (0.15915494309189535, -9.839338337591243e-18)
LN2: DoubleDouble = (0.6931471805599453, 2.3190468138462996e-17)


def two_sum(a: Operand, b: Operand) -> Pairs:
    """Return fl(a + b) and its exact error [Knuth]."""
    # e = (a − (s − t)) + (b − t) with t = s − a, which holds for either order of |a| and |b|: Knuth, *Seminumerical
    # Algorithms*, §4.2.2
    s = a + b
    t = s - a
    e = b - t
    t = s - t
    t -= a  # in place, as all below: new arrays cost NumPy more than the sums themselves
    e -= t
    return s, e


def fast_two_sum(a: Operand, b: Operand) -> Pairs:
    """Return fl(a + b) and its exact error, for |a| ≥ |b| [Dekker]."""
    s = a + b
    return s, b - (s - a)


def two_product(a: Operand, b: Operand) -> Pairs:
    """Return fl(a b) and its exact error, barring overflow and underflow [Dekker–Veltkamp].

    XLA may contract ``ah*bh - a*b`` into one fused step, which returns zero for the error, and its optimization
    barriers do not always survive to forbid it. For JAX the product is therefore summed from the four products of
    halves, each of which is exact, so that contraction changes nothing.
    """
    ah, al = split_halves(a)
    bh, bl = split_halves(b)
    if is_jax(a, b):
        return _sum_of_partial_products(ah * bh, ah * bl, al * bh, al * bl)
    # e = ((ah bh − p) + ah bl + al bh) + al bl: every partial sum is exact in this order (Dekker 1971)
    p, e = a * b, ah * bh
    e -= p
    e += ah * bl
    e += al * bh
    e += al * bl
    return p, e


def two_square(a: Operand) -> Pairs:
    """Return fl(a²) and its exact error."""
    # (h + l)² = h² + 2hl + l²
    h, l = split_halves(a)  # noqa: E741
    hl = h * l
    if is_jax(a):
        return _sum_of_partial_products(h * h, hl, hl, l * l)
    p, e = a * a, h * h
    e -= p
    e += hl + hl
    e += l * l
    return p, e


def _sum_of_partial_products(most: Array, middle: Array, other: Array, least: Array) -> DoubleDouble:
    middle, below = two_sum(middle, other)
    p, e = fast_two_sum(most, middle)
    e, rest = two_sum(e, least)
    p, e = fast_two_sum(p, e)
    return p, e + (rest + below)


def from_float(a: Operand) -> Pairs:
    """Return the float64 array as a pair."""
    return a, 0.0 * a


def one_like(a: Operand) -> Pairs:
    """Return 1 in the shape of a finite array.

    XLA folds sums with two literal constants, (1 + b) − 1 → b, which would undo ``two_sum``; this one is not a literal.
    """
    return 1.0 + 0.0 * a, 0.0 * a


def add(x: Pair, y: Pair) -> Pairs:
    """Return x + y."""
    s, e = two_sum(x[0], y[0])
    e += x[1] + y[1]
    return fast_two_sum(s, e)


def subtract(x: Pair, y: Pair) -> Pairs:
    """Return x − y."""
    return add(x, negate(y))


def negate(x: Pair) -> Pairs:
    """Return −x."""
    return -x[0], -x[1]


def multiply(x: Pair, y: Pair) -> Pairs:
    """Return x y."""
    # (x + x′)(y + y′) = xy + (xy′ + x′y); x′y′ is below 2^−106 of the product
    p, e = two_product(x[0], y[0])
    cross = x[0] * y[1]
    cross += x[1] * y[0]
    e += cross
    return fast_two_sum(p, e)


def multiply_float(x: Pair, factor: Operand) -> Pairs:
    """Return x times a float64 factor."""
    p, e = two_product(x[0], factor)
    e += x[1] * factor
    return fast_two_sum(p, e)


def square(x: Pair) -> Pairs:
    """Return x²."""
    p, e = two_square(x[0])
    e += 2.0 * x[0] * x[1]
    return fast_two_sum(p, e)


def scale(x: Pair, power_of_two: Operand) -> Pairs:
    """Return x times an exact power of two (or 0, ±1)."""
    return x[0] * power_of_two, x[1] * power_of_two


def divide(x: Pair, y: Pair) -> Pairs:
    """Return x / y."""
    # one step of long division: x/y = q + (x − qy)/y with the remainder x − qy formed exactly
    q = x[0] / y[0]
    p, e = two_product(q, y[0])
    r = x[0] - p
    r -= e
    r += x[1] - q * y[1]
    r /= y[0]
    return fast_two_sum(q, r)


def sqrt(x: Pair) -> Pairs:
    """Return √x; zero for x = 0."""
    xp = namespace(*x)
    # one Newton step from the rounded root: √x = s + (x − s²)/2s, less (x − s²)²/8s³, which is about 2^−107 of s
    s = xp.sqrt(x[0])
    p, e = two_square(s)
    r = ((x[0] - p) - e) + x[1]
    return fast_two_sum(s, r / xp.where(s > 0, s + s, 1.0))


def where(condition: Bool[Array, "*#shape"], x: Pair, y: Pair) -> Pairs:
    """Return x where the condition holds, else y."""
    xp = namespace(condition, *x, *y)
    return xp.where(condition, x[0], y[0]), xp.where(condition, x[1], y[1])


def multiply_terms(x: Sum, factor: Operand) -> Sum:
    """Return the exact product of a sum of floats and a float as a sum with twice as many terms [Shewchuk 1997]."""
    return tuple(part for term in x for part in two_product(term, factor))


def distil(x: Sum, passes: int = 5) -> Pairs:
    """Return the sum of the terms to double-double accuracy, even if they cancel to 2^(−53 passes) of their size.

    Source: Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26 (2005) 1955, Algorithm 4.8 (SumK).
    """
    # after the sweeps the last term holds the sum to double precision, and the others its error
    rest, *errors, last = _swept(x, passes)
    for error in errors:
        rest = rest + error
    return two_sum(last, rest)


def compress(x: Sum, count: int = 4) -> Sum:
    """Return the sum of the terms as one of ``count`` floats, largest last, correct to eps^count of its size.

    Exact zero stays exact zero. Each sweep moves the sum's leading part to the end, as in ``distil``.
    """
    return _swept(x, count + 1)[-count:] if len(x) > count else x


def _swept(x: Sum, times: int) -> Sum:
    return iterate(times, _sweep, tuple(x), like=next((term for term in x if is_jax(term)), x[0]))


def _sweep(x: tuple[Array, ...]) -> tuple[Array, ...]:
    # VecSum of Ogita, Rump & Oishi, Algorithm 4.3: the sum stays, and all but its rounded value moves to the errors
    out, running = [], x[0]
    for term in x[1:]:
        running, error = two_sum(running, term)
        out.append(error)
    return (*out, running)
