"""A torque that follows a command with a lag."""

from __future__ import annotations

from collections.abc import Callable

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Attitude, Own, Time, Velocity, checked_jumps
from polhode.spacecraft.torques.base import NEEDED, AbstractTorque
from polhode.systems._checks import checked_number
from polhode.types import Array, ArrayLike, Float64, Real

Command = Callable[
    [Float64[Array, "*batch"], Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]], Float64[Array, "*batch 3"]
]


class LaggedTorque(AbstractTorque):
    """A torque that follows a command with a lag of first order: τ̇ = (u − τ)/T, as of a thruster or a magnetorquer.

    Its state is τ itself (…, 3).

    Args:
        command: u (…, 3) [N m, body axes], a function (t, attitude, angular_velocity) of the time (…) [s], the attitude
            (…, 4) and Ω (…, 3), batched and written with ``jax.numpy``. It needs states with the attitude.
        time_constant: T [s], positive.
        jumps: (J,) times [s] at which the command jumps; see ``AbstractSystem.jumps``.

    Raises:
        InvalidInput: for a command that is not a function, a time constant that is not positive, or jumps that are not
            times.
    """

    command: Command
    time_constant: Float64[Array, ""]
    jump_times: Float64[Array, "jumps"]

    @known_numbers_only
    def __init__(
        self, command: Command, time_constant: float, jumps: Real[ArrayLike, "jumps"] = ()
    ) -> None:
        if not callable(command):
            check.refuse("command", "a function (t, attitude, angular_velocity) that gives a torque (…, 3) [N m]",
                         command, "For a constant one write `lambda t, attitude, velocity: 0 * velocity + torque`.")
        self.command, self.time_constant = command, checked_number("time_constant", time_constant, 0.0, unit="s")
        self.jump_times = checked_jumps(jumps)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.jump_times

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("actuator_torque", 3, "N m", "torque of the actuator", "given"),)

    @property
    def needs_attitude(self) -> bool:
        return True

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        assert attitude is not None, NEEDED
        return (self.command(t, attitude, angular_velocity) - actuator) / self.time_constant

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        assert actuator is not None, NEEDED
        return actuator
