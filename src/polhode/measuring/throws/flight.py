"""Where in a log a body flies freely: by its accelerometer, or by its constant angular momentum."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.measuring.throws._momentum_flight import LIMITS as MOMENTUM_LIMITS
from polhode.measuring.throws._momentum_flight import Stretch, momentum_stretches, of_one_body, within
from polhode.measuring.throws._weightless_flight import weightless_stretches
from polhode.measuring.throws.gyro_log import LIMITS as LOG_LIMITS
from polhode.measuring.throws.gyro_log import GyroLog
from polhode.measuring.throws.rest import rest_stretches
from polhode.types import Array

WEIGHTLESS = "the accelerometer feels no weight"
MOMENTUM = "keeps an angular momentum"


class FlightThresholds(NamedTuple):
    """Numbers that decide which stretches of a log are flights.

    Attributes:
        min_duration: s, of a flight; shorter ones do not determine an inertia.
        min_duration_left_out: s; a shorter stretch is not even listed as left out.
        max_trimmed: s, at each end of a weightless stretch, where a hand may still turn the body.
    """

    min_duration: float = 0.25
    min_duration_left_out: float = 0.15
    max_trimmed: float = 0.1


LIMITS = FlightThresholds()


@dataclass(frozen=True)
class Window:
    """A stretch of a log.

    Attributes:
        start: [s].
        end: [s], included.
        reason: by which sensor it was detected, or why it is left out.
        score: of the accelerometer, rms of the acceleration not due to rotation [m/s²]; of the gyro, change of angular
            momentum relative to its size; the smaller, the better; 0 where the window was given.
    """

    start: float
    end: float
    reason: str = "given"
    score: float = 0.0


class Flights(NamedTuple):
    """The flights of a log that a fit can use, and the stretches that look like flights and are left out."""

    windows: list[Window]
    left_out: list[Window]


@known_numbers_only
def free_flights(log: GyroLog, limit: float | None = None) -> list[Window]:
    """Return the stretches of free flight, in the order of time; none where there are none.

    In flight an accelerometer at place r measures ω × (ω × r) + ω̇ × r alone, without weight. The lever arm r is fitted
    over spans of a few tenths of a second, no longer than in a hand-held device. In a log without accelerometer a
    flight is a stretch over which R J ω is constant for some inertia J, R from the gyro itself; all flights of a log
    must share one inertia. A flight is limited by the torque of the hands at both ends.

    Args:
        log: from ``clean_log``.
        limit: size of rates [rad/s] from which samples are at the gyro's limit, if there are any.

    Example:
        >>> import numpy as np
        >>> from polhode.measuring import clean_log
        >>> t = np.arange(0, 2, 0.01)
        >>> acceleration = np.where(abs(t - 1) < 0.4, 0.0, 9.8)[:, None] * [0.0, 0.0, 1.0]
        >>> [window] = free_flights(clean_log(t, np.ones((200, 3)), t, acceleration))
        >>> bool(abs(window.start - 0.6) < 0.03 and abs(window.end - 1.4) < 0.03)
        True
    """
    return find_flights(log, limit).windows


def find_flights(log: GyroLog, limit: float | None = None) -> Flights:
    """Return the flights of ``free_flights``, and the stretches that were left out, with the reasons."""
    t, rates = _thin(log.times, log.rates - _bias(log))
    if log.acceleration is None:
        used, left = _by_momentum(t, rates)
    else:
        used, left = _by_weight(log, t, rates)
    usable = log.times if limit is None else log.times[(np.abs(log.rates) < limit * (1 - 1e-6)).all(axis=1)]
    few = [window for window in used if _samples(usable, window) < LOG_LIMITS.min_samples]
    why = "fewer than 8 samples" if limit is None else "fewer than 8 samples below the gyro's limit"
    left += [Window(window.start, window.end, why, window.score) for window in few]
    return Flights([window for window in used if window not in few], sorted(left, key=lambda one: one.start))


def check_windows(windows: list[Window], log: GyroLog) -> None:
    """Raise InvalidInput unless every window has a beginning before its end, and samples."""
    for window in windows:
        inside = _samples(log.times, window)
        if not window.start < window.end or inside < LOG_LIMITS.min_samples:
            raise InvalidInput(
                f"a window must start before its end and hold at least 8 samples of the log, which goes from "
                f"{log.times[0]:g} s to {log.times[-1]:g} s; got {shown((window.start, window.end))} with {inside}."
            )


def _samples(t: Array, window: Window) -> int:
    return int(np.searchsorted(t, window.end, "right") - np.searchsorted(t, window.start, "left"))


def _bias(log: GyroLog) -> Array:
    """Return the mean rates while the device lies still, zero where it never does."""
    still = np.zeros(len(log.times), dtype=bool)
    for start, end in rest_stretches(log):
        still |= (log.times >= start) & (log.times <= end)
    return log.rates[still].mean(axis=0) if still.any() else np.zeros(3)


def _thin(t: Array, rates: Array) -> tuple[Array, Array]:
    """Return means over a few samples where they come faster than needed."""
    step = float(np.median(np.diff(t)))
    fastest = float(np.quantile(np.abs(rates).max(axis=1), 0.999))
    duration, turn = 0.004, 0.1  # s and rad, of a mean; hands act for longer
    many = int(min(duration, turn / max(fastest, 1e-9)) / step) if step > 0 else 1
    if many < 2 or len(t) // many < 2 * LOG_LIMITS.min_samples:
        return t, rates
    n = len(t) // many * many
    return t[:n].reshape(-1, many).mean(axis=1), rates[:n].reshape(-1, many, 3).mean(axis=1)


def _by_momentum(t: Array, rates: Array) -> tuple[list[Window], list[Window]]:
    stretches = momentum_stretches(t, rates, LIMITS.min_duration_left_out)
    long = [one for one in stretches if t[one.last] - t[one.first] >= LIMITS.min_duration]
    used, others = of_one_body(t, rates, long)
    left = [_window(t, one, f"{MOMENTUM}, by another inertia than the rest") for one in others]
    short = [one for one in stretches if one not in long]
    left += [_window(t, one, f"{MOMENTUM}, for less than {LIMITS.min_duration} s") for one in short
             if of_one_body(t, rates, [*used, one])[1] == []]
    return [_window(t, one, MOMENTUM) for one in used], left


def _by_weight(log: GyroLog, t: Array, rates: Array) -> tuple[list[Window], list[Window]]:
    clock = log.acceleration_times
    assert clock is not None
    windows = [Window(float(clock[one.first]), float(clock[one.last]), WEIGHTLESS, one.felt)
             for one in weightless_stretches(log, LIMITS.min_duration_left_out)]
    used = [_trim(t, rates, window) for window in windows if window.end - window.start >= LIMITS.min_duration]
    left = [Window(one.start, one.end, f"{WEIGHTLESS}, for less than {LIMITS.min_duration} s", one.score)
            for one in windows if one.end - one.start < LIMITS.min_duration]
    if not used:  # a device that turns on a bearing keeps a momentum too
        left += [Window(one.start, one.end, f"{MOMENTUM}, but the accelerometer feels weight", one.score)
                 for one in _by_momentum(t, rates)[0]]
    return used, left


def _trim(t: Array, rates: Array, window: Window) -> Window:
    """Return a window without the ends at which a torque acts: a hand may turn the device without carrying it."""
    part = slice(int(np.searchsorted(t, window.start)), int(np.searchsorted(t, window.end, "right")))
    stretch = within(t[part], rates[part]) if part.stop - part.start >= LOG_LIMITS.min_samples else None
    if stretch is None or stretch.change > MOMENTUM_LIMITS.max_change:
        return window
    start, end = float(t[part][stretch.first]), float(t[part][stretch.last])
    trimmed = max(start - window.start, window.end - end)
    if trimmed > LIMITS.max_trimmed or end - start < LIMITS.min_duration:
        return window
    first, last = stretch.first == 0, stretch.last == part.stop - part.start - 1
    return Window(window.start if first else start, window.end if last else end, window.reason, window.score)


def _window(t: Array, one: Stretch, reason: str) -> Window:
    return Window(float(t[one.first]), float(t[one.last]), reason, one.change)
