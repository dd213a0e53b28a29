"""u(n), the quadratic algebra of all antihermitian matrices."""

from __future__ import annotations

from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode.algebra.matrix import SU, AbstractMatrixAlgebra, Element, adjoint, check_size
from polhode.types import Array, Float64


class U(AbstractMatrixAlgebra):
    """u(n): antihermitian matrices, ⟨μ, x⟩ = −2 Re tr(μx), basis that of su(n) and behind it −i/2.

    The trace is a Casimir of its own: u(n) = su(n) ⊕ u(1). Casimirs Re tr (iμ)^k, k = 1, …, n.
    """

    n: int = eqx.field(static=True)

    @property
    def scale(self) -> float:
        return 2.0

    def __check_init__(self) -> None:
        check_size("U", self.n, 1)

    @property
    def dim(self) -> int:
        return self.n**2

    @property
    def dtype(self) -> Any:
        return jnp.complex128

    def _make_basis(self) -> np.ndarray:
        centre = -0.5j * np.eye(self.n)[None]
        return np.concatenate([SU(self.n).basis, centre]) if self.n > 1 else centre

    @property
    def element_rule(self) -> str:
        return "antihermitian matrices"

    def project(self, matrix: Element) -> Element:
        return self.odd_part(matrix)

    def reversal(self, matrix: Element) -> Element:
        return adjoint(matrix)

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple("tr iμ" if k == 1 else f"tr (iμ)^{k}" for k in range(1, self.n + 1))

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        return jnp.stack(self._power_traces(1j * jnp.asarray(mu), tuple(range(1, self.n + 1))), axis=-1).real
