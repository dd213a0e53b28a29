"""The matrices behind a verdict: derivatives of all that is conserved at an equilibrium, dimensionless."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from flint import fmpq_mpoly

from polhode.algebra._functions import Function
from polhode.analysis._conserved import (
    Casimirs,
    Derivatives,
    Energy,
    Given,
    Known,
    Source,
    check_casimirs,
    check_closed,
    check_commute,
    choose_unit,
    commute,
    derivatives,
    refuse_rough,
    samples_around,
)
from polhode.analysis._exact_functions import ExactFunctions, polynomial_derivatives, refuse_inexact
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Float64


class FieldLimits(NamedTuple):
    """Numbers that decide whether a vector field vanishes."""

    # of a function at the point, relative to its terms: below it the flow leaves the point where it is
    relative_field: float = 1e-9
    # per dimension, relative to the terms: a field below it at all random points is rounding of zero
    field_rounding: float = 1e-15


LIMITS = FieldLimits()


class Problem(NamedTuple):
    """An equilibrium in coordinates y = μ/unit, with H/unit² in unit² and time in 1/unit.

    Attributes:
        g, H: (1+k+j, n) gradients and (…, n, n) Hessians of H, the k Casimirs and the j integrals at rest or given.
        tensor, constants: π and its derivative.
        names: of the Casimirs and integrals.
        free: which integrals are not at rest at the point; their flows are divided out.
        error: relative, of the second derivatives.
        still: whether the field vanishes all around.
        commute: whether the integrals that are not at rest commute with each other, everywhere.
        exact: all functions as polynomials over the rationals; None where some are none.
        rotated: integrals that other symmetries rotate: their levels are kept, and their flows are not divided out.
    """

    system: AbstractLiePoissonSystem
    casimirs: Source
    y: Float64[Array, "n"]
    unit: float
    g: Float64[Array, "terms n"]
    H: Float64[Array, "terms n n"]
    tensor: Float64[Array, "n n"]
    constants: Float64[Array, "n n n"]
    names: list[str]
    free: list[int]
    error: float
    still: bool
    commute: bool
    exact: ExactFunctions | None = None
    rotated: tuple[int, ...] = ()

    def sizes(self, weights: Float64[Array, "terms"]) -> tuple[Float64[Array, "n"], Float64[Array, "n n"], float]:
        """Return the sizes of the terms that make up dF (n,), the flow (n, n), and the field.

        A gradient that vanishes is a sum of terms that cancel: rounding errors of the point alone change it by those of
        |D²F| |μ|.
        """
        terms = np.abs(weights) @ (np.abs(self.g) + np.abs(self.H) @ np.abs(self.y))
        tensor = np.abs(self.constants) @ np.abs(self.y)
        by_gradient = np.einsum("jik,i->jk", np.abs(self.constants), terms)
        flow = tensor @ np.tensordot(np.abs(weights), np.abs(self.H), 1) + by_gradient
        return terms, flow, float(tensor.max(initial=0.0) * terms.max(initial=0.0))


def problem(
    system: AbstractLiePoissonSystem,
    casimirs: Casimirs,
    integrals: tuple[Function, ...],
    z: Float64[Array, "n"],
    casimirs_given: bool,
    exact: ExactFunctions | None,
) -> Problem:
    """Differentiate all functions, and refuse those that are not conserved.

    Polynomials over the rationals have exact derivatives, and are conserved or not.
    """
    unit = choose_unit(z)
    y, constants = z / unit, system.sign * np.asarray(system.algebra.structure_constants())
    around = samples_around(constants, y)
    tensors = np.einsum("ijk,mk->mij", constants, around)
    energy = _in_units(_differentiate(Energy(system), exact and [exact.energy], z, unit * around), unit)
    refuse_rough(energy, "the energy")
    own = _differentiate(casimirs.source, exact and [*exact.casimirs.values()], y, around)
    refuse_rough(own, "each Casimir")
    if casimirs_given:
        check_casimirs(tensors, own.around)
    tensor = constants @ y
    known = _integrals(Known(system), Known(system).names, exact and [*exact.known.values()], tensor, z, unit, around)
    wanted = _integrals(Given(system.algebra, integrals), [f"J{k + 1}" for k in range(len(integrals))],
                        exact and [*exact.given.values()], tensor, z, unit, around)
    refuse_rough(wanted.derived, "each of `integrals`")
    moving = [wanted.derived.around[:, k] for k, rest in enumerate(wanted.rest) if not rest]
    # a function that the system names takes no part where the symmetries rotate it
    known = known.choose([
        k for k, rest in enumerate(known.rest)
        if rest and known.derived.smooth[k] and all(commute(tensors, known.derived.around[:, k], x) for x in moving)
    ])
    for functions in (known, wanted):
        for name, slopes in zip(functions.names, np.moveaxis(functions.derived.around, 1, 0), strict=True):
            check_commute(tensors, slopes, energy.around[:, 0], (name, "H"),
                          "It is not conserved; check the function, its sign and its parameters.")
    if exact is not None:
        refuse_inexact(exact, casimirs_given)
        kept = exact.conserved
        known = known.choose([k for k, name in enumerate(known.names) if name in kept])
    names = [*_name_scaled(casimirs, y, unit), *known.names, *wanted.names]
    parts = [energy, own, known.derived, wanted.derived]
    first = 1 + len(names) - len(wanted.names)
    free = [first + k for k, rest in enumerate(wanted.rest) if not rest]
    commutes = _check_symmetries(system, integrals, unit * around, tensors, wanted)
    slopes = energy.around[:, 0]
    still = exact.still if exact is not None else _vanishes(
        np.einsum("mij,mj->mi", tensors, slopes), np.einsum("mij,mj->mi", np.abs(tensors), np.abs(slopes))
    )
    g, H = (np.concatenate([getattr(part, field) for part in parts]) for field in ("gradients", "hessians"))
    error = max(float(part.errors.max(initial=0.0)) for part in parts)
    return Problem(system, casimirs.source, y, unit, g, H, tensor, constants, names, free, error, still, commutes,
                   exact)


def _differentiate(
    source: Source, polynomials: Sequence[fmpq_mpoly] | None, z: Array, around: Array
) -> Derivatives:
    return derivatives(source, z, around) if polynomials is None else polynomial_derivatives(polynomials, z, around)


class _Integrals(NamedTuple):
    """Functions that may take part: names, derivatives, and which flows leave the point where it is."""

    names: list[str]
    derived: Derivatives
    rest: list[bool]

    def choose(self, rows: list[int]) -> _Integrals:
        return _Integrals([self.names[k] for k in rows], self.derived.choose(rows), [self.rest[k] for k in rows])


def _integrals(
    source: Source, names: list[str], polynomials: Sequence[fmpq_mpoly] | None, tensor: Array, z: Array,
    unit: float, around: Array,
) -> _Integrals:
    if not names:
        n = z.size
        return _Integrals([], Derivatives(np.zeros((0, n)), np.zeros((0, n, n)), np.zeros((len(around), 0, n)),
                                          np.zeros(0), np.zeros(0)), [])
    derived = _in_units(_differentiate(source, polynomials, z, unit * around), unit)
    return _Integrals(names, derived, [_is_at_rest(tensor, gradient) for gradient in derived.gradients])


def _check_symmetries(
    system: AbstractLiePoissonSystem, integrals: tuple[Function, ...], around: Array, tensors: Array, wanted: _Integrals
) -> bool:
    """Return whether integrals commute, of which some are divided out; refuse those that do not make up a group."""
    if all(wanted.rest) or len(integrals) < 2:
        return True
    values = np.asarray(jax.vmap(Given(system.algebra, integrals))(jnp.asarray(around)))
    return check_closed(tensors, wanted.derived.around, values, wanted.names)


def _is_at_rest(tensor: Array, gradient: Array) -> bool:
    """Whether a function's flow leaves the point where it is."""
    terms = np.abs(tensor).max(), np.abs(gradient).max()
    return bool(np.abs(tensor @ gradient).max() <= LIMITS.relative_field * terms[0] * terms[1])


def _in_units(derived: Derivatives, unit: float) -> Derivatives:
    """Return derivatives of f(unit · y)/unit²."""
    return derived._replace(gradients=derived.gradients / unit, around=derived.around / unit)


def _name_scaled(casimirs: Casimirs, y: Array, unit: float) -> list[str]:
    """Return the names of unit² C(μ/unit), which is C itself if C is quadratic."""
    if unit == 1.0:
        return list(casimirs.names)
    ones, twos = (np.asarray(casimirs.source(jnp.asarray(x))) for x in (np.cos(np.arange(y.size)),
                                                                         2.0 * np.cos(np.arange(y.size))))
    quadratic = np.isclose(twos, 4.0 * ones, rtol=1e-9)
    return [name if plain else f"({unit:.3g})² ({name} of μ/{unit:.3g})"
            for name, plain in zip(casimirs.names, quadratic, strict=True)]


def _vanishes(values: Array, terms: Array) -> bool:
    good = np.all(np.isfinite(values), axis=1)
    values, terms = values[good], terms[good].max(axis=1, keepdims=True)
    rounding = LIMITS.field_rounding * values.shape[1] * terms
    return bool(good.sum() > len(good) // 2 and (np.abs(values) <= rounding).all())
