"""Least squares of a throw: its parameters, the predicted rates, and the noise of the samples."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import block_diag
from scipy.optimize import least_squares, minimize_scalar
from scipy.spatial.transform import Rotation

from polhode.measuring.throws._throw_models import compute_moments, free_rates, integrate_forced
from polhode.types import Array, Float64, Integer


class FitThresholds(NamedTuple):
    """Numbers that decide on the noise of a fit of throws, and on its end.

    Attributes:
        max_quadratic_error: standard deviations, beyond which residuals count linearly (Huber).
        min_moment: over the largest; no body has a smaller one.
        min_flatness: least c that is fitted; noise may make it negative, flatter than a plate.
        max_unexplained: residuals over the variation of the rates; a motion that leaves more does not explain them.
        max_jitter: of the time between samples; a worse clock would explain any motion.
        noise_tolerance: relative change of the noise in a round, below which the fit has converged.
        bias_spread: rad/s, standard deviation of offsets anywhere within ±0.05, as gyros of phones have them.
    """

    max_quadratic_error: float = 3.0
    min_moment: float = 0.003
    min_flatness: float = -0.1
    max_unexplained: float = 0.2
    max_jitter: float = 0.1
    noise_tolerance: float = 0.02
    bias_spread: float = 0.03


LIMITS = FitThresholds()
PARAMETER_BOUNDS = {
    "shape": ([-1.0, LIMITS.min_flatness], [1.0, 2.0]),
    "gain": ([0.7] * 3, [1.3] * 3), "cross_axis": ([-0.3] * 3, [0.3] * 3),
    "drag": ([-0.2] * 3, [1.0] * 3), "linear_drag": ([-2.0] * 3, [10.0] * 3), "one_sided_drag": ([-0.5] * 3, [0.5] * 3),
}  # fmt: skip
UNBOUNDED = ([-np.inf] * 3, [np.inf] * 3)
PRIOR_SPREADS = {"drag": 0.02, "linear_drag": 0.2, "one_sided_drag": 0.02}
"""Standard deviations of coefficients over I3; thin plates in air have a drag of 0.01."""
PAIRS = ((1, 2), (0, 2), (0, 1))  # of axes, whose rates leak into each other


@dataclass(frozen=True, eq=False)
class Throw:
    """Samples of one throw: times from its epoch (n,) [s], and rates (n, 3) [rad/s, device frame]."""

    elapsed: Float64[Array, "n"]
    rates: Float64[Array, "n 3"]
    epoch: float


@dataclass(frozen=True)
class Model:
    """The fitted parameters and their places in the vector of all.

    Attributes:
        forces: names of the torques, of ``throw_models.TORQUES``.
        gain: whether the gyro has a matrix of gains, symmetric: its antisymmetric part turns the axes of the device.
        throws: how many.
        gain_spread: standard deviation of an entry of that matrix, known beforehand.
        bias: of the gyro, known beforehand [rad/s].
        bias_spread: standard deviations of it [rad/s].
    """

    forces: tuple[str, ...]
    gain: bool
    throws: int
    gain_spread: float
    bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    bias_spread: tuple[float, float, float] = (LIMITS.bias_spread, LIMITS.bias_spread, LIMITS.bias_spread)

    @property
    def places(self) -> dict[str, slice]:
        """The slice of each group of parameters."""
        names = ["shape", "turn", "bias", *["gain", "cross_axis"] * self.gain, *self.forces]
        names += [f"start {k}" for k in range(self.throws)]
        slices, at = {}, 0
        for name in names:
            size = 2 if name == "shape" else 3
            slices[name] = slice(at, at + size)
            at += size
        return slices

    @property
    def size(self) -> int:
        """How many parameters there are."""
        return 8 + 3 * (2 * self.gain + len(self.forces) + self.throws)

    @property
    def air(self) -> str:
        """The kind of drag."""
        known = {0: "none", 1: "quadratic", 2: "linear and quadratic", 3: "one-sided, linear and quadratic"}
        return known[sum(name != "rotor" for name in self.forces)]

    @property
    def rotor(self) -> bool:
        """Whether a wheel turns in the body."""
        return "rotor" in self.forces

    def prior(self) -> tuple[Integer[Array, "k"], Float64[Array, "k"], Float64[Array, "k k"]]:
        """Return which parameters are known beforehand, their means m and W, so that W (x − m) has unit covariance.

        The priors of drag, and of a bias without a rest, are so wide that they do not move a good fit; they keep the
        iteration out of the long valleys where a large bias acts like drag.
        """
        parts: dict[str, tuple[Any, Array]] = {"bias": (self.bias, np.diag(1.0 / np.array(self.bias_spread)))}
        if self.gain:
            # of the covariance s² (1 + κ) of the three gains, κ everywhere: a slow clock is a gain of all axes
            common = 0.25  # κ
            root = np.eye(3) + (1.0 / np.sqrt(1.0 + 3.0 * common) - 1.0) / 3.0
            parts["gain"] = np.ones(3), root / self.gain_spread
            parts["cross_axis"] = np.zeros(3), np.eye(3) * np.sqrt(2.0) / self.gain_spread  # halves of two entries
        for name in self.forces:
            if name in PRIOR_SPREADS:
                parts[name] = np.zeros(3), np.eye(3) / PRIOR_SPREADS[name]
        places = self.places
        which = np.concatenate([np.r_[places[name]] for name in parts])
        weights = np.asarray(block_diag(*(weight for _, weight in parts.values())))
        return which, np.concatenate([mean for mean, _ in parts.values()]), weights

    def limits(self) -> tuple[Float64[Array, "p"], Float64[Array, "p"]]:
        """Return the bounds of the parameters."""
        pairs = [PARAMETER_BOUNDS.get(name, UNBOUNDED) for name in self.places]
        low, high = (np.concatenate([pair[k] for pair in pairs]) for k in (0, 1))
        return low, high


@dataclass(frozen=True, eq=False)
class Solution:
    """A fitted model.

    Attributes:
        model: the fitted model.
        parameters: (p,).
        axes: (3, 3) device from principal.
        covariance: (p, p) of the parameters, the turn along the principal axes.
        residuals: (n, 3) of all throws [rad/s, device frame].
        sigma: noise of a sample [rad/s].
        jitter: of the clock [s], rms.
        log_likelihood: with what is known beforehand.
        aicc: Akaike's criterion, corrected for few samples.
        bic: Schwarz's criterion.
        freedom: degrees of freedom.
        converged: whether the iteration ended.
    """

    model: Model
    parameters: Float64[Array, "p"]
    axes: Float64[Array, "3 3"]
    covariance: Float64[Array, "p p"]
    residuals: Float64[Array, "n 3"]
    sigma: float
    jitter: float
    log_likelihood: float
    aicc: float
    bic: float
    freedom: float
    converged: bool


def cross_matrix(v: Array) -> Float64[Array, "3 3"]:
    """Return hat(v), hat(v) x = v × x."""
    return cross_matrices(v[None])[0]


def cross_matrices(v: Float64[Array, "n 3"]) -> Float64[Array, "n 3 3"]:
    """Return hat(v), hat(v) x = v × x, of each row."""
    matrices = np.zeros((len(v), 3, 3))
    matrices[:, [2, 0, 1], [1, 2, 0]] = v
    matrices[:, [1, 2, 0], [2, 0, 1]] = -v
    return matrices


def right_jacobian(turn: Array) -> Float64[Array, "3 3"]:
    """Return M with exp(turn + δ) = exp(turn) exp(M δ)."""
    size = float(np.linalg.norm(turn))
    hat = cross_matrix(turn)
    smallest = 1e-6  # below which the next term of the series is rounding
    if size < smallest:
        return np.eye(3) - 0.5 * hat
    return np.eye(3) - (1 - np.cos(size)) / size**2 * hat + (size - np.sin(size)) / size**3 * hat @ hat


def predict_rates(
    model: Model, x: Array, axes0: Array, throws: list[Throw]
) -> tuple[Float64[Array, "n 3"], Float64[Array, "n 3 p"], Float64[Array, "n 3"]]:
    """Return rates (n, 3), their derivatives (n, 3, p), and the device's angular acceleration (n, 3).

    Args:
        model: of the throws.
        x: (p,) parameters.
        axes0: (3, 3) device from principal, before the turn.
        throws: the samples, one throw after another.
    """
    places = model.places
    axes = axes0 @ Rotation.from_rotvec(x[places["turn"]]).as_matrix()
    moved = right_jacobian(x[places["turn"]])
    shape = x[places["shape"]]
    moments = compute_moments(shape)
    gain = gain_matrix(model, x)
    forces = {name: x[places[name]] for name in model.forces}
    to_device = gain @ axes
    values, slopes, fast = [], [], []
    for k, throw in enumerate(throws):
        start = x[places[f"start {k}"]]
        rates, d = _rates(shape, start, forces, throw.elapsed)
        J = np.zeros((len(rates), 3, model.size))
        J[:, :, places["shape"]] = np.einsum("ij,pnj->nip", to_device, d[:2])
        J[:, :, places[f"start {k}"]] = np.einsum("ij,pnj->nip", to_device, d[2:5])
        for m, name in enumerate(model.forces):
            J[:, :, places[name]] = np.einsum("ij,pnj->nip", to_device, d[5 + 3 * m : 8 + 3 * m])
        J[:, :, places["turn"]] = to_device @ cross_matrices(-rates) @ moved
        J[:, :, places["bias"]] = np.eye(3)
        in_device = rates @ axes.T
        if model.gain:
            for i, (one, other) in enumerate(PAIRS):
                J[:, i, places["gain"].start + i] = in_device[:, i]
                J[:, one, places["cross_axis"].start + i] = in_device[:, other]
                J[:, other, places["cross_axis"].start + i] = in_device[:, one]
        values.append(in_device @ gain + x[places["bias"]])
        slopes.append(J)
        momentum = rates * moments + forces.get("rotor", np.zeros(3))
        fast.append(np.cross(momentum, rates) / moments @ to_device.T)
    return np.concatenate(values), np.concatenate(slopes), np.concatenate(fast)


def _rates(shape: Array, start: Array, forces: dict[str, Array], elapsed: Array) -> tuple[Array, Array]:
    if compute_moments(shape).min() < LIMITS.min_moment:
        return np.full((len(elapsed), 3), np.nan), np.zeros((5 + 3 * len(forces), len(elapsed), 3))
    return integrate_forced(shape, start, forces, elapsed) if forces else free_rates(shape, start, elapsed)


def gain_matrix(model: Model, x: Array) -> Float64[Array, "3 3"]:
    """Return the matrix by which the gyro multiplies rates [device frame]."""
    if not model.gain:
        return np.eye(3)
    matrix = np.diag(x[model.places["gain"]])
    for value, (i, j) in zip(x[model.places["cross_axis"]], PAIRS, strict=True):
        matrix[i, j] = matrix[j, i] = value
    return matrix


def explains(solution: Solution, throws: list[Throw]) -> bool:
    """Whether residuals are small compared with the variation of the rates."""
    return rms(solution.residuals) < LIMITS.max_unexplained * variation(throws)


def variation(throws: list[Throw]) -> float:
    """Return the root mean square deviation of the rates from their mean [rad/s]."""
    rates = np.concatenate([throw.rates for throw in throws])
    return rms(rates - rates.mean(axis=0))


def rms(x: Array) -> float:
    """Return the root mean square."""
    return float(np.sqrt(np.mean(x * x)))


def whitening_matrices(fast: Array, sigma: float, jitter: float) -> Float64[Array, "n 3 3"]:
    """Return Σ^(−1/2) (n, 3, 3) of Σ = σ² + τ² ω̇ ω̇ᵀ: a clock's error shows along the acceleration."""
    size = np.linalg.norm(fast, axis=1)
    u = fast / np.maximum(size, 1e-300)[:, None]
    along = 1.0 / np.hypot(sigma, jitter * size)
    return np.eye(3) / sigma + (along - 1.0 / sigma)[:, None, None] * u[:, :, None] * u[:, None, :]


def estimate_noise(residuals: Array, fast: Array, lost: float, latest: float) -> tuple[float, float, float]:
    """Return σ, τ and −2 ln(likelihood) by maximum likelihood, outliers downweighted.

    Args:
        residuals: (n, 3).
        fast: (n, 3) the device's angular acceleration.
        lost: degrees of freedom used by the fit.
        latest: largest plausible τ [s].
    """
    size2 = (fast * fast).sum(axis=1)
    along2 = np.einsum("ij,ij->i", residuals, fast) ** 2 / np.maximum(size2, 1e-300)
    across2 = np.maximum((residuals**2).sum(axis=1) - along2, 0.0)
    count = residuals.size

    def parts(ratio: float) -> tuple[float, float]:
        grown = 1.0 + ratio * size2
        z2 = across2 + along2 / grown
        middle = np.median(z2) / 2.366 + 1e-300  # of the sum of three squares
        variance = np.minimum(z2, 16.0 * middle).sum() / count
        return variance, count * np.log(variance + 1e-300) + np.log(grown).sum()

    # ratios of the clock's part to the gyro's, from nothing to a thousand times
    typical = max(float(np.median(size2)), 1e-300)
    minimum: Any = minimize_scalar(lambda v: parts(np.exp(v) / typical)[1], bounds=(-9.0, 7.0), method="bounded")
    ratio = float(np.exp(minimum.x) / typical) if minimum.fun < parts(0.0)[1] else 0.0
    variance, cost = parts(ratio)
    sigma = float(np.sqrt(variance * count / max(count - lost, 1.0)))
    if np.sqrt(ratio) * sigma > latest:
        ratio = 0.0
        variance, cost = parts(ratio)
        sigma = float(np.sqrt(variance * count / max(count - lost, 1.0)))
    return max(sigma, 1e-12), float(np.sqrt(ratio) * sigma), float(cost + count * (1 + np.log(2 * np.pi)))


def fit_model(
    model: Model, x: Array, axes0: Array, throws: list[Throw], noise: tuple[float, float] | None,
    rounds: int = 6,
) -> Solution:
    """Return the robust least squares of a model from a start.

    Args:
        model: which parameters to fit.
        x: (p,) their start.
        axes0: (3, 3) device from principal at zero turn.
        throws: the samples.
        noise: σ and τ to begin with; None to take the start's own residuals.
        rounds: how often least squares and noise take turns at most; 0 to stay at the start.
    """
    data = np.concatenate([throw.rates for throw in throws])
    low, high = model.limits()
    inside = np.isfinite(low)
    x = x.copy()
    x[inside] = np.clip(x[inside], low[inside] + 1e-6, high[inside] - 1e-6)
    if noise is None:
        values, _, fast = predict_rates(model, x, axes0, throws)
        sigma, jitter = float(np.median(np.abs(data - values)) * 1.5 + 1e-9), 0.0
    else:
        sigma, jitter = noise
    x, noise, cost, converged = _descend(model, x, axes0, throws, data, (sigma, jitter), rounds)
    sigma, jitter = noise
    values, slopes, fast = predict_rates(model, x, axes0, throws)
    white = whitening_matrices(fast, sigma, jitter)
    J = (white @ slopes).reshape(-1, model.size)
    J = np.where(np.isfinite(J), J, 0.0)  # a motion that overflows determines nothing
    cost = cost if np.isfinite(cost) else np.inf
    z = (white @ (data - values)[..., None]).ravel()
    which, means, weights = model.prior()
    covariance = compute_covariance(np.concatenate([J, weights @ np.eye(model.size)[which]]))
    cost += float(((weights @ (x[which] - means)) ** 2).sum())
    count, size = data.size, float(np.einsum("ij,ik,kj->", J, J, covariance)) + 2.0
    axes, change = turn_axes(model, x, axes0)
    covariance = change @ covariance @ change.T / np.mean(np.abs(z) < LIMITS.max_quadratic_error) ** 2
    return Solution(
        model, x, axes, covariance, data - values, sigma, jitter, -0.5 * cost,
        cost + 2 * size * count / max(count - size - 1, 1), cost + size * np.log(count),
        float(max(count - size, 1)), converged,
    )


def turn_axes(model: Model, x: Array, axes0: Array) -> tuple[Float64[Array, "3 3"], Float64[Array, "p p"]]:
    """Return the axes after the turn, and the Jacobian that makes changes of the turn those about these axes."""
    turn = model.places["turn"]
    change = np.eye(model.size)
    change[turn, turn] = right_jacobian(x[turn])
    return axes0 @ Rotation.from_rotvec(x[turn]).as_matrix(), change


def _descend(
    model: Model, x: Array, axes0: Array, throws: list[Throw], data: Array, noise: tuple[float, float],
    rounds: int,
) -> tuple[Array, tuple[float, float], float, bool]:
    """Return parameters, noise, −2 ln(likelihood) and whether they converged, by least squares and noise in turn."""
    lost = model.size - 6 * model.gain
    cost = np.inf
    latest = LIMITS.max_jitter * float(np.median(np.concatenate([np.diff(throw.elapsed) for throw in throws])))
    for k in range(rounds):
        system = _System(model, axes0, throws, data, *noise)
        done = least_squares(
            system.residuals, x, jac=system.jacobian, bounds=model.limits(),  # pyright: ignore[reportArgumentType]
            loss=system.loss,  # pyright: ignore[reportArgumentType]
            f_scale=LIMITS.max_quadratic_error, x_scale="jac", xtol=1e-9, ftol=1e-4, gtol=1e-12, max_nfev=25,
        )
        x = done.x
        values, _, fast = predict_rates(model, x, axes0, throws)
        before = noise[0]
        sigma, jitter, cost = estimate_noise(data - values, fast, lost, latest)
        noise = sigma, jitter
        if done.status > 0 and abs(noise[0] / before - 1.0) < LIMITS.noise_tolerance:
            return x, noise, cost, True
        if k and rms(data - values) > LIMITS.max_unexplained * variation(throws):
            break  # more rounds will not explain it
    return x, noise, cost, False


def compute_covariance(J: Array) -> Float64[Array, "p p"]:
    """Return (JᵀJ)⁻¹, very large along undetermined directions."""
    scale = np.linalg.norm(J, axis=0)
    scale = np.where(scale > 0, scale, 1.0)
    _, values, right = np.linalg.svd(J / scale, full_matrices=False)
    root = right.T / np.maximum(values, 1e-9 * values[0]) / scale[:, None]
    return root @ root.T


class _System:
    """Residuals over their noise and their Jacobian, of one evaluation for both."""

    def __init__(
        self, model: Model, axes0: Array, throws: list[Throw], data: Array, sigma: float, jitter: float
    ) -> None:
        self.given = model, axes0, throws
        self.data, self.noise = data, (sigma, jitter)
        self.at: Array | None = None

    def _evaluate(self, x: Array) -> None:
        if self.at is not None and np.array_equal(self.at, x):
            return
        model, axes0, throws = self.given
        values, J, fast = predict_rates(model, x, axes0, throws)
        if self.at is None:  # weights that change would reward fast motion by a smaller sum
            self.white = whitening_matrices(fast, *self.noise)
        r = (self.white @ (values - self.data)[..., None]).ravel()
        K = (self.white @ J).reshape(-1, model.size)
        which, means, weights = model.prior()
        r = np.concatenate([r, weights @ (x[which] - means)])
        K = np.concatenate([K, weights @ np.eye(model.size)[which]])
        self.at, self.r, self.K = x.copy(), np.nan_to_num(r, nan=1e6), np.nan_to_num(K)

    def loss(self, z: Array) -> Float64[Array, "3 m"]:
        """Return Huber's function of the squares and its two derivatives, but the squares themselves for the priors."""
        far = (z > 1.0) & (np.arange(len(z)) < self.data.size)
        root = np.sqrt(np.where(far, z, 1.0))
        return np.stack([np.where(far, 2 * root - 1, z), 1 / root, np.where(far, -0.5 / root**3, 0.0)])

    def residuals(self, x: Array) -> Float64[Array, "m"]:
        self._evaluate(x)
        return self.r

    def jacobian(self, x: Array) -> Float64[Array, "m p"]:
        self._evaluate(x)
        return self.K
