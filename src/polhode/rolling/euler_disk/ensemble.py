"""Answers about many motions of one disk at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode.kinds.ensembles import Ensemble, ManySpecs, vary_table
from polhode.kinds.many_motions import ManyStarts, beyond_end, evaluate_motions, varies_start_alone
from polhode.motion._trajectory import Trajectory
from polhode.rolling.euler_disk._mechanics import LIMITS
from polhode.rolling.euler_disk.answers import TURNS, make_disks
from polhode.rolling.euler_disk.dissipation import slow_push
from polhode.rolling.euler_disk.system import LAYOUT, EulerDisk, rolling_parts
from polhode.rolling.euler_disk.table import EulerDiskTable
from polhode.rolling.euler_disk.turns import TURN
from polhode.simulation import simulate
from polhode.types import Array, Bool, Float64

OF_START = tuple(f"system.{key}" for key in ("tilt", "heading", "precession", "spin", "tilt_rate"))
OF_FORCE = ("normal_force_minimum", "normal_force_minimum_of_weight")  # of closer samples, too


@dataclass(frozen=True)
class RollingDisks:
    """Motions of one disk.

    Attributes:
        trajectory: of the batch.
        samples: that the spec asks for.
    """

    trajectory: Trajectory
    samples: int

    @property
    def disk(self) -> EulerDisk:
        assert isinstance(self.trajectory.source, EulerDisk)
        return self.trajectory.source

    @property
    def start(self) -> Float64[Array, "sample 8"]:
        return np.asarray(self.trajectory.states)[:, 0]

    @cached_property
    def beyond(self) -> Bool[Array, "sample time"]:
        """Which samples come after the end of their motion."""
        beyond = beyond_end(self.trajectory)
        return np.zeros(np.shape(self.trajectory.states)[:2], bool) if beyond is None else beyond

    @property
    def end_times(self) -> Float64[Array, "sample"]:
        """When each motion ends [s]."""
        assert self.trajectory.ends is not None, "a batch has ends"
        return np.asarray(self.trajectory.ends.time)

    @property
    def end(self) -> Float64[Array, "sample 8"]:
        """The states then."""
        assert self.trajectory.ends is not None, "a batch has ends"
        return np.asarray(self.trajectory.ends.state)

    @cached_property
    def first_turns_over(self) -> Any:
        """(sample,) number of the first sample after the turns that a report samples closely; −1 where none is."""
        headings = np.asarray(self.trajectory.part("heading"))
        past = np.abs(headings - headings[:, :1]) > TURN * TURNS
        past &= ~self.beyond
        return np.where(past.any(axis=-1), np.argmax(past, axis=-1), -1)

    @cached_property
    def lowest_force(self) -> Float64[Array, "sample"]:
        """The least normal force [N] of all samples, closer ones of the first turns included."""
        forces = np.asarray(self.disk.normal_force(np.asarray(self.trajectory.states)))
        lowest = np.minimum(np.where(self.beyond, np.inf, forces).min(axis=-1), self.disk.normal_force(self.end))
        over, times = self.first_turns_over, np.asarray(self.trajectory.times)
        for k in np.unique(over[over >= 0]):  # reports on these have the same closer times
            rows = np.flatnonzero(over == k)
            closer = np.linspace(0.0, float(times[k]), self.samples)
            path = simulate(self.disk, self.start[rows], closer)
            lowest[rows] = np.minimum(lowest[rows], np.asarray(self.disk.normal_force(path.states)).min(axis=-1))
        return lowest

    def need_closer_samples(self) -> Bool[Array, "sample"]:
        """Whether the report samples the motion again up to its end, which is sooner than half of the samples."""
        before = np.sum(~self.beyond, axis=-1)
        ended = self.beyond.any(axis=-1)
        turned = np.abs(LAYOUT.part(self.end, "heading") - LAYOUT.part(self.start, "heading")) > TURN * TURNS
        return ended & ((before + 1 <= self.samples // 2) | (turned & (self.first_turns_over < 0)))


def _of_start(name: str) -> Callable[[RollingDisks], Any]:
    return lambda disks: LAYOUT.part(disks.start, name)


NUMBERS: dict[str, Callable[[RollingDisks], Any]] = {
    **{f"start.{name}": _of_start(name) for name in ("tilt", "heading", "spin", "tilt_rate")},
    "start.precession": lambda disks: disks.disk.precession(disks.start),
    "start.face_rate": lambda disks: disks.disk.face_rate(disks.start),
    "start.angular_velocity": lambda disks: np.linalg.norm(np.stack(rolling_parts(disks.start)[1:], axis=-1), axis=-1),
    "start.energy": lambda disks: disks.disk.energy(disks.start),
    "start.normal_force": lambda disks: disks.disk.normal_force(disks.start),
    "end_time": lambda disks: disks.end_times,
    "turns": lambda disks: np.abs(LAYOUT.part(disks.end, "heading") - LAYOUT.part(disks.start, "heading")) / TURN,
    "end_energy": lambda disks: disks.disk.energy(disks.end),
    OF_FORCE[0]: lambda disks: disks.lowest_force,
    OF_FORCE[1]: lambda disks: disks.lowest_force / (float(disks.disk.mechanics.mass * disks.disk.mechanics.gravity)),
}


def evaluate_ensemble(samples: ManySpecs, names: Sequence[str], times: Any) -> Ensemble | None:
    """Return the answers as ``AbstractKind.ensemble`` does; None for answers that need a report on each."""
    forces = any(name in OF_FORCE for name in names)
    return evaluate_motions(samples, names, times, lambda some: _begin(some, forces), NUMBERS)


def _begin(samples: ManySpecs, forces: bool) -> ManyStarts | None:
    """Return the motions before they begin; None of samples that are not of one system."""
    spec, table, times = samples.spec, samples.spec.system, samples.spec.times
    if times is None or table.center_velocity is not None or not varies_start_alone(samples, OF_START):
        return None
    disk, _ = make_disks(table)
    states, doubtful = start_disks(disk, vary_table(table, "system", samples.varied, samples.size), samples.size)

    def doubts(trajectory: Trajectory) -> Bool[Array, "sample"]:
        return RollingDisks(trajectory, spec.samples).need_closer_samples()

    return ManyStarts(
        disk, states, times, doubtful, lambda trajectory: RollingDisks(trajectory, spec.samples), spec.until,
        doubts=doubts if forces else None,
    )


def start_disks(
    disk: EulerDisk, table: EulerDiskTable, count: int
) -> tuple[Float64[Array, "sample 8"], Bool[Array, "sample"]]:
    """Return the states of many disks at the start, their contacts at the origin, and which may be refused.

    Args:
        disk: with its dissipation.
        table: with arrays (sample,) in place of numbers that vary.
        count: of the disks.
    """
    each = lambda value: np.array(np.broadcast_to(value, count), dtype=float)  # noqa: E731
    theta, mechanics = each(table.tilt), disk.mechanics
    given: list[Any] = [None if rate is None else each(rate) for rate in (table.precession, table.spin)]
    with np.errstate(all="ignore"):
        if table.tilt_rate is None:
            precession, spin = mechanics.steady_rates(theta, *given)
            rise = precession * np.sin(theta)
            left = np.asarray(mechanics.tilt_acceleration(theta, rise, spin))
            size = float(mechanics.gravity) / float(mechanics.radius) + rise * rise + spin * spin
            doubtful = ~(np.abs(left) <= LIMITS.relative_tilt_acceleration * size)
            rate = np.zeros(count)
            if disk.dissipation:
                # two at least, as XLA compiles one alone with other last bits
                push, square = map(np.asarray, _slow_pushes(disk, *(np.resize(x, max(2, count)) for x in (
                    theta, rise, spin))))  # fmt: skip
                rate, doubtful = (push / square)[:count], doubtful | ~(square > 0.0)[:count]
        else:
            (precession, spin), rate = given, each(table.tilt_rate)  # with which both rates go
            rise, doubtful = precession * np.sin(theta), np.zeros(count, bool)
        zero = np.zeros(count)
        states = np.stack([theta, each(table.heading), zero, zero, zero, rate, rise, spin], axis=-1)
        doubtful |= ~np.isfinite(states).all(axis=-1)
        highest = math.pi if disk.is_thin else 0.5 * math.pi
        doubtful |= ~((np.sin(theta) > LIMITS.flat_sine) & (theta > 0.0) & (theta < highest))
        doubtful |= ~(np.asarray(disk.normal_force(states)) > 0.0)
    return states, doubtful


@jax.jit
def _slow_pushes(disk: EulerDisk, theta: Array, rise: Array, spin: Array) -> tuple[Array, Array]:
    """Return what ``slow_push`` does of each of many disks."""
    one = lambda *parts: slow_push(disk.mechanics, disk.dissipation, *parts)  # noqa: E731
    return jax.vmap(one)(jnp.asarray(theta), jnp.asarray(rise), jnp.asarray(spin))
