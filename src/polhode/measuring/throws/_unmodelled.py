"""Errors that no model of a throw covers, and their effect on estimates: a smooth torque, larger gain errors.

A model that leaves something out fits by moving what it has, and its residuals do not tell by how much. So the last
step is a least squares with a smooth torque in the body beside the model, small as its own effect shows, and with the
spread of the gains taken from what of them is seen: a mixed model, its variances by maximum likelihood.

Reference: D. J. C. MacKay, Neural Computation 4 (1992) 415, for the variances.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from polhode.measuring.throws._throw_fit import (
    ROBUST,
    Model,
    Solution,
    Throw,
    predict_rates,
    turn_axes,
    whitening_matrices,
)
from polhode.measuring.throws._throw_models import compute_moments
from polhode.types import Array, Float64

TORQUE = 0.003  # over I3 |ω|², to begin with: a third of what thin plates feel in air
NOTHING = 1e-7  # over I3 |ω|²: less is no torque
GAINS_KNOWN = 4.0  # degrees of freedom by which the spread of the gains is known beforehand
PER_NODE, MOST_NODES = 1.0, 20  # rad of turning from node to node of the torque; how many nodes a throw has at most
ROUNDS, STEPS, HALVINGS = 4, 40, 8
ROUNDED = 1e-15  # of the largest singular value: smaller ones are rounding


@dataclass(frozen=True, eq=False)
class Settled:
    """A solution that allows for what its model leaves out.

    Attributes:
        solution: with its parameters, covariance, residuals and degrees of freedom of the new fit.
        predicted: (n, 3) rates, with the torque [rad/s, device frame].
        torque: rms of the torque over I3 |ω|².
        gain_spread: standard deviation of the gains' entries that the log shows, and what was known beforehand.
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
    mixed, response = _solve_mixed(solution, x, throws, data, np.zeros(0), _Scales(model.gain_spread, TORQUE, 1.0, 1.0))
    x, push = _take_step(solution, x, np.zeros(0), throws, data, mixed, response)
    for _ in range(ROUNDS - 1):
        mixed, response = _solve_mixed(solution, x, throws, data, push, mixed.scales)
        x, push = _take_step(solution, x, push, throws, data, mixed, response)
    scales = mixed.scales
    values = predict_rates(model, x, axes0, throws)[0] + response @ push
    turned, change = turn_axes(model, x, axes0)
    keep = slice(0, model.size)
    covariance = change @ mixed.covariance[keep, keep] @ change.T
    done = replace(
        solution, parameters=x, axes=turned, covariance=covariance, residuals=data - values, freedom=mixed.freedom,
        sigma=solution.sigma * np.sqrt(scales.noise), jitter=solution.jitter * np.sqrt(scales.noise),
    )  # fmt: skip
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

    def cost(x: Array, push: Array, values: Array) -> float:
        z = np.abs((white @ (data - values - response @ push)[..., None]).ravel())
        return mixed.cost(x, push, float(np.where(z > ROBUST, ROBUST * (2 * z - ROBUST), z * z).sum()))

    before = cost(x, push, values)
    for part in 0.5 ** np.arange(HALVINGS):
        there = np.clip(x + part * mixed.step[: model.size], low, high)
        pushed = push + part * (mixed.step[model.size :] - push)
        with np.errstate(all="ignore"):
            reached = cost(there, pushed, predict_rates(model, there, solution.axes, throws)[0])
        if reached <= before:  # not so where a number is none
            return there, pushed
    return x, push


def _downweight(A: Array, z: Array, size: Array) -> tuple[Array, Array]:
    """Return rows with Huber's weights: outliers count less."""
    weight = np.sqrt(np.minimum(1.0, ROBUST / np.maximum(size, 1e-300)))
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
    turned = float(np.sqrt(np.mean(squares)) * (t[-1] - t[0]))
    count = int(np.clip(turned / PER_NODE, 2, MOST_NODES)) + 1
    place = (t - t[0]) / (t[-1] - t[0]) * (count - 1)
    return np.maximum(1.0 - np.abs(place[:, None] - np.arange(count)), 0.0)


@dataclass(frozen=True)
class _Scales:
    """Standard deviations of gains and torque, variance of the noise over that taken, and what its colour adds."""

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
        # squares of A would lose what is known beforehand, where the noise is small
        self.root, self.right = np.split(np.asarray(np.linalg.qr(np.c_[A, z], mode="r")), [A.shape[1]], axis=1)
        for _ in range(STEPS):
            before = self.scales
            self._solve()
            self._scale()
            change = abs(np.log(self.scales.torque / before.torque)) + abs(np.log(self.scales.gain / before.gain))
            if change + abs(np.log(self.scales.noise / before.noise)) < 1e-3:
                break
        left = z - A @ self.step
        alike = float((left[:-3] * left[3:]).sum() / max(float((left**2).sum()), 1e-300)) - 1.0 / np.sqrt(len(z) / 3)
        alike = float(np.clip(alike, 0.0, 0.95))
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
        self.spread = right.T * scale[:, None] / np.maximum(values, ROUNDED * values[0])  # root of the covariance
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
        self.told = max(determined, 0.0)
        known = GAINS_KNOWN * self.model.gain_spread**2
        spread = (known + float(here @ gains @ here) * self.scales.gain**2) / (GAINS_KNOWN + self.told)
        self.seen = max(self.torques - float(np.trace(torque @ self.covariance)), 1e-6)
        push = float(here @ torque @ here) * self.scales.torque**2 / self.seen
        left = float(np.sum((self.z - self.A @ self.step) ** 2))
        used = float(np.sum((self.root @ self.spread) ** 2)) / (self.scales.noise * self.scales.widened)
        noise = max(left, 1e-300) / max(self.count - used, 1.0)
        self.scales = replace(self.scales, gain=float(np.sqrt(spread)), torque=max(float(np.sqrt(push)), NOTHING),
                              noise=float(noise))  # fmt: skip
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
            parts = zip((*shares[:2], noise), (GAINS_KNOWN + self.told, max(self.seen, 1.0),
                        max(self.count - self.used, 1.0)), strict=True)  # fmt: skip
            least = min(least, 1.0 / max(sum(share**2 / known for share, known in parts), 1e-12))
        return float(max(least, 1.0))
