"""The Chandler wobble as a damped free motion excited by white noise: period and Q by likelihood.

The wobble is the Gauss–Markov process ds = iσ_c s dt + dw of ṁ = iσ_c(m − ψ), σ_c = σ(1 + i/2Q), with a white
excitation ψ. All else that moves the pole is far from white from the lowest frequencies to the highest, so the
likelihood looks at the wobble's band alone: the pole, rotated back at a rate near σ, is averaged over a wobble's
period, which also takes out position and drift. The means z_k of the process have the autocovariance of a damped
walk averaged over steps, exactly; in the band the rest is white noise of the means. The annual term is integrated
out (restricted likelihood).

References: C. R. Wilson, R. O. Vicente, Geophys. J. Int. 103 (1990) 743; M. Furuya, B. F. Chao, Geophys. J. Int. 127
(1996) 693; H. Working, Econometrica 28 (1960) 916 for a walk's averages.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import cho_solve, cholesky, solve_triangular, toeplitz
from scipy.optimize import brentq, minimize
from scipy.stats import chi2

from polhode._base.arrays import known_numbers_only
from polhode.celestial.wobble._pole_series import DAY, Pole, even
from polhode.celestial.wobble.estimation import ANNUAL, ChandlerFit, fit_chandler
from polhode.estimation._estimate import Estimate
from polhode.special._residual_noise import NoiseTest
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

LEVELS = (0.6827, 0.95)
UNIT = 433.0 * DAY


class SearchBounds(NamedTuple):
    """Ends of the search for the parameters of the process."""

    period: tuple[float, float] = (380.0 / 433.0, 490.0 / 433.0)  # in units of 433 d
    # ln Q; a wobble of longer life is not distinguished from one without damping by any series there is
    quality: tuple[float, float] = (np.log(2.0), np.log(1e5))
    noise: tuple[float, float] = (-9.0, 14.0)  # ln of the noise's variance over that of the walk in a step


BOUNDS = SearchBounds()


@dataclass(frozen=True, eq=False)
class ChandlerProcess:
    """Period and Q of the Chandler wobble by likelihood, and the wobble itself.

    Attributes:
        estimate: ``period`` [s] and ``quality_factor``, with errors by the curvature of the likelihood; Q has an
            infinite one where its interval of one standard deviation has no upper end.
        period_intervals: probability → ends of the interval of the period [s], by the likelihood's profile.
        quality_intervals: likewise of Q, wider above than below. The upper end is infinite where the likelihood does
            not refuse a wobble without damping.
        excitation: spectral density of the excitation at the wobble's rate, two-sided [rad² s].
        noise: standard deviation of the rest of the motion, in a complex mean over a step [rad].
        step: over which means are taken [s].
        times: (n,) middles of the steps [s].
        wobble: (n,) the complex wobble's means, estimated from all data [rad]; they turn at the fitted line's rate.
        wobble_error: (n,) standard deviation of each of its components [rad].
        whiteness: probability of innovations as correlated as these (Ljung–Box over 6 steps), were they white. Where
            they are not, errors and intervals are NaN.
    """

    estimate: Estimate
    period_intervals: dict[float, tuple[float, float]]
    quality_intervals: dict[float, tuple[float, float]]
    excitation: float
    noise: float
    step: float
    times: Float64[Array, "n"] = field(repr=False)
    wobble: Complex128[Array, "n"] = field(repr=False)
    wobble_error: Float64[Array, "n"] = field(repr=False)
    whiteness: float

    @property
    def is_noise(self) -> bool:
        """Whether the innovations are noise, for which alone the errors hold."""
        return NoiseTest(self.whiteness, 0.0).is_noise


class _Band(NamedTuple):
    """Means over steps, rotated back at ``rate``: the pole in column 0, the annual term in column 1."""

    data: Complex128[Array, "n c"]
    rate: float
    step: float


class _Filtered(NamedTuple):
    cost: float
    scale: float
    values: Complex128[Array, "c"]
    innovations: Complex128[Array, "n"]


@known_numbers_only
def fit_chandler_process(
    times: Real[ArrayLike, "n"], x: Real[ArrayLike, "n"], y: Real[ArrayLike, "n"]
) -> ChandlerProcess:
    """Estimate period and Q of the Chandler wobble as a Gauss–Markov process, by restricted likelihood.

    Unlike a fitted line, the process expects amplitude and phase to change, so that its errors hold for the free
    wobble. Intervals are by the likelihood's profile. Q is poorly determined: 64 years of a wobble with Q = 100 leave
    it open by a factor of two or more.

    Args:
        times: [s], ascending, without gaps longer than 5 d or the usual step.
        x: the pole towards Greenwich [rad].
        y: the pole towards 90° West [rad].

    Raises:
        InvalidInput: for series that ``fit_chandler`` refuses, or with gaps.

    Example:
        >>> import numpy as np
        >>> t = 20 * 86400.0 * np.arange(900.0)
        >>> kicks, s = np.random.default_rng(2).normal(size=(900, 2)) @ [1e-7, 1e-7j], np.zeros(900, complex)
        >>> for k in range(1, 900):
        ...     s[k] = np.exp((2j - 0.01) * np.pi * 20 / 433) * s[k - 1] + kicks[k]
        >>> process = fit_chandler_process(t, s.real, -s.imag)
        >>> low, high = process.period_intervals[0.95]
        >>> low < 433 * 86400 < high
        True
    """
    line = fit_chandler(times, x, y)
    band, middles = _take_band(line)
    cost = lambda p: _filter(p, band).cost  # noqa: E731
    starts = [np.array([line.estimate.value[0] / UNIT, np.log(q), r]) for q, r in ((50.0, 0.0), (300.0, 2.0))]
    best = min((minimize(cost, start, method="Nelder-Mead", bounds=BOUNDS, options={"xatol": 1e-5, "fatol": 1e-7})
                for start in starts), key=lambda minimum: minimum.fun)
    intervals = [_intervals(cost, best.x, float(best.fun), k) for k in (0, 1)]
    filtered = _filter(best.x, band)
    quality = float(np.exp(best.x[1]))
    slopes = np.array([UNIT, quality])
    covariance = np.linalg.pinv(_curvature(cost, best.x), hermitian=True)[:2, :2] * np.outer(slopes, slopes)
    if (np.diagonal(covariance) <= 0.0).any() or not np.isfinite(intervals[1][LEVELS[0]][1]):  # Q has no upper bound
        covariance = np.diag([(0.5 * UNIT * np.subtract(*intervals[0][LEVELS[0]])) ** 2, np.inf])
    estimate = Estimate(("period", "quality_factor"), np.array([best.x[0] * UNIT, quality]), covariance)
    wobble, error = _smooth(best.x, band, filtered)
    rate = 2.0 * np.pi / estimate.value[0]
    process = ChandlerProcess(
        estimate, {level: (a * UNIT, b * UNIT) for level, (a, b) in intervals[0].items()},
        {level: (float(np.exp(a)), float(np.exp(b))) for level, (a, b) in intervals[1].items()},
        # dm/dt = iσ (m − χ): the walk's variance in a step is σ²Δ S, with Δ the step and S the density of χ
        float(filtered.scale * band.step / (rate * band.step) ** 2),
        float(np.sqrt(filtered.scale * np.exp(best.x[2]))), band.step, middles,
        wobble * np.exp(1j * band.rate * (middles - line.epoch)), error, _whiteness(filtered.innovations),
    )
    return process if process.is_noise else _without_errors(process)


def _without_errors(process: ChandlerProcess) -> ChandlerProcess:
    """Return the process without errors and intervals."""
    unknown = dict.fromkeys(LEVELS, (float("nan"), float("nan")))
    return replace(process, estimate=process.estimate.without_errors(), period_intervals=unknown,
                   quality_intervals=unknown, wobble_error=np.full_like(process.wobble_error, np.nan))


def _take_band(line: ChandlerFit) -> tuple[_Band, Float64[Array, "n"]]:
    """Return the band about the wobble, without the terms fitted far from it, and the middles of its steps."""
    clock = line.times - line.epoch
    rate = line.rates["chandler_prograde"]
    m = line.left + line.term("chandler_prograde") * np.exp(1j * rate * clock)  # the annual term is fitted once more
    step = 2.0 * np.pi / rate
    parts = [values * np.exp(-1j * rate * clock) for values in (m, np.exp(1j * ANNUAL * clock))]
    means = [even(Pole(line.times, part, np.ones(len(clock))), step) for part in parts]
    return _Band(np.stack([mean.m for mean in means], axis=1), rate, step), means[0].times


def _covariance(p: Float64[Array, "3"], band: _Band) -> Complex128[Array, "n n"]:
    """Return the covariance of the wobble's means, where a walk's variance grows by 1 in a step."""
    rate = 2.0 * np.pi / (p[0] * UNIT)
    # dm/dt = (iσ − σ/2Q) m + white noise: times j steps apart have the covariance e^{−aj}/(2 Re a), where
    # a = (σ/2Q − i(σ − fitted rate)) × step, as the data are rotated back at the fitted rate
    decay = 0.5 * rate * np.exp(-p[1]) * band.step
    a = decay - 1j * (rate - band.rate) * band.step
    count = len(band.data)
    still = 0.5 / decay  # variance of the process itself
    # ∫∫ e^{−a(k + u − v)} du dv over 0 ≤ u, v ≤ 1 is e^{−a(k − 1)} ((1 − e^{−a})/a)²; for k = 0 it is
    # 2 Re ∫ (1 − x) e^{−ax} dx = 2 Re (a − 1 + e^{−a})/a²
    column = still * (-np.expm1(-a) / a) ** 2 * np.exp(-a * (np.arange(count) - 1.0))
    column[0] = still * 2.0 * ((a + np.expm1(-a)) / a**2).real
    return toeplitz(column)


def _filter(p: Float64[Array, "3"], band: _Band) -> _Filtered:
    """Return minus the restricted log-likelihood, the variance of the walk in a step, coefficients and innovations."""
    covariance = _covariance(p, band) + np.exp(p[2]) * np.eye(len(band.data))
    factor = cholesky(covariance, lower=True, check_finite=False)
    white = solve_triangular(factor, band.data, lower=True, check_finite=False)
    basis, target = white[:, 1:], white[:, 0]
    # with V = L Lᴴ and columns X, of p columns: least squares of L⁻¹y on L⁻¹X = QR; minus the restricted
    # log-likelihood, at its best scale, is (n − p) ln scale + ln|V| + ln|Xᴴ V⁻¹ X|, the last ln|Rᴴ R|. Complex data
    # count twice, so that no halves are left
    q, r = np.linalg.qr(basis)
    inside = q.conj().T @ target
    left = target - q @ inside
    free = len(left) - basis.shape[1]
    scale = float(np.vdot(left, left).real) / free
    logs = 2.0 * np.sum(np.log(np.real(np.diagonal(factor)))) + 2.0 * np.sum(np.log(np.abs(np.diagonal(r))))
    return _Filtered(free * np.log(scale) + logs, scale, np.linalg.solve(r, inside), left / np.sqrt(scale))


def _curvature(cost: Callable[[Float64[Array, "3"]], float], at: Float64[Array, "3"]) -> Float64[Array, "3 3"]:
    """Return second derivatives by differences, at steps over which the likelihood changes by about one."""
    steps = np.eye(3) * np.array([1e-3, 0.1, 0.1])
    hessian = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            a, b = steps[i], steps[j]
            hessian[i, j] = (cost(at + a + b) - cost(at + a - b) - cost(at - a + b) + cost(at - a - b)) / 4.0
    size = np.diagonal(steps)
    return hessian / np.outer(size, size)


def _intervals(
    cost: Callable[[Float64[np.ndarray, "3"]], float], best: Float64[np.ndarray, "3"], least: float, k: int
) -> dict[float, tuple[float, float]]:
    """Return intervals of one parameter: where the profile of the likelihood falls by half a quantile of χ²."""
    others = [j for j in range(3) if j != k]
    limits = [BOUNDS[j] for j in others]

    def rise(value: float) -> float:
        def along(rest: Float64[Array, "2"]) -> float:
            p = best.copy()
            p[k], p[others] = value, rest
            return cost(p)

        minimum = minimize(along, best[others], method="Nelder-Mead", bounds=limits,
                         options={"xatol": 1e-3, "fatol": 1e-3, "maxfev": 80})
        return float(minimum.fun) - least

    reach = (0.004, 0.3)[k]
    intervals = {}
    for level in LEVELS:
        height = 0.5 * float(chi2.ppf(level, 1))
        low, high = BOUNDS[k]
        intervals[level] = (_end(rise, best[k], -reach, height, low), _end(rise, best[k], reach, height, high))
    return intervals


def _end(rise: Callable[[float], float], start: float, reach: float, height: float, limit: float) -> float:
    """Return where a profile has risen by a height; infinite, or the lower bound, where it does not."""
    inner, outer = start, start + reach
    for _ in range(30):
        if (outer - limit) * np.sign(reach) >= 0.0:
            outer = limit
        if rise(outer) > height:
            root: Any = brentq(lambda value: rise(value) - height, inner, outer, xtol=0.02 * abs(reach))
            return float(root)
        if outer == limit:
            break
        inner, outer = outer, outer + 2.0 * (outer - start)
    return float("inf") if reach > 0 else float(limit)


def _smooth(
    p: Float64[Array, "3"], band: _Band, filtered: _Filtered
) -> tuple[Complex128[Array, "n"], Float64[Array, "n"]]:
    """Return the wobble's means given all data, rotated back, and the standard deviation of each component."""
    wobble = _covariance(p, band)
    factor = cholesky(wobble + np.exp(p[2]) * np.eye(len(wobble)), lower=True)
    # with the covariance C of the wobble and V = C + noise of the data, E[m | y] = C V⁻¹ (y − Xβ); its error
    # has the covariance C − C V⁻¹ C
    mean = wobble @ cho_solve((factor, True), band.data[:, 0] - band.data[:, 1:] @ filtered.values)
    whitened = solve_triangular(factor, wobble, lower=True)
    variance = np.real(np.diagonal(wobble)) - np.sum(np.abs(whitened) ** 2, axis=0)
    return mean, np.sqrt(0.5 * filtered.scale * np.maximum(variance, 0.0))


def _whiteness(innovations: Complex128[Array, "n"]) -> float:
    # 2n |r_k|² of white complex noise is χ² with two degrees; Ljung and Box weigh its sum by (n + 2)/(n − k)
    order = 6  # steps over which innovations are tested
    count = len(innovations)
    power = float(np.vdot(innovations, innovations).real)
    lags = [abs(np.vdot(innovations[:-k], innovations[k:])) ** 2 / power**2 / (count - k) for k in range(1, order + 1)]
    return float(chi2.sf(2.0 * count * (count + 2) * sum(lags), 2 * order))
