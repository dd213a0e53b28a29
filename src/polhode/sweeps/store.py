"""The Zarr store of a sweep: arrays of all samples, and a mark for each chunk that is finished.

A chunk of samples is one chunk of every array, so that whoever computes it writes files of its own. Its mark, a small
file that appears whole after the data, holds checksums and a summary; what has no mark is computed again.

All files are checked before they are used, like any file from outside: each must be a regular file, no larger than
its content can be, with the content that was written. Read are marks and chunks by the sweep's own layout; documents in
the store are for other readers, and put right where they differ.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import FormatError, InvalidInput, one_line, shown
from polhode.formats.drafts import sync_to_disk
from polhode.formats.opening import MB, read_file
from polhode.formats.paths import write_whole
from polhode.sweeps.columns import Column
from polhode.sweeps.evaluation import Chunk
from polhode.sweeps.layout import CHUNKS, EARLIER_FORMATS, FORMAT, HOME, LOCK, PLAN, Layout, import_zarr
from polhode.sweeps.marks import Mark, hash_array, pack_mark, read_mark
from polhode.sweeps.store_checks import AGAIN, check_file, check_folder, says, unpack_chunk


class StoreThresholds(NamedTuple):
    """Numbers that decide whether a store is begun.

    Attributes:
        min_free_ratio: of the room on the disk to the size that the store may reach.
    """

    min_free_ratio: float = 1.1


LIMITS = StoreThresholds()


class Damage(NamedTuple):
    """Damage of a store.

    Attributes:
        chunks: how many had marks, and are to be computed again.
        documents: how many were missing or changed, and are as they were again.
    """

    chunks: int
    documents: int


class Store:
    """A store on a disk that all workers reach.

    Attributes:
        path: of the folder.
        layout: of its files.
        is_new: whether it was made by this object, and nothing of it is worth keeping before a chunk is finished.
    """

    def __init__(self, path: str | Path, layout: Layout) -> None:
        self.path = Path(path)
        self.layout = layout
        self.home = self.path / HOME
        self.is_new = False
        self._digests: dict[int, dict[str, str]] = {}  # of chunks whose mark was read

    # ------------------------------------------------------------------ beginning

    def begin(self) -> None:
        """Make the store, or check that it belongs to this sweep, to go on with.

        Raises:
            InvalidInput: for another sweep's store, other folders and files, and where nothing can be written.
            FormatError: for a store that is no longer one.
        """
        if os.path.lexists(self.home):
            self._check_home()
            self._check_same()
            return
        if os.path.lexists(self.path):
            raise InvalidInput(f"{self.path}: is there already, and not the store of a sweep. Choose another folder "
                               "with `store`, or move it away.")
        with write_whole(self.path) as draft:
            for name, content in self.layout.documents.items():
                (draft / name).parent.mkdir(parents=True, exist_ok=True)
                (draft / name).write_bytes(content)
            (draft / HOME / CHUNKS).mkdir()
        self.is_new = True

    def remove_if_empty(self) -> None:
        """Remove a store that was made in vain."""
        if self.is_new and not self.list_finished():
            shutil.rmtree(self.path, ignore_errors=True)

    def _check_home(self) -> None:
        """Refuse paths that cannot be a store's folder, before anything in it is opened or locked."""
        check_folder(self.path, self.home, {CHUNKS})
        if not os.path.lexists(self.home / PLAN):
            raise FormatError(f"{self.path}: is damaged: {HOME}/{PLAN} is gone. Put it back, or choose another folder "
                              "with `store`.")

    def _check_same(self) -> None:
        try:
            plan = json.loads(read_file(self.home / PLAN, "plan", MB))
        except (ValueError, RecursionError):
            plan = None
        wanted = self.layout.plan
        if not isinstance(plan, dict) or plan.keys() != wanted.keys():
            old = plan.get("format") if isinstance(plan, dict) else None
            what = f"is damaged: {HOME}/{PLAN} is not what a sweep writes"
            if old in EARLIER_FORMATS:
                what = f"was made by another version of polhode (format {old}, not {FORMAT})"
            raise FormatError(f"{self.path}: {what}. Choose another folder with `store`, or remove this one.")
        if plan["fingerprint"] != wanted["fingerprint"]:
            raise InvalidInput(f"{self.path}: holds another sweep: {_name_changes(plan['made_from'], wanted)} changed "
                               "since, and samples of both would be mixed. Put it back, choose another folder with "
                               "`store`, or remove this one.")
        if plan["chunk"] != wanted["chunk"]:
            got = shown(plan["chunk"])
            raise InvalidInput(f"{self.path}: was begun with chunks of {got} samples, not {wanted['chunk']}. Set "
                               "sweep.chunk to that, or choose another folder with `store`.")
        if plan != wanted:
            key = next(key for key in wanted if plan[key] != wanted[key])
            raise FormatError(f"{self.path}: is damaged: {HOME}/{PLAN} says {key} = {shown(plan[key])}, and this "
                              f"sweep has {wanted[key]}. Choose another folder with `store`, or remove this "
                              "one.")

    @contextlib.contextmanager
    def lock(self) -> Iterator[None]:
        """Keep other processes from this sweep; the lock ends with the process, however it ends.

        Raises:
            InvalidInput: if another one is at it.
        """
        from filelock import FileLock, Timeout

        lock = FileLock(self.home / LOCK)
        with reword_errors(self.path):
            try:
                lock.acquire(timeout=0)
            except Timeout:
                why = "another process computes this sweep now"
                raise InvalidInput(f"{self.path}: {why}. Wait for it, or stop it.") from None
        try:
            yield
        finally:
            lock.release()

    # ------------------------------------------------------------------ what is there

    def settle(self) -> Damage:
        """Repair the store so that every chunk with a mark is intact; to be called under the lock.

        Marks go from chunks that are not, so that they are computed again; documents are put right.

        Raises:
            FormatError: where there are pipes, links or folders in place of files.
            InvalidInput: where nothing can be written.
        """
        with reword_errors(self.path):
            self._check_places()
            (self.home / CHUNKS).mkdir(exist_ok=True)
            restored = sum(self._restore(name, content) for name, content in self.layout.documents.items())
            dropped = 0
            for number in sorted(self.list_finished()):
                if self._is_whole(number):
                    continue
                self._mark(number).unlink(missing_ok=True)
                dropped += 1
        return Damage(dropped, restored)

    def _check_places(self) -> None:
        """Refuse special files in place of the sweep's own, and remove abandoned drafts."""
        check_folder(self.path, self.home, {CHUNKS})
        for name in self.layout.documents:
            check_file(self.path, name)
        folders = {(self.path / name).parent for name in self.layout.documents} | {self.home / CHUNKS}
        for folder in sorted(folders - {self.path, self.home}):
            if not os.path.lexists(folder):
                continue
            check_folder(self.path, folder, set())
            for draft in (*folder.glob(".*.mark.*"), *folder.glob("*.partial")):  # our own, and zarr's
                draft.unlink(missing_ok=True)

    def _restore(self, name: str, content: bytes) -> bool:
        """Restore a document that is missing or changed, and return whether it was."""
        path = self.path / name
        if says(path, content):
            return False
        path.parent.mkdir(exist_ok=True)
        _write_whole(path, content)
        return True

    def _is_whole(self, number: int) -> bool:
        """Whether a mark and the data of its chunk are intact."""
        try:
            digests = self.mark(number).digests
            for column in self.layout.arrays.values():
                self._load_chunk(column, number, digests[column.name])
        except InvalidInput:
            return False
        self._digests[number] = digests
        return True

    def list_finished(self) -> set[int]:
        """Return which chunks have marks, whole or not."""
        finished = set()
        for path in (self.home / CHUNKS).glob("*.mark"):
            if path.stem.isascii() and path.stem.isdecimal() and len(path.stem) < 20:
                number = int(path.stem)
                if number < self.layout.chunks and path.name == self._mark(number).name:
                    finished.add(number)
        return finished

    def mark(self, number: int) -> Mark:
        """Return the mark of a chunk.

        Raises:
            InvalidInput: where there is none, or nothing that could be one.
        """
        path = self._mark(number)
        mark = read_mark(read_file(path, "mark", self.layout.largest_mark), number, self.layout)
        if mark is None:
            raise FormatError(f"{path}: is damaged. {AGAIN}")
        return mark

    def marks(self) -> Iterator[Mark]:
        """Yield the marks of all chunks in the order of the samples.

        Raises:
            InvalidInput: where one is missing or damaged.
        """
        for number in range(self.layout.chunks):
            try:
                yield self.mark(number)
            except InvalidInput as error:
                raise FormatError(f"{self.path}: chunk {number} has no whole mark ({error.args[0]})") from None

    # ------------------------------------------------------------------ data

    def write(self, number: int, chunk: Chunk) -> None:
        """Write a chunk of samples, and then its mark.

        Raises:
            OSError: as the system does, such as on a full disk; no mark is left then.
        """
        low, high = self.layout.sample_range(number)
        if self.layout.arrays:
            group = import_zarr().open_group(str(self.path), mode="r+", zarr_format=2, use_consolidated=False)
            for name, column in self.layout.arrays.items():
                file = self.path / self.layout.chunk_path(column, number)
                file.unlink(missing_ok=True)  # zarr would read it first, where the last chunk has fewer samples
                group[name][low:high] = chunk.values[name]
                _write_through(file)  # the mark must not outlive the data in a power cut
        mark = Mark.of(chunk, number, self.layout)
        _write_whole(self._mark(number), pack_mark(mark))

    def read(self, name: str, most: int | None = None) -> Any:
        """Return an array, or evenly chosen chunks of it with about so many samples.

        Raises:
            FormatError: where it is not what was written.
        """
        layout = self.layout
        count, each = layout.samples, layout.chunk
        chosen = np.arange(layout.chunks)
        if most is not None and count > most:
            chosen = np.unique(np.linspace(0, layout.chunks - 1, max(1, most // each)).astype(int))
        column = layout.arrays[name]
        return np.concatenate([self._load_chunk(column, k, self._digest(k, name)) for k in chosen.tolist()])

    def _digest(self, number: int, name: str) -> str:
        if number not in self._digests:
            self._digests[number] = self.mark(number).digests
        return self._digests[number][name]

    def _load_chunk(self, column: Column, number: int, digest: str) -> Any:
        """Return the values (sample, …) of a chunk, which are those of the digest.

        Raises:
            FormatError: if they are not.
        """
        path, (low, high) = self.path / self.layout.chunk_path(column, number), self.layout.sample_range(number)
        if os.path.lexists(path):
            values = unpack_chunk(path, column, self.layout.chunk)[: high - low]
        else:
            values = column.blank(high - low)  # of which zarr writes no file
        if hash_array(values) != digest:
            raise FormatError(f"{path}: is not what was written. {AGAIN}")
        return values

    def _mark(self, number: int) -> Path:
        return self.home / CHUNKS / f"{number:09d}.mark"


def _name_changes(parts: Any, wanted: dict[str, Any]) -> str:
    """Return in words which of the parts that a store was made from are others now, or are not there any more."""
    parts, now = parts if isinstance(parts, dict) else {}, wanted["made_from"]
    changed = [one_line(name) for name in {**now, **parts} if parts.get(name) != now.get(name)]
    named = changed[:4]
    rest = [f"{len(changed) - len(named)} more"] if len(changed) > len(named) else []
    *most, last = [*named, *rest] or ["what it is computed from"]
    return f"{', '.join(most)} and {last}" if most else last


def compute_size(columns: tuple[Column, ...], samples: int) -> int:
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
    if free < LIMITS.min_free_ratio * needed:
        raise InvalidInput(
            f"{path}: the sweep may take {in_bytes(needed)}, and the disk has {in_bytes(free)} free. Take fewer "
            'samples or outputs, set keep = "statistics", or choose another disk with `store`.'
        )


def in_bytes(count: float) -> str:
    """Return a size in the unit that it is read by.

    >>> in_bytes(1234567), in_bytes(0)
    ('1.23 MB', '0 B')
    """
    unit = max(0, min(4, int(math.log10(max(count, 1.0)) / 3.0)))
    return f"{count / 1000.0**unit:.3g} {('B', 'kB', 'MB', 'GB', 'TB')[unit]}"


@contextlib.contextmanager
def reword_errors(path: Path) -> Iterator[None]:
    """Turn errors of the system into one that names the store."""
    try:
        yield
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be written ({error.strerror or error}). Choose a place that you may write "
                           "to, with `store`.") from None


def _write_through(path: Path) -> None:
    """Flush a file and its folder's entry to the disk; an array that is all blank has no file."""
    for one in (path, path.parent):
        if one.exists():
            sync_to_disk(one)


def _write_whole(path: Path, content: bytes) -> None:
    """Write a file atomically; of two writers at once either wins, as both write equal bytes."""
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with draft.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            draft.unlink()
        raise
