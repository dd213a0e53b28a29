"""Lets a user's step function run: in the convention that it was declared to have, or in another that it may mean."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from polhode.analysis._engine_mistakes import StateConvention
from polhode.analysis._engine_run import EngineRun
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Float64

Step = Callable[[Any, Any, float], tuple[Any, Any]]


@dataclass(frozen=True, eq=False)
class SteppedEngine:
    """A step function, with the body and the convention that it has.

    Attributes:
        step: (quaternion (4,), rate (3,), dt [s]) → (quaternion, rate) after dt, in ``convention``.
        inertia: (3, 3) of the body that the function steps [kg m², body axes].
        convention: how it writes attitude and rate.
    """

    step: Step
    inertia: Float64[Array, "3 3"]
    convention: StateConvention

    def run(
        self, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, count: int, every: int = 1
    ) -> EngineRun:
        """Return the states after every so many of ``count`` steps, the start first.

        Args:
            attitude: (4,) unit quaternion wxyz at the start, body → space.
            momentum: (3,) at the start [kg m²/s, body axes].
            dt: of a step [s].
            count: number of steps, a multiple of ``every``.
            every: steps between two states that are kept.

        Raises:
            InvalidInput: for a step that does not return a quaternion (4,) and a rate (3,).
        """
        q, rate = self.convention.encode(attitude, momentum, self.inertia)
        kept_q, kept_rate = np.full((count // every + 1, 4), np.nan), np.full((count // every + 1, 3), np.nan)
        kept_q[0], kept_rate[0] = q, rate
        with np.errstate(all="ignore"):
            q, rate = _check_answer(self.step(q, rate, dt))
            first = q, rate
            for k in range(1, count + 1):
                if k % every == 0:
                    kept_q[k // every], kept_rate[k // every] = q, rate
                    if not np.isfinite(kept_rate[k // every]).all():
                        break
                try:
                    q, rate = self.step(q, rate, dt)
                except (ArithmeticError, ValueError):  # a state that has left all bounds; what follows is not a number
                    break
            attitudes, momenta = self.convention.decode(kept_q, kept_rate, self.inertia)
        attitudes[0], momenta[0] = attitude, momentum
        times = dt * every * np.arange(len(attitudes))
        return EngineRun(self.inertia, times, attitudes, momenta, find_eps(*first), count)


def _check_answer(answer: Any) -> tuple[Any, Any]:
    if not (isinstance(answer, tuple | list) and len(answer) == 2):
        raise InvalidInput(f"`step` must return attitude and rate, two arrays; got {shown(answer)}.")
    if np.shape(answer[0]) != (4,) or np.shape(answer[1]) != (3,):
        got = f"{np.shape(answer[0])} and {np.shape(answer[1])}"
        raise InvalidInput(f"`step` must return a quaternion (4,) and a rate (3,); got shapes {got}.")
    return answer[0], answer[1]


def find_eps(*values: Any) -> float:
    """Return the rounding unit of numbers: that of their type, or of float32 where all of them are numbers of it."""
    types = [np.asarray(value).dtype for value in values]
    coarsest = max((np.finfo(t).eps for t in types if np.issubdtype(t, np.floating)), default=np.finfo(float).eps)
    arrays = [np.asarray(value, dtype=float) for value in values]
    with np.errstate(all="ignore"):
        if all(np.array_equal(a, a.astype(np.float32), equal_nan=True) for a in arrays):
            coarsest = max(coarsest, np.finfo(np.float32).eps)
    return float(coarsest)
