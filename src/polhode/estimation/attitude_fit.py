"""The inertia of a free body from a log of its attitude: by tracking, motion capture, or a spacecraft's ephemeris."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation.estimate import Estimate
from polhode.estimation.linear_start import linear_inertia
from polhode.estimation.principal import principal, why_undetermined
from polhode.estimation.throw_fit import ROBUST, covariance_of, right_jacobian
from polhode.estimation.throw_models import free_states, shape_of
from polhode.exact.free_body.motion import FreeMotion
from polhode.types import Array, ArrayLike, Float64, Real

STEP = 0.3  # rad, over which rates are taken for the start, so that noise of the attitude does not swamp them
PLACES = {"shape": slice(0, 2), "turn": slice(2, 5), "start": slice(5, 8), "attitude": slice(8, 11)}
LIMITS = ([-1.0, 0.0, *[-np.inf] * 9], [1.0, 2.0, *[np.inf] * 9])


@dataclass(frozen=True)
class AttitudeFit:
    """What a log of attitudes says of a free body.

    Attributes:
        ratios: I1/I3 and I2/I3, I1 ≤ I2 ≤ I3; None where the fit is degenerate.
        axes: (3, 3) principal axes by columns [device frame]; None where the fit is degenerate.
        axes_error: turn of the axes about themselves [rad], zero with its covariance.
        joint: ratios and turn together, with all their correlations.
        equal: which neighbours are equal within their errors, or None.
        motion: along the principal axes, moments over the largest; its attitude principal → space.
        regime: of the motion.
        times: (n,) [s].
        residuals: (n, 3) turns from the fitted to the measured attitude [rad, device frame].
        rms: of the residuals [rad].
        sigma: noise of an attitude about each axis [rad].
        degenerate: why the inertia is not determined; None where it is.
        singular_values: (6,) of the linear method.
    """

    ratios: Estimate | None
    axes: Float64[Array, "3 3"] | None
    axes_error: Estimate | None
    joint: Estimate | None
    equal: str | None
    motion: FreeMotion | None
    regime: str | None
    times: Float64[Array, "n"]
    residuals: Float64[Array, "n 3"]
    rms: float
    sigma: float
    degenerate: str | None
    singular_values: Float64[Array, "6"]


@known_numbers_only
def fit_attitude(times: Real[ArrayLike, "n"], quaternions: Real[ArrayLike, "n 4"]) -> AttitudeFit:
    """Fit the inertia of a free body to its measured attitude, by robust least squares on the exact motion.

    Args:
        times: (n,) increasing [s]; equal steps are not needed, but less than half a turn from each to the next.
        quaternions: (n, 4) unit wxyz, device → space. Rows with NaN are left out.

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
    t, measured = _cleaned(times, quaternions)
    middle = len(t) // 2
    epoch = float(t[middle])
    rates, turned = _differenced(t, measured)
    linear = linear_inertia([rates], [turned])
    axes0, attitude0 = linear.axes, measured[middle] * Rotation.from_matrix(linear.axes)
    k = int(np.argmin(np.abs(np.linspace(0, len(t) - 1, len(rates)) - middle)))
    x = np.concatenate([shape_of(linear.moments), np.zeros(3), axes0.T @ rates[k], np.zeros(3)])
    system = _System(t - epoch, measured, axes0, attitude0)
    x, sigma, freedom = _descended(system, x)
    r, J = system.residuals(x), system.jacobian(x)
    covariance = covariance_of(J / sigma) / np.mean(np.abs(r) < ROBUST * sigma) ** 2
    change = np.eye(len(x))
    change[2:5, 2:5] = right_jacobian(x[2:5])
    axes = axes0 @ Rotation.from_rotvec(x[2:5]).as_matrix()
    found = principal(x, change @ covariance @ change.T, PLACES, axes, freedom)
    residuals, rms = r.reshape(-1, 3), float(np.sqrt(np.mean(r * r)))
    if not found.determined:
        reason = why_undetermined([rates], found)
        return AttitudeFit(None, None, None, None, None, None, None, t, residuals, rms, sigma, reason,
                           linear.singular_values)  # fmt: skip
    start = found.order.T @ x[PLACES["start"]]
    there = attitude0 * Rotation.from_rotvec(x[PLACES["attitude"]]) * Rotation.from_matrix(found.order)
    motion = FreeMotion(found.moments, found.moments * start, there.as_quat(scalar_first=True), epoch)
    return AttitudeFit(found.ratios, found.axes, found.turn, found.joint, found.equal, motion, motion.regime, t,
                       residuals, rms, sigma, None, linear.singular_values)  # fmt: skip


def _descended(system: _System, x: Array) -> tuple[Array, float, float]:
    """Return parameters, the noise of an attitude and degrees of freedom: least squares and noise in turn."""
    sigma = float(np.median(np.abs(system.residuals(x)))) * 1.5 + 1e-9
    freedom = float(max(len(system.residuals(x)) - len(x), 1))
    for _ in range(6):
        done = least_squares(
            system.residuals, x, jac=system.jacobian, bounds=LIMITS,  # pyright: ignore[reportArgumentType]
            loss="huber", f_scale=ROBUST * sigma, x_scale="jac", xtol=1e-10, ftol=1e-8, gtol=1e-15, max_nfev=60,
        )  # fmt: skip
        x, before = done.x, sigma
        sizes = np.abs(system.residuals(x))
        # residuals far out are drawn in, or one of them would make all the others seem small
        drawn = np.minimum(sizes, 4 * 1.4826 * np.median(sizes))
        sigma = max(float(np.sqrt((drawn**2).sum() / freedom)), 1e-13)
        if done.status > 0 and abs(sigma / before - 1.0) < 0.02:
            break
    return x, sigma, freedom


def _cleaned(times: ArrayLike, quaternions: ArrayLike) -> tuple[Array, Rotation]:
    t, q = np.asarray(times, dtype=np.float64), np.asarray(quaternions, dtype=np.float64)
    if t.ndim != 1 or q.shape != (len(t), 4):
        raise InvalidInput(f"times of shape (n,) and quaternions of shape (n, 4) are needed; got {shown(t.shape)} and "
                           f"{shown(q.shape)}.")  # fmt: skip
    whole = np.isfinite(t) & np.isfinite(q).all(axis=1)
    t, q = t[whole], q[whole]
    if len(t) < 12 or not (np.diff(t) > 0).all():
        raise InvalidInput(f"at least 12 attitudes at increasing times are needed; got {len(t)}. Sort them by time and "
                           "leave out repeated times.")  # fmt: skip
    lengths = np.linalg.norm(q, axis=1)
    if (np.abs(lengths - 1.0) > 0.01).any():
        worst = lengths[np.argmax(np.abs(lengths - 1.0))]
        raise InvalidInput(f"quaternions must be of unit length; got one of length {worst:g}.")
    return t, Rotation.from_quat(q, scalar_first=True)


def _differenced(t: Array, measured: Rotation) -> tuple[Array, Array]:
    """Return rates over steps of some tenths of a radian, and the attitudes xyzw in their middles."""
    turn = float(np.median((measured[:-1].inv() * measured[1:]).magnitude()))
    stride = int(np.clip(round(STEP / max(turn, 1e-12)), 1, max(len(t) // 8, 1)))
    steps = (measured[:-stride].inv() * measured[stride:]).as_rotvec()
    middles = measured[:-stride] * Rotation.from_rotvec(0.5 * steps)
    return steps / (t[stride:] - t[:-stride])[:, None], middles.as_quat()


class _System:
    """Turns from predicted to measured attitudes, and their derivatives."""

    def __init__(self, elapsed: Array, measured: Rotation, axes0: Array, attitude0: Rotation) -> None:
        self.elapsed, self.measured, self.axes0, self.attitude0 = elapsed, measured, axes0, attitude0
        self.at: Array | None = None

    def _evaluate(self, x: Array) -> None:
        if self.at is not None and np.array_equal(self.at, x):
            return
        q, _, dq, _ = free_states(x[:2], x[5:8], self.elapsed)
        since = Rotation.from_quat(q, scalar_first=True)
        own = Rotation.from_matrix(self.axes0) * Rotation.from_rotvec(x[2:5])
        A = own.as_matrix()
        begin = self.attitude0 * Rotation.from_rotvec(x[8:11])
        self.r = ((begin * since * own.inv()).inv() * self.measured).as_rotvec().ravel()
        # predicted attitudes R exp(hat η): of δq, η = 2 vec(q* δq) along the principal axes
        w, v, dw, dv = q[:, :1], q[:, 1:], dq[..., :1], dq[..., 1:]
        eta = 2.0 * (w * dv - dw * v - np.cross(v, dv)) @ A.T
        J = np.empty((len(q), 3, 11))
        J[:, :, [0, 1, 5, 6, 7]] = np.moveaxis(eta, 0, 2)
        J[:, :, 2:5] = -A @ right_jacobian(x[2:5])
        J[:, :, 8:11] = A @ np.swapaxes(since.as_matrix(), 1, 2) @ right_jacobian(x[8:11])
        self.at, self.J = x.copy(), -J.reshape(-1, 11)

    def residuals(self, x: Array) -> Float64[Array, "m"]:
        self._evaluate(x)
        return self.r

    def jacobian(self, x: Array) -> Float64[Array, "m 11"]:
        self._evaluate(x)
        return self.J
