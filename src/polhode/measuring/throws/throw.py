"""The inertia of a body from gyro logs of free throws: ratios, axes, bias, gains and drag, with their errors."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation._estimate import Estimate
from polhode.exact.free_body.motion import FreeMotion
from polhode.measuring.throws._principal import Principal, principal, widen_errors
from polhode.measuring.throws._rest_bias import RestBias, rest_bias
from polhode.measuring.throws._saturation import saturation
from polhode.measuring.throws._throw_doubts import why_no_result, why_nothing_explains
from polhode.measuring.throws._throw_fit import PAIRS, Model, Solution, Throw, rms
from polhode.measuring.throws._throw_search import Start, covariance_beside_wheel, fit_models, rival
from polhode.measuring.throws._unmodelled import Settled, allow_for_unmodelled
from polhode.measuring.throws.flight import Window, check_windows, free_flights
from polhode.measuring.throws.gyro_log import LIMITS as LOG_LIMITS
from polhode.measuring.throws.gyro_log import GyroLog
from polhode.motion._inputs import name_of
from polhode.special._residual_noise import Misfit, test_filtered_noise
from polhode.types import Array, Float64

BIAS = ("bias x", "bias y", "bias z")
GAIN_SPREAD = 0.01  # standard deviation of gains and cross-axis sensitivities of phones


@dataclass(frozen=True, eq=False)
class FittedThrow:
    """One throw of a fit.

    Attributes:
        log: index of its log.
        window: the stretch of the log.
        times: (n,) of the samples that were used [s].
        rates: (n, 3) measured [rad/s, device frame].
        predicted: (n, 3) by the fitted model, with bias and gains [rad/s, device frame].
        motion: the free motion along the principal axes, moments over the largest, with the fitted rates at its epoch;
            where there is drag, the one that touches the fitted motion at its epoch. None where the fit is degenerate,
            or a wheel turns in the body.
        regime: of that motion; None where there is none.
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
    """The score of a model: its terms besides motion and bias, criteria and residuals [rad/s].

    Attributes:
        drag: "none", "quadratic", "linear and quadratic" or "one-sided, linear and quadratic".
        rotor: whether a wheel turns in the body.
        gain: whether the gyro has gains.
        parameters: how many.
        aicc: Akaike's criterion, corrected for few samples.
        bic: Schwarz's criterion.
        rms: of the residuals [rad/s].
        chosen: whether the answer is of this model.
    """

    drag: str
    rotor: bool
    gain: bool
    parameters: int
    aicc: float
    bic: float
    rms: float
    chosen: bool


@dataclass(frozen=True, eq=False)
class ThrowFit:
    """The result of a fit to one or several throws of one body.

    Attributes:
        ratios: I1/I3 and I2/I3, I1 ≤ I2 ≤ I3; None where the fit is degenerate.
        axes: (3, 3) principal axes by columns [device frame], right-handed; None where the fit is degenerate.
        axes_error: turn of the axes about themselves [rad, principal axes], zero with its covariance. That about the
            odd axis of a body with two equal moments is not determined, and its error large.
        joint: ratios and turn of the axes together, with all their correlations.
        equal: which neighbours, "I1 = I2" or "I2 = I3", are equal within their errors, so that the axes between them
            are not determined; None for none.
        bias: of the gyro [rad/s, device axes].
        rest: the bias of the gyro at rest, the prior of the fit; None where no log has rests.
        gain: of the gyro along the device axes, 1 without error; None where it was not fitted.
        cross_axis: how much of the rate about one axis shows about another, of y and z, x and z, x and y, the mean of
            both ways; their difference turns the axes of the device. None where it was not fitted.
        gain_spread: standard deviation of such gains, by the log and the prior.
        drag: c_i/I3 of the torque −c_i |ω| ω_i along the principal axes; None where there is none.
        linear_drag: b_i/I3 of the torque −b_i ω_i [1/s], or None.
        one_sided_drag: d_i/I3 of the torque −d_i |ω| |ω_i|, or None.
        rotor: momentum of a wheel that turns in the body, over I3 [rad/s, principal axes]; None where there is none.
            The ratios are then of the body with the wheel; where no motor keeps its speed, without the wheel's own
            moment about its axis.
        beside_wheel: standard errors of the ratios if a wheel, of which nothing is known, might turn in the body; None
            where one was fitted.
        unmodelled: rms of a smooth torque over I3 |ω|² that no model has, and that the intervals allow for.
        widened: factor on the variances of the noise, because neighbouring residuals are alike.
        criterion: the models that were compared, by Akaike's corrected criterion, with a handicap of 10 for a wheel.
        with_or_without: whether models with a wheel and without one do about as well, so that the errors of ratios and
            axes cover both.
        throws: each throw, with measured and predicted rates.
        residuals: (n, 3) of all throws [rad/s].
        rms: of the residuals [rad/s].
        sigma: noise of a sample that the residuals show, without the clock's part [rad/s].
        jitter: of the clock that the residuals show, rms [s].
        degenerate: why the inertia is not determined; None where it is.
        misfit: why the residuals are not noise; None where they are. The estimates are then of a wrong model: they
            have no errors (NaN).
        singular_values: (6,) of the linear method [rad/s times the root of the number of samples].
        clip: size of rates from which samples were left out as saturated [rad/s], or None.
    """

    ratios: Estimate | None
    axes: Float64[Array, "3 3"] | None
    axes_error: Estimate | None
    joint: Estimate | None
    equal: str | None
    bias: Estimate
    rest: Estimate | None
    gain: Estimate | None
    cross_axis: Estimate | None
    gain_spread: float
    drag: Estimate | None
    linear_drag: Estimate | None
    one_sided_drag: Estimate | None
    rotor: Estimate | None
    beside_wheel: Float64[Array, "2"] | None
    unmodelled: float
    widened: float
    criterion: list[ModelScore]
    with_or_without: bool
    throws: list[FittedThrow]
    residuals: Float64[Array, "n 3"]
    rms: float
    sigma: float
    jitter: float
    degenerate: str | None
    misfit: Misfit | None
    singular_values: Float64[Array, "6"]
    clip: float | None

    @property
    def gains(self) -> Float64[Array, "3 3"]:
        """The matrix that the gyro multiplies rates by [device frame]."""
        matrix = np.eye(3) if self.gain is None else np.diag(self.gain.value)
        if self.cross_axis is not None:
            for value, (i, j) in zip(self.cross_axis.value, PAIRS, strict=True):
                matrix[i, j] = matrix[j, i] = value
        return matrix

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
    gain: bool | str = True, clip: float | None = None, gain_spread: float = GAIN_SPREAD, rotor: bool | str = "auto",
) -> ThrowFit:
    """Fit the inertia of one body to gyro logs of its free throws.

    The start is linear: R J ω is constant in space, R from the gyro itself. Then comes a robust least squares on the
    motion with its exact derivatives: the closed form, or Euler's equations with torques and their variations. The
    noise of a sample is that of the gyro and, along the acceleration, that of the clock; both come from the residuals.
    At the end the intervals allow for unmodelled effects: a smooth torque, gains larger than expected, correlated
    residuals. Rests in a log determine the bias. Samples need not be at equal times.

    Args:
        logs: from ``clean_log``, one or several of one device.
        windows: of each log, the stretches of free flight; by default those that ``free_flights`` finds.
        drag: torques of air along the principal axes; False for none, True for some, "auto" to let Akaike's criterion
            choose that too. It also chooses between quadratic drag, −c_i |ω| ω_i, quadratic and linear drag, −b_i ω_i,
            and both with one-sided drag, −d_i |ω| |ω_i|.
        gain: a symmetric matrix of gains of the gyro. "auto" lets the criterion choose, but undetected gains
            still move the ratios by about as much: only True makes the intervals account for them. False for a
            calibrated gyro.
        clip: largest rate that the gyro measures [rad/s], infinity for no limit; by default that of ``saturation``.
        gain_spread: prior standard deviation of an entry of the matrix of gains.
        rotor: a wheel of constant momentum that turns in the body; "auto" for what the criterion says, where air alone
            leaves residuals that are too large or alike.

    Raises:
        InvalidInput: if the log has no free flight, a window does not fit its log, or a throw has too few samples.

    Example:
        >>> import numpy as np
        >>> from polhode import FreeMotion
        >>> from polhode.measuring import clean_log
        >>> motion = FreeMotion((0.2, 0.8, 1.0), angular_velocity=(2.0, 9.0, 1.0))
        >>> t = np.arange(0.0, 0.8, 0.01)
        >>> noise = 1e-3 * np.random.default_rng(1).normal(size=(80, 3))
        >>> fit = fit_throw(clean_log(t, motion.angular_velocity(t) + noise), gain=False, drag=False)
        >>> bool(np.all(abs(fit.ratios.value - [0.2, 0.8]) < 3 * fit.ratios.standard_error))
        True
    """
    every = [logs] if isinstance(logs, GyroLog) else list(logs) if isinstance(logs, Iterable) else []
    if not every or not all(isinstance(log, GyroLog) for log in every):
        raise InvalidInput(f"`logs` must be a GyroLog or a list of them; got {shown(logs)}. Read files with "
                           "`polhode.measuring.read_gyro_log`, or make one by `clean_log`.")
    for name, value in (("drag", drag), ("gain", gain), ("rotor", rotor)):
        if not (value is True or value is False or (isinstance(value, str) and value == "auto")):
            check.refuse(name, 'True, False or "auto"', value)
    gain_spread = check.number("gain_spread", gain_spread, above=0, remedy="0.01 is usual.")
    if clip is not None:
        clip = check.number("clip", clip, "rad/s", above=0, infinite=True, remedy="Infinity is no limit.")
    level = saturation(every) if clip is None else float(clip) if clip < math.inf else None
    flights = _choose_windows(every, windows, level)
    cut = [(k, window, *_cut(every[k], window, level)) for k, per_log in enumerate(flights) for window in per_log]
    throws = [throw for *_, throw in cut]
    start = Start.of(throws)
    if start.degenerate:
        return _make_empty_fit(cut, start, level)
    rest = rest_bias(every, flights)
    plain = Model((), gain is True, len(throws), gain_spread)
    if rest is not None:
        plain = replace(plain, bias=tuple(rest.value.tolist()), bias_spread=tuple(rest.spread.tolist()))
    tried = fit_models(plain, start, throws, drag, rotor, gain)
    best = tried[0]
    reason = why_nothing_explains(best, throws)
    if reason is not None:
        return replace(_make_empty_fit(cut, start, level), degenerate=reason)
    other = rival(tried)
    models = allow_for_unmodelled(best, throws), None if other is None else allow_for_unmodelled(other, throws)
    return _result(*models, rest, _scores(tried), cut, start, level)


def _scores(tried: list[Solution]) -> list[ModelScore]:
    return [ModelScore(s.model.air, s.model.rotor, s.model.gain, s.model.size, s.aicc, s.bic, rms(s.residuals),
                       s is tried[0]) for s in tried if np.isfinite(s.aicc)]


def _choose_windows(
    logs: list[GyroLog], windows: Sequence[Sequence[Window]] | None, level: float | None
) -> list[list[Window]]:
    if not logs:
        raise InvalidInput("at least one log is needed; got none.")
    if windows is not None and len(windows) != len(logs):
        raise InvalidInput(f"each log needs its windows: got {len(logs)} logs and windows for {len(windows)}.")
    flights = [free_flights(log, level) for log in logs] if windows is None else [list(per_log) for per_log in windows]
    if not any(flights):
        raise InvalidInput(
            "the log has no free flight: no stretch of a quarter of a second keeps an angular momentum, or "
            "feels no weight. Give its start and end."
        )
    for per_log, log in zip(flights, logs, strict=True):
        check_windows(per_log, log)
    return flights


def _cut(log: GyroLog, window: Window, level: float | None) -> tuple[Array, Throw]:
    """Return the times of a window's usable samples, and the throw, whose epoch is near the middle."""
    use = (log.times >= window.start) & (log.times <= window.end)
    if level is not None:
        use &= (np.abs(log.rates) < level * (1 - 1e-6)).all(axis=1)
    times, rates = log.times[use], log.rates[use]
    if len(times) < LOG_LIMITS.min_samples:
        raise InvalidInput(f"a throw must have {LOG_LIMITS.min_samples} samples that are not saturated; got "
                           f"{len(times)}. Throw more slowly, or give a longer window.")
    epoch = float(times[len(times) // 2])
    return times, Throw(times - epoch, rates, epoch)


def _part(solution: Solution, group: str, names: tuple[str, ...]) -> Estimate | None:
    if group not in solution.model.places:
        return None
    place = solution.model.places[group]
    return Estimate(names, solution.parameters[place], solution.covariance[place, place], solution.freedom)


def _result(
    done: Settled, other: Settled | None, rest: RestBias | None, scores: list[ModelScore], cut: list[Any],
    start: Start, level: float | None,
) -> ThrowFit:
    """Return the fit; where models with and without a wheel do about as well, the errors cover both."""
    best, throws = done.solution, [throw for *_, throw in cut]
    inertia = _principal(best)
    if other is not None:
        inertia = widen_errors(inertia, _principal(other.solution))
    reason = why_no_result(best, inertia, throws)
    if reason is not None:
        return replace(_make_empty_fit(cut, start, level), criterion=scores, degenerate=reason)
    parts = np.split(done.predicted, np.cumsum([len(throw.rates) for throw in throws])[:-1])
    fitted = [FittedThrow(k, window, times, throw.rates, part, *_motion(inertia, best, i, throw))
            for i, ((k, window, times, throw), part) in enumerate(zip(cut, parts, strict=True))]
    misfit = _find_misfit(fitted, scores)
    at_rest = None if rest is None else Estimate(BIAS, rest.value, np.diag(rest.spread**2))
    return ThrowFit(
        **_estimates(best, inertia, misfit), axes=inertia.axes, equal=inertia.equal if misfit is None else None,
        rest=at_rest, gain_spread=done.gain_spread, misfit=misfit,
        beside_wheel=None if best.model.rotor or misfit else _beside_wheel(best, done, throws), unmodelled=done.torque,
        widened=done.widened, criterion=scores, with_or_without=other is not None, throws=fitted,
        residuals=best.residuals, rms=rms(best.residuals),
        sigma=best.sigma, jitter=best.jitter, degenerate=None, singular_values=start.singular_values, clip=level,
    )


def _estimates(best: Solution, inertia: Principal, misfit: Misfit | None) -> dict[str, Any]:
    """Return the estimates by their names in a fit, without errors where the residuals are not noise."""
    named = {
        "ratios": inertia.ratios, "axes_error": inertia.turn, "joint": inertia.joint, "bias": _part(best, "bias", BIAS),
        "gain": _part(best, "gain", ("gain x", "gain y", "gain z")),
        "cross_axis": _part(best, "cross_axis", ("gain yz", "gain xz", "gain xy")),
        **{name: inertia.forces.get(name) for name in ("drag", "linear_drag", "one_sided_drag", "rotor")},
    }  # fmt: skip
    if misfit is None:
        return named
    return {name: None if one is None else one.without_errors() for name, one in named.items()}


def _find_misfit(fitted: list[FittedThrow], scores: list[ModelScore]) -> Misfit | None:
    """Return the misfit if the residuals are not noise, else None."""
    turns = max(float(np.median(np.linalg.norm(throw.rates[1:], axis=1) * np.diff(throw.times))) for throw in fitted)
    test = test_filtered_noise([throw.rates - throw.predicted for throw in fitted], turns)
    if test.is_noise:
        return None
    tried = (("air",) if any(score.drag != "none" for score in scores) else ()) + (
        ("wheel",) if any(score.rotor for score in scores) else ())
    return Misfit(test, tried)


def _principal(solution: Solution) -> Principal:
    return principal(solution.parameters, solution.covariance, solution.model.places, solution.axes, solution.freedom)


def _beside_wheel(best: Solution, done: Settled, throws: list[Throw]) -> Float64[Array, "2"]:
    """Return errors of the ratios if a wheel might turn, none smaller than those without."""
    more = covariance_beside_wheel(best, throws) * done.widened
    alone, beside = (_principal(each).ratios.standard_error for each in (best, replace(best, covariance=more)))
    return np.maximum(alone, beside)


def _motion(inertia: Principal, best: Solution, k: int, throw: Throw) -> tuple[FreeMotion | None, str | None]:
    if best.model.rotor:
        return None, None
    rates = inertia.order.T @ best.parameters[best.model.places[f"start {k}"]]
    motion = FreeMotion(inertia.moments, momentum=inertia.moments * rates, epoch=throw.epoch)
    return motion, name_of(motion.regime)


def _make_empty_fit(cut: list[Any], start: Start, level: float | None) -> ThrowFit:
    """Return the result for throws that do not determine the inertia."""
    fitted = [FittedThrow(k, window, times, throw.rates, np.full_like(throw.rates, np.nan), None, None)
            for k, window, times, throw in cut]
    unknown = Estimate(BIAS, np.full(3, np.nan), np.full((3, 3), np.nan))
    return ThrowFit(
        ratios=None, axes=None, axes_error=None, joint=None, equal=None, bias=unknown, rest=None, gain=None,
        cross_axis=None, gain_spread=float("nan"), drag=None, linear_drag=None, one_sided_drag=None, rotor=None,
        beside_wheel=None, unmodelled=float("nan"), widened=1.0, criterion=[], with_or_without=False, throws=fitted,
        residuals=np.empty((0, 3)), rms=float("nan"), sigma=start.noise, jitter=0.0, degenerate=start.degenerate,
        misfit=None, singular_values=start.singular_values, clip=level,
    )
