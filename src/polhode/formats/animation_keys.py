"""Times and attitudes of an animation's keys: close enough to interpolate, distinct in single precision."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion
from polhode.types import Array, Float64

FINE = math.pi / 16.0  # rad from key to key where an exact motion is evaluated again


class KeyLimits(NamedTuple):
    """Numbers that decide how an animation is sampled."""

    max_turn: float = 0.5 * math.pi  # rad between keys; beyond π viewers, which take the short way, would turn backward
    max_keys: int = 1_000_000  # more than viewers bear
    # rad from the motion's own first attitude; a larger one means that the trajectory is along other axes
    max_attitude_difference: float = 1e-9


LIMITS = KeyLimits()


def make_keys(
    trajectory: Trajectory, speed: float, rate: float | None = None
) -> tuple[Float64[Array, "keys"], Trajectory]:
    """Return the clock (K,) [s] of an animation, as single precision has it, and the trajectory at its keys.

    Exact motions are evaluated again at just these times, finer than they were sampled if necessary; of other samples
    the clock is rounded, and those at equal rounded times are left out.

    Args:
        trajectory: of one body, with attitude.
        speed: seconds of motion in a second of the animation.
        rate: keys per second of the animation, for exact motions.

    Raises:
        InvalidInput: for times that do not increase, keys too far apart or too many, and a rate for a motion that is
            not exact.
    """
    times = np.asarray(trajectory.times, dtype=float)
    if not (np.diff(times) > 0).all():
        raise InvalidInput("an animation needs times that increase; these do not. Sort them, each once.")
    motion = exact_motion(trajectory)
    lasts = float(times[-1] - times[0]) / speed
    clock = (times - times[0]) / speed
    if rate is not None:
        if motion is None:
            raise InvalidInput("`rate` is for exact motions; samples are keys themselves. Leave it out.")
        clock = _evenly(lasts, lasts * rate)
    elif motion is not None and farthest_turn(trajectory) >= LIMITS.max_turn:
        fastest = float(np.linalg.norm(np.asarray(trajectory.angular_velocity), axis=-1).max())
        clock = _evenly(lasts, fastest * lasts * speed / FINE)
    clock, kept = np.unique(clock.astype(np.float32), return_index=True)
    clock = clock.astype(float)
    keyed = trajectory.select(kept) if motion is None else trajectory.resample(times[0] + speed * clock)
    if (farthest := farthest_turn(keyed)) >= LIMITS.max_turn:
        raise InvalidInput(
            f"the keys of the animation are too far apart: {farthest:.3g} rad from one to the next, where less than "
            f"{LIMITS.max_turn:.3g} leaves no doubt which way it turns. Take more samples or a shorter time (`until` "
            "in a spec); of exact motions a higher rate."
        )
    return clock, keyed


def farthest_turn(trajectory: Trajectory) -> float:
    """Return the largest angle [rad] from one sample to the next, by the rates at both where there are any."""
    times, attitude = np.asarray(trajectory.times), np.asarray(trajectory.attitude)
    if len(times) < 2:
        return 0.0
    if trajectory.angular_velocity is None:
        return float(np.max(rotation.angle_between(attitude[1:], attitude[:-1])))
    rates = np.linalg.norm(np.asarray(trajectory.angular_velocity), axis=-1)
    return float((np.maximum(rates[1:], rates[:-1]) * np.diff(times)).max())


def _evenly(lasts: float, intervals: float) -> Array:
    if intervals >= LIMITS.max_keys:
        raise InvalidInput(f"an animation of {intervals:.3g} keys is more than the {LIMITS.max_keys} that viewers "
                           "bear. Take a shorter time, or a lower rate.")
    return np.linspace(0.0, lasts, math.ceil(intervals) + 1)


def exact_motion(trajectory: Trajectory) -> AbstractMotion | None:
    """Return the motion to evaluate again, unless the trajectory is along other axes than its motion's."""
    motion = trajectory.motion
    if motion is None:
        return None
    again = np.asarray(motion.sample(np.asarray(trajectory.times)[:1]).attitude)
    first = np.asarray(trajectory.attitude)[:1]
    if again.shape != first.shape:
        return None
    return motion if float(rotation.angle_between(again, first)[0]) <= LIMITS.max_attitude_difference else None
