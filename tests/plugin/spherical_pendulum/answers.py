"""The plain answers about a spherical pendulum."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from polhode import simulate
from polhode.kinds import Answer, Group, MotionReport, Spec, Table, accuracy, from_motion
from polhode.motion import Trajectory
from spherical_pendulum.system import SphericalPendulum
from spherical_pendulum.table import PendulumTable

SWINGS = 10


@dataclass(frozen=True)
class PendulumReport(MotionReport):
    """One motion of a spherical pendulum."""

    kind: ClassVar[str] = "spherical-pendulum"
    system: SphericalPendulum
    trajectory: Trajectory

    @property
    def small_period(self) -> float:
        """2π √(l/g) [s]."""
        return 2.0 * math.pi * math.sqrt(float(self.system.length / self.system.gravity))

    @property
    def summary(self) -> str:
        lowest, highest = (f"{self.values()[name]:.5g} m" for name in ("lowest", "highest"))
        return self.rounded(f"The mass swings between {lowest} and {highest}.")

    @property
    def answers(self) -> list[Group | Table]:
        height = np.asarray(self.trajectory.part("z"))
        return [Group("Pendulum", [
            Answer("length", float(self.system.length), "m", "rod"),
            Answer("small_period", self.small_period, "s", "period of small swings"),
            *from_motion(self.trajectory, [
                Answer("highest", float(height.max()), "m", "highest", "from the pivot"),
                Answer("lowest", float(height.min()), "m", "lowest", "from the pivot"),
            ]),
            *accuracy(self.trajectory),
        ])]  # fmt: skip


def make_report(spec: Spec[PendulumTable]) -> PendulumReport:
    """Return the report on a spherical pendulum."""
    table = spec.system
    system = SphericalPendulum(jnp.asarray(table.length), jnp.asarray(table.gravity))
    x, z = table.length * math.sin(table.lean), -table.length * math.cos(table.lean)
    start = np.array([x, 0.0, z, 0.0, table.rate * x, 0.0])
    found = PendulumReport(system, simulate(system, start, [0.0, 1e-3], estimate_error=False))
    times = np.linspace(0.0, SWINGS * found.small_period, spec.samples) if spec.times is None else spec.times
    return PendulumReport(system, simulate(system, start, times))
