"""The offset between the clocks of two attitude histories, where their attitudes show it.

The histories are laid over each other at all offsets, first with their axes as given, then with the axes of space of
one turned by a constant, as a log without a compass has them. The best offset is refined by Gauss and Newton's steps.
Where another fits nearly as well, the motion looks alike at all times, or the samples turn too little to tell an
offset, none is returned.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis._attitude_noise import root_mean_square
from polhode.errors import InvalidInput
from polhode.types import Array, Float64

TURN = 0.2  # rad between offsets that are tried first
MOST_OFFSETS = 100_000
SEEN, USED = 48, 1500  # samples that the search and the refinement look at
CANDIDATES = 12  # offsets that are refined
ROUNDS = 25
SETTLED = 1e-13  # of the usual step between samples
ALIKE = 3.0  # times what the best offset leaves: one that leaves less may be the right one
FITS = 0.3  # rad, rms; what leaves more is another motion
EXPLAINED = 0.3  # of how far the samples turn, rms; what leaves more does not follow them, however little it is
KNOWN = 0.1  # of the span that offsets are sought in; an error that is larger leaves them all possible
BLURRED = 1e-6  # of the information on an offset; where less is left beside a turned space, the motion has none
LEAST_NOISE = 1e-12  # rad, rms; rounding, below which residuals are not compared
OVERLAP = 0.5  # of the shorter history

STILL = "the attitude does not change, so that it shows no offset of the clocks"

Evaluate = Callable[[Float64[Array, "time"]], tuple[Float64[Array, "time 4"], Float64[Array, "time 3"]]]
"""Attitudes and angular velocities [rad/s, body axes] at times."""


class Moving(NamedTuple):
    """A history that can be evaluated at any time within a span.

    Attributes:
        at: evaluates it.
        first, last: the span [s].
        is_bounded: whether it is not known beyond.
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
        turned: whether the axes of space had to be turned by a constant.
    """

    offset: float
    error: float
    left: float
    turned: bool


def find_clock_offset(
    motion: Moving, times: Float64[Array, "time"], attitude: Float64[Array, "time 4"], speed: float
) -> ClockOffset:
    """Return the time of a motion at the time zero of samples (T, 4).

    Args:
        motion: what the samples are of.
        times: of the samples [s].
        attitude: body → space.
        speed: how fast the body turns at most [rad/s].

    Raises:
        InvalidInput: where no offset makes them agree, several do, or the motion does not determine it.
    """
    if not speed > 0.0:
        raise InvalidInput(f"{STILL}. Say it by `offset`.")
    some = np.unique(np.linspace(0, len(times) - 1, min(len(times), SEEN)).round().astype(int))
    many = np.unique(np.linspace(0, len(times) - 1, min(len(times), USED)).round().astype(int))
    grid = _offsets(motion, times, speed)
    nearest, turns = None, _spread(attitude[many])
    for turned in (False, True):
        starts = _search(motion, times[some], attitude[some], grid, turned)
        fits = [_refine(motion, times[many], attitude[many], start, turned) for start in starts]
        fits = sorted((fit for fit in fits if fit is not None), key=lambda fit: fit.left)
        if not fits:
            continue
        best = fits[0]
        nearest = best if nearest is None or best.left < nearest.left else nearest
        if best.left > FITS:
            continue
        if not np.isfinite(best.error):
            steady = "the body turns steadily, so that with other axes of space any offset fits" if turned else STILL
            raise InvalidInput(f"{steady}. Say it by `offset`.")
        if best.left > EXPLAINED * turns:
            continue
        _check_single(best, fits[1:], speed)
        if best.error > KNOWN * (grid[-1] - grid[0]):
            raise InvalidInput(
                f"the attitudes do not determine the offset of the clocks: the best is {best.offset:.6g} ± "
                f"{best.error:.2g} s, and its error must be at most a tenth of the {grid[-1] - grid[0]:.6g} s that it "
                "is sought in. Say it by `offset`, or give a log that turns further."
            )
        return best
    raise InvalidInput(f"no offset of the clocks makes the two agree{_word_nearest(nearest, turns)}. Check that both "
                       "are along the same body axes, or say the offset by `offset`.")  # fmt: skip


def _word_nearest(nearest: ClockOffset | None, turns: float) -> str:
    """Return how well the best offset fits samples that turn so far [rad, rms], after a colon; "" without one."""
    if nearest is None:
        return ""
    turned = ", with the axes of space turned by a constant" if nearest.turned else ""
    return (f": the best, {nearest.offset:.6g} s{turned}, leaves {nearest.left:.2g} rad rms, and the samples turn by "
            f"{turns:.2g} rad rms")  # fmt: skip


def _check_single(best: ClockOffset, others: list[ClockOffset], speed: float) -> None:
    """Refuse an offset that is not the only one.

    Raises:
        InvalidInput: where others, far from it, leave nearly as little.
    """
    limit = ALIKE * max(best.left, LEAST_NOISE)
    apart = max(TURN / speed, 10.0 * best.error)
    also = [fit for fit in others if fit.left < limit and abs(fit.offset - best.offset) > apart]
    if also:
        named = " and ".join(f"{fit.offset:.6g} s, {fit.left:.2g} rad" for fit in also[:3])
        raise InvalidInput(
            f"the offset of the clocks is ambiguous, as the motion nearly repeats itself: {best.offset:.6g} s "
            f"leaves {best.left:.2g} rad rms, and so nearly do {named}. Say the right one by `offset`."
        )


def _spread(attitude: Array) -> float:
    """Return the angle between attitudes (T, 4) and their mean, root mean square [rad]."""
    mean = np.linalg.eigh(attitude.T @ attitude)[1][:, -1]
    return float(np.sqrt(np.mean(rotation.angle_between(attitude, mean) ** 2)))


def _offsets(motion: Moving, times: Array, speed: float) -> Array:
    """Return the offsets to try, those at which half of the shorter history overlaps."""
    length = min(motion.last - motion.first, float(times[-1] - times[0]))
    first = motion.first - float(times[-1]) + OVERLAP * length
    last = motion.last - float(times[0]) - OVERLAP * length
    count = int(np.clip(np.ceil((last - first) * speed / TURN), 1, MOST_OFFSETS)) + 1
    return np.linspace(first, last, count)


def _search(motion: Moving, times: Array, attitude: Array, grid: Array, turned: bool) -> list[float]:
    """Return the most promising offsets, local maxima of the agreement over a grid of them."""
    step = float(grid[1] - grid[0]) if len(grid) > 1 else 1.0
    places = np.round((times - times[0]) / step).astype(int)
    begin = float(grid[0] + times[0])
    known = begin + step * np.arange(len(grid) + places[-1] + 1)
    inside = (known >= motion.first) & (known <= motion.last) if motion.is_bounded else np.ones(len(known), dtype=bool)
    values = np.zeros((len(known), 4))
    values[inside] = motion.at(known[inside])[0]
    agreement, weight = np.zeros(len(grid)), np.zeros(len(grid))
    sums = np.zeros((len(grid), 4, 4)) if turned else None
    for place, quaternion in zip(places, attitude, strict=True):
        there, ok = values[place : place + len(grid)], inside[place : place + len(grid)]
        weight += ok
        if sums is None:
            agreement += (there @ quaternion) ** 2
        else:
            product = rotation.multiply(np.where(ok[:, None], there, [1.0, 0, 0, 0]), rotation.conjugate(quaternion))
            sums += ok[:, None, None] * product[:, :, None] * product[:, None, :]
    if sums is not None:
        agreement = np.linalg.eigvalsh(sums)[:, -1]
    share = np.where(weight >= OVERLAP * len(times), agreement / np.maximum(weight, 1), -1.0)
    padded = np.concatenate([[-2.0], share, [-2.0]])
    peaks = np.flatnonzero((share >= padded[:-2]) & (share >= padded[2:]) & (share >= 0.0))
    best = peaks[np.argsort(share[peaks])[::-1][:CANDIDATES]]
    return [float(grid[k]) for k in best]


def _refine(motion: Moving, times: Array, attitude: Array, offset: float, turned: bool) -> ClockOffset | None:
    """Return an offset improved from a start; None where it leaves the span, or does not converge."""
    space = np.array([1.0, 0.0, 0.0, 0.0])
    usual = float(np.median(np.diff(times)))
    error = rms = np.inf
    for k in range(ROUNDS):
        moved = times + offset
        inside = (moved >= motion.first) & (moved <= motion.last) if motion.is_bounded else np.ones(len(times), bool)
        if inside.sum() < OVERLAP * len(times) or inside.sum() < 3:
            return None
        there, velocity = motion.at(moved[inside])
        here = attitude[inside]
        if turned and k == 0:
            products = rotation.multiply(there, rotation.conjugate(here))
            space = np.linalg.eigh(products.T @ products)[1][:, -1]
        here = rotation.multiply(space, here)
        left = rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(here), there))
        columns = [velocity[:, :, None]]
        if turned:
            columns.append(-np.swapaxes(rotation.as_matrix(there), 1, 2))
        design = np.concatenate(columns, axis=2).reshape(-1, 4 if turned else 1)
        normal = design.T @ design
        # what the space's turn leaves of it; that block of the normal equations is the number of samples times 1
        seen = normal[0, 0] - normal[0, 1:] @ normal[0, 1:] / len(left)
        determined = seen > BLURRED * normal[0, 0]
        step = np.linalg.lstsq(design, -left.reshape(-1), rcond=None)[0]
        rms = root_mean_square(left)
        spare = 3.0 - design.shape[1] / len(left)  # numbers of a sample, but for what they are fitted by
        error = rms / np.sqrt(spare * seen) if determined else np.inf
        if not determined:
            return ClockOffset(offset, np.inf, rms, turned)
        if abs(step[0]) < SETTLED * usual + 4.0 * np.spacing(abs(offset)):
            return ClockOffset(offset, error, rms, turned)
        offset += float(step[0])
        if turned:
            space = rotation.normalize(rotation.multiply(rotation.from_rotation_vector(step[1:]), space))
    return ClockOffset(offset, error, rms, turned) if rms < FITS else None
