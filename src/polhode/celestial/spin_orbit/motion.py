"""The motion of a spin over thousands of orbits: chaotic or regular, in a resonance or not."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.celestial.spin_orbit.resonances import (
    follow_neighbours,
    resonance_strength,
    scale_start,
    steps_per_orbit,
)
from polhode.celestial.spin_orbit.system import SpinOrbit
from polhode.types import Array, ArrayLike, Float64, Real

TURN = 2.0 * math.pi


class MotionLimits(NamedTuple):
    """What decides how far a spin is followed, and whether it is chaotic, regular or in libration.

    Neighbours of a quasi-periodic motion part as t: ln|δ| stays within a few units of ln t, and rises by ln 2 as t
    doubles. Of 448 regular starts on nine orbits none exceeded ln t by more than 2.7 or rose by more than 0.77.
    """

    max_orbits: int = 10_000  # of a run whose number of orbits is not given
    min_orbits: int = 200  # of such a run, on very eccentric orbits and of very fast spins too
    max_kicks: float = 3e7  # of a run's map: a few seconds
    fast_spin: float = 3.0  # turns per orbit, from which the map takes more steps
    chaotic_excess: float = 20.0  # of ln|δ| over ln t, from which a motion is chaotic: a factor of half a billion
    regular_excess: float = 6.0  # of ln|δ| over ln t, up to which it may be regular
    regular_rise: float = 1.5  # of ln|δ| in the second half, up to which it may be regular
    min_librations: float = 3.0  # of a run, for a libration to be distinguished from slow rotation


LIMITS = MotionLimits()


class Libration(NamedTuple):
    """Swinging about a resonance.

    Attributes:
        order: p, turns per orbit on average, exactly.
        angle: mean θ at periapsis [rad] within ±π/2; half a turn makes no difference.
        amplitude: half the range of θ at periapsis [rad].
    """

    order: float
    angle: float
    amplitude: float


class SpinMotion(NamedTuple):
    """The motion of a spin.

    Attributes:
        orbits: number of orbits followed.
        verdict: on these orbits; ``spin_motion`` says how far it holds.
        exponents: (orbits,) estimates of the largest Lyapunov exponent after each orbit [1/s].
        mean_rate: mean θ̇ [rad/s].
        libration: of a motion that is not chaotic, where it is caught in a resonance; else None.
        section: (orbits + 1, 2) angle [rad] and rate [rad/s] at each periapsis, as of ``poincare_section``.
    """

    orbits: int
    verdict: Literal["chaotic", "regular", "undecided"]
    exponents: Float64[Array, "periods"]
    mean_rate: float
    libration: Libration | None
    section: Float64[Array, "points 2"]

    @property
    def exponent(self) -> float:
        """The last and best estimate of the largest Lyapunov exponent [1/s]."""
        return float(self.exponents[-1])

    @property
    def lyapunov_time(self) -> float | None:
        """1/λ of a chaotic motion [s], in which neighbours part by a factor of e; None of others."""
        return 1.0 / self.exponent if self.verdict == "chaotic" else None

    def predictable_time(self, error: float) -> float | None:
        """Return the time [s] in which neighbours of a chaotic motion part from an error [rad] to one radian."""
        return math.log(1.0 / error) / self.exponent if self.verdict == "chaotic" else None

    def regular_exponent(self, mean_motion: float) -> float:
        """Return ln(nt)/t [1/s], about the exponent of a regular motion after as many orbits."""
        span = self.orbits * (TURN / mean_motion)
        return math.log(mean_motion * span) / span


@known_numbers_only
def spin_motion(system: SpinOrbit, state: Real[ArrayLike, "2"], orbits: int | None = None) -> SpinMotion:
    """Follow one spin from a periapsis on.

    Chaos is positive evidence: neighbours are half a billion times as far apart as they would be if their distance grew
    in proportion to time. "Regular" means that no chaos showed; a chaotic motion may cling to an island for longer than
    it was followed. On a circular orbit, or of a body with A = B, all motions are those of a pendulum or free, and none
    is chaotic.

    The mean rate of a motion that is not chaotic is averaged with weights that vanish smoothly at both ends, and so
    converges faster than any power of the number of orbits.

    Args:
        system: the spin-orbit problem.
        state: (2,) angle θ [rad] and rate θ̇ [rad/s] at a periapsis.
        orbits: number; by default up to ten thousand, less on very eccentric orbits and of very fast spins.

    Source: Das, Saiki, Sander & Yorke, Nonlinearity 30 (2017) 4111 (weights).

    >>> moon = spin_motion(SpinOrbit(0.1, 0.05), [0.2, 1.0], 1000)
    >>> moon.verdict, moon.libration.order, round(moon.mean_rate, 9)
    ('regular', 1.0, 1.0)
    """
    n, e, start = float(system.mean_motion), float(system.eccentricity), scale_start(system, state)
    steps = steps_for(system, float(start[1]))
    if orbits is None:
        orbits = int(np.clip(LIMITS.max_kicks / (9 * steps), LIMITS.min_orbits, LIMITS.max_orbits))
    orbits = check.whole("orbits", orbits, 1)
    points, exponents = follow_neighbours(system, state, orbits, steps)
    verdict = _verdict(exponents * TURN * np.arange(1, orbits + 1) / n)
    if e == 0.0 or float(system.asphericity) == 0.0:
        verdict = "regular"
    points = np.vstack([np.append(start, 0.0), points])
    section, angles = points[:, :2] * (1.0, n), points[:, 0] + TURN * np.cumsum(points[:, 2])
    advance = np.diff(angles) / TURN
    if verdict == "chaotic":
        return SpinMotion(orbits, verdict, exponents, n * float(advance.mean()), None, section)
    mean = float(np.average(advance, weights=_weights(orbits)))
    return SpinMotion(orbits, verdict, exponents, n * mean, _libration(system, angles, mean), section)


def steps_for(system: SpinOrbit, spin_ratio: float) -> int:
    """Return how many steps per orbit the map takes for spins of up to some turns per orbit."""
    return math.ceil(steps_per_orbit(system) * max(1.0, abs(spin_ratio) / LIMITS.fast_spin))


def _verdict(growth: Array) -> Literal["chaotic", "regular", "undecided"]:
    """Return the verdict on ln|δ| after each orbit."""
    largest = np.maximum.accumulate(growth)
    excess = largest[-1] - math.log(TURN * len(growth))
    if excess > LIMITS.chaotic_excess:
        return "chaotic"
    calm = excess < LIMITS.regular_excess and largest[-1] - largest[len(growth) // 2] < LIMITS.regular_rise
    return "regular" if calm else "undecided"


def _weights(count: int) -> Array:
    """Return exp(−1/(t(1 − t))) at the middles of equal parts of 0 … 1."""
    t = (np.arange(count) + 0.5) / count
    return np.exp(-1.0 / (t * (1.0 - t)))


def _libration(system: SpinOrbit, angles: Array, mean: float) -> Libration | None:
    order = 0.5 * round(2.0 * mean)
    frequency = float(system.asphericity) * math.sqrt(abs(resonance_strength(order, float(system.eccentricity))))
    slow = angles - TURN * order * np.arange(len(angles))
    span = float(np.ptp(slow))
    if span >= math.pi or frequency * (len(angles) - 1) < LIMITS.min_librations:
        return None
    middle = float(np.average(slow[:-1], weights=_weights(len(slow) - 1)))
    return Libration(order, middle - math.pi * round(middle / math.pi), 0.5 * span)
