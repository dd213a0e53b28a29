"""The change of a state in a step, and the memory of a method of equal steps."""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode.types import Array, ArrayOrFloat, Bool, Double, Float64, Integer

Scalar = Float64[ArrayOrFloat, ""]


class Change(NamedTuple):
    """The result of a step.

    Attributes:
        state: the state's change.
        iterations: how often an implicit step evaluated the system; 0 for explicit ones.
        converged: whether it solved its equation.
    """

    state: Double[Array, "*shape"]
    iterations: Integer[Array, ""]
    converged: Bool[Array, ""]


class Memory(NamedTuple):
    """The memory of a solver: rounding errors of the sums, steps and iterations so far, success.

    ``hint`` is where past steps suggest that the next one start its iteration; results depend on it by rounding.
    """

    lost: Double[Array, "*shape"]
    steps: Integer[Array, ""]
    iterations: Integer[Array, ""]
    fine: Bool[Array, ""]
    hint: Any = ()
