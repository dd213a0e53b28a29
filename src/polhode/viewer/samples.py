"""The samples on a page: few enough to be fast, close enough to interpolate where possible."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput
from polhode.motion._layout import StateLayout
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion
from polhode.reports.wording import unit_in_words
from polhode.types import Array, Double, Float64

JOINED = 0.5 * np.pi  # rad up to which the motion between two samples is clear


class SampleLimits(NamedTuple):
    """Numbers that decide at which times a page shows a motion."""

    max_samples: int = 4000  # about 0.4 MB
    fine_turn: float = 0.05  # rad from sample to sample, wanted of exact motions
    max_turn: float = 0.25  # rad from sample to sample of exact motions; of longer ones only the beginning is shown


LIMITS = SampleLimits()


@dataclass(frozen=True, eq=False)
class Samples:
    """One body's motion as a page shows it, along the principal axes where they are known.

    Attributes:
        times: (T,) [s], ascending.
        states: (T, n), as the system packs them.
        attitude: (T, 4) wxyz, or None.
        momentum: (T, 3) [kg m²/s], or None.
        angular_velocity: (T, 3) [rad/s], or None.
        energy: (T,), or None, called ``energy_name`` [``energy_unit``].
        joined: whether the motion between samples is clear, so that they may be joined by lines.
        notes: sentences on this choice for the page.
    """

    times: Float64[Array, "time"]
    states: Double[Array, "time ..."]
    attitude: Float64[Array, "time 4"] | None
    momentum: Float64[Array, "time 3"] | None
    angular_velocity: Float64[Array, "time 3"] | None
    energy: Float64[Array, "time"] | None
    energy_name: str = "energy"
    energy_unit: str = "J"
    joined: bool = True
    notes: tuple[str, ...] = field(default=())


def take_samples(trajectory: Trajectory) -> Samples:
    """Return the samples for a page: exact motions evaluated at times close enough to each other, others thinned.

    Raises:
        InvalidInput: for a trajectory without samples, a batch, or values that are not finite.
    """
    _check(trajectory)
    trajectory = trajectory.along("principal")
    if trajectory.motion is not None:
        return _evaluate(trajectory, trajectory.motion)
    return _thin(trajectory)


def _check(trajectory: Trajectory) -> None:
    if not np.size(trajectory.times):
        raise InvalidInput("the page needs at least one sample; the trajectory is empty. Give it times.")
    if trajectory.batch_shape:
        raise InvalidInput(
            f"the page shows one body; got a batch of shape {trajectory.batch_shape}. Make a trajectory of one of them."
        )
    for name in ("times", "states", "attitude", "momentum", "angular_velocity"):
        values = getattr(trajectory, name)
        if values is not None and not np.isfinite(np.asarray(values)).all():
            raise InvalidInput(f"the page shows finite motions; `{name}` of the trajectory has NaN or infinity in it.")


def _evaluate(trajectory: Trajectory, motion: AbstractMotion) -> Samples:
    """Return an exact motion at fine steps, its first part where it has too many turns."""
    times = np.asarray(trajectory.times, dtype=float)
    start, end = float(times.min()), float(times.max())
    velocity = np.asarray(trajectory.angular_velocity)
    fastest = float(np.linalg.norm(velocity, axis=-1).max())
    turn = fastest * (end - start)
    notes, shown = [], end
    if len(times) == 1 or not turn < np.inf:
        return replace(_thin(trajectory), joined=False)
    if turn > LIMITS.max_turn * (LIMITS.max_samples - 1):
        shown = start + (end - start) * LIMITS.max_turn * (LIMITS.max_samples - 1) / turn
        notes.append(f"Shown: the first {LIMITS.max_turn * (LIMITS.max_samples - 1) / (2 * np.pi):.0f} turns, "
                     f"{shown - start:.4g} s of {end - start:.4g} s.")
    fine = np.ceil(min(turn, LIMITS.max_turn * LIMITS.max_samples) / LIMITS.fine_turn) + 1
    count = int(np.clip(fine, min(len(times), LIMITS.max_samples), LIMITS.max_samples))
    if len(times) > LIMITS.max_samples:
        notes.append(f"Evaluated at {count} times for display; the trajectory has {len(times)} samples.")
    again = motion.sample(np.linspace(start, shown, count))
    return replace(_plain(again), joined=True, notes=tuple(notes))


def _thin(trajectory: Trajectory) -> Samples:
    """Return every k-th sample."""
    samples = _plain(trajectory)
    count = len(samples.times)
    notes = []
    if count > LIMITS.max_samples:
        step = -(-count // LIMITS.max_samples)
        samples = _take(samples, slice(None, None, step))
        notes.append(f"Thinned for display: every {_ordinal(step)} of {count} samples.")
    joined = _largest_turn(trajectory.layout, samples) <= JOINED
    if not joined:
        points = "" if samples.attitude is None and samples.momentum is None else ", and samples are drawn as points"
        notes.append("From sample to sample the body turns too far for the motion between to be shown: "
                     f"it jumps{points}.")
    return replace(samples, joined=joined, notes=tuple(notes))


def _plain(trajectory: Trajectory) -> Samples:
    values = trajectory.invariants | trajectory.balances
    name = next((key for key in values if "energy" in key), None)
    unit = "J" if name is None else unit_in_words(trajectory.quantity(name).unit)

    def array(values: Array | None) -> Array | None:
        return None if values is None else np.asarray(values, dtype=float)

    samples = Samples(
        np.asarray(trajectory.times, dtype=float), np.asarray(trajectory.states),
        array(trajectory.attitude), array(trajectory.momentum), array(trajectory.angular_velocity),
        None if name is None else array(values[name]), (name or "energy").replace("_", " "), unit,
    )
    return _take(samples, slice(None, None, -1)) if samples.times[-1] < samples.times[0] else samples


def _take(samples: Samples, rows: slice) -> Samples:
    names = ("times", "states", "attitude", "momentum", "angular_velocity", "energy")
    return replace(samples, **{name: None if getattr(samples, name) is None else getattr(samples, name)[rows]
                             for name in names})


def _largest_turn(layout: StateLayout, samples: Samples) -> float:
    """Return the largest change [rad] of an angle of the state, or else of the attitude, from sample to sample."""
    steps = np.diff(samples.times)
    if angles := [name for name, part in layout.scalars.items() if part.unit == "rad"]:
        return max(float(np.abs(np.diff(layout.part(samples.states, name))).max(initial=0.0)) for name in angles)
    if samples.angular_velocity is not None:
        rate = np.linalg.norm(samples.angular_velocity, axis=-1)
        return float(np.max(np.maximum(rate[1:], rate[:-1]) * steps, initial=0.0))
    if samples.attitude is not None:
        along = np.abs(np.sum(samples.attitude[1:] * samples.attitude[:-1], axis=-1))
        return float(np.max(2.0 * np.arccos(np.clip(along, 0.0, 1.0)), initial=0.0))
    return 0.0


def _ordinal(number: int) -> str:
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th") if number // 10 % 10 != 1 else "th"
    return f"{number}{ending}"
