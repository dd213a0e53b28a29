"""From the spec of a body with a rotor to the system that moves, and its samples."""

from __future__ import annotations

import math

import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.systems.base import AbstractSystem
from polhode.systems.body_with_rotor import RotorInBody, find_direction, rotor_in_body, rotor_misfit
from polhode.systems.gyrostat import TorquedGyrostat
from polhode.types import Array, Float64


def build(spec: Spec[GyrostatTable]) -> RotorInBody:
    """Return the gyrostat of a spec and its start, or the starts of many, where numbers of [spin] are arrays.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    table = spec.system
    assert spec.body is not None
    if why := rotor_misfit(spec.body, table.rotor_axis, table.rotor_moment):
        raise InvalidInput(f"`system.rotor_moment` {why}")
    rotor = table.rotor_moment * table.rotor_rate * find_direction(table.rotor_axis)
    velocity, attitude = _start(spec, rotor)
    free = table.rotor_drive == "free" or table.motor_torque is not None
    return rotor_in_body(
        spec.body, table.rotor_axis, table.rotor_moment, table.rotor_rate, velocity, attitude, free=free
    )


def make_system(table: GyrostatTable, assembly: RotorInBody) -> AbstractSystem:
    """Return what moves."""
    if table.motor_torque is None:
        return assembly.gyrostat
    return TorquedGyrostat(assembly.moments, assembly.along, table.rotor_moment, table.motor_torque)


def pack_start(table: GyrostatTable, assembly: RotorInBody) -> Float64[Array, "*start state"]:
    """Return the states (…, n) at the start."""
    parts = [assembly.attitude, assembly.total]
    if table.motor_torque is not None:
        parts.append(np.asarray(assembly.momentum)[..., None])
    shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    return np.concatenate([np.broadcast_to(part, (*shape, part.shape[-1])) for part in parts], axis=-1)


def _start(spec: Spec[GyrostatTable], rotor: Array) -> tuple[Array, Array]:
    """Return Ω (…, 3) along the given axes and their attitude (…, 4); a momentum in the spec is the whole one.

    Args:
        spec: with the start.
        rotor: (3,) relative momentum of the rotor [kg m²/s, given axes].
    """
    assert spec.body is not None
    moments, axes = spec.body.principal_moments, spec.body.principal_axes
    momentum, attitude = spec.start(moments, axes)
    if spec.spin is not None and spec.spin.momentum is not None:
        momentum = momentum - axes.T @ rotor
    back = rotation.conjugate(rotation.from_matrix(axes))
    return ((momentum / moments)[..., None, :] @ axes.T)[..., 0, :], rotation.multiply(attitude, back)


def usual_span(table: GyrostatTable, assembly: RotorInBody) -> float:
    """Return ten turns [s], or of a body at rest the time in which its motor gives the rotor ten."""
    turns = 10
    if assembly.usual_rate:
        return turns * 2.0 * math.pi / assembly.usual_rate
    torque = abs(table.motor_torque or 0.0)
    return math.sqrt(4.0 * math.pi * turns * table.rotor_moment / torque) if torque else 1.0
