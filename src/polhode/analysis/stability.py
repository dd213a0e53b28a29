"""Equilibria of any Lie–Poisson system and their stability, by automatic differentiation.

What is differentiated goes to ``energy_casimir``, which judges. Source: Holm, Marsden, Ratiu & Weinstein, Phys. Rep.
123 (1985) 1; for relative equilibria Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode.algebra.casimirs import polynomial_casimirs
from polhode.algebra.properties import index
from polhode.analysis.energy_casimir import Stability, energy_casimir
from polhode.analysis.first_method import first_method
from polhode.analysis.rolling import rolling_stability
from polhode.analysis.second_variation import null_space
from polhode.errors import InvalidInput
from polhode.poisson.brackets import as_points
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.systems.euler_disk import EulerDisk

Array = Any
Function = Callable[[Array], Array]
AT_REST = 1e-8  # of |dH| |μ|: a field below it vanishes, up to the solver that found the point
DIFFERENTIATION = 1e-12  # relative error of second derivatives by AD of functions of order one
NULL = 1e-9  # singular values of the linearised flow below it, relative to the largest, vanish
HIGHEST_DEGREE = 4  # of Casimirs looked for where the algebra does not name enough
STARTS = 64
SAME = 1e-6  # distance, in units of |μ|, below which two equilibria are one
SOLVED = 1e-10


def stability(
    system: AbstractLiePoissonSystem | EulerDisk, equilibrium: Array, integrals: Sequence[Function] = ()
) -> Stability:
    """Return the verdict on an equilibrium, or on a relative equilibrium if conserved functions are given.

    The spectrum is that of the linearised flow on the leaf. Is the second variation of H + Σ λ C definite there, it
    proves stability; is an exponent's real part positive, it disproves it. Integrals J whose gradients depend on the
    Casimirs' at the point, as a top's spin where it sleeps, take part in the sum. With others a motion along their
    symmetries, dH + Σ λ dC + Σ ω dJ = 0, is judged on the level of J, the symmetries' directions divided out. Where
    energy is lost the exponents alone decide, Lyapunov's first method.

    Args:
        system: any Lie–Poisson system; what it names conserved takes part by itself where its gradient depends on the
            Casimirs'. Or a rolling disk, whose linear integrals take the Casimirs' place, see ``rolling_stability``.
        equilibrium: one point of the dual, (*element_shape), without attitude; of a disk a state of steady motion.
        integrals: further conserved functions of one point, real, whose flows commute; none where energy is lost.

    Raises:
        InvalidInput: for a wrong shape, or a point that is no (relative) equilibrium.

    >>> from polhode.systems import FreeRigidBody
    >>> [stability(FreeRigidBody((1.0, 2.0, 3.0)), row).verdict for row in np.eye(3)]
    ['stable', 'unstable', 'stable']
    """
    if isinstance(system, EulerDisk):
        return rolling_stability(system, equilibrium)
    if not isinstance(system, AbstractLiePoissonSystem):
        raise InvalidInput(f"`system` must be a Lie–Poisson system or an EulerDisk; got {type(system).__name__}.")
    algebra = system.algebra
    mu = as_points(algebra, equilibrium)
    if mu.shape != algebra.element_shape:
        raise InvalidInput(f"`equilibrium` must be one point {algebra.element_shape}; got shape {mu.shape}.")
    z = algebra.to_dual_vector(mu)
    energy, casimirs, names = _functions(system)
    if not system.conserves_energy:
        return _judge_dissipative(system, casimirs, z)
    known = [_in_coordinates(system, function) for function in system.extra_invariants.values()]
    extra = [_in_coordinates(system, function) for function in integrals]
    g, H, tensor, constants = _derivatives(system, [energy, casimirs, *known, *extra], z)
    k = 1 + len(names)
    bound = [n for n in range(k, len(g)) if _depends(g[n], g[1:k])]
    free = [n for n in range(k + len(known), len(g)) if n not in bound]
    weights = np.zeros(len(g))
    weights[0] = 1.0
    if free:
        weights[free] = -np.linalg.lstsq(tensor @ g[free].T, tensor @ g[0], rcond=None)[0]
    slope, curvature = weights @ g, np.einsum("k,kij->ij", weights, H)
    flow = tensor @ curvature + np.einsum("jik,i->jk", constants, slope)
    # beside dH what it is made of counts, as where a gyrostat's body rests dH itself vanishes
    size = max(float(np.linalg.norm(slope)), float(np.abs(flow).max())) * float(np.linalg.norm(z))
    _check_at_rest(tensor @ slope, size, bool(free))
    taking_part = [*range(1, k), *bound]
    dC, ddC = g[taking_part], H[taking_part]
    names = [*names, *(f"J{n + 1}" for n in range(len(bound) + len(free)))]
    if free:
        return _judge_relative(tensor, (flow, slope, curvature, dC, ddC), (g[free], H[free]), names)
    rate = max(float(np.abs(slope).max()), float(np.abs(flow).max()))
    family = _on_equilibria(_field(system, energy), casimirs, np.asarray(z), flow, dC, rate)
    return energy_casimir(
        flow, slope, curvature, dC, ddC, names, on_equilibria=family, is_equilibrium=True, tolerance=DIFFERENTIATION
    )


def find_equilibria(system: AbstractLiePoissonSystem, state: Array, starts: int = STARTS, seed: int = 0) -> Array:
    """Return the equilibria on the Casimirs' levels of one point, (m, *element_shape), lowest energy first.

    Levenberg and Marquardt's method from random starts of the point's size; what settles is sharpened and counted once.
    Where equilibria come in families, members of these. An incomplete list cannot be ruled out: take more starts.

    Args:
        system: any Lie–Poisson system.
        state: one point of the dual, not zero.
        starts: how many random starts.
        seed: of the random generator.

    Raises:
        InvalidInput: for a wrong shape or the zero point.
    """
    import optimistix

    algebra = system.algebra
    mu = as_points(algebra, state)
    if mu.shape != algebra.element_shape or not bool(jnp.any(mu != 0)):
        raise InvalidInput(f"`state` must be one point {algebra.element_shape} other than zero; got shape {mu.shape}.")
    level = np.asarray(algebra.to_dual_vector(mu))
    energy, casimirs, _ = _functions(system)
    field = _field(system, energy)
    unit = float(np.linalg.norm(level))
    rate = float(np.linalg.norm(jax.grad(energy)(jnp.asarray(level)))) or 1.0
    wanted = casimirs(jnp.asarray(level))
    slopes = np.linalg.norm(np.asarray(jax.jacfwd(casimirs)(jnp.asarray(level))), axis=1) * unit
    slopes = np.where(slopes > 0, slopes, 1.0)

    def residual(x: Array, args: Any = None) -> Array:
        return jnp.concatenate([field(unit * x) / (rate * unit), (casimirs(unit * x) - wanted) / slopes])

    solver = optimistix.LevenbergMarquardt(rtol=1e-10, atol=1e-12)
    draws = np.random.default_rng(seed).normal(size=(starts, len(level))) / np.sqrt(len(level))

    @jax.jit
    @jax.vmap
    def solve(start: Array) -> Array:
        return optimistix.least_squares(residual, solver, start, max_steps=200, throw=False).value

    jacobian = jax.jit(jax.jacfwd(residual))
    found: list[np.ndarray] = []
    for x in np.asarray(solve(jnp.asarray(draws))):
        if not np.isfinite(x).all():
            continue
        left = np.asarray(residual(x))
        for _ in range(3):
            better = x - np.linalg.lstsq(np.asarray(jacobian(x)), left, rcond=NULL)[0]
            rest = np.asarray(residual(better))
            if np.linalg.norm(rest) < np.linalg.norm(left):  # not so beside bifurcations
                x, left = better, rest
        good = np.linalg.norm(left) < SOLVED
        if good and all(np.linalg.norm(x - other) > SAME for other in found):
            found.append(x)
    points = unit * np.array(sorted(found, key=lambda x: float(energy(unit * x)))).reshape(-1, len(level))
    return np.asarray(algebra.from_dual_vector(jnp.asarray(points)))


def _functions(system: AbstractLiePoissonSystem) -> tuple[Function, Function, list[str]]:
    """Return energy and Casimirs as functions of coordinates ⟨μ, e_i⟩, and the Casimirs' names."""
    algebra = system.algebra
    energy = _in_coordinates(system, system.energy)
    names = list(algebra.casimir_names)
    if len(names) < index(algebra):
        polynomials = polynomial_casimirs(algebra, HIGHEST_DEGREE)
        return energy, lambda x: jnp.stack([p(x) for p in polynomials]), [str(p) for p in polynomials]
    return energy, lambda x: algebra.casimirs(algebra.from_dual_vector(x)), names


def _derivatives(system: AbstractLiePoissonSystem, functions: list[Function], z: Array) -> tuple[Array, ...]:
    """Return gradients (m, n) and Hessians (m, n, n) of functions of coordinates, one behind the other, the tensor
    π_ij = {x_i, x_j} (n, n), whose product with a gradient is the field, and its derivative (n, n, n)."""
    every = lambda x: jnp.concatenate([jnp.atleast_1d(function(x)) for function in functions])  # noqa: E731
    gradients, hessians = jax.jit(lambda x: (jax.jacrev(every)(x), jax.hessian(every)(x)))(z)
    constants = system.sign * system.algebra.structure_constants()
    return np.asarray(gradients), np.asarray(hessians), constants @ np.asarray(z), constants


def _depends(gradient: Array, rows: Array) -> bool:
    """Whether a gradient is a combination of the rows."""
    size = np.linalg.norm(gradient)
    if not len(rows) or size == 0.0:
        return bool(size == 0.0)
    left = gradient - rows.T @ np.linalg.lstsq(rows.T, gradient, rcond=NULL)[0]
    return bool(np.linalg.norm(left) <= NULL * size)


def _check_at_rest(field: Array, size: float, relative: bool) -> None:
    left = np.linalg.norm(field)
    if left > AT_REST * max(size, np.finfo(float).tiny):
        kind = "relative equilibrium" if relative else "equilibrium"
        raise InvalidInput(
            f"the point is no {kind}: the field there is {left:.3g} where its terms are {size:.3g}. "
            "Find one by `find_equilibria`, or give the integrals whose symmetries carry it along."
        )


def _in_coordinates(system: AbstractLiePoissonSystem, function: Function) -> Function:
    return lambda x: function(system.algebra.from_dual_vector(x))


def _field(system: AbstractLiePoissonSystem, energy: Function) -> Function:
    """Return the Hamiltonian field of a function of coordinates; partial derivatives are coordinates of dH."""
    algebra = system.algebra

    def field(x: Array) -> Array:
        generator = -system.sign * algebra.from_vector(jax.grad(energy)(x))
        return algebra.to_dual_vector(algebra.coadjoint(generator, algebra.from_dual_vector(x)))

    return field


def _judge_dissipative(system: AbstractLiePoissonSystem, casimirs: Function, z: Array) -> Stability:
    """Judge by the exponents alone, those of the field that moves the system, on the leaf."""
    field = lambda x: _moved(system, x)  # noqa: E731
    linearization, rows = np.asarray(jax.jacfwd(field)(z)), np.asarray(jax.jacfwd(casimirs)(z))
    _check_at_rest(np.asarray(field(z)), float(np.abs(linearization).max() * np.linalg.norm(z)), False)
    return first_method(linearization, null_space(rows, NULL * np.abs(rows).max(initial=0.0)), DIFFERENTIATION)


def _moved(system: AbstractLiePoissonSystem, x: Array) -> Array:
    point = system.algebra.from_dual_vector(x)
    return system.algebra.to_dual_vector(system.algebra.coadjoint(system.generator(0.0, point), point))


def _judge_relative(
    tensor: Array, matrices: tuple[Array, ...], integrals: tuple[Array, Array], names: list[str]
) -> Stability:
    """Judge on the level of the integrals, in coordinates across the directions in which their symmetries move."""
    flow, g, H, dC, ddC = matrices
    dJ, ddJ = integrals
    _, sizes, rows = np.linalg.svd(dJ @ tensor.T)
    basis = rows[int((sizes > NULL * max(sizes[0], np.finfo(float).tiny)).sum()) :].T
    found = energy_casimir(
        basis.T @ flow @ basis, g @ basis, basis.T @ H @ basis, np.concatenate([dC, dJ]) @ basis,
        np.einsum("ia,kij,jb->kab", basis, np.concatenate([ddC, ddJ]), basis), names,
        is_equilibrium=True, tolerance=DIFFERENTIATION,
    )  # fmt: skip
    return found if found.direction is None else replace(found, direction=basis @ found.direction)


def _on_equilibria(
    field: Function, casimirs: Function, z: np.ndarray, flow: Array, dC: Array, rate: float
) -> bool:
    """Whether every direction in which the linearised flow on the leaf vanishes leads to equilibria on the leaf.

    From a point a little off in such a direction Newton's method must come back to an equilibrium at a distance of
    second order.
    """
    _, sizes, rows = np.linalg.svd(dC) if len(dC) else (None, np.zeros(0), np.eye(len(z)))
    tangent = rows[int((sizes > NULL * max(sizes.max(initial=0.0), np.finfo(float).tiny)).sum()) :].T
    if not tangent.shape[1]:
        return False
    on_leaf = tangent.T @ flow @ tangent
    _, sizes, rows = np.linalg.svd(on_leaf)
    still = tangent @ rows[int((sizes > NULL * rate).sum()) :].T
    if not still.shape[1]:
        return False
    level = np.asarray(casimirs(jnp.asarray(z)))
    residual = jax.jit(lambda x: jnp.concatenate([field(x), casimirs(x) - level]))
    jacobian = jax.jit(jax.jacfwd(residual))
    size = np.linalg.norm(z)
    for way in still.T:
        off = 1e-3 * size
        start = z + off * way
        x = start
        for _ in range(6):
            x = x - np.linalg.lstsq(np.asarray(jacobian(x)), np.asarray(residual(x)), rcond=1e-4)[0]
        settled = np.linalg.norm(np.asarray(field(jnp.asarray(x)))) <= AT_REST * off * rate
        if not (settled and np.linalg.norm(x - start) < 0.05 * off):
            return False
    return True
