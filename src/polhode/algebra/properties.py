"""Invariants of an algebra as a whole, from its structure constants."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.algebra.base import AbstractLieAlgebra


class RankLimits(NamedTuple):
    """What decides ranks and signs."""

    relative_rank: float = 1e-10  # singular values and eigenvalues below it, relative to the largest, vanish


LIMITS = RankLimits()


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
    return rows[int((sizes > LIMITS.relative_rank * max(sizes.max(initial=0.0), 1e-300)).sum()) :]


def index(algebra: AbstractLieAlgebra) -> int:
    """Return the codimension of generic coadjoint orbits, dim − max rank ⟨μ, [e_i, e_j]⟩: how many Casimirs there are.

    The rank is that at random points, which is the largest with probability one.

    Source: Dixmier, *Enveloping Algebras*, 1.11.
    """
    draws = 3  # almost all points have the largest rank
    c = algebra.structure_constants()
    points = np.random.default_rng(0).normal(size=(draws, len(c)))
    tensors = np.einsum("ijk,nk->nij", c, points)
    ranks = np.linalg.matrix_rank(tensors, tol=LIMITS.relative_rank * max(np.abs(tensors).max(initial=0.0), 1e-300))
    return int(len(c) - np.max(ranks))


def is_compact(algebra: AbstractLieAlgebra) -> bool:
    """Whether the inner automorphisms form a compact group: then orbits are compact, and Casimirs separate them.

    Exactly where the Killing form is negative on a complement of the centre, as for so(n), su(n), and their sums.

    >>> from polhode.algebra import SE3, SL, SO
    >>> is_compact(SO(4)), is_compact(SL(2)), is_compact(SE3())
    (True, False, False)
    """
    sizes = np.linalg.eigvalsh(killing_form(algebra))
    zero = LIMITS.relative_rank * max(np.abs(sizes).max(initial=0.0), 1e-300)
    return bool((sizes <= zero).all() and (sizes < -zero).sum() == algebra.dim - len(centre(algebra)))
