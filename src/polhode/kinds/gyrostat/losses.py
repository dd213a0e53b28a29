"""The effect of losses in platform and rotor on small nutation about the rotor's axis."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode.analysis.dual_spin import DualSpinDamping, dual_spin_damping
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.reports.answer import Answer, Group
from polhode.reports.wording import duration
from polhode.systems.body_with_rotor import find_direction
from polhode.types import Array, Float64

EFFECTS = {"calm": "calm nutation", "raise": "raise nutation", "leave": "leave it, to first order"}


class LossLimits(NamedTuple):
    """A number that decides whether the damping of a dual-spin body is judged."""

    max_asymmetry: float = 0.01  # of a moment: how far a body may be from one of revolution about the rotor's axis


LIMITS = LossLimits()


def judge_losses(table: GyrostatTable, body: Body, angular_velocity: Float64[Array, "3"]) -> DualSpinDamping | None:
    """Return the effect of losses by the criterion of Landon and Iorillo; None where it does not hold.

    It holds for small nutation of a craft that is axisymmetric about its rotor's axis within one per cent.

    Args:
        table: of the rotor.
        body: with the rotor locked.
        angular_velocity: Ω (3,) at the start [rad/s, given axes].

    Raises:
        InvalidInput: for losses in a part that feels the nutation at rest.
    """
    axis, inertia = find_direction(table.rotor_axis), np.asarray(body.inertia)
    along = float(axis @ inertia @ axis)
    across = 0.5 * (float(np.trace(inertia)) - along)
    off = inertia - across * np.eye(3) - (along - across) * np.outer(axis, axis)
    platform, spin = along - table.rotor_moment, float(axis @ angular_velocity)
    momentum = along * spin + table.rotor_moment * table.rotor_rate
    if np.abs(off).max() > LIMITS.max_asymmetry * across or not platform > 0.0 or momentum == 0.0:
        return None
    losses = (table.platform_loss or 0.0, table.rotor_loss or 0.0)
    try:
        return dual_spin_damping(across, (platform, table.rotor_moment), (spin, spin + table.rotor_rate), losses)
    except InvalidInput as error:
        raise InvalidInput(f"system.platform_loss, system.rotor_loss: {error}") from None


def describe_losses(table: GyrostatTable, damping: DualSpinDamping) -> Group:
    """Return the answers."""
    platform, rotor = damping.effects
    given = table.platform_loss is not None or table.rotor_loss is not None
    time = damping.time_constant if given and math.isfinite(damping.time_constant) else None
    sense = None if time is None else f"{duration(abs(time))}, {'decays' if time > 0.0 else 'grows'} by e"
    return Group("Losses, at small nutation about the rotor's axis", [
        Answer("losses.nutation_rate", damping.nutation_rate, "rad/s", "nutation in space", "h/A"),
        Answer("losses.platform", platform, "", "losses in the body", "", EFFECTS[platform]),
        Answer("losses.rotor", rotor, "", "losses in the rotor", "", EFFECTS[rotor]),
        Answer("losses.time_constant", time, "s", "nutation angle", "negative where it grows", sense),
    ])
