"""Matrix algebras closed under the adjoint: so(n), su(n), sl(n), sp(n).

The pairing is ⟨μ, x⟩ = c Re tr(μ† x) with c stated by each, so that dual elements are matrices of the algebra too and
ad*_x μ = [x†, μ], Ad*_g μ = g† μ g^(−†). Traces of powers are Casimirs.
"""

from __future__ import annotations

import abc
from functools import cached_property
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode.algebra._pfaffian import pfaffian
from polhode.algebra._real_products import product
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput
from polhode.types import Array, Double, Float64

Element = Double[Array, "*batch {self.size} {self.size}"]
Operand = Double[Array, "*#batch {self.size} {self.size}"]


class AbstractMatrixAlgebra(AbstractLieAlgebra):
    """An algebra of square matrices with an orthogonal basis of rational structure constants."""

    n: eqx.AbstractVar[int]

    @property
    @abc.abstractmethod
    def scale(self) -> float:
        """c of the pairing c Re tr(μ†x), in most algebras a constant of the class."""

    @cached_property
    def basis(self) -> np.ndarray:
        """Basis matrices (dim, size, size), mutually orthogonal in the pairing."""
        return self._make_basis()

    @abc.abstractmethod
    def _make_basis(self) -> np.ndarray:
        """Return the basis matrices."""

    @abc.abstractmethod
    def project(self, matrix: Element) -> Element:
        """Return the part of any matrix (…, size, size) that lies in the algebra, and so in its dual."""

    @property
    def size(self) -> int:
        """Rows of an element."""
        return self.n

    @property
    def element_shape(self) -> tuple[int, ...]:
        return (self.size, self.size)

    @property
    def name(self) -> str:
        return f"{type(self).__name__}({self.n})"

    @cached_property
    def _lengths(self) -> np.ndarray:
        return self.scale * np.sum(np.abs(self.basis) ** 2, axis=(1, 2))

    def bracket(self, x: Operand, y: Operand) -> Element:
        return x @ y - y @ x

    def coadjoint(self, x: Operand, mu: Operand) -> Element:
        conjugate = adjoint(x)
        return conjugate @ mu - mu @ conjugate

    def pairing(self, mu: Operand, x: Operand) -> Float64[Array, "*batch"]:
        return self.scale * jnp.sum((jnp.conj(mu) * x).real, axis=(-2, -1))

    def to_vector(self, x: Element) -> Float64[Array, "*batch {self.dim}"]:
        return self.to_dual_vector(x) / self._lengths

    def from_vector(self, vector: Float64[Array, "*batch {self.dim}"]) -> Element:
        return jnp.einsum("...k,kij->...ij", vector, self.basis)

    def to_dual_vector(self, mu: Element) -> Float64[Array, "*batch {self.dim}"]:
        return self.scale * jnp.einsum("...ij,kij->...k", mu, self.basis.conj()).real

    def from_dual_vector(self, vector: Float64[Array, "*batch {self.dim}"]) -> Element:
        return self.from_vector(vector / self._lengths)

    def from_gradient(self, gradient: Element) -> Element:
        # JAX gives g with δF = Re Σ g δμ, and ⟨δμ, x⟩ = c Re Σ δμ̄ x: x is ḡ/c, its part in the algebra
        return self.project(jnp.conj(gradient)) / self.scale

    def rate(self, x: Element) -> Float64[Array, "*batch"]:
        # eigenvalues of ad_x are differences of those of x, and |λ − λ′|² ≤ 2(|λ|² + |λ′|²) ≤ 2 |x|² for normal x
        return jnp.sqrt(2.0) * jnp.linalg.norm(x, axis=(-2, -1))

    def exp(self, x: Element) -> Element:
        return jax.scipy.linalg.expm(jnp.asarray(x))

    def coadjoint_action(self, g: Operand, mu: Operand) -> Element:
        # g† μ g^(−†) = (g⁻¹ (g† μ)†)†
        return adjoint(jnp.linalg.solve(g, adjoint(adjoint(g) @ mu)))

    def cayley(self, x: Element) -> Element:
        one = jnp.eye(self.size)
        return jnp.linalg.solve(one - 0.5 * x, one + 0.5 * x)

    def exp_change(self, x: Operand, mu: Operand) -> Element:
        return self.project(AbstractLieAlgebra.exp_change(self, x, mu))

    def cayley_change(self, x: Operand, mu: Operand) -> Element:
        # (1 + y) W̃ (1 − y) − (1 − y) W̃ (1 + y) = 2[y, W̃] with y = x†/2
        return self.coadjoint(x, self.cayley_middle(x, mu))

    def cayley_middle(self, x: Operand, mu: Operand) -> Element:
        """Return W̃ with μ = (1 − x†/2) W̃ (1 + x†/2) and Ad*_{cay x} μ = (1 + x†/2) W̃ (1 − x†/2).

        In algebras of traceless matrices it may have a trace, which is no part of a dual element.
        """
        one, half = jnp.eye(self.size), 0.5 * adjoint(x)
        middle = adjoint(jnp.linalg.solve(one + adjoint(half), adjoint(jnp.linalg.solve(one - half, mu))))
        return self.odd_part(middle)  # rounding must not leave the algebra, step after step

    def cayley_terms(self, x: Operand, mu: Operand) -> tuple[Element, Element, Element]:
        """Return y μ, [y, μ] and y μ y with y = x†/2, by two products of matrices.

        W̃ = W + [y, W̃] + y W̃ y is the W̃ of ``cayley_middle`` for W, and Ad*_{cay x} W = W + 2[y, W̃]. Both terms are
        odd under ``reversal`` to the last digit.
        """
        half = 0.5 * adjoint(x)
        one_sided = product(half, mu)
        return one_sided, one_sided - self.reversal(one_sided), self.odd_part(product(one_sided, half))

    def reversal(self, matrix: Element) -> Element:
        """Return σ(M), linear with σ(AB) = σ(B)σ(A), which takes every x of a quadratic algebra to −x.

        Raises:
            InvalidInput: if the algebra is not quadratic.
        """
        raise InvalidInput(f"{self.name} is not an algebra of a quadratic group, of which Cayley's map needs one.")

    def odd_part(self, matrix: Element) -> Element:
        """Return (M − σ(M))/2, M's part in a quadratic algebra but for the trace."""
        return 0.5 * (matrix - self.reversal(matrix))

    def _power_traces(self, mu: Array, powers: tuple[int, ...]) -> list[Array]:
        """Return tr μ^k = Σ_ij (μ^m)_ij (μ^(k−m))_ji, by powers of matrices up to half the largest k."""
        largest, known = max(powers, default=1), [mu]
        for _ in range(largest - largest // 2 - 1):
            known.append(known[-1] @ mu)
        turned = [jnp.swapaxes(power, -1, -2) for power in known]
        return [jnp.sum(known[k // 2 - 1] * turned[k - k // 2 - 1], axis=(-2, -1)) if k > 1
                else jnp.trace(mu, axis1=-2, axis2=-1) for k in powers]


class AbstractOrthogonalAlgebra(AbstractMatrixAlgebra):
    """Matrices with xᵀη + ηx = 0 for a diagonal η of signs; Casimirs −½ tr μ², tr μ⁴, …, and the Pfaffian of ημ."""

    @property
    @abc.abstractmethod
    def form(self) -> Float64[np.ndarray, "n"]:
        """η's diagonal (n,)."""

    @property
    def scale(self) -> float:
        return 0.5

    @property
    def dim(self) -> int:
        return self.n * (self.n - 1) // 2

    def _make_basis(self) -> np.ndarray:
        rows, columns = np.triu_indices(self.n, 1)
        basis = np.zeros((self.dim, self.n, self.n))
        own = np.arange(self.dim)
        # E_ji − η_i η_j E_ij solves xᵀη + ηx = 0
        basis[own, columns, rows] = 1.0
        basis[own, rows, columns] = -self.form[rows] * self.form[columns]
        return basis

    @property
    def element_rule(self) -> str:
        return "matrices x with xᵀη + ηx = 0, η = diag({})".format(", ".join(f"{x:g}" for x in self.form))

    def project(self, matrix: Element) -> Element:
        return self.odd_part(matrix)

    def reversal(self, matrix: Element) -> Element:
        return self.form[:, None] * self.form * jnp.swapaxes(matrix, -1, -2)

    @property
    def _pfaffian_name(self) -> str:
        return "Pf ημ"

    @property
    def _powers(self) -> tuple[int, ...]:
        return tuple(range(2, self.n if self.n % 2 == 0 else self.n + 1, 2))

    @property
    def casimir_names(self) -> tuple[str, ...]:
        traces = tuple("−½ tr μ²" if k == 2 else f"tr μ^{k}" for k in self._powers)
        return traces if self.n % 2 else (*traces, self._pfaffian_name)

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        mu = jnp.asarray(mu)
        values = self._power_traces(mu, self._powers)
        values = [-0.5 * v if k == 2 else v for k, v in zip(self._powers, values, strict=True)]
        return jnp.stack(values if self.n % 2 else [*values, pfaffian(self.form[:, None] * mu)], axis=-1)


class SO(AbstractOrthogonalAlgebra):
    """so(n): antisymmetric matrices, ⟨μ, x⟩ = ½ tr(μᵀx), basis E_ji − E_ij for i < j in dictionary order.

    Casimirs −½ tr μ², tr μ⁴, …; for even n the last is Pf μ instead of tr μⁿ.
    """

    n: int = eqx.field(static=True)

    def __check_init__(self) -> None:
        check_size("SO", self.n, 2)

    @property
    def form(self) -> Float64[np.ndarray, "n"]:
        return np.ones(self.n)

    @property
    def element_rule(self) -> str:
        return "antisymmetric matrices"

    @property
    def _pfaffian_name(self) -> str:
        return "Pf μ"


class SU(AbstractMatrixAlgebra):
    """su(n): traceless antihermitian matrices, ⟨μ, x⟩ = −2 Re tr(μx), basis −iλ/2 in Gell-Mann's order.

    Diagonal λ are diag(1, …, 1, −l, 0, …), not normalised, which keeps the constants rational; su(2) is so(3) in this
    basis. Casimirs Re tr (iμ)^k, k = 2, …, n.
    """

    n: int = eqx.field(static=True)

    @property
    def scale(self) -> float:
        return 2.0

    def __check_init__(self) -> None:
        check_size("SU", self.n, 2)

    @property
    def dim(self) -> int:
        return self.n**2 - 1

    @property
    def dtype(self) -> Any:
        return jnp.complex128

    def _make_basis(self) -> np.ndarray:
        matrices = []
        for k in range(1, self.n):
            for j in range(k):
                symmetric = np.zeros((self.n, self.n), complex)
                symmetric[j, k] = symmetric[k, j] = -0.5j
                antisymmetric = np.zeros((self.n, self.n), complex)
                antisymmetric[j, k], antisymmetric[k, j] = -0.5, 0.5
                matrices += [symmetric, antisymmetric]
            # diag(1, …, 1, −k) has no trace, and is orthogonal to those before it
            matrices.append(np.diag([-0.5j] * k + [0.5j * k] + [0.0] * (self.n - k - 1)))
        return np.array(matrices)

    @property
    def element_rule(self) -> str:
        return "antihermitian matrices without a trace"

    def project(self, matrix: Element) -> Element:
        return traceless(self.odd_part(matrix))

    def reversal(self, matrix: Element) -> Element:
        return adjoint(matrix)

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"tr (iμ)^{k}" for k in range(2, self.n + 1))

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        return jnp.stack(self._power_traces(1j * jnp.asarray(mu), tuple(range(2, self.n + 1))), axis=-1).real


class SL(AbstractMatrixAlgebra):
    """sl(n): traceless real matrices, ⟨μ, x⟩ = tr(μᵀx), basis E_ij for i ≠ j by rows, then diag(1, …, 1, −l, 0, …).

    Casimirs tr μ^k, k = 2, …, n. There is no Cayley map: it leaves the group.
    """

    n: int = eqx.field(static=True)

    @property
    def scale(self) -> float:
        return 1.0

    def __check_init__(self) -> None:
        check_size("SL", self.n, 2)

    @property
    def dim(self) -> int:
        return self.n**2 - 1

    def _make_basis(self) -> np.ndarray:
        units = np.eye(self.n**2).reshape(self.n, self.n, self.n, self.n)
        matrices = [units[i, j] for i in range(self.n) for j in range(self.n) if i != j]
        matrices += [np.diag([1.0] * k + [-float(k)] + [0.0] * (self.n - k - 1)) for k in range(1, self.n)]
        return np.array(matrices)

    @property
    def element_rule(self) -> str:
        return "matrices without a trace"

    def project(self, matrix: Element) -> Element:
        return traceless(matrix)

    def cayley(self, x: Element) -> Element:
        return AbstractLieAlgebra.cayley(self, x)

    def cayley_middle(self, x: Operand, mu: Operand) -> Element:
        return AbstractLieAlgebra.cayley(self, x)

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"tr μ^{k}" for k in range(2, self.n + 1))

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        return jnp.stack(self._power_traces(jnp.asarray(mu), tuple(range(2, self.n + 1))), axis=-1)


class Sp(AbstractMatrixAlgebra):
    """sp(n): real Hamiltonian matrices [[a, b], [c, −aᵀ]] of 2n rows, b and c symmetric; ⟨μ, x⟩ = ½ tr(μᵀx).

    Basis: a by rows, then b and c by rows of their upper triangles. Casimirs tr μ^2k, k = 1, …, n.
    """

    n: int = eqx.field(static=True)

    @property
    def scale(self) -> float:
        return 0.5

    def __check_init__(self) -> None:
        check_size("Sp", self.n, 1)

    @property
    def dim(self) -> int:
        return self.n * (2 * self.n + 1)

    @property
    def size(self) -> int:
        return 2 * self.n

    def _make_basis(self) -> np.ndarray:
        n, matrices = self.n, []
        for i in range(n):
            for j in range(n):
                one = np.zeros((2 * n, 2 * n))
                one[i, j], one[n + j, n + i] = 1.0, -1.0
                matrices.append(one)
        for row, column in ((0, n), (n, 0)):
            for i in range(n):
                for j in range(i, n):
                    one = np.zeros((2 * n, 2 * n))
                    one[row + i, column + j] = one[row + j, column + i] = 1.0
                    matrices.append(one)
        return np.array(matrices)

    @property
    def element_rule(self) -> str:
        return "matrices [[a, b], [c, −aᵀ]] with symmetric b and c"

    def project(self, matrix: Element) -> Element:
        return self.odd_part(matrix)

    def reversal(self, matrix: Element) -> Element:
        n = self.n
        # J M + Mᵀ J = 0 with J = [[0, 1], [−1, 0]] is σ(M) = −M for σ(M) = −J Mᵀ J, as J⁻¹ = −J
        form = np.block([[np.zeros((n, n)), np.eye(n)], [-np.eye(n), np.zeros((n, n))]])
        return -form @ adjoint(matrix) @ form

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"tr μ^{2 * k}" for k in range(1, self.n + 1))

    def casimirs(self, mu: Element) -> Float64[Array, "*batch k"]:
        return jnp.stack(self._power_traces(jnp.asarray(mu), tuple(range(2, 2 * self.n + 1, 2))), axis=-1)


def adjoint(matrix: Double[Array, "*batch n n"]) -> Double[Array, "*batch n n"]:
    """Return the conjugate transpose of the last two axes."""
    return jnp.conj(jnp.swapaxes(matrix, -1, -2))


def traceless(matrix: Double[Array, "*batch n n"]) -> Double[Array, "*batch n n"]:
    """Return the matrix (…, n, n) less its trace's share of the identity."""
    n = matrix.shape[-1]
    return matrix - (jnp.trace(matrix, axis1=-2, axis2=-1) / n)[..., None, None] * jnp.eye(n)


def check_size(name: str, size: int, least: int, letter: str = "n") -> None:
    """Refuse a size that is not a whole number, or too small."""
    check.whole(f"`{letter}` of {name}", size, least)
