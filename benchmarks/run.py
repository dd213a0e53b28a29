"""Run all benchmarks and write ``RESULTS.md`` next to this file: ``python benchmarks/run.py``.

Each file in ``measures`` is one; ``--only NAME`` runs one alone and prints it, ``--quick`` takes tiny sizes. All of
them run in one process on one core, ours and the peer by turns; what is told are medians of ratios and their range.
Peers that are not installed are named: ``pip install -e '.[bench]'`` and a Java runtime bring them.
"""

from __future__ import annotations

import argparse
import datetime
import importlib
import importlib.metadata
import os
import platform
import sys
import warnings
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false")
HOME = Path(__file__).parent
PEERS = ("numpy", "scipy", "jax", "diffrax", "numba", "heyoka", "mujoco", "orekit-jpype", "numericalpoissongeometry")


def main() -> None:
    """Run what was asked for."""
    names = sorted(path.stem for path in (HOME / "measures").glob("*.py"))
    options = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    options.add_argument("--quick", action="store_true", help="tiny sizes, to try it out")
    options.add_argument("--only", choices=names, help="one of them, printed")
    chosen = options.parse_args()
    sys.path[:0] = [str(HOME), str(HOME / "measures")]
    import jax

    jax.config.update("jax_enable_x64", True)
    text = list(_head())
    for name in [chosen.only] if chosen.only else names:
        found = importlib.import_module(name)
        title = (found.__doc__ or name).strip()
        part = ["", f"## {title}", "", f"`measures/{name}.py`", "", *_table(found, chosen.quick)]
        print("\n".join(part), flush=True)
        text += part
    if not chosen.only and not chosen.quick:
        results = HOME / "RESULTS.md"
        kept = results.read_text("utf-8").partition(OTHERS)[2] if results.exists() else ""
        results.write_text("\n".join(text) + "\n\n" + OTHERS + kept, "utf-8")


def _table(measure: Any, quick: bool) -> Iterator[str]:
    """Yield the rows of a measure; its pictures, if it has any, come below."""
    rows = list(measure.rows(quick))
    heads = ["work", "peer", "our error", "the peer's", "peer's time / ours", "range", ""]
    if any(row.first for row in rows):
        heads += ["first process, CPU s", "the peer's", "set-up, CPU s", "the peer's"]
    yield f"| {' | '.join(heads)} |"
    yield "|---" * len(heads) + "|"
    for row in rows:
        spread = "" if row.spread is None else f"{_short(row.spread[0])} to {_short(row.spread[1])}"
        cells = [row.work, row.peer, _error(row.ours), _error(row.theirs), _short(row.ratio), spread, row.note]
        cells += [f"{x:.2f}" for x in row.first or ()]
        yield f"| {' | '.join(cells + [''] * (len(heads) - len(cells)))} |"
    if hasattr(measure, "draw") and not quick:
        for path in measure.draw(HOME):
            yield f"\n![{path.stem.replace('_', ' ')}]({path.name})"


def _short(value: float | None) -> str:
    return "" if value is None else f"{value:.2g}" if value < 100.0 else f"{float(f'{value:.2g}'):,.0f}"


def _error(value: float | None) -> str:
    return "" if value is None else f"{value:.1e}"


OTHERS = "## By scripts of their own\n"  # from here on the file is written by hand
HEAD = """\
# Results of the benchmarks

Written by `python benchmarks/run.py`: one process, one core, ours and the peer by turns. Ratios are medians of the
peer's CPU time over ours, above 1 where we are quicker, with their range. Errors of attitudes are angles in rad against
states that are exact to 17 digits; others are the largest of all components.

{when}, {processor}, {system}, Python {python}; {versions}.

What first calls cost is measured by `first_calls.py`, a GPU by `gpu.py`; what other scripts found stands at the end."""


def _head() -> Iterable[str]:
    versions = ", ".join(f"{name} {version}" for name in PEERS if (version := _version(name)))
    yield HEAD.format(when=datetime.date.today(), processor=_processor(), system=platform.system(),
                      python=platform.python_version(), versions=versions)  # fmt: skip


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def _version(name: str) -> str | None:
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return None


if __name__ == "__main__":
    warnings.filterwarnings("ignore", message="a step of")
    main()
