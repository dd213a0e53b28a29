"""Rest of a body under gravity's gradient on a circular orbit, one principal axis along each of the orbit's."""

from __future__ import annotations

import math
from itertools import permutations
from typing import Any, NamedTuple

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

    >>> rest = gravity_gradient_rest((2500.0, 2530.0, 85.0), 2 * math.pi / 6052.4)
    >>> rest.verdict, rest.region, round(2 * math.pi / rest.pitch, 1)
    ('stable', 'Lagrange', 3576.6)
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
    across: Any = np.roots([1.0, middle, last])  # λ² in n²
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


class NearestRest(NamedTuple):
    """The rest nearest to an attitude.

    Attributes:
        moments: (3,) about roll, pitch and yaw there [kg m²].
        turn: (3, 3) the principal axes by columns in the orbit's, one along each.
        angle: to it [rad].
    """

    moments: Float64[Array, "3"]
    turn: Float64[Array, "3 3"]
    angle: float


def nearest_rest(axes: Real[ArrayLike, "3 3"], moments: Real[ArrayLike, "3"]) -> NearestRest:
    """Return the rest nearest to a body.

    Args:
        axes: (3, 3) principal axes by columns in the orbit's, which look ahead, against the normal, and down.
        moments: (3,) about them [kg m²].

    >>> nearest_rest(np.eye(3)[[1, 0, 2]] * [1.0, 1.0, -1.0], (1.0, 2.0, 3.0)).moments.tolist()
    [2.0, 1.0, 3.0]
    """
    matrix, best = np.asarray(axes, dtype=float), None
    for order in permutations(range(3)):
        chosen = matrix[range(3), list(order)]
        signs = np.where(chosen < 0, -1.0, 1.0)
        turn = np.zeros((3, 3))
        turn[range(3), list(order)] = signs
        if np.linalg.det(turn) < 0:  # the sign that costs least makes it a rotation
            weakest = int(np.argmin(np.abs(chosen)))
            turn[weakest, order[weakest]] *= -1.0
        trace = float(np.sum(turn * matrix))
        if best is None or trace > best[0]:
            best = trace, turn, order
    assert best is not None
    trace, turn, order = best
    return NearestRest(
        np.asarray(moments, dtype=float)[list(order)], turn, float(np.arccos(np.clip(0.5 * (trace - 1.0), -1.0, 1.0)))
    )


@known_numbers_only
def escape_energy(moments: Real[ArrayLike, "3"], mean_motion: float) -> float:
    """Return the Jacobi integral [J] below which a body on a circular orbit cannot leave the rest that it is near.

    It is ½ w·Iw + ½ n² (3 R̂·IR̂ − ẑ·Iẑ), whose second part has its least values, at the four attitudes with the largest
    moment across the orbit and the least one down, ½ n² (3 I1 − I3). Its next critical values are those with two axes
    exchanged; below the lower of them, what a motion can reach falls apart into four pieces, one about each rest.

    Args:
        moments: (3,) principal moments [kg m²].
        mean_motion: n [rad/s].

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), §9.3; Likins & Roberson, J. Astronaut. Sci. 13 (1966) 87.
    """
    first, second, third = np.sort(np.asarray(moments, dtype=float)).tolist()
    lowest = 3.0 * first - third
    return 0.5 * float(mean_motion) ** 2 * (lowest + min(third - second, 3.0 * (second - first)))
