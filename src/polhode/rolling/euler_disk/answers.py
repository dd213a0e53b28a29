"""From a spec of a rolling disk to its report."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.kinds.base import Spec
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.reports.answer import Group, Table
from polhode.reports.base import WITHOUT_MOTION, make_placeholder
from polhode.reports.length import Watch
from polhode.rolling.euler_disk.report import EulerDiskReport, LawShare, law_names
from polhode.rolling.euler_disk.spin_down import SpinDown, adiabatic_end, spin_down
from polhode.rolling.euler_disk.steady_rolling import (
    SteadyRolling,
    critical_rolling_speed,
    critical_spin_rate,
    rolling_period,
    steady_rolling,
)
from polhode.rolling.euler_disk.system import EulerDisk
from polhode.rolling.euler_disk.table import EulerDiskTable
from polhode.rolling.euler_disk.turns import DiskPath, first_turns, last_turns, resample_until_end, rolling_path
from polhode.simulation import simulate
from polhode.types import Array

TURNS = 12  # of the contact, which are sampled densely


class StartLimits(NamedTuple):
    """What decides which answers a disk has."""

    angle_off_upright: float = 1e-9  # rad; π/2 from degrees, or typed with ten digits, is nearer


LIMITS = StartLimits()


def make_report(spec: Spec[EulerDiskTable]) -> EulerDiskReport:
    """Return the report on a rolling disk.

    With dissipation and without times it is followed to its end, else for these times, or for ten nutations. An event
    that ends the motion earlier ends the samples too.

    Raises:
        InvalidInput: for sizes that no disk has, and starts that do not roll or are not steady.
        NotConverged: where the dissipation comes to an end before the motion does.
    """
    turn_samples = 125
    periods = 10  # of the nutation
    table, times = spec.system, spec.times
    disk, ideal = make_disks(table)
    start, steady = _start(table, disk), _steady(table, ideal)
    if table.dissipation and times is None:
        end = _simulate_end(disk, start)
        trajectory = end.trajectory
        path = last_turns(trajectory, TURNS, spec.samples)
        turn = 2.0 * math.pi / abs(float(disk.precession(start)))
        opening = rolling_path(disk, start, turn, turn_samples)
    else:
        end, opening = None, None
        if times is None:
            times = np.linspace(0.0, periods * rolling_period(disk, start, steady), spec.samples)
        # losses end the motion at a time that is not known beforehand
        watch = None if table.dissipation else Watch(spec.until, times)
        trajectory = resample_until_end(simulate(disk, start, times, progress=watch), spec.samples)
        path = first_turns(trajectory, TURNS, spec.samples)
    by_energy = None if end is None or table.precession is not None else adiabatic_end(disk, table.tilt)
    A, C = float(disk.mechanics.diametral_moment), float(disk.mechanics.axial_moment)
    trajectory = replace(trajectory, frame=BodyFrame(np.array([A, A, C]), np.eye(3), np.zeros(3), table.mass))
    return EulerDiskReport(
        table=table, disk=disk, trajectory=trajectory, begin=start, steady=steady,
        laws=_shares(table, disk, trajectory, end), spin_down=end, end_by_energy=by_energy, path=path,
        opening=opening, thresholds=_thresholds(table, ideal),
    )


def answers_without_motion(spec: Spec[EulerDiskTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need no trajectory.

    Raises:
        InvalidInput: for sizes that no disk has, and starts that do not roll or are not steady.
    """
    table = spec.system
    disk, ideal = make_disks(table)
    yield from EulerDiskReport(
        table=table, disk=disk, trajectory=WITHOUT_MOTION, begin=_start(table, disk), steady=_steady(table, ideal),
        laws=[], spin_down=None, end_by_energy=None, path=make_placeholder(DiskPath), opening=None,
        thresholds=_thresholds(table, ideal),
    ).without_motion()


def make_disks(table: EulerDiskTable) -> tuple[EulerDisk, EulerDisk]:
    """Return the disk with its dissipation, and without it."""
    sizes = (table.mass, table.radius, table.thickness, table.axial_moment, table.diametral_moment, table.gravity)
    disk = EulerDisk(*sizes, dissipation=[law.build() for law in table.dissipation])
    return disk, EulerDisk(*sizes) if table.dissipation else disk


def _steady(table: EulerDiskTable, ideal: EulerDisk) -> SteadyRolling | None:
    return steady_rolling(ideal, table.tilt, table.precession, table.spin, table.heading)


def _thresholds(table: EulerDiskTable, ideal: EulerDisk) -> tuple[float, float] | None:
    """Return speed and rate above which an upright thin disk rolls and spins stably; None for other disks."""
    upright = not table.thickness and abs(table.tilt - 0.5 * math.pi) < LIMITS.angle_off_upright
    return (critical_rolling_speed(ideal), critical_spin_rate(ideal)) if upright else None


def _start(table: EulerDiskTable, disk: EulerDisk) -> Array:
    """Return the state (8,) that the spec asks for, its contact at the origin."""
    tilt = table.tilt
    if table.tilt_rate is None:
        state = disk.rolling_state(tilt, table.precession, table.spin, table.heading)
    else:
        assert table.precession is not None and table.spin is not None
        state = disk.state(tilt, table.tilt_rate, table.precession, table.spin, table.heading)
    if table.center_velocity is not None:
        known = disk.vectors(state)
        disk.pack(known.attitude, known.angular_velocity, center_velocity=table.center_velocity)
    if not float(disk.normal_force(state)) > 0.0:
        raise InvalidInput(
            f"the start leaves the plane at once: its normal force would be {float(disk.normal_force(state)):.4g} N. "
            "Check `tilt_rate`, `precession` and `spin`."
        )
    return state


def _simulate_end(disk: EulerDisk, start: Array) -> SpinDown:
    try:
        return spin_down(disk, start)
    except (InvalidInput, NotConverged) as error:
        hint = "In a spec, [time] until follows any start for that long."
        raise type(error)(f"{error} {hint}") from None


def _shares(table: EulerDiskTable, disk: EulerDisk, trajectory: Trajectory, end: SpinDown | None) -> list[LawShare]:
    """Return the power that each law dissipates."""
    powers = np.asarray(disk.powers(trajectory.states))
    shares = powers / powers.sum(axis=-1, keepdims=True)
    late = [None if end is None else float(np.mean(share[end.late])) for share in shares.T]
    return [
        LawShare(name, law.exponent, float(powers[0, k]), float(shares[0, k]), late[k])
        for k, (name, law) in enumerate(zip(law_names(table), disk.dissipation, strict=True))
    ]
