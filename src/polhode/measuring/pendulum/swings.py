"""The file of a pendulum's measurements: its tables, and the swings that they describe."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import numpy as np
from pydantic import BeforeValidator, Field, PlainValidator, ValidationError

from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.errors import InvalidInput, shown
from polhode.measuring.pendulum.fitting import Filaments, Jig, Measured, Pivot, Swing
from polhode.spec.fields import Angle, Coordinate, is_number, one_of
from polhode.spec.mistakes import as_message, list_mistakes
from polhode.spec.models import Strict
from polhode.spec.parsing import read_tables
from polhode.spec.rules import Mistake
from polhode.spec.uncertain import uncertain

BIFILAR, TRIFILAR, COMPOUND = "bifilar", "trifilar", "compound"
SIZES = {BIFILAR: ("spacing", "upper_spacing"), TRIFILAR: ("radius", "upper_radius"), COMPOUND: ("distance", "pivot")}
OF_JIG = ("turns", "amplitude", "last_amplitude")  # keys of the rig that the jig's own swing takes
CENTRED = Measured(0.0)


class TimingThresholds(NamedTuple):
    """Numbers that decide which timings are refused.

    Attributes:
        min_timings: whose scatter gives an error.
        max_deviation: of the median timing; one that deviates more is mistyped, or of another number of turns.
    """

    min_timings: int = 2
    max_deviation: float = 0.2


LIMITS = TimingThresholds()


def _measured(unit: str) -> PlainValidator:
    def read(value: Any) -> Measured:
        if not isinstance(value, str):
            raise ValueError(f'needs a number with its unit in quotes, like "1.500 ± 0.001 {unit}"; got {shown(value)}')
        try:
            return Measured(*uncertain("it", value, unit))
        except InvalidInput as error:
            raise ValueError(str(error).removeprefix("it ").removesuffix(".")) from None

    return PlainValidator(read)


MeasuredMass = Annotated[Measured, _measured("kg")]
MeasuredLength = Annotated[Measured, _measured("m")]
MeasuredMoment = Annotated[Measured, _measured("kg*m^2")]
MeasuredGravity = Annotated[Measured, _measured("m/s^2")]
OneTiming = Annotated[Measured, _measured("s")]
Kind = Annotated[str, one_of(BIFILAR, TRIFILAR, COMPOUND)]


def _timings(value: Any) -> Any:
    return value if isinstance(value, list) else [value]


Timings = Annotated[list[OneTiming], BeforeValidator(_timings), Field(min_length=1)]


def _axis(value: Any) -> tuple[float, float, float]:
    letters = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
    if isinstance(value, str) and value in letters:
        return letters[value]
    if not (isinstance(value, list) and len(value) == 3 and all(map(is_number, value)) and any(value)):
        rule = "must be x, y or z, or three plain numbers in a list, not all zero, like [1, 1, 0]"
        raise ValueError(f"{rule}; got {shown(value)}")
    x, y, z = map(float, value)
    return x, y, z


def _turns(value: Any) -> float:
    if not is_number(value) or not value > 0:
        raise ValueError(f"must be a positive number of oscillations, like 10; got {shown(value)}")
    return float(value)


AxisOfSwing = Annotated[tuple[float, float, float], BeforeValidator(_axis)]
Turns = Annotated[float, BeforeValidator(_turns)]


class JigTable(Strict):
    """The holder of the body, by its moment or by its own swing in the same rig.

    Its turns and amplitudes are those of the table that contains it, unless it has its own.
    """

    mass: MeasuredMass = Field(description='give it like "80 ± 1 g"')
    moment: MeasuredMoment | None = None
    periods: Timings | None = None
    turns: Turns | None = None
    amplitude: Angle | None = None
    last_amplitude: Angle | None = None
    distance: MeasuredLength | None = None


class RigTable(Strict):
    """The rig that holds the body; in [pendulum] for all swings, in [[swing]] for one."""

    kind: Kind | None = None
    length: MeasuredLength | None = None
    spacing: MeasuredLength | None = None
    upper_spacing: MeasuredLength | None = None
    radius: MeasuredLength | None = None
    upper_radius: MeasuredLength | None = None
    offset: MeasuredLength | None = None
    distance: MeasuredLength | None = None
    pivot: Coordinate | None = None
    amplitude: Angle | None = None
    last_amplitude: Angle | None = None
    turns: Turns | None = None
    jig: JigTable | None = None


class SwingTable(RigTable):
    """The timings of one swing, and keys that replace those of [pendulum]."""

    axis: AxisOfSwing = (0.0, 0.0, 1.0)
    periods: Timings = Field(description='give timings like ["23.11 s", "23.08 s"], or "23.10 ± 0.02 s"')


class PendulumFile(Strict):
    """The whole file."""

    name: str | None = None
    mass: MeasuredMass = Field(description='give that of the body alone, like "1.523 ± 0.001 kg"')
    gravity: MeasuredGravity = Measured(STANDARD_GRAVITY)
    pendulum: RigTable = RigTable()
    swing: Annotated[list[SwingTable], Field(min_length=1, description="give one table [[swing]] for each")]


class Measurements(NamedTuple):
    """The content of a file.

    Attributes:
        name: of the body.
        mass: of the body alone [kg].
        gravity: [m/s²].
        swings: in the file's order.
        kinds: of pendulum, of each.
        timings: how many there are of each.
        exact: names of the sizes that were given without an error.
    """

    name: str
    mass: Measured
    gravity: Measured
    swings: list[Swing]
    kinds: list[str]
    timings: list[int]
    exact: list[str]


def read_swings(path: Path) -> Measurements:
    """Read measurements of a pendulum; every mistake in the file is reported at once.

    Raises:
        InvalidInput: naming the file and, for each mistake, the key, the rule and what came.
        FormatError: if the file is not TOML.
    """
    tables = read_tables(path, "pendulum")
    try:
        file = PendulumFile.model_validate(tables)
    except ValidationError as error:
        raise InvalidInput(*as_message(path, list_mistakes(error, PendulumFile))) from None
    jig = _fill_jig(file.pendulum.jig, dict(file.pendulum))
    merged = [_merge(file.pendulum.model_copy(update={"jig": jig}), swing) for swing in file.swing]
    every = list(zip(file.swing, merged, strict=True))
    if mistakes := [one for k, (swing, keys) in enumerate(every) for one in _broken_rules(keys, swing, k)]:
        raise InvalidInput(*as_message(path, mistakes))
    build = _Builder({})
    swings = [build.swing(keys, swing) for swing, keys in every]
    counts = [len(swing.periods) for swing in file.swing]
    return Measurements(file.name or path.stem, file.mass, file.gravity, swings, [keys["kind"] for keys in merged],
                        counts, _list_exact(file.mass, merged))


def _merge(shared: RigTable, own: SwingTable) -> dict[str, Any]:
    """Return the keys of a swing: its own, and those of all swings where it has none."""
    keys = {name: getattr(shared, name) if getattr(own, name) is None else getattr(own, name)
            for name in RigTable.model_fields}
    return keys if own.jig is None else {**keys, "jig": _fill_jig(own.jig, keys)}


def _fill_jig(jig: JigTable | None, keys: Mapping[str, Any]) -> JigTable | None:
    """Return a jig with the keys of its own swing from the table that contains it, where it has none."""
    if jig is None:
        return None
    return jig.model_copy(update={name: keys[name] for name in OF_JIG if getattr(jig, name) is None})


def _list_exact(mass: Measured, merged: list[dict[str, Any]]) -> list[str]:
    """Return the names of all sizes without an error; a dict keeps their order."""
    named = {"mass": None} if not mass.error else {}
    for keys in merged:
        every = {**keys, **({} if keys["jig"] is None else {f"jig.{name}": value for name, value in keys["jig"]})}
        named |= {name: None for name, value in every.items() if isinstance(value, Measured) and not value.error}
        named |= {} if keys["pivot"] is None else {"pivot": None}
    return list(named)


def _broken_rules(keys: dict[str, Any], swing: SwingTable, k: int) -> Iterator[Mistake]:
    place, kind = ("swing", k), keys["kind"]
    if kind is None:
        yield (*place, "kind"), "is missing, and [pendulum] has none; it is bifilar, trifilar or compound"
        return
    main, other = SIZES[kind]
    if kind == COMPOUND:
        if (keys[main] is None) == (keys[other] is None):
            yield place, ("needs distance, from the pivot to the body's centre of mass, or pivot, its place on a scale "
                          "along a line through that, one of the two")
    else:
        yield from (((*place, name), f"is missing; a {kind} pendulum needs length and {main}")
                    for name in ("length", main) if keys[name] is None)
    takes = {main, other, *(("length", "offset") if kind != COMPOUND else ())}
    sizes = {"length", "offset", *(name for both in SIZES.values() for name in both)}
    yield from (((*place, name), f"is not a size of a {kind} pendulum; leave it out")
                for name in sorted(sizes - takes) if keys[name] is not None)
    yield from (((*place, "periods"), fault) for fault in _faults(swing.periods))
    last, first = keys["last_amplitude"], keys["amplitude"] or 0.0
    if last is not None and not 0.0 < last <= first:
        yield (*place, "last_amplitude"), "must be positive and at most amplitude"
    jig = keys["jig"]
    if jig is None:
        return
    if (jig.moment is None) == (jig.periods is None):
        yield (*place, "jig"), "needs moment, or periods of its own swing in the same rig, one of the two"
    yield from (((*place, "jig", "periods"), fault) for fault in _faults(jig.periods or []))
    if jig.last_amplitude is not None and not 0.0 < jig.last_amplitude <= (jig.amplitude or 0.0):
        yield (*place, "jig", "last_amplitude"), "must be positive and at most the jig's amplitude"
    if (jig.distance is None) == (kind == COMPOUND):
        wanted = "needs distance, from the pivot to the jig's own centre of mass" if kind == COMPOUND else (
            "goes without distance on filaments, where it hangs centred")
        yield (*place, "jig"), wanted


@dataclass(frozen=True)
class _Builder:
    """Makes swings; a quantity of [pendulum] becomes one object, whose error all swings share."""

    made: dict[int, Any]

    def swing(self, keys: dict[str, Any], swing: SwingTable) -> Swing:
        kind, jig = keys["kind"], keys["jig"]
        if kind == COMPOUND:
            rig: Filaments | Pivot = Pivot(keys["distance"], keys["pivot"] or 0.0)
        else:
            below, above = (keys[name] for name in SIZES[kind])
            factor = 0.5 if kind == BIFILAR else 1.0
            lower = self._once(below, lambda: Measured(factor * below.value, factor * below.error))
            upper = lower
            if above is not None:
                upper = self._once(above, lambda: Measured(factor * above.value, factor * above.error))
            rig = Filaments(keys["length"], upper, lower, keys["offset"] or CENTRED)
        period = _mean(swing.periods, keys["turns"] or 1.0)
        made = None if jig is None else self._once(jig, lambda: _jig(jig))
        return Swing(swing.axis, rig, period, keys["amplitude"] or 0.0, keys["last_amplitude"], keys["turns"] or 1.0,
                     made)

    def _once(self, source: Any, make: Callable[[], Any]) -> Any:
        if id(source) not in self.made:
            self.made[id(source)] = make()
        return self.made[id(source)]


def _jig(table: JigTable) -> Jig:
    turns = table.turns or 1.0
    period = None if table.periods is None else _mean(table.periods, turns)
    return Jig(table.mass, table.moment, period, table.amplitude or 0.0, table.distance or CENTRED,
               table.last_amplitude, turns)


def _faults(timings: list[Measured]) -> Iterator[str]:
    middle = float(np.median([one.value for one in timings])) if timings else 0.0
    for one in timings:
        if abs(one.value - middle) > LIMITS.max_deviation * middle and len(timings) > 2:
            yield (f"has {one.value:g} s among timings about {middle:g} s, and the same swing takes as long each time; "
                   "correct it or leave it out")
    if not timings or any(one.error for one in timings):
        return
    like = 'give the error of a timing, like "23.10 ± 0.02 s"'
    if len(timings) < LIMITS.min_timings:
        yield f"is one timing without an error; give several, or {like}"
    elif len({one.value for one in timings}) == 1:
        yield f"are all the same, so that their scatter shows no error; {like}"


def _mean(timings: list[Measured], turns: float) -> Measured:
    """Return the period of one oscillation: by the scatter of timings, or by their errors where that is larger."""
    values = np.array([one.value for one in timings]) / turns
    stated = math.sqrt(sum(one.error**2 for one in timings)) / len(timings) / turns
    if len(timings) < LIMITS.min_timings:
        return Measured(float(values[0]), stated)
    scatter = float(np.std(values, ddof=1)) / math.sqrt(len(values))
    if stated >= scatter:
        return Measured(float(np.mean(values)), stated)
    return Measured(float(np.mean(values)), scatter, len(values) - 1.0)
