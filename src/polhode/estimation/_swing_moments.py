"""From moments of single swings to axes, a tensor and a centre of mass: weighted least squares with all errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.optimize import minimize_scalar
from scipy.stats import chi2

from polhode.errors import InvalidInput, shown
from polhode.estimation._estimate import Estimate
from polhode.types import Array, Float64

ENTRIES = ("Jxx", "Jyy", "Jzz", "Jxy", "Jxz", "Jyz")
SAME = 1e-9  # sine of an angle between axes below which they are one
RANK = 1e-6  # of singular values, below which six directions do not determine a tensor
STEP, LEAST_STEP = 1e-6, 1e-9  # relative, of central differences
ROUNDED = 1e-15  # of a moment, by which its own computation is off
PLAUSIBLE = 1e-3  # probability of a misfit, below which a place of the centre is excluded


def unit_vector(axis: Sequence[float]) -> Float64[Array, "3"]:
    """Return an axis with length one.

    Raises:
        InvalidInput: for what is not three finite numbers, not all zero.
    """
    vector = np.asarray(axis, dtype=float)
    if vector.shape != (3,) or not np.isfinite(vector).all() or not vector.any():
        raise InvalidInput(f"an axis must be three finite numbers, not all zero, like [0, 0, 1]; got {shown(axis)}.")
    vector = vector / np.abs(vector).max()
    return vector / np.linalg.norm(vector)


def list_measured(thing: Any, quantity: type) -> list[Any]:
    """Return the measured quantities anywhere in nested tuples."""
    if isinstance(thing, quantity):
        return [thing]
    return [one for part in thing for one in list_measured(part, quantity)] if isinstance(thing, tuple) else []


def propagate(swings: Sequence[Any], mass: Any, gravity: Any, moment: Callable[..., float]) -> Estimate:
    """Return the moments of swings with the covariance that the errors of all measured quantities give them.

    Their degrees of freedom are the smallest effective ones, by Welch and Satterthwaite: (Σu²)²/Σ(u⁴/ν).
    """
    sources = {id(one): one for swing in (*swings, (mass, gravity)) for one in list_measured(swing, type(mass))}
    uncertain = [one for one in sources.values() if one.error > 0.0]

    def moments(shift: Any = None, by: float = 0.0) -> Array:
        value = {} if shift is None else {id(shift): shift.value + by}
        at = value.get(id(mass), mass.value), value.get(id(gravity), gravity.value)
        return np.array([moment(swing, *at, value) for swing in swings])

    columns = []
    for one in uncertain:
        # over steps that are much smaller a difference is rounding
        step = min(STEP * abs(one.value) or STEP, max(one.error, LEAST_STEP * abs(one.value)))
        low = max(-step, -0.5 * one.value) if one.value else 0.0  # an offset of zero goes up only
        columns.append((moments(one, step) - moments(one, low)) / (step - low) * one.error)
    parts = np.stack(columns, axis=1)  # of each source in each moment
    total, weak = np.sum(parts**2, axis=1) ** 2, np.zeros(len(swings))
    for one, part in zip(uncertain, parts.T, strict=True):
        if one.freedom is not None:
            weak += part**4 / one.freedom
    freedom = float(np.min(total[weak > 0] / weak[weak > 0])) if (weak > 0).any() else None
    value = moments()
    covariance = parts @ parts.T + np.diag((ROUNDED * value) ** 2)
    return Estimate(tuple(f"swing {k + 1}" for k in range(len(swings))), value, covariance, freedom)


def combine_moments(
    moments: Estimate, axes: Float64[Array, "n 3"]
) -> tuple[Float64[Array, "k 3"], Estimate, float, int]:
    """Return the different axes (k, 3), the moment about each, the misfit χ² and how many moments it is left of."""
    different: list[Array] = []
    of = np.zeros(len(axes), dtype=int)
    for n, axis in enumerate(axes):
        same = [k for k, known in enumerate(different) if np.linalg.norm(np.cross(axis, known)) < SAME]
        of[n] = same[0] if same else len(different)
        different += [] if same else [axis]
    design = np.eye(len(different))[of]
    value, covariance, misfit = _least_squares(design, moments.value, moments.covariance)
    names = tuple(f"axis {k + 1}" for k in range(len(different)))
    combined = Estimate(names, value, covariance, moments.degrees_of_freedom)
    return np.stack(different), combined, misfit, len(axes) - len(different)


def fit_tensor(
    axes: Float64[Array, "n 3"], moments: Estimate
) -> tuple[Estimate, Estimate, Float64[Array, "3 3"], float, int] | None:
    """Return tensor, principal moments and axes, misfit and its freedom; None where the axes do not determine them.

    Each axis gives n·Jn. Errors of the principal moments are those of e·Je with fixed e, which is their first order.
    """
    design = _directions(axes)
    if len(axes) < 6 or np.linalg.svd(design, compute_uv=False)[5] < RANK:
        return None
    value, covariance, misfit = _least_squares(design, moments.value, moments.covariance)
    tensor = value[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]]
    principal, vectors = np.linalg.eigh(tensor)
    vectors[:, 2] *= np.linalg.det(vectors)
    along = _directions(vectors.T)
    freedom = moments.degrees_of_freedom
    return (
        Estimate(ENTRIES, value, covariance, freedom),
        Estimate(("I1", "I2", "I3"), principal, along @ covariance @ along.T, freedom),
        vectors, misfit, len(axes) - 6,
    )  # fmt: skip


def find_center(
    moments_at: Callable[[float], Estimate], axes: Array, places: Array, reach: Array
) -> tuple[Estimate, Estimate, Estimate, float]:
    """Return the place of the centre of mass on the pivots' scale, the moments there, the common one, and the misfit.

    A centre s gives the swings moments; the right one gives them all the same. Each moment is positive where the pivot
    is nearer than ``reach``, the length of the simple pendulum of its period, which bounds s.

    Raises:
        InvalidInput: for pivots of several axes or at one place, and where no or several places explain the periods.
    """
    if len(places) < 2 or np.ptp(places) == 0.0:
        raise InvalidInput("the place of the centre of mass follows from pivots at two places at least. Give a second "
                           "swing, or the distance.")  # fmt: skip
    if max(np.linalg.norm(np.cross(axes[0], axis)) for axis in axes) > SAME:
        raise InvalidInput("pivots on one scale must swing about the same axis; give distances for several axes.")
    design = np.ones((len(places), 1))

    def misfit(place: float) -> float:
        moments = moments_at(place)
        return _least_squares(design, moments.value, moments.covariance)[2]

    def settle(place: float) -> tuple[Estimate, Array, Array, float]:
        """Return the moments at a place, and by least squares the step to the best one with the common moment there."""
        step = 1e-5 * float(np.min(reach))
        moments = moments_at(place)
        slope = (moments_at(place + step).value - moments_at(place - step).value) / (2.0 * step)
        # moments less the common one, linear in the place and in that
        both = np.stack([-slope, np.ones(len(places))], axis=1)
        return moments, *_least_squares(both, moments.value, moments.covariance)

    low, high = float(np.max(places - reach)), float(np.min(places + reach))
    borders = [low, *sorted(p for p in set(places.tolist()) if low < p < high), high]
    found = []
    for left, right in pairwise(borders):
        inside = 1e-9 * (right - left)
        # χ² may have two minima between pivots, where the moments of two swings cross twice
        ends = np.linspace(left + inside, right - inside, 9)
        starts = [(ends[k], ends[k + 1]) for k in range(8)]
        for a, b in starts:
            sharp = {"xatol": 1e-12 * (right - left)}
            best: Any = minimize_scalar(misfit, bounds=(a, b), method="bounded", options=sharp)
            edge = 1e-6 * (b - a)
            # the search ends at half of the digits, where timings without noise still seem to disagree
            if a + edge < best.x < b - edge and chi2.sf(settle(best.x)[3], max(len(places) - 2, 1)) > PLAUSIBLE:
                found.append(float(best.x))
    found = [s for k, s in enumerate(found) if all(abs(s - t) > 1e-6 * (high - low) for t in found[:k])]
    if len(found) != 1:
        said = "no place" if not found else " or ".join(f"{s:.4g} m" for s in found)
        raise InvalidInput(f"the periods allow {said} of the centre of mass on the pivots' scale. Give the distance of "
                           "each pivot from the centre, or a further pivot.")  # fmt: skip
    s = found[0]
    moments, value, joint, misfit_left = settle(s)
    freedom = moments.degrees_of_freedom
    center = Estimate(("center",), np.array([s + value[0]]), joint[:1, :1], freedom)
    return center, moments, Estimate(("axis 1",), value[1:], joint[1:, 1:], freedom), misfit_left


def _least_squares(design: Array, value: Array, covariance: Array) -> tuple[Array, Array, float]:
    """Return the solution of least χ², its covariance and χ²."""
    scale = math.sqrt(float(np.trace(covariance)) / len(value))
    root = np.linalg.cholesky(covariance / scale**2 + 1e-14 * np.eye(len(value))) * scale
    A, b = np.linalg.solve(root, design), np.linalg.solve(root, value)
    solution, *_ = np.linalg.lstsq(A, b, rcond=None)
    return solution, np.linalg.inv(A.T @ A), float(np.sum((A @ solution - b) ** 2))


def _directions(axes: Array) -> Array:
    """Return the rows by which n·Jn (k,) follow from the six entries."""
    x, y, z = axes.T
    return np.stack([x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z], axis=1)
