"""Checks that every kind of motion must pass."""

from __future__ import annotations

import json
import pickle
import re
import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput, one_line, shown
from polhode.formats.dataset_reading import read_dataset
from polhode.kinds.added_figures import FILE_NAME
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.page import page_of_report
from polhode.kinds.panel import KindPanel
from polhode.kinds.reading import build_spec
from polhode.motion._trajectory import Trajectory
from polhode.reports.answer import Answer, Table, collect_values, plain
from polhode.reports.base import MotionReport, SystemReport
from polhode.reports.wording import round_words
from polhode.spec.models import SystemTable
from polhode.spec.parsing import read_tables
from polhode.testing._pickling import find_what_is_not_pickled
from polhode.testing.laws import LawBroken

VECTORS = ("attitude", "momentum", "angular_velocity")
BY_NAME = ("invariants", "balances", "received", "observed")
ANY_BODY = {"body", "axis", "sphere", "poinsot"}  # panels that the page's own script makes
NAME = re.compile(r"[a-z]+(-[a-z]+)*")


class KindLimits(NamedTuple):
    """A tolerance of these checks."""

    max_drift: float = 1e-9  # of what is conserved or balanced: no example is long


LIMITS = KindLimits()


def check_kind(kind: AbstractKind[Any]) -> None:
    """Check a kind by its example: spec, report, JSON, figures, motion, dataset and page.

    Args:
        kind: any; the registry must find it by its name, as the folder of a kind or an entry point is.

    Raises:
        LawBroken: naming the first law that fails.
        InvalidInput: for anything but a kind, and where the example is refused.
        NotConverged: where the example's motion cannot be followed.

    >>> from polhode.kinds.registry import default_kind
    >>> check_kind(default_kind())
    """
    check.instance("kind", kind, AbstractKind, "an object of a subclass of AbstractKind, as KIND is")
    _check_parts(kind)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "example.toml"
        path.write_text(kind.example, "utf-8")
        spec = _check_spec(kind, path)
        report = spec.report()
        _check_words(kind, report)
        _check_json(kind, report)
        _check_answers_without_motion(kind, spec, report)
        _check_figures(kind, report, Path(folder))
        _check_kept(report)
        if kind.has_motion:
            if not isinstance(report, MotionReport):
                raise LawBroken("a kind with a motion reports on one: derive from MotionReport.")
            _check_motion(kind, spec, report)
            _check_digits(report)
            _check_dataset(report, Path(folder))
            if kind.has_pictures:
                _check_page(spec, report, Path(folder))
            else:
                _check_no_page(kind)


def _check_parts(kind: AbstractKind) -> None:
    home = type(kind).__module__
    try:
        example = kind.example
    except (OSError, TypeError, AttributeError) as error:
        why = f"a kind is a folder with __init__.py and example.toml; {home} has none: {error}."
        raise LawBroken(why) from None
    _require(example.strip(), "the example is a spec; it is empty")
    table = getattr(kind, "table", None)
    right = isinstance(table, type) and issubclass(table, SystemTable)
    _require(right, f"`table` is a class derived from SystemTable; got {shown(table)}")
    _require(isinstance(kind.figures(), Mapping), f"`figures` returns a mapping; got {shown(kind.figures())}")
    panel = kind.panel()
    _require(panel is None or isinstance(panel, KindPanel), f"`panel` returns a KindPanel or None; got {shown(panel)}")


def _require(holds: Any, law: str) -> None:
    if not holds:
        raise LawBroken(f"{law}.")


def _check_spec(kind: AbstractKind, path: Path) -> Spec:
    _require(NAME.fullmatch(kind.name), f"a name is words with hyphens; got {shown(kind.name)}")
    tables = read_tables(path)
    spec = build_spec(tables, path)
    _require(spec.kind is kind, f"the example is of the kind named {kind.name}; it is of {spec.kind.name}")
    _require(isinstance(spec.system, kind.table), "the table [system] is read by the kind's `table`")
    system = tables.get("system", {"kind": kind.name})
    system = system if isinstance(system, dict) else {"kind": system}
    try:
        build_spec({**tables, "system": {**system, "nonsense": 1}}, path)
    except InvalidInput as error:
        said = str(error)
    else:
        said = "nothing"
    named = ".nonsense: unknown key" in said
    _require(named, f"an unknown key in [system] is refused by its name; it said {said}")
    return spec


def _check_words(kind: AbstractKind, report: SystemReport) -> None:
    said = [report.summary, *report.notes]
    same = plain(collect_values(report.iterate_answers())) == plain(collect_values(report.answers))
    _require(same, "`iterate_answers` yields what `answers` says, in whatever order")
    for group in report.answers:
        rows = group.cells if isinstance(group, Table) else group.lines
        said += [group.title, *(cell for row in rows for cell in row)]
    _require(report.kind == kind.name, f"the report's `kind` is the kind's name; got {shown(report.kind)}")
    _require(report.summary.endswith("."), f"the summary is of sentences; got {shown(report.summary)}")
    wrong = [words for words in said if re.search(r"\b(nan|inf|None)\b", words)]
    _require(not wrong, f"no line says nan, inf or None; got {shown(wrong[:1])}")


def _check_json(kind: AbstractKind, report: SystemReport) -> None:
    values = json.loads(report.json())
    _require(values["kind"] == kind.name, f"the JSON's `kind` is the kind's name; got {shown(values['kind'])}")
    _require(values.pop("units"), "some answers have units")
    for name in report.units():
        *levels, last = name.split(".")
        branch = values
        for level in levels:
            _require(isinstance(branch, dict) and level in branch, f"units are of answers; there is none called {name}")
            branch = branch[level]
        # a unit of a table is that of each of its rows
        rows = branch if isinstance(branch, list) else [branch, *branch.values()]
        _require(any(isinstance(row, dict) and last in row for row in rows),
                 f"units are of answers; there is none called {name}")


def _check_answers_without_motion(kind: AbstractKind, spec: Spec, report: SystemReport) -> None:
    whole = report.as_json_dict()
    for group in kind.answers_without_motion(spec):
        for name, value in plain(collect_values([group])).items():
            inside = value if isinstance(value, dict) else {}
            same = whole.get(name) == value or (inside and all(whole[name][key] == inside[key] for key in inside))
            _require(same, f"what takes no motion is what the report says; {name} differs")


def _check_figures(kind: AbstractKind, report: SystemReport, folder: Path) -> None:
    names = tuple(kind.figures())
    _require(names == tuple(kind.figure_names), f"`figures` has the names of `figure_names`; got {names}")
    unfit = [name for name in names if not FILE_NAME.fullmatch(name)]
    _require(not unfit, f"names of figures are words in small letters joined by _, as files have them; got {unfit}")
    written = report.draw(folder)
    _require(not names or written, "the example has a figure")
    _require({path.stem for path in written} <= set(report.figures()), "each figure has a name of `figure_names`")


def _check_kept(report: SystemReport) -> None:
    why = find_what_is_not_pickled("report", report)
    _require(not why, f"a report can be pickled, as commands keep it; {why}")
    try:
        again = pickle.loads(pickle.dumps(report))
    except Exception as error:  # of any __setstate__ and constructor
        raised = f"{type(error).__name__}: {one_line(str(error))}"
        raise LawBroken(f"a report can be read again after it is pickled; it raises {raised}.") from error
    same = again.as_json_dict() == report.as_json_dict()
    _require(same, "a report is the same after it is pickled, as commands keep it")


def _check_motion(kind: AbstractKind, spec: Spec, report: MotionReport) -> None:
    trajectory, moved = report.trajectory, spec.motion()
    _require(trajectory.drift, "something is conserved or balanced, and its drift is reported")
    for name, drift in trajectory.drift.items():
        largest = float(np.max(drift))
        _require(largest < LIMITS.max_drift, f"{name} stays in the example; it drifts by {largest:.3g}, relative")
        known = trajectory.invariants.keys() | trajectory.balances.keys()
        _require(name in known, f"each drift is of an invariant or a balance; {name} is neither")
    same = np.array_equal(moved.trajectory.states, trajectory.states)
    _require(same, "`motion` gives the motion of the report, to the bit")
    turns = moved.trajectory.attitude is not None
    _require(turns == kind.has_attitude, "`has_attitude` says whether there are attitudes")
    both = moved.mechanics, report.mechanics
    _require((both[0] is None) == (both[1] is None), "`motion` gives the mechanics of the report")
    frames = moved.trajectory.frame, trajectory.frame
    _require((frames[0] is None) == (frames[1] is None), "`motion` gives the frame of the report")


def _check_digits(report: MotionReport) -> None:
    """Check the report's error of the motion: that there is an estimate of it, and no digits beyond it.

    Answers that change with the states after the first come from the motion.
    """
    trajectory = report.trajectory
    if trajectory.motion is not None:
        return
    said = any("without an error estimate" in note for note in report.notes)
    _require(trajectory.error_estimate is not None or said,
             "a motion by steps has an error estimate, or a note says \"without an error estimate\"")
    plainly = replace(report, trajectory=replace(trajectory, error_estimate=None))
    bent = replace(plainly, trajectory=_bend(plainly.trajectory))
    known = {answer.name: plain(answer.value) for answer in _answers(plainly)}
    for answer in _answers(bent):
        shown_digits = bool(answer.name and answer.label and answer.words)
        if shown_digits and known.get(answer.name) != plain(answer.value):
            _require(round_words(answer.words or "", None) == answer.words,
                     "an answer that changes with the motion has the motion's error, by `from_motion`; "
                     f"{answer.name} has not")
    numbers = set(re.findall(r"[\d.e]*\d", bent.summary)) - set(re.findall(r"[\d.e]*\d", plainly.summary))
    finer = [number for number in numbers if round_words(number, None) != number]
    _require(not finer, f"a summary has no digits beyond the motion's error, by `rounded`; it has {finer}")


def _answers(report: SystemReport) -> list[Answer]:
    return [answer for group in report.answers if not isinstance(group, Table) for answer in group.answers]


def _bend(trajectory: Trajectory) -> Trajectory:
    """Return a motion whose samples after the first are off by a hundredth."""
    rng = np.random.default_rng(1)

    def moved(values: Any) -> Any:
        if values is None:
            return None
        values = np.array(values)
        later = values[1:]
        later *= 1.0 + 0.01 * rng.uniform(-1.0, 1.0, later.shape)
        return values

    states = {name: moved(getattr(trajectory, name)) for name in ("states", *VECTORS)}
    if trajectory.attitude is not None:
        unit = states["attitude"] / np.linalg.norm(states["attitude"], axis=-1, keepdims=True)
        states["attitude"] = unit
        if trajectory.layout.names[:1] == ("attitude",):
            states["states"][..., :4] = unit
    by_name = {name: {key: moved(x) for key, x in getattr(trajectory, name).items()} for name in BY_NAME}
    return replace(trajectory, **states, **by_name)


def _check_dataset(report: MotionReport, folder: Path) -> None:
    dataset, wanted = read_dataset(report.save(folder / report.data_file)), report.trajectory
    _require(np.array_equal(dataset.times, wanted.times), "a dataset gives the times back, to the bit")
    _require(dataset.outcome == wanted.outcome, "a dataset gives the outcome back")
    for part in dataset.layout.parts:
        _require(np.array_equal(dataset.part(part.name), wanted.part(part.name)), f"a dataset gives {part.name} back")
    for name in wanted.invariants | wanted.balances:
        _require(dataset.quantity(name).unit == wanted.quantity(name).unit, f"a dataset gives the unit of {name} back")


def _check_no_page(kind: AbstractKind) -> None:
    try:
        kind.check_page()
    except InvalidInput:
        return
    raise LawBroken("a kind with neither attitude nor panel refuses a page, by `check_page`.")


def _check_page(spec: Spec, report: MotionReport, folder: Path) -> None:
    page = page_of_report(report, folder / "page.html", surface=spec.surface).read_text("utf-8")
    match = re.search(r'id="motion">(.*?)</script>', page, re.DOTALL)
    assert match is not None
    data = json.loads(match[1])
    types = {panel["type"] for panel in data["panels"]}
    panels = ANY_BODY | set(re.findall(r"polhodePanels \?\?= \{\}\)\.(\w+) =", page))
    _require(types and types <= panels, f"panel.js makes each panel of the page; none makes {sorted(types - panels)}")
    _require(data["name"] == spec.name and data["summary"], "a page has the spec's name and the report's summary")
