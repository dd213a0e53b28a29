"""Answers about many Lagrange tops at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from polhode.exact.lagrange_top import LagrangeMotion
from polhode.exact.lagrange_top._geometry import REGIMES
from polhode.exact.lagrange_top.steady_precession import sleeping_thresholds
from polhode.kinds.ensembles import Ensemble, ManySpecs
from polhode.kinds.lagrange_top.answers import make_start
from polhode.kinds.many_tops import start_tops

STATES = "states."
PARTS = ("attitude", "momentum", "angular_velocity")


def _regime(motion: LagrangeMotion) -> Any:
    return np.array(REGIMES)[motion.regime]


def _unless_planar(motion: LagrangeMotion, values: Any) -> Any:
    """Return rates, NaN for motions in a plane, where they are undefined."""
    return np.where(_regime(motion) == "planar", np.nan, values)


NUMBERS: dict[str, Callable[[LagrangeMotion], Any]] = {
    "regime": _regime,
    "spin": lambda motion: motion.momentum_at_epoch[:, 2] / motion.moments[:, 2],
    "sleeping_threshold": lambda motion: sleeping_thresholds(motion.moments[:, 0], motion.moments[:, 2], motion.mgl),
    "nutation_limits": lambda motion: np.stack([np.asarray(limit) for limit in motion.nutation_limits], axis=-1),
    "nutation_period": lambda motion: motion.nutation_period,
    "precession_per_period": lambda motion: motion.precession_per_period,
    "spin_per_period": lambda motion: motion.spin_per_period,
    "precession_rate": lambda motion: _unless_planar(motion, motion.precession_rate),
    "spin_rate": lambda motion: _unless_planar(motion, motion.spin_rate),
    "energy": lambda motion: motion.energy,
}


def evaluate_ensemble(samples: ManySpecs, names: Sequence[str], times: Any) -> Ensemble | None:
    """Return the answers as ``AbstractKind.ensemble`` does; None for answers that need a report on each."""
    if not set(names) <= {*NUMBERS, *(STATES + part for part in PARTS)}:
        return None
    tops = start_tops(samples, make_start)
    wrong, moments = list(tops.refused), tops.moments
    moments[wrong] = 1.0
    motion = LagrangeMotion(moments, mgl=tops.mgl, momentum=tops.momentum, attitude=tops.attitude)
    with np.errstate(all="ignore"):
        values = {name: NUMBERS[name](motion) for name in names if name in NUMBERS}
    states = [name for name in names if name.startswith(STATES)]
    if states:
        sampled = motion.sample(np.asarray(times))
        values |= {name: getattr(sampled, name.removeprefix(STATES)) for name in states}
    return Ensemble(values, tops.refused)
