"""Forward and reverse derivatives of operations that have cheaper ways than forming their Jacobian.

One operation gives the changes of the values, another the weights of the arguments. Second derivatives go through the
Jacobian.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from polhode._base.arrays.elementwise import Elementwise


def push(
    function: Elementwise, compiled: bool, primals: tuple[Any, ...], which: tuple[int, ...], ways: list[Any]
) -> list[Any]:
    """Return the changes of the smooth values when some of the arguments change.

    Args:
        function: with ``ways``.
        compiled: how closed forms are evaluated.
        primals: all arguments.
        which: indices of the arguments that change.
        ways: their changes, in that order.
    """
    return _primitive().bind(*primals, *ways, function=function, compiled=compiled, which=which)


@cache
def _primitive() -> Any:
    from polhode._base.jax_inner import Primitive, ad, batching, mlir

    primitive = Primitive("polhode_pushed")
    primitive.multiple_results = True
    primitive.def_impl(_push)
    primitive.def_abstract_eval(_abstract)
    ad.primitive_jvps[primitive] = _jvp
    ad.primitive_transposes[primitive] = _transpose
    batching.primitive_batchers[primitive] = _batch
    mlir.register_lowering(primitive, mlir.lower_fun(_push, multiple_results=True))
    return primitive


def _push(*args: Any, function: Elementwise, compiled: bool, which: tuple[int, ...]) -> list[Any]:
    import jax.numpy as jnp

    primals, moving = args[: len(function.inputs)], dict(zip(which, args[len(function.inputs) :], strict=True))
    changes = [moving[k] if k in moving else jnp.zeros_like(x) for k, x in enumerate(primals)]
    return split_values(function, _make_ahead(function, compiled)(*primals, *changes))


def _abstract(*args: Any, function: Elementwise, **_: Any) -> list[Any]:
    from polhode._base.jax_inner import ShapedArray

    shapes = function.shapes(args[: len(function.inputs)])
    return [ShapedArray(*shapes[k]) for k in function.smooth]


def _jvp(primals: Any, tangents: Any, **known: Any) -> tuple[Any, Any]:
    import jax

    from polhode._base.jax_inner import ad

    return jax.jvp(partial(_push, **known), tuple(primals), tuple(ad.instantiate_zeros(x) for x in tangents))


def _batch(args: Any, axes: Any, **known: Any) -> tuple[Any, list[int]]:
    import jax

    changes = jax.vmap(partial(_push, **known), in_axes=tuple(axes))(*args)
    return changes, [0] * len(changes)


def _transpose(weights: Any, *args: Any, function: Elementwise, compiled: bool, which: tuple[int, ...]) -> list[Any]:
    import jax.numpy as jnp

    from polhode._base.jax_inner import ad

    primals, ways = args[: len(function.inputs)], args[len(function.inputs) :]
    # w·(J dx) = (Jᵀw)·dx: the transpose of the forward derivative is the reverse one
    batch = function.batch(primals)
    flat = [jnp.reshape(ad.instantiate_zeros(x), (*batch, -1)) for x in weights]
    cotangents = _make_back(function, compiled)(*primals, jnp.concatenate(flat, axis=-1))
    summed = [_sum_shared(cotangents[k], way.aval.shape) if ad.is_undefined_primal(way) else None
             for k, way in zip(which, ways, strict=True)]
    return [None] * len(primals) + summed


def _sum_shared(weights: Any, shape: tuple[int, ...]) -> Any:
    """Return weights of an argument that all copies share, from those of each copy."""
    import jax.numpy as jnp

    lead = weights.ndim - len(shape)
    shared = (*range(lead), *(lead + k for k, n in enumerate(shape) if n == 1 and weights.shape[lead + k] != 1))
    return jnp.reshape(jnp.sum(weights, axis=shared), shape) if shared else weights


def split_values(function: Elementwise, change: Any) -> list[Any]:
    """Return changes (batch…, M) of all smooth values as those of each."""
    import jax.numpy as jnp

    parts, row = [], 0
    for k in function.smooth:
        shape = function.outputs[k][0]
        parts.append(jnp.reshape(change[..., row : row + math.prod(shape)], (*change.shape[:-1], *shape)))
        row += math.prod(shape)
    return parts


def _count_values(function: Elementwise) -> int:
    return sum(math.prod(function.outputs[k][0]) for k in function.smooth)


@cache
def _make_ahead(function: Elementwise, compiled: bool) -> Any:
    """Return the function of arguments and a change of each that gives the change (batch…, M) of all smooth values."""
    import jax.numpy as jnp

    assert function.ways is not None
    inputs, outputs = (*function.inputs, *function.inputs), (((_count_values(function),), float),)

    def by_columns(*arguments: Any) -> Any:
        primals, changes = arguments[: len(function.inputs)], arguments[len(function.inputs) :]
        # the change J dx, by rows of J
        columns = function.differential.bind(compiled, primals)[-1]
        flat = [x if core else x[..., None] for x, core in zip(changes, function.inputs, strict=True)]
        batch = jnp.broadcast_shapes(*(x.shape[:-1] for x in flat))
        change = jnp.concatenate([jnp.broadcast_to(x, (*batch, x.shape[-1])) for x in flat], axis=-1)
        return jnp.sum(columns * change[..., None, :], axis=-1)

    return _make_differentiable(function, function.ways.ahead, inputs, outputs, compiled, by_columns, lambda x: x[0])


@cache
def _make_back(function: Elementwise, compiled: bool) -> Any:
    """Return the function of arguments and weights (batch…, M) that gives the weights of the arguments."""
    import jax.numpy as jnp

    assert function.ways is not None
    inputs = (*function.inputs, (_count_values(function),))
    outputs = tuple((shape, float) for shape in function.inputs)

    def by_columns(*arguments: Any) -> tuple[Any, ...]:
        *primals, weights = arguments
        # the weights Jᵀw, by columns of J
        columns = function.differential.bind(compiled, primals)[-1]
        rows, parts, start = jnp.sum(columns * weights[..., None], axis=-2), [], 0
        for shape in function.inputs:
            size = math.prod(shape)
            parts.append(jnp.reshape(rows[..., start : start + size], (*rows.shape[:-1], *shape)))
            start += size
        return tuple(parts)

    return _make_differentiable(function, function.ways.back, inputs, outputs, compiled, by_columns, tuple)


def _make_differentiable(
    function: Elementwise, values: Any, inputs: Any, outputs: Any, compiled: bool, by_columns: Any, formed: Any
) -> Any:
    """Wrap computed values so that their derivative comes from the given Jacobian."""
    import jax

    operation = replace(function, values=values, inputs=inputs, outputs=outputs, jacobian=None, ways=None)

    @jax.custom_jvp
    def bind_operation(*arguments: Any) -> Any:
        return formed(operation.bind(compiled, arguments))

    @bind_operation.defjvp
    def rule(primals: Any, tangents: Any) -> tuple[Any, Any]:
        return bind_operation(*primals), jax.jvp(by_columns, primals, tangents)[1]

    return bind_operation
