"""Proved enclosures of a motion: balls that are certain to contain the state at a time."""

from __future__ import annotations

import math
from types import FunctionType
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import require_doubles
from polhode.analysis._exact_arithmetic import import_flint
from polhode.analysis._printing import count_things, print_answer, write_numbers, write_span
from polhode.analysis._tangent_flow import one_state
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.integrators._interrupts import keep_interrupts
from polhode.proving.enclosures._proof_limits import LIMITS
from polhode.proving.enclosures._taylor_balls import Ball, BallSystem, collect_numbers
from polhode.simulation import simulate
from polhode.systems.base import AbstractSystem
from polhode.taylor.expressions import Untraceable
from polhode.types import Array, ArrayLike, Double, Float64, Real

SHARE = math.exp(-1.3)  # of the disc in which a series is bounded, that a step reaches: the least work


class Enclosure(NamedTuple):
    """Rigorous enclosures of a motion at some times.

    Attributes:
        times: (T,) [s].
        states: (T, …) the nearest doubles.
        radii: (T, …) by how much each number of the true state may differ from them at most; of complex states
            each of real and imaginary part.
        exact: whether the numbers in the system's fields and formulas were taken as they are. Otherwise some
            values computed of them were rounded to doubles, and the enclosure is of the system with those.
        growth: by how much the bound on an error of the start has grown at the last time.
        steps: how many were taken.
        order: of the series.
        bits: of the arithmetic.
    """

    times: Float64[np.ndarray, "time"]
    states: Double[np.ndarray, "..."]
    radii: Float64[np.ndarray, "..."]
    exact: bool
    growth: float
    steps: int
    order: int
    bits: int

    def __str__(self) -> str:
        of = "as it is" if self.exact else "with its numbers rounded to doubles"
        return print_answer(
            f"proved enclosures of the system {of}, at {count_things(len(self.times), 'time')} "
            f"{write_span(self.times, 's')}", largest_radius_at_the_last_time=write_numbers(np.max(self.radii[-1])),
            state_there=write_numbers(self.states[-1]),
        )


def enclose_by_series(
    system: AbstractSystem, state: Real[ArrayLike, "..."], times: Real[ArrayLike, "time"], radius: float,
    other: AbstractSystem | None, state_radii: Real[ArrayLike, "..."] | None,
) -> Enclosure:
    """Return enclosures of a system's motion; ``certify`` says what the arguments are."""
    start, times = _check_arguments(system, state, times, radius)
    flint = import_flint()
    if other is not None:
        system, other = _with_numbers_as_arrays(system), _with_numbers_as_arrays(other)
    try:
        balls = BallSystem(system, start)
    except Untraceable as error:
        raise InvalidInput(
            f"{type(system).__name__} has no Taylor series, and no proof by one: its rates of change contain {error}."
        ) from None
    middle, spread = _limits(system, other, balls)
    off = _check_radii(state_radii, balls, start)
    weights, grown, steps = _look_ahead(system, balls, start, times)
    # of the weighted norm, whose largest weight turns it into the radius that is asked for
    wanted = radius * (float(np.abs(_flat(balls, start)).max()) or 1.0) / float(weights.max())
    digits = math.log(max(steps, 1.0)) + grown + LIMITS.spare_growth - math.log(min(wanted, 1.0))
    order = max(math.ceil(digits / -math.log(SHARE)), LIMITS.tube_order)
    bits = max(math.ceil(digits / math.log(2.0)) + 32, LIMITS.min_bits)
    if order > LIMITS.max_order or bits > LIMITS.max_bits:
        raise NotConverged(
            f"the bound on errors grows by e^{grown:.0f} up to {times[-1]:g} s, for which {bits} bits and order "
            f"{order} would be needed; at most {LIMITS.max_bits} and {LIMITS.max_order} are "
            "taken. Give an earlier last time."
        )
    before, flint.ctx.prec = flint.ctx.prec, bits
    try:
        return _Proof(flint, balls, (start, off), (middle, spread), times, weights, order, bits).run()
    finally:
        flint.ctx.prec = before


class _Proof:
    """The state of a run: the midpoint, the bound on the distance to the true state, the disc."""

    def __init__(
        self, flint: Any, balls: BallSystem, start: tuple[Array, Array], numbers: tuple[Array, Array],
        times: np.ndarray, weights: Array, order: int, bits: int,
    ) -> None:
        self.flint, self.balls, self.times = flint, balls, times
        self.order, self.bits = order, bits
        arb = flint.arb
        self.moving = balls.form.size
        self.parameters = [arb(float(x)) for x in numbers[0]]
        self.radii = [arb(float(x)) for x in numbers[1]]
        self.around = [x + arb(0, r) for x, r in zip(self.parameters, self.radii, strict=True)]
        self.weights = [arb(float(w)) for w in weights]
        self.y = [arb(float(x)) for x in _flat(balls, start[0])] + [arb(float(times[0]))] * balls.timed
        self.error, self.growth, self.steps = self._size([arb(float(x)) for x in start[1]]), arb(1), 0
        self.width = float(abs(times[-1] - times[0])) / LIMITS.rings
        self.forth = 1 if times[-1] > times[0] else -1

    def _size(self, changes: list[Ball]) -> Ball:
        """Return a bound on the weighted norm of changes of the state, without the time."""
        total = self.flint.arb(0)
        for x, w in zip(changes, self.weights, strict=False):
            total += (x.abs_upper() / w) ** 2  # a square of a ball around zero reaches below it
        return total.sqrt().upper()

    def run(self) -> Enclosure:
        """Return the enclosures at all times."""
        samples = [self._sample()]
        with keep_interrupts() as check_interrupts:
            now = self.flint.arb(float(self.times[0]))
            for time in self.times[1:]:
                end = self.flint.arb(float(time))
                while True:
                    check_interrupts()
                    left = (end - now) * self.forth
                    box, disc = self._bound(left)
                    whole = self.flint.arb(SHARE * disc)
                    last = bool(left <= whole)
                    h = left if last else self.flint.arb(float(whole.mid()))
                    self._step(h * self.forth, box, disc)
                    now = end if last else now + h * self.forth
                    if last:
                        break
                if self.balls.timed:
                    self.y[-1] = end
                samples.append(self._sample())
        states, radii = (np.array(x) for x in zip(*samples, strict=True))
        form = self.balls.form
        radii = radii.reshape(len(radii), *form.shape, -1).max(axis=-1)
        return Enclosure(self.times, form.back(states), radii, self.balls.exact,
                         float(self.growth.upper()), self.steps, self.order, self.bits)

    def _bound(self, left: Ball) -> tuple[list[Ball], float]:
        """Return radii of a box in which the motion stays for all complex times in a disc, and the disc's radius.

        The disc grows ring by ring. If the rates over a box, times the width of a ring, lead nowhere out of the box
        from the one before, then by Picard's theorem the motion is analytic up to there and stays in it.
        """
        arb, whole = self.flint.arb, float(left.upper()) / SHARE
        width, disc, sizes = self.width, arb(0), [arb(0)] * len(self.y)
        least = LIMITS.min_disc * max(whole, abs(self.times[-1]))
        while width > max(least, LIMITS.min_ring * float(disc.upper())) and float(disc.upper()) < whole:
            ring = arb(width)
            wider = self._wider(sizes, ring)
            if wider is None:
                width *= 0.5
                continue
            disc, sizes = arb((disc + ring).lower()), wider
            far = LIMITS.max_excursion
            if any(bool(x > far * (w + abs(y))) for x, w, y in zip(sizes, self.weights, self.y, strict=False)):
                break
        reached = float(disc.lower())
        if not reached > least:
            raise NotConverged(
                f"no box is proved to hold the motion after {self.steps} steps: it runs into a singularity. Give an "
                "earlier last time."
            )
        self.width = reached / LIMITS.rings
        return sizes, math.nextafter(reached, 0.0)

    def _wider(self, sizes: list[Ball], ring: Ball) -> list[Ball] | None:
        """Return the radii of a box that the motion does not leave within one more ring; None if none is proved."""
        arb, acb = self.flint.arb, self.flint.acb

        def reach(radii: list[Ball]) -> list[Ball] | None:
            box = [acb(y + arb(0, r), arb(0, r)) for y, r in zip(self.y, radii, strict=True)]
            rates = self.balls.rates(box, self.parameters)
            if not all(x.is_finite() for x in rates):
                return None
            return [(size + x.abs_upper() * ring).upper() for size, x in zip(sizes, rates, strict=True)]

        reached = reach(sizes)
        for _ in range(LIMITS.max_trials):
            if reached is None:
                return None
            wider = [(size + (x - size) * LIMITS.widening).upper() for size, x in zip(sizes, reached, strict=True)]
            reached = reach(wider)
            if reached is not None and all(bool(x <= y) for x, y in zip(reached, wider, strict=True)):
                return reached
        return None

    def _step(self, h: Ball, box: list[Ball], disc: float) -> None:
        arb = self.flint.arb
        series = self.balls.coefficients(self.y, self.parameters, self.order)
        ratio = (abs(h) / arb(disc)).upper()
        # Cauchy's estimate |c_k| ≤ size/disc^k: what is cut off is at most size · ratio^(p+1)/(1 − ratio)
        cut = (ratio ** (self.order + 1) / (1 - ratio)).upper()
        new, off = [], []
        for k, (row, size) in enumerate(zip(series, box, strict=True)):
            value = row[self.order]
            for x in reversed(row[: self.order]):
                value = value * h + x
            new.append(value.mid())
            if k == self.moving and not bool(value.rad() == 0):
                raise NotConverged(f"{self.bits} bits do not hold times of steps exactly. Give a smaller `radius`.")
            off.append(arb(value.rad()).upper() + size * cut)
        tube = self._tube(series, h, box, ratio)
        # the change of the rates along the midpoint's path by other numbers, which then grows as errors do
        pushed = arb(0)
        if any(bool(r > 0) for r in self.radii):
            pushed = self._size(self.balls.changes(tube, self.around, self.radii)) * abs(h)
        faster = self._faster(tube, abs(h), pushed)
        grow = (faster * abs(h)).exp().upper()
        grown = grow.max(arb(1)) if bool(pushed > 0) else grow
        # d|e|/dt ≤ m |e| + |push| with the logarithmic norm m (Dahlquist)
        self.error = (self.error * grow + pushed * grown + self._size(off[: self.moving])).upper()
        self.growth = (self.growth * grow).upper()
        self.y, self.steps = new, self.steps + 1

    def _tube(self, series: list[list[Ball]], h: Ball, box: list[Ball], ratio: Ball) -> list[Ball]:
        """Return balls that hold the motion from the midpoint during the step, by the first terms of its series."""
        arb = self.flint.arb
        half = (abs(h) / 2).upper()
        during = h / 2 + arb(0, half)
        cut = (ratio ** (LIMITS.tube_order + 1) / (1 - ratio)).upper()
        tube = []
        for row, size in zip(series, box, strict=True):
            value = row[LIMITS.tube_order]
            for x in reversed(row[: LIMITS.tube_order]):
                value = value * during + x
            tube.append(value + arb(0, (size * cut).upper()))
        return tube

    def _faster(self, motion: list[Ball], h: Ball, pushed: Ball) -> Ball:
        """Return an upper bound of the logarithmic norm along the step, of the true motion and of the midpoint's."""
        arb, n = self.flint.arb, self.moving
        error = self.error + pushed
        aside = error * 2
        for _ in range(LIMITS.max_trials):
            tube = list(motion)
            tube = [x + arb(0, (w * aside).upper()) for x, w in zip(tube, self.weights, strict=False)] + tube[n:]
            slopes = self.balls.slopes(tube, self.around)
            half = [[(self.forth * (slopes[i][j] * self.weights[j] / self.weights[i]
                                    + slopes[j][i] * self.weights[i] / self.weights[j])) / 2
                     for j in range(n)] for i in range(n)]
            if not all(x.is_finite() for row in half for x in row):
                break
            # the logarithmic norm for |W⁻¹e|: the largest eigenvalue of the symmetric part of W⁻¹ J W
            bound = _largest(self.flint, half)
            most = error * (bound * h).exp().max(arb(1))
            if bool(most <= aside):
                return bound
            aside = most.upper() * LIMITS.widening
        raise NotConverged(
            f"the bound on errors, {float(self.error.upper()):.1e}, is too large for the rates to be bounded around "
            "the motion. Give a smaller `radius`, or an earlier last time."
        )

    def _sample(self) -> tuple[Array, Array]:
        """Return the nearest doubles (n,) and the radii (n,) around them."""
        doubles = np.array([float(x) for x in self.y[: self.moving]])
        radii = []
        for k, x in enumerate(doubles):
            off = abs(self.y[k] - self.flint.arb(x)) + self.weights[k] * self.error
            radii.append(math.nextafter(float(off.upper()), math.inf))
        return doubles, np.array(radii)


def _largest(flint: Any, matrix: list[list[Ball]]) -> Ball:
    """Return a bound that no eigenvalue of a symmetric matrix of balls exceeds, proved by Cholesky's factors."""
    middle = np.array([[float(x) for x in row] for row in matrix])
    spread = np.array([[float(x.rad().upper()) for x in row] for row in matrix])
    size = float(np.abs(middle).max()) or 1e-300
    estimate = float(np.linalg.eigvalsh(middle)[-1]) + float(np.linalg.norm(spread))
    margin = 1e-9 * size
    while math.isfinite(margin):
        bound = flint.arb(estimate + margin)
        if _is_positive([[bound * (i == j) - matrix[i][j] for j in range(len(matrix))] for i in range(len(matrix))]):
            return bound
        margin *= 8.0
    return flint.arb(math.inf)


def _is_positive(a: list[list[Ball]]) -> bool:
    """Return whether all symmetric matrices in a matrix of balls are positive definite, by elimination."""
    a = [list(row) for row in a]
    for k in range(len(a)):
        if not bool(a[k][k] > 0):
            return False
        for i in range(k + 1, len(a)):
            factor = a[i][k] / a[k][k]
            for j in range(k + 1, len(a)):
                a[i][j] -= factor * a[k][j]
    return True


def _look_ahead(
    system: AbstractSystem, balls: BallSystem, start: Array, times: Array
) -> tuple[Float64[np.ndarray, "n"], float, float]:
    """Return weights of a norm in which errors grow slowly, the e-folds of that growth, and a number of steps.

    All three are estimates by doubles: nothing that is proved depends on them.
    """
    places = 400
    path = np.linspace(times[0], times[-1], places)
    run = simulate(system, start, path, estimate_error=False)
    if run.outcome.event:
        raise InvalidInput(
            f"`times` must be within the motion of {type(system).__name__}, which ends at {run.times[-1]:g} s by the "
            f"event {run.outcome.event}. Give an earlier last time."
        )
    form = balls.form

    @jax.jit
    def slopes(t: Array, numbers: Array) -> Array:
        return jax.jacfwd(lambda x: form.numbers(system.vector_field(t, form.state(x))))(numbers)

    flat = form.flat(run.states)
    forth = 1.0 if times[-1] > times[0] else -1.0
    J = forth * np.stack([np.asarray(slopes(jnp.asarray(t), jnp.asarray(x))) for t, x in zip(path, flat, strict=True)])
    largest = np.abs(flat).max() or 1.0
    wrong = ~(np.abs(J).max(axis=(1, 2)) < LIMITS.max_slope)
    if wrong.any():
        here, before = path[np.argmax(wrong)], path[max(np.argmax(wrong) - 1, 0)]
        raise NotConverged(
            f"the rates of change of {type(system).__name__} have no finite derivative at {here:g} s: up to "
            f"{before:g} s they have. Give an earlier last time, before the motion comes to a singularity."
        )

    def growth(w: Array) -> float:
        scaled = J * w[None, None, :] / w[None, :, None]
        fastest = np.linalg.eigvalsh(0.5 * (scaled + np.swapaxes(scaled, 1, 2)))[:, -1]
        return float(np.sum(np.maximum(fastest, 0.0)) * np.ptp(path) / (places - 1))

    shapes = [np.maximum(np.abs(flat).max(axis=0), share * largest) for share in (0.01, 0.2, 1.0)]
    weights = min(shapes, key=growth)
    best = growth(weights)
    for _ in range(3):
        for k in range(len(weights)):
            for factor in (0.7, 1.4):
                trial = np.where(np.arange(len(weights)) == k, weights * factor, weights)
                if (value := growth(trial)) < best:
                    weights, best = trial, value
    rate = float(np.max(np.linalg.norm(J, axis=(1, 2))))
    return weights, 1.15 * best, 10.0 * rate * float(np.ptp(path)) + len(times)


def _limits(system: AbstractSystem, other: AbstractSystem | None, balls: BallSystem) -> tuple[Array, Array]:
    """Return the midpoint of both systems' numbers, and the radii of balls around it that contain both."""
    one = balls.parameters
    if other is None:
        return one, np.zeros(len(one))
    if not (jax.tree.structure(other) == jax.tree.structure(system) and _have_same_rest(system, other)):
        raise InvalidInput(
            f"`other` must be a {type(system).__name__} of the same form, of which only real numbers in its fields "
            f"differ; got {shown(other)}. What a function or a whole number says differently cannot be enclosed: make "
            "it a field, like `rate: float`."
        )
    own = collect_numbers(other)
    if not balls.exact:
        raise InvalidInput(
            f"`other` cannot be taken: the rates of {type(system).__name__} look at their numbers, or put them into "
            "functions that have no series, and were traced with those of `system`."
        )
    second = one.copy()  # with the numbers in formulas, which both share
    second[: len(own)] = own
    middle = one + 0.5 * (second - one)
    radii = np.maximum(np.abs(one - middle), np.abs(second - middle))
    radii = np.where(radii > 0.0, np.nextafter(radii, np.inf), 0.0)
    if radii[balls.looked_at].any():
        raise InvalidInput("`other` must have the same eccentricity: Kepler's equation is solved for one number.")
    return middle, radii


def _with_numbers_as_arrays(system: AbstractSystem) -> AbstractSystem:
    """Return a system whose plain real numbers are arrays, as the numbers are that may differ."""
    return jax.tree.map(lambda x: np.float64(x) if type(x) is float else x, system)


def _have_same_rest(system: AbstractSystem, other: AbstractSystem) -> bool:
    """Return whether two systems agree in all but the real numbers."""
    one, two = (jax.tree.leaves(eqx.filter(each, eqx.is_inexact_array, inverse=True)) for each in (system, other))
    return len(one) == len(two) and all(map(_is_same, one, two))


def _is_same(x: Any, y: Any) -> bool:
    """Return whether two parts are equal; functions are if they come from one line of code and enclose equal values."""
    if x is y:
        return True
    if isinstance(x, FunctionType) and isinstance(y, FunctionType):
        enclosed = [[cell.cell_contents for cell in each.__closure__ or ()] for each in (x, y)]
        return x.__code__ is y.__code__ and x.__defaults__ == y.__defaults__ and all(map(_is_same, *enclosed))
    return type(x) is type(y) and bool(np.array_equal(np.asarray(x), np.asarray(y)))


def _check_radii(value: ArrayLike | None, balls: BallSystem, start: Array) -> Float64[np.ndarray, "n"]:
    """Return the radius of each number of the start."""
    shape = np.shape(start)
    try:
        radii = np.asarray(0.0 if value is None else value, float)
    except (TypeError, ValueError):
        radii = np.full(1, np.nan)
    if radii.shape not in ((), shape) or not (np.isfinite(radii) & (radii >= 0.0)).all():
        check.refuse("state_radii", f"numbers that are not negative, one or of shape {shape}", value)
    return np.repeat(np.broadcast_to(radii, shape).ravel(), 2 if balls.form.is_complex else 1)


def _flat(balls: BallSystem, start: Array) -> Float64[np.ndarray, "n"]:
    return np.ravel(balls.form.flat(start))


def _check_arguments(
    system: AbstractSystem, state: ArrayLike, times: ArrayLike, radius: float
) -> tuple[Double[np.ndarray, "..."], Float64[np.ndarray, "time"]]:
    require_doubles(times=times)
    start, values = one_state(system, state), np.asarray(times, dtype=float)
    gaps = np.sign(np.diff(values)) if values.ndim == 1 else np.zeros(1)
    if values.ndim != 1 or len(values) < 2 or not np.isfinite(values).all() or not (gaps * gaps[:1] > 0).all():
        raise InvalidInput(f"`times` must be at least two finite times [s] in one direction; got {shown(times)}.")
    radius = check.number("radius", radius, above=0, below=1)
    jumps = np.ravel(np.asarray(system.jumps, float))
    low, high = sorted((values[0], values[-1]))
    if ((jumps > low) & (jumps < high)).any():
        raise InvalidInput(
            f"`times` must not go beyond a jump of {type(system).__name__}'s rates, as that at {jumps[0]:g} s. Certify "
            "each segment by itself."
        )
    return start, values
