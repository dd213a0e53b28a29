"""Errors that no model of a throw covers, and their effect on estimates: a smooth torque, larger gain errors.

A model that leaves something out fits by wrong values of its parameters, and its residuals do not show by how much. So
the last step is a least squares with a smooth torque in the body besides the model. The variances of this torque and of
the gains are estimated from the log by maximum likelihood: a mixed model.

Reference: D. J. C. MacKay, Neural Computation 4 (1992) 415, for the variances.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from polhode.measuring.throws._throw_fit import LIMITS as FIT_LIMITS
from polhode.measuring.throws._throw_fit import (
    Model,
    Solution,
    Throw,
    predict_rates,
    turn_axes,
    whitening_matrices,
)
from polhode.measuring.throws._throw_models import compute_moments
from polhode.types import Array, Float64


class MixedThresholds(NamedTuple):
    """Numbers that bound the variances of unmodelled torques and gains.

    Attributes:
        prior_gain_freedom: degrees of freedom of the prior spread of the gains.
        min_torque: over I3 |ω|²; less is none.
        variance_tolerance: change of the logarithms of all spreads, below which they have converged.
        max_correlation: of neighbouring residuals; a larger one leaves hardly a sample independent.
        relative_rounding: of the largest singular value; smaller ones are rounding.
    """

    prior_gain_freedom: float = 4.0
    min_torque: float = 1e-7
    variance_tolerance: float = 1e-3
    max_correlation: float = 0.95
    relative_rounding: float = 1e-15


LIMITS = MixedThresholds()


@dataclass(frozen=True, eq=False)
class Settled:
    """A solution that allows for unmodelled torques and gains.

    Attributes:
        solution: with its parameters, covariance, residuals and degrees of freedom of the new fit.
        predicted: (n, 3) rates, with the torque [rad/s, device frame].
        torque: rms of the torque over I3 |ω|².
        gain_spread: standard deviation of the gains' entries, by the log and the prior.
        widened: factor on the variances of the noise, as neighbouring residuals are alike.
    """

    solution: Solution
    predicted: Float64[Array, "n 3"]
    torque: float
    gain_spread: float
    widened: float


def allow_for_unmodelled(solution: Solution, throws: list[Throw]) -> Settled:
    """Return a solution whose errors allow for unmodelled torques and gains."""
    model, x, axes0 = solution.model, solution.parameters.copy(), solution.axes
    x[model.places["turn"]] = 0.0
    data = np.concatenate([throw.rates for throw in throws])
    scales = _Scales(model.gain_spread, 0.003, 1.0, 1.0)  # a third of the torque that thin plates feel in air
    mixed, response = _solve_mixed(solution, x, throws, data, np.zeros(0), scales)
    x, push = _take_step(solution, x, np.zeros(0), throws, data, mixed, response)
    for _ in range(3):
        mixed, response = _solve_mixed(solution, x, throws, data, push, mixed.scales)
        x, push = _take_step(solution, x, push, throws, data, mixed, response)
    scales = mixed.scales
    values = predict_rates(model, x, axes0, throws)[0] + response @ push
    axes, change = turn_axes(model, x, axes0)
    keep = slice(0, model.size)
    covariance = change @ mixed.covariance[keep, keep] @ change.T
    done = replace(
        solution, parameters=x, axes=axes, covariance=covariance, residuals=data - values, freedom=mixed.freedom,
        sigma=solution.sigma * np.sqrt(scales.noise), jitter=solution.jitter * np.sqrt(scales.noise),
    )
    return Settled(done, values, float(np.sqrt(np.mean(push**2))), scales.gain, scales.widened)


def _solve_mixed(
    solution: Solution, x: Array, throws: list[Throw], data: Array, push: Array, scales: _Scales
) -> tuple[_Mixed, Float64[Array, "n 3 m"]]:
    """Return the least squares about parameters, and the response of the rates to the torque."""
    model = solution.model
    values, slopes, fast = predict_rates(model, x, solution.axes, throws)
    slopes = np.nan_to_num(slopes)  # as in the fit itself
    response = _responses(model, x, throws, slopes)
    white = whitening_matrices(fast, solution.sigma, solution.jitter)
    A = np.concatenate([white @ slopes, white @ response], axis=2).reshape(data.size, -1)
    z = (white @ (data - values)[..., None]).ravel()
    size = np.abs(z - (A[:, model.size :] @ push if len(push) else 0.0))
    return _Mixed(model, x, *_downweight(A, z, size), scales), response


def _take_step(
    solution: Solution, x: Array, push: Array, throws: list[Throw], data: Array, mixed: _Mixed, response: Array
) -> tuple[Array, Array]:
    """Return parameters and torque after the part of a step that decreases the sum of squares.

    Along poorly determined directions a whole step may lead to another motion, or to NaN.
    """
    model = solution.model
    low, high = model.limits()
    push = push if len(push) else np.zeros(response.shape[2])
    values, _, fast = predict_rates(model, x, solution.axes, throws)
    white = whitening_matrices(fast, solution.sigma, solution.jitter)

    robust = FIT_LIMITS.max_quadratic_error

    def cost(x: Array, push: Array, values: Array) -> float:
        z = np.abs((white @ (data - values - response @ push)[..., None]).ravel())
        return mixed.cost(x, push, float(np.where(z > robust, robust * (2 * z - robust), z * z).sum()))

    before = cost(x, push, values)
    for part in 0.5 ** np.arange(8):
        there = np.clip(x + part * mixed.step[: model.size], low, high)
        pushed = push + part * (mixed.step[model.size :] - push)
        with np.errstate(all="ignore"):
            reached = cost(there, pushed, predict_rates(model, there, solution.axes, throws)[0])
        if reached <= before:  # false for NaN
            return there, pushed
    return x, push


def _downweight(A: Array, z: Array, size: Array) -> tuple[Array, Array]:
    """Return rows with Huber's weights: outliers count less."""
    weight = np.sqrt(np.minimum(1.0, FIT_LIMITS.max_quadratic_error / np.maximum(size, 1e-300)))
    return A * weight[:, None], z * weight


def _responses(model: Model, x: Array, throws: list[Throw], slopes: Array) -> Float64[Array, "n 3 m"]:
    """Return how the rates follow torques |ω|² I3 along the principal axes that are linear from node to node.

    By the variation of constants with the derivatives by the starting rates, Φ: ∫ Φ(t) Φ(s)⁻¹ I⁻¹ N(s) ds.
    """
    over = 1.0 / compute_moments(x[model.places["shape"]])
    parts, at = [], 0
    for k, throw in enumerate(throws):
        t = throw.elapsed
        moved = slopes[at : at + len(t), :, model.places[f"start {k}"]]  # G R Φ, and at the epoch G R
        at += len(t)
        origin = moved[np.argmin(np.abs(t))]
        inner = np.linalg.pinv(origin, rcond=1e-10) @ moved  # Φ along the principal axes
        squares = (throw.rates**2).sum(axis=1)
        hats = _hats(t, squares)
        # where a rate has hardly an effect any more, inner is all but singular
        push = np.linalg.pinv(inner, rcond=1e-10) @ np.diag(over) * squares[:, None, None]
        rate = np.einsum("nij,nm->nimj", push, hats).reshape(len(t), 3, -1)
        steps = 0.5 * (rate[1:] + rate[:-1]) * np.diff(t)[:, None, None]
        total = np.concatenate([np.zeros((1, *rate.shape[1:])), np.cumsum(steps, axis=0)])
        parts.append(moved @ (total - total[np.argmin(np.abs(t))]))
    width = sum(part.shape[2] for part in parts)
    whole, at, column = np.zeros((len(slopes), 3, width)), 0, 0
    for part in parts:
        whole[at : at + len(part), :, column : column + part.shape[2]] = part
        at, column = at + len(part), column + part.shape[2]
    return whole


def _hats(t: Array, squares: Array) -> Float64[Array, "n m"]:
    """Return functions of time that are 1 at a node and linear to zero at the next ones."""
    turn = float(np.sqrt(np.mean(squares)) * (t[-1] - t[0]))
    count = int(np.clip(turn, 2, 20)) + 1  # a node per radian
    place = (t - t[0]) / (t[-1] - t[0]) * (count - 1)
    return np.maximum(1.0 - np.abs(place[:, None] - np.arange(count)), 0.0)


@dataclass(frozen=True)
class _Scales:
    """Standard deviations of gains and torque, variance of the noise over the fit's, and factor for its correlation."""

    gain: float
    torque: float
    noise: float
    widened: float


class _Mixed:
    """The least squares of parameters and torque, with its variances."""

    def __init__(self, model: Model, x: Array, A: Array, z: Array, scales: _Scales) -> None:
        self.model, self.x, self.scales = model, x, scales
        self.count = len(z)
        self.A, self.z = A, z
        self.torques = A.shape[1] - model.size
        # squares of A would lose the priors, where the noise is small
        self.root, self.right = np.split(np.asarray(np.linalg.qr(np.c_[A, z], mode="r")), [A.shape[1]], axis=1)
        for _ in range(40):
            before = self.scales
            self._solve()
            self._scale()
            change = abs(np.log(self.scales.torque / before.torque)) + abs(np.log(self.scales.gain / before.gain))
            if change + abs(np.log(self.scales.noise / before.noise)) < LIMITS.variance_tolerance:
                break
        left = z - A @ self.step
        alike = float((left[:-3] * left[3:]).sum() / max(float((left**2).sum()), 1e-300)) - 1.0 / np.sqrt(len(z) / 3)
        alike = float(np.clip(alike, 0.0, LIMITS.max_correlation))
        self.scales = replace(self.scales, widened=(1.0 + alike) / (1.0 - alike))
        self._solve()
        self.freedom = self._freedom()

    def _prior_rows(self) -> tuple[Array, Array, Array, Array]:
        """Return roots of the prior precision of each group (fixed part, gains, torque), and the prior's pull."""
        size = self.model.size + self.torques
        which, means, weights = replace(self.model, gain_spread=self.scales.gain).prior()
        rows = np.zeros((len(which), size))
        rows[:, which] = weights
        of_gains = np.zeros(size, dtype=bool)
        for name in ("gain", "cross_axis"):
            if name in self.model.places:
                of_gains[self.model.places[name]] = True
        gains = rows * of_gains
        torque = np.eye(size)[self.model.size :] / self.scales.torque
        return rows - gains, gains, torque, weights @ (means - self.x[which])

    def _solve(self) -> None:
        fixed, gains, torque, pull = self._prior_rows()
        self.parts = fixed.T @ fixed, gains.T @ gains, torque.T @ torque
        level = np.sqrt(self.scales.noise * self.scales.widened)
        whole = np.concatenate([self.root / level, fixed + gains, torque])
        wanted = np.concatenate([self.right[:, 0] / level, pull, np.zeros(self.torques)])
        scale = 1.0 / np.maximum(np.linalg.norm(whole, axis=0), 1e-150)
        left, values, right = np.linalg.svd(whole * scale, full_matrices=False)
        root = right.T * scale[:, None]
        self.spread = root / np.maximum(values, LIMITS.relative_rounding * values[0])  # root of the covariance
        self.covariance = self.spread @ self.spread.T
        self.step = self.spread @ (left.T @ wanted)

    def cost(self, x: Array, push: Array, squares: float) -> float:
        """Return the sum of squares that the step minimizes, of whitened residuals and priors."""
        which, means, weights = replace(self.model, gain_spread=self.scales.gain).prior()
        known = float(((weights @ (x[which] - means)) ** 2).sum()) + float(push @ push) / self.scales.torque**2
        return squares / (self.scales.noise * self.scales.widened) + known

    def _scale(self) -> None:
        """Update each variance: the group's sum of squares over its number of well-determined parameters [MacKay]."""
        _, gains, torque = self.parts
        here = self.step.copy()
        here[: self.model.size] += self.x
        if "gain" in self.model.places:
            here[self.model.places["gain"]] -= 1.0
        determined = 6.0 * bool(gains.any()) - float(np.trace(gains @ self.covariance))
        self.gains_determined = max(determined, 0.0)
        known = LIMITS.prior_gain_freedom * self.model.gain_spread**2
        spread = known + float(here @ gains @ here) * self.scales.gain**2
        spread /= LIMITS.prior_gain_freedom + self.gains_determined
        self.torques_determined = max(self.torques - float(np.trace(torque @ self.covariance)), 1e-6)
        push = float(here @ torque @ here) * self.scales.torque**2 / self.torques_determined
        left = float(np.sum((self.z - self.A @ self.step) ** 2))
        used = float(np.sum((self.root @ self.spread) ** 2)) / (self.scales.noise * self.scales.widened)
        noise = max(left, 1e-300) / max(self.count - used, 1.0)
        size = max(float(np.sqrt(push)), LIMITS.min_torque)
        self.scales = replace(self.scales, gain=float(np.sqrt(spread)), torque=size, noise=float(noise))
        self.used = used

    def _freedom(self) -> float:
        """Return Satterthwaite's degrees of freedom of the less known ratio, of the variances that make it up."""
        fixed, gains, torque = self.parts
        shape = self.model.places["shape"]
        rows = np.array([[-0.5, 1.0], [0.5, 1.0]]) @ self.covariance[shape]
        total = np.einsum("ij,ij->i", rows[:, shape], np.array([[-0.5, 1.0], [0.5, 1.0]]))
        least = float("inf")
        for row, variance in zip(rows, total, strict=True):
            shares = [float(row @ part @ row) / max(variance, 1e-300) for part in (gains, torque, fixed)]
            noise = max(1.0 - sum(shares), 0.0)
            known = (LIMITS.prior_gain_freedom + self.gains_determined, max(self.torques_determined, 1.0),
                     max(self.count - self.used, 1.0))  # fmt: skip
            parts = zip((*shares[:2], noise), known, strict=True)
            least = min(least, 1.0 / max(sum(share**2 / count for share, count in parts), 1e-12))
        return float(max(least, 1.0))
