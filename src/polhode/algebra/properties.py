"""Invariants of an algebra as a whole, from its structure constants."""

from __future__ import annotations

import numpy as np

from polhode.algebra.base import AbstractLieAlgebra

RANK_TOLERANCE = 1e-10  # singular values below it, relative to the largest, count as zero
DRAWS = 3


def killing_form(algebra: AbstractLieAlgebra) -> np.ndarray:
    """Return K_ij = tr(ad_i ad_j) (dim, dim); not degenerate exactly for semisimple algebras [Cartan]."""
    c = algebra.structure_constants()
    # (ad_i)_lk = c_ikl
    return np.einsum("ikl,jlk->ij", c, c)


def centre(algebra: AbstractLieAlgebra) -> np.ndarray:
    """Return an orthonormal basis (m, dim) of the coordinates of elements that commute with all."""
    c = algebra.structure_constants()
    # x with Σ_i x_i c_ijk = 0 for all j, k
    _, sizes, rows = np.linalg.svd(c.reshape(len(c), -1).T)
    return rows[int((sizes > RANK_TOLERANCE * max(sizes.max(initial=0.0), 1e-300)).sum()) :]


def index(algebra: AbstractLieAlgebra) -> int:
    """Return the codimension of generic coadjoint orbits, dim − max rank ⟨μ, [e_i, e_j]⟩: how many Casimirs there are.

    The rank is that at random points, which is the largest with probability one.

    Source: Dixmier, *Enveloping Algebras*, 1.11.
    """
    c = algebra.structure_constants()
    points = np.random.default_rng(0).normal(size=(DRAWS, len(c)))
    tensors = np.einsum("ijk,nk->nij", c, points)
    ranks = np.linalg.matrix_rank(tensors, tol=RANK_TOLERANCE * max(np.abs(tensors).max(initial=0.0), 1e-300))
    return int(len(c) - np.max(ranks))


def is_compact(algebra: AbstractLieAlgebra) -> bool:
    """Whether the inner automorphisms form a compact group: then orbits are compact, and Casimirs tell them apart.

    Exactly where the Killing form is negative on a complement of the centre, as for so(n), su(n), and their sums.

    >>> from polhode.algebra import SE3, SL, SO
    >>> is_compact(SO(4)), is_compact(SL(2)), is_compact(SE3())
    (True, False, False)
    """
    sizes = np.linalg.eigvalsh(killing_form(algebra))
    zero = RANK_TOLERANCE * max(np.abs(sizes).max(initial=0.0), 1e-300)
    return bool((sizes <= zero).all() and (sizes < -zero).sum() == algebra.dim - len(centre(algebra)))
