"""Casimirs of a user's own algebra: given ones, after a check, or polynomials by exact algebra."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import lru_cache
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.algebra._functions import Function, check_functions
from polhode.algebra._polynomial import Polynomial
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.casimirs import polynomial_casimirs
from polhode.algebra.properties import index
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Float64


class OwnCasimirLimits(NamedTuple):
    """Numbers that decide which functions are Casimirs, and which are sought."""

    max_degree: int = 4  # of polynomials that are sought
    max_monomials: int = 1000  # of one degree: a fifth of a second of exact elimination
    max_name_length: int = 40  # characters of a polynomial that is its own name
    bracket_rounding: float = 1e-10  # of the terms of {C, x_i}: what rounding of values near a pole leaves
    # singular values of unit gradients below it are those of Casimirs that depend on each other
    independence: float = 1e-9
    points: int = 12  # random ones, at which a function is checked


LIMITS = OwnCasimirLimits()


class PolynomialCasimirs(NamedTuple):
    """Polynomial Casimirs, and what a run says where there are more that it cannot watch; "" where there are not."""

    casimirs: tuple[Polynomial, ...]
    unwatched: str


@lru_cache(maxsize=64)
def find_casimirs(algebra: AbstractLieAlgebra) -> PolynomialCasimirs:
    """Return polynomial Casimirs up to degree 4, lowest first, until there are as many as there can be.

    The search goes as far as it is quick, up to 1,000 monomials of a degree. It has no result where python-flint, the
    extra `jax`, is missing, or constants are rounded and no simple fractions.
    """
    wanted = index(algebra)
    casimirs: list[Polynomial] = []
    why = f"no polynomial of degree ≤ {LIMITS.max_degree} is another"
    for degree in range(1, LIMITS.max_degree + 1):
        if len(casimirs) >= wanted:
            break
        if math.comb(algebra.dim + degree - 1, degree) > LIMITS.max_monomials:
            why = f"polynomials of degree ≥ {degree} were not looked for"
            break
        try:
            casimirs = polynomial_casimirs(algebra, degree)
        except InvalidInput as error:
            why = str(error).rstrip(".")
            break
    missing = len(casimirs) < wanted
    note = f"{len(casimirs)} of {wanted} Casimirs are watched: {why}; give others by `casimirs=`" if missing else ""
    return PolynomialCasimirs(tuple(casimirs), note)


def check_casimirs(algebra: AbstractLieAlgebra, value: Any) -> tuple[Function, ...]:
    """Return functions of one point (dim,), after checking that they are independent Casimirs.

    Raises:
        InvalidInput: for one that is not a real scalar of one point, that does not commute with every coordinate at
            random points or is defined at few of them, and for functions that depend on each other.
    """
    functions = check_functions("casimirs", value, algebra.element_shape, algebra.dtype)
    if not functions:
        return ()
    points = np.random.default_rng(0).normal(size=(LIMITS.points, algebra.dim))
    gradients = np.asarray(jax.vmap(jax.jacrev(lambda x: evaluate_functions(functions, x)))(jnp.asarray(points)))
    tensors = np.einsum("ijk,mk->mij", algebra.structure_constants(), points)
    for k in range(len(functions)):
        _check_commutes(f"casimirs[{k}]", tensors, gradients[:, k])
    fine = gradients[np.isfinite(gradients).all(axis=(1, 2))]
    lengths = np.linalg.norm(fine, axis=2, keepdims=True)
    sizes = np.linalg.svd(fine / np.where(lengths > 0, lengths, 1.0), compute_uv=False)
    rank = int((sizes > LIMITS.independence).sum(axis=1).max(initial=0))
    if rank < len(functions):
        raise InvalidInput(
            f"`casimirs` must be independent; the gradients of these {len(functions)} span {rank} dimensions at random "
            "points. Leave out constants and those that are functions of others."
        )
    return functions


def _check_commutes(name: str, tensors: Array, gradients: Array) -> None:
    good = np.isfinite(gradients).all(axis=1)
    if good.sum() < 2:
        raise InvalidInput(
            f"`{name}` must be differentiable at most points; its gradient is finite at {good.sum()} of "
            f"{LIMITS.points} random ones. Check its domain."
        )
    # {C, x_i} up to sign: π_ij ∂C/∂x_j, next to the sizes of its terms
    brackets = np.einsum("mij,mj->mi", tensors[good], gradients[good])
    terms = np.einsum("mij,mj->mi", np.abs(tensors[good]), np.abs(gradients[good])).max(axis=1, keepdims=True)
    off = np.abs(brackets) / np.where(terms > 0.0, terms, 1.0)
    if off.max() > LIMITS.bracket_rounding:
        worst = int(np.argmax(off.max(axis=0)))
        raise InvalidInput(
            f"`{name}` must be a Casimir, which commutes with every coordinate; {{{name}, x{worst + 1}}} is "
            f"{off.max():.3g} of its terms at a random point. Check the function and the order of its coordinates."
        )


def evaluate_functions(functions: tuple[Function, ...], point: Float64[Array, "dim"]) -> Float64[Array, "k"]:
    """Return the values (k,) at one point."""
    return jnp.stack([function(point) for function in functions]) if functions else jnp.zeros(0)


def name_functions(functions: tuple[Function, ...]) -> tuple[str, ...]:
    """Return a name for each function: a short polynomial itself, else its number, counted from 1."""
    texts = [str(f) if isinstance(f, Polynomial) else "" for f in functions]
    return tuple(text if 0 < len(text) <= LIMITS.max_name_length else f"C{k + 1}" for k, text in enumerate(texts))


def check_names(names: Iterable[str], functions: tuple[Function, ...] | None) -> tuple[str, ...]:
    """Return names of given Casimirs, one for each.

    Raises:
        InvalidInput: for names without Casimirs, of another number, empty or repeated ones, and that of the energy,
            beside which they are listed.
    """
    if functions is None:
        raise InvalidInput("`names` are of `casimirs`, which are not given. Give both, or neither.")
    chosen = tuple(names) if isinstance(names, Iterable) else (names,)
    if isinstance(names, str) or not all(isinstance(name, str) and name.strip() for name in chosen):
        raise InvalidInput(f"`names` must be a list of texts that are not empty; got {shown(names)}.")
    if len(chosen) != len(functions):
        raise InvalidInput(f"`names` must be as many as `casimirs`, {len(functions)}; got {len(chosen)}.")
    if len({*chosen, "energy"}) <= len(chosen):
        raise InvalidInput(f"`names` must differ from each other and from \"energy\"; got {shown(chosen)}.")
    return chosen
