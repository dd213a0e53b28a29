"""Motions by steps: the report on one spec, and those on many, whose copies of one system are followed together."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.motion._trajectory import Trajectory
from polhode.reports.base import SystemReport
from polhode.reports.length import Watch
from polhode.simulation import simulate
from polhode.systems.base import AbstractSystem
from polhode.taylor.structure import take_structure
from polhode.types import Array, Double, Float64

if TYPE_CHECKING:
    from polhode.kinds.base import Spec


class SteppingLimits(NamedTuple):
    """A number that decides how many motions are followed together."""

    max_numbers: float = 2e7  # of samples kept at once: 160 MB


LIMITS = SteppingLimits()


class Start(NamedTuple):
    """A motion by steps that has not begun.

    Attributes:
        system: which moves.
        state: packed, at the first time.
        times: (T,) [s] of samples.
        report: makes the report of the trajectory and of warnings on the way.
        until: the last time as the spec gives it [s], or None.
        remedy: against a long run, besides a shorter time.
        options: of ``simulate``: a motion with any is followed alone.
        keeps_warnings: whether warnings on the way are for the report, not for the caller.
    """

    system: AbstractSystem
    state: Double[Array, "..."]
    times: Float64[Array, "time"]
    report: Callable[[Trajectory, tuple[str, ...]], SystemReport]
    until: float | None = None
    remedy: str = ""
    options: dict[str, Any] = {}  # noqa: RUF012
    keeps_warnings: bool = False

    def follow(self) -> tuple[Trajectory, tuple[str, ...]]:
        """Return the trajectory, and warnings on the way.

        Raises:
            InvalidInput, NotConverged: as ``simulate`` does.
        """
        watch = Watch(self.until, self.times, self.remedy)
        options = {name: value for name, value in self.options.items() if value is not None}
        if not self.keeps_warnings:
            return simulate(self.system, self.state, self.times, progress=watch, **options), ()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", UserWarning)
            trajectory = simulate(self.system, self.state, self.times, progress=watch, **options)
        return trajectory, tuple(str(warning.message) for warning in caught)

    def make_report(self) -> Any:
        """Return the report on the motion, followed alone.

        Raises:
            InvalidInput, NotConverged: as ``simulate`` does.
        """
        return self.report(*self.follow())

    @property
    def key(self) -> Any:
        """What motions have in common that are followed together; None for one that is followed alone."""
        if any(value is not None for value in self.options.values()):
            return None
        structure, numbers = take_structure(self.system)
        return structure, numbers.tobytes(), np.asarray(self.times).tobytes(), np.shape(self.state)


def report_on_each(
    specs: Sequence[Spec[Any]], begin: Callable[[Spec[Any]], Start]
) -> Iterator[SystemReport | InvalidInput | NotConverged]:
    """Yield the report on each of some specs, or why there is none; copies of one system are followed together.

    Each report says of its motion, to the last bit, what it says where the motion is followed alone.

    Args:
        specs: of one kind.
        begin: returns the motion of a spec.
    """
    starts: list[Start | InvalidInput | NotConverged] = []
    together: dict[Any, list[int]] = {}
    for k, spec in enumerate(specs):
        try:
            with spec.within_double_precision():
                start = begin(spec)
                key = start.key
            together.setdefault(k if key is None else key, []).append(k)
            starts.append(start)
        except (InvalidInput, NotConverged) as error:
            starts.append(error)
    blocks = {copies[0]: copies for copies in _blocks(starts, list(together.values()))}
    followed: dict[int, tuple[Trajectory, int]] = {}  # a batch is kept until its last copy is taken
    for k, spec in enumerate(specs):
        start = starts[k]
        if not isinstance(start, Start):
            yield start
            continue
        if k in blocks:
            followed |= _follow_together(starts, blocks[k])
        try:
            with spec.within_double_precision():
                yield start.report(copy_of(*followed.pop(k)), ()) if k in followed else start.make_report()
        except (InvalidInput, NotConverged) as error:
            yield error


def _blocks(starts: Sequence[Any], groups: Sequence[list[int]]) -> Iterator[list[int]]:
    """Yield the copies of one system that are followed in one run.

    A run is made when the report on its first copy is due, and kept up to its last. So only groups that overlap have
    runs at once, and share the room.
    """
    groups = [copies for copies in groups if len(copies) > 1]
    for copies in groups:
        overlapping = sum(other[0] <= copies[-1] and copies[0] <= other[-1] for other in groups)
        first = starts[copies[0]]
        size = max(1, int(LIMITS.max_numbers / overlapping / (len(first.times) * np.size(first.state))))
        for begin in range(0, len(copies), size):
            if len(some := copies[begin : begin + size]) > 1:
                yield some


def _follow_together(starts: Sequence[Any], copies: list[int]) -> dict[int, tuple[Trajectory, int]]:
    """Return the batch and the row of copies of one system; none where a warning or an error may be of one of them."""
    states = np.stack([np.asarray(starts[k].state) for k in copies])
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            trajectory, warned = starts[copies[0]]._replace(state=states).follow()
    except (InvalidInput, NotConverged, ArithmeticError):
        return {}
    return {} if warned or caught else {k: (trajectory, row) for row, k in enumerate(copies)}


def copy_of(trajectory: Trajectory, k: int) -> Trajectory:
    """Return one copy of a batch along one axis, in arrays of its own, as a view would keep the batch."""

    def one(values: Any) -> Any:
        return None if values is None else np.asarray(values)[k].copy()

    each = {name: {key: one(value) for key, value in getattr(trajectory, name).items()}
            for name in ("invariants", "balances", "received", "drift", "observed")}  # fmt: skip
    arrays = {name: one(getattr(trajectory, name))
              for name in ("states", "attitude", "momentum", "angular_velocity", "error_estimate")}  # fmt: skip
    plan = None if trajectory.plan is None else replace(trajectory.plan, copies=1)
    return replace(trajectory, **each, **arrays, plan=plan, ends=None)
