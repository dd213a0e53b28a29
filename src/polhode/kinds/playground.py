"""The playground: one page with many motions, each with a few words on what to watch."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import replace
from importlib import resources
from pathlib import Path
from typing import Any

from polhode.kinds.base import Spec
from polhode.kinds.page import page_of_answers, write_page_text
from polhode.kinds.reading import read_spec
from polhode.reports.base import SystemReport
from polhode.viewer.page import Page, make_playground

SAMPLED = ("attitude", "momentum", "velocity", "energy")


def write_playground(
    path: Path, examples: dict[str, Path], report_of: Callable[[Path, Spec], SystemReport] | None = None
) -> Path:
    """Write the playground as one HTML file; the file appears whole or not at all.

    Args:
        path: the file.
        examples: the specs that come with the package, by name.
        report_of: returns the report on a spec, which may have been kept; computed again without it.

    Raises:
        InvalidInput: for a path that cannot be written.
    """
    return write_page_text(make_playground([_preset(words, examples, report_of) for words in presets()]), path)


def presets() -> list[dict[str, Any]]:
    """Return example, title and story of each motion of the playground."""
    text = (resources.files("polhode.viewer") / "playground.toml").read_text("utf-8")
    return tomllib.loads(text)["preset"]


def _preset(
    words: dict[str, Any], examples: dict[str, Path], report_of: Callable[[Path, Spec], SystemReport] | None
) -> tuple[Page, dict[str, Any]]:
    samples = 600  # of motions that the page cannot solve itself
    path = examples[words["example"]]
    spec = read_spec(path)
    spec = spec if spec.kind.in_closed_form else replace(spec, samples=min(spec.samples, samples))
    if "until" in words:
        spec = replace(spec, until=float(words["until"]), samples=samples)
    report = spec.report() if report_of is None else report_of(path, spec)
    page = page_of_answers(report, report.name, spec.picture)
    if page.data["model"] is not None:  # the page solves it from the start, at any time, and needs no samples of it
        data = {name: value for name, value in page.data.items() if name not in SAMPLED}
        page = page._replace(data=data | {"notes": data["notes"][data["notesOnSamples"] :]})
    return page, {"key": words["example"], "title": words["title"], "story": words["story"]}
