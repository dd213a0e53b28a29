"""The threshold at which a verdict changes along a family of equilibria."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._printing import print_answer, write_numbers
from polhode.analysis.energy_casimir import Stability
from polhode.errors import InvalidInput


@dataclass(frozen=True)
class Threshold:
    """Where a verdict changes.

    Attributes:
        value: the parameter's value there.
        uncertainty: half the remaining interval.
        below: the verdict just below it.
        above: the verdict just above it.
    """

    value: float
    uncertainty: float
    below: Stability
    above: Stability

    def __str__(self) -> str:
        return print_answer(
            f"{self.below.verdict} below and {self.above.verdict} above",
            threshold=write_numbers(self.value, errors=self.uncertainty),
        )


@known_numbers_only
def stability_threshold(
    verdict: Callable[[float], Stability], low: float, high: float, tolerance: float = 1e-9
) -> Threshold:
    """Return the value of a parameter at which the verdict changes, by bisection.

    Next to a threshold a verdict may be "undecided" over an interval of the size of rounding; one of its edges is
    returned then. Of several thresholds in the interval one is returned.

    Args:
        verdict: the parameter → ``stability`` of the equilibrium there.
        low, high: ends of the interval, at which the verdicts differ.
        tolerance: of the value, relative to the larger of the ends.

    Raises:
        InvalidInput: for ends that are not finite or in the wrong order, a tolerance that is not positive, or ends with
            the same verdict.

    >>> from polhode.analysis import stability
    >>> from polhode.systems import HeavyTop
    >>> top = HeavyTop((1.0, 1.0, 0.5), 1.0)
    >>> threshold = stability_threshold(lambda spin: stability(top, top.upright(spin)), 1.0, 6.0)
    >>> round(threshold.value, 6), threshold.below.verdict, threshold.above.verdict  # (I3 ω)² = 4 mgl I1
    (4.0, 'unstable', 'stable')
    """
    max_halvings = 200
    low = check.number("low", low)
    high = check.number("high", high, above=low)
    tolerance = check.number("tolerance", tolerance, above=0, below=1)
    below, above = verdict(low), verdict(high)
    if below.verdict == above.verdict:
        raise InvalidInput(
            f"the verdicts at `low` and `high` must differ; got {below.verdict!s} at both {low:g} and {high:g}. Choose "
            "an interval across the threshold."
        )
    first, size = below.verdict, max(abs(low), abs(high))
    for _ in range(max_halvings):
        middle = 0.5 * (low + high)
        if high - low <= 2.0 * tolerance * size or not low < middle < high:
            break
        judgement = verdict(middle)
        if judgement.verdict == first:
            low, below = middle, judgement
        else:
            high, above = middle, judgement
    return Threshold(0.5 * (low + high), 0.5 * (high - low), below, above)
