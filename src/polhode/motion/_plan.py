"""How a motion is computed, and why that way."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import Enum
from typing import Any


class Stepping(Enum):
    """What a motion's samples come from."""

    CLOSED_FORM = "closed form"
    SERIES = "Taylor series"
    EQUAL_STEPS = "equal steps"
    ADAPTIVE_STEPS = "adaptive steps"


@dataclass(frozen=True)
class MotionPlan:
    """How a motion is computed, and why that way; it prints as one sentence.

    Attributes:
        stepping: what samples come from.
        method: the class of the method, as "Taylor", "LieMidpoint" or "Dopri8"; of a closed form that of the motion.
        order: of the method; None of a closed form, and where steps choose it.
        step: the largest step [s] of any copy; None where nothing but the motion bounds it.
        tolerance: relative error to which the motion or, of adaptive steps, each step is held; None where that is a
            rounding, or where the step was given.
        copies: how many motions of a batch go this way, 1 without a batch.
        engine: what computes a step: "on single numbers" (a program of operations, run by Python or as machine code
            to the same bits), "on whole arrays" (by NumPy), "compiled by XLA"; "" of a closed form.
        reason: why this way and no other, a clause without full stop.
        otherwise: how those copies of the batch go that this way does not take to the end, else None.

    >>> print(MotionPlan(Stepping.EQUAL_STEPS, "LieMidpoint", 2, 0.01, None, 3, "compiled by XLA", "as asked"))
    LieMidpoint of order 2, equal steps of at most 0.01 s, 3 copies, compiled by XLA; as asked
    """

    stepping: Stepping
    method: str
    order: int | None = None
    step: float | None = None
    tolerance: float | None = None
    copies: int = 1
    engine: str = ""
    reason: str = ""
    otherwise: MotionPlan | None = None

    def __str__(self) -> str:
        copies = "one copy" if self.copies == 1 else f"{self.copies} copies"
        if self.stepping is Stepping.CLOSED_FORM:
            return f"closed form, {self.method}, {copies}"
        of_series = self.stepping is Stepping.SERIES
        name = self.stepping.value if of_series else self.method
        named = name if self.order is None else f"{name} of order {self.order}"
        bound = "" if self.step is None else f"of at most {self.step:.3g} s"
        held = "" if self.tolerance is None else f"to {self.tolerance:.3g}"
        steps = " ".join(filter(None, ("steps" if of_series else self.stepping.value, bound, held)))
        parts = [named, copies, self.engine] if steps == "steps" else [named, steps, copies, self.engine]
        sentence = "; ".join(filter(None, (", ".join(parts), self.reason)))
        return sentence if self.otherwise is None else f"{sentence}; where these end, {self.otherwise}"

    def as_json_dict(self) -> dict[str, Any]:
        """Return the fields as JSON has them; those without a value are left out."""
        entries = asdict(self) | {"stepping": self.stepping.value}
        if self.otherwise is not None:
            entries["otherwise"] = self.otherwise.as_json_dict()
        return {name: value for name, value in entries.items() if value not in (None, "")}
