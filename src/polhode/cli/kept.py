"""Reports and their pages kept in the user's cache folder, for the next command on the same spec.

A report follows from its spec and from the program, so it is kept under a digest of both. With it is kept what else it
came from, by content: files that were read meanwhile, such as an earlier run that it goes on from, and the code of
other packages that took part. It is true as long as all of these are the same (``entries``).

Nothing is kept where a file may have changed after it was read, or where a warning was shown, which whoever takes the
entry would not see.

A page is kept as JSON. A report is an object that draws, writes and proves, made of systems, bodies, algebras and
certificates of any kind and package; whatever wrote and read all of these would call their classes by name, as pickle
does. So it is pickled, and unpickled only below an intact seal in a file that nobody else can have written.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import json
import pickle
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import BaseModel

from polhode._base.plugins import record_plugins
from polhode._base.plugins.program import program_digest
from polhode.cli.entries import (
    PAGE,
    REPORT,
    Origin,
    folder_of_entries,
    keep_entry,
    load_entry,
    may_have_changed,
    record_warnings,
)
from polhode.formats.opening import record_files
from polhode.kinds.base import Spec
from polhode.reports.base import SystemReport

if TYPE_CHECKING:
    from polhode.viewer.page import Page


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
        begun = time.time_ns()
        with record_files() as read, record_plugins() as plugins, record_warnings() as shown:
            report = spec.report()
            _ = report.answers  # what they take is kept with it
        if shown or may_have_changed(read, begun):
            return report
        with contextlib.suppress(Exception):  # what cannot be kept is computed again
            keep_entry(pickle.dumps(report), Origin.of(plugins.union(spec.plugins), read), place)
    return report


def load_or_make_page(spec: Spec, report: SystemReport, begun: int) -> Page:
    """Return the page of a spec's report, from the cache or made now; some kinds compute more motions for it.

    Args:
        spec: of the report.
        report: as ``load_or_make_report`` returned it.
        begun: when this was asked for it [ns since 1970].

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
        with record_files() as read, record_plugins() as plugins, record_warnings() as shown:
            page = page_of_answers(report, report.name, spec.picture)
        kept = load_entry(place)
        if kept is not None:  # else the report itself may not be kept
            origin, _ = kept
            before = [path for path, digest in origin.read.items() if digest]  # others lie in archives
            if shown or may_have_changed([*read, *before], begun):
                return page
            with contextlib.suppress(Exception):
                came_from = Origin.of(plugins.union(origin.plugins), read, origin.read)
                keep_entry(json.dumps(page._asdict()).encode(), came_from, beside)
    return page


def is_kept(spec: Spec) -> bool:
    """Whether the report on a spec is kept, as far as the spec goes."""
    return _place(spec) is not None


def _place(spec: Spec) -> Path | None:
    """Return the file of a spec's report; None where it is not kept."""
    folder = folder_of_entries()
    is_own = type(spec.kind).__module__.startswith("polhode.")
    if folder is None or not (is_own or any(plugin.name == spec.kind.name for plugin in spec.plugins)):
        return None
    try:
        return folder / f"{_digest(spec)}{REPORT}"
    except TypeError:  # a value whose digest is not known
        return None


def _load_report(place: Path) -> SystemReport | None:
    kept = load_entry(place)
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

    kept = load_entry(place)
    if kept is None:
        return None
    parts = json.loads(kept[1])
    return Page(parts["title"], parts["data"], tuple(parts["scripts"]))


def _digest(spec: Spec) -> str:
    shown = sys.warnoptions  # by which a report that would warn elsewhere does not, and is kept
    digest = hashlib.sha256(f"{program_digest()} {shown}".encode())
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
