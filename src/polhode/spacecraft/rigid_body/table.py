"""The tables of a rigid body with mounts and torques: [[wheel]], [[torque]], [[mount]], [control] and [orbit]."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BaseModel, ConfigDict, Field, create_model

from polhode.errors import InvalidInput
from polhode.spacecraft.rigid_body.arguments import Chosen, make_model
from polhode.spacecraft.rigid_body.named import LAWS, MOUNTS, TORQUES, Family, find_part
from polhode.spec.fields import (
    Angle,
    BearingFriction,
    Direction,
    Duration,
    Eccentricity,
    Flag,
    GravitationalParameter,
    Length,
    PositiveMoment,
    PositiveRate,
    PositiveTorque,
    Rate,
    Torque,
    one_of,
)
from polhode.spec.models import Strict, SystemTable

DRIVES = ("controlled", "free", "constant-rate", "motor")
ACTUATORS = ("wheels", "torque")
LISTS = {"torque": TORQUES, "mount": MOUNTS}
EARTH = 3.986004418e14  # m³/s², of the Earth; IERS Conventions (2010), table 1.1


class WheelTable(Strict):
    """A wheel in the body; the body's inertia includes it.

    Attributes:
        axis: in the given axes, of any length.
        moment: about it.
        rate: against the body at the start.
        drive: by default "controlled" if [control] works by wheels, "motor" with a ``torque``, else "free".
        torque: of its motor, constant.
        friction: of the bearing.
        max_torque: of a controlled wheel's motor.
        max_rate: of a controlled wheel against the body, beyond which its motor does not drive it.
    """

    axis: Direction = Field(description="give it like [0.0, 0.0, 1.0], along the given axes")
    moment: PositiveMoment = Field(description='give it like "2e-5 kg*m^2"')
    rate: Rate = 0.0
    drive: Annotated[Literal["controlled", "free", "constant-rate", "motor"], one_of(*DRIVES)] | None = None
    torque: Torque | None = None
    friction: BearingFriction = 0.0
    max_torque: PositiveTorque | None = None
    max_rate: PositiveRate | None = None


class OrbitTable(Strict):
    """A Kepler orbit about the Earth, or another body by its gravitational parameter.

    Attributes:
        relative: whether [spin] is against the axes that look down along the orbit, instead of space.
        greenwich: angle of the Earth's prime meridian from space x at the start.
    """

    period: Duration | None = None
    semi_major_axis: Length | None = None
    altitude: Length | None = None
    gravitational_parameter: GravitationalParameter = EARTH
    eccentricity: Eccentricity = 0.0
    inclination: Angle = 0.0
    node: Angle = 0.0
    periapsis: Angle = 0.0
    mean_anomaly: Angle = 0.0
    greenwich: Angle = 0.0
    relative: Flag = False


class ControlBase(Strict):
    """The keys of [control] besides the arguments of its law.

    Attributes:
        by: the actuator: the wheels, or an ideal couple from outside.
        limit: of that couple, about each axis.
        within: pointing error below which the body has settled.
    """

    by: Annotated[Literal["wheels", "torque"], one_of(*ACTUATORS)] = "wheels"
    limit: PositiveTorque | None = None
    within: Annotated[Angle, Field(gt=0)] | None = None


class ControlTable(Chosen, ControlBase):
    """The law that [control] names, with its arguments in SI."""


class Unknown(BaseModel):
    """Placeholder for an entry that a rule refuses."""

    model_config = ConfigDict(extra="allow")


class RigidBodyTable(SystemTable):
    """A rigid body with wheels, other mounts and torques; vectors are along the given axes."""

    beside: ClassVar[tuple[str, ...]] = ("wheel", "torque", "mount", "control", "orbit")
    wheel: Annotated[list[WheelTable], Field(default_factory=list)]
    torque: Annotated[list[Chosen], Field(default_factory=list)]
    mount: Annotated[list[Chosen], Field(default_factory=list)]
    control: ControlTable | None = None
    orbit: OrbitTable | None = None


def model_of(raw: dict[str, Any]) -> type[BaseModel]:
    """Return the model of raw tables, in which each torque, mount and law has the keys of its class."""
    lists = {key: raw.get(key, []) for key in LISTS}
    models = {key: tuple(_model_of(LISTS[key], entry, "type") for entry in entries)
              for key, entries in lists.items() if isinstance(entries, list)}
    control = _model_of(LAWS, raw["control"], "law", ControlBase) if "control" in raw else None
    return _join_models(tuple(models.items()), control)


@lru_cache(maxsize=64)
def _join_models(
    lists: tuple[tuple[str, tuple[type[BaseModel], ...]], ...], control: type[BaseModel] | None
) -> type[BaseModel]:
    fields: dict[str, Any] = {key: (tuple[models] if models else tuple[()], ()) for key, models in lists}
    if control is not None:
        fields["control"] = (control, ...)
    return create_model("RigidBodyTables", __base__=RigidBodyTable, **fields)


def settle(checked: Any) -> RigidBodyTable:
    """Convert entries parsed as classes of their own into names with values, the form in which specs keep them."""
    given = set(checked.model_fields_set)
    values: dict[str, Any] = {name: getattr(checked, name) for name in RigidBodyTable.model_fields}
    for key in LISTS:
        known = [entry for entry in values[key] if not isinstance(entry, Unknown)]
        values[key] = [Chosen.model_construct(type=entry.type, values=_set(entry, ("type",))) for entry in known]
    law = values["control"]
    if isinstance(law, Unknown):
        values["control"] = None
    elif law is not None:
        own = {name: getattr(law, name) for name in ControlBase.model_fields}
        rest = _set(law, ("law", *ControlBase.model_fields))
        values["control"] = ControlTable.model_construct(type=law.law, values=rest, **own)
    return RigidBodyTable.model_construct(_fields_set=given, **values)


def _model_of(family: Family, entry: Any, key: str, base: type[Strict] = Strict) -> type[BaseModel]:
    name = entry.get(key) if isinstance(entry, dict) else None
    if not isinstance(name, str):
        return Unknown
    try:
        return make_model(find_part(family, name), name, key, base)
    except InvalidInput:
        return Unknown


def _set(entry: BaseModel, but: Sequence[str]) -> dict[str, Any]:
    return {name: getattr(entry, name) for name in entry.model_fields_set if name not in but}
