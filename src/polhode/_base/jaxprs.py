"""Reads jaxprs, in which JAX writes down the operations of a function; no other file looks into them.

A ``Listing`` has the operations one after the other, between numbered places. What a function calls (``jit``, functions
with derivatives of their own, ``checkpoint``) is written out where it is called; loops and branches have listings of
their own. What is kept at the places makes an arithmetic: doubles, expressions, coefficients of arrays, truth values
that say what depends on what. Each has a table of rules by the names of the operations.

Importing this file does not import JAX.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

from polhode.types import Array, Shaped

CALLS = frozenset((
    "jit", "pjit", "call", "core_call", "closed_call", "custom_jvp_call", "custom_vjp_call", "remat", "remat2",
    "checkpoint", "eval_jaxpr",
))  # fmt: skip
"""Operations that call a function with their operands, by the names that releases of JAX give them.

Others hold functions too, and do something else with them: a reduction combines elements by one.
"""
WRITTEN_OUT = frozenset(("jit", "pjit", "call", "core_call", "closed_call"))  # those that change nothing
NAMED = frozenset(("solve_kepler", "_whole_turns"))  # functions of polhode's own that have rules as operations have
CALLED = ("jaxpr", "call_jaxpr")  # parameters of these that may hold the function
BRANCHING = frozenset(("scan", "while", "cond"))

Rule = TypeVar("Rule")


class NoRule(Exception):
    """An arithmetic has no rule for an operation, which the message names."""


class Scan(NamedTuple):
    """A loop over rows of arrays.

    Attributes:
        body: of one round: constants, carried values and rows → carried values and rows of the results.
        constants, carried: how many.
        order: of the rows.
    """

    body: Listing
    constants: int
    carried: int
    order: range

    def split(self, arguments: list[Any]) -> tuple[list[Any], list[Any], list[Any]]:
        """Return the constants, the values carried into the first round, and the arrays of rows."""
        first = self.constants + self.carried
        return arguments[: self.constants], arguments[self.constants : first], arguments[first:]

    def run(
        self, arguments: list[Any], body: Callable[[list[Any]], list[Any]], stack: Callable[[tuple[int, ...], Any], Any]
    ) -> list[Any]:
        """Return the values carried out of the last round, and stacks of the rows of results.

        Args:
            arguments: of the loop.
            body: computes a round.
            stack: makes an array of a shape for elements of JAX's type.
        """
        constants, carry, rows = self.split(arguments)
        stacks = [stack((len(self.order), *kind.shape), kind.dtype) for kind in self.body.kinds[self.carried :]]
        for k in self.order:
            computed = body([*constants, *carry, *(row[k, ...] for row in rows)])
            carry = computed[: self.carried]
            for each, value in zip(stacks, computed[self.carried :], strict=True):
                each[k, ...] = value
        return [*carry, *stacks]


class While(NamedTuple):
    """A loop until a condition fails.

    Attributes:
        condition: of its own constants and the carried values.
        body: of its own constants and the carried values.
        of_condition, of_body: how many constants.
    """

    condition: Listing
    body: Listing
    of_condition: int
    of_body: int

    def split(self, arguments: list[Any]) -> tuple[list[Any], list[Any], list[Any]]:
        """Return the constants of the condition, those of the body, and the values carried into the first round."""
        first = self.of_condition + self.of_body
        return arguments[: self.of_condition], arguments[self.of_condition : first], arguments[first:]


class Branches(NamedTuple):
    """Functions of all operands but the first, which says which is taken."""

    each: tuple[Listing, ...]

    def place(self, which: Any) -> int:
        """Return the place of the branch that a number takes."""
        return min(max(int(which), 0), len(self.each) - 1)


class Call(NamedTuple):
    """A function that is called and not written out, as an arithmetic has a rule for it as a whole."""

    body: Listing


class Entry(NamedTuple):
    """One operation of a listing.

    Attributes:
        name: of JAX's primitive, or of a function that is called as a whole.
        parameters: as JAX names them.
        operands, results: places.
        within: the functions that a loop, branches or a call as a whole have.
        equation: JAX's.
    """

    name: str
    parameters: dict[str, Any]
    operands: tuple[int, ...]
    results: tuple[int, ...]
    within: Scan | While | Branches | Call | None
    equation: Any

    @property
    def given(self) -> list[Any]:
        """Shapes and types of the operands."""
        return [variable.aval for variable in self.equation.invars]

    @property
    def made(self) -> list[Any]:
        """Shapes and types of the results."""
        return [variable.aval for variable in self.equation.outvars]

    @property
    def operation(self) -> Hashable:
        """JAX's primitive, one object for all that do the same; names may be those of several."""
        return self.equation.primitive

    def bind(self, values: Iterable[Any]) -> list[Any]:
        """Return the results that JAX computes of values."""
        primitive = self.equation.primitive
        results = primitive.bind(*values, **self.parameters)
        return list(results) if primitive.multiple_results else [results]

    def rule(self, rules: Mapping[str, Rule], of: str, refusal: type[NoRule] = NoRule) -> Rule:
        """Return the rule of an arithmetic.

        Raises:
            NoRule: or the refusal of the arithmetic, where it has none for this operation ``of`` something.
        """
        if self.name not in rules:
            raise refusal(f"`{self.name}` of {of}")
        return rules[self.name]


class Listing:
    """The operations of a function.

    Args:
        closed: its jaxpr, with constants.
        whole: names of compiled functions that are operations of their own, and not written out.

    Attributes:
        inputs, outputs: places.
        kinds: shapes and types of the outputs.
        literals: single numbers in the function, by place.
        constants: arrays that it encloses, by place.
        size: how many places there are.
    """

    def __init__(self, closed: Any, whole: frozenset[str] = frozenset()) -> None:
        self.literals: dict[int, Any] = {}
        self.constants: dict[int, Any] = {}
        self.entries: list[Entry] = []
        self.size, self._whole = 0, whole
        jaxpr, constants = _open(closed)
        self.inputs = [self._new() for _ in jaxpr.invars]
        self.outputs = self._write(jaxpr, constants, self.inputs)
        self.kinds = [v.aval for v in jaxpr.outvars]

    def run(
        self, arguments: Iterable[Any], apply: Callable[[Entry, list[Any]], Iterable[Any]],
        read: Callable[[Any], Any] = lambda number: number,
    ) -> list[Any]:
        """Return the outputs in an arithmetic.

        Args:
            arguments: values of the inputs.
            apply: (entry, values of its operands) → values of its results.
            read: a literal or a constant → its value.
        """
        values: list[Any] = [None] * self.size
        for numbers in (self.literals, self.constants):
            for place, number in numbers.items():
                values[place] = read(number)
        for place, value in zip(self.inputs, arguments, strict=True):
            values[place] = value
        for entry in self.entries:
            results = apply(entry, [values[place] for place in entry.operands])
            for place, value in zip(entry.results, results, strict=True):
                values[place] = value
        return [values[place] for place in self.outputs]

    def only(self, wanted: Sequence[int] | None = None) -> Listing:
        """Return a listing of some outputs, or of all, without operations that these do not need."""
        made = copy.copy(self)
        if wanted is not None:
            made.outputs, made.kinds = [self.outputs[k] for k in wanted], [self.kinds[k] for k in wanted]
        needed, kept = set(made.outputs), []
        for entry in reversed(self.entries):
            if not needed.isdisjoint(entry.results):
                needed.update(entry.operands)
                kept.append(entry)
        made.entries = kept[::-1]
        return made

    def with_constants(self, convert: Callable[[Any], Any]) -> Listing:
        """Return a listing with other constants in place of its own."""
        made = copy.copy(self)
        made.constants = {place: convert(value) for place, value in self.constants.items()}
        return made

    def with_values(self, values: Mapping[int, Any]) -> Listing:
        """Return a listing with other numbers at some places of literals and constants."""
        made = copy.copy(self)
        made.literals = {place: values.get(place, number) for place, number in self.literals.items()}
        made.constants = {place: values.get(place, number) for place, number in self.constants.items()}
        return made

    def _new(self) -> int:
        self.size += 1
        return self.size - 1

    def _keep(self, numbers: dict[int, Any], value: Any) -> int:
        place = self._new()
        numbers[place] = value
        return place

    def _write(self, jaxpr: Any, constants: Iterable[Any], inputs: Iterable[int]) -> list[int]:
        """Append the operations of a jaxpr, and return the places of its outputs."""
        places = dict(zip(jaxpr.invars, inputs, strict=True))
        for variable, value in zip(jaxpr.constvars, constants, strict=True):
            places[variable] = self._keep(self.constants, value)

        def find(variable: Any) -> int:
            return self._keep(self.literals, variable.val) if hasattr(variable, "val") else places[variable]

        for equation in jaxpr.eqns:
            operands = tuple(map(find, equation.invars))
            called = _find_called(equation)
            if called is not None and equation.params.get("name") not in self._whole:
                places.update(zip(equation.outvars, self._write(*_open(called), operands), strict=True))
                continue
            results = tuple([self._new() for _ in equation.outvars])
            places.update(zip(equation.outvars, results, strict=True))
            name = equation.primitive.name if called is None else equation.params["name"]
            within = self._find_within(equation, called) if name in BRANCHING or called is not None else None
            self.entries.append(Entry(name, equation.params, operands, results, within, equation))
        return [find(v) for v in jaxpr.outvars]

    def _find_within(self, equation: Any, called: Any) -> Scan | While | Branches | Call:
        name, parameters = equation.primitive.name, equation.params
        of = lambda closed: Listing(closed, self._whole)  # noqa: E731
        if called is not None:
            return Call(of(called))
        if name == "scan":
            order = range(parameters["length"])[:: -1 if parameters["reverse"] else 1]
            return Scan(of(parameters["jaxpr"]), *split_scan(parameters), order)
        if name == "while":
            counts = parameters["cond_nconsts"], parameters["body_nconsts"]
            return While(of(parameters["cond_jaxpr"]), of(parameters["body_jaxpr"]), *counts)
        return Branches(tuple(map(of, parameters["branches"])))


def _find_called(equation: Any) -> Any:
    """Return the jaxpr of the function that an operation calls with its operands, or None."""
    if equation.primitive.name not in CALLS:
        return None
    return next((equation.params[name] for name in CALLED if name in equation.params), None)


def _open(called: Any) -> tuple[Any, Any]:
    """Return the jaxpr and the constants of a closed jaxpr or one without."""
    return (called.jaxpr, called.consts) if hasattr(called, "jaxpr") else (called, ())


def split_scan(parameters: dict[str, Any]) -> tuple[int, int]:
    """Return how many arguments of a scan are constants, and how many are carried from round to round."""
    if "num_consts" in parameters:
        return parameters["num_consts"], parameters["num_carry"]
    constants, carried, _ = parameters["ft_in"].unpack()  # JAX 0.11 and later
    return len(constants), len(carried)


def lift_enclosed(function: Callable[..., Any], *arguments: Any) -> tuple[list[Any], Callable[..., list[Any]]]:
    """Return the arrays that a function encloses, and (these, *leaves of arguments) → leaves of its results."""
    import jax

    from polhode._base.jax_inner import eval_jaxpr

    closed = jax.make_jaxpr(function)(*arguments)
    return closed.consts, lambda enclosed, *leaves: eval_jaxpr(closed.jaxpr, enclosed, *leaves)


def depends_on(closed: Any, argument: int) -> bool:
    """Return whether any result of a function depends on an argument; a product of it with zero counts as well."""
    listing = Listing(closed)
    return any(_mark(listing, [k == argument for k in range(len(listing.inputs))]))


def _mark(listing: Listing, marks: list[bool]) -> list[bool]:
    """Return which outputs depend on any of the marked inputs."""
    return listing.run(marks, _mark_results, lambda number: False)


def _mark_results(entry: Entry, marks: list[bool]) -> list[bool]:
    within, none = entry.within, [False] * len(entry.results)
    if not any(marks):
        return none
    if isinstance(within, Branches) and not marks[0]:
        return [any(each) for each in zip(none, *(_mark(branch, marks[1:]) for branch in within.each), strict=True)]
    if isinstance(within, While):
        of_condition, of_body, carry = within.split(marks)
        carry = _mark_carried(carry, lambda now: _mark(within.body, [*of_body, *now]))
        return [True] * len(carry) if any(_mark(within.condition, [*of_condition, *carry])) else carry
    if isinstance(within, Scan):
        constants, carry, rows = within.split(marks)
        round_of = lambda now: _mark(within.body, [*constants, *now, *rows])  # noqa: E731
        carry = _mark_carried(carry, lambda now: round_of(now)[: within.carried])
        return [*carry, *round_of(carry)[within.carried :]]
    return [True] * len(none)


def _mark_carried(carry: list[bool], advance: Callable[[list[bool]], list[bool]]) -> list[bool]:
    """Return which carried values are marked after any number of rounds."""
    while True:
        later = [now or then for now, then in zip(carry, advance(carry), strict=True)]
        if later == carry:
            return carry
        carry = later


def numbers_within(closed: Any) -> Iterator[Shaped[Array, "..."]]:
    """Yield all numbers that a function, and functions within it, contain: constants and literals."""
    for jaxpr, constants in _all_within(closed):
        yield from constants
        for equation in jaxpr.eqns:
            yield from (v.val for v in equation.invars if hasattr(v, "val"))


def is_jaxpr(value: Any) -> bool:
    """Return whether a parameter of an operation is a function that JAX has written down."""
    return hasattr(value, "eqns")  # closed ones have them too


def names_within(closed: Any) -> set[str]:
    """Return the names of all operations in a function and functions within it."""
    return {equation.primitive.name for jaxpr, _ in _all_within(closed) for equation in jaxpr.eqns}


def types_within(closed: Any) -> list[str]:
    """Return the names of the types of all operands and results in a function and functions within it."""
    types: dict[Any, None] = {}  # naming a type takes longer than all else
    for jaxpr, _ in _all_within(closed):
        for equation in jaxpr.eqns:
            for variable in (*equation.invars, *equation.outvars):
                types[getattr(variable.aval, "dtype", None)] = None
    return [str(kind) for kind in types]


def _all_within(value: Any) -> Iterator[tuple[Any, Any]]:
    """Yield a jaxpr and those that its operations hold, in whatever way, with their constants."""
    if is_jaxpr(value):
        jaxpr, constants = _open(value)
        yield jaxpr, constants
        for equation in jaxpr.eqns:
            for parameter in equation.params.values():
                yield from _all_within(parameter)
    elif isinstance(value, list | tuple):
        for part in value:
            yield from _all_within(part)
