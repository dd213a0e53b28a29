"""Answers about many motions of one gyrostat at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from polhode.kinds.ensembles import Ensemble, ManySpecs, vary_table
from polhode.kinds.gyrostat.answers import GyrostatReport
from polhode.kinds.gyrostat.build import build, make_system, pack_start
from polhode.kinds.many_motions import ManyStarts, evaluate_motions, finite_rows, norms, varies_start_alone


def _leans(report: GyrostatReport) -> Any:
    """Return the angles of the rotor's axis to L (sample, time), NaN of samples without momentum."""
    still = ~np.any(np.asarray(report.trajectory.momentum)[:, 0], axis=-1)
    return np.where(still[:, None], np.nan, report.axis_to_momentum)


NUMBERS: dict[str, Callable[[GyrostatReport], Any]] = {
    "momentum": lambda report: np.asarray(report.trajectory.momentum)[:, 0],
    "momentum_norm": lambda report: norms(np.asarray(report.trajectory.momentum)[:, 0]),
    "energy": lambda report: report.energy[:, 0],
    "angular_velocity": lambda report: np.asarray(report.trajectory.angular_velocity)[:, 0],
    "rotor_axis_to_momentum.smallest": lambda report: _leans(report).min(axis=-1),
    "rotor_axis_to_momentum.largest": lambda report: _leans(report).max(axis=-1),
    "final.time": lambda report: np.full(len(report.trajectory.states), report.trajectory.times[-1]),
    "final.angular_velocity": lambda report: np.asarray(report.trajectory.angular_velocity)[:, -1],
    "final.rotor_rate": lambda report: report.rotor_rate[:, -1],
    "final.rotor_momentum": lambda report: report.rotor_momentum[:, -1],
    "final.energy": lambda report: report.energy[:, -1],
}


def evaluate_ensemble(samples: ManySpecs, names: Sequence[str], times: Any) -> Ensemble | None:
    """Return the answers as ``AbstractKind.ensemble`` does; None for answers that need a report on each."""
    return evaluate_motions(samples, names, times, _begin, NUMBERS)


def _begin(samples: ManySpecs) -> ManyStarts | None:
    """Return the motions before they begin; None of samples that are not of one system."""
    spec, count, times = samples.spec, samples.size, samples.spec.times
    table, one = spec.system, build(spec)
    free_alone = one.free and table.motor_torque is None  # whose momentum, part of the system, varies with the spin
    coning = spec.spin is not None and spec.spin.is_of_a_cone
    if times is None or free_alone or coning or table.step is not None or not varies_start_alone(samples):
        return None
    assembly = build(replace(spec, spin=vary_table(spec.spin, "spin", samples.varied, count)))
    states = np.broadcast_to(packed := pack_start(table, assembly), (count, packed.shape[-1]))
    doubtful = ~finite_rows(states)
    return ManyStarts(
        make_system(table, one), states, times, doubtful,
        lambda trajectory: GyrostatReport(spec, table, one, trajectory), spec.until,
    )
