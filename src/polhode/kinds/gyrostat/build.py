"""From the spec of a body with a rotor to the system that moves, and its samples."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis.gyrostat_rotations import cleaned
from polhode.bodies.body import Body, principal_axes
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.length import ADAPTIVE, SPLITTING, TURNING, check_length, equal_steps
from polhode.reports.wording import vector
from polhode.simulation import simulate
from polhode.systems.gyrostat import Gyrostat, TorquedGyrostat
from polhode.types import Array, ArrayLike, Float64, Real

TURNS = 10
STEP_ANGLE = 0.05  # rad by which the faster of body and momentum turns in a step
ORDER = 6


class Built(NamedTuple):
    """What moves, and how it starts.

    Attributes:
        moments: (3,) of the motion: rotor locked, or of a free rotor less its axial moment [kg m²].
        axes: (3, 3) their axes by columns in the given ones; the vectors below are along them.
        along: (3,) unit vector of the rotor's axis.
        momentum: of the rotor along its axis, relative to the body or, of a free one, whole [kg m²/s].
        velocity: (3,) Ω [rad/s].
        total: (3,) L of body and rotor [kg m²/s].
        attitude: (4,) unit quaternion, these axes → space.
    """

    moments: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    along: Float64[Array, "3"]
    momentum: float
    velocity: Float64[Array, "3"]
    total: Float64[Array, "3"]
    attitude: Float64[Array, "4"]


def built(spec: Spec) -> Built:
    """Return what a spec asks for.

    Raises:
        InvalidInput: for a rotor that does not fit into the body.
    """
    table = spec.system
    assert isinstance(table, GyrostatTable) and spec.body is not None
    axis = unit(table.rotor_axis)
    _check_fits(spec.body, axis, table.rotor_moment)
    free = table.rotor_drive == "free" or table.motor_torque is not None
    moments, axes = spec.body.principal_moments, spec.body.principal_axes
    velocity, attitude = _start(spec, table.rotor_moment * table.rotor_rate * axis)
    if free:
        moments, axes = principal_axes(spec.body.inertia - table.rotor_moment * np.outer(axis, axis))
    along, velocity = cleaned(axes.T @ axis), axes.T @ velocity
    attitude = rotation.multiply(attitude, rotation.from_matrix(axes))
    momentum = table.rotor_moment * (table.rotor_rate + (float(along @ velocity) if free else 0.0))
    return Built(moments, axes, along, momentum, velocity, moments * velocity + momentum * along, attitude)


def sampled(spec: Spec, made: Built) -> Trajectory:
    """Return the motion at the times of the spec, or for ten turns.

    Raises:
        InvalidInput: for a run longer than can be waited for.
    """
    table, times = spec.system, spec.times
    assert isinstance(table, GyrostatTable)
    if times is None:
        times = np.linspace(0.0, _span(table, made), spec.samples)
    state = np.concatenate([made.attitude, made.total])
    span, turning = float(np.ptp(times)), _rate(made)
    if table.motor_torque is None:
        steps = equal_steps(span, turning, table.step)
        check_length(spec.until, times, steps, SPLITTING, "A longer `system.step` takes less.")
        step = table.step or (STEP_ANGLE / turning if turning else None)
        return simulate(Gyrostat(made.moments, made.momentum * made.along), state, times, order=ORDER, step=step)
    system = TorquedGyrostat(made.moments, made.along, table.rotor_moment, table.motor_torque)
    steps = max(_driven_steps(table, made, span), span / (table.step or math.inf))
    shown = check_length(spec.until, times, steps, ADAPTIVE)
    return simulate(system, np.append(state, made.momentum), times, step=table.step, progress=shown)


def unit(values: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return a vector's direction, however long it is."""
    array = np.asarray(values, dtype=float)
    array = array / np.abs(array).max()  # so that squares neither vanish nor overflow
    return array / np.linalg.norm(array)


def _check_fits(body: Body, axis: Array, moment: float) -> None:
    """Refuse a rotor whose inertia, at least that of a thin disk, leaves none that a carrier could have."""
    inertia = body.inertia - 0.5 * moment * (np.eye(3) + np.outer(axis, axis))
    try:
        fits = bool(Body(None, (0.0, 0.0, 0.0), inertia).principal_moments[0] > 0)
    except InvalidInput:
        fits = False
    if not fits or not axis @ body.inertia @ axis > moment:
        raise InvalidInput(
            f"`system.rotor_moment` must be that of a part of the body; got {moment:.6g} kg m², without which the body "
            f"would be left with moments of at most {vector(principal_axes(inertia)[0])} kg m². No body has these; "
            "check rotor_moment and rotor_axis, and that [body] has the rotor in it."
        )


def _start(spec: Spec, rotor: Array) -> tuple[Array, Array]:
    """Return Ω (3,) along the given axes and their attitude (4,); a momentum in the spec is the whole one.

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
    return axes @ (momentum / moments), rotation.multiply(attitude, back)


def _rate(made: Built) -> float:
    """Return how fast body or momentum turn [rad/s]; with a fast rotor L goes round a body that hardly turns."""
    return max(float(np.linalg.norm(made.velocity)), float(np.linalg.norm(made.total)) / float(np.min(made.moments)))


def _driven_steps(table: GyrostatTable, made: Built, span: float) -> float:
    """Return how many adaptive steps a run takes at least: L stays in space, so the carrier turns back as h grows.

    L turns in the carrier by the whole angle, the quaternion of a steady rotation by half of it: twice as many steps.
    """
    grown = 0.5 * abs(table.motor_torque or 0.0) * span * float(np.linalg.norm(made.along / made.moments))
    turned = (grown - float(np.linalg.norm(made.total)) / float(np.min(made.moments))) * span
    return 2.0 * TURNING * max(turned, 0.0)


def _span(table: GyrostatTable, made: Built) -> float:
    """Return ten turns [s], or of a body at rest the time in which its motor gives the rotor ten."""
    slowest = float(np.linalg.norm(made.total)) / float(np.max(made.moments))
    turning = max(float(np.linalg.norm(made.velocity)), slowest)
    if turning:
        return TURNS * 2.0 * math.pi / turning
    torque = abs(table.motor_torque or 0.0)
    return math.sqrt(4.0 * math.pi * TURNS * table.rotor_moment / torque) if torque else 1.0
