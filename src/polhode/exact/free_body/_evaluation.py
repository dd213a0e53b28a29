"""Runs the free body's closed form over batches: NumPy in blocks, JAX as one operation with its derivative.

What only JAX needs, and bodies that the kernels leave, is imported there: most motions are NumPy's and are not derived.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode._base.arrays import Elementwise, is_jax, namespace, stack_last
from polhode.exact._blocks import Constants, Vectors, columns_in_blocks, in_blocks, units
from polhode.exact._closed_form import ClosedForm
from polhode.exact.free_body import _formulas_numbers as formulas_numbers
from polhode.exact.free_body import _formulas_rates as formulas_rates
from polhode.exact.free_body import _formulas_reduction as formulas_reduction
from polhode.exact.free_body import _geometry as geometry
from polhode.exact.free_body import _kernel_setup as kernel_setup
from polhode.exact.free_body._formulas_reduction import Three
from polhode.types import Array, Float64

IDENTITY = np.asarray([1.0, 0.0, 0.0, 0.0])


def motion_columns(arguments: Vectors) -> Constants:
    """Return the constants of motion of moments (…, 3), momentum (…, 3), attitude (…, 4) as columns.

    JAX needs none: there set-up and evaluation are one operation.
    """
    return () if is_jax(*arguments) else FORM.columns(arguments)


def _columns_of_bodies(moments: Array, momentum: Array, attitude: Array) -> tuple[Array, ...]:
    from polhode.exact.free_body._preparation import prepare

    return prepare(moments, momentum, attitude).motion


FORM = ClosedForm("polhode.exact.free_body", _columns_of_bodies)


def characteristics(
    moments: Float64[Array, "*#batch 3"], momentum: Float64[Array, "*#batch 3"]
) -> geometry.Characteristics:
    """Return the numbers of the motion for arrays (…, 3)."""
    if type(moments) is type(momentum) is np.ndarray and moments.ndim == momentum.ndim == 1:
        one = _numbers_of_one(tuple(moments.tolist()), tuple(momentum.tolist()))
        if one is not None:
            return one
    return geometry.Characteristics(*_NUMBERS(moments, momentum))


def _numbers_of_one(moments: Three, momentum: Three) -> geometry.Characteristics | None:
    """Return the numbers of one body by the formulas on single numbers, a tenth of the time that arrays take.

    None for bodies that the kernels leave to arrays, where numbers go beyond doubles.
    """
    if not kernel_setup.is_within(moments, momentum):
        return None
    try:
        body = formulas_reduction.reduction(moments, momentum)
        if not kernel_setup.has_period(body):
            return None
        numbers = formulas_numbers.numbers(body, formulas_rates.frequencies(body))
    except (ArithmeticError, ValueError):
        return None
    # NumPy's numbers, which go beyond doubles without an error, as those of arrays do
    codes, others = (np.asarray(int(code)) for code in numbers[:2]), (np.float64(x) for x in numbers[2:])
    return geometry.Characteristics(*codes, *others)  # type: ignore[arg-type]


def state(
    motion: Any, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
    """Return attitude (…, 4) and momentum (…, 3) at the elapsed times, which broadcast against the motion's batch."""
    if is_jax(elapsed, *motion._arguments):
        return _STATE(*motion._arguments, elapsed, rest)  # type: ignore[return-value]
    return FORM.states_of(motion, elapsed, rest)


def _state(moments: Array, momentum: Array, attitude: Array, elapsed: Array, rest: Array) -> tuple[Array, Array]:
    arguments = moments, momentum, attitude
    if not is_jax(elapsed, *arguments):
        return FORM.states(FORM.columns(arguments), elapsed, rest)
    from polhode.exact.free_body._preparation import STATES

    columns = columns_in_blocks(_columns_of_bodies, arguments)
    parts = STATES.evaluate(columns, elapsed, rest)
    return stack_last(parts[:4]), stack_last(parts[4:])


def _state_jacobian(*arguments: Array) -> tuple[tuple[Array, Array], Array]:
    """The columns are of moments, momentum, attitude, elapsed time, and its rest, which changes nothing more."""
    from polhode.exact.free_body._derivative import state_tangent

    value = _state(*arguments)

    def columns(moments: Array, momentum: Array, attitude: Array, time: Array, q: Array, L: Array) -> Array:
        xp = namespace(time)
        d_moments, d_momentum, d_attitude, d_time = units(xp, time.shape, (3, 3, 4, 1))
        changes = d_moments, d_momentum, d_attitude, d_time[..., 0]
        tangents = state_tangent((moments, momentum, attitude, time), (q, L), changes)
        tangents = xp.moveaxis(xp.concat(tangents, axis=-1), 0, -1)
        return xp.concat([tangents, xp.zeros_like(tangents[..., :1])], axis=-1)

    return value, in_blocks(columns, (*arguments[:4], *value), (1, 1, 1, 0, 1, 1))


def _numbers(moments: Array, momentum: Array) -> geometry.Characteristics:
    xp = namespace(moments, momentum)
    with np.errstate(all="ignore"):
        return geometry.characteristics(*xp.broadcast_arrays(moments, momentum))


def _numbers_jacobian(moments: Array, momentum: Array) -> tuple[geometry.Characteristics, Array]:
    from polhode.exact.free_body._geometry_tangent import changed_numbers
    from polhode.exact.free_body._preparation import prepare

    value = _numbers(moments, momentum)

    def columns(moments: Array, momentum: Array, *numbers: Array) -> Array:
        xp = namespace(moments)
        prepared = prepare(moments, momentum, xp.zeros((*moments.shape[:-1], 4)) + xp.asarray(IDENTITY))
        changes = units(xp, moments.shape[:-1], (3, 3))
        tangents = changed_numbers(prepared, geometry.Characteristics(*numbers), *changes)
        return xp.moveaxis(xp.stack(tangents, axis=-1), 0, -1)

    return value, in_blocks(columns, (moments, momentum, *value), (1, 1, *(0 for _ in value)))


_ONE = ((), float)
_STATE = Elementwise("FreeMotion", _state, ((3,), (3,), (4,), (), ()), (((4,), float), ((3,), float)), _state_jacobian)
_NUMBERS = Elementwise("FreeMotion", _numbers, ((3,), (3,)), (((), int), ((), int), *(_ONE,) * 5), _numbers_jacobian)
