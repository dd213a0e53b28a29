"""Properties of a jaxpr, JAX's list of the operations of a function, needed before it is evaluated."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import jax
import numpy as np

from polhode._base.jax_inner import ClosedJaxpr, Jaxpr, Literal
from polhode._base.jaxprs import CALLED as INNER


def write_jaxpr(function: Callable[..., Any], *shapes: tuple[int, ...]) -> Any:
    """Return the jaxpr of a function of real arrays of given shapes."""
    return jax.make_jaxpr(function)(*[jax.ShapeDtypeStruct(shape, float) for shape in shapes])


def numbers_in(closed: Any) -> list[float]:
    """Return the real numbers that a jaxpr contains, each once, but those by which doubles are multiplied exactly."""
    numbers: set[float] = set()

    def look_at(value: Any) -> None:
        if np.issubdtype(np.result_type(value), np.inexact):
            flat: Any = np.ravel(np.asarray(value))
            numbers.update(x for part in (flat.real, flat.imag) for x in part.tolist() if not is_power_of_two(x))

    def look_into(jaxpr: Any) -> None:
        for equation in jaxpr.eqns:
            for variable in equation.invars:
                if isinstance(variable, Literal):
                    look_at(variable.val)
            for inner in jax.tree.leaves(list(equation.params.values()), is_leaf=_is_jaxpr):
                if _is_jaxpr(inner):
                    for constant in getattr(inner, "consts", ()):
                        look_at(constant)
                    look_into(getattr(inner, "jaxpr", inner))

    for constant in closed.consts:
        look_at(constant)
    look_into(closed.jaxpr)
    return sorted(numbers)


def is_power_of_two(x: float) -> bool:
    """Return whether a number is zero, infinite or none, or by its size a power of two."""
    return abs(math.frexp(x)[0]) == 0.5 or x == 0.0 or not math.isfinite(x)


def _is_jaxpr(x: Any) -> bool:
    return isinstance(x, Jaxpr | ClosedJaxpr)


def uses_first(closed: Any) -> bool:
    """Return whether a jaxpr does anything with its first argument."""
    first = closed.jaxpr.invars[0]
    return any(v is first for equation in closed.jaxpr.eqns for v in equation.invars)


def operations_on(closed: Any, moving: tuple[int, ...]) -> int:
    """Return about how many operations on single numbers a jaxpr makes of those arguments that move."""
    return _operations(closed.jaxpr, [k in moving for k in range(len(closed.jaxpr.invars))])


def _operations(jaxpr: Any, moving: list[bool]) -> int:
    moves, count = {v for v, does in zip(jaxpr.invars, moving, strict=True) if does}, 0
    for equation in jaxpr.eqns:
        which = [not isinstance(v, Literal) and v in moves for v in equation.invars]
        if not any(which):
            continue
        moves.update(equation.outvars)
        parameters = equation.params
        inner = next((parameters[k] for k in INNER if k in parameters), None)
        if inner is not None:
            inner = getattr(inner, "jaxpr", inner)
            passed = which if len(which) == len(inner.invars) else [True] * len(inner.invars)
            count += _operations(inner, passed) * parameters.get("length", 1)
            continue
        each = 1
        if equation.primitive.name == "dot_general":
            shape = equation.invars[0].aval.shape
            each = math.prod(shape[k] for k in parameters["dimension_numbers"][0][0])
        count += each * sum(math.prod(v.aval.shape) for v in equation.outvars)
    return count


def select_needed(outputs: list[Any], equations: list[Any]) -> list[Any]:
    """Return those equations, in order, without which the outputs cannot be computed."""
    needed, kept = {v for v in outputs if not isinstance(v, Literal)}, []
    for equation in reversed(equations):
        if needed.intersection(equation.outvars):
            needed.update(v for v in equation.invars if not isinstance(v, Literal))
            kept.append(equation)
    return kept[::-1]
