"""The offset between the clocks of two attitude histories, where their attitudes show it.

The histories are laid over each other at all offsets, first with their axes as given, then with the axes of space of
one rotated by a constant, as a log without a compass has them. Gauss and Newton's steps refine the best offsets, and
then fit a constant turn of the body axes along, as no sensor is mounted quite straight: R_B(t) = S R_A(t + offset) M.
Where the motion does not distinguish that turn from an offset, the axes are supposed to agree, and the result says so.
Where another offset fits nearly as well, the motion repeats itself at all times, or the samples turn too little to
determine an offset, none is returned.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis._attitude_noise import root_mean_square
from polhode.errors import InvalidInput
from polhode.spacecraft.comparing._offset_limits import LIMITS, SEARCH
from polhode.types import Array, Float64

STILL = "the attitude does not change, so that it shows no offset of the clocks"
ONE = np.array([1.0, 0.0, 0.0, 0.0])

Evaluate = Callable[[Float64[Array, "time"]], tuple[Float64[Array, "time 4"], Float64[Array, "time 3"]]]
"""Attitudes and angular velocities [rad/s, body axes] at times."""


class Moving(NamedTuple):
    """A history that can be evaluated at any time within a span.

    Attributes:
        at: evaluates it.
        first, last: the span [s].
        is_bounded: whether it has no values beyond.
    """

    at: Evaluate
    first: float
    last: float
    is_bounded: bool


class ClockOffset(NamedTuple):
    """The time of one history at the zero of another's times.

    Attributes:
        offset: that time [s].
        error: its standard error, of independent residuals [s].
        left: root mean square angle that remains [rad].
        turned: whether the axes of space had to be rotated by a constant.
        supposed: whether the body axes are supposed to agree, as no constant turn of them could be fitted along.
        agreeing: the offset and its error [s] if they do agree, where one was fitted along and none shows; else None.
    """

    offset: float
    error: float
    left: float
    turned: bool
    supposed: bool = False
    agreeing: tuple[float, float] | None = None


class Wanted(NamedTuple):
    """How messages name offsets, and which of several is wanted.

    Attributes:
        word: an offset in words.
        near: an offset near the right one [s]; None where none is given.
    """

    word: Callable[[float], str]
    near: float | None = None


class Samples(NamedTuple):
    """Samples laid over a motion: times (T,) [s] and attitudes (T, 4), body → space."""

    times: Float64[Array, "time"]
    attitude: Float64[Array, "time 4"]


class Fit(NamedTuple):
    """An offset, with turns of axes fitted along: S q_B(t) M = q_A(t + offset).

    Attributes:
        offset: [s].
        free: whether S is fitted, and whether M is.
        share: agreement at the offset of the search that it began with, at most 1.
        space, body: S and M (4,).
        left: root mean square angle that remains [rad].
        error: of the offset, by the covariance of all fitted numbers [s].
        spare: degrees of freedom: three for each sample, less the fitted numbers.
    """

    offset: float
    free: tuple[bool, bool]
    share: float
    space: Float64[Array, "4"] = ONE
    body: Float64[Array, "4"] = ONE
    left: float = np.inf
    error: float = np.inf
    spare: float = 0.0


class Rule(NamedTuple):
    """What decides on the offset of one comparison.

    Attributes:
        speed: largest angular speed of the body [rad/s].
        span: that offsets are sought in [s].
        wanted: which of several is meant.
        missed: the best agreement of those that were not refined, 0 if none.
    """

    speed: float
    span: float
    wanted: Wanted
    missed: float


def find_clock_offset(motion: Moving, samples: Samples, speed: float, wanted: Wanted) -> ClockOffset:
    """Return the time of a motion at the time zero of samples.

    Args:
        motion: of which the samples are.
        samples: the other history.
        speed: largest angular speed of the body [rad/s].
        wanted: which of several offsets is meant.

    Raises:
        InvalidInput: where no offset makes them agree, several do, or the motion does not determine it.
    """
    if not speed > 0.0:
        raise InvalidInput(f"{STILL}. Say it by `offset`.")
    some, many = _take(samples, SEARCH.coarse_samples), _take(samples, SEARCH.fine_samples)
    grid = _offsets(motion, samples.times, speed)
    nearest, turns = None, _spread(many.attitude)
    for free in (False, True):
        starts, missed = _search(motion, some, grid, free, wanted.near)
        fits = _sort([_refine(motion, many, start) for start in starts])
        if not fits:
            continue
        best = fits[0]
        nearest = best if nearest is None or best.left < nearest.left else nearest
        if best.left > LIMITS.max_residual:
            continue
        if not np.isfinite(best.error):
            steady = "the body turns steadily, so that with other axes of space any offset fits" if free else STILL
            raise InvalidInput(f"{steady}. Say it by `offset`.")
        if best.left > LIMITS.max_unexplained * turns:
            continue
        return _settle(motion, many, fits, Rule(speed, float(grid[-1] - grid[0]), wanted, missed))
    raise InvalidInput(f"no offset of the clocks makes the two agree{_word_nearest(nearest, turns, wanted)}. Check "
                       "that both are along the same body axes, or say the offset by `offset`.")


def _word_nearest(nearest: Fit | None, turns: float, wanted: Wanted) -> str:
    """Return how well the best offset fits samples that turn so far [rad, rms], after a colon; "" without one."""
    if nearest is None:
        return ""
    axes = ", with the axes of space turned by a constant" if nearest.free[0] else ""
    return (f": the best, {wanted.word(nearest.offset)} s{axes}, leaves {nearest.left:.2g} rad rms, and the samples "
            f"turn by {turns:.2g} rad rms")


def _settle(motion: Moving, samples: Samples, fits: list[Fit], rule: Rule) -> ClockOffset:
    """Return the offset with those turns of axes fitted along that the motion distinguishes from it.

    Axes that are supposed to agree, while the residuals show a turn about others, are likely to differ as much about
    the one that is not measured; the error covers that.

    Args:
        motion: of which the samples are.
        samples: the other history.
        fits: with the body axes as given, the best first.
        rule: what decides on the offset.

    Raises:
        InvalidInput: where several offsets fit even with the body axes as given, or the error is too large.
    """
    free = fits[0].free[0]
    askew = _fit_along(motion, samples, fits, (free, True), rule)
    best = _choose(askew or fits, rule)
    lean = _find_lean(motion, samples, best, (not free, not askew))
    if lean and askew and not free:
        tilted = _fit_along(motion, samples, askew, (True, True), rule)
        best, lean = (_choose(tilted, rule), 0.0) if tilted else (best, lean)
    error = best.error
    if lean:
        error *= float(np.hypot(1.0, LIMITS.axes_unmeasured * lean * np.sqrt(best.spare) / best.left))
    if error > LIMITS.max_error * rule.span:
        raise InvalidInput(
            f"the attitudes do not determine the offset of the clocks: the best is {rule.wanted.word(best.offset)} ± "
            f"{error:.2g} s, and its error must be at most a tenth of the {rule.span:.6g} s that it "
            "is sought in. Say it by `offset`, or give a log that turns further."
        )
    held = min(fits, key=lambda fit: abs(fit.offset - best.offset))
    straight = bool(askew) and best.free[0] == free and not _find_lean(motion, samples, held, (False, True))
    agreeing = (held.offset, held.error) if straight else None
    return ClockOffset(best.offset, error, best.left, best.free[0], not askew, agreeing)


def _fit_along(motion: Moving, samples: Samples, fits: list[Fit], free: tuple[bool, bool], rule: Rule) -> list[Fit]:
    """Return fits with more turns of axes, the best first; none where they do not leave one offset."""
    # a fit that diverges with the turns is kept as it was: its residual is no larger than that
    near = [fit for fit in fits if fit.left < LIMITS.max_residual]
    wider = _sort([_refine(motion, samples, fit._replace(free=free)) or fit for fit in near])
    best = _pick(wider, rule)
    if best is None or best.free != free:
        return []
    return wider if best.error * rule.speed < LIMITS.max_turn_within_error else []


def _sort(fits: list[Fit | None]) -> list[Fit]:
    """Return those that converged, the best first."""
    return sorted((fit for fit in fits if fit is not None), key=lambda fit: fit.left)


def _list_alike(fits: list[Fit], rule: Rule) -> list[Fit]:
    """Return the best offset, and those far from it and from each other with residuals nearly as small."""
    best = fits[0]
    limit = LIMITS.rival * max(best.left, LIMITS.min_noise)
    apart = max(SEARCH.turn / rule.speed, 10.0 * best.error)
    alike: list[Fit] = [best]
    for fit in fits[1:]:
        if fit.left < limit and all(abs(fit.offset - other.offset) > apart for other in alike):
            alike.append(fit)
    return alike


def _pick(fits: list[Fit], rule: Rule) -> Fit | None:
    """Return the offset that fits, of several the wanted one; None where they are ambiguous."""
    alike = _list_alike(fits, rule)
    near = rule.wanted.near
    if len(alike) == 1 or near is None:
        return alike[0] if len(alike) == 1 else None
    first, second = sorted(alike, key=lambda fit: abs(fit.offset - near))[:2]
    return first if abs(first.offset - near) < LIMITS.nearest * abs(second.offset - near) else None


def _choose(fits: list[Fit], rule: Rule) -> Fit:
    """Return the offset that fits, of several the wanted one.

    Raises:
        InvalidInput: where they are ambiguous, with all that fit.
    """
    best = _pick(fits, rule)
    if best is not None:
        return best
    alike = sorted(_list_alike(fits, rule), key=lambda fit: fit.offset)
    word, near = rule.wanted.word, rule.wanted.near
    least = "at least " if rule.missed > min(fit.share for fit in alike) - SEARCH.coarse_loss else ""
    listed = f"{', '.join(word(fit.offset) for fit in alike[:-1])} and {word(alike[-1].offset)} s"
    left = [f"{choice(fit.left for fit in alike):.2g}" for choice in (min, max)]
    span = left[0] if left[0] == left[1] else f"{left[0]} to {left[1]}"
    more = "; others, as good, were not looked at" if least else ""
    open_still = "" if near is None else f" No one of them is clearly the nearest to {word(near)} s."
    raise InvalidInput(
        f"the offset of the clocks is ambiguous, as the motion nearly repeats itself: {least}{len(alike)} offsets fit "
        f"nearly as well as each other, {listed}, and leave {span} rad rms{more}.{open_still} Say about where the "
        f'right one lies by `offset`, like `offset="{word(alike[0].offset)}s"`: beside `align_clock=True`, the nearest '
        "is taken."
    )


def _take(samples: Samples, count: int) -> Samples:
    """Return a number of samples, evenly chosen."""
    length = len(samples.times)
    chosen = np.unique(np.linspace(0, length - 1, min(length, count)).round().astype(int))
    return Samples(samples.times[chosen], samples.attitude[chosen])


def _spread(attitude: Array) -> float:
    """Return the angle between attitudes (T, 4) and their mean, root mean square [rad]."""
    mean = np.linalg.eigh(attitude.T @ attitude)[1][:, -1]
    return float(np.sqrt(np.mean(rotation.angle_between(attitude, mean) ** 2)))


def _offsets(motion: Moving, times: Array, speed: float) -> Array:
    """Return the offsets to try, those at which half of the shorter history overlaps."""
    length = min(motion.last - motion.first, float(times[-1] - times[0]))
    first = motion.first - float(times[-1]) + LIMITS.min_overlap * length
    last = motion.last - float(times[0]) - LIMITS.min_overlap * length
    count = int(np.clip(np.ceil((last - first) * speed / SEARCH.turn), 1, SEARCH.max_offsets)) + 1
    return np.linspace(first, last, count)


def _search(motion: Moving, samples: Samples, grid: Array, free: bool, near: float | None) -> tuple[list[Fit], float]:
    """Return the most promising offsets, local maxima of the agreement over a grid of them, and the best agreement of
    those left out. Where one is near the wanted, half of them are the nearest.
    """
    share = _agreement(motion, samples, grid, free)
    padded = np.concatenate([[-2.0], share, [-2.0]])
    peaks = np.flatnonzero((share >= padded[:-2]) & (share >= padded[2:]) & (share >= 0.0))
    peaks = peaks[np.argsort(share[peaks])[::-1]]
    some, rest = peaks[:SEARCH.candidates], peaks[SEARCH.candidates:]
    if near is not None and len(rest):
        half = SEARCH.candidates // 2
        others = peaks[half:]
        order = np.argsort(np.abs(grid[others] - near), kind="stable")
        some, rest = np.concatenate([peaks[:half], others[order[:half]]]), others[order[half:]]
    starts = [Fit(float(grid[k]), (free, False), float(share[k])) for k in some]
    return starts, float(np.max(share[rest], initial=0.0))


def _agreement(motion: Moving, samples: Samples, grid: Array, free: bool) -> Array:
    """Return the mean square cosine of half the residual angle at each offset; -1 where too little overlaps."""
    times, attitude = samples
    step = float(grid[1] - grid[0]) if len(grid) > 1 else 1.0
    places = np.round((times - times[0]) / step).astype(int)
    begin = float(grid[0] + times[0])
    known = begin + step * np.arange(len(grid) + places[-1] + 1)
    inside = (known >= motion.first) & (known <= motion.last) if motion.is_bounded else np.ones(len(known), dtype=bool)
    values = np.zeros((len(known), 4))
    values[inside] = motion.at(known[inside])[0]
    agreement, weight = np.zeros(len(grid)), np.zeros(len(grid))
    sums = np.zeros((len(grid), 4, 4)) if free else None
    for place, quaternion in zip(places, attitude, strict=True):
        there, ok = values[place : place + len(grid)], inside[place : place + len(grid)]
        weight += ok
        if sums is None:
            agreement += (there @ quaternion) ** 2
        else:
            product = rotation.multiply(np.where(ok[:, None], there, ONE), rotation.conjugate(quaternion))
            sums += ok[:, None, None] * product[:, :, None] * product[:, None, :]
    if sums is not None:
        agreement = np.linalg.eigvalsh(sums)[:, -1]
    return np.where(weight >= LIMITS.min_overlap * len(times), agreement / np.maximum(weight, 1), -1.0)


class _Laid(NamedTuple):
    """Samples laid over the motion: residuals (N, 3), and their derivatives by the offset, S and M (N, 3, n)."""

    left: Array
    by_offset: Array
    by_space: Array
    by_body: Array

    def columns(self, free: tuple[bool, bool]) -> Float64[Array, "rows turns"]:
        """Return the effect of the turns that are free, (3 N, n)."""
        blocks = [block for block, is_free in zip((self.by_space, self.by_body), free, strict=True) if is_free]
        return np.concatenate([np.zeros((len(self.left), 3, 0)), *blocks], axis=2).reshape(3 * len(self.left), -1)


def _lay(motion: Moving, samples: Samples, fit: Fit, is_new: bool) -> tuple[_Laid, Fit] | None:
    """Return the residuals at an offset, and the fit, with a first S where it has none; None where little overlaps."""
    moved, count = samples.times + fit.offset, len(samples.times)
    inside = (moved >= motion.first) & (moved <= motion.last) if motion.is_bounded else np.ones(count, dtype=bool)
    if inside.sum() < LIMITS.min_overlap * count or inside.sum() < 3:
        return None
    there, velocity = motion.at(moved[inside])
    here = samples.attitude[inside]
    if is_new and fit.free == (True, False):
        products = rotation.multiply(there, rotation.conjugate(here))
        fit = fit._replace(space=np.linalg.eigh(products.T @ products)[1][:, -1])
    here = rotation.multiply(rotation.multiply(fit.space, here), fit.body)
    left = rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(here), there))
    by_space = -np.swapaxes(rotation.as_matrix(there), 1, 2)
    return _Laid(left, velocity[:, :, None], by_space, np.broadcast_to(-np.eye(3), by_space.shape)), fit


def _refine(motion: Moving, samples: Samples, fit: Fit) -> Fit | None:
    """Return a fit improved from a start; None if it leaves the span, does not converge, or turns body axes too far."""
    usual = float(np.median(np.diff(samples.times)))
    for k in range(SEARCH.max_rounds):
        known = _lay(motion, samples, fit, k == 0)
        if known is None:
            return None
        laid, fit = known
        first, others = laid.by_offset.reshape(-1), laid.columns(fit.free)
        speed = float(np.sqrt(np.mean(first**2))) or 1.0
        alone = first - others @ np.linalg.lstsq(others, first, rcond=LIMITS.same_effect)[0]
        rms, spare = root_mean_square(laid.left), float(len(first) - 1 - others.shape[1])
        determined = alone @ alone > LIMITS.min_information_left * (first @ first)
        error = rms * np.sqrt(len(laid.left) / (spare * (alone @ alone))) if determined else np.inf
        fit = fit._replace(left=rms, error=float(error), spare=spare)
        if not determined:
            return fit
        design = np.concatenate([first[:, None] / speed, others], axis=1)
        step = np.linalg.lstsq(design, -laid.left.reshape(-1), rcond=LIMITS.same_effect)[0]
        move, turns = float(step[0]) / speed, step[1:]
        resolved = LIMITS.settled_step * usual + 4.0 * np.spacing(abs(fit.offset))
        if abs(move) < resolved and np.abs(turns).max(initial=0.0) < LIMITS.settled_turn:
            return fit
        fit = _step(fit, move, turns)
        if fit.free[1] and rotation.angle_between(fit.body, ONE) > LIMITS.max_residual:
            return None
    return fit if fit.left < LIMITS.max_residual else None


def _step(fit: Fit, move: float, turns: Array) -> Fit:
    """Return a fit moved by a step of its offset and of those turns that are free."""
    space, body = fit.space, fit.body
    if fit.free[0]:
        space = rotation.normalize(rotation.multiply(rotation.from_rotation_vector(turns[:3]), space))
    if fit.free[1]:
        body = rotation.normalize(rotation.multiply(body, rotation.from_rotation_vector(turns[-3:])))
    return fit._replace(offset=fit.offset + move, space=space, body=body)


def _find_lean(motion: Moving, samples: Samples, fit: Fit, new: tuple[bool, bool]) -> float:
    """Return the turn [rad] of axes that are not fitted, where the residuals show one, else 0."""
    known = _lay(motion, samples, fit, False)
    if known is None or not any(new):
        return 0.0
    laid, _ = known
    others = np.concatenate([laid.by_offset.reshape(-1, 1), laid.columns(fit.free)], axis=1)
    added, left = laid.columns(new), laid.left.reshape(-1)
    added = added - others @ np.linalg.lstsq(others, added, rcond=LIMITS.same_effect)[0]
    turns = np.linalg.lstsq(added, left, rcond=LIMITS.same_effect_alone)[0]
    explained = float(np.sum((added @ turns) ** 2))
    noise = max((float(left @ left) - explained) / max(fit.spare - len(turns), 1.0), LIMITS.min_noise**2)
    return float(np.linalg.norm(turns)) if explained > LIMITS.min_improvement * noise else 0.0
