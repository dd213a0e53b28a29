"""What python-flint's polynomials over the rationals lack: a context, parts, rates, shifts, derivatives at a point.

Their context orders terms by degree, the highest first, and within one by exponents.
"""

from __future__ import annotations

import copyreg
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache

from flint import Ordering, fmpq, fmpq_mat, fmpq_mpoly, fmpq_mpoly_ctx

from polhode._base.rational._sparse import dense, rows_of
from polhode._base.rational._terms import Exponents
from polhode._base.rational.numbers import as_fmpq

Field = Sequence[fmpq_mpoly]
Tensor = Sequence[Field]


@cache
def context(size: int) -> fmpq_mpoly_ctx:
    """Return where polynomials in x_1, …, x_n live."""
    return fmpq_mpoly_ctx.get([f"x{k + 1}" for k in range(size)], Ordering.deglex)


def variables(size: int) -> tuple[fmpq_mpoly, ...]:
    """Return x_1, …, x_n."""
    return context(size).gens()


def total(size: int, parts: Iterable[fmpq_mpoly]) -> fmpq_mpoly:
    """Return the sum of polynomials in ``size`` variables, of which there may be none."""
    return sum(parts, context(size).constant(0))


def terms_of(p: fmpq_mpoly) -> list[tuple[Exponents, fmpq]]:
    """Return exponents, as whole numbers of Python, and coefficients, highest degree first."""
    return [(tuple(map(int, m)), c) for m, c in p.terms()]


def part(p: fmpq_mpoly, lowest: int, highest: int | None = None) -> fmpq_mpoly:
    """Return the terms of degrees from lowest to highest, or of all degrees above."""
    return p.context().from_dict({m: c for m, c in p.terms()
                                  if lowest <= sum(m) and (highest is None or sum(m) <= highest)})  # fmt: skip


def magnitude(p: fmpq_mpoly) -> fmpq:
    """Return the sum of the sizes of all coefficients."""
    return sum(map(abs, p.coeffs()), fmpq(0))


def rate(p: fmpq_mpoly, field: Field) -> fmpq_mpoly:
    """Return the rate of change along a field, Σ f_k ∂p/∂x_k."""
    return total(len(field), (f * slope for k, f in enumerate(field) if f and (slope := p.derivative(k))))


def shift(p: fmpq_mpoly, point: Sequence[fmpq]) -> fmpq_mpoly:
    """Return the polynomial of v whose value is that of p at point + v."""
    return p.compose(*(x + z for x, z in zip(variables(len(point)), point, strict=True)))


def gradient(p: fmpq_mpoly, point: Sequence[fmpq]) -> list[fmpq]:
    """Return ∂p/∂x_k (n,) at a point."""
    return [p.derivative(k)(*point) for k in range(len(point))]


def half_hessian(p: fmpq_mpoly, point: Sequence[fmpq]) -> fmpq_mat:
    """Return the symmetric matrix M (n, n) of the terms vᵀMv of second degree at point + v."""
    n = len(point)
    rows = [gradient(p.derivative(k), point) for k in range(n)]
    return fmpq_mat(n, n, [x / 2 for row in rows for x in row])


def linear_form(row: Sequence[fmpq]) -> fmpq_mpoly:
    """Return Σ row_k x_k."""
    return total(len(row), (c * x for c, x in zip(row, variables(len(row)), strict=True)))


def quadratic_form(matrix: Sequence[Sequence[fmpq]]) -> fmpq_mpoly:
    """Return xᵀMx."""
    x = variables(len(matrix))
    return total(len(matrix), (x[i] * linear_form(row) for i, row in enumerate(matrix)))


def coefficients_of(polynomials: Sequence[fmpq_mpoly]) -> fmpq_mat:
    """Return the matrix whose columns are the coefficients of polynomials, by any monomial that one of them has."""
    return dense(rows_of(polynomials), range(len(polynomials)))


def poisson_tensor(constants: Sequence[Sequence[Mapping[int, Fraction]]], sign: int) -> Tensor:
    """Return {x_i, x_j} = sign · Σ_k c_ijk x_k (n, n) of structure constants [e_i, e_j] as {k: c_ijk}."""
    x = variables(len(constants))
    return [[total(len(x), (as_fmpq(sign * c) * x[k] for k, c in vector.items())) for vector in row]
            for row in constants]


def poisson_field(tensor: Tensor, function: fmpq_mpoly) -> tuple[fmpq_mpoly, ...]:
    """Return {x_i, F} (n,)."""
    return tuple(rate(function, row) for row in tensor)


def _rebuild(size: int, terms: dict[Exponents, fmpq]) -> fmpq_mpoly:
    return context(size).from_dict(terms)


copyreg.pickle(fmpq_mpoly, lambda p: (_rebuild, (p.context().nvars(), dict(terms_of(p)))))  # as flint does for numbers
