"""``polhode judge FILE``: is a physics engine right, by the states that it wrote."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.publish import publish
from polhode.testing.judge import judge_file


def run_judge(path: Path, json: bool, out: Path | None, spec: Path | None) -> None:
    """Judge the file, draw where asked for, and print the verdicts."""
    publish(judge_file(path, spec), json, figures=out)
