"""The corrections of the discrete Moser–Veselov algorithm, derived again in rational arithmetic.

For random rational bodies the quaternion of one step is expanded in h, for the exact motion and for the algorithm with
the corrections found so far. The first difference is −½ hⁿ (s/I_j + d) L_j; three components give s, d and one check.
Their dependence on H, C and the symmetric polynomials of 1/I is then found from enough bodies.
"""

import random
from fractions import Fraction

from flint import fmpq, fmpq_mat

TERMS = 12
Series = list[Fraction]


def times(a: Series, b: Series) -> Series:
    product = [Fraction(0)] * TERMS
    for i, x in enumerate(a):
        if x:
            for j in range(TERMS - i):
                product[i + j] += x * b[j]
    return product


def plus(*series: Series) -> Series:
    return [sum(column, Fraction(0)) for column in zip(*series, strict=True)]


def scaled(factor: Fraction | int, a: Series) -> Series:
    return [factor * x for x in a]


def one_over(a: Series) -> Series:
    inverse = [1 / a[0]] + [Fraction(0)] * (TERMS - 1)
    for n in range(1, TERMS):
        inverse[n] = -sum(a[k] * inverse[n - k] for k in range(1, n + 1)) / a[0]
    return inverse


def root_near_one(a: Series) -> Series:
    root = [Fraction(1)] + [Fraction(0)] * (TERMS - 1)
    for n in range(1, TERMS):
        root[n] = (a[n] - sum(root[k] * root[n - k] for k in range(1, n))) / 2
    return root


def exact_step(inverse_moments: list[Fraction], momentum: list[Fraction]) -> list[Series]:
    """Vector part of the quaternion of L' = L × Ω, q' = q Ω/2 from the identity."""
    L = [[x] + [Fraction(0)] * (TERMS - 1) for x in momentum]
    q = [[Fraction(k == 0)] + [Fraction(0)] * (TERMS - 1) for k in range(4)]
    for n in range(TERMS - 1):
        spin = [scaled(a, row) for a, row in zip(inverse_moments, L, strict=True)]

        def term(x: Series, y: Series, n: int = n) -> Fraction:
            return sum(x[k] * y[n - k] for k in range(n + 1))

        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            L[i][n + 1] = (term(L[j], spin[k]) - term(L[k], spin[j])) / (n + 1)
        (w, x, y, z), (a, b, c) = q, spin
        rates = (
            -term(x, a) - term(y, b) - term(z, c), term(w, a) + term(y, c) - term(z, b),
            term(w, b) + term(z, a) - term(x, c), term(w, c) + term(x, b) - term(y, a),
        )  # fmt: skip
        for m in range(4):
            q[m][n + 1] = rates[m] / 2 / (n + 1)
    return q[1:]


def algorithm_step(inverse_moments: list[Series], momentum: list[Fraction]) -> list[Series]:
    """v with h L_i = 2 w v_i I_i + 2 v_j v_k (I_k − I_j), w² + |v|² = 1."""
    moments = [one_over(a) for a in inverse_moments]
    h = [Fraction(0), Fraction(1)] + [Fraction(0)] * (TERMS - 2)
    v = [[Fraction(0)] * TERMS for _ in range(3)]
    one = [Fraction(1)] + [Fraction(0)] * (TERMS - 1)
    for _ in range(TERMS):
        w = root_near_one(plus(one, scaled(-1, plus(*(times(x, x) for x in v)))))
        better = []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            gap = plus(moments[k], scaled(-1, moments[j]))
            rest = plus(scaled(momentum[i], h), scaled(-2, times(times(v[j], v[k]), gap)))
            better.append(scaled(Fraction(1, 2), times(times(rest, one_over(w)), inverse_moments[i])))
        v = better
    return v


def monomials(order: int, more: int) -> list[tuple[int, ...]]:
    """(p, q, i, j, k) of H^p C^q e1^i e2^j e3^k with p + q = order and the degree that dimensions ask for."""
    rows = []
    for q in range(order + 1):
        degree = order + q + more
        rows += [
            (order - q, q, degree - 2 * j - 3 * k, j, k)
            for k in range(degree // 3 + 1)
            for j in range((degree - 3 * k) // 2 + 1)
        ]
    return rows


def value(row: tuple[int, ...], a: list[Fraction], y: list[Fraction]) -> Fraction:
    H = sum(x * b * b for x, b in zip(a, y, strict=True)) / 2
    C = sum(b * b for b in y) / 2
    symmetric = (sum(a), a[0] * a[1] + a[1] * a[2] + a[2] * a[0], a[0] * a[1] * a[2])
    product = H ** row[0] * C ** row[1]
    for base, power in zip(symmetric, row[2:], strict=True):
        product *= base**power
    return product


def derived(most: int) -> tuple[list[dict], list[dict]]:
    """Return s_1 … s_most and d_1 … d_most as {monomial: coefficient}."""
    rng = random.Random(1)
    s_found, d_found = [], []
    for order in range(1, most + 1):
        rows_s, rows_d = monomials(order, 0), monomials(order, 1)
        samples = []
        while len(samples) < len(rows_d) + 4:
            a = [Fraction(rng.randint(1, 9), rng.randint(1, 5)) for _ in range(3)]
            y = [Fraction(rng.randint(1, 7) * rng.choice((-1, 1)), rng.randint(1, 3)) for _ in range(3)]
            if len(set(a)) == 3:
                samples.append((a, y, *first_difference(a, y, s_found, d_found)))
        s_found.append(fitted(rows_s, [(a, y, s) for a, y, s, _ in samples]))
        d_found.append(fitted(rows_d, [(a, y, d) for a, y, _, d in samples]))
    return s_found, d_found


def first_difference(a: list[Fraction], y: list[Fraction], s_found: list[dict], d_found: list[dict]) -> tuple:
    corrected = []
    for x in a:
        series = [x] + [Fraction(0)] * (TERMS - 1)
        for k, (s, d) in enumerate(zip(s_found, d_found, strict=True), start=1):
            series[2 * k] = sum(c * value(row, a, y) for row, c in d.items()) + x * sum(
                c * value(row, a, y) for row, c in s.items()
            )
        corrected.append(series)
    exact, stepped = exact_step(a, y), algorithm_step(corrected, y)
    n = 2 * len(s_found) + 3
    assert all(exact[i][k] == stepped[i][k] for i in range(3) for k in range(n))
    rates = [2 * (exact[i][n] - stepped[i][n]) / y[i] for i in range(3)]
    s = (rates[0] - rates[1]) / (a[0] - a[1])
    d = rates[0] - s * a[0]
    assert rates[2] == s * a[2] + d
    return s, d


def fitted(rows: list[tuple[int, ...]], samples: list[tuple]) -> dict:
    matrix = fmpq_mat(len(samples), len(rows) + 1)
    for i, (a, y, wanted) in enumerate(samples):
        for j, number in enumerate([*(value(row, a, y) for row in rows), wanted]):
            matrix[i, j] = fmpq(number.numerator, number.denominator)
    echelon, rank = matrix.rref()
    assert rank == len(rows)  # one more, and no polynomial fits
    last = len(rows)
    found = {row: Fraction(int(echelon[j, last].p), int(echelon[j, last].q)) for j, row in enumerate(rows)}
    return {row: c for row, c in found.items() if c}
