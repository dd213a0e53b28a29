"""Polynomials in one variable over the rationals: common factors, real roots [Sturm], roots to the right [Routh].

A polynomial is a list of coefficients, highest power first, the first one not zero; the empty list is zero.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from polhode._base.rational._matrices import is_hurwitz, shift_origin

Coefficients = list[Fraction]


def trim(p: Sequence[Fraction]) -> Coefficients:
    """Return the coefficients without zeros in front."""
    start = next((k for k, c in enumerate(p) if c), len(p))
    return list(p[start:])


def divide(p: Sequence[Fraction], q: Sequence[Fraction]) -> tuple[Coefficients, Coefficients]:
    """Return quotient and remainder."""
    rest, quotient = list(p), []
    while len(rest) >= len(q):
        factor = rest[0] / q[0]
        quotient.append(factor)
        rest = [a - factor * b for a, b in zip(rest, [*q, *[Fraction(0)] * (len(rest) - len(q))], strict=True)][1:]
    return quotient, trim(rest)


def common_factor(p: Sequence[Fraction], q: Sequence[Fraction]) -> Coefficients:
    """Return the monic greatest common divisor."""
    p, q = trim(p), trim(q)
    while q:
        p, q = q, divide(p, q)[1]
        q = [c / q[0] for c in q] if q else q  # keeps fractions short
    return [c / p[0] for c in p]


def derivative(p: Sequence[Fraction]) -> Coefficients:
    """Return dp/dx."""
    degree = len(p) - 1
    return [c * (degree - k) for k, c in enumerate(p[:-1])]


def squarefree(p: Sequence[Fraction]) -> Coefficients:
    """Return the square-free polynomial with these roots."""
    p = trim(p)
    return divide(p, common_factor(p, derivative(p)))[0] if len(p) > 1 else p


def count_roots_up_to_zero(p: Sequence[Fraction]) -> int:
    """Return how many different real roots a polynomial has in (−∞, 0], by Sturm's theorem."""
    chain = [squarefree(p)]
    zero = int(not chain[0][-1])
    if zero:
        chain[0] = chain[0][:-1]
    if len(chain[0]) > 1:
        chain.append(derivative(chain[0]))
        while rest := divide(chain[-2], chain[-1])[1]:
            size = abs(rest[0])
            chain.append([-c / size for c in rest])
    far = [q[0] * (-1) ** (len(q) - 1) for q in chain]
    return zero + _changes(far) - _changes([q[-1] for q in chain])


def _changes(values: Sequence[Fraction]) -> int:
    signs = [v > 0 for v in values if v]
    return sum(a != b for a, b in pairwise(signs))


def has_root_to_the_right(p: Sequence[Fraction]) -> bool:
    """Whether a root has a positive real part.

    What p(λ) and p(−λ) share is λᵐ q(λ²), whose roots lie on the imaginary axis exactly where all those of q are real
    and not positive. The rest has no root on that axis, and Routh's array tells on which side of it all are.

    >>> [has_root_to_the_right([Fraction(c) for c in p]) for p in ((1, 0, 2, 0, 1), (1, -1))]
    [False, True]
    """
    p = trim(p)
    mirrored = [c * (-1) ** (len(p) - 1 - k) for k, c in enumerate(p)]
    shared = common_factor(p, mirrored)
    rest = divide(p, shared)[0]
    if not shared[-1]:
        shared = shared[: max(k for k, c in enumerate(shared) if c) + 1]
    in_squares = squarefree(shared[::2])
    return count_roots_up_to_zero(in_squares) < len(in_squares) - 1 or not is_hurwitz(rest)


def largest_real_part(p: Sequence[Fraction]) -> float:
    """Return the largest real part of the roots where that is positive, else zero, to a double's last digits."""
    bisections = 60  # of a root between two powers of two: below a rounding error of a double
    p = trim(p)
    if len(p) < 2 or not has_root_to_the_right(p):
        return 0.0
    # Lagrange and Fujiwara: every root is at most twice the largest of these
    sizes = [math.log2(float(abs(c / p[0]))) / k if 1e-300 < abs(c / p[0]) < 1e300 else _log2(abs(c / p[0])) / k
             for k, c in enumerate(p) if k and c]
    high = Fraction(2) ** (math.ceil(max(sizes)) + 1)
    while not has_root_to_the_right(shift_origin(p, high / 2)):
        high /= 2
    low = high / 2
    for _ in range(bisections):
        middle = (low + high) / 2
        low, high = (middle, high) if has_root_to_the_right(shift_origin(p, middle)) else (low, middle)
    return float(low)


def _log2(x: Fraction) -> float:
    return float(x.numerator.bit_length() - x.denominator.bit_length())
