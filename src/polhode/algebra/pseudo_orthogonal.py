"""so(p, q): rotations and boosts, the matrices that keep a scalar product of signature (p, q)."""

from __future__ import annotations

import equinox as eqx
import numpy as np

from polhode.algebra.matrix import AbstractOrthogonalAlgebra, check_size
from polhode.types import Float64


class SOpq(AbstractOrthogonalAlgebra):
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

    def __init__(self, p: int, q: int) -> None:
        check_size("SOpq", p, 0, "p")
        check_size("SOpq", q, 0, "q")
        check_size("SOpq", p + q, 2, "p + q")
        self.p, self.q, self.n = p, q, p + q

    @property
    def name(self) -> str:
        return f"SO({self.p},{self.q})"

    @property
    def form(self) -> Float64[np.ndarray, "n"]:
        """η's diagonal (p + q,)."""
        return np.array([1.0] * self.p + [-1.0] * self.q)
