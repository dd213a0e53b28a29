"""``polhode judge FILE``: is a physics engine right, by the states that it wrote."""

from __future__ import annotations

from pathlib import Path

from polhode.cli.publish import publish
from polhode.cli.terminal import say_if_long
from polhode.errors import InvalidInput
from polhode.judging.judge import judge_file


def run_judge(path: Path, json: bool, figures: Path | None, spec: Path | None) -> None:
    """Judge the file, draw where asked for, and print the verdicts.

    Raises:
        InvalidInput: if every run was refused, after the report has been printed.
    """
    with say_if_long("states that are not right are compared with those of known mistakes, about a minute"):
        report = judge_file(path, spec)
    publish(report, json, figures=figures if report.judgements else None)
    if not report.judgements:
        case, reason = report.refused[0]
        others = " The report says why the others were refused." if len(report.refused) > 1 else ""
        raise InvalidInput(f"{path}: no run could be judged; {case}: {reason}{others}")
