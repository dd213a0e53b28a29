"""A definite combination of symmetric matrices, if there is one."""

from __future__ import annotations

import numpy as np

from polhode.types import Array, Float64


def definite_combination(matrices: Float64[Array, "k d d"], tolerance: float) -> Float64[Array, "k"] | None:
    """Return c, |c| = 1, with Σ c_i M_i positive definite; None if no combination is.

    There is one exactly if zero is not in the convex hull of the joint numerical range {(vᵀM_1v, …, vᵀM_kv) : |v| = 1},
    and the hull's point next to zero is then the best c. Each round supports the hull once more, by the eigenvector of
    the least eigenvalue, and takes the point next to zero of the polytope so far.

    Args:
        matrices: (k, d, d) symmetric, entries at most of order one.
        tolerance: distance from zero that counts as none.

    Source: von Hohenbalken, Math. Programming 13 (1977) 49 (simplicial decomposition); Wolfe, ibid. 11 (1976) 128.
    """
    rounds = 200
    gap = 0.1  # of the distance: how far the point next to zero may be from the hull's own
    from scipy.optimize import nnls

    c, points, distance = np.eye(len(matrices))[0], [], np.inf
    for _ in range(rounds):
        sizes, vectors = np.linalg.eigh(np.tensordot(c, matrices, 1))
        if sizes[0] > (1.0 - gap) * distance:
            return c
        points.append(matrices @ vectors[:, 0] @ vectors[:, 0])
        corners = np.array(points).T
        # nearest point of a convex hull as non-negative least squares: the row of ones makes the weights sum to one
        weights, _ = nnls(np.vstack([corners, np.ones(len(points))]), np.r_[np.zeros(len(c)), 1.0])
        nearest = corners @ weights / weights.sum()
        distance = float(np.linalg.norm(nearest))
        if distance <= max(tolerance, np.finfo(float).eps):
            return None
        c = nearest / distance
    return c if np.linalg.eigvalsh(np.tensordot(c, matrices, 1))[0] > 0 else None
