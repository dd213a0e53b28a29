"""Exponents of power laws from samples of a motion, with their uncertainty.

The samples are exact, but a law is only approached: the residuals of a fit are not noise. Exponents are therefore those
of the second half of the samples, which is nearer to the law, and their uncertainty is half of the difference between
the fits of both halves, or the standard error where that is larger.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from polhode.types import Array, Float64


@dataclass(frozen=True)
class PowerLaw:
    """y ∝ x^n.

    Attributes:
        exponent: n.
        uncertainty: of n, see above.
        samples: how many were fitted.
    """

    exponent: float
    uncertainty: float
    samples: int


class Singularity(NamedTuple):
    """y ∝ (t0 − t)^n, or with n < 0 y ∝ (t − t0)^n, of unknown t0.

    Attributes:
        law: exponent and its uncertainty.
        distance: |t0 − t| of the last sample, or of the first one if n < 0 [s].
        uncertainty: of that [s].
    """

    law: PowerLaw
    distance: float
    uncertainty: float


def power_law(x: Float64[Array, "n"], y: Float64[Array, "n"]) -> PowerLaw:
    """Return the fit of log y against log x.

    Args:
        x: (n,) positive, monotonic.
        y: (n,) positive.
    """
    p, q = np.log(x), np.log(y)
    half = len(p) // 2
    early, (slope, error, _) = _line(p[:half], q[:half])[0], _line(p[half:], q[half:])
    return PowerLaw(slope, max(error, 0.5 * abs(slope - early)), len(p))


def fit_singularity(spans: Float64[Array, "gaps"], y: Float64[Array, "n"]) -> Singularity:
    """Return the singularity that samples approach, or from which they start if they fall ever more slowly.

    Args:
        spans: (n−1,) [s] from each sample to the next.
        y: (n,) falling.
    """
    ahead = np.append(np.cumsum(spans[::-1])[::-1], 0.0)
    since = np.append(0.0, np.cumsum(spans))
    q = np.log(y)
    misses, rest = _nearest(since, q)[1], _nearest(ahead, q)[1]
    times = ahead if rest <= misses else since
    half = len(q) // 2
    fits, distances = [], []
    for part in (slice(None, half), slice(half, None)):
        own = times[part]
        offset = _nearest(own - own.min(), q[part])[0]
        fits.append(_line(np.log(own - own.min() + offset), q[part]))
        distances.append(offset - own.min())
    (early, *_), (slope, error, _) = fits
    law = PowerLaw(slope, max(error, 0.5 * abs(slope - early)), len(q))
    return Singularity(law, distances[1], 0.5 * abs(distances[0] - distances[1]))


def _nearest(times: Array, q: Array) -> tuple[float, float]:
    """Return the offset d > 0 at which q is most nearly linear in log(times + d), and the sum of squared residuals."""
    count = 400
    reach = 12.0  # e-folds of the samples' span, either way, within which a singularity is sought
    from scipy.optimize import minimize_scalar

    span = np.log(times.max())
    misses = lambda d: _line(np.log(times + np.exp(d)), q)[2]  # noqa: E731
    grid = np.linspace(span - 2.0 * reach, span + reach, count)
    k = int(np.clip(np.argmin([misses(d) for d in grid]), 1, count - 2))
    best: Any = minimize_scalar(misses, bounds=(grid[k - 1], grid[k + 1]), method="bounded", options={"xatol": 1e-12})
    return float(np.exp(best.x)), float(best.fun)


def _line(p: Array, q: Array) -> tuple[float, float, float]:
    """Return the slope of q against p, its standard error, and the sum of squared residuals."""
    x, y = p - p.mean(), q - q.mean()
    size = float(x @ x)
    slope = float(x @ y) / size
    left = float(np.sum((y - slope * x) ** 2))
    return slope, (left / max(len(p) - 2, 1) / size) ** 0.5, left
