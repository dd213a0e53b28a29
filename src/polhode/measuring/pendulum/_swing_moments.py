"""From moments of single swings to axes and a tensor: weighted least squares with all errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode.estimation._estimate import Estimate
from polhode.types import Array, Float64

ENTRIES = ("Jxx", "Jyy", "Jzz", "Jxy", "Jxz", "Jyz")


class MomentThresholds(NamedTuple):
    """Numbers that decide which axes are one, and whether axes determine a tensor.

    Attributes:
        axis_tolerance: sine of the angle between axes, below which they are one.
        min_singular_value: least of six directions; with a smaller one they do not determine a tensor.
        relative_rounding: of a moment, by its own computation.
    """

    axis_tolerance: float = 1e-9
    min_singular_value: float = 1e-6
    relative_rounding: float = 1e-15


LIMITS = MomentThresholds()


def unit_vector(axis: Sequence[float]) -> Float64[Array, "3"]:
    """Return an axis with length one.

    Raises:
        InvalidInput: for what is not three finite numbers, not all zero.
    """
    vector = check.array("axis", axis, (3,), not_all_zero=True, remedy="Write it like [0, 0, 1].")
    vector = vector / np.abs(vector).max()
    return vector / np.linalg.norm(vector)


def list_measured(thing: Any, quantity: type) -> list[Any]:
    """Return the measured quantities anywhere in nested tuples."""
    if isinstance(thing, quantity):
        return [thing]
    return [one for part in thing for one in list_measured(part, quantity)] if isinstance(thing, tuple) else []


def propagate(swings: Sequence[Any], mass: Any, gravity: Any, moment: Callable[..., float]) -> Estimate:
    """Return the moments of swings with their covariance by the errors of all measured quantities.

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
        usual, least = 1e-6, 1e-9  # relative; the difference over smaller steps is rounding
        step = min(usual * abs(one.value) or usual, max(one.error, least * abs(one.value)))
        low = max(-step, -0.5 * one.value) if one.value else 0.0  # an offset of zero goes up only
        columns.append((moments(one, step) - moments(one, low)) / (step - low) * one.error)
    parts = np.stack(columns, axis=1)  # of each source in each moment
    total, weak = np.sum(parts**2, axis=1) ** 2, np.zeros(len(swings))
    for one, part in zip(uncertain, parts.T, strict=True):
        if one.freedom is not None:
            weak += part**4 / one.freedom
    freedom = float(np.min(total[weak > 0] / weak[weak > 0])) if (weak > 0).any() else None
    value = moments()
    covariance = parts @ parts.T + np.diag((LIMITS.relative_rounding * value) ** 2)
    return Estimate(tuple(f"swing {k + 1}" for k in range(len(swings))), value, covariance, freedom)


def combine_moments(
    moments: Estimate, axes: Float64[Array, "n 3"]
) -> tuple[Float64[Array, "k 3"], Estimate, float, int]:
    """Return the different axes (k, 3), the moment about each, the misfit χ² and its degrees of freedom."""
    different: list[Array] = []
    of = np.zeros(len(axes), dtype=int)
    for n, axis in enumerate(axes):
        sines = [np.linalg.norm(np.cross(axis, other)) for other in different]
        equal = [k for k, sine in enumerate(sines) if sine < LIMITS.axis_tolerance]
        of[n] = equal[0] if equal else len(different)
        different += [] if equal else [axis]
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
    if len(axes) < 6 or np.linalg.svd(design, compute_uv=False)[5] < LIMITS.min_singular_value:
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


def whiten(covariance: Float64[Array, "n n"], values: Float64[Array, "n ..."]) -> Float64[Array, "n ..."]:
    """Return numbers of this covariance, or linear parts of them, as independent ones with unit variance."""
    scale = math.sqrt(float(np.trace(covariance)) / len(covariance))
    root = np.linalg.cholesky(covariance / scale**2 + 1e-14 * np.eye(len(covariance))) * scale
    return np.linalg.solve(root, values)


def _least_squares(design: Array, value: Array, covariance: Array) -> tuple[Array, Array, float]:
    """Return the solution of least χ², its covariance and χ²."""
    solve = partial(whiten, covariance)
    A, b = solve(design), solve(value)
    solution, *_ = np.linalg.lstsq(A, b, rcond=None)
    return solution, np.linalg.inv(A.T @ A), float(np.sum((A @ solution - b) ** 2))


def _directions(axes: Array) -> Array:
    """Return the rows by which n·Jn (k,) follow from the six entries."""
    x, y, z = axes.T
    return np.stack([x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z], axis=1)
