"""How long a run will take: said beforehand where it is long, refused where it would be far too long."""

from __future__ import annotations

import sys

import numpy as np

from polhode.errors import InvalidInput
from polhode.integrators.composition import stages
from polhode.solving import step_angle
from polhode.types import Array, Float64

LONGEST = 600.0  # s that a run may take by these estimates
SAID_FROM = 5.0  # s from which it is said
# s a step, with the runs that tell its error: at order 6, 8 to 17 µs were measured, of Dopri8 50 to 60 µs
SPLITTING, ADAPTIVE = 2e-5, 6e-5
TURNING = 2.0  # steps of Dopri8 to a radian of steady rotation, at its tolerance: 2.1 was measured
ORBITING = 7.0  # the same of mean anomaly, for a spin near an orbit's rate: 7.4 was measured at e = 0.1
HIGHEST = 8  # order of splitting; Taylor series take as many steps or fewer, and each is quicker
PIECES = 8  # of a long step cost about as much as a step: each of its nine stages has one at least
UNCOUNTED = 1e15  # steps, beyond which nobody needs to know how many
DURATIONS = ((60.0, "s"), (60.0, "min"), (24.0, "h"), (365.25, "days"))


def check_length(
    until: float | None, times: Float64[Array, "time"], steps: float, each: float, remedy: str = ""
) -> bool:
    """Say on standard error how long a run will take where that is long.

    Args:
        until: its end as the spec gives it [s], None where it leaves it out.
        times: (T,) [s]; there is a step to each at least.
        steps: about how many there will be.
        each: how long one takes [s].
        remedy: what helps, other than a shorter time.

    Returns:
        Whether to show progress: the run is long, and somebody watches.

    Raises:
        InvalidInput: for a run that would take far too long.
    """
    steps, span = max(steps, float(len(times))), float(np.ptp(times))
    seconds = steps * each
    if not seconds <= LONGEST:
        which = "" if until is not None else ", the usual one,"
        other = f" {remedy}" if remedy else ""
        more = "about" if steps < UNCOUNTED else "more than"
        steps = steps if steps < UNCOUNTED else UNCOUNTED  # numbers of steps that overflow too
        raise InvalidInput(
            f"`time.until` of {span:g} s{which} would take {more} {steps:.1e} steps, {more} {duration(steps * each)}; "
            f"at most {LONGEST / each:.0e} steps are taken here, some ten minutes. Check the units, or give a shorter "
            f"`until` under [time].{other}"
        )
    if seconds > SAID_FROM:
        sys.stderr.write(f"polhode: about {steps:.1e} steps, up to {duration(seconds)}. Ctrl-C ends it.\n")
        sys.stderr.flush()
    return seconds > SAID_FROM and sys.stderr.isatty()


def equal_steps(span: float, rate: float, step: float | None, order: int = HIGHEST) -> float:
    """Return about how many equal steps a run takes; longer steps are taken in pieces that bound what they turn.

    Args:
        span: of the run [s].
        rate: of the fastest rotation [rad/s].
        step: that is asked for [s], None for the usual one.
        order: of the method.
    """
    usual = span * rate / step_angle(order)
    return usual if step is None else max(span / step, usual / PIECES)


def splitting_step(order: int) -> float:
    """Return how long a step of splitting takes [s]: each stage as long as those of order 6."""
    return SPLITTING * len(stages(order)) / len(stages(6))


def duration(seconds: float) -> str:
    """Return a duration in the unit that fits it.

    >>> duration(40.0), duration(1234.0), duration(4e9)
    ('40 s', '21 min', '130 years')
    """
    for size, unit in DURATIONS:
        if seconds < 2.0 * size:
            return f"{_rounded(seconds)} {unit}"
        seconds /= size
    return f"{_rounded(seconds)} years"


def _rounded(value: float) -> str:
    """Return two digits of a number, written out up to a million."""
    return f"{float(f'{value:.2g}'):,.0f}" if 100.0 <= value < 1e6 else f"{value:.2g}"
