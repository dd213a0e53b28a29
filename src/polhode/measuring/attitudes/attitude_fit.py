"""The inertia of a body from a log of its attitude: by tracking, motion capture, or a spacecraft's ephemeris."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation._estimate import Estimate
from polhode.estimation._last_steps import take_last_steps
from polhode.exact.free_body.motion import FreeMotion
from polhode.measuring.attitudes._torqued_states import estimate_torqued_start, integrate_torqued
from polhode.measuring.throws._linear_start import linear_inertia
from polhode.measuring.throws._principal import Principal, explain_undetermined, principal
from polhode.measuring.throws._throw_doubts import why_impossible
from polhode.measuring.throws._throw_fit import LIMITS as FIT_LIMITS
from polhode.measuring.throws._throw_fit import compute_covariance, cross_matrix, right_jacobian
from polhode.measuring.throws._throw_models import D_MOMENTS, compute_moments, compute_shape, free_states
from polhode.measuring.throws.gyro_log import check_sizes
from polhode.motion._inputs import name_of
from polhode.special._residual_noise import LIMITS as NOISE
from polhode.special._residual_noise import Misfit, NoiseTest, test_noise
from polhode.types import Array, ArrayLike, Float64, Real

PLACES = {"shape": slice(0, 2), "turn": slice(2, 5), "start": slice(5, 8), "attitude": slice(8, 11)}
PUSH = slice(11, 14)  # the torque or the wheel, where there is one; a gyro's bias comes last
PARAMETER_BOUNDS = ([-1.0, 0.0, *[-np.inf] * 15], [1.0, 2.0, *[np.inf] * 15])
BIAS = ("bias x", "bias y", "bias z")


class AttitudeThresholds(NamedTuple):
    """Numbers that decide which logs of attitudes are refused.

    Attributes:
        min_samples: of a log, for the eleven parameters of a free motion.
        length_tolerance: by which the length of a quaternion may miss 1, as printed digits make it.
    """

    min_samples: int = 12
    length_tolerance: float = 0.01


LIMITS = AttitudeThresholds()


@dataclass(frozen=True, eq=False)
class AttitudeFit:
    """The result of a fit to a log of attitudes.

    Attributes:
        ratios: I1/I3 and I2/I3, I1 ≤ I2 ≤ I3; None where the fit is degenerate.
        axes: (3, 3) principal axes by columns [device frame]; None where the fit is degenerate.
        axes_error: turn of the axes about themselves [rad], zero with its covariance.
        joint: ratios and turn together, with all their correlations.
        equal: which neighbours are equal within their errors, or None.
        torque: constant torque over I3 [rad/s², device frame]; None where there is none.
        bias: of the gyro [rad/s, device frame]; None where no rates were given.
        misfit: why the residuals are not noise; None where they are. The estimates are then of a wrong model: they
            have no errors (NaN).
        motion: free motion along the principal axes, moments over the largest; its attitude principal → space. With a
            torque it is the one that touches the motion at its epoch.
        regime: of the motion.
        times: (n,) [s].
        residuals: (n, 3) turns from the fitted to the measured attitude [rad, device frame].
        rms: of the residuals [rad].
        sigma: noise of an attitude about each axis [rad].
        rate_sigma: noise of a rate along each axis [rad/s]; None where no rates were given.
        aicc: Akaike's corrected criterion of each model that was tried: "free", "torque", and "wheel" where neither
            leaves noise.
        degenerate: why the log does not determine the inertia; None where it does.
        singular_values: (6,) of the linear method.
    """

    ratios: Estimate | None
    axes: Float64[Array, "3 3"] | None
    axes_error: Estimate | None
    joint: Estimate | None
    equal: str | None
    torque: Estimate | None
    bias: Estimate | None
    misfit: Misfit | None
    motion: FreeMotion | None
    regime: str | None
    times: Float64[Array, "n"]
    residuals: Float64[Array, "n 3"]
    rms: float
    sigma: float
    rate_sigma: float | None
    aicc: dict[str, float]
    degenerate: str | None
    singular_values: Float64[Array, "6"]


@known_numbers_only
def fit_attitude(
    times: Real[ArrayLike, "n"],
    quaternions: Real[ArrayLike, "n 4"],
    rates: Real[ArrayLike, "n 3"] | None = None,
    torque: bool | str = False,
) -> AttitudeFit:
    """Fit the inertia of a body to its measured attitude, by robust least squares on the motion.

    Without a torque the motion is the exact free one, with its exact derivatives; with one, which is constant in the
    body as of a leaking thruster, Euler's equations and their variations are integrated. Where rates are given, their
    bias is fitted too. Residuals that are no noise show that something else acts on the body: then the estimates have
    no errors, as those of a wrong model are unknown.

    Args:
        times: (n,) increasing [s]; equal steps are not needed, but less than half a turn from each to the next.
        quaternions: (n, 4) unit wxyz, device → space. Rows with NaN are left out.
        rates: (n, 3) measured rates, if any [rad/s, device frame]; they are weighted by their own noise.
        torque: whether there is a constant torque; "auto" for what Akaike's criterion prefers.

    Raises:
        InvalidInput: for wrong shapes, times that do not increase, quaternions of length zero, or fewer than 12 rows.

    Example:
        >>> import numpy as np
        >>> from polhode import FreeMotion
        >>> t = np.arange(0.0, 2.0, 0.01)
        >>> motion = FreeMotion((0.2, 0.8, 1.0), angular_velocity=(1.0, 5.0, 1.0))
        >>> fit_attitude(t, motion.attitude(t)).ratios.value.round(6).tolist()
        [0.2, 0.8]
    """
    if torque not in (True, False, "auto"):
        raise InvalidInput(f'torque must be True, False or "auto"; got {shown(torque)}.')
    t, measured, gyro = _clean(times, quaternions, rates)
    middle = len(t) // 2
    epoch = float(t[middle])
    slow, attitudes, at = _difference_attitudes(t, measured)
    linear = linear_inertia([slow], [attitudes])
    k = int(np.argmin(np.abs(at - epoch)))
    samples = _Samples(t - epoch, measured, gyro)

    def descend_from(moments: Array, axes: Array, push: Array, acting: str = "torque") -> _Solution:
        bias = np.zeros(0 if gyro is None else 3)
        x = np.concatenate([compute_shape(moments), np.zeros(3), axes.T @ slow[k], np.zeros(3), push, bias])
        attitude0 = measured[middle] * Rotation.from_matrix(axes)
        return _descend(_System(samples, axes, attitude0, acting if len(push) else ""), x)

    tried: dict[str, _Solution] = {}
    if torque is not True:
        tried["free"] = descend_from(linear.moments, linear.axes, np.zeros(0))
    if torque:
        starts = [descend_from(*estimate_torqued_start(at, slow, attitudes)),
                  descend_from(linear.moments, linear.axes, np.zeros(3))]  # fmt: skip
        tried["torque"] = min(starts, key=lambda solution: solution.aicc)
    best = min(tried.values(), key=lambda solution: solution.aicc)
    test = _test_residuals(best)
    if not test.is_noise and torque == "auto":
        wheel = linear_inertia([slow], [attitudes], rotor=True)
        tried["wheel"] = descend_from(wheel.moments, wheel.axes, wheel.axes.T @ wheel.rotor, "wheel")
    misfit = None if test.is_noise else Misfit(test, tuple(name for name in ("torque", "wheel") if name in tried),
        next((name for name, one in tried.items() if one is not best and one.aicc < best.aicc
              and _test_residuals(one).is_noise), None))
    scores = {name: solution.aicc for name, solution in tried.items()}
    return _make_result(best, t, epoch, slow, scores, linear.singular_values, misfit)


def _test_residuals(solution: _Solution) -> NoiseTest:
    system = solution.system
    blocks = system.blocks(solution.x)
    if float(np.sqrt(np.mean(blocks[0][0] ** 2))) < NOISE.exact:
        return NoiseTest(1.0, 0.0)
    slopes = [J / size for (_, J), size in zip(blocks, solution.noise, strict=True)]
    return test_noise([r for r, _ in blocks], slopes)


class _Samples(NamedTuple):
    """The data: times from the epoch, attitudes, and perhaps rates."""

    elapsed: Array
    measured: Rotation
    rates: Array | None


class _Solution(NamedTuple):
    """Parameters with their covariance, the noise of attitudes and rates, and the quality of the fit."""

    system: _System
    x: Array
    covariance: Array
    noise: Array
    freedom: float
    aicc: float


def _make_result(
    solution: _Solution, t: Array, epoch: float, rates: Array, scores: dict[str, float], singular: Array,
    misfit: Misfit | None,
) -> AttitudeFit:
    system, x = solution.system, solution.x
    change = np.eye(len(x))
    change[2:5, 2:5] = right_jacobian(x[2:5])
    covariance = change @ solution.covariance @ change.T
    axes = system.axes0 @ Rotation.from_rotvec(x[2:5]).as_matrix()
    inertia = principal(x[:11], covariance[:11, :11], PLACES, axes, solution.freedom)
    residuals = system.blocks(x)[0][0]
    rms = float(np.sqrt(np.mean(residuals**2)))
    sigma, rate_sigma = float(solution.noise[0]), float(solution.noise[1]) if len(solution.noise) > 1 else None
    reason = why_impossible(inertia) if inertia.determined else explain_undetermined([rates], inertia)
    if reason is not None:
        return AttitudeFit(None, None, None, None, None, None, None, misfit, None, None, t, residuals, rms, sigma,
                           rate_sigma, scores, reason, singular)
    start = inertia.order.T @ x[PLACES["start"]]
    there = system.attitude0 * Rotation.from_rotvec(x[PLACES["attitude"]]) * Rotation.from_matrix(inertia.order)
    motion = FreeMotion(
        inertia.moments, momentum=inertia.moments * start, attitude=there.as_quat(scalar_first=True), epoch=epoch
    )
    torque = _torque(x, covariance, axes, inertia, solution.freedom) if system.acting == "torque" else None
    bias = None
    if rate_sigma is not None:
        bias = Estimate(BIAS, x[-3:], covariance[-3:, -3:], solution.freedom)
    known = [inertia.ratios, inertia.turn, inertia.joint, torque, bias]
    if misfit is not None:
        known = [None if one is None else one.without_errors() for one in known]
    ratios, turn, joint, torque, bias = known
    equal = inertia.equal if misfit is None else None
    return AttitudeFit(ratios, inertia.axes, turn, joint, equal, torque, bias, misfit, motion, name_of(motion.regime),
                       t, residuals, rms, sigma, rate_sigma, scores, None, singular)


def _torque(x: Array, covariance: Array, axes: Array, inertia: Principal, freedom: float) -> Estimate:
    """Return the torque over the largest moment along the device's axes, errors of moments and axes included."""
    third = int(np.argmax(inertia.order[:, 2] != 0))
    largest = float(compute_moments(x[PLACES["shape"]])[third])
    own = x[PUSH]
    value = axes @ own / largest
    by = np.zeros((3, len(x)))
    by[:, PUSH] = axes / largest
    by[:, PLACES["shape"]] = -np.outer(value, D_MOMENTS[:, third]) / largest
    by[:, PLACES["turn"]] = -axes @ cross_matrix(own) / largest
    return Estimate(("Nx/I3", "Ny/I3", "Nz/I3"), value, by @ covariance @ by.T, freedom)


def _descend(system: _System, x: Array) -> _Solution:
    """Return the solution from a start: least squares and the noise of each kind of data in turn."""
    size = len(x)
    low, high = (np.array(limit[:size]) for limit in PARAMETER_BOUNDS)
    data = sum(r.size for r, _ in system.blocks(x))
    freedom = float(max(data - size, 1))
    noise = np.array([float(np.median(np.abs(r))) * 1.5 + 1e-9 for r, _ in system.blocks(x)])
    robust = FIT_LIMITS.max_quadratic_error
    for _ in range(6):
        system.noise = noise
        done = least_squares(
            system.residuals, x, jac=system.jacobian,  # pyright: ignore[reportArgumentType]
            bounds=(low, high),  # pyright: ignore[reportArgumentType]
            loss="huber", f_scale=robust, x_scale="jac", xtol=1e-10, ftol=1e-8, gtol=1e-15, max_nfev=60,
        )
        x, before = done.x, noise
        noise = np.array([_noise(r, freedom / data) for r, _ in system.blocks(x)])
        if done.status > 0 and np.abs(noise / before - 1.0).max() < FIT_LIMITS.noise_tolerance:
            break
    system.noise = noise
    x, left = take_last_steps(system, x, low, high, robust)
    system.noise = noise = np.array([_noise(r, freedom / data) for r, _ in system.blocks(x)])
    z, J = system.residuals(x), system.jacobian(x)
    # the remaining step of the iteration is an error too, and for data without noise the larger one
    covariance = compute_covariance(J) / np.mean(np.abs(z) < robust) ** 2 + np.outer(left, left)
    cost = sum(2.0 * r.size * np.log(s) for (r, _), s in zip(system.blocks(x), noise, strict=True))
    count = size + len(noise)
    return _Solution(system, x, covariance, noise, freedom, float(cost + 2 * count * data / max(data - count - 1, 1)))


def _noise(r: Array, share: float) -> float:
    # outliers are drawn in, or one of them would make all other residuals seem small
    sizes = np.abs(r)
    drawn = np.minimum(sizes, 4 * 1.4826 * np.median(sizes))
    return max(float(np.sqrt(np.mean(drawn**2) / share)), 1e-13)


def _clean(times: ArrayLike, quaternions: ArrayLike, rates: ArrayLike | None) -> tuple[Array, Rotation, Array | None]:
    t, q = np.asarray(times, dtype=np.float64), np.asarray(quaternions, dtype=np.float64)
    if t.ndim != 1 or q.shape != (len(t), 4):
        raise InvalidInput(f"times of shape (n,) and quaternions of shape (n, 4) are needed; got {shown(t.shape)} and "
                           f"{shown(q.shape)}.")
    gyro = None if rates is None else np.asarray(rates, dtype=np.float64)
    if gyro is not None and gyro.shape != (len(t), 3):
        raise InvalidInput(f"rates must have the shape (n, 3), one for each time; got {shown(gyro.shape)}.")
    whole = np.isfinite(t) & np.isfinite(q).all(axis=1)
    whole &= True if gyro is None else np.isfinite(gyro).all(axis=1)
    t, q, gyro = t[whole], q[whole], None if gyro is None else gyro[whole]
    check_sizes(times=t, rates=np.zeros(0) if gyro is None else gyro)
    if len(t) < LIMITS.min_samples or not (np.diff(t) > 0).all():
        raise InvalidInput(f"at least {LIMITS.min_samples} attitudes at increasing times are needed; got {len(t)}. "
                           "Sort them by time and leave out repeated times.")
    lengths = np.linalg.norm(q, axis=1)
    if (np.abs(lengths - 1.0) > LIMITS.length_tolerance).any():
        worst = lengths[np.argmax(np.abs(lengths - 1.0))]
        raise InvalidInput(f"quaternions must be of unit length; got one of length {worst:g}.")
    return t, Rotation.from_quat(q, scalar_first=True), gyro


def _difference_attitudes(t: Array, measured: Rotation) -> tuple[Array, Array, Array]:
    """Return rates over steps of some tenths of a radian, and the attitudes xyzw and times in their middles."""
    turn = float(np.median((measured[:-1].inv() * measured[1:]).magnitude()))
    step = 0.3  # rad, over which noise of the attitude does not dominate a rate
    stride = int(np.clip(round(step / max(turn, 1e-12)), 1, max(len(t) // 8, 1)))
    steps = (measured[:-stride].inv() * measured[stride:]).as_rotvec()
    middles = measured[:-stride] * Rotation.from_rotvec(0.5 * steps)
    rates = steps / (t[stride:] - t[:-stride])[:, None]
    return rates, middles.as_quat(), 0.5 * (t[stride:] + t[:-stride])


class _System:
    """Residuals of attitudes and rates, and their derivatives; one evaluation serves both."""

    def __init__(self, samples: _Samples, axes0: Array, attitude0: Rotation, acting: str) -> None:
        self.samples, self.axes0, self.attitude0, self.acting = samples, axes0, attitude0, acting
        self.noise = np.ones(1 if samples.rates is None else 2)
        self.at: Array | None = None

    def _motion(self, x: Array) -> tuple[Array, Array, Array, Array]:
        if self.acting:
            return integrate_torqued(x[:2], x[5:8], x[PUSH], self.samples.elapsed, self.acting == "wheel")
        q, rates, dq, d_rates = free_states(x[:2], x[5:8], self.samples.elapsed)
        w, v, dw, dv = q[:, :1], q[:, 1:], dq[..., :1], dq[..., 1:]
        return q, rates, 2.0 * (w * dv - dw * v - np.cross(v, dv)), d_rates  # of δq, the turn is 2 vec(q* δq)

    def blocks(self, x: Array) -> list[tuple[Float64[Array, "n 3"], Float64[Array, "n 3 p"]]]:
        """Return residuals (n, 3) and their derivatives (n, 3, p), of attitudes and perhaps of rates."""
        if self.at is not None and np.array_equal(self.at, x):
            return self.evaluated
        q, rates, turns, slopes = self._motion(x)
        since = Rotation.from_quat(np.nan_to_num(q, nan=1.0), scalar_first=True)
        own = Rotation.from_matrix(self.axes0) * Rotation.from_rotvec(x[2:5])
        A = own.as_matrix()
        begin = self.attitude0 * Rotation.from_rotvec(x[8:11])
        r = ((begin * since * own.inv()).inv() * self.samples.measured).as_rotvec()
        moved = right_jacobian(x[2:5])
        columns = [0, 1, 5, 6, 7, *([11, 12, 13] if self.acting else [])]  # shape, start, torque or wheel
        J = np.zeros((len(q), 3, len(x)))
        # predicted attitudes change by R exp(hat η) along the principal axes
        J[:, :, columns] = np.moveaxis(turns @ A.T, 0, 2)
        J[:, :, 2:5] = -A @ moved
        J[:, :, 8:11] = A @ np.swapaxes(since.as_matrix(), 1, 2) @ right_jacobian(x[8:11])
        blocks: list[tuple[Array, Array]] = [(np.nan_to_num(r, nan=1e3), -np.nan_to_num(J))]
        if self.samples.rates is not None:
            K = np.zeros_like(J)
            K[:, :, columns] = np.moveaxis(slopes @ A.T, 0, 2)
            K[:, :, 2:5] = A @ np.stack([cross_matrix(-w) for w in rates]) @ moved
            K[:, :, -3:] = np.eye(3)
            blocks.append((np.nan_to_num(self.samples.rates - rates @ A.T - x[-3:], nan=1e3), -np.nan_to_num(K)))
        self.at, self.evaluated = x.copy(), blocks
        return blocks

    def residuals(self, x: Array) -> Float64[Array, "m"]:
        """Return all residuals over their noise."""
        return np.concatenate([r.ravel() / s for (r, _), s in zip(self.blocks(x), self.noise, strict=True)])

    def jacobian(self, x: Array) -> Float64[Array, "m p"]:
        """Return their derivatives."""
        return np.concatenate([
            J.reshape(-1, len(x)) / s for (_, J), s in zip(self.blocks(x), self.noise, strict=True)
        ])
