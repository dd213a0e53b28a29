"""Last steps to a minimum of squares: what SciPy's least squares and searches along a line leave undone.

They end where the sum of squares no longer falls, which is at half of the digits of its place.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np

from polhode.types import Array, Float64


class LastStepLimits(NamedTuple):
    """Numbers that decide when the last steps of a fit are done, or refused."""

    max_steps: int = 8  # of Gauss and Newton
    negligible_gain: float = 1e-6  # of half the sum of squares over the noise: less, and the minimum is reached
    max_step: float = 1e-3  # of each parameter, in its unit: a longer one does not start near the minimum
    relative_singular_value: float = 1e-10  # below it data do not determine a direction


LIMITS = LastStepLimits()


@runtime_checkable
class System(Protocol):
    """Residuals over their noise, and their derivatives."""

    def residuals(self, x: Array) -> Float64[Array, "m"]:
        """Return the residuals at the parameters x (p,)."""
        ...

    def jacobian(self, x: Array) -> Float64[Array, "m p"]:
        """Return their derivatives."""
        ...


def take_last_steps(
    system: System, x: Float64[Array, "p"], low: Float64[Array, "p"], high: Float64[Array, "p"],
    robust: float | Float64[Array, "m"] = np.inf,
) -> tuple[Float64[Array, "p"], Float64[Array, "p"]]:
    """Return the minimum by steps of Gauss and Newton, and the last of them: what the iteration leaves undone.

    Args:
        system: with residuals of about 1.
        x: near the minimum, as the method before has it.
        low, high: bounds of the parameters.
        robust: residuals beyond which these count linearly (Huber).
    """
    step, cost = np.zeros(len(x)), _robust_cost(system.residuals(x), robust)
    for _ in range(LIMITS.max_steps):
        z, J = system.residuals(x), system.jacobian(x)
        weights = np.sqrt(np.minimum(1.0, robust / np.maximum(np.abs(z), 1e-300)))
        scale = np.linalg.norm(J, axis=0)
        scale[scale == 0.0] = 1.0
        rows, rcond = weights[:, None] * J / scale, LIMITS.relative_singular_value
        step = np.linalg.lstsq(rows, -weights * z, rcond=rcond)[0] / scale
        if np.abs(step).max() > LIMITS.max_step:  # along what the data hardly determine, which the covariance says
            return x, np.zeros(len(x))
        there = np.clip(x + step, low, high)
        step, lower = there - x, _robust_cost(system.residuals(there), robust)
        if not lower <= cost:
            break
        x, done, cost = there, cost - lower, lower
        if done < LIMITS.negligible_gain:
            break
    return x, step


def _robust_cost(z: Array, robust: float | Array) -> float:
    """Return Huber's sum, half of it that of the squares."""
    sizes = np.abs(z)
    inside = np.minimum(sizes, robust)
    return float(np.sum(inside * (sizes - 0.5 * inside)))
