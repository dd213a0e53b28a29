"""Whether an engine's states converge to the exact motion as its steps become shorter, and with which order."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis._attitude_noise import root_mean_square
from polhode.types import Array, Float64


class ConvergenceThresholds(NamedTuple):
    """Numbers that decide what halved steps show.

    Attributes:
        max_order: of a method; errors that fall faster do so for another reason.
        order_tolerance: by which an observed order may miss a whole number.
        min_error_ratio: by which a halved step must divide errors, if they may still go to zero.
        max_uncertainty: rad per radian of rotation; a limit with a larger uncertainty gives no verdict.
    """

    max_order: int = 8
    order_tolerance: float = 0.2
    min_error_ratio: float = 1.5
    max_uncertainty: float = 1e-3


LIMITS = ConvergenceThresholds()


class Convergence(NamedTuple):
    """What halved steps show.

    Attributes:
        converges: whether the limit of short steps is the reference, within its uncertainty.
        order: observed, a power of the step; None where steps do not show one.
        errors: of each step, root of the mean square over the samples, attitudes in rad and momenta relative.
        limit: distance of the extrapolated limit from the reference, as the errors; None where there is none.
        unsure: a mistake that moves the states by less than this is not detected; as the errors.
        by_rounding: whether rounding explains all errors.
        momentum_order: that of the momentum alone, which may be higher; None where rounding hides it.
        open: whether shorter steps might still lead to the reference, or elsewhere.
    """

    converges: bool
    order: float | None
    errors: tuple[float, ...]
    limit: float | None
    unsure: float
    by_rounding: bool = False
    momentum_order: float | None = None
    open: bool = False


def departures(
    attitude: Float64[Array, "time 4"], momentum: Float64[Array, "time 3"],
    exact_attitude: Float64[Array, "time 4"], exact_momentum: Float64[Array, "time 3"],
) -> Float64[Array, "time 6"]:
    """Return rotation vectors [rad, body axes] and momenta relative to the largest |L|, of states from exact ones.

    All are NaN where a state is not finite.

    Args:
        attitude, momentum: (T, 4) wxyz of any length, and (T, 3), of an engine.
        exact_attitude, exact_momentum: (T, 4) unit quaternions and (T, 3).
    """
    if not (np.isfinite(attitude).all() and np.isfinite(momentum).all()):
        return np.full((len(momentum), 6), np.nan)
    turn = rotation.multiply(rotation.conjugate(exact_attitude), rotation.normalize(attitude))
    turn = np.where(turn[..., :1] < 0.0, -turn, turn)
    size = float(np.linalg.norm(exact_momentum, axis=-1).max()) or 1.0
    return np.concatenate([rotation.as_rotation_vector(turn), (momentum - exact_momentum) / size], axis=-1)


def judge_convergence(
    levels: Sequence[Float64[Array, "time 6"]], floors: Sequence[float], rotation_angle: float
) -> Convergence:
    """Judge whether states computed with steps dt, dt/2, dt/4, … converge to the reference.

    The order is that of the differences between successive levels, which do not depend on the limit. The limit is
    Richardson's; its uncertainty is its change between the last two levels. While that is more than a thousandth of
    the angle through which the body rotates, the steps are too long for a verdict.

    Args:
        levels: of each step (T, 6), the departures from the reference at the same times.
        floors: of each, the size of departures that rounding alone may cause.
        rotation_angle: through which the body rotates in that time [rad].

    Source: Richardson, Phil. Trans. R. Soc. A 226 (1927) 299; Roache, J. Fluids Eng. 116 (1994) 405.

    >>> import numpy as np
    >>> shape = np.ones((4, 6))
    >>> result = judge_convergence([shape * h**2 for h in (0.1, 0.05, 0.025)], [1e-15] * 3, 1.0)
    >>> result.converges, round(result.order, 3)
    (True, 2.0)
    >>> judge_convergence([shape * (0.02 + h**2) for h in (0.1, 0.05, 0.025)], [1e-15] * 3, 1.0).converges
    False
    """
    errors = tuple(_size(level) for level in levels)
    floor = floors[-1]
    if not np.isfinite(errors[-3:]).all():
        return Convergence(False, None, errors, None, np.inf)
    if all(error <= least for error, least in zip(errors, floors, strict=True)):
        resolved = floor <= LIMITS.max_uncertainty * max(rotation_angle, 1.0)
        return Convergence(resolved, None, errors, errors[-1], floor, True, open=not resolved)
    if len(levels) < 3:
        return Convergence(False, None, errors, None, np.inf)
    coarse, middle, fine = levels[-3:]
    before, after = _size(coarse - middle), _size(middle - fine)
    if after <= floor:
        # rounding exceeds the last difference: the error that remains is the limit itself
        return Convergence(errors[-1] <= floor, None, errors, errors[-1], floor, errors[-1] <= floor)
    order = float(np.log2(before / after)) if before > 0.0 else 0.0
    whole = round(order)
    if not (1 <= whole <= LIMITS.max_order and abs(order - whole) <= LIMITS.order_tolerance):
        falling = all(a >= LIMITS.min_error_ratio * b for a, b in pairwise(errors[-3:]))
        return Convergence(False, order, errors, None, np.inf, open=falling)
    divisor = 2.0**whole - 1.0
    limit, earlier = fine - (middle - fine) / divisor, middle - (coarse - middle) / divisor
    unsure = _size(limit - earlier) + floor
    distance = _size(limit)
    near, resolved = distance <= unsure, unsure <= LIMITS.max_uncertainty * max(rotation_angle, 1.0)
    own = [_size(change[:, 3:]) for change in (coarse - middle, middle - fine)]
    of_momentum = float(np.log2(own[0] / own[1])) if own[1] > floor else None
    return Convergence(near and resolved, order, errors, distance, unsure, False, of_momentum, near and not resolved)


def _size(level: Float64[Array, "time 6"]) -> float:
    with np.errstate(all="ignore"):
        return root_mean_square(level)
