"""From a TOML file to a body, its spin and the times asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from polhode.bodies.body import Body
from polhode.bodies.surface import Surface
from polhode.errors import FormatError, InvalidInput, printable, shown
from polhode.formats.labels import AttitudeLabels
from polhode.spec.building import build_body, build_part, build_spin
from polhode.spec.export import labels_of
from polhode.spec.mistakes import as_message, mistakes_of
from polhode.spec.models import BodyTable, PartTable, SpecFile, SpinTable
from polhode.spec.parsing import read_tables
from polhode.spec.rules import SOURCES, Location, Mistake, broken_rules
from polhode.spec.surfaces import surface_of_body, surface_of_disk
from polhode.spec.systems import SYSTEMS, EulerDiskTable, SystemTable

Array = Any


@dataclass(frozen=True)
class Spec:
    """A spec in SI units.

    Attributes:
        name: what to call the body.
        body: its mass properties; None where the system has sizes of its own.
        spin: as it stands in the file, None for rest.
        until: end of the samples [s], None for the report's own choice.
        samples: how many.
        system: what moves, None for the free body.
        labels: what attitude files say of it.
        source: where the body comes from, as it stands in the file; None where the system has sizes of its own.
        folder: that paths count from.
    """

    name: str
    body: Body | None
    spin: SpinTable | None
    until: float | None
    samples: int
    system: SystemTable | None = None
    labels: AttitudeLabels = field(default_factory=AttitudeLabels)
    source: BodyTable | None = None
    folder: Path = Path()

    @cached_property
    def surface(self) -> Surface | None:
        """What the body looks like, in the given axes, made when first asked for; None where only moments are known.

        Raises:
            InvalidInput: if a file that the body came from is gone since.
        """
        if isinstance(self.system, EulerDiskTable):
            return surface_of_disk(self.system)
        return None if self.source is None else surface_of_body(self.source, self.folder)

    def start(self, moments: Array, axes: Array) -> tuple[Array, Array]:
        """Return momentum (3,) along, and attitude (4,) of, principal axes by columns in the given ones."""
        return build_spin(self.spin, moments, axes)


def read_spec(path: str | Path) -> Spec:
    """Read a spec; every mistake in it is reported at once.

    Raises:
        InvalidInput: naming the file and, for each mistake, the key, the rule and what came.
        FormatError: if the file is not TOML, or a file that it names is not what it should be.
    """
    path = Path(path)
    table = read_tables(path)
    raw = table.pop("system", None)
    raw = {"kind": raw} if isinstance(raw, str) else raw
    mistakes, model = list(broken_rules(table | ({} if raw is None else {"system": raw}))), None
    system, found = (None, []) if raw is None else _system(raw)
    mistakes += found
    try:
        model = SpecFile.model_validate(table)
    except ValidationError as error:
        mistakes += mistakes_of(error)
    body, unphysical = _built_body(table.get("body"), path.parent, mistakes)
    if model is None or mistakes or unphysical:
        found = mistakes + [(location, str(error)) for location, error in unphysical]
        of_files = not mistakes and all(isinstance(error, FormatError) for _, error in unphysical)
        raise (FormatError if of_files else InvalidInput)(*as_message(path, found))
    name = printable(model.name or path.stem).replace("\n", " ")
    labels = labels_of(model.export, model.name or path.stem)
    return Spec(
        name, body, model.spin, model.time.until, model.time.samples, system, labels, source=model.body,
        folder=path.parent,
    )  # fmt: skip


def _system(raw: Any) -> tuple[SystemTable | None, list[Mistake]]:
    kinds = ", ".join(SYSTEMS)
    if not isinstance(raw, dict):
        return None, [(("system",), f'must be a table, or one of its kinds, {kinds}; got {shown(raw)}')]
    kind = raw.get("kind")
    if not isinstance(kind, str) or kind not in SYSTEMS:
        got = "it is missing" if kind is None else f"got {shown(kind)}"
        return None, [(("system", "kind"), f"must be one of {kinds}; {got}")]
    try:
        return SYSTEMS[kind].model_validate(raw), []
    except ValidationError as error:
        return None, mistakes_of(error, SYSTEMS[kind], ("system",))


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
