"""Attitudes and vectors of a body from one set of its axes to another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.arrays import as_float64, is_traced, namespace
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real

PRINCIPAL, GIVEN = "principal", "given"


class AxesLimits(NamedTuple):
    """A number beyond which axes are refused."""

    max_error: float = 1e-9  # of columns from orthonormal


LIMITS = AxesLimits()


class Turn(NamedTuple):
    """From body axes to others that are the columns of ``matrix`` in these.

    Attributes:
        matrix: (…, 3, 3) a rotation, or one for each body.
        quaternion: (…, 4) of that rotation.
    """

    matrix: Float64[Array, "*turns 3 3"]
    quaternion: Float64[Array, "*turns 4"]

    @classmethod
    def to(cls, matrix: Float64[Array, "*turns 3 3"]) -> Turn:
        """Return the turn to axes that are the columns of a matrix."""
        return cls(matrix, rotation.from_matrix(matrix))

    @property
    def back(self) -> Turn:
        """The inverse turn, after which an attitude has its former sign."""
        return Turn(self.matrix.mT, rotation.conjugate(self.quaternion))

    def plain(self) -> PlainTurn:
        """Return this turn for single numbers."""
        rows = tuple(tuple(row) for row in np.asarray(self.matrix).tolist())
        return PlainTurn(tuple(np.asarray(self.quaternion).tolist()), rows)

    def then(self, other: Turn) -> Turn:
        """Return this turn and another after it."""
        return Turn(self.matrix @ other.matrix, rotation.multiply(self.quaternion, other.quaternion))

    def attitude(self, attitude: Float64[Array, "*batch 4"]) -> Float64[Array, "*batch 4"]:
        """Return attitudes (…, 4), body → space, of the other axes."""
        # other axes → body → space
        return rotation.multiply(attitude, self.quaternion)

    def vector(self, vector: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
        """Return the components (…, 3) of vectors along the other axes.

        The sums are written out: a matrix product would round one vector and many in different orders.
        """
        rows = namespace(vector, self.matrix).asarray(self.matrix)
        x, y, z = (vector[..., k : k + 1] * rows[..., k, :] for k in range(3))
        return x + y + z


class PlainTurn(NamedTuple):
    """A turn of single numbers, with the bits of that of arrays, without their overhead."""

    quaternion: tuple[float, ...]
    rows: tuple[tuple[float, ...], ...]

    def attitude(self, attitude: Sequence[float]) -> tuple[float, ...]:
        """Return an attitude, four numbers, of the other axes."""
        return rotation.product_of_parts(attitude, self.quaternion)

    def vector(self, vector: Sequence[float]) -> tuple[float, ...]:
        """Return the components of a vector along the other axes."""
        (x, y, z), (first, second, third) = vector, self.rows
        return tuple(x * a + y * b + z * c for a, b, c in zip(first, second, third, strict=True))


def chosen_axes(
    axes: str | Real[ArrayLike, "3 3"], given_axes: Float64[Array, "3 3"] | None
) -> Float64[Array, "3 3"] | None:
    """Return the principal axes by columns in the chosen ones; None for the principal ones themselves.

    Args:
        axes: "principal", "given", or axes by columns in the given ones.
        given_axes: the principal axes by columns in the given ones; None where the two coincide.

    Raises:
        InvalidInput: for anything else.
    """
    if isinstance(axes, str):
        if axes not in (PRINCIPAL, GIVEN):
            rule = '"principal", "given", or a rotation matrix (3, 3)'
            raise InvalidInput(f"`axes` must be {rule}; got {shown(axes)}.")
        return None if axes == PRINCIPAL else given_axes
    xp: Any = namespace(axes)
    matrix = as_float64(xp, axes, "axes")
    proper = matrix.shape == (3, 3) and (is_traced(matrix) or _is_rotation(np.asarray(matrix)))
    if not proper:
        raise InvalidInput(f"`axes` must have three orthonormal columns (3, 3), right-handed; got {shown(axes)}.")
    # columns of the principal axes: in the given ones G, in the chosen ones, which are the columns of M, Mᵀ G
    return matrix.T if given_axes is None else matrix.T @ xp.asarray(given_axes)


def shared_axes(axes: Float64[Array, "..."] | None) -> Float64[Array, "3 3"] | None:
    """Return the axes that all bodies of a batch have in common, of which JAX may have made a copy for each.

    Raises:
        InvalidInput: where they differ, or are traced.
    """
    if axes is None or axes.ndim == 2:
        return axes
    each = axes.reshape(-1, 3, 3)
    if is_traced(axes) or not bool((each == each[0]).all()):
        raise InvalidInput("samples are along one set of axes, and these bodies have one each. Take "
                           '`along("principal")`, or `state(times)`.')
    return each[0]


def _is_rotation(matrix: Array) -> bool:
    if not np.isfinite(matrix).all():
        return False
    return bool(np.abs(matrix.T @ matrix - np.eye(3)).max() < LIMITS.max_error) and float(np.linalg.det(matrix)) > 0.0
