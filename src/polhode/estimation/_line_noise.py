"""The noise around a line of a spectrum, from the residuals of a fit, and the errors that it causes.

White noise of ordinary formulas is not what polar motion leaves: its residuals are red, and the excitation shakes
the wobble itself, so that amplitude and phase walk. Close to a line such noise is a constant plus what falls off as
the square of the distance, here in the time domain: white noise of variance ``white``, and a line whose complex
amplitude takes random steps of variance ``walk``. The least squares themselves remove noise next to the line, the
more the closer; that is accounted for by taking the expectation of what is *left* in each frequency.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize

from polhode.special._residual_noise import NoiseTest, compare_bands
from polhode.types import Array, Complex128, Float64


class LineNoiseLimits(NamedTuple):
    """Numbers that decide which frequencies show the noise about a line."""

    bandwidth: float = 0.45 / (365.25 * 86_400.0)  # Hz, on either side of the line
    min_kept_power: float = 0.3  # share of a frequency's power that the fit must leave, for it to count


LIMITS = LineNoiseLimits()


class LineNoise(NamedTuple):
    """Noise about a line.

    Attributes:
        white: variance of a complex sample [rad²].
        walk: variance of a complex step of the line's amplitude, from one sample to the next [rad²].
        covariance: (2, 2) of both, by Fisher's information; zero for one whose estimate is zero.
        frequencies: number of frequencies used.
        test: whether the power of all bands about the line is that of such noise.
    """

    white: float
    walk: float
    covariance: Float64[Array, "2 2"]
    frequencies: int
    test: NoiseTest


def accumulate_walk(influence: Complex128[Array, "n k"]) -> Complex128[Array, "n k"]:
    """Return the influence of each step of a random walk, given that of the walk itself.

    The walk counts from its own mean: the mean amplitude is what a fit of a constant line estimates.
    """
    centred = influence - influence.mean(axis=0)
    return np.cumsum(centred[::-1], axis=0)[::-1]


def noise_about(
    times: Float64[Array, "n"], left: Complex128[Array, "n"], removed: Complex128[Array, "n r"], rate: float,
) -> LineNoise:
    """Return noise about the line of a wobble, by Whittle's likelihood of what is left around it.

    Args:
        times: [s].
        left: residuals of the fit.
        removed: orthonormal columns that the fit removes.
        rate: of the line [rad/s].
    """
    span = times[-1] - times[0]
    many = max(4, int(LIMITS.bandwidth * span))
    k = np.concatenate([np.arange(-many, 0), np.arange(1, many + 1)])
    power, white, walk = _expect_powers(times, left, removed, rate + 2.0 * np.pi * k / span, rate)
    kept = white > LIMITS.min_kept_power
    power, white, walk = power[kept], white[kept], walk[kept]
    level = power.sum() / white.sum()
    size = float(np.median(walk / white))

    def cost(p: Float64[Array, "2"]) -> float:
        # Whittle: powers P are exponential about their mean S, −ln likelihood Σ (ln S + P/S)
        model = np.exp(p[0]) * white + np.exp(p[1]) * walk
        return float(np.sum(np.log(model) + power / model))

    starts = [np.log([level * a, level * b / size]) for a, b in ((0.9, 1e-2), (0.3, 0.7))]
    best = min((minimize(cost, start, method="Nelder-Mead", options={"xatol": 1e-3, "fatol": 1e-4})
                for start in starts), key=lambda minimum: minimum.fun)
    both = np.exp(best.x)
    basis = np.stack([white, walk])
    shares = (both[:, None] * basis).sum(axis=1) / (both @ basis).sum()
    weight = np.max(both[:, None] * basis / (both @ basis), axis=1)
    there = (shares > 1e-3) | (weight > 0.05)  # otherwise its likelihood is flat towards zero
    if not there.all():
        only = basis[np.argmax(there)]
        both = np.where(there, np.mean(power / only), 0.0)
    # Fisher's information of exponential variables: Σ ∂S ∂S/S²
    information = (basis / (both @ basis) ** 2) @ basis.T
    covariance = np.zeros((2, 2))
    covariance[np.ix_(there, there)] = np.linalg.inv(information[np.ix_(there, there)])
    # powers over their expectations are exponential, χ² of two degrees of freedom each
    least, count = compare_bands(power / (both @ basis), np.full(len(power), 2.0))
    test = NoiseTest(min(1.0, least * count), 0.0)
    return LineNoise(float(both[0]), float(both[1]), covariance, len(power), test)


def level_at(
    times: Float64[Array, "n"], left: Complex128[Array, "n"], removed: Complex128[Array, "n r"], rate: float
) -> float:
    """Return the variance of a complex sample of white noise that is as strong as what is left next to a rate
    [rad/s]."""
    neighbours = 4  # frequencies on either side of a seasonal line
    span = times[-1] - times[0]
    k = np.concatenate([np.arange(-neighbours, 0), np.arange(1, neighbours + 1)])
    power, white, _ = _expect_powers(times, left, removed, rate + 2.0 * np.pi * k / span, rate)
    return float(power.sum() / white.sum())


def _expect_powers(
    times: Float64[Array, "n"], left: Complex128[Array, "n"], removed: Complex128[Array, "n r"],
    rates: Float64[Array, "k"], line: float,
) -> tuple[Float64[Array, "k"], Float64[Array, "k"], Float64[Array, "k"]]:
    """Return powers at rates, and their expectations for white noise and for a walk of unit variance."""
    waves = np.exp(1j * np.outer(times, rates)) / np.sqrt(len(times))
    power = np.abs(waves.conj().T @ left) ** 2
    waves -= removed @ (removed.conj().T @ waves)
    white = np.sum(np.abs(waves) ** 2, axis=0)
    walk = np.sum(np.abs(accumulate_walk(waves * np.exp(-1j * line * times)[:, None])) ** 2, axis=0)
    return power, white, walk
