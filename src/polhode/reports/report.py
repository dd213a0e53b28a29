"""The base class of reports: summary, answers, notes, figures and data in one object."""

from __future__ import annotations

import abc
import html
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from polhode._base.extras import needing
from polhode.errors import InvalidInput, printable, shown
from polhode.formats.figure_file import save_figure
from polhode.formats.opening import record_files
from polhode.formats.paths import as_path, write_together
from polhode.reports.answer import Group, Table, collect_units, collect_values, plain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.bodies.surface import Surface
    from polhode.motion._trajectory import Trajectory
    from polhode.viewer.page import NotebookPage


class Report(abc.ABC):
    """The results of one question: as text, as values by name, as figures and as a data file.

    A notebook shows it as it is; ``values`` has its numbers, ``json`` a text for other programs.

    Attributes:
        name: of its subject.
        kind: of report, like "tumble"; of one on a spec, the system that moves.
        trajectory: the motion, where there is one.
        determined: whether the data sufficed to answer the question.
        data_file: name of the file that ``write`` saves the data under; empty where there are none.
        data_endings: that a file of the data may have; empty where the ending chooses the format, or does not matter.
        inputs: the files that it was made from; they are never overwritten.

    >>> import polhode as ph
    >>> report = ph.tumble("apophis")
    >>> report.kind, round(report.values()["energy_ratio"], 3)
    ('tumble', 1.024)
    """

    name: str
    kind: str
    trajectory: Trajectory | None
    determined: bool = True
    data_file: ClassVar[str] = ""
    data_endings: ClassVar[tuple[str, ...]] = ()
    inputs: Sequence[Path] = ()

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if "__repr__" not in vars(cls):  # a dataclass would write out all of its arrays
            cls.__repr__ = Report.__repr__  # type: ignore[method-assign]
        if "__eq__" not in vars(cls):  # and compare them, which gives an array of truth values
            cls.__eq__, cls.__hash__ = object.__eq__, object.__hash__  # type: ignore[method-assign,assignment]

    def __repr__(self) -> str:
        return f"<{type(self).__name__} on {printable(self.name)}: {printable(self.summary)}>"

    @property
    @abc.abstractmethod
    def summary(self) -> str:
        """The answer in a sentence or two."""

    @property
    @abc.abstractmethod
    def answers(self) -> Sequence[Group | Table]:
        """All answers, by groups and tables, in the order of the text."""

    def iterate_answers(self) -> Iterator[Group | Table]:
        """Yield the answers one after the other, the quickest first, each computed as it is asked for."""
        yield from self.answers

    @property
    def notes(self) -> Sequence[str]:
        """Caveats that a reader should know besides the numbers."""
        return ()

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        """Return the functions that draw the figures, by name; one returns None where there is nothing to draw."""
        return {}

    def save(self, path: str | Path) -> Path:
        """Write the data into a file that appears whole or not at all, and return its path.

        Args:
            path: of a motion, its ending chooses the format, as ``polhode.formats.write_motion`` says; of other data
                it ends as ``data_endings`` says.

        Raises:
            InvalidInput: for a report without data, for another ending, for a path that cannot be written, and for a
                file that the report was made from.
        """
        place = as_path("path", path)
        self._check_spares_inputs(place, "another")
        if self.data_endings and place.suffix.lower() not in self.data_endings:
            wanted = " or ".join(self.data_endings)
            raise InvalidInput(f"{place}: must end in {wanted}, as such data do; got {shown(place.suffix)}.")
        return self._write_data(place)

    def _check_spares_inputs(self, place: Path, remedy: str) -> None:
        # by the file and not by its name, of which some systems take Motion.nc and motion.nc for one
        if taken := [one for one in self.inputs if one.exists() and place.exists() and place.samefile(one)]:
            raise InvalidInput(f"{taken[0]}: is the file that was read; writing would destroy it. Name {remedy}.")

    def _write_data(self, path: Path) -> Path:
        """Write the data, where a kind of report has any, and return the path."""
        raise InvalidInput(f"{path}: a report of kind {self.kind} has no data to save. Its numbers are in json().")

    def values(self) -> dict[str, Any]:
        """Return the answers by name, levels as nested dictionaries, SI units, arrays and infinite numbers included."""
        return collect_values(self.answers)

    def units(self) -> dict[str, str]:
        """Return the units by the names of the answers, explanations after them."""
        return collect_units(self.answers)

    def as_json_dict(self) -> dict[str, Any]:
        """Return all of it as plain lists, numbers, strings and None; undefined or infinite numbers are None."""
        answers = self.answers
        head = {"name": self.name, "kind": self.kind, "summary": self.summary}
        return plain({**head, **collect_values(answers), "units": self.units(), "notes": list(self.notes)})

    def json(self) -> str:
        """Return the JSON as a text in ASCII."""
        return json.dumps(self.as_json_dict(), indent=2, ensure_ascii=True, allow_nan=False)

    def figure(self, name: str) -> Figure | None:
        """Return one figure by its name; None where there is nothing to draw.

        Raises:
            InvalidInput: for a name that this report has no figure of.
        """
        with needing("Figures need"):
            figures = self.figures()
            if name in figures:
                return figures[name]()
        where = f"in a report of kind {self.kind}; got {shown(name)}"
        if not figures:
            raise InvalidInput(f"there are no figures {where}.")
        raise InvalidInput(f"`name` must be one of {', '.join(figures)}, the figures {where}.")

    def plot(self) -> dict[str, Figure]:
        """Return the figures by name, as Matplotlib has them."""
        return dict(self._draw_each())

    def _draw_each(self) -> Iterator[tuple[str, Figure]]:
        """Yield the figures with their names, one at a time for the memory."""
        with needing("Figures need"):
            for name, draw in self.figures().items():
                if (figure := draw()) is not None:
                    yield name, figure

    def show(self, *, name: str | None = None, surface: Surface | None = None, height: int = 760) -> NotebookPage:
        """Return the page of the report's motion for a notebook to show, as ``polhode.show`` does.

        Args:
            name: heading of the page; the subject's name if left out.
            surface: what the body looks like, in the given axes; without it, a shape with the same inertia is drawn.
            height: of the frame [pixels].

        Raises:
            InvalidInput: for a report without a motion, or one whose motion has nothing to draw.
        """
        import polhode  # which hands in the functions that make pages, as reports must not import pages

        return polhode.show(self, name=name, surface=surface, height=height)

    def draw(self, folder: str | Path, *forms: str) -> list[Path]:
        """Write every figure into an existing folder, and return the paths.

        Args:
            folder: of the figures.
            forms: png, svg, pdf, each figure in all of them; png if none is named.
        """
        return [save_figure(figure, Path(folder) / f"{name}.{form}")
                for name, figure in self._draw_each() for form in forms or ("png",)]

    def write(self, folder: str | Path, *forms: str) -> list[Path]:
        """Write the figures and the data into a folder, all or none of them, and return their paths.

        Args:
            folder: of the files; it is made where it is missing.
            forms: of the figures, as ``draw`` has them.

        Raises:
            InvalidInput: if the files cannot be written.
        """
        place = as_path("folder", folder)
        if self.data_file:
            self._check_spares_inputs(place / self.data_file, "another folder")
        with write_together(place) as draft:
            written = self.draw(draft, *forms)
            if self.data_file:
                written.append(self._write_data(draft / self.data_file))
        return [place / path.name for path in written]

    def _repr_html_(self) -> str:
        """Return the text as a notebook shows it."""
        parts = [f"<b>{_escape(self.name)}</b>", f"<p>{_escape(self.summary)}</p>" if self.summary else ""]
        for group in self.answers:
            head = list(group.columns) if isinstance(group, Table) else []
            rows = group.cells if isinstance(group, Table) else group.lines
            if rows:
                parts.append(_html_table(group.title, head, rows))
        return "".join([*parts, *(f"<p><i>Note: {_escape(note)}</i></p>" for note in self.notes)])


ReportT = TypeVar("ReportT", bound=Report)


class StudyReport(Report):
    """A report whose subject is not a single motion."""

    trajectory: Trajectory | None = None


class PlainReport(StudyReport):
    """A report made from given parts."""

    def __init__(
        self, name: str, kind: str, summary: str, answers: Sequence[Group | Table], notes: Sequence[str] = (),
        save: Callable[[Path], Path] | None = None,
    ) -> None:
        """Take the parts; ``save`` writes the data into a file and returns its path."""
        self.name, self.kind = name, kind
        self._summary, self._answers, self._notes, self._save = summary, answers, notes, save

    @property
    def summary(self) -> str:
        return self._summary

    @property
    def answers(self) -> Sequence[Group | Table]:
        return self._answers

    @property
    def notes(self) -> Sequence[str]:
        return self._notes

    def _write_data(self, path: Path) -> Path:
        return super()._write_data(path) if self._save is None else self._save(path)


def with_inputs(make: Callable[[], ReportT]) -> ReportT:
    """Return what ``make`` returns, with the files that it read meanwhile as its ``inputs``."""
    with record_files() as read:
        report = make()
    object.__setattr__(report, "inputs", tuple(read))
    return report


def _html_table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    top = f"<tr>{''.join(f'<th>{_escape(cell)}</th>' for cell in head)}</tr>" if head else ""
    body = "".join(f"<tr>{''.join(f'<td>{_escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f"<table><caption>{_escape(title)}</caption>{top}{body}</table>"


def _escape(text: str) -> str:
    return html.escape(printable(text))
