"""The plan of a sweep, read from the table [sweep] of a spec."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field, StrictInt, ValidationError

from polhode._base.plugins import Plugin, record_plugins
from polhode.errors import InvalidInput, shown
from polhode.formats.opening import record_files
from polhode.kinds.base import AbstractKind
from polhode.kinds.reading import SWEEP, kind_of_tables, model_of_tables
from polhode.spec.fields import Duration, Flag, one_of
from polhode.spec.keys import number_at
from polhode.spec.mistakes import as_message, list_mistakes
from polhode.spec.models import Strict
from polhode.spec.parsing import read_tables
from polhode.spec.rules import Mistake
from polhode.sweeps.distributions import AbstractPlaced, AbstractRandom, Grid, Reader, read_distribution
from polhode.sweeps.sampling import SOBOL_BITS, Design

STATES = "states."  # before the parts of a state, as outputs
EXAMPLE = '"spin.rate" = { normal = ["120 rpm", "5 rpm"] }'


class PlanThresholds(NamedTuple):
    """Numbers that decide which sweeps are refused.

    Attributes:
        max_samples: of a sweep; more take years.
        max_chunk: samples of a chunk, whose arrays are in memory together.
        many_chunks: of a sweep; beyond that chunks double, as each has a file for each array.
        chunk_at_once: samples of a chunk that is computed at once.
        largest_at_once: samples of a doubled chunk: some seconds of work, and 8 MB an array.
        chunk_by_steps: samples of a chunk that is followed at once by steps, beyond which a sample costs no less.
        largest_by_steps: samples of a doubled one: minutes of work.
        chunk_of_reports: samples of a chunk of reports.
        largest_of_reports: samples of a doubled one: what is lost when a sweep is stopped takes minutes again.
    """

    max_samples: int = 10**10
    max_chunk: int = 10**7
    many_chunks: int = 1024
    chunk_at_once: int = 2**16
    largest_at_once: int = 2**20
    chunk_by_steps: int = 2**10
    largest_by_steps: int = 2**14
    chunk_of_reports: int = 2**6
    largest_of_reports: int = 2**10


LIMITS = PlanThresholds()


def choose_chunk(samples: int, at_once: bool, by_steps: bool = False) -> int:
    """Return how many of a sweep's samples make a chunk, where the spec does not say it."""
    least, largest = LIMITS.chunk_of_reports, LIMITS.largest_of_reports
    if at_once and by_steps:
        least, largest = LIMITS.chunk_by_steps, LIMITS.largest_by_steps
    elif at_once:
        least, largest = LIMITS.chunk_at_once, LIMITS.largest_at_once
    wanted = 2 ** math.ceil(math.log2(samples / LIMITS.many_chunks))
    return min(max(least, min(wanted, largest)), samples)


class SweepTable(Strict):
    """The table [sweep] of a file.

    Attributes:
        samples: how many; of each point, where there are grids.
        seed: of the random numbers.
        inputs: what is varied and how, by key of the spec.
        outputs: what is kept, by name in the report's JSON; or ``states.`` and a part of the state.
        times: of the states [s].
        points: how random inputs are drawn.
        sensitivity: whether Sobol' indices are asked for.
        keep: all outputs, or their statistics alone.
        chunk: samples computed together.
    """

    samples: Annotated[StrictInt, Field(ge=1, le=LIMITS.max_samples)] | None = None
    seed: Annotated[StrictInt, Field(ge=0, le=2**63 - 1)] = 0
    inputs: dict[str, Any] = Field(description=f"say what varies, like {EXAMPLE} under [sweep.inputs]")
    outputs: list[str] = Field(description='say what to keep, like ["regime", "polhode_period"]')
    times: list[Duration] = Field(default_factory=list)
    points: Annotated[Literal["random", "sobol"], one_of("random", "sobol")] = "random"
    sensitivity: Flag = False
    keep: Annotated[Literal["all", "statistics"], one_of("all", "statistics")] = "all"
    chunk: Annotated[StrictInt, Field(ge=1, le=LIMITS.max_chunk)] | None = None


@dataclass(frozen=True, eq=False)
class Plan:
    """The plan of a sweep.

    Attributes:
        path: of the spec.
        tables: of the spec, without [sweep].
        kind: that the spec names.
        design: the inputs of each sample.
        units: of the inputs, "" for plain numbers.
        outputs: names of what is kept.
        times: of states among the outputs [s].
        keep: "all", or "statistics" alone.
        chunk: samples computed together as the spec gives it; None for the usual number.
        asked: what the spec says, as text, without ``chunk``, which is compared separately.
        read: the files that were read for the inputs, with SHA-256 of their content.
        plugins: what was taken of other packages for it.
    """

    path: Path
    tables: dict[str, Any]
    kind: AbstractKind
    design: Design
    units: dict[str, str]
    outputs: tuple[str, ...]
    times: tuple[float, ...]
    keep: str
    chunk: int | None
    asked: str
    read: dict[Path, str]
    plugins: frozenset[Plugin] = frozenset()

    @property
    def states(self) -> tuple[str, ...]:
        """The outputs that are parts of states."""
        return tuple(name for name in self.outputs if name.startswith(STATES))


def read_plan(path: str | Path) -> Plan:
    """Return the plan of the sweep in a spec.

    Raises:
        InvalidInput: naming every mistake of the table [sweep].
        FormatError: if the file is not TOML.
    """
    with record_plugins() as plugins:
        plan = _read_plan(Path(path))
    return replace(plan, plugins=frozenset(plugins))


def _read_plan(path: Path) -> Plan:
    tables = read_tables(path)
    if SWEEP not in tables:
        raise InvalidInput(f"{path}: has no table [sweep]. Add one, with samples, outputs and, under [sweep.inputs], "
                           f"what varies: {EXAMPLE}")
    raw = tables.pop(SWEEP)
    kind = kind_of_tables(tables, path)
    if not isinstance(raw, dict):
        raise InvalidInput(f"{path}: [sweep] must be a table; got {shown(raw)}.")
    if isinstance(raw.get("inputs"), dict):
        raw = raw | {"inputs": _flat(raw["inputs"])}
    try:
        table = SweepTable.model_validate(raw)
    except ValidationError as error:
        raise InvalidInput(*as_message(path, list_mistakes(error, SweepTable, (SWEEP,)))) from None
    mistakes: list[Mistake] = []
    inputs, units, model = {}, {}, model_of_tables(kind, tables)
    with record_files() as read:
        for key, value in table.inputs.items():
            try:
                reader = Reader(number_at(key, model, kind.table.beside))
                inputs[key] = read_distribution(value, reader, path.parent)
                units[key] = reader.unit or ""
            except ValueError as error:
                mistakes.append(((SWEEP, "inputs", key), str(error)))
    mistakes += _find_broken(table, inputs)
    if mistakes:
        raise InvalidInput(*as_message(path, mistakes))
    rows = [how.count for how in inputs.values() if isinstance(how, AbstractPlaced) and not isinstance(how, Grid)]
    draws = table.samples if table.samples is not None else min(rows, default=1)
    design = Design(inputs, draws, table.seed, table.points, table.sensitivity)
    _check_size(path, design)
    said = {key: value for key, value in raw.items() if key != "chunk"}
    asked = json.dumps([tables, said], sort_keys=True, default=str)
    outputs, times = tuple(table.outputs), tuple(table.times)
    return Plan(path, tables, kind, design, units, outputs, times, table.keep, table.chunk, asked, read)


def _flat(inputs: dict[str, Any], before: str = "") -> dict[str, Any]:
    """Return inputs by whole keys; without quotes TOML takes spin.rate for a table in a table."""
    flat: dict[str, Any] = {}
    for key, value in inputs.items():
        inner = isinstance(value, dict) and value and all(isinstance(item, dict) for item in value.values())
        ways = {"sphere", "von-mises-fisher", "grid"}
        flat |= _flat(value, f"{before}{key}.") if inner and not ways & set(value) else {f"{before}{key}": value}
    return flat


def _find_broken(table: SweepTable, inputs: dict[str, Any]) -> list[Mistake]:
    """Return violations of rules between keys."""
    wrong: list[Mistake] = []
    placed = [how for how in inputs.values() if isinstance(how, AbstractPlaced)]
    rows = [how.count for how in placed if not isinstance(how, Grid)]
    meant = any(isinstance(value, dict) and {"grid", "table"} & set(value) for value in table.inputs.values())
    if not table.inputs:
        wrong.append(((SWEEP, "inputs"), f"must name at least one input, like {EXAMPLE}"))
    if not table.outputs:
        wrong.append(((SWEEP, "outputs"), 'must name at least one output, like ["regime"]'))
    if table.samples is None and not meant and table.inputs:
        wrong.append(((SWEEP, "samples"), "is missing; say how many, like samples = 10000"))
    if rows and table.samples is not None and table.samples > min(rows):
        wrong.append(((SWEEP, "samples"), f"must be at most the rows of the table, {min(rows)}; got {table.samples}"))
    if len(set(rows)) > 1 and table.samples is None:
        text = f"names tables of {min(rows)} and {max(rows)} rows, whose rows go together"
        wrong.append(((SWEEP, "inputs"), f"{text}. Give tables of one length, or samples, how many rows to take"))
    if placed and len(placed) == len(table.inputs) and not rows and (table.samples or 1) > 1:
        text = "repeats each point of the grids, and nothing is random; leave it out"
        wrong.append(((SWEEP, "samples"), text))
    if table.sensitivity and any(not isinstance(how, AbstractRandom) for how in inputs.values()):
        wrong.append(((SWEEP, "sensitivity"), "needs random inputs throughout, neither grids nor tables"))
    if table.sensitivity and table.keep != "all":
        wrong.append(((SWEEP, "keep"), 'must be "all": a sensitivity analysis needs all samples'))
    if twice := sorted({name for name in table.outputs if table.outputs.count(name) > 1 or name in table.inputs}):
        wrong.append(((SWEEP, "outputs"), f"names {twice[0]} twice, or as an input too; inputs are kept anyway"))
    states = any(name.startswith(STATES) for name in table.outputs)
    if states != bool(table.times):
        text = 'is missing; states need times, like ["10 s", "20 s"]' if states else (
            'goes with outputs such as "states.attitude"; add one, or leave it out')
        wrong.append(((SWEEP, "times"), text))
    if np.any(np.diff(table.times) <= 0.0):
        wrong.append(((SWEEP, "times"), f"must ascend, without repetitions; got {shown(table.times)} s. Sort them"))
    overlapping = [(a, b) for a in table.inputs for b in table.inputs if b.startswith(f"{a}.")]
    if overlapping:
        wrong.append(((SWEEP, "inputs"), f"sets {overlapping[0][1]} twice, alone and as a part of {overlapping[0][0]}"))
    return wrong


def _check_size(path: Path, design: Design) -> None:
    quasi = design.points == "sobol" or design.crossed
    if design.count > LIMITS.max_samples or (quasi and design.draws > 2**SOBOL_BITS):
        most = 2**SOBOL_BITS if quasi else LIMITS.max_samples
        got = f"{design.count:.3g} samples"
        raise InvalidInput(f"{path}: the sweep has {got}; at most {most:.3g} are taken. Give fewer.")
