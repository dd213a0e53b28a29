"""``polhode sweep SPEC``: many motions, with numbers of the spec varied, into one Zarr store."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from polhode.cli.publish import publish
from polhode.cli.stopping import Stopped
from polhode.errors import InvalidInput
from polhode.reports.answer import Answer, Group
from polhode.reports.report import PlainReport
from polhode.reports.wording import in_its_unit
from polhode.sweeps.answers import SweepReport
from polhode.sweeps.layout import import_zarr
from polhode.sweeps.plan import read_plan
from polhode.sweeps.running import Sweep
from polhode.sweeps.store import Store, check_room, in_bytes


class SweepOptions(NamedTuple):
    """Options of the command; see there."""

    out: Path | None
    workers: int | None
    scheduler: str | None
    dry_run: bool
    json: bool
    no_figures: bool


def run_sweep(path: Path, options: SweepOptions) -> None:
    """Read the plan, compute the missing samples, print the statistics and draw them."""
    plan = read_plan(path)
    if not options.dry_run:
        import_zarr()  # a missing library is reported before samples are tried
    sweep = Sweep.of(plan)
    out = options.out or Path(f"{path.stem}.zarr")
    seconds = sweep.cost()
    workers = options.workers or sweep.usual_workers(seconds)
    if options.dry_run:
        _print_cost(sweep, out, seconds, workers, options)
        return
    folder = _figures_folder(out)
    if not options.no_figures and folder.exists() and not folder.is_dir():
        raise InvalidInput(f"{folder}: is a file, where the figures' folder is needed. Choose another name with --out, "
                           "or leave the figures out with --no-figures.")
    store = sweep.begin(out)
    try:
        with _progress(sweep, store) as tell:
            sweep.run(store, workers, options.scheduler, tell)
    except Stopped:
        done = len(store.list_finished()) if store.home.is_dir() else 0
        kept = f"polhode: {done} of {sweep.chunks} chunks are finished and kept; the same command goes on from there.\n"
        sys.stderr.write(kept if done else "")
        raise
    report = SweepReport(sweep, store)
    publish(report, options.json, figures=None if options.no_figures else folder, written=[str(out)])


@contextmanager
def _progress(sweep: Sweep, store: Store) -> Iterator[Callable[[int], object]]:
    """Show progress, speed and remaining time on a terminal."""
    from tqdm import tqdm

    done = sum(high - low for low, high in map(sweep.layout.sample_range, store.list_finished()))
    if not sys.stderr.isatty():
        yield _Lines(done, sweep.plan.design.count).add
        return
    with tqdm(total=sweep.plan.design.count, initial=done, unit=" samples", unit_scale=True, dynamic_ncols=True) as bar:
        yield bar.update


class _Lines:
    """A line about the progress once a minute, for logs."""

    interval = 60.0  # s

    def __init__(self, done: int, total: int) -> None:
        self.first, self.done, self.total = done, done, total
        self.begun = self.written = time.monotonic()

    def add(self, samples: int) -> None:
        self.done += samples
        now = time.monotonic()
        if now - self.written < self.interval or self.done >= self.total:
            return
        self.written, rate = now, (self.done - self.first) / (now - self.begun)
        left = in_its_unit(float(f"{(self.total - self.done) / rate:.2g}"))
        sys.stderr.write(f"{self.done:,} of {self.total:,} samples, {rate:.3g} a second, about {left} left\n")
        sys.stderr.flush()


def _figures_folder(out: Path) -> Path:
    """Return the folder beside a store, whose name may follow ``.`` or ``..``.

    Raises:
        InvalidInput: if no name is given.
    """
    named = out if out.name not in ("", "..") else out.resolve()
    if not named.name:
        raise InvalidInput(f"{out}: has no name that a store could have. Choose another with --out, like runs.zarr.")
    return named.with_name(f"{named.stem}_figures")


def _print_cost(sweep: Sweep, out: Path, seconds: float, workers: int, options: SweepOptions) -> None:
    """Print the cost of the sweep; nothing is written."""
    check_room(out, sweep.bytes)
    design, each = sweep.plan.design, sweep.evaluator.chunk_size
    many = f"{sweep.chunks:,} of {each:,} samples"
    wall = float(f"{seconds / workers:.2g}")
    group = Group("Cost", [
        Answer("samples", design.count, "", "samples", "", f"{design.count:,}"),
        Answer("chunks", sweep.chunks, "", "chunks", "", many),
        Answer("computed_at_once", sweep.evaluator.at_once, "", "computed", "",
               "many at once" if sweep.evaluator.at_once else "one by one, a report on each"),
        Answer("cpu_time", seconds, "s", "CPU time, about", "", in_its_unit(float(f"{seconds:.2g}"))),
        Answer("workers", workers, "", "workers here") if options.scheduler is None else Answer("", None),
        Answer("wall_time", seconds / workers, "s", "wall time then, about", "", in_its_unit(wall))
        if options.scheduler is None else Answer("", None),
        Answer("store_size", sweep.bytes, "B", "store, at most", "", in_bytes(sweep.bytes)),
        Answer("chunk_memory", sweep.chunk_bytes, "B", "memory for a chunk's arrays", "", in_bytes(sweep.chunk_bytes)),
    ])
    report = PlainReport(sweep.plan.path.stem, "sweep-cost", "Nothing is computed in a dry run.", [group])
    publish(report, options.json)

