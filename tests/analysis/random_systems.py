"""Random Lie–Poisson systems with equations of motion of their own, to hold verdicts against.

Nothing here uses polhode's derivatives, brackets or integrators: structure constants come from commutators of matrices,
fields from polynomials' derivatives by hand, Jacobians from difference quotients that are exact for them.
"""

from dataclasses import dataclass

import jax.numpy as jnp
import numpy as np

from polhode import algebra as lie
from polhode.systems.base import AbstractLiePoissonSystem

GROWS = 1e-5  # of the largest exponent: real parts below it may be double zero exponents split by rounding
RATE = 1e-5  # relative agreement of rates, where exponents are simple
ROUNDING = 1e-9  # of a distance that is a difference of two points, each off by a rounding
OFF = 1e-4  # of |μ|, the distance at which neighbours start
CONFINED = 1e3  # times OFF that neighbours of a stable equilibrium may go: square roots of curvatures' ratios
TURNS = 150.0  # over which motions are followed, in units of the inverse of the largest exponent's size
STEP = 0.05
FAR = 0.5  # of |μ|: a neighbour this far has left


def commutator_constants(basis):
    """Return c with [e_i, e_j] = Σ c_ijk e_k of matrices, by least squares over the reals."""
    flat = lambda m: np.concatenate([m.reshape(len(m), -1).real, m.reshape(len(m), -1).imag], axis=1)  # noqa: E731
    n = len(basis)
    products = np.array([a @ b - b @ a for a in basis for b in basis])
    return np.linalg.lstsq(flat(basis).T, flat(products).T, rcond=None)[0].T.reshape(n, n, n)


def twists():
    """Return the basis of se(3) as 4 × 4 matrices, angular part first."""
    basis = np.zeros((6, 4, 4))
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        basis[k, j, i], basis[k, i, j], basis[3 + k, k, 3] = 1.0, -1.0, 1.0
    return basis


def twice(c):
    """Return the constants of the direct sum of two copies."""
    n = len(c)
    both = np.zeros((2 * n, 2 * n, 2 * n))
    both[:n, :n, :n], both[n:, n:, n:] = c, c
    return both


ALGEBRAS = {
    "so(3)": (lie.SO3(), commutator_constants(twists()[:3])),
    "se(3)": (lie.SE3(), commutator_constants(twists())),
    "so(4)": (lie.SO(4), commutator_constants(np.asarray(lie.SO(4).basis))),
    "su(2)²": (lie.Power(lie.SU(2), 2), twice(commutator_constants(np.asarray(lie.SU(2).basis)))),
    "su(3)": (lie.SU(3), commutator_constants(np.asarray(lie.SU(3).basis))),
}


class PolynomialSystem(AbstractLiePoissonSystem):
    """H = l·x + ½ x·Ax + ¼ Σ w_k (b_k·x)⁴ in coordinates x_i = ⟨μ, e_i⟩: coefficients are data, compiled once."""

    algebra: lie.AbstractLieAlgebra
    linear: jnp.ndarray
    quadratic: jnp.ndarray
    weights: jnp.ndarray
    forms: jnp.ndarray

    def energy(self, point):
        x = self.algebra.to_dual_vector(point)
        fourth = 0.25 * jnp.sum(self.weights * (x @ self.forms.T) ** 4, axis=-1)
        return x @ self.linear + 0.5 * jnp.sum(x * (x @ self.quadratic), axis=-1) + fourth


@dataclass(frozen=True)
class Specimen:
    """A system, a point whose leaf is searched, and the field of its own."""

    system: PolynomialSystem
    point: np.ndarray
    constants: np.ndarray

    def slope(self, x):
        s = self.system
        linear, A, w, b = (np.asarray(v) for v in (s.linear, s.quadratic, s.weights, s.forms))
        return linear + x @ A + (w * (x @ b.T) ** 3) @ b

    def field(self, x):
        """Return ẋ_j = ⟨μ, [dH, e_j]⟩ (…, n)."""
        tensor = np.tensordot(x, self.constants, axes=([-1], [2]))
        return np.einsum("...i,...ij->...j", self.slope(x), tensor)

    def jacobian(self, x):
        """Return ∂ẋ_j/∂x_i as (j, i), by five points: exact for polynomials of degree four."""
        h, columns = 0.1 * (np.linalg.norm(x) or 1.0), []
        for d in h * np.eye(x.size):
            one, two = self.field(x + d) - self.field(x - d), self.field(x + 2 * d) - self.field(x - 2 * d)
            columns.append((8.0 * one - two) / (12.0 * h))
        return np.array(columns).T


def departures(specimens, points, starts, rates):
    """Return how far motions of one algebra's systems are from their equilibria at times 0, …, TURNS/rate.

    By Runge and Kutta's method, all at once: one system, point (m, n) and start (m, n) for each motion.
    """
    stacked = [np.array([getattr(s.system, f) for s in specimens]) for f in ("linear", "quadratic", "weights", "forms")]
    linear, A, w, b = stacked
    n = points.shape[1]
    constants = specimens[0].constants.transpose(2, 0, 1).reshape(n, n * n)

    def field(x):
        cubes = w * (b @ x[:, :, None])[..., 0] ** 3
        slope = linear + (A @ x[:, :, None])[..., 0] + (cubes[:, None] @ b)[:, 0]
        return (slope[:, None] @ (x @ constants).reshape(-1, n, n))[:, 0]

    sizes = np.linalg.norm(points, axis=1)
    x, far, h = starts.copy(), FAR * np.where(sizes > 0.0, sizes, 1.0), (STEP / rates)[:, None]
    distances = [np.linalg.norm(starts - points, axis=1)]
    for _ in range(int(TURNS / STEP)):
        k1 = field(x)
        k2 = field(x + 0.5 * h * k1)
        k3 = field(x + 0.5 * h * k2)
        change = h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + field(x + h * k3))
        # what has left stays where it is: energies without bound let it run away in finite time
        x = x + np.where((distances[-1] < far)[:, None], change, 0.0)
        distances.append(np.linalg.norm(x - points, axis=1))
    return np.array(distances)


def random_specimen(name, seed):
    """Return quadratic Hamiltonians for even seeds, ones with a quartic part for odd; some definite, some not."""
    algebra, constants = ALGEBRAS[name]
    rng = np.random.default_rng([seed, len(name), algebra.dim])
    n = algebra.dim
    mixed = np.linalg.qr(rng.normal(size=(n, n)))[0]
    curvatures = rng.uniform(0.3, 3.0, n) if seed % 3 else rng.normal(size=n)
    quartic = float(seed % 2)
    system = PolynomialSystem(
        algebra, jnp.asarray(0.3 * (seed % 4 > 1) * rng.normal(size=n)), jnp.asarray(mixed * curvatures @ mixed.T),
        jnp.asarray(quartic * rng.normal(size=3)), jnp.asarray(rng.normal(size=(3, n)) / np.sqrt(n)),
    )  # fmt: skip
    return Specimen(system, np.asarray(algebra.from_dual_vector(rng.normal(size=n))), constants)


def judge(found, specimen, x):
    """Return what is false about a verdict beside independent exponents, or None."""
    exponents = np.linalg.eigvals(specimen.jacobian(x))
    size, growth = np.abs(exponents).max(), exponents.real.max()
    if found.verdict == "stable" and growth > GROWS * size:
        return f"said to be stable, but grows at {growth:.3g} beside {size:.3g}"
    if found.verdict == "unstable" and found.growth == "exponential" and abs(found.rate - growth) > RATE * size:
        return f"said to grow at {found.rate:.6g}, but does so at {growth:.6g}"
    if found.verdict == "undecided" and growth > 1e3 * GROWS * size:
        return f"said to be undecided, but grows at {growth:.3g} beside {size:.3g}"
    return None


def judge_motion(found, distances, rate, off=OFF, confined=CONFINED):
    """Return what is false about a verdict beside a neighbour's distances (times,) from its equilibrium, or None.

    It started at a share ``off`` of the distance up to which the linearised flow tells how it goes on, and may go
    ``confined`` times as far where it is stable.
    """
    start, farthest = distances[0], distances.max()
    half = len(distances) // 2
    if found.verdict == "stable":
        if farthest > confined * start:
            return f"said to be stable, but a neighbour goes {farthest / start:.3g} times as far"
        if distances[half:].max() > 2.0 * distances[:half].max():
            return "said to be stable, but a neighbour's distance keeps growing"
    if found.verdict == "unstable" and found.growth == "exponential":
        # rates of 1e-18 are exact where the numbers given are, and move a neighbour by less than a rounding
        expected = min(np.exp(0.5 * found.rate * TURNS / rate), 0.02 / off)
        if farthest < (1.0 - ROUNDING) * expected * start:
            return f"said to grow as exp({found.rate:.3g} t), but goes {farthest / start:.3g} times as far only"
    return None
