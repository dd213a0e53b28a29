"""Spins in a heat bath: noise, drift, noise."""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

import jax.numpy as jnp

from polhode._base.arrays import is_traced
from polhode.algebra.so3 import scaled_norm
from polhode.errors import InvalidInput, shown
from polhode.integrators._fixed_point import fixed_point
from polhode.integrators._step_noise import normals_of_step
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, ArrayLike, Double, Float64, Real


class Bath(NamedTuple):
    """A heat bath of classical spins.

    Attributes:
        kT: temperature, in units of energy.
        damping: λ of Ṡ = S × B − (λ/|S|) S × (S × B).
        seed: whole number; different seeds give independent noise.
    """

    kT: Real[ArrayLike, ""]
    damping: Real[ArrayLike, ""]
    seed: Any = 0


class NoiseDriftNoise(AbstractOrbitSolver):
    """Half the noise, a damped spherical midpoint step, the other half; of weak order 2.

    Ṡ = S × (B + η) − (λ/s) S × (S × B) in Stratonovich's sense, ⟨η η⟩ = 2(λkT/s) δ, s = |S|: each half turns every
    spin by √(λkT h/s) times three normal numbers, a little less as large turns do not commute.
    At rest in the bath the states follow exp(−H/kT) up to O(h²).

    The noise of a step is keyed by the bath's seed and the step's place in time, and depends neither on how
    often states are saved nor on the size of a batch. Copies of a batch share their noise; for independent noise map
    over the seed. Save at multiples of the step: shorter last steps have other noise.

    Args:
        system: on SO3 or a Power of it, without attitude, that keeps its energy.
        step_size: largest step [s].
        bath: gives temperature and damping.

    Raises:
        InvalidInput: for other algebras, a system with damping of its own, a bath with negative numbers.

    Source: García-Palacios & Lázaro, Phys. Rev. B 58 (1998) 14937, for the equation.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    bath: Bath
    largest: Float64[Array, ""]
    keeps: ClassVar[str] = "the length of every spin"
    symmetric: ClassVar[bool] = False

    def __init__(self, system: AbstractLiePoissonSystem, step_size: Scalar, bath: Bath) -> None:
        algebra = system.algebra
        if not algebra.is_of_spins:
            raise InvalidInput(f"`NoiseDriftNoise` needs SO3 or a Power of it; got {algebra.name}.")
        if not system.conserves_energy:
            raise InvalidInput("`system` must have no damping of its own; the bath's serves both noise and drift.")
        for name, value in (("kT", bath.kT), ("damping", bath.damping)):
            if not is_traced(value) and not 0.0 <= float(value) < float("inf"):
                raise InvalidInput(f"`bath.{name}` must be finite and not negative; got {shown(value)}.")
        self.system, self.step_size, self.largest = system, step_size, step_size
        # arrays, so that another temperature does not compile the step again
        self.bath = Bath(jnp.asarray(bath.kT, float), jnp.asarray(bath.damping, float), jnp.asarray(bath.seed, int))

    def order(self, terms: Any) -> int:
        return 2

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        if self.system.parts(state).attitude is not None:
            raise InvalidInput("`NoiseDriftNoise` moves momenta only, not an attitude.")
        one, other = normals_of_step(self.bath.seed, t, self.largest, (2, *jnp.shape(state)))
        length = scaled_norm(state)[..., None]
        variance = self.bath.damping * self.bath.kT * jnp.abs(h) / jnp.where(length > 0, length, 1.0)
        # one turn by a normal vector of variance v spreads like the many small ones of variance v (1 + v/12), as turns
        # do not commute: E cos|x| of three normal numbers; without the factor the bias would be of first order
        size = jnp.sqrt(variance / (1.0 + variance / 12.0))
        exp_change = self.system.algebra.exp_change
        first = exp_change(size * one, state)
        drift = self._drift(t + 0.5 * h, h, state + first, length)
        moved = first + drift.state
        return Change(moved + exp_change(size * other, state + moved), drift.iterations, drift.converged)

    def _drift(self, t: Array, h: Scalar, point: Array, length: Array) -> Change:
        def improve(change: Array) -> Array:
            middle = point + 0.5 * change
            size = scaled_norm(middle)[..., None]
            middle = middle * (length / jnp.where(size > 0, size, 1.0))
            field = self.system.generator(t, middle)
            pull = self.bath.damping / jnp.where(length > 0, length, 1.0) * jnp.cross(middle, field)
            return h * jnp.cross(middle, field - pull)

        start = improve(jnp.zeros_like(point))
        scale = jnp.abs(h) * jnp.max(jnp.abs(self.system.generator(t, point))) * jnp.max(length)
        return Change(*fixed_point(improve, start, scale))
