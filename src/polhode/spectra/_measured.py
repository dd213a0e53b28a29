"""Measured lines: labels, frequencies, errors and blends."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.types import Array, Float64, Integer


class MeasuredLines(NamedTuple):
    """Lines as measured. Neighbours of equal frequency and error are one blend, the weighted mean of its members.

    Attributes:
        upper, lower: (n, 3) J, K_a, K_c.
        frequency: (n,) [Hz].
        error: (n,) standard deviation of the frequency [Hz].
        weight: (n,) of a member of a blend; None for equal ones.
    """

    upper: Integer[Array, "n 3"]
    lower: Integer[Array, "n 3"]
    frequency: Float64[Array, "n"]
    error: Float64[Array, "n"]
    weight: Float64[Array, "n"] | None = None


class Observations(NamedTuple):
    """Lines, checked, as observations: (m,) frequencies and errors [Hz], and shares (m, n) of lines in them."""

    upper: Integer[Array, "n 3"]
    lower: Integer[Array, "n 3"]
    frequency: Float64[Array, "m"]
    error: Float64[Array, "m"]
    member: Integer[Array, "n"]
    share: Float64[Array, "n"]

    def means(self, of_lines: Float64[Array, "lines ..."]) -> Float64[Array, "observations ..."]:
        """Return values of lines as values of observations: means over blends."""
        total = np.zeros((len(self.frequency), *of_lines.shape[1:]))
        np.add.at(total, self.member, self.share.reshape(-1, *[1] * (of_lines.ndim - 1)) * of_lines)
        return total


def check_labels(name: str, labels: Array) -> Integer[Array, "n 3"]:
    """Return levels' labels.

    Raises:
        InvalidInput: for labels that no level has.
    """
    rows = np.asarray(labels)
    if rows.ndim != 2 or rows.shape[1] != 3 or not np.issubdtype(rows.dtype, np.integer):
        raise InvalidInput(f"`{name}` must be whole numbers (n, 3), J, Ka, Kc of each line; got shape {rows.shape}.")
    J, Ka, Kc = rows.T
    wrong = (J < 0) | (Ka < 0) | (Kc < 0) | (Ka > J) | (Kc > J) | ((Ka + Kc - J) * (Ka + Kc - J - 1) != 0)
    if wrong.any():
        k = int(np.flatnonzero(wrong)[0])
        raise InvalidInput(
            f"`{name}` must have Ka and Kc from 0 to J, with Ka + Kc = J or J + 1; got J, Ka, Kc = "
            f"{', '.join(str(int(x)) for x in rows[k])} in line {k + 1}. Check the assignment."
        )
    return rows


def observations(lines: MeasuredLines) -> Observations:
    """Return lines, checked, by blends.

    Raises:
        InvalidInput: for labels that no level has, numbers that are not finite, errors and weights that are not
            positive, and arrays of other lengths.
    """
    upper, lower = check_labels("upper", lines.upper), check_labels("lower", lines.lower)
    raw = {"frequency": lines.frequency, "error": lines.error}
    raw["weight"] = np.ones(len(upper)) if lines.weight is None else lines.weight
    if not len(upper):
        raise InvalidInput("`lines` must not be empty. Give measured lines.")
    columns = {}
    for name, values in raw.items():
        column = np.asarray(values, float)
        if column.shape != (len(upper),) or len(lower) != len(upper):
            raise InvalidInput(f"`lines.{name}` must have one number for each line; got shape {column.shape} and "
                               f"{len(upper)} and {len(lower)} labels.")
        wrong = ~np.isfinite(column) | ((column <= 0.0) if name != "frequency" else False)
        if wrong.any():
            k = int(np.flatnonzero(wrong)[0])
            rule = "finite" if name == "frequency" else "positive and finite"
            raise InvalidInput(f"`lines.{name}` must be {rule}; got {shown(float(column[k]))} in line {k + 1}.")
        columns[name] = column
    same = (upper == lower).all(axis=1)
    if same.any():
        raise InvalidInput(f"a line must be between two levels; line {int(np.flatnonzero(same)[0]) + 1} has the same "
                           "upper and lower one. Check the assignment.")
    frequency, error, weight = columns["frequency"], columns["error"], columns["weight"]
    # lines next to each other with one frequency and error are one observation
    begins = np.concatenate([[True], (np.diff(frequency) != 0.0) | (np.diff(error) != 0.0)])
    member = np.cumsum(begins) - 1
    share = weight / np.bincount(member, weight)[member]
    return Observations(upper, lower, frequency[begins], error[begins], member, share)
