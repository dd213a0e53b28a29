"""Runs a user's step function in its declared convention, or in another one that it may follow."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, one_line, shown
from polhode.judging._mistakes import StateConvention
from polhode.judging._run import EngineRun
from polhode.types import Array, Float64

Step = Callable[[Any, Any, float], tuple[Any, Any]]


class SteppingThresholds(NamedTuple):
    """Numbers that decide what an engine's numbers show of its digits and lengths.

    Attributes:
        min_numbers: different ones, whose digits show how they were printed; fewer may be short by chance.
        max_printed_digits: significant ones; those of more digits count as exact, as rounding is then negligible.
        length_tolerance: by which a quaternion's length may miss 1 without a word in the report.
    """

    min_numbers: int = 12
    max_printed_digits: int = 9
    length_tolerance: float = 1e-5


LIMITS = SteppingThresholds()


@dataclass(frozen=True)
class Stop:
    """Where a step function no longer gives states.

    Attributes:
        step: the first that gives none, counted from 1.
        time: at its end [s].
        why: what is wrong with it, as the middle of a sentence.
    """

    step: int
    time: float
    why: str

    @property
    def words(self) -> str:
        """What is wrong, and since when."""
        return f"{self.why} from t = {self.time:.6g} s on"


@dataclass(frozen=True, eq=False)
class SteppedRun(EngineRun):
    """States of a step function; NaN where it gives none.

    Attributes:
        lengths: (T,) of the quaternions as the function returned them; those of ``attitude`` are normalized.
        stop: where it no longer gives states; None where it does to the end.
    """

    lengths: Float64[Array, "time"] = field(default_factory=lambda: np.empty(0))
    stop: Stop | None = None

    def finite_part(self) -> SteppedRun:
        """Return the run up to its first state that is not finite, of which invariants can be measured."""
        with np.errstate(all="ignore"):
            numbers = (self.attitude.T, self.momentum.T, self.energy, self.momentum_norm, self.lengths)
            lost = np.flatnonzero(~np.isfinite(np.vstack(numbers)).all(axis=0))
        if not len(lost):
            return self
        count = max(1, int(lost[0]))
        return replace(
            self, times=self.times[:count], attitude=self.attitude[:count], momentum=self.momentum[:count],
            lengths=self.lengths[:count], steps=self.steps * (count - 1) // (len(self.times) - 1),
        )


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
    ) -> SteppedRun:
        """Return the states after every so many of ``count`` steps, the start first, until the function gives none.

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
        stop = None
        with np.errstate(all="ignore"):
            q, rate = _check_answer(self.step(q, rate, dt))
            first = q, rate
            for k in range(1, count + 1):
                if why := _find_fault(q, rate):
                    stop = Stop(k, k * dt, why)
                    break
                if k % every == 0:
                    kept_q[k // every], kept_rate[k // every] = q, rate
                if k == count:
                    break
                try:
                    q, rate = self.step(q, rate, dt)
                except (ArithmeticError, ValueError) as error:  # a state that has left all bounds
                    stop = Stop(k + 1, (k + 1) * dt, f"it raises {type(error).__name__} ({one_line(str(error))[:120]})")
                    break
            attitudes, momenta = self.convention.decode(kept_q, kept_rate, self.inertia)
            lengths = np.linalg.norm(kept_q, axis=-1)
        attitudes[0], momenta[0] = attitude, momentum
        times = dt * every * np.arange(len(attitudes))
        return SteppedRun(self.inertia, times, attitudes, momenta, find_eps(*first), count,
                          lengths=lengths, stop=stop)


def _find_fault(q: Any, rate: Any) -> str:
    """Return in words why an answer is no state; nothing for a state."""
    # of every step, so that a report can name the first: the squares are quicker than a look at each number
    if 0.0 < np.dot(q, q) < np.inf and np.dot(rate, rate) < np.inf:
        return ""
    answer = {"quaternion": np.asarray(q, dtype=float), "rate": np.asarray(rate, dtype=float)}
    if lost := [name for name, values in answer.items() if not np.isfinite(values).all()]:
        return f"its {' and '.join(lost)} {'are' if len(lost) > 1 else 'is'} no longer finite"
    if beyond := [name for name, values in answer.items() if not np.isfinite(values @ values)]:
        return f"the square of its {beyond[0]} leaves double precision"
    return "" if answer["quaternion"] @ answer["quaternion"] > 0.0 else "its quaternion has length 0"


def find_length_change(lengths: Float64[Array, "time"], eps: float) -> float:
    """Return the largest deviation of a quaternion's length from 1, with its sign; 0 within tolerance."""
    change = lengths - 1.0
    worst = float(change[np.abs(change).argmax()])
    return worst if abs(worst) > max(LIMITS.length_tolerance, 8.0 * eps) else 0.0


def _check_answer(answer: Any) -> tuple[Any, Any]:
    if not (isinstance(answer, tuple | list) and len(answer) == 2):
        raise InvalidInput(f"`step` must return attitude and rate, two arrays; got {shown(answer)}.")
    if np.shape(answer[0]) != (4,) or np.shape(answer[1]) != (3,):
        got = f"{np.shape(answer[0])} and {np.shape(answer[1])}"
        raise InvalidInput(f"`step` must return a quaternion (4,) and a rate (3,); got shapes {got}.")
    return answer[0], answer[1]


def find_printed_unit(values: Float64[Array, "..."]) -> float:
    """Return the unit of the last printed digit of the largest number; 0 where numbers have all digits.

    Few different numbers, such as those of a constant momentum, do not show how many digits were printed.
    """
    numbers = np.unique(np.abs(values[values != 0.0]))
    if len(numbers) < LIMITS.min_numbers:
        return 0.0
    digits = 0
    for number in numbers.tolist():
        digits = max(digits, len(Decimal(repr(number)).normalize().as_tuple().digits))
        if digits > LIMITS.max_printed_digits:
            return 0.0
    return 10.0 ** (math.floor(math.log10(numbers[-1])) + 1 - digits)


def find_eps(*values: Any) -> float:
    """Return the rounding unit of numbers: that of their type, or of float32 where float32 holds all of them.

    Numbers of float32 are also recognized when they were printed with the nine digits that distinguish them.
    """
    types = [np.asarray(value).dtype for value in values]
    coarsest = max((np.finfo(t).eps for t in types if np.issubdtype(t, np.floating)), default=np.finfo(float).eps)
    arrays = [np.asarray(value, dtype=float) for value in values]
    with np.errstate(all="ignore"):
        if all(np.array_equal(a, a.astype(np.float32), equal_nan=True) or _is_single_printed(a) for a in arrays):
            coarsest = max(coarsest, np.finfo(np.float32).eps)
    return float(coarsest)


def _is_single_printed(values: Float64[Array, "..."]) -> bool:
    return all(float(f"{np.float32(x):.9g}") == x for x in np.ravel(values).tolist())
