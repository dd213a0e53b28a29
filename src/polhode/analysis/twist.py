"""The tennis racket's twist: how far a body turns about its handle while the handle turns once about L.

With handle h and the next two axes j, k, the handle's azimuth about L grows at |L| (L_j²/I_j + L_k²/I_k)/(L_j² + L_k²)
and the twist is the change of atan2(L_k, L_j). Whole polhode periods are counted, the rest is integrated, and the
attitude, which gives the azimuth up to whole turns without any integral, checks and sharpens the end.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.arrays import known_numbers_only
from polhode._base.extras import needing
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.exact.free_body import FreeMotion
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory
from polhode.types import Array

TURN = 2.0 * math.pi
NODES, NODE_WEIGHTS = np.polynomial.legendre.leggauss(12)


class TwistLimits(NamedTuple):
    """Numbers that decide whether the handle was followed."""

    max_refinements: int = 3  # each with 16 times as many segments: a needle may hurry past its handle
    quadrature_error: float = 1e-12  # of a turn; the end is sharpened by the attitude anyway
    # rad between integral and attitude: far above the first's error, far below a missed feature
    max_disagreement: float = 1e-6


LIMITS = TwistLimits()


@known_numbers_only
def racket_twist(motion: FreeMotion | Trajectory, handle: int = 0) -> float:
    """Return the twist [rad] about the handle while its azimuth about L turns once, the tennis-racket experiment.

    The experiment is often said to give half a turn, and does so only for some throws.

    Args:
        motion: one body's, or samples of it.
        handle: index 0, 1, 2 of the principal axis that is the handle.

    Raises:
        InvalidInput: for a batch, a body at rest, or one that spins exactly about its handle.
        NotConverged: if the turn is too uneven to be followed.

    Source: Ashbaugh, Chicone & Cushman, J. Dyn. Differ. Equ. 3 (1991) 67.

    >>> racket = FreeMotion((0.00121, 0.01638, 0.01748), momentum=(0.1 * 0.00121, 0.01638, 0.0))
    >>> round(math.degrees(racket_twist(racket)), 1)
    166.3
    """
    free = motion.motion if isinstance(motion, Trajectory) else motion
    if not isinstance(free, FreeMotion):
        origin = f" of a {type(motion.source).__name__}" if isinstance(motion, Trajectory) else ""
        raise InvalidInput(f"`motion` must be a FreeMotion or samples of one; got a {type(motion).__name__}{origin}.")
    return _twist(free.along("principal"), handle)


def _twist(motion: FreeMotion, handle: int) -> float:
    segments = 256  # of one period, before they are refined
    start = np.asarray(motion.momentum_at_epoch)
    if start.ndim != 1 or np.ndim(motion.epoch):
        raise InvalidInput(f"`motion` must be of one body; got momentum of shape {start.shape}. Take one at a time.")
    if handle not in (0, 1, 2):
        raise InvalidInput(f"`handle` must be the index 0, 1 or 2 of a principal axis; got {shown(handle)}.")
    j, k = (handle + 1) % 3, (handle + 2) % 3
    if not (start[j] or start[k]):
        raise InvalidInput("the twist needs a handle that is not along L; tilt the spin away from the handle.")
    moments = np.asarray(motion.moments)
    longest = TURN * float(max(moments[j], moments[k])) / float(motion.momentum_norm)

    def rates(t: Array) -> np.ndarray:
        return _rates(motion.momentum(float(motion.epoch) + t), moments, handle)

    for refinement in range(LIMITS.max_refinements):
        edges = _first_edges(motion, longest, segments * 16**refinement)
        end, twist = _one_turn(rates, edges, finite(motion.period))
        late = _azimuth(motion, handle, end)
        if abs(late) < LIMITS.max_disagreement:
            end -= late / rates(np.asarray(end))[0]
            return abs(_exact_twist(motion, j, k, end, twist))
    raise NotConverged("the handle's turn about L is too uneven to be followed; its moments are too far apart.")


def _rates(L: Array, moments: Array, h: int) -> np.ndarray:
    """Return the rates (2, …) of the handle's azimuth about L and of the angle of L about the handle [rad/s]."""
    j, k = (h + 1) % 3, (h + 2) % 3
    largest = np.maximum(np.abs(L[..., j]), np.abs(L[..., k]))
    a, b = (L[..., j] / largest) ** 2, (L[..., k] / largest) ** 2
    # the azimuth by the module's formula; atan2(L_k, L_j) by Euler's equations L̇_j = L_k L_h (1/I_h − 1/I_k),
    # L̇_k = L_h L_j (1/I_j − 1/I_h); squares over the larger, which cannot underflow
    across = (a / moments[j] + b / moments[k]) / (a + b)
    return np.stack([np.linalg.norm(L, axis=-1) * across, L[..., h] * (across - 1.0 / moments[h])])


def _first_edges(motion: FreeMotion, longest: float, count: int) -> np.ndarray:
    """Return edges of segments over one period or the longest possible turn, fine where L changes."""
    flipped = 1000.0  # e-folding times: a start next to the saddle, down to the smallest numbers, has flipped by then
    period = finite(motion.period)
    if period is not None:
        return np.linspace(0.0, min(period, longest), count + 1)
    if motion.regime != "separatrix":
        return np.array([0.0, longest])
    low, middle, high = np.sort(np.asarray(motion.moments))
    # the time constant at the saddle, I₂/(|L| √((I₂ − I₁)(I₃ − I₂)/(I₁ I₃)))
    fold = float(middle / (motion.momentum_norm * np.sqrt((middle - low) / low * ((high - middle) / high))))
    return np.append(np.linspace(0.0, min(longest, flipped * fold), count + 1), longest * (1.0 + 1e-12))


def _one_turn(rates: Callable[[Array], np.ndarray], edges: np.ndarray, period: float | None) -> tuple[float, float]:
    """Return the time at which the azimuth has grown by one turn, and the twist by then."""
    edges, parts = _integrals(rates, edges)
    azimuth, twist = np.cumsum(parts, axis=1)
    before_time, before_azimuth, before_twist = 0.0, 0.0, 0.0
    if azimuth[-1] < TURN and edges[-1] == period:
        # L is back after a period, so that the twist is whole turns then. Edges that end before it span the longest
        # possible turn, of which rounding alone leaves less than a turn
        periods = math.floor(TURN / azimuth[-1])
        before_time, before_azimuth = periods * period, periods * azimuth[-1]
        before_twist = periods * TURN * round(twist[-1] / TURN)
    wanted = TURN - before_azimuth
    n = min(int(np.searchsorted(azimuth, wanted)), len(azimuth) - 1)
    left = edges[n]
    gained = parts[:, :n].sum(axis=1)

    with needing("The twist needs", alone=True):
        from scipy.optimize import brentq

    def rest(t: float) -> float:
        return float(gained[0] + _gauss(rates, np.array([left]), np.array([t]))[0, 0] - wanted)

    right = edges[n + 1]
    end: Any = brentq(rest, left, right) if rest(left) < 0.0 < rest(right) else (left if rest(left) >= 0.0 else right)
    twisted = gained[1] + _gauss(rates, np.array([left]), np.array([end]))[1, 0]
    return before_time + float(end), float(before_twist + twisted)


def _integrals(rates: Callable[[Array], np.ndarray], edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return edges split until each segment's Gauss sum agrees with its halves', and the integrals (2, segments)."""
    max_splits = 40
    left, right = edges[:-1], edges[1:]
    parts = _gauss(rates, left, right)
    open_ = np.ones(len(left), dtype=bool)
    for _ in range(max_splits):
        if not open_.any():
            break
        a, c = left[open_], right[open_]
        b = 0.5 * (a + c)
        first, second = _gauss(rates, a, b), _gauss(rates, b, c)
        wrong = np.abs(first + second - parts[:, open_]).max(axis=0) > LIMITS.quadrature_error * TURN
        left = np.concatenate([left[~open_], a, b])
        right = np.concatenate([right[~open_], b, c])
        parts = np.concatenate([parts[:, ~open_], first, second], axis=1)
        open_ = np.concatenate([np.zeros(len(left) - 2 * len(a), dtype=bool), wrong, wrong])
    order = np.argsort(left)
    return np.append(left[order], right[order][-1]), parts[:, order]


def _gauss(rates: Callable[[Array], np.ndarray], left: np.ndarray, right: np.ndarray) -> np.ndarray:
    half = 0.5 * (right - left)
    times = 0.5 * (left + right)[:, None] + half[:, None] * NODES
    return np.sum(rates(times) * NODE_WEIGHTS, axis=-1) * half


def _azimuth(motion: FreeMotion, handle: int, t: float) -> float:
    """Return the handle's azimuth about L since the epoch, in (−π, π]."""
    axis = np.eye(3)[handle]
    attitude, momentum = motion.state(float(motion.epoch))
    normal = rotation.rotate(attitude, momentum / np.abs(momentum).max())
    normal = normal / np.linalg.norm(normal)
    first = rotation.rotate(attitude, axis)
    now = rotation.rotate(motion.attitude(float(motion.epoch) + t), axis)
    across = np.cross(normal, first)
    return math.atan2(float(now @ across), float(now @ np.cross(across, normal)))


def _exact_twist(motion: FreeMotion, j: int, k: int, end: float, twist: float) -> float:
    """Return the twist from L itself, with the whole turns of the integral."""
    start, last = np.asarray(motion.momentum_at_epoch), motion.momentum(float(motion.epoch) + end)
    change = math.atan2(last[k], last[j]) - math.atan2(start[k], start[j])
    return float(change + TURN * round((twist - change) / TURN))
