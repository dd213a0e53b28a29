"""Reports and their pages kept in the user's cache folder, for the next command on the same spec.

A report follows from its spec and from the program, so it is kept under a digest of both. With it is kept what else it
came from, by content: files that were read meanwhile, such as an earlier run that it goes on from, and the code of
other packages that took part. It is true as long as all of these are the same. Every entry is sealed.

A page is kept as JSON. A report is an object that draws, writes and proves, made of systems, bodies, algebras and
certificates of any kind and package; whatever wrote and read all of these would call their classes by name, as pickle
does. So it is pickled, and unpickled only below an intact seal in a file that nobody else can have written.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import json
import os
import pickle
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError

from polhode._base.plugins import Plugin, list_modules_of_others, record_plugins
from polhode._base.plugins.program import program_digest
from polhode._base.seals import drop_oldest, read_sealed, write_sealed
from polhode.errors import PolhodeError
from polhode.formats.opening import content_digest, record_files
from polhode.kinds.base import Spec
from polhode.reports.base import SystemReport

if TYPE_CHECKING:
    from polhode.viewer.page import Page

FOLDER = "POLHODE_REPORTS_CACHE"  # in the environment: where reports are kept; empty to keep none
REPORT, PAGE = ".report", ".page"  # ends of names
MOST, LARGEST = 32, 50_000_000  # reports and as many pages, and bytes of one
FORMAT = 1


class Origin(BaseModel):
    """What an entry came from besides its spec, and what it needs: its first line.

    Attributes:
        format: of the entry.
        program: digest of the program and of the other packages' code.
        plugins: what took part of these.
        read: files, with SHA-256 of their content.
        jax: whether there are arrays of JAX, which are cut to 32 bits unless it is switched to 64.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    format: int
    program: str
    plugins: tuple[Plugin, ...]
    read: dict[str, str]
    jax: bool

    @classmethod
    def of(cls, plugins: Iterable[Plugin], read: dict[str, str]) -> Origin:
        used = tuple(sorted(set(plugins)))
        # what code of others imported by names that it put together is in no text, but has been imported by now
        modules = list_modules_of_others() if used else []
        read = read | {str(path): content_digest(path) for path in modules}
        return cls(format=FORMAT, program=program_digest(used), plugins=used, read=read, jax="jax" in sys.modules)

    @property
    def is_unchanged(self) -> bool:
        """Whether files and code are still the same."""
        return (self.format == FORMAT and program_digest(self.plugins) == self.program
                and all(content_digest(Path(path)) == digest for path, digest in self.read.items()))


def load_or_make_report(spec: Spec) -> SystemReport:
    """Return the report on a spec, from the cache or computed now.

    Raises:
        InvalidInput: as ``Spec.report`` does.
        NotConverged: likewise.
    """
    place = _place(spec)
    if place is None:
        return spec.report()
    report = _load_report(place)
    if report is None:
        with record_files() as read, record_plugins() as plugins:
            report = spec.report()
            _ = report.answers  # what they take is kept with it
        with contextlib.suppress(Exception):  # what cannot be kept is computed again
            _keep(pickle.dumps(report), Origin.of(plugins.union(spec.plugins), _by_name(read)), place)
    return report


def load_or_make_page(spec: Spec, report: SystemReport) -> Page:
    """Return the page of a spec's report, from the cache or made now; some kinds compute more motions for it.

    Raises:
        InvalidInput: where there is nothing to show.
    """
    from polhode.kinds.page import page_of_answers

    place = _place(spec)
    if place is None:
        return page_of_answers(report, report.name, spec.picture)
    beside = place.with_suffix(PAGE)
    page = _load_page(beside)
    if page is None:
        with record_files() as read, record_plugins() as plugins:
            page = page_of_answers(report, report.name, spec.picture)
        kept = _load(place)
        if kept is not None:  # else the report itself may not be kept
            origin, _ = kept
            with contextlib.suppress(Exception):
                came_from = Origin.of(plugins.union(origin.plugins), origin.read | _by_name(read))
                _keep(json.dumps(page._asdict()).encode(), came_from, beside)
    return page


def _place(spec: Spec) -> Path | None:
    """Return the file of a spec's report; None where it is not kept."""
    folder = os.environ.get(FOLDER)
    is_own = type(spec.kind).__module__.startswith("polhode.")
    if not folder or not (is_own or any(plugin.name == spec.kind.name for plugin in spec.plugins)):
        return None
    try:
        return Path(folder) / f"{_digest(spec)}{REPORT}"
    except TypeError:  # a value whose digest is not known
        return None


def _load_report(place: Path) -> SystemReport | None:
    kept = _load(place)
    if kept is None:
        return None
    origin, packed = kept
    try:
        if origin.jax:
            import polhode.algebra  # noqa: F401
        report = pickle.loads(packed)
    except Exception:  # whatever classes of another package do
        return None
    return report if isinstance(report, SystemReport) else None


def _load_page(place: Path) -> Page | None:
    from polhode.viewer.page import Page

    kept = _load(place)
    if kept is None:
        return None
    told = json.loads(kept[1])
    return Page(told["title"], told["data"], tuple(told["scripts"]))


def _load(place: Path) -> tuple[Origin, bytes] | None:
    """Return an entry that is whole and still true; None where there is none."""
    content = read_sealed(place, LARGEST)
    if content is None:
        return None
    first, _, packed = content.partition(b"\n")
    try:
        origin = Origin.model_validate_json(first)
        if not origin.is_unchanged:
            return None
    except (ValidationError, PolhodeError, OSError):
        return None
    with contextlib.suppress(OSError):
        os.utime(place)
    return origin, packed


def _by_name(read: dict[Path, str]) -> dict[str, str]:
    return {str(path): digest for path, digest in read.items()}


def _keep(packed: bytes, origin: Origin, place: Path) -> None:
    content = origin.model_dump_json().encode() + b"\n" + packed
    if len(content) > LARGEST:
        return
    write_sealed(place, content)
    pages = set(place.parent.glob(f"*{PAGE}"))
    drop_oldest(pages if place.suffix == PAGE else set(place.parent.glob("*")) - pages, MOST)


def _digest(spec: Spec) -> str:
    digest = hashlib.sha256(program_digest().encode())
    for part in _parts([getattr(spec, field.name) for field in dataclasses.fields(spec) if field.name != "kind"]):
        digest.update(b"%d:" % len(part))
        digest.update(part)
    digest.update(spec.kind.name.encode())
    return digest.hexdigest()


def _parts(value: Any) -> Iterator[bytes]:
    """Yield bytes that are the same only for equal values.

    Raises:
        TypeError: for a type whose values are not known here.
    """
    yield type(value).__qualname__.encode()
    if value is None or isinstance(value, bool | int | str | Path):
        yield str(value).encode()
    elif isinstance(value, float):
        yield value.hex().encode()
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fiubU":
        yield repr((value.dtype.str, value.shape)).encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, list | tuple):
        yield str(len(value)).encode()
        for item in value:
            yield from _parts(item)
    elif isinstance(value, dict):
        yield from _parts(sorted(value.items()))
    elif isinstance(value, BaseModel):
        yield from _parts(list(value))
    elif dataclasses.is_dataclass(value):
        for field in dataclasses.fields(value):
            yield from _parts(getattr(value, field.name))
    else:
        raise TypeError(type(value).__name__)
