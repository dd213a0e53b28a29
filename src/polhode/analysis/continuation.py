"""Equilibria along a parameter: branches, their stability, and where they fold, split or lose stability."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode._base.long_work import long_work
from polhode.algebra._functions import Function
from polhode.analysis._branches import LIMITS as BRANCH_LIMITS
from polhode.analysis._branches import Family, Place, crossings, follow, is_on, step_onto_branch, trace_family
from polhode.analysis._conserved import choose_casimirs
from polhode.analysis._printing import count_things, print_answer, write_numbers, write_span
from polhode.analysis.equilibria import LIMITS as SEARCH
from polhode.analysis.equilibria import find_equilibria
from polhode.errors import InvalidInput, shown
from polhode.poisson.brackets import as_points
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import ArrayLike, Double, Float64, Real


class ContinuationLimits(NamedTuple):
    """Numbers that decide which places, meetings and directions are one."""

    # of the state's size and of the range: nearer bifurcations of branches that cross are one
    meeting_distance: float = 1e-2
    place_distance: float = 1e-5  # in the same units: nearer places are one
    relative_imaginary_part: float = 1e-6  # of the largest exponent: one with a smaller imaginary part is real
    max_branches: int = 64
    min_parameter_share: float = 1e-3  # of a direction: with less the parameter stays
    min_departure: float = 1e-8  # of the range, by which another branch leaves the place where it begins


LIMITS = ContinuationLimits()


class Branch(NamedTuple):
    """Equilibria that follow one another as a parameter changes.

    Attributes:
        values: (m,) of the parameter, which may turn back.
        points: (m, …) the equilibria.
        energies: (m,).
        verdicts: m of them: ``"stable"`` where the energy is definite on the leaf, which proves it, ``"unstable"``
            where a small change grows exponentially, else ``"undecided"``, which ``stability`` may decide by more.
        rates: (m,) largest real part of an exponent [1/s].
        negative: (m,) how many negative directions the energy has on the leaf.
    """

    values: Float64[np.ndarray, "m"]
    points: Double[np.ndarray, "m ..."]
    energies: Float64[np.ndarray, "m"]
    verdicts: tuple[str, ...]
    rates: Float64[np.ndarray, "m"]
    negative: Float64[np.ndarray, "m"]

    def __str__(self) -> str:
        verdicts = [f"{self.verdicts.count(one)} {one}" for one in dict.fromkeys(self.verdicts)]
        ends = [self.values.min(), self.values.max()] if len(self.values) else None
        return print_answer(
            f"{count_things(len(self.values), 'equilibrium', 'equilibria')}: {', '.join(verdicts) or 'none'}",
            parameter=write_span(ends) if ends else None,
        )


class Bifurcation(NamedTuple):
    """A bifurcation: branches turn back or meet, or lose their stability.

    Attributes:
        kind: ``"fold"``: a branch turns back; ``"pitchfork"``: another branch touches it, both arms on one side;
            ``"transcritical"``: another crosses it; ``"branch point"``: another begins that could not be followed;
            ``"circle"``: a closed curve of equilibria at this value alone; ``"family"``: one whose end was not reached;
            ``"Hamiltonian Hopf"``: exponents meet on the imaginary axis and leave it; ``"exchange"``: the verdict
            changes in another way.
        value: of the parameter.
        point: (…) the equilibrium.
        branches: numbers of those that take part.
    """

    kind: str
    value: float
    point: Double[np.ndarray, "..."]
    branches: tuple[int, ...]

    def __str__(self) -> str:
        return print_answer(
            f"a {self.kind} at {write_numbers(self.value)}", point=write_numbers(self.point),
            branches=write_numbers(self.branches),
        )


class Continuation(NamedTuple):
    """The equilibria of a search over a range of a parameter.

    Attributes:
        branches: in the order of the search.
        bifurcations: by the parameter.
    """

    branches: tuple[Branch, ...]
    bifurcations: tuple[Bifurcation, ...]

    def __str__(self) -> str:
        bifurcations = [f"{one.kind} at {write_numbers(one.value)}" for one in self.bifurcations]
        return print_answer(
            f"{count_things(len(self.branches), 'branch', 'branches')} of equilibria and "
            f"{count_things(len(bifurcations), 'bifurcation')}", bifurcations=", ".join(bifurcations) or None,
        )


@known_numbers_only
@long_work("following equilibria")
def continue_equilibria(
    make: Callable[[float], AbstractLiePoissonSystem],
    limits: Real[ArrayLike, "2"],
    state: Real[ArrayLike, "..."],
    starts: int = SEARCH.starts,
    seed: int = 0,
    casimirs: Sequence[Function] | None = None,
) -> Continuation:
    """Return the equilibria on one leaf of a family of systems, followed along its parameter.

    Those at both ends of the range come from ``find_equilibria`` and are followed along their branch, around folds too.
    Another branch starts where the energy's curvature in a direction of the leaf changes its sign. A branch that
    reaches neither an end of the range nor another branch is missed.

    Args:
        make: the parameter's value → a system; all on one algebra.
        limits: lowest and highest value.
        state: a point of the dual, whose Casimirs' levels all equilibria are on.
        starts, seed: of ``find_equilibria``.
        casimirs: as real functions of one point, instead of those that the algebra names or exact algebra gives.

    Raises:
        InvalidInput: for invalid limits, systems that are not of one kind or lose energy, or what
            ``find_equilibria`` refuses.

    >>> import polhode as ph, jax.numpy as jnp
    >>> def spin(field):  # with an easy axis z, in a field along x
    ...     return ph.systems.LiePoisson(ph.algebra.SO3(), lambda m: -0.5 * m[2] ** 2 - field * m[0])
    >>> continuation = ph.analysis.continue_equilibria(spin, (0.0, 2.0), [0.0, 0.0, 1.0])
    >>> [(b.kind, round(b.value, 9)) for b in continuation.bifurcations]
    [('pitchfork', 1.0)]

    Source: Keller, in *Applications of Bifurcation Theory* (1977); Seydel, *Practical Bifurcation and Stability
    Analysis*, ch. 4 and 5; the energy's signs on the leaf, Marsden & Ratiu, *Introduction to Mechanics and Symmetry*,
    §1.7.
    """
    low, high = _limits(limits)
    systems = [make(low), make(high)]
    for system in systems:
        if not isinstance(system, AbstractLiePoissonSystem) or not system.conserves_energy:
            raise InvalidInput(f"`make` must give Lie–Poisson systems that conserve energy; got {shown(system)}.")
    start = np.asarray(as_points(systems[0].algebra, state))
    family = Family(make, choose_casimirs(systems[0].algebra, casimirs).source, start, low, high)
    begins = [
        family.place(family.vector(point), value)
        for value, system in zip((low, high), systems, strict=True)
        for point in find_equilibria(system, state, starts, seed, casimirs)
    ]
    atlas = _Atlas(family, [], [], [])
    for begin in begins:
        # one of a family that does not move with the parameter belongs to this value alone
        stays = begin.flat.shape[1] and abs(begin.tangent[-1]) < LIMITS.min_parameter_share
        if not stays and atlas.find_branch(begin) is None:
            atlas.add(follow(family, begin))
    for number, path in enumerate(atlas.paths):
        atlas.meetings.extend((kind, place, [number]) for kind, place in _exchanges(family, path)
                              if not any(number in m[2] and family.apart(m[1], place) < LIMITS.meeting_distance
                                         for m in atlas.meetings))
    bifurcations = [Bifurcation(kind, place.value, family.point(place.vector), tuple(sorted(set(numbers))))
             for kind, place, numbers in atlas.meetings]
    branches = tuple(_branch(family, path) for path in atlas.paths)
    return Continuation(branches, tuple(sorted(bifurcations, key=lambda one: one.value)))


class _Atlas(NamedTuple):
    """The branches so far, their bifurcations: kind, place, numbers of branches; and points of families."""

    family: Family
    paths: list[list[Place]]
    meetings: list[tuple[str, Place, list[int]]]
    families: list[tuple[int, Float64[np.ndarray, "m n"]]]

    def find_branch(self, place: Place) -> int | None:
        """Return the index of the known branch through a place, or None."""
        near = LIMITS.place_distance
        return next((k for k, path in enumerate(self.paths) if is_on(self.family, place, path, near)), None)

    def add(self, path: list[Place]) -> None:
        """Add a branch, and those that leave it."""
        if len(self.paths) >= LIMITS.max_branches:
            warnings.warn(f"there are more than {LIMITS.max_branches} branches; the others are left out.", stacklevel=4)
            return
        number = len(self.paths)
        self.paths.append(path)
        for before, place, after in crossings(self.family, path):
            near = LIMITS.meeting_distance
            known = [k for k, m in enumerate(self.meetings) if m[0] != "fold" and self.family.apart(m[1], place) < near]
            known += [k for k, points in self.families if self._is_in_family(place, self.meetings[k][1], points)]
            if known:
                kind, other, numbers = self.meetings[known[0]]
                # where branches cross, the straighter one tells the better where
                best = min(other, place, key=lambda one: abs(one.least))
                self.meetings[known[0]] = kind, best, [*numbers, number]
                continue
            if before.tangent[-1] * after.tangent[-1] < 0.0 and self._turns(before, place, after):
                self.meetings.append(("fold", place, [number]))
                continue
            self._split(place, number)

    def _turns(self, before: Place, place: Place, after: Place) -> bool:
        """Return whether the parameter has its extreme at a place between two."""
        turns_back = (place.value - before.value) * (after.value - place.value) < 0.0
        return bool(turns_back or abs(place.tangent[-1]) < LIMITS.min_parameter_share)

    def _is_in_family(self, place: Place, member: Place, points: Float64[np.ndarray, "m n"]) -> bool:
        """Return whether a place is one of a family of equilibria at one value."""
        off = float(np.linalg.norm(points - place.vector, axis=1).min())
        at_value = abs(place.value - member.value) < LIMITS.meeting_distance * self.family.range
        return at_value and off < BRANCH_LIMITS.longest_step * self.family.size

    def _split(self, place: Place, number: int) -> None:
        points, closes = trace_family(self.family, place)
        if len(points):
            self.families.append((len(self.meetings), points))
            self.meetings.append(("circle" if closes else "family", place, [number]))
            return
        beside = step_onto_branch(self.family, place)
        flat = LIMITS.min_departure * self.family.range
        sides = [np.sign(one.value - place.value) * (abs(one.value - place.value) > flat) for one in beside]
        kind = "branch point"
        if len(beside) == 2 and sides[0] * sides[1]:
            kind = "pitchfork" if sides[0] == sides[1] else "transcritical"
        numbers = [number]
        self.meetings.append((kind, place, numbers))
        owners = [self.find_branch(one) for one in beside]
        numbers.extend(k for k in owners if k is not None)
        arms = [follow(self.family, one) for one, owner in zip(beside, owners, strict=True) if owner is None]
        if not arms:
            return
        numbers.append(len(self.paths))
        self.add([*reversed(arms[1]), place, *arms[0]] if len(arms) == 2 else [place, *arms[0]])


def _branch(family: Family, path: list[Place]) -> Branch:
    points = np.stack([family.point(one.vector) for one in path])
    values, energies, rates, negative = (
        np.array([getattr(one, name) for one in path]) for name in ("value", "energy", "rate", "negative")
    )
    return Branch(values, points, energies, tuple(one.verdict for one in path), rates, negative)


def _exchanges(family: Family, path: list[Place]) -> Iterator[tuple[str, Place]]:
    """Yield where a change begins to grow though no direction of the energy changes its sign."""
    halvings = 40
    for one, other in itertools.pairwise(path):
        same_signs = (one.negative, one.flat.shape) == (other.negative, other.flat.shape)
        if (one.rate > 0.0) == (other.rate > 0.0) or not same_signs:
            continue
        low, high, last, grows = 0.0, 1.0, one, one if one.rate > 0.0 else other
        for _ in range(halvings):
            middle = family.between(one, other, 0.5 * (low + high))
            if middle is None:
                break
            grows = middle if middle.rate > 0.0 else grows
            same = (middle.rate > 0.0) == (one.rate > 0.0)
            low, high = (0.5 * (low + high), high) if same else (low, 0.5 * (low + high))
            last = middle
        fastest = complex(grows.exponents[np.argmax(np.real(grows.exponents))])
        oscillates = abs(fastest.imag) > LIMITS.relative_imaginary_part * abs(fastest)
        yield ("Hamiltonian Hopf" if oscillates else "exchange"), last


def _limits(limits: ArrayLike) -> tuple[float, float]:
    low, high = check.array("limits", limits, (2,)).tolist()
    if not low < high:
        check.refuse("limits", "a lowest and a higher value", limits)
    return low, high
