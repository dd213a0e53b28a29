"""From a spec of a rolling disk to its report."""

from __future__ import annotations

import math
from dataclasses import replace

import diffrax
import jax.numpy as jnp
import numpy as np

from polhode.analysis.rolling import critical_rolling_speed, critical_spin_rate, nutation, rolling_stability
from polhode.analysis.spin_down import (
    ASYMPTOTIC_FIT,
    FALL_SAMPLES,
    STEPS_PER_RADIAN,
    SpinDown,
    adiabatic_end,
    spin_down,
)
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators.adaptive import solve_adaptively
from polhode.kinds.base import Spec
from polhode.kinds.euler_disk.report import EulerDiskReport, LawShare, Path, Steady, law_names
from polhode.kinds.euler_disk.table import EulerDiskTable
from polhode.motion.frame import BodyFrame
from polhode.motion.outcome import Ending, Outcome
from polhode.motion.trajectory import Trajectory
from polhode.reports.length import ADAPTIVE, check_length
from polhode.simulation import simulate
from polhode.systems.euler_disk import LAYOUT, EulerDisk
from polhode.types import Array

PERIODS = 10
TURNS = 12  # of the contact, sampled densely
TURN_SAMPLES = 125
PAST_END = 1.1  # of the time to the end, so that its event is found again
JUST_PAST_END = 1.0 + 1e-9  # the same, as the last of many samples
UPRIGHT = 1e-9  # rad


def report_of(spec: Spec) -> EulerDiskReport:
    """Return the report on a rolling disk.

    With dissipation and without times it is followed to its end, else for these times, or for ten nutations. What ends
    it before the last of the times ends the samples too.

    Raises:
        InvalidInput: for sizes that no disk has, and starts that do not roll or are not steady.
        NotConverged: where the dissipation comes to an end before the motion does.
    """
    table, times = spec.system, spec.times
    assert isinstance(table, EulerDiskTable)
    sizes = (table.mass, table.radius, table.thickness, table.axial_moment, table.diametral_moment, table.gravity)
    disk = EulerDisk(*sizes, dissipation=[law.build() for law in table.dissipation])
    ideal = EulerDisk(*sizes) if table.dissipation else disk
    start = _start(table, disk)
    steady = _steady(table, ideal)
    if table.dissipation and times is None:
        found = _ended(disk, start)
        trajectory = found.trajectory
        path = _last_turns(disk, trajectory, spec.samples)
        turn = 2.0 * math.pi / abs(float(disk.precession(start)))
        opening = _dense(disk, start, 0.0, turn, TURN_SAMPLES)
    else:
        found, opening = None, None
        if times is None:
            times = np.linspace(0.0, PERIODS * _period(disk, start, steady), spec.samples)
        # losses bring it to an end, of which nothing is known yet
        steps = 0.0 if table.dissipation else STEPS_PER_RADIAN * float(np.ptp(times)) * _fastest(disk, start)
        shown = check_length(spec.until, times, steps, ADAPTIVE)
        trajectory = _sampled_to_its_end(disk, simulate(disk, start, times, progress=shown), spec.samples)
        path = _first_turns(disk, trajectory, spec.samples)
    by_energy = None if found is None or table.precession is not None else adiabatic_end(disk, table.tilt)
    A, C = float(disk.mechanics.diametral_moment), float(disk.mechanics.axial_moment)
    trajectory = replace(trajectory, frame=BodyFrame(np.array([A, A, C]), np.eye(3), np.zeros(3), table.mass))
    upright = not table.thickness and abs(table.tilt - 0.5 * math.pi) < UPRIGHT
    return EulerDiskReport(
        table=table, disk=disk, trajectory=trajectory, steady=steady, laws=_shares(table, disk, trajectory, found),
        spin_down=found, end_by_energy=by_energy, path=path, opening=opening,
        thresholds=(critical_rolling_speed(ideal), critical_spin_rate(ideal)) if upright else None,
    )  # fmt: skip


def _start(table: EulerDiskTable, disk: EulerDisk) -> Array:
    """Return the state (8,) that the spec asks for, its contact at the origin."""
    tilt = table.tilt
    if table.tilt_rate is None:
        state = disk.rolling_state(tilt, table.precession, table.spin, table.heading)
    else:
        assert table.precession is not None and table.spin is not None
        rise = table.precession * math.sin(tilt)
        state = disk.check_state([tilt, table.heading, 0.0, 0.0, 0.0, table.tilt_rate, rise, table.spin])
    if table.center_velocity is not None:
        known = disk.vectors(state)
        disk.pack(known.attitude, known.angular_velocity, center_velocity=table.center_velocity)
    if not float(disk.normal_force(state)) > 0.0:
        raise InvalidInput(
            f"the start leaves the plane at once: its normal force would be {float(disk.normal_force(state)):.4g} N. "
            "Check `tilt_rate`, `precession` and `spin`."
        )
    return state


def _steady(table: EulerDiskTable, ideal: EulerDisk) -> Steady | None:
    """Return the steady motion with the given rates, or else with the given precession, None if there is none."""
    for spin in (table.spin, None):
        try:
            state = ideal.rolling_state(table.tilt, table.precession, spin, table.heading)
            return Steady(state, rolling_stability(ideal, state), nutation(ideal, state))
        except InvalidInput:
            continue
    return None


def _ended(disk: EulerDisk, start: Array) -> SpinDown:
    try:
        return spin_down(disk, start)
    except (InvalidInput, NotConverged) as error:
        hint = "In a spec, [time] until follows any start for that long."
        raise type(error)(f"{error} {hint}") from None


def _sampled_to_its_end(disk: EulerDisk, trajectory: Trajectory, samples: int) -> Trajectory:
    """Return the motion, simulated again with all samples before its end if it ends early in those asked for."""
    if trajectory.outcome.event is None or len(trajectory.times) > samples // 2:
        return trajectory
    first, last = float(trajectory.times[0]), float(trajectory.times[-1])
    return simulate(disk, trajectory.states[0], np.linspace(first, first + JUST_PAST_END * (last - first), samples))


def _period(disk: EulerDisk, start: Array, steady: Steady | None) -> float:
    """Return the time of a small nutation, of a turn where it is unstable, of a swing where nothing turns."""
    if steady is not None and steady.nutation:
        return 2.0 * math.pi / steady.nutation
    swinging = math.sqrt(float(disk.mechanics.gravity / disk.mechanics.radius))
    return 2.0 * math.pi / max(_fastest(disk, start), swinging)


def _fastest(disk: EulerDisk, start: Array) -> float:
    rates = [LAYOUT.part(start, name) for name in ("tilt_rate", "rise_rate", "spin")]
    return max(abs(float(disk.precession(start))), float(np.linalg.norm(rates)))


def _first_turns(disk: EulerDisk, trajectory: Trajectory, samples: int) -> Path:
    """Return the motion itself, or its first turns where it has too many for its samples."""
    heading = np.asarray(trajectory.part("heading"))
    beyond = np.flatnonzero(np.abs(heading - heading[0]) > 2.0 * math.pi * TURNS)
    if len(beyond):
        times = np.linspace(0.0, float(trajectory.times[beyond[0]]), samples)
        trajectory = simulate(disk, trajectory.states[0], times)
    return Path(np.asarray(trajectory.times), np.asarray(trajectory.states), trajectory.outcome)


def _last_turns(disk: EulerDisk, trajectory: Trajectory, samples: int) -> Path:
    """Return the last turns of the contact, to the event that ends them."""
    heading, times = np.asarray(trajectory.part("heading")), np.asarray(trajectory.times)
    before = np.flatnonzero(np.abs(heading[-1] - heading) >= 2.0 * math.pi * TURNS)
    k = int(before[-1]) if len(before) else 0
    span = PAST_END * float(times[-1] - times[k])
    turns = abs(float(heading[-1] - heading[k])) / (2.0 * math.pi)
    if turns > 4.0 * TURNS:  # of a motion without end in sight, whose samples lie far apart
        span *= TURNS / turns
    return _dense(disk, trajectory.states[k], float(times[k]), span, samples)


def _dense(disk: EulerDisk, state: Array, since: float, span: float, samples: int) -> Path:
    """Return equally spaced samples up to an event, in pieces of the size that ``spin_down`` has compiled already."""
    piece = FALL_SAMPLES - 1
    step = span / max(samples - 1, piece)
    ticks, times, states = step * np.arange(FALL_SAMPLES), [np.array([since])], [np.asarray(state)[None]]
    outcome = Outcome(Ending.COMPLETED)
    for k in range(math.ceil(max(samples - 1, piece) / piece)):
        found = solve_adaptively(disk, diffrax.Dopri8(), jnp.asarray(states[-1][-1]), ticks)
        times.append(since + k * piece * step + found.times[1:])
        states.append(np.asarray(found.states)[1:])
        if not found.successful:
            raise NotConverged(f"the last turns cannot be followed past {times[-1][-1]:.6g} s. Give [time] until.")
        if found.event is not None:
            outcome = Outcome(Ending.EVENT, found.event)
            break
    return Path(np.concatenate(times), np.concatenate(states), outcome)


def _shares(table: EulerDiskTable, disk: EulerDisk, trajectory: Trajectory, found: SpinDown | None) -> list[LawShare]:
    """Return what each law takes."""
    states, tilt = jnp.asarray(trajectory.states), jnp.asarray(trajectory.part("tilt"))
    tilt = jnp.minimum(tilt, jnp.pi - tilt)
    rate = jnp.abs(disk.precession(states))
    powers = [np.asarray(law.power(disk.mechanics, tilt, rate)) for law in disk.dissipation]
    late = slice(0, 0)
    if found is not None:
        first, count = int(np.flatnonzero(found.adiabaticity < ASYMPTOTIC_FIT)[0]), found.tilt.samples
        late = slice(first + count // 2, first + count)  # the half whose exponent it is
    whole = sum(powers)
    shares = [power / whole for power in powers]
    return [
        LawShare(name, law.exponent, float(power[0]), float(share[0]),
                 None if found is None else float(np.mean(share[late])))
        for name, law, power, share in zip(law_names(table), disk.dissipation, powers, shares, strict=True)
    ]  # fmt: skip
