"""Second derivatives of closed forms, by differences of their exact first ones."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode._base.arrays.namespaces import namespace

if TYPE_CHECKING:
    from polhode._base.arrays.elementwise import Elementwise

# Σ w_k f(x + kh) = h f′(x) exactly for polynomials up to degree eight; the error is h⁸ f⁽⁹⁾/630, for a step of 0.003 of
# the scale 1e-23 of f′. What remains is rounding of f over the step, some 1e-13.
PLACES = np.asarray([-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0])
WEIGHTS = np.asarray([1 / 280, -4 / 105, 1 / 5, -4 / 5, 4 / 5, -1 / 5, 4 / 105, -1 / 280])  # of order eight


def differences(function: Elementwise, *arguments: Any) -> tuple[tuple[Any, ...], Any]:
    """Return values, with the Jacobian as the last of them, and the derivatives of all by all arguments.

    The derivatives of the Jacobian are central differences of order eight. Their steps follow from the Jacobian
    itself, so that they fit fast phases and the growth of changes near a saddle: the error is some 1e-11 of the
    largest second derivative.

    Args:
        function: that has an exact Jacobian.
        arguments: of the function, of any library.
    """
    xp = namespace(*arguments)
    jacobian: Any = function.jacobian
    values, columns = jacobian(*arguments)
    batch = function.batch(arguments)
    sizes = [math.prod(core) for core in function.inputs]
    spread = [
        xp.broadcast_to(a if core else a[..., None], (*batch, size))
        for a, core, size in zip(arguments, function.inputs, sizes, strict=True)
    ]
    with np.errstate(all="ignore"):
        steps = _steps(xp, function, spread, values, columns)
    ways = xp.eye(sum(sizes), dtype=xp.float64).reshape(sum(sizes), 1, *(1,) * len(batch), sum(sizes))
    places = xp.asarray(PLACES).reshape(1, -1, *(1,) * (len(batch) + 1))
    points = xp.concat(spread, axis=-1) + places * ways * steps
    starts = [sum(sizes[:k]) for k in range(len(sizes))]
    moved = (points[..., a : a + n] for a, n in zip(starts, sizes, strict=True))
    parts = (x if core else x[..., 0] for x, core in zip(moved, function.inputs, strict=True))
    weights = xp.asarray(WEIGHTS).reshape(1, -1, *(1,) * (len(batch) + 2))
    change = xp.sum(weights * jacobian(*parts)[1], axis=1)
    steps = xp.moveaxis(steps, -1, 0)[..., None, None]
    # Σ_j w_j J(x + j h e_k)/h = ∂J/∂x_k
    second = xp.moveaxis(change / steps, 0, -1).reshape(*batch, -1, sum(sizes))
    return (*values, columns), xp.concat([columns, second], axis=-2)


def _steps(xp: Any, function: Elementwise, spread: list[Any], values: tuple[Any, ...], columns: Any) -> Any:
    """Return the step along each argument (batch…, N)."""
    step = 0.003  # of the distance over which the values change by their own size
    scales = []
    for k, x in enumerate(spread):
        size = xp.max(xp.abs(x), axis=-1, keepdims=True)
        size = xp.abs(x) if k < function.positive else xp.broadcast_to(size, x.shape)
        scales.append(xp.where(size > 0, size, 1.0))
    sizes = []
    for k in function.smooth:
        shape = function.outputs[k][0]
        value = xp.abs(values[k])[..., None] if not shape else xp.abs(values[k])
        largest = xp.max(value, axis=-1, keepdims=True)
        sizes.append(xp.broadcast_to(xp.where(largest > 0, largest, 1.0), value.shape))
    # a value of size S and slope s changes by its own size over the length S/s
    sensitivity = xp.max(xp.abs(columns) / xp.concat(sizes, axis=-1)[..., None], axis=-2)
    own = 1.0 / xp.where(sensitivity > 0, sensitivity, 1e-300)
    return step * xp.minimum(xp.concat(scales, axis=-1), own)
