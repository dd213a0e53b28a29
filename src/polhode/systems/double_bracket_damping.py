"""Any Lie–Poisson system that loses energy and keeps its coadjoint orbit."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput
from polhode.motion._layout import Quantity
from polhode.systems._checks import checked_number
from polhode.systems.base import AbstractLiePoissonSystem, Balance
from polhode.types import Array, ArrayLike, Double, Float64, Real


class DoubleBracketDamping(AbstractLiePoissonSystem):
    """μ̇ = ad*_ξ μ with ξ = ∓dH + α (ad*_dH μ)^♯: every Casimir is kept, the energy falls by Ḣ = −α |ad*_dH μ|².

    ♯ takes a dual element to the algebra by a scalar product there. The motion ends on its orbit, at a rest of the
    system, from most starts where the energy is least. On so(3) with the usual scalar product it is ``DoubleBracket``,
    on many spins the damping of Landau and Lifshitz, on the algebra of a fluid selective decay to a steady flow.

    Args:
        system: what loses energy; the system's own state, with the attitude where it may have one.
        rate: α, not negative [1 over the unit of the metric's μ² and time].
        metric: (dim, dim) positive-definite symmetric matrix of the scalar product on the dual, in the algebra's dual
            coordinates; by default the sum of the squares of the entries of a dual element.

    Raises:
        InvalidInput: for a rate that is negative or not finite, a metric that is not positive definite, or a system
            that is not Lie–Poisson or loses energy already.

    Source: Brockett, Linear Algebra Appl. 146 (1991) 79; Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175
    (1996) 1; Gay-Balmaz & Holm, Nonlinearity 26 (2013) 495.

    >>> from polhode.systems import Manakov
    >>> damped = DoubleBracketDamping(Manakov((1.0, 2.0, 3.0, 4.0)), 0.1)
    >>> point = jnp.array(np.triu(np.ones((4, 4)), 1) - np.tril(np.ones((4, 4)), -1))
    >>> bool(damped.balances(0.0, point)["energy"].rate < 0.0)
    True
    """

    title: ClassVar[str] = "Double-bracket damping"
    system: AbstractLiePoissonSystem
    algebra: AbstractLieAlgebra
    rate: Float64[Array, ""]
    metric: Float64[Array, "dim dim"] | None

    @known_numbers_only
    def __init__(
        self, system: AbstractLiePoissonSystem, rate: float, metric: Real[ArrayLike, "dim dim"] | None = None
    ) -> None:
        require_doubles(rate=rate, metric=metric)
        if not isinstance(system, AbstractLiePoissonSystem) or not system.conserves_energy:
            raise InvalidInput(
                f"`system` must be a Lie–Poisson system that keeps its energy; got {type(system).__name__}."
            )
        self.system, self.algebra, self.rate = system, system.algebra, checked_number("rate", rate, least=0.0)
        self.metric = None if metric is None else jnp.asarray(_checked_metric(metric, system.algebra))

    @property
    def sign(self) -> int:
        return self.system.sign

    @property
    def quantities(self) -> dict[str, Quantity]:
        return self.system.quantities

    def energy(self, point: Double[Array, "..."]) -> Float64[Array, "..."]:
        return self.system.energy(point)

    def velocity(self, point: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        return self.system.velocity(point)

    def generator(self, t: Real[ArrayLike, "..."], point: Double[Array, "..."]) -> Double[Array, "..."]:
        velocity = self.velocity(point)
        return self.system.generator(t, point) + self.rate * self._raise_index(self.algebra.coadjoint(velocity, point))

    @property
    def conserves_energy(self) -> bool:
        return False

    def balances(self, t: Real[ArrayLike, "..."], state: Double[Array, "..."]) -> dict[str, Balance]:
        point = self.parts(state).point
        # with ν = ad*_dH μ: Ḣ = ⟨ad*_{αν♯} μ, dH⟩ = α ⟨μ, [ν♯, dH]⟩ = −α ⟨ν, ν♯⟩
        along = self.algebra.coadjoint(self.velocity(point), point)
        lost = self.rate * self.algebra.pairing(along, self._raise_index(along))
        return {"energy": Balance(self.energy(point), -lost)}

    def _raise_index(self, dual: Array) -> Array:
        """Return the element of the algebra that the scalar product makes of a dual one."""
        if self.metric is None:
            # of half the sum of squares: JAX gives gradients by complex entries conjugated
            return self.algebra.from_gradient(jnp.conj(dual))
        return self.algebra.from_vector(self.algebra.to_dual_vector(dual) @ self.metric)


def _checked_metric(metric: Array, algebra: AbstractLieAlgebra) -> np.ndarray:
    values = check.array("metric", metric, (algebra.dim, algebra.dim))
    size = np.abs(values).max()
    lowest = np.linalg.eigvalsh(0.5 * (values + values.T)).min()
    if np.abs(values - values.T).max() > 1e-12 * size or not lowest > 0.0:
        raise InvalidInput(
            f"`metric` must be symmetric and positive definite; its least eigenvalue is {lowest:g}. Otherwise the "
            "energy need not fall."
        )
    return values
