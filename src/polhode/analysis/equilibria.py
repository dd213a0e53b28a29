"""Equilibria of any Lie–Poisson system on the leaf of a point, by least squares from random starts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode._base.long_work import long_work
from polhode.algebra._functions import Function
from polhode.analysis._conserved import Energy, Source, choose_casimirs, choose_unit
from polhode.analysis._motion_by_energy import check_motion
from polhode.analysis.stability import LIMITS as STABILITY_LIMITS
from polhode.analysis.stability import scaled_field
from polhode.errors import InvalidInput
from polhode.poisson.brackets import as_points
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, ArrayLike, Double, Float64, Real


class EquilibriaLimits(NamedTuple):
    """Numbers that decide which roots are equilibria, and which are one."""

    starts: int = 64  # of the search, by default
    distance: float = 1e-6  # in units of |μ|: nearer equilibria are one
    residual: float = 1e-10  # relative, of an equilibrium and its levels


LIMITS = EquilibriaLimits()


@known_numbers_only
@long_work("the search for equilibria")
def find_equilibria(
    system: AbstractLiePoissonSystem,
    state: Real[ArrayLike, "..."],
    starts: int = LIMITS.starts,
    seed: int = 0,
    casimirs: Sequence[Function] | None = None,
) -> Double[Array, "count ..."]:
    """Return the equilibria on the Casimirs' levels of one point, (m, *element_shape), lowest energy first.

    Levenberg and Marquardt's method from random starts of the point's size; what settles is sharpened and counted once.
    Where equilibria come in families, members of these. An incomplete list cannot be ruled out: take more starts.

    Args:
        system: any Lie–Poisson system.
        state: one point of the dual, not zero.
        starts: how many random starts.
        seed: of the random generator.
        casimirs: real functions of one point, instead of those that the algebra names or exact algebra gives.

    Raises:
        InvalidInput: for a wrong shape, the zero point, an algebra some of whose Casimirs are neither known nor given,
            or a system that does not move by its energy alone.
    """
    checked = 4  # starts at which the system must move as its energy says
    algebra = check.instance("system", system, AbstractLiePoissonSystem, "a Lie–Poisson system").algebra
    mu = as_points(algebra, state)
    if mu.shape != algebra.element_shape or not bool(jnp.any(mu != 0)):
        raise InvalidInput(f"`state` must be one point {algebra.element_shape} other than zero; got shape {mu.shape}.")
    known = choose_casimirs(algebra, casimirs)
    if known.missing:
        raise InvalidInput(f"the levels of all Casimirs are needed, but {known.missing}.")
    z = np.asarray(algebra.to_dual_vector(mu))
    unit = choose_unit(z)
    draws = np.random.default_rng(seed).normal(size=(starts, z.size)) / np.sqrt(z.size)
    check_motion(system, lambda: np.linalg.norm(z) * draws[:checked])
    constants = np.abs(algebra.structure_constants())
    given = jnp.asarray(z / unit), jnp.asarray(unit), jnp.asarray(draws), constants
    roots, left, moving, energies, works = map(np.asarray, _solve(system, known.source, *given))
    energies = energies if unit == 1.0 else works
    good = np.isfinite(roots).all(axis=1) & (left < LIMITS.residual) & (moving <= STABILITY_LIMITS.relative_field)
    kept: list[int] = []
    for k in np.flatnonzero(good):
        if all(np.linalg.norm(roots[k] - roots[other]) > LIMITS.distance for other in kept):
            kept.append(int(k))
    if not np.isfinite(energies[kept]).all():
        raise InvalidInput("the energy must be finite at the equilibria; choose units in which |μ| is nearer to one.")
    order = sorted(kept, key=lambda k: float(energies[k]))
    points = unit * np.linalg.norm(z / unit) * roots[order].reshape(-1, z.size)
    return np.asarray(algebra.from_dual_vector(jnp.asarray(points)))


@eqx.filter_jit
def _solve(
    system: AbstractLiePoissonSystem, casimirs: Source, level: Array, unit: Array, draws: Array, constants: Array
) -> tuple[Array, Array, Array, Array, Array]:
    """Return where each start settles, in units of |level|, the residuals there, the fields, and the energies.

    Residuals are relative to the level, on which small points would pass; fields to their own terms, as for
    ``stability``.

    These twice: as they are, and as ∫ dH along the ray from zero in ``unit``², which neither overflows nor underflows.
    """
    nodes_count = 12  # of Gauss's rule along a ray: exact for energies of degree 24
    import optimistix

    size, energy, field = jnp.linalg.norm(level), Energy(system), scaled_field(system, unit)
    differential = jax.grad(lambda x: energy(x)[0])
    slope = jnp.linalg.norm(differential(unit * level) / unit)
    rate = jnp.where(slope > 0, slope, 1.0)
    nodes, shares = np.polynomial.legendre.leggauss(nodes_count)
    wanted = casimirs(level)
    slopes = jnp.linalg.norm(jax.jacfwd(casimirs)(level).reshape(-1, level.size), axis=1) * size
    slopes = jnp.where(slopes > 0, slopes, 1.0)

    @jax.jit  # so that it is traced once, however often the solver asks for it
    def residual(x: Array, args: Any = None) -> Array:
        # at rest, and on the levels of the start: both relative to their own sizes
        return jnp.concatenate([field(size * x) / (rate * size), (casimirs(size * x) - wanted) / slopes])

    solver = optimistix.LevenbergMarquardt(rtol=1e-10, atol=1e-12)

    def work(y: Array) -> Array:
        # H(y) − H(0) = ∫₀¹ dH(ty)·y dt
        slopes = jax.vmap(lambda t: differential(unit * t * y) / unit)(0.5 + 0.5 * nodes)
        return 0.5 * shares @ (slopes @ y)

    def still_moving(y: Array) -> Array:
        # a slope that vanishes is a sum of terms that cancel, of the size of the curvature times the point
        slope, curvature = differential(unit * y) / unit, jax.jacfwd(differential)(unit * y)
        terms = (jnp.abs(constants) @ jnp.abs(y)).max() * (jnp.abs(slope) + jnp.abs(curvature) @ jnp.abs(y)).max()
        return jnp.linalg.norm(field(y)) / jnp.where(terms > 0, terms, 1.0)

    def solve(start: Array) -> tuple[Array, Array, Array, Array, Array]:
        x = optimistix.least_squares(residual, solver, start, max_steps=200, throw=False).value
        x = _sharpen(residual, x)
        return x, jnp.linalg.norm(residual(x)), still_moving(size * x), energy(unit * size * x)[0], work(size * x)

    return jax.vmap(solve)(draws)


def _sharpen(residual: Function, root: Float64[Array, "n"]) -> Float64[Array, "n"]:
    """Return a root by Newton's steps, of which each takes off a part alone where the root is degenerate.

    The residual has the field's n components first, then the levels.
    """

    steps = 60  # a degenerate root gains a fixed part with each
    longest_step = 1e-2  # in units of |μ|
    least_singular_value = 1e-13  # relative
    small = 1e-5  # in units of |μ|: smaller components are tried at zero
    rounding = 1e-15  # a residual below it is rounding
    def towards(x: Array, part: slice) -> Array:
        values, slopes = residual(x)[part], jax.jacfwd(residual)(x)[part]
        return x - jnp.linalg.lstsq(slopes, values, rcond=least_singular_value)[0] if values.size else x

    def on_levels(x: Array) -> Array:  # which curve by more than is left of a degenerate root
        levels = slice(root.size, None)
        return towards(towards(x, levels), levels)

    def left(x: Array) -> Array:
        return jnp.maximum(jnp.linalg.norm(residual(x)), rounding)

    def improve(_: Any, x: Array) -> Array:
        new = on_levels(towards(x, slice(None)))
        return jnp.where((left(new) <= left(x)) & (jnp.abs(new - x).max() < longest_step), new, x)

    x = jax.lax.fori_loop(0, steps, improve, root)
    # what is small beside the others is often zero, and slopes by which to see it are lost in roundings
    cleaned = on_levels(jnp.where(jnp.abs(x) < small, 0.0, x))
    return jnp.where(left(cleaned) <= left(x), cleaned, x)
