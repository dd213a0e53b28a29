"""Corrections of the moments that raise the order of the discrete Moser–Veselov algorithm.

With 1/I_j replaced by (1 + Σ_k h^2k s_k)/I_j + Σ_k h^2k d_k the algorithm is of order 2m + 2 when k runs to m. s_k and
d_k are polynomials in the energy H, C = |L|²/2 and the elementary symmetric polynomials e1, e2, e3 of the 1/I_j; a row
(p, q, i, j, k, numerator, denominator) stands for H^p C^q e1^i e2^j e3^k times the fraction. The idea and k = 1 are
Hairer & Vilmart's, J. Phys. A 39 (2006) 13225; all are derived in rational arithmetic by
``tests/oracle/moser_veselov.py``.
"""

from __future__ import annotations

from collections.abc import Sequence

from polhode.types import Array, Float64

Row = tuple[int, int, int, int, int, int, int]

TIME_SCALE: tuple[tuple[Row, ...], ...] = (
    (
        (1, 0, 1, 0, 0, -1, 3), (0, 1, 0, 1, 0, 1, 6),
    ),
    (
        (2, 0, 0, 1, 0, -1, 60), (2, 0, 2, 0, 0, 1, 30), (1, 1, 0, 0, 1, 2, 15), (1, 1, 1, 1, 0, -1, 30),
        (0, 2, 0, 2, 0, 1, 30), (0, 2, 1, 0, 1, -1, 10),
    ),
    (
        (3, 0, 0, 0, 1, 1, 35), (3, 0, 1, 1, 0, 1, 630), (3, 0, 3, 0, 0, -1, 630), (2, 1, 0, 2, 0, 41, 2520),
        (2, 1, 1, 0, 1, -53, 630), (2, 1, 2, 1, 0, 1, 420), (1, 2, 0, 1, 1, -1, 84), (1, 2, 1, 2, 0, -1, 70),
        (1, 2, 2, 0, 1, 11, 210), (0, 3, 0, 0, 2, 5, 126), (0, 3, 0, 3, 0, 17, 2520), (0, 3, 1, 1, 1, -11, 420),
    ),
    (
        (4, 0, 0, 2, 0, 17, 5040), (4, 0, 1, 0, 1, -3, 280), (4, 0, 2, 1, 0, -1, 15120), (4, 0, 4, 0, 0, 1, 22680),
        (3, 1, 0, 1, 1, -23, 1260), (3, 1, 1, 2, 0, -11, 1890), (3, 1, 2, 0, 1, 23, 945), (3, 1, 3, 1, 0, -1, 11340),
        (2, 2, 0, 0, 2, 53, 1260), (2, 2, 0, 3, 0, 1, 2520), (2, 2, 1, 1, 1, 1, 252), (2, 2, 2, 2, 0, 13, 3780),
        (2, 2, 3, 0, 1, -17, 1260), (1, 3, 0, 2, 1, 47, 7560), (1, 3, 1, 0, 2, -47, 945), (1, 3, 1, 3, 0, -11, 3240),
        (1, 3, 2, 1, 1, 17, 1260), (0, 4, 0, 1, 2, 97, 15120), (0, 4, 0, 4, 0, 31, 22680), (0, 4, 1, 2, 1, -19, 2520),
        (0, 4, 2, 0, 2, 1, 120),
    ),
)
SHIFT: tuple[tuple[Row, ...], ...] = (
    (
        (1, 0, 0, 1, 0, 1, 6), (0, 1, 0, 0, 1, -1, 3),
    ),
    (
        (2, 0, 0, 0, 1, -1, 10), (2, 0, 1, 1, 0, -1, 60), (1, 1, 0, 2, 0, -1, 60), (1, 1, 1, 0, 1, 2, 15),
        (0, 2, 0, 1, 1, -1, 60),
    ),
    (
        (3, 0, 0, 2, 0, -13, 1260), (3, 0, 1, 0, 1, 1, 42), (3, 0, 2, 1, 0, 1, 1260), (2, 1, 0, 1, 1, 11, 252),
        (2, 1, 1, 2, 0, 13, 2520), (2, 1, 2, 0, 1, -8, 315), (1, 2, 0, 0, 2, -22, 315), (1, 2, 0, 3, 0, 1, 1260),
        (1, 2, 1, 1, 1, -1, 1260), (0, 3, 0, 2, 1, -19, 2520), (0, 3, 1, 0, 2, 1, 35),
    ),
    (
        (4, 0, 0, 1, 1, 17, 1680), (4, 0, 1, 2, 0, -1, 7560), (4, 0, 2, 0, 1, -1, 360), (4, 0, 3, 1, 0, -1, 45360),
        (3, 1, 0, 0, 2, -1, 35), (3, 1, 0, 3, 0, 97, 22680), (3, 1, 1, 1, 1, -23, 1890), (3, 1, 2, 2, 0, -1, 1512),
        (3, 1, 3, 0, 1, 8, 2835), (2, 2, 0, 2, 1, -19, 1080), (2, 2, 1, 0, 2, 89, 1890), (2, 2, 1, 3, 0, -1, 1512),
        (2, 2, 2, 1, 1, 19, 7560), (1, 3, 0, 1, 2, 19, 1260), (1, 3, 0, 4, 0, -1, 45360), (1, 3, 1, 2, 1, 37, 7560),
        (1, 3, 2, 0, 2, -2, 105), (0, 4, 0, 0, 3, -61, 4536), (0, 4, 0, 3, 1, -61, 45360), (0, 4, 1, 1, 2, 3, 560),
    ),
)


def corrections(
    order: int,
    inverse: Sequence[Float64[Array, "*#batch"]],
    energy: Float64[Array, "*#batch"],
    casimir: Float64[Array, "*#batch"],
) -> tuple[Float64[Array, "*batch"], Float64[Array, "*batch"]]:
    """Return s and d with which (1 + s)/I_j + d in place of 1/I_j gives the algorithm an order, 4 to 10.

    Args:
        order: even.
        inverse: three 1/I_j, or products of them with one factor.
        energy: h² H, with the square of the factor.
        casimir: h² |L|²/2, with the square of the factor.
    """
    x, y, z = inverse
    symmetric = (x + y + z, x * y + y * z + z * x, x * y * z)
    found = []
    for table in (TIME_SCALE, SHIFT):
        # what depends on moments alone stands together, as copies of a batch share it
        coefficients: dict[tuple[int, int], Array] = {}
        for *powers, numerator, denominator in (row for rows in table[: order // 2 - 1] for row in rows):
            p, q, *rest = powers
            term = _monomial(symmetric, rest) * (numerator / denominator)
            coefficients[p, q] = coefficients[p, q] + term if (p, q) in coefficients else term
        terms = [_monomial((energy, casimir), powers) * value for powers, value in coefficients.items()]
        found.append(sum(terms[::-1]))
    return found[0], found[1]


def _monomial(values: Sequence[Array], powers: Sequence[int]) -> Array | float:
    product: Array | float = 1.0
    for value, power in zip(values, powers, strict=True):
        for _ in range(power):
            product = product * value
    return product
