"""Rest of a body under gravity's gradient on a circular orbit, one principal axis along each of the orbit's."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real

NEAR = 1e-12  # of n²: a threshold that is missed by less decides nothing


class GravityGradientRest(NamedTuple):
    """A rest in the orbit's frame.

    Attributes:
        verdict: "stable", "unstable" or "undecided".
        region: "Lagrange", where the Jacobi integral has a strict minimum; "DeBra-Delp", where it has not, and all
            motions near by are bounded to first order alone; "" elsewhere.
        pitch: rate of small librations in the orbit's plane [rad/s]; None where it does not oscillate.
        roll_yaw: the two rates across it [rad/s], faster first; None where they do not both oscillate.
        rate: of growth [1/s], zero where nothing grows exponentially.
    """

    verdict: str
    region: str
    pitch: float | None
    roll_yaw: tuple[float, float] | None
    rate: float


@known_numbers_only
def gravity_gradient_rest(moments: Real[ArrayLike, "3"], mean_motion: float) -> GravityGradientRest:
    """Return whether a body that rests along the orbit's axes stays there.

    Pitch: θ̈ = −3 n² (I_r − I_y)/I_p θ. Roll and yaw: λ⁴ + (1 + 3 k_r + k_r k_y) n² λ² + 4 k_r k_y n⁴ = 0 with
    k_r = (I_p − I_y)/I_r and k_y = (I_p − I_r)/I_y. The Jacobi integral has a strict minimum, which proves stability,
    where I_p > I_r > I_y. Losses make the rests of the DeBra–Delp region unstable.

    Args:
        moments: about the axes of roll, pitch and yaw: ahead along the orbit, against its normal, down [kg m²].
        mean_motion: n of the circular orbit [rad/s].

    Raises:
        InvalidInput: for moments that are not positive.

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), §9.2–9.3; DeBra & Delp, J. Astronaut. Sci. 8 (1961) 14.

    >>> rest = gravity_gradient_rest((2500.0, 2530.0, 85.0), 2 * math.pi / 6052.4)  # much as GEOSAT
    >>> rest.verdict, rest.region, round(2 * math.pi / rest.pitch, 1)
    ('stable', 'Lagrange', 3557.2)
    """
    sizes = np.asarray(moments, dtype=float)
    if sizes.shape != (3,) or not np.isfinite(sizes).all() or not (sizes > 0).all():
        raise InvalidInput(f"`moments` must be three positive numbers [kg m²]; got {shown(sizes.tolist())}.")
    n = float(mean_motion)
    roll, pitch, yaw = sizes.tolist()
    in_plane = 3.0 * (roll - yaw) / pitch
    kr, ky = (pitch - yaw) / roll, (pitch - roll) / yaw
    middle, last = 1.0 + 3.0 * kr + kr * ky, 4.0 * kr * ky
    inside = middle**2 - 4.0 * last
    across = np.roots([1.0, middle, last])  # λ² in n²
    exponents = np.concatenate([np.sqrt(across.astype(complex)), [np.sqrt(complex(-in_plane))]])
    growth = float(np.abs(exponents.real).max()) * n
    decided = min(abs(in_plane), abs(last), abs(inside)) > NEAR
    oscillates = middle > 0 and last > 0 and inside > 0
    rates = tuple(sorted((n * math.sqrt(-x) for x in across.real.tolist()), reverse=True)) if oscillates else None
    pitching = n * math.sqrt(in_plane) if in_plane > 0 else None
    if not decided:
        return GravityGradientRest("undecided", "", pitching, _two(rates), 0.0)
    if pitching is None or rates is None:
        return GravityGradientRest("unstable", "", pitching, _two(rates), growth)
    if pitch > roll > yaw:
        return GravityGradientRest("stable", "Lagrange", pitching, _two(rates), 0.0)
    return GravityGradientRest("undecided", "DeBra-Delp", pitching, _two(rates), 0.0)


def _two(rates: tuple[float, ...] | None) -> tuple[float, float] | None:
    return None if rates is None else (rates[0], rates[1])


def nearest_rest(
    axes: Real[ArrayLike, "3 3"], moments: Real[ArrayLike, "3"]
) -> tuple[Float64[Array, "3"], float]:
    """Return the moments about roll, pitch and yaw of the rest nearest to a body, and the angle to it [rad].

    Args:
        axes: (3, 3) principal axes by columns in the orbit's, which look ahead, against the normal, and down.
        moments: (3,) about them [kg m²].
    """
    from itertools import permutations

    matrix = np.asarray(axes, dtype=float)
    best: tuple[float, tuple[int, ...]] = (-math.inf, (0, 1, 2))
    for order in permutations(range(3)):
        # the rotation from the nearest signs has the trace Σ |cosines|, or less by twice the least if it is improper
        chosen = [matrix[row, column] for row, column in enumerate(order)]
        signs = np.where(np.asarray(chosen) < 0, -1.0, 1.0)
        turn = np.zeros((3, 3))
        turn[range(3), list(order)] = signs
        trace = float(np.abs(chosen).sum())
        if np.linalg.det(turn) * np.linalg.det(matrix) < 0:
            trace -= 2.0 * float(np.abs(chosen).min())
        best = max(best, (trace, order))
    trace, order = best
    return np.asarray(moments, dtype=float)[list(order)], float(np.arccos(np.clip(0.5 * (trace - 1.0), -1.0, 1.0)))
