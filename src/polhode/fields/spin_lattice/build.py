"""From a table to spins on a lattice and their start."""

from __future__ import annotations

import math

import numpy as np
from scipy.constants import hbar, physical_constants

from polhode.errors import InvalidInput
from polhode.fields.spin_lattice.lattice import Bond, Lattice, exchange_matrix
from polhode.fields.spin_lattice.system import SpinLattice
from polhode.fields.spin_lattice.table import BondTable, SpinLatticeTable
from polhode.types import Array, Float64

BOHR_MAGNETON = physical_constants["Bohr magneton"][0]  # J/T


def build_lattice(table: SpinLatticeTable) -> SpinLattice:
    """Return the spins, energies over ħ in rad/s, so that times are in seconds.

    Raises:
        InvalidInput: where nothing acts on the spins, or vectors and places make no lattice.
    """
    bonds = [_bond(bond) for bond in table.bonds]
    anisotropy = 0.0 if table.anisotropy is None else table.anisotropy.energy
    field = np.zeros(3) if table.field is None else table.g_factor * np.asarray(table.field)
    acting = any(np.any(bond.matrix) for bond in bonds) or anisotropy or np.any(field) or table.dipolar
    if not acting and table.temperature is None:
        raise InvalidInput(
            "`bonds`, `anisotropy`, `field` and `dipolar` must not all be zero: nothing would act on the spins. "
            'Give one of them, like field = ["0 T", "0 T", "1 T"].'
        )
    vectors = [[*row] for row in table.vectors]
    lattice = Lattice(vectors, table.basis, tuple(table.cells), table.periodic)
    onsite = None
    if table.anisotropy is not None:
        axis = np.asarray(table.anisotropy.axis)
        axis = axis / np.linalg.norm(axis)
        onsite = table.anisotropy.energy / hbar * np.outer(axis, axis)
    return SpinLattice(
        lattice, table.spin, bonds, onsite,
        BOHR_MAGNETON / hbar * field,
        0.0 if table.dipolar is None else table.dipolar / hbar,
        0.0 if table.temperature is not None else table.damping,
    )


def build_start(system: SpinLattice, table: SpinLatticeTable) -> Float64[Array, "..."]:
    """Return spins (L1, L2, L3, b, 3) along the directions, disturbed, or along random ones."""
    rng = np.random.default_rng(table.seed)
    shape = system.algebra.element_shape
    if table.random:
        return system.aligned(rng.normal(size=shape))
    directions = np.asarray(table.directions or [(0.0, 0.0, 1.0)])
    directions = directions / np.linalg.norm(directions, axis=-1, keepdims=True)
    return system.aligned(np.broadcast_to(directions, shape) + table.disorder * rng.normal(size=shape))


def _bond(table: BondTable) -> Bond:
    unit = 1.0 / hbar
    if table.matrix is not None:
        matrix = unit * np.asarray(table.matrix)
    else:
        chirality = np.zeros(3) if table.chirality is None else np.asarray(table.chirality)
        matrix = exchange_matrix(unit * (table.exchange or 0.0), unit * chirality)
    return Bond(table.sites[0] - 1, table.sites[1] - 1, tuple(table.cell), matrix)


def wave_path(system: SpinLattice, points: int = 121) -> tuple[Float64[Array, "points 3"], Float64[Array, "points"]]:
    """Return wave vectors across the first Brillouin zone along the first reciprocal vector, and their lengths.

    Returns:
        q (points, 3) Cartesian, from −b/2 to b/2, and q in units of b.
    """
    vectors = np.zeros((system.lattice.dimension, 3))
    vectors[:] = system.lattice.vectors
    reciprocal = 2.0 * math.pi * np.linalg.pinv(vectors).T
    shares = np.linspace(-0.5, 0.5, points)
    return shares[:, None] * reciprocal[0], shares
