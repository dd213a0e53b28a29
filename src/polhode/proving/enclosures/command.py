"""``polhode certify SPEC``: proved enclosures of a motion in closed form."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from polhode.cli.publish import publish
from polhode.proving.enclosures.study import certify_report


def run_certify(path: Path, digits: int, at: Sequence[str], json: bool) -> None:
    """Print enclosures of a motion's constants, and of its states at the given times."""
    publish(certify_report(path, digits, at), json)
