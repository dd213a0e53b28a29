"""From a TOML file to nested tables, within bounds far beyond those of any reasonable spec."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any, NamedTuple

from polhode.errors import FormatError, shown
from polhode.formats.opening import MB, read_text

LARGEST = MB  # bytes; some thousand parts
ATOMS = ".xyz", ".pdb", ".mol"  # endings
_DOT = re.compile(r"\.[ \t]*[\w-]")
_QUOTED_DOT = re.compile(r"[\"'][ \t]*\.|\.[ \t]*[\"']")
REMEDY = "Values with units stand in quotes."


class ParsingLimits(NamedTuple):
    """Numbers beyond which a spec is refused before it is parsed."""

    max_depth: int = 16  # lists and tables inside each other; a spec has five
    max_dots: int = 32  # in one key: tomllib takes a time that grows with their square


LIMITS = ParsingLimits()


def read_tables(path: Path, kind: str = "spec") -> dict[str, Any]:
    """Return the tables of a TOML file; ``kind`` names it in messages.

    Raises:
        InvalidInput: if it is missing, not a regular file, or cannot be read.
        FormatError: if it is not TOML, too large or too deeply nested.
    """
    text = read_text(path, kind, LARGEST)
    if _longest_key(text) > LIMITS.max_dots:
        dotted = f"has a key of more than {LIMITS.max_dots} names with dots between"
        raise FormatError(f"{path}: {dotted}. A spec needs three.")
    try:
        tables = tomllib.loads(text, parse_float=_read_float)
    except FormatError as error:
        raise FormatError(f"{path}: {error}") from None
    except tomllib.TOMLDecodeError as error:
        if path.suffix.lower() in ATOMS:
            raise FormatError(
                f'{path}: holds atoms; it is not a {kind}. Write a spec with molecule = "{path.name}" under [body], or '
                "give the file to `polhode levels`."
            ) from None
        raise FormatError(f"{path}: is not TOML ({error}). {REMEDY}") from None
    except ValueError:  # Python reads no whole number of more than some thousand digits
        raise FormatError(f"{path}: has a number of too many digits. {REMEDY}") from None
    except RecursionError:
        raise FormatError(_too_deep(path)) from None
    if _is_deeper(tables, LIMITS.max_depth):
        raise FormatError(_too_deep(path))
    return name_parts(tables)


def name_parts(tables: dict[str, Any]) -> dict[str, Any]:
    """Return tables in which a body's ``parts``, as its list may be called too, is ``part``."""
    body = tables.get("body")
    if not isinstance(body, dict) or "parts" not in body or "part" in body:
        return tables
    return tables | {"body": {"part" if key == "parts" else key: value for key, value in body.items()}}


def _read_float(text: str) -> float:
    """Return a number of TOML as Python does; refuse one that vanishes in a double."""
    value = float(text)
    if value == 0.0 and re.search("[1-9]", re.split("[eE]", text)[0]):
        raise FormatError(f"has the number {shown(text)}, which is too small for a double. Write 0 if zero is meant.")
    return value


def _too_deep(path: Path) -> str:
    nested = f"has lists or tables more than {LIMITS.max_depth} deep inside each other"
    return f"{path}: {nested}. A spec needs five. Check brackets."


def _longest_key(text: str) -> int:
    """Return an upper bound of the dots in any key; only the parser can tell keys from text."""
    bare = max(len(_DOT.findall(piece)) for piece in re.split(r"[\n=,{}\[\]]", text))
    quoted = len(_QUOTED_DOT.findall(text))
    return max(bare, quoted // 4)


def _is_deeper(value: Any, depth: int) -> bool:
    """Whether tables and lists go deeper than that; without recursion, which has its own bound."""
    level = [value]
    for _ in range(depth):
        level = [item for one in level for item in (one.values() if isinstance(one, dict) else one)
                 if isinstance(item, dict | list)]
    return bool(level)
