"""Answers about many motions of one heavy top at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from polhode.analysis.top_motion import axis_in_space, axis_tilt
from polhode.analysis.top_rates import mean_top_rates
from polhode.kinds.ensembles import Ensemble, ManySpecs
from polhode.kinds.heavy_top.answers import pack_start, rename_invariants
from polhode.kinds.many_motions import ManyStarts, evaluate_motions, varies_start_alone
from polhode.kinds.many_tops import start_together
from polhode.motion._trajectory import Trajectory
from polhode.reports.top_starts import build_top
from polhode.systems.heavy_top import HeavyTop


def _tilts(trajectory: Trajectory) -> Any:
    return axis_tilt(_top(trajectory), trajectory.attitude)


def _top(trajectory: Trajectory) -> HeavyTop:
    assert isinstance(trajectory.source, HeavyTop)
    return trajectory.source


def _mean_rates(trajectory: Trajectory, name: str) -> Any:
    """Return a mean rate of each motion, NaN where there is none."""
    axes = axis_in_space(_top(trajectory), trajectory.attitude)
    rates = [getattr(mean_top_rates(trajectory.times, axis), name) for axis in axes]
    return np.array([np.nan if rate is None else rate for rate in rates])


def _invariant(name: str) -> Callable[[Trajectory], Any]:
    return lambda trajectory: np.asarray(rename_invariants(trajectory).invariants[name])[:, 0]


def _constant(trajectory: Trajectory, value: Any) -> Any:
    return np.broadcast_to(np.asarray(value), (len(trajectory.states), *np.shape(value)))


NUMBERS: dict[str, Callable[[Trajectory], Any]] = {
    "principal_moments": lambda trajectory: _constant(trajectory, _top(trajectory).moments),
    "mgl": lambda trajectory: _constant(trajectory, _top(trajectory).mgl),
    "tilt.smallest": lambda trajectory: _tilts(trajectory).min(axis=-1),
    "tilt.largest": lambda trajectory: _tilts(trajectory).max(axis=-1),
    **{f"invariants.{name}": _invariant(name) for name in ("energy", "|Γ|²", "vertical_momentum")},
    "rates.motion.precession": lambda trajectory: _mean_rates(trajectory, "precession"),
    "rates.motion.nutation": lambda trajectory: _mean_rates(trajectory, "nutation"),
}


def evaluate_ensemble(samples: ManySpecs, names: Sequence[str], times: Any) -> Ensemble | None:
    """Return the answers as ``AbstractKind.ensemble`` does; None for answers that need a report on each."""
    return evaluate_motions(samples, names, times, _begin, NUMBERS)


def _begin(samples: ManySpecs) -> ManyStarts | None:
    """Return the motions before they begin; None of samples that are not of one system."""
    spec, table, body, times = samples.spec, samples.spec.system, samples.spec.body, samples.spec.times
    by_given_steps = table.step is not None or table.order is not None
    if times is None or by_given_steps or not varies_start_alone(samples, ("system.lean",)):
        return None
    assert body is not None
    top = build_top(body, table.pivot, table.gravity)
    if float(top.mgl) == 0.0:
        return None
    starts = start_together(samples, top)
    momentum, attitude = (np.array(part) for part in (starts.momentum, starts.attitude))
    momentum[starts.doubtful], attitude[starts.doubtful] = 0.0, [1.0, 0.0, 0.0, 0.0]
    return ManyStarts(top, pack_start(momentum, attitude), times, starts.doubtful, until=spec.until)
