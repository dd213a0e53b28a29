"""What a kind of motion is: its table in a spec, its answers, its figures."""

from __future__ import annotations

import abc
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from polhode.bodies.body import Body
from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput, shown
from polhode.formats.labels import AttitudeLabels
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport
from polhode.spec.building import build_spin
from polhode.spec.models import BodyTable, SpinTable, SystemTable
from polhode.spec.rules import Mistake
from polhode.spec.surfaces import surface_of_body

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.viewer.panels import Content
    from polhode.viewer.samples import Samples

Array = Any


class AbstractKind(abc.ABC):
    """A kind of motion that a spec can name as ``[system] kind``.

    A folder of ``polhode.kinds``, or a module that another package names in the entry-point group ``polhode.kinds``,
    offers one object of a subclass as ``KIND``. Importing it must be cheap: the methods import what they need.

    Attributes:
        name: as specs write it; the folder's name has underscores for its hyphens.
        figure_names: of the files of ``figures``, which a later report may remove.
        sources: the classes, as ``module.name``, of systems and motions whose pages show the kind's own pictures.
    """

    name: ClassVar[str]
    figure_names: ClassVar[tuple[str, ...]] = ()
    sources: ClassVar[tuple[str, ...]] = ()

    @property
    @abc.abstractmethod
    def table(self) -> type[SystemTable]:
        """The model of the table [system]."""

    @property
    def example(self) -> str:
        """The folder's ``example.toml``: a short spec of this kind."""
        return self._file("example.toml")

    @abc.abstractmethod
    def report(self, spec: Spec) -> AbstractReport:
        """Return the answers about the motion of a spec of this kind.

        Raises:
            InvalidInput: for values that the system refuses.
            NotConverged: where a motion could not be followed.
        """

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        """Yield what the raw tables of a file break beyond what each field says, and where."""
        yield from ()

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        """Return what draws each figure from a report, by the name of its file; None where there is nothing to see."""
        return {}

    def draw(self, report: AbstractReport, name: str) -> Figure | None:
        """Return one figure of a report of this kind, by the name of its file; None where there is nothing to see.

        Raises:
            InvalidInput: for names that reports of this kind have no figure of.
        """
        figures = self.figures()
        if name not in figures:
            known = ", ".join(figures)
            got = shown(name)
            raise InvalidInput(f"`name` must be one of {known} for a report of kind {self.name}; got {got}.")
        return figures[name](report)

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> Content | None:
        """Return the pictures of a page; None for those that fit any body.

        Args:
            trajectory: whose source is one of ``sources``.
            samples: of it, as the page shows them, along the principal axes.
            surface: of the body, along the axes of the samples.
        """
        return None

    def script(self) -> str:
        """Return the folder's ``panel.js``, which makes the kind's own panels on a page."""
        return self._file("panel.js")

    def _file(self, name: str) -> str:
        return (resources.files(type(self).__module__) / name).read_text("utf-8")

    def surface(self, spec: Spec) -> Surface | None:
        """Return what the body looks like, in the given axes; None where only moments are known.

        Raises:
            InvalidInput: if a file that the body came from is gone since.
        """
        return None if spec.source is None else surface_of_body(spec.source, spec.folder)


@dataclass(frozen=True)
class Spec:
    """A spec in SI units.

    Attributes:
        name: what to call the body.
        kind: what moves.
        system: the table [system], with its defaults.
        body: its mass properties; None where the system has sizes of its own.
        spin: as it stands in the file, None for rest.
        until: end of the samples [s], None for the kind's own choice.
        samples: how many.
        labels: what attitude files say of it.
        source: where the body comes from, as it stands in the file; None where the system has sizes of its own.
        folder: that paths count from.
    """

    name: str
    kind: AbstractKind
    system: Any
    body: Body | None
    spin: SpinTable | None
    until: float | None
    samples: int
    labels: AttitudeLabels = field(default_factory=AttitudeLabels)
    source: BodyTable | None = None
    folder: Path = Path()

    @cached_property
    def surface(self) -> Surface | None:
        """What the body looks like, made when first asked for; see ``AbstractKind.surface``."""
        return self.kind.surface(self)

    @property
    def times(self) -> Array | None:
        """(T,) [s] that the spec asks for, None for the kind's own choice."""
        return None if self.until is None else np.linspace(0.0, self.until, self.samples)

    def start(self, moments: Array, axes: Array) -> tuple[Array, Array]:
        """Return momentum (3,) along, and attitude (4,) of, principal axes by columns in the given ones."""
        return build_spin(self.spin, moments, axes)

    def report(self) -> AbstractReport:
        """Return the answers; see ``AbstractKind.report``."""
        return self.kind.report(self)
