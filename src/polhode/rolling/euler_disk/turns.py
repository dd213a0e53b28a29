"""The turns of a rolling disk's contact, sampled densely: the first of a motion, and the last before its end."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._adaptive import solve_adaptively
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.rolling.euler_disk.spin_down import FALL_SAMPLES
from polhode.rolling.euler_disk.system import LAYOUT, EulerDisk
from polhode.simulation import simulate
from polhode.types import Array, ArrayLike, Float64, Real

TURN = 2.0 * math.pi


class DiskPath(NamedTuple):
    """Part of a rolling disk's motion.

    Attributes:
        times: (T,) [s].
        states: (T, 8), as of ``EulerDisk``.
        outcome: of the motion.
    """

    times: Float64[Array, "time"]
    states: Float64[Array, "time 8"]
    outcome: Outcome

    def part(self, name: str) -> Float64[Array, "time"]:
        """Return a part of the states by name."""
        return LAYOUT.part(self.states, name)

    @property
    def contact(self) -> Float64[Array, "time 2"]:
        """The point of contact [m]."""
        return np.stack([self.part("contact_x"), self.part("contact_y")], axis=-1)


@known_numbers_only
def first_turns(trajectory: Trajectory, turns: float, samples: int) -> DiskPath:
    """Return the first turns of the contact, sampled again, or the whole motion where it has no more.

    Args:
        trajectory: of one disk, from ``simulate``.
        turns: of the contact.
        samples: at least two.
    """
    disk = _take_disk(trajectory)
    heading = np.asarray(trajectory.part("heading"))
    beyond = np.flatnonzero(np.abs(heading - heading[0]) > TURN * turns)
    if len(beyond):
        times = np.linspace(0.0, float(trajectory.times[beyond[0]]), samples)
        trajectory = simulate(disk, trajectory.states[0], times)
    return DiskPath(np.asarray(trajectory.times), np.asarray(trajectory.states), trajectory.outcome)


@known_numbers_only
def last_turns(trajectory: Trajectory, turns: float, samples: int) -> DiskPath:
    """Return the last turns of the contact up to the event that ends the motion; arguments as of ``first_turns``."""
    far_apart = 4.0  # times the turns asked for: samples of a motion with no end in sight are far apart
    past_end = 1.1  # of the time to the end, so that its event occurs again
    disk = _take_disk(trajectory)
    heading, times = np.asarray(trajectory.part("heading")), np.asarray(trajectory.times)
    before = np.flatnonzero(np.abs(heading[-1] - heading) >= TURN * turns)
    k = int(before[-1]) if len(before) else 0
    span = past_end * float(times[-1] - times[k])
    counted = abs(float(heading[-1] - heading[k])) / TURN
    if counted > far_apart * turns:
        span *= turns / counted
    return rolling_path(disk, trajectory.states[k], span, samples, float(times[k]))


@known_numbers_only
def rolling_path(
    disk: EulerDisk, state: Real[ArrayLike, "8"], span: float, samples: int, since: float = 0.0
) -> DiskPath:
    """Return equally spaced samples up to the event that ends a motion, or over a span.

    They come in pieces of the size that ``spin_down`` has compiled already.

    Args:
        disk: any.
        state: (8,) to start from.
        span: of time [s], positive.
        samples: about how many over the span; not fewer than of one piece.
        since: time of the start [s].

    Raises:
        InvalidInput: for a span that is not positive and finite.
        NotConverged: where no step is short enough.
    """
    span = check.number("span", span, "s", above=0)
    piece = FALL_SAMPLES - 1
    step = span / max(samples - 1, piece)
    ticks, times, states = step * np.arange(FALL_SAMPLES), [np.array([since])], [np.asarray(state)[None]]
    outcome = Outcome(Ending.COMPLETED)
    for k in range(math.ceil(max(samples - 1, piece) / piece)):
        motion = solve_adaptively(disk, diffrax.Dopri8(), jnp.asarray(states[-1][-1]), ticks)
        times.append(since + k * piece * step + motion.times[1:])
        states.append(np.asarray(motion.states)[1:])
        if not motion.successful:
            at = times[-1][-1] if len(times[-1]) else since
            raise NotConverged(f"the disk cannot be followed past {at:.6g} s. Ask for a shorter span.")
        if motion.event is not None:
            outcome = Outcome(Ending.EVENT, motion.event)
            break
    return DiskPath(np.concatenate(times), np.concatenate(states), outcome)


@known_numbers_only
def resample_until_end(trajectory: Trajectory, samples: int) -> Trajectory:
    """Return a disk's motion, simulated again if it ended in the first half of its samples, so that all precede it.

    Args:
        trajectory: of one disk, from ``simulate``.
        samples: that were asked for.
    """
    past_end = 1.0 + 1e-9  # of the time to the end, so that its event occurs again, as the last of many samples
    if trajectory.outcome.event is None or len(trajectory.times) > samples // 2:
        return trajectory
    first, last = float(trajectory.times[0]), float(trajectory.times[-1])
    times = np.linspace(first, first + past_end * (last - first), samples)
    return replace(simulate(_take_disk(trajectory), trajectory.states[0], times), frame=trajectory.frame)


def _take_disk(trajectory: Trajectory) -> EulerDisk:
    if not isinstance(trajectory.source, EulerDisk) or trajectory.batch_shape:
        raise InvalidInput(
            f"`trajectory` must be of one EulerDisk; got one of {shown(trajectory.source)}, batch of shape "
            f"{trajectory.batch_shape}. Simulate a disk."
        )
    return trajectory.source
