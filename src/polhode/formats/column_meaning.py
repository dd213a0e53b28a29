"""Turns numbers of a plain table into checked times, attitudes and rates, and says how they were understood."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis._attitude_noise import root_mean_square
from polhode.errors import FormatError, InvalidInput
from polhode.estimation._coarse_clock import is_coarse, spread_evenly
from polhode.formats.plain_table import PlainTable
from polhode.types import Array, Bool, Float64


class DirectionLimits(NamedTuple):
    """Numbers that decide whether rates agree with a direction of rotation."""

    max_turn: float = 1.0  # rad between samples; beyond it differences say little about rates
    min_rms_turn: float = 0.02  # rad; less may be noise
    max_residual: float = 0.1  # relative, of rates that agree with a direction
    min_residual_reversed: float = 0.5  # relative, which the same rates leave with the other direction
    min_turns: int = 4  # that are compared


LIMITS = DirectionLimits()


class Understood(NamedTuple):
    """How a table was understood.

    Attributes:
        header: where its columns are named.
        delimiter: the character between columns.
        time, attitude, angular_velocity: which columns these are, in which unit and direction; None for none.
        samples: how many lines are read.
        first, last: times [s].
        left_out: how many lines have no values.
        repeated: how many only repeat the one before.
        spread: how many repeat a time with other values, and were spread over the clock's step.
        largest_deviation: of |q| from 1, or of RᵀR from the unit matrix; None for attitudes that fit any numbers.
        deviation_from: the name of the quantity that must be 1.
        rates_apart: relative difference of the rates from the attitude's rate of turning, both as root mean squares;
            None where one is missing or the samples are too far apart.
        notes: contradictions between file and mapping, and the zero of the times.
        counted_from: the stamp of the file's clock that times count from [s], with all its digits; None for its zero,
            or a date.
        time_resolution: uncertainty of the times by the digits of the stamps [s].
    """

    header: str
    delimiter: str
    time: str
    attitude: str | None
    angular_velocity: str | None
    samples: int
    first: float
    last: float
    left_out: int
    repeated: int
    spread: int
    largest_deviation: float | None
    deviation_from: str
    rates_apart: float | None
    notes: tuple[str, ...]
    counted_from: str | None
    time_resolution: float


def order_times(
    path: Path, times: Float64[Array, "rows"], table: PlainTable
) -> tuple[Float64[Array, "kept"], Bool[Array, "rows"], int]:
    """Return rising times, which rows they are of (n,), and how many of them were spread over a coarse clock's step.

    Rows that merely repeat the row before are left out. Where many come at a time that was there already, with other
    values, the clock is rounded more coarsely than the samples come, and they are spread evenly.

    Raises:
        FormatError: naming the line of a time that is not after the one before it.
    """
    if not np.isfinite(times).all():
        line = table.lines[int(np.argmin(np.isfinite(times)))]
        raise FormatError(f"{path}, line {line}: its time is too large for a number of seconds. Check its unit.")
    steps, same = np.diff(times), np.zeros(len(times), dtype=bool)
    same[1:] = (steps == 0.0) & (table.numbers[1:, 1:] == table.numbers[:-1, 1:]).all(axis=1)
    repeated = np.concatenate([[False], steps == 0.0]) & ~same
    if is_coarse(int(repeated.sum()), len(times)) and (steps >= 0.0).all() and np.ptp(times) > 0.0:
        return spread_evenly(times[~same]), ~same, int(repeated.sum())
    wrong = ~((steps > 0) | same[1:])
    if wrong.any():
        row = int(np.argmax(wrong)) + 1
        now, before = table.lines[row], table.lines[row - 1]
        same_time = steps[row - 1] == 0
        how = "the same as" if same_time else "before"
        remedy = "Write times with more digits, or delete one of the two lines" if same_time else "Sort the lines"
        raise FormatError(
            f"{path}, line {now}: its time, {times[row]:.9g} s, is {how} that of line {before}, "
            f"{times[row - 1]:.9g} s. Times must rise. {remedy}."
        )
    return times[~same], ~same, 0


def agreement(
    times: Float64[Array, "rows"], attitude: Float64[Array, "rows 4"] | None, velocity: Float64[Array, "rows 3"] | None
) -> float | None:
    """Return the relative difference between the rates and the derivative of the attitude; None where nothing turns.

    Of the right order, direction and units it is a little more than noise; of wrong ones it is about one. As many steps
    are taken together as it takes to turn visibly, so that the last digits of the attitude do not matter.

    >>> times = np.linspace(0.0, 0.5, 11)
    >>> attitude = rotation.from_rotation_vector(times[:, None] * np.array([0.0, 0.0, 2.0]))
    >>> ratios = [agreement(times, attitude, np.tile([0.0, 0.0, rate], (11, 1))) for rate in (2.0, -2.0)]
    >>> [round(one, 6) for one in ratios]
    [0.0, 2.0]
    """
    if attitude is None or velocity is None:
        return None
    with np.errstate(over="ignore", invalid="ignore"):  # of rates that no body has
        steps = 0.5 * (velocity[1:] + velocity[:-1]) * np.diff(times)[:, None]
        summed = np.concatenate([np.zeros((1, 3)), np.cumsum(steps, axis=0)])
        stride = 1
        while LIMITS.min_turns * stride < len(times):
            rows = np.arange(0, len(times), stride)
            before, after = attitude[rows[:-1]], attitude[rows[1:]]
            turns = rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(before), after))
            integrated = np.diff(summed[rows], axis=0)
            small = np.linalg.norm(turns, axis=-1) < LIMITS.max_turn
            size = max(root_mean_square(turns[small]), root_mean_square(integrated[small])) if small.any() else 0.0
            if size > LIMITS.min_rms_turn:
                apart = root_mean_square((turns - integrated)[small]) / size
                return apart if np.isfinite(apart) else None
            stride *= 2
    return None


def find_direction(
    path: Path, times: Float64[Array, "rows"], attitude: Float64[Array, "rows 4"],
    velocity: Float64[Array, "rows 3"] | None,
) -> bool:
    """Return whether rotations take space to body, as the angular velocity shows.

    Raises:
        InvalidInput: where it does not show it, or there is none.
    """
    forward, back = (agreement(times, one, velocity) for one in (attitude, rotation.conjugate(attitude)))
    for one, other, backward in ((forward, back, False), (back, forward, True)):
        if one is not None and other is not None and one < LIMITS.max_residual and other > LIMITS.min_residual_reversed:
            return backward
    why = "the file has no angular velocity" if velocity is None else "the angular velocity does not show it"
    raise InvalidInput(
        f"{path}: whether the matrix takes components along the body's axes to those of space, or the other way round, "
        f"is not known, as {why}. Say it by `direction` body-to-space|space-to-body."
    )
