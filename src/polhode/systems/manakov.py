"""The rigid body in n dimensions."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.algebra._functions import Function
from polhode.algebra._joint_functions import JointFunction, evaluate_sizes
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.matrix import SO
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, components
from polhode.types import Array, ArrayLike, Float64, Real

Matrices = Float64[Array, "*batch {self.size} {self.size}"]


class Manakov(AbstractLiePoissonSystem):
    """M = ΛΩ + ΩΛ on so(n)*, Ṁ = [M, Ω], H = ½ ⟨M, Ω⟩; state M (…, n, n).

    Integrable: with Lax's pair M + sΛ², Ω + sΛ every coefficient of tr (M + sΛ²)^k is conserved. Flows: rotation in
    each coordinate plane, from H = Σ_{i<j} M_ij²/2(Λ_i + Λ_j).

    Args:
        masses: (n,) second moments of mass Λ along the axes [kg m²], sums of any two positive; n ≥ 3.

    Source: Manakov, Funct. Anal. Appl. 10 (1976) 328; Ratiu, Indiana Univ. Math. J. 29 (1980) 609.
    """

    algebra: AbstractLieAlgebra
    masses: Float64[Array, "n"]
    size: int = eqx.field(static=True)

    @known_numbers_only
    def __init__(self, masses: Real[ArrayLike, "n"]) -> None:
        require_doubles(masses=masses)
        values = np.asarray(masses, dtype=float)
        if values.ndim != 1 or len(values) < 3 or not np.isfinite(values).all():
            raise InvalidInput(f"`masses` must be at least three finite numbers (n,); got shape {values.shape}.")
        with np.errstate(over="ignore"):
            sums, largest = np.sort(values)[:2].sum(), np.sort(values)[-2:].sum()
        if not np.isfinite(largest):
            raise InvalidInput("the sums of two `masses` must not overflow. Choose a larger unit.")
        if not sums > 0:
            raise InvalidInput(f"`masses` must have positive sums of any two; got the sum {sums:g} kg m².")
        self.algebra, self.masses, self.size = SO(len(values)), jnp.asarray(values), len(values)

    @property
    def _sums(self) -> Array:
        return self.masses[:, None] + self.masses[None, :]

    def energy(self, point: Matrices) -> Float64[Array, "*batch"]:
        # ½ ⟨M, Ω⟩ = ¼ Σ_ij M_ij Ω_ij, as ⟨M, Ω⟩ = ½ tr(MᵀΩ)
        return 0.25 * jnp.sum(point * point / self._sums, axis=(-2, -1))

    def velocity(self, point: Matrices) -> Matrices:
        # M_ij = Λ_i Ω_ij + Ω_ij Λ_j
        return point / self._sums

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """Coefficients of s^j in tr (M + sΛ²)^k, k = 3, …, n, of even degree k − j in M."""
        joint, sizes = self._traces, self._trace_sizes
        names = (_name_coefficient(k, j) for k, j in self._coefficients)
        return {name: JointFunction(joint, name, sizes) for name in names}

    @property
    def _coefficients(self) -> list[tuple[int, int]]:
        return [(k, j) for k in range(3, self.size + 1) for j in range(1, k - 1) if (k - j) % 2 == 0]

    def _traces(self, point: Array) -> dict[str, Array]:
        # (M + sΛ²)˙ = [M + sΛ², Ω + sΛ]: the terms of order s cancel, [M, Λ] + [Λ², Ω] = 0 by M = ΛΩ + ΩΛ
        powers = self._expand_powers(point, self.size - self.size // 2)
        turned = [jnp.flip(jnp.swapaxes(power, -1, -2), axis=-3) for power in powers]
        return {_name_coefficient(k, j): _trace_of_product(powers[k // 2], turned[k - k // 2], j)
                for k, j in self._coefficients}

    def _trace_sizes(self, point: Array) -> dict[str, Array]:
        # ∂ tr (M + sΛ²)^k/∂M_ab = k ((M + sΛ²)^(k−1))_ba, and M_ba = −M_ab
        powers = self._expand_powers(point, self.size - 1)
        sums = [jnp.sum(jnp.abs(power * point[..., None, :, :]), axis=(-2, -1)) for power in powers]
        return {_name_coefficient(k, j): k * sums[k - 1][..., j] for k, j in self._coefficients}

    def _expand_powers(self, point: Array, highest: int) -> list[Array]:
        """Return coefficients (…, m + 1, n, n) of 1, s, …, s^m of (M + sΛ²)^m, m = 0, …, highest."""
        none = jnp.zeros_like(point)[..., None, :, :]
        powers: list[Array] = [none + jnp.eye(self.size)]
        for _ in range(highest):
            by_point, by_square = powers[-1] @ point[..., None, :, :], powers[-1] * self.masses**2
            powers.append(jnp.concatenate([by_point, none], axis=-3) + jnp.concatenate([none, by_square], axis=-3))
        return powers

    def invariant_sizes(self, state: Matrices) -> dict[str, Float64[Array, "*batch"]]:
        return evaluate_sizes(self.extra_invariants, state)

    @property
    def flows(self) -> dict[str, Flow]:
        planes = [(i, j) for i in range(self.size) for j in range(i + 1, self.size)]
        return {f"rotation in plane {i + 1}{j + 1}": self._plane_flow(i, j) for i, j in planes}

    def _plane_flow(self, i: int, j: int) -> Flow:
        def flow(time: Array, columns: Components) -> Components:
            state = jnp.stack(columns, axis=-1)
            half = (0.5 * time) * state[..., i, j] / (self.masses[i] + self.masses[j])
            sine, cosine = jnp.sin(half), jnp.cos(half)
            s, less = 2.0 * sine * cosine, -2.0 * sine * sine
            # M ↦ GᵀMG for the turn G = exp(Ω_ij): rows i and j mix, then columns; M_ij itself stays
            s, less = s[..., None], less[..., None]
            own = jnp.arange(self.size)
            others = (own != i) & (own != j)
            row_i, row_j = state[..., i, :], state[..., j, :]
            change_i = jnp.where(others, less * row_i - s * row_j, 0.0)
            change_j = jnp.where(others, less * row_j + s * row_i, 0.0)
            change = jnp.zeros_like(state).at[..., i, :].set(change_i).at[..., j, :].set(change_j)
            return components(change - change.swapaxes(-1, -2))

        return flow


def _name_coefficient(k: int, j: int) -> str:
    return f"s^{j} of tr (M + sΛ²)^{k}"


def _trace_of_product(one: Array, turned: Array, degree: int) -> Array:
    """Return the coefficient (…) of a degree of tr PQ, of polynomials with matrices (…, degrees, n, n) as coefficients.

    Those of Q are transposed, the one of the highest degree first.
    """
    last = turned.shape[-3] - 1
    low, high = max(0, degree - last), min(degree, one.shape[-3] - 1)
    other = turned[..., last - degree + low : last - degree + high + 1, :, :]
    return jnp.sum(one[..., low : high + 1, :, :] * other, axis=(-3, -2, -1))
