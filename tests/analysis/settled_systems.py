"""Random systems that rest at a chosen point: regular, singular, or nearly so, on algebras of every kind.

The Hamiltonian's linear part is chosen so that dH there is any element that moves nothing, {x, dH} = 0: of singular
points these are more than combinations of Casimirs' gradients.
"""

import jax.numpy as jnp
import numpy as np

from analysis.random_systems import PolynomialSystem, Specimen, commutator_constants, twice, twists
from polhode import algebra as lie
from polhode import fields

PLACES = ("regular", "singular", "near")
NEAR = (-6.0, -1.0)  # decimal logarithms of the distance from a singular point
STILL = 1e-12  # singular values of the Poisson tensor below it, relative to the largest, vanish


def unit(n, *places):
    matrix = np.zeros((n, n))
    for i, j in places:
        matrix[i, j] = 1.0
    return matrix


def constants_of(dim, *triples):
    """Return c of [e_i, e_j] = v e_k for (i, j, k, v)."""
    c = np.zeros((dim, dim, dim))
    for i, j, k, v in triples:
        c[i, j, k], c[j, i, k] = v, -v
    return c


TURN = unit(3, (1, 0)) - unit(3, (0, 1))
ENGEL = constants_of(4, (0, 1, 2, 1.0), (0, 2, 3, 1.0))
SL2 = np.array([[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]], float)
# an algebra, its constants from elsewhere, and which coordinates of a singular point are not zero
SETTLED = {
    "so(3)": (lie.SO3(), commutator_constants(twists()[:3]), []),
    "se(3)": (lie.SE3(), commutator_constants(twists()), [0, 1, 2]),
    "su(2)²": (lie.Power(lie.SU(2), 2), twice(commutator_constants(np.asarray(lie.SU(2).basis))), [0, 1, 2]),
    "su(3)": (lie.SU(3), commutator_constants(np.asarray(lie.SU(3).basis)), []),
    "sl(2)": (lie.from_matrices(SL2), commutator_constants(SL2), []),
    "so(2,1)": (lie.SOpq(2, 1), commutator_constants(np.asarray(lie.SOpq(2, 1).basis)), []),
    "se(2)": (lie.SE2(), commutator_constants(np.array([TURN, unit(3, (0, 2)), unit(3, (1, 2))])), [0]),
    "affine": (lie.AffineLine(), commutator_constants(np.array([unit(2, (0, 0)), unit(2, (0, 1))])), [0]),
    "Heisenberg": (lie.Heisenberg(1), commutator_constants(np.array(
        [unit(3, (0, 1)), unit(3, (1, 2)), unit(3, (0, 2))])), [0, 1]),
    "Heisenberg of two": (lie.Heisenberg(2), commutator_constants(np.array(
        [unit(4, (0, 1)), unit(4, (0, 2)), unit(4, (1, 3)), unit(4, (2, 3)), unit(4, (0, 3))])), [0, 1, 2, 3]),
    "bidiagonal": (fields.Bidiagonal(3), constants_of(
        5, (0, 3, 3, -1.0), (1, 3, 3, 1.0), (1, 4, 4, -1.0), (2, 4, 4, 1.0)), [0, 1, 2, 3]),
    "Engel": (lie.from_structure_constants(ENGEL), ENGEL, [0, 1]),
    "se(2) ⊕ affine": (lie.Product(lie.SE2(), lie.AffineLine()), None, [0, 1, 2, 3]),
    "Engel twice": (lie.Power(lie.from_structure_constants(ENGEL), 2), twice(ENGEL), [0, 1, 4, 5]),
}  # fmt: skip


def joined(first, second):
    """Return the constants of a direct sum."""
    n, m = len(first), len(second)
    both = np.zeros((n + m, n + m, n + m))
    both[:n, :n, :n], both[n:, n:, n:] = first, second
    return both


SETTLED["se(2) ⊕ affine"] = (SETTLED["se(2) ⊕ affine"][0], joined(SETTLED["se(2)"][1], SETTLED["affine"][1]),
                             SETTLED["se(2) ⊕ affine"][2])  # fmt: skip


def settled_specimen(name, seed, place):
    """Return a specimen whose point is an equilibrium, that point in coordinates, and how near to singular it is."""
    algebra, constants, kept = SETTLED[name]
    rng, n = np.random.default_rng([seed, PLACES.index(place), len(name)]), algebra.dim
    x, distance = rng.normal(size=n), 1.0
    if place != "regular":
        singular = np.zeros(n)
        singular[kept] = x[kept]
        distance = 0.0 if place == "singular" else 10.0 ** rng.uniform(*NEAR)
        x = singular + distance * rng.normal(size=n)
    mixed = np.linalg.qr(rng.normal(size=(n, n)))[0]
    curvatures = rng.uniform(0.3, 3.0, n) if seed % 3 else rng.normal(size=n)
    A, w, b = mixed * curvatures @ mixed.T, float(seed % 2) * rng.normal(size=3), rng.normal(size=(3, n)) / np.sqrt(n)
    tensor = np.tensordot(x, constants, axes=([-1], [2]))
    _, sizes, rows = np.linalg.svd(tensor)
    still = rows[int((sizes > STILL * sizes.max(initial=1e-300)).sum()) :] if sizes.any() else np.eye(n)
    wanted = still.T @ rng.normal(size=len(still)) * float(seed % 4 > 0)
    linear = wanted - (A @ x + (w * (b @ x) ** 3) @ b)
    system = PolynomialSystem(algebra, *(jnp.asarray(v) for v in (linear, A, w, b)))
    return Specimen(system, np.asarray(algebra.from_dual_vector(x)), constants), x, distance
