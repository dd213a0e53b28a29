"""Follows the equilibria of a family of systems on one leaf, by the length of their branch, through folds and splits.

An equilibrium is where the energy's derivative along the leaf vanishes; its second derivative there is a symmetric
matrix, which is singular exactly where a branch turns back or another meets it.
Source: Keller, in *Applications of Bifurcation Theory* (1977).
"""

from __future__ import annotations

import functools
import itertools
import math
import warnings
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import equinox as eqx
import jax
import numpy as np

from polhode.algebra._closures import Closure, take_apart
from polhode.analysis._conserved import Energy, Source
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Complex128, Double, Float64


class BranchLimits(NamedTuple):
    """Numbers that decide what an equilibrium on a branch is, and how far a branch is followed."""

    tensor_rank: float = 1e-9  # singular values of the Poisson tensor below it, relative to the largest, move nothing
    relative_zero: float = 1e-7  # singular values and eigenvalues below it, relative to the largest, vanish
    first_step: float = 0.01  # in units of the state's size and of the range
    longest_step: float = 0.04  # in the same units
    shortest_step: float = 1e-7  # in the same units: a branch that needs shorter ones is given up
    max_places: int = 3000  # on a branch
    max_newton_steps: int = 12  # of a method that converges quadratically from a step's guess
    settled_step: float = 1e-12  # in units of size and range: Newton's method is done after a shorter one
    min_cosine: float = 0.97  # of the angle between the directions at neighbouring places
    min_family_points: int = 6  # along equilibria at one value: a quarter of the state's size, no coincidence


LIMITS = BranchLimits()


class Place(NamedTuple):
    """One equilibrium.

    Attributes:
        vector: (n,) the point's coordinates.
        value: of the parameter.
        tangent: (n + 1,) unit direction of the branch, coordinates in units of the state's size, then the parameter in
            units of the range.
        negative: how many negative eigenvalues the energy's second derivative has on the leaf.
        flat: (n, k) directions in which it vanishes.
        weakest: (n,) the direction on the leaf in which it is smallest.
        least: the eigenvalue that goes with it.
        energy: of the point.
        exponents: (r,) of the linearised flow on the leaf [1/s].
        noise: of an exponent, that rounding may make [1/s].
    """

    vector: Float64[np.ndarray, "n"]
    value: float
    tangent: Float64[np.ndarray, "extended"]
    negative: int
    flat: Float64[np.ndarray, "n k"]
    weakest: Float64[np.ndarray, "n"]
    least: float
    energy: float
    exponents: Complex128[np.ndarray, "r"]
    noise: float

    @property
    def rate(self) -> float:
        """The largest real part of an exponent [1/s]; 0 where it may come from rounding."""
        largest = float(np.real(self.exponents).max(initial=0.0))
        return largest if largest > self.noise else 0.0

    @property
    def verdict(self) -> str:
        """``"stable"`` where the energy is definite on the leaf, ``"unstable"`` where a change grows exponentially."""
        definite = not self.flat.shape[1] and self.negative in (0, len(self.exponents))
        return "stable" if definite else "unstable" if self.rate > 0.0 else "undecided"


class _Local(NamedTuple):
    """Derivatives at a point: of the energy, and of the Casimirs."""

    energy: Array
    slope: Array
    curvature: Array
    levels: Array
    slopes: Array
    curvatures: Array


def _local(system: AbstractLiePoissonSystem, casimirs: Source, z: Array) -> _Local:
    energy = Energy(system)

    def height(x: Array) -> Array:
        return energy(x)[0]

    return _Local(height(z), jax.grad(height)(z), jax.hessian(height)(z), casimirs(z), jax.jacfwd(casimirs)(z),
                  jax.jacfwd(jax.jacrev(casimirs))(z))


_compute_local = eqx.filter_jit(_local)  # kept between families, as is what they call


@eqx.filter_jit
def _call(function: Closure, value: Array, z: Array) -> _Local:
    return function(value, z)


class Equations(NamedTuple):
    """The equations of an equilibrium, in units of their terms.

    Attributes:
        energy: there.
        leaf: (n, r) directions of the leaf.
        off: (r + k,) the energy's slope along them, and by how much the k Casimirs miss their levels.
        matrix: (r + k, n + 1) its derivative by the point and the parameter, in units of size and range.
        curvature: (r, r) the energy's second derivative on the leaf.
    """

    energy: float
    leaf: Float64[np.ndarray, "n r"]
    off: Float64[np.ndarray, "equations"]
    matrix: Float64[np.ndarray, "equations extended"]
    curvature: Float64[np.ndarray, "r r"]


class Family:
    """Systems along a parameter, and the leaf on which equilibria are sought."""

    def __init__(
        self, make: Callable[[float], AbstractLiePoissonSystem], casimirs: Source, state: Double[np.ndarray, "..."],
        low: float, high: float,
    ) -> None:
        self._make, self._casimirs, self.low, self.high = make, casimirs, low, high
        self.algebra = make(low).algebra
        level = self.vector(state)
        self.size, self.range = float(np.linalg.norm(level)), high - low
        self._wanted = np.asarray(casimirs(level))
        self._compiled = self._once_for_all(level)
        self._constants = make(low).sign * np.asarray(self.algebra.structure_constants())

    def vector(self, point: Double[np.ndarray, "..."]) -> Float64[np.ndarray, "n"]:
        """Return a point's coordinates."""
        return np.asarray(self.algebra.to_dual_vector(np.asarray(point, self.algebra.dtype)))

    def point(self, vector: Float64[np.ndarray, "n"]) -> Double[np.ndarray, "..."]:
        """Return the point with these coordinates."""
        return np.asarray(self.algebra.from_dual_vector(vector))

    def _once_for_all(self, z: Array) -> Callable[[Any, Any], _Local]:
        """Return the derivatives as a function of value and coordinates, traced once if ``make`` can be."""
        try:
            family = take_apart(lambda value, x: _local(self._make(value), self._casimirs, x), np.zeros(()), z)
        except Exception:  # `make` wants a number, as it may; its own errors come again from below
            return lambda value, x: _compute_local(self._make(float(value)), self._casimirs, x)
        # kept for all that do the same if it is data, and with this family alone if not: no other can use it
        call = functools.partial(_call, family) if isinstance(family, Closure) else jax.jit(family)
        return lambda value, x: call(np.asarray(value, float), x)

    def _at(self, z: Array, value: float) -> _Local:
        return _Local(*map(np.asarray, self._compiled(value, z)))

    def equations(self, z: Array, value: float) -> Equations:
        """Return the equations of an equilibrium at a point and a value."""
        difference = 1e-5  # of the range: the step of derivatives by the parameter
        derivatives = self._at(z, value)
        left, sizes, _ = np.linalg.svd(self._constants @ z)
        leaf = left[:, sizes > LIMITS.tensor_rank * max(sizes[0], 1e-300)]
        # on the leaf dH = Σ w dC, and its curvature is D²H − Σ w D²C
        weights = np.linalg.lstsq(derivatives.slopes.T, derivatives.slope, rcond=None)[0]
        curvature = derivatives.curvature - np.tensordot(weights, derivatives.curvatures, 1)
        step = difference * self.range
        # dH as a function of the parameter, by a central difference
        by_value = (self._at(z, value + step).slope - self._at(z, value - step).slope) / (2.0 * step)
        steepness = max(float(np.abs(derivatives.slope).max()), float(np.abs(curvature).max()) * self.size, 1e-300)
        levels = np.maximum(np.linalg.norm(derivatives.slopes, axis=1) * self.size, 1e-300)
        off = np.concatenate([leaf.T @ derivatives.slope / steepness, (derivatives.levels - self._wanted) / levels])
        matrix = np.block([
            [leaf.T @ curvature * (self.size / steepness), (leaf.T @ by_value)[:, None] * (self.range / steepness)],
            [derivatives.slopes * (self.size / levels[:, None]), np.zeros((len(levels), 1))],
        ])  # fmt: skip
        return Equations(float(derivatives.energy), leaf, off, matrix, leaf.T @ curvature @ leaf)

    def place(
        self, z: Float64[np.ndarray, "n"], value: float, along: Float64[np.ndarray, "extended"] | None = None
    ) -> Place:
        """Return a settled point as a place, its direction as near as can be to another, or towards higher values."""
        equations = self.equations(z, value)
        _, sizes, rows = np.linalg.svd(equations.matrix)
        sizes = np.concatenate([sizes, np.zeros(len(rows) - len(sizes))])
        flat = sizes <= LIMITS.relative_zero * sizes[0]
        kernel = rows[flat] if flat.any() else rows[-1:]
        along = np.eye(len(rows))[-1] if along is None else along
        tangent = kernel.T @ (kernel @ along)
        length = np.linalg.norm(tangent)
        tangent = tangent / length if length > 1e-6 else kernel[-1]
        curvature = 0.5 * (equations.curvature + equations.curvature.T)
        values, vectors = np.linalg.eigh(curvature)
        still = np.abs(values) <= LIMITS.relative_zero * np.abs(values).max(initial=0.0)
        tensor, vectors, least = self._constants @ z, equations.leaf @ vectors, int(np.argmin(np.abs(values)))
        # the linearised flow on the leaf is π times the curvature there
        exponents = np.linalg.eigvals(equations.leaf.T @ tensor @ equations.leaf @ curvature).astype(complex)
        # two that meet are off by the root of a rounding
        noise = LIMITS.relative_zero * float(np.linalg.norm(tensor, 2) * np.linalg.norm(curvature, 2))
        return Place(z, float(value), tangent, int(np.sum((values < 0.0) & ~still)), vectors[:, still],
                     vectors[:, least], float(values[least]), equations.energy, exponents, noise)

    def settle(
        self, z: Float64[np.ndarray, "n"], value: float, row: Float64[np.ndarray, "extended"]
    ) -> tuple[Float64[np.ndarray, "n"], float] | None:
        """Return the equilibrium next to a guess, with the step along a given direction held; None if there is none."""
        z, value, far, off = np.array(z), float(value), math.inf, np.zeros(1)
        for _ in range(LIMITS.max_newton_steps):
            off, matrix = self.equations(z, value)[2:4]
            if not (np.isfinite(off).all() and np.isfinite(matrix).all()):
                return None
            move = -np.linalg.lstsq(np.vstack([matrix, row]), np.append(off, 0.0), rcond=LIMITS.relative_zero * 1e-2)[0]
            far = float(np.abs(move).max())
            if far > 0.5:
                return None
            z, value = z + self.size * move[:-1], value + self.range * float(move[-1])
            if far < LIMITS.settled_step:
                return z, value
        return (z, value) if far < 1e3 * LIMITS.settled_step and np.abs(off).max() < 1e3 * LIMITS.settled_step else None

    def between(self, one: Place, other: Place, share: float) -> Place | None:
        """Return the place at a share of the way from one to another."""
        way = np.append((other.vector - one.vector) / self.size, (other.value - one.value) / self.range)
        length = float(np.linalg.norm(way))
        if length == 0.0:
            return one
        solution = self.settle(one.vector + share * self.size * way[:-1], one.value + share * self.range * way[-1],
                             way / length)
        return None if solution is None else self.place(*solution, one.tangent)

    def at_value(self, z: Float64[np.ndarray, "n"], value: float) -> Float64[np.ndarray, "n"] | None:
        """Return the equilibrium next to a guess at a value of the parameter."""
        solution = self.settle(z, value, np.eye(len(z) + 1)[-1])
        return None if solution is None else solution[0]

    def apart(self, one: Place, other: Place) -> float:
        """Return how far two places are from each other, in units of size and range."""
        gap = float(np.abs(one.vector - other.vector).max()) / self.size
        return max(gap, abs(one.value - other.value) / self.range)


def follow(family: Family, begin: Place) -> list[Place]:
    """Return the places of a branch from one on, in its direction, up to an end of the range.

    Warns where it cannot be followed that far.
    """
    tangent = begin.tangent
    if begin.value >= family.high and tangent[-1] > 0.0:
        tangent = -tangent
    places, step = [begin], LIMITS.first_step
    while len(places) < LIMITS.max_places and step > LIMITS.shortest_step:
        last = places[-1]
        guess = last.vector + step * family.size * tangent[:-1], last.value + step * family.range * tangent[-1]
        solution = family.settle(*guess, tangent)
        if solution is None:
            step *= 0.5
            continue
        place = family.place(*solution, tangent)
        if place.tangent @ tangent < LIMITS.min_cosine or family.apart(place, last) > 3.0 * step:
            step *= 0.5
            continue
        if not family.low <= place.value <= family.high:
            value = family.low if place.value < family.low else family.high
            end = family.at_value(place.vector, value)
            if end is not None and value != last.value:
                places.append(family.place(end, value, tangent))
            return places
        places.append(place)
        tangent, step = place.tangent, min(1.3 * step, LIMITS.longest_step)
        if len(places) > 10 and family.apart(place, begin) < step and place.tangent @ begin.tangent > LIMITS.min_cosine:
            return [*places, begin]  # it is closed
    warnings.warn(
        f"a branch of equilibria could not be followed beyond the value {places[-1].value:g}: what comes after is not "
        "known.",
        stacklevel=4,
    )
    return places


def crossings(family: Family, path: list[Place]) -> Iterator[tuple[Place, Place, Place]]:
    """Yield the places at which a direction of the energy changes its sign, each with those before and after."""
    max_halvings = 50
    for one, other in itertools.pairwise(path):
        if one.negative == other.negative or one.flat.shape[1] or other.flat.shape[1]:
            continue
        low, high, at, (a, b), ends = 0.0, 1.0, one, (one.least, other.least), [one, other]
        missed = False
        for k in range(max_halvings):
            # by the eigenvalue that vanishes, where it is the smallest already; halved now and then
            by_halves = k % 3 == 0 or a * b >= 0.0 or missed
            secant = 0.5 * (low + high) if by_halves else low + (high - low) * a / (a - b)
            place = family.between(one, other, secant)
            if place is None:  # a family of equilibria that crosses here leaves steps along it open
                at = _between_ends(family, ends, a / (a - b)) if a * b < 0.0 else at
                if missed:
                    break
                missed = True
                continue
            at, missed = place, False
            if place.flat.shape[1] and abs(place.least) < 1e-13 * abs(a - b):
                break
            before = place.negative == one.negative if not place.flat.shape[1] else place.least * a > 0.0
            if before:
                low, a, ends[0] = secant, place.least, place
            else:
                high, b, ends[1] = secant, place.least, place
            if high - low < 1e-15:
                break
        yield one, at, other


def _between_ends(family: Family, ends: list[Place], share: float) -> Place:
    """Return what is at a share of the straight way between two near places."""
    one, other = ends
    return family.place(one.vector + share * (other.vector - one.vector),
                        one.value + share * (other.value - one.value), one.tangent)


def trace_family(family: Family, place: Place) -> tuple[Float64[np.ndarray, "m n"], bool]:
    """Return points of a curve of equilibria through a place, all at its value, and whether the curve closes.

    No points where there is no such curve: next to a place where another branch begins the energy bends.
    """
    step, points, ahead = LIMITS.longest_step * family.size, [place.vector], place.weakest
    while len(points) < LIMITS.max_places:
        guess = points[-1] + step * ahead
        z = family.at_value(guess, place.value)
        if z is None or np.linalg.norm(z - guess) > 0.5 * step or not family.place(z, place.value).flat.shape[1]:
            break
        ahead = (z - points[-1]) / np.linalg.norm(z - points[-1])
        points.append(z)
        if len(points) > LIMITS.min_family_points and np.linalg.norm(z - place.vector) < step:
            return np.array(points), True
    return (np.array(points) if len(points) > LIMITS.min_family_points else np.zeros((0, place.vector.size))), False


def step_onto_branch(family: Family, place: Place) -> list[Place]:
    """Return places on another branch that meets this one at a place: one on either side."""
    aside = 1e-3  # of the state's size: how far from the place another branch is sought
    places = []
    for sign in (1.0, -1.0):
        way = sign * place.weakest
        row = np.append(way, 0.0)
        beside = family.settle(place.vector + aside * family.size * way, place.value, row)
        if beside is not None:
            places.append(family.place(*beside, row))
    return places


def is_on(family: Family, place: Place, path: list[Place], same: float) -> bool:
    """Return whether a place is on a branch, or one that a symmetry takes to it."""
    scale = np.append(np.full(len(place.vector), family.size), family.range)
    here = np.append(place.vector, place.value) / scale
    for one in path:
        node = np.append(one.vector, one.value) / scale
        ahead = float(one.tangent @ (here - node))
        if abs(ahead) > 2.0 * LIMITS.longest_step:
            continue
        solution = family.settle(*_parts((node + ahead * one.tangent) * scale), one.tangent)
        if solution is None:
            continue
        if family.apart(family.place(*solution, one.tangent), place) < same:
            return True
    return bool(place.flat.shape[1]) and any(_alike(family, place, *pair) for pair in itertools.pairwise(path))


def _alike(family: Family, place: Place, one: Place, other: Place) -> bool:
    """Return whether a place of a family of equilibria has the energy of one between two places at the same value."""
    if not min(one.value, other.value) <= place.value <= max(one.value, other.value):
        return False
    share = (place.value - one.value) / ((other.value - one.value) or 1.0)
    z = family.at_value(one.vector + share * (other.vector - one.vector), place.value)
    if z is None:
        return False
    there = family.place(z, place.value)
    height = max(abs(there.energy), abs(place.energy), 1e-300)
    alike = (there.negative, there.flat.shape) == (place.negative, place.flat.shape)
    return alike and math.isclose(there.energy, place.energy, abs_tol=1e-9 * height)


def _parts(both: Float64[np.ndarray, "extended"]) -> tuple[Float64[np.ndarray, "n"], float]:
    return both[:-1], float(both[-1])
