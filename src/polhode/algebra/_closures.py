"""Functions of a user as data: their operations, by which they are compared, and the numbers in them, as arrays.

What JAX compiles is kept by the functions in its arguments, and each closure is another function. Taken apart, closures
that differ by their numbers alone share one program, whose arguments these numbers are. Operations are read off the
jaxpr and not off Python's code, so that it does not matter where a function has its numbers from.
"""

from __future__ import annotations

import hashlib
import itertools
import re
from collections.abc import Callable, Hashable, Iterable
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced, refuse_complex
from polhode._base.jaxprs import (
    CALLS,
    NAMED,
    WRITTEN_OUT,
    Branches,
    Entry,
    Listing,
    NoRule,
    Scan,
    While,
    is_jaxpr,
    names_within,
)
from polhode.algebra.base import HashableModule
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Double, Float64

Shapes = tuple[tuple[tuple[int, ...], Any], ...]


class _Body(NamedTuple):
    """Operations, with the places that numbers and arrays take among them.

    Attributes:
        within: bodies of loops and branches that enclose some themselves, by the identity of these.
    """

    listing: Listing
    numbers: dict[int, int]
    arrays: dict[int, int]
    within: dict[int, list[_Body]]

    def run(self, enclosed: tuple[Any, Any], arguments: Iterable[Any]) -> list[Any]:
        """Return the results for numbers and arrays."""
        values = ({place: kept[k] for place, k in places.items()}
                  for kept, places in zip(enclosed, (self.numbers, self.arrays), strict=True))  # fmt: skip
        return self.listing.with_values(dict(itertools.chain(*(one.items() for one in values)))).run(
            arguments, lambda entry, operands: self._apply(entry, enclosed, operands)
        )

    def _apply(self, entry: Entry, enclosed: tuple[Any, Any], operands: list[Any]) -> Any:
        loop, bodies = entry.within, self.within.get(id(entry.within))
        if bodies is None:
            return entry.bind(operands)
        one, *others = [lambda *x, body=body: body.run(enclosed, x) for body in bodies]
        if isinstance(loop, Scan):
            constants, carry, rows = loop.split(operands)

            def advance(now: Any, row: Any) -> Any:
                results = one(*constants, *now, *row)
                return results[: loop.carried], results[loop.carried :]

            given = entry.parameters
            carry, stacks = jax.lax.scan(advance, carry, rows, len(loop.order), given["reverse"], given["unroll"])
            return [*carry, *stacks]
        if isinstance(loop, While):
            of_condition, of_body, carry = loop.split(operands)
            return jax.lax.while_loop(lambda now: one(*of_condition, *now)[0],
                                      lambda now: others[0](*of_body, *now), carry)  # fmt: skip
        return jax.lax.switch(operands[0], [one, *others], *operands[1:])


class Code:
    """What a function does with its arguments and the numbers in it; equal for functions that do the same.

    Attributes:
        body: the operations.
        form: of the results.
        function, shapes: which it was read off; not compared.
    """

    def __init__(self, key: Hashable, body: _Body, form: Any, function: Callable[..., Any], shapes: Shapes) -> None:
        self._key = key, form
        self._hash = hash(self._key)
        self.body, self.form, self.function, self.shapes = body, form, function, shapes

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Code) and self._hash == other._hash and self._key == other._key)

    def __repr__(self) -> str:
        return f"<operations of {_name(self.function)}>"

    @property
    def digest(self) -> str:
        """Of what it is compared by; the same in every process."""
        return hashlib.sha256(_write(self._key).encode()).hexdigest()


class Closure(HashableModule):
    """A function of arrays, with the numbers that it had when it was taken apart.

    Attributes:
        numbers: (count,) the single ones: those in its code, such as 0.5, and those that its variables had.
        arrays: the others.
        code: what is done with them.
    """

    numbers: Float64[Array, "count"]
    arrays: tuple[Double[Array, "..."], ...]
    code: Code = eqx.field(static=True)

    def __call__(self, *arguments: Any) -> Any:
        numbers: Any = self.numbers if is_traced(self.numbers) else np.asarray(self.numbers)
        enclosed = [numbers[k] for k in range(len(numbers))], self.arrays
        return jax.tree.unflatten(self.code.form, self.code.body.run(enclosed, self._convert(arguments)))

    def _convert(self, arguments: tuple[Any, ...]) -> list[Array]:
        """Return arguments as arrays of the types that the operations were read for.

        Raises:
            InvalidInput: for other shapes, for which the function might do other operations.
        """
        given, name = [jnp.asarray(x) for x in arguments], _name(self.code.function)
        shapes, kinds = zip(*self.code.shapes, strict=True)
        if tuple(x.shape for x in given) != shapes:
            raise InvalidInput(
                f"`{name}` takes {_list(shapes)}; got {_list(x.shape for x in given)}. For many points at once, use "
                "`jax.vmap` of it."
            )
        for x, kind in zip(given, kinds, strict=True):
            if not jnp.issubdtype(kind, jnp.complexfloating):
                refuse_complex(f"argument of {name}", x)
        return [x if x.dtype == kind else x.astype(kind) for x, kind in zip(given, kinds, strict=True)]

    def __copy__(self) -> Closure:
        return self

    def __deepcopy__(self, memo: Any) -> Closure:  # nothing of it changes, and a function read again may do so
        return self

    def __reduce__(self) -> Any:
        code = self.code
        return _take_apart_again, (code.function, code.shapes, self.numbers, self.arrays, code.digest)


def _name(function: Any) -> str:
    return getattr(function, "__qualname__", None) or shown(function)


def _list(shapes: Iterable[tuple[int, ...]]) -> str:
    texts = [str(shape) for shape in shapes]
    return f"{'an array' if len(texts) == 1 else 'arrays'} of shape {' and '.join(texts)}"


def take_apart(function: Callable[..., Any], *arguments: Any) -> Callable[..., Any]:
    """Return a function of arrays as a ``Closure``, or as it is where that gains nothing.

    Modules and ``Partial`` have their numbers as data already. Operations that hold functions of Python, such as
    derivatives of a user's own, cannot be compared.

    Args:
        function: of these arguments.
        arguments: arrays, or their shapes and types.
    """
    if not jax.tree_util.all_leaves([function]):
        return function
    # by another name each time, as JAX keeps what it traced by the function, with the numbers that it had then
    closed, results = jax.make_jaxpr(lambda *x: function(*x), return_shape=True)(*arguments)
    if not (CALLS - WRITTEN_OUT).isdisjoint(names_within(closed)):
        return function
    taken = _Taken([], [])
    try:
        body, key = _take(Listing(closed, NAMED), taken)
        shapes = tuple((tuple(np.shape(x)), jnp.result_type(x)) for x in arguments)
        counts = len(taken.numbers), len(taken.arrays)
        code = Code((key, shapes, counts), body, jax.tree.structure(results), function, shapes)
    except (NoRule, TypeError):  # what cannot be hashed
        return function
    with jax.ensure_compile_time_eval():  # so that numbers are known, too, where other things are traced
        numbers = jnp.asarray(np.array(taken.numbers, float))
        arrays = tuple(x if is_traced(x) else jnp.asarray(np.array(x)) for x in taken.arrays)  # copies
    return Closure(numbers, arrays, code)


def _take_apart_again(function: Callable[..., Any], shapes: Shapes, numbers: Array, arrays: Any, digest: str) -> Any:
    """Return a closure that was pickled.

    Raises:
        InvalidInput: if its function does something else now.
    """
    read = take_apart(function, *(jax.ShapeDtypeStruct(*shape) for shape in shapes))
    if not isinstance(read, Closure) or read.code.digest != digest:
        raise InvalidInput(
            f"`{_name(function)}` must have the operations that it had when it was pickled, to which the pickled "
            "numbers belong; its code, or something that it reads, or JAX has changed since. Undo that, or make the "
            "system anew."
        )
    return eqx.tree_at(lambda one: (one.numbers, one.arrays), read, (numbers, arrays))


class _Taken(NamedTuple):
    numbers: list[float]
    arrays: list[Any]


def _take(listing: Listing, taken: _Taken | None) -> tuple[_Body, Hashable]:
    """Return operations as a body, whose numbers are appended to those taken, and what they are compared by.

    Where nothing is taken, they are compared by their numbers, too.

    Raises:
        NoRule: for operations that cannot be compared.
    """
    # whole powers are operations of their own, and what is known of others, such as roots, is by their exponents
    exponents = {entry.operands[1] for entry in listing.entries if entry.name == "pow"}
    body, kept, entries = _Body(listing, {}, {}, {}), [], []
    for place, value in itertools.chain(listing.literals.items(), listing.constants.items()):
        kind = jnp.result_type(value)
        if taken is None or place in exponents or not jnp.issubdtype(kind, jnp.inexact):
            kept.append((place, _by_value(value)))
        elif np.shape(value) == () and kind == jnp.float64 and not is_traced(value):
            body.numbers[place] = len(taken.numbers)
            taken.numbers.append(float(value))
        else:
            kept.append((place, np.shape(value), str(kind)))
            body.arrays[place] = len(taken.arrays)
            taken.arrays.append(value)
    for entry in listing.entries:
        within = entry.within
        parts = [_take(one, taken) for one in _bodies(within)]
        if any(one.numbers or one.arrays or one.within for one, _ in parts):
            body.within[id(within)] = [one for one, _ in parts]
        given = {k: x for k, x in entry.parameters.items() if not (parts and _holds_jaxpr(x))}
        entries.append((entry.operation, _parameter(given), entry.operands, entry.results,
                        tuple(key for _, key in parts)))  # fmt: skip
    return body, (tuple(listing.inputs), tuple(listing.outputs), tuple(kept), tuple(entries))


def _bodies(within: Any) -> tuple[Listing, ...]:
    if isinstance(within, Scan):
        return (within.body,)
    if isinstance(within, While):
        return within.condition, within.body
    return within.each if isinstance(within, Branches) else ()


def _holds_jaxpr(value: Any) -> bool:
    return is_jaxpr(value) or (isinstance(value, tuple) and any(map(_holds_jaxpr, value)))


def _parameter(value: Any) -> Hashable:
    """Return what a parameter of an operation is compared by."""
    if is_jaxpr(value):
        return _take(Listing(value, NAMED), None)[1]
    if isinstance(value, dict):
        return tuple((name, _parameter(value[name])) for name in sorted(value))
    if isinstance(value, list | tuple):
        return type(value), tuple(map(_parameter, value))
    if isinstance(value, np.ndarray | jax.Array):
        return _by_value(value)
    if callable(value) and not isinstance(value, type):
        raise NoRule("a function of Python")
    hash(value)
    return type(value), value  # as 1, 1.0 and True are equal


def _by_value(value: Any) -> Hashable:
    if is_traced(value):
        raise NoRule("a traced value that is no real number")
    number = np.asarray(value)
    return type(value), number.shape, str(number.dtype), number.tobytes()


def _write(key: Any) -> str:
    """Return what code is compared by as text, without what differs between processes: addresses, orders of sets."""
    if isinstance(key, tuple):
        return f"({', '.join(map(_write, key))})"
    if isinstance(key, frozenset):
        return f"{{{', '.join(sorted(map(_write, key)))}}}"
    if isinstance(key, type):
        return f"{key.__module__}.{key.__qualname__}"
    return re.sub(r" at 0x[0-9a-fA-F]+", "", repr(key))
