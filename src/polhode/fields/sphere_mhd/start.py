"""Vorticity and magnetic field at the start, from a table."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput
from polhode.fields.sphere.mhd import SphereMHD
from polhode.fields.sphere.start import Degrees, coefficient
from polhode.fields.sphere_mhd.table import AlfvenWaveTable, MagneticFluidTable
from polhode.formats.dataset_reading import read_dataset
from polhode.motion._trajectory import Trajectory
from polhode.types import Array, Complex128

Harmonics = dict[tuple[int, int], complex]


def build_start(system: SphereMHD, table: MagneticFluidTable) -> Complex128[Array, "2 n n"]:
    """Return the state (Θ, W) of the absolute vorticity [rad/s]."""
    if table.alfven_wave is not None:
        return _exact_wave(system, table.alfven_wave)
    vorticity, potential = (_sum_waves(waves) for waves in (
        [(wave, wave.vorticity) for wave in table.waves or []],
        [(wave, wave.field / math.sqrt(wave.degree * (wave.degree + 1))) for wave in table.field_waves or []],
    ))
    state = system.from_harmonics(vorticity, potential)
    if table.random is not None:
        state = state.at[1].add(_random(system, table.random, 1, table.random.vorticity))
    if table.random_field is not None:
        state = state.at[0].add(_random(system, table.random_field, 0, table.random_field.field))
    return state


def wave_speed(system: SphereMHD, table: AlfvenWaveTable) -> float:
    """Return c [rad/s], at which the exact wave goes round eastward.

    (c − a/2 + (a + 2Ω)/λ)(c − a/2) = b²(1 − 2/λ), λ = l(l + 1), of which one root is east of a/2 and the other west:
    W = (a + 2Ω)X₃ + Y and Θ = bX₃ + κY with κ = −(b/λ)/(c − a/2) put into the equations of ``SphereMHD``.
    """
    turning, eigenvalue = table.turning, table.degree * (table.degree + 1)
    half = -0.5 * (turning + 2.0 * float(system.fluid.rotation)) / eigenvalue
    reach = math.hypot(half, table.field * math.sqrt(1.0 - 2.0 / eigenvalue))
    # of both roots the one that cancels comes from their product
    far = half + math.copysign(reach, half)
    near = -(table.field**2) * (1.0 - 2.0 / eigenvalue) / far
    return 0.5 * turning + (max(far, near) if table.branch == "eastward" else min(far, near))


def _exact_wave(system: SphereMHD, table: AlfvenWaveTable) -> Array:
    eigenvalue = table.degree * (table.degree + 1)
    ratio = -table.field / eigenvalue / (wave_speed(system, table) - 0.5 * table.turning)
    wave = system.sphere.from_harmonics(_table(system.size, table))
    axis = jnp.asarray(system.sphere.coordinates[2])
    whole = table.turning + 2.0 * float(system.fluid.rotation)
    return jnp.stack([table.field * axis + ratio * wave, whole * axis + wave])


def _table(n: int, wave: AlfvenWaveTable) -> Array:
    coefficients = np.zeros((n, n), complex)
    coefficients[wave.degree, wave.order] = coefficient(wave, wave.vorticity)
    return jnp.asarray(coefficients)


def _sum_waves(waves: Sequence[tuple[Any, float]]) -> Harmonics:
    harmonics: Harmonics = {}
    for wave, size in waves:
        place = wave.degree, wave.order
        harmonics[place] = harmonics.get(place, 0.0) + coefficient(wave, size)
    return harmonics


def _random(system: SphereMHD, table: Degrees, part: int, size: float) -> Array:
    """Return a random W or Θ whose vorticity or field has a given root mean square."""
    first, last = table.degrees
    energies, none = (np.arange(last + 1) >= first).astype(float), np.zeros(2)
    spectra = (none, energies) if part == 0 else (energies, none)
    fields = system.random(*spectra, seed=table.seed)
    if part == 0:
        square = 2.0 * float(jnp.sum(system.energy_spectrum(fields)[1]))
        return fields[0] * (size * math.sqrt(4.0 * math.pi / square))
    relative = fields[1] - system.fluid.planetary
    return relative * (size * math.sqrt(4.0 * math.pi / float(system.sphere.pairing(relative, relative))))


def load_earlier_run(path: Path, system: SphereMHD) -> Trajectory:
    """Return the earlier run that is continued.

    Raises:
        InvalidInput: for one of another resolution.
        FormatError: for a file that is no dataset of polhode's.
    """
    trajectory = read_dataset(path)
    states, n = np.asarray(trajectory.states), system.size
    if states.ndim != 4 or states.shape[1:] != (2, n, n):
        raise InvalidInput(
            f"`start_from` must be the motion.nc of a conducting fluid of resolution {n}; states in {path} have shape "
            f"{states.shape[1:]}. Give its resolution, or another file."
        )
    return trajectory
