"""``polhode body SPEC``: mass properties alone."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.render import as_json, print_report
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.reports.about import about_body
from polhode.reports.answer import values_of
from polhode.reports.base import plain
from polhode.spec.remarks import remarks_on_body


def run_body(path: Path, json: bool) -> None:
    """Print the mass properties of the spec's body."""
    spec = read_spec(path)
    if spec.body is None:
        raise InvalidInput(f"{path}: has no [body]; its system brings sizes of its own. Ask for the report.")
    if json:
        print(as_json({"name": spec.name, **plain(values_of([about_body(spec.body)]))}))
    else:
        print_report(spec.name, "", [about_body(spec.body)], remarks_on_body(spec.body), [])
