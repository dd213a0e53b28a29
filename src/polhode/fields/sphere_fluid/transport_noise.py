"""Noise that moves a point along its coadjoint orbit, as the motion itself does."""

from __future__ import annotations

from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced
from polhode.errors import InvalidInput, shown
from polhode.integrators._group import attitude_by_exp
from polhode.integrators._step_noise import normals_of_step
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar
from polhode.integrators.lie_midpoint import LieMidpoint
from polhode.systems.base import AbstractLiePoissonSystem, join_state
from polhode.types import Array, ArrayLike, Double, Float64, Real


class TransportNoise(AbstractOrbitSolver):
    """dμ = ad*_ξ μ dt + Σ_k ad*_{σ_k} μ ∘ dW_k in Stratonovich's sense; Casimirs are kept, the energy wanders.

    ξ is the system's generator, the σ_k are fixed elements of its algebra, and the W_k independent Wiener processes: a
    fluid stirred by random flows, a body whose axes shake. A step is half the noise, the motion, and the other half:
    exp(√(h/2) n_1 σ_1) … exp(√(h/2) n_m σ_m), a step of ``drift``, and these factors in reverse order with new normal
    numbers n. Every factor is exact, so that a step is of weak order 2, whether the σ_k commute or not.

    The noise of a step is keyed by the seed and the step's place in time, and depends neither on how often states are
    saved nor on the size of a batch. Copies of a batch share their noise; for independent noise map over the seed.
    Save at multiples of the step: shorter last steps have other noise.

    Args:
        system: with its Hamiltonian motion.
        step_size: largest step [s].
        fields: (m, *element_shape) σ_k, elements of the algebra, each per √s.
        seed: whole number; different seeds give independent noise.
        drift: class of the method for ξ, of order 2.

    Raises:
        InvalidInput: for fields that are not elements of the algebra or not finite.

    Source: Holm, Proc. R. Soc. A 471 (2015) 20140963; for the composition Strang, SIAM J. Numer. Anal. 5 (1968) 506.

    >>> import numpy as np
    >>> from polhode.systems import FreeRigidBody
    >>> shaken = TransportNoise(FreeRigidBody((1.0, 2.0, 3.0)), 0.1, 0.2 * np.eye(3))
    >>> moved = shaken.change(0.0, 0.1, jnp.array([0.0, 0.6, 0.8])).state + jnp.array([0.0, 0.6, 0.8])
    >>> round(float(jnp.linalg.norm(moved)), 15)
    1.0
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    fields: Double[Array, "m *element"]
    seed: Any
    drift: AbstractOrbitSolver
    largest: Float64[Array, ""]
    keeps: ClassVar[str] = "the Casimirs"
    symmetric: ClassVar[bool] = False

    def __init__(
        self,
        system: AbstractLiePoissonSystem,
        step_size: Scalar,
        fields: Real[ArrayLike, "m *element"],
        seed: Any = 0,
        drift: type[AbstractOrbitSolver] = LieMidpoint,
    ) -> None:
        own, shape = system.algebra.element_shape, np.shape(fields)
        if len(shape) != len(own) + 1 or shape[1:] != own:
            raise InvalidInput(
                f"`fields` must be (m, {', '.join(map(str, own))}), elements of {system.algebra.name}; got {shape}."
            )
        if not is_traced(fields) and not np.isfinite(np.asarray(fields)).all():
            raise InvalidInput(f"`fields` must be finite; got {shown(np.asarray(fields))}.")
        if not (isinstance(drift, type) and issubclass(drift, AbstractOrbitSolver)):
            raise InvalidInput(f"`drift` must be a class of polhode.integrators; got {shown(drift)}.")
        self.system, self.step_size, self.largest = system, step_size, step_size
        self.fields = jnp.asarray(fields, dtype=system.algebra.dtype)
        self.seed = jnp.asarray(seed, int)
        self.drift = drift(system, step_size)  # type: ignore[call-arg]

    def order(self, terms: Any) -> int:
        return 2

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        normals = normals_of_step(self.seed, t, self.largest, (2, len(self.fields)))
        return self.change_by(t, h, state, normals)

    def change_by(self, t: Scalar, h: Scalar, state: Double[Array, "..."], normals: Float64[Array, "2 m"]) -> Change:
        """Return the change over one step whose noise comes from given normal numbers."""
        sizes = jnp.sqrt(0.5 * jnp.abs(h)) * jnp.asarray(normals)
        moved = self._stir(state, jnp.zeros_like(state), sizes[0], self.fields)
        drifted = self.drift.change(t, h, state + moved)
        moved = self._stir(state, moved + drifted.state, sizes[1], self.fields[::-1])
        return Change(moved, drifted.iterations, drifted.converged)

    def _stir(self, state: Array, moved: Array, sizes: Array, fields: Array) -> Array:
        """Return the change since ``state`` after rotations by all fields in turn."""

        def turn(moved: Array, term: tuple[Array, Array]) -> tuple[Array, None]:
            size, field = term
            algebra, (attitude, point) = self.system.algebra, self.system.parts(state + moved)
            x = size * field
            return moved + join_state(attitude_by_exp(algebra, attitude, x), algebra.exp_change(x, point)), None

        return jax.lax.scan(turn, moved, (sizes, fields))[0]
