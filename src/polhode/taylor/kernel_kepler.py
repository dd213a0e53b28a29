"""Kepler's equation E − e sin E = M at one place of an orbit; how E goes on from there is in ``kernel_series``."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from polhode._base.compiled.copying import called

TURN = 2.0 * math.pi


@called
def eccentric_anomaly_at(mean_anomaly: Any, eccentricity: Any) -> Any:
    """Return E of M, both growing without bound; see ``kepler_orbit.solve_kepler`` for the start and its equation."""
    largest = 1e300
    if not abs(mean_anomaly) < largest:
        return np.nan
    turns = TURN * math.floor(mean_anomaly / TURN + 0.5)
    m, e = abs(mean_anomaly - turns), eccentricity
    x = min(min(m + e, m / (1.0 - e)), min((math.pi * math.pi * m / e) ** (1.0 / 3.0), math.pi))
    for _ in range(6):  # Newton comes within three roundings by five steps for any e < 1
        sine = math.sin(0.5 * x)
        # Newton for (1−e) x + e (x − sin x) = m, with the slope 1 − e cos x
        x -= (((1.0 - e) * x - m) + e * less_sine(x)) / ((1.0 - e) + 2.0 * e * sine * sine)
    x = max(x, 0.0)
    return turns + (x if mean_anomaly >= turns else -x)


def less_sine(x: Any) -> Any:
    """Return x − sin x to its last digits, of a positive number."""
    if x >= 1.0:
        return x - math.sin(x)
    term, total = x, 0.0
    for k in range(1, 10):  # enough up to one radian
        # x − sin x = Σ_{k≥1} −(−1)^k x^(2k+1)/(2k+1)!
        term *= -x * x / ((2 * k) * (2 * k + 1))
        total -= term
    return total
