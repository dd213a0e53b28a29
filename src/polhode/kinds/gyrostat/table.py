"""The table [system] of a body with a rotor."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from polhode.spec.fields import Direction, Duration, NutationLoss, PositiveMoment, Rate, Torque, one_of
from polhode.spec.models import SystemTable


class GyrostatTable(SystemTable):
    """A body with a rotor inside; the body's inertia includes the rotor's.

    Attributes:
        rotor_axis: in the given axes, of any length.
        rotor_rate: relative to the body.
        rotor_drive: by default "free" with a motor torque and "constant-rate" without.
        platform_loss: mean power over the square of the nutation angle that is lost in the body.
        rotor_loss: likewise in the rotor.
    """

    rotor_axis: Direction = Field(description="give it like [0.0, 0.0, 1.0], along the given axes")
    rotor_moment: PositiveMoment = Field(description='give it like "0.02 kg*m^2"')
    rotor_rate: Rate = Field(description='give it like "6000 rpm", relative to the body')
    rotor_drive: Annotated[Literal["constant-rate", "free"], one_of("constant-rate", "free")] | None = None
    motor_torque: Torque | None = None
    platform_loss: NutationLoss | None = None
    rotor_loss: NutationLoss | None = None
    step: Duration | None = None
