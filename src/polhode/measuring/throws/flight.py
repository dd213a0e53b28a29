"""Where in a log a body flies freely: by its accelerometer, or by its constant angular momentum."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.measuring.throws._momentum_flight import UNEVEN, Stretch, momentum_stretches, of_one_body, within
from polhode.measuring.throws._weightless_flight import weightless_stretches
from polhode.measuring.throws.gyro_log import MIN_SAMPLES, GyroLog
from polhode.measuring.throws.rest import rest_stretches
from polhode.types import Array

SHORTEST = 0.25  # s
SHORTEST_TOLD = 0.15  # s; what is shorter is not worth a word
FINE, FINE_TURN = 0.004, 0.1  # s and rad: means over so much show all that is looked for
MOST_TRIMMED = 0.1  # s at each end of a stretch without weight, where a hand may still turn it
WEIGHTLESS = "the accelerometer feels no weight"
MOMENTUM = "keeps an angular momentum"


@dataclass(frozen=True)
class Window:
    """A stretch of a log.

    Attributes:
        start: [s].
        end: [s], included.
        reason: how it was found, or why it is left out.
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

    In flight an accelerometer at place r feels ω × (ω × r) + ω̇ × r alone. The lever arm r is fitted, within what a
    hand-held device has, over the spans of a few tenths of a second, and gravity's absence is what is looked for. In a
    log without accelerometer a flight is a stretch over which some inertia J keeps R J ω, R from the gyro itself; those
    are taken that one inertia explains together. A flight begins and ends where the torque of the hands does.

    Args:
        log: from ``clean_log``.
        limit: size of rates [rad/s] from which samples are at the gyro's limit, if there are any.

    Example:
        >>> import numpy as np
        >>> from polhode.measuring import clean_log
        >>> t = np.arange(0, 2, 0.01)
        >>> felt = np.where(abs(t - 1) < 0.4, 0.0, 9.8)[:, None] * [0.0, 0.0, 1.0]
        >>> [flight] = free_flights(clean_log(t, np.ones((200, 3)), t, felt))
        >>> bool(abs(flight.start - 0.6) < 0.03 and abs(flight.end - 1.4) < 0.03)
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
    few = [window for window in used if _samples(usable, window) < MIN_SAMPLES]
    why = "fewer than 8 samples" if limit is None else "fewer than 8 samples below the gyro's limit"
    left += [Window(window.start, window.end, why, window.score) for window in few]
    return Flights([window for window in used if window not in few], sorted(left, key=lambda one: one.start))


def check_windows(windows: list[Window], log: GyroLog) -> None:
    """Raise InvalidInput unless every window has a beginning before its end, and samples."""
    for window in windows:
        inside = _samples(log.times, window)
        if not window.start < window.end or inside < MIN_SAMPLES:
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
    """Return means over a few samples where samples come faster than a flight needs them."""
    step = float(np.median(np.diff(t)))
    fastest = float(np.quantile(np.abs(rates).max(axis=1), 0.999))
    many = int(min(FINE, FINE_TURN / max(fastest, 1e-9)) / step) if step > 0 else 1
    if many < 2 or len(t) // many < 2 * MIN_SAMPLES:
        return t, rates
    n = len(t) // many * many
    return t[:n].reshape(-1, many).mean(axis=1), rates[:n].reshape(-1, many, 3).mean(axis=1)


def _by_momentum(t: Array, rates: Array) -> tuple[list[Window], list[Window]]:
    stretches = momentum_stretches(t, rates, SHORTEST_TOLD)
    long = [one for one in stretches if t[one.last] - t[one.first] >= SHORTEST]
    used, others = of_one_body(t, rates, long)
    left = [_window(t, one, f"{MOMENTUM}, by another inertia than the rest") for one in others]
    short = [one for one in stretches if one not in long]
    left += [_window(t, one, f"{MOMENTUM}, for less than {SHORTEST} s") for one in short
             if of_one_body(t, rates, [*used, one])[1] == []]  # fmt: skip
    return [_window(t, one, MOMENTUM) for one in used], left


def _by_weight(log: GyroLog, t: Array, rates: Array) -> tuple[list[Window], list[Window]]:
    clock = log.acceleration_times
    assert clock is not None
    windows = [Window(float(clock[one.first]), float(clock[one.last]), WEIGHTLESS, one.felt)
             for one in weightless_stretches(log, SHORTEST_TOLD)]  # fmt: skip
    used = [_trim(t, rates, window) for window in windows if window.end - window.start >= SHORTEST]
    left = [Window(one.start, one.end, f"{WEIGHTLESS}, for less than {SHORTEST} s", one.score)
            for one in windows if one.end - one.start < SHORTEST]  # fmt: skip
    if not used:  # a device that turns on a bearing keeps a momentum too
        left += [Window(one.start, one.end, f"{MOMENTUM}, but the accelerometer feels weight", one.score)
                 for one in _by_momentum(t, rates)[0]]  # fmt: skip
    return used, left


def _trim(t: Array, rates: Array, window: Window) -> Window:
    """Return a window without ends at which a torque acts: a hand that carries no weight may still turn the device."""
    part = slice(int(np.searchsorted(t, window.start)), int(np.searchsorted(t, window.end, "right")))
    stretch = within(t[part], rates[part]) if part.stop - part.start >= MIN_SAMPLES else None
    if stretch is None or stretch.change > UNEVEN:
        return window
    start, end = float(t[part][stretch.first]), float(t[part][stretch.last])
    if start - window.start > MOST_TRIMMED or window.end - end > MOST_TRIMMED or end - start < SHORTEST:
        return window
    first, last = stretch.first == 0, stretch.last == part.stop - part.start - 1
    return Window(window.start if first else start, window.end if last else end, window.reason, window.score)


def _window(t: Array, one: Stretch, reason: str) -> Window:
    return Window(float(t[one.first]), float(t[one.last]), reason, one.change)
