"""A first estimate of the inertia J: R J ω is constant in space, which is linear in J."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from polhode.types import Array, Float64, Integer

ROOT = np.sqrt(2.0)
OFF_DIAGONAL = ((0, 1), (0, 2), (1, 2))


class LinearInertia(NamedTuple):
    """The result of the linear method.

    Attributes:
        moments: (3,) ascending, the largest 1.
        axes: (3, 3) principal axes by columns [device frame], right-handed.
        singular_values: (6,) descending, of the centred map [rad/s times the root of the number of samples]; with a
            rotor (9,).
        rotor: (3,) momentum of a wheel over the largest moment [rad/s, device frame]; zero where none was asked for.
    """

    moments: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    singular_values: Float64[Array, "k"]
    rotor: Float64[Array, "3"]


def integrate_rates(times: Float64[Array, "n"], rates: Float64[Array, "n 3"]) -> Float64[Array, "n 4"]:
    """Integrate rates to attitude quaternions xyzw, from the unit one on.

    Each step is the Magnus expansion of rates that are linear in time between samples.
    """
    h = np.diff(times)[:, None]
    # ½h(ω0 + ω1) + h²/12 ω0 × ω1, the sign for rates in body axes, dR/dt = R hat(ω)
    step = 0.5 * h * (rates[:-1] + rates[1:]) + h * h / 12.0 * np.cross(rates[:-1], rates[1:])
    parts = np.concatenate([[[0.0, 0.0, 0.0, 1.0]], Rotation.from_rotvec(step).as_quat()])
    reach = 1
    while reach < len(parts):  # products of 2, 4, 8, … neighbours
        parts[reach:] = (Rotation.from_quat(parts[:-reach]) * Rotation.from_quat(parts[reach:])).as_quat()
        reach *= 2
    return parts


def momentum_map(attitudes: Float64[Array, "n 4"], rates: Float64[Array, "n 3"]) -> Float64[Array, "n 3 6"]:
    """Return the maps from J11, J22, J33, √2 J12, √2 J13, √2 J23 to the momentum R J ω in space."""
    n = len(rates)
    columns = np.zeros((n, 3, 6))
    for i in range(3):
        columns[:, i, i] = rates[:, i]
    for k, (i, j) in enumerate(OFF_DIAGONAL, start=3):
        columns[:, i, k] = rates[:, j] / ROOT
        columns[:, j, k] = rates[:, i] / ROOT
    return np.matmul(Rotation.from_quat(attitudes).as_matrix(), columns)


def inertia_matrix(entries: Float64[Array, "6"]) -> Float64[Array, "3 3"]:
    """Return the symmetric matrix of six entries, those off the diagonal times √2."""
    J = np.diag(entries[:3])
    for k, (i, j) in enumerate(OFF_DIAGONAL, start=3):
        J[i, j] = J[j, i] = entries[k] / ROOT
    return J


def linear_inertia(
    rates: list[Float64[Array, "n 3"]], attitudes: list[Float64[Array, "n 4"]],
    parts: Sequence[Sequence[Integer[Array, "..."]]] | None = None, rotor: bool = False,
) -> LinearInertia:
    """Return moments and axes from one or several throws of one body.

    Args:
        rates: of each throw [rad/s, device frame].
        attitudes: of each throw, quaternions xyzw, device → any frame at rest.
        parts: samples of each throw with one constant momentum, by default all.
        rotor: whether a wheel of constant momentum h turns in the body: R (J ω + h) is constant then.
    """
    rows = []
    for k, (rate, attitude) in enumerate(zip(rates, attitudes, strict=True)):
        maps = momentum_map(attitude, rate)
        if rotor:
            maps = np.concatenate([maps, Rotation.from_quat(attitude).as_matrix()], axis=2)
        for part in [slice(None)] if parts is None else parts[k]:
            rows.append((maps[part] - maps[part].mean(axis=0)).reshape(-1, maps.shape[2]))
    # Σ |R J ω − its mean|² is least, at |J| = 1, along the last right singular vector; the root of two makes the six
    # entries' length that of the matrix
    _, values, right = np.linalg.svd(np.concatenate(rows), full_matrices=False)  # at least 24 rows
    J = inertia_matrix(right[-1, :6])
    sign = np.sign(np.trace(J) or 1.0)
    moments, axes = np.linalg.eigh(J * sign)
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    wheel = sign * right[-1, 6:] / max(float(moments[2]), 1e-300) if rotor else np.zeros(3)
    return LinearInertia(possible_moments(moments), axes, values, wheel)


def possible_moments(moments: Float64[Array, "3"]) -> Float64[Array, "3"]:
    """Return moments over the largest, ascending, moved to satisfy the triangle inequality."""
    # of a flat body's, (b + c, a + c, a + b) with a ≥ b ≥ c ≥ 0 the spreads of mass along the axes
    a, b, c = (0.5 * moments.sum() - moments).tolist()
    largest = max(a, 1e-300)
    thinnest = 0.02  # of the largest spread: a start within what a body can be
    b, c = max(b, thinnest * largest), max(c, thinnest * largest)
    ordered = np.sort(np.array([b + c, largest + c, largest + b]))
    return ordered / ordered[2]
