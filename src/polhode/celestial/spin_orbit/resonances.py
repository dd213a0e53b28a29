"""The spin-orbit problem from periapsis to periapsis: sections, Lyapunov exponents, resonances and their overlap."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.celestial.spin_orbit._periapsis_map import Kicks, carry_neighbours, section, tabulate
from polhode.celestial.spin_orbit.system import SpinOrbit
from polhode.errors import InvalidInput, shown
from polhode.special.elliptic import complete_k
from polhode.types import Array, ArrayLike, Float64, Real

TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Resonance:
    """A commensurability of spin and orbit: θ̇ = p n on average.

    Attributes:
        order: p, turns per orbit.
        rate: p n [rad/s].
        strength: H(p, e), the mean of (a/r)³ cos 2(f − pM) over an orbit.
        half_width: n ω0 √|H| [rad/s], of the zone of libration in θ̇; also the frequency of small librations.
        stable_angle: θ at periapsis about which the spin librates [rad], 0 or π/2, and its opposite; None for H = 0.
    """

    order: float
    rate: float
    strength: float
    half_width: float
    stable_angle: float | None


@known_numbers_only
def poincare_section(
    system: SpinOrbit, states: Real[ArrayLike, "*batch 2"], periods: int, steps: int | None = None
) -> Float64[Array, "*batch {periods}+1 2"]:
    """Return the states at one periapsis after another, (…, periods + 1, 2), the given ones first.

    Args:
        system: the spin-orbit problem.
        states: (…, 2) angle θ [rad] and rate θ̇ [rad/s] at a periapsis.
        periods: number of orbits.
        steps: per orbit; by default 128/√(1 − e). Spins much faster than three turns an orbit need more.

    Returns:
        Angles within [−π, π], from the direction of the periapsis, and rates.

    Raises:
        InvalidInput: for states of another shape, or numbers that are not positive integers.

    Source: Wisdom, Peale & Mignard, Icarus 58 (1984) 137.

    >>> libration = poincare_section(SpinOrbit(0.2, 0.1), [0.1, 1.0], 200)
    >>> libration.shape, bool(abs(libration[:, 0]).max() < 0.2)
    ((201, 2), True)
    """
    start, kicks = scale_start(system, states), make_kicks(system, steps)
    points = np.asarray(section(kicks, start, check.whole("periods", periods, 1)))[..., :2]
    points = np.moveaxis(np.concatenate([start[None], points]), 0, -2)
    return points * np.array([1.0, float(system.mean_motion)])


@known_numbers_only
def tangent_map(
    system: SpinOrbit, states: Real[ArrayLike, "*batch 2"], periods: int = 1, steps: int | None = None
) -> Float64[Array, "*batch 2 2"]:
    """Return the derivative (…, 2, 2) of (θ, θ̇/n) after some periods by (θ, θ̇/n) at a periapsis; its determinant is 1.

    Args:
        system: the spin-orbit problem.
        states: (…, 2) angle [rad] and rate [rad/s] at a periapsis.
        periods: number of orbits.
        steps: per orbit, as in ``poincare_section``.
    """
    start, kicks = scale_start(system, states), make_kicks(system, steps)
    sides = np.broadcast_to(np.eye(2), (*start.shape, 2))
    _, grown, _ = carry_neighbours(kicks, start, sides, check.whole("periods", periods, 1), False)
    return np.asarray(grown)


@known_numbers_only
def lyapunov_exponent(
    system: SpinOrbit, states: Real[ArrayLike, "*batch 2"], periods: int, steps: int | None = None
) -> Float64[Array, "*batch {periods}"]:
    """Return the estimates (…, periods) [1/s] of the largest Lyapunov exponent after each period; the last is the best.

    ln |δ(t)|/t for a neighbour δ = (δθ, δθ̇/n) carried by the tangent map. In a chaotic zone it settles at a positive
    value; where the motion is quasi-periodic it falls as ln t/t.

    Args:
        system: the spin-orbit problem.
        states: (…, 2) angle [rad] and rate [rad/s] at a periapsis.
        periods: number of orbits.
        steps: per orbit, as in ``poincare_section``.

    Source: Wisdom, Peale & Mignard, Icarus 58 (1984) 137; Benettin et al., Meccanica 15 (1980) 9.
    """
    return follow_neighbours(system, states, check.whole("periods", periods, 1), steps)[1]


def follow_neighbours(
    system: SpinOrbit, states: Real[ArrayLike, "*batch 2"], periods: int, steps: int | None
) -> tuple[Float64[Array, "{periods} *batch 3"], Float64[Array, "*batch {periods}"]]:
    """Return the section as the map has it, and the exponents of ``lyapunov_exponent`` along it."""
    start, kicks = scale_start(system, states), make_kicks(system, steps)
    side = np.full((*start.shape, 1), math.sqrt(0.5))
    points, _, growth = carry_neighbours(kicks, start, side, periods, True)
    times = TURN / float(system.mean_motion) * np.arange(1, periods + 1)
    return np.asarray(points), np.moveaxis(np.cumsum(np.asarray(growth)[..., 0], axis=0), 0, -1) / times


@known_numbers_only
def resonances(system: SpinOrbit, largest: float = 3.0) -> list[Resonance]:
    """Return the resonances p = 1/2, 1, 3/2, … up to the largest order.

    θ̇ = p n + γ̇ obeys γ̈ = −½ n² ω0² H sin 2γ on average over an orbit, a pendulum, as long as the resonances are apart.

    Source: Goldreich & Peale, Astron. J. 71 (1966) 425; Murray & Dermott, *Solar System Dynamics*, ch. 5.

    >>> [(r.order, round(r.strength, 4)) for r in resonances(SpinOrbit(0.02, 0.206), 1.5)]  # Mercury
    [(0.5, -0.1025), (1.0, 0.8954), (1.5, 0.6552)]
    """
    n, e = float(system.mean_motion), float(system.eccentricity)
    zones = []
    for order in np.arange(0.5, largest + 0.25, 0.5):
        strength = resonance_strength(float(order), e)
        # γ̇² = n² ω0² |H| cos² γ on the separatrix of the pendulum, about γ = 0 for H > 0; its small librations have
        # the frequency n ω0 √|H|
        width = n * float(system.asphericity) * math.sqrt(abs(strength))
        angle = None if strength == 0.0 else 0.0 if strength > 0.0 else 0.5 * math.pi
        zones.append(Resonance(float(order), float(order) * n, strength, width, angle))
    return zones


@known_numbers_only
def resonance_strength(order: float, eccentricity: float) -> float:
    """Return H(p, e) = (1/2π) ∫ (a/r)³ cos 2(f − pM) dM over one orbit, 2p an integer.

    By the trapezoidal rule in eccentric anomaly, where dM = (r/a) dE and the integrand is periodic and analytic up to
    Im E = arccosh 1/e: the error is exponentially small.

    Args:
        order: p, half an integer.
        eccentricity: 0 ≤ e < 1.

    Raises:
        InvalidInput: for an order that is not a half-integer, or an orbit that is not an ellipse.
    """
    decay = 60.0  # e-foldings of that rule's error, which is exponentially small in its nodes
    fewest_nodes = 64  # of the trapezoidal rule
    e, p = float(eccentricity), float(order)
    if not (2.0 * p).is_integer():
        check.refuse("`order` of a resonance", "half an integer", order, "It is turns per orbit.")
    if not 0.0 <= e < 1.0:
        raise InvalidInput(f"`eccentricity` must be within 0 ≤ e < 1; got {shown(eccentricity)}.")
    count = fewest_nodes + 16 * math.ceil(abs(p)) + (math.ceil(decay / math.acosh(1.0 / e)) if e > 1e-16 else 0)
    E = TURN * np.arange(count) / count
    sine = np.sin(0.5 * E)
    ratio = (1.0 - e) + 2.0 * e * sine**2
    direction = ((1.0 - e) - 2.0 * sine**2 + 1j * math.sqrt((1.0 - e) * (1.0 + e)) * np.sin(E)) / ratio  # exp(i f)
    # (a/r)³ dM = (a/r)² dE, and e^{2if} from the direction
    values = (direction**2 * np.exp(-2j * p * (E - e * np.sin(E)))).real / ratio**2
    strength = math.fsum(values) / count
    # a sum that vanishes, as on a circular orbit, leaves rounding
    return 0.0 if abs(strength) < 4e-16 * float(np.abs(values).max()) else strength


def overlap_asphericity(zones: Sequence[Resonance]) -> float | None:
    """Return the least asphericity ω0 = √(3(B − A)/C) at which two neighbours of these resonances touch.

    Half-widths add up to the distance, ω0 (√|H(p)| + √|H(p + ½)|) = ½, by Chirikov's criterion. None where no two
    neighbours have any strength, as on a circular orbit.

    Source: Chirikov, Phys. Rep. 52 (1979) 263; Wisdom, Peale & Mignard, Icarus 58 (1984) 137.
    """
    roots = [math.sqrt(abs(resonance.strength)) for resonance in zones]
    pairs = [a + b for a, b in itertools.pairwise(roots) if a and b]
    return 0.5 / max(pairs) if pairs else None


@known_numbers_only
def overlap_threshold(eccentricity: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
    """Return the asphericity 1/(2 + √(14 e)) from which the zones of p = 1 and p = 3/2 touch: chaos between them.

    Chirikov's criterion with H(1) ≈ 1 and H(3/2) ≈ 7e/2.

    Source: Wisdom, Peale & Mignard, Icarus 58 (1984) 137; Chirikov, Phys. Rep. 52 (1979) 263.
    """
    # ω0 (1 + √(7e/2)) = ½
    return 1.0 / (2.0 + np.sqrt(14.0 * np.asarray(eccentricity, dtype=float)))


def steps_per_orbit(system: SpinOrbit) -> float:
    """Return the steps with which sections of regular motion are right to 1e-10 after ten orbits."""
    return 128 / math.sqrt(1.0 - float(system.eccentricity))


def make_kicks(system: SpinOrbit, steps: int | None) -> Kicks:
    default = math.ceil(steps_per_orbit(system))
    return tabulate(system, default if steps is None else check.whole("steps", steps, 1))


def scale_start(system: SpinOrbit, states: Real[ArrayLike, "*batch 2"]) -> Float64[Array, "*batch 2"]:
    return np.asarray(system.check_state(states)) / (1.0, float(system.mean_motion))


@known_numbers_only
def libration_period(system: SpinOrbit, state: Real[ArrayLike, "2"]) -> float | None:
    """Return the period of libration on a circular orbit [s], exact at any amplitude; None for a spin that circulates.

    About the radius φ = θ − n t moves as a pendulum, φ̈ = −½ n² ω0² sin 2φ, whose period is 4 K(k)/(n ω0) with
    k² = sin² φ + (φ̇/(n ω0))².

    Args:
        system: the spin-orbit problem, of eccentricity zero.
        state: (2,) angle θ [rad] and rate θ̇ [rad/s] at t = 0.

    Raises:
        InvalidInput: for an eccentric orbit, on which a libration has no one period.

    >>> quiet = libration_period(SpinOrbit(0.5, 0.0), (0.0, 1.0))
    >>> print(quiet is not None and round(quiet / TURN, 12))
    2.0
    """
    if float(system.eccentricity):
        raise InvalidInput(
            f"the orbit must be a circle; its eccentricity is {float(system.eccentricity):g}. `spin_motion` finds "
            "librations on others."
        )
    angle, rate = (float(x) for x in np.asarray(state, dtype=float))
    small = float(system.mean_motion) * float(system.asphericity)
    if small == 0.0:
        return None
    # 1 − k² = cos² φ − (φ̇/(n ω0))², a difference of squares without cancellation at a saddle
    side = (rate - float(system.mean_motion)) / small
    rest = (math.cos(angle) - side) * (math.cos(angle) + side)
    return 4.0 * float(complete_k(rest)) / small if rest > 0.0 else None
