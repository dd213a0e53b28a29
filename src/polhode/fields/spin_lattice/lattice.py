"""Lattices of sites, and the bonds between them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.types import ArrayLike, Float64, Real


class LatticeLimits(NamedTuple):
    """What a lattice must satisfy.

    Attributes:
        min_relative_extent: least singular value of the vectors, and least distance of two sites, over the largest
            component: vectors closer to a plane span no cell.
    """

    min_relative_extent: float = 1e-12


LIMITS = LatticeLimits()


class Lattice:
    """A Bravais lattice with a basis, in one to three dimensions: shape[k] cells along the k-th vector.

    Compared and hashed by value. In fewer than three dimensions the missing axes have one cell.

    Args:
        vectors: (d, e) rows are the vectors of the cell, d ≤ e ≤ 3, in any unit of length.
        basis: (b, e) places of the sites of a cell; by default one at the origin.
        shape: (d,) numbers of cells.
        periodic: whether the lattice closes along each vector; one value for all.

    Raises:
        InvalidInput: for shapes that disagree, dependent vectors, sites at one place.

    >>> Lattice([[1.0, 0.0], [0.0, 1.0]], shape=(4, 3)).shape
    (4, 3, 1)
    """

    @known_numbers_only
    def __init__(
        self,
        vectors: Real[ArrayLike, "d e"],
        basis: Real[ArrayLike, "b e"] | None = None,
        shape: tuple[int, ...] = (1,),
        periodic: bool | tuple[bool, ...] = True,
    ) -> None:
        vectors = _rows("vectors", vectors)
        count = len(vectors)
        if (
            not 1 <= count <= 3
            or np.linalg.svd(vectors, compute_uv=False)[-1] <= LIMITS.min_relative_extent * np.abs(vectors).max()
        ):
            raise InvalidInput(f"`vectors` must be one to three independent rows; got {shown(vectors.tolist())}.")
        sites = np.zeros((1, 3)) if basis is None else _rows("basis", basis)
        gaps = np.linalg.norm(sites[:, None] - sites[None], axis=-1) + np.eye(len(sites))
        if gaps.min() <= LIMITS.min_relative_extent * np.abs(vectors).max():
            raise InvalidInput("`basis` must hold different places; two of its rows agree.")
        closed = periodic if isinstance(periodic, tuple) else (bool(periodic),) * count
        whole = all(isinstance(n, int) and n >= 1 for n in shape)
        if not (len(shape) == len(closed) == count and whole):
            raise InvalidInput(
                f"`shape` and `periodic` must have one entry for each of the {count} vectors, whole numbers from 1; "
                f"got {shown(shape)} and {shown(periodic)}."
            )
        self.dimension = count
        self.vectors: tuple[tuple[float, ...], ...] = tuple(map(tuple, vectors.tolist()))
        self.basis: tuple[tuple[float, ...], ...] = tuple(map(tuple, sites.tolist()))
        self.shape: tuple[int, int, int] = (*shape, *(1,) * (3 - count))  # pyright: ignore[reportAttributeAccessIssue]
        self.periodic: tuple[bool, bool, bool] = (*map(bool, closed), *(False,) * (3 - count))  # pyright: ignore[reportAttributeAccessIssue]

    def _all(self) -> tuple:
        return self.vectors, self.basis, self.shape, self.periodic

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Lattice) and self._all() == other._all()

    def __hash__(self) -> int:
        return hash(self._all())

    @property
    def sites(self) -> int:
        """Number of sites of a cell."""
        return len(self.basis)

    def positions(self) -> Float64[np.ndarray, "... 3"]:
        """Return the places (L1, L2, L3, b, 3) of all sites."""
        cells = np.stack(np.meshgrid(*map(np.arange, self.shape), indexing="ij"), axis=-1)
        origins = cells[..., : self.dimension] @ np.array(self.vectors)
        return origins[..., None, :] + np.array(self.basis)


class Bond(NamedTuple):
    """H = −Σ_R S_i(R)ᵀ J S_j(R + cell), for all cells R of the lattice.

    Each bond is listed once, from one of its ends. Exchange is J times the unit matrix; ``exchange_matrix`` adds the
    antisymmetric part of Dzyaloshinskii and Moriya.

    Attributes:
        i: site of the basis.
        j: the other.
        cell: by how many cells along each vector the second end is further.
        matrix: (3, 3) J, or a number for plain exchange.
    """

    i: int
    j: int
    cell: tuple[int, ...]
    matrix: Real[ArrayLike, "..."]


@known_numbers_only
def exchange_matrix(
    exchange: Real[ArrayLike, "..."] = 0.0, chirality: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0)
) -> Float64[np.ndarray, "3 3"]:
    """Return J of a bond with −J S_i·S_j − D·(S_i × S_j).

    Args:
        exchange: a number, (3,) the diagonal, or (3, 3).
        chirality: (3,) D.

    >>> exchange_matrix(1.0, (0.0, 0.0, 0.5)).tolist()
    [[1.0, 0.5, 0.0], [-0.5, 1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    coupling = np.asarray(exchange, float)
    matrix = coupling * np.eye(3) if coupling.ndim < 2 else coupling
    x, y, z = np.asarray(chirality, float)
    if matrix.shape != (3, 3) or not np.isfinite([*matrix.flat, x, y, z]).all():
        raise InvalidInput(f"`exchange` must be finite: a number, (3,) or (3, 3); got {shown(exchange)}.")
    # D·(a × b) = −aᵀ D̂ b with D̂ v = D × v, so that −D̂ joins J in −aᵀ J b
    return matrix + np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])


def _rows(name: str, value: ArrayLike) -> np.ndarray:
    rows = check.array(name, value, ("n", "d"), remedy="Give rows of one to three.")
    if not 1 <= rows.shape[1] <= 3:
        check.refuse(name, "rows of one to three numbers", rows.tolist())
    return np.pad(rows, ((0, 0), (0, 3 - rows.shape[1])))
