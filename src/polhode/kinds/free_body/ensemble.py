"""Answers about the free motions of many bodies at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from polhode.analysis.cone import many_axis_angles, many_velocity_angles, rotation_forms
from polhode.analysis.free_axes import leaving_rates
from polhode.analysis.poinsot import Herpolhode, herpolhodes
from polhode.exact.free_body import FreeMotion
from polhode.exact.free_body._geometry import REGIMES
from polhode.kinds.ensembles import Ensemble, ManySpecs, vary_table
from polhode.kinds.free_body.answers import LIMITS
from polhode.motion._invariants import norm
from polhode.spec.building import build_spin

STATES = "states."


class FreeBodies:
    """Free motions of many bodies, with the answers that a report on each would give.

    Attributes:
        motion: of all, along their principal axes.
        momentum: (sample, 3) at the start.
    """

    def __init__(self, moments: Any, momentum: Any, attitude: Any) -> None:
        self.momentum = momentum
        self.motion = FreeMotion(moments, momentum=momentum, attitude=attitude)

    @cached_property
    def velocity(self) -> Any:
        return self.momentum / self.motion.moments

    @cached_property
    def regime(self) -> Any:
        return np.array(REGIMES)[self.motion.regime]

    @cached_property
    def form(self) -> Any:
        return rotation_forms(self.motion)

    @cached_property
    def flip_interval(self) -> Any:
        """NaN for bodies that do not flip."""
        return np.where(self.form == "flipping", np.asarray(self.motion.flip_interval), math.nan)

    @cached_property
    def axis_angles(self) -> Any:
        return many_axis_angles(self.motion)

    @cached_property
    def herpolhode(self) -> Any:
        return herpolhodes(self.motion)

    @cached_property
    def steady(self) -> Any:
        return (self.regime == "permanent") | (self.regime == "spherical")

    @cached_property
    def speed(self) -> Any:
        return np.sqrt(np.vecdot(self.velocity, self.velocity))  # which sums as the norm of one vector does

    def verdict(self, k: int) -> Any:
        """Return whether rotation about an axis is stable; ``analysis.free_axes`` has the verdicts in full."""
        about, one, other = self._about(k)
        middle = (one - about) * (about - other) > 0.0
        equatorial = ((one == about) | (other == about)) & (one != other)
        moving = self.motion.momentum_norm > 0.0
        return np.where((middle | equatorial) & moving, "unstable", "stable")

    def growth(self, k: int) -> Any:
        """Return the rate at which motions near an axis leave it."""
        return leaving_rates(*self._about(k), self.motion.momentum_norm)

    def _about(self, k: int) -> tuple[Any, Any, Any]:
        moments = np.broadcast_to(self.motion.moments, self.momentum.shape)
        return moments[:, k], moments[:, (k + 1) % 3], moments[:, (k + 2) % 3]


def _find_encircled(bodies: FreeBodies) -> Any:
    axis = np.asarray(bodies.motion.encircled_axis)
    return np.where(axis >= 0, axis + 1.0, math.nan)


def _turn_per_flip(bodies: FreeBodies) -> Any:
    turn = np.asarray(bodies.motion.precession_per_period)
    return np.where(np.isnan(bodies.flip_interval), math.nan, 0.5 * turn)


def _sense(bodies: FreeBodies) -> Any:
    against = bodies.motion.encircled_axis == np.argmin(bodies.motion.moments, axis=-1)
    words = np.where(against, "against the spin", "with the spin")
    return np.where(np.isfinite(np.asarray(bodies.motion.period)), words, "")


def _in_space(bodies: FreeBodies) -> Any:
    axis, rate = np.asarray(bodies.motion.encircled_axis), np.asarray(bodies.motion.precession_rate)
    return np.where(axis >= 0, np.abs(rate), math.nan)


NUMBERS: dict[str, Callable[[FreeBodies], Any]] = {
    "angular_velocity": lambda bodies: bodies.velocity,
    "angular_speed": lambda bodies: bodies.speed,
    "momentum": lambda bodies: bodies.momentum,
    "principal_moments": lambda bodies: np.broadcast_to(bodies.motion.moments, bodies.momentum.shape),
    "form": lambda bodies: bodies.form,
    "regime": lambda bodies: bodies.regime,
    "encircled_axis": _find_encircled,
    "modulus": lambda bodies: bodies.motion.modulus,
    "energy": lambda bodies: bodies.motion.energy,
    "momentum_norm": lambda bodies: bodies.motion.momentum_norm,
    "polhode_period": lambda bodies: bodies.motion.period,
    "rotation_period": lambda bodies: np.where(bodies.steady, 2.0 * math.pi / bodies.speed, math.nan),
    "flip_interval": lambda bodies: bodies.flip_interval,
    "twist_per_flip": _turn_per_flip,
    "precession.body.rate": lambda bodies: 2.0 * math.pi / np.asarray(bodies.motion.period),
    "precession.body.sense": _sense,
    "precession.space.rate": _in_space,
    "precession_rate": lambda bodies: bodies.motion.precession_rate,
    "precession_per_period": lambda bodies: bodies.motion.precession_per_period,
    "geometric_phase": lambda bodies: bodies.motion.geometric_phase,
    "action": lambda bodies: bodies.motion.action,
    "tumbling_periods.P_phi": lambda bodies: bodies.motion.tumbling_periods[0],
    "tumbling_periods.P_psi": lambda bodies: bodies.motion.tumbling_periods[1],
    "long_axis_period": lambda bodies: bodies.motion.long_axis_period,
    "angle_of_velocity_to_momentum": lambda bodies: many_velocity_angles(bodies.motion),
    **{f"herpolhode.{name}": lambda bodies, k=k: bodies.herpolhode[k] for k, name in enumerate(Herpolhode._fields)},
    **{f"axes.{k + 1}.angle_to_momentum": lambda bodies, k=k: bodies.axis_angles[:, k] for k in range(3)},
    **{f"axes.{k + 1}.moment": lambda bodies, k=k: bodies._about(k)[0] for k in range(3)},
    **{f"axes.{k + 1}.verdict": lambda bodies, k=k: bodies.verdict(k) for k in range(3)},
    **{f"axes.{k + 1}.rate": lambda bodies, k=k: bodies.growth(k) for k in range(3)},
}
PARTS = ("attitude", "momentum", "angular_velocity")


def evaluate_ensemble(samples: ManySpecs, names: Sequence[str], times: Any) -> Ensemble | None:
    """Return the answers as ``AbstractKind.ensemble`` does; None for answers that need a report on each."""
    spec, varied, bodies, count = samples.spec, samples.varied, samples.bodies, samples.size
    known = {*NUMBERS, *(STATES + part for part in PARTS)}
    coning = spec.spin is not None and spec.spin.is_of_a_cone
    of_start = all(key.startswith(("spin.", "body.")) for key in varied)
    if bodies is None or coning or not of_start or not set(names) <= known:
        return None
    momentum, attitude = build_spin(vary_table(spec.spin, "spin", varied, count), bodies.moments, bodies.axes)
    momentum = np.array(np.broadcast_to(momentum, (count, 3)), dtype=float)
    moments, refused = np.array(np.broadcast_to(bodies.moments, (count, 3))), dict(bodies.refused)
    _refuse(moments, momentum, refused)
    wrong = list(refused)
    moments[wrong], momentum[wrong] = 1.0, 0.0
    free_bodies = FreeBodies(bodies.moments if bodies.moments.ndim == 1 else moments, momentum, attitude)
    with np.errstate(all="ignore"):
        values = {name: NUMBERS[name](free_bodies) for name in names if name in NUMBERS}
    return Ensemble(values | _states(free_bodies, names, times), refused)


def _refuse(moments: Any, momentum: Any, refused: dict[int, str]) -> None:
    """Note the bodies that ``answers.free_body_report`` would refuse."""
    with np.errstate(all="ignore"):
        energy, size = 0.5 * np.sum(momentum / moments * momentum, axis=1), norm(np, momentum)
        far = ~((energy < LIMITS.largest) & (size < LIMITS.largest))
        close = (size > 0.0) & ~((energy > 1.0 / LIMITS.largest) & (size > 1.0 / LIMITS.largest))
    for k in np.flatnonzero(moments[:, 0] <= 0.0):
        refused.setdefault(int(k), "the body is a thin rod, whose spin about its own axis is not defined")
    for k in np.flatnonzero(far | close):
        refused.setdefault(int(k), "the spin must give an energy and |L| within 1e±200, or none")


def _states(bodies: FreeBodies, names: Sequence[str], times: Any) -> dict[str, Any]:
    wanted = [name for name in names if name.startswith(STATES)]
    if not wanted:
        return {}
    sampled = bodies.motion.sample(np.asarray(times))
    return {name: getattr(sampled, name.removeprefix(STATES)) for name in wanted}
