"""Stability of an equilibrium of a Lie–Poisson system, by the energy–Casimir method and by the spectrum.

An equilibrium is a critical point of F = H + Σ λ_k C_k. If the second variation of F is definite on the null space of
the dC_k, then F + Σ c_k (C_k − C_k⁰)² has a strict extremum in the whole space for some c_k, and confines every motion
that starts near: that is the certificate. It needs nothing of the C_k but that they are conserved; where leaves are
singular the null space is larger than the leaf's tangent space, and the test is only harder to pass. If the linearised
flow has an exponent with positive real part, its mode shows how neighbours leave. Between the two the matrices alone
decide nothing, and the verdict is "undecided".

Source: Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1; Marsden & Ratiu, *Introduction to Mechanics and
Symmetry*, §1.7 and §15.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._conserved_function import ConservedFunction
from polhode.analysis._printing import print_answer, write_numbers
from polhode.analysis._reasons import (
    AbstractReason,
    DefiniteVariation,
    EquilibriaWithoutShear,
    ExponentialGrowth,
    LeafOfEquilibria,
    MissingCasimirs,
    NoCombination,
    OpenVariation,
    Restriction,
    SteadyDrift,
)
from polhode.analysis._second_variation import Leaf, null_space, scale_leaf
from polhode.analysis.certificate import Certificate, Subject
from polhode.certificates._definite import definite_combination
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Complex128, Float64, Real


class EnergyCasimirLimits(NamedTuple):
    """Numbers that decide what an equilibrium is, and which functions contain the energy."""

    equilibrium_residual: float = 1e-8  # of dH + Σ λ dC, relative to its terms: what a solver leaves, beyond rounding
    energy_weight: float = 1e-12  # among weights of order one: below it a conserved function does not contain H


LIMITS = EnergyCasimirLimits()


@dataclass(frozen=True, eq=False)
class Stability:
    """A verdict with its certificate.

    "stable" is Lyapunov's: motions that start near enough, in any direction, on this leaf or on others, stay near for
    all times. Where less is proved, ``restriction`` says what. "unstable" means that some motions leave however near
    they start. "undecided" is all else, also where stability is proved on the leaf alone; the reason says which.

    Attributes:
        verdict: "stable", "unstable" or "undecided".
        rate: largest real part of an exponent of the linearised flow on the leaf [1/s].
        growth: "exponential", "linear", or None for a verdict that is not "unstable".
        direction: (n,) unit direction in which neighbours leave, or None.
        reason: the function that proves stability, the growth that disproves it, or why neither is known, as data.
        spectrum: exponents of the linearised flow on the null space of the dC [1/s], complex; those that vanish
            everywhere across regular leaves are left out.
        restricted: what "stable" is restricted to; None for all small perturbations.
        function: of conserved quantities by which the verdict was reached, or tried to be; None where there is none.
        missing: Casimirs that might have helped an undecided verdict; None where all are known.
        legend: what names in the reason stand for, where they are not usual ones.
        subject: the system and the point, of which ``certificate`` makes an exact proof; None for matrices alone, and
            after pickling.
    """

    verdict: str
    rate: float
    growth: str | None
    direction: Float64[Array, "n"] | None
    reason: AbstractReason
    spectrum: Complex128[Array, "d"]
    restricted: Restriction | None = None
    function: ConservedFunction | None = None
    missing: MissingCasimirs | None = None
    legend: str = ""
    subject: Subject | None = field(default=None, repr=False, compare=False)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "subject": None}  # a system may hold functions that cannot be pickled

    @property
    def certificate(self) -> Certificate:
        """The reason as a sentence; ``as_rational`` makes an exact proof of it."""
        flows = self.restricted if self.restricted is not None and self.restricted.flows else None
        parts = (self.reason, self.legend, flows, self.missing)
        return Certificate("; ".join(str(part) for part in parts if part), self)

    @property
    def words(self) -> str:
        """What the reason means, without formulas."""
        flows = self.restricted if self.restricted is not None and self.restricted.flows else None
        return "; ".join(str(part) for part in (self.reason.words, flows) if part)

    @property
    def restriction(self) -> str | None:
        """The restriction of "stable" in words, such as "up to the flow of J1"; None for no restriction."""
        return None if self.restricted is None else str(self.restricted)

    def __str__(self) -> str:
        at = f" {self.restricted}" if self.restricted is not None and not self.restricted.flows else ""
        return print_answer(
            f"{self.verdict}{at}: {self.certificate}", exponents=write_numbers(self.spectrum, "1/s"),
            fastest_growth=write_numbers(self.rate, "1/s") if self.rate else None,
        )


@known_numbers_only
def energy_casimir(
    linearization: Real[ArrayLike, "n n"],
    energy_gradient: Real[ArrayLike, "n"],
    energy_hessian: Real[ArrayLike, "n n"],
    casimir_gradients: Real[ArrayLike, "..."],
    casimir_hessians: Real[ArrayLike, "..."],
    casimir_names: Sequence[str] = (),
    on_equilibria: bool = False,
    is_equilibrium: bool = False,
    tolerance: float = 1e-12,
    sizes: tuple[Real[ArrayLike, "n"], Real[ArrayLike, "n n"]] | None = None,
    contained: Real[ArrayLike, "k"] | None = None,
    unit: float = 1.0,
) -> Stability:
    """Return the verdict on an equilibrium from the matrices there, in any consistent units.

    The state is scaled so that the terms of the second variation are of order one, each Casimir so that its gradient
    is: verdicts do not depend on units, nor on how far apart the sizes of the components are.

    Args:
        linearization: (n, n) derivative of the vector field [1/s].
        energy_gradient: (n,) dH.
        energy_hessian: (n, n) D²H.
        casimir_gradients: (k, n) dC_k; they may depend on each other, as on singular leaves. Other conserved
            quantities may be among them where their gradients depend on the Casimirs'. The freedom this leaves in
            λ is used.
        casimir_hessians: (k, n, n) D²C_k.
        casimir_names: what to call the Casimirs in the certificate; C1, C2, … if empty.
        on_equilibria: whether every null direction of the second variation on the leaf is known to be tangent to a
            family of equilibria on it. Then a shear along it moves neighbours away at a steady rate. Where the whole
            leaf is such a family, only a shear from other leaves is considered.
        is_equilibrium: whether the field is known to vanish here. On singular leaves it may although dH is no
            combination of the dC; the spectrum alone can then decide.
        tolerance: relative error of the entries, which decides what counts as zero. Zero for matrices whose entries
            are right to their last digit.
        sizes: (n,) of the terms of which dH is the sum and (n, n) of those of the linearisation. Where dH or the flow
            vanishes but for rounding errors of these terms, it is compared with them; without them, with itself.
        contained: (k,) multiples of the C_k that the given derivatives of H contain; the certificate names them.
        unit: of the state, if H and the C_k are given in its square: the certificate's squares are then divided by it.

    Raises:
        InvalidInput: for shapes that do not match, values that are not finite, a point that is not an equilibrium, or
            matrices that no conservative flow has: dC A = 0 and D²F A antisymmetric are necessary.

    >>> import numpy as np
    >>> momentum, moments = np.array([0.0, 0.0, 2.0]), np.array([1.0, 2.0, 3.0])
    >>> flow = np.array([[0.0, 1 / 3, 0.0], [-4 / 3, 0.0, 0.0], [0.0, 0.0, 0.0]])
    >>> energy_casimir(flow, momentum / moments, np.diag(1 / moments), [momentum], [np.eye(3)], ["½|L|²"]).verdict
    'stable'
    """
    A, g, H = (np.asarray(x, dtype=float) for x in (linearization, energy_gradient, energy_hessian))
    dC = np.asarray(casimir_gradients, dtype=float).reshape(-1, g.size)
    ddC = np.asarray(casimir_hessians, dtype=float).reshape(-1, g.size, g.size)
    _check(A, g, H, dC, ddC, casimir_names, tolerance)
    leaf = scale_leaf(A, g, H, dC, ddC, tolerance, sizes)
    if not np.isfinite(leaf.multipliers).all():
        raise InvalidInput("the multipliers of the Casimirs overflow; choose units in which |μ| is nearer to one.")
    names = list(casimir_names) or [f"C{k + 1}" for k in range(len(dC))]
    if leaf.residual > LIMITS.equilibrium_residual:
        return _on_singular_leaf(leaf, is_equilibrium)
    weights = _weights(leaf)
    leaf.check_conservation(weights)
    second = leaf.combination(weights)
    function = _function(leaf, weights, second, contained, names, unit)
    positive, flat, negative = function.signature
    if not flat and not (positive and negative):
        return _stable(leaf, weights, second, function)
    growth = _growth(leaf)
    if growth.direction is not None:
        return replace(_unstable(growth, growth.direction), function=function)
    indefinite = bool(positive and negative)
    if on_equilibria and not indefinite:
        return replace(_on_equilibria(leaf, second, leaf.zero(weights), function, growth.spectrum), function=function)
    reason = OpenVariation(function, indefinite, growth.real_part, growth.sure_from)
    return Stability("undecided", 0.0, None, None, reason, growth.spectrum, function=function)


def _function(
    leaf: Leaf, weights: Array, second: Array, contained: Array | None, names: Sequence[str], unit: float
) -> ConservedFunction:
    """Return F over the weight of H, and its curvatures; a negative weight turns the signs of both."""
    scale, size = weights[0] or 1.0, leaf.size(weights) or 1.0
    total = weights if contained is None else weights + np.r_[0.0, weights[0] * contained]
    curvatures = np.sort(np.sign(scale) * np.linalg.eigvalsh(second)) / size
    return ConservedFunction(
        tuple(names), total / scale, curvatures, leaf.zero(weights) / size, leaf.freedom.shape[1], unit=unit
    )


def _stable(leaf: Leaf, weights: Array, second: Array, function: ConservedFunction) -> Stability:
    """State the function; multiples of (C − C⁰)² make it definite across leaves too, and so on all of the space."""
    sizes, vectors = np.linalg.eigh(second)
    sign = -1.0 if sizes.size and sizes[0] < 0 else 1.0
    root = np.sqrt(sign * sizes)
    # √|D²F| makes the flow antisymmetric, so that its exponents come out imaginary, as they are
    frequencies = root[:, None] * (vectors.T @ leaf.flow @ vectors) / root
    frequencies = np.linalg.eigvalsh(0.5j * (frequencies - frequencies.T))
    spectrum = leaf.unit * (1j * np.sort_complex(frequencies)[::-1] + 0.0)
    sign = sign * (np.sign(weights[0]) or 1.0)
    squares, lengths = leaf.squares(weights)
    function = replace(function, squares=sign * squares / abs(weights[0] or 1.0), lengths=lengths)
    return Stability("stable", 0.0, None, None, DefiniteVariation(function, int(sign)), spectrum, function=function)


def _on_equilibria(leaf: Leaf, second: Array, zero: float, function: ConservedFunction, spectrum: Array) -> Stability:
    """Judge a semidefinite second variation whose null directions are tangent to equilibria.

    F then bounds the distance y to the equilibria by its initial size. A block of the flow that shears, ẇ = Σ a y,
    takes w away at that steady rate, for the y that drives it changes only with y². Without one the drift along the
    equilibria is of order y², and nothing is known.
    """
    sizes, vectors = np.linalg.eigh(second)
    flat = vectors[:, np.abs(sizes) <= zero]
    if flat.shape[1] == sizes.size:
        return _all_at_rest(leaf, function, spectrum)
    across = leaf.flow - flat @ (flat.T @ leaf.flow)
    drivers = null_space(across, leaf.noise * leaf.flow_size)
    _, shear, rows = np.linalg.svd(leaf.flow @ drivers)
    sure_from = leaf.noise * leaf.flow_size
    if shear[0] <= sure_from:
        reason = EquilibriaWithoutShear(function, leaf.unit * float(shear[0]), leaf.unit * sure_from)
        return Stability("undecided", 0.0, None, None, reason, spectrum)
    driver = drivers @ rows[0]
    return steady_drift(leaf.out(leaf.flow @ driver), leaf.out(driver), leaf.unit, spectrum)


def _all_at_rest(leaf: Leaf, function: ConservedFunction, spectrum: Array) -> Stability:
    """Judge a leaf of equilibria: its neighbours may hold none, and then drift past at a rate of their distance."""
    _, sizes, rows = np.linalg.svd(leaf.full)
    sure_from = leaf.noise * leaf.flow_size
    if sizes[0] > sure_from:
        return steady_drift(leaf.scale * (leaf.full @ rows[0]), leaf.scale * rows[0], leaf.unit, spectrum)
    reason = LeafOfEquilibria(function, leaf.unit * float(sizes[0]), leaf.unit * sure_from)
    return Stability("undecided", 0.0, None, None, reason, spectrum)


def steady_drift(moved: Array, displaced: Array, unit: float, spectrum: Array) -> Stability:
    """Return the verdict that neighbours displaced so are moved so, at a steady rate."""
    rate, direction = float(unit * np.linalg.norm(moved) / np.linalg.norm(displaced)), _unit(moved)
    return Stability("unstable", 0.0, "linear", direction, SteadyDrift(rate, direction), spectrum)


def _weights(leaf: Leaf) -> Array:
    """Return the weights of H and the Casimirs in F; where several do, ones that make it definite if any do."""
    plain = np.concatenate([[1.0], leaf.multipliers])
    free = leaf.freedom
    if not free.shape[1] or not leaf.basis.shape[1]:
        return plain
    directions = [plain, *np.hstack([np.zeros((free.shape[1], 1)), free.T])]
    sizes = [leaf.size(direction) or 1.0 for direction in directions]
    ends = np.linalg.eigvalsh(leaf.combination(plain))[[0, -1]]
    if ends[0] > leaf.zero(plain) or ends[1] < -leaf.zero(plain):
        return plain
    matrices = np.array([leaf.combination(direction) / size for direction, size in zip(directions, sizes, strict=True)])
    weights = definite_combination(matrices, leaf.noise)
    if weights is None:
        return plain
    weights[0] = weights[0] if abs(weights[0]) > LIMITS.energy_weight else 0.0
    parts = ((c / size) * direction for c, size, direction in zip(weights, sizes, directions, strict=True))
    return sum(parts, np.zeros(plain.shape))


class _Growth(NamedTuple):
    """Exponents on the leaf [1/s], the largest real part and that from which it is sure; the direction if it is."""

    spectrum: Array
    real_part: float
    sure_from: float
    direction: Array | None


def _growth(leaf: Leaf) -> _Growth:
    """Return exponents on the leaf, and rate and direction of the fastest growth unless it is an artefact of errors.

    An exponent of a defective block is split by an error e to a distance √e, where its condition 1/|yᴴx| is as large
    as 1/√e: only a real part beyond what errors of the matrix can do to this very exponent is a proof.
    """
    if not leaf.basis.shape[1]:
        return _Growth(np.zeros(0, complex), 0.0, 0.0, None)
    from scipy.linalg import eig

    eigensystem: Any = eig(leaf.flow, left=True, right=True)
    spectrum, left, right = eigensystem
    k = int(np.argmax(spectrum.real))
    alignment = max(abs(np.vdot(left[:, k], right[:, k])), np.finfo(float).tiny)
    real_part, sure_from = float(spectrum[k].real), leaf.noise * leaf.flow_size / alignment
    direction = None if real_part <= sure_from else _unit(leaf.out(_largest_real_part(right[:, k])))
    return _Growth(leaf.unit * spectrum, leaf.unit * real_part, leaf.unit * float(sure_from), direction)


def growing_direction(flow: Float64[Array, "d d"]) -> Float64[Array, "d"]:
    """Return the real direction of the mode with the largest real part of a linear flow."""
    spectrum, modes = np.linalg.eig(flow)
    return _largest_real_part(modes[:, int(np.argmax(np.real(spectrum)))])


def _unstable(growth: _Growth, direction: Array) -> Stability:
    reason = ExponentialGrowth(growth.real_part, direction)
    return Stability("unstable", growth.real_part, "exponential", direction, reason, growth.spectrum)


def _on_singular_leaf(leaf: Leaf, is_equilibrium: bool) -> Stability:
    """Judge an equilibrium at which the Casimirs' gradients do not span dH, by the spectrum alone."""
    if not is_equilibrium:
        raise InvalidInput(
            "the point is not an equilibrium: dH is not a combination of the dC there, "
            f"{leaf.residual:.3g} of it is left. Solve for the equilibrium first; if the field does vanish, a Casimir "
            "is missing or the leaf is singular: say `is_equilibrium=True`."
        )
    leaf.check_conservation(None)
    residual = float(leaf.residual)
    growth = _growth(leaf._replace(residual=0.0))
    if growth.direction is not None:
        return _unstable(growth, growth.direction)
    reason = NoCombination(residual, LIMITS.equilibrium_residual, growth.real_part, growth.sure_from)
    return Stability("undecided", 0.0, None, None, reason, growth.spectrum)


def _check(A: Array, g: Array, H: Array, dC: Array, ddC: Array, names: Sequence[str], tolerance: float) -> None:
    n = g.size
    if g.ndim != 1 or A.shape != (n, n) or H.shape != (n, n) or len(dC) != len(ddC) or len(names) not in (0, len(dC)):
        raise InvalidInput(
            f"shapes must match: dH (n,), D²H (n, n), linearisation (n, n), one gradient, Hessian and name a Casimir; "
            f"got {g.shape}, {H.shape}, {A.shape}, {len(dC)}, {len(ddC)} and {len(names)}."
        )
    if not all(np.isfinite(x).all() for x in (A, g, H, dC, ddC)):
        raise InvalidInput("the matrices at the equilibrium must be finite; got NaN or an infinity.")
    tolerance = check.number("tolerance", tolerance, least=0, below=1, remedy="It is a relative error.")


def _largest_real_part(mode: Array) -> Array:
    """Return the real part of a mode rotated to the phase at which that part is largest."""
    return (mode * np.exp(-0.5j * np.angle(np.sum(mode * mode)))).real


def _unit(vector: Array) -> Array:
    vector = vector / np.abs(vector).max()
    largest = vector[np.argmax(np.abs(vector))]
    return vector / (np.linalg.norm(vector) * np.sign(largest)) + 0.0
