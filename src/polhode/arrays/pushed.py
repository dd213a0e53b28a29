"""Derivatives of operations that have a way back of their own, cheaper than their Jacobian.

Forward mode multiplies by the Jacobian. Reverse mode is an operation too, which takes the weights of the values back to
the arguments.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from polhode.arrays.elementwise import Elementwise


def pushed(
    function: Elementwise, compiled: bool, primals: tuple[Any, ...], which: tuple[int, ...], ways: list[Any]
) -> list[Any]:
    """Return the changes of the smooth values when some of the arguments change.

    Args:
        function: with ``pullback``.
        compiled: how closed forms are evaluated.
        primals: all arguments.
        which: of them change.
        ways: how each of these changes.
    """
    return _primitive().bind(*primals, *ways, function=function, compiled=compiled, which=which)


@cache
def _primitive() -> Any:
    from jax.extend.core import Primitive
    from jax.interpreters import ad, batching, mlir

    made = Primitive("polhode_pushed")
    made.multiple_results = True
    made.def_impl(_by_jacobian)
    made.def_abstract_eval(_abstract)
    ad.primitive_jvps[made] = _jvp
    ad.primitive_transposes[made] = _transpose
    batching.primitive_batchers[made] = _batched
    mlir.register_lowering(made, mlir.lower_fun(_by_jacobian, multiple_results=True))
    return made


def _by_jacobian(*args: Any, function: Elementwise, compiled: bool, which: tuple[int, ...]) -> list[Any]:
    primals, ways = args[: len(function.inputs)], args[len(function.inputs) :]
    columns = function.differential.bind(compiled, primals)[-1]
    return function.changes(which)(columns, *ways)


def _abstract(*args: Any, function: Elementwise, **_: Any) -> list[Any]:
    from jax.core import ShapedArray

    shapes = function.shapes(args[: len(function.inputs)])
    return [ShapedArray(*shapes[k]) for k in function.smooth]


def _jvp(primals: Any, tangents: Any, **known: Any) -> tuple[Any, Any]:
    import jax
    from jax.interpreters import ad

    return jax.jvp(partial(_by_jacobian, **known), primals, [ad.instantiate_zeros(x) for x in tangents])


def _batched(args: Any, axes: Any, **known: Any) -> tuple[Any, list[int]]:
    import jax

    found = jax.vmap(partial(_by_jacobian, **known), in_axes=tuple(axes))(*args)
    return found, [0] * len(found)


def _transpose(weights: Any, *args: Any, function: Elementwise, compiled: bool, which: tuple[int, ...]) -> list[Any]:
    import jax.numpy as jnp
    from jax.interpreters import ad

    primals, ways = args[: len(function.inputs)], args[len(function.inputs) :]
    batch = function.batch(primals)
    flat = [jnp.reshape(ad.instantiate_zeros(x), (*batch, -1)) for x in weights]
    found = _pulled(function, compiled)(*primals, jnp.concatenate(flat, axis=-1))
    given = [_summed(found[k], way.aval.shape) if ad.is_undefined_primal(way) else None
             for k, way in zip(which, ways, strict=True)]  # fmt: skip
    return [None] * len(primals) + given


def _summed(found: Any, shape: tuple[int, ...]) -> Any:
    """Return weights of an argument that all copies share, from those of each copy."""
    import jax.numpy as jnp

    lead = found.ndim - len(shape)
    shared = (*range(lead), *(lead + k for k, n in enumerate(shape) if n == 1 and found.shape[lead + k] != 1))
    return jnp.reshape(jnp.sum(found, axis=shared), shape) if shared else found


@cache
def _pulled(function: Elementwise, compiled: bool) -> Any:
    """Return the function of arguments and weights that gives the weights of the arguments.

    Its own derivative goes by that of the Jacobian.
    """
    import jax
    import jax.numpy as jnp

    assert function.pullback is not None
    count = sum(math.prod(function.outputs[k][0]) for k in function.smooth)
    outputs = tuple((shape, float) for shape in function.inputs)
    operation = replace(function, values=function.pullback, inputs=(*function.inputs, (count,)), outputs=outputs,
                        jacobian=None, pullback=None)  # fmt: skip

    @jax.custom_jvp
    def pull(*given: Any) -> tuple[Any, ...]:
        return tuple(operation.bind(compiled, given))

    def by_columns(*given: Any) -> tuple[Any, ...]:
        *primals, weights = given
        columns = function.differential.bind(compiled, primals)[-1]
        rows, found, start = jnp.sum(columns * weights[..., None], axis=-2), [], 0
        for shape in function.inputs:
            size = math.prod(shape)
            found.append(jnp.reshape(rows[..., start : start + size], (*rows.shape[:-1], *shape)))
            start += size
        return tuple(found)

    @pull.defjvp
    def rule(primals: Any, tangents: Any) -> tuple[Any, Any]:
        return pull(*primals), jax.jvp(by_columns, primals, tangents)[1]

    return pull
