"""A function with two implementations: one that has forward derivatives, and one that has reverse ones.

Loops of unknown length are differentiated forward step by step, and in reverse only from checkpoints; no single loop of
JAX does both. The derivative is kept as one linear map, which forward mode applies by one implementation and reverse
mode transposes by the other.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.core import ShapedArray
from jax.custom_derivatives import SymbolicZero
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from polhode.errors import InvalidInput
from polhode.types import Array


def by_either_mode(forward: Callable[[Any], Any], reverse: Callable[[Any], Any], operands: Any, name: str) -> Any:
    """Return ``forward(operands)``, with forward derivatives of ``forward`` and reverse ones of ``reverse``.

    Args:
        forward: of the operands, with outputs that are arrays; it must not enclose traced arrays.
        reverse: the same function.
        operands: any nest; what is not an array is constant.
        name: of the public function, for the refusal of second derivatives.
    """
    leaves, tree = jax.tree.flatten(operands)
    places = [k for k, leaf in enumerate(leaves) if eqx.is_array(leaf)]

    def whole(arrays: list[Array]) -> Any:
        filled = list(leaves_known)
        for k, x in zip(places, arrays, strict=True):
            filled[k] = x
        return jax.tree.unflatten(tree, filled)

    leaves_known = [None if eqx.is_array(leaf) else leaf for leaf in leaves]

    @jax.custom_jvp
    def value(*arrays: Array) -> Any:
        return forward(whole(list(arrays)))

    def rule(primals: tuple[Array, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
        moving = [k for k, tangent in enumerate(tangents) if not isinstance(tangent, SymbolicZero)]
        moving = [k for k in moving if jnp.issubdtype(jnp.result_type(primals[k]), jnp.inexact)]
        out = value(*primals)
        outputs, shape = jax.tree.flatten(out)
        smooth = [k for k, x in enumerate(outputs) if jnp.issubdtype(x.dtype, jnp.inexact)]

        def of_moving(function: Callable[[Any], Any], fixed: tuple[Array, ...]) -> Callable[..., list[Array]]:
            def values(*moved: Array) -> list[Array]:
                arrays = list(fixed)
                for k, x in zip(moving, moved, strict=True):
                    arrays[k] = x
                found = jax.tree.leaves(function(whole(arrays)))
                return [found[k] for k in smooth]

            return values

        def along(*both: Array) -> list[Array]:
            at, ways = both[: len(primals)], both[len(primals) :]
            return jax.jvp(of_moving(forward, at), tuple(at[k] for k in moving), tuple(ways))[1]

        def back(*both: Array) -> list[Array]:
            at, weights = both[: len(primals)], both[len(primals) :]
            _, pull = jax.vjp(of_moving(reverse, at), *(at[k] for k in moving))
            return list(pull(list(weights)))

        changes: list[Any] = [SymbolicZero(jax.typeof(x).to_tangent_aval()) for x in outputs]
        if moving:
            ways = [tangents[k] for k in moving]
            found = _linear.bind(*primals, *ways, count=len(primals), along=along, back=back, name=name)
            for k, change in zip(smooth, found, strict=True):
                changes[k] = change
        return out, jax.tree.unflatten(shape, changes)

    value.defjvp(rule, symbolic_zeros=True)
    return value(*(leaves[k] for k in places))


def _jvp(primals: Any, tangents: Any, *, count: int, along: Any, back: Any, name: str) -> Any:
    if any(not isinstance(tangent, ad.Zero) for tangent in tangents[:count]):
        raise InvalidInput(f"`{name}` has first derivatives only; take second ones by differences of the first.")
    moved = [ad.instantiate_zeros(tangent) for tangent in tangents[count:]]
    bind = lambda ways: _linear.bind(*primals[:count], *ways, count=count, along=along, back=back, name=name)  # noqa: E731
    return bind(primals[count:]), bind(moved)


def _transpose(weights: Any, *args: Any, count: int, along: Any, back: Any, name: str) -> list[Any]:
    weights = [ad.instantiate_zeros(weight) for weight in weights]
    found = _linear.bind(*args[:count], *weights, count=count, along=back, back=along, name=name)
    return [None] * count + list(found)


def _batched(args: Any, axes: Any, *, count: int, along: Any, back: Any, name: str) -> Any:
    size = next(x.shape[axis] for x, axis in zip(args, axes, strict=True) if axis is not None)
    moved = [
        jnp.broadcast_to(x, (size, *jnp.shape(x))) if axis is None else jnp.moveaxis(x, axis, 0)
        for x, axis in zip(args, axes, strict=True)
    ]
    found = _linear.bind(*moved, count=count, along=jax.vmap(along), back=jax.vmap(back), name=name)
    return found, [0] * len(found)


def _shapes(*args: Any, along: Any, **known: Any) -> list[ShapedArray]:
    given = [jax.ShapeDtypeStruct(x.shape, x.dtype) for x in args]
    return [ShapedArray(x.shape, x.dtype) for x in jax.eval_shape(along, *given)]


_linear = Primitive("linear_by_either_mode")
_linear.multiple_results = True
_linear.def_impl(lambda *args, along, **known: jax.jit(along)(*args))
_linear.def_abstract_eval(_shapes)
ad.primitive_jvps[_linear] = _jvp
ad.primitive_transposes[_linear] = _transpose
batching.primitive_batchers[_linear] = _batched
mlir.register_lowering(_linear, mlir.lower_fun(lambda *args, along, **known: along(*args), multiple_results=True))
