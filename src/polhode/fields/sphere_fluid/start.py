"""The vorticity at the start, from a table."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from polhode.errors import InvalidInput
from polhode.fields.sphere.fluid import SphereFluid
from polhode.fields.sphere.start import RandomTable, coefficient
from polhode.fields.sphere_fluid.table import FluidTable
from polhode.formats.dataset_reading import read_dataset
from polhode.motion._trajectory import Trajectory
from polhode.types import Array, Complex128


def build_start(fluid: SphereFluid, table: FluidTable) -> Complex128[Array, "n n"]:
    """Return the matrix of the absolute vorticity [rad/s]."""
    state = fluid.planetary
    if table.random is not None:
        state = state + _random(fluid, table.random)
    for vortex in table.vortices or []:
        along = math.cos(vortex.latitude)
        direction = np.array([along * math.cos(vortex.longitude), along * math.sin(vortex.longitude),
                              math.sin(vortex.latitude)])  # fmt: skip
        state = state + fluid.vortex(vortex.strength / table.radius**2, direction)
    waves: dict[tuple[int, int], complex] = {}
    for wave in table.waves or []:
        place = wave.degree, wave.order
        waves[place] = waves.get(place, 0.0) + coefficient(wave, wave.vorticity)
    return state + (fluid.from_harmonics(waves) - fluid.planetary) if waves else state


def _random(fluid: SphereFluid, table: RandomTable) -> Array:
    first, last = table.degrees
    degree = np.arange(last + 1)
    vorticity = fluid.random((degree >= first).astype(float), seed=table.seed) - fluid.planetary
    size = math.sqrt(float(fluid.algebra.pairing(vorticity, vorticity)) / (4.0 * math.pi))
    return vorticity * (table.vorticity / size)


def load_earlier_run(path: Path, fluid: SphereFluid) -> Trajectory:
    """Return the earlier run that is continued.

    Raises:
        InvalidInput: for one of another resolution.
        FormatError: for a file that is no dataset of polhode's.
    """
    trajectory = read_dataset(path)
    states, n = np.asarray(trajectory.states), fluid.size
    if states.ndim != 3 or states.shape[1:] != (n, n):
        raise InvalidInput(
            f"`start_from` must be the motion.nc of a fluid of resolution {n}; states in {path} have shape "
            f"{states.shape[1:]}. Give its resolution, or another file."
        )
    return trajectory
