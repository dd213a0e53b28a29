"""Answers about many motions by steps at once: of one system, from starts that differ."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.kinds.ensembles import Ensemble, ManySpecs
from polhode.kinds.stepping import LIMITS as STEPPING
from polhode.kinds.stepping import Start
from polhode.motion._outcome import Status
from polhode.motion._trajectory import Trajectory
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Bool, Float64

STATES = "states."


class ManyMotionsLimits(NamedTuple):
    """A number that decides whether a sample is left to its own report.

    Attributes:
        largest: size of states and of angular velocities, in SI, and one over the smallest: products of three of them
            stay in the range of doubles, so that no report refuses what is within.
    """

    largest: float = 1e100


LIMITS = ManyMotionsLimits()


class ManyStarts(NamedTuple):
    """Motions by steps of one system that have not begun.

    Attributes:
        system: which moves.
        states: (sample, …) packed, at the first time.
        times: (T,) [s] of samples.
        doubtful: (sample,) which may be refused; their states mean nothing.
        view: makes of the trajectory what the kind's answers are taken from, such as a report on all at once.
        until: the last time as the spec gives it [s], or None.
        parts: how many of the times go to one that the spec gives.
        doubts: (sample,) which need their own reports after all, by the trajectory.
    """

    system: AbstractSystem
    states: Float64[Array, "sample ..."]
    times: Float64[Array, "time"]
    doubtful: Bool[Array, "sample"]
    view: Callable[[Trajectory], Any] = lambda trajectory: trajectory
    until: float | None = None
    parts: int = 1
    doubts: Callable[[Trajectory], Bool[Array, "sample"]] | None = None


Begin = Callable[[ManySpecs], ManyStarts | None]
AnswersOfMany = Mapping[str, Callable[[Any], Any]]
"""By the name of an answer, its values (sample, …) from what ``ManyStarts.view`` makes of the trajectory of a batch."""


def norms(vectors: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
    """Return lengths of vectors (…, 3), each with the bits that ``np.linalg.norm`` gives one alone."""
    return np.sqrt(np.vecdot(vectors, vectors))


def varies_start_alone(samples: ManySpecs, keys: Sequence[str] = ()) -> bool:
    """Whether samples differ by [spin], or by these keys, alone."""
    return all(key.startswith("spin.") or key in keys for key in samples.varied)


def finite_rows(states: Float64[Array, "sample state"]) -> Bool[Array, "sample"]:
    """Return which of many states are finite."""
    return np.asarray(np.isfinite(states).all(axis=-1))


def evaluate_motions(
    samples: ManySpecs, names: Sequence[str], times: Any, begin: Begin, answers: AnswersOfMany
) -> Ensemble | None:
    """Return answers as ``AbstractKind.ensemble`` does, those of each sample's report; None where some need reports.

    Samples that may be refused, that do not arrive, or have numbers that are not finite are left to their own reports.

    Args:
        samples: what differs between them.
        names: of the answers, and of parts of states.
        times: (T,) [s] of states.
        begin: returns the motions before they begin; None where the samples are not of one system.
        answers: those that the kind knows.
    """
    parts = [name for name in names if name.startswith(STATES)]
    wanted = [name for name in names if not name.startswith(STATES)]
    if not set(wanted) <= set(answers):
        return None
    count, values, alone = samples.size, dict[str, Any](), np.zeros(samples.size, bool)
    runs = [(samples, wanted)] if wanted else []
    runs += [(_sampled_at(samples, times), parts)] if parts else []
    for each, asked in runs:
        if (starts := begin(each)) is None:
            return None
        alone |= starts.doubtful
        for rows, trajectory in _follow(starts, alone):
            with np.errstate(all="ignore"):
                some = _take_parts(trajectory, asked, starts.parts) if asked is parts else (
                    _take_answers(starts.view(trajectory), asked, answers))
                alone[rows[~_are_within(trajectory)]] = True
                if starts.doubts is not None:
                    alone[rows[starts.doubts(trajectory)]] = True
            for name, found in some.items():
                if name not in values:
                    values[name] = np.zeros((count, *found.shape[1:]), object if found.dtype.kind == "U" else float)
                values[name][rows] = found
    values = {name: found.astype(str) if found.dtype == object else found for name, found in values.items()}
    return Ensemble(values, {}, alone=np.flatnonzero(alone).tolist(), by_steps=True)


def beyond_end(trajectory: Trajectory) -> Bool[Array, "sample time"] | None:
    """Return which samples of a batch come with or after the event that ended their copy; None where there are none."""
    ends = trajectory.ends
    if ends is None or not (np.asarray(ends.status) == Status.EVENT).any():
        return None
    return ends.beyond(np.asarray(trajectory.times))


def _sampled_at(samples: ManySpecs, times: Any) -> ManySpecs:
    instants = (0.0, *np.asarray(times, dtype=float).tolist())
    spec = replace(samples.spec, until=instants[-1], samples=len(instants), instants=instants)
    return samples._replace(spec=spec)


def _take_answers(view: Any, names: Sequence[str], answers: AnswersOfMany) -> dict[str, Array]:
    return {name: np.asarray(answers[name](view)) for name in names}


def _take_parts(trajectory: Trajectory, names: Sequence[str], every: int) -> dict[str, Array]:
    """Return parts of the states (sample, time, …) after the start, NaN where a copy has ended before."""
    layout, beyond, found = trajectory.layout, beyond_end(trajectory), {}
    for name in names:
        part = name.removeprefix(STATES)
        values = layout.part(trajectory.states, part) if part in layout.names else getattr(trajectory, part)
        values = np.array(values, dtype=float)
        if beyond is not None:
            values[beyond] = np.nan
        found[name] = values[:, every::every]
    return found


def _follow(starts: ManyStarts, alone: Bool[Array, "sample"]) -> Iterator[tuple[Array, Trajectory]]:
    """Yield rows of samples and their trajectories, in runs that have room; note in ``alone`` those that fail."""
    rows, states = np.flatnonzero(~alone), np.asarray(starts.states)
    size = max(1, int(STEPPING.max_numbers / (len(starts.times) * states[0].size)))
    waiting = [rows[k : k + size] for k in range(0, len(rows), size)]
    while waiting:
        some = waiting.pop(0)
        start = Start(starts.system, states[some], starts.times, _no_report, starts.until)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error", UserWarning)  # it may be of one copy, whose own report has it
                trajectory = start.follow()[0]
        except (InvalidInput, NotConverged, ArithmeticError, UserWarning):
            if len(some) == 1:
                alone[some] = True
            else:
                waiting = [some[: len(some) // 2], some[len(some) // 2 :], *waiting]
            continue
        yield some, trajectory


def _no_report(*_: Any) -> Any:
    raise AssertionError("motions of many samples have no reports")


def _are_within(trajectory: Trajectory) -> Bool[Array, "sample"]:
    """Whether the numbers of each copy are within the limits, those after its end left out."""
    within = np.ones(len(trajectory.states), bool)
    for values in (trajectory.states, trajectory.angular_velocity):
        if values is None:
            continue
        sizes = np.abs(np.asarray(values))
        if (beyond := beyond_end(trajectory)) is not None:
            sizes = np.where(beyond.reshape(*beyond.shape, *[1] * (sizes.ndim - 2)), 0.0, sizes)
        largest = sizes.max(axis=tuple(range(1, sizes.ndim)), initial=0.0)
        within &= (largest == 0.0) | ((largest <= LIMITS.largest) & (largest >= 1.0 / LIMITS.largest))
    return within
