"""Checks of HDF5 files before their arrays are read: only what polhode writes, no link to other files.

HDF5 can keep arrays in other files, load plugins to decode them, and declare sizes that nothing is stored for.

Source: The HDF Group, *HDF5 File Format Specification* and *HDF5 Filters*.
"""

from __future__ import annotations

import math
import mmap
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from polhode.errors import FormatError, shown
from polhode.formats.zarr_gate import check_size

HEAP = b"GCOL\x01\0\0\0"  # how a heap of texts and references of varying length begins
FILTERS = {1: "deflate", 2: "shuffle", 3: "fletcher32"}  # those in HDF5 itself, whose output is bounded
OF_DIMENSIONS = ("DIMENSION_LIST", "REFERENCE_LIST")  # how NetCDF says which axis is which


class Hdf5Limits(NamedTuple):
    """Numbers beyond which a file of HDF5 is refused before it is read."""

    max_variables: int = 2000
    max_attributes: int = 200
    max_texts: int = 10_000  # of one variable; names of axes are a handful
    max_bytes: int = 65536  # of an attribute, which HDF5 itself keeps in a header


LIMITS = Hdf5Limits()


def _check_heaps(path: Path, stored: int) -> None:
    """Refuse heaps of text and references with an entry that leads nowhere: HDF5 would loop on them for ever."""
    if not stored:
        return
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
        begin = content.find(HEAP)
        while begin >= 0:
            size = int.from_bytes(content[begin + 8 : begin + 16], "little")
            end, place = begin + size, begin + 16
            if end > stored:
                _refuse(path, "is cut short or damaged, as a heap of its text ends outside of it")
            while place + 16 <= end:
                number = int.from_bytes(content[place : place + 2], "little")
                taken = int.from_bytes(content[place + 8 : place + 16], "little")
                step = 16 + -(-taken // 8) * 8 if number else taken
                if not 16 <= step <= end - place:
                    _refuse(path, "is damaged in a heap of its text")
                place += step
            begin = content.find(HEAP, begin + 8)


def check_hdf5(path: Path) -> None:
    """Refuse files unlike those that polhode writes: variables of numbers or text, side by side, all in the file.

    Raises:
        FormatError: for links and groups, arrays kept elsewhere, filters beyond ``FILTERS``, types other than numbers
            and text, and arrays larger than the stored bytes can hold.
        Exception: whatever h5py raises on a broken file.
    """
    import h5py

    stored = path.stat().st_size
    _check_heaps(path, stored)
    with h5py.File(path, "r") as file:
        if len(file) > LIMITS.max_variables:
            _refuse(path, f"has {len(file)} variables, and may have {LIMITS.max_variables}")
        _check_attributes(path, "the file", file)
        declared = 0
        for name in file:
            where = f"variable {shown(name)}"
            if not isinstance(file.get(name, getlink=True), h5py.HardLink):
                _refuse(path, f"{where} is a link, which may lead to another file")
            item = file[name]
            if not isinstance(item, h5py.Dataset):
                _refuse(path, f"{where} is a group or a type, and polhode writes neither")
            declared += _check_variable(path, where, item, stored)
        check_size(path, declared, stored)


def _refuse(path: Path, what: str) -> NoReturn:
    raise FormatError(f"{path}: {what}. Write it again with polhode.")


def _check_variable(path: Path, where: str, item: Any, stored: int) -> int:
    """Return the bytes of a variable."""
    import h5py

    layout = item.id.get_create_plist()
    if layout.get_external_count() or layout.get_layout() == h5py.h5d.VIRTUAL:
        _refuse(path, f"{where} keeps its values in other files")
    for k in range(layout.get_nfilters()):
        number, name = layout.get_filter(k)[0], layout.get_filter(k)[3]
        if number not in FILTERS:
            known = ", ".join(FILTERS.values())
            _refuse(path, f"{where} has the filter {number} {shown(name)}; read are {known}, as others load plugins")
    if item.shape is None:
        _refuse(path, f"{where} is empty")
    _check_type(path, where, item.dtype, math.prod(item.shape))
    if item.chunks is not None:
        check_size(path, math.prod(item.chunks) * item.dtype.itemsize, stored)
    _check_attributes(path, where, item)
    return math.prod(item.shape) * item.dtype.itemsize


def _check_type(path: Path, where: str, dtype: Any, count: int) -> None:
    import h5py

    text = h5py.check_string_dtype(dtype) is not None
    if text and count > LIMITS.max_texts:
        _refuse(path, f"{where} has {count} texts, and may have {LIMITS.max_texts}")
    if not text and not (dtype.kind in "fiub" and dtype.shape == () and dtype.itemsize <= 8):
        _refuse(path, f"{where} is of type {shown(str(dtype))}, and polhode writes numbers and text")


def _check_attributes(path: Path, where: str, item: Any) -> None:
    import h5py

    count = h5py.h5a.get_num_attrs(item.id)
    if count > LIMITS.max_attributes:
        _refuse(path, f"{where} has {count} attributes, and may have {LIMITS.max_attributes}")
    for k in range(count):
        attribute = h5py.h5a.open(item.id, index=k)
        name = attribute.name.decode("utf-8", "replace")
        size = attribute.get_storage_size()
        if size > LIMITS.max_bytes:
            _refuse(path, f"attribute {shown(name)} of {where} has {size} bytes, and may have {LIMITS.max_bytes}")
        if name not in OF_DIMENSIONS:
            _check_type(path, f"attribute {shown(name)} of {where}", attribute.dtype, math.prod(attribute.shape or ()))
