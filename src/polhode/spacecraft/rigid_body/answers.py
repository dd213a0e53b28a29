"""The answers about a rigid body with wheels, mounts and torques."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis._mechanics import Mechanics
from polhode.bodies.body import Body
from polhode.kinds.base import Spec, SpecMotion
from polhode.kinds.stepping import Start
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import about_body, accuracy, from_motion
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport
from polhode.reports.wording import angle, degrees, duration, number, vector
from polhode.spacecraft.rigid_body.build import Craft, build, usual_times
from polhode.spacecraft.rigid_body.control_margins import (
    LinearLoop,
    Margins,
    has_linear_loop,
    linearize_loop,
    loop_margins,
)
from polhode.spacecraft.rigid_body.history import History, follow
from polhode.spacecraft.rigid_body.table import RigidBodyTable
from polhode.spacecraft.systems.control_laws import QuaternionPD
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.spacecraft.rigid_body.gravity import GravityAnswers

WITHIN = math.radians(1.0)  # of the target: the usual pointing error below which a body has settled


class RigidBodyLimits(NamedTuple):
    """What decides on limits of actuators, real eigenvalues, slews and the reach of wheels."""

    min_samples: int = 4001  # at which limits of actuators are evaluated
    relative_eigenvalue: float = 1e-10  # of the largest: smaller parts of eigenvalues are rounding of differences
    slew_excess: float = 1e-6  # rad past half a turn, from which a slew goes the longer way; rounding leaves less
    min_sine: float = 1e-9  # of directions, below which wheels add none


LIMITS = RigidBodyLimits()


@dataclass(frozen=True)
class RigidBodyReport(MotionReport):
    """A rigid body with its mounts and torques.

    Attributes:
        craft: the system with its start.
        trajectory: the motion.
        history: derived quantities over time.
        limits: "none", "not reached", or "acted".
    """

    kind: ClassVar[str] = "rigid-body"
    spec: Spec[RigidBodyTable]
    craft: Craft
    trajectory: Trajectory
    history: History
    limits: str

    @cached_property
    def loop(self) -> LinearLoop | None:
        """The motion about the target to first order, with what is stored at the end; None without a target."""
        if self.craft.law is None:
            return None
        end = float(self.trajectory.times[-1]), np.asarray(self.trajectory.states)[-1]
        return linearize_loop(self.craft.system.without_limits(), self.craft.law, *end)

    @cached_property
    def gravity(self) -> GravityAnswers | None:
        """Answers about rests under gravity's gradient; None unless it acts alone on a circular orbit."""
        if not self.craft.falls_freely or self.trajectory.attitude is None:
            return None
        from polhode.spacecraft.rigid_body.gravity import judge_gravity

        return judge_gravity(self.craft, self.trajectory)

    @property
    def body(self) -> Body:
        assert self.spec.body is not None
        return self.spec.body

    @property
    def within(self) -> float:
        control = self.spec.system.control
        return WITHIN if control is None or control.within is None else control.within

    @cached_property
    def settling_time(self) -> float | None:
        """Time from which on the pointing error stays below ``within`` [s], at a sample; None where it does not."""
        error, times = self.history.pointing, np.asarray(self.trajectory.times)
        if error is None or error[-1] > self.within:
            return None
        away = np.flatnonzero(error > self.within)
        return float(times[away[-1] + 1] - times[0]) if len(away) else 0.0

    @property
    def mechanics(self) -> Mechanics | None:
        return None

    @property
    def summary(self) -> str:
        said = [self._control_summary(), self._wheel_summary(), None if self.gravity is None else self.gravity.summary]
        if words := " ".join(filter(None, said)):
            return self.rounded(words)
        first, last = (float(np.linalg.norm(self.history.velocity[k])) for k in (0, -1))
        span = duration(float(np.ptp(self.trajectory.times)))
        before, after = (number(speed, "rad/s", digits=4) for speed in (first, last))
        return self.rounded(f"The body turns at {before} at the start and {after} after {span}.")

    def _control_summary(self) -> str | None:
        error = self.history.pointing
        if error is None:
            return None
        if self.settling_time is None:
            end = degrees(float(error[-1]), 4)
            return f"The pointing error is {end} at the end and has not settled below {degrees(self.within, 4)}."
        after = "from the start" if self.settling_time == 0.0 else f"after {duration(self.settling_time)}"
        end = degrees(float(error[-1]), 4)
        within = degrees(self.within, 4)
        return f"At all samples it points within {within} {after}, and at the end within {end}."

    def _wheel_summary(self) -> str | None:
        rates = self.history.rates
        if not rates.shape[1]:
            return None
        fastest = float(np.abs(rates).max())
        acts = {"acted": " A limit of the actuators acts.", "not reached": " No limit of the actuators is reached."}
        fastest_rate = number(fastest, "rad/s", digits=4)
        return f"At the samples the fastest wheel turns at {fastest_rate}.{acts.get(self.limits, '')}"

    @property
    def notes(self) -> list[str]:
        notes = [*self.spec.remarks]
        law = self.craft.law
        if self.limits == "acted" and law is not None and has_linear_loop(self.craft.system, law):
            notes.append("eigenvalues and margins are those without limits.")
        notes += self._notes_on_reach()
        notes += self._notes_on_slew()
        if self.gravity is not None:
            notes += self.gravity.notes
        return [*notes, *self._notes_on_torques()]

    def _notes_on_reach(self) -> Iterator[str]:
        """Yield a note if the wheels cannot turn the body about every axis."""
        if self.craft.wheels is None:
            return
        rank = int(np.linalg.matrix_rank(np.asarray(self.craft.wheels.axes), tol=LIMITS.min_sine))
        if rank < 3:
            along = "one axis" if rank == 1 else "axes in one plane"
            yield f"the controlled wheels turn the body about {along} only; about other axes, control does nothing."

    def _notes_on_slew(self) -> Iterator[str]:
        """Yield a note if control went the longer way, and for rotors past their limit."""
        slew, law = self.history.slew, self.craft.law
        if slew is not None and isinstance(law, QuaternionPD) and slew.max() > math.pi + LIMITS.slew_excess:
            k = int(np.argmax(slew))
            yield (f"the body was turned by up to {degrees(float(slew[k]), 4)} from its target, at "
                   f"{duration(float(self.trajectory.times[k]))}, and quaternion-pd turns it back the way it went, "
                   f"although only {degrees(math.tau - float(slew[k]), 4)} were left the other way: it chooses the "
                   "shorter way at the start, and keeps it.")
        past = [k + 1 for k, margin in enumerate(self._rate_margins()) if margin is not None and margin < 0.0]
        if past:
            yield (f"{'wheel' if len(past) == 1 else 'wheels'} {', '.join(map(str, past))} turned past max_rate: no "
                   "motor drives there, but the body, as it turns, carries rotors past it.")

    def _rate_margins(self) -> list[float | None]:
        """Return the share of max_rate left to each controlled wheel, negative past it; None without max_rate."""
        pairs = zip(self.craft.wheel_tables, np.abs(self.history.rates).max(axis=0, initial=0.0).tolist(), strict=False)
        return [None if wheel.max_rate is None else 1.0 - fastest / wheel.max_rate for wheel, fastest in pairs]

    def _notes_on_torques(self) -> Iterator[str]:
        """Yield remarks, and notes on torques that start or end between the samples, or act outside of the motion."""
        first, last = (float(self.trajectory.times[k]) for k in (0, -1))
        pairs = zip(self.spec.system.torque, self.craft.system.torques, strict=False)
        for k, (chosen, torque) in enumerate(pairs):
            if remark := torque.remark(self.trajectory.times):
                yield f"torque.{k + 1} ({chosen.type}) {remark}."
            jumps = np.ravel(np.asarray(torque.jumps))
            if not len(jumps):
                continue
            if ((jumps > first) & (jumps < last)).any():
                said = "starts or ends on the way; the table of torques has only what is at the samples, the motion all"
            elif not self.history.torques[:, k].any():
                begin, end = jumps.min(), jumps.max()
                said = f"acts from {begin:g} s to {end:g} s, and this motion goes from {first:g} s to {last:g} s"
            else:
                continue
            yield f"torque.{k + 1} ({chosen.type}) {said}."

    @property
    def answers(self) -> list[Group | Table]:
        return [*self._along_motion(), *self._about_rests(), self._motion()]

    def iterate_answers(self) -> Iterator[Group | Table]:
        yield from self._along_motion()
        yield self._motion()
        yield from self._about_rests()

    def _along_motion(self) -> Iterator[Group | Table]:
        yield about_body(self.body, "all mounts locked")
        if self.craft.orbit is not None:
            yield self._orbit()
        if self.history.rates.shape[1]:
            yield self._wheels()
        if self.history.torques.shape[1]:
            yield self._torques()
        if self.craft.law is not None:
            yield self._control()

    def _about_rests(self) -> Iterator[Group | Table]:
        """Yield answers that take longer than the motion itself."""
        if self.loop is not None:
            yield self._modes(self.loop)
            yield self._margins()
        if self.gravity is not None:
            yield self.gravity.group

    def _orbit(self) -> Group:
        orbit = self.craft.orbit
        assert orbit is not None and orbit.semi_major_axis is not None
        return Group("Orbit", [
            Answer("orbit.period", float(orbit.period), "s", "period"),
            Answer("orbit.semi_major_axis", float(orbit.semi_major_axis), "m", "semi-major axis"),
            Answer("orbit.eccentricity", float(orbit.eccentricity), "", "eccentricity"),
            Answer("orbit.mean_motion", float(orbit.mean_motion), "rad/s", "mean motion"),
        ])

    def _wheels(self) -> Table:
        rates, motors, rows = self.history.rates, self.history.motors, []
        for k, (wheel, margin) in enumerate(zip(self.craft.wheel_tables, self._rate_margins(), strict=True)):
            fastest, strongest = float(np.abs(rates[:, k]).max()), float(np.abs(motors[:, k]).max())
            rows.append({
                "axis": np.asarray(wheel.axis) / np.linalg.norm(wheel.axis), "rate_start": rates[0, k],
                "rate_end": rates[-1, k], "rate_largest": fastest, "torque_largest": strongest,
                "rate_margin": margin,
                "torque_margin": None if wheel.max_torque is None else 1.0 - strongest / wheel.max_torque,
            })
        units = {"axis": "direction, given axes", "rate_start": "rad/s", "rate_end": "rad/s", "rate_largest": "rad/s",
                 "torque_largest": "N m", "rate_margin": "of max_rate that is left",
                 "torque_margin": "of max_torque that is left"}  # fmt: skip
        share = lambda value: "–" if value is None else f"{100.0 * abs(value):.3g} %{' past' if value < 0.0 else ''}"  # noqa: E731
        return Table("wheels", "Wheels, against the body, at the samples", {
            "axis": lambda row: vector(row["axis"], digits=3),
            "rate at the end": lambda row: number(row["rate_end"], "rad/s", digits=4) or "–",
            "largest": lambda row: number(row["rate_largest"], "rad/s", digits=4) or "–",
            "torque, largest": lambda row: number(row["torque_largest"], "N m", digits=4) or "–",
            "left of rate": lambda row: share(row["rate_margin"]),
            "of torque": lambda row: share(row["torque_margin"]),
        }, rows, units)

    def _torques(self) -> Table:
        names = [chosen.type for chosen in self.spec.system.torque]
        names += ["control"] * (self.history.torques.shape[1] - len(names))
        times = np.asarray(self.trajectory.times)
        span = float(np.ptp(times))
        rows = [
            {"type": name, "largest": float(values.max()), "mean": float(np.trapezoid(values, times) / span)}
            for name, values in zip(names, self.history.torques.T, strict=True)
        ]
        cell = lambda key: lambda row: number(row[key], "N m", digits=4) or "–"  # noqa: E731
        columns = {"torque": lambda row: row["type"], "largest": cell("largest"), "mean": cell("mean")}
        return Table("torques", "Torques about the centre of mass, at the samples", columns, rows,
                     {"largest": "N m", "mean": "N m"})

    def _control(self) -> Group:
        error, times = self.history.pointing, np.asarray(self.trajectory.times)
        control = self.spec.system.control
        assert control is not None
        load = float(self.history.load.max())
        answers = [
            Answer("control.law", control.type, "", "law"),
            Answer("control.by", control.by, "", "by"),
            Answer("control.limits", self.limits, "", "limits"),
            Answer("control.load", None if self.limits == "none" else load, "", "largest demand over the limit"),
        ]
        if error is not None:
            late = error[times >= times[0] + 0.9 * np.ptp(times)]
            answers += [
                Answer("control.pointing_error.start", float(error[0]), "rad", "pointing error at the start"),
                Answer("control.pointing_error.end", float(error[-1]), "rad", "at the end"),
                Answer("control.pointing_error.late", float(late.max()), "rad", "largest in the last tenth",
                       "at the samples"),
                Answer("control.within", self.within, "rad"),
                Answer("control.settling_time", self.settling_time, "s", f"settled below {angle(self.within)} after",
                       "from when on the error stays below `within`, at a sample"),
            ]
        if self.history.rates.shape[1]:
            power = self.history.power
            used = float(np.sum(0.5 * (power[1:] + power[:-1]) * np.diff(times)))
            answers += [
                Answer("control.power.largest", float(power.max()), "W", "power of the motors, largest at the samples",
                       "sum of |torque × rate|, none given back"),
                Answer("control.power.used", used, "J", "energy that they use, summed over the samples",
                       "trapezoidal sum; more samples, a better one"),
            ]
        return Group("Control", answers)

    def _modes(self, loop: LinearLoop) -> Table:
        rows, rounding = [], LIMITS.relative_eigenvalue * float(np.abs(loop.eigenvalues).max())
        for value in loop.eigenvalues:
            real, imaginary = (float(x) if abs(x) > rounding else 0.0 for x in (value.real, value.imag))
            if imaginary >= 0.0:
                size = math.hypot(real, imaginary)
                rows.append({"real": real, "imaginary": imaginary, "frequency": size,
                             "damping": (0.0 - real) / size if size else 0.0})
        units = {"real": "1/s", "imaginary": "rad/s", "frequency": "rad/s", "damping": "of critical"}
        columns = {
            "eigenvalue": lambda row: f"{row['real']:.5g} ± {row['imaginary']:.5g} i /s" if row["imaginary"] else (
                f"{row['real']:.5g} /s"),
            "frequency": lambda row: number(row["frequency"], "rad/s") or "–",
            "damping": lambda row: f"{row['damping']:.4g}",
        }  # fmt: skip
        title = "Closed loop about the target, to first order, with the momentum stored at the end"
        return Table("closed_loop", title, columns, rows, units)

    @cached_property
    def _loop_margins(self) -> list[Margins]:
        assert self.loop is not None
        return loop_margins(self.loop)

    def _margins(self) -> Table:
        rows = [{"axis": name, **margins._asdict()} for name, margins in zip("xyz", self._loop_margins, strict=True)]
        units: dict[str, str] = dict(zip(Margins._fields, ("rad/s", "rad", "s", "factor", "factor"), strict=True))
        columns = {
            "axis": lambda row: row["axis"],
            "crossover": lambda row: number(row["crossover"], "rad/s") or "–",
            "phase margin": lambda row: angle(row["phase"]) or "–",
            "delay margin": lambda row: duration(row["delay"]) or "–",
            "gain may fall to": lambda row: f"× {row['gain_down']:.4g}",
            "grow to": lambda row: f"× {row['gain_up']:.4g}" if math.isfinite(row["gain_up"]) else "any",
        }
        return Table("margins", "Margins of the loop about each given axis, the others closed", columns, rows, units,
                     key="axis")

    def _motion(self) -> Group:
        history, energy = self.history, self._energy()
        ends = (("start", 0), ("end", -1))
        answers = [Answer("end.time", float(self.trajectory.times[-1]), "s", "time")]
        for name, k in ends:
            values = [
                Answer(f"{name}.angular_velocity", history.velocity[k], "rad/s", f"Ω at the {name}", "given axes"),
                Answer(f"{name}.momentum", history.momentum[k], "kg m²/s", "", "of all, given axes"),
                Answer(f"{name}.momentum_norm", float(np.linalg.norm(history.momentum[k])), "kg m²/s",
                       f"|L| at the {name}"),
                Answer(f"{name}.stored_momentum", history.stored[k], "kg m²/s", "", "inside, L − IΩ, given axes"),
                Answer(f"{name}.energy", float(energy[k]), "J", f"kinetic energy at the {name}",
                       "with the mounts' own"),
            ]
            answers += from_motion(self.trajectory, values) if k else values
        if self.trajectory.attitude is not None:
            answers.append(Answer("end.attitude", self._given_attitude(), "", "", "quaternion wxyz of the given axes"))
        work = Answer("work", self._work(), "J", "work of torques and motors", "until the end")
        answers += from_motion(self.trajectory, [work])
        if history.from_nadir is not None:
            answers += [
                Answer("from_nadir.start", float(history.from_nadir[0]), "rad",
                       "given axes from nadir axes at the start"),
                *from_motion(self.trajectory, [
                    Answer("from_nadir.largest", float(history.from_nadir.max()), "rad", "largest, at the samples")]),
            ]
        return Group("Motion", [*answers, *accuracy(self.trajectory, "drift of conserved and balanced quantities")])

    def _energy(self) -> Array:
        for kept in (self.trajectory.balances, self.trajectory.invariants):
            for name in ("kinetic_energy", "energy"):
                if name in kept:
                    return np.asarray(kept[name])
        return np.full(len(self.trajectory.times), math.nan)

    def _work(self) -> float:
        received: Any = self.trajectory.received
        return float(next((received[x][-1] for x in ("kinetic_energy", "energy") if x in received), 0.0))

    def _given_attitude(self) -> Float64[Array, "4"]:
        back = rotation.conjugate(rotation.from_matrix(np.asarray(self.body.principal_axes)))
        return rotation.multiply(np.asarray(self.trajectory.attitude)[-1], back)


def make_report(spec: Spec[RigidBodyTable]) -> RigidBodyReport:
    """Return the report on a rigid body with its mounts and torques.

    Raises:
        InvalidInput: naming the table that does not fit.
    """
    return begin_motion(spec).make_report()


def simulate_motion(spec: Spec[RigidBodyTable]) -> SpecMotion:
    """Return the motion alone.

    Raises:
        InvalidInput: naming the table that does not fit.
    """
    return SpecMotion(make_report(spec).trajectory, None)


def begin_motion(spec: Spec[RigidBodyTable]) -> Start:
    """Return the motion, with whose report come its history, and whether its limits acted.

    Steps end where a limit begins or ceases to act, so that the motion has no error from them. Whether one acted is
    judged at samples so close that they resolve the motion.

    Raises:
        InvalidInput: naming the table that does not fit.
    """
    body, craft = spec.body, build(spec)
    assert body is not None
    times, parts = choose_times(craft, usual_times(craft, spec))

    def report(trajectory: Trajectory, _: tuple[str, ...]) -> RigidBodyReport:
        trajectory, limits = replace(trajectory, source=craft.system, frame=body.frame), "none"
        history = follow(craft.system, craft.orbit, trajectory.times, trajectory.states)
        if craft.system.limited:
            limits = "acted" if float(history.load.max()) > 1.0 else "not reached"
            trajectory, history = _thin(trajectory, parts), history.thin(parts)
        return RigidBodyReport(spec, craft, history.add_observed(trajectory), history, limits)

    return Start(craft.system, craft.state, times, report, spec.until)


def choose_times(craft: Craft, times: Float64[Array, "time"]) -> tuple[Float64[Array, "close"], int]:
    """Return times at which limits of actuators can be judged, and how many of them go to one of the given times."""
    if not craft.system.limited:
        return times, 1
    parts = max(1, math.ceil((LIMITS.min_samples - 1) / (len(times) - 1)))
    return np.append(np.linspace(times[:-1], times[1:], parts, endpoint=False, axis=1), times[-1]), parts


def _thin(trajectory: Trajectory, parts: int) -> Trajectory:
    """Return every ``parts``-th sample."""
    of_samples = ("times", "states", "attitude", "momentum", "angular_velocity")
    kept: dict[str, Any] = {}
    for name in of_samples:
        value = getattr(trajectory, name)
        kept[name] = None if value is None else value[::parts]
    for name in ("invariants", "balances", "received"):
        kept[name] = {key: np.asarray(value)[::parts] for key, value in getattr(trajectory, name).items()}
    return replace(trajectory, **kept)
