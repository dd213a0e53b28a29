"""From object code to an image: its sections side by side, with the places of addresses; see ``images``."""

from __future__ import annotations

import struct
from typing import NamedTuple

from polhode._base.compiled.images import CannotLink, Image

# of libc and libm, which the process has; anything else is a part of Numba or of Python that must not be left out
OUTSIDE = frozenset((
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "ceil", "copysign", "cos", "cosh", "exp", "exp2",
    "expm1", "fabs", "floor", "fma", "fmod", "frexp", "hypot", "ldexp", "log", "log10", "log1p", "log2", "nearbyint",
    "pow", "rint", "round", "sin", "sincos", "sinh", "sqrt", "tan", "tanh", "trunc", "free", "malloc", "memcpy",
    "memmove", "memset",
))  # fmt: skip
SAME = {"numba_frexp": "frexp", "numba_ldexp": "ldexp"}  # which those of glibc are, for infinity and NaN as well
WRITABLE, LOADED_WITH = 1, 2  # flags of a section
PLAIN, ZEROS, RELOCATIONS, SYMBOLS = 1, 8, 4, 2  # kinds of one
ABSOLUTE, RELATIVE = 1, 24  # kinds of an address: from zero, and from its own place


class _Section(NamedTuple):
    name: int
    kind: int
    flags: int
    address: int
    offset: int
    size: int
    link: int
    about: int
    alignment: int
    row: int


def link(built: bytes, entry: str) -> Image:
    """Return the image of object code in ELF that begins with a function of this name.

    Raises:
        CannotLink: of what cannot be in one.
    """
    if built[:6] != b"\x7fELF\x02\x01" or struct.unpack_from("<H", built, 18) != (62,):
        raise CannotLink("no object of x86-64")
    (table,), (row, count) = struct.unpack_from("<Q", built, 40), struct.unpack_from("<HH", built, 58)
    sections = [_Section(*struct.unpack_from("<IIQQQQIIQQ", built, table + k * row)) for k in range(count)]
    code, starts = bytearray(), dict[int, int]()
    for k, section in enumerate(sections):
        if section.kind in (PLAIN, ZEROS) and section.flags & LOADED_WITH and section.size:
            if section.flags & WRITABLE or section.kind == ZEROS:
                raise CannotLink("it keeps something between two calls")
            code += bytes(-len(code) % max(section.alignment, 1))
            starts[k] = len(code)
            code += built[section.offset : section.offset + section.size]
    symbols = _read_symbols(built, sections)
    begins = next((starts[home] + value for name, home, value in symbols if name == entry and home in starts), None)
    if begins is None:
        raise CannotLink(f"there is no {entry}")
    within, outside = dict[int, int](), dict[str, tuple[int, ...]]()
    for section in sections:
        if section.kind != RELOCATIONS or section.about not in starts:
            continue
        for k in range(section.offset, section.offset + section.size, 24):
            place, about, more = struct.unpack_from("<QQq", built, k)
            place, kind, (name, home, value) = starts[section.about] + place, about & 0xFFFFFFFF, symbols[about >> 32]
            target = starts[home] + value + more if home in starts else None
            if kind == ABSOLUTE and target is not None:
                within[place] = target
            elif kind == RELATIVE and target is not None:
                struct.pack_into("<q", code, place, target - place)
            elif kind == ABSOLUTE and home == 0 and more == 0 and (known := SAME.get(name, name)) in OUTSIDE:
                outside[known] = (*outside.get(known, ()), place)
            else:
                raise CannotLink(f"address of {name}")
    return Image(bytes(code), begins, tuple(within), tuple(within.values()), outside)


def _read_symbols(built: bytes, sections: list[_Section]) -> list[tuple[str, int, int]]:
    """Return name, section and place of each symbol."""
    (table,) = (section for section in sections if section.kind == SYMBOLS)
    names = sections[table.link].offset
    found = []
    for k in range(table.offset, table.offset + table.size, 24):
        name, _, _, home, value, _ = struct.unpack_from("<IBBHQQ", built, k)
        found.append((built[names + name : built.index(b"\0", names + name)].decode(), home, value))
    return found
