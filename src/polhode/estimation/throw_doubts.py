"""When a fit of throws is no result: estimates where no body or gyro is, and motions that explain nothing."""

from __future__ import annotations

import numpy as np

from polhode.estimation.principal import Principal, why_undetermined
from polhode.estimation.throw_fit import Solution, Throw
from polhode.estimation.throw_search import at_bound
from polhode.types import Array

UNEXPLAINED = 0.2  # of the rates, that residuals may be
FAR = 10.0  # times what a bias or a gain was known by beforehand
IMPOSSIBLE = 3.0  # standard errors, by which a body may miss I1 + I2 ≥ I3
CALLED = {"drag": "drag", "linear_drag": "linear drag", "one_sided_drag": "one-sided drag", "shape": "shape"}


def why_nothing_explains(solution: Solution, throws: list[Throw]) -> str | None:
    """Return that residuals are hardly smaller than the rates themselves, in a sentence, or None."""
    rates = np.concatenate([throw.rates for throw in throws])
    size, left = _rms(rates - rates.mean(axis=0)), _rms(solution.residuals)
    if left < UNEXPLAINED * size:
        return None
    return (f"no motion that was tried explains the rates: {left:.3g} rad/s of {size:.3g} rad/s are left. The rates "
            "may be of another unit, like deg/s, or the stretch no free flight.")  # fmt: skip


def why_no_result(solution: Solution, found: Principal, throws: list[Throw]) -> str | None:
    """Return why a fit says nothing of the inertia, in a sentence, or None where it does.

    Args:
        solution: of the model that was chosen.
        found: what it says of moments and axes.
        throws: the samples.
    """
    bound = at_bound(solution)
    if bound is not None:
        return (f"the fit ended at a bound of the {CALLED[bound]}, where no body is: the motion is another one than "
                "those that were tried, or the stretch is no free flight.")  # fmt: skip
    far = _far_from_expected(solution)
    if far is not None:
        return far
    if not found.determined:
        return why_undetermined([throw.rates for throw in throws], found)
    return _impossible(found)


def _far_from_expected(solution: Solution) -> str | None:
    which, means, weights = solution.model.believed()
    spread = np.sqrt(np.diagonal(np.linalg.inv(weights.T @ weights)))
    for name, what, unit in (("bias", "bias", " rad/s"), ("gain", "gain", ""), ("cross_axis", "cross-axis gain", "")):
        if name not in solution.model.places:
            continue
        place = solution.model.places[name]
        at = np.flatnonzero((which >= place.start) & (which < place.stop))
        off = np.abs(solution.parameters[place] - means[at]) / spread[at]
        if off.max() > FAR:
            k = int(np.argmax(off))
            value = solution.parameters[place][k]
            return (f"the fit needs a {what} of {value:.3g}{unit}, and {means[at][k]:.3g} ± {spread[at][k]:.2g} was "
                    "known beforehand: the motion is another one than those that were tried, the rates are of another "
                    "unit, or the stretch is no free flight.")  # fmt: skip
    return None


def _impossible(found: Principal) -> str | None:
    """Return why no body has such moments."""
    for name, (low, high) in zip(found.ratios.names, found.ratios.interval().tolist(), strict=True):
        if low <= 0.0:
            return (f"the interval of {name}, {low:.2g} to {high:.2g}, reaches zero, which no moment is. Throw it "
                    "longer, or with more tumble.")  # fmt: skip
    flat = float(found.ratios.value.sum() - 1.0)
    error = float(np.sqrt(found.ratios.covariance.sum()))
    if flat < -IMPOSSIBLE * error:
        return (f"I1 + I2 would be less than I3 by {-flat:.2g} ± {error:.2g} of it, which no body is: the motion is "
                "another one than those that were tried, or the stretch is no free flight.")  # fmt: skip
    return None


def _rms(x: Array) -> float:
    return float(np.sqrt(np.mean(x * x)))
