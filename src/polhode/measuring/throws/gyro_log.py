"""Logs of gyroscopes and accelerometers as clean arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation._coarse_clock import is_coarse, spread_evenly
from polhode.types import Array, ArrayLike, Float64, Real

UNITS = {"times": "s", "rates": "rad/s", "acceleration": "m/s²"}


class LogThresholds(NamedTuple):
    """Numbers that decide which logs are refused.

    Attributes:
        min_samples: of a log, and of a throw.
        max_value: s, rad/s or m/s²; beyond any clock and gyro, as levitated grains reach 3e10 rad/s.
        min_step: s from sample to sample; no gyro comes near it, and a second of such a log fills the memory.
    """

    min_samples: int = 8
    max_value: float = 1e12
    min_step: float = 1e-9


LIMITS = LogThresholds()


@dataclass(frozen=True, eq=False)
class GyroLog:
    """Angular rates and proper accelerations of a device, each with its own clock readings.

    Attributes:
        times: (n,) increasing [s].
        rates: (n, 3) [rad/s, device frame].
        acceleration_times: (m,) increasing [s], or None.
        acceleration: (m, 3) proper acceleration [m/s², device frame], or None.
        dropped: samples of the gyro that were left out because they were not finite.
        repeats: samples of the gyro that were left out because their time had come before.
        spread: samples of the gyro that repeated an earlier time and were given times of their own, as the
            clock is coarser than the sampling.
        reordered: whether the samples did not come in the order of time.
    """

    times: Float64[Array, "n"]
    rates: Float64[Array, "n 3"]
    acceleration_times: Float64[Array, "m"] | None = None
    acceleration: Float64[Array, "m 3"] | None = None
    dropped: int = 0
    repeats: int = 0
    reordered: bool = False
    spread: int = 0


@known_numbers_only
def clean_log(
    times: Real[ArrayLike, "n"], rates: Real[ArrayLike, "n 3"],
    acceleration_times: Real[ArrayLike, "m"] | None = None, acceleration: Real[ArrayLike, "m 3"] | None = None,
) -> GyroLog:
    """Return a log whose samples are finite and in the order of time.

    Rows with NaN are dropped samples and are left out; of samples of one time the first is kept; both are counted.
    Where many samples share their time with another, and differ, the clock is rounded more coarsely than the sensor
    samples: they are spread evenly over its step.

    Args:
        times: of the gyro's samples [s].
        rates: [rad/s, device frame].
        acceleration_times: of the accelerometer's samples [s], if there is one; they need not be those of the gyro.
        acceleration: proper acceleration [m/s², device frame]; of a device at rest on a table about 9.8 upwards.

    Raises:
        InvalidInput: for wrong shapes, fewer than eight usable samples of the gyro, samples less than 1e-9 s apart, or
            numbers that no log holds.

    Example:
        >>> import numpy as np
        >>> times, rates = np.arange(10.0), np.ones((10, 3))
        >>> rates[4] = np.nan
        >>> log = clean_log(times, rates)
        >>> len(log.times), log.dropped
        (9, 1)
    """
    t, x, dropped, repeats, reordered, spread = _clean("rates", times, rates)
    if len(t) < LIMITS.min_samples:
        raise InvalidInput(f"a gyro log must have {LIMITS.min_samples} finite samples at different times; got "
                           f"{len(t)}.")
    if (acceleration is None) != (acceleration_times is None):
        raise InvalidInput("acceleration and acceleration_times must be given together; got only one of them.")
    if acceleration is None or acceleration_times is None:
        return GyroLog(t, x, None, None, dropped, repeats, reordered, spread)
    ta, a, *_ = _clean("acceleration", acceleration_times, acceleration)
    some = len(ta) > 0
    return GyroLog(t, x, ta if some else None, a if some else None, dropped, repeats, reordered, spread)


def check_sizes(**values: Array) -> None:
    """Refuse numbers larger than those of any log, as from columns with another meaning.

    Args:
        values: by name, one of UNITS.

    Raises:
        InvalidInput: naming what is too large, and the rule.
    """
    for name, numbers in values.items():
        most, unit = LIMITS.max_value, UNITS[name]
        largest = float(np.max(np.abs(numbers), initial=0.0))
        if largest > most:
            raise InvalidInput(f"{name} must be at most {most:g} {unit} in size; got {largest:g} {unit}. Check which "
                               "columns of the log they are, and their unit.")


def _check_steps(name: str, steps: Float64[Array, "_"]) -> None:
    """Refuse samples closer than those of any sensor, judged by the median, as rounding separates equal times."""
    usual = float(np.median(steps)) if len(steps) else LIMITS.min_step
    if usual < LIMITS.min_step:
        raise InvalidInput(f"times of {name} must lie {LIMITS.min_step:g} s apart or more; got {usual:g} s. Check "
                           "which column has the times, and their unit.")


def _clean(name: str, times: ArrayLike, values: ArrayLike) -> tuple[Array, Array, int, int, bool, int]:
    t, x = (np.asarray(v, dtype=np.float64) for v in (times, values))
    if t.ndim != 1 or x.shape != (*t.shape, 3):
        raise InvalidInput(
            f"times of shape (n,) and {name} of shape (n, 3) are needed; got {shown(t.shape)} and {shown(x.shape)}."
        )
    whole = np.isfinite(t) & np.isfinite(x).all(axis=1)
    if not whole.all():
        t, x = t[whole], x[whole]
    check_sizes(**{"times": t, name: x})
    steps = np.diff(t)
    _check_steps(name, np.abs(steps[steps != 0.0]))
    if (steps > 0).all():
        return t.copy(), x.copy(), int((~whole).sum()), 0, False, 0
    reordered = bool((steps < 0).any())
    order = np.argsort(t, kind="stable")
    t, x = t[order], x[order]
    new = np.concatenate([[True], (np.diff(t) > 0) | (np.diff(x, axis=0) != 0).any(axis=1)])  # no line that came twice
    first = np.concatenate([[True], np.diff(t) > 0])
    spread = int((new & ~first).sum())
    if not is_coarse(spread, len(t)):
        return t[first], x[first], int((~whole).sum()), int((~first).sum()), reordered, 0
    return spread_evenly(t[new]), x[new], int((~whole).sum()), int((~new).sum()), reordered, spread
