"""Whether the residuals of a fit are noise: the standard errors of least squares hold for no others.

The residuals of a right model are white, so that all frequencies have equal shares of them, less what the parameters
took. What a model leaves out has its own frequencies, those of the motion. So the power of each band of frequencies is
compared with that of all others by Fisher's F, for bands of all widths and places, with Bonferroni's correction for
their number. The order of samples counts alone, so that they need not be at equal times.

Source: J. Durbin, Biometrika 56 (1969) 1, for the periodogram of residuals; R. A. Fisher, Proc. R. Soc. A 125 (1929)
54.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.fft import dct
from scipy.stats import chi2
from scipy.stats import f as fisher

from polhode.types import Array, Float64


class NoiseLimits(NamedTuple):
    """Numbers that decide whether residuals are noise.

    Attributes:
        probability: of such residuals by chance, below which they are no noise: one right fit in ten thousand. Of noise
            whose size changes along the log by a factor of seven it is one in two hundred, less than the one in a
            hundred that is promised.
        drawn_in: standard deviations to which outliers are drawn in, as the fits themselves weigh them less.
        least_free: degrees of freedom that a band and all others together must have, for a comparison.
        harmonics: of the rate of rotation, up to which motion left out by a model of rates is looked for.
        compared: times that frequency, up to which their power is compared with; above it gyros have filters,
            vibrations and rounding.
        most_alike: correlation of neighbouring residuals of a filtered gyro at most.
        exact: rad, residuals of computed attitudes, which rounding correlates.
    """

    probability: float = 1e-4
    drawn_in: float = 4.0
    least_free: float = 3.0
    harmonics: float = 4.0
    compared: float = 4.0
    most_alike: float = 0.95
    exact: float = 1e-9


LIMITS = NoiseLimits()


class NoiseTest(NamedTuple):
    """The result of a test whether residuals are noise.

    Attributes:
        probability: of a band as strong as the strongest by chance, were the residuals noise; at most 1.
        alike: correlation of neighbouring residuals.
    """

    probability: float
    alike: float

    @property
    def is_noise(self) -> bool:
        """Whether the residuals are as noise may be."""
        return self.probability >= LIMITS.probability


class Misfit(NamedTuple):
    """Residuals of a fit that are no noise, so that its estimates have no known errors.

    Attributes:
        test: of the residuals.
        tried: the effect that was tried as the cause: "air", "torque" or "wheel".
        cause: which of these leaves noise alone, and explains the data; None where none does.
    """

    test: NoiseTest
    tried: tuple[str, ...] = ()
    cause: str | None = None


def test_noise(
    residuals: Sequence[Float64[Array, "n 3"]], slopes: Sequence[Float64[Array, "n 3 p"]] | None = None,
    highest: float = 1.0,
) -> NoiseTest:
    """Test whether residuals are white noise.

    Args:
        residuals: one or several series, each of noise of its own size along each axis.
        slopes: derivatives of each by the parameters, all of them over the noise as in the fit; they say how much of
            each frequency the fit took. None where the parameters are few.
        highest: frequency up to which bands are tested, over half of that of the samples.
    """
    taken = [None] * len(residuals) if slopes is None else _share_taken(slopes)
    parts = [_test_bands(r, h, highest) for r, h in zip(residuals, taken, strict=True) if len(r) > 2]
    least, count = min((p for p, _ in parts), default=1.0), sum(n for _, n in parts)
    return NoiseTest(min(1.0, least * count), correlate_neighbours(residuals))


def test_known_errors(squares: float, freedom: int, known: float | None = None) -> NoiseTest:
    """Test whether residuals are as large as their errors, which were given: by χ², or by F where these were estimated.

    Args:
        squares: sum of the squares of the residuals over their errors.
        freedom: observations less parameters; where it is zero, nothing is left to test.
        known: degrees of freedom of the errors; None where they are known.
    """
    if not freedom:
        return NoiseTest(1.0, 0.0)
    by_chance = chi2.sf(squares, freedom) if known is None else fisher.sf(squares / freedom, freedom, known)
    return NoiseTest(float(by_chance), 0.0)


def test_filtered_noise(residuals: Sequence[Float64[Array, "n 3"]], turns: float) -> NoiseTest:
    """Test whether residuals of rates are noise, white or as a gyro's filter leaves it, at the motion's frequencies.

    Such noise is white after r_k − c r_{k−1} with the correlation c of neighbours, for which a fit of throws widens its
    errors.

    Args:
        residuals: of each throw.
        turns: by how much the body turns from sample to sample [rad].
    """
    alike = correlate_neighbours(residuals)
    filtered = min(max(alike, 0.0), LIMITS.most_alike)
    white = [r[1:] - filtered * r[:-1] for r in residuals if len(r) > 2]
    return test_noise(white, highest=LIMITS.harmonics * turns / np.pi)._replace(alike=alike)


def correlate_neighbours(residuals: Sequence[Float64[Array, "n 3"]]) -> float:
    """Return the correlation of neighbouring residuals of one or several series."""
    pairs = [(r[:-1], r[1:]) for r in residuals if len(r) > 2]
    squares = max(sum(float((a * a).sum()) for a, _ in pairs), 1e-300)
    return sum(float((a * b).sum()) for a, b in pairs) / squares


def _share_taken(slopes: Sequence[Float64[Array, "n 3 p"]]) -> list[Float64[Array, "n 3"]]:
    """Return which part of each frequency the parameters took, from 0 to 1: the hat matrix's diagonal."""
    rows = np.concatenate([J.reshape(-1, J.shape[2]) for J in slopes])
    scale = np.linalg.norm(rows, axis=0)
    left, values, _ = np.linalg.svd(rows / np.where(scale > 0.0, scale, 1.0), full_matrices=False)
    parts = np.split(left[:, values > 1e-10 * values[0]], np.cumsum([3 * len(J) for J in slopes])[:-1])
    spectra = [np.asarray(dct(part.reshape(len(part) // 3, 3, -1), axis=0, norm="ortho")) for part in parts]
    return [(spectrum**2).sum(axis=2) for spectrum in spectra]


def _test_bands(
    residuals: Float64[Array, "n 3"], taken: Float64[Array, "n 3"] | None, highest: float
) -> tuple[float, int]:
    """Return the least probability of a band's share, and the number of bands."""
    size = 1.4826 * np.median(np.abs(residuals), axis=0)
    reach = LIMITS.drawn_in * np.where(size > 0.0, size, np.inf)
    power = np.asarray(dct(np.clip(residuals, -reach, reach), axis=0, norm="ortho")) ** 2
    tested = max(highest * len(power), 1.0)
    power = power[: max(int(LIMITS.compared * tested), 2)]
    free = np.ones_like(power) if taken is None else np.clip(1.0 - taken[: len(power)], 0.0, 1.0)
    if taken is None:
        free[0] = power[0] = 0.0  # a constant is nobody's doing
    variance = power.sum(axis=0) / np.maximum(free.sum(axis=0), 1e-300)
    power = (power / np.where(variance > 0.0, variance, 1.0)).sum(axis=1)
    return compare_bands(power, free.sum(axis=1), tested)


def compare_bands(
    power: Float64[Array, "n"], freedom: Float64[Array, "n"], tested: float = np.inf
) -> tuple[float, int]:
    """Return the least probability by chance of a band's power over its expectation, and the number of bands.

    Args:
        power: of each frequency, over the power expected of noise, up to one factor for all.
        freedom: degrees of freedom of each.
        tested: index of a frequency below which bands begin.
    """
    whole, free = np.concatenate([[0.0], np.cumsum(power)]), np.concatenate([[0.0], np.cumsum(freedom)])
    least, count, width = 1.0, 0, 1
    while width < len(power):
        edges = np.arange(0, len(power) + width, width).clip(max=len(power))
        inside, within = np.diff(whole[edges]), np.diff(free[edges])
        outside, beyond = whole[-1] - inside, free[-1] - within
        use = (within >= min(LIMITS.least_free, width)) & (beyond >= LIMITS.least_free)
        use &= edges[:-1] < tested
        if use.any():
            ratio = inside[use] / within[use] / np.maximum(outside[use] / beyond[use], 1e-300)
            least = min(least, float(fisher.sf(ratio, within[use], beyond[use]).min()))
            count += int(use.sum())
        width *= 2
    return least, count
