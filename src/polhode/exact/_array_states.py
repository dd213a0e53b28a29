"""What ``kernel_loops`` does for numbers, for arrays: many bodies or tops, each at its time."""

from __future__ import annotations

from types import ModuleType

from polhode._base.arrays import choose, split_halves
from polhode.exact._array_arithmetic import exponential, for_arrays
from polhode.exact._blocks import Columns
from polhode.types import Array, ArrayOrFloat, Float64

Times = Float64[ArrayOrFloat, "*times"]
Sums = tuple[Float64[ArrayOrFloat, "*shape"], ...]


class ArrayStates:
    """States of a motion for arrays of NumPy or JAX, elementwise with broadcasting.

    Args:
        formulas: module of the motion's formulas.
    """

    def __init__(self, formulas: ModuleType) -> None:
        self._formulas, self._summed = for_arrays(formulas), formulas.SUMMED
        self._idle = (0.0,) * (formulas.COLUMNS - formulas.SUMMED)  # in place of entries that sums do not take

    def evaluate(self, flat: Columns, time: Times, rest: Times) -> tuple[Float64[Array, "*shape"], ...]:
        """Return the four quaternion and three momentum components at the times since the epoch, given in two parts."""
        high, low = split_halves(time)
        *components, last = self._formulas.state_of(self._formulas.unflatten(flat), self._sums(flat, high, low, rest))
        return (*components, last + 0.0 * components[0])  # a top's is one number for all times

    def _sums(self, flat: Columns, *time: Array) -> Sums:
        return choose(flat[0] != 0.0, self._full, self._complementary, *flat[: self._summed], *time)

    def _full(self, *columns: Array) -> Sums:
        return self._formulas.full_sums(self._formulas.unflatten((*columns[:-3], *self._idle)), columns[-3:])

    def _complementary(self, *columns: Array) -> Sums:
        m = self._formulas.unflatten((*columns[:-3], *self._idle))
        a, b, c, exponent, factor, other, other_factor = self._formulas.complementary_phase(m, columns[-3:])
        return self._formulas.complementary_sums(
            m, a, b, c, exponential(exponent) * factor, exponential(other) * other_factor
        )
