"""Steady rotations of the rigid body in n dimensions in coordinate planes: their exponents in closed form."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.systems.manakov import Manakov
from polhode.types import Array, ArrayLike, Complex128, Real


@known_numbers_only
def plane_rotation_exponents(
    system: Manakov, momentum: Real[ArrayLike, "n n"]
) -> dict[tuple[int, ...], Complex128[Array, "k"]]:
    """Return the exponents [1/s] of small disturbances of rotations in disjoint coordinate planes, by what they couple.

    A rotation in plane ij with momentum p moves M_ik and M_jk of a free axis k, key (i, j, k), with
    λ² = p² (Λ_k − Λ_i)(Λ_j − Λ_k)/((Λ_i + Λ_j)² (Λ_i + Λ_k)(Λ_j + Λ_k)): it is unstable exactly where some Λ_k lies
    between Λ_i and Λ_j. Two rotations, in planes ij and kl, move M_ik, M_il, M_jk and M_jl, key (i, j, k, l), whose λ²
    solve a quadratic equation: a rotation in the inner plane can hold one in the outer plane that is unstable alone.

    ``stability`` proves what is stable by Manakov's integrals, and ``stability_threshold`` finds where it ends.

    Args:
        system: the body.
        momentum: M (n, n) antisymmetric [kg m²/s], of disjoint planes: at most one entry other than zero in each row.

    Raises:
        InvalidInput: for another shape, a matrix that is not antisymmetric, or planes that share an axis.

    Source: Fehér & Marshall, Nonlinearity 16 (2003) 999; Izosimov, J. Phys. A 47 (2014) 355202.

    >>> M = np.zeros((4, 4))
    >>> M[0, 3], M[3, 0] = 1.0, -1.0
    >>> exponents = plane_rotation_exponents(Manakov((1.0, 2.0, 3.0, 4.0)), M)
    >>> round(15.0 * float(max(x.real.max() for x in exponents.values())), 12)
    1.0
    """
    n = check.instance("system", system, Manakov, "Manakov").size
    M = check.array("momentum", momentum, (n, n))
    if np.abs(M + M.T).max() > 0.0:
        check.refuse("momentum", "antisymmetric", momentum)
    if (np.count_nonzero(M, axis=1) > 1).any():
        raise InvalidInput("`momentum` must have disjoint planes: at most one nonzero entry in each row.")
    planes = [(int(i), int(j)) for i, j in np.argwhere(np.triu(M))]
    free = sorted(set(range(n)) - {axis for plane in planes for axis in plane})
    groups = [(*plane, k) for plane in planes for k in free] + [(*p, *q) for p, q in combinations(planes, 2)]
    return {group: _exponents(np.asarray(system.masses), M, group) for group in groups}


def _exponents(masses: np.ndarray, M: np.ndarray, axes: tuple[int, ...]) -> Array:
    """Return exponents of the entries M_ac that link the first plane of ``axes`` with the rest."""
    links = [(a, c) for a in axes[:2] for c in axes[2:]]
    linear = np.zeros((len(links), len(links)))
    for row, (a, c) in enumerate(links):
        for column, (e, f) in enumerate(links):
            linear[row, column] = _slope(masses, M, a, c, e, f)
    return np.linalg.eigvals(linear).astype(complex)


def _slope(masses: np.ndarray, M: np.ndarray, a: int, c: int, e: int, f: int) -> float:
    """Return ∂Ṁ_ac/∂M_ef: Ṁ_ac = Σ_b M_ab M_bc (Λ_a − Λ_c)/((Λ_a + Λ_b)(Λ_b + Λ_c))."""

    def factor(b: int) -> float:
        return float((masses[a] - masses[c]) / ((masses[a] + masses[b]) * (masses[b] + masses[c])))

    value = 0.0
    if f == c and e != a:
        value += M[a, e] * factor(e)  # M_ab = M_ae is of the steady rotation, M_bc = M_ef
    if e == a and f != c:
        value += M[f, c] * factor(f)
    return value
