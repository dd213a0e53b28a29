"""The inertia of a body from gyro logs of free throws: ratios, axes, bias, gains and drag, with their errors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation.estimate import Estimate
from polhode.estimation.flight import Window, check_windows, free_flights
from polhode.estimation.gyro_log import GyroLog
from polhode.estimation.linear_start import linear_inertia, turned_by
from polhode.estimation.principal import Principal, principal, why_undetermined
from polhode.estimation.saturation import saturation
from polhode.estimation.throw_fit import Model, Solution, Throw, fitted, predicted
from polhode.estimation.throw_models import shape_of
from polhode.exact.free_body.motion import FreeMotion
from polhode.types import Array, Float64

MISFIT = 1.4  # times the noise of the samples: larger residuals ask for other starts
NEAR = 1e-4  # of a bound of the shape or the drag: a fit that ends there may be in a wrong valley
SAME, AGREED = 5.0, 3  # of the logarithm of the likelihood, and how many starts that end alike are believed
ROD = 0.98  # of s: hardly a body is so long and thin
RESTARTS = np.array([[0.3, 0.05], [0.6, 0.05], [0.85, 0.02], [0.3, 0.3]])  # shapes s and c: plates, a rod, round
MIN_TURN = 0.5  # rad: of less nothing can be said


@dataclass(frozen=True)
class FittedThrow:
    """One throw of a fit.

    Attributes:
        log: index of its log.
        window: the stretch of the log.
        times: (n,) of the samples that were used [s].
        rates: (n, 3) measured [rad/s, device frame].
        predicted: (n, 3) by the fitted model, with bias and gains [rad/s, device frame].
        motion: the free motion along the principal axes, moments over the largest, with the fitted rates at its epoch;
            where there is drag, the one that touches the fitted motion at its epoch. None where the fit is degenerate.
        regime: of that motion; None where the fit is degenerate.
    """

    log: int
    window: Window
    times: Float64[Array, "n"]
    rates: Float64[Array, "n 3"]
    predicted: Float64[Array, "n 3"]
    motion: FreeMotion | None
    regime: str | None


@dataclass(frozen=True)
class ModelScore:
    """How well a model did: what it has besides motion and bias, its parameters, criteria and residuals [rad/s]."""

    drag: bool
    gain: bool
    parameters: int
    aicc: float
    bic: float
    rms: float
    chosen: bool


@dataclass(frozen=True)
class ThrowFit:
    """What one or several throws of one body say of it.

    Attributes:
        ratios: I1/I3 and I2/I3, I1 ≤ I2 ≤ I3; None where the fit is degenerate.
        axes: (3, 3) principal axes by columns [device frame], right-handed; None where the fit is degenerate.
        axes_error: turn of the axes about themselves [rad, principal axes], zero with its covariance. That about the
            odd axis of a body with two equal moments is not determined, and its error large.
        joint: ratios and turn of the axes together, with all their correlations.
        equal: which neighbours, "I1 = I2" or "I2 = I3", are equal within their errors, so that the axes between them
            are not determined; None for none.
        bias: of the gyro [rad/s, device axes].
        gain: of the gyro along the device axes, 1 without error; None where it was not fitted.
        drag: c_i/I3 of the torque −c_i |ω| ω_i along the principal axes; None where there is none.
        criterion: the models that were compared, by Akaike's corrected criterion.
        throws: each throw, with measured and predicted rates.
        residuals: (n, 3) of all throws [rad/s].
        rms: of the residuals [rad/s].
        sigma: noise of a sample that the residuals show, without the clock's part [rad/s].
        jitter: of the clock that the residuals show, rms [s].
        degenerate: why the inertia is not determined; None where it is.
        singular_values: (6,) of the linear method [rad/s times the root of the number of samples].
        clip: size of rates from which samples were left out as saturated [rad/s], or None.
    """

    ratios: Estimate | None
    axes: Float64[Array, "3 3"] | None
    axes_error: Estimate | None
    joint: Estimate | None
    equal: str | None
    bias: Estimate
    gain: Estimate | None
    drag: Estimate | None
    criterion: list[ModelScore]
    throws: list[FittedThrow]
    residuals: Float64[Array, "n 3"]
    rms: float
    sigma: float
    jitter: float
    degenerate: str | None
    singular_values: Float64[Array, "6"]
    clip: float | None

    @property
    def windows(self) -> list[Window]:
        """The stretches that were used."""
        return [throw.window for throw in self.throws]

    @property
    def regimes(self) -> list[str | None]:
        """The regime of each throw."""
        return [throw.regime for throw in self.throws]


@known_numbers_only
def fit_throw(
    logs: GyroLog | Sequence[GyroLog], windows: Sequence[Sequence[Window]] | None = None, drag: bool | str = "auto",
    gain: bool | str = True, clip: float | None = None, gain_spread: float = 0.01,
) -> ThrowFit:  # fmt: skip
    """Fit the inertia of one body to gyro logs of its free throws.

    The start is linear: R J ω is constant in space, R from the gyro itself. The end is a robust least squares on the
    motion with its exact derivatives: the closed form, or Euler's equations with drag and their variations. The noise
    of a sample is that of the gyro and, along the acceleration, that of the clock; both come from the residuals.
    Samples need not be at equal times.

    Args:
        logs: from ``clean_log``, one or several of the same thing.
        windows: of each log, the stretches of free flight; by default those that ``free_flights`` finds.
        drag: quadratic drag, the torque −c_i |ω| ω_i along the principal axes; "auto" lets Akaike's criterion choose.
        gain: a gain of each axis of the gyro. "auto" lets the criterion choose, but gains that are too small to be
            seen still move the ratios by about as much: only True makes the intervals account for them. False for a
            calibrated gyro.
        clip: largest rate that the gyro can tell [rad/s]; by default where ``saturation`` finds a limit.
        gain_spread: standard deviation of gains about 1, as far as known beforehand.

    Raises:
        InvalidInput: if no free flight is found, a window does not fit its log, or a throw has too few samples.

    Example:
        >>> import numpy as np
        >>> from polhode import FreeMotion
        >>> from polhode.estimation import clean_log
        >>> motion = FreeMotion((0.2, 0.8, 1.0), angular_velocity=(2.0, 9.0, 1.0))
        >>> t = np.arange(0.0, 0.8, 0.01)
        >>> noise = 1e-3 * np.random.default_rng(1).normal(size=(80, 3))
        >>> fit = fit_throw(clean_log(t, motion.angular_velocity(t) + noise), gain=False, drag=False)
        >>> bool(np.all(abs(fit.ratios.value - [0.2, 0.8]) < 3 * fit.ratios.standard_error))
        True
    """
    every = [logs] if isinstance(logs, GyroLog) else list(logs)
    _check_choice("drag", drag)
    _check_choice("gain", gain)
    if not (np.isfinite(gain_spread) and gain_spread > 0):
        raise InvalidInput(f"gain_spread must be a positive number, like 0.01; got {shown(gain_spread)}.")
    level = saturation(every) if clip is None else float(clip)
    found = _windows_of(every, windows, level)
    cut = [(k, window, *_cut(every[k], window, level)) for k, per_log in enumerate(found) for window in per_log]
    throws = [throw for *_, throw in cut]
    start = _Start.of(throws)
    if start.degenerate:
        return _nothing(cut, start, level)
    tried = _tried(start, throws, drag, gain, gain_spread)
    best = min(tried, key=lambda one: one.aicc)
    scores = [ModelScore(s.model.drag, s.model.gain, s.model.size, s.aicc, s.bic, _rms(s.residuals), s is best)
              for s in tried]  # fmt: skip
    return _result(best, scores, cut, start, level)


def _check_choice(name: str, value: bool | str) -> None:
    if value is not True and value is not False and value != "auto":
        raise InvalidInput(f"{name} must be True, False or 'auto'; got {shown(value)}.")


def _windows_of(
    logs: list[GyroLog], windows: Sequence[Sequence[Window]] | None, level: float | None
) -> list[list[Window]]:
    if not logs:
        raise InvalidInput("at least one log is needed; got none.")
    if windows is not None and len(windows) != len(logs):
        raise InvalidInput(f"each log needs its windows: got {len(logs)} logs and windows for {len(windows)}.")
    found = [free_flights(log, level) for log in logs] if windows is None else [list(per_log) for per_log in windows]
    if not any(found):
        raise InvalidInput(
            "no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or "
            "feels no weight. Give its start and end."
        )
    for per_log, log in zip(found, logs, strict=True):
        check_windows(per_log, log)
    return found


def _cut(log: GyroLog, window: Window, level: float | None) -> tuple[Array, Throw]:
    """Return the times of a window's usable samples, and the throw, whose epoch is near the middle."""
    use = (log.times >= window.start) & (log.times <= window.end)
    if level is not None:
        use &= (np.abs(log.rates) < level * (1 - 1e-6)).all(axis=1)
    times, rates = log.times[use], log.rates[use]
    if len(times) < 8:
        raise InvalidInput(f"a throw must have 8 samples that are not saturated; got {len(times)}. "
                           "Throw more slowly, or give a longer window.")  # fmt: skip
    epoch = float(times[len(times) // 2])
    return times, Throw(times - epoch, rates, epoch)


@dataclass(frozen=True)
class _Start:
    """What the linear method says, and why nothing can be said, if so."""

    shape: Array
    axes: Array
    singular_values: Array
    noise: float
    degenerate: str | None

    @classmethod
    def of(cls, throws: list[Throw]) -> _Start:
        rates = [throw.rates for throw in throws]
        found = linear_inertia(rates, [turned_by(t.elapsed, t.rates) for t in throws])
        noise = _noise(throws)
        # noise of σ makes each singular value about σ √n; biases and drag make them larger, so the fit judges again
        floor = 6.0 * noise * np.sqrt(sum(len(r) for r in rates))
        turned = max(float(np.sum(np.linalg.norm(t.rates[1:], axis=1) * np.diff(t.elapsed))) for t in throws)
        reason = None
        if turned < MIN_TURN:
            reason = f"the body turned by {turned:.2g} rad only: nothing can be said of its inertia."
        elif found.singular_values[-2] < floor:
            reason = why_undetermined(rates, None)
        return cls(shape_of(found.moments), found.axes, found.singular_values, noise, reason)


def _noise(throws: list[Throw]) -> float:
    """Return the noise of a sample from third differences, in which smooth motion vanishes."""
    parts = [np.abs(np.diff(throw.rates, n=3, axis=0)) for throw in throws]
    return float(np.median(np.concatenate(parts)) / (0.6745 * np.sqrt(20.0)))


def _tried(
    start: _Start, throws: list[Throw], drag: bool | str, gain: bool | str, spread: float
) -> list[Solution]:
    """Return the models that are asked for, each started from the one before it that it contains."""
    choices = lambda x: (False, True) if x == "auto" else (x,)  # noqa: E731
    plain = Model(False, gain is True, len(throws), spread)
    begin = [start.axes.T @ throw.rates[len(throw.rates) // 2] for throw in throws]
    x = np.concatenate([start.shape, np.zeros(6), *[np.ones(3)] * plain.gain, *begin])
    first = _grown(plain, x, start.axes, throws)
    solutions = {(False, plain.gain): first}
    for wanted_drag in choices(drag):
        for wanted_gain in choices(gain):
            if (wanted_drag, wanted_gain) in solutions:
                continue
            base = solutions.get((wanted_drag, False), first)
            model = Model(bool(wanted_drag), bool(wanted_gain), len(throws), spread)
            noise = (base.sigma, base.jitter)
            solutions[wanted_drag, wanted_gain] = fitted(model, _carried(base, model), base.axes, throws, noise)
    asked = [solutions[d, g] for d in choices(drag) for g in choices(gain)]
    if _in_a_valley(min(asked, key=lambda one: one.aicc), start):
        asked[-1] = _retried(asked[-1], start, throws)  # it contains the others
    return asked


def _in_a_valley(solution: Solution, start: _Start) -> bool:
    """Whether a fit may have ended at a wrong place: at a bound, or with residuals beyond the samples' own noise."""
    return bool(np.median(np.abs(solution.residuals)) > MISFIT * 0.6745 * start.noise) or _at_bound(solution)


def _at_bound(solution: Solution) -> bool:
    """Whether the shape or the drag ran to a bound, where drag may do the work of a wrong shape."""
    low, high = solution.model.limits()
    near = np.minimum(solution.parameters - low, high - solution.parameters) < NEAR
    near[0] = abs(solution.parameters[0]) > ROD
    places = solution.model.places
    return any(bool(near[places[name]].any()) for name in ("shape", "drag") if name in places)


def _grown(model: Model, x: Array, axes: Array, throws: list[Throw]) -> Solution:
    """Return a fit that begins with the middles of long throws, where a rough start keeps the count of turns."""
    for samples in (500, 2500):
        if max(len(throw.elapsed) for throw in throws) > 2 * samples:
            middles = [_middle(throw, samples) for throw in throws]
            found = fitted(model, x, axes, middles, None)
            x, axes = _carried(found, model), found.axes
    return fitted(model, x, axes, throws, None)


def _middle(throw: Throw, samples: int) -> Throw:
    centre = int(np.argmin(np.abs(throw.elapsed)))
    part = slice(max(centre - samples // 2, 0), centre + samples // 2)
    return Throw(throw.elapsed[part], throw.rates[part], throw.epoch)


def _retried(solution: Solution, start: _Start, throws: list[Throw]) -> Solution:
    """Return the best of several starts: shapes by the axes of the linear method and by those of the rates themselves.

    The linear method knows of no bias. Where the body turns about its middle axis, that may exchange its axes.
    """
    model = solution.model
    begin = _carried(solution, model)
    for name, place in model.places.items():
        if name in ("bias", "drag"):
            begin[place] = 0.0
    one, two, three = np.linalg.svd(np.concatenate([throw.rates for throw in throws]), full_matrices=False)[2]
    found = [solution]
    for axes in (np.stack([three, one, np.cross(three, one)], axis=1), start.axes,
                 np.stack([two, one, np.cross(two, one)], axis=1)):  # fmt: skip
        for k, throw in enumerate(throws):
            begin[model.places[f"start {k}"]] = axes.T @ throw.rates[len(throw.rates) // 2]
        for shape in RESTARTS:
            begin[model.places["shape"]] = shape
            found.append(fitted(model, begin, axes, throws, None))
            if not _in_a_valley(found[-1], start):
                return max(found, key=lambda each: each.log_likelihood)
        likelihoods = np.array([each.log_likelihood for each in found])
        if (likelihoods > likelihoods.max() - SAME).sum() >= AGREED:
            break  # the data are not of this model, wherever one starts
    return max(found, key=lambda each: each.log_likelihood)


def _carried(base: Solution, model: Model) -> Array:
    """Return a solution's parameters where another model has them, its axes taken for the start."""
    x = np.zeros(model.size)
    for name, place in model.places.items():
        if name in base.model.places:
            x[place] = base.parameters[base.model.places[name]]
        elif name == "gain":
            x[place] = 1.0
    x[model.places["turn"]] = 0.0
    return x


def _rms(x: Array) -> float:
    return float(np.sqrt(np.mean(x * x)))


def _part(solution: Solution, group: str, names: tuple[str, ...]) -> Estimate:
    place = solution.model.places[group]
    return Estimate(names, solution.parameters[place], solution.covariance[place, place], solution.freedom)


def _result(
    best: Solution, scores: list[ModelScore], cut: list[Any], start: _Start, level: float | None
) -> ThrowFit:
    throws = [throw for *_, throw in cut]
    found = principal(best.parameters, best.covariance, best.model.places, best.axes, best.freedom)
    reason = None
    if not found.determined:
        reason = why_undetermined([throw.rates for throw in throws], found)
    zero = _without_turn(best)
    values, *_ = predicted(best.model, zero, best.axes, throws)
    parts = np.split(values, np.cumsum([len(throw.rates) for throw in throws])[:-1])
    bias = _part(best, "bias", ("bias x", "bias y", "bias z"))
    gain = _part(best, "gain", ("gain x", "gain y", "gain z")) if best.model.gain else None
    told = [FittedThrow(k, window, times, throw.rates, part, *_motion(found, best, i, throw, reason))
            for i, ((k, window, times, throw), part) in enumerate(zip(cut, parts, strict=True))]  # fmt: skip
    sure = reason is None
    return ThrowFit(
        found.ratios if sure else None, found.axes if sure else None, found.turn if sure else None,
        found.joint if sure else None, found.equal if sure else None, bias, gain, found.drag if sure else None,
        scores, told, best.residuals, _rms(best.residuals), best.sigma, best.jitter, reason, start.singular_values,
        level,
    )  # fmt: skip


def _without_turn(solution: Solution) -> Array:
    """Return the parameters with no turn, for use with the solution's own axes."""
    x = solution.parameters.copy()
    x[solution.model.places["turn"]] = 0.0
    return x


def _motion(
    found: Principal, best: Solution, k: int, throw: Throw, reason: str | None
) -> tuple[FreeMotion | None, str | None]:
    if reason is not None:
        return None, None
    rates = found.order.T @ best.parameters[best.model.places[f"start {k}"]]
    motion = FreeMotion(found.moments, found.moments * rates, epoch=throw.epoch)
    return motion, motion.regime


def _nothing(cut: list[Any], start: _Start, level: float | None) -> ThrowFit:
    """Return the fit of throws that say nothing of the inertia."""
    told = [FittedThrow(k, window, times, throw.rates, np.full_like(throw.rates, np.nan), None, None)
            for k, window, times, throw in cut]  # fmt: skip
    unknown = Estimate(("bias x", "bias y", "bias z"), np.full(3, np.nan), np.full((3, 3), np.nan))
    return ThrowFit(None, None, None, None, None, unknown, None, None, [], told, np.empty((0, 3)), float("nan"),
                    start.noise, 0.0, start.degenerate, start.singular_values, level)  # fmt: skip
