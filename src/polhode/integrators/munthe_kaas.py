"""Runge–Kutta–Munthe-Kaas methods on coadjoint orbits: explicit, for any algebra."""

from __future__ import annotations

from typing import Any, ClassVar

import equinox as eqx

from polhode.algebra._rotations import others_are_an_ideal
from polhode.errors import InvalidInput, shown
from polhode.integrators._group import attitude_by_exp
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar, explicit
from polhode.systems.base import AbstractLiePoissonSystem, join_state
from polhode.types import Array, Double, Float64


class MuntheKaas(AbstractOrbitSolver):
    """μ₁ = Ad*_{exp u} μ₀, u from the midpoint rule (order 2) or Kutta's (order 4) in the algebra; explicit.

    u̇ = dexp⁻¹_{−u} ξ = ξ + ½ [u, ξ] + 1/12 [u, [u, ξ]] − …, cut where the order allows.

    Args:
        system: any Lie–Poisson system.
        step_size: largest step [s].
        order: 2 or 4.

    Source: Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115; Engø & Faltinsen, SIAM J. Numer. Anal. 39 (2001) 128.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    own_order: int = eqx.field(static=True)
    keeps: ClassVar[str] = "the coadjoint orbit, and so every Casimir; the energy drifts"
    symmetric: ClassVar[bool] = False

    def __init__(self, system: AbstractLiePoissonSystem, step_size: Scalar, order: int = 4) -> None:
        if order not in (2, 4):
            raise InvalidInput(f"`order` of MuntheKaas must be 2 or 4; got {shown(order)}.")
        self.system, self.step_size, self.own_order = system, step_size, order

    def order(self, terms: Any) -> int:
        return self.own_order

    def _check_attitude(self) -> None:
        """Refuse an attitude that is not the image of the group element.

        The stages correct u by brackets of the algebra, of which the part in the so(3) is that of the components in the
        so(3) only where the others are an ideal.
        """
        algebra = self.system.algebra
        if not others_are_an_ideal(algebra.structure_constants(), algebra.rotations):
            raise InvalidInput(f"`MuntheKaas` of order 4 has no attitude where brackets with the other components of "
                               f"{algebra.name} lead into its so(3); take LieMidpoint, or order 2.")

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        algebra, (attitude, point) = self.system.algebra, self.system.parts(state)
        if attitude is not None and self.own_order == 4 and not algebra.body_parts:
            self._check_attitude()
        begin, half_way, end = t, t + 0.5 * h, t + h
        beside = self.beside_jumps(t, h)
        if beside is not None:
            begin, end = beside(begin), beside(end)

        def slope(time: Array, u: Array) -> Array:
            xi = h * self.system.generator(time, point + algebra.exp_change(u, point))
            once = algebra.bracket(u, xi)
            return xi + 0.5 * once + algebra.bracket(u, once) / 12.0

        k1 = h * self.system.generator(begin, point)
        if self.own_order == 2:
            u = h * self.system.generator(half_way, point + algebra.exp_change(0.5 * k1, point))
        else:
            k2 = slope(half_way, 0.5 * k1)
            k3 = slope(half_way, 0.5 * k2)
            u = (k1 + 2.0 * k2 + 2.0 * k3 + slope(end, k3)) / 6.0
        return explicit(join_state(attitude_by_exp(algebra, attitude, u), algebra.exp_change(u, point)))
