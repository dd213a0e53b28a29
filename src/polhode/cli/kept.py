"""Reports and their pages kept in the user's cache folder, for the next command on the same spec.

A report follows from its spec and from the program, so it is kept under a digest of both; with it are kept the digests
of the files that were read while it was computed, such as an earlier run that it goes on from, and it is true as long
as these are the same. Kinds of other packages are computed each time.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import os
import pickle
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from pydantic import BaseModel

from polhode.formats.opening import content_digest, record_files
from polhode.kinds.base import Spec
from polhode.reports.base import SystemReport
from polhode.reports.program import program_digest

if TYPE_CHECKING:
    from polhode.viewer.page import Page

FOLDER = "POLHODE_REPORTS_CACHE"  # in the environment: where reports are kept; empty to keep none
MOST, LARGEST = 32, 50_000_000  # reports and as many pages, and bytes of one
Kept = TypeVar("Kept")


def load_or_make_report(spec: Spec) -> SystemReport:
    """Return the report on a spec, from the cache or computed now.

    Raises:
        InvalidInput: as ``Spec.report`` does.
        NotConverged: likewise.
    """
    place = _place(spec)
    if place is None:
        return spec.report()
    report = _load(place, SystemReport)
    if report is None:
        with record_files() as read:
            report = spec.report()
            _ = report.answers  # what they take is kept with it
        with contextlib.suppress(Exception):  # what cannot be kept is computed again
            _keep(report, read, place)
    return report


def load_or_make_page(spec: Spec, report: SystemReport) -> Page:
    """Return the page of a spec's report, from the cache or made now; some kinds compute more motions for it.

    Raises:
        InvalidInput: where there is nothing to show.
    """
    from polhode.kinds.page import page_of_answers
    from polhode.viewer.page import Page

    place = _place(spec)
    if place is None:
        return page_of_answers(report, report.name, spec.picture)
    beside = place.with_suffix(".page")
    page = _load(beside, Page)
    if page is None:
        with record_files() as read:
            page = page_of_answers(report, report.name, spec.picture)
        with contextlib.suppress(Exception):  # the report itself may not be kept
            _keep(page, _files_read(place) | read, beside)
    return page


def _place(spec: Spec) -> Path | None:
    """Return the file of a spec's report; None where it is not kept."""
    folder = os.environ.get(FOLDER)
    if not folder or not type(spec.kind).__module__.startswith("polhode."):
        return None
    try:
        return Path(folder) / f"{_digest(spec)}.pickle"
    except TypeError:  # a value whose digest is not known
        return None


def _load(place: Path, type_: type[Kept]) -> Kept | None:
    try:
        with place.open("rb") as file:
            if pickle.load(file):  # whether there are arrays of JAX, which are cut to 32 bits unless told otherwise
                import polhode.algebra  # noqa: F401
            read = pickle.load(file)
            if any(content_digest(path) != digest for path, digest in read.items()):
                return None
            value = pickle.load(file)
        os.utime(place)
    except Exception:  # missing, damaged in whatever way, or not to be read
        return None
    return value if isinstance(value, type_) else None


def _files_read(place: Path) -> dict[Path, str]:
    """Return the files that were read for a report that is kept, with their digests."""
    with place.open("rb") as file:
        pickle.load(file)
        return pickle.load(file)


def _keep(value: SystemReport | Page, read: dict[Path, str], place: Path) -> None:
    packed = pickle.dumps("jax" in sys.modules) + pickle.dumps(read) + pickle.dumps(value)
    if len(packed) > LARGEST:
        return
    place.parent.mkdir(parents=True, exist_ok=True)
    descriptor, draft = tempfile.mkstemp(dir=place.parent)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(packed)
        Path(draft).replace(place)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise
    oldest_first = sorted(place.parent.glob(f"*{place.suffix}"), key=lambda path: path.stat().st_mtime)
    for path in oldest_first[:-MOST]:
        path.unlink(missing_ok=True)


def _digest(spec: Spec) -> str:
    digest = hashlib.sha256(_program())
    for part in _parts([getattr(spec, field.name) for field in dataclasses.fields(spec) if field.name != "kind"]):
        digest.update(b"%d:" % len(part))
        digest.update(part)
    digest.update(spec.kind.name.encode())
    return digest.hexdigest()


@cache
def _program() -> bytes:
    return program_digest().encode()


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
