"""Answers about many Lagrange tops at once: each is set up by itself, and all motions are one array."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.exact.lagrange_top._geometry import REGIMES
from polhode.exact.lagrange_top.steady_precession import sleeping_threshold
from polhode.kinds.ensembles import Ensemble, ManySpecs
from polhode.kinds.lagrange_top.answers import make_start
from polhode.types import Array

STATES = "states."
PARTS = ("attitude", "momentum", "angular_velocity")
RESTING = (np.ones(3), 1.0, np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]))


def _regime(motion: LagrangeMotion) -> Any:
    return np.array(REGIMES)[motion.regime]


def _unless_planar(motion: LagrangeMotion, values: Any) -> Any:
    """Return rates, NaN for motions in a plane, where they are undefined."""
    return np.where(_regime(motion) == "planar", np.nan, values)


NUMBERS: dict[str, Callable[[LagrangeMotion], Any]] = {
    "regime": _regime,
    "spin": lambda motion: motion.momentum_at_epoch[:, 2] / motion.moments[:, 2],
    "sleeping_threshold": lambda motion: [
        sleeping_threshold((float(moments[0]), float(moments[1]), float(moments[2])), float(mgl))
        for moments, mgl in zip(motion.moments, motion.mgl, strict=True)
    ],
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
    starts: list[tuple[Array, float, Array, Array]] = [RESTING] * samples.size
    refused: dict[int, str] = {}
    for k in range(samples.size):
        try:
            top, momentum, attitude = make_start(samples.spec_of(k))
            starts[k] = np.asarray(top.moments), float(top.mgl), momentum, attitude
        except InvalidInput as error:
            refused[k] = str(error)
    moments, mgl, momentum, attitude = (np.array(column) for column in zip(*starts, strict=True))
    motion = LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude)
    with np.errstate(all="ignore"):
        values = {name: NUMBERS[name](motion) for name in names if name in NUMBERS}
    states = [name for name in names if name.startswith(STATES)]
    if states:
        sampled = motion.sample(np.asarray(times))
        values |= {name: getattr(sampled, name.removeprefix(STATES)) for name in states}
    return Ensemble(values, refused)
