"""Conserved quantities of a Lie–Poisson system in coordinates ⟨μ, e_i⟩, with compiled derivatives and checks.

A certificate is worth as much as the conservation laws it is made of. Each function that takes part is therefore
checked at random points near the equilibrium, away from it and along its orbit, not only at the point itself.
"""

from __future__ import annotations

import abc
import itertools
import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import arrays_for_few_calls
from polhode.algebra._closures import take_apart
from polhode.algebra._functions import Function, check_functions
from polhode.algebra._joint_functions import evaluate_jointly
from polhode.algebra._polynomial import Polynomial
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.casimirs import polynomial_casimirs
from polhode.algebra.constants import ConstantsAlgebra
from polhode.algebra.properties import index
from polhode.analysis._reasons import MissingCasimirs
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Bool, Float64

TRACING = (jax.errors.ConcretizationTypeError, jax.errors.TracerArrayConversionError)


class ConservationLimits(NamedTuple):
    """Numbers that decide whether functions commute, depend on each other, and have derivatives."""

    # of the terms of {F, G}: what rounding of smooth derivatives and of parameters may leave
    relative_rounding: float = 4e-12
    # times the change of {F, G} over a rounding error of the point: functions may lose digits inside
    noise_factor: float = 20.0
    closure: float = 1e-9  # of the largest bracket: how far it may be from a combination of the momenta
    casimir_rank: float = 1e-9  # singular values of unit gradients below which given Casimirs depend on each other
    max_casimir_degree: int = 4  # of polynomials that are sought where the algebra does not name enough
    points_per_distance: int = 3  # random points at which conservation is checked
    # of difference quotients against second derivatives, relative: beyond it there are none
    max_roughness: float = 1e-3
    derivative_error: float = 1e-12  # relative, of second derivatives by AD of functions of order one


LIMITS = ConservationLimits()


class Source(eqx.Module):
    """Functions of coordinates."""

    @abc.abstractmethod
    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        """Return the values (k,) at a point (n,)."""


class Energy(Source):
    system: AbstractLiePoissonSystem

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        return self.system.energy(self.system.algebra.from_dual_vector(x))[None]


class Known(Source):
    """The conserved quantities that the system names."""

    system: AbstractLiePoissonSystem

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        point = self.system.algebra.from_dual_vector(x)
        values = evaluate_jointly(self.system.extra_invariants, point).values()
        return _stack([x for value in values for x in jnp.ravel(value)])

    @property
    def names(self) -> list[str]:
        """Of each value; components of vectors and arrays are counted from 1."""
        algebra, names = self.system.algebra, []
        point = jax.ShapeDtypeStruct(algebra.element_shape, algebra.dtype)
        values = jax.eval_shape(lambda x: evaluate_jointly(self.system.extra_invariants, x), point)
        for name in self.system.extra_invariants:
            shape = values[name].shape
            places = [", ".join(str(i + 1) for i in k) for k in np.ndindex(*shape)]
            names += [f"{name}, {place}" for place in places] if shape else [name]
        return names


class Own(Source):
    """The Casimirs that the algebra names."""

    algebra: AbstractLieAlgebra

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        return self.algebra.casimirs(self.algebra.from_dual_vector(x))


class Given(Source):
    """Functions of one point of the dual, from the user."""

    algebra: AbstractLieAlgebra
    functions: tuple[Function, ...]

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        point = self.algebra.from_dual_vector(x)
        return _stack([function(point) for function in self.functions])


class Polynomials(Source):
    polynomials: tuple[Polynomial, ...]

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        return _stack([polynomial(x) for polynomial in self.polynomials])


class Casimirs(NamedTuple):
    """Casimirs as one source, their names, and which are missing, None if none."""

    source: Source
    names: list[str]
    missing: MissingCasimirs | None


def choose_casimirs(algebra: AbstractLieAlgebra, casimirs: Sequence[Function] | None) -> Casimirs:
    """Return the user's Casimirs, or those that the algebra names, or polynomials from exact algebra."""
    if casimirs is not None:
        functions = read_functions("casimirs", casimirs, algebra)
        names = [f"C{k + 1}" for k in range(len(functions))]
        return Casimirs(Given(algebra, functions), names, _lack(len(functions), index(algebra), "were given"))
    wanted = index(algebra)
    names = list(algebra.casimir_names)
    if len(names) >= wanted:
        return Casimirs(Own(algebra), names, None)
    constants = np.ascontiguousarray(algebra.structure_constants())
    try:
        polynomials = _polynomials(constants.tobytes(), len(constants), algebra.fractions)
    except InvalidInput as error:
        return Casimirs(Own(algebra), names, _lack(len(names), wanted, f"are known ({error})"))
    texts = [str(p) for p in polynomials]
    return Casimirs(Polynomials(polynomials), texts,
                    _lack(len(polynomials), wanted, f"of degree ≤ {LIMITS.max_casimir_degree} exist"))


def read_functions(name: str, value: Any, algebra: AbstractLieAlgebra) -> tuple[Function, ...]:
    """Return a user's functions of one point as data, where they can be.

    Raises:
        InvalidInput: for what is not a list of such functions.
    """
    functions = check_functions(name, value, algebra.element_shape, algebra.dtype)
    point = jax.ShapeDtypeStruct(algebra.element_shape, algebra.dtype)
    return tuple(take_apart(function, point) for function in functions)


def _lack(count: int, wanted: int, how: str) -> MissingCasimirs | None:
    return None if count >= wanted else MissingCasimirs(count, wanted, how)


@lru_cache(maxsize=16)
def _polynomials(constants: bytes, dim: int, fractions: Any) -> tuple[Polynomial, ...]:
    table = np.frombuffer(constants).reshape(dim, dim, dim)
    return tuple(polynomial_casimirs(ConstantsAlgebra(table, None, fractions), LIMITS.max_casimir_degree))


def choose_unit(z: Float64[Array, "n"]) -> float:
    """Return a power of two near the size of z where its squares might overflow, else one."""
    usual = 2.0**200  # sizes up to it have squares that are far from overflow
    largest = float(np.abs(z).max(initial=0.0))
    return 1.0 if largest == 0.0 or 1.0 / usual < largest < usual else 2.0 ** round(math.log2(largest))


# ---------------------------------------------------------------------- derivatives


class Derivatives(NamedTuple):
    """Gradients (k, n) and Hessians (k, n, n) at the point, gradients (m, k, n) at samples, and their errors.

    ``errors`` (k,) are relative to the largest entry of each Hessian, measured as its change over a few rounding errors
    of the point. ``rough`` (k,) is by how much difference quotients of the gradient miss the Hessian, relative to both;
    infinite where a derivative is.
    """

    gradients: Float64[np.ndarray, "k n"]
    hessians: Float64[np.ndarray, "k n n"]
    around: Float64[np.ndarray, "m k n"]
    errors: Float64[np.ndarray, "k"]
    rough: Float64[np.ndarray, "k"]

    @property
    def smooth(self) -> Bool[Array, "k"]:
        """Whether each function is twice differentiable, (k,)."""
        return self.rough <= LIMITS.max_roughness

    def choose(self, rows: list[int]) -> Derivatives:
        """Return the derivatives of some of the functions."""
        return Derivatives(self.gradients[rows], self.hessians[rows], self.around[:, rows], self.errors[rows],
                           self.rough[rows])


def derivatives(source: Source, z: Float64[Array, "n"], samples: Float64[Array, "m n"]) -> Derivatives:
    """Differentiate at z (n,), and once at each sample (m, n); what is not finite there is left so."""
    neighbourhood = 0.5  # of |μ|, per root of the dimension: samples there give a function's size
    step = 1e-6  # of the difference quotients, in units of |μ|
    rng = np.random.default_rng(1)
    size = float(np.abs(z).max(initial=0.0)) or 1.0
    signs = rng.choice([-1.0, 1.0], size=(2, z.size))
    signs = np.vstack([signs, -signs])
    rounded = z * (1.0 + 2.0**-51 * rng.choice([-1.0, 1.0], size=(2, z.size)))
    points, centres = np.vstack([z, z + step * size * signs, samples]), np.vstack([z, rounded])
    gradients, hessians = (np.asarray(x) for x in differentiate(source, points, centres))
    slopes, curvatures = gradients[0], hessians[0]
    with np.errstate(invalid="ignore"):
        quotients = (gradients[1:5] - slopes) / step
        expected = size * np.einsum("kij,mj->mki", curvatures, signs)
        # a cubic term has neither slope nor curvature at its zero: nearby it has, and its size is theirs
        nearby = np.linalg.norm(samples - z, axis=1) <= neighbourhood * size * np.sqrt(z.size)
        around = np.abs(np.nan_to_num(np.vstack([slopes[None], gradients[5:][nearby]]), posinf=0.0, neginf=0.0))
        scale = size * np.abs(curvatures).max(axis=(1, 2), initial=0.0) + around.max(axis=(0, 2), initial=0.0)
        off = np.abs(quotients - expected).max(axis=(0, 2), initial=0.0) / np.where(scale > 0, scale, 1.0)
        largest = np.abs(curvatures).max(axis=(1, 2), initial=0.0)
        change = np.abs(hessians[1:] - curvatures).max(axis=(0, 2, 3), initial=0.0)
    errors = np.maximum(LIMITS.derivative_error, change / np.where(largest > 0, largest, 1.0))
    finite = np.isfinite(slopes).all(axis=1) & np.isfinite(curvatures).all(axis=(1, 2))
    rough = np.where(finite & ~np.isnan(off), off, np.inf)
    return Derivatives(slopes, curvatures, gradients[5:], errors, rough)


def refuse_rough(derived: Derivatives, name: str) -> None:
    """Refuse functions without second derivatives at the point.

    Raises:
        InvalidInput: naming them.
    """
    if not (np.isfinite(derived.gradients).all() and np.isfinite(derived.hessians).all()):
        raise InvalidInput(
            f"{name} must have finite first and second derivatives at the equilibrium; got NaN or an infinity. "
            "Check that the function is smooth there, or choose units in which |μ| is nearer to one."
        )
    if not derived.smooth.all():
        raise InvalidInput(
            f"{name} must be twice differentiable at the equilibrium; difference quotients of its gradient differ "
            f"from the second derivative by {derived.rough.max():.3g} of it. Replace kinks and jumps by smooth "
            "functions."
        )


def differentiate(
    source: Source, points: Float64[Array, "m n"], centres: Float64[Array, "c n"]
) -> tuple[Float64[Array, "m k n"], Float64[Array, "c k n n"]]:
    """Return gradients (m, k, n) at points and Hessians (…, k, n, n) at centres."""
    points, centres = jnp.asarray(points), jnp.asarray(centres)
    try:
        return _differentiate(source, points, centres)
    except TRACING:  # functions that branch on their own parameters: these are constants then
        return jax.jit(lambda p, c: _differentiate(source, p, c))(points, centres)


@arrays_for_few_calls
def _differentiate(source: Source, points: Array, centres: Array) -> tuple[Array, Array]:
    return jax.vmap(jax.jacrev(source))(points), jax.vmap(jax.hessian(source))(centres)


def samples_around(constants: Float64[Array, "n n n"], z: Float64[Array, "n"]) -> Float64[Array, "m n"]:
    """Return random points near z, away from it, and on its orbit, where most functions are still defined.

    (2m, n): behind the m points their neighbours at a rounding error's distance, which show how exact derivatives are.
    """
    distances = (0.01, 0.1, 0.5, 1.0)  # in units of |μ|
    from scipy.linalg import expm

    rng = np.random.default_rng(2)
    size = float(np.abs(z).max(initial=0.0)) or 1.0
    draws = range(LIMITS.points_per_distance)
    near = [z + r * size * rng.normal(size=z.size) for r in distances for _ in draws]
    scale = float(np.abs(constants).max(initial=0.0)) or 1.0
    turns = [expm(np.einsum("i,ijk->jk", rng.normal(size=z.size) / scale, constants)) for _ in draws]
    points = np.array([*near, *(turn @ z for turn in turns)])
    return np.vstack([points, points * (1.0 + 2.0**-51 * rng.choice([-1.0, 1.0], size=points.shape))])


# ---------------------------------------------------------------------- checks


def check_commute(
    tensors: Float64[Array, "m n n"],
    first: Float64[Array, "m n"],
    second: Float64[Array, "m n"],
    names: tuple[str, str],
    remedy: str,
) -> None:
    """Refuse two functions whose bracket does not vanish at all samples.

    Args:
        tensors: (2m, n, n) π at the samples.
        first: (2m, n) gradient of one.
        second: (2m, n) gradient of the other.
        names: of both.
        remedy: the message's last sentence.

    Raises:
        InvalidInput: with the size of the bracket.
    """
    good = _find_defined(tensors, first, second)
    if good.sum() < 2 * LIMITS.points_per_distance:
        raise InvalidInput(
            f"{names[0]} and {names[1]} must be defined around the equilibrium; their derivatives are finite at "
            f"{good.sum() // 2} of {len(good) // 2} points there. Check their domain."
        )
    worst, rounding = _bracket(tensors[good], first[good], second[good])
    if worst > rounding:
        raise InvalidInput(
            f"{{{names[0]}, {names[1]}}} must vanish around the equilibrium; at points nearby it is up to {worst:.3g} "
            f"of its terms. {remedy}"
        )


def commute(tensors: Float64[Array, "m n n"], first: Float64[Array, "m n"], second: Float64[Array, "m n"]) -> bool:
    """Whether the bracket of two functions vanishes at all samples where they are defined; see ``check_commute``."""
    good = _find_defined(tensors, first, second)
    worst, rounding = _bracket(tensors[good], first[good], second[good])
    return bool(good.any()) and worst <= rounding


def _find_defined(tensors: Array, first: Array, second: Array) -> Array:
    """Return the samples (2m,) at which both gradients are finite, and their neighbours' too."""
    smooth = np.all(np.isfinite(first), axis=1) & np.all(np.isfinite(second), axis=1)
    good = smooth & np.all(np.isfinite(tensors), axis=(1, 2))
    return np.tile(good[: len(good) // 2] & good[len(good) // 2 :], 2)


def _bracket(tensors: Array, first: Array, second: Array) -> tuple[float, float]:
    """Return the largest bracket relative to its terms, and the bound of its rounding error."""
    first, second = _normalise(first), _normalise(second)
    values = np.einsum("mi,mi->m", first, np.einsum("mij,mj->mi", tensors, second))
    terms = np.einsum("mi,mi->m", np.abs(first), np.einsum("mij,mj->mi", np.abs(tensors), np.abs(second)))
    values, rounded = np.split(values / (terms.max(initial=0.0) or 1.0), 2)
    off = float(np.abs(values - rounded).max(initial=0.0))
    return float(np.abs(values).max(initial=0.0)), max(LIMITS.relative_rounding, LIMITS.noise_factor * off)


def check_closed(
    tensors: Float64[Array, "m n n"],
    gradients: Float64[Array, "m j n"],
    values: Float64[Array, "m j"],
    names: list[str],
) -> bool:
    """Return whether functions J_a commute; refuse those that are not the momentum map of a group either.

    Of a group {J_a, J_b} = Σ c_ab^k J_k.

    Args:
        tensors: (m, n, n) π at the samples.
        gradients: (m, j, n) of the functions.
        values: (m, j) theirs.
        names: of the functions.

    Raises:
        InvalidInput: naming two of them whose bracket is not a combination of them.
    """
    good = np.isfinite(gradients).all(axis=(1, 2)) & np.isfinite(values).all(axis=1)
    gradients, tensors, values = gradients[good], tensors[good], values[good]
    brackets = np.einsum("mai,mij,mbj->mab", gradients, tensors, gradients)
    terms = np.einsum("mai,mij,mbj->mab", np.abs(gradients), np.abs(tensors), np.abs(gradients))
    if not np.abs(brackets).max(initial=0.0) > LIMITS.closure * terms.max(initial=0.0):
        return True
    for a, b in itertools.combinations(range(len(names)), 2):
        wanted = brackets[:, a, b]
        size = np.abs(brackets).max()
        left = wanted - values @ np.linalg.lstsq(values, wanted, rcond=None)[0]
        if np.abs(left).max() > LIMITS.closure * size:
            raise InvalidInput(
                f"{{{names[a]}, {names[b]}}} must vanish or be a sum of multiples of the `integrals`, as symmetries "
                "that are divided out make up a group; at points nearby it misses every such sum by "
                f"{np.abs(left).max():.3g}. Give one of the two alone, or the others of their group too."
            )
    return False


def check_casimirs(tensors: Float64[Array, "m n n"], gradients: Float64[Array, "m k n"]) -> None:
    """Refuse functions that are not Casimirs, {C, x_i} = 0, or that depend on each other.

    Args:
        tensors: (m, n, n) π at the samples.
        gradients: (m, k, n) of the functions.

    Raises:
        InvalidInput: with the one at fault.
    """
    n = tensors.shape[-1]
    for k in range(gradients.shape[1]):
        for i in range(n):
            unit = np.broadcast_to(np.eye(n)[i], gradients[:, k].shape)
            check_commute(tensors, gradients[:, k], unit, (f"casimirs[{k}]", f"x{i + 1}"),
                          "A Casimir commutes with every coordinate; check the function.")
    fine = gradients[np.isfinite(gradients).all(axis=(1, 2))]
    count = gradients.shape[1]
    lengths = np.linalg.norm(fine, axis=2, keepdims=True)
    sizes = np.linalg.svd(fine / np.where(lengths > 0, lengths, 1.0), compute_uv=False)
    rank = int((sizes > LIMITS.casimir_rank).sum(axis=1).max(initial=0))
    if rank < count:
        raise InvalidInput(
            f"`casimirs` must be independent: the gradients of these {count} span {rank} dimensions everywhere. "
            "Leave out those that are functions of others."
        )


def _normalise(vectors: Array) -> Array:
    sizes = np.abs(vectors).max(axis=1, keepdims=True)
    return vectors / np.where(sizes > 0, sizes, 1.0)


def _stack(values: list[Array]) -> Array:
    return jnp.stack(values) if values else jnp.zeros(0)
