"""How fast a damper or sloshing fuel calms or raises the nutation of a spinning spacecraft, by the energy-sink method.

At a small nutation angle θ the axis of symmetry goes round L at λ₀ = h/A, with h the axial momentum and A the moment
across the axis. A part that spins at ω experiences the transverse motion at λ = λ₀ − ω. If it loses the mean power D
θ², its axial momentum changes by the torque −Dθ²/λ; L is conserved, and A λ₀ θ̇/θ = −Σ D/λ. ``dual_spin`` has the sum
over two parts, which one of them may be.

Source: Landon & Stewart, J. Spacecraft 1 (1964) 682; Iorillo, ASME winter meeting (1965); Likins, J. Spacecraft 4
(1967) 1638; Hughes, *Spacecraft Attitude Dynamics*, §7.3; Kaplan, *Modern Spacecraft Dynamics and Control*, §5.
"""

from __future__ import annotations

import math

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput


@known_numbers_only
def nutation_time_constant(transverse: float, axial: float, spin: float, loss: float) -> float:
    """Return the time [s] in which losses change a small nutation angle of a spinning symmetric body by e.

    Positive where nutation dies away, about the axis of largest moment; negative where it grows, about that of least;
    it is A λ₀ (λ₀ − ω)/D with λ₀ = Cω/A.

    Args:
        transverse: A, the moment across the axis [kg m²].
        axial: C, the moment about it [kg m²].
        spin: ω about the axis [rad/s].
        loss: D, mean power over the square of the nutation angle [W/rad²].

    Raises:
        InvalidInput: for moments, spin or loss that are not positive, or equal moments, which no loss tilts.

    >>> nutation_time_constant(1.0, 2.0, 10.0, 0.5), nutation_time_constant(2.0, 1.0, 10.0, 0.5)
    (400.0, -100.0)
    """
    check.positive(transverse=transverse, axial=axial, spin=abs(spin), loss=loss)
    if transverse == axial:
        raise InvalidInput("a body of equal moments feels no nutation; `transverse` and `axial` must differ.")
    rate = axial * spin / transverse
    return transverse * rate * (rate - spin) / loss


@known_numbers_only
def damper_loss(
    transverse: float, axial: float, spin: float, mass: float, radius: float, frequency: float, damping: float
) -> float:
    """Return the mean power over θ² [W/rad²] that a mass on a spring loses, which moves along the axis off it.

    Nutation shakes it along the axis with the acceleration r (2 − C/A) ω λ₀ θ at the frequency λ = λ₀ − ω of the body;
    its answer is that of a damped oscillator. A particle or ball in a tube, a pendulum of sloshing fuel and a sprung
    boom are such masses; they must be small beside the body.

    Args:
        transverse, axial: A, C of the body [kg m²].
        spin: ω [rad/s].
        mass: [kg].
        radius: r, from the axis to the mass at rest [m].
        frequency: of the free oscillation [rad/s]; ``slosh_frequency`` gives that of a pendulum.
        damping: of the oscillation, as a part of the critical one.

    Raises:
        InvalidInput: for numbers that are not positive.

    Source: Cloutier, AIAA J. 7 (1969) 1672; Hughes, *Spacecraft Attitude Dynamics*, §5.3.
    """
    check.positive(
        transverse=transverse, axial=axial, spin=abs(spin), mass=mass, radius=radius, frequency=frequency,
        damping=damping,
    )
    nutation = axial * spin / transverse
    felt = nutation - spin
    shaking = radius * nutation * (spin - felt)
    answer = (frequency**2 - felt**2) ** 2 + (2.0 * damping * frequency * felt) ** 2
    return mass * damping * frequency * (felt * shaking) ** 2 / answer if answer else math.inf


@known_numbers_only
def slosh_frequency(spin: float, pivot: float, length: float) -> float:
    """Return the frequency [rad/s] of a pendulum in a spinning body that swings along the axis, ω √((b + ℓ)/ℓ).

    The centrifugal force holds it out. It swings always faster than the body spins, and never in resonance with
    nutation, which a body feels at |C/A − 1| ω, at most ω.

    Args:
        spin: ω [rad/s].
        pivot: b, the distance of its pivot from the axis [m]; not negative.
        length: ℓ, from the pivot outwards to its mass [m].

    Raises:
        InvalidInput: for numbers out of range.

    Source: Abramson, *The Dynamic Behavior of Liquids in Moving Containers*, NASA SP-106, ch. 6.
    """
    check.positive(spin=abs(spin), length=length)
    pivot = check.number("pivot", pivot, "m", least=0)
    return abs(spin) * math.sqrt((pivot + length) / length)
