"""Periods of bodies on filaments and on pivots, at any amplitude, and moments from these periods."""

from __future__ import annotations

import math

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.errors import InvalidInput
from polhode.special.elliptic import complete_k
from polhode.types import Array

MAX_AMPLITUDE = math.radians(179.0)  # up to which a pendulum swings back


@known_numbers_only
def filament_period(
    moment: float, mass: float, length: float, upper: float, lower: float, amplitude: float = 0.0,
    gravity: float = STANDARD_GRAVITY,
) -> float:
    """Return the period [s] of a body that twists on filaments, at any amplitude.

    The height h of the upper circle over the lower one is h² = ℓ² − R² − r² + 2Rr cos θ, the energy
    ½(I + M h′²)θ̇² − Mgh. With sin(θ/2) = sin(θ₀/2) sin φ the period is a smooth integral over φ,
    4∫√((I + M h′²)(h + h₀)/(2MgRr)) dφ/√(1 − sin²(θ₀/2) sin²φ); for long filaments, 4√(Ih/(MgRr)) K.

    Args:
        moment: about the vertical through the centre of mass [kg m²].
        mass: [kg].
        length: ℓ of a filament [m].
        upper, lower: radii R, r of the circles of attachments [m].
        amplitude: θ₀ [rad].
        gravity: [m/s²].

    Raises:
        InvalidInput: for numbers that are not positive, or filaments too short for the amplitude.

    >>> round(filament_period(0.01, 1.0, 1.0, 0.2, 0.2), 6), round(2 * math.pi * math.sqrt(0.01 / 9.80665 / 0.04), 6)
    (1.003205, 1.003205)
    """
    check.positive(moment=moment, mass=mass, length=length, upper=upper, lower=lower, gravity=gravity)
    inertial, rise = _filament_integrand(mass, length, upper, lower, amplitude, gravity)
    return float(2.0 * math.pi * np.mean(np.sqrt((moment + inertial) * rise)))


@known_numbers_only
def filament_moment(
    period: float, mass: float, length: float, upper: float, lower: float, amplitude: float = 0.0,
    gravity: float = STANDARD_GRAVITY,
) -> float:
    """Return the moment [kg m²] of a body that twists on filaments with a period [s]; see ``filament_period``.

    Raises:
        InvalidInput: as ``filament_period`` does, and for a period shorter than that of a body without inertia.

    >>> round(filament_moment(filament_period(0.01, 1.0, 1.0, 0.2, 0.3, 1.0), 1.0, 1.0, 0.2, 0.3, 1.0), 15)
    0.01
    """
    check.positive(period=period, mass=mass, length=length, upper=upper, lower=lower, gravity=gravity)
    inertial, rise = _filament_integrand(mass, length, upper, lower, amplitude, gravity)
    moment = (period / (2.0 * math.pi * float(np.mean(np.sqrt(rise))))) ** 2
    computed = period
    for _ in range(30):  # of Newton's iteration, which needs about four
        each = np.sqrt(np.maximum(moment + inertial, 0.0) * rise)
        computed = 2.0 * math.pi * float(np.mean(each))
        slope = math.pi * float(np.mean(rise / each))
        change = (computed - period) / slope
        moment = max(moment - change, 1e-9 * moment)
        if abs(change) <= 1e-15 * moment:
            break
    rounding = 1e-12
    if computed > period * (1.0 + rounding):
        raise InvalidInput(
            f"the period {period:.6g} s is too short: rising and falling alone takes {computed:.6g} s on these "
            "filaments. Check the timing, the count of oscillations in it, mass, lengths and amplitude."
        )
    return moment


@known_numbers_only
def compound_period(
    moment: float, mass: float, distance: float, amplitude: float = 0.0, gravity: float = STANDARD_GRAVITY
) -> float:
    """Return the period [s] of a compound pendulum, 4√((I + md²)/(mgd)) K(sin(θ₀/2)).

    Args:
        moment: I about the parallel to the pivot through the centre of mass [kg m²].
        mass: m [kg].
        distance: d from the pivot to the centre of mass [m].
        amplitude: θ₀ [rad].
        gravity: [m/s²].

    Raises:
        InvalidInput: for numbers that are not positive, or an amplitude of half a turn and more.
    """
    check.positive(moment=moment, mass=mass, distance=distance, gravity=gravity)
    return 4.0 * math.sqrt((moment + mass * distance**2) / (mass * gravity * distance)) * quarter_period(amplitude)


@known_numbers_only
def compound_moment(
    period: float, mass: float, distance: float, amplitude: float = 0.0, gravity: float = STANDARD_GRAVITY
) -> float:
    """Return the moment [kg m²] about the centre of mass of a compound pendulum; see ``compound_period``.

    Zero or negative if the period is not longer than that of a point mass.

    >>> round(compound_moment(compound_period(0.02, 1.0, 0.3, 0.5), 1.0, 0.3, 0.5), 15)
    0.02
    """
    check.positive(period=period, mass=mass, distance=distance, gravity=gravity)
    return mass * gravity * distance * (period / (4.0 * quarter_period(amplitude))) ** 2 - mass * distance**2


@known_numbers_only
def quarter_period(amplitude: float) -> float:
    """Return K(sin(θ₀/2)), a quarter of a pendulum's period over √(I/k); π/2 for small swings.

    Raises:
        InvalidInput: for an amplitude of half a turn and more, or a negative one.
    """
    _check_amplitude(amplitude)
    return float(complete_k(math.cos(0.5 * amplitude) ** 2))


def _check_amplitude(amplitude: float) -> None:
    rule = f"from 0 to below {MAX_AMPLITUDE:.4g}, 179°,"
    check.number("amplitude", amplitude, "rad", least=0, below=MAX_AMPLITUDE, rule=rule)


def _filament_integrand(
    mass: float, length: float, upper: float, lower: float, amplitude: float, gravity: float
) -> tuple[Array, Array]:
    """Return M h′² and (h + h₀)/(2MgRr)/(1 − sin²(θ₀/2) sin²φ) (n,) at midpoints φ of the quarter period."""
    _check_amplitude(amplitude)
    straight = length**2 - (upper - lower) ** 2  # h² at rest
    lowest = straight - 4.0 * upper * lower * math.sin(0.5 * amplitude) ** 2
    if not lowest > 0.0:
        raise InvalidInput(
            f"filaments of {length:.6g} m are too short for circles of radii {upper:.6g} and {lower:.6g} m at an "
            f"amplitude of {math.degrees(amplitude):.4g} deg. Check lengths and units."
        )
    nodes = 64  # of the midpoint rule over the quarter period, which converges exponentially
    phi = 0.5 * math.pi * (np.arange(nodes) + 0.5) / nodes
    half = math.sin(0.5 * amplitude) * np.sin(phi)  # sin(θ/2)
    height = np.sqrt(straight - 4.0 * upper * lower * half**2)
    turn = 2.0 * half * np.sqrt(1.0 - half**2)  # sin θ
    inertial = mass * (upper * lower * turn / height) ** 2
    rise = (height + math.sqrt(lowest)) / (2.0 * mass * gravity * upper * lower) / (1.0 - half**2)
    return inertial, rise
