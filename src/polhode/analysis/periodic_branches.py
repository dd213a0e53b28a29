"""Continuation of periodic motions along a parameter: branch, Floquet multipliers and bifurcations."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Sequence
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode._base.long_work import long_work
from polhode.analysis._printing import count_things, print_answer, write_numbers, write_span
from polhode.analysis._tangent_flow import TangentFlow, compute_multipliers
from polhode.analysis.floquet import LIMITS as FLOQUET_LIMITS
from polhode.analysis.floquet import PeriodicMotion, periodic_motion
from polhode.errors import InvalidInput, NotConverged
from polhode.systems.base import AbstractSystem
from polhode.taylor.advancing import integrals_at
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import Form, build_machine
from polhode.types import Array, ArrayLike, Double, Float64, Real


class PeriodicBranchLimits(NamedTuple):
    """Numbers that decide how far a branch of periodic motions is followed, and what happens on it."""

    first_step: float = 0.02  # along the branch, in units of state, period and range
    longest_step: float = 0.1  # in the same units
    shortest_step: float = 1e-5  # in the same units: a branch that needs shorter ones is given up
    max_motions: int = 2000  # on a branch
    max_newton_steps: int = 8  # of a method that converges quadratically from a step's guess
    settled_move: float = 1e-12  # in the same units: Newton's method is done after a shorter one
    accepted_move: float = 1e-9  # in the same units: after all steps, a last one so short will do
    min_cosine: float = 0.95  # of the angle between the directions at neighbouring motions
    max_halvings: int = 30  # of the interval in which a bifurcation lies
    relative_zero: float = 1e-7  # singular values of the equations below it belong to directions in a family
    min_parameter_share: float = 1e-6  # of a direction: with less the parameter stays
    conserved_rank: float = 1e-8  # singular values of the gradients of what is conserved below it, relative, vanish
    relative_imaginary_part: float = 1e-7  # of a multiplier: with a smaller one it is real


LIMITS = PeriodicBranchLimits()


class PeriodicBranch(NamedTuple):
    """Periodic motions that follow one another as a parameter changes.

    Attributes:
        values: (m,) of the parameter, which may turn back.
        motions: m of them, with period and multipliers.
        bifurcations: where their multipliers cross the unit circle, or the branch turns back, along the branch.
    """

    values: Float64[np.ndarray, "m"]
    motions: tuple[PeriodicMotion, ...]
    bifurcations: tuple[PeriodicBifurcation, ...]

    @property
    def periods(self) -> Float64[np.ndarray, "m"]:
        """(m,) [s]."""
        return np.array([motion.period for motion in self.motions])

    @property
    def verdicts(self) -> tuple[str, ...]:
        """``"spectrally stable"`` or ``"unstable"``, m of them."""
        return tuple(motion.verdict for motion in self.motions)

    def __str__(self) -> str:
        ends = [self.values.min(), self.values.max()] if len(self.values) else None
        unstable = self.verdicts.count("unstable")
        bifurcations = [f"{one.kind} at {write_numbers(one.value)}" for one in self.bifurcations]
        return print_answer(
            f"{count_things(len(self.motions), 'periodic motion')}, {unstable or 'none'} of them unstable",
            parameter=write_span(ends) if ends else None, bifurcations=", ".join(bifurcations) or None,
        )


class PeriodicBifurcation(NamedTuple):
    """A place on a branch of periodic motions where their kind changes.

    Attributes:
        kind: ``"fold"``: the branch turns back; ``"period doubling"``: a multiplier goes through −1;
            ``"branch point"``: one goes through 1, where another branch begins; ``"torus"``: a pair leaves or enters
            the unit circle.
        value: of the parameter; that of a branch point is known to the root of a rounding only.
        motion: there.
    """

    kind: str
    value: float
    motion: PeriodicMotion

    def __str__(self) -> str:
        return print_answer(
            f"a {self.kind} at {write_numbers(self.value)}", period=write_numbers(self.motion.period, "s"),
            multipliers=write_numbers(self.motion.multipliers),
        )


class _Place(NamedTuple):
    """A motion, the parameter, and the unit direction (n + 2,) of the branch in units of state, period and range."""

    motion: PeriodicMotion
    value: float
    tangent: Float64[np.ndarray, "extended"]
    kinds: tuple[int, int, int]


@known_numbers_only
@long_work("following periodic motions")
def continue_periodic(
    make: Callable[[float], AbstractSystem], limits: Real[ArrayLike, "2"], state: Real[ArrayLike, "..."], period: float,
    first: float = 0.0, fixed: bool = False,
) -> PeriodicBranch:
    """Return the periodic motions of a family of systems, followed from a guess at one end of a range of its parameter.

    Conserved quantities, such as energy and Casimirs, keep their values at the start; otherwise there would be a whole
    family of motions at each value of the parameter. The branch is followed by its length, also around folds, until it
    leaves the range or comes back to where it began.

    Args:
        make: the parameter's value → a system.
        limits: the value to begin at, and the other end of the range, above or below.
        state: a guess of one state on the motion at the first value, packed as ``simulate`` takes it.
        period: a guess of its period [s].
        first: the time [s] at which it is in the state, which matters to driven systems.
        fixed: whether the period is known, as that of a drive that the parameter leaves as it is.

    Raises:
        InvalidInput: for invalid limits, or what ``periodic_motion`` refuses.
        NotConverged: where there is no periodic motion near the guess, or none for other values of the parameter.

    Warns where the branch cannot be followed to an end.

    >>> import polhode as ph
    >>> body = lambda third: ph.systems.FreeRigidBody((1.0, 2.0, third))
    >>> branch = continue_periodic(body, (3.0, 3.2), [0.3, 0.1, 2.0], 9.5)
    >>> exact = ph.FreeMotion((1.0, 2.0, 3.2), momentum=branch.motions[-1].state).period
    >>> bool(abs(branch.periods[-1] / exact - 1.0) < 1e-10), set(branch.verdicts)
    (True, {'spectrally stable'})

    Source: Seydel, *Practical Bifurcation and Stability Analysis*, ch. 7; Muñoz-Almaraz et al., Physica D 181 (2003) 1,
    for what is conserved.
    """
    if not callable(make):
        check.refuse("make", "a function from a value to a system", make)
    ends = check.array("limits", limits, (2,))
    if ends[0] == ends[1]:
        check.refuse("limits", "two different values of the parameter", limits)
    begin = periodic_motion(make(float(ends[0])), state, period, first, fixed)
    family = _Family(make, ends, begin, first, fixed)
    first_place = family.place(begin, float(ends[0]), None)
    if first_place is None:
        raise NotConverged(f"the periodic motion at the value {ends[0]:g} cannot be followed to values beside it.")
    if abs(first_place.tangent[-1]) < LIMITS.min_parameter_share:
        raise NotConverged(
            "the periodic motion does not go on to other values of the parameter while all that is conserved stays as "
            "it is: it may be one of a family that belongs to this value alone."
        )
    places = family.follow(first_place)
    changes = [change for pair in itertools.pairwise(places) for change in family.changes(*pair)]
    return PeriodicBranch(np.array([p.value for p in places]), tuple(p.motion for p in places), tuple(changes))


def _levels_and_slopes(
    system: AbstractSystem, form: Form, z: Float64[np.ndarray, "n"]
) -> tuple[Float64[np.ndarray, "k"], Float64[np.ndarray, "k n"]]:
    """Return the numbers that a system conserves at a state's real numbers, and their derivatives."""
    try:
        levels, slopes = integrals_at(build_machine(system, form.back(z), None), z[None])
        return levels[0], slopes[0]
    except Untraceable:

        def values(x: Array) -> Array:
            invariants = [jnp.asarray(v) for v in system.invariants(form.state(x)).values()]
            return jnp.stack([jnp.zeros(()), *(jnp.real(v) for v in invariants if v.ndim == 0)])[1:]

        return np.asarray(values(jnp.asarray(z))), np.asarray(jax.jacfwd(values)(jnp.asarray(z)))


class _Family:
    """Systems along a parameter, and the conserved values that all their motions share."""

    def __init__(
        self, make: Callable[[float], AbstractSystem], ends: Float64[np.ndarray, "2"], begin: PeriodicMotion,
        first: float, fixed: bool,
    ) -> None:
        self._make, self.begin, self.end, self.first, self.fixed = make, float(ends[0]), float(ends[1]), first, fixed
        self.range = abs(self.end - self.begin)
        self.size, self.period = float(np.linalg.norm(begin.state)) or 1.0, begin.period
        self._form = Form(begin.state.shape, np.iscomplexobj(begin.state))
        levels, slopes = self._find_conserved(self.begin, self._form.flat(begin.state))
        self._held = np.isfinite(levels) & np.isfinite(slopes).all(axis=1)
        self._levels, sizes = levels[self._held], np.linalg.svd(slopes[self._held], compute_uv=False)
        self._trivial = (not fixed) + int(np.sum(sizes > LIMITS.conserved_rank * sizes.max(initial=0.0)))

    def _find_conserved(
        self, value: float, z: Float64[np.ndarray, "n"]
    ) -> tuple[Float64[np.ndarray, "k"], Float64[np.ndarray, "k n"]]:
        """Return the conserved quantities, and their derivatives by the state."""
        return _levels_and_slopes(self._make(value), self._form, z)

    def _units(self, n: int) -> Float64[np.ndarray, "extended"]:
        return np.array([self.size] * n + [self.period, self.range])

    def settle(
        self, motion: PeriodicMotion, value: float, row: Float64[np.ndarray, "extended"] | None
    ) -> tuple[PeriodicMotion, float] | None:
        """Return the periodic motion next to a guess, which may not move along a direction; None if there is none."""
        z, T = self._form.flat(motion.state), motion.period
        n, start = z.size, z.copy()
        units = self._units(n)
        for turn in range(LIMITS.max_newton_steps):
            equations = self._equations(z, T, value, start)
            if equations is None:
                return None
            off, matrix, M = equations
            if row is not None:
                matrix, off = np.vstack([matrix, row / units]), np.append(off, 0.0)
            move = -np.linalg.lstsq(matrix * units, off, rcond=FLOQUET_LIMITS.relative_singular_value)[0]
            if not np.isfinite(move).all() or np.abs(move).max() > 0.5:
                return None
            z, T, value = z + units[:n] * move[:n], T + float(units[n] * move[n]), value + float(self.range * move[-1])
            far = float(np.abs(move).max())
            if far < LIMITS.settled_move or (far < LIMITS.accepted_move and turn == LIMITS.max_newton_steps - 1):
                gap = float(np.linalg.norm(off[:n])) / self.size
                return PeriodicMotion(self._form.back(z), T, gap, M, *compute_multipliers(M)), value
        return None

    def _equations(
        self, z: Float64[np.ndarray, "n"], T: float, value: float, start: Float64[np.ndarray, "n"]
    ) -> tuple[Float64[np.ndarray, "equations"], Float64[np.ndarray, "equations extended"], np.ndarray] | None:
        """Return residuals, their derivatives by state, period and parameter, and the monodromy."""
        difference = 1e-6  # of the range: the step of derivatives by the parameter
        n, state, first = z.size, self._form.back(z), self.first
        step, low, high = difference * self.range, min(self.begin, self.end), max(self.begin, self.end)
        near = value + step * (value != high), value - step * (value != low)
        try:
            after, M = self._flow(value, state, T, np.eye(n))
            beside = [self._flow(v, state, T, np.zeros((n, 1)))[0] for v in near]
        except (InvalidInput, NotConverged):
            return None
        flow = TangentFlow(self._make(value), state, (first, first + T))
        by_value = (flow.flat(beside[0]) - flow.flat(beside[1])) / (near[0] - near[1])
        by_period = np.zeros(n) if self.fixed else flow.rates(first + T, after)
        rows = [np.column_stack([M - np.eye(n), by_period, by_value])]
        off = [flow.flat(after) - z]
        if self.fixed:
            rows.append(np.eye(n + 2)[n : n + 1] * (self.size / self.period))
            off.append(np.zeros(1))
        else:  # it begins on the plane through the guess, across the motion
            along = flow.rates(first, state)
            along = along / (np.linalg.norm(along) or 1.0)
            rows.append(np.concatenate([along, [0.0, 0.0]])[None])
            off.append(np.array([along @ (z - start)]))
        if self._levels.size:
            (levels, slopes), beyond = self._find_conserved(value, z), [self._find_conserved(v, z)[0] for v in near]
            scales = np.maximum(np.linalg.norm(slopes, axis=1), 1e-300)
            by_parameter = (beyond[0] - beyond[1]) / (near[0] - near[1])
            all_rows = np.column_stack([slopes, np.zeros(len(slopes)), by_parameter]) / scales[:, None]
            rows.append(all_rows[self._held])
            off.append((levels[self._held] - self._levels) / scales[self._held])
        return np.concatenate(off), np.vstack(rows), M

    def _flow(
        self, value: float, state: Double[np.ndarray, "..."], T: float, changes: Float64[np.ndarray, "n k"]
    ) -> tuple[Double[np.ndarray, "..."], Float64[np.ndarray, "n k"]]:
        flow = TangentFlow(self._make(value), state, (self.first, self.first + T))
        return flow(self.first, self.first + T, state, changes)

    def place(
        self, motion: PeriodicMotion, value: float, along: Float64[np.ndarray, "extended"] | None
    ) -> _Place | None:
        """Return a settled motion as a place, its direction as near as can be to another, or into the range.

        None where the motions beside it do not exist.
        """
        z = self._form.flat(motion.state)
        equations = self._equations(z, motion.period, value, z)
        if equations is None:
            return None
        matrix = equations[1] * self._units(z.size)
        _, sizes, rows = np.linalg.svd(matrix)
        still = rows[np.append(sizes, np.zeros(len(rows)))[: len(rows)] <= LIMITS.relative_zero * sizes[0]]
        still = still if len(still) else rows[-1:]
        # of a whole family the direction in which the parameter changes most, or that is nearest to the last
        wanted = np.eye(len(rows))[-1] * np.sign(self.end - self.begin) if along is None else along
        tangent = still.T @ (still @ wanted)
        length = float(np.linalg.norm(tangent))
        if length < LIMITS.relative_zero:
            tangent, length = still[-1], 1.0
        return _Place(motion, value, tangent / length, self._kinds(motion))

    def _kinds(self, motion: PeriodicMotion) -> tuple[int, int, int]:
        """Return how many multipliers are real and above 1, real and below −1, and not real and off the unit circle."""
        others = np.argsort(np.abs(motion.multipliers - 1.0))[self._trivial :]
        values, errors = np.asarray(motion.multipliers)[others], np.asarray(motion.errors)[others]
        real, size = np.real(values), np.abs(values)
        is_real = np.abs(np.imag(values)) <= LIMITS.relative_imaginary_part * size
        above, below, outside = real > 1.0 + errors, real < -1.0 - errors, size > 1.0 + errors
        return int(np.sum(is_real & above)), int(np.sum(is_real & below)), int(np.sum(~is_real & outside))

    def follow(self, begin: _Place) -> list[_Place]:
        """Return the places of the branch, up to an end of the range."""
        places, step, low, high = [begin], LIMITS.first_step, min(self.begin, self.end), max(self.begin, self.end)
        while len(places) < LIMITS.max_motions and step > LIMITS.shortest_step:
            last = places[-1]
            place = self._step_from(last, step)
            if place is None or place.tangent @ last.tangent < LIMITS.min_cosine:
                step *= 0.5
                continue
            if not low <= place.value <= high:
                border = low if place.value < low else high
                end = self._at_value(last, place, border)
                return [*places, end] if end is not None and border != last.value else places
            places.append(place)
            step = min(1.5 * step, LIMITS.longest_step)
            goes_on = place.tangent @ begin.tangent > LIMITS.min_cosine
            if len(places) > 5 and self._apart(place, begin) < 0.5 * step and goes_on:
                return [*places, begin]  # it is closed
        warnings.warn(
            f"a branch of periodic motions could not be followed beyond the value {places[-1].value:g}: what comes "
            "after is not known.",
            stacklevel=4,
        )
        return places

    def _step_from(self, last: _Place, step: float) -> _Place | None:
        n = last.tangent.size - 2
        move = step * last.tangent * self._units(n)
        state = self._form.back(self._form.flat(last.motion.state) + move[:n])
        guess = last.motion._replace(state=state, period=last.motion.period + float(move[n]))
        solution = self.settle(guess, last.value + float(move[-1]), last.tangent)
        return None if solution is None else self.place(*solution, last.tangent)

    def _at_value(self, before: _Place, after: _Place, value: float) -> _Place | None:
        """Return the place at a value between two."""
        share = (value - before.value) / (after.value - before.value)
        motion = before.motion._replace(
            state=before.motion.state + share * (after.motion.state - before.motion.state),
            period=before.motion.period + share * (after.motion.period - before.motion.period),
        )
        solution = self.settle(motion, value, np.eye(before.tangent.size)[-1])
        return None if solution is None else self.place(solution[0], value, before.tangent)

    def _apart(self, one: _Place, other: _Place) -> float:
        gap = float(np.abs(one.motion.state - other.motion.state).max()) / self.size
        return max(gap, abs(one.value - other.value) / self.range)

    def changes(self, one: _Place, other: _Place) -> Sequence[PeriodicBifurcation]:
        """Return where the kind of the motions changes between two places, in order."""
        meetings = []
        if one.tangent[-1] * other.tangent[-1] < 0.0:
            meetings.append(("fold", self._locate(one, other, lambda place: place.tangent[-1] * one.tangent[-1] > 0.0)))
        for k, kind in enumerate(("branch point", "period doubling", "torus")):
            # a multiplier goes through 1 at a fold too
            if one.kinds[k] != other.kinds[k] and not (k == 0 and meetings):
                meetings.append((kind, self._locate(one, other, lambda place, k=k: place.kinds[k] == one.kinds[k])))
        return [PeriodicBifurcation(kind, place.value, place.motion) for kind, place in meetings]

    def _locate(self, one: _Place, other: _Place, is_before: Callable[[_Place], bool]) -> _Place:
        """Return the place up to which something holds, by halving the way."""
        low, high = one, other
        for _ in range(LIMITS.max_halvings):
            if self._apart(low, high) < 1e-9:
                break
            way = 0.5 * self._length(low, high)
            place = self._step_from(low, way) if way > 0.0 else None
            if place is None:
                break
            low, high = (place, high) if is_before(place) else (low, place)
        return low

    def _length(self, one: _Place, other: _Place) -> float:
        n = one.tangent.size - 2
        flat = [self._form.flat(place.motion.state) for place in (one, other)]
        way = np.concatenate([flat[1] - flat[0], [other.motion.period - one.motion.period, other.value - one.value]])
        return float(np.linalg.norm(way / self._units(n)))
