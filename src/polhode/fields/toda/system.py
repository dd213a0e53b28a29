"""The open Toda lattice in Flaschka's variables, and its motion in closed form."""

from __future__ import annotations

from functools import partial
from itertools import pairwise
from typing import ClassVar, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import require_doubles
from polhode.algebra._functions import Function
from polhode.algebra._joint_functions import JointFunction, evaluate_sizes
from polhode.fields.toda.algebra import Bidiagonal
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, Kick
from polhode.types import Array, ArrayLike, Float64, Real


class TodaLimits(NamedTuple):
    """What bounds the exponents of the closed form.

    Attributes:
        max_exponent: of t(λ_max − λ_min): beyond it weights underflow, and the motion is over.
    """

    max_exponent: float = 700.0


LIMITS = TodaLimits()


class Toda(AbstractLiePoissonSystem):
    """ȧ_i = a_i (b_{i+1} − b_i), ḃ_i = 2(a_i² − a_{i−1}²) on the dual of ``Bidiagonal(n)``, H = ½ Σb² + Σa².

    n particles on a line with forces that fall off exponentially: b_i = −p_i/2, a_i = ½ exp((q_i − q_{i+1})/2). States
    are (b_1, …, b_n, a_1, …, a_{n−1}) (…, 2n−1), the diagonal and the one beside it of the symmetric matrix L, whose
    eigenvalues stay; its power traces are in involution. As time goes on b becomes the eigenvalues in falling order and
    a vanishes. Flows: those of Σa² and of ½Σb². ``exact`` gives the state at any time.

    Args:
        n: how many particles, at least 2.

    Source: Flaschka, Phys. Rev. B 9 (1974) 1924; Moser, Lect. Notes Phys. 38 (1975) 467; Symes, Physica D 4 (1982) 275.

    >>> Toda(2).vector_field(0.0, jnp.array([0.0, 1.0, 0.5])).tolist()
    [0.5, -0.5, 0.5]
    """

    title: ClassVar[str] = "Toda lattice"
    algebra: Bidiagonal
    n: int = eqx.field(static=True)

    def __init__(self, n: int) -> None:
        self.algebra, self.n = Bidiagonal(n), n

    def energy(self, point: Float64[Array, "*batch k"]) -> Float64[Array, "*batch"]:
        b, a = point[..., : self.n], point[..., self.n :]
        return 0.5 * jnp.sum(b * b, axis=-1) + jnp.sum(a * a, axis=-1)

    def velocity(self, point: Float64[Array, "*batch k"]) -> Float64[Array, "*batch k"]:
        return jnp.concatenate([point[..., : self.n], 2.0 * point[..., self.n :]], axis=-1)

    def matrix(self, point: Float64[Array, "*batch k"]) -> Float64[Array, "*batch n n"]:
        """Return the tridiagonal L (…, n, n)."""
        point, rows = jnp.asarray(point), np.arange(self.n)
        empty = jnp.zeros((*point.shape[:-1], self.n, self.n))
        a = point[..., self.n :]
        return (empty.at[..., rows, rows].set(point[..., : self.n])
                .at[..., rows[:-1], rows[1:]].set(a).at[..., rows[1:], rows[:-1]].set(a))

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """tr L^k, k = 3, …, n; those of k = 1 and 2 are Σb and 2H."""
        joint, sizes = self._traces, self._trace_sizes
        return {(name := f"tr L^{k}"): JointFunction(joint, name, sizes) for k in range(3, self.n + 1)}

    def _traces(self, point: Array) -> dict[str, Array]:
        powers = [self.matrix(point)]
        for k in range(2, self.n - self.n // 2 + 1):
            powers.append(powers[k // 2 - 1] @ powers[k - k // 2 - 1])
        # tr L^k = Σ_ij (L^m)_ij (L^(k−m))_ij, as they are symmetric
        pairs = {k: (powers[k // 2 - 1], powers[k - k // 2 - 1]) for k in range(3, self.n + 1)}
        return {f"tr L^{k}": jnp.sum(one * other, axis=(-2, -1)) for k, (one, other) in pairs.items()}

    def _trace_sizes(self, point: Array) -> dict[str, Array]:
        matrix = self.matrix(point)
        power, sizes = matrix, dict[str, Array]()
        for k in range(3, self.n + 1):
            power = power @ matrix
            # ∂ tr L^k/∂L = k L^(k−1), of which L has nonzero elements beside the diagonal twice
            sizes[f"tr L^{k}"] = k * jnp.sum(jnp.abs(matrix * power), axis=(-2, -1))
        return sizes

    def invariant_sizes(self, state: Float64[Array, "*batch k"]) -> dict[str, Float64[Array, "*batch"]]:
        return evaluate_sizes(self.extra_invariants, state)

    @property
    def flows(self) -> dict[str, Flow]:
        return {"interaction": Kick(self._kick), "motion": self._drift}

    def _kick(self, time: Array, state: Components) -> Components:
        none, still = [jnp.zeros_like(state[0])], [jnp.zeros_like(a) for a in state[self.n :]]
        # under Σa² alone a stays, and ḃ_i = 2(a_i² − a_{i−1}²) is constant
        squares = [*none, *(2.0 * time * a * a for a in state[self.n :]), *none]
        return (*(right - left for left, right in pairwise(squares)), *still)

    def _drift(self, time: Array, state: Components) -> Components:
        b, a = state[: self.n], state[self.n :]
        # under ½Σb² alone b stays, and a_i grows as e^{t(b_{i+1} − b_i)}
        grown = (x * jnp.expm1(time * (right - left)) for x, left, right in zip(a, b[:-1], b[1:], strict=True))
        return (*(jnp.zeros_like(x) for x in b), *grown)

    def exact(self, state: Real[ArrayLike, "*#batch k"], t: Real[ArrayLike, "*#batch"]) -> Float64[Array, "*batch k"]:
        """Return states (…, 2n−1) at a time t after states (…, 2n−1), with error of rounding at any time.

        L(t) has the eigenvalues of L, and its first components of eigenvectors are proportional to V_1i e^{tλ_i}; from
        both, Lanczos' process with reorthogonalisation makes the tridiagonal matrix. Beyond |t|(λ_max − λ_min) = 700
        the motion is over: b is sorted, and a is zero. Where an a_i is zero L decouples, and the result is NaN; give
        each part its own lattice then.

        Args:
            state: no a_i zero.
            t: time, of either sign.
        """
        require_doubles(state=state, t=t)
        state, t = jnp.asarray(state, dtype=float), jnp.asarray(t, dtype=float)
        shape = jnp.broadcast_shapes(state.shape[:-1], t.shape)
        state, t = jnp.broadcast_to(state, (*shape, self.algebra.dim)), jnp.broadcast_to(t, shape)
        one = partial(_at, self)
        for _ in shape:
            one = jax.vmap(one)
        return one(state, t)


def _at(system: Toda, state: Array, t: Array) -> Array:
    n = system.n
    values, vectors = jnp.linalg.eigh(system.matrix(state))
    # e^{tL} = QR and L(t) = Qᵀ L Q (Symes 1982): its eigenvectors are QᵀV, and the first row of Qᵀ is e₁ᵀ e^{tL} over
    # R₁₁, so that their first components are V_1i e^{tλ_i}, normalised
    exponents = jnp.log(jnp.abs(vectors[0])) + t * values
    weights = jnp.exp(exponents - jnp.max(exponents))
    b, a = _tridiagonal(values, weights / jnp.linalg.norm(weights))
    over = jnp.abs(t) * (values[-1] - values[0]) > LIMITS.max_exponent
    ended = jnp.where(t > 0.0, values[::-1], values)
    a = jnp.where(over, 0.0, a) * jnp.sign(state[n:])
    return jnp.concatenate([jnp.where(over, ended, b), a])


def _tridiagonal(values: Array, start: Array) -> tuple[Array, Array]:
    """Return the diagonal (n,) and the one beside it (n−1,) of diag(values) in Lanczos' basis from a unit vector."""
    basis, b, a = [start], [], []
    for k in range(len(values)):
        b.append(jnp.sum(values * basis[k] ** 2))
        if k == len(values) - 1:
            break
        # L u_k = a_{k−1} u_{k−1} + b_k u_k + a_k u_{k+1}
        left = (values - b[k]) * basis[k]
        for _ in range(2):  # twice is enough
            for known in basis:
                left = left - jnp.sum(known * left) * known
        a.append(jnp.linalg.norm(left))
        basis.append(left / a[k])
    return jnp.stack(b), jnp.stack(a)
