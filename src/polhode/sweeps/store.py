"""The Zarr store of a sweep: arrays of all samples, and a mark for each chunk that is finished.

A chunk of samples is one chunk of every array, so that whoever computes it writes files of its own. Its mark, a small
file that appears whole after the data, holds a checksum and a summary; what has no mark is computed again.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from polhode.errors import FormatError, InvalidInput, not_installed, shown
from polhode.formats.paths import written_whole
from polhode.sweeps.evaluation import Chunk, Column
from polhode.sweeps.summary import summary_of

HOME, PLAN, CHUNKS, LOCK = ".sweep", "plan.json", "chunks", "lock"
FORMAT = 1
COMPONENTS = {3: "axis", 4: "quaternion"}
SPARE = 1.1  # of the room that a store may need, in what the disk must have


def _zarr() -> Any:
    try:
        import zarr
    except ImportError:
        raise not_installed("Sweeps", "zarr", "sweep") from None
    return zarr


class Store:
    """A store on a disk that all workers reach.

    Attributes:
        path: of the folder.
        is_new: whether it was made by this object, and nothing of it is worth keeping before a chunk is finished.
    """

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self.home = self.path / HOME
        self.is_new = False

    # ------------------------------------------------------------------ beginning

    def begin(
        self, plan: dict[str, Any], columns: list[Column], times: tuple[float, ...], header: dict[str, Any]
    ) -> None:
        """Make the store, or check that it is one of the same sweep, to go on with.

        Args:
            plan: what tells it from others, as JSON has it: "fingerprint", "samples", "chunk", "keep".
            columns: of inputs, outputs and status.
            times: of states [s].
            header: global attributes.

        Raises:
            InvalidInput: for another sweep's store, other folders and files, and where nothing can be written.
        """
        if (self.home / PLAN).is_file():
            self._check_same(plan)
            return
        if self.path.exists():
            raise InvalidInput(f"{self.path}: is there already, and not the store of a sweep. Choose another name, or "
                               "move it away.")  # fmt: skip
        with written_whole(self.path) as draft:
            _make_arrays(draft, plan, columns, times, header)
            (draft / HOME / CHUNKS).mkdir(parents=True)
            (draft / HOME / PLAN).write_text(json.dumps({"format": FORMAT, **plan}, indent=1), "utf-8")
        self.is_new = True

    def remove_if_empty(self) -> None:
        """Remove a store that was made in vain."""
        if self.is_new and not self.finished():
            shutil.rmtree(self.path, ignore_errors=True)

    def _check_same(self, plan: dict[str, Any]) -> None:
        try:
            found = json.loads((self.home / PLAN).read_text("utf-8"))
        except (OSError, ValueError) as error:
            why = f"its {HOME}/{PLAN} cannot be read ({error})"
            raise FormatError(f"{self.path}: {why}. Choose another store.") from None
        if found.get("fingerprint") != plan["fingerprint"]:
            raise InvalidInput(f"{self.path}: holds another sweep: the spec, its files or polhode's version changed "
                               "since. Choose another store with --out, or remove this one.")  # fmt: skip
        if found.get("chunk") != plan["chunk"] or found.get("format") != FORMAT:
            got = shown(found.get("chunk"))
            raise InvalidInput(f"{self.path}: was begun with chunks of {got} samples, not {plan['chunk']}. Set "
                               "sweep.chunk to that, or choose another store with --out.")  # fmt: skip

    @contextlib.contextmanager
    def locked(self) -> Iterator[None]:
        """Keep other processes from the same sweep; the lock goes with the process, however it ends.

        Raises:
            InvalidInput: if another one is at it.
        """
        from filelock import FileLock, Timeout

        lock = FileLock(self.home / LOCK)
        with worded(self.path):
            try:
                lock.acquire(timeout=0)
            except Timeout:
                why = "another process computes this sweep now"
                raise InvalidInput(f"{self.path}: {why}. Wait for it, or stop it.") from None
        try:
            yield
        finally:
            lock.release()

    # ------------------------------------------------------------------ chunks

    def write(self, number: int, low: int, chunk: Chunk, keep: str) -> None:
        """Write a chunk of samples, the first of which is ``low``, and then its mark.

        Raises:
            OSError: as the system does, such as on a full disk; no mark is left then.
        """
        if keep == "all":
            group = _zarr().open_group(str(self.path), mode="r+", zarr_format=2, use_consolidated=False)
            for name, values in chunk.values.items():
                group[name][low : low + len(values)] = values
                # the mark must not outlive the data in a power cut
                _written_through(self.path / name / ".".join([str(number), *["0"] * (values.ndim - 1)]))
        mark = {
            "checksum": checksum(chunk.values), "reasons": chunk.reasons,
            "summaries": {name: summary_of(values) for name, values in chunk.values.items()},
        }  # fmt: skip
        _write_whole(self._mark(number), json.dumps(mark))

    def _mark(self, number: int) -> Path:
        return self.home / CHUNKS / f"{number:09d}.json"

    def drop_damaged(self) -> int:
        """Take the marks from chunks whose data are not what was written, so that they are computed again.

        Returns:
            how many there are.
        """
        plan = json.loads((self.home / PLAN).read_text("utf-8"))
        # what killed processes left: our drafts of marks, and zarr's of chunks
        for draft in (*(self.home / CHUNKS).glob(".*.json.*"), *self.path.rglob("*.partial")):
            draft.unlink(missing_ok=True)
        group, dropped = _zarr().open_group(str(self.path), mode="r", zarr_format=2, use_consolidated=False), 0
        for number in sorted(self.finished()):
            low = number * plan["chunk"]
            try:
                mark = json.loads(self._mark(number).read_text("utf-8"))
                high = min(low + plan["chunk"], plan["samples"])
                whole = plan["keep"] != "all" or mark["checksum"] == checksum(
                    {name: group[name][low:high] for name in mark["summaries"]}
                )
            except Exception:  # whatever a decoder makes of damaged bytes
                whole = False
            if not whole:
                self._mark(number).unlink(missing_ok=True)
                dropped += 1
        return dropped

    def finished(self) -> set[int]:
        """Return which chunks have marks."""
        return {int(path.stem) for path in (self.home / CHUNKS).glob("*.json") if path.stem.isdecimal()}

    def marks(self) -> Iterator[dict[str, Any]]:
        """Yield the marks in the order of the samples."""
        for path in sorted((self.home / CHUNKS).glob("*.json")):
            try:
                yield json.loads(path.read_text("utf-8"))
            except ValueError:
                raise FormatError(f"{path}: is damaged. Remove it and run the sweep again; the chunk is computed "
                                  "anew.") from None  # fmt: skip

    def checksum(self) -> str:
        """Return one for all samples, which depends neither on who computed them nor on interruptions."""
        found = hashlib.sha256()
        for mark in self.marks():
            found.update(bytes.fromhex(mark["checksum"]))
        return found.hexdigest()

    def read(self, name: str, most: int | None = None) -> Any:
        """Return an array, or evenly chosen chunks of it with about so many samples."""
        array = _zarr().open_group(str(self.path), mode="r", zarr_format=2)[name]
        count, each = array.shape[0], array.chunks[0]
        if most is None or count <= most:
            return array[:]
        chunks = np.unique(np.linspace(0, (count - 1) // each, max(1, most // each)).astype(int))
        return np.concatenate([array[k * each : (k + 1) * each] for k in chunks])


def _make_arrays(
    path: Path, plan: dict[str, Any], columns: list[Column], times: tuple[float, ...], header: dict[str, Any]
) -> None:
    """Make a group with empty arrays."""
    zarr = _zarr()
    group = zarr.create_group(str(path), zarr_format=2, attributes={"source": "polhode", **header})
    if plan["keep"] != "all":
        zarr.consolidate_metadata(str(path), zarr_format=2)
        return
    for column in columns:
        array = group.create_array(
            column.name, shape=(plan["samples"], *column.shape), chunks=(plan["chunk"], *column.shape),
            dtype=column.type, fill_value=None if column.text else np.nan,
            attributes={"_ARRAY_DIMENSIONS": _dimensions(column, bool(times)), **_attributes(column)},
        )  # fmt: skip
        assert array.chunks[0] == plan["chunk"]
    if times:
        clock = group.create_array("time", shape=(len(times),), chunks=(len(times),), dtype="<f8",
                                   attributes={"_ARRAY_DIMENSIONS": ["time"], "units": "s"})  # fmt: skip
        clock[:] = np.asarray(times)
    zarr.consolidate_metadata(str(path), zarr_format=2)


def checksum(values: dict[str, Any]) -> str:
    """Return the SHA-256 of arrays, their names and forms, in the order of the names."""
    found = hashlib.sha256()
    for name in sorted(values):
        array = np.ascontiguousarray(values[name])
        found.update(f"{name} {array.dtype.str} {array.shape}\n".encode())
        found.update(array.tobytes())
    return found.hexdigest()


def _dimensions(column: Column, states: bool) -> list[str]:
    own = list(column.shape)
    names = ["sample"]
    if states and column.name.startswith("states."):
        names.append("time")
        own = own[1:]
    return names + [COMPONENTS.get(size, f"component_{size}") for size in own]


def _attributes(column: Column) -> dict[str, str]:
    unit = column.unit.replace("²", "2").replace("³", "3").replace("°", "deg")
    found = {} if column.text else {"units": unit or "1"}
    return found | ({"comment": column.note} if column.note else {})


def size_of(columns: list[Column], samples: int) -> int:
    """Return the bytes of all arrays before they are compressed."""
    each = sum(column.type.itemsize * int(np.prod(column.shape, dtype=int)) for column in columns)
    return each * samples


def check_room(path: Path, needed: int) -> None:
    """Refuse a sweep that the disk has no room for.

    Raises:
        InvalidInput: saying how much there is.
    """
    folder = next(one for one in (path, *path.absolute().parents) if one.exists())
    free = shutil.disk_usage(folder).free
    if free < SPARE * needed:
        raise InvalidInput(
            f"{path}: the sweep may take {in_bytes(needed)}, and the disk has {in_bytes(free)} free. Take fewer "
            'samples or outputs, set keep = "statistics", or choose another disk with --out.'
        )


def in_bytes(count: float) -> str:
    """Return a size in the unit that it is read by.

    >>> in_bytes(1234567), in_bytes(0)
    ('1.23 MB', '0 B')
    """
    unit = max(0, min(4, int(math.log10(max(count, 1.0)) / 3.0)))
    return f"{count / 1000.0**unit:.3g} {('B', 'kB', 'MB', 'GB', 'TB')[unit]}"


@contextlib.contextmanager
def worded(path: Path) -> Iterator[None]:
    """Turn what the system refuses into one error that names the store."""
    try:
        yield
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be written ({error.strerror or error}). Choose a place that you may write "
                           "to, with --out.") from None  # fmt: skip


def _written_through(path: Path) -> None:
    """Have the system write a file and its folder's entry to the disk; what is all blank has no file."""
    for one in (path, path.parent):
        if not one.exists() or (one.is_dir() and os.name == "nt"):
            continue
        handle = os.open(one, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _write_whole(path: Path, text: str) -> None:
    """Write a file that is there whole or not at all; of two at once either stays, and both are the same."""
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with draft.open("w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            draft.unlink()
        raise
