"""Reports on a system, and on its motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.analysis._mechanics import Mechanics
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import motion_error
from polhode.reports.answer import plain
from polhode.reports.report import Report
from polhode.reports.wording import round_words

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Drawings = Mapping[str, "Callable[[Any], Figure | None]"]


@dataclass(frozen=True, kw_only=True)
class SystemReport(Report):
    """A report on the system of a spec.

    Attributes:
        kind: the system, as a spec names it.
        name: of the body, in the spec.
        drawings: returns the functions that draw the figures; ``Spec.report`` fills in name and drawings.
    """

    kind: ClassVar[str]
    name: str = ""
    drawings: Callable[[], Drawings] | None = None

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        drawings = {} if self.drawings is None else self.drawings()
        return {name: partial(draw, self) for name, draw in drawings.items()}


def make_placeholder(kind: type) -> Any:
    """Return a placeholder for an object that a partial report does not need; any use of it is an error."""

    class LeftOut(kind):
        def __getattribute__(self, name: str) -> Any:
            if name.startswith("__"):
                return super().__getattribute__(name)
            raise AssertionError(f"an answer asks for `{name}` of a {kind.__name__} that was left out")

    return tuple.__new__(LeftOut) if issubclass(kind, tuple) else object.__new__(LeftOut)


WITHOUT_MOTION: Trajectory = make_placeholder(Trajectory)


class MotionReport(SystemReport):
    """Answers about one motion of one system.

    Attributes:
        kind: the system, as a spec names it.
        trajectory: its samples.
    """

    trajectory: Trajectory
    data_file: ClassVar[str] = "motion.nc"

    def _write_data(self, path: Path) -> Path:
        from polhode.formats.form import Content
        from polhode.formats.saving import write_content

        return write_content(Content(self.name, None, self.trajectory, self.shown), path)

    @property
    def shown(self) -> Trajectory:
        """The motion for figures and pages: all of it, or a part that is sampled closely enough."""
        return self.trajectory

    @property
    def shown_part(self) -> str:
        """A sentence on which part of the motion ``shown`` is; empty where it is all of it."""
        return ""

    def rounded(self, words: str) -> str:
        """Return a text about the motion without digits finer than its error."""
        return round_words(words, motion_error(self.trajectory))

    @property
    def mechanics(self) -> Mechanics | None:
        """The mechanics from which energy and momentum of an attitude history follow; None where there is no energy."""
        return None

    def as_json_dict(self) -> dict[str, Any]:
        """Return the answers, with the outcome of the motion and its drift."""
        trajectory = self.trajectory
        ends = {
            "status": str(trajectory.outcome), "drift": trajectory.drift,
            "state_error_estimate": trajectory.error_estimate,
        }  # fmt: skip
        return super().as_json_dict() | plain(ends)
