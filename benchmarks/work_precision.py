"""Error against CPU seconds of public calls: ``python benchmarks/work_precision.py [PICTURE] [--quick]``.

What users of polhode, heyoka, diffrax and SciPy call, for one motion and for 400 copies at once, to t = 20. Errors are
the largest of all components at the end, against motions with twice as many digits (order 40 where the rates have no
such digits). Each point is the median of five calls after one that compiles, on one core, and of three that take more
than a second. The picture is that of the docs. ``--table FILE`` draws what was printed before; ``--only NAME`` measures
one system, ``--quick`` takes few copies, one system and three tolerances.
"""

from __future__ import annotations

import argparse
import os
import statistics
import warnings
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false")

import heyoka_peer
import matplotlib.pyplot as plt
import numpy as np
from callers import dop853, dopri8, find_exact, make_copies, off, simulated
from cases import Case, cases
from measure import seconds

import polhode as ph
from polhode.integrators import LieMidpoint, Splitting

PICTURE = Path(__file__).resolve().parents[1] / "docs" / "images" / "work_precision.png"
SYSTEMS = "free body", "heavy top", "Manakov's body of so(6)", "chain of eight spins", "Toda, four"
SPAN, COPIES, TURNS = 20.0, 400, 5
LONG_CALL, LONG_TURNS = 1.0, 3  # s; one is not enough, as even a second call may still prepare something
TOLERANCES = 10.0 ** -np.arange(4.0, 15.0, 2.0)
STEPS = 0.4 * 2.0 ** -np.arange(0.0, 4.0)
SERIES, KNOWN, HEYOKA = "polhode", "polhode, with its error estimate", "heyoka"
EQUAL, DOPRI8, DOP853 = "polhode, equal steps", "diffrax Dopri8", "SciPy DOP853"
STYLES = {
    SERIES: ("tab:red", "-"), KNOWN: ("tab:red", "--"), EQUAL: ("tab:purple", "-"), HEYOKA: ("tab:orange", "-"),
    DOPRI8: ("black", "-"), DOP853: ("tab:blue", "-"),
}  # fmt: skip


class Point(NamedTuple):
    """CPU seconds of a copy, and its error."""

    time: float
    error: float


Curves = dict[tuple[str, int], dict[str, list[Point]]]  # by system and number of copies, then by library


def find_curves(case: Case, starts: np.ndarray, quick: bool) -> Iterator[tuple[str, list[Point]]]:
    """Yield the points of each library."""
    exact, peer = find_exact(case, starts, SPAN), heyoka_peer.one if len(starts) == 1 else heyoka_peer.many
    run = partial(simulated, case, starts, SPAN)
    tolerances = TOLERANCES[:: 2 if quick else 1]
    yield SERIES, measure(run, tolerances, exact)
    yield KNOWN, measure(partial(run, known=True), tolerances, exact)
    yield HEYOKA, measure(peer(case, starts, SPAN), tolerances, exact)
    yield DOPRI8, measure(dopri8(case, starts, SPAN), tolerances, exact)
    if len(starts) == 1:
        way: dict[str, Any] = (
            {"method": Splitting, "order": 8} if hasattr(case.system, "flows") else {"method": LieMidpoint, "order": 4}
        )
        yield EQUAL, measure(lambda step: run(step=float(step), **way), STEPS[:: 2 if quick else 1], exact)
        yield DOP853, measure(dop853(case, starts, SPAN), tolerances, exact)


def measure(run: Callable[[Any], np.ndarray], choices: Iterable[float], exact: np.ndarray) -> list[Point]:
    """Return the points of a caller; tolerances that it cannot meet have none."""
    points = []
    for choice in choices:
        try:
            found = run(choice)
        except ph.NotConverged:
            continue
        times = [seconds(partial(run, choice))]
        times += [seconds(partial(run, choice)) for _ in range((TURNS if times[0] < LONG_CALL else LONG_TURNS) - 1)]
        points.append(Point(statistics.median(times) / len(found), off(found, exact)))
    return points


def draw(found: Curves, path: Path) -> None:
    """Write the picture: a row of each system, one motion on the left, many on the right."""
    names = list(dict.fromkeys(name for name, _ in found))
    figure, axes = plt.subplots(len(names), 2, figsize=(9.0, 2.7 * len(names) + 0.8), layout="constrained",
                                sharey="row", sharex=True, squeeze=False)  # fmt: skip
    for (name, count), curves in found.items():
        axis = axes[names.index(name), 0 if count == 1 else 1]
        for who, points in curves.items():
            colour, line = STYLES[who]
            axis.loglog([p.time for p in points], [p.error for p in points], line, color=colour, marker=".", label=who)
        axis.set_title(f"{name}, {'one' if count == 1 else f'each of {count}'}", fontsize=10)
        axis.grid(alpha=0.3)
    for row in axes:
        row[0].set_ylabel("largest error")
    for axis in axes[-1]:
        axis.set_xlabel("CPU time of a motion [s]")
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3, frameon=False)
    figure.savefig(path, dpi=110)


def read_table(text: str) -> Curves:
    """Return the points of printed rows, the last of each."""
    found: Curves = {}
    for row in (line.split(" | ") for line in text.splitlines()[2:] if ": " in line):
        name, count, who, points = (cell.strip("| ") for cell in row)
        pairs = (point.split(": ") for point in points.split(", "))
        found.setdefault((name, int(count)), {})[who] = [Point(float(time), float(error)) for time, error in pairs]
    return found


def main() -> None:
    """Measure, print every point and draw."""
    given = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    given.add_argument("picture", type=Path, nargs="?", default=PICTURE)
    given.add_argument("--table", type=Path, help="what was printed before, to draw it")
    given.add_argument("--only", choices=SYSTEMS, help="one of them")
    given.add_argument("--quick", action="store_true", help="to try it out")
    options = given.parse_args()
    if options.table:
        draw(read_table(options.table.read_text()), options.picture)
        return
    found: Curves = {}
    chosen = [options.only] if options.only else SYSTEMS[: 1 if options.quick else None]
    print("| system | copies | by | CPU s of a copy: error, at each tolerance or step |\n|---|---|---|---|")
    for case in (case for case in cases() if case.name in chosen):
        copies = make_copies(case, 16 if options.quick else COPIES)
        for count in (1, len(copies)):
            curves = found[case.name, count] = {}
            for who, points in find_curves(case, copies[:count], options.quick):
                curves[who] = points
                told = ", ".join(f"{p.time:.2g}: {p.error:.1g}" for p in points)
                print(f"| {case.name} | {count} | {who} | {told} |", flush=True)
    draw(found, options.picture)


if __name__ == "__main__":
    warnings.filterwarnings("ignore", message="a step of")
    main()
