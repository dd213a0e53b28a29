"""What a kind of motion is: its table in a spec, its answers, its figures."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib import import_module, resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from polhode.analysis.mechanics import Mechanics
from polhode.bodies.body import Body
from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.motion.trajectory import Trajectory
from polhode.reports.answer import Group, Table
from polhode.reports.base import MotionReport, SystemReport
from polhode.spec.building import build_spin
from polhode.spec.models import BodyTable, SpinTable, SystemTable
from polhode.spec.reach import REACH, most_extreme
from polhode.spec.remarks import remarks_on
from polhode.spec.rules import Mistake
from polhode.spec.surfaces import surface_of_body
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.spec.rotors import SpecRotor
    from polhode.viewer.panels import Content
    from polhode.viewer.samples import Samples


NOT_FINITE = re.compile(r"(?<![\w'\"])-?(inf|nan)(?![\w'\"])")  # as Python writes it in a sentence


class SpecMotion(NamedTuple):
    """What a spec moves, without the answers about it.

    Attributes:
        trajectory: its samples.
        mechanics: what energy and momentum of this body are made of; None where that is not known.
    """

    trajectory: Trajectory
    mechanics: Mechanics | None


class NextStep(NamedTuple):
    """A command to go on with.

    Attributes:
        command: of ``polhode``, which takes the spec.
        gives: what it does with it, as it goes on from the command: "shows the motion".
    """

    command: str
    gives: str


class Bodies(NamedTuple):
    """Bodies of many samples.

    Attributes:
        moments: (sample, 3) principal moments [kg m²], or (3,) for all.
        axes: (sample, 3, 3) principal axes by columns in the given ones, or (3, 3) for all.
        refused: sample → why there is no such body.
    """

    moments: Float64[Array, "*sample 3"]
    axes: Float64[Array, "*sample 3 3"]
    refused: dict[int, str]


def motion_report_of(report: SystemReport) -> MotionReport:
    """Return the report of a kind that has a motion, as one that has a trajectory."""
    assert isinstance(report, MotionReport), f"a report of kind {report.kind} must be on a motion"
    return report


class ManySpecs(NamedTuple):
    """Samples that differ from one spec by some numbers.

    Attributes:
        spec: of one sample, whose other numbers all share.
        varied: key → values (sample, …) of the spec's numbers that differ, SI.
        bodies: of the samples; None for kinds without a body.
        spec_of: the spec of a sample; raises InvalidInput where it breaks a rule.
    """

    spec: Spec
    varied: Mapping[str, Any]
    bodies: Bodies | None
    spec_of: Callable[[int], Spec]

    @property
    def size(self) -> int:
        """How many samples there are."""
        return len(next(iter(self.varied.values())))


class Ensemble(NamedTuple):
    """What is asked of many samples.

    Attributes:
        values: name of an answer, as the JSON has it → values (sample, …), NaN where it is not defined; of
            ``states.`` and a part of the state, (sample, time, …).
        refused: sample → why there is no such motion.
    """

    values: dict[str, Any]
    refused: dict[int, str]


class AbstractKind:
    """A kind of motion that a spec can name as ``[system] kind``.

    A folder of ``polhode.kinds``, or a module that another package names in the entry-point group ``polhode.kinds``,
    offers one object of a subclass as ``KIND``. Importing it must be cheap: the methods import the other files of the
    folder when they are needed, ``answers``, ``figures`` and ``panel``.

    Attributes:
        name: as specs write it; the folder's name has underscores for its hyphens.
        table: the model of the table [system].
        figure_names: of the files of ``figures``, which a later report may remove.
        sources: the classes, as ``module.name``, of systems and motions that are of this kind, so that their pages
            and ``plot`` show its own pictures.
        subject: what moves, in a word, where other kinds may move the same in another way.
        in_closed_form: whether the motion is known exactly at any time, without steps.
        has_motion: whether something moves in time, so that its report is an ``MotionReport``.
        has_attitude: whether the motion is that of a body that turns in space.
        is_default: whether a spec without [system] means this kind; of the kinds here one does.
        reach: the largest size, in SI, that its spec may give to a number, and one over the smallest.
    """

    name: ClassVar[str]
    table: ClassVar[type[SystemTable]]
    figure_names: ClassVar[tuple[str, ...]] = ()
    sources: ClassVar[tuple[str, ...]] = ()
    subject: ClassVar[str] = ""
    in_closed_form: ClassVar[bool] = False
    has_motion: ClassVar[bool] = True
    has_attitude: ClassVar[bool] = True
    is_default: ClassVar[bool] = False
    reach: ClassVar[float] = REACH

    @property
    def example(self) -> str:
        """The folder's ``example.toml``: a short spec of this kind."""
        return self._file("example.toml")

    def report(self, spec: Spec) -> SystemReport:
        """Return the answers about a spec of this kind, by ``answers.report_of``.

        Raises:
            InvalidInput: for values that the system refuses.
            NotConverged: where a motion could not be followed.
        """
        return self._part("answers").report_of(spec)

    def motion(self, spec: Spec) -> SpecMotion:
        """Return the motion alone, by ``answers.motion_of`` where a kind has one: much may not be needed for it.

        Raises:
            InvalidInput, NotConverged: as ``report`` does.
        """
        self.check_motion()
        answers = self._part("answers")
        if hasattr(answers, "motion_of"):
            return answers.motion_of(spec)
        report = answers.report_of(spec)
        return SpecMotion(report.trajectory, report.mechanics)

    def answers_without_motion(self, spec: Spec) -> Iterable[Group | Table]:
        """Return those of the report's answers that take no motion, by ``answers.answers_without_motion`` where there
        is one; none elsewhere. They are computed one after the other as they are taken, the quickest first.

        Raises:
            InvalidInput: for values that the system refuses.
        """
        answers = self._part("answers")
        return answers.answers_without_motion(spec) if hasattr(answers, "answers_without_motion") else ()

    def next_steps(self, spec: Spec) -> Sequence[NextStep]:
        """Return the commands to go on with from a report of this kind."""
        return (NextStep("view", "shows the motion"),) if self._has_pictures() else ()

    def offers(self, spec: Spec) -> Sequence[NextStep]:
        """Return the commands by which this kind makes something of a spec of another kind; none without a reason."""
        return ()

    def check_page(self) -> None:
        """Refuse a page of what neither moves nor says in ``panel.py`` how it is to be shown.

        Raises:
            InvalidInput: for such a kind.
        """
        if not self._has("panel.py"):
            self.check_motion()

    def _has_pictures(self) -> bool:
        """Whether any page has something to draw: the kind's own panels, or a body that turns."""
        return self._has("panel.py") or (self.has_motion and self.has_attitude)

    def check_motion(self) -> None:
        """Refuse what needs a motion.

        Raises:
            InvalidInput: for a kind without one.
        """
        if not self.has_motion:
            raise InvalidInput(
                f"the system {self.name} has no motion in time, with samples to show, write or compare. Ask for its "
                "answers and figures by `polhode report`."
            )

    def rotor(self, spec: Spec) -> SpecRotor:
        """Return the quantum rotor that a spec's body is, of kinds that have constants of their own with these.

        Raises:
            InvalidInput: for a spec without [body], or a body that is no rotor.
        """
        from polhode.spec.rotors import asked_of, rotor_of_body

        return asked_of(rotor_of_body(spec.body, spec.source, spec.folder)[0])

    def ensemble(
        self, samples: ManySpecs, names: Sequence[str], times: Float64[Array, "time"]
    ) -> Ensemble | None:
        """Return answers about many motions at once, by ``ensemble.ensemble_of`` where a kind has one.

        None where the kind knows no quicker way than a report on each.

        Args:
            samples: what differs between them.
            names: of answers, as the JSON has them, and of parts of states, after ``states.``.
            times: (T,) [s] of states.
        """
        if not self._has("ensemble.py"):
            return None
        return self._part("ensemble").ensemble_of(samples, names, times)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        """Yield what the raw tables of a file break beyond what each field says, and where."""
        yield from ()

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        """Return ``figures.FIGURES``: what draws each figure of a report, or None, by the name of its file."""
        return self._part("figures").FIGURES if self.figure_names else {}

    def overview(self) -> Sequence[tuple[Callable[..., Figure | None], int]]:
        """Return ``figures.OVERVIEW``: what ``motion.plot()`` draws side by side, and how many axes each needs.

        Each takes what is shown and ``axes``; without any, a trajectory is drawn part by part of its state.
        """
        return getattr(self._part("figures"), "OVERVIEW", ()) if self.figure_names else ()

    def shown(self, report: SystemReport) -> Trajectory:
        """Return what moves on the page of a report without a motion of its own, by ``panel.shown_of``.

        Raises:
            InvalidInput: where there is nothing to show.
        """
        self.check_page()
        return self._part("panel").shown_of(report)

    def content_of_report(self, report: SystemReport, samples: Samples, surface: Surface | None) -> Content:
        """Return the pictures on the page of a report without a motion of its own, by ``panel.content_of``.

        Args:
            report: of this kind.
            samples: of what ``shown`` returned.
            surface: of the body, along the axes of the samples.
        """
        return replace(self._part("panel").content_of(report, samples, surface), scripts=self._scripts())

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> Content | None:
        """Return the kind's own pictures of a page, by ``panel.panels_of`` and ``panel.js``; None if it has none.

        By ``panel.plots_of(trajectory, samples)``, where there is one, it brings ``plots`` and ``scatters`` of
        ``Content``. By ``panel.model_of(trajectory)``, where there is one, the page goes on with the motion itself.

        Args:
            trajectory: whose source is one of ``sources``.
            samples: of it, as the page shows them, along the principal axes.
            surface: of the body, along the axes of the samples.
        """
        if not self._has("panel.py"):
            return None
        from polhode.viewer.panels import Content, content_of, moves_as_one_of

        part = self._part("panel")
        # the page goes on by the equations of the source itself, which an heir may have changed
        knows = hasattr(part, "model_of") and moves_as_one_of(self.source_classes(), trajectory.source)
        model = part.model_of(trajectory) if knows else None
        if not hasattr(part, "panels_of"):
            return replace(content_of(trajectory.source, samples, surface), model=model)
        panels = part.panels_of(trajectory, samples, surface)
        more = part.plots_of(trajectory, samples) if hasattr(part, "plots_of") else {}
        return Content(panels, self._scripts(), model, **more)

    def scatters(self, report: MotionReport) -> tuple[dict[str, Any], ...]:
        """Return by ``panel.scatters_of`` what a report's page draws beyond the part that it shows; none without it."""
        if not self._has("panel.py"):
            return ()
        part = self._part("panel")
        return part.scatters_of(report) if hasattr(part, "scatters_of") else ()

    def source_classes(self) -> tuple[type, ...]:
        """Return the classes of ``sources``, of the modules that are loaded: nothing is made of others yet."""
        places = (name.rpartition(".") for name in self.sources)
        return tuple(getattr(sys.modules[module], own) for module, _, own in places if module in sys.modules)

    def _part(self, name: str) -> Any:
        """Return a file of the folder as a module."""
        return import_module(f"{type(self).__module__}.{name}")

    def _has(self, name: str) -> bool:
        """Whether the folder has a file of this name."""
        return (resources.files(type(self).__module__) / name).is_file()

    def _scripts(self) -> tuple[str, ...]:
        return (self._file("panel.js"),) if self._has("panel.js") else ()

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
        instants: times [s], zero first, in place of equal steps up to ``until``, their last.
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
    instants: tuple[float, ...] | None = None

    @cached_property
    def surface(self) -> Surface | None:
        """What the body looks like, made when first asked for; see ``AbstractKind.surface``."""
        return self.kind.surface(self)

    @property
    def times(self) -> Float64[Array, "time"] | None:
        """(T,) [s] that the spec asks for, None for the kind's own choice."""
        if self.instants is not None:
            return np.asarray(self.instants)
        return None if self.until is None else np.linspace(0.0, self.until, self.samples)

    @property
    def remarks(self) -> tuple[str, ...]:
        """What a report should say of how the body and its spin were taken, a note each."""
        return remarks_on(self.body, self.spin)

    def start(
        self, moments: Float64[Array, "3"], axes: Float64[Array, "3 3"]
    ) -> tuple[Float64[Array, "3"], Float64[Array, "4"]]:
        """Return momentum (3,) along, and attitude (4,) of, principal axes by columns in the given ones."""
        return build_spin(self.spin, moments, axes)

    def report(self) -> SystemReport:
        """Return the answers; see ``AbstractKind.report``."""
        with self._within_double_precision():
            found = replace(self.kind.report(self), name=self.name, drawings=self.kind.figures)
            if wrong := NOT_FINITE.search("\n".join([found.summary, *found.notes])):
                raise OverflowError(f"its sentences would say {wrong.group()}")
        return found

    def motion(self) -> SpecMotion:
        """Return the motion without the answers; see ``AbstractKind.motion``."""
        with self._within_double_precision():
            return self.kind.motion(self)

    @contextmanager
    def _within_double_precision(self) -> Iterator[None]:
        """Refuse, in words, what leaves double precision on the way to the answers.

        NumPy says nothing meanwhile: what is not finite in the end is seen there.
        """
        try:
            with np.errstate(all="ignore"):
                yield
        except (ArithmeticError, np.linalg.LinAlgError) as error:
            until = {} if self.until is None else {"until": self.until}
            given = {"system": self.system, "body": self.source, "spin": self.spin, "time": until}
            farthest = most_extreme(given)
            told = f" Farthest from one {farthest}: check its number and unit." if farthest else ""
            raise InvalidInput(
                f"numbers on the way to the answers leave double precision ({error}).{told}"
            ) from error
