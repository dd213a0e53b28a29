"""Partition functions of rotors: sums over the levels that contribute."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy import constants

from polhode._base import check
from polhode.types import Array, ArrayLike, Float64, Real

THERMAL = constants.k / constants.h  # Hz/K


class PartitionLimits(NamedTuple):
    """Where the sum over levels ends.

    Attributes:
        negligible_energy: E/kT of a level that no longer counts: e^−45 = 3e-20.
    """

    negligible_energy: float = 45.0


LIMITS = PartitionLimits()


def check_temperature(temperature: Real[ArrayLike, "*batch"]) -> Float64[Array, "*batch"]:
    """Return temperatures (…) [K].

    Raises:
        InvalidInput: for temperatures that are not positive and finite.
    """
    return check.array("temperature", temperature, None, "K", above=0)


def partition_sum(
    levels_of: Callable[[int], tuple[Array, Array]], temperature: Float64[Array, "*batch"], highest: int
) -> Float64[Array, "*batch"]:
    """Return Σ w (2J+1) e^{−E/kT} (…).

    The sum ends where a J's lowest level no longer counts, or, with a warning, where distortion lets levels fall from
    one J to the next.

    Args:
        levels_of: J → energies [Hz] and weights.
        temperature: (…) [K].
        highest: largest J of the sum.
    """
    hottest = THERMAL * float(np.max(temperature))
    total, last = np.zeros(np.shape(temperature)), -math.inf
    for J in range(highest + 1):
        energy, weight = levels_of(J)
        lowest = float(energy.min())
        if lowest < last:
            warnings.warn(
                f"levels fall from J = {J - 1} to {J}: the distortion constants do not hold there, and the partition "
                "function is summed up to here. Give constants of higher order, or a lower temperature.",
                stacklevel=4,
            )
            break
        # 2J + 1 directions in space of each level
        total = total + np.sum((2 * J + 1) * weight * np.exp(-energy / (THERMAL * temperature[..., None])), axis=-1)
        last = lowest
        if lowest > LIMITS.negligible_energy * hottest:
            break
    return total
