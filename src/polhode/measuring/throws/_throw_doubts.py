"""Reasons to reject a fit of throws: impossible estimates, and motions that do not explain the data."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.measuring.throws._principal import Principal, explain_undetermined
from polhode.measuring.throws._throw_fit import Solution, Throw, explains, rms, variation
from polhode.measuring.throws._throw_search import find_bound

CALLED = {"drag": "drag", "linear_drag": "linear drag", "one_sided_drag": "one-sided drag", "shape": "shape"}


class DoubtThresholds(NamedTuple):
    """Numbers that decide whether a fit of throws is rejected.

    Attributes:
        max_prior_errors: prior standard deviations, by which a bias or a gain may differ from its prior mean.
        max_driving_torque: over I3 |ω|², twice the torque that slows a plate; air that drives the body by more than
            this is none.
        max_errors: standard errors, by which a body may miss I1 + I2 ≥ I3, or air may drive it.
    """

    max_prior_errors: float = 10.0
    max_driving_torque: float = 0.02
    max_errors: float = 3.0


LIMITS = DoubtThresholds()


def why_nothing_explains(solution: Solution, throws: list[Throw]) -> str | None:
    """Return a sentence if the residuals are hardly smaller than the rates themselves, else None."""
    if explains(solution, throws):
        return None
    left, size = rms(solution.residuals), variation(throws)
    return (f"no motion that was tried explains the rates: {left:.3g} rad/s of {size:.3g} rad/s are left. The rates "
            "may be of another unit, like deg/s, or the stretch no free flight.")


def why_no_result(solution: Solution, inertia: Principal, throws: list[Throw]) -> str | None:
    """Return why a fit does not determine the inertia, in a sentence, or None where it does.

    Args:
        solution: of the model that was chosen.
        inertia: its moments and axes.
        throws: the samples.
    """
    bound = find_bound(solution)
    if bound is not None:
        return (f"the fit ended at a bound of the {CALLED[bound]}, where no body is: the motion is another one than "
                "those that were tried, or the stretch is no free flight.")
    far = _doubt_expectations(solution)
    if far is not None:
        return far
    if not inertia.determined:
        return explain_undetermined([throw.rates for throw in throws], inertia)
    return why_impossible(inertia) or _doubt_drag(inertia, throws)


def _doubt_expectations(solution: Solution) -> str | None:
    which, means, weights = solution.model.prior()
    spread = np.sqrt(np.diagonal(np.linalg.inv(weights.T @ weights)))
    for name, what, unit in (("bias", "bias", " rad/s"), ("gain", "gain", ""), ("cross_axis", "cross-axis gain", "")):
        if name not in solution.model.places:
            continue
        place = solution.model.places[name]
        at = np.flatnonzero((which >= place.start) & (which < place.stop))
        off = np.abs(solution.parameters[place] - means[at]) / spread[at]
        if off.max() > LIMITS.max_prior_errors:
            k = int(np.argmax(off))
            value = solution.parameters[place][k]
            return (f"the fit needs a {what} of {value:.3g}{unit}, and {means[at][k]:.3g} ± {spread[at][k]:.2g} was "
                    "known beforehand: the motion is another one than those that were tried, the rates are of another "
                    "unit, or the stretch is no free flight.")
    return None


def _doubt_drag(inertia: Principal, throws: list[Throw]) -> str | None:
    """Return a sentence if the fitted drag would accelerate the body, else None."""
    typical = float(np.median(np.linalg.norm(np.concatenate([throw.rates for throw in throws]), axis=1)))
    least, variance = np.zeros(3), np.zeros(3)
    for name, scale in (("drag", 1.0), ("linear_drag", 1.0 / typical), ("one_sided_drag", 1.0)):
        if name in inertia.forces:
            value = scale * inertia.forces[name].value
            least += -np.abs(value) if name == "one_sided_drag" else value
            variance += (scale * inertia.forces[name].standard_error) ** 2
    if (least < -np.maximum(LIMITS.max_driving_torque, LIMITS.max_errors * np.sqrt(variance))).any():
        return (f"the fit needs air that accelerates the body, not slows it, by {-least.min():.2g} I3 |ω|²: the "
                "motion is another one than those that were tried, or the stretch is no free flight.")
    return None


def why_impossible(inertia: Principal) -> str | None:
    """Return why such moments are impossible, in a sentence, or None."""
    for name, (low, high) in zip(inertia.ratios.names, inertia.ratios.interval().tolist(), strict=True):
        if low <= 0.0:
            return (f"the interval of {name}, {low:.2g} to {high:.2g}, reaches zero, which no moment is. Throw it "
                    "longer, or with more tumble.")
    flat = float(inertia.ratios.value.sum() - 1.0)
    error = float(np.sqrt(inertia.ratios.covariance.sum()))
    if flat < -LIMITS.max_errors * error:
        return (f"I1 + I2 would be less than I3 by {-flat:.2g} ± {error:.2g} of it, which no body is: the motion is "
                "another one than those that were tried, or the stretch is no free flight.")
    return None

