"""Times of a clock that is rounded more coarsely than the samples come."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.types import Array, Float64


class ClockLimits(NamedTuple):
    """Numbers that decide that a clock is rounded, and that its times are those of equal steps."""

    min_repeats: int = 3  # samples at the time of the one before, from which a clock may count as rounded
    min_repeated_share: float = 0.02  # of the samples; fewer repeated times are hiccups of a clock that is not rounded
    max_deviation: float = 1.1  # of the clock's step, within which its rounding keeps the times of equal steps


LIMITS = ClockLimits()


def is_coarse(repeated: int, samples: int) -> bool:
    """Whether this number of repeated times shows a rounded clock."""
    return repeated >= max(LIMITS.min_repeats, LIMITS.min_repeated_share * samples)


def spread_evenly(t: Float64[Array, "n"]) -> Float64[Array, "n"]:
    """Return the times of a coarse clock, with samples of one time at equal steps to the next."""
    distinct, counts = np.unique(t, return_counts=True)
    coarse = float(np.median(np.diff(distinct))) if len(distinct) > 1 else 0.0
    steps = np.minimum(np.diff(distinct, append=distinct[-1] + coarse), coarse)  # not over a gap
    spread = t + np.concatenate([np.arange(count) / count * step for count, step in zip(counts, steps, strict=True)])
    # samples that are even to the clock's resolution are taken as even
    grid = np.polynomial.Polynomial.fit(np.arange(len(t)), t, 1)(np.arange(len(t)))
    return t[0] + grid - grid[0] if np.ptp(t - grid) <= LIMITS.max_deviation * coarse else spread
