"""Attitude and rates of a body with a constant torque or a wheel, their derivatives, and a start for a fit of these.

Everything is along the principal axes, with the parameters of ``throw_models``.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import cumulative_trapezoid, solve_ivp
from scipy.spatial.transform import Rotation

from polhode.measuring.throws._linear_start import inertia_matrix, momentum_map, possible_moments
from polhode.measuring.throws._throw_fit import cross_matrix
from polhode.measuring.throws._throw_models import D_MOMENTS, compute_moments
from polhode.types import Array, Float64

COUNT = 8  # s, c, the starting rates, and the torque or the wheel's momentum
Motion = tuple[Float64[Array, "n 4"], Float64[Array, "n 3"], Float64[Array, "p n 3"], Float64[Array, "p n 3"]]


def integrate_torqued(
    shape: Float64[Array, "2"], start: Float64[Array, "3"], push: Float64[Array, "3"], elapsed: Float64[Array, "n"],
    wheel: bool = False,
) -> Motion:
    """Return attitudes wxyz, rates, turns of the body by each parameter, and derivatives of the rates.

    Args:
        shape: s and c of the moments.
        start: rates at zero [rad/s].
        push: over the third moment, a torque that is constant in the body [rad/s²] or the momentum of a wheel [rad/s].
        elapsed: increasing, of either sign [s].
        wheel: whether it is a wheel's.
    """
    field = _Field(compute_moments(shape), push, wheel)
    begin = np.zeros(7 + 6 * COUNT)
    begin[0], begin[4:7] = 1.0, start
    begin[7:].reshape(2, COUNT, 3)[1, 2:5] = np.eye(3)
    size = max(float(np.linalg.norm(start)), 1e-3)
    tolerance, loose = 1e-10, 1e-6  # of the motion, and of its derivatives, which only steer the iteration
    allowed = np.concatenate([np.full(4, tolerance), np.full(3, tolerance * size), np.full(6 * COUNT, loose)])
    out = np.full((len(elapsed), len(begin)), np.nan)
    for side in (elapsed < 0, elapsed >= 0):
        if not side.any():
            continue
        wanted = elapsed[side]
        back = wanted[0] < 0
        wanted = wanted[::-1] if back else wanted
        done = solve_ivp(
            field, (0.0, wanted[-1] or 1e-9), begin, method="DOP853", t_eval=wanted, rtol=tolerance, atol=allowed
        )
        if done.success:
            out[side] = done.y.T[::-1] if back else done.y.T
    changes = np.moveaxis(out[:, 7:].reshape(-1, 2, COUNT, 3), 0, 2)
    attitude = out[:, :4] / np.linalg.norm(out[:, :4], axis=1, keepdims=True)
    return attitude, out[:, 4:7], changes[0], changes[1]


class _Field:
    """Euler's equations with a constant torque N or a wheel's, h × ω, the attitude, and the variations of both."""

    def __init__(self, moments: Array, push: Array, wheel: bool) -> None:
        over = 1.0 / moments
        i1, i2, i3 = moments
        d = D_MOMENTS
        self.k = np.array([i2 - i3, i3 - i1, i1 - i2]) * over
        # ω̇1 = k1 ω2 ω3 + N1/I1 with k1 = (I2 − I3)/I1, so that δk1 = (δI2 − δI3 − k1 δI1)/I1
        spread = np.stack([d[:, 1] - d[:, 2], d[:, 2] - d[:, 0], d[:, 0] - d[:, 1]], axis=-1)
        self.dk = (spread - self.k * d) * over
        self.over, self.d_over = over, -d * over
        self.push, self.wheel = push, wheel

    def __call__(self, t: float, y: Array) -> Array:
        w, x, z, s = y[:4]
        a, b, c = y[4:7]
        turns, slopes = y[7:].reshape(2, COUNT, 3)
        pairs = np.array([b * c, c * a, a * b])
        k1, k2, k3 = self.k
        jacobian = np.array([[0.0, k1 * c, k1 * b], [k2 * c, 0.0, k2 * a], [k3 * b, k3 * a, 0.0]])
        hat = np.array([[0.0, -c, b], [c, 0.0, -a], [-b, a, 0.0]])
        out = np.empty(7 + 6 * COUNT)
        out[:4] = 0.5 * (-x * a - z * b - s * c), 0.5 * (w * a + z * c - s * b), 0.5 * (w * b + s * a - x * c), \
            0.5 * (w * c + x * b - z * a)  # fmt: skip
        torque, by_push = self.push, np.eye(3)
        if self.wheel:
            torque, by_push = np.cross(self.push, y[4:7]), hat  # row i: e_i × ω
            jacobian += self.over[:, None] * cross_matrix(self.push)
        out[4:7] = self.k * pairs + self.over * torque
        changes = out[7:].reshape(2, COUNT, 3)
        changes[0] = slopes + turns @ hat  # −ω × η + δω
        changes[1] = slopes @ jacobian.T
        changes[1, :2] += self.dk * pairs + self.d_over * self.over * torque
        changes[1, 5:] += by_push * self.over
        return out


def estimate_torqued_start(
    times: Float64[Array, "n"], rates: Float64[Array, "n 3"], attitudes: Float64[Array, "n 4"]
) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"], Float64[Array, "3"]]:
    """Return moments over the largest, principal axes by columns, and the torque over the largest moment.

    R J ω − (∫R dt) N is constant in space, so J and N are in the null space of the centred map.

    Args:
        times: [s].
        rates: [rad/s, device frame].
        attitudes: quaternions xyzw, device → a frame at rest.
    """
    R = Rotation.from_quat(attitudes).as_matrix()
    pushed = -cumulative_trapezoid(R, times, axis=0, initial=0.0)
    # of like sizes, or noise would determine the least singular vector
    scale = np.linalg.norm(rates) / max(float(np.linalg.norm(pushed - pushed.mean(axis=0))), 1e-300)
    maps = np.concatenate([momentum_map(attitudes, rates), scale * pushed], axis=2)
    _, _, right = np.linalg.svd((maps - maps.mean(axis=0)).reshape(-1, 9), full_matrices=False)
    J, torque = inertia_matrix(right[-1, :6]), scale * right[-1, 6:]
    sign = np.sign(np.trace(J) or 1.0)
    moments, axes = np.linalg.eigh(sign * J)
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    return possible_moments(moments), axes, sign * axes.T @ torque / max(float(moments[2]), 1e-300)
