"""The base class of a kind of motion: its table in a spec, its answers, its figures."""

from __future__ import annotations

import abc
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Generic, NamedTuple, TypeVar

import numpy as np
from pydantic import BaseModel

from polhode._base.plugins import Plugin
from polhode.analysis._mechanics import Mechanics
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.formats.labels import AttitudeLabels
from polhode.kinds.added_figures import figures_of
from polhode.kinds.folder import InFolder
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Group, Table
from polhode.reports.base import MotionReport, SystemReport
from polhode.spec.building import build_coning, build_spin
from polhode.spec.models import BodyTable, SpinTable, SystemTable
from polhode.spec.reach import LIMITS, most_extreme
from polhode.spec.remarks import remarks_on
from polhode.spec.rules import Mistake
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.bodies.surface import Surface
    from polhode.kinds.ensembles import Ensemble, ManySpecs
    from polhode.kinds.panel import KindPanel
    from polhode.motion.base import AbstractMotion
    from polhode.viewer.panels import PageContent
    from polhode.viewer.samples import Samples


NOT_FINITE = re.compile(r"(?<![\w'\"])-?(inf|nan)(?![\w'\"])")  # as Python writes it in a sentence


class SpecMotion(NamedTuple):
    """The motion of a spec, without the answers about it.

    Attributes:
        trajectory: its samples.
        mechanics: from which energy and momentum of this body follow; None where it is not known.
    """

    trajectory: Trajectory
    mechanics: Mechanics | None


class NextStep(NamedTuple):
    """A command that a report suggests next.

    Attributes:
        command: of ``polhode``, which takes the spec.
        gives: the command's effect, as the rest of a sentence: "shows the motion".
    """

    command: str
    gives: str


def require_motion_report(report: SystemReport) -> MotionReport:
    """Return the report of a kind that has a motion, as one that has a trajectory."""
    assert isinstance(report, MotionReport), f"a report of kind {report.kind} must be on a motion"
    return report


Figures = Mapping[str, "Callable[[Any], Figure | None]"]
"""The function that draws each figure of a report, or None, by the name of its file."""
Overview = Sequence["tuple[Callable[..., Figure | None], int]"]
"""The pictures of a motion that are drawn side by side, each called with ``axes``, and how many axes each needs."""
TableT = TypeVar("TableT", bound=SystemTable)


class AbstractKind(InFolder, abc.ABC, Generic[TableT]):
    """A kind of motion that a spec can name as ``[system] kind``.

    A folder of ``polhode.kinds``, or a module that a wing names under [kinds] of its ``plugin.toml``, or another
    package in the entry-point group ``polhode.kinds``, offers one object of a subclass as ``KIND``. Importing it must
    be cheap: the other files of its folder are imported when they are needed. What they have under these names is
    used, and a method that needs more than that is overridden:

    ========================  ==================================================================================
    ``answers.py``            ``make_report``, which each kind needs; ``simulate_motion``, ``make_motion``,
                              ``answers_without_motion``, ``begin_motion``, for ``motion``, ``closed_form``,
                              ``answers_without_motion``, ``reports``
    ``figures.py``            ``FIGURES`` and ``OVERVIEW``
    ``panel.py``              ``PANEL``, an object of a subclass of ``KindPanel``
    ``ensemble.py``           ``evaluate_ensemble``
    ``rules.py``              ``find_mistakes``
    ``table.py``              ``model_of`` and ``settle``
    ========================  ==================================================================================

    A system or motion names its kind by ``kind``, so that its pages and ``plot`` show the pictures of this kind.

    Attributes:
        name: as specs write it; the folder's name has underscores for its hyphens.
        table: the model of the table [system].
        figure_names: file names of ``figures``; a later report may remove outdated ones.
        subject: the moving thing in a word, where several kinds compute its motion in different ways.
        in_closed_form: whether the motion is known exactly at any time, without steps.
        has_motion: whether something moves in time, so that its report is a ``MotionReport``.
        has_attitude: whether the motion is that of a body that turns in space.
        is_default: whether a spec without [system] means this kind; of the kinds here one does.
        reach: the largest number that a spec may give, in SI units, and one over the smallest.
    """

    name: ClassVar[str]
    table: ClassVar[type[SystemTable]]
    figure_names: ClassVar[tuple[str, ...]] = ()
    subject: ClassVar[str] = ""
    in_closed_form: ClassVar[bool] = False
    has_motion: ClassVar[bool] = True
    has_attitude: ClassVar[bool] = True
    is_default: ClassVar[bool] = False
    reach: ClassVar[float] = LIMITS.largest

    def __reduce__(self) -> tuple[Callable[[str], AbstractKind], tuple[str]]:
        """Pickle a kind by its module: there is one object of each."""
        return _kind_in, (type(self).__module__,)

    @property
    def example(self) -> str:
        """The folder's ``example.toml``: a short spec of this kind."""
        return self._file("example.toml")

    def model_of(self, raw: dict[str, Any]) -> type[BaseModel]:
        """Return the model that checks a raw [system], with the tables beside it; ``table`` where none is chosen."""
        return self._call("table", "model_of", raw, otherwise=self.table)

    def settle(self, checked: Any) -> TableT:
        """Return the part that a spec keeps of the object of ``model_of``: by default all of it."""
        return self._call("table", "settle", checked, otherwise=checked)

    def report(self, spec: Spec[TableT]) -> SystemReport:
        """Return the answers about a spec of this kind.

        Raises:
            InvalidInput: for values that the system refuses.
            NotConverged: where a motion could not be followed.
            NotImplementedError: where the kind's folder has no ``make_report`` in ``answers.py``.
        """
        make = self._find("answers", "make_report")
        if make is None:
            raise NotImplementedError(f"the kind {self.name} needs `make_report` in answers.py of its folder")
        return make(spec)

    def reports(self, specs: Sequence[Spec[TableT]]) -> Iterator[SystemReport | InvalidInput | NotConverged]:
        """Yield the report on each of many specs of this kind, or why there is none.

        Where ``answers.py`` has ``begin_motion``, copies of one system are followed together.
        """
        if (begin := self._find("answers", "begin_motion")) is not None:
            from polhode.kinds.stepping import report_on_each

            yield from report_on_each(specs, begin)
            return
        for spec in specs:
            try:
                yield spec.report()
            except (InvalidInput, NotConverged) as error:
                yield error

    def motion(self, spec: Spec[TableT]) -> SpecMotion:
        """Return the motion alone: from the report, where ``answers.py`` has no quicker way.

        Raises:
            InvalidInput, NotConverged: as ``report`` does.
        """
        self.check_motion()
        if (simulate := self._find("answers", "simulate_motion")) is not None:
            return simulate(spec)
        report = require_motion_report(self.report(spec))
        return SpecMotion(report.trajectory, report.mechanics)

    def closed_form(self, spec: Spec[TableT]) -> AbstractMotion | None:
        """Return the motion in closed form along the principal axes, from which its states follow at any time.

        None for kinds whose motion is computed by steps.

        Raises:
            InvalidInput: as ``report`` does.
        """
        return self._call("answers", "make_motion", spec)

    def answers_without_motion(self, spec: Spec[TableT]) -> Iterable[Group | Table]:
        """Return the answers that need no trajectory, the quickest first.

        They are computed one after the other as they are asked for.

        Raises:
            InvalidInput: for values that the system refuses.
        """
        return self._call("answers", "answers_without_motion", spec, otherwise=())

    def panel(self) -> KindPanel | None:
        """Return this kind's own pictures of a page; None where the page is that of any body."""
        return self._find("panel", "PANEL")

    def next_steps(self, spec: Spec) -> Sequence[NextStep]:
        """Return the commands that a report of this kind suggests next."""
        return (NextStep("view", "shows the motion"),) if self.has_pictures else ()

    def offers(self, spec: Spec) -> Sequence[NextStep]:
        """Return commands that a report of another kind suggests, because this kind can use its spec; mostly none."""
        return ()

    def check_page(self) -> None:
        """Refuse a page that would have nothing to draw.

        Raises:
            InvalidInput: for a kind without pictures.
        """
        if not self.has_pictures:
            self.check_motion()
            raise InvalidInput(
                f"the system {self.name} has no attitude, and its kind no panel, so that a page has nothing to draw. "
                "Ask for its figures by `polhode report`."
            )

    @property
    def has_pictures(self) -> bool:
        """Whether a page has something to draw: the kind's own panels, or a body that turns."""
        return self.panel() is not None or (self.has_motion and self.has_attitude)

    def check_motion(self) -> None:
        """Refuse a command that needs a motion.

        Raises:
            InvalidInput: for a kind without one.
        """
        if not self.has_motion:
            raise InvalidInput(
                f"the system {self.name} has no motion in time, with samples to show, write or compare. Ask for its "
                "answers and figures by `polhode report`."
            )

    def ensemble(self, samples: ManySpecs, names: Sequence[str], times: Float64[Array, "time"]) -> Ensemble | None:
        """Return answers about many motions at once; None where the kind knows no quicker way than a report on each.

        Args:
            samples: what differs between them.
            names: of answers, as the JSON has them, and of parts of states, after ``states.``.
            times: (T,) [s] of states.
        """
        return self._call("ensemble", "evaluate_ensemble", samples, names, times)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        """Yield violations of rules between keys of a file's raw tables, and where they are."""
        yield from self._call("rules", "find_mistakes", tables, otherwise=())

    def figures(self) -> Figures:
        """Return the functions that draw the figures of a report, by the names in ``figure_names``."""
        return self._find("figures", "FIGURES") or {}

    def overview(self) -> Overview:
        """Return the pictures of ``motion.plot()``; without any, each part of the state is drawn against time."""
        return self._find("figures", "OVERVIEW") or ()

    def shown(self, report: SystemReport) -> Trajectory:
        """Return the motion that the page of a report without a motion shows.

        Raises:
            InvalidInput: where there is nothing to show.
        """
        self.check_page()
        return self._any_panel().shown(report)

    def content_of_report(self, report: SystemReport, samples: Samples, surface: Surface | None) -> PageContent:
        """Return the pictures on the page of a report without a motion of its own; see ``KindPanel.content``."""
        return replace(self._any_panel().content(report, samples, surface), scripts=self._scripts())

    def _any_panel(self) -> KindPanel:
        from polhode.kinds.panel import KindPanel

        return self.panel() or KindPanel()

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> PageContent | None:
        """Return the kind's own pictures of a page; None if it has none. Arguments as ``KindPanel.panels`` has them."""
        panel = self.panel()
        if panel is None:
            return None
        from polhode.viewer.panels import PageContent, choose_content, keeps_motion_of

        # the page goes on by the equations of the class that names the kind, which an heir may have changed
        names_it = next(one for one in type(trajectory.source).__mro__ if "kind" in vars(one))
        model = panel.model(trajectory) if keeps_motion_of((names_it,), trajectory.source) else None
        panels = panel.panels(trajectory, samples, surface)
        if panels is None:
            return replace(choose_content(trajectory.source, samples, surface, trajectory.frame), model=model)
        return PageContent(panels, self._scripts(), model, **panel.plots(trajectory, samples))

    def surface(self, spec: Spec) -> Surface | None:
        """Return the body's surface, in the given axes; None where only moments are known.

        Raises:
            InvalidInput: if a file that the body came from is gone since.
        """
        if spec.source is None:
            return None
        from polhode.spec.surfaces import surface_of_body

        return surface_of_body(spec.source, spec.folder)


def _kind_in(module: str) -> AbstractKind:
    return import_module(module).KIND


@dataclass(frozen=True)
class Spec(Generic[TableT]):
    """A spec in SI units.

    Attributes:
        name: of the body.
        kind: what moves.
        system: the table [system], with its defaults.
        body: its mass properties; None where the system has sizes of its own.
        spin: as given in the file, None for rest.
        until: end of the samples [s]; None lets the kind choose.
        samples: how many.
        labels: metadata for attitude files.
        source: the table that describes the body; None where the system has sizes of its own.
        folder: that relative paths start from.
        instants: times [s], zero first, in place of equal steps up to ``until``, their last.
        body_notes: sentences on how the body was made: repairs and rounding.
        plugins: parts of other packages that it names: kinds, torques, mounts and laws.
    """

    name: str
    kind: AbstractKind[TableT]
    system: TableT
    body: Body | None
    spin: SpinTable | None
    until: float | None
    samples: int
    labels: AttitudeLabels = field(default_factory=AttitudeLabels)
    source: BodyTable | None = None
    folder: Path = Path()
    instants: tuple[float, ...] | None = None
    body_notes: tuple[str, ...] = ()
    plugins: tuple[Plugin, ...] = ()

    @cached_property
    def surface(self) -> Surface | None:
        """The body's surface, made when first asked for; see ``AbstractKind.surface``."""
        return self.kind.surface(self)

    @cached_property
    def picture(self) -> Surface | None:
        """The body's surface as a page draws it, painted if the spec names a look."""
        if self.source is None:
            return self.surface
        from polhode.spec.looks import paint_body

        return paint_body(self.source, self.surface)

    @property
    def times(self) -> Float64[Array, "time"] | None:
        """(T,) [s] that the spec asks for, None for the kind's own choice."""
        if self.instants is not None:
            return np.asarray(self.instants)
        return None if self.until is None else np.linspace(0.0, self.until, self.samples)

    @property
    def remarks(self) -> tuple[str, ...]:
        """Notes for a report on how body and spin were understood."""
        return self.remarks_on_body + remarks_on(self.body, self.spin)

    @cached_property
    def remarks_on_body(self) -> tuple[str, ...]:
        """Notes on how the body was made, and on parts that lie in each other."""
        parts = None if self.source is None else self.source.part
        if self.source is None or parts is None:
            return self.body_notes
        from polhode.spec.part_overlaps import notes_on_places

        return self.body_notes + notes_on_places(parts, self.source.density, self.folder)

    def start(
        self, moments: Float64[Array, "3"], axes: Float64[Array, "3 3"]
    ) -> tuple[Float64[Array, "*spin 3"], Float64[Array, "*turn 4"]]:
        """Return momentum (…, 3) along, and attitude (…, 4) of, principal axes by columns in the given ones.

        Of many starts, where numbers of ``spin`` are arrays.
        """
        if self.spin is not None and self.spin.is_of_a_cone and self.system.cones:
            return build_coning(self.spin, moments, axes)
        return build_spin(self.spin, moments, axes)

    def report(self) -> SystemReport:
        """Return the answers; see ``AbstractKind.report``."""
        with self.within_double_precision():
            report = self.kind.report(self)
            if not isinstance(report, SystemReport):
                name = self.kind.name
                raise InvalidInput(f"`report` of the kind {name} must return a SystemReport; got {shown(report)}.")
            named = replace(report, name=self.name, drawings=partial(figures_of, self.kind))
            self.check_sentences(named)
        return named

    def check_sentences(self, report: SystemReport) -> None:
        """Refuse a report on the spec whose summary or notes would say numbers that are not finite.

        Raises:
            InvalidInput: for these, and for sentences that cannot be made.
        """
        with self.within_double_precision():
            if wrong := NOT_FINITE.search("\n".join([report.summary, *report.notes])):
                raise OverflowError(f"its sentences would say {wrong.group()}")

    def motion(self) -> SpecMotion:
        """Return the motion without the answers; see ``AbstractKind.motion``."""
        with self.within_double_precision():
            return self.kind.motion(self)

    @contextmanager
    def within_double_precision(self) -> Iterator[None]:
        """Raise an error that explains an overflow of double precision on the way to the answers.

        NumPy's warnings are off meanwhile: results that are not finite are refused in the end.
        """
        try:
            with np.errstate(all="ignore"):
                yield
        except (ArithmeticError, np.linalg.LinAlgError) as error:
            until = {} if self.until is None else {"until": self.until}
            tables = {"system": self.system, "body": self.source, "spin": self.spin, "time": until}
            farthest = most_extreme(tables)
            hint = f" Farthest from one {farthest}: check its number and unit." if farthest else ""
            raise InvalidInput(f"numbers on the way to the answers leave double precision ({error}).{hint}") from error
