"""From the spec of a rigid body with mounts and torques to the system that moves, its start and its times."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base.arrays import compiled_for_few_calls
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.spacecraft.rigid_body.arguments import make_part
from polhode.spacecraft.rigid_body.named import LAWS, MOUNTS, TORQUES, find_part
from polhode.spacecraft.rigid_body.table import EARTH, ControlTable, OrbitTable, RigidBodyTable, WheelTable
from polhode.spacecraft.systems.control_laws import AbstractControlLaw
from polhode.spacecraft.systems.controlled_wheels import ControlledWheels, ControlTorque
from polhode.spacecraft.systems.mounts import AbstractMount, AbstractMounted
from polhode.spacecraft.systems.rigid_body import RigidBody
from polhode.spacecraft.systems.wheels import HeldWheel, Wheel
from polhode.spacecraft.torques.base import AbstractTorque
from polhode.spacecraft.torques.earth_field import EarthDipoleField
from polhode.spacecraft.torques.gravity import GravityGradient
from polhode.spacecraft.torques.surfaces import EARTH_RADIUS
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, Float64


class Craft(NamedTuple):
    """The body of a spec with all its parts.

    Attributes:
        system: that moves.
        state: packed, at the start.
        orbit: None for none.
        law: of control, as it is in the system; None without control.
        wheels: the controlled wheels; None where there are none.
        wheel_tables: those of the wheels in the order of ``rates``: the controlled ones, then the others.
        rates: of the mounts at the start, as ``RigidBody.pack`` takes them.
        coordinates: likewise.
    """

    system: RigidBody
    state: Float64[Array, "n"]
    orbit: KeplerOrbit | None
    law: AbstractControlLaw | None
    wheels: ControlledWheels | None
    wheel_tables: tuple[WheelTable, ...]
    rates: list[Any]
    coordinates: list[Any]

    def pack_starts(self, spec: Spec[RigidBodyTable]) -> Float64[Array, "*start n"]:
        """Return the states (…, n) from which this craft starts by a spec whose numbers of [spin] are arrays."""
        attitude, velocity, momentum = _start(spec, self.orbit)
        return np.asarray(self.system.pack(attitude, velocity, momentum, self.rates, coordinates=self.coordinates))

    @property
    def falls_freely(self) -> bool:
        """Whether gravity's gradient acts alone, on a circular orbit, on a body without mounts."""
        torques, orbit = self.system.torques, self.orbit
        alone = len(torques) == 1 and isinstance(torques[0], GravityGradient) and not self.system.mounts
        return alone and orbit is not None and not float(orbit.eccentricity)


def build(spec: Spec[RigidBodyTable]) -> Craft:
    """Return the system of a spec and its start.

    Raises:
        InvalidInput: naming the table of what does not fit.
    """
    table = spec.system
    assert spec.body is not None
    orbit = None if table.orbit is None else make_orbit(table.orbit)
    elsewhere = {"orbit": orbit, "field": None if orbit is None else _make_field(orbit, table.orbit)}
    controlled, others = _sort_wheels(table)
    law = None if table.control is None else _make_law(table.control, elsewhere)
    attitude, velocity, momentum = _start(spec, orbit)
    law = None if law is None else law.started(0.0, attitude)
    mounts: list[AbstractMounted] = []
    rates: list[Any] = []
    coordinates: dict[int, Any] = {}
    if controlled and law is not None:
        mounts.append(_make_controlled_wheels(controlled, law))
        rates.append(np.array([wheel.rate for wheel in controlled]))
    for place, wheel in others:
        mounts.append(_make_at(f"wheel.{place + 1}", partial(_make_wheel, wheel)))
        rates.append(np.array(wheel.rate) if mounts[-1].state_size else None)
    for k, chosen in enumerate(table.mount):
        part = find_part(MOUNTS, chosen.type)
        mounts.append(_make_at(f"mount.{k + 1}", partial(make_part, part, chosen.values, elsewhere)))
        rate, coordinate = _make_at(f"mount.{k + 1}", partial(mounts[-1].start_of, chosen.values))
        rates.append(rate)
        coordinates[len(mounts) - 1] = coordinate
    torques: list[AbstractTorque] = []
    for k, chosen in enumerate(table.torque):
        part = find_part(TORQUES, chosen.type)
        torques.append(_make_at(f"torque.{k + 1}", partial(make_part, part, chosen.values, elsewhere)))
    if table.control is not None and table.control.by == "torque" and law is not None:
        torques.append(_make_at("control", partial(ControlTorque, law, table.control.limit)))
    system = RigidBody.from_body(spec.body, mounts, torques)
    places = [coordinates.get(k) for k in range(len(mounts))]
    state = system.pack(attitude, velocity, momentum, rates, coordinates=places)
    wheels = next((mount for mount in system.mounts if isinstance(mount, ControlledWheels)), None)
    acting = next((torque.law for torque in system.torques if isinstance(torque, ControlTorque)), None)
    return Craft(
        system, np.asarray(state), orbit, acting if wheels is None else wheels.law, wheels,
        (*controlled, *(wheel for _, wheel in others)), rates, places,
    )


def make_orbit(table: OrbitTable) -> KeplerOrbit:
    """Return the orbit of a table.

    Raises:
        InvalidInput: for values that no orbit has.
    """
    if table.period is not None:
        size = (table.gravitational_parameter * (table.period / (2.0 * math.pi)) ** 2) ** (1.0 / 3.0)
    else:
        size = table.semi_major_axis if table.altitude is None else EARTH_RADIUS + table.altitude
    assert size is not None
    lowest = size * (1.0 - table.eccentricity)
    if table.gravitational_parameter == EARTH and 0.0 < lowest < EARTH_RADIUS:
        raise InvalidInput(
            f"orbit: comes within {lowest / 1e3:.6g} km of the Earth's centre, and its surface is at "
            f"{EARTH_RADIUS / 1e3:.6g} km. Check its size, where an altitude is that of the semi-major axis, and its "
            "eccentricity, or give the gravitational_parameter of another body."
        )
    rate = math.sqrt(table.gravitational_parameter / size) / size if table.period is None else (
        2.0 * math.pi / table.period)
    return KeplerOrbit(
        rate, table.eccentricity, table.mean_anomaly, table.inclination, table.node, table.periapsis, size
    )


def usual_times(craft: Craft, spec: Spec[RigidBodyTable]) -> Float64[Array, "time"]:
    """Return the times of the spec, or usual ones, over orbits, settling times or turns."""
    orbits, turns, settlings = 2, 10, 20.0  # the last over the bandwidth
    usual = 100.0  # s, if nothing sets a pace
    if spec.times is not None:
        return spec.times
    velocity = np.linalg.norm(np.asarray(craft.system.vectors(craft.state).angular_velocity))
    bandwidth = getattr(craft.law, "bandwidth", None)
    if craft.orbit is not None:
        span = orbits * float(craft.orbit.period)
    elif bandwidth is not None:
        span = settlings / float(bandwidth)
    else:
        span = turns * 2.0 * math.pi / velocity if velocity > 0 else usual
    return np.linspace(0.0, span, spec.samples)


def _make_field(orbit: KeplerOrbit, table: OrbitTable | None) -> EarthDipoleField | None:
    """Return the Earth's field; None about another body, which has another one."""
    if table is None or table.gravitational_parameter != EARTH:
        return None
    return EarthDipoleField(orbit, table.greenwich)


def _sort_wheels(table: RigidBodyTable) -> tuple[list[WheelTable], list[tuple[int, WheelTable]]]:
    """Return the wheels under control, and the others with their places."""
    by_wheels = table.control is not None and table.control.by == "wheels"
    controlled, others = [], []
    for k, wheel in enumerate(table.wheel):
        if wheel.max_rate is not None and abs(wheel.rate) > wheel.max_rate:
            raise InvalidInput(
                f"wheel.{k + 1}: its rate at the start, {wheel.rate:.6g} rad/s, is beyond its max_rate, "
                f"{wheel.max_rate:.6g} rad/s, to which its motor drives it. Give a lower rate, or a higher limit."
            )
        if by_wheels and wheel.torque is None and wheel.drive in (None, "controlled"):
            controlled.append(wheel)
        else:
            others.append((k, wheel))
    return controlled, others


def _make_law(table: ControlTable, elsewhere: dict[str, object]) -> AbstractControlLaw:
    part = find_part(LAWS, table.type)
    return _make_at("control", partial(make_part, part, table.values, elsewhere))


def _make_controlled_wheels(wheels: list[WheelTable], law: AbstractControlLaw) -> ControlledWheels:
    limits = {}
    for key in ("max_torque", "max_rate"):
        values = [getattr(wheel, key) for wheel in wheels]
        limits[key] = None if None in values else np.array(values)
    axes, moments = np.array([wheel.axis for wheel in wheels]), np.array([wheel.moment for wheel in wheels])
    friction = np.array([wheel.friction for wheel in wheels])
    return _make_at("wheel", lambda: ControlledWheels(axes, moments, law, **limits, friction=friction))


def _make_wheel(wheel: WheelTable) -> AbstractMount:
    if wheel.drive == "constant-rate":
        return HeldWheel(wheel.axis, wheel.moment, wheel.rate)
    return Wheel(wheel.axis, wheel.moment, motor=wheel.torque, friction=wheel.friction)


def _make_at(place: str, make: Callable[[], Any]) -> Any:
    """Return the made object; errors name its place in the spec."""
    try:
        return make()
    except InvalidInput as error:
        raise InvalidInput(f"{place}: {error}") from None


def _start(spec: Spec[RigidBodyTable], orbit: KeplerOrbit | None) -> tuple[Array, Array | None, Array | None]:
    """Return attitude (…, 4) of, and Ω (…, 3) or else the whole L (…, 3) along, the given axes."""
    assert spec.body is not None
    moments, axes = spec.body.principal_moments, spec.body.principal_axes
    if not moments[0] > 0:
        raise InvalidInput(
            "the body is a thin rod: its moment about its own axis is zero, and its spin about it is undefined. "
            "Give it a radius, as a cylinder."
        )
    along, principal = spec.start(moments, axes)
    attitude = np.asarray(rotation.multiply(principal, rotation.conjugate(rotation.from_matrix(axes))))
    if spec.spin is not None and np.array_equal(spec.spin.attitude, (1.0, 0.0, 0.0, 0.0)):
        attitude = np.array([1.0, 0.0, 0.0, 0.0])  # without the rounding of a rotation there and back
    whole = spec.spin is not None and spec.spin.momentum is not None
    relative = spec.system.orbit is not None and spec.system.orbit.relative
    if relative and orbit is not None:
        if whole:
            raise InvalidInput("`orbit.relative` goes with an angular velocity; leave out `spin.momentum` or it.")
        frame, turning = map(np.asarray, _frame(orbit))
        attitude = rotation.multiply(frame, attitude)
        turning = rotation.rotate(rotation.conjugate(attitude), turning)
        return attitude, _in_given_axes(axes, along / moments) + turning, None
    if whole:
        return attitude, None, _in_given_axes(axes, along)
    return attitude, _in_given_axes(axes, along / moments), None


def _in_given_axes(axes: Float64[Array, "3 3"], vectors: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
    """Return vectors (…, 3) from the axes by columns, with the same bits of one as of many."""
    return (vectors[..., None, :] @ axes.T)[..., 0, :]


@compiled_for_few_calls
def _frame(orbit: KeplerOrbit) -> tuple[Array, Array]:
    """Return the axes that look down at the start (4,), and their angular velocity (3,) in space."""
    start = jnp.zeros(())
    return orbit.frame(start), orbit.turning_rate(start) * orbit.normal
