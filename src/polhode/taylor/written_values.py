"""Invariants and vectors of a system at states, as lines of Python that are written once for each structure.

NumPy's steps for a function of JAX take longer for a few states than a whole motion by compiled code. The lines take
the numbers of a system as arguments, so that all systems that differ by these share them. Only sums, products,
reciprocals and roots are written: these give the same bits for one state and for arrays of states.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from itertools import chain
from typing import Any, NamedTuple

import jax
import numpy as np

from polhode._base.kept import kept_of_object
from polhode.systems._forms import facts_of
from polhode.systems.base import AbstractSystem, Vectors
from polhode.systems.trajectories import Told
from polhode.taylor.expressions import Expression, Tape, Untraceable, gradient
from polhode.taylor.machine import TRACING, Form, tape_value
from polhode.taylor.operations import Node, Operation
from polhode.taylor.structure import Structure, take_structure
from polhode.taylor.tracing import evaluate, list_operations
from polhode.types import Double, Float64


class WrittenLimits(NamedTuple):
    """Bounds of what is written, and how states are taken."""

    max_numbers: int = 600  # of a state times those of its invariants: beyond, gradients take long to write
    max_nodes: int = 2_000  # Python compiles a line in some 10 µs
    max_single: int = 24  # states that are taken one by one: of more, NumPy's arrays take less time
    together: int = 4_096  # states of one array, which the processor's cache holds with all that comes of them


LIMITS = WrittenLimits()
Lines = Callable[..., tuple[Any, ...]]
POWERS = {-1.0: "1.0 / {0}", -2.0: "1.0 / ({0} * {0})", 1.5: "{0} * root({0})", 0.5: "root({0})",
          -0.5: "1.0 / root({0})", -1.5: "1.0 / ({0} * root({0}))"}  # fmt: skip


class Written(NamedTuple):
    """Functions of the numbers of a state and of a system.

    Attributes:
        values: those of invariants that are one number, of the others, then of vectors.
        sizes: Σ |x ∂C/∂x| of each invariant that is one number.
        shapes: of invariants by name, in their order.
        vectors: sizes of attitude, momentum and angular velocity; None where meaningless.
    """

    values: Lines
    sizes: Lines
    shapes: dict[str, tuple[int, ...]]
    vectors: tuple[int | None, ...]


def tell(system: AbstractSystem, states: Double[np.ndarray, "..."]) -> Told | None:
    """Return what a system says of states (batch…, T, *shape); None where that is not written.

    Systems with balances, or with quantities of their copies, are not.
    """
    shape = states.shape[states.ndim - facts_of(system).state_axes :]
    if np.iscomplexobj(states):
        return None
    written, numbers = _written_for(system, Form(shape, False))
    if written is None:
        return None
    leading, size = states.shape[: states.ndim - len(shape)], math.prod(shape)
    first = states.reshape(-1, leading[-1], size)[:, 0]
    try:
        values = _at(written.values, states.reshape(-1, size), numbers)
        sizes = _at(written.sizes, first, numbers)
    except (ArithmeticError, ValueError):  # of Python's numbers, where NumPy has an infinity or NaN
        return None
    single = tuple(name for name, own in written.shapes.items() if not own)
    together, place = values[:, : len(single)].reshape(*leading, len(single)), len(single)
    invariants: dict[str, Any] = dict.fromkeys(written.shapes)  # in this order
    for name, own in written.shapes.items():
        if own:
            count = math.prod(own)
            invariants[name] = values[:, place : place + count].reshape(*leading, *own)
            place += count
    for k, name in enumerate(single):
        invariants[name] = together[..., k]
    is_finite, vectors = bool(np.isfinite(values[:, :place]).all()), list[Any]()
    for count in written.vectors:
        vectors.append(None if count is None else values[:, place : place + count].reshape(*leading, count))
        place += count or 0
    sizes = sizes.reshape(*leading[:-1], len(single))
    of_first = {name: sizes[..., k] for k, name in enumerate(single)}
    return Told(invariants, {}, Vectors(*vectors), of_first, (single, together, sizes), is_finite)


def _at(lines: Lines, states: Float64[np.ndarray, "states n"], numbers: list[float]) -> Float64[np.ndarray, "states k"]:
    """Return values, one row for each state."""
    count = len(states)
    if count <= LIMITS.max_single:
        return np.array([lines(math.sqrt, *row, *numbers) for row in states.tolist()])
    result = None
    for low in range(0, count, LIMITS.together):
        columns = np.ascontiguousarray(states[low : low + LIMITS.together].T)
        with np.errstate(all="ignore"):
            values = lines(np.sqrt, *columns, *numbers)
        result = np.empty((count, len(values))) if result is None else result
        for k, value in enumerate(values):
            result[low : low + LIMITS.together, k] = value
    assert result is not None
    return result


@kept_of_object
def _written_for(system: AbstractSystem, form: Form) -> tuple[Written | None, list[float]]:
    structure, numbers = take_structure(system)
    try:
        return _write(structure, form, type(system)), numbers.tolist()
    except (Untraceable, *TRACING):
        return None, []


@lru_cache(maxsize=256)
def _write(structure: Structure, form: Form, kind: type) -> Written | None:
    """Return the lines for systems of one structure and kind.

    Raises:
        Untraceable: for functions that have no lines.
    """
    order, has_more = list[str](), [False]

    def functions(x: Any, numbers: Any) -> Any:
        system, state = structure.with_numbers(numbers), form.state(x)
        invariants, vectors = system.invariants(state), system.vectors(state)
        order[:] = sorted(invariants)  # as JAX has them
        of_copies = any(quantity.of_copies for quantity in system.quantities.values())
        has_more[0] = bool(of_copies or system.balance_values(0.0, state) or system.invariant_sizes(state))
        return tuple(invariants[name] for name in order), vectors

    arguments = [jax.ShapeDtypeStruct((count,), float) for count in (form.size, structure.size)]
    closed, (invariants, vectors) = jax.make_jaxpr(functions, return_shape=True)(*arguments)
    shapes = {name: each.shape for name, each in zip(order, invariants, strict=True)}
    are_doubles = all(each.dtype == np.float64 for each in jax.tree.leaves((invariants, vectors)))
    single = [k for k, each in enumerate(invariants) if not each.shape]
    if has_more[0] or not are_doubles or len(single) * form.size > LIMITS.max_numbers:
        return None
    tape = Tape(form.size + structure.size)
    known = np.empty(tape.size, object)
    known[:] = tape.state()
    results = evaluate(list_operations(closed), known[: form.size], known[form.size :])
    values = [[tape_value(tape, x) for x in np.ravel(part)] for part in results]
    slopes = [gradient(values[k][0])[: form.size] for k in single]
    lines = _Lines(tape, form.size)
    of_vectors = tuple(None if each is None else math.prod(each.shape) for each in vectors)
    numbers_first = [*single, *(k for k in range(len(values)) if k not in single)]
    return Written(lines.write(list(chain(*(values[k] for k in numbers_first)))), lines.write_sizes(slopes), shapes,
                   of_vectors)


class _Lines:
    """A tape as text of Python: x are the numbers of a state, p those of the system, z the nodes."""

    def __init__(self, tape: Tape, size: int) -> None:
        self.tape, self.size = tape, size
        self.arguments = [f"x{k}" for k in range(size)] + [f"p{k}" for k in range(tape.size - size)]

    def write(self, outputs: Sequence[Expression]) -> Lines:
        """Return the function that gives these expressions."""
        return self._compile(outputs, [self._sum(each.terms.items(), each.constant) for each in outputs])

    def write_sizes(self, slopes: Sequence[Sequence[Expression]]) -> Lines:
        """Return the function that gives Σ |x ∂C/∂x| for each row of derivatives."""
        texts = [
            " + ".join(f"abs(x{k} * ({self._sum(each.terms.items(), each.constant)}))" for k, each in enumerate(row)
                       if each.terms or each.constant) or "0.0"
            for row in slopes
        ]  # fmt: skip
        return self._compile(list(chain(*slopes)), texts)

    def _compile(self, outputs: Sequence[Expression], texts: Sequence[str]) -> Lines:
        """Return the function with those nodes that the outputs need.

        Raises:
            Untraceable: for too many of them, and operations that are not written.
        """
        needed = {place for each in outputs for place in each.terms}
        count = len(self.tape.nodes)
        if count > LIMITS.max_nodes:
            raise Untraceable(f"more than {LIMITS.max_nodes} operations")
        for place in range(self.tape.size + count - 1, self.tape.size - 1, -1):
            if place in needed:
                needed.update(self.tape.nodes[place - self.tape.size].arguments)
        body = [f"    z{place} = {self._node(self.tape.nodes[place - self.tape.size])}"
                for place in sorted(needed) if place >= self.tape.size]  # fmt: skip
        results = "".join(f"{each}, " for each in texts)
        text = "\n".join([f"def lines(root, {', '.join(self.arguments)}):", *body, f"    return ({results})"])
        space: dict[str, Any] = {}
        exec(compile(text, "<values of a system>", "exec"), space)
        return space["lines"]

    def _name(self, place: int) -> str:
        return self.arguments[place] if place < self.tape.size else f"z{place}"

    def _node(self, node: Node) -> str:
        names = [self._name(place) for place in node.arguments]
        if node.operation is Operation.AFFINE:
            return self._sum(zip(node.arguments, node.coefficients, strict=True), node.number)
        if node.operation is Operation.PRODUCT:
            return f"{names[0]} * {names[1]}"
        if node.operation is Operation.POWER and node.number in POWERS:
            return POWERS[node.number].format(names[0])
        raise Untraceable(f"the operation '{node.operation.name.lower()}', which is not written")

    def _sum(self, terms: Iterable[tuple[int, float]], constant: float) -> str:
        parts = [self._name(place) if factor == 1.0 else f"{_number(factor)} * {self._name(place)}"
                 for place, factor in terms]  # fmt: skip
        return " + ".join([*parts, *([_number(constant)] if constant or not parts else [])])


def _number(x: float) -> str:
    """Return a number as text.

    Raises:
        Untraceable: if it is infinite or NaN.
    """
    if not math.isfinite(x):
        raise Untraceable("a number that is not finite")
    text = repr(x)
    return f"({text})" if x < 0.0 else text
