"""A body about a fixed point: its moments there, its weight's arm, and its axis of symmetry."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import is_traced
from polhode.bodies._inertia import principal_axes
from polhode.bodies.body import Body, check_is_body
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real

STANDARD_GRAVITY = 9.80665  # m/s², by definition
EQUAL = 1e-12  # relative: moments of a body about a point are sums with rounding


class PivotLimits(NamedTuple):
    """A number that decides whether a body is balanced at its pivot."""

    # of the radius of gyration; a centre of mass nearer to the pivot is there but for rounding
    min_distance: float = 1e-12


LIMITS = PivotLimits()


class PivotedBody(NamedTuple):
    """The constants on which the motion of a body about a fixed point depends.

    Attributes:
        moments: (3,) principal moments about the fixed point, ascending [kg m²].
        axes: (3, 3) principal axes there by columns, in the given axes.
        arm: (3,) from the fixed point to the centre of mass [m, principal axes].
        mgl: weight times the length of the arm [N m]; zero where that is rounding, and the body is free.
    """

    moments: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    arm: Float64[Array, "3"]
    mgl: float


def about_pivot(body: Body, pivot: Real[ArrayLike, "3"], gravity: float = STANDARD_GRAVITY) -> PivotedBody:
    """Return the constants of a body's motion about a fixed point: Huygens and Steiner's theorem, and the weight.

    A fixed point at the centre of mass leaves the free body; a warning to the caller of the caller says so.

    Args:
        body: with its mass.
        pivot: (3,) the fixed point [m, given axes of the body].
        gravity: [m/s²], positive.

    Raises:
        InvalidInput: for a body without mass, gravity that is not positive, or numbers that JAX traces.
    """
    check_is_body(body)
    if is_traced(gravity, *(pivot if isinstance(pivot, tuple | list) else (pivot,))):
        raise InvalidInput("`pivot` and `gravity` must be known numbers, not traced by JAX: the principal axes at the "
                           "pivot are decided on them. Give moments and mgl to LagrangeMotion instead.")
    gravity = check.number("gravity", gravity, "m/s²", above=0)
    # J_pivot = J + m (|d|² 1 − d dᵀ)
    moments, axes = principal_axes(body.about(pivot))
    arm = (body.center_of_mass - np.asarray(pivot, dtype=float)) @ axes
    length, mass = float(np.linalg.norm(arm)), float(body.mass or 0.0)
    if length * np.sqrt(mass) <= LIMITS.min_distance * np.sqrt(moments[2]):
        warnings.warn("the fixed point is the centre of mass: the weight has no torque, the body is free.",
                      stacklevel=3)
        return PivotedBody(moments, axes, np.zeros(3), 0.0)
    return PivotedBody(moments, axes, arm, mass * gravity * length)


def with_gravity(body: Body, arm: Float64[Array, "3"], gravity: Float64[Array, "*batch"]) -> Float64[Array, "*batch"]:
    """Return mgl (…) as ``about_pivot`` does, of one body, by its arm, and many gravities (…) [m/s²]."""
    return float(body.mass or 0.0) * gravity * float(np.linalg.norm(arm))


def axis_of_symmetry(moments: Real[ArrayLike, "3"], axis: Real[ArrayLike, "3"]) -> int | None:
    """Return the index of the principal axis of symmetry that a direction lies along, but for rounding.

    Args:
        moments: (3,) principal moments about a fixed point [kg m²].
        axis: (3,) unit vector along the principal axes.

    Returns:
        0, 1 or 2 where the other two moments are equal; −1 where all are, and every direction will do; None elsewhere.
    """
    if np.ptp(moments) <= EQUAL * moments.max():
        return -1
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        if abs(moments[i] - moments[j]) <= EQUAL * moments[i] and abs(axis[i]) + abs(axis[j]) <= EQUAL:
            return k
    return None
