"""An attitude over time, as files and motions give it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from polhode import rotation
from polhode._base.arrays import is_traced
from polhode.analysis._mechanics import Mechanics
from polhode.analysis._printing import count_things, print_answer, write_numbers, write_span
from polhode.errors import InvalidInput
from polhode.types import Array, Float64


@dataclass(frozen=True, eq=False)
class AttitudeHistory:
    """The attitude of a body over time, sampled, and exactly where it is known.

    Attributes:
        name: for reports.
        times: (T,) rising [s].
        attitude: (T, 4) unit quaternions wxyz, body → space.
        angular_velocity: (T, 3) [rad/s, body axes], or None.
        exact: attitude (…, 4) and angular velocity (…, 3) at any times (…), or None.
        mechanics: for energy and momentum, or None.
        resolution: by how much its times may be off, as they were written with so many digits [s].
    """

    name: str
    times: Float64[Array, "time"]
    attitude: Float64[Array, "time 4"]
    angular_velocity: Float64[Array, "time 3"] | None = None
    exact: Callable[[Float64[Array, "time"]], tuple[Float64[Array, "time 4"], Float64[Array, "time 3"]]] | None = None
    mechanics: Mechanics | None = None
    resolution: float = 0.0

    def __post_init__(self) -> None:
        if is_traced(self.times, self.attitude, self.angular_velocity):
            raise InvalidInput("times and attitudes of an AttitudeHistory must be known numbers, not traced by JAX.")

    @property
    def speed(self) -> float:
        """How fast it turns at most [rad/s], by its angular velocity, else from sample to sample."""
        if self.angular_velocity is not None:
            return float(np.linalg.norm(self.angular_velocity, axis=-1).max())
        turns = rotation.angle_between(self.attitude[1:], self.attitude[:-1])
        return float(np.max(turns / np.diff(self.times), initial=0.0))

    def __str__(self) -> str:
        known = "exact" if self.exact is not None else "sampled"
        return print_answer(
            f"the attitude of {self.name} at {count_things(len(self.times), 'time')}, {known}",
            times=write_span(self.times, "s"), fastest_turn=write_numbers(self.speed, "rad/s"),
        )


