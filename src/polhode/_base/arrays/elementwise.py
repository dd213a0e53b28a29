"""Closed forms as single operations of JAX.

XLA needs about a millisecond for each operation that it compiles, and a closed form has thousands. As one operation
it is evaluated on the CPU by NumPy, at once and without compilation, within compiled functions by a call back to
Python; on other devices it is compiled. Its derivative is a second operation that gives the Jacobian, so that forward
and reverse mode are products with it.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator, Sequence
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays.namespaces import is_jax
from polhode._base.arrays.underflow import gradual_underflow, remember_environment
from polhode.errors import InvalidInput, shown

WAYS = ("host", "compiled")
_where: ContextVar[str] = ContextVar("where", default="host")


@contextlib.contextmanager
def closed_forms(where: str) -> Iterator[None]:
    """Choose how JAX evaluates closed forms on the CPU, in functions that are traced within this context.

    ``"host"``, the default: by NumPy, called back from compiled functions. It compiles in a tenth of a second, and is
    as fast as NumPy is. ``"compiled"``: by XLA, which takes seconds to compile, and is faster only where one function
    is called very often with few bodies; such a function can be exported too. GPUs and TPUs always compile.

    A function that has been traced keeps its choice.

    Args:
        where: "host" or "compiled".

    Raises:
        InvalidInput: for any other word.

    >>> import jax, polhode as ph
    >>> with ph.closed_forms("compiled"):
    ...     momentum_at = jax.jit(ph.FreeMotion((1.0, 2.0, 3.0), momentum=jax.numpy.ones(3)).momentum).lower(5.0)
    """
    if where not in WAYS:
        raise InvalidInput(f"`where` must be one of {', '.join(map(repr, WAYS))}; got {shown(where)}.")
    before = _where.set(where)
    try:
        yield
    finally:
        _where.reset(before)


class Ways(NamedTuple):
    """Derivatives of a function without its Jacobian.

    Attributes:
        ahead: forward, J dx: arguments, and a change of each → the change (batch…, M) of all float values, one after
            the other.
        back: reverse, Jᵀw: arguments, and weights w (batch…, M) of these values → the weights of each argument.
    """

    ahead: Callable[..., tuple[Any, ...]]
    back: Callable[..., tuple[Any, ...]]


@dataclass(frozen=True)
class Elementwise:
    """A function of arrays whose leading axes are batch axes, which broadcast.

    Attributes:
        name: of the public class, for messages.
        values: arrays of any library → tuple of arrays.
        inputs: trailing shape of each argument, () or (k,); the other axes are of the batch.
        outputs: trailing shape and type of each value; only those that are float have derivatives.
        jacobian: arrays → ``(values, columns)``, where ``columns`` (batch…, M, N) has the derivatives of all float
            values, one after the other, by all arguments, one after the other; None where there is none.
        positive: how many of the first arguments consist of positive numbers, each with a scale of its own.
        order: of the derivatives that the Jacobian gives.
        ways: forward and reverse derivatives that take less time than the Jacobian; None where none do.
        on_host: whether the values are NumPy's alone: JAX calls them on the host, whichever way is chosen for closed
            forms, and wherever its own arrays are.
    """

    name: str
    values: Callable[..., tuple[Any, ...]]
    inputs: tuple[tuple[int, ...], ...]
    outputs: tuple[tuple[tuple[int, ...], type], ...]
    jacobian: Callable[..., tuple[tuple[Any, ...], Any]] | None = None
    positive: int = 1
    order: int = 1
    ways: Ways | None = None
    on_host: bool = False

    def __call__(self, *arguments: Any) -> tuple[Any, ...]:
        """Return the values, NumPy arrays for NumPy arrays and JAX arrays for JAX arrays."""
        if not is_jax(*arguments):
            return self.values(*arguments)
        import jax.numpy as jnp

        arrays = (jnp.asarray(a, float) for a in arguments)
        return tuple(_primitive().bind(*arrays, function=self, compiled=_where.get() == "compiled"))

    def bind(self, compiled: bool, arguments: Sequence[Any]) -> Any:
        """Return the values of JAX arrays, which may be traced."""
        return _primitive().bind(*arguments, function=self, compiled=compiled)

    @property
    def smooth(self) -> tuple[int, ...]:
        """Which values have derivatives."""
        return tuple(k for k, (_, kind) in enumerate(self.outputs) if kind is float)

    @property
    def differential(self) -> Elementwise:
        """The function whose values are these and, last, the columns of the Jacobian."""
        return _differential(self)

    @property
    def width(self) -> int:
        """The number of scalars in the arguments of one element of the batch."""
        return sum(math.prod(shape) for shape in self.inputs)

    def shapes(self, arguments: tuple[Any, ...]) -> list[tuple[tuple[int, ...], Any]]:
        """Return shape and type of each value."""
        batch = self.batch(arguments)
        return [((*batch, *shape), np.dtype(kind)) for shape, kind in self.outputs]

    def batch(self, arguments: tuple[Any, ...]) -> tuple[int, ...]:
        """Return the common batch shape of arguments."""
        shapes = (a.shape[: a.ndim - len(core)] for a, core in zip(arguments, self.inputs, strict=True))
        return np.broadcast_shapes(*shapes)


@cache
def _differential(function: Elementwise) -> Elementwise:
    jacobian = function.jacobian
    assert jacobian is not None, "only functions with a Jacobian are differentiated"

    def both(*arguments: Any) -> tuple[Any, ...]:
        values, columns = jacobian(*arguments)
        return (*values, columns)

    columns = (sum(math.prod(function.outputs[k][0]) for k in function.smooth), function.width), float
    from polhode._base.arrays.differences import differences

    again = partial(differences, function) if function.order == 1 else None
    return Elementwise(function.name, both, function.inputs, (*function.outputs, columns), again, function.positive,
                       function.order + 1, on_host=function.on_host)


@cache
def _primitive() -> Any:
    """Return the operation, made when a JAX array first comes in."""
    from polhode._base.jax_inner import Primitive, ad, batching, mlir

    remember_environment()
    primitive = Primitive("polhode_elementwise")
    primitive.multiple_results = True
    primitive.def_impl(_at_once)
    primitive.def_abstract_eval(_abstract)
    ad.primitive_jvps[primitive] = _jvp
    batching.primitive_batchers[primitive] = _batch
    in_line = mlir.lower_fun(lambda *args, function, compiled: function.values(*args), multiple_results=True)
    mlir.register_lowering(primitive, partial(_lower, in_line, False))
    mlir.register_lowering(primitive, partial(_lower, in_line, True), platform="cpu")
    return primitive


def _abstract(*args: Any, function: Elementwise, compiled: bool) -> list[Any]:
    from polhode._base.jax_inner import ShapedArray

    return [ShapedArray(*shape) for shape in function.shapes(args)]


def _on_host(function: Elementwise, *arguments: Any) -> tuple[np.ndarray, ...]:
    arrays = tuple(np.asarray(a) for a in arguments)
    values = function.values(*arrays)
    return tuple(
        np.array(np.broadcast_to(np.asarray(value, kind), shape), order="C", copy=None)
        for value, (shape, kind) in zip(values, function.shapes(arrays), strict=True)
    )


def _at_once(*args: Any, function: Elementwise, compiled: bool) -> list[Any]:
    import jax
    import jax.numpy as jnp

    elsewhere = compiled or any(device.platform != "cpu" for x in args for device in x.devices())
    if elsewhere and not function.on_host:
        return jax.jit(partial(_primitive().bind, function=function, compiled=compiled))(*args)
    return [jnp.asarray(x) for x in _on_host(function, *args)]


def _lower(in_line: Any, is_cpu: bool, ctx: Any, *operands: Any, function: Elementwise, compiled: bool) -> Any:
    import jax

    from polhode._base.jax_inner import ShapedArray, mlir

    if not function.on_host and (compiled or not is_cpu):
        return in_line(ctx, *operands, function=function, compiled=compiled)
    # jax.pure_callback would put the operands on a device first, for which the pool may have no thread left
    words = [ShapedArray((*x.shape, 2), np.uint32) for x in ctx.avals_out]
    outputs, _, _ = mlir.emit_python_callback(
        ctx.replace(avals_out=words), partial(_words_on_host, function), None, list(operands), ctx.avals_in, words,
        has_side_effect=False, returns_token=False,
    )
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
    import jax.numpy as jnp

    triples = list(zip(args, axes, function.inputs, strict=True))
    rank = max(x.ndim - len(core) - (axis is not None) for x, axis, core in triples)

    def move_axis(x: Any, axis: Any, core: tuple[int, ...]) -> Any:
        """Return x with the new axis before all batch axes, those of the others between."""
        if axis is None:
            return x
        x = jnp.moveaxis(x, axis, 0)
        missing = rank - (x.ndim - 1 - len(core))
        return x.reshape(x.shape[0], *(1,) * missing, *x.shape[1:])

    moved_args = (move_axis(*each) for each in triples)
    values = _primitive().bind(*moved_args, function=function, compiled=compiled)
    return values, [0] * len(values)


def _jvp(primals: Any, tangents: Any, *, function: Elementwise, compiled: bool) -> tuple[Any, Any]:
    from polhode._base.jax_inner import ad

    bind = partial(_primitive().bind, compiled=compiled)
    if function.jacobian is None:
        raise InvalidInput(
            f"`{function.name}` has first and second derivatives only; take third ones by differences of the second."
        )
    which = tuple(k for k, dx in enumerate(tangents) if not isinstance(dx, ad.Zero))
    ways = [tangents[k] for k in which]
    if function.ways is None:
        *values, columns = bind(*primals, function=function.differential)
        smooth_changes = _changes(function, which)(columns, *ways)
    else:
        from polhode._base.arrays.pushed import push

        values = bind(*primals, function=function)
        smooth_changes = push(function, compiled, primals, which, ways)
    changes: list[Any] = [ad.Zero(_tangent_type(v)) for v in values]
    for k, change in zip(function.smooth, smooth_changes, strict=True):
        changes[k] = change
    return values, changes


@cache
def _changes(function: Elementwise, which: tuple[int, ...]) -> Any:
    import jax
    import jax.numpy as jnp

    from polhode._base.arrays.pushed import split_values

    def apply(columns: Any, *ways: Any) -> list[Any]:
        change: Any = 0.0
        for k, dx in zip(which, ways, strict=True):
            # dv = Σ_k J_k dx_k, J_k the columns of the k-th argument
            start, core = sum(math.prod(shape) for shape in function.inputs[:k]), function.inputs[k]
            dx = dx if core else dx[..., None]
            change = change + jnp.sum(columns[..., start : start + math.prod(core)] * dx[..., None, :], axis=-1)
        return split_values(function, change)

    return jax.jit(apply)


def _tangent_type(value: Any) -> Any:
    import jax

    return jax.typeof(value).to_tangent_aval()
