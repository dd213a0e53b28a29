"""Every algebra and every way of making one, all the way: simulated, solved, differentiated, kept, shown.

Motions are held against SciPy's, of equations written with the structure constants alone.
"""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import algebra as lie
from polhode._base.arrays.few_calls import quick_options
from specimens import ALGEBRAS, SL2_MATRICES, so3

TIMES = np.linspace(0.0, 0.6, 4)
STEP = 0.02
MOVED = 1e-7
"""Of the state's size: Lie's midpoint rule, order 4, at the given step."""
SLOPE = 1e-5
"""Of the largest derivative: differences of SciPy's motions over 1e-4 leave its square, and rounding over it."""
KEPT = 1e-12


def brackets(dim, *triples):
    """Return the constants of [e_i, e_j] = e_k for triples (i, j, k)."""
    c = np.zeros((dim, dim, dim))
    for i, j, k in triples:
        c[i, j, k], c[j, i, k] = 1.0, -1.0
    return c


ENGEL = brackets(4, (0, 1, 2), (0, 2, 3))
CARTAN = brackets(5, (0, 1, 2), (0, 2, 3), (1, 2, 4))


class OfMyOwn(lie.AbstractLieAlgebra):
    """An algebra as users write it: its numbers are an array, which JAX traces with the system."""

    table: Any

    @property
    def dim(self):
        return len(self.table)

    def bracket(self, x, y):
        return jnp.einsum("...i,...j,ijk->...k", x, y, self.table)

    def coadjoint(self, x, mu):
        return jnp.einsum("...i,...k,ijk->...j", x, mu, self.table)


CONSTANTS = lie.from_structure_constants(so3.structure_constants())
MADE = {
    "Engel": lie.from_structure_constants(ENGEL),
    "Engel with Casimirs": lie.from_structure_constants(
        ENGEL, casimirs=[lambda x: x[3], lambda x: 2.0 * x[1] * x[3] - x[2] ** 2]
    ),
    "Cartan": lie.from_structure_constants(CARTAN),
    "so(3) from constants": CONSTANTS,
    "sl(2) from matrices": lie.from_matrices(SL2_MATRICES),
    "sl(2, C) over the reals": lie.from_matrices(np.concatenate([SL2_MATRICES, 1j * SL2_MATRICES])),
    "so(3) from constants acting": lie.Semidirect(CONSTANTS, so3.structure_constants().transpose(0, 2, 1)),
    "powers of Engel": lie.Power(lie.from_structure_constants(ENGEL), 2, (1.0, -2.0)),
    "product with Engel": lie.Product(so3, lie.from_structure_constants(ENGEL)),
    "dual numbers over constants": lie.DualNumbers(CONSTANTS),
    "my own, of NumPy": OfMyOwn(so3.structure_constants()),
    "my own, of JAX": OfMyOwn(jnp.asarray(ENGEL)),
    "acted on by my own": lie.Semidirect(OfMyOwn(so3.structure_constants()),
                                         so3.structure_constants().transpose(0, 2, 1)),
    **{type(algebra).__name__: algebra for algebra in sorted(ALGEBRAS, key=lambda a: -a.dim)
       if 1 < algebra.dim <= 16 and not isinstance(algebra, lie.ConstantsAlgebra)},
}  # fmt: skip
AT_ONCE = ("my own, of NumPy",)
WATCHED = {
    "Engel": {"x4", "2 x2 x4 − x3²"}, "Engel with Casimirs": {"C1", "C2"},
    "Cartan": {"x4", "x5", "2 x1 x5 − 2 x2 x4 + x3²"}, "so(3) from constants": {"x1² + x2² + x3²"},
    "sl(2) from matrices": {"4 x1 x2 + x3²"},
    "so(3) from constants acting": {"x1 x4 + x2 x5 + x3 x6", "x4² + x5² + x6²"},
    "powers of Engel": {"x4", "2 x2 x4 − x3²"}, "product with Engel": {"|L|² of 0", "x4 of 1", "2 x2 x4 − x3² of 1"},
    "dual numbers over constants": {"x1² + x2² + x3²", "d x1² + x2² + x3²"}, "my own, of NumPy": set(),
}  # fmt: skip


class Squares(eqx.Module):
    """H = ½ Σ w_i ⟨μ, e_i⟩², whose weights are data."""

    algebra: Any
    weights: Any

    def __call__(self, point):
        return 0.5 * jnp.sum(self.weights * self.algebra.to_dual_vector(point) ** 2)


def by_scipy(constants, weights, start):
    """Return coordinates (T, dim) of ẋ_j = Σ c_ijk w_i x_i x_k."""
    tensor = constants.transpose(1, 0, 2) * weights[:, None]
    found = solve_ivp(lambda _, x: np.einsum("jik,i,k->j", tensor, x, x), (0.0, TIMES[-1]), start, "DOP853", TIMES,
                      rtol=1e-13, atol=1e-14)  # fmt: skip
    return found.y.T


def ways():
    for name in MADE:
        yield pytest.param(name, marks=[] if name in AT_ONCE else [pytest.mark.sweep])


@pytest.mark.sweep
@pytest.mark.parametrize("name", list(ways()))
def test_the_whole_way(name, tmp_path):
    algebra = MADE[name]
    constants, n = np.asarray(algebra.structure_constants()), algebra.dim
    weights, start = np.linspace(1.0, 2.0, n), np.linspace(0.2, 0.6, n)
    wanted = by_scipy(constants, weights, start)
    size = np.abs(wanted).max()

    system = ph.systems.LiePoisson(algebra, Squares(algebra, weights))
    run = ph.simulate(system, algebra.from_dual_vector(start), TIMES, step=STEP, order=4, estimate_error=False)
    assert np.abs(algebra.to_dual_vector(run.states) - wanted).max() < MOVED * size
    assert set(run.drift) == {"energy", *algebra.named_casimirs(algebra.from_dual_vector(start))}
    assert set(run.drift) - {"energy"} == WATCHED.get(name, set(run.drift) - {"energy"})
    assert all(np.max(value) < KEPT for key, value in run.drift.items() if key != "energy")

    solved, slopes, forward = moved(algebra, weights, start)
    assert np.abs(solved - wanted[-1]).max() < MOVED * size
    expected = differences(constants, weights, start)
    assert np.abs(np.concatenate(slopes) - expected).max() < SLOPE * np.abs(expected).max()
    assert forward == pytest.approx(float(expected[:n] @ np.cos(np.arange(n))), rel=SLOPE, abs=SLOPE)

    assert set(run.drift) <= set(ph.as_dataset(run))
    back = ph.formats.read_dataset(ph.formats.write_dataset(run, tmp_path / "run.nc"))
    assert {key: float(np.max(value)) for key, value in back.drift.items()} == {
        key: float(np.max(value)) for key, value in run.drift.items()}  # fmt: skip
    words = repr(run) + " "
    assert all(f"{key.replace('_', ' ')} " in words for key in list(run.drift)[:6])
    assert run.plot().axes


def moved(algebra, weights, start):
    """Return the last coordinates of one of two motions at once, derivatives of a sum of them, and one forwards."""
    def end(weights, start):
        system = ph.systems.LiePoisson(algebra, Squares(algebra, weights))
        return algebra.to_dual_vector(ph.solve(system, algebra.from_dual_vector(start), TIMES, step=STEP,
                                               order=4).end_state)  # fmt: skip

    def all_of_it(weights, start):
        n = algebra.dim
        starts, sums = jnp.stack([2.0 * start, start]), jnp.stack([jnp.zeros(n), jnp.arange(1.0, n + 1.0)])
        both, back = jax.vjp(jax.vmap(end, (None, 0)), weights, starts)
        slopes = back(sums)
        forward = jax.jvp(lambda w: end(w, start), (weights,), (jnp.cos(jnp.arange(n)),))[1]
        return both[1], (slopes[0], slopes[1][1]), forward @ sums[1]

    return jax.jit(all_of_it, compiler_options=quick_options())(weights, start)


def differences(constants, weights, start):
    """Return the derivatives (2 dim,) of the sum by weights and start, from SciPy's motions."""
    both, n, h = np.concatenate([weights, start]), len(start), 1e-4
    total = lambda x: by_scipy(constants, x[:n], x[n:])[-1] @ np.arange(1.0, n + 1.0)  # noqa: E731
    return np.array([(total(both + h * d) - total(both - h * d)) / (2.0 * h) for d in np.eye(2 * n)])
