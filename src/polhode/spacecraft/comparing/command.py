"""``polhode compare A B``: how two attitude histories differ."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from polhode.cli.column_options import ColumnOptions
from polhode.cli.columns import tables_to_compare
from polhode.cli.naming import as_options
from polhode.cli.publish import publish
from polhode.formats.form import Kernels
from polhode.spacecraft.comparing.clocks import parse_clocks
from polhode.spacecraft.comparing.study import compare_files


def run_compare(
    first: Path, second: Path, json: bool, figures: Path | None, spec: Path | None, kernels: Kernels,
    columns: ColumnOptions, offset: str | None = None, align: bool = False,
) -> None:
    """Read both, compare, draw, and print the answers."""
    parsed = parse_clocks(offset, align)
    report = compare_files(first, second, spec, kernels, tables_to_compare(columns), parsed)
    report = replace(report, clocks=as_options(report.clocks))  # which names the offset
    publish(report, json, figures=figures or Path(f"{first.stem}_and_{second.stem}"))
