"""The Chandler wobble and the seasons in the motion of the Earth's pole, by least squares.

The pole is m = x − i y, with x towards Greenwich and y towards 90° West, as the IERS has them; prograde motion, with
the Earth's spin, goes as exp(+iσt). Model: a position, a drift, annual and semiannual terms of both senses, and
the Chandler wobble of both senses at one rate σ, which is fitted too.

References: K. Lambeck, The Earth's Variable Rotation, Cambridge 1980, ch. 7; J. Vondrák, C. Ron, Y. Chapanov,
Adv. Space Res. 59 (2017) 1395.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar
from scipy.special import factorial

from polhode._base.arrays import known_numbers_only
from polhode.celestial.wobble._pole_series import DAY, YEAR, average_steps, clean_pole, step_moments
from polhode.errors import InvalidInput
from polhode.estimation._estimate import Estimate
from polhode.estimation._last_steps import take_last_steps
from polhode.estimation._line_noise import LineNoise, accumulate_walk, level_at, noise_about
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

STEP = 5.0 * DAY  # means over it are fitted, as the model changes little within it
ANNUAL = 2.0 * np.pi / YEAR
SEASONS = {"annual_prograde": ANNUAL, "annual_retrograde": -ANNUAL,
           "semiannual_prograde": 2.0 * ANNUAL, "semiannual_retrograde": -2.0 * ANNUAL}  # fmt: skip


class ChandlerLimits(NamedTuple):
    """What decides whether a series has a Chandler wobble."""

    min_period: float = 380.0 * DAY  # s, sought
    max_period: float = 490.0 * DAY  # s, sought
    min_span: float = 2.0 * 6.39 * 365.25 * DAY  # s: twice the beat of 433 d and a year; `fit_chandler` says why
    min_significance: float = 3.0  # standard errors of the amplitude; a line with less is noise


LIMITS = ChandlerLimits()


@dataclass(frozen=True, eq=False)
class ChandlerFit:
    """A fit of polar motion: the Chandler wobble as one line, seasons and drift.

    Attributes:
        estimate: ``period`` [s], ``amplitude`` [rad] and ``phase`` [rad] at ``epoch`` of the prograde wobble. The
            amplitude is that of the *mean* wobble over the span, as one line cannot describe a wobble that
            changes.
        terms: real and imaginary part [rad] of each term at ``epoch``, as ``annual_prograde_re``, and of position
            (``mean``) and ``drift`` [rad/s].
        rates: name of a term → its rate [rad/s].
        epoch: middle of the span [s].
        times: (n,) of the means that were fitted [s].
        pole: (n,) complex means [rad].
        left: (n,) residuals of the model [rad].
        noise: about the wobble's line. Where its test says that something else moves the pole next to the line, nothing
            has a known error (NaN).
        rms: of ``left``, over both coordinates [rad].
        inflation: factor by which the seasons, the drift and all else fitted enlarge the variance of the rate.
    """

    estimate: Estimate
    terms: Estimate
    rates: dict[str, float]
    epoch: float
    times: Float64[Array, "n"] = field(repr=False)
    pole: Complex128[Array, "n"] = field(repr=False)
    left: Complex128[Array, "n"] = field(repr=False)
    noise: LineNoise
    rms: float
    inflation: float

    @property
    def energy_ratio(self) -> float:
        """Square of the retrograde over the prograde amplitude at the wobble's rate; 1 for motion along a line."""
        return float(abs(self.term("chandler_retrograde")) ** 2 / abs(self.term("chandler_prograde")) ** 2)

    def term(self, name: str) -> complex:
        """Return the complex amplitude of a term at ``epoch``, ``mean`` [rad] or ``drift`` [rad/s]."""
        k = self.terms.names.index(f"{name}_re")
        return complex(self.terms.value[k], self.terms.value[k + 1])

    def amplitude(self, name: str) -> tuple[float, float]:
        """Return the amplitude of a term and its standard error [rad]."""
        k = self.terms.names.index(f"{name}_re")
        return _polar(self.terms.value[k : k + 2], self.terms.covariance[k : k + 2, k : k + 2])


class _Series(NamedTuple):
    """Means over steps: their times from the epoch (n,), the pole (n,), and mean powers of time within steps (n, k)."""

    clock: Float64[Array, "n"]
    m: Complex128[Array, "n"]
    moments: Float64[Array, "n k"]
    span: float


class _Model(NamedTuple):
    columns: Complex128[Array, "n c"]
    values: Complex128[np.ndarray, "c"]
    left: Complex128[Array, "n"]


@known_numbers_only
def fit_chandler(times: Real[ArrayLike, "n"], x: Real[ArrayLike, "n"], y: Real[ArrayLike, "n"]) -> ChandlerFit:
    """Fit the Chandler wobble, its rate included, with drift and seasons, by least squares.

    Errors allow for coloured noise and for a wobble whose amplitude and phase walk, as estimated from the residuals on
    both sides of each line (``line_noise``); simulations of both cover the true period as often as they should.

    The wobble and the year beat in 6.39 a, and two beats are asked for. Over one, the seasons enlarge the variance
    of the rate by half. In windows of 7 years of series C04 the period scatters by 7 d, more than twice its error
    there, since the residuals are too few to estimate the noise; in windows of 13 years by 3.5 d, as its errors say.

    Args:
        times: [s], ascending; gaps are allowed.
        x: the pole towards Greenwich [rad].
        y: the pole towards 90° West [rad].

    Raises:
        InvalidInput: for series that are not finite, not in radians, shorter than two beats, without a wobble in it, or
            with one that turns the wrong way, as when a sign is flipped.

    Example:
        >>> import numpy as np
        >>> t = 86400.0 * np.arange(0.0, 9000.0, 10.0)
        >>> m = 7e-7 * np.exp(2j * np.pi * t / (433.0 * 86400.0)) + 4e-7 * np.exp(2j * np.pi * t / 31556926.0)
        >>> noise = 1e-9 * np.random.default_rng(1).normal(size=(2, len(t)))
        >>> fit = fit_chandler(t, m.real + noise[0], -m.imag + noise[1])
        >>> [round(float(fit.estimate.value[0]) / 86400.0, 1), round(float(fit.estimate.value[1]) * 1e7, 2)]
        [433.0, 7.0]
    """
    orders = 9  # of powers of the turn within half a step, 0.09 at most
    samples = clean_pole(times, x, y)
    pole = average_steps(samples, STEP)
    if pole.span < LIMITS.min_span:
        raise InvalidInput(f"the series must last {LIMITS.min_span / YEAR:.1f} years, twice the beat of the wobble and "
                           f"the year, to separate the two; got {pole.span / YEAR:.2f} years. Give a longer series."
                           )
    epoch = 0.5 * float(pole.times[0] + pole.times[-1])
    series = _Series(pole.times - epoch, pole.m, step_moments(samples, STEP, orders), pole.span)
    rate, undone = _best_rate(series)
    rates = {**SEASONS, "chandler_prograde": rate, "chandler_retrograde": -rate}
    model = _solve(series, rate)
    _check_sense(abs(model.values[4]), abs(model.values[5]))
    noise, covariance, degrees, inflation = _errors(series, model, rate, undone)
    names = [f"{name}_{part}" for name in (*rates, "mean", "drift") for part in ("re", "im")]
    values = model.values.copy()
    values[-1] /= pole.span
    scale = np.ones(len(names) + 1)
    scale[-3:-1] = 1.0 / pole.span
    covariance = covariance * np.outer(scale, scale)
    parts = np.stack([np.real(values), np.imag(values)], axis=1).ravel()
    terms = Estimate(tuple(names), parts, covariance[:-1, :-1], degrees)
    estimate = _headline(rate, values[4], covariance[np.ix_([-1, 8, 9], [-1, 8, 9])], degrees)
    if estimate.value[1] < LIMITS.min_significance * estimate.standard_error[1]:
        raise InvalidInput(f"no Chandler wobble exceeds the noise: its amplitude is {estimate.value[1]:.2g} ± "
                           f"{estimate.standard_error[1]:.2g} rad. Give a longer series, or check columns and units."
                           )
    rms = float(np.sqrt(0.5 * np.mean(np.abs(model.left) ** 2)))
    if not noise.test.is_noise:
        estimate, terms = estimate.without_errors(), terms.without_errors()
    return ChandlerFit(estimate, terms, rates, epoch, pole.times, pole.m, model.left, noise, rms, inflation)


def _best_rate(series: _Series) -> tuple[float, float]:
    """Return the rate [rad/s] with the least residuals, the global minimum over the admitted periods, and the error
    that the search leaves."""

    def cost(rate: float) -> float:
        left = _solve(series, rate).left
        return float(np.vdot(left, left).real)

    low, high = 2.0 * np.pi / LIMITS.max_period, 2.0 * np.pi / LIMITS.min_period
    grid = np.linspace(low, high, int((high - low) * series.span / (2.0 * np.pi) * 6.0) + 8)
    costs = [cost(rate) for rate in grid]
    best = int(np.argmin(costs))
    if best in (0, len(grid) - 1):
        raise InvalidInput(f"no Chandler wobble with a period between {LIMITS.min_period / DAY:g} and "
                           f"{LIMITS.max_period / DAY:g} d is in the series: the fit runs to an end. Check columns "
                           "and units, or give a longer series.")
    minimum: Any = minimize_scalar(cost, bounds=(grid[best - 1], grid[best + 1]), method="bounded",
                            options={"xatol": 1e-7 * grid[best]})
    turn = float(minimum.x) * series.span
    x, left = take_last_steps(_RateSystem(series), np.array([turn]), np.array([-np.inf]), np.array([np.inf]))
    return float(x[0]) / series.span, float(left[0]) / series.span


class _RateSystem:
    """Residuals over their rms, and their derivatives by the turn of the wobble in the span, all else fitted."""

    def __init__(self, series: _Series) -> None:
        self.series = series
        self.size: float | None = None

    def residuals(self, x: Float64[Array, "1"]) -> Float64[Array, "m"]:
        left = _solve(self.series, float(x[0]) / self.series.span).left
        if self.size is None:
            self.size = max(float(np.sqrt(0.5 * np.mean(np.abs(left) ** 2))), 1e-300)
        return np.concatenate([left.real, left.imag]) / self.size

    def jacobian(self, x: Float64[Array, "1"]) -> Float64[Array, "m 1"]:
        rate = float(x[0]) / self.series.span
        model = _solve(self.series, rate)
        bend = _bend(self.series, model, rate)
        own = bend - model.columns @ np.linalg.lstsq(model.columns, bend, rcond=None)[0]
        assert self.size is not None
        return -np.concatenate([np.real(own), np.imag(own)])[:, None] / (self.size * self.series.span)


def _waves(series: _Series, rates: list[float], slope: bool = False) -> Complex128[Array, "n c"]:
    """Return e^{iσt} of each rate, of means over the samples of each step, or its derivatives by σ."""
    # about the mean time t of a step's samples the mean of e^{iσ(t + u)} is e^{iσt} Σ (iσ)ᵏ ⟨uᵏ⟩/k!
    k = np.arange(series.moments.shape[1])
    parts = (1j * np.array(rates)) ** k[:, None] / factorial(k)[:, None]
    turn = np.exp(1j * np.outer(series.clock, rates))
    mean = series.moments @ parts
    if not slope:
        return turn * mean
    return 1j * turn * (series.clock[:, None] * mean + series.moments[:, 1:] @ parts[:-1])


def _solve(series: _Series, rate: float) -> _Model:
    """Return the least squares of all lines, position and drift over the span, for a rate of the wobble."""
    waves = _waves(series, [*SEASONS.values(), rate, -rate])
    columns = np.concatenate([waves, np.ones((len(waves), 1)), series.clock[:, None] / series.span], axis=1)
    values = np.linalg.lstsq(columns, series.m, rcond=None)[0]
    return _Model(columns, values, series.m - columns @ values)


def _bend(series: _Series, model: _Model, rate: float) -> Complex128[Array, "n"]:
    """Return the derivative of the fitted pole by the wobble's rate."""
    return _waves(series, [rate, -rate], slope=True) @ (model.values[4:6] * [1.0, -1.0])


def _check_sense(prograde: float, retrograde: float) -> None:
    if retrograde >= prograde:
        raise InvalidInput(
            f"the wobble turns against the Earth's spin: {retrograde:.3g} rad retrograde, {prograde:.3g} rad prograde. "
            "x must be towards Greenwich and y towards 90° West, as the IERS has them. Change the sign of y, or swap x "
            "and y if they are exchanged.")


def _errors(
    series: _Series, model: _Model, line: float, undone: float
) -> tuple[LineNoise, Float64[Array, "p p"], float, float]:
    """Return the noise, the covariance of all parameters (real, imaginary, …, rate), its degrees of freedom, and the
    inflation of the rate's variance."""
    clock, rates = series.clock, [*SEASONS.values(), line, -line]
    bend = _bend(series, model, line)
    basis = np.stack([model.columns, 1j * model.columns], axis=2).reshape(len(clock), -1)
    basis = np.concatenate([basis, bend[:, None]], axis=1)
    size = np.sqrt(np.sum(np.abs(basis) ** 2, axis=0))
    basis = basis / size
    normal = (basis.conj().T @ basis).real
    inverse = np.linalg.inv(normal)
    removed = np.linalg.qr(np.concatenate([model.columns, bend[:, None]], axis=1))[0]
    left = model.left - removed @ (removed.conj().T @ model.left)  # the change of amplitude too, as the noise expects
    noise = noise_about(clock, left, removed, line)
    levels = [noise.white if rate == line else level_at(clock, left, removed, rate) for rate in rates]
    still = level_at(clock, left, removed, 0.0)
    each = np.sqrt(np.array([*np.repeat(levels, 2), *[still] * 4, noise.white]))
    # N⁻¹ (Re Aᴴ V A) N⁻¹/2 with N = Re Aᴴ A: half of a complex residual's variance is in each real part. V is taken as
    # the level of noise near each line, √(s_i s_j) N_ij
    steady = inverse @ (np.outer(each, each) * normal) @ inverse * 0.5
    # a step of the walk changes all later samples by e^{iσt}: its influence is a sum from the end
    influence = accumulate_walk((basis @ inverse) * np.exp(-1j * line * clock)[:, None])
    walking = 0.5 * np.real(influence.conj().T @ influence)
    covariance = steady + noise.walk * walking
    share = np.array([steady[-1, -1] / noise.white if noise.white > 0.0 else 0.0, walking[-1, -1]])
    spread = share @ noise.covariance @ share
    # degrees of freedom as Satterthwaite has them, 2 V²/var V for an estimated variance V
    degrees = float(np.clip(2.0 * covariance[-1, -1] ** 2 / spread, 2.0, 1e6))
    alone = basis[:, [8, 9, -1]]
    inflation = inverse[-1, -1] / np.linalg.inv((alone.conj().T @ alone).real)[-1, -1]
    # the error that the search leaves counts too, and is the larger one for series without noise
    moved = np.linalg.lstsq(model.columns, -undone * bend, rcond=None)[0]
    last = np.array([*np.stack([moved.real, moved.imag], axis=1).ravel(), undone])
    phase = np.finfo(float).eps * 0.5 * line * series.span  # by which a phase at the ends is rounded
    rounded = np.array([*[phase * abs(model.values[4])] * (len(size) - 1), np.finfo(float).eps * line])
    covariance = covariance / np.outer(size, size) + np.outer(last, last) + np.diag(rounded**2)
    return noise, covariance, degrees, float(inflation)


def _headline(rate: float, value: complex, covariance: Float64[Array, "3 3"], degrees: float) -> Estimate:
    """Return period, amplitude and phase, from rate, real and imaginary part."""
    size = abs(value)
    # T = 2π/σ, A = √(x² + y²) and φ = arg(x + iy) by σ, x and y
    slopes = np.array([
        [-2.0 * np.pi / rate**2, 0.0, 0.0],
        [0.0, value.real / size, value.imag / size],
        [0.0, -value.imag / size**2, value.real / size**2],
    ])  # fmt: skip
    values = np.array([2.0 * np.pi / rate, size, float(np.angle(value))])
    return Estimate(("period", "amplitude", "phase"), values, slopes @ covariance @ slopes.T, degrees)


def _polar(parts: Float64[Array, "2"], covariance: Float64[Array, "2 2"]) -> tuple[float, float]:
    size = float(np.hypot(*parts))
    along = parts / size if size > 0.0 else np.array([1.0, 0.0])
    return size, float(np.sqrt(along @ covariance @ along))
