"""The growth of a plasma wave in a run, measured while it follows linear theory."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.fields.vlasov_poisson.waves import PlasmaWave
from polhode.types import ArrayLike, Real


class LinearWaveLimits(NamedTuple):
    """What decides when a wave in a run follows linear theory.

    Attributes:
        settling_time: inverse plasma frequencies, after which faster modes have died.
        max_bounce_rate: √(kE) over the growth rate, up to which a growing wave is linear; then it traps electrons.
        late_share: of the linear time of a growing wave, after which it is fitted: earlier the damped modes count too.
        min_damped_field: of the first field; a wave damped below it is lost in the noise of the particles.
        min_values: for a line with a standard error.
    """

    settling_time: float = 5.0
    max_bounce_rate: float = 0.3
    late_share: float = 0.6
    min_damped_field: float = 1e-4
    min_values: int = 4


LIMITS = LinearWaveLimits()


class GrowthFit(NamedTuple):
    """A line through the logarithm of the field.

    Attributes:
        growth: its slope, in plasma frequencies.
        error: standard error of it, by the scatter about the line.
        begin, end: of the times used.
    """

    growth: float
    error: float
    begin: float
    end: float


@known_numbers_only
def fit_growth(
    times: Real[ArrayLike, "time"], field: Real[ArrayLike, "time"], wavenumber: float, wave: PlasmaWave, end: float
) -> GrowthFit | None:
    """Return the growth of a field's amplitude between the times where it is linear; None where there are too few.

    The line goes through the maxima of a field that oscillates, and through all values of one that does not.

    Args:
        times: (T,) ascending.
        field: (T,) amplitudes, not negative.
        wavenumber: k of the wave.
        wave: the mode of linear theory, which bounds the times.
        end: time up to which the particles represent a smooth distribution.

    Raises:
        InvalidInput: for arrays that do not fit.

    >>> t = np.linspace(0.0, 30.0, 301)
    >>> wave = PlasmaWave(0.5, 1.4, -0.15, 1.5, 0.5)
    >>> fit = fit_growth(t, 0.01 * np.abs(np.exp(-0.15 * t) * np.cos(1.4 * t)), 0.5, wave, 30.0)
    >>> round(fit.growth, 3)
    -0.15
    """
    t, amplitude = np.asarray(times, float), np.asarray(field, float)
    if t.ndim != 1 or t.shape != amplitude.shape or not (np.isfinite(amplitude).all() and (amplitude >= 0.0).all()):
        raise InvalidInput(
            f"`times` and `field` must be (T,) of one length, the field finite and not negative; got shapes {t.shape} "
            f"and {amplitude.shape}, and field {shown(field)}."
        )
    begin, end = LIMITS.settling_time, min(end, float(t[-1])) if t.size else end
    if wave.growth > 0.0:
        beyond = np.sqrt(wavenumber * amplitude) > LIMITS.max_bounce_rate * wave.growth
        end = min(end, float(t[np.argmax(beyond)]) if beyond.any() else end)
        begin = max(LIMITS.settling_time, LIMITS.late_share * end)
    elif amplitude.size:
        if wavenumber * amplitude.max() > wave.growth**2:
            return None  # electrons are trapped before the wave is damped
        peaks = np.maximum.accumulate(amplitude[::-1])[::-1]  # what is still to come
        low = peaks < LIMITS.min_damped_field * amplitude.max()
        end = min(end, float(t[np.argmax(low)]) if low.any() else end)
    used = (t >= begin) & (t <= end) & (amplitude > 0.0)
    inner = np.zeros(t.size, bool)
    inner[1:-1] = (amplitude[1:-1] > amplitude[:-2]) & (amplitude[1:-1] >= amplitude[2:])
    if wave.frequency and (used & inner).sum() >= LIMITS.min_values:
        at, log = _peaks(t, amplitude, np.flatnonzero(used & inner))
    elif wave.frequency and wave.growth < 0.0:
        return None
    else:
        at, log = t[used], np.log(amplitude[used])
    if len(at) < LIMITS.min_values:
        return None
    (slope, _), covariance = np.polyfit(at, log, 1, cov=True)
    return GrowthFit(float(slope), float(np.sqrt(covariance[0, 0])), float(at[0]), float(at[-1]))


def _peaks(t: np.ndarray, amplitude: np.ndarray, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return times and logarithms of maxima, by parabolas through three squares each."""
    left, middle, right = (amplitude[places + k] ** 2 for k in (-1, 0, 1))
    curvature = left - 2.0 * middle + right
    # vertex of the parabola through three equidistant samples, ½(l − r)/(l − 2m + r) steps from the middle
    shift = 0.5 * (left - right) / np.where(curvature < 0.0, curvature, -1.0)
    shift = np.where(curvature < 0.0, shift, 0.0)
    top = middle - 0.25 * (left - right) * shift
    step = np.where(shift < 0.0, t[places] - t[places - 1], t[places + 1] - t[places])
    return t[places] + shift * step, 0.5 * np.log(top)
