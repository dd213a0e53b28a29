"""What every report offers."""

from __future__ import annotations

import abc
import math
from typing import Any, ClassVar

import numpy as np

from polhode.analysis.mechanics import Mechanics
from polhode.motion.trajectory import Trajectory
from polhode.reports.answer import Group, Table, units_of, values_of


class AbstractReport(abc.ABC):
    """Answers about one system.

    Attributes:
        kind: the system, as a spec names it.
    """

    kind: ClassVar[str]

    @property
    @abc.abstractmethod
    def summary(self) -> str:
        """What is said of it, in a sentence or two."""

    @property
    def notes(self) -> list[str]:
        """What a reader should know in addition to the numbers."""
        return []

    @abc.abstractmethod
    def answers(self) -> list[Group | Table]:
        """Return what the report says, in the order of its text."""

    def values(self) -> dict[str, Any]:
        """Return the answers by name, SI units, arrays and numbers that are not finite included."""
        return values_of(self.answers())

    def as_json_dict(self) -> dict[str, Any]:
        """Return the answers as plain lists, numbers, strings and None; undefined or infinite ones are None."""
        answers = self.answers()
        ends = {"units": units_of(answers), "summary": self.summary, "notes": self.notes}
        return plain({"kind": self.kind, **values_of(answers), **ends})


def left_out(kind: type) -> Any:
    """Return what stands for an object of a class in a report of which no answer that takes it is asked."""

    class LeftOut(kind):
        def __getattribute__(self, name: str) -> Any:
            if name.startswith("__"):
                return super().__getattribute__(name)
            raise AssertionError(f"an answer asks for `{name}` of a {kind.__name__} that was left out")

    return tuple.__new__(LeftOut) if issubclass(kind, tuple) else object.__new__(LeftOut)


WITHOUT_MOTION: Trajectory = left_out(Trajectory)


class AbstractMotionReport(AbstractReport):
    """Answers about one motion of one system.

    Attributes:
        kind: the system, as a spec names it.
        trajectory: its samples.
    """

    trajectory: Trajectory

    @property
    def shown(self) -> Trajectory:
        """The motion as it is to be watched: all of it, or a part with samples close enough."""
        return self.trajectory

    @property
    def shown_part(self) -> str:
        """Which part of the motion that is, as a sentence; empty for all of it, or where it goes without saying."""
        return ""

    @property
    def mechanics(self) -> Mechanics | None:
        """What energy and momentum of an attitude history of this body are made of; None where it tells no energy."""
        return None

    def as_json_dict(self) -> dict[str, Any]:
        """Return the answers, with how the motion ended and how well it keeps what it should."""
        trajectory = self.trajectory
        ends = {
            "status": str(trajectory.outcome), "drift": trajectory.drift,
            "state_error_estimate": trajectory.error_estimate,
        }  # fmt: skip
        return super().as_json_dict() | plain(ends)


def plain(value: Any) -> Any:
    """Return nested data as JSON has it; numbers that are not finite become None."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, bool | str) or value is None:
        return value
    if np.ndim(value):
        return plain(np.asarray(value).tolist())
    if isinstance(value, int | np.integer):
        return int(value)
    number = float(value)
    return number if math.isfinite(number) else None
