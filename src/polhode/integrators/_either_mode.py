"""Joins two implementations of a function, one with forward derivatives and one with reverse ones.

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
from jax.custom_derivatives import SymbolicZero

from polhode._base.jax_inner import Primitive, ShapedArray, ad, batching, mlir
from polhode.errors import InvalidInput
from polhode.types import Array

Back = Callable[[Callable[[Any], Any], Any, Any, Any], Any]
"""Of ``whole``, ``moved``, outputs and weights: ``whole(moved)`` are the operands, with those of their arrays that move
replaced; outputs are their results; weights are the cotangents of those outputs that are not whole numbers. It returns
the cotangents of the moving operands."""


def by_either_mode(forward: Callable[[Any], Any], back: Back, operands: Any, name: str, twice: bool = False) -> Any:
    """Return ``forward(operands)``, with forward derivatives of ``forward`` and reverse ones by ``back``.

    Args:
        forward: of the operands, with outputs that are arrays; it must not enclose traced arrays.
        back: the transpose of its derivative.
        operands: any nest, of which all but arrays is constant.
        name: of the public function, for the refusal of second derivatives.
        twice: whether both may be differentiated once more, forward.
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

        def with_moved(fixed: Any) -> Callable[[Any], Any]:
            def replaced(moved: Any) -> Any:
                arrays = list(fixed)
                for k, x in zip(moving, moved, strict=True):
                    arrays[k] = x
                return whole(arrays)

            return replaced

        def along(*both: Array) -> list[Array]:
            at, ways = both[: len(primals)], both[len(primals) + len(outputs) :]
            replaced = with_moved(at)
            moved = [at[k] for k in moving]
            return jax.jvp(lambda *x: _smooth_part(forward(replaced(x))), moved, list(ways))[1]

        def pulled(*both: Array) -> list[Array]:
            at, weights = both[: len(primals)], both[len(primals) + len(outputs) :]
            ended = jax.tree.unflatten(shape, both[len(primals) : len(primals) + len(outputs)])
            return list(back(with_moved(at), [at[k] for k in moving], ended, list(weights)))

        changes: list[Any] = [SymbolicZero(jax.typeof(x).to_tangent_aval()) for x in outputs]
        if moving:
            known, ways = (*primals, *outputs), [tangents[k] for k in moving]
            rules = {"along": along, "back": pulled, "name": name, "twice": twice}
            smooth_changes = _linear.bind(*known, *ways, count=len(known), **rules)
            smooth = [k for k, x in enumerate(outputs) if jnp.issubdtype(x.dtype, jnp.inexact)]
            for k, change in zip(smooth, smooth_changes, strict=True):
                changes[k] = change
        return out, jax.tree.unflatten(shape, changes)

    value.defjvp(rule, symbolic_zeros=True)
    return value(*(leaves[k] for k in places))


def by_transposing(reverse: Callable[[Any], Any]) -> Back:
    """Return the transposed derivative of a function of the operands that JAX transposes itself."""

    def back(whole: Callable[[Any], Any], moved: Any, outputs: Any, weights: Any) -> Any:
        _, pull = jax.vjp(lambda *x: _smooth_part(reverse(whole(x))), *moved)
        return pull(weights)

    return back


def _smooth_part(outputs: Any) -> list[Array]:
    """Return those of a nest of arrays that are not whole numbers."""
    return [x for x in jax.tree.leaves(outputs) if jnp.issubdtype(x.dtype, jnp.inexact)]


def _jvp(primals: Any, tangents: Any, *, count: int, along: Any, name: str, twice: bool, **more: Any) -> Any:
    known, ways = primals[:count], primals[count:]
    changes = [ad.instantiate_zeros(tangent) for tangent in tangents[count:]]
    bind = lambda ways: _linear.bind(*known, *ways, count=count, along=along, name=name, twice=twice, **more)  # noqa: E731
    results, moved = bind(ways), bind(changes)
    moving = [k for k, tangent in enumerate(tangents[:count]) if not isinstance(tangent, ad.Zero)]
    if not moving:
        return results, moved
    if not twice:
        raise InvalidInput(f"`{name}` has first derivatives only; take second ones by differences of the first.")

    def of_known(*values: Array) -> list[Array]:
        at = list(known)
        for k, x in zip(moving, values, strict=True):
            at[k] = x
        return along(*at, *ways)

    _, slopes = jax.jvp(of_known, [known[k] for k in moving], [tangents[k] for k in moving])
    return results, [a + b for a, b in zip(moved, _forward_only(slopes, f"the derivative of {name}"), strict=True)]


def _transpose(weights: Any, *args: Any, count: int, along: Any, back: Any, **more: Any) -> list[Any]:
    weights = [ad.instantiate_zeros(weight) for weight in weights]
    cotangents = _linear.bind(*args[:count], *weights, count=count, along=back, back=along, **more)
    return [None] * count + list(cotangents)


def _batch(args: Any, axes: Any, *, count: int, along: Any, back: Any, **more: Any) -> Any:
    size = next(x.shape[axis] for x, axis in zip(args, axes, strict=True) if axis is not None)

    def each(function: Any) -> Any:
        def batch(*both: Array) -> list[Array]:
            return jax.vmap(function, in_axes=(*axes[:count], *(0 for _ in both[count:])), axis_size=size)(*both)

        return batch

    # operands that all copies share are not copied; directions are, so that the transpose adds up the copies
    ways = [
        jnp.broadcast_to(x, (size, *jnp.shape(x))) if axis is None else jnp.moveaxis(x, axis, 0)
        for x, axis in zip(args[count:], axes[count:], strict=True)
    ]
    results = _linear.bind(*args[:count], *ways, count=count, along=each(along), back=each(back), **more)
    return results, [0] * len(results)


def _shapes(*args: Any, along: Any, **known: Any) -> list[ShapedArray]:
    structs = [jax.ShapeDtypeStruct(x.shape, x.dtype) for x in args]
    return [ShapedArray(x.shape, x.dtype) for x in jax.eval_shape(along, *structs)]


def _forward_only(values: Any, name: str) -> Any:
    """Return a loop's results; reverse-mode derivatives of them are refused, with the name of the result.

    Args:
        values: arrays or nests of them.
        name: of the public function or class.
    """
    return jax.tree.map(lambda value: _identity.bind(value, name=name), values)


def _refuse(cotangent: Any, value: Any, *, name: str) -> Any:
    raise InvalidInput(
        f"`{name}` loops as often as its numbers ask, and has forward derivatives only; got a reverse-mode one "
        "(jax.grad, jax.vjp, jax.jacrev). Take jax.jvp or jax.jacfwd."
    )


_linear = Primitive("linear_by_either_mode")
_linear.multiple_results = True
_linear.def_impl(lambda *args, along, **known: jax.jit(along)(*args))
_linear.def_abstract_eval(_shapes)
ad.primitive_jvps[_linear] = _jvp
ad.primitive_transposes[_linear] = _transpose
batching.primitive_batchers[_linear] = _batch
mlir.register_lowering(_linear, mlir.lower_fun(lambda *args, along, **known: along(*args), multiple_results=True))

_identity = Primitive("forward_only")
_identity.def_impl(lambda value, *, name: value)
_identity.def_abstract_eval(lambda value, *, name: value)
ad.deflinear2(_identity, _refuse)
batching.primitive_batchers[_identity] = lambda values, axes, *, name: (_identity.bind(*values, name=name), axes[0])
mlir.register_lowering(_identity, lambda context, value, *, name: [value])
