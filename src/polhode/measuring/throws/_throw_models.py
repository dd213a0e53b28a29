"""Rates of a thrown body and their exact derivatives: free motion in closed form, with air or a rotor by integration.

A body's parameters are s and c of the moments ((1 − s)/2 + c, (1 + s)/2 + c, 1), so that |s| ≤ 1 and c ≥ 0 are the
triangle inequality; those of a throw are the rates at its epoch. Everything is along the principal axes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from polhode.exact.free_body._derivative import state_tangent
from polhode.exact.free_body.motion import FreeMotion
from polhode.types import Array, Float64

D_MOMENTS = np.array([[-0.5, 0.5, 0.0], [1.0, 1.0, 0.0]])  # by s and c
Torque = tuple[Float64[Array, "3"], Float64[Array, "3 3"], Float64[Array, "3 3"]]
States = tuple[Float64[Array, "n 4"], Float64[Array, "n 3"], Float64[Array, "p n 4"], Float64[Array, "p n 3"]]


def compute_moments(shape: Float64[Array, "2"]) -> Float64[Array, "3"]:
    """Return the three moments, the third 1, of the parameters s and c."""
    s, c = shape
    return np.array([0.5 * (1.0 - s) + c, 0.5 * (1.0 + s) + c, 1.0])


def compute_shape(moments: Float64[Array, "3"]) -> Float64[Array, "2"]:
    """Return s and c of three moments."""
    x, y = moments[:2] / moments[2]
    return np.array([y - x, 0.5 * (x + y - 1.0)])


def free_states(shape: Float64[Array, "2"], start: Float64[Array, "3"], elapsed: Float64[Array, "n"]) -> States:
    """Return attitudes, rates and their derivatives by s, c and the three starting rates, without torque."""
    moments = compute_moments(shape)
    n = len(elapsed)
    attitude, momentum = FreeMotion(moments, momentum=moments * start).state(elapsed)
    d_moments, d_momentum = np.zeros((5, 3)), np.zeros((5, 3))
    d_moments[:2] = D_MOMENTS
    d_momentum[:2] = D_MOMENTS * start
    d_momentum[2:] = np.diag(moments)
    spread = lambda x: np.broadcast_to(x[..., None, :], (*x.shape[:-1], n, x.shape[-1])).copy()  # noqa: E731
    values = spread(moments), spread(moments * start), spread(np.array([1.0, 0.0, 0.0, 0.0])), elapsed
    changes = spread(d_moments), spread(d_momentum), np.zeros((5, n, 4)), np.zeros((5, n))
    with np.errstate(all="ignore"):  # branches that are not taken, as of permanent rotation
        d_attitude, d_momentum_t = state_tangent(values, (attitude, momentum), changes)
    rates = momentum / moments
    return attitude, rates, d_attitude, (d_momentum_t - rates * d_moments[:, None, :]) / moments


def free_rates(
    shape: Float64[Array, "2"], start: Float64[Array, "3"], elapsed: Float64[Array, "n"]
) -> tuple[Float64[Array, "n 3"], Float64[Array, "5 n 3"]]:
    """Return the rates and their derivatives by s, c and the three starting rates, without torque."""
    _, rates, _, d_rates = free_states(shape, start, elapsed)
    return rates, d_rates


def integrate_forced(
    shape: Float64[Array, "2"], start: Float64[Array, "3"], forces: dict[str, Array], elapsed: Float64[Array, "n"]
) -> tuple[Float64[Array, "n 3"], Float64[Array, "p n 3"]]:
    """Return the rates and their derivatives by s, c, the starting rates and each force, of air or a rotor.

    All is over the third moment and along the principal axes. The derivatives are of the variational equations,
    integrated with the motion.

    Args:
        shape: s and c.
        start: rates at zero time [rad/s].
        forces: three numbers of each of ``TORQUES`` that acts.
        elapsed: [s].
    """
    field = _Field(compute_moments(shape), forces)
    count = 6 + 3 * len(forces)
    begin = np.zeros((count, 3))
    begin[0] = start
    begin[3:6] = np.eye(3)
    out = np.empty((len(elapsed), 3 * count))
    scale = max(float(np.linalg.norm(start)), 1e-3)
    # far below the noise of any gyro; errors of the derivatives only slow the convergence down, so that a looser
    # tolerance does for them
    tolerance = 1e-8
    allowed = np.repeat([tolerance * scale, *[1e-5] * (count - 1)], 3)
    for side in (elapsed < 0, elapsed >= 0):
        if not side.any():
            continue
        wanted = elapsed[side]
        wanted = wanted[::-1] if wanted[0] < 0 else wanted
        with np.errstate(all="ignore"):  # far from the minimum a motion with drag may overflow: it becomes NaN
            done = solve_ivp(
                field, (0.0, wanted[-1] or 1e-9), begin.ravel(), method="DOP853", t_eval=wanted, rtol=tolerance,
                atol=allowed,
            )
        values = done.y.T if done.success else np.full((len(wanted), 3 * count), np.nan)
        out[side] = values[::-1] if wanted[-1] < 0 else values
    shaped = out.reshape(-1, count, 3)
    return shaped[:, 0], np.moveaxis(shaped[:, 1:], 1, 0)


def _quadratic(c: Array, w: Array, size: float) -> Torque:
    """−c_i |ω| ω_i."""
    return -size * c * w, -np.diag(size * c) - np.outer(c * w, w / (size or 1.0)), -np.diag(size * w)


def _linear(c: Array, w: Array, size: float) -> Torque:
    """−c_i ω_i."""
    return -c * w, -np.diag(c), -np.diag(w)


def _one_sided_drag(c: Array, w: Array, size: float) -> Torque:
    """−c_i |ω| |ω_i|, smooth where ω_i changes its sign: air may resist one sense of rotation more than the other."""
    width = 0.05  # of |ω|, of the transition
    length = np.sqrt(w * w + (width * size) ** 2) + 1e-300
    slope = np.diag(size * w / length) + np.outer(length / (size or 1.0) + width**2 * size / length, w)
    return -size * c * length, -c[:, None] * slope, -np.diag(size * length)


def _rotor(h: Array, w: Array, size: float) -> Torque:
    """h × ω of a wheel that turns in the body at a constant momentum."""
    hat = np.array([[0.0, -h[2], h[1]], [h[2], 0.0, -h[0]], [-h[1], h[0], 0.0]])
    by_h = np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])  # row i: e_i × ω
    return hat @ w, hat, by_h


TORQUES: dict[str, Callable[[Array, Array, float], Torque]] = {
    "drag": _quadratic, "linear_drag": _linear, "one_sided_drag": _one_sided_drag, "rotor": _rotor,
}  # fmt: skip
"""Torques besides inertia: torque (3,), its slopes (3, 3) by the rates, and by the coefficients (row by row)."""


class _Field:
    """Euler's equations with torques, and their variations by s, c, the starting rates and the coefficients."""

    def __init__(self, moments: Array, forces: dict[str, Array]) -> None:
        self.over = 1.0 / moments
        i1, i2, i3 = moments
        self.k = np.array([i2 - i3, i3 - i1, i1 - i2]) * self.over
        d = D_MOMENTS
        spread = np.stack([d[:, 1] - d[:, 2], d[:, 2] - d[:, 0], d[:, 0] - d[:, 1]], axis=-1)
        self.dk = (spread - self.k * d) * self.over
        self.d_over = -d * self.over**2
        self.forces = [(TORQUES[name], values) for name, values in forces.items()]

    def __call__(self, t: float, y: Array) -> Array:
        state = y.reshape(-1, 3)
        x1, x2, x3 = w = state[0]
        size = float(np.sqrt(x1 * x1 + x2 * x2 + x3 * x3))
        pairs = np.array([x2 * x3, x3 * x1, x1 * x2])
        k1, k2, k3 = self.k
        jacobian = np.array([[0.0, k1 * x3, k1 * x2], [k2 * x3, 0.0, k2 * x1], [k3 * x2, k3 * x1, 0.0]])
        out = np.zeros_like(state)
        torque = np.zeros(3)
        for m, (of, values) in enumerate(self.forces):
            push, by_rate, by_value = of(values, w, size)
            torque += push
            jacobian += self.over[:, None] * by_rate
            out[6 + 3 * m : 9 + 3 * m] = by_value * self.over
        out[0] = self.k * pairs + self.over * torque
        out[1:] += state[1:] @ jacobian.T
        out[1:3] += self.dk * pairs + self.d_over * torque
        return out.ravel()
