"""Refuses derivatives of motions by numbers that functions enclose, which would be wrong."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced
from polhode._base.arrays.namespaces import ENCLOSED
from polhode._base.arrays.operation import Operation, Point
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractSystem
from polhode.types import Array

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")
_plain: set[Any] = set()
"""Systems that enclose no traced numbers, by their parts and shapes."""


def refuse_derivatives_by_enclosed(solve: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Make a function of a system, whose result has an ``end_state``, refuse derivatives by enclosed numbers.

    Methods have derivatives of their own, by the state and the arrays of the system; a number that a function of the
    system encloses is a constant to them. Values, compiled or batched, may depend on it.
    """

    @functools.wraps(solve)
    def solve_guarded(*args: Parameters.args, **kwargs: Parameters.kwargs) -> Result:
        solution = solve(*args, **kwargs)
        system: Any = args[0] if args else kwargs["system"]
        enclosed = _find_enclosed(system, solution)
        return _guard(solution, enclosed, type(system).__name__) if enclosed else solution

    return solve_guarded


def _find_enclosed(system: AbstractSystem, solution: Any) -> list[Any]:
    """Return the traced numbers that a system's rates of change contain, and that are none of its arrays."""
    end = solution.end_state
    one = jax.ShapeDtypeStruct(end.shape[end.ndim - system.state_axes :], end.dtype)
    arrays, rest = eqx.partition(system, lambda x: eqx.is_array(x) or isinstance(x, np.ndarray))
    leaves, tree = jax.tree.flatten(rest)
    key = tree, one, *leaves, *(x.shape for x in jax.tree.leaves(arrays))
    try:
        if key in _plain:
            return []
    except TypeError:  # a part that cannot be hashed
        key = None

    def rates(t: Any, state: Any, arrays: Any) -> Any:
        return eqx.combine(arrays, rest).vector_field(t, state)

    consts = jax.make_jaxpr(rates)(jnp.zeros(()), one, arrays).consts
    enclosed = [x for x in consts if is_traced(x)]
    if key is not None and not enclosed:
        if len(_plain) >= 256:
            _plain.clear()
        _plain.add(key)
    return enclosed


def _guard(solution: Result, enclosed: list[Any], name: str) -> Result:
    """Return the solution, whose derivatives by the enclosed numbers raise."""
    arrays, rest = eqx.partition(solution, eqx.is_inexact_array)
    count = len(jax.tree.leaves(arrays))

    def forward(at: Point, results: Any, changes: list[Array]) -> list[Array]:
        if any(k >= count for k in at.which):
            raise InvalidInput(f"the functions of {name} {ENCLOSED}")
        return at.spread(changes)[:count]

    return eqx.combine(Operation(name, lambda arrays, enclosed: arrays, forward)(arrays, enclosed), rest)
