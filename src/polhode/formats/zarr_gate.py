"""Checks of Zarr stores before zarr opens them: plain files, known codecs, sizes that the files can hold.

A store names the code that decodes it, pickle among it, and sizes that need not fit its bytes. Here only the documents
on the disk are read, as JSON, and the first bytes of every chunk; no codec of the store runs.

Source: Zarr storage specification, version 2; the frame formats of Blosc, Zstandard (RFC 8878) and numcodecs' LZ4.
"""

from __future__ import annotations

import json
import math
import os
import re
import stat
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from polhode.errors import FormatError, shown
from polhode.formats.opening import MB, check_is_file, read_file

LARGEST_DOCUMENT = 4 * MB
LARGEST_CHUNK_FILE = 2000 * MB
OF_A_SWEEP = ".sweep"  # the folder that marks a store as a sweep's
DOCUMENTS = (".zarray", ".zgroup", ".zattrs", ".zmetadata")
_DTYPE = re.compile(r"[<>|](?:[iu][1248]|f[248]|b1|[US][1-9]\d{0,3})", re.ASCII)


class ZarrLimits(NamedTuple):
    """Numbers beyond which a Zarr store is refused before it is read."""

    max_files: int = 50_000  # of a folder
    max_chunks: int = 20_000  # zarr takes a quarter of a millisecond for each
    spare_bytes: int = 64 * MB  # that arrays may take in any case
    # bytes of arrays for one on the disk: Blosc compresses constants so far, and nothing further
    max_compression: int = 256


LIMITS = ZarrLimits()


class _File(NamedTuple):
    path: Path
    size: int


def check_store(folder: Path) -> list[str]:
    """Return the names of the arrays in a store (format 2), after checking that it is one that polhode writes.

    Raises:
        FormatError: for links and devices in it, codecs other than ``CODECS``, filters, objects, and arrays or chunks
            whose declared size exceeds what the stored bytes can hold.
    """
    if os.path.lexists(folder / OF_A_SWEEP):
        _refuse(folder, "is the store of a sweep, which holds numbers of many motions and not one motion. Read it with "
                        "xarray.open_zarr; `polhode sweep` with its spec prints its statistics")
    files = list(_files(folder, folder, 0))
    names = sorted(entry.name for entry in folder.iterdir() if entry.is_dir())
    arrays = {file.path.parent for file in files if file.path.name == ".zarray"}
    if arrays != {folder / name for name in names}:
        _refuse(folder, "has folders that are not arrays, or arrays within others. It is damaged; write it again")
    stored, chunks, declared = sum(file.size for file in files), 0, 0
    for file in files:
        if file.path.name == "zarr.json":
            _refuse(folder, "is of Zarr's format 3, and polhode writes format 2. Write it again with polhode")
        if file.path.name == ".zarray":
            count, size = _check_array(folder, file.path, files)
            chunks, declared = chunks + count, declared + size
        if file.path.name == ".zattrs":
            _document(folder, file.path)
    if chunks > LIMITS.max_chunks:
        _refuse(folder, f"has {shown(chunks)} chunks, and may have {LIMITS.max_chunks:,}. "
                        "Write it again with larger ones")
    check_size(folder, declared, stored)
    return names


def check_size(path: Path, declared: int, stored: int) -> None:
    """Refuse arrays whose declared size exceeds what the stored bytes can hold.

    Raises:
        FormatError: with both sizes.
    """
    if declared > LIMITS.spare_bytes + LIMITS.max_compression * stored:
        said = f"{declared / MB:,.0f}" if declared < 1e15 else "more than a billion"
        _refuse(path, f"claims arrays of {said} MB, and {stored / MB:,.3g} MB are stored. It is damaged, or made to "
                      "fill the memory. Write it again with polhode")


def _refuse(path: Path, what: str) -> NoReturn:
    raise FormatError(f"{path}: {what}.")


def _files(store: Path, folder: Path, depth: int) -> Iterator[_File]:
    count = 0
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError as error:
        _refuse(store, f"cannot be read ({error.strerror}). Check the path")
    for entry in entries:
        status = entry.stat(follow_symlinks=False)
        if stat.S_ISDIR(status.st_mode):
            if depth > 4:
                _refuse(store, "has folders nested too deep for a store of polhode's. Check the path")
            yield from _files(store, Path(entry.path), depth + 1)
        elif not stat.S_ISREG(status.st_mode):
            _refuse(store, f"has something other than files and folders in it, {shown(entry.name)}. Take it out, or "
                           "write the store again")
        else:
            count += 1
            if count > LIMITS.max_files:
                _refuse(store, f"has more than {LIMITS.max_files:,} files in a folder. "
                               "Write it again with larger chunks")
            yield _File(Path(entry.path), status.st_size)


def _check_array(store: Path, path: Path, files: list[_File]) -> tuple[int, int]:
    """Return how many chunks an array has, and its bytes."""
    name = f"variable {shown(path.parent.name)}"
    document = _document(store, path)
    shape, chunks = (_lengths(store, name, document, key) for key in ("shape", "chunks"))
    if len(shape) != len(chunks) or 0 in chunks:
        _refuse(store, f"{name} has chunks of shape {shown(chunks)} for the shape {shown(shape)}. It is damaged")
    dtype, compressor = document.get("dtype"), document.get("compressor")
    if not isinstance(dtype, str) or not _DTYPE.fullmatch(dtype):
        _refuse(store, f"{name} is of type {shown(dtype)}, and polhode writes numbers and short text. Write it again")
    if document.get("filters"):
        _refuse(store, f"{name} has filters, {shown(document['filters'])}, and polhode writes none. Write it again")
    codec = compressor.get("id") if isinstance(compressor, dict) else compressor
    if codec is not None and not (isinstance(codec, str) and codec in CODECS):
        known = ", ".join(CODECS)
        _refuse(store, f"{name} is compressed by {shown(codec)}; read are {known} and none, as others may run code. "
                       "Write it again with polhode")
    width = int(dtype[2:]) * (4 if dtype[1] == "U" else 1)
    whole = math.prod(chunks) * width
    check_size(store, whole, sum(file.size for file in files))
    for file in files:
        if file.path.parent == path.parent and file.path.name not in DOCUMENTS:
            _check_chunk(store, name, file, codec, whole)
    return math.prod(-(-n // c) for n, c in zip(shape, chunks, strict=True)), math.prod(shape) * width


def _document(store: Path, path: Path) -> dict[str, Any]:
    try:
        document = json.loads(read_file(path, "Zarr", LARGEST_DOCUMENT))
    except (ValueError, RecursionError) as error:
        if isinstance(error, FormatError):
            raise
        document = None
    if not isinstance(document, dict):
        _refuse(store, f"{shown(f'{path.parent.name}/{path.name}')} is not JSON of an array. It is damaged")
    return document


def _lengths(store: Path, name: str, document: dict[str, Any], key: str) -> list[int]:
    shape = document.get(key)
    if not isinstance(shape, list) or len(shape) > 16 or not all(type(n) is int and 0 <= n < 2**62 for n in shape):
        _refuse(store, f"{name} has the {key} {shown(shape)}, where whole numbers are wanted. It is damaged")
    return shape


def _check_chunk(store: Path, name: str, file: _File, codec: str | None, whole: int) -> None:
    if file.size > LARGEST_CHUNK_FILE:
        _refuse(store, f"{name} has a chunk of {file.size // MB:,} MB. Write the store again with smaller ones")
    if codec is None:
        check_is_file(file.path, "Zarr")
        size = file.size
    else:
        content = read_file(file.path, "Zarr", LARGEST_CHUNK_FILE)
        size = CODECS[codec](content, whole)
    if size != whole:
        _refuse(store, f"chunk {shown(file.path.name)} of {name} does not hold the {whole} bytes that it should. The "
                       "store is damaged; write it again")


def _of_blosc(content: bytes, whole: int) -> int:
    if len(content) < 16 or int.from_bytes(content[12:16], "little") != len(content):
        return -1
    return int.from_bytes(content[4:8], "little")


def _of_lz4(content: bytes, whole: int) -> int:
    return int.from_bytes(content[:4], "little") if len(content) > 4 else -1


def _of_zlib(content: bytes, whole: int) -> int:
    unpacking = zlib.decompressobj(wbits=47)  # zlib or gzip, as its head says
    try:
        return len(unpacking.decompress(content, whole + 1))
    except zlib.error:
        return -1


def _of_zstd(content: bytes, whole: int) -> int:
    if len(content) < 6 or content[:4] != b"\x28\xb5\x2f\xfd":
        return -1
    descriptor = content[4]
    single, flag = bool(descriptor & 0x20), descriptor >> 6
    begin = 5 + (not single) + (0, 1, 2, 4)[descriptor & 3]
    width = (int(single), 2, 4, 8)[flag]
    return int.from_bytes(content[begin : begin + width], "little") + (256 if flag == 1 else 0) if width else -1


CODECS: dict[str, Callable[[bytes, int], int]] = {
    "blosc": _of_blosc, "zstd": _of_zstd, "lz4": _of_lz4, "zlib": _of_zlib, "gzip": _of_zlib,
}  # fmt: skip
"""The number of bytes that a chunk of this codec declares, or -1 for bytes that are no such chunk."""
