"""``polhode body SPEC``: mass properties alone."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.publish import publish
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.reports.about import about_body
from polhode.reports.report import PlainReport
from polhode.spec.remarks import remarks_on_body


def run_body(path: Path, json: bool) -> None:
    """Print the mass properties of the spec's body."""
    spec = read_spec(path)
    if spec.body is None:
        raise InvalidInput(f"{path}: has no [body]; its system brings sizes of its own. Ask for the report.")
    publish(PlainReport(spec.name, "body", "", [about_body(spec.body)], remarks_on_body(spec.body)), json)
