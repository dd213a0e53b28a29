"""Predicts how long a run will take; long runs are announced, and far too long ones refused."""

from __future__ import annotations

import sys
import time
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput
from polhode.integrators import _diffrax as diffrax
from polhode.types import Array, Float64

RUNS = 5.0  # time of a run and of those that estimate its error, over that of the run alone: 3.5 to 5.5 were measured
RUNS_BY_EQUAL_STEPS = 2.5  # likewise for equal steps: the runs for the error take steps twice as long
FEWER = "Check the units, or give a shorter `until` under [time]."


class LengthLimits(NamedTuple):
    """Numbers that decide whether a run is announced as long, or ended."""

    max_seconds: float = 600.0  # that a run may take by these estimates
    long_seconds: float = 5.0  # from which a run is announced
    watched_seconds: float = 0.5  # after which a run's speed is measured
    patience_seconds: float = 10.0  # after which no announced run is ended any more
    compiling_seconds: float = 1.0  # a longer part of a run is assumed to include compiling
    max_compilings: int = 2  # in one run
    max_steps_counted: float = 1e15  # beyond which nobody needs the number


LIMITS = LengthLimits()


class Watch:
    """A meter for ``simulate`` that measures a run's speed, announces its length, and ends one that is endless.

    A run may become slower or faster, so the longer it has been watched, the less it must exceed the limit to be ended.

    Args:
        until: end of the run as the spec gives it [s], None where it leaves it out.
        times: (T,) [s] of its samples.
        remedy: one besides a shorter time.
        runs: time of the run and of the further runs that estimate its error, over that of the run alone.
    """

    def __init__(
        self, until: float | None, times: Float64[Array, "time"], remedy: str = "", runs: float = RUNS
    ) -> None:
        which = "" if until is not None else ", the usual one,"
        self._named, self._remedy = f"`time.until` of {float(np.ptp(times)):g} s{which}", remedy and f" {remedy}"
        self._begun: tuple[float, float] | None = None
        self._runs = runs
        self._said, self._latest, self._compiled = False, 0.0, 0
        self._bar: Any = None  # of diffrax, once it is known that the run is long

    def init(self) -> Any:
        """Begin, before a run."""
        self._begun = None
        return self._bar and self._bar.init()

    def step(self, shown: Any, share: Any) -> Any:
        """Check a run of which a share is done.

        Raises:
            InvalidInput: where it would take far too long.
        """
        now, share = time.process_time(), float(share)
        # time for tracing and compiling does not predict that of the steps
        slow = self._begun is not None and now - self._latest > LIMITS.compiling_seconds
        compiled = slow and self._compiled < LIMITS.max_compilings
        self._compiled, self._latest = self._compiled + compiled, now
        if self._begun is None or compiled:
            self._begun = now, share
        elapsed, done = now - self._begun[0], share - self._begun[1]
        if elapsed >= LIMITS.watched_seconds and not (self._said and elapsed > LIMITS.patience_seconds):
            seconds = self._runs * elapsed * (1.0 - self._begun[1]) / max(done, 1.0 / LIMITS.max_steps_counted)
            if seconds * min(elapsed, LIMITS.patience_seconds) > LIMITS.max_seconds * LIMITS.patience_seconds:
                raise InvalidInput(
                    f"{self._named} would take about {duration(seconds)}; at most some ten minutes are taken here. "
                    f"{FEWER}{self._remedy}"
                )
            # a run that may yet be refused is not announced, as the two lines would contradict each other
            if LIMITS.long_seconds < seconds <= LIMITS.max_seconds and not self._said:
                shown = self._say(seconds)
        return self._bar and self._bar.step(shown, jnp.asarray(share))

    def close(self, shown: Any) -> None:
        """End the progress bar, after the run."""
        if self._bar:
            self._bar.close(shown)

    def _say(self, seconds: float) -> Any:
        self._said = True
        _say(f"this takes about {duration(seconds)}")
        if sys.stderr.isatty():
            self._bar = diffrax.TqdmProgressMeter()
        return self._bar and self._bar.init()


def check_length(
    until: float | None, times: Float64[Array, "time"], steps: float, each: float, remedy: str = ""
) -> bool:
    """Announce on standard error the length of a long run.

    Args:
        until: its end as the spec gives it [s], None where it leaves it out.
        times: (T,) [s]; there is a step to each at least.
        steps: about how many there will be.
        each: how long one takes [s].
        remedy: one besides a shorter time.

    Returns:
        Whether to show progress: the run is long, and standard error is a terminal.

    Raises:
        InvalidInput: for a run that would take far too long.
    """
    steps, span = max(steps, float(len(times))), float(np.ptp(times))
    seconds = steps * each
    if not seconds <= LIMITS.max_seconds:
        which = "" if until is not None else ", the usual one,"
        other = f" {remedy}" if remedy else ""
        more = "about" if steps < LIMITS.max_steps_counted else "more than"
        # numbers of steps that overflow too
        steps = steps if steps < LIMITS.max_steps_counted else LIMITS.max_steps_counted
        raise InvalidInput(
            f"`time.until` of {span:g} s{which} would take {more} {steps:.1e} steps, {more} {duration(steps * each)}; "
            f"at most {LIMITS.max_seconds / each:.0e} steps are taken here, some ten minutes. {FEWER}{other}"
        )
    if seconds > LIMITS.long_seconds:
        _say(f"about {steps:.1e} steps, up to {duration(seconds)}")
    return seconds > LIMITS.long_seconds and sys.stderr.isatty()


def duration(seconds: float) -> str:
    """Return a duration in the unit that fits it.

    >>> duration(40.0), duration(1234.0), duration(4e9)
    ('40 s', '21 min', '130 years')
    """
    units = ((60.0, "s"), (60.0, "min"), (24.0, "h"), (365.25, "days"))
    for size, unit in units:
        if seconds < 2.0 * size:
            return f"{_round(seconds)} {unit}"
        seconds /= size
    return f"{_round(seconds)} years"


def _round(value: float) -> str:
    """Return two digits of a number, written out up to a million."""
    return f"{float(f'{value:.2g}'):,.0f}" if 100.0 <= value < 1e6 else f"{value:.2g}"


def _say(what: str) -> None:
    sys.stderr.write(f"polhode: {what}. Ctrl-C ends it.\n")
    sys.stderr.flush()
