"""Checks of the folder of a sweep before anything in it is used."""

from __future__ import annotations

import contextlib
import json
import math
import os
from pathlib import Path
from typing import Any

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.opening import MB, read_file
from polhode.formats.zarr_gate import CODECS
from polhode.sweeps.columns import Column
from polhode.sweeps.layout import COMPRESSOR

AGAIN = "Run the sweep again; what is damaged is computed again."
ELSEWHERE = "or choose another folder with `store`."


def check_folder(store: Path, folder: Path, folders: set[str]) -> None:
    """Refuse a path that is no folder, or a folder that holds anything but files and these folders.

    Raises:
        FormatError: naming it.
    """
    name = shown(folder.relative_to(store).as_posix())
    if folder.is_symlink() or not folder.is_dir():
        raise FormatError(f"{store}: {name} is not a folder. Put it back, {ELSEWHERE}")
    with os.scandir(folder) as entries:
        for entry in entries:
            fits = entry.is_dir if entry.name in folders else entry.is_file
            if not (entry.is_symlink() or entry.is_file() or entry.is_dir()):
                raise FormatError(f"{store}: {shown(entry.name)} in {name} is neither a file nor a folder. Take it "
                                  f"out, {ELSEWHERE}")
            if not fits(follow_symlinks=False):
                raise FormatError(f"{store}: {name} has something in it that a sweep does not write, "
                                  f"{shown(entry.name)}. Take it out, {ELSEWHERE}")


def check_file(store: Path, name: str) -> None:
    """Refuse anything but a file under a name; the file may be missing.

    Raises:
        FormatError: naming it.
    """
    path = store / name
    if os.path.lexists(path) and (path.is_symlink() or not path.is_file()):
        raise FormatError(f"{store}: {shown(name)} is not a file. Put it back, {ELSEWHERE}")


def says(path: Path, wanted: bytes) -> bool:
    """Whether a document has this content; attributes may say more than it."""
    if not os.path.lexists(path):
        return False
    try:
        content = read_file(path, "Zarr", len(wanted) + MB)
    except InvalidInput:
        return False
    if content == wanted or path.name not in (".zattrs", ".zmetadata"):
        return content == wanted
    try:
        return _holds(json.loads(content), json.loads(wanted))
    except (ValueError, RecursionError):
        return False


def _holds(content: Any, wanted: Any) -> bool:
    if isinstance(wanted, dict):
        return isinstance(content, dict) and all(key in content and _holds(content[key], wanted[key]) for key in wanted)
    return type(content) is type(wanted) and content == wanted


def unpack_chunk(path: Path, column: Column, count: int) -> Any:
    """Return the values (count, …) in the file of a chunk, whose size is checked before it is unpacked.

    Raises:
        InvalidInput: for what is no such file.
    """
    from numcodecs import get_codec

    shape = (count, *column.shape)
    whole = math.prod(shape) * column.type.itemsize
    content, data = read_file(path, "chunk", whole + whole // 64 + MB), b""
    if CODECS[COMPRESSOR["id"]](content, whole) == whole:
        with contextlib.suppress(Exception):  # whatever a decoder makes of damaged bytes
            data = bytes(get_codec(COMPRESSOR).decode(content))  # type: ignore[arg-type]
    if len(data) != whole:
        raise FormatError(f"{path}: is damaged. {AGAIN}")
    return np.frombuffer(data, dtype=column.type).reshape(shape)
