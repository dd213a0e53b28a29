"""Arithmetic of the kernels: double-double numbers, phases, and storage.

Kernels are functions of single numbers, written once. Python runs them as they are, for one body at few times, without
anything that has to be loaded; for many, ``_base.compiled`` has Numba compile them. Both give the same bits: the
arithmetic is that of ``special._doubledouble`` and ``special._circular``, exact where these are; nothing is contracted.
"""

from __future__ import annotations

import math
import struct
from array import array
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

# states, bodies or tops at a time: what is kept of them stays in the first two levels of cache. With a power of two the
# rows of a store, of which a loop reads fifty, would all fall into two of the cache's 64 sets
BLOCK = 264
ROUNDING = 6755399441055744.0  # 1.5 · 2⁵²: added and taken away again, it leaves the nearest whole number
SPLITTING = 134217729.0  # 2²⁷ + 1
SWEEPS = 5  # of an exact sum, after which its last term and the others have all its digits
SINE = [(-1) ** n * (2.0 * np.pi) ** (2 * n + 1) / float(np.prod(np.arange(1.0, 2 * n + 2))) for n in range(9)]
COSINE = [(-1) ** n * (2.0 * np.pi) ** (2 * n) / float(np.prod(np.arange(1.0, 2 * n + 1))) for n in range(10)]
# of the power series of sin 2πx and cos 2πx
S0, S1, S2, S3, S4, S5, S6, S7, S8 = SINE
C0, C1, C2, C3, C4, C5, C6, C7, C8, C9 = COSINE
if TYPE_CHECKING:  # in copies for arrays they are arrays
    from typing import Any as Number
    from typing import Any as Truth
else:
    Number, Truth = float, bool
Pair = tuple[Number, Number]
Sum = tuple[Number, ...]  # of floats, never added up: exact, with as many terms as it needs [Shewchuk 1997]
Rate = tuple[Number, Number, Number]  # in halves, and what they leave of it
Time = tuple[Number, Number, Number]  # likewise: the halves of a double, and what is left where t − epoch is none


# ---------------------------------------------------------------------- what ``compiled_arithmetic`` has in other forms


def two_product(a: float, b: float) -> Pair:
    """Return the product and its exact error, as long as that does not underflow [Dekker–Veltkamp]."""
    p, t, u = a * b, SPLITTING * a, SPLITTING * b
    ah, bh = t - (t - a), u - (u - b)
    al, bl = a - ah, b - bh
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


def bits_of(x: float) -> int:
    """Return the bits of a float as an integer."""
    return int.from_bytes(struct.pack("<d", x), "little")


def of_bits(n: int) -> float:
    """Return the float with these bits."""
    return float(struct.unpack("<d", n.to_bytes(8, "little"))[0])


def square_root(x: float) -> float:
    return math.sqrt(x) if x >= 0.0 else math.nan


def exponential(x: float) -> float:
    return math.exp(x)


def floor(x: float) -> float:
    return float(math.floor(x)) if math.isfinite(x) else x


def nearest(x: float) -> float:
    """Return the nearest whole number, the even one of two."""
    return float(round(x))


def where(condition: bool, x: float, y: float) -> float:
    return x if condition else y


def larger(x: float, y: float) -> float:
    return x if x > y else y


def smaller(x: float, y: float) -> float:
    return x if x < y else y


def negation(condition: bool) -> bool:
    return not condition


def binary_exponent(x: float) -> float:
    """Return e, a whole number, with ½ ≤ |x|/2^e < 1, and 0 for x = 0."""
    return float(math.frexp(x)[1])


def times_power(x: float, n: float) -> float:
    """Return 2ⁿ x, for a whole number n."""
    return math.ldexp(x, int(n))


def arctangent(x: float) -> float:
    return math.atan(x)


def angle_of(y: float, x: float) -> float:
    """Return the angle of the point (x, y), between −π and π."""
    return math.atan2(y, x)


def logarithm(x: float) -> float:
    return math.log(x)


def hyperbolic_sine(x: float) -> float:
    return math.sinh(x)


def area_of_sine(x: float) -> float:
    """Return the number whose hyperbolic sine is x."""
    return math.asinh(x)


# ---------------------------------------------------------------------- one of two ways, and again


def choose(condition: bool, when_true: Callable[[Any], Any], when_false: Callable[[Any], Any], values: Any) -> Any:
    """Return one of two functions of values; the other is not evaluated where that can be avoided."""
    return when_true(values) if condition else when_false(values)


def iterate(count: int, step: Callable[[Any], Any], state: Any) -> Any:
    """Apply a function so often."""
    for _ in range(count):
        state = step(state)
    return state


def iterate_until(
    step: Callable[[Any], Any], finished: Callable[[Any], bool], state: Any, at_once: int, most: int
) -> Any:
    """Apply a function so often, and then until the other holds, but not more than ``most`` times in all."""
    for k in range(most):
        if k >= at_once and finished(state):
            return state
        state = step(state)
    return state


def room(count: int) -> Any:
    """Return room for numbers, which are read where they were put alone; what is put into parts of it is in the whole.

    Compiled, it is not even cleared, which would take as long as the kernel of a short run.
    """
    return memoryview(array("d", [math.nan]) * count)


def cleared(count: int) -> Any:
    """Return room for numbers, which are zero."""
    return memoryview(array("d", bytes(8 * count)))


def places(count: int) -> Any:
    """Return room for whole numbers."""
    return [0] * count


def flags(count: int) -> Any:
    """Return room for yes and no."""
    return [False] * count


# ---------------------------------------------------------------------- whole numbers, circular functions, phases


def whole(x: float) -> float:
    return (x + ROUNDING) - ROUNDING


def sine_cosine(x: float) -> Pair:
    """Return sin 2πx and cos 2πx, |x| ≤ ½."""
    quarter = whole(4.0 * x)
    r = x - 0.25 * quarter
    z = r * r
    s = r * (S0 + z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * (S6 + z * (S7 + z * S8))))))))
    c = C0 + z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * (C6 + z * (C7 + z * (C8 + z * C9))))))))
    n = quarter - 4.0 * floor(0.25 * quarter)
    odd = n == 1.0 or n == 3.0
    a, b = (c, s) if odd else (s, c)
    return (-a if n >= 2.0 else a), (-b if n == 1.0 or n == 2.0 else b)


def halves(x: float) -> Pair:
    t = SPLITTING * x
    high = t - (t - x)
    return high, x - high


def phase(rate: Rate, time: Time) -> tuple[float, float, float]:
    """Return ``circular.reduced_phase``."""
    upper, lower, least = rate
    high, low, rest = time
    a, b, c = upper * high, upper * low, lower * high
    na, nb, nc = whole(a), whole(b), whole(c)
    d = (lower * low + least * (high + low)) + (upper + lower) * rest
    middle, middle_error = two_sum(b - nb, c - nc)
    fraction, error = two_sum(a - na, middle)
    more = whole(fraction)
    return fraction - more, error + (middle_error + d), na + (nb + nc) + more


# ---------------------------------------------------------------------- double-double numbers


def two_sum(a: float, b: float) -> Pair:
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def two_square(a: float) -> Pair:
    return two_product(a, a)


def fast_two_sum(a: float, b: float) -> Pair:
    s = a + b
    return s, b - (s - a)


def add(x: Pair, y: Pair) -> Pair:
    s, e = two_sum(x[0], y[0])
    return fast_two_sum(s, e + (x[1] + y[1]))


def subtract(x: Pair, y: Pair) -> Pair:
    return add(x, (-y[0], -y[1]))


def multiply(x: Pair, y: Pair) -> Pair:
    p, e = two_product(x[0], y[0])
    return fast_two_sum(p, e + (x[0] * y[1] + x[1] * y[0]))


def multiply_float(x: Pair, factor: float) -> Pair:
    p, e = two_product(x[0], factor)
    return fast_two_sum(p, e + x[1] * factor)


def square(x: Pair) -> Pair:
    p, e = two_product(x[0], x[0])
    return fast_two_sum(p, e + 2.0 * x[0] * x[1])


def scale(x: Pair, power_of_two: float) -> Pair:
    return x[0] * power_of_two, x[1] * power_of_two


def divide(x: Pair, y: Pair) -> Pair:
    q = x[0] / y[0]
    p, e = two_product(q, y[0])
    r = ((x[0] - p) - e) + (x[1] - q * y[1])
    return fast_two_sum(q, r / y[0])


def root(x: Pair) -> Pair:
    """Return √x of a positive number."""
    s = square_root(x[0])
    p, e = two_product(s, s)
    return fast_two_sum(s, (((x[0] - p) - e) + x[1]) / (s + s))


def constant(value: Pair, like: float) -> Pair:
    """Return a constant in the shape of a number, as which compilers of arrays do not reckon with it beforehand."""
    return value


def choice(condition: bool, x: Pair, y: Pair) -> Pair:
    return (x[0] if condition else y[0]), (x[1] if condition else y[1])


def root_or_zero(x: Pair) -> Pair:
    """Return √x, zero for x = 0."""
    zero = x[0] == 0.0
    return choice(zero, (0.0, 0.0), root(choice(zero, (1.0, 0.0), x)))


# ---------------------------------------------------------------------- exact sums


def as_sum(x: Pair) -> Sum:
    """Return a pair as a sum of two terms."""
    return x


def join(x: Sum, y: Sum) -> Sum:
    """Return x + y, with the terms of both."""
    return x + y


def negated(x: Sum) -> Sum:
    """Return −x."""
    return tuple(-term for term in x)


def multiply_terms(x: Sum, factor: float) -> Sum:
    """Return the exact product with a float, with twice as many terms."""
    return tuple(part for term in x for part in two_product(term, factor))


def compress(x: Sum, count: int) -> Sum:
    """Return ``doubledouble.compress``: a sum of so many terms at most, correct to 2^(−53 count) of its size."""
    return _swept(x, count + 1)[-count:] if len(x) > count else x


def distil(x: Sum) -> Pair:
    """Return ``doubledouble.distil``: the sum to double-double accuracy, whatever cancels, up to 2^−265."""
    *errors, last = _swept(x, SWEEPS)
    rest = errors[0]
    for error in errors[1:]:
        rest += error
    return two_sum(last, rest)


def _swept(x: Sum, times: int) -> Sum:
    """Return terms of equal sum, of which the last ones have the leading parts [Ogita, Rump & Oishi 2005]."""
    terms = list(x)
    for _ in range(times):
        running = terms[0]
        for k in range(1, len(terms)):
            running, terms[k - 1] = two_sum(running, terms[k])
        terms[-1] = running
    return tuple(terms)


# ---------------------------------------------------------------------- stores


def record(rows: Any, i: int, count: int) -> Any:
    """Return the numbers that stand BLOCK apart, in rows of a store that follow.

    One array holds all rows, so that LLVM knows which are apart and turns loops over them into vector instructions.
    """
    return tuple(rows[i : i + count * BLOCK : BLOCK])


def put_record(rows: Any, i: int, values: tuple[Any, ...]) -> None:
    """Store the numbers of a record or a tuple, one below the other, and 1 or 0 for what holds or does not."""
    for x in _numbers(values):
        rows[i] = x
        i += BLOCK


def _numbers(part: Any) -> Iterator[float]:
    if not isinstance(part, tuple):
        yield float(part)
        return
    for inner in part:
        yield from _numbers(inner)


def pair(w: Any, k: int) -> Pair:
    """Return the double-double number whose two parts stand BLOCK apart, in two rows of a store that follow.

    One array holds all rows, so that LLVM knows which are apart and turns loops over them into vector instructions.
    """
    return w[k], w[k + BLOCK]


def put(w: Any, k: int, x: Pair) -> None:
    """Store a double-double number, as ``pair`` returns it."""
    w[k], w[k + BLOCK] = x
