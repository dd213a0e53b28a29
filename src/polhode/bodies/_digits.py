"""Which moments are equal, and which are zero, to the digits of the data that they come from.

One rule wherever moments are judged: two that differ by no more than their uncertainty are equal, and one within its
uncertainty of zero is zero. The uncertainty comes from the rounding of an inertia's entries, or from the digits of the
positions behind them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode.types import Array, Float64, Real

DECIMALS = range(3, 9)  # of positions, as programs print them; more digits count as exact


class DigitLimits(NamedTuple):
    """A number that decides whether numbers are whole multiples of a digit."""

    max_rounding: float = 1e-5  # of a unit of the last digit: rounding of a float that should be a whole multiple


LIMITS = DigitLimits()


def judge_moments(
    moments: Float64[Array, "3"], unsure: Float64[Array, "3"]
) -> tuple[Float64[Array, "3"], list[list[int]]]:
    """Return moments (3,), set to zero or equal where they are so within their uncertainty, and the groups of equal
    ones.

    If one is zero, mass lies on its axis alone, and the other two are equal: a difference within the rounding of all
    three is dropped.

    Args:
        moments: ascending.
        unsure: of each.

    >>> judge_moments(np.array([1e-9, 1.0, 1.0 + 1e-9]), np.full(3, 1e-8))
    (array([0., 1., 1.]), [[0], [1, 2]])
    """
    rounded = np.where(np.abs(moments) <= unsure, 0.0, moments)
    line = rounded[0] == 0.0 and rounded[2] - rounded[1] <= unsure.sum()
    groups = [[0]]
    for k in (1, 2):
        if rounded[k] - rounded[k - 1] <= max(unsure[k], unsure[k - 1]) or (k == 2 and line):
            groups[-1].append(k)
        else:
            groups.append([k])
    for group in groups:
        rounded[group] = rounded[group].mean() if len(group) > 1 else rounded[group]
    return rounded, groups


def unsure_moments(moments: Float64[Array, "3"], mass: float, digit: float) -> Float64[Array, "3"]:
    """Return the uncertainty (3,) of moments, from positions that were rounded to a digit.

    Each point is off by up to digit/√2 across an axis, so that no radius of gyration √(I/M) changes by more, and two
    that were equal differ by up to √2 digits.

    Args:
        moments: (3,) [kg m²].
        mass: M [kg].
        digit: the unit of the last digit [m].
    """
    radii = np.sqrt(np.maximum(moments, 0.0) / mass)
    return mass * ((radii + math.sqrt(2.0) * digit) ** 2 - radii**2)


def last_digit(positions: Real[Array, "n 3"], unit: float) -> float:
    """Return the unit of the last decimal [m] of positions, 0 of those that have more digits than are printed.

    Args:
        positions: (n, 3) [m].
        unit: of length, that their decimals are of [m].

    >>> last_digit(np.array([[0.0, 1.2345, -0.5]]), 1.0)
    0.0001
    """
    lengths = np.asarray(positions, float) / unit
    for decimals in DECIMALS:
        scaled = lengths * 10.0**decimals
        if (np.abs(scaled - np.rint(scaled)) <= LIMITS.max_rounding).all():
            return unit * 10.0**-decimals
    return 0.0
