"""Verdicts by exact signs: where polynomials decide, no threshold does.

A margin in doubles beyond their errors decides as well as exact signs, and sooner. What it leaves open, and what rests
on equal numbers, is decided over the rationals: signs of a second variation on the leaf by Sylvester's law, growth by
the characteristic polynomial, families of equilibria by identities of polynomials.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cached_property

import numpy as np
from flint import fmpq_mat

from polhode._base.rational._matrices import (
    as_floats,
    combine,
    matrix,
    null_space,
    reduce_rows,
    signature,
)
from polhode._base.rational._polynomials import half_hessian
from polhode._base.rational._univariate import largest_real_part
from polhode.analysis._conserved_function import ConservedFunction
from polhode.analysis._equilibrium_data import Problem
from polhode.analysis._exact_families import moves_along_equilibria
from polhode.analysis._exact_functions import ExactFunctions
from polhode.analysis._reasons import (
    DefiniteOnLeaf,
    DefiniteVariation,
    ExponentialGrowth,
    LeafIsPoint,
    NoCombination,
    OpenVariation,
    SteadyDrift,
)
from polhode.analysis.energy_casimir import Stability, growing_direction, steady_drift
from polhode.certificates._confinement import Confinement, find_confinement, restrict
from polhode.certificates._equations import ENERGY, Equations, rational_equilibrium
from polhode.errors import InvalidInput
from polhode.types import Complex128, Float64

BY_EQUALITY = SteadyDrift, DefiniteOnLeaf, LeafIsPoint  # reasons that rest on numbers being equal, or ranks


def decide_exactly(numerical: Stability, p: Problem) -> Stability:
    """Return the verdict by exact signs where doubles left it open, or rested on equal numbers.

    Args:
        numerical: by doubles, on an equilibrium itself, not up to flows.
        p: from which doubles decided it. Without polynomials, or an equilibrium over the rationals near the point, the
            verdict stays as it is.
    """
    if p.exact is None or not (numerical.verdict == "undecided" or isinstance(numerical.reason, BY_EQUALITY)):
        return numerical
    equations = _at_equilibrium(numerical, p)
    if equations is None:
        return numerical
    if proof := find_confinement(equations, _hint(numerical)):
        return _stable(numerical, equations, proof)
    here = _Leaf(equations, p.exact)
    if rate := largest_real_part(here.flow.charpoly()):
        direction = growing_direction(as_floats(here.flow)) @ as_floats(here.basis)
        direction = direction / np.linalg.norm(direction)
        return Stability("unstable", rate, "exponential", direction, ExponentialGrowth(rate, direction),
                         here.spectrum, function=numerical.function)
    if here.drifts:
        return numerical if isinstance(numerical.reason, SteadyDrift) else _drifting(numerical, here)
    return _on_leaf_alone(numerical, here)


def _hint(numerical: Stability) -> dict[str, float]:
    if numerical.function is None:
        return {}
    return dict(zip((ENERGY, *numerical.function.names), map(float, numerical.function.weights), strict=True))


def _at_equilibrium(numerical: Stability, p: Problem) -> Equations | None:
    """Return the equations at an exact equilibrium near the point, if there is one over the rationals."""
    exact = p.exact
    assert exact is not None  # for the type checker: the caller asked
    conserved = exact.conserved
    try:
        point, moved = rational_equilibrium(exact.field, conserved, _hint(numerical), p.y.tolist(), Fraction)
    except InvalidInput:
        return None
    return Equations(type(p.system).__name__, exact.field, conserved, point, moved)


class _Leaf:
    """The exact matrices of an equilibrium on the levels of what is conserved and has it at rest."""

    def __init__(self, equations: Equations, exact: ExactFunctions) -> None:
        self.equations, self.exact, self.point = equations, exact, equations.point
        self.names = [*(name for name, p in equations.conserved.items() if name != ENERGY
                        and not any(f(*self.point) for f in exact.flow(p))), ENERGY]  # fmt: skip
        self.basis = null_space(matrix([equations.slopes[name] for name in self.names], equations.size))

    @cached_property
    def flow(self) -> fmpq_mat:
        """The linearised flow along the basis, whose vectors have a one each where the others have zeros."""
        places = [max(k for k, x in enumerate(v) if x) for v in self.basis.tolist()]
        images = (self.equations.linearization * self.basis.transpose()).tolist()
        return matrix([images[k] for k in places], len(places))

    @cached_property
    def spectrum(self) -> Complex128[np.ndarray, "dim"]:
        """Its exponents [1/s]."""
        return np.linalg.eigvals(as_floats(self.flow)).astype(complex)

    @cached_property
    def tensor(self) -> fmpq_mat:
        """π at the point."""
        return self.exact.tensor_at(self.point)

    @cached_property
    def second(self) -> fmpq_mat | None:
        """½ D²F along the basis, with H in F and no freedom used; None where dH is no combination of other slopes."""
        slopes = matrix([self.equations.slopes[k] for k in self.names], self.equations.size)
        weights = null_space(slopes.transpose()).tolist()
        if not weights or not weights[-1][-1] or not self.basis:
            return None
        halves = [half_hessian(self.equations.conserved[k], self.point) for k in self.names]
        return restrict(combine(weights[-1], halves), self.basis)

    @cached_property
    def drifts(self) -> bool:
        """Whether neighbours drift at a steady rate along equilibria, which bound the distance from them.

        Directions in which a semidefinite D²F vanishes must lead along equilibria. The flow then shears where its
        square takes more to zero than itself; where the whole leaf is at rest, where it moves neighbours at all.
        """
        size = self.basis.nrows()
        if self.second is None or self.tensor.rank() != size:
            return False
        positive, zero, negative = signature(self.second)
        if not zero or (positive and negative):
            return False
        whole = zero == size
        flow = self.equations.linearization if whole else self.flow
        if not (flow if whole else (flow * flow).rank() < flow.rank()):
            return False
        flat = null_space(self.second) * self.basis
        return moves_along_equilibria(self.exact, self.point, as_floats(flat))

    @cached_property
    def driver(self) -> Float64[np.ndarray, "dim"]:
        """A direction whose neighbours drift."""
        whole = not self.second
        flow = self.equations.linearization if whole else self.flow
        candidates = null_space(flow * flow)
        images = as_floats(candidates * flow.transpose())
        k = int(np.argmax(np.abs(images).max(axis=1)))
        return as_floats(candidates if whole else candidates * self.basis)[k]

    @cached_property
    def on_tangent(self) -> tuple[int, tuple[int, int, int]]:
        """The leaf's dimension, and the signature of the energy on its tangent space.

        On tangent vectors v = π ξ of an equilibrium D²F(v, w) = −ξ·A w.
        """
        moved = self.equations.linearization * self.tensor
        _, places = reduce_rows(self.tensor)
        return len(places), signature(matrix([[-moved[a, b] for b in places] for a in places], len(places)))


def _stable(numerical: Stability, equations: Equations, proof: Confinement) -> Stability:
    """Return the verdict with the function of the proof, divided by the weight of the energy."""
    names = [name for name in equations.conserved if name != ENERGY]
    scale = float(proof.weights.get(ENERGY, 0)) or 1.0
    sign = 1 if scale > 0 else -1
    weights = np.array([float(proof.weights.get(name, 0)) / scale for name in (ENERGY, *names)])
    squares = np.array([float(proof.squares.get(name, 0)) / scale for name in names])
    basis = null_space(matrix(list(equations.slopes.values()), equations.size))
    halves = {name: half_hessian(equations.conserved[name], equations.point) for name in proof.weights}
    size = max((float(abs(w)) * np.abs(as_floats(halves[name])).max() for name, w in proof.weights.items()),
               default=0.0) or 1.0
    bends = (as_floats(restrict(combine(proof.weights.values(), list(halves.values())), basis)) if basis and halves
             else np.zeros((0, 0)))
    # all of one sign, by exact ones: rounding must not turn it
    curvatures = sign * np.maximum(np.abs(np.linalg.eigvalsh(bends)) / size, np.finfo(float).tiny)
    function = ConservedFunction(tuple(names), weights, np.sort(curvatures), 0.0, squares=squares,
                                 lengths=np.ones(len(names)))
    return Stability("stable", 0.0, None, None, DefiniteVariation(function, sign), 1j * numerical.spectrum.imag,
                     function=function)


def _drifting(numerical: Stability, here: _Leaf) -> Stability:
    moved = as_floats(here.equations.linearization) @ here.driver
    return replace(steady_drift(moved, here.driver, 1.0, numerical.spectrum), function=numerical.function)


def _on_leaf_alone(numerical: Stability, here: _Leaf) -> Stability:
    """Return the verdict by the energy's signs on the leaf's own tangent space; undecided where these differ."""
    dimension, (positive, zero, negative) = here.on_tangent
    if not zero and not (positive and negative):
        nearby = ("alike" if here.exact.is_regular(here.point) else "near" if here.exact.is_compact else "larger")
        reason = DefiniteOnLeaf("H", dimension, -1 if negative else 1, nearby) if dimension else LeafIsPoint(nearby)
        verdict = "undecided" if nearby == "larger" else "stable"
        function = numerical.function if verdict == "undecided" else None
        return Stability(verdict, 0.0, None, None, reason, numerical.spectrum, function=function)
    if numerical.verdict == "undecided" and not isinstance(numerical.reason, BY_EQUALITY):
        return numerical
    reason = (NoCombination(0.0, 0.0, 0.0, 0.0) if numerical.function is None else
              OpenVariation(numerical.function, bool(positive and negative), 0.0, 0.0))
    return Stability("undecided", 0.0, None, None, reason, numerical.spectrum, function=numerical.function)
