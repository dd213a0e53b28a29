"""``polhode body SPEC``: mass properties alone."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.publish import publish
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.reports.about import about_body, about_place
from polhode.reports.report import PlainReport
from polhode.spec.places import find_place
from polhode.spec.remarks import remarks_on_body


def run_body(path: Path, json: bool, about: str | None) -> None:
    """Print the mass properties of the spec's body, and its inertia about a point, an axis or a part if asked for."""
    spec = read_spec(path)
    if spec.body is None or spec.source is None:
        raise InvalidInput(f"{path}: has no [body]; its system brings sizes of its own. Ask for the report.")
    groups = [about_body(spec.body)]
    if about is not None:
        groups.append(about_place(spec.body, *find_place(about, spec.body, spec.source, spec.folder)))
    notes = (*spec.remarks_on_body, *remarks_on_body(spec.body))
    publish(PlainReport(spec.name, "body", "", groups, notes), json)
