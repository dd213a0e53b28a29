"""``Elementwise`` functions of JAX arrays: called back on the host or compiled, batched, and differentiated.

This file needs JAX: it is imported when the first of its arrays comes in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays.differences import differences
from polhode._base.arrays.operation import Operation, Point, along
from polhode._base.arrays.underflow import gradual_underflow, remember_environment
from polhode._base.jax_inner import Primitive, ShapedArray, batching, mlir
from polhode.types import Array

if TYPE_CHECKING:
    from polhode._base.arrays.elementwise import Elementwise

KEPT = 64  # functions of which operations are kept: each may hold the arrays of a motion


@lru_cache(maxsize=KEPT)
def operation(function: Elementwise, compiled: bool) -> Operation:
    """Return the function as an operation of JAX, with the derivatives that it has.

    Args:
        function: of arrays.
        compiled: whether closed forms are compiled instead of called on the host.
    """
    evaluate = partial(_call.bind, function=function, compiled=compiled)
    if function.jacobian is None:
        return Operation(function.name, evaluate, order=function.order)
    if function.forward is None:
        columns = operation(_differential(function), compiled)

        def keep(*arguments: Array) -> tuple[list[Array], Array]:
            *values, jacobian = columns(*arguments)
            return values, jacobian

        def forward(at: Point, jacobian: Array, changes: list[Array]) -> list[Array]:
            return _changes(function, at.which)(jacobian, *changes)

        return Operation(function.name, evaluate, forward, keep=keep, order=function.order)
    return _by_its_ways(function, evaluate, compiled)


@lru_cache(maxsize=KEPT)
def _differential(function: Elementwise) -> Elementwise:
    """Return the function whose values are those of another and, last, the columns of its Jacobian."""
    jacobian = function.jacobian
    assert jacobian is not None, "only functions with a Jacobian are differentiated"

    def both(*arguments: Any) -> tuple[Any, ...]:
        values, columns = jacobian(*arguments)
        return (*values, columns)

    columns = (function.height, function.width), float
    again = partial(differences, function) if function.order == 1 else None
    return replace(function, values=both, outputs=(*function.outputs, columns), jacobian=again,
                   order=function.order + 1, forward=None, back=None)  # fmt: skip


@lru_cache(maxsize=KEPT)
def _changes(function: Elementwise, which: tuple[int, ...]) -> Any:
    def apply(columns: Array, *ways: Array) -> list[Array]:
        change: Any = 0.0
        for k, dx in zip(which, ways, strict=True):
            # dv = Σ_k J_k dx_k, J_k the columns of the k-th argument
            start, core = sum(math.prod(shape) for shape in function.inputs[:k]), function.inputs[k]
            dx = dx if core else dx[..., None]
            change = change + jnp.sum(columns[..., start : start + math.prod(core)] * dx[..., None, :], axis=-1)
        return _split(change, [function.outputs[k][0] for k in function.smooth])

    return jax.jit(apply)


def _split(x: Array, shapes: Sequence[tuple[int, ...]]) -> list[Array]:
    """Return the parts of these shapes that lie one after the other along the last axis."""
    parts, start = [], 0
    for shape in shapes:
        size = math.prod(shape)
        parts.append(jnp.reshape(x[..., start : start + size], (*x.shape[:-1], *shape)))
        start += size
    return parts


# ---------------------------------------------------------------------- derivatives without the Jacobian


def _by_its_ways(function: Elementwise, evaluate: Any, compiled: bool) -> Operation:
    """Return the operation of a function with ``forward`` and ``back``; second derivatives go through the Jacobian."""
    values = [function.outputs[k][0] for k in function.smooth]
    jacobian = operation(_differential(function), compiled)

    def ahead_by_columns(*arguments: Array) -> Array:
        primals, changes = arguments[: len(function.inputs)], arguments[len(function.inputs) :]
        # the change J dx, by rows of J
        columns = jacobian(*primals)[-1]
        flat = [x if core else x[..., None] for x, core in zip(changes, function.inputs, strict=True)]
        batch = jnp.broadcast_shapes(*(x.shape[:-1] for x in flat))
        change = jnp.concatenate([jnp.broadcast_to(x, (*batch, x.shape[-1])) for x in flat], axis=-1)
        return jnp.sum(columns * change[..., None, :], axis=-1)

    def back_by_columns(*arguments: Array) -> list[Array]:
        *primals, weights = arguments
        # the weights Jᵀw, by columns of J
        return _split(jnp.sum(jacobian(*primals)[-1] * weights[..., None], axis=-2), function.inputs)

    def by_columns(values: Any, inputs: Any, outputs: Any, columns: Any) -> Operation:
        called = replace(function, values=values, inputs=inputs, outputs=tuple((shape, float) for shape in outputs))
        return Operation(function.name, partial(_call.bind, function=called, compiled=compiled), along(columns))

    ahead = by_columns(function.forward, function.inputs * 2, [(function.height,)], ahead_by_columns)
    weigh = by_columns(function.back, (*function.inputs, (function.height,)), function.inputs, back_by_columns)

    def forward(at: Point, results: Any, changes: list[Array]) -> list[Array]:
        return _split(ahead(*at.arrays, *at.spread(changes))[0], values)

    def back(at: Point, results: Any, weights: list[Array]) -> list[Array]:
        batch = function.batch(tuple(at.arrays))
        cotangents = weigh(*at.arrays, jnp.concatenate([jnp.reshape(w, (*batch, -1)) for w in weights], axis=-1))
        return [_sum_shared(cotangents[k], at.arrays[k].shape) for k in at.which]

    return Operation(function.name, evaluate, forward, back, second="any", at_once=True)


def _sum_shared(weights: Array, shape: tuple[int, ...]) -> Array:
    """Return weights of an argument that copies share, from those of each copy."""
    lead = weights.ndim - len(shape)
    shared = (*range(lead), *(lead + k for k, n in enumerate(shape) if n == 1 and weights.shape[lead + k] != 1))
    return jnp.reshape(jnp.sum(weights, axis=shared), shape) if shared else weights


# ---------------------------------------------------------------------- the call, a primitive without derivatives


def _abstract(*args: Any, function: Elementwise, compiled: bool) -> list[Any]:
    return [ShapedArray(*shape) for shape in function.shapes(args)]


def _on_host(function: Elementwise, *arguments: Any) -> tuple[np.ndarray, ...]:
    arrays = tuple(np.asarray(a) for a in arguments)
    values = function.values(*arrays)
    return tuple(
        np.array(np.broadcast_to(np.asarray(value, kind), shape), order="C", copy=None)
        for value, (shape, kind) in zip(values, function.shapes(arrays), strict=True)
    )


def _at_once(*args: Any, function: Elementwise, compiled: bool) -> list[Any]:
    elsewhere = compiled or any(device.platform != "cpu" for x in args for device in x.devices())
    if elsewhere and not function.on_host:
        return jax.jit(partial(_call.bind, function=function, compiled=compiled))(*args)
    return [jnp.asarray(x) for x in _on_host(function, *args)]


def _lower(is_cpu: bool, ctx: Any, *operands: Any, function: Elementwise, compiled: bool) -> Any:
    if not function.on_host and (compiled or not is_cpu):
        return _in_line(ctx, *operands, function=function, compiled=compiled)
    # jax.pure_callback would put the operands on a device first, for which the pool may have no thread left
    words = [ShapedArray((*x.shape, 2), np.uint32) for x in ctx.avals_out]
    outputs, _, _ = mlir.emit_python_callback(
        ctx.replace(avals_out=words), partial(_words_on_host, function), None, list(operands), ctx.avals_in, words,
        has_side_effect=False, returns_token=False,
    )  # fmt: skip
    joined = mlir.lower_fun(
        lambda *parts: [
            jax.lax.bitcast_convert_type(x, aval.dtype) for x, aval in zip(parts, ctx.avals_out, strict=True)
        ],
        multiple_results=True,
    )
    return joined(ctx.replace(avals_in=words), *outputs)


def _words_on_host(function: Elementwise, *arguments: Any) -> tuple[np.ndarray, ...]:
    """Return the values as pairs of 32-bit words: JAX takes 64 bits from a callback only where its thread allows them,
    which one of its own threads does not within a function that ``jax.enable_x64`` governs."""
    with gradual_underflow():
        values = _on_host(function, *arguments)
    return tuple(np.ascontiguousarray(x[..., None]).view(np.uint32) for x in values)


def _batch(args: Any, axes: Any, *, function: Elementwise, compiled: bool) -> tuple[Any, list[int]]:
    triples = list(zip(args, axes, function.inputs, strict=True))
    rank = max(x.ndim - len(core) - (axis is not None) for x, axis, core in triples)

    def move_axis(x: Any, axis: Any, core: tuple[int, ...]) -> Any:
        """Return x with the new axis before all batch axes, those of the others between."""
        if axis is None:
            return x
        x = jnp.moveaxis(x, axis, 0)
        missing = rank - (x.ndim - 1 - len(core))
        return x.reshape(x.shape[0], *(1,) * missing, *x.shape[1:])

    values = _call.bind(*(move_axis(*each) for each in triples), function=function, compiled=compiled)
    return values, [0] * len(values)


remember_environment()  # before a thread of XLA's can ask for it
_call = Primitive("polhode_elementwise")
_call.multiple_results = True
_call.def_impl(_at_once)
_call.def_abstract_eval(_abstract)
batching.primitive_batchers[_call] = _batch
_in_line = mlir.lower_fun(lambda *args, function, compiled: function.values(*args), multiple_results=True)
mlir.register_lowering(_call, partial(_lower, False))
mlir.register_lowering(_call, partial(_lower, True), platform="cpu")
