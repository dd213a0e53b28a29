"""The Chandler wobble in sliding windows, and the spectrum of the pole."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.celestial.wobble._pole_series import DAY, YEAR, Pole, average_steps, clean_pole, even
from polhode.celestial.wobble.estimation import LIMITS as CHANDLER
from polhode.celestial.wobble.estimation import SEASONS, STEP, fit_chandler
from polhode.errors import InvalidInput, shown
from polhode.estimation._line_noise import level_at
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

SIX_YEARS = 6.0 * YEAR


class WindowLimits(NamedTuple):
    """What windows are refused or left out."""

    # s: there the seasons enlarge the amplitude's variance by a third, over six years by 2 %
    min_window: float = 4.0 * YEAR
    min_filled: float = 0.9  # of a window, by samples


LIMITS = WindowLimits()


@dataclass(frozen=True, eq=False)
class ChandlerWindows:
    """The wobble, as one line of fixed rate in each of many windows that overlap.

    Attributes:
        centres: (k,) middles of the windows [s].
        value: (k,) complex amplitude: the wobble is ``value`` · exp(i · ``rate`` · (t − ``epoch``)) [rad].
        covariance: (k, 2, 2) of its real and imaginary part [rad²].
        rate: [rad/s].
        epoch: [s].
        window: length [s].
    """

    centres: Float64[Array, "k"]
    value: Complex128[Array, "k"]
    covariance: Float64[Array, "k 2 2"]
    rate: float
    epoch: float
    window: float

    @property
    def amplitude(self) -> Float64[Array, "k"]:
        """Amplitudes [rad]."""
        return np.abs(self.value)

    @property
    def phase(self) -> Float64[Array, "k"]:
        """Phases [rad], continuous from window to window; constant for a wobble at ``rate``."""
        return np.unwrap(np.angle(self.value))

    @property
    def amplitude_error(self) -> Float64[Array, "k"]:
        """Standard deviations of the amplitudes [rad]."""
        return self._error(np.stack([self.value.real, self.value.imag], axis=1) / self.amplitude[:, None])

    @property
    def phase_error(self) -> Float64[Array, "k"]:
        """Standard deviations of the phases [rad]."""
        across = np.stack([-self.value.imag, self.value.real], axis=1) / self.amplitude[:, None]
        return self._error(across) / self.amplitude

    def _error(self, along: Float64[Array, "k 2"]) -> Float64[Array, "k"]:
        return np.sqrt(np.einsum("ki,kij,kj->k", along, self.covariance, along))


@dataclass(frozen=True, eq=False)
class PoleSpectrum:
    """Spectral density of the complex pole.

    Attributes:
        frequencies: (k,) [Hz], ascending; positive ones are prograde.
        density: (k,) two-sided [rad²/Hz]. Each is the truth times χ²/2 of two degrees of freedom.
    """

    frequencies: Float64[Array, "k"]
    density: Float64[Array, "k"]


@known_numbers_only
def fit_chandler_windows(
    times: Real[ArrayLike, "n"], x: Real[ArrayLike, "n"], y: Real[ArrayLike, "n"], window: float = SIX_YEARS,
    period: float | None = None,
) -> ChandlerWindows:
    """Fit amplitude and phase of the wobble in windows that slide by a quarter of a year.

    In each window position, drift, seasons and the prograde wobble at one rate are fitted. Errors are by the
    residuals on both sides of the line; a value is the mean wobble of its window. Windows shorter than 4 years are
    refused: there the year and the wobble, which beat in 6.4 years, are hardly separated.

    Args:
        times: [s], ascending; windows with gaps of more than a tenth of them are left out.
        x: the pole towards Greenwich [rad].
        y: the pole towards 90° West [rad].
        window: length [s].
        period: of the wobble [s]; that of ``fit_chandler`` if None.

    Raises:
        InvalidInput: for a series that is wrong, a window too short or longer than it, a period not near 433 d.

    Example:
        >>> import numpy as np
        >>> t = 86400.0 * np.arange(0.0, 4000.0, 5.0)
        >>> m = (1 + t / t[-1]) * 5e-7 * np.exp(2j * np.pi * t / (433 * 86400))
        >>> windows = fit_chandler_windows(t, m.real, -m.imag, period=433 * 86400)
        >>> (windows.amplitude[[0, -1]] * 1e7).round(1).tolist()
        [6.4, 8.5]
    """
    spacing = 0.25 * YEAR  # of windows
    raw = clean_pole(times, x, y)
    if not LIMITS.min_window * 0.999 <= window <= raw.span:
        raise InvalidInput(f"the window must be from {LIMITS.min_window / YEAR:g} years, which separate the wobble "
                           f"from the year, to the series' {raw.span / YEAR:.2f} years; got {shown(window / YEAR)}. "
                           "Leave it out for 6 years.")
    if period is None:
        period = float(fit_chandler(times, x, y).estimate.value[0])
    if not CHANDLER.min_period <= period <= CHANDLER.max_period:
        raise InvalidInput(f"`period` must be from {CHANDLER.min_period / DAY:g} to {CHANDLER.max_period / DAY:g} d, "
                           f"in seconds; got {shown(period)}. Leave it out to have it fitted.")
    pole = average_steps(raw, STEP)
    epoch = 0.5 * float(pole.times[0] + pole.times[-1])
    rate = 2.0 * np.pi / period
    steps = int((pole.span - window) / spacing + 1e-6)
    centres = pole.times[0] + 0.5 * window + spacing * np.arange(steps + 1)
    usual = float(np.median(np.diff(pole.times)))
    windows = []
    for centre in centres:
        inside = np.abs(pole.times - centre) <= 0.5 * window
        if inside.sum() * usual > LIMITS.min_filled * window:
            windows.append((centre, *_in_window(pole.times[inside] - epoch, pole.m[inside], rate)))
    if not windows:
        raise InvalidInput(f"no window of {window / YEAR:g} years is full: the gaps are too long. Choose another span.")
    middles, values, variances = map(np.array, zip(*windows, strict=True))
    covariance = 0.5 * variances[:, None, None] * np.eye(2)
    return ChandlerWindows(middles, values, covariance, rate, epoch, float(window))


def _in_window(clock: Float64[Array, "n"], m: Complex128[Array, "n"], rate: float) -> tuple[complex, float]:
    """Return the complex amplitude and its variance, of both components together."""
    waves = np.exp(1j * np.outer(clock, [rate, *SEASONS.values()]))
    middle, span = clock.mean(), np.ptp(clock)
    columns = np.concatenate([waves, np.ones((len(clock), 1)), (clock[:, None] - middle) / span], axis=1)
    q, r = np.linalg.qr(columns)
    inside = q.conj().T @ m
    left = m - q @ inside
    inverse = np.linalg.inv(r)
    # c = R⁻¹ Qᴴ m: the first has the variance of the noise times |row 1 of R⁻¹|²
    return complex(inverse[0] @ inside), level_at(clock, left, q, rate) * float(np.sum(np.abs(inverse[0]) ** 2))


@known_numbers_only
def pole_spectrum(times: Real[ArrayLike, "n"], x: Real[ArrayLike, "n"], y: Real[ArrayLike, "n"]) -> PoleSpectrum:
    """Return the spectral density of the complex pole, prograde and retrograde, by a Hann window.

    Position and drift are taken out first; means over 5 d are transformed.

    Args:
        times: [s], ascending, without gaps longer than 5 d or the usual step.
        x: the pole towards Greenwich [rad].
        y: the pole towards 90° West [rad].

    Raises:
        InvalidInput: for a series that is wrong, or with gaps.

    Example:
        >>> import numpy as np
        >>> t = 86400.0 * np.arange(4000.0)
        >>> spectrum = pole_spectrum(t, np.cos(t / 6e6) * 1e-7, -np.sin(t / 6e6) * 1e-7)
        >>> bool(abs(spectrum.frequencies[np.argmax(spectrum.density)] * 2 * np.pi * 6e6 - 1) < 0.1)
        True
    """
    raw = clean_pole(times, x, y)
    step = max(STEP, float(np.median(np.diff(raw.times))))
    pole: Pole = even(raw, step)
    columns = np.stack([np.ones(len(pole.m)), (pole.times - pole.times.mean()) / pole.span], axis=1)
    left = pole.m - columns @ np.linalg.lstsq(columns, pole.m, rcond=None)[0]
    taper = np.hanning(len(left) + 2)[1:-1]
    # a periodogram of tapered data, |Σ w_k m_k e^{−2πifkΔ}|² Δ/Σ w_k²
    density = np.abs(np.fft.fft(left * taper)) ** 2 * step / np.sum(taper**2)
    return PoleSpectrum(np.fft.fftshift(np.fft.fftfreq(len(left), step)), np.fft.fftshift(density))
