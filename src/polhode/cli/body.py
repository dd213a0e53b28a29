"""``polhode body SPEC``: mass properties alone."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.render import as_json, print_body
from polhode.report import body_json
from polhode.spec.reading import read_spec


def run_body(path: Path, json: bool) -> None:
    """Print the mass properties of the spec's body."""
    spec = read_spec(path)
    values = {"name": spec.name, **body_json(spec.body)}
    if json:
        print(as_json(values))
    else:
        print_body(values)
