"""so(p, q): turns and boosts, that is the matrices that keep a scalar product of signature (p, q)."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode.algebra.matrix import AbstractMatrixAlgebra, Element, checked_size, pfaffian
from polhode.types import Array, Float64


class SOpq(AbstractMatrixAlgebra):
    """so(p, q): matrices with xᵀη + ηx = 0, η = diag(1, …, 1, −1, …, −1), ⟨μ, x⟩ = ½ tr(μᵀx).

    Basis E_ji − η_i η_j E_ij for i < j in dictionary order, turns where η_i = η_j and boosts where not; so(n, 0) is
    so(n), so(3, 1) Lorentz's algebra, so(2, 1) that of the hyperbolic plane. Casimirs −½ tr μ², tr μ⁴, …; for even
    p + q the last is Pf ημ.

    The exponential of a boost grows without bound, which limits the steps of integrators.

    Source: Gilmore, *Lie Groups, Physics, and Geometry*, ch. 6.
    """

    p: int = eqx.field(static=True)
    q: int = eqx.field(static=True)
    n: int = eqx.field(static=True)

    @property
    def scale(self) -> float:
        return 0.5

    def __init__(self, p: int, q: int) -> None:
        checked_size("SOpq", p, 0, "p")
        checked_size("SOpq", q, 0, "q")
        checked_size("SOpq", p + q, 2, "p + q")
        self.p, self.q, self.n = p, q, p + q

    @property
    def dim(self) -> int:
        return self.n * (self.n - 1) // 2

    @property
    def name(self) -> str:
        return f"SO({self.p},{self.q})"

    @property
    def form(self) -> Float64[np.ndarray, "n"]:
        """η's diagonal (p + q,)."""
        return np.array([1.0] * self.p + [-1.0] * self.q)

    def _make_basis(self) -> np.ndarray:
        rows, columns = np.triu_indices(self.n, 1)
        basis = np.zeros((self.dim, self.n, self.n))
        own = np.arange(self.dim)
        basis[own, columns, rows] = 1.0
        basis[own, rows, columns] = -self.form[rows] * self.form[columns]
        return basis

    def project(self, matrix: Element) -> Element:
        signs = self.form[:, None] * self.form
        return 0.5 * (matrix - signs * jnp.swapaxes(matrix, -1, -2))

    @property
    def _powers(self) -> tuple[int, ...]:
        return tuple(range(2, self.n if self.n % 2 == 0 else self.n + 1, 2))

    @property
    def casimir_names(self) -> tuple[str, ...]:
        traces = tuple("−½ tr μ²" if k == 2 else f"tr μ^{k}" for k in self._powers)
        return traces if self.n % 2 else (*traces, "Pf ημ")

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        mu = jnp.asarray(mu)
        values = self._power_traces(mu, self._powers)
        values = [-0.5 * v if k == 2 else v for k, v in zip(self._powers, values, strict=True)]
        return jnp.stack(values if self.n % 2 else [*values, pfaffian(self.form[:, None] * mu)], axis=-1)
