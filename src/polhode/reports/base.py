"""Reports on a system, and on its motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.analysis.mechanics import Mechanics
from polhode.errors import InvalidInput, shown
from polhode.motion.trajectory import Trajectory
from polhode.reports.answer import plain
from polhode.reports.report import Report

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Drawings = Mapping[str, "Callable[[Any], Figure | None]"]


@dataclass(frozen=True, kw_only=True)
class SystemReport(Report):
    """What a spec's system is like.

    Attributes:
        kind: the system, as a spec names it.
        name: what the spec calls it.
        drawings: returns what draws each figure from the report; both are filled in by ``Spec.report``.
    """

    kind: ClassVar[str]
    name: str = ""
    drawings: Callable[[], Drawings] | None = None

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        drawings = {} if self.drawings is None else self.drawings()
        return {name: partial(draw, self) for name, draw in drawings.items()}


def make_placeholder(kind: type) -> Any:
    """Return what stands for an object of a class in a report of which no answer that takes it is asked."""

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
        from polhode.formats.dataset import write_dataset

        if path.suffix.lower() != ".nc":
            raise InvalidInput(f"{path}: must end in .nc, as a NetCDF dataset is written; got {shown(path.suffix)}.")
        return write_dataset(self.trajectory, path, {"title": self.name})

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
