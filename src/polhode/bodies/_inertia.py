"""Inertia of points and matrices: their sums, principal moments and axes, and which moments a rigid body can have."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import is_traced
from polhode._base.extras import needing
from polhode.bodies._digits import judge_moments
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real

ROUNDING = 64 * np.finfo(float).eps  # rounding of the sums in an inertia matrix, relative to its entries


class InertiaLimits(NamedTuple):
    """Numbers that decide whether moments are refused and which axis comes first."""

    max_inertial_defect: float = 1.0 / 3.0  # of I3: more than vibration does to any molecule that stays in one shape
    largest: float = 1e150  # SI; beyond it products of two overflow, and no body is near
    max_asymmetry: float = 1e-9  # of a tensor's largest entry: more was mistyped, not rounded
    # between direction cosines that count as equal, so that rounding never decides between two axes
    max_tie: float = 1e-9


LIMITS = InertiaLimits()


class MassProperties(NamedTuple):
    """Mass properties of a rigid body."""

    mass: float  # [kg]
    center_of_mass: Float64[Array, "3"]  # [m, given axes]
    inertia: Float64[Array, "3 3"]  # about the centre of mass [kg m²]


def point_inertia(offset: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 3 3"]:
    """Return |r|² 1 − r rᵀ (…, 3, 3), the inertia of a unit mass at r, its diagonal as sums of squares."""
    x, y, z = np.moveaxis(np.asarray(offset, dtype=float), -1, 0)
    rows = ((y * y + z * z, -x * y, -x * z), (-x * y, x * x + z * z, -y * z), (-x * z, -y * z, x * x + y * y))
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def inertia_of_second(second: Float64[Array, "3 3"]) -> Float64[Array, "3 3"]:
    """Return tr(S) 1 − S (3, 3) of S = ∫ r rᵀ, its diagonal as sums, not trace minus entry, which cancels."""
    xx, yy, zz = np.diag(second)
    return np.diag([yy + zz, zz + xx, xx + yy]) - (second - np.diag([xx, yy, zz]))


def nearest_physical(inertia: Float64[Array, "3 3"]) -> Float64[Array, "3 3"]:
    """Return the tensor (3, 3) nearest to a symmetric one, in Frobenius' norm, that a body can have.

    The norm does not depend on axes, so the nearest tensor keeps the axes, and its moments are I_i = s_j + s_k
    with second moments s ≥ 0 that bring them nearest: least squares without negative unknowns, of three.

    Source: Lawson & Hanson, *Solving Least Squares Problems* (1974), ch. 23; Lewis, Math. Oper. Res. 21 (1996) 576
    (projections onto sets of matrices that depend on eigenvalues alone).
    """
    with needing("Inertia tensors of rounded numbers need", alone=True):
        from scipy.optimize import nnls

    scale = float(np.abs(inertia).max())
    if not 0.0 < scale < LIMITS.largest:
        return inertia
    diagonal = np.diag(inertia)
    if np.array_equal(inertia, np.diag(diagonal)):
        moments, axes = diagonal, np.eye(3)
    else:
        moments, axes = np.linalg.eigh(inertia)
    seconds, _ = nnls(1.0 - np.eye(3), moments / scale)
    near = axes * (scale * (seconds.sum() - seconds)) @ axes.T
    return 0.5 * near + 0.5 * near.T


def take_rounded(
    inertia: Float64[Array, "3 3"], digits: int, given: Float64[Array, "3 3"] | None = None
) -> Float64[Array, "3 3"]:
    """Return the tensor itself if a body can have it, else the nearest one, where rounding explains the distance.

    The true tensor is one that a body has and, entry by entry, within half a unit of the last digit; the nearest one is
    no further away than it.

    Args:
        inertia: symmetric.
        digits: significant ones of the entries.
        given: the entries that were rounded, where the tensor was taken from another point; else its own.

    Raises:
        InvalidInput: where rounding to so many significant digits is not enough.
    """
    digits = check.whole("digits", digits, 1, 17)
    near = nearest_physical(inertia)
    moved = float(np.linalg.norm(near - inertia))
    if moved <= ROUNDING * float(np.abs(inertia).max()):
        return inertia
    if moved > rounding_of(inertia if given is None else given, digits):
        moments = ", ".join(f"{x:.9g}" for x in np.linalg.eigvalsh(inertia))
        enough = digits_that_explain(inertia, given)
        but = f", but to {enough} digits would" if enough else " nor to fewer from 3 on"
        raise InvalidInput(
            f"no rigid body has the principal moments ({moments}) kg m², which must satisfy I1 + I2 ≥ I3 ≥ 0; rounding "
            f"to {digits} digits does not explain it{but}. Check the numbers."
        )
    return near


def rounding_of(inertia: Float64[Array, "3 3"], digits: int) -> float:
    """Return the largest change of a matrix by rounding its entries to a number of digits, in Frobenius' norm."""
    size = np.abs(inertia)
    with np.errstate(divide="ignore"):
        unit = np.where(size > 0.0, 10.0 ** (np.floor(np.log10(size)) - digits + 1.0), 0.0)
    return float(np.linalg.norm(0.5 * unit)) * (1.0 + ROUNDING)


def digits_that_explain(inertia: Float64[Array, "3 3"], given: Float64[Array, "3 3"] | None = None) -> int | None:
    """Return the most significant digits, from 3 on, whose rounding explains that no body has this tensor, or None."""
    moved = float(np.linalg.norm(nearest_physical(inertia) - inertia))
    if not moved > 0.0:
        return None
    entries = inertia if given is None else given
    return next((digits for digits in range(12, 2, -1) if moved <= rounding_of(entries, digits)), None)


def check_moments(moments: Float64[Array, "3"], effective: bool = False) -> None:
    """Refuse moments (3,) ascending that no rigid body has, or effective ones that no molecule has.

    Raises:
        InvalidInput: if one is negative beyond rounding, all vanish, or I1 + I2 < I3 beyond rounding, of effective ones
            by more than a third of I3.
    """
    I1, I2, I3 = moments
    shown = ", ".join(f"{x:.10g}" for x in moments)  # enough digits to show the violation
    if not I3 > 0:
        raise InvalidInput(f"the principal moments must not all vanish; got ({shown}) kg m². A point has no attitude.")
    if I1 < -ROUNDING * I3:
        raise InvalidInput(
            f"the principal moments must not be negative; got ({shown}) kg m². "
            "Check signs and sizes of the products of inertia."
        )
    if I1 + I2 < I3 * (1.0 - (LIMITS.max_inertial_defect if effective else ROUNDING)):
        rule, bodies = ("I1 + I2 ≥ 2/3 I3", "molecule") if effective else ("I1 + I2 ≥ I3", "rigid body")
        raise InvalidInput(
            f"the principal moments must satisfy {rule}; got ({shown}) kg m². No {bodies} has these; "
            "check units and order."
        )


def principal_axes(inertia: Float64[Array, "3 3"]) -> tuple[Float64[np.ndarray, "3"], Float64[np.ndarray, "3 3"]]:
    """Return ascending moments (3,) and right-handed axes (3, 3), by columns, of a symmetric matrix."""
    diagonal = np.diag(inertia)
    if np.array_equal(inertia, np.diag(diagonal)):
        order = np.argsort(diagonal, kind="stable")
        moments, axes = diagonal[order], np.eye(3)[:, order]
        moments = np.where((moments < 0) & (moments > -ROUNDING * moments[2]), 0.0, moments)
    else:
        scale = 2.0 ** np.frexp(np.abs(inertia).max())[1]  # a power of two, so that scaling rounds nothing
        moments, axes = _jacobi(inertia / scale)
        # effect of relative rounding of the entries on each moment: v · |J| v with |v|
        unsure = ROUNDING * np.einsum("ik,ij,jk->k", np.abs(axes), np.abs(inertia / scale), np.abs(axes))
        moments, groups = judge_moments(moments, unsure)
        columns = [axis for group in groups for axis in _nearest_axes(axes[:, group])]
        moments, axes = moments * scale, np.column_stack(columns)
    leading = [_first_largest(np.abs(axes[:, k])) for k in range(3)]
    axes = axes * np.where(axes[leading, range(3)] < 0, -1.0, 1.0)
    if np.linalg.det(axes) < 0:
        axes[:, 2] = -axes[:, 2]
    return moments, axes + 0.0


def _jacobi(matrix: Array) -> tuple[Array, Array]:
    """Return ascending eigenvalues and eigenvectors of a symmetric (3, 3) matrix by Jacobi's rotations.

    Unlike LAPACK's reduction to tridiagonal form it keeps the relative accuracy of small eigenvalues of a positive
    matrix that is nearly diagonal after scaling.

    Source: Rutishauser, Numer. Math. 9 (1966) 1; Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204.
    """
    a, v = np.array(matrix), np.eye(3)
    for _ in range(40):  # converges quadratically, in 4 to 6 sweeps
        if not a[[0, 0, 1], [1, 2, 2]].any():
            break
        for p, q in ((0, 1), (0, 2), (1, 2)):
            small = np.finfo(float).eps / 4 * np.sqrt(abs(a[p, p])) * np.sqrt(abs(a[q, q]))
            if abs(a[p, q]) <= max(small, np.finfo(float).tiny):
                a[p, q] = a[q, p] = 0.0
                continue
            # tan of the angle: the smaller root of t² + 2ϑt − 1 = 0, ϑ = cot 2φ = (a_qq − a_pp)/2a_pq, by its stable
            # form
            theta = 0.5 * (a[q, q] - a[p, p]) / a[p, q]
            t = 1.0 / (theta + np.copysign(np.hypot(theta, 1.0), theta))
            c = 1.0 / np.hypot(t, 1.0)
            s, change, r = t * c, t * a[p, q], 3 - p - q
            # JᵀAJ: a_pp − t a_pq and a_qq + t a_pq, whose sum stays
            a[p, p], a[q, q], a[p, q], a[q, p] = a[p, p] - change, a[q, q] + change, 0.0, 0.0
            a[p, r], a[q, r] = c * a[p, r] - s * a[q, r], s * a[p, r] + c * a[q, r]
            a[r, p], a[r, q] = a[p, r], a[q, r]
            v[:, p], v[:, q] = c * v[:, p] - s * v[:, q], s * v[:, p] + c * v[:, q]
    order = np.argsort(np.diag(a), kind="stable")
    return np.diag(a)[order], v[:, order]


def _nearest_axes(space: Array) -> list[Array]:
    """Return an orthonormal basis of the column space: the given axes nearest to it, projected in turn."""
    if space.shape[1] == 1:
        return [space[:, 0]]
    projections = space @ space.T
    nearness = np.diag(projections).copy()
    chosen: list[int] = []
    for _ in range(space.shape[1]):
        chosen.append(_first_largest(nearness))
        nearness[chosen[-1]] = -1.0
    basis: list[Array] = []
    for k in sorted(chosen):
        vector = projections[:, k] - sum((b * (b @ projections[:, k]) for b in basis), np.zeros(3))
        basis.append(vector / np.linalg.norm(vector))
    return basis


def _first_largest(values: Array) -> int:
    return int(np.flatnonzero(values > values.max() - LIMITS.max_tie)[0])


def finite_array(name: str, value: Any, shape: tuple[int, ...]) -> Float64[np.ndarray, "..."]:
    """Return a float64 copy of the wanted shape, finite."""
    remedy = "Give moments to FreeMotion instead." if is_traced(value) else "Check where the value comes from."
    return np.array(check.array(name, value, shape, remedy=remedy))
