"""su(N) as the functions on a sphere of area 4π, reduced to N² − 1 numbers: Zeitlin's matrices.

f ↦ F = i f(ħS) with ħ = 2/√(N² − 1): spherical harmonics Y_lm become matrices T_lm, l < N, and {f, g} = x·(∇f × ∇g)
becomes −[F, G]/ħ up to terms that fall as 1/N². Row i has m = −s + i, s = (N − 1)/2.
Source: Hoppe & Yau, Commun. Math. Phys. 195 (1998) 67; Zeitlin, Phys. Rev. Lett. 93 (2004) 264501.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.matrix import AbstractMatrixAlgebra, Element, Operand, adjoint, check_size, traceless
from polhode.special._spherical_tensors import spherical_tensor
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

POWERS = (2, 3, 4)  # of −iμ whose traces are named among the Casimirs; ``spectrum`` has them all


class QuantizedSphere(AbstractMatrixAlgebra):
    """su(N) with [x, y]/ħ, ħ = 2/√(N²−1), and ⟨μ, x⟩ = (4π/N) Re tr μ†x, which is ∫ f g of the functions.

    Elements (…, N, N) are traceless antihermitian. Coordinates are those along real orthonormal spherical harmonics, by
    degree l = 1, …, N−1, in each m = 0, then cos mφ and sin mφ. Casimirs (4π/N) tr (−iW)^k, k = 2, 3, 4, which
    tend to ∫ ω^k; ``spectrum`` has all N − 1.

    Args:
        n: N, at least 2.
    """

    n: int = eqx.field(static=True)

    def __check_init__(self) -> None:
        check_size("QuantizedSphere", self.n, 2)

    @property
    def scale(self) -> float:
        return 4.0 * math.pi / self.n

    @property
    def hbar(self) -> float:
        """ħ = 2/√(N²−1)."""
        return 2.0 / math.sqrt(self.n**2 - 1.0)

    @property
    def dim(self) -> int:
        return self.n**2 - 1

    @property
    def dtype(self) -> Any:
        return jnp.complex128

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"tr (−iμ)^{k}" for k in POWERS[: self.n - 1])

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        traces = self._power_traces(-1j * jnp.asarray(mu), POWERS[: self.n - 1])
        return self.scale * jnp.stack(traces, axis=-1).real

    def spectrum(self, mu: Element) -> Float64[Array, "*batch {self.n}"]:
        """Return the eigenvalues of −iW (…, N), ascending: blurred values of the function, conserved by any motion."""
        return jnp.linalg.eigvalsh(-1j * jnp.asarray(mu))

    # ------------------------------------------------------------------ the bracket is the commutator over ħ

    def bracket(self, x: Operand, y: Operand) -> Element:
        return super().bracket(x / self.hbar, y)

    def coadjoint(self, x: Operand, mu: Operand) -> Element:
        product = adjoint(x / self.hbar) @ mu
        return product - adjoint(product)  # the adjoint is μx†, as both are antihermitian: this saves a product

    def exp(self, x: Element) -> Element:
        return super().exp(x / self.hbar)

    def cayley(self, x: Element) -> Element:
        return super().cayley(x / self.hbar)

    def cayley_middle(self, x: Operand, mu: Operand) -> Element:
        return super().cayley_middle(x / self.hbar, mu)

    def cayley_terms(self, x: Operand, mu: Operand) -> tuple[Element, Element, Element]:
        return super().cayley_terms(x / self.hbar, mu)

    def exp_change(self, x: Operand, mu: Operand) -> Element:
        return self.project(AbstractLieAlgebra.exp_change(self, x, mu))

    def rate(self, x: Element) -> Float64[Array, "*batch"]:
        # eigenvalues of ad_x are differences of those of x over ħ, the largest that of the extreme ones
        values = self.spectrum(x)
        return (values[..., -1] - values[..., 0]) / self.hbar

    @property
    def element_rule(self) -> str:
        return "antihermitian matrices without a trace"

    def project(self, matrix: Element) -> Element:
        return traceless(self.odd_part(matrix))

    def reversal(self, matrix: Element) -> Element:
        return adjoint(matrix)

    # ------------------------------------------------------------------ harmonics

    @cached_property
    def tensors(self) -> list[np.ndarray]:
        """T_lm on its diagonal for m = 0, …, N−1: rows l = m, …, N−1, columns i = 0, …, N−1−m; tr T†T = N."""
        s = 0.5 * (self.n - 1)
        # rows of ``spherical_tensor`` run from m = s down, those here from m = −s up
        return [math.sqrt(self.n) * spherical_tensor(s, m)[:, ::-1] for m in range(self.n)]

    def from_harmonics(self, coefficients: Real[ArrayLike, "*batch n n"]) -> Complex128[jax.Array, "*batch n n"]:
        """Return the matrices of real functions f = Σ f_lm Y_lm from f_lm (…, N, N), l by rows, m ≥ 0 by columns.

        f_{l,−m} = (−1)^m f̄_lm; f_00 and the imaginary parts of f_l0 are ignored.
        """
        if not is_traced(coefficients):
            return jnp.asarray(self._make_matrices(np.asarray(coefficients, dtype=complex)))
        f = jnp.asarray(coefficients, dtype=complex)
        matrix = jnp.zeros(f.shape, complex)
        for m, rows in enumerate(self.tensors):
            values = f[..., m:, m]
            if m == 0:
                values = values.real.at[..., 0].set(0.0)
            # F = i Σ f_lm T_lm/√(4π): with tr T†T = N, (4π/N) tr F†F is Σ |f_lm|² = ∫ f²
            entries = (values @ rows) * (1j / math.sqrt(4.0 * math.pi))
            i = np.arange(self.n - m)
            matrix = matrix.at[..., i + m, i].set(entries)
            if m:
                matrix = matrix.at[..., i, i + m].set(-jnp.conj(entries))
        return matrix

    def _make_matrices(self, f: np.ndarray) -> np.ndarray:
        """Return these matrices without JAX, which would compile each order by itself."""
        matrix = np.zeros(f.shape, complex)
        for m, rows in enumerate(self.tensors):
            values = f[..., m:, m]
            if m == 0:
                values = np.where(np.arange(self.n) > 0, np.real(values), 0.0)
            entries = (values @ rows) * (1j / math.sqrt(4.0 * math.pi))
            i = np.arange(self.n - m)
            matrix[..., i + m, i] = entries
            if m:
                matrix[..., i, i + m] = -np.conj(entries)
        return matrix

    def to_harmonics(self, matrix: Element) -> Complex128[Array, "*batch {self.n} {self.n}"]:
        """Return f_lm (…, N, N), l by rows, m ≥ 0 by columns, of matrices; zero where m > l."""
        if not is_traced(matrix):
            return jnp.asarray(self._extract_harmonics(np.asarray(matrix)))
        columns = []
        for m, rows in enumerate(self.tensors):
            entries = jnp.diagonal(matrix, -m, -2, -1)
            coefficients = entries @ rows.T * (math.sqrt(4.0 * math.pi) / (1j * self.n))
            columns.append(jnp.concatenate([jnp.zeros((*coefficients.shape[:-1], m), complex), coefficients], axis=-1))
        return jnp.stack(columns, axis=-1)

    def _extract_harmonics(self, matrix: np.ndarray) -> np.ndarray:
        coefficients = np.zeros(matrix.shape, complex)
        for m, rows in enumerate(self.tensors):
            entries = np.diagonal(matrix, -m, -2, -1)
            coefficients[..., m:, m] = entries @ rows.T * (math.sqrt(4.0 * math.pi) / (1j * self.n))
        return coefficients

    def _make_basis(self) -> np.ndarray:
        return np.asarray(self.from_vector(jnp.eye(self.dim)))

    def to_vector(self, x: Element) -> Float64[Array, "*batch {self.dim}"]:
        f = self.to_harmonics(x)
        xp = _namespace(f)
        f, parts = xp.asarray(f), []
        for degree in range(1, self.n):
            row = f[..., degree, 1 : degree + 1]
            # f_lm Y_lm and its conjugate at −m together: a pair of orthonormal real harmonics, with √2 Re f_lm and √2
            # Im f_lm
            pairs = math.sqrt(2.0) * xp.stack([row.real, row.imag], axis=-1)
            parts += [f[..., degree, :1].real, pairs.reshape(*pairs.shape[:-2], -1)]
        return jnp.asarray(xp.concatenate(parts, axis=-1))

    def from_vector(self, vector: Float64[Array, "*batch {self.dim}"]) -> Element:
        xp = _namespace(vector)
        vector = xp.asarray(vector)
        batch, at = vector.shape[:-1], 0
        rows = [xp.zeros((*batch, self.n), complex)]
        for degree in range(1, self.n):
            pairs = vector[..., at + 1 : at + 1 + 2 * degree].reshape(*batch, degree, 2) / math.sqrt(2.0)
            beyond = xp.zeros((*batch, self.n - 1 - degree), complex)
            row = [vector[..., at, None] + 0j, pairs[..., 0] + 1j * pairs[..., 1], beyond]
            rows.append(xp.concatenate(row, axis=-1))
            at += 2 * degree + 1
        return self.from_harmonics(xp.stack(rows, axis=-2))

    def to_dual_vector(self, mu: Element) -> Float64[Array, "*batch {self.dim}"]:
        return self.to_vector(mu)

    def from_dual_vector(self, vector: Float64[Array, "*batch {self.dim}"]) -> Element:
        return self.from_vector(vector)

    @cached_property
    def coordinates(self) -> np.ndarray:
        """The matrices X_a = iħS_a (3, N, N) of the Cartesian coordinates x_a."""
        s = 0.5 * (self.n - 1)
        m = np.arange(self.n) - s
        up = np.diag(np.sqrt((s - m[:-1]) * (s + m[:-1] + 1.0)), -1)
        spins = np.array([0.5 * (up + up.T), -0.5j * (up - up.T), np.diag(m)])
        return 1j * self.hbar * spins


def _namespace(x: Any) -> Any:
    """Return JAX's functions for what it traces, else NumPy's: JAX would compile each degree by itself."""
    return jnp if is_traced(x) else np
