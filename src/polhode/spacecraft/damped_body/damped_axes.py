"""Rotation about the principal axes of a body that loses energy."""

from __future__ import annotations

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only
from polhode.analysis._reasons import SettlesOnCircle, SphereOfRests
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.first_method import first_method
from polhode.spacecraft.systems.torqued_body import TorquedBody
from polhode.systems.double_bracket import DoubleBracket
from polhode.types import Array


@known_numbers_only
def damped_axis_stability(
    system: DoubleBracket | TorquedBody, momentum_norm: float
) -> tuple[Stability, Stability, Stability]:
    """Return verdicts on L along each principal axis of a body with losses, as a direction with |L| frozen.

    Under drag L itself dies away; the verdict is whether it meanwhile turns towards the axis or away from it, by
    the exponents of ṅ, the field less its part along n = L/|L|. Torques that ask for the attitude are left out. Across
    a circle of axes of equal moment, neighbours that settle on the circle as near as they start count as stable.

    Args:
        system: the body and its losses.
        momentum_norm: |L| [kg m²/s].

    Raises:
        InvalidInput: for another system, or a |L| that is not positive and finite.

    Source: Lyapunov's first method; for the double bracket, Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys.
    175 (1996) 1, §3.

    >>> verdicts = damped_axis_stability(DoubleBracket((1.0, 2.0, 3.0), 0.1), 1.0)
    >>> [verdict.verdict for verdict in verdicts]
    ['unstable', 'unstable', 'stable']
    """
    check.instance("system", system, (DoubleBracket, TorquedBody), "a DoubleBracket or a TorquedBody")
    norm = check.number("momentum_norm", momentum_norm, "kg m²/s", above=0)
    if isinstance(system, TorquedBody):
        system = TorquedBody(system.moments, [torque for torque in system.torques if not torque.needs_attitude])

    rates = [np.asarray(_turning_rates(system, norm, axis)) for axis in np.eye(3)]
    first, second, third = (_verdict(rates[k], np.asarray(system.moments), k) for k in range(3))
    return first, second, third


@compiled_for_few_calls
def _turning_rates(system: DoubleBracket | TorquedBody, norm: float, direction: Array) -> Array:
    """Return the derivative (3, 3) of the rate at which the direction of L turns, by that direction."""

    def turning_rate(direction: Array) -> Array:
        field = system.vector_field(0.0, norm * direction) / norm
        return field - direction * jnp.sum(field * direction)

    return jax.jacfwd(turning_rate)(direction)


def _verdict(rates: Array, moments: Array, k: int) -> Stability:
    stability = first_method(rates, np.delete(np.eye(3), k, axis=1))
    return stability if stability.verdict != "undecided" else _along_family(stability, moments, k)


def _along_family(stability: Stability, moments: Array, k: int) -> Stability:
    """Return the verdict where only drift along other axes of the same moment, all at rest, does not decay.

    Across a circle of equilibria the exponent decides: where it is negative, neighbours settle on the circle as near as
    they started.
    """
    alike = int((moments == moments[k]).sum())
    if alike == 3:
        return replace(stability, verdict="stable", reason=SphereOfRests())
    rest = float(np.min(stability.spectrum.real))
    if alike == 2 and rest < 0 and np.min(np.abs(stability.spectrum)) < abs(rest) * 1e-6:
        return replace(stability, verdict="stable", rate=rest, reason=SettlesOnCircle(rest))
    return stability
