"""Partial statistics of some samples, which can be merged."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

KNOTS = 257  # of the distribution function of a part: quantiles of all are right to 1/256 of the samples at worst


@dataclass
class Numbers:
    """A summary of numbers; undefined ones are left out.

    Attributes:
        count: of those that are defined.
        mean: their mean.
        squares: sum of squared distances from it.
        low: the smallest.
        high: the largest.
        parts: of each part, how many it had and evenly spaced order statistics of it.
    """

    count: int = 0
    mean: float = 0.0
    squares: float = 0.0
    low: float = math.inf
    high: float = -math.inf
    parts: list[tuple[int, list[float]]] = field(default_factory=list)

    @classmethod
    def of(cls, values: Any) -> Numbers:
        """Summarise values (sample,)."""
        known = np.sort(values[~np.isnan(values)])
        if not known.size:
            return cls()
        with np.errstate(over="ignore", invalid="ignore"):  # sums of large numbers are infinite
            mean = float(known[0] + (known - known[0]).mean())  # exact where all are equal
            squares = float(np.sum((known - mean) ** 2))
        places = np.unique(np.round(np.linspace(0, known.size - 1, min(KNOTS, known.size))).astype(int))
        knots = known[places].tolist()
        return cls(known.size, mean, squares, float(known[0]), float(known[-1]), [(known.size, knots)])

    def join(self, other: Numbers) -> Numbers:
        """Return the summary of both. Source: Chan, Golub & LeVeque, Am. Stat. 37 (1983) 242."""
        if not (self.count and other.count):
            return self if self.count else other
        count, apart = self.count + other.count, other.mean - self.mean
        mean = self.mean + apart * (other.count / count)
        squares = self.squares + other.squares + apart * apart * (self.count * (other.count / count))
        return Numbers(count, mean, squares, min(self.low, other.low), max(self.high, other.high),
                       [*self.parts, *other.parts])

    @property
    def deviation(self) -> float | None:
        """Standard deviation of the distribution that the samples are from."""
        return math.sqrt(self.squares / (self.count - 1)) if self.count > 1 else None

    @property
    def error(self) -> float | None:
        """Standard error of the mean, of independent samples."""
        return None if self.deviation is None else self.deviation / math.sqrt(self.count)

    def quantiles(self, levels: Iterable[float]) -> list[float | None]:
        """Return quantiles, from the knots of all parts."""
        if not self.count:
            return [None for _ in levels]
        values = np.concatenate([knots for _, knots in self.parts])
        weights = np.concatenate([np.full(len(knots), count / len(knots)) for count, knots in self.parts])
        order = np.argsort(values, kind="stable")
        middle = np.cumsum(weights[order]) - 0.5 * weights[order]
        return np.interp(np.asarray(list(levels)) * weights.sum(), middle, values[order]).tolist()


Summary = dict[str, int] | list[Numbers]  # how often each word occurs, or numbers by component


def summarise(values: Any) -> Summary:
    """Return values (sample, …) in summary."""
    if values.dtype.kind == "U":
        return dict(sorted(Counter(values.tolist()).items()))
    flat = values.reshape(len(values), -1)
    return [Numbers.of(flat[:, k]) for k in range(flat.shape[1])]


def join_summaries(summaries: Iterable[Summary]) -> Summary:
    """Return the summary of all parts, in their order."""
    words: Counter[str] = Counter()
    numbers: list[Numbers] = []
    for summary in summaries:
        if isinstance(summary, dict):
            words.update(summary)
        else:
            numbers = [a.join(b) for a, b in zip(numbers, summary, strict=True)] if numbers else summary
    return numbers or dict(sorted(words.items()))
