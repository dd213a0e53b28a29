"""Steps of the Toda lattice by orthogonal factors, which keep the spectrum."""

from __future__ import annotations

from typing import Any, ClassVar

import jax.numpy as jnp

from polhode.errors import InvalidInput
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar, explicit
from polhode.systems.toda import Toda
from polhode.types import Array, Double, Float64


class IsospectralQR(AbstractOrbitSolver):
    """L ↦ QᵀLQ with QR = (1 − hL/2)⁻¹ (1 + hL/2), R of positive diagonal; explicit, of order 2.

    The exact motion is the same with exp(hL) in place of its Padé approximant, which commutes with L, so that a step is
    an exact motion of another member of Toda's hierarchy: all of tr L^k stay, the energy among them, for steps of any
    size. Each takes O(n³).

    Args:
        system: a Toda lattice.
        step_size: largest step.

    Raises:
        InvalidInput: for other systems.

    Source: Symes, Physica D 4 (1982) 275, for the factors of exp(hL).

    >>> lattice, start = Toda(2), jnp.array([0.0, 1.0, 0.5])
    >>> moved = start + IsospectralQR(lattice, 0.1).change(0.0, 0.1, start).state
    >>> bool(abs(lattice.energy(moved) - lattice.energy(start)) < 1e-15)
    True
    """

    system: Toda
    step_size: Float64[Array, ""]
    keeps: ClassVar[str] = "the eigenvalues of L, the energy among their functions; time reversal"

    def __init__(self, system: Toda, step_size: Scalar) -> None:
        if not isinstance(system, Toda):
            raise InvalidInput(f"`IsospectralQR` needs a Toda lattice; got {type(system).__name__}.")
        self.system, self.step_size = system, step_size

    def order(self, terms: Any) -> int:
        return 2

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        one, matrix = jnp.eye(self.system.n), self.system.matrix(state)
        upper = jnp.linalg.qr(jnp.linalg.solve(one - 0.5 * h * matrix, one + 0.5 * h * matrix))[1]
        upper = upper * jnp.sign(jnp.diagonal(upper, axis1=-2, axis2=-1))[..., None]
        # from RL = (QᵀLQ)R, so that nothing cancels and changes vanish with a
        r, beside = (jnp.diagonal(upper, offset, axis1=-2, axis2=-1) for offset in (0, 1))
        a = state[..., self.system.n :]
        none = jnp.zeros_like(a[..., :1])
        taken, given = a * beside, a * beside * r[..., 1:] / r[..., :-1]
        change_of_b = jnp.concatenate([taken, none], axis=-1) - jnp.concatenate([none, given], axis=-1)
        return explicit(jnp.concatenate([change_of_b / r, a * (r[..., 1:] - r[..., :-1]) / r[..., :-1]], axis=-1))
