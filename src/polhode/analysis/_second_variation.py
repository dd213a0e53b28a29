"""The second variation of H + Σ λ C on the tangent space of a leaf, dimensionless, and λ that make it definite.

Physical components differ in unit and size, so that no fixed threshold separates zero from small. Here the state is
scaled by powers of two until the terms of the second variation, before they cancel, are of order one; then their
rounding errors are all of the same size.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real


class SecondVariationLimits(NamedTuple):
    """Numbers that decide what is conserved, independent and rounding on a leaf."""

    conservation: float = 1e-6  # residual of dC A and D²F A + (D²F A)ᵀ, relative to their terms, after a solver
    independence: float = 1e-12  # singular values of unit gradients below it are those of dependent ones
    multiplier_rounding: float = 1e-14  # of the terms of dH: multipliers below it are those of its rounding errors
    balancing_sweeps: int = 8  # of either of the two nested scalings


LIMITS = SecondVariationLimits()


class Leaf(NamedTuple):
    """An equilibrium's matrices on the tangent space of its leaf, in scaled coordinates x = scale · y.

    Attributes:
        flow: (d, d) linearised flow along ``basis``, in ``unit``.
        full: (n, n) the same on all of the space.
        flow_size: the largest of the terms of which the flow's entries are sums.
        drift: (k, n) dC A for unit dC, relative to the largest entry of A; zero for Casimirs.
        hessians: (1+k, d, d) second derivatives of H and the C_k along ``basis``.
        terms: (1+k, d, d) the same in absolute values of all entries, which bound the effect of their errors.
        whole: (1+k, n, n) second derivatives on all of the space.
        gradients: (k, n) dC_k.
        multipliers: (k,) λ with dH + Σ λ dC = 0, in the units of the input.
        freedom: (k, f) combinations of Casimirs whose gradient vanishes here.
        basis: (n, d) orthonormal.
        scale: (n,) powers of two.
        residual: what is left of dH + Σ λ dC, relative to its terms.
        tolerance: relative error of the entries, as stated by the caller, or of the λ where gradients nearly depend.
        unit: of the flow [1/s], a power of two.
    """

    flow: Float64[Array, "d d"]
    full: Float64[Array, "n n"]
    flow_size: float
    drift: Float64[Array, "k n"]
    hessians: Float64[Array, "all d d"]
    terms: Float64[Array, "all d d"]
    whole: Float64[Array, "all n n"]
    gradients: Float64[Array, "k n"]
    multipliers: Float64[Array, "k"]
    freedom: Float64[Array, "k f"]
    basis: Float64[Array, "n d"]
    scale: Float64[Array, "n"]
    residual: float
    tolerance: float
    unit: float

    @property
    def noise(self) -> float:
        """Relative error of the entries: theirs or, if larger, what the point is away from the equilibrium."""
        return max(self.tolerance, self.residual) if self.tolerance else 0.0

    def combination(self, weights: Float64[Array, "all"]) -> Float64[Array, "d d"]:
        """Return Σ weights · second derivatives, (d, d)."""
        return np.tensordot(weights, self.hessians, 1)

    def size(self, weights: Float64[Array, "all"]) -> float:
        """Return the largest term of the combination, before anything cancels."""
        return float(np.tensordot(np.abs(weights), self.terms, 1).max(initial=0.0))

    def zero(self, weights: Float64[Array, "all"]) -> float:
        """Return how far from zero errors of the entries can move an eigenvalue of the combination."""
        return self.noise * self.size(weights) * max(1, self.basis.shape[1])

    def out(self, vector: Float64[Array, "d"]) -> Float64[Array, "n"]:
        """Return a vector along the basis in the coordinates of the input."""
        return self.scale * (self.basis @ vector)

    def check_conservation(self, weights: Float64[Array, "all"] | None) -> None:
        """Refuse a flow that leaves the Casimirs' levels or, F being given, changes D²F: no flow of the system does."""
        if np.abs(self.drift).max(initial=0.0) > LIMITS.conservation:
            raise InvalidInput(
                "the linearised flow does not conserve the Casimirs: dC A must vanish at an equilibrium. "
                "Check the order and the signs of the components, and that each C is conserved."
            )
        if weights is None or not self.basis.shape[1]:
            return
        change = self.combination(weights) @ self.flow
        terms = np.tensordot(np.abs(weights), self.terms, 1).max() * self.flow_size
        if np.abs(change + change.T).max() > LIMITS.conservation * terms:
            raise InvalidInput(
                "the linearised flow does not conserve the second variation of H + Σ λ C: D²F A must be antisymmetric. "
                "Check that the Hessians and the linearisation belong to the same conservative system and point."
            )

    def squares(self, weights: Float64[Array, "all"]) -> tuple[Float64[Array, "k"], Float64[Array, "k"]]:
        """Return c_k ≥ 0 and ℓ_k with |D²F| + 2 Σ (c_k/ℓ_k²) dC_k dC_kᵀ definite on all of the space, for D²F so here.

        By Schur's complement the part across the leaf must exceed what the coupling takes away [Finsler's lemma].
        """
        K = np.tensordot(weights, self.whole, 1)
        K = 0.5 * (K + K.T)
        if self.basis.shape[1] and self.combination(weights)[0, 0] < 0:
            K = -K
        squares, lengths = np.zeros(len(self.gradients)), _unit_rows(self.gradients)[1]
        rows = self.gradients[lengths > 0] / lengths[lengths > 0, None]
        across = np.linalg.svd(self.basis.T)[2][self.basis.shape[1] :].T if self.basis.size else np.eye(len(K))
        if not across.shape[1]:
            return squares, lengths
        coupling = self.basis.T @ K @ across
        inner = self.basis.T @ K @ self.basis
        left = across.T @ K @ across - (coupling.T @ np.linalg.solve(inner, coupling) if coupling.size else 0.0)
        metric = np.asarray(np.linalg.qr(rows @ across, mode="r")).T
        left = np.linalg.solve(metric, np.linalg.solve(metric, left).T)
        worst = np.linalg.eigvalsh(left)[0]
        if worst <= self.zero(weights):
            # twice what is needed or more: the digits that are printed must not spoil the proof
            squares[lengths > 0] = max(-worst, self.size(weights))
        return squares, lengths


def scale_leaf(
    A: Float64[Array, "n n"],
    g: Float64[Array, "n"],
    H: Float64[Array, "n n"],
    dC: Float64[Array, "k n"],
    ddC: Float64[Array, "k n n"],
    tolerance: float,
    sizes: tuple[Real[ArrayLike, "n"], Real[ArrayLike, "n n"]] | None = None,
) -> Leaf:
    """Return the leaf's matrices.

    Args:
        A: (n, n) linearised flow.
        g: (n,) dH.
        H: (n, n) D²H.
        dC: (k, n) gradients of the Casimirs.
        ddC: (k, n, n) their Hessians.
        tolerance: relative error of the entries.
        sizes: (n,) of the terms of which dH is the sum, (n, n) of those of A; both may vanish but for their rounding.
    """
    gradient_sizes, flow_sizes = (np.zeros(g.size), np.abs(A)) if sizes is None else sizes
    scale, multipliers = np.ones(g.size), np.zeros(len(dC))
    for _ in range(LIMITS.balancing_sweeps):
        multipliers = _multipliers(g * scale, dC * scale, gradient_sizes * scale)
        scale = _equilibrate(np.abs(H) + np.tensordot(np.abs(multipliers), np.abs(ddC), 1))
    square = scale[:, None] * scale
    A, g, dC = A * scale / scale[:, None], g * scale, dC * scale
    flow_sizes = np.maximum(np.abs(A), flow_sizes * scale / scale[:, None])
    largest = float(flow_sizes.max(initial=0.0))
    unit = 2.0 ** np.rint(np.log2(largest)) if largest else 1.0
    A, flow_sizes = A / unit, flow_sizes / unit
    whole = np.concatenate([H[None], ddC]) * square
    residual = _residual(g, dC, multipliers, gradient_sizes * scale)
    gradients, lengths = _unit_rows(dC)
    basis = _coordinates_or_null_space(gradients[lengths > 0], g.size)
    size = np.abs(basis)
    hessians = basis.T @ (0.5 * (whole + whole.transpose(0, 2, 1))) @ basis
    angles = np.linalg.svd(gradients, compute_uv=False)
    narrowest = float(angles[angles > LIMITS.independence].min(initial=1.0))
    return Leaf(
        flow=basis.T @ A @ basis,
        full=A,
        flow_size=float((size.T @ flow_sizes @ size).max(initial=0.0)) if basis.shape[1] else 1.0,
        drift=gradients @ A / (flow_sizes.max(initial=0.0) or 1.0),
        hessians=hessians,
        terms=size.T @ np.abs(whole) @ size,
        whole=whole,
        gradients=dC,
        multipliers=multipliers,
        freedom=null_space(gradients.T, LIMITS.independence) / np.where(lengths > 0, lengths, 1.0)[:, None],
        basis=basis,
        scale=scale,
        residual=residual,
        tolerance=max(tolerance, np.finfo(float).eps / narrowest) if tolerance else 0.0,
        unit=float(unit),
    )


def null_space(matrix: Float64[Array, "rows n"], tolerance: float) -> Float64[Array, "n d"]:
    """Return an orthonormal basis (n, d) of what the matrix takes to zero, singular values ≤ tolerance."""
    _, sizes, rows = np.linalg.svd(matrix)
    return rows[int((sizes > tolerance).sum()) :].T


def _multipliers(g: Array, dC: Array, sizes: Array) -> Array:
    """Return λ with dH + Σ λ dC = 0, nearest to zero in units of unit gradients, or zero where it is but rounding."""
    if not len(dC):
        return np.zeros(0)
    rows, lengths = _unit_rows(dC)
    # divided before solving, for gradients near the largest and smallest numbers
    size = np.abs(g).max(initial=0.0) or 1.0
    multipliers = np.linalg.lstsq(rows.T, -g / size, rcond=LIMITS.independence)[0]
    rounding = LIMITS.multiplier_rounding * sizes.max(initial=0.0)
    multipliers = np.where(np.abs(multipliers) * size > rounding, multipliers, 0.0)
    return multipliers * size / np.where(lengths > 0, lengths, 1.0)


def _equilibrate(terms: Array) -> Array:
    """Return powers of two d with d_i d_j terms_ij ≤ 2 and of order one somewhere in each row.

    Source: Ruiz, Rutherford Appleton Laboratory report RAL-TR-2001-034 (2001).
    """
    scale, used = np.ones(len(terms)), terms.any(axis=0)
    for _ in range(LIMITS.balancing_sweeps):
        # two roots, for a product of scales may overflow where the scaled entry does not
        rows = np.where(used, ((terms * scale) * scale[:, None]).max(axis=0, initial=0.0), 1.0)
        # Ruiz's iteration: the root of the largest entry of each row is divided out
        scale = scale / np.sqrt(rows)
    exponents = np.rint(np.log2(scale))
    # a component the second variation does not know has no scale of its own
    exponents[~used] = np.rint(np.mean(exponents[used])) if used.any() else 0.0
    return np.exp2(exponents)


def _unit_rows(dC: Array) -> tuple[Array, Array]:
    largest = np.abs(dC).max(axis=1, initial=0.0)
    largest = np.where(largest > 0, largest, 1.0)
    lengths = np.linalg.norm(dC / largest[:, None], axis=1) * largest
    return dC / np.where(lengths > 0, lengths, 1.0)[:, None], lengths


def _coordinates_or_null_space(rows: Array, n: int) -> Array:
    """Return an orthonormal basis of the null space with coordinate vectors where they fit: they keep entries exact."""
    used = rows.any(axis=0)
    free = np.eye(n)[:, ~used]
    rest = null_space(rows[:, used], LIMITS.independence) if len(rows) else np.zeros((0, 0))
    inside = np.zeros((n, rest.shape[1]))
    inside[used] = rest
    return np.hstack([free, inside])


def _residual(g: Array, dC: Array, multipliers: Array, sizes: Array) -> float:
    """Return what is left of dH + Σ λ dC relative to its terms, and to those of which dH itself is the sum."""
    parts = np.vstack([g, multipliers[:, None] * dC])
    largest = max(np.abs(parts).max(initial=0.0), sizes.max(initial=0.0)) or 1.0
    parts, sizes = parts / largest, sizes / largest
    whole = np.maximum(np.abs(parts).sum(axis=0), sizes)
    return float(np.linalg.norm(parts.sum(axis=0)) / (np.linalg.norm(whole) or 1.0))
