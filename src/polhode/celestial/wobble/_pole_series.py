"""Series of the pole as clean arrays: checked, complex, averaged over equal steps."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Complex128, Float64, Integer, Real

DAY = 86_400.0
YEAR = 365.2422 * DAY  # tropical: the seasons' year


class PoleLimits(NamedTuple):
    """What series of the pole are refused."""

    max_coordinate: float = 0.01  # rad; values beyond are arcseconds or milliarcseconds
    min_samples: int = 50  # of a series


LIMITS = PoleLimits()


class Pole(NamedTuple):
    """The pole m = x − i y, which turns with the Earth's spin where its phase grows.

    Attributes:
        times: (n,) [s], ascending.
        m: (n,) [rad].
        counts: (n,) number of samples in each mean.
    """

    times: Float64[Array, "n"]
    m: Complex128[Array, "n"]
    counts: Float64[Array, "n"]

    @property
    def span(self) -> float:
        """From the first to the last time [s]."""
        return float(self.times[-1] - self.times[0])


def clean_pole(times: Real[ArrayLike, "n"], x: Real[ArrayLike, "n"], y: Real[ArrayLike, "n"]) -> Pole:
    """Return the pole as clean arrays.

    Raises:
        InvalidInput: for arrays that are not finite, of different lengths, too few, not ascending, or not in radians.
    """
    remedy = "Give one series, and leave out samples that are not finite."
    t, east, west = (check.array(name, column, ("n",), remedy=remedy)
                     for name, column in (("times", times), ("x", x), ("y", y)))  # fmt: skip
    if not len(t) == len(east) == len(west):
        raise InvalidInput(f"`times`, `x` and `y` must be equally long; got {len(t)}, {len(east)} and {len(west)}.")
    if len(t) < LIMITS.min_samples:
        raise InvalidInput(
            f"the pole must be sampled at {LIMITS.min_samples} times at least; got {len(t)}. Give a longer series."
        )
    if (np.diff(t) <= 0.0).any():
        bad = int(np.argmax(np.diff(t) <= 0.0)) + 1
        raise InvalidInput(f"`times` must ascend; entry {bad} is {t[bad]:g} after {t[bad - 1]:g}. Sort the samples.")
    if max(np.abs(east).max(), np.abs(west).max()) > LIMITS.max_coordinate:
        raise InvalidInput(f"`x` and `y` must be in radians, {LIMITS.max_coordinate:g} at most; got "
                           f"{max(np.abs(east).max(), np.abs(west).max()):g}. Divide arcseconds by 206264.8."
                           )
    return Pole(t, east - 1j * west, np.ones(len(t)))


def average_steps(pole: Pole, step: float) -> Pole:
    """Return means over consecutive steps [s] from the first time; steps without samples are left out."""
    first, sizes = _split_steps(pole, step)
    mean = lambda values: np.add.reduceat(values, first) / sizes  # noqa: E731
    return Pole(mean(pole.times), mean(pole.m.real) + 1j * mean(pole.m.imag), sizes.astype(float))


def step_moments(pole: Pole, step: float, orders: int) -> Float64[Array, "n k"]:
    """Return the mean powers 0, 1, … of the samples' times about their mean, in each step [s] of ``average_steps``."""
    first, sizes = _split_steps(pole, step)
    away = pole.times - np.repeat(np.add.reduceat(pole.times, first) / sizes, sizes)
    return np.add.reduceat(away[:, None] ** np.arange(orders), first, axis=0) / sizes[:, None]


def _split_steps(pole: Pole, step: float) -> tuple[Integer[Array, "n"], Integer[Array, "n"]]:
    """Return the first sample of each step that has samples, and their number."""
    place = np.floor((pole.times - pole.times[0]) / step + 1e-9).astype(int)
    _, first, sizes = np.unique(place, return_index=True, return_counts=True)
    return first, sizes


def even(pole: Pole, step: float) -> Pole:
    """Return means over steps without a gap, at the middles of the steps; the last step is left out unless full.

    Raises:
        InvalidInput: if a step has no sample.
    """
    usual = float(np.median(np.diff(pole.times)))
    steps = int(np.floor((pole.span + usual) / step + 1e-9))
    place = np.floor((pole.times - pole.times[0]) / step + 1e-9).astype(int)
    inside = place < steps
    place = place[inside]
    sizes = np.bincount(place, minlength=steps)
    if (sizes == 0).any():
        bad = int(np.argmax(sizes == 0))
        raise InvalidInput(f"the series must have no gap longer than the step of {step / DAY:g} d; there is no sample "
                           f"in the {step / DAY:g} d from {(pole.times[0] + bad * step) / DAY:g} d on. Choose a span "
                           "without the gap.")
    mean = lambda values: np.bincount(place, values[inside], minlength=steps) / sizes  # noqa: E731
    half = 0.5 * (step - usual)  # the time of a mean over samples at the start of each interval
    times = pole.times[0] + half + step * np.arange(steps)
    return Pole(times, mean(pole.m.real) + 1j * mean(pole.m.imag), sizes.astype(float))
