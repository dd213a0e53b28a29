"""The noise of sampled attitudes, from differences of neighbouring samples that no smooth motion leaves."""

from __future__ import annotations

from math import comb
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.types import Array, Float64


class AttitudeNoiseLimits(NamedTuple):
    """Numbers that decide whether samples allow an estimate of their noise."""

    min_samples: int = 40  # fewer leave differences of high order no mean
    max_unevenness: float = 0.2  # of the median step, by which steps may differ
    max_turn: float = 1.0  # rad between samples; differences of longer rotation vectors are not small


LIMITS = AttitudeNoiseLimits()


def root_mean_square(vectors: Float64[Array, "... n"]) -> float:
    """Return the root mean square length of vectors (…, n)."""
    return float(np.sqrt(np.mean(np.sum(vectors * vectors, axis=-1))))


def attitude_noise(times: Float64[Array, "time"], attitude: Float64[Array, "time 4"]) -> float | None:
    """Return the root mean square angle [rad] by which samples (T, 4) scatter about a smooth motion; None if unknown.

    Printed digits are noise as well. Differences of order n of a smooth motion shrink with each order where it is
    sampled well, and those of independent noise σ have the variance C(2n, n) σ²; the least of several orders is taken.
    Where the motion is not sampled well, the estimate is above the noise.

    Source: von Neumann et al., Ann. Math. Stat. 12 (1941) 153, for first differences.
    """
    steps = np.diff(times)
    if len(times) < LIMITS.min_samples or np.ptp(steps) > LIMITS.max_unevenness * np.median(steps):
        return None
    turns = rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(attitude[:-1]), attitude[1:]))
    if np.linalg.norm(turns, axis=-1).max() > LIMITS.max_turn:
        return None
    orders = range(3, 11)  # of differences: a motion that turns by 0.1 rad between samples leaves 1e-10 of the tenth
    return min(
        float(np.sqrt(np.mean(np.sum(np.diff(turns, n=order, axis=0) ** 2, axis=-1)) / comb(2 * order + 2, order + 1)))
        for order in orders
    )
