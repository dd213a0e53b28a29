"""Turns spins about the field of their neighbours, one sublattice after another."""

from __future__ import annotations

from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.fields.spin_lattice.lattice import Bond
from polhode.fields.spin_lattice.system import SpinLattice
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar, explicit
from polhode.types import Array, ArrayLike, Double, Float64, Real


class SublatticeTurns(AbstractOrbitSolver):
    """Each sublattice turns about its field while the others are fixed, forth and back; order 2, explicit.

    Without on-site terms that field does not change meanwhile, so that the energy is kept to rounding. The field of one
    spin's turn depends on others that stay, so this is not the flow of a Hamiltonian, nor a Poisson map, and the total
    spin wanders. ``Splitting`` keeps both, and is the default.

    Args:
        system: without damping and dipoles.
        step_size: largest step [s].
        sublattices: (L1, L2, L3, b) whole numbers from 0; no bond may join two sites of one number.

    Raises:
        InvalidInput: for other systems, and numbers that do not fit the bonds.

    Source: Krech, Bunker & Landau, Comput. Phys. Commun. 111 (1998) 1.
    """

    system: SpinLattice
    step_size: Float64[Array, ""]
    masks: Array
    keeps: ClassVar[str] = "the length of every spin, the energy where there are no on-site terms; time reversal"

    @known_numbers_only
    def __init__(self, system: SpinLattice, step_size: Scalar, sublattices: Real[ArrayLike, "..."]) -> None:
        if not isinstance(system, SpinLattice) or system.is_damped or system.kernel is not None:
            raise InvalidInput("`SublatticeTurns` needs a SpinLattice without damping and dipoles.")
        numbers, shape = np.asarray(sublattices), system.algebra.shape
        if numbers.shape != shape or not np.issubdtype(numbers.dtype, np.integer) or numbers.min() < 0:
            raise InvalidInput(f"`sublattices` must be whole numbers from 0 of shape {shape}; got {numbers.shape}.")
        masks = numbers == np.arange(numbers.max() + 1)[:, None, None, None, None]
        # ones along x on one sublattice: with any matrix, a field there is that of a bond within it
        plain = [Bond(b.i, b.j, b.cell[: system.lattice.dimension], 1.0) for b in system.bonds]
        bare = SpinLattice(system.lattice, 1.0, plain)
        within = np.asarray(bare.effective_field(masks[..., None] * np.array([1.0, 0.0, 0.0])))[..., 0]
        if (within * masks).any():
            raise InvalidInput("`sublattices` must not have a bond between two sites of one number; take more of them.")
        self.system, self.step_size, self.masks = system, step_size, jnp.asarray(masks)

    def order(self, terms: Any) -> int:
        return 2

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        count, total = len(self.masks), jnp.zeros_like(state)
        for k in [*range(count), *range(count - 2, -1, -1)]:
            share = h if k == count - 1 else 0.5 * h
            generator = share * self.system.effective_field(state + total) * self.masks[k][..., None]
            total = total + self.system.algebra.exp_change(generator, state + total)
        return explicit(total)
