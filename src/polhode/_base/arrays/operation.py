"""Functions of JAX arrays with derivatives of their own, in either mode from one definition.

JAX differentiates what it traces, which does not serve a call of the host, a loop of unknown length in reverse, or a
sum that is cut off where its terms vanish. An ``Operation`` states such derivatives. This file needs JAX: modules that
must not import it before one of its arrays has come import this file where they need it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import jax
import jax.numpy as jnp
from jax.custom_derivatives import SymbolicZero

from polhode._base.arrays.namespaces import is_jax, is_traced
from polhode._base.jax_inner import Primitive, ShapedArray, ad, batching, mlir
from polhode.errors import InvalidInput
from polhode.types import Array, Shaped

REFUSALS = {
    1: "no derivatives; take differences of its values.",
    2: "first derivatives only; take second ones by differences of the first.",
    3: "first and second derivatives only; take third ones by differences of the second.",
}
"""What is said instead of the first, second and third derivative."""


@dataclass(frozen=True, eq=False)
class Point:
    """Arguments of an operation, and by which of their arrays it is differentiated.

    Attributes:
        arrays: all arrays in the arguments, in the order of ``jax.tree.leaves``.
        which: indices of those that change.
        fill: arrays like these → arguments.
    """

    arrays: Sequence[Array]
    which: tuple[int, ...]
    fill: Callable[[Sequence[Array]], tuple[Any, ...]]

    @property
    def arguments(self) -> tuple[Any, ...]:
        """The arguments of the call."""
        return self.fill(self.arrays)

    @property
    def moving(self) -> list[Shaped[Array, "..."]]:
        """The arrays that change."""
        return [self.arrays[k] for k in self.which]

    def spread(self, changes: Sequence[Array]) -> list[Shaped[Array, "..."]]:
        """Return a change of each array, zeros of those that do not change."""
        spread: list[Array] = [jnp.zeros_like(x) for x in self.arrays]
        for k, dx in zip(self.which, changes, strict=True):
            spread[k] = dx
        return spread

    def replace(self, moved: Sequence[Array]) -> tuple[Any, ...]:
        """Return the arguments with arrays in the places of those that change."""
        arrays = list(self.arrays)
        for k, x in zip(self.which, moved, strict=True):
            arrays[k] = x
        return self.fill(arrays)


Forward = Callable[[Point, Any, list[Array]], Any]
"""Of a point, results there, and changes of the moving arrays, each of its array's shape: a nest, whose floating-point
arrays are the changes J dx of the results that are floating-point arrays, in their order and of their shapes."""
Back = Callable[[Point, Any, list[Array]], Sequence[Array]]
"""Of a point, results there, and weights w of those that are floating-point arrays, of their shapes: the weights Jᵀw of
the moving arrays, each of its array's shape."""

_Kind = tuple[tuple[int, ...], Any]
"""Shape and type of an array."""


@dataclass(frozen=True)
class Operation:
    """A function of JAX arrays whose derivatives are given.

    It is called with nests of arrays of any shapes, in which all but JAX's arrays are constants.

    - By ``jax.jit`` it becomes part of the program, as if it were called without.
    - ``jax.jvp``, ``jacfwd`` and ``linearize`` take ``forward``; ``jax.grad``, ``vjp``, ``jacrev`` and
      ``linear_transpose`` take ``back`` at the same point.
    - ``jax.vmap`` maps ``evaluate``, ``forward`` and ``back`` over the copies; the weights of an argument that they
      share are added up. A function that takes a batch itself is a primitive, as those of ``Elementwise`` are.
    - What these functions enclose is constant to derivatives, and must not be traced where ``back`` is given.
    - Without JAX there are no operations: ``Elementwise`` evaluates NumPy's arrays before it asks for one.

    Attributes:
        name: of the public function, for messages.
        evaluate: arguments → results, a nest of arrays.
        forward: the derivative; None refuses it.
        back: its transpose; None where JAX transposes what ``forward`` consists of.
        keep: arguments → results, and what ``forward`` gets instead of them; by default the results themselves.
        order: of the derivative that this operation's first one would be to the user.
        second: with ``back``, which second derivatives there are: "none"; "forward", those of ``forward`` and ``back``
            that JAX takes forward; or "any", where it differentiates both in either mode.
        at_once: whether derivatives that no compiled function contains are computed piece by piece, not compiled.
    """

    name: str
    evaluate: Callable[..., Any]
    forward: Forward | None = None
    back: Back | None = None
    keep: Callable[..., tuple[Any, Any]] | None = None
    order: int = 1
    second: Literal["none", "forward", "any"] = "none"
    at_once: bool = False

    def __call__(self, *arguments: Any) -> Any:
        """Return the results.

        Raises:
            InvalidInput: where a derivative is asked for that there is not.
        """
        leaves, tree = jax.tree.flatten(arguments)
        if not is_traced(*leaves):
            return self.evaluate(*arguments)
        places = [k for k, leaf in enumerate(leaves) if is_jax(leaf)]
        constants = [None if is_jax(leaf) else leaf for leaf in leaves]

        def fill(arrays: Sequence[Array]) -> tuple[Any, ...]:
            filled = list(constants)
            for k, x in zip(places, arrays, strict=True):
                filled[k] = x
            return jax.tree.unflatten(tree, filled)

        value = jax.custom_jvp(lambda *arrays: self.evaluate(*fill(arrays)))

        def rule(primals: tuple[Array, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
            which = tuple(k for k, (x, dx) in enumerate(zip(primals, tangents, strict=True))
                          if _is_smooth(x) and not isinstance(dx, SymbolicZero))
            if which and self.forward is None:
                _refuse(self.name, self.order)
            results, kept = self.keep(*fill(primals)) if which and self.keep else (value(*primals),) * 2
            outputs, shape = jax.tree.flatten(results)
            changes: list[Any] = [SymbolicZero(jax.typeof(x).to_tangent_aval()) for x in outputs]
            if which:
                smooth = tuple(map(_kind, filter(_is_smooth, outputs)))
                at, ways = Point(primals, which, fill), [tangents[k] for k in which]
                moved = iter(self._change(at, kept, ways, smooth))
                changes = [next(moved) if _is_smooth(x) else none for x, none in zip(outputs, changes, strict=True)]
            return results, jax.tree.unflatten(shape, changes)

        value.defjvp(rule, symbolic_zeros=True)
        return value(*(leaves[k] for k in places))

    def _change(self, at: Point, kept: Any, changes: list[Array], kinds: tuple[_Kind, ...]) -> list[Array]:
        """Return the changes, of these kinds, of the results; by one linear map if it has a transpose of its own."""
        forward, back = self.forward, self.back
        assert forward is not None, "a derivative that there is not has been refused"
        if back is None:
            return _smooth(forward(at, kept, changes))
        leaves, shape = jax.tree.flatten(kept)
        count, arrays = len(at.arrays) + len(leaves), len(at.arrays)

        def split(both: Sequence[Array]) -> tuple[Point, Any, list[Array]]:
            there = Point(both[:arrays], at.which, at.fill)
            return there, jax.tree.unflatten(shape, both[arrays:count]), list(both[count:])

        derivative = _LinearMap(
            lambda *both: _smooth(forward(*split(both))), lambda *both: list(back(*split(both))), count,
            (kinds, tuple(map(_kind, changes))), self.name, self.second, self.at_once,
        )  # fmt: skip
        return derivative(*at.arrays, *leaves, *changes)


def along(function: Callable[..., Any]) -> Forward:
    """Return the forward derivative that JAX takes of a function of the arguments."""

    def forward(at: Point, results: Any, changes: list[Array]) -> list[Array]:
        return jax.jvp(lambda *moved: _smooth(function(*at.replace(moved))), at.moving, changes)[1]

    return forward


def transposed(function: Callable[..., Any]) -> Back:
    """Return the reverse derivative that JAX takes of a function of the arguments."""

    def back(at: Point, results: Any, weights: list[Array]) -> Sequence[Array]:
        _, pull = jax.vjp(lambda *moved: _smooth(function(*at.replace(moved))), *at.moving)
        return pull(weights)

    return back


def first_order_only(values: Any, name: str) -> Any:
    """Return a nest of values unchanged, but refuse to differentiate them: a second derivative would be wrong."""
    return Operation(name, lambda same: same, order=2)(values)


def _refuse(name: str, order: int) -> None:
    raise InvalidInput(f"`{name}` has {REFUSALS[order]}")


def _kind(x: Any) -> _Kind:
    return x.shape, x.dtype


def _is_smooth(x: Any) -> bool:
    return jnp.issubdtype(jnp.result_type(x), jnp.inexact)


def _smooth(results: Any) -> list[Array]:
    """Return those of a nest of arrays that are not whole numbers."""
    return [x for x in jax.tree.leaves(results) if _is_smooth(x)]


# ---------------------------------------------------------------------- derivatives as linear maps


@dataclass(frozen=True, eq=False)  # not a tuple: JAX 0.9 keeps weak references to what it binds
class _LinearMap:
    """A map that is linear in the operands behind the first ones, which say where.

    Attributes:
        forward: all operands → results.
        back: its transpose: the first operands, and weights of the results → those of the others; None refuses it.
        width: how many the first operands are.
        kinds: of the results of ``forward`` and ``back``, so that neither is traced to ask for them.
        name, second, at_once: of the operation.
    """

    forward: Callable[..., list[Array]]
    back: Callable[..., list[Array]] | None
    width: int
    kinds: tuple[tuple[_Kind, ...], tuple[_Kind, ...]]
    name: str
    second: str
    at_once: bool

    def __call__(self, *operands: Any) -> list[Array]:
        return _linear.bind(*operands, linear=self)


def _jvp(primals: Any, tangents: Any, *, linear: _LinearMap) -> tuple[list[Array], list[Array]]:
    count, twice = linear.width, linear.second == "any"
    results = linear(*primals)
    moved = lambda: linear(*primals[:count], *(ad.instantiate_zeros(tangent) for tangent in tangents[count:]))  # noqa: E731
    moving = [k for k, tangent in enumerate(tangents) if not isinstance(tangent, ad.Zero)]
    if all(k >= count for k in moving):
        return results, moved()
    if linear.second == "none":
        _refuse(linear.name, 2)
    # what JAX can transpose is differentiated at once by all that moves; a loop only by where it is
    moving = [k for k in moving if twice or k < count]

    def of_moving(*values: Array) -> list[Array]:
        operands = list(primals)
        for k, x in zip(moving, values, strict=True):
            operands[k] = x
        return linear.forward(*operands)

    _, slopes = jax.jvp(of_moving, [primals[k] for k in moving], [tangents[k] for k in moving])
    if twice:
        return results, slopes
    slopes = _forward_only(slopes, f"the derivative of {linear.name}")
    return results, [a + b for a, b in zip(moved(), slopes, strict=True)]


def _forward_only(values: list[Array], name: str) -> list[Array]:
    """Return values unchanged, of which reverse-mode derivatives are refused, with the name."""
    kinds = tuple(map(_kind, values))
    return _LinearMap(lambda *x: list(x), None, 0, (kinds, kinds), name, "forward", True)(*values)


def _transpose(weights: Any, *args: Any, linear: _LinearMap) -> list[Any]:
    if linear.back is None:
        raise InvalidInput(
            f"`{linear.name}` loops as often as its numbers ask, and has forward derivatives only; got a reverse-mode "
            "one (jax.grad, jax.vjp, jax.jacrev). Take jax.jvp or jax.jacfwd."
        )
    back = replace(linear, forward=linear.back, back=linear.forward, kinds=linear.kinds[::-1])
    cotangents = back(*args[: linear.width], *(ad.instantiate_zeros(weight) for weight in weights))
    own = [x if ad.is_undefined_primal(way) else None for x, way in zip(cotangents, args[linear.width :], strict=True)]
    return [None] * linear.width + own


def _batch(args: Any, axes: Any, *, linear: _LinearMap) -> tuple[list[Array], list[int]]:
    count = linear.width
    size = next(x.shape[axis] for x, axis in zip(args, axes, strict=True) if axis is not None)

    def each(function: Callable[..., list[Array]]) -> Callable[..., list[Array]]:
        def batch(*both: Array) -> list[Array]:
            return jax.vmap(function, in_axes=(*axes[:count], *(0 for _ in both[count:])), axis_size=size)(*both)

        return batch

    # operands that all copies share are not copied; directions are, so that the transpose adds up the copies
    ways = [
        jnp.broadcast_to(x, (size, *jnp.shape(x))) if axis is None else jnp.moveaxis(x, axis, 0)
        for x, axis in zip(args[count:], axes[count:], strict=True)
    ]
    ahead, behind = (tuple(((size, *shape), dtype) for shape, dtype in kinds) for kinds in linear.kinds)
    transpose = linear.back and each(linear.back)
    copies = replace(linear, forward=each(linear.forward), back=transpose, kinds=(ahead, behind))
    results = copies(*args[:count], *ways)
    return results, [0] * len(results)


def _evaluate(*args: Any, linear: _LinearMap) -> list[Array]:
    return (linear.forward if linear.at_once else jax.jit(linear.forward))(*args)


_linear = Primitive("polhode_derivative")
_linear.multiple_results = True
_linear.def_impl(_evaluate)
_linear.def_abstract_eval(lambda *args, linear: [ShapedArray(*kind) for kind in linear.kinds[0]])
ad.primitive_jvps[_linear] = _jvp
ad.primitive_transposes[_linear] = _transpose
batching.primitive_batchers[_linear] = _batch
mlir.register_lowering(_linear, mlir.lower_fun(lambda *args, linear: linear.forward(*args), multiple_results=True))
