"""The table [export]: labels of attitude files, such as object, frames and epoch."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from datetime import UTC, date, datetime
from typing import Annotated, Any, NamedTuple

from pydantic import BaseModel, BeforeValidator, ConfigDict

from polhode.errors import shown
from polhode.formats.labels import AttitudeLabels, plain
from polhode.spec.fields import one_of

SPEC_TIME_SYSTEMS = ("UTC", "TAI", "TT", "TDB", "GPS")
INERTIAL = ("EME2000", "J2000", "ICRF", "GCRF", "B1950", "FK4", "ECLIPJ2000", "ECLIPB1950", "TEME", "TOD", "GALACTIC")


class LabelLimits(NamedTuple):
    """A number beyond which a label is refused."""

    max_characters: int = 200  # lines of an AEM have 254


LIMITS = LabelLimits()


def _label(value: Any) -> str:
    good = isinstance(value, str) and value.strip() and value.isascii() and value.isprintable()
    if not good or len(value) > LIMITS.max_characters:
        rule = f"must be one line of printable ASCII, at most {LIMITS.max_characters} characters"
        raise ValueError(f"{rule}; got {shown(value)}")
    return value.strip()


def _epoch(value: Any) -> str:
    try:
        text = _as_text(value)
    except OverflowError:
        return str(value)  # a rule says so
    if text is None:
        raise ValueError(f'must be a date and time like "2026-03-01T12:00:00"; got {shown(value)}')
    return text


def _as_text(value: Any) -> str | None:
    """Return an epoch as text without zone; TOML has dates and times of its own."""
    if isinstance(value, datetime):
        value = value.astimezone(UTC).replace(tzinfo=None) if value.tzinfo else value
        return value.isoformat()
    if isinstance(value, date):
        return f"{value.isoformat()}T00:00:00"
    if isinstance(value, str):
        return value if "T" in value else f"{value.strip()}T00:00:00"
    return None


def _spice_id(value: Any) -> int:
    if type(value) is not int or not -(2**31) // 1000 < value < 0:
        raise ValueError(f"must be a negative whole number, as SPICE numbers spacecraft, like -999, and not below "
                         f"{-(2**31) // 1000 + 1}; got {shown(value)}")
    return value


Label = Annotated[str, BeforeValidator(_label)]


class ExportTable(BaseModel):
    """Labels of attitude files; each has a default."""

    model_config = ConfigDict(extra="forbid")

    object_name: Label | None = None
    object_id: Label | None = None
    center: Label | None = None
    reference_frame: Label | None = None
    body_frame: Label | None = None
    epoch: Annotated[str | None, BeforeValidator(_epoch)] = None
    time_system: Annotated[str, one_of(*SPEC_TIME_SYSTEMS)] = "UTC"
    originator: Label | None = None
    spice_id: Annotated[int, BeforeValidator(_spice_id)] | None = None


def export_rules(table: dict[str, Any]) -> Iterator[tuple[tuple[str | int, ...], str]]:
    """Yield mistakes in the epoch, by its time system, and in the names of the two frames."""
    yield from _frame_rules(table)
    epoch, system = table.get("epoch"), table.get("time_system", "UTC")
    try:
        text = _as_text(epoch)
    except OverflowError:
        yield ("export", "epoch"), f"lies in UTC outside the years 1 to 9999; got {shown(epoch)}. Check year and zone"
        return
    if text is None:
        return
    if system not in SPEC_TIME_SYSTEMS:
        system = "TAI"  # a mistake of its own; dates and times of day are wrong in any other as well
    if isinstance(epoch, datetime) and epoch.tzinfo and system != "UTC":
        yield ("export", "epoch"), f"has a zone, which only UTC has; leave the zone out for {system}"
        return
    from polhode.formats.epochs import read_epoch

    try:
        read_epoch(text, system)
    except ValueError as error:
        yield ("export", "epoch"), str(error)


def _frame_rules(table: dict[str, Any]) -> Iterator[tuple[tuple[str | int, ...], str]]:
    names = {key: table.get(key, getattr(AttitudeLabels, key)) for key in ("body_frame", "reference_frame")}
    if not all(isinstance(name, str) for name in names.values()):
        return
    body, space = plain(names["body_frame"]), plain(names["reference_frame"])
    frame = "body_frame" if "body_frame" in table else "reference_frame"
    if body == space:
        yield ("export", frame), f"must differ from the other frame; both are {shown(names['body_frame'])}"
    elif body in INERTIAL:
        got = shown(names["body_frame"])
        yield ("export", frame), f"is an inertial frame, and the body turns; got {got}. Name its own"


def make_labels(table: ExportTable, name: str) -> AttitudeLabels:
    """Return the labels of a spec; the object's default name is that of the spec."""
    fields: dict[str, Any] = {"object_name": _in_ascii(name)}
    fields |= {key: value for key, value in table.model_dump().items() if value is not None}
    if table.epoch is not None:
        from polhode.formats.epochs import read_epoch, shortest

        fields["epoch"] = shortest(read_epoch(table.epoch, table.time_system), table.time_system)
    return AttitudeLabels(**fields)


def _in_ascii(name: str) -> str:
    """Return a name of any script as attitude files can hold it: accents dropped, other signs an underscore."""
    letters = (c for c in unicodedata.normalize("NFKD", name) if not unicodedata.combining(c))
    plain = "".join(c if c.isascii() and c.isprintable() else " " if c.isspace() else "_" for c in letters)
    return " ".join(plain.split())[:LIMITS.max_characters] or "BODY"
