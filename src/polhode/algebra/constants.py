"""Algebras given by structure constants or by a basis of matrices."""

from __future__ import annotations

from typing import Any

import jax.numpy as jnp
import numpy as np

from polhode.algebra.base import AbstractLieAlgebra, Operand, Vector
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Double, Float64, Real

TOLERANCE = 1e-12  # of identities among constants, relative to their size


class ConstantsAlgebra(AbstractLieAlgebra):
    """The algebra with [e_i, e_j] = Σ_k c_ijk e_k; elements (…, dim). Made by ``from_structure_constants``."""

    constants: np.ndarray

    @property
    def dim(self) -> int:
        return len(self.constants)

    def bracket(self, x: Operand, y: Operand) -> Vector:
        return jnp.einsum("...i,...j,ijk->...k", x, y, self.constants)

    def coadjoint(self, x: Operand, mu: Operand) -> Vector:
        return jnp.einsum("...i,...k,ijk->...j", x, mu, self.constants)

    def structure_constants(self) -> np.ndarray:
        return self.constants


class MatrixBasisAlgebra(ConstantsAlgebra):
    """The algebra spanned by matrices; elements are coordinates (…, dim), group elements matrices."""

    matrices: np.ndarray

    def exp(self, x: Vector) -> Double[Array, "*batch n n"]:
        """Return exp Σ x_i B_i as a matrix."""
        from jax.scipy.linalg import expm

        return expm(jnp.einsum("...i,iab->...ab", x, self.matrices))

    def coadjoint_action(self, g: Double[Array, "*#batch n n"], mu: Operand) -> Vector:
        inverse = np.linalg.pinv(self.matrices.reshape(self.dim, -1).T)
        turned = g[..., None, :, :] @ self.matrices @ jnp.linalg.inv(g)[..., None, :, :]
        adjoint = jnp.einsum("ij,...kj->...ik", inverse, turned.reshape(*turned.shape[:-2], -1))
        return jnp.einsum("...ik,...i->...k", adjoint.real, mu)


@known_numbers_only
def from_structure_constants(constants: Real[ArrayLike, "dim dim dim"]) -> ConstantsAlgebra:
    """Return the algebra with [e_i, e_j] = Σ_k c[i,j,k] e_k, after checking that it is one.

    Args:
        constants: (dim, dim, dim) real.

    Raises:
        InvalidInput: if the shape is wrong, c is not antisymmetric in its first two indices, or Jacobi's identity
            fails; the offending indices are named.

    >>> c = np.zeros((2, 2, 2))
    >>> c[0, 1, 1], c[1, 0, 1] = 1.0, -1.0
    >>> from_structure_constants(c).dim
    2
    """
    return ConstantsAlgebra(checked_constants(constants))


def checked_constants(constants: Real[ArrayLike, "dim dim dim"]) -> Float64[Array, "dim dim dim"]:
    """Return structure constants as a read-only array after the checks of ``from_structure_constants``."""
    refuse_single_precision(constants=constants)
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
    if abs(c[i, j, k] + c[j, i, k]) > TOLERANCE * scale:
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
        total = nested + c[:, i] @ c + (c[i] @ c).transpose(1, 0, 2)
        largest = max(largest, float(np.abs(nested).max()))
        j, k, m = _worst(total)
        if abs(total[j, k, m]) > abs(worst):
            worst, where = float(total[j, k, m]), (i, j, k, m)
    if abs(worst) > TOLERANCE * largest:
        i, j, k, m = where
        raise InvalidInput(
            "`constants` must satisfy Jacobi's identity; [e_i,[e_j,e_k]] + cyclic has component "
            f"{worst:g} along e_{m} for (i, j, k) = ({i}, {j}, {k}), counted from 0. "
            "Check the constants with these indices."
        )


@known_numbers_only
def from_matrices(basis: Real[ArrayLike, "dim n n"]) -> MatrixBasisAlgebra:
    """Return the algebra spanned over the reals by matrices, after checking that it closes under commutation.

    Args:
        basis: (dim, n, n), real or complex, linearly independent over the reals.

    Raises:
        InvalidInput: if the matrices depend on each other, or a commutator leaves their span; its indices are named.
    """
    refuse_single_precision(basis=basis)
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
    return MatrixBasisAlgebra(checked_constants(0.5 * (constants - constants.transpose(1, 0, 2))), matrices)


def _real_rows(matrices: np.ndarray) -> np.ndarray:
    flat: Any = matrices.reshape(len(matrices), -1)
    return np.hstack([flat.real, flat.imag]) if np.iscomplexobj(flat) else flat


def _worst(array: np.ndarray) -> tuple[int, ...]:
    return tuple(int(k) for k in np.unravel_index(np.argmax(np.abs(array)), array.shape))

