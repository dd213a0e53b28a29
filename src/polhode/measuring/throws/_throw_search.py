"""The choice of a model for throws, from simple to rich, each fitted from the result of the one before."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from polhode.measuring.throws._linear_start import integrate_rates, linear_inertia
from polhode.measuring.throws._principal import explain_undetermined
from polhode.measuring.throws._throw_fit import LIMITS as FIT_LIMITS
from polhode.measuring.throws._throw_fit import (
    PARAMETER_BOUNDS,
    UNBOUNDED,
    Model,
    Solution,
    Throw,
    compute_covariance,
    explains,
    fit_model,
    predict_rates,
    whitening_matrices,
)
from polhode.measuring.throws._throw_models import compute_shape
from polhode.types import Array, Float64

RESTARTS = np.array([[0.3, 0.05], [0.6, 0.05], [0.85, 0.02], [0.3, 0.3]])  # shapes s and c: plates, a rod, round
AIR = ((), ("drag",), ("drag", "linear_drag"), ("drag", "linear_drag", "one_sided_drag"))
WHEEL = (("rotor",), ("drag", "rotor"))


class SearchThresholds(NamedTuple):
    """Numbers that decide which models and starts are tried, which model is chosen, and which throws are refused.

    Attributes:
        max_noise_ratio: of the residuals to the noise of the samples; larger residuals call for other starts.
        bound_distance: of a coefficient to its bound; a fit that ends as near may be a local minimum.
        min_flatness: c; no body is as flat, so that a fit that ends there is a local minimum.
        max_length: |s|; hardly a body is as long and thin, so that a fit that ends there is a local minimum.
        max_correlation: of neighbouring residuals; larger ones show a motion that the model does not explain.
        min_turn: rad, through which the body rotates; less does not determine its inertia.
        max_turn_per_sample: rad, a third of a turn; larger ones cannot be followed from sample to sample.
        max_rate: rad/s, 4300 deg/s; larger rates are of another unit, if they make the body round.
        max_roundness: I1/I3 by the linear method, beyond which a body is round.
        min_singular_value: times that of noise, of the second least; less does not determine the axes.
        wheel_score: decrease of χ² by a wheel's three numbers, from which one is tried: one throw in 130 without a
            wheel reaches it.
        wheel_handicap: of AICc, by which a model with a wheel must do better than one without: few bodies have one.
        rival_distance: of the criterion, within which a model with a wheel and one without may both be true.
        min_part: samples of a part of a throw; fewer have no momentum to compare.
    """

    max_noise_ratio: float = 1.4
    bound_distance: float = 1e-4
    min_flatness: float = -0.05
    max_length: float = 0.98
    max_correlation: float = 0.3
    min_turn: float = 0.5
    max_turn_per_sample: float = 2.0
    max_rate: float = 75.0
    max_roundness: float = 0.6
    min_singular_value: float = 6.0
    wheel_score: float = 12.0
    wheel_handicap: float = 10.0
    rival_distance: float = 15.0
    min_part: int = 4


LIMITS = SearchThresholds()


@dataclass(frozen=True, eq=False)
class Start:
    """The result of the linear method, or why there is none."""

    shape: Array
    axes: Array
    singular_values: Array
    noise: float
    degenerate: str | None

    @classmethod
    def of(cls, throws: list[Throw]) -> Start:
        """Return the start for throws of one body."""
        rates = [throw.rates for throw in throws]
        estimate = linear_inertia(rates, [integrate_rates(t.elapsed, t.rates) for t in throws])
        noise = _noise(throws)
        # noise of σ makes each singular value about σ √n; biases and drag make them larger, and the fit judges again
        floor = LIMITS.min_singular_value * noise * np.sqrt(sum(len(r) for r in rates))
        steps = [np.linalg.norm(t.rates[1:], axis=1) * np.diff(t.elapsed) for t in throws]
        turn = max(float(step.sum()) for step in steps)
        between = max(float(np.median(step)) for step in steps)
        reason = None
        if between > LIMITS.max_turn_per_sample:
            reason = (f"the rates say that the body turns by {between:.3g} rad from sample to sample, too far to be "
                      "followed: the rates are of another unit, like deg/s, or the times are.")
        elif max(_typical(r) for r in rates) > LIMITS.max_rate and estimate.moments[0] > LIMITS.max_roundness:
            reason = (f"the rates, about {max(_typical(r) for r in rates):.3g} rad/s, are beyond what gyros can tell, "
                      "and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: give "
                      "their unit.")
        elif turn < LIMITS.min_turn:
            reason = f"the body turned by {turn:.2g} rad only: nothing can be said of its inertia."
        elif estimate.singular_values[-2] < floor:
            reason = explain_undetermined(rates, None)
        return cls(compute_shape(estimate.moments), estimate.axes, estimate.singular_values, noise, reason)


def _typical(rates: Array) -> float:
    return float(np.median(np.linalg.norm(rates, axis=1)))


def _noise(throws: list[Throw]) -> float:
    """Return the noise of a sample from third differences, in which smooth motion vanishes."""
    parts = [np.abs(np.diff(throw.rates, n=3, axis=0)) for throw in throws]
    return float(np.median(np.concatenate(parts)) / (0.6745 * np.sqrt(20.0)))


def fit_models(
    plain: Model, start: Start, throws: list[Throw], drag: bool | str, rotor: bool | str, gain: bool | str
) -> list[Solution]:
    """Fit the models that are asked for, and return the fits, the best first.

    Args:
        plain: the model of the free motion, with gains where they are asked for.
        start: of the linear method.
        throws: the samples.
        drag: whether air acts; "auto" to let the criterion choose.
        rotor: whether a wheel turns in the body.
        gain: whether the gyro has gains.
    """
    fits = []
    if rotor is not True:
        fits += _in_air(plain, start, throws, drag)
    if rotor is True or (rotor == "auto" and _asks_for_wheel(min(fits, key=criterion), start, throws)):
        fits += _with_wheel(plain, throws, drag)
    best = min(fits, key=criterion)
    without = [one for one in fits if not one.model.rotor]
    if best.model.rotor and rotor == "auto" and _in_a_valley(min(without, key=criterion), start):
        # a wheel must not win only because the fit without one is a local minimum
        fits += _again(replace(plain, forces=() if drag is False else AIR[1]), best, drag, start, throws)
        best = min(fits, key=criterion)
    if _in_a_valley(best, start):
        kept = best.model if best.model.rotor else replace(plain, forces=() if drag is False else AIR[1])
        fits += _again(kept, best, drag, start, throws)
    if gain == "auto":
        best = min(fits, key=criterion)
        fits.append(_richer(best, replace(best.model, gain=True), throws))
    return sorted(fits, key=criterion)


def _again(model: Model, best: Solution, drag: bool | str, start: Start, throws: list[Throw]) -> list[Solution]:
    """Return the fit of a model from several starts, and with linear drag too where it does better than the best."""
    again = _retry(model, start, throws)
    if drag is False or model.rotor or again.aicc >= best.aicc or not explains(again, throws):
        return [again]
    return [again, _richer(again, replace(model, forces=AIR[2]), throws)]


def criterion(solution: Solution) -> float:
    """Return the criterion by which models are compared: AICc, with a handicap for a wheel."""
    return solution.aicc + LIMITS.wheel_handicap * solution.model.rotor


def rival(fits: list[Solution]) -> Solution | None:
    """Return the best model with a wheel if the chosen one has none, or without, where it does about as well.

    Args:
        fits: the best of them first.
    """
    others = [each for each in fits if each.model.rotor != fits[0].model.rotor]
    return others[0] if others and criterion(others[0]) - criterion(fits[0]) < LIMITS.rival_distance else None


def _in_air(plain: Model, start: Start, throws: list[Throw], drag: bool | str) -> list[Solution]:
    """Return fits without a wheel; richer ones only while they do better."""
    begin = [start.axes.T @ throw.rates[len(throw.rates) // 2] for throw in throws]
    x = np.concatenate([start.shape, np.zeros(3), plain.bias, *_no_gains(plain), *begin])
    last = _fit_growing(plain, x, start.axes, throws)
    fits = [last]
    for forces in AIR[1:] if drag is not False else ():
        model = replace(plain, forces=forces)
        if explains(last, throws):
            more = _richer(last, model, throws)
        elif len(forces) == 1:  # a local minimum without drag: with it, the fit starts from the linear method
            at = np.insert(x, model.places["drag"].start, np.zeros(3))
            more = _choose_best(model, [(at, start.axes)], throws)
        else:
            break
        fits.append(more)
        if len(forces) > 1 and more.aicc > last.aicc:
            break
        last = more
    return fits[1:] if drag is True and len(fits) > 1 else fits


def _no_gains(plain: Model) -> list[Array]:
    return [np.ones(3), np.zeros(3)] * plain.gain


def _with_wheel(plain: Model, throws: list[Throw], drag: bool | str) -> list[Solution]:
    """Return fits with a wheel, from the linear method with one over throws or parts of them."""
    rates = [throw.rates - np.array(plain.bias) for throw in throws]
    turns = [integrate_rates(t.elapsed, r) for t, r in zip(throws, rates, strict=True)]
    starts = []
    for span in (100.0, 0.3, 0.15):  # s; a bias makes the momentum of a long part drift
        parts = [np.array_split(np.arange(len(t.elapsed)), _count_parts(t, span)) for t in throws]
        linear = linear_inertia(rates, turns, parts, rotor=True)
        begin = [linear.axes.T @ throw.rates[len(throw.rates) // 2] for throw in throws]
        x = np.concatenate([compute_shape(linear.moments), np.zeros(3), plain.bias, *_no_gains(plain),
                            linear.axes.T @ linear.rotor, *begin])  # fmt: skip
        starts.append((x, linear.axes))
    fits = [_choose_best(replace(plain, forces=WHEEL[0]), starts, throws)]
    if drag is not False:
        fits.append(_richer(fits[0], replace(plain, forces=WHEEL[1]), throws))
    return fits[1:] if drag is True else fits


def _count_parts(throw: Throw, span: float) -> int:
    """Return the number of parts of about a span [s] into which a throw is split, each of enough samples."""
    wanted = round((throw.elapsed[-1] - throw.elapsed[0]) / span)
    return int(np.clip(wanted, 1, len(throw.elapsed) // LIMITS.min_part))


def _choose_best(model: Model, starts: list[tuple[Array, Array]], throws: list[Throw]) -> Solution:
    """Return the fit from the best of several starts, compared on the middles of the throws."""
    middles = [_middle(throw, _count_glance(throw)) for throw in throws]
    fits = [fit_model(model, x, axes, middles, None, rounds=1) for x, axes in starts]
    best = max(fits, key=lambda one: one.log_likelihood)
    if not explains(best, middles):
        return fit_model(model, carry_over(best, model), best.axes, throws, None, rounds=0)
    return _fit_growing(model, carry_over(best, model), best.axes, throws)


def _richer(base: Solution, model: Model, throws: list[Throw]) -> Solution:
    return fit_model(model, carry_over(base, model), base.axes, throws, (base.sigma, base.jitter))


def _in_a_valley(solution: Solution, start: Start) -> bool:
    """Whether a fit may be a local minimum: at a bound, or with residuals above the noise of the samples."""
    misfit = np.median(np.abs(solution.residuals)) > LIMITS.max_noise_ratio * 0.6745 * start.noise
    return bool(misfit) or find_bound(solution) is not None


def _asks_for_wheel(solution: Solution, start: Start, throws: list[Throw]) -> bool:
    """Whether residuals are larger than the samples' noise, correlated, or reduced by a wheel."""
    if _in_a_valley(solution, start) or alike(solution.residuals) > LIMITS.max_correlation:
        return True
    return score_wheel(solution, throws) > LIMITS.wheel_score


def score_wheel(solution: Solution, throws: list[Throw]) -> float:
    """Return the decrease of χ² by a small wheel, all other parameters free (Rao's score test)."""
    model, A, z = _beside_wheel(solution, throws)
    scaled = A / np.maximum(np.linalg.norm(A, axis=0), 1e-300)
    without = np.delete(scaled, np.r_[model.places["rotor"]], axis=1)
    explained = [z @ part @ np.linalg.lstsq(part, z, rcond=1e-9)[0] for part in (without, scaled)]
    return float(explained[1] - explained[0])


def covariance_beside_wheel(solution: Solution, throws: list[Throw]) -> Float64[Array, "p p"]:
    """Return the covariance of a solution's parameters if a small unknown wheel may turn in the body.

    Args:
        solution: of a model without one, with p parameters.
        throws: the samples.
    """
    model, A, _ = _beside_wheel(solution, throws)
    kept = np.delete(np.arange(model.size), np.r_[model.places["rotor"]])
    return compute_covariance(A)[np.ix_(kept, kept)]


def _beside_wheel(solution: Solution, throws: list[Throw]) -> tuple[Model, Array, Array]:
    """Return the model with a wheel too, its linear least squares about the solution, and the residuals for it."""
    model = replace(solution.model, forces=(*solution.model.forces, "rotor"))
    x = carry_over(solution, model)
    _, slopes, fast = predict_rates(model, x, solution.axes, throws)
    white = whitening_matrices(fast, solution.sigma, solution.jitter)
    which, means, weights = model.prior()
    A = np.concatenate([(white @ slopes).reshape(-1, model.size), weights @ np.eye(model.size)[which]])
    robust = FIT_LIMITS.max_quadratic_error
    z = np.clip((white @ solution.residuals[..., None]).ravel(), -robust, robust)
    return model, A, np.concatenate([z, weights @ (means - x[which])])


def alike(residuals: Array) -> float:
    """Return the correlation of neighbouring residuals (n, 3)."""
    return float((residuals[:-1] * residuals[1:]).sum() / max(float((residuals**2).sum()), 1e-300))


def find_bound(solution: Solution) -> str | None:
    """Return which of shape and drag ended at a bound; drag may compensate a wrong shape."""
    x, places = solution.parameters, solution.model.places
    s, c = x[places["shape"]]
    if abs(s) > LIMITS.max_length or c < LIMITS.min_flatness:
        return "shape"
    for name in solution.model.forces:
        low, high = PARAMETER_BOUNDS.get(name, UNBOUNDED)
        if np.minimum(x[places[name]] - low[0], high[0] - x[places[name]]).min() < LIMITS.bound_distance:
            return name
    return None


def _fit_growing(model: Model, x: Array, axes: Array, throws: list[Throw]) -> Solution:
    """Fit the middles of long throws first, over which a rough start does not lose a turn, and then the whole throws.

    Where the model does not explain a middle, the whole throws are not fitted.
    """
    for samples in (500, 2500):
        if max(len(throw.elapsed) for throw in throws) > 2 * samples:
            middles = [_middle(throw, samples) for throw in throws]
            fit = fit_model(model, x, axes, middles, None)
            x, axes = carry_over(fit, model), fit.axes
            if not explains(fit, middles):
                return fit_model(model, x, axes, throws, None, rounds=0)
    return fit_model(model, x, axes, throws, None)


def _count_glance(throw: Throw) -> int:
    """Return the number of middle samples that suffices to compare starts."""
    between = np.median(np.linalg.norm(throw.rates, axis=1)) * np.median(np.diff(throw.elapsed))
    turn = 15.0  # rad
    return int(np.clip(turn / max(float(between), 1e-9), 24, 200))


def _middle(throw: Throw, samples: int) -> Throw:
    centre = int(np.argmin(np.abs(throw.elapsed)))
    part = slice(max(centre - samples // 2, 0), centre + samples // 2)
    return Throw(throw.elapsed[part], throw.rates[part], throw.epoch)


def _retry(model: Model, start: Start, throws: list[Throw]) -> Solution:
    """Return the best of several starts: shapes by the axes of the linear method and by those of the rates themselves.

    The linear method ignores the bias. Where the body turns about its middle axis, that may exchange its axes.
    """
    begin = np.zeros(model.size)
    begin[model.places["bias"]] = model.bias
    if model.gain:
        begin[model.places["gain"]] = 1.0
    one, two, three = np.linalg.svd(np.concatenate([throw.rates for throw in throws]), full_matrices=False)[2]
    starts = []
    for axes in (np.stack([three, one, np.cross(three, one)], axis=1), start.axes,
                 np.stack([two, one, np.cross(two, one)], axis=1)):
        for k, throw in enumerate(throws):
            begin[model.places[f"start {k}"]] = axes.T @ throw.rates[len(throw.rates) // 2]
        for shape in RESTARTS:
            begin[model.places["shape"]] = shape
            starts.append((begin.copy(), axes))
    return _choose_best(model, starts, throws)


def carry_over(base: Solution, model: Model) -> Float64[Array, "parameters"]:
    """Return a solution's parameters in the places of another model, with the solution's axes as the start."""
    x = np.zeros(model.size)
    for name, place in model.places.items():
        if name in base.model.places:
            x[place] = base.parameters[base.model.places[name]]
        elif name == "gain":
            x[place] = 1.0
    x[model.places["turn"]] = 0.0
    return x

