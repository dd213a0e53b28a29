"""Attitudes from the columns of a table: quaternions of four or three components, matrices, MRPs and Euler angles.

Source: Markley and Crassidis, *Fundamentals of Spacecraft Attitude Determination and Control* (2014), sections 2.9.2
(rotation matrices), 2.9.5 (modified Rodrigues parameters).
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from polhode import rotation
from polhode.errors import FormatError
from polhode.formats.aem_attitudes import FAR_FROM_UNIT
from polhode.formats.column_mapping import ColumnMapping
from polhode.formats.header_words import IN_RADIANS
from polhode.formats.plain_table import PlainTable
from polhode.types import Array, Float64, Integer

Quaternions = Float64[Array, "rows 4"]


def make_attitude(
    path: Path, table: PlainTable, values: Float64[Array, "rows columns"], mapping: ColumnMapping, letters: str,
    angle_unit: str,
) -> tuple[Quaternions, float | None]:
    """Return the attitude (n, 4) as the file has it, and the largest deviation from a rotation, None for angles.

    Args:
        path: for messages.
        table: for the numbers of lines.
        values: the columns of the attitude.
        mapping: their meaning.
        letters: the order of a quaternion's columns, or of a matrix's entries.
        angle_unit: of Euler angles.

    Raises:
        FormatError: naming the line of values that are no rotation.
    """
    if mapping.sequence:
        return rotation.from_euler_angles(values * IN_RADIANS[angle_unit], mapping.sequence), None
    with np.errstate(over="ignore"):  # an infinite length is refused
        if mapping.mrp:
            return from_modified_rodrigues(values), None
        if mapping.matrix:
            return _from_matrices(path, table, values, letters)
        if mapping.quat and len(mapping.quat) == 3:
            return _from_vectors(path, table, values)
        return _from_quaternions(path, table, values, letters)


def from_modified_rodrigues(parameters: Float64[Array, "rows 3"]) -> Quaternions:
    """Return quaternions of modified Rodrigues parameters σ = e tan(φ/4); a switch to the shadow −σ/σ² changes none.

    >>> from_modified_rodrigues(np.array([[0.0, 0.0, np.tan(np.pi / 8)]])).round(12).tolist()
    [[0.707106781187, 0.0, 0.0, 0.707106781187]]
    """
    square = np.sum(parameters * parameters, axis=-1, keepdims=True)
    return np.concatenate([(1.0 - square), 2.0 * parameters], axis=-1) / (1.0 + square)


def restore_scalars(vectors: Float64[Array, "rows 3"]) -> Quaternions:
    """Return unit quaternions from their vector parts: the scalar follows from the length, its sign by continuity.

    The first scalar is taken as positive. Every further sign makes the attitude nearer to the one that a repetition of
    the last turn gives, so that a scalar that passes through zero changes sign, and a program that keeps all scalars
    positive, whose vector part jumps to its opposite there, is followed too.
    """
    sizes = np.sqrt(np.clip(1.0 - np.sum(vectors * vectors, axis=-1), 0.0, None))
    quaternions = np.concatenate([sizes[:, None], vectors], axis=-1)
    before = last = quaternions[0]
    for k in range(1, len(quaternions)):
        ahead = rotation.multiply(rotation.multiply(last, rotation.conjugate(before)), last)
        along = float(ahead[1:] @ quaternions[k, 1:])
        # the scalar has the sign that makes |q · ahead| larger
        if ahead[0] * along < 0.0:
            quaternions[k, 0] = -quaternions[k, 0]
        now = quaternions[k] if quaternions[k] @ last >= 0.0 else -quaternions[k]
        before, last = last, now
    return quaternions


def _from_quaternions(path: Path, table: PlainTable, values: Array, letters: str) -> tuple[Array, float]:
    attitude = values[:, [letters.index(letter) for letter in "wxyz"]]
    with np.errstate(over="ignore"):  # an infinite length is refused
        lengths = np.linalg.norm(attitude, axis=-1)
    off = np.abs(lengths - 1.0)
    if not off.max() <= FAR_FROM_UNIT:
        row = int(np.argmax(~(off <= FAR_FROM_UNIT)))
        raise FormatError(
            f"{path}, line {table.lines[row]}: a quaternion must have length 1 to {FAR_FROM_UNIT:g}; got "
            f"{lengths[row]:.6g} from {values[row].tolist()}. Check which columns it has, or normalise them."
        )
    return attitude / lengths[:, None], float(off.max())


def _from_vectors(path: Path, table: PlainTable, values: Array) -> tuple[Array, float]:
    with np.errstate(over="ignore"):  # an infinite length is refused
        lengths = np.linalg.norm(values, axis=-1)
    over = np.maximum(lengths - 1.0, 0.0)
    if not over.max() <= FAR_FROM_UNIT:
        row = int(np.argmax(~(over <= FAR_FROM_UNIT)))
        raise FormatError(
            f"{path}, line {table.lines[row]}: the vector part of a quaternion must be at most 1 long; got "
            f"{lengths[row]:.6g} from {values[row].tolist()}. Check which columns it has; modified Rodrigues "
            "parameters are given by `mrp`."
        )
    return restore_scalars(values / (1.0 + over)[:, None]), float(over.max())


def _from_matrices(path: Path, table: PlainTable, values: Array, letters: str) -> tuple[Array, float]:
    order = letters.split()
    rows = [order.index(f"{i}{j}") for i in "123" for j in "123"]
    return nearest_rotations(path, table.lines, values[:, rows].reshape(-1, 3, 3))


def nearest_rotations(
    path: Path, lines: Sequence[int] | Integer[Array, "n"], matrices: Float64[Array, "n 3 3"]
) -> tuple[Float64[Array, "n 4"], float]:
    """Return quaternions (n, 4) of the rotations nearest to matrices of a file, and the largest entry of RᵀR − 1.

    Raises:
        FormatError: naming the line of a matrix that is no rotation.
    """
    misfit = np.abs(np.swapaxes(matrices, 1, 2) @ matrices - np.eye(3)).max(axis=(1, 2))
    where = f"{path}, line"
    if not misfit.max() <= FAR_FROM_UNIT:
        row = int(np.argmax(~(misfit <= FAR_FROM_UNIT)))
        raise FormatError(
            f"{where} {lines[row]}: a rotation matrix must be orthogonal, RᵀR = 1 to {FAR_FROM_UNIT:g}; it "
            f"misses by {misfit[row]:.3g}. Check which columns it has."
        )
    mirrored = np.linalg.det(matrices) < 0.0
    if mirrored.any():
        row = int(np.argmax(mirrored))
        raise FormatError(f"{where} {lines[row]}: the matrix is a reflection, det R = −1, and no rotation. Flip "
                          "the sign of one axis in the file.")
    left, _, right = np.linalg.svd(matrices)
    return rotation.from_matrix(left @ right), float(misfit.max())
