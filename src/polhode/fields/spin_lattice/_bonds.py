"""Bonds of a lattice as whole arrays: which exist, in which classes they are disjoint, and their exact flows.

Arrays are components (…, L1, L2, L3, b) of spins; a bond type shifts the three axes of cells. Bonds that would leave an
open lattice are masked out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.fields._turns import Vector3, dot, turn
from polhode.fields.spin_lattice.lattice import Bond, Lattice
from polhode.systems.base import Components, Flow
from polhode.types import Array, Shaped

Matrix = tuple[tuple[float, ...], ...]


class BondLimits(NamedTuple):
    """What decides which flows a bond has.

    Attributes:
        max_anisotropy: relative difference of a matrix from a multiple of the unit matrix, up to which it is plain
            exchange, and a singular value relative to the largest that counts as zero.
    """

    max_anisotropy: float = 1e-14


LIMITS = BondLimits()


class BondType(NamedTuple):
    """A checked bond: sites, shift by (n1, n2, n3) cells, and its matrix as numbers."""

    i: int
    j: int
    cell: tuple[int, int, int]
    matrix: Matrix

    @property
    def exchange(self) -> float | None:
        """J where the matrix is J times the unit matrix, else None."""
        matrix = np.array(self.matrix)
        mean = float(np.trace(matrix)) / 3.0
        return mean if np.abs(matrix - mean * np.eye(3)).max() <= LIMITS.max_anisotropy * np.abs(matrix).max() else None


def checked_bonds(lattice: Lattice, bonds: Sequence[Bond]) -> tuple[BondType, ...]:
    """Return bonds as numbers.

    Raises:
        InvalidInput: for sites that the basis does not have, shifts of the wrong length, a site bound to itself.
    """
    checked = []
    for k, bond in enumerate(bonds):
        i, j, cell, exchange = bond
        matrix = np.asarray(exchange, float)
        matrix = matrix * np.eye(3) if matrix.ndim == 0 else matrix
        if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
            raise InvalidInput(f"`bonds[{k}].matrix` must be a finite number or (3, 3); got {shown(exchange)}.")
        if not (0 <= i < lattice.sites and 0 <= j < lattice.sites):
            raise InvalidInput(f"`bonds[{k}]` joins sites {i} and {j}; the basis has 0 to {lattice.sites - 1}.")
        if len(cell) != lattice.dimension or not all(isinstance(n, int | np.integer) for n in cell):
            raise InvalidInput(f"`bonds[{k}].cell` must be {lattice.dimension} whole numbers; got {shown(cell)}.")
        shift = (*map(int, cell), *(0,) * (3 - len(cell)))
        if i == j and not any(shift):
            raise InvalidInput(f"`bonds[{k}]` joins a site with itself; give such terms as `onsite`.")
        checked.append(BondType(i, j, shift, tuple(map(tuple, matrix.tolist()))))  # pyright: ignore[reportArgumentType]
    return tuple(checked)


def find_cells(lattice: Lattice, bond: BondType) -> np.ndarray | None:
    """Return a mask of the cells (L1, L2, L3) whose second end is in the lattice; None for all."""
    if all(closed or n == 0 for closed, n in zip(lattice.periodic, bond.cell, strict=True)):
        return None
    ends = np.indices(lattice.shape) + np.reshape(bond.cell, (3, 1, 1, 1))
    sizes, closed = np.reshape(lattice.shape, (3, 1, 1, 1)), np.reshape(lattice.periodic, (3, 1, 1, 1))
    return np.all(closed | ((ends >= 0) & (ends < sizes)), axis=0)


def classes(lattice: Lattice, bond: BondType) -> list[np.ndarray]:
    """Return masks (L1, L2, L3) of first ends, in each of which no two bonds have a site in common.

    Along an axis bonds of length m start in blocks of m cells, alternately in two classes; where an odd number of
    blocks closes, those that go round are a third.

    Raises:
        InvalidInput: for a periodic lattice so small that the bond's ends are one site.
    """
    whole = find_cells(lattice, bond)
    mask = np.ones(lattice.shape, bool) if whole is None else whole
    if bond.i != bond.j:
        return [mask]
    best: list[np.ndarray] = []
    for axis, (n, size, closed) in enumerate(zip(bond.cell, lattice.shape, lattice.periodic, strict=True)):
        forward = n % size if closed else n
        length = min(forward, size - forward) if closed else abs(n)
        if length == 0:
            continue
        forwards = forward == length if closed else n > 0
        place = np.indices(lattice.shape)[axis]
        start = place if forwards else size - 1 - place  # a bond backwards starts where its mirror image does
        colour = start // length % 2
        if closed and size % (2 * length):
            colour = np.where(start >= size - length, 2, colour)
        masks = [mask & (colour == c) for c in range(3)]
        masks = [one for one in masks if one.any()]
        if not best or len(masks) < len(best):
            best = masks
    if not best and mask.any():
        raise InvalidInput(
            f"a bond by {bond.cell} cells joins each site with itself in a periodic lattice of {lattice.shape} cells. "
            "Take more cells, or open boundaries."
        )
    return best


def shift_cells(values: Shaped[Array, "..."], cell: Sequence[int], back: bool = False) -> Shaped[Array, "..."]:
    """Return values (…, L1, L2, L3) at the second end of a bond, by the cell of its first end."""
    axes = (-3, -2, -1)  # of one sublattice's components
    moved = [(n if back else -n, axis) for n, axis in zip(cell, axes, strict=True) if n]
    return jnp.roll(values, [n for n, _ in moved], [axis for _, axis in moved]) if moved else values


def bond_flows(lattice: Lattice, bond: BondType) -> list[Flow]:
    """Return the exact flows whose sum is that of all bonds of a type.

    Exchange turns both ends about their sum. The matrix of another bond is Σ σ u vᵀ by singular values, and
    −σ(u·S_i)(v·S_j) turns S_i about u and S_j about v, while both products stay.
    """
    masks, exchange = classes(lattice, bond), bond.exchange
    if exchange is not None:
        halves = find_halving(lattice, bond)
        if halves is not None and exchange:
            return [_halve_flow(bond, *halves, colour, find_cells(lattice, bond), exchange) for colour in (0, 1)]
        return [_flow(bond, mask, None, exchange) for mask in masks] if exchange else []
    left, sizes, right = np.linalg.svd(np.array(bond.matrix))
    terms = [(left[:, k], right[k], float(sizes[k])) for k in range(3) if sizes[k] > LIMITS.max_anisotropy * sizes[0]]
    return [_flow(bond, mask, (tuple(u.tolist()), tuple(v.tolist())), size) for u, v, size in terms for mask in masks]


def find_halving(lattice: Lattice, bond: BondType) -> tuple[int, int] | None:
    """Return axis and length of blocks of cells, every second of which starts bonds; None where none fit.

    Then a class of bonds joins one half of the cells with the other, which takes half the turns of masks.
    """
    if bond.i != bond.j or lattice.sites > 1:
        return None
    for axis, (n, size) in enumerate(zip(bond.cell, lattice.shape, strict=True)):
        if n > 0 and size % (2 * n) == 0:
            return axis, n
    return None


def _halve_flow(
    bond: BondType, axis: int, length: int, colour: int, whole: np.ndarray | None, exchange: float
) -> Flow:
    place, rest = axis - 3, [0 if k == axis else n for k, n in enumerate(bond.cell)]

    def blocks(values: Array, block: int) -> Array:
        """Return every second block of cells, with the other axes in place."""
        # blocks begin at colour · length, and go round
        size, before = values.shape[place], values.shape[:place]
        after = values.shape[values.ndim + place + 1 :]
        cut = values.reshape(*before, size // (2 * length), 2, length, *after)
        return cut[(*(slice(None),) * (len(before) + 1), block)].reshape(*before, size // 2, *after)

    def first_ends(values: Array) -> Array:
        return blocks(values, colour)

    def second_ends(values: Array) -> Array:
        taken = blocks(values, 1 - colour)
        taken = jnp.roll(taken, -length, place) if colour else taken
        return shift_cells(taken, rest)

    def flow(time: Array, state: Components) -> Components:
        ones = [first_ends(x[..., 0]) for x in state]
        others = [second_ends(x[..., 0]) for x in state]
        # H = −J S_i·S_j gives Ṡ_i = S_i × J S_j = −J (S_i + S_j) × S_i, and likewise for j: both turn about their sum,
        # which stays, at the rate −J |S_i + S_j|
        share = -exchange * time
        if whole is not None:
            share = jnp.where(first_ends(jnp.asarray(whole)), share, 0.0)
        moved = turn(ones, [share * (a + b) for a, b in zip(ones, others, strict=True)])
        return tuple(jax.lax.optimization_barrier([_join_halves(x)[..., None] for x in moved]))

    def _join_halves(change: Array) -> Array:
        """Return the changes of both halves, of which the second is minus the first, on all cells."""
        back = shift_cells(change, rest, back=True)
        back = jnp.roll(back, length, place) if colour else back
        shape, size, before = change.shape, change.shape[place], change.ndim + place
        halves = [x.reshape(*shape[:before], size // length, length, *shape[before + 1 :]) for x in (change, -back)]
        both = jnp.stack(halves[::-1] if colour else halves, axis=before + 1)
        return both.reshape(*shape[:before], 2 * size, *shape[before + 1 :])

    return flow


def _flow(bond: BondType, mask: np.ndarray, axes: tuple[Vector3, Vector3] | None, strength: float) -> Flow:
    i, j, cell = bond.i, bond.j, bond.cell

    def flow(time: Array, state: Components) -> Components:
        whole = [x.astype(float) for x in state]
        ones, others = [x[..., i] for x in whole], [x[..., j] for x in whole]
        if i == j:
            return _within(time, ones, whole)
        partners = [shift_cells(x, cell) for x in others]
        share = -strength * time if mask.all() else jnp.where(mask, -strength * time, 0.0)
        if axes is None:
            first = turn(ones, [share * (a + b) for a, b in zip(ones, partners, strict=True)])
            second = [-x for x in first]  # their sum stays
        else:
            (u, v), one, other = axes, share * dot(axes[1], partners), share * dot(axes[0], ones)
            first, second = turn(ones, [one * x for x in u]), turn(partners, [other * x for x in v])
        back = [shift_cells(x, cell, back=True) for x in second]
        still = jnp.zeros_like(ones[0])
        of_site = {i: first, j: back}
        count = whole[0].shape[-1]
        changes = [jnp.stack([of_site[s][k] if s in of_site else still for s in range(count)], -1) for k in range(3)]
        return tuple(jax.lax.optimization_barrier(changes))

    def _within(time: Array, ones: list[Array], whole: list[Array]) -> Components:
        # each end turns itself: within a class a site is the first end of one bond, or the second, or of none
        ends = shift_cells(jnp.asarray(mask), cell, back=True)
        partners = [jnp.where(mask, shift_cells(x, cell), shift_cells(x, cell, back=True)) for x in ones]
        share = -strength * time * (mask | ends)
        if axes is None:
            along = [share * (a + b) for a, b in zip(ones, partners, strict=True)]
        else:
            u, v = axes
            speed = share * jnp.where(mask, dot(v, partners), dot(u, partners))
            along = [speed * jnp.where(mask, a, b) for a, b in zip(u, v, strict=True)]
        moved, count = turn(ones, along), whole[0].shape[-1]
        still = jnp.zeros_like(ones[0])
        changes = [jnp.stack([x if s == i else still for s in range(count)], axis=-1) for x in moved]
        return tuple(jax.lax.optimization_barrier(changes))

    return flow
