"""Linear waves of a plasma of Maxwellian beams: frequencies, damping, growth and amplitudes."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.special import wofz

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.types import Array, Float64


class ModeLimits(NamedTuple):
    """Numbers that decide whether Newton's method has converged to a mode.

    Attributes:
        max_steps: of Newton's method.
        max_last_step: of Newton's method over |ω|; also the rounding below zero of a frequency that counts as zero.
        max_dispersion: |D| at a root, where its terms are of order one.
        max_rounded_frequency: real part over |ω|: a smaller one is zero but for rounding.
    """

    max_steps: int = 60
    max_last_step: float = 1e-13
    max_dispersion: float = 1e-6
    max_rounded_frequency: float = 1e-13


LIMITS = ModeLimits()


class Beam(NamedTuple):
    """A Maxwellian share of electrons.

    Attributes:
        share: of the density; those of all beams add up to one.
        drift: mean speed u.
        spread: thermal speed s: f = share · exp(−(v − u)²/2s²)/(s√2π).
    """

    share: float = 1.0
    drift: float = 0.0
    spread: float = 1.0


MAXWELLIAN = (Beam(),)


@known_numbers_only
def two_stream(drift: float) -> tuple[Beam, ...]:
    """Return two equal beams of unit spread that drift at ±``drift``."""
    return Beam(0.5, drift), Beam(0.5, -drift)


@known_numbers_only
def bump_on_tail(share: float, drift: float, spread: float) -> tuple[Beam, ...]:
    """Return a Maxwellian of unit spread with a small beam on its tail."""
    return Beam(1.0 - share), Beam(share, drift, spread)


@dataclass(frozen=True)
class PlasmaWave:
    """A normal mode exp(ikx − iωt).

    Attributes:
        wavenumber: k, in inverse Debye lengths.
        frequency: Re ω, in plasma frequencies.
        growth: Im ω; negative where Landau damping wins.
        response: amplitude a of the field after f = f₀(1 + A cos kx) at t = 0, once faster modes are gone:
            A · a · exp(growth t) · cos(frequency t − phase). Where the mode has no oscillation, half of it counts.
        phase: see ``response``.
    """

    wavenumber: float
    frequency: float
    growth: float
    response: float
    phase: float


@known_numbers_only
def velocity_distribution(beams: Sequence[Beam], velocities: Float64[Array, "*shape"]) -> Float64[Array, "*shape"]:
    """Return f₀ at velocities, of integral one.

    >>> float(velocity_distribution(MAXWELLIAN, np.array(0.0)).round(9))
    0.39894228
    """
    v = np.asarray(velocities, dtype=float)
    return sum((b.share / (b.spread * math.sqrt(2.0 * math.pi)) * np.exp(-0.5 * ((v - b.drift) / b.spread) ** 2)
                for b in beams), 0.0 * v)


@known_numbers_only
def dispersion(beams: Sequence[Beam], wavenumber: float, frequency: complex) -> complex:
    """Return D(ω) = 1 + Σ share · (1 + ζ Z(ζ))/(k s)², ζ = (ω/k − u)/(√2 s), whose zeros are the modes.

    Z = i√π w is the plasma dispersion function, continued to the lower half plane.

    Raises:
        InvalidInput: for shares that do not add up to one or spreads that are not positive.

    >>> abs(dispersion(MAXWELLIAN, 0.5, 1.415661888604537 - 0.15335946690960459j)) < 1e-13
    True
    """
    return _dispersion(_check_beams(beams), float(wavenumber), complex(frequency))[0]


@known_numbers_only
def plasma_wave(beams: Sequence[Beam], wavenumber: float, guess: complex | None = None) -> PlasmaWave:
    """Return the mode that Newton's method finds from a guess.

    Args:
        beams: their shares add up to one.
        wavenumber: k > 0 in inverse Debye lengths.
        guess: of ω in plasma frequencies; by default the Langmuir wave of a Maxwellian of the beams' whole spread.
            Growing modes of two streams are near ω = ku of the slow wave: guess 0.2j for two equal ones.

    Raises:
        InvalidInput: for shares that do not add up to one, spreads that are not positive, k that is not positive.
        NotConverged: if the guess leads nowhere.

    Source: Landau, J. Phys. USSR 10 (1946) 25; Fried & Conte, *The Plasma Dispersion Function* (1961).

    >>> wave = plasma_wave(MAXWELLIAN, 0.5)
    >>> round(wave.frequency, 9), round(wave.growth, 9)
    (1.415661889, -0.153359467)
    """
    beams, k = _check_beams(beams), check.number("wavenumber", wavenumber, above=0)
    if guess is None:
        mean = sum(b.share * b.drift for b in beams)
        square = sum(b.share * (b.spread**2 + (b.drift - mean) ** 2) for b in beams)
        # Bohm and Gross: ω² = 1 + 3k²⟨v²⟩, from moving with the mean
        guess = complex(k * mean + math.sqrt(1.0 + 3.0 * k * k * square), -0.05)
    omega = complex(guess)
    for _ in range(LIMITS.max_steps):
        value, slope = _dispersion(beams, k, omega)
        step = value / slope if slope else complex(math.nan)
        omega -= step
        if not (math.isfinite(omega.real) and math.isfinite(omega.imag)):
            break
        if abs(step) <= LIMITS.max_last_step * abs(omega):
            if abs(_dispersion(beams, k, omega)[0]) < LIMITS.max_dispersion:
                return _with_response(beams, k, omega)
            break  # far away, where numbers do not change any more
    raise NotConverged(
        f"Newton's method from ω = {shown(guess)} finds no mode at k = {k:g}. Give another `guess`, nearer to one."
    )


@known_numbers_only
def fastest_growing_wave(beams: Sequence[Beam], wavenumber: float) -> PlasmaWave | None:
    """Return the mode that grows fastest, or is damped least, of those that guesses at each beam's speed lead to.

    Args:
        beams: their shares add up to one.
        wavenumber: k > 0 in inverse Debye lengths.

    Returns:
        None where no guess leads to a mode.

    Raises:
        InvalidInput: as ``plasma_wave`` does.

    >>> round(fastest_growing_wave(two_stream(2.4), 0.2).growth, 9)
    0.225844255
    """
    beams, k = _check_beams(beams), float(wavenumber)
    guesses: list[complex | None] = [None]
    for one in beams:
        guesses += [complex(k * one.drift + sign * (1.0 + 1.5 * k * k), -0.05) for sign in (1.0, -1.0)]
        for other in beams:
            # between two beams the phase velocity is one of neither
            guesses += [complex(k * (share * one.drift + (1.0 - share) * other.drift), high)
                        for share in (0.5, 0.75) for high in (0.05, 0.2, 0.5)]
    waves = []
    for guess in guesses:
        with contextlib.suppress(NotConverged):
            waves.append(plasma_wave(beams, k, guess))
    forwards = [wave for wave in waves if wave.frequency >= -LIMITS.max_last_step]
    return max(forwards or waves, key=lambda wave: wave.growth, default=None)


def _with_response(beams: Sequence[Beam], k: float, omega: complex) -> PlasmaWave:
    # residue of (−i ∫ f₀/(kv − ω) dv)/D at the mode, and E = n/k
    started = sum(b.share * _z((omega / k - b.drift) / (math.sqrt(2.0) * b.spread)) / (math.sqrt(2.0) * b.spread)
                  for b in beams)
    residue = -started / (k * k * _dispersion(beams, k, omega)[1])
    frequency = omega.real if abs(omega.real) > LIMITS.max_rounded_frequency * abs(omega) else 0.0
    return PlasmaWave(k, frequency, omega.imag, 2.0 * abs(residue), math.atan2(residue.imag, residue.real))


def _dispersion(beams: Sequence[Beam], k: float, omega: complex) -> tuple[complex, complex]:
    """Return D and dD/dω; Z' = −2(1 + ζZ)."""
    value, slope = 1.0 + 0.0j, 0.0j
    for b in beams:
        unit = math.sqrt(2.0) * b.spread
        zeta = (omega / k - b.drift) / unit
        z = _z(zeta)
        whole = 1.0 + zeta * z
        value += b.share * whole / (k * b.spread) ** 2
        # d/dζ (1 + ζZ) = Z + ζZ′ = Z − 2ζ (1 + ζZ), and dζ/dω = 1/(k s √2)
        slope += b.share * (z - 2.0 * zeta * whole) / (k * b.spread) ** 2 / (k * unit)
    return value, slope


def _z(zeta: complex) -> complex:
    return 1j * math.sqrt(math.pi) * complex(wofz(zeta))


def _check_beams(beams: Sequence[Beam]) -> tuple[Beam, ...]:
    numbers = np.array([[b.share, b.drift, b.spread] for b in beams], dtype=float).reshape(-1, 3)
    if not len(numbers) or not np.isfinite(numbers).all() or (numbers[:, [0, 2]] <= 0.0).any():
        raise InvalidInput(f"`beams` must have positive shares and spreads, finite; got {shown(beams)}.")
    if abs(numbers[:, 0].sum() - 1.0) > 1e-12:
        raise InvalidInput(f"the shares of `beams` must add up to one; got {numbers[:, 0].sum():g}.")
    return tuple(beams)
