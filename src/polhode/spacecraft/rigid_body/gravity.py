"""A body under gravity's gradient alone on a circular orbit: the nearest rest, and whether the body stays at it."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.analysis.gravity_gradient import (
    CYLINDRICAL,
    DEBRA_DELP,
    GYROSCOPIC,
    HYPERBOLIC,
    LAGRANGE,
    STATIC,
    UNSTABLE,
    escape_energy,
    nearest_rest,
    spinning_equilibria,
)
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Answer, Group
from polhode.reports.wording import degrees
from polhode.spacecraft.rigid_body.build import Craft
from polhode.types import Float64

WHERE = {CYLINDRICAL: "along the orbit's normal", HYPERBOLIC: "across the radius"}
VERDICTS = {STATIC: "stable", GYROSCOPIC: "stable to first order", UNSTABLE: "unstable"}


class GravityLimits(NamedTuple):
    """What decides whether a rest can be left, and whether a body is symmetric."""

    escape_margin: float = 1e-9  # of the height to escape over; nearer to it, rounding could decide
    # difference of moments that are equal, of a body that spins about the axis of the third
    relative_moment: float = 1e-9


LIMITS = GravityLimits()


class GravityAnswers(NamedTuple):
    """Answers about rests under gravity's gradient.

    Attributes:
        group: of answers.
        summary: a sentence.
        notes: of the report.
    """

    group: Group
    summary: str
    notes: list[str]


def judge_gravity(craft: Craft, trajectory: Trajectory) -> GravityAnswers:
    """Return the answers about a motion under the gradient alone, see ``Craft.falls_freely``."""
    system = craft.system
    assert craft.orbit is not None and trajectory.attitude is not None
    n, moments = float(craft.orbit.mean_motion), np.asarray(system.moments)
    frames = np.asarray(craft.orbit.frame(jnp.asarray(trajectory.times)))
    relative = rotation.as_matrix(rotation.multiply(rotation.conjugate(frames), np.asarray(trajectory.attitude)))
    if (axis := _axis_of_symmetry(moments)) is not None and trajectory.angular_velocity is not None:
        spin = float(np.asarray(trajectory.angular_velocity)[0, axis])
        return _judge_axis(moments, axis, n, spin, np.asarray(relative)[:, :, axis])
    near = nearest_rest(relative[0], moments, n)
    rest = near.equilibrium
    verdict = {LAGRANGE: "stable", UNSTABLE: "unstable"}.get(rest.region, "undecided")
    # the angle θ between rotations has tr RᵀS = 1 + 2 cos θ, and |R − S|² = 8 sin² θ/2 keeps small ones
    away = 2.0 * np.arcsin(np.clip(np.linalg.norm(relative - near.turn, axis=(1, 2)) / math.sqrt(8.0), 0.0, 1.0))
    value, most = float(trajectory.balances["jacobi_integral"][0]), escape_energy(moments, n)
    room = abs(most) + abs(value)
    trapped = rest.region == LAGRANGE and value < most - LIMITS.escape_margin * room
    period = lambda rate: None if not rate else 2.0 * math.pi / rate  # noqa: E731
    librations = [period(rate) for rate in reversed(rest.roll_yaw_rates or ()) if rate]
    of_both = "periods of roll and yaw" if len(librations) == 2 else "period of roll or yaw, of which the other drifts"
    group = Group("Rest under gravity's gradient", [
        Answer("gravity.moments", moments[[rest.roll - 1, rest.pitch - 1, rest.yaw - 1]], "kg m²",
               "moments about roll, pitch and yaw", "ahead, across, down"),
        Answer("gravity.verdict", verdict, "", "verdict"),
        Answer("gravity.region", rest.region, "", "region"),
        Answer("gravity.rate", rest.growth, "1/s", "rate of growth" if rest.growth else ""),
        Answer("gravity.pitch_period", period(rest.pitch_rate), "s", "period of small pitch librations"),
        Answer("gravity.roll_yaw_periods", librations or None, "s", of_both),
        Answer("gravity.from_rest.start", float(away[0]), "rad", "angle from the rest at the start"),
        Answer("gravity.from_rest.largest", float(away.max()), "rad", "largest, at the samples"),
        Answer("gravity.jacobi_integral", value, "J"),
        Answer("gravity.escape_energy", most, "J"),
        Answer("gravity.stays", trapped, "", "stays for ever", "by the Jacobi integral",
               "yes, by the Jacobi integral" if trapped else "not proved"),
    ])
    swings = f"within {degrees(float(away.max()), 4)} of it in this motion"
    if trapped:
        said = f"The rest nearest to the start is stable, and by the Jacobi integral it can never leave it; {swings}."
    elif rest.region == LAGRANGE:
        said = f"The rest nearest to the start is stable, but this motion has enough energy to leave it; {swings}."
    elif rest.region == DEBRA_DELP:
        said = f"The rest nearest to the start is stable to first order alone, and losses would end that; {swings}."
    else:
        said = f"The rest nearest to the start is {verdict}; {swings}."
    notes = []
    if rest.region == DEBRA_DELP:
        notes.append("in the DeBra–Delp region the Jacobi integral has no minimum: any loss of energy makes it leave.")
    return GravityAnswers(group, said, notes)


def _axis_of_symmetry(moments: Float64[np.ndarray, "3"]) -> int | None:
    """Return the axis whose moment alone differs from the two others; None for other bodies."""
    for k in range(3):
        A, B, C = moments[(k + 1) % 3], moments[(k + 2) % 3], moments[k]
        if abs(A - B) <= LIMITS.relative_moment * A < abs(A - C):
            return k
    return None


def _judge_axis(
    moments: Float64[np.ndarray, "3"], axis: int, mean_motion: float, spin: float, axes: Float64[np.ndarray, "time 3"]
) -> GravityAnswers:
    """Return the answers about a symmetric body: its rate about the axis stays, and the axis can rest in the frame.

    Args:
        moments: principal ones.
        axis: that of symmetry.
        mean_motion: n of the orbit [rad/s].
        spin: the angular velocity along the axis, against the stars [rad/s].
        axes: it along the motion, in the orbit's frame, which looks ahead, against the normal, and down.
    """
    A, C = float(moments[(axis + 1) % 3]), float(moments[axis])
    # of a body that spins either way both ends of the axis count; in the frame of radius, velocity and normal
    path = np.stack([-axes[:, 2], axes[:, 0], -axes[:, 1]], axis=1)
    rests = spinning_equilibria(A, C, mean_motion, spin)
    away = [2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(path - rest.axis, axis=1), 0.0, 1.0)) for rest in rests]
    k = int(np.argmin([angles[0] for angles in away]))
    rest, angles = rests[k], away[k]
    verdict, where = VERDICTS.get(rest.region, "undecided"), WHERE.get(rest.case, "across the velocity")
    periods = None if rest.rates is None else [2.0 * math.pi / rate for rate in reversed(rest.rates) if rate]
    group = Group("Rest of the spin axis under gravity's gradient (Thomson)", [
        Answer("gravity.spin", spin, "rad/s", "spin, against the stars"),
        Answer("gravity.case", rest.case, "", "nearest rest", where, f"{rest.case}, {where}"),
        Answer("gravity.verdict", verdict, "", "verdict"),
        Answer("gravity.region", rest.region, "", "region"),
        Answer("gravity.rate", rest.growth, "1/s", "rate of growth" if rest.growth else ""),
        Answer("gravity.axis_periods", periods or None, "s", "periods of small motions of the axis"),
        Answer("gravity.from_rest.start", float(angles[0]), "rad", "angle from the rest at the start"),
        Answer("gravity.from_rest.largest", float(angles.max()), "rad", "largest, at the samples"),
    ])
    swings = f"within {degrees(float(angles.max()), 4)} of it in this motion"
    why = {
        STATIC: "stable, as its energy at this spin is the least",
        GYROSCOPIC: "stable to first order, held by the spin, and losses would end that",
    }.get(rest.region, verdict)
    said = f"The rest of the spin axis nearest to the start, {where}, is {why}; the axis stays {swings}."
    return GravityAnswers(group, said, [])
