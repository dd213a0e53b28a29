"""Precession described in full: which axis, in which frame, at what mean rate, and in which sense."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.exact.free_body import FreeMotion
from polhode.motion._inputs import finite


class Precession(NamedTuple):
    """A mean rate [rad/s], positive; relative to ``frame``; ``sense`` in words."""

    frame: str
    rate: float
    sense: str


@known_numbers_only
def body_precession(motion: FreeMotion) -> Precession | None:
    """Return how L circles the encircled axis in the body's own frame, at 2π/T.

    For a symmetric body the rate is |I3−I1| ω3/I1: with the spin if the body is oblate, against it if prolate; the
    same senses hold for short-axis and long-axis modes. None where L stays or never returns.
    """
    period = finite(motion.period)
    if period is None:
        return None
    against = motion.encircled_axis == int(np.argmin(np.asarray(motion.moments)))
    sense = "against the spin" if against else "with the spin"
    return Precession("body", 2.0 * math.pi / period, sense)


@known_numbers_only
def rotation_period(motion: FreeMotion) -> float | None:
    """Return the time of a turn [s] of one body that turns steadily about an axis fixed in it; None of others."""
    rate = float(np.linalg.norm(np.asarray(motion.momentum_at_epoch) / np.asarray(motion.moments)))
    return 2.0 * math.pi / rate if rate and motion.regime in ("permanent", "spherical") else None


@known_numbers_only
def turn_per_flip(motion: FreeMotion) -> float | None:
    """Return the mean turn [rad] of one body about L from one flip to the next; None where it does not flip again."""
    turn = finite(motion.precession_per_period)
    return None if turn is None or motion.flip_interval is None else 0.5 * turn


@known_numbers_only
def fastest_rate(motion: FreeMotion) -> float:
    """Return the fastest mean rate of one body's motion [rad/s]: about L, along the polhode, or of a steady turn."""
    periods = (finite(motion.period), rotation_period(motion))
    return max(float(motion.precession_rate or 0.0), *(2.0 * math.pi / (period or math.inf) for period in periods))


@known_numbers_only
def space_precession(motion: FreeMotion) -> Precession | None:
    """Return how the encircled axis turns about L in space; always along L. For a symmetric body the rate is |L|/I1."""
    if motion.precession_rate is None or motion.encircled_axis is None:
        return None
    return Precession("space", abs(float(motion.precession_rate)), "along the angular momentum")
