"""From a TOML file to a body, its spin and the times asked for."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput
from polhode.spec.building import build_body, build_part, build_spin
from polhode.spec.mistakes import as_message, mistakes_of
from polhode.spec.models import BodyTable, PartTable, SpecFile
from polhode.spec.rules import SOURCES, Location, Mistake, broken_rules

Array = Any


@dataclass(frozen=True)
class Spec:
    """A spec in SI units.

    Attributes:
        name: what to call the body.
        body: its mass properties.
        momentum: (3,) at time zero [kg m²/s, principal axes]; zero where the file has no spin.
        attitude: (4,) wxyz, principal axes → space, at time zero.
        until: end of the samples [s], None for the report's own choice.
        samples: how many.
    """

    name: str
    body: Body
    momentum: Array
    attitude: Array
    until: float | None
    samples: int


def read_spec(path: str | Path) -> Spec:
    """Read a spec; every mistake in it is reported at once.

    Raises:
        InvalidInput: naming the file and, for each mistake, the key, the rule and what came.
        FormatError: if the file is not TOML, or a file that it names is not what it should be.
    """
    path = Path(path)
    table = _read_toml(path)
    mistakes, model = list(broken_rules(table)), None
    try:
        model = SpecFile.model_validate(table)
    except ValidationError as error:
        mistakes += mistakes_of(error)
    body, unphysical = _built_body(table.get("body"), path.parent, mistakes)
    if model is None or body is None or mistakes or unphysical:
        found = mistakes + [(location, str(error)) for location, error in unphysical]
        of_files = not mistakes and all(isinstance(error, FormatError) for _, error in unphysical)
        raise (FormatError if of_files else InvalidInput)(as_message(path, found))
    momentum, attitude = build_spin(model.spin, body)
    return Spec(model.name or path.stem, body, momentum, attitude, model.time.until, model.time.samples)


def _read_toml(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text("utf-8-sig"))  # some editors begin a file with a byte-order mark
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be read ({error.strerror}). Check the path.") from None
    except UnicodeDecodeError:
        raise FormatError(f"{path}: is not TOML, as it is not UTF-8 text. Save it as UTF-8.") from None
    except tomllib.TOMLDecodeError as error:
        raise FormatError(f"{path}: is not TOML ({error}). Values with units stand in quotes.") from None


def _built_body(
    raw: Any, folder: Path, mistakes: list[Mistake]
) -> tuple[Body | None, list[tuple[Location, InvalidInput]]]:
    """Return the body, or what of it no body has.

    Beside mistakes, what is right in itself is tried on its own: each part, and the source of the body with its other
    keys as if they were right.
    """

    def clean(location: Location) -> bool:
        return not any(where[: len(location)] == location for where, _ in mistakes)

    if not isinstance(raw, dict):
        return None, []
    errors: list[tuple[Location, InvalidInput]] = []
    parts = raw.get("parts")
    for k, part in enumerate(parts if isinstance(parts, list) else []):
        location = ("body", "parts", k)
        if clean(location):
            errors += _tried(location, lambda part=part: build_part(PartTable.model_validate(part)))[1]
    sources = [key for key in SOURCES if key in raw]
    if errors or len(sources) != 1 or not clean(("body", sources[0])):
        return None, errors
    kept = {key: value for key, value in raw.items() if key in BodyTable.model_fields and clean(("body", key))}
    if "mesh" in kept:
        kept = {"mesh_unit": "m", **kept}
        if ("mass" in kept) == ("density" in kept):
            kept = {key: value for key, value in kept.items() if key != "density"} | {"mass": "1 kg"}
    return _tried(("body",), lambda: build_body(BodyTable.model_validate(kept), folder))


def _tried(location: Location, build: Callable[[], Body]) -> tuple[Body | None, list[tuple[Location, InvalidInput]]]:
    try:
        return build(), []
    except InvalidInput as error:
        return None, [(location, error)]
