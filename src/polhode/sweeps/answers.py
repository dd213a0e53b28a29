"""The report on a sweep: statistics, probabilities, sensitivities."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np
from scipy.stats import binomtest

from polhode._base import check
from polhode._base.compiled.threads import available_cores
from polhode.kinds.registry import find_kind
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain
from polhode.sweeps.columns import Column
from polhode.sweeps.evaluation import DONE, STATUS
from polhode.sweeps.marks import Mark
from polhode.sweeps.plan import read_plan
from polhode.sweeps.running import Sweep
from polhode.sweeps.sensitivity import sobol_indices
from polhode.sweeps.store import Store
from polhode.sweeps.summary import Numbers, Summary, join_summaries

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEVELS = (0.05, 0.25, 0.5, 0.75, 0.95)


class AnswerThresholds(NamedTuple):
    """Numbers that decide how statistics are computed.

    Attributes:
        max_exact_samples: up to which quantiles are those of all values; of more, those of the knots of chunks.
        max_words: different ones whose sensitivities are analysed.
    """

    max_exact_samples: int = 2**25
    max_words: int = 50


LIMITS = AnswerThresholds()


def sweep(
    spec: str | Path, store: str | Path | None = None, workers: int | None = None, scheduler: str | None = None
) -> SweepReport:
    """Compute the motions that the table [sweep] of a spec asks for, or those that are missing, into a Zarr store.

    ``xarray.open_zarr`` reads the store. Its bits depend neither on the number of workers
    nor on interruptions. A script that uses several workers needs ``if __name__ == "__main__":`` around its own
    code, as they import it.

    Args:
        spec: a file.
        store: the folder; by default named after the spec, in the present folder.
        workers: processes of this machine; by default one for each core, and this one alone for short sweeps.
        scheduler: address of a Dask scheduler whose workers compute instead, and see the same files.

    Raises:
        InvalidInput: for mistakes in the spec, stores of other sweeps, and where disk or cluster fail.
    """
    check.instance("spec", spec, (str, os.PathLike), "the path of a file")
    if workers is not None:
        workers = check.whole("workers", workers, 1)
    work = Sweep.of(read_plan(spec))
    path = Path(f"{Path(spec).stem}.zarr") if store is None else Path(store)
    count = work.usual_workers() if workers is None and scheduler is None else workers or available_cores()
    begun = work.begin(path)
    work.run(begun, count, scheduler)
    return SweepReport(work, begun)


@dataclass(frozen=True)
class SweepReport(StudyReport):
    """The answers of a sweep.

    Attributes:
        sweep: the plan with its columns.
        store: where the samples are.
    """

    kind: ClassVar[str] = "sweep"
    sweep: Sweep
    store: Store

    @property
    def name(self) -> str:
        return self.sweep.plan.path.stem

    def __repr__(self) -> str:
        return f"<SweepReport: {self.summary} {self.store.path}>"

    @cached_property
    def summaries(self) -> dict[str, Summary]:
        """Each input, output and the status in summary."""
        return {column.name: join_summaries(mark.arrays[column.name].summary for mark in self.marks)
                for column in self.sweep.columns}

    @cached_property
    def marks(self) -> list[Mark]:
        """The marks of all chunks."""
        return list(self.store.marks())

    @property
    def checksum(self) -> str:
        """Of all samples, which depends neither on who computed them nor on interruptions."""
        checksum = hashlib.sha256()
        for mark in self.marks:
            for name, digest in sorted(mark.digests.items()):
                checksum.update(f"{name} {digest}\n".encode())
        return checksum.hexdigest()

    @property
    def outputs(self) -> list[Column]:
        """The outputs with statistics in the report; states at many times have too many numbers."""
        return [column for column in self.sweep.evaluator.columns if len(column.shape) < 2]

    @property
    def status(self) -> dict[str, int]:
        """The number of samples of each status."""
        counts = self.summaries[STATUS]
        assert isinstance(counts, dict)
        return counts

    @property
    def summary(self) -> str:
        count, done = self.sweep.plan.design.count, self.status.get(DONE, 0)
        rest = ", ".join(f"{number:,} {word}" for word, number in self.status.items() if word != DONE)
        system = self.sweep.plan.tables.get("system", {})
        kind = find_kind(str(system.get("kind", "") if isinstance(system, dict) else system))
        done_what = "have a motion" if kind is None or kind.has_motion else "are computed"
        return f"{done:,} of {count:,} samples {done_what}" + (f"; {rest}." if rest else ".")

    @property
    def notes(self) -> list[str]:
        notes = []
        reasons = [reason for mark in self.marks for reason in mark.reasons]
        if reasons:
            number, why = reasons[0]
            notes.append(f"statistics leave out the samples that were not computed. The first of them, sample {number} "
                         f"(from 0): {why.removesuffix('.')}.")
        design = self.sweep.plan.design
        if design.crossed:
            notes.append(f"samples are {design.group} to each of {design.draws:,} base points, for the sensitivities; "
                         "standard errors and intervals count them as independent, which they are not.")
        elif design.points == "sobol":
            notes.append("standard errors and intervals are those of random samples; Sobol' points do better.")
        return notes

    @property
    def answers(self) -> list[Group | Table]:
        mark = self.checksum
        about = Group("Sweep", [
            Answer("samples", self.sweep.plan.design.count, "", "samples"),
            Answer(STATUS, self.status),
            Answer("seed", self.sweep.plan.design.seed, "", "seed"),
            Answer("checksum", mark, "", "checksum of all samples", "SHA-256", f"{mark[:16]}…"),
        ])
        numbers, words, shares = list(self._numbers()), list(self._words()), list(self._sensitivities())
        units = {column.name: column.unit for column in self.outputs}
        return [about, *_tables(numbers, words, shares, units, self.status.get(DONE, 0))]

    def units(self) -> dict[str, str]:
        """Return the units by the names of the answers, and those of the columns."""
        return super().units() | {column.name: column.unit for column in self.sweep.columns if column.unit}

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.sweeps.figures import FIGURES

        return {name: partial(draw, self) for name, draw in FIGURES.items()}

    def _numbers(self) -> Iterator[dict[str, Any]]:
        for column in self.outputs:
            summary = self.summaries[column.name]
            if isinstance(summary, dict):
                continue
            for k, one in enumerate(summary):
                quantiles = self._quantiles(column, k, one)
                yield {
                    "output": column.name + (f".{k + 1}" if column.shape else ""), "count": one.count,
                    "mean": one.mean if one.count else None, "standard_error": one.error,
                    "standard_deviation": one.deviation, "least": one.low if one.count else None,
                    **{f"quantile_{round(100 * level):02d}": q for level, q in zip(LEVELS, quantiles, strict=True)},
                    "largest": one.high if one.count else None,
                }

    def _quantiles(self, column: Column, k: int, one: Numbers) -> list[float | None]:
        if not one.count or self.sweep.plan.keep != "all" or self.sweep.plan.design.count > LIMITS.max_exact_samples:
            return one.quantiles(LEVELS)
        values = self.store.read(column.name).reshape(self.sweep.plan.design.count, -1)[:, k]
        return np.quantile(values[~np.isnan(values)], LEVELS).tolist()

    def _words(self) -> Iterator[dict[str, Any]]:
        for column in self.outputs:
            summary = self.summaries[column.name]
            if not isinstance(summary, dict):
                continue
            known = {word: count for word, count in summary.items() if word}
            total = sum(known.values())
            for word, count in sorted(known.items(), key=lambda item: (-item[1], item[0])):
                low, high = binomtest(count, total).proportion_ci(0.95, "wilson")
                yield {"output": column.name, "value": word, "count": count, "probability": count / total,
                       "low": float(low), "high": float(high)}

    def _sensitivities(self) -> Iterator[dict[str, Any]]:
        design = self.sweep.plan.design
        if not design.crossed:
            return
        for column in self.outputs:
            values = self.store.read(column.name)
            if column.text:
                words = [word for word in np.unique(values) if word][: LIMITS.max_words]
                parts = {f"{column.name} = {word}": np.where(values == "", np.nan, values == word) for word in words}
            elif column.shape:
                parts = {f"{column.name}.{k + 1}": values[:, k] for k in range(column.shape[0])}
            else:
                parts = {column.name: values}
            for name, part in parts.items():
                for indices in sobol_indices(design, part) or ():
                    yield {"output": name, **indices._asdict()}


def _tables(
    numbers: list[dict[str, Any]], words: list[dict[str, Any]], shares: list[dict[str, Any]], units: dict[str, str],
    done: int,
) -> Iterator[Table]:
    """Yield the tables that have rows."""

    def format_cell(name: str) -> Any:
        return lambda row: "–" if row[name] is None else f"{row[name]:.5g}"

    def output(row: dict[str, Any]) -> str:
        unit = units.get(row["output"].rpartition(".")[0] if row["output"] not in units else row["output"], "")
        return f"{row['output']} [{unit}]" if unit else row["output"]

    if numbers:
        columns = {
            "output": output, "mean": _mean,
            "deviation": format_cell("standard_deviation"), "median": format_cell("quantile_50"),
            "5 to 95 %": lambda row: f"{format_cell('quantile_05')(row)} to {format_cell('quantile_95')(row)}",
        }  # fmt: skip
        if any(row["count"] != done for row in numbers):
            columns["samples"] = lambda row: f"{row['count']:,}"
        yield Table("statistics", "Numbers", columns, numbers)
    if words:
        columns = {
            "output": lambda row: row["output"], "": lambda row: row["value"],
            "probability": lambda row: f"{100.0 * row['probability']:.4g} %",
            "95 % interval": lambda row: f"{100.0 * row['low']:.4g} to {100.0 * row['high']:.4g} %",
            "samples": lambda row: f"{row['count']:,}",
        }  # fmt: skip
        yield Table("probabilities", "Words", columns, words)
    if shares:
        columns = {
            "output": lambda row: row["output"], "input": lambda row: row["input"],
            "alone": lambda row: f"{row['first']:.3f} ± {row['first_error']:.3f}",
            "in all": lambda row: f"{row['total']:.3f} ± {row['total_error']:.3f}",
        }  # fmt: skip
        yield Table("sensitivities", "Share of the variance that an input explains (Sobol')", columns, shares)


def _mean(row: dict[str, Any]) -> str:
    return "–" if row["mean"] is None else uncertain(row["mean"], row["standard_error"])
