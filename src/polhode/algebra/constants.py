"""Algebras given by structure constants or by a basis of matrices."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property, partial
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only, require_doubles
from polhode._base.rational.numbers import nearest_double, read_number
from polhode.algebra._fixed_array import FixedArray
from polhode.algebra._functions import Function
from polhode.algebra._own_casimirs import (
    PolynomialCasimirs,
    check_casimirs,
    check_names,
    evaluate_functions,
    find_casimirs,
    name_functions,
)
from polhode.algebra._rotations import check_rotations
from polhode.algebra.base import AbstractLieAlgebra, Operand, Vector
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Double, Float64, Real

Fractions = tuple[tuple[tuple[Fraction, ...], ...], ...]


class IdentityLimits(NamedTuple):
    """What decides that constants are those of a Lie algebra."""

    max_residual: float = 1e-12  # of an identity among constants, relative to their size


LIMITS = IdentityLimits()


class ConstantsAlgebra(AbstractLieAlgebra):
    """The algebra with [e_i, e_j] = Σ_k c_ijk e_k; elements (…, dim). Made by ``from_structure_constants``.

    Attributes:
        constants: c (dim, dim, dim).
        own_casimirs: Casimirs as functions of one point: those given; else polynomials up to degree 4, computed on the
            first access, where that takes a fraction of a second.
    """

    table: FixedArray = eqx.field(static=True)
    given: tuple[Function, ...] | None
    given_names: tuple[str, ...] | None = eqx.field(static=True)
    given_fractions: Fractions | None = eqx.field(static=True)
    given_rotations: tuple[int, ...] = eqx.field(static=True)

    def __init__(
        self, constants: Float64[Array, "dim dim dim"], casimirs: Iterable[Function] | None = None,
        fractions: Fractions | None = None, names: Iterable[str] | None = None, rotations: Sequence[int] = (),
    ) -> None:
        self.given_rotations = check_rotations(constants, rotations)
        self.table, self.given, self.given_fractions = FixedArray(constants), None, fractions
        if casimirs is not None:
            self.given = check_casimirs(ConstantsAlgebra(constants), casimirs)
        self.given_names = None if names is None else check_names(names, self.given)

    @property
    def constants(self) -> Float64[np.ndarray, "dim dim dim"]:
        return self.table.values

    @property
    def dim(self) -> int:
        return len(self.constants)

    @property
    def rotations(self) -> tuple[int, ...]:
        return self.given_rotations

    @property
    def fractions(self) -> Fractions | None:
        return self.given_fractions

    @cached_property
    def own_casimirs(self) -> tuple[Function, ...]:
        return self._polynomials.casimirs if self.given is None else self.given

    @property
    def _polynomials(self) -> PolynomialCasimirs:
        return find_casimirs(ConstantsAlgebra(self.constants, None, self.fractions))

    @property
    def unwatched(self) -> str:
        return self._polynomials.unwatched if self.given is None else ""

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return name_functions(self.own_casimirs) if self.given_names is None else self.given_names

    def casimirs(self, mu: Vector) -> Float64[Array, "*batch k"]:
        mu = jnp.asarray(mu)
        values = partial(evaluate_functions, self.own_casimirs)
        for _ in self.batch_shape(mu):
            values = jax.vmap(values)
        return values(mu)

    def bracket(self, x: Operand, y: Operand) -> Vector:
        return jnp.einsum("...i,...j,ijk->...k", x, y, self.constants)

    def coadjoint(self, x: Operand, mu: Operand) -> Vector:
        # ⟨ad*_x μ, e_j⟩ = ⟨μ, [x, e_j]⟩ = x_i c_ijk μ_k
        return jnp.einsum("...i,...k,ijk->...j", x, mu, self.constants)

    def structure_constants(self) -> np.ndarray:
        return self.constants


class MatrixBasisAlgebra(ConstantsAlgebra):
    """The algebra spanned by matrices (dim, n, n); elements are coordinates (…, dim), group elements matrices."""

    basis: FixedArray = eqx.field(static=True)
    readings: FixedArray = eqx.field(static=True)

    def __init__(
        self,
        constants: Float64[Array, "dim dim dim"],
        matrices: Double[np.ndarray, "dim n n"],
        casimirs: Iterable[Function] | None = None,
        names: Iterable[str] | None = None,
        rotations: Sequence[int] = (),
    ) -> None:
        super().__init__(constants, casimirs, names=names, rotations=rotations)
        self.basis = FixedArray(matrices)
        # over the reals: over the complex numbers B and iB are not independent
        self.readings = FixedArray(np.linalg.pinv(_real_rows(matrices).T))

    @property
    def matrices(self) -> Double[Array, "dim n n"]:
        """The basis (dim, n, n)."""
        return self.basis.values

    def exp(self, x: Vector) -> Double[Array, "*batch n n"]:
        """Return exp Σ x_i B_i as a matrix."""
        return jax.scipy.linalg.expm(jnp.einsum("...i,iab->...ab", x, self.matrices))

    def coadjoint_action(self, g: Double[Array, "*#batch n n"], mu: Operand) -> Vector:
        # Ad_g B_j = g B_j g⁻¹, in coordinates by least squares: Σ_k Ad_kj B_k
        conjugated = g[..., None, :, :] @ self.matrices @ jnp.linalg.inv(g)[..., None, :, :]
        flat = conjugated.reshape(*conjugated.shape[:-2], -1)
        if np.iscomplexobj(self.matrices):
            flat = jnp.concatenate([flat.real, flat.imag], axis=-1)
        adjoint = jnp.einsum("ij,...kj->...ik", self.readings.values, flat)
        return jnp.einsum("...ik,...i->...k", adjoint, mu)


@known_numbers_only
def from_structure_constants(
    constants: Real[ArrayLike, "dim dim dim"], casimirs: Iterable[Function] | None = None,
    names: Iterable[str] | None = None, rotations: Sequence[int] = (),
) -> ConstantsAlgebra:
    """Return the algebra with [e_i, e_j] = Σ_k c[i,j,k] e_k, after checking that it is one.

    Its Casimirs are watched: they are in the ``drift`` of what ``simulate`` returns, and ``stability`` uses them. Where
    none are given, ``polynomial_casimirs`` computes them up to degree 4, as long as that takes a fraction of a second.
    Where it misses some, as without python-flint (the extra ``jax``), motions do not change, and their ``outcome``
    says what is not watched.

    Args:
        constants: (dim, dim, dim) real. Doubles are the numbers that they are; Fractions and texts like "1/3" are kept
            beside the doubles next to them, for exact algebra.
        casimirs: functions of one point (dim,) with jax.numpy, or polynomials of ``polynomial_casimirs``, where more
            are known than by default; an empty list for none.
        names: of these Casimirs, by which invariants and certificates call them; by default a short polynomial is its
            own name, and others are C1, C2, ….
        rotations: three components one behind the other, like (0, 1, 2), that are an so(3), [e_i, e_j] = ε_ijk e_k:
            states may then have an attitude in front, which turns with Ω = dH along these components.

    Raises:
        InvalidInput: if the shape is wrong, c is not antisymmetric in its first two indices, or Jacobi's identity
            fails; the offending indices are named. If a function is not a Casimir, names do not fit, or components are
            no so(3).

    >>> c = np.zeros((4, 4, 4))
    >>> c[0, 1, 2], c[1, 0, 2], c[0, 2, 3], c[2, 0, 3] = 1.0, -1.0, 1.0, -1.0
    >>> own = [lambda x: x[3], lambda x: 2 * x[1] * x[3] - x[2] ** 2]
    >>> from_structure_constants(c, casimirs=own).casimir_names
    ('C1', 'C2')
    >>> from_structure_constants(c, casimirs=own, names=["charge", "spread"]).casimir_names
    ('charge', 'spread')
    """
    fractions = _keep_fractions(constants)
    doubles = constants if fractions is None else _doubles(fractions)
    return ConstantsAlgebra(check_constants(doubles), casimirs, fractions, names, rotations)


def _doubles(fractions: Fractions) -> list[list[list[float]]]:
    return [[[nearest_double(x) for x in row] for row in rows] for rows in fractions]


def _keep_fractions(constants: Any) -> Fractions | None:
    """Return constants as fractions where some are given as such, or as texts."""
    given = np.asarray(constants)
    if given.dtype.kind not in "OUS" or given.ndim != 3:
        return None
    given = np.asarray(constants, dtype=object)
    return tuple(tuple(tuple(read_number(x, name="constants") for x in row) for row in rows) for rows in given)


def check_constants(constants: Real[ArrayLike, "dim dim dim"]) -> Float64[Array, "dim dim dim"]:
    """Return structure constants as a read-only array after the checks of ``from_structure_constants``."""
    require_doubles(constants=constants)
    try:
        c = np.array(constants, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput("`constants` must be real numbers, (dim, dim, dim).") from None
    if c.ndim != 3 or len(set(c.shape)) != 1 or not c.size:
        raise InvalidInput(f"`constants` must have shape (dim, dim, dim); got {c.shape}.")
    if not np.isfinite(c).all():
        raise InvalidInput("`constants` must be finite; got NaN or an infinity.")
    scale = np.abs(c).max()
    i, j, k = _worst(c + c.transpose(1, 0, 2))
    if abs(c[i, j, k] + c[j, i, k]) > LIMITS.max_residual * scale:
        raise InvalidInput(
            f"`constants` must be antisymmetric, c[i,j,k] = −c[j,i,k]; got c[{i},{j},{k}] = {c[i, j, k]:g} and "
            f"c[{j},{i},{k}] = {c[j, i, k]:g}."
        )
    _check_jacobi(c, scale)
    c.flags.writeable = False
    return c


def _check_jacobi(c: np.ndarray, scale: float) -> None:
    """Refuse constants against Jacobi's identity, by dim³ numbers at a time."""
    worst, where, largest = 0.0, (0, 0, 0, 0), scale**2
    for i in range(len(c)):
        nested = c @ c[i]  # [e_i, [e_j, e_k]] at (j, k)
        # [e_i, [e_j, e_k]] + [e_j, [e_k, e_i]] + [e_k, [e_i, e_j]]
        total = nested + c[:, i] @ c + (c[i] @ c).transpose(1, 0, 2)
        largest = max(largest, float(np.abs(nested).max()))
        j, k, m = _worst(total)
        if abs(total[j, k, m]) > abs(worst):
            worst, where = float(total[j, k, m]), (i, j, k, m)
    if abs(worst) > LIMITS.max_residual * largest:
        i, j, k, m = where
        raise InvalidInput(
            "`constants` must satisfy Jacobi's identity; [e_i,[e_j,e_k]] + cyclic has component "
            f"{worst:g} along e_{m} for (i, j, k) = ({i}, {j}, {k}), counted from 0. "
            "Check the constants with these indices."
        )


@known_numbers_only
def from_matrices(
    basis: Real[ArrayLike, "dim n n"], casimirs: Iterable[Function] | None = None, names: Iterable[str] | None = None,
    rotations: Sequence[int] = (),
) -> MatrixBasisAlgebra:
    """Return the algebra spanned over the reals by matrices, after checking that it closes under commutation.

    Args:
        basis: (dim, n, n), real or complex, linearly independent over the reals.
        casimirs: functions of coordinates (dim,) ⟨μ, B_i⟩, as for ``from_structure_constants``.
        names, rotations: as there.

    Raises:
        InvalidInput: if the matrices depend on each other, or a commutator leaves their span; its indices are named. If
            a function is not a Casimir, names do not fit, or components span no so(3).
    """
    require_doubles(basis=basis)
    try:
        matrices = np.array(basis)
        matrices = matrices.astype(complex if np.iscomplexobj(matrices) else float)
    except (TypeError, ValueError):
        raise InvalidInput("`basis` must be numbers, (dim, n, n).") from None
    if matrices.ndim != 3 or matrices.shape[1] != matrices.shape[2] or not matrices.size:
        raise InvalidInput(f"`basis` must have shape (dim, n, n); got {matrices.shape}.")
    if not np.isfinite(matrices).all():
        raise InvalidInput("`basis` must be finite; got NaN or an infinity.")
    columns = _real_rows(matrices).T
    if np.linalg.matrix_rank(columns) < len(matrices):
        raise InvalidInput(f"`basis` must be linearly independent over the reals; {len(matrices)} matrices are not.")
    commutators = matrices[:, None] @ matrices[None] - matrices[None] @ matrices[:, None]
    rows = _real_rows(commutators.reshape(-1, *matrices.shape[1:]))
    solution = np.linalg.lstsq(columns, rows.T, rcond=None)[0]
    left = np.abs(columns @ solution - rows.T).max(axis=0)
    worst = int(np.argmax(left))
    if left[worst] > 1e-10 * max(np.abs(rows).max(), np.abs(matrices).max() ** 2):
        i, j = divmod(worst, len(matrices))
        raise InvalidInput(
            f"`basis` must close under commutation; [B_{i}, B_{j}], counted from 0, leaves its span by "
            f"{left[worst]:.3g}. Add the missing matrices."
        )
    constants = solution.T.reshape(len(matrices), len(matrices), -1)
    near = np.rint(constants * 120.0) / 120.0  # what is a simple fraction is one exactly
    constants = np.where(np.abs(constants - near) < 1e-12 * np.abs(constants).max(initial=1.0), near, constants)
    antisymmetric = check_constants(0.5 * (constants - constants.transpose(1, 0, 2)))
    return MatrixBasisAlgebra(antisymmetric, matrices, casimirs, names, rotations)


def _real_rows(matrices: np.ndarray) -> np.ndarray:
    flat: Any = matrices.reshape(len(matrices), -1)
    return np.hstack([flat.real, flat.imag]) if np.iscomplexobj(flat) else flat


def _worst(array: np.ndarray) -> tuple[int, ...]:
    return tuple(int(k) for k in np.unravel_index(np.argmax(np.abs(array)), array.shape))

