"""Answers about many motions of one rigid body with wheels, mounts and torques at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from polhode import rotation
from polhode.kinds.base import Spec
from polhode.kinds.ensembles import Ensemble, ManySpecs, vary_table
from polhode.kinds.many_motions import (
    AnswersOfMany,
    ManyStarts,
    evaluate_motions,
    finite_rows,
    norms,
    varies_start_alone,
)
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.rigid_body.answers import WITHIN, choose_times
from polhode.spacecraft.rigid_body.build import Craft, build
from polhode.spacecraft.rigid_body.history import History, follow
from polhode.spacecraft.rigid_body.table import RigidBodyTable
from polhode.spacecraft.systems.control_laws import AbstractControlLaw
from polhode.types import Array, Float64


@dataclass(frozen=True)
class RigidBodies:
    """Motions of one body with its parts.

    Attributes:
        spec: of one of them.
        craft: that all have.
        trajectory: of the batch.
        history: of the batch, at every ``parts``-th sample.
        parts: as of ``choose_times``.
    """

    spec: Spec[RigidBodyTable]
    craft: Craft
    trajectory: Trajectory
    history: History
    parts: int

    @property
    def times(self) -> Float64[Array, "time"]:
        return np.asarray(self.trajectory.times)[:: self.parts]

    @property
    def energy(self) -> Float64[Array, "sample time"]:
        """Kinetic energy [J], NaN where it is not known."""
        for kept in (self.trajectory.balances, self.trajectory.invariants):
            for name in ("kinetic_energy", "energy"):
                if name in kept:
                    return np.asarray(kept[name])[:, :: self.parts]
        return np.full(self.history.velocity.shape[:-1], np.nan)

    @property
    def work(self) -> Float64[Array, "sample"]:
        """Of torques and motors until the end [J]."""
        received = self.trajectory.received
        values = next((received[name] for name in ("kinetic_energy", "energy") if name in received), None)
        return np.zeros(len(self.history.velocity)) if values is None else np.asarray(values)[:, -1]

    @property
    def given_attitude(self) -> Float64[Array, "sample 4"]:
        """Of the given axes at the end."""
        assert self.spec.body is not None
        back = rotation.conjugate(rotation.from_matrix(np.asarray(self.spec.body.principal_axes)))
        return rotation.multiply(np.asarray(self.trajectory.attitude)[:, -1], back)

    @property
    def pointing(self) -> Float64[Array, "sample time"]:
        """Pointing error [rad]."""
        assert self.history.pointing is not None, "asked for with a target alone"
        return self.history.pointing

    @property
    def from_nadir(self) -> Float64[Array, "sample time"]:
        """Angle of the given axes from those that look down [rad]."""
        assert self.history.from_nadir is not None, "asked for on an orbit alone"
        return self.history.from_nadir

    @property
    def late_pointing(self) -> Float64[Array, "sample"]:
        """The largest pointing error in the last tenth [rad]."""
        late = self.times >= self.times[0] + 0.9 * np.ptp(self.times)
        return self.pointing[:, late].max(axis=-1)

    @property
    def settling_time(self) -> Float64[Array, "sample"]:
        """As of ``RigidBodyReport``, NaN where there is none."""
        control = self.spec.system.control
        within = WITHIN if control is None or control.within is None else control.within
        away = self.pointing > within
        first = np.where(away.any(axis=-1), away.shape[-1] - np.argmax(away[:, ::-1], axis=-1), 0)
        at = self.times[np.minimum(first, len(self.times) - 1)] - self.times[0]
        return np.where(away[:, -1], np.nan, at)

    @property
    def limits(self) -> Any:
        """Whether limits of actuators acted, in words."""
        if not self.craft.system.limited:
            return np.full(len(self.history.load), "none")
        return np.where(self.history.load.max(axis=-1) > 1.0, "acted", "not reached")


def _of_ends(end: str, k: int) -> AnswersOfMany:
    """Return the answers about the start or the end."""
    return {
        f"{end}.angular_velocity": lambda bodies: bodies.history.velocity[:, k],
        f"{end}.momentum": lambda bodies: bodies.history.momentum[:, k],
        f"{end}.momentum_norm": lambda bodies: norms(bodies.history.momentum[:, k]),
        f"{end}.stored_momentum": lambda bodies: bodies.history.stored[:, k],
        f"{end}.energy": lambda bodies: bodies.energy[:, k],
    }


def _of_wheel(k: int) -> AnswersOfMany:
    return {
        f"wheels.{k + 1}.rate_start": lambda bodies: bodies.history.rates[:, 0, k],
        f"wheels.{k + 1}.rate_end": lambda bodies: bodies.history.rates[:, -1, k],
        f"wheels.{k + 1}.rate_largest": lambda bodies: np.abs(bodies.history.rates[:, :, k]).max(axis=-1),
        f"wheels.{k + 1}.torque_largest": lambda bodies: np.abs(bodies.history.motors[:, :, k]).max(axis=-1),
    }


def _of_torque(k: int) -> AnswersOfMany:
    return {
        f"torques.{k + 1}.largest": lambda bodies: bodies.history.torques[:, :, k].max(axis=-1),
        f"torques.{k + 1}.mean": lambda bodies: np.trapezoid(bodies.history.torques[:, :, k], bodies.times)
        / np.ptp(bodies.times),
    }


NUMBERS: dict[str, Callable[[RigidBodies], Any]] = {
    **_of_ends("start", 0),
    **_of_ends("end", -1),
    "end.time": lambda bodies: np.full(len(bodies.history.velocity), bodies.times[-1]),
    "end.attitude": lambda bodies: bodies.given_attitude,
    "work": lambda bodies: bodies.work,
    "from_nadir.start": lambda bodies: bodies.from_nadir[:, 0],
    "from_nadir.largest": lambda bodies: bodies.from_nadir.max(axis=-1),
    "control.limits": lambda bodies: bodies.limits,
    "control.load": lambda bodies: np.where(bodies.limits == "none", np.nan, bodies.history.load.max(axis=-1)),
    "control.pointing_error.start": lambda bodies: bodies.pointing[:, 0],
    "control.pointing_error.end": lambda bodies: bodies.pointing[:, -1],
    "control.pointing_error.late": lambda bodies: bodies.late_pointing,
    "control.settling_time": lambda bodies: bodies.settling_time,
    "control.power.largest": lambda bodies: bodies.history.power.max(axis=-1),
}


def evaluate_ensemble(samples: ManySpecs, names: Sequence[str], times: Any) -> Ensemble | None:
    """Return the answers as ``AbstractKind.ensemble`` does; None for answers that need a report on each."""
    table, answers = samples.spec.system, dict(NUMBERS)
    for k in range(len(table.wheel)):
        answers |= _of_wheel(k)
    for k in range(len(table.torque) + 1):  # and that of control
        answers |= _of_torque(k)
    return evaluate_motions(samples, names, times, _begin, answers)


def _begin(samples: ManySpecs) -> ManyStarts | None:
    """Return the motions before they begin; None of samples that are not of one system."""
    spec, count, times = samples.spec, samples.size, samples.spec.times
    coning = spec.spin is not None and spec.spin.is_of_a_cone
    if times is None or coning or not varies_start_alone(samples):
        return None
    craft = build(spec)
    starts_anew = craft.law is not None and type(craft.law).started is not AbstractControlLaw.started
    if starts_anew and any(key.startswith("spin.attitude") for key in samples.varied):
        return None  # the law, part of the system, depends on the attitude
    spins = replace(spec, spin=vary_table(spec.spin, "spin", samples.varied, count))
    packed = craft.pack_starts(spins)
    states = np.broadcast_to(packed, (count, packed.shape[-1]))
    times, parts = choose_times(craft, times)

    def view(trajectory: Trajectory) -> RigidBodies:
        history = follow(craft.system, craft.orbit, trajectory.times, trajectory.states)
        return RigidBodies(spec, craft, trajectory, history.thin(parts), parts)

    return ManyStarts(craft.system, states, times, ~finite_rows(states), view, spec.until, parts)
