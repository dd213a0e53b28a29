"""Stability of equilibria of any Lie–Poisson system, by automatic differentiation.

``conserved`` differentiates and checks functions, ``energy_casimir`` judges. Where Casimirs are missing
or the leaf is singular, the leaf's own tangent space, the image of the Poisson tensor, is judged as well.
Source: Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1; for relative equilibria Simo, Lewis & Marsden, Arch.
Rational Mech. Anal. 115 (1991) 15; Patrick, J. Geom. Phys. 9 (1992) 111; for singular leaves Patrick, Roberts & Wulff,
Arch. Rational Mech. Anal. 174 (2004) 301.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode._base.rational.numbers import as_fmpq
from polhode.algebra._functions import Function
from polhode.algebra.properties import index, is_compact
from polhode.analysis._conserved import Casimirs, Energy, Source, choose_casimirs, read_functions, samples_around
from polhode.analysis._equilibrium_data import Problem, problem
from polhode.analysis._exact_families import moves_along_equilibria
from polhode.analysis._exact_functions import exact_functions
from polhode.analysis._exact_verdict import decide_exactly
from polhode.analysis._motion_by_energy import check_motion
from polhode.analysis._reasons import (
    DefiniteOnLeaf,
    ExponentialGrowth,
    FieldVanishes,
    LeafIsPoint,
    MissingCasimirs,
    Restriction,
    SteadyDrift,
)
from polhode.analysis._second_variation import null_space
from polhode.analysis.certificate import Subject
from polhode.analysis.energy_casimir import Stability, energy_casimir
from polhode.analysis.first_method import first_method
from polhode.errors import InvalidInput
from polhode.poisson.brackets import as_points
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.systems.steady_motion import SteadyMotion
from polhode.types import Array, ArrayLike, Real


class StabilityLimits(NamedTuple):
    """Numbers that decide what an equilibrium is, and what vanishes there."""

    min_size: float = 1e-300  # of an equilibrium; smaller numbers lose digits
    max_size: float = 1e300  # of an equilibrium; sums of larger numbers overflow
    relative_field: float = 1e-8  # of |dH| |μ|: a field below it vanishes, up to what a solver leaves
    field_rounding: float = 1e-12  # of |dH| |μ|: a field that Newton's method cannot make smaller
    relative_zero: float = 1e-9  # singular values of the linearised flow below it, relative to the largest, vanish
    null_rounding: float = 4.0 * np.finfo(float).eps  # per dimension: smaller ones are rounding errors of zero
    tensor_rounding: float = 1e-13  # per dimension: smaller singular values of the Poisson tensor are rounding errors


LIMITS = StabilityLimits()


@known_numbers_only
def stability(
    system: AbstractSystem,
    equilibrium: Real[ArrayLike, "..."],
    integrals: Sequence[Function] = (),
    casimirs: Sequence[Function] | None = None,
) -> Stability:
    """Return the verdict on an equilibrium, or on a relative equilibrium if conserved functions are given.

    If the second variation of F = H + Σ λ C + Σ ω J, dF = 0, is definite on the null space of the dC and dJ, it proves
    Lyapunov's stability against all small perturbations, on this leaf and on others; an exponent of the linearised flow
    with positive real part disproves it. Integrals J that are at rest at the point, as a top's spin where it sleeps,
    take part like Casimirs. With others a motion along their flows is judged on the level of J, the flows' directions
    divided out: "stable" then holds up to these flows, which ``restriction`` says. Of the momentum map of a group that
    does not commute all components keep their levels, and those flows are divided out that do not change its value:
    turns about the angular momentum, or all turns where it is zero.

    Where this decides nothing and the null space is larger than the leaf's tangent space, because the leaf is singular
    or Casimirs are missing, H + Σ ω J is judged on the tangent space itself. An extremum there proves stability against
    all perturbations if the point is regular, for leaves nearby then hold extrema too, or if the group is compact, for
    leaves nearby then stay near this one. Else it proves stability on the leaf alone, and the verdict is "undecided".

    Where energy is lost the exponents alone decide, Lyapunov's first method.

    Args:
        system: any Lie–Poisson system; what it names conserved takes part by itself where it is at rest at the point.
            Or any other that gives derivatives by its ``steady_motion``, such as a rolling disk, whose linear integrals
            take the Casimirs' place.
        equilibrium: one point of the dual, (*element_shape), without attitude; of others a state of steady motion.
        integrals: further conserved functions of one point, real; those that are not at rest at the point must commute
            with each other, or be all components of a compact group's momentum map, as the three of the angular
            momentum. None where energy is lost.
        casimirs: real functions of one point, instead of those that the algebra names or exact algebra gives.

    Raises:
        InvalidInput: for a wrong shape, a point that is not a (relative) equilibrium, functions without finite second
            derivatives there, integrals that are not conserved or do not commute, wrong Casimirs, or a system that does
            not move by its energy alone. All are checked at random points nearby.

    >>> from polhode.systems import FreeRigidBody
    >>> [stability(FreeRigidBody((1.0, 2.0, 3.0)), row).verdict for row in np.eye(3)]
    ['stable', 'unstable', 'stable']
    """
    if not isinstance(system, AbstractLiePoissonSystem):
        return _judge_own(system, equilibrium, integrals, casimirs)
    algebra = system.algebra
    mu = as_points(algebra, equilibrium)
    if mu.shape != algebra.element_shape:
        raise InvalidInput(f"`equilibrium` must be one point {algebra.element_shape}; got shape {mu.shape}.")
    integrals = read_functions("integrals", integrals, algebra)
    z = np.asarray(algebra.to_dual_vector(mu))
    size = float(np.abs(z).max())
    if size and not LIMITS.min_size <= size <= LIMITS.max_size:
        raise InvalidInput(
            f"the largest component of `equilibrium` must be between {LIMITS.min_size:g} and {LIMITS.max_size:g}; got "
            f"{size:g}. Choose other units."
        )
    check_motion(system, lambda: samples_around(np.asarray(algebra.structure_constants()), z))
    known, subject = choose_casimirs(algebra, casimirs), Subject(system, z, tuple(integrals), casimirs)
    if not system.conserves_energy:
        if len(integrals):
            raise InvalidInput("`integrals` must be left out where energy is lost: exponents alone decide there.")
        return replace(_judge_dissipative(system, known, z), subject=subject)
    exact = exact_functions(system, known, tuple(integrals), z)
    p = problem(system, known, tuple(integrals), z, casimirs is not None, exact)
    verdict = _note_missing(_judge_equilibrium_first(p), known.missing)
    return replace(_at(verdict, np.asarray(mu)), subject=subject)


def _judge_own(system: AbstractSystem, state: Any, integrals: Sequence[Function], casimirs: Any) -> Stability:
    """Judge a steady motion of any other system by the derivatives that it gives itself."""
    gives = isinstance(system, AbstractSystem) and type(system).steady_motion is not AbstractSystem.steady_motion
    name = type(system).__name__
    if gives and (len(integrals) or casimirs is not None):
        raise InvalidInput(f"integrals of {name} are its own; leave out `integrals` and `casimirs`.")
    motion = system.steady_motion(state) if gives else None
    if motion is None:
        raise InvalidInput(f"`system` must be a Lie–Poisson system, or one that gives its `steady_motion`; got {name}.")
    return judge_steady_motion(motion)


def judge_steady_motion(motion: SteadyMotion) -> Stability:
    """Return the verdict on a steady motion from its derivatives, those of its conserved functions for Casimirs."""
    judged = energy_casimir(*motion[:5], motion.names, is_equilibrium=True, tolerance=1e-12)
    is_named = any(name in str(judged.reason) for name in motion.names)
    restricted = Restriction(within=motion.within, without=motion.without) if motion.without else None
    return replace(judged, legend=motion.legend if is_named else "",
                   restricted=restricted if judged.verdict == "stable" else None)


def _judge_equilibrium_first(p: Problem) -> Stability:
    """Judge as an equilibrium if it is one; else, or where that decides nothing, up to the flows of the integrals."""
    sizes = p.sizes(np.eye(len(p.g))[0])
    resting = np.linalg.norm(p.tensor @ p.g[0]) <= LIMITS.relative_field * sizes[2]
    judgement = None
    if resting or not p.free:
        _check_at_rest(p.tensor @ p.g[0], sizes[2], False)
        judgement = decide_exactly(_judge(p, np.eye(len(p.g))[0]), p)
        # a drift along a group that does not commute is what it was given for
        drifts = judgement.verdict == "unstable" and not judgement.rate and not p.commute
        if not p.free or not (judgement.verdict == "undecided" or drifts):
            return judgement
    weights = np.eye(len(p.g))[0]
    if not resting:
        weights[p.free] = -np.linalg.lstsq(p.tensor @ p.g[p.free].T, p.tensor @ p.g[0], rcond=None)[0]
    _check_at_rest(p.tensor @ (weights @ p.g), p.sizes(weights)[2], True)
    p, weights = _of_isotropy(p, weights)
    relative = _judge(p, weights, p.free)
    if relative.verdict != "stable" and judgement is not None and judgement.verdict != "undecided":
        return judgement
    if relative.verdict == "stable":
        relative = replace(relative, restricted=Restriction(flows=tuple(p.names[n - 1] for n in p.free)))
    return relative


def _judge(p: Problem, weights: Array, divided: Sequence[int] = ()) -> Stability:
    """Judge H + Σ ω J by all that is conserved and at rest, then on the leaf's tangent space.

    Args:
        p: the problem.
        weights: (1+k+j,) of H and the integrals.
        divided: integrals whose flows are divided out, all of whose levels are kept.
    """
    if p.still and not len(divided):
        return Stability("stable", 0.0, None, None, FieldVanishes(), np.zeros(0, complex))
    slope, curvature = weights @ p.g, np.tensordot(weights, p.H, 1)
    # ẏ_j = π_jk(y) ∂_k F, linearised: π D²F, and the derivative of π, which is linear, times dF
    flow = p.tensor @ curvature + np.einsum("jik,i->jk", p.constants, slope)
    sizes = p.sizes(weights)
    rows = [n for n in range(1, len(p.g)) if n not in p.free and n not in p.rotated]
    kept = [*rows, *divided]
    # across the directions in which the symmetries move, on the level of the momenta that they rotate
    moved = [*(p.g[list(divided)] @ p.tensor.T), *p.g[list(p.rotated)]]
    across = null_space(_unit_rows(np.array(moved)), LIMITS.relative_zero) if moved else np.eye(len(slope))

    def judge_part(basis: Array, H: Array, chosen: Sequence[int], error: float, **options: Any) -> Stability:
        inside, leafwise = np.abs(basis), basis is not across
        judgement = energy_casimir(
            p.unit * basis.T @ flow @ basis, (0.0 if leafwise else 1.0) * slope @ basis, basis.T @ H @ basis,
            p.g[chosen] @ basis, (0.0 if leafwise else 1.0) * basis.T @ p.H[chosen] @ basis,
            is_equilibrium=True, tolerance=min(error, 0.5), unit=p.unit,
            sizes=((0.0 if leafwise else 1.0) * sizes[0] @ inside, p.unit * inside.T @ sizes[1] @ inside), **options,
        )
        return _express_direction(judgement, basis)

    family = not len(divided) and _on_equilibria(p, flow, p.g[rows], float(sizes[1].max()))
    judgement = judge_part(across, curvature, kept, p.error, casimir_names=[p.names[n - 1] for n in kept],
                   on_equilibria=family, contained=weights[kept])
    tangent, effective, error = _on_tangent(p, flow, sizes[1])
    if judgement.verdict != "undecided":
        return judgement
    if tangent.shape[1] >= null_space(_unit_rows(p.g[rows]), LIMITS.relative_zero).shape[1]:
        return judgement
    leaf = tangent @ null_space(_unit_rows(np.array(moved).reshape(-1, len(slope))) @ tangent, LIMITS.relative_zero)
    # on a point there is nothing to judge
    leafwise = (judge_part(leaf, effective, list(divided), error) if leaf.shape[1] else
                Stability("stable", 0.0, None, None, LeafIsPoint(), np.zeros(0, complex)))
    return _leafwise(p, judgement, leafwise, tangent.shape[1], bool(len(divided)))


def _of_isotropy(p: Problem, weights: Array) -> tuple[Problem, Array]:
    """Return the problem with momenta combined into those whose flows keep J's value, and those that rotate it.

    Of a group that does not commute only the flows of the first kind are divided out: the others leave the level of J.
    """
    free = list(p.free)
    of_momenta = p.g[free]
    brackets = of_momenta @ p.tensor @ of_momenta.T
    size = float(np.abs(of_momenta).max(initial=0.0)) ** 2 * float(np.abs(p.tensor).max(initial=0.0))
    if not np.abs(brackets).max(initial=0.0) > LIMITS.relative_zero * size:
        return p, weights
    # {J_a, J_b} c_b = 0 for all a: the flow of Σ c_b J_b leaves the values of all J
    _, sizes, rows = np.linalg.svd(brackets)
    rank = int((sizes > LIMITS.relative_zero * sizes[0]).sum())
    mixing = np.vstack([_plain(rows[rank:]), rows[:rank]])
    g, H, names, rotated = p.g.copy(), p.H.copy(), list(p.names), weights.copy()
    g[free], H[free] = mixing @ of_momenta, np.tensordot(mixing, p.H[free], 1)
    rotated[free] = np.linalg.lstsq(mixing.T, weights[free], rcond=None)[0]
    for n, row in zip(free, mixing, strict=True):
        names[n - 1] = _combination(row, [p.names[m - 1] for m in free])
    kept = free[: len(free) - rank]
    return p._replace(g=g, H=H, names=names, free=kept, rotated=tuple(free[len(kept) :])), rotated


def _plain(rows: Array) -> Array:
    """Return a basis of the same span in which each row has a one where the others have zeros: it reads best."""
    columns: list[int] = []
    rows = rows.copy()
    for k in range(len(rows)):
        column = int(np.argmax(np.abs(rows[k])))
        rows[k] /= rows[k, column]
        for other in range(len(rows)):
            if other != k:
                rows[other] -= rows[other, column] * rows[k]
        columns.append(column)
    return rows[np.argsort(columns)]


def _combination(row: Array, names: list[str]) -> str:
    """Return a sum of multiples in words, without those that are rounding."""
    terms = [(value, name) for value, name in zip(row, names, strict=True) if abs(value) > LIMITS.relative_zero]
    text = " + ".join(name if value == 1.0 else f"{value:.6g} {name}" for value, name in terms)
    return text.replace("+ -", "− ").replace("-", "−")


def _express_direction(judgement: Stability, basis: Array) -> Stability:
    """Return a verdict with its direction along the coordinates instead of a basis (n, d)."""
    if judgement.direction is None:
        return judgement
    direction, reason = basis @ judgement.direction, judgement.reason
    if isinstance(reason, ExponentialGrowth | SteadyDrift):
        reason = replace(reason, direction=direction)
    return replace(judgement, direction=direction, reason=reason)


def _leafwise(p: Problem, judgement: Stability, leafwise: Stability, dimension: int, divided: bool) -> Stability:
    """Return the consequence of an extremum on the leaf, or a leaf of one point, for all neighbours."""
    if leafwise.verdict != "stable":
        return judgement
    sign = -1 if leafwise.function is not None and leafwise.function.signature[2] else 1
    reason = DefiniteOnLeaf("H + Σ ω J" if divided else "H", dimension, sign, "alike")
    if isinstance(leafwise.reason, LeafIsPoint):
        reason = LeafIsPoint(what="the leaf without the flows that are divided out" if divided else "the leaf")
    if dimension == p.y.size - index(p.system.algebra):
        return replace(leafwise, reason=reason, function=None)
    if is_compact(p.system.algebra):
        return replace(leafwise, reason=replace(reason, leaves_nearby="near"), function=None)
    return replace(judgement, reason=replace(reason, leaves_nearby="larger"))


def _on_tangent(p: Problem, flow: Array, flow_sizes: Array) -> tuple[Array, Array, float]:
    """Return an orthonormal basis (n, d) of the leaf's tangent space, the function's Hessian there (n, n), its error.

    On tangent vectors v = π ξ of an equilibrium D²F(v, w) = −ξ·A w, with A the linearised flow: A = π D²F in
    coordinates in which leaves are flat.
    """
    left, sizes, _ = np.linalg.svd(p.tensor)
    largest = float((np.abs(p.constants) @ np.abs(p.y)).max(initial=0.0))
    rank = int((sizes > LIMITS.tensor_rounding * len(sizes) * largest).sum())
    tangent = left[:, :rank]
    if not rank:
        return tangent, np.zeros_like(flow), p.error
    inverse = tangent @ np.linalg.inv(tangent.T @ p.tensor @ tangent) @ tangent.T
    effective = inverse @ flow @ tangent @ tangent.T
    effective = 0.5 * (effective + effective.T)
    amplified = float(flow_sizes.max()) / (sizes[rank - 1] * (np.abs(effective).max() or 1.0))
    return tangent, effective, p.error * max(1.0, amplified)


def _check_at_rest(field: Array, size: float, relative: bool) -> None:
    left = float(np.linalg.norm(field))
    if left > LIMITS.relative_field * size:
        kind = "a relative equilibrium" if relative else "an equilibrium"
        raise InvalidInput(
            f"the point is not {kind}: the field there is {left / size:.3g} of its terms. "
            "Find one by `find_equilibria`, or give the integrals whose symmetries carry it along."
        )


def _note_missing(judgement: Stability, missing: MissingCasimirs | None) -> Stability:
    """Return an undecided verdict with the Casimirs that might have helped."""
    return replace(judgement, missing=missing) if judgement.verdict == "undecided" else judgement


def _at(judgement: Stability, point: Array) -> Stability:
    """Return a verdict whose function has the values at the equilibrium."""
    function = judgement.function
    return judgement if function is None else replace(judgement, function=replace(function, point=point))


def _unit_rows(rows: Array) -> Array:
    lengths = np.linalg.norm(rows, axis=1, keepdims=True)
    return rows / np.where(lengths > 0, lengths, 1.0)


def _judge_dissipative(system: AbstractLiePoissonSystem, casimirs: Casimirs, z: Array) -> Stability:
    """Judge by the exponents alone, those of the field that moves the system, on the leaf."""
    field, linearization = (np.asarray(x) for x in _compute_field_and_slope(system, jnp.asarray(z)))
    if not (np.isfinite(field).all() and np.isfinite(linearization).all()):
        raise InvalidInput("the field must have finite derivatives at the equilibrium; got NaN or an infinity.")
    rows = _unit_rows(np.asarray(jax.jacfwd(casimirs.source)(jnp.asarray(z))).reshape(-1, z.size))
    _check_at_rest(field, float(np.abs(linearization).max() * np.linalg.norm(z)), False)
    return _note_missing(first_method(linearization, null_space(rows, LIMITS.relative_zero)), casimirs.missing)


@eqx.filter_jit
def _compute_field_and_slope(system: AbstractLiePoissonSystem, x: Array) -> tuple[Array, Array]:
    def field(x: Array) -> Array:
        point = system.algebra.from_dual_vector(x)
        return system.algebra.to_dual_vector(system.algebra.coadjoint(system.generator(0.0, point), point))

    return field(x), jax.jacfwd(field)(x)


def _on_equilibria(p: Problem, flow: Array, dC: Array, rate: float) -> bool:
    """Whether every direction in which the linearised flow on the leaf vanishes leads to equilibria on the leaf.

    From a point a little off in such a direction Newton's method must come back to an equilibrium at a distance of
    second order. A potential of high order looks the same there, so the equilibria must go on for at least a quarter of
    |μ|, with a field that vanishes to rounding.
    """
    steps = 32  # along a family of equilibria, each of a part of |μ|
    tangent = null_space(_unit_rows(dC), LIMITS.relative_zero)
    if not tangent.shape[1] or not p.y.any():
        return False
    _, sizes, rows = np.linalg.svd(tangent.T @ flow @ tangent)
    zero = LIMITS.null_rounding * len(p.y) * rate
    # moments that differ in the twelfth digit have no circle of equilibria, and no steady drift along one
    if ((sizes > zero) & (sizes <= LIMITS.relative_zero * rate)).any():
        return False
    still = tangent @ rows[int((sizes > zero).sum()) :].T
    if not still.shape[1]:
        return False
    if p.exact is not None:
        return moves_along_equilibria(p.exact, list(map(as_fmpq, p.y.tolist())), still.T)
    off = 1e-3 * np.linalg.norm(p.y)
    settled = _settle(p.system, p.casimirs, jnp.asarray(p.y), jnp.asarray(p.unit), jnp.asarray(p.y + off * still.T))
    points, fields, slopes = (np.asarray(x) for x in settled)
    near = np.linalg.norm(points - (p.y + off * still.T), axis=1) < 0.05 * off
    # where the linearised flow vanishes, its size a little off shows how large a rounding error of the field is
    rate = max(rate, float(np.linalg.norm(slopes, axis=(1, 2)).max()))
    if not (near & (np.linalg.norm(fields, axis=1) <= LIMITS.relative_field * off * rate)).all():
        return False
    step = np.linalg.norm(p.y) / steps
    last, ahead = np.broadcast_to(p.y, points.shape), points - p.y
    for _ in range(steps):
        ahead = ahead / np.linalg.norm(ahead, axis=1, keepdims=True)
        starts = last + step * ahead
        settled = _settle(p.system, p.casimirs, jnp.asarray(p.y), jnp.asarray(p.unit), jnp.asarray(starts))
        points, fields, slopes = (np.asarray(x) for x in settled)
        # Newton's method may go back along the family, but not as far as the last point
        near = (np.linalg.norm(points - starts, axis=1) < step) & (np.sum((points - last) * ahead, axis=1) > step / 4)
        rate = max(rate, float(np.linalg.norm(slopes, axis=(1, 2)).max()))
        if not (near & (np.linalg.norm(fields, axis=1) <= LIMITS.field_rounding * np.linalg.norm(p.y) * rate)).all():
            return False
        last, ahead = points, points - last
    return True


@eqx.filter_jit
def _settle(system: AbstractLiePoissonSystem, casimirs: Source, y: Array, unit: Array, starts: Array) -> Any:
    """Return where Newton's method takes each start on the levels of y, the field there, and its slope at the start."""
    level = casimirs(y)
    field = scaled_field(system, unit)

    def residual(x: Array) -> Array:
        return jnp.concatenate([field(x), casimirs(x) - level])

    def settle(start: Array) -> tuple[Array, Array, Array]:
        step = lambda _, x: x - jnp.linalg.lstsq(jax.jacfwd(residual)(x), residual(x), rcond=1e-4)[0]  # noqa: E731
        x = jax.lax.fori_loop(0, 6, step, start)
        return x, field(x), jax.jacfwd(field)(start)

    return jax.vmap(settle)(starts)


def scaled_field(system: AbstractLiePoissonSystem, unit: Any) -> Function:
    """Return the Hamiltonian field in coordinates y = μ/unit, divided by unit².

    Partial derivatives of H with respect to coordinates are those of dH.
    """
    algebra = system.algebra
    energy = Energy(system)

    def field(y: Array) -> Array:
        slope = jax.grad(lambda x: energy(x)[0])(unit * y) / unit
        generator = -system.sign * algebra.from_vector(slope)
        return algebra.to_dual_vector(algebra.coadjoint(generator, algebra.from_dual_vector(y)))

    return field
