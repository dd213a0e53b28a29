"""Data inside a page: arrays as base64, in JSON that cannot end the element around it."""

from __future__ import annotations

import base64
import json
import re
from typing import Any

import numpy as np

from polhode.types import Array, Shaped

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
EXPONENT = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e([+-]?\d+)\b")


def pack(values: Shaped[Array, "..."], kind: str = "f8") -> dict[str, Any]:
    """Return an array for JSON: its numbers little-endian in base64.

    Args:
        values: any shape.
        kind: "f8", "f4", "u4", "u2" or "u1".
    """
    array = np.ascontiguousarray(values, dtype=f"<{kind}")
    return {"kind": kind, "shape": list(array.shape), "data": base64.b64encode(array.tobytes()).decode("ascii")}


def with_powers(text: str) -> str:
    """Return a text with its numbers as the page writes them.

    >>> with_powers("the first 2.62332e+07 s")
    'the first 2.62332·10⁷ s'
    """
    return EXPONENT.sub(lambda match: f"{match[1]}·10{str(int(match[2])).translate(RAISED)}", text)


def as_script_json(values: dict[str, Any]) -> str:
    """Return JSON for inside a script element, where neither ``</script`` nor ``<!--`` may appear."""
    text = json.dumps(values, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    # "<" appears in JSON only inside strings, where its escape means the same
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
