"""Precession said in full: which axis, in which frame, at what mean rate, and in which sense."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion

Array = Any
SAMPLES_PER_TURN = 512


class Precession(NamedTuple):
    """A mean rate [rad/s], positive; ``frame`` it is seen in; ``sense`` in words."""

    frame: str
    rate: float
    sense: str


def body_precession(motion: FreeMotion) -> Precession | None:
    """Return how L circles the encircled axis in the body's own frame, at 2π/T.

    For a symmetric body the rate is |I3−I1| ω3/I1: with the spin if the body is oblate, against it if prolate; the
    same senses hold for short-axis and long-axis modes. None where L stays or never returns.
    """
    if motion.period is None:
        return None
    against = motion.encircled_axis == int(np.argmin(np.asarray(motion.moments)))
    sense = "against the spin" if against else "with the spin"
    return Precession("body", 2.0 * math.pi / motion.period, sense)


def space_precession(motion: FreeMotion) -> Precession | None:
    """Return how the encircled axis turns about L in space; always along L. For a symmetric body the rate is |L|/I1."""
    if motion.precession_rate is None or motion.encircled_axis is None:
        return None
    return Precession("space", abs(motion.precession_rate), "along the angular momentum")


def racket_twist(motion: FreeMotion, handle: int = 0) -> float:
    """Return the twist [rad] about the handle while its azimuth about L turns once, the tennis-racket experiment.

    The twist is the change of the angle of L about the handle axis, atan2(L_k, L_j) over the next two axes; the
    experiment is often said to give half a turn, and does so only near the separatrix of a thin racket.

    Args:
        motion: one body.
        handle: index 0, 1, 2 of the principal axis that is the handle.

    Raises:
        InvalidInput: for a body at rest, or one that spins exactly about its handle.

    Source: Ashbaugh, Chicone & Cushman, J. Dyn. Differ. Equ. 3 (1991) 67.
    """
    j, k = (handle + 1) % 3, (handle + 2) % 3
    momentum = np.asarray(motion.momentum_at_epoch)
    if not (momentum[j] or momentum[k]):
        raise InvalidInput("the twist needs a handle that is not along L; tilt the spin away from the handle.")
    moments = np.asarray(motion.moments)
    norm = float(motion.momentum_norm)
    longest = 2.0 * math.pi * max(moments[j], moments[k]) / norm
    # the azimuth's rate lies between |L|/I_j and |L|/I_k, so one turn ends within the longest of both
    fastest = norm / min(moments[0], moments[1], moments[2])
    count = SAMPLES_PER_TURN * math.ceil(1.0 + longest * fastest / (2.0 * math.pi))
    times = np.linspace(0.0, longest * (1.0 + 1e-9), count)

    def angles(t: Array) -> tuple[Array, Array]:
        L = motion.momentum(motion.epoch + t)
        return _azimuth_rate(L, moments, norm, j, k), np.arctan2(L[..., k], L[..., j])

    from scipy.integrate import quad
    from scipy.optimize import brentq

    def turned(t: float) -> float:
        rate = lambda s: float(angles(np.asarray(s))[0])  # noqa: E731
        return quad(rate, 0.0, t, epsabs=1e-12, epsrel=1e-12, limit=500)[0] - 2.0 * math.pi

    shortest = 2.0 * math.pi * min(moments[j], moments[k]) / norm
    end: Any = brentq(turned, shortest * (1.0 - 1e-9), times[-1], xtol=1e-12 * longest)
    path = np.unwrap(angles(np.append(times[times < end], end))[1])
    return float(abs(path[-1] - path[0]))


def _azimuth_rate(L: Array, moments: Array, norm: float, j: int, k: int) -> Array:
    """Return the rate of the handle's azimuth about L, |L| (L_j²/I_j + L_k²/I_k)/(L_j² + L_k²)."""
    a, b = L[..., j] ** 2, L[..., k] ** 2
    return norm * (a / moments[j] + b / moments[k]) / (a + b)
