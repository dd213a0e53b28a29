"""What gravity's gradient alone does with a body on a circular orbit: which rest is near, and whether it stays."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.analysis.gravity_gradient import DEBRA_DELP, LAGRANGE, UNSTABLE, escape_energy, nearest_rest
from polhode.kinds.base import Spec
from polhode.kinds.rigid_body.build import Craft
from polhode.kinds.rigid_body.table import RigidBodyTable
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Answer, Group
from polhode.reports.wording import degrees
from polhode.systems.torques.gravity import GravityGradient

SURE = 1e-9  # of the height to escape over: nearer to it, rounding could decide


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


def judge_gravity(spec: Spec[RigidBodyTable], craft: Craft, trajectory: Trajectory) -> GravityAnswers | None:
    """Return the answers; None unless the gradient acts alone, on a circular orbit, on a body without mounts."""
    system = craft.system
    alone = len(system.torques) == 1 and isinstance(system.torques[0], GravityGradient) and not system.mounts
    if not alone or craft.orbit is None or float(craft.orbit.eccentricity) or trajectory.attitude is None:
        return None
    n, moments = float(craft.orbit.mean_motion), np.asarray(system.moments)
    frames = np.asarray(craft.orbit.frame(jnp.asarray(trajectory.times)))
    turned = rotation.as_matrix(rotation.multiply(rotation.conjugate(frames), np.asarray(trajectory.attitude)))
    near = nearest_rest(turned[0], moments, n)
    rest = near.equilibrium
    verdict = {LAGRANGE: "stable", UNSTABLE: "unstable"}.get(rest.region, "undecided")
    # the angle θ between rotations has tr RᵀS = 1 + 2 cos θ, and |R − S|² = 8 sin² θ/2 keeps small ones
    away = 2.0 * np.arcsin(np.clip(np.linalg.norm(turned - near.turn, axis=(1, 2)) / math.sqrt(8.0), 0.0, 1.0))
    value, most = float(trajectory.balances["jacobi_integral"][0]), escape_energy(moments, n)
    room = abs(most) + abs(value)
    trapped = rest.region == LAGRANGE and value < most - SURE * room
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
    ])  # fmt: skip
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
