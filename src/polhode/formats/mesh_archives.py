"""3MF and COLLADA (DAE) files, which carry a unit, before trimesh reads them: sizes, entities, units, libraries.

Source: 3MF Consortium, *3D Manufacturing Format core specification* 1.3, section 3.4; Khronos, *COLLADA 1.5*, <asset>.
"""

from __future__ import annotations

import importlib
import io
import re
import zipfile
from pathlib import Path
from typing import NamedTuple

from polhode._base.extras import needing
from polhode.errors import FormatError, InvalidInput, shown

MODULES = {"3mf": ("lxml.etree", "networkx"), "dae": ("collada", "lxml.etree", "networkx")}  # which trimesh needs
UNITS_OF_3MF = {"micron": 1e-6, "millimeter": 1e-3, "centimeter": 1e-2, "inch": 0.0254, "foot": 0.3048, "meter": 1.0}
_MODEL = re.compile(rb"<(?:\w+:)?model\b[^>]*?\bunit\s*=\s*[\"'](\w+)[\"']")
_ASSET = re.compile(rb"<unit\b[^>]*?\bmeter\s*=\s*[\"']([^\"']+)[\"']")


class ArchiveLimits(NamedTuple):
    """Numbers beyond which an archive is refused."""

    max_unpacked: int = 1 << 28  # bytes of all files in one archive
    relative_unit_difference: float = 1e-6  # between the unit in the file and the given one


LIMITS = ArchiveLimits()


def names_its_unit(path: str | Path) -> bool:
    """Return whether mesh files of this ending name their unit."""
    return Path(path).suffix.lower().lstrip(".") in MODULES


def check_archive(path: Path, ending: str, content: bytes, unit: float | None) -> float:
    """Refuse a file that is not safe for trimesh, or whose unit contradicts the given one, and return its unit [m].

    Args:
        path: for messages.
        ending: "3mf" or "dae".
        content: of the file.
        unit: that the user gave [m], if any; it must be the file's own.

    Raises:
        InvalidInput: where a library is missing, or the unit is not that of the file.
        FormatError: for archives larger than they look, and XML that declares entities.
    """
    with needing(f"{ending.upper()} files need", "Or convert it to STL."):
        for module in MODULES[ending]:
            importlib.import_module(module)
    texts = _unpack(path, content) if ending == "3mf" else [content]
    if any(b"\0" in text for text in texts):  # other encodings could hide the entities searched for below
        raise FormatError(f"{path}: must be written in UTF-8. Export it again.")
    if any(b"<!DOCTYPE" in text or b"<!ENTITY" in text for text in texts):
        raise FormatError(f"{path}: declares a document type, which a mesh has no use for. Export it again.")
    own = _unit_of(path, ending, texts)
    if own is not None and unit is not None and abs(own - unit) > LIMITS.relative_unit_difference * own:
        raise InvalidInput(
            f"{path}: says itself that its unit is {own:g} m; got mesh_unit of {unit:g} m. Leave mesh_unit out."
        )
    return own or unit or 1.0


def _unpack(path: Path, content: bytes) -> list[bytes]:
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            size = sum(one.file_size for one in archive.infolist())
            names = [one for one in archive.namelist() if one.lower().endswith((".model", ".rels", ".xml"))]
            texts = [archive.read(name) for name in names] if size <= LIMITS.max_unpacked else []
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError, EOFError, ValueError):
        raise FormatError(f"{path}: cannot be read as a mesh: it is no archive, as 3MF is. Export it again.") from None
    if size > LIMITS.max_unpacked:
        raise FormatError(f"{path}: unpacks to {size} bytes, and may have {LIMITS.max_unpacked}. Export it smaller.")
    return texts


def _unit_of(path: Path, ending: str, texts: list[bytes]) -> float | None:
    if ending == "3mf":
        words = [match[1].decode("ascii", "replace") for text in texts if (match := _MODEL.search(text))]
        return UNITS_OF_3MF.get(words[0]) if words else UNITS_OF_3MF["millimeter"]
    match = _ASSET.search(texts[0])
    try:
        return float(match[1]) if match else 1.0
    except ValueError:
        raise FormatError(
            f"{path}: its unit must be a number of metres; got {shown(match[1] if match else '')}. Export it again."
        ) from None
