"""Marks of finished chunks: checksums of their data, and their part of the statistics, under a seal.

A mark is JSON under a seal. The seal reveals damage, and the JSON says of which sweep and chunk it is, so that a copied
or renamed mark is none; what is read is checked in form all the same.
"""

from __future__ import annotations

import hashlib
import math
from itertools import pairwise
from typing import Annotated, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from polhode._base.seals import seal, unseal
from polhode.sweeps.columns import Column
from polhode.sweeps.evaluation import Chunk
from polhode.sweeps.layout import Layout
from polhode.sweeps.summary import KNOTS, Numbers, Summary, summarise

Digest = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]


class _Sealed(BaseModel):
    """A part of a mark; sums of large numbers may be infinite."""

    model_config = ConfigDict(extra="forbid", frozen=True, ser_json_inf_nan="constants")


class OfArray(_Sealed):
    """The digest and summary of one input, output, or the status.

    Attributes:
        digest: of its values.
        summary: of them, in words or by component.
    """

    digest: Digest
    summary: Summary


class Mark(_Sealed):
    """A finished chunk.

    Attributes:
        sweep: its fingerprint.
        chunk: its number.
        arrays: of inputs, outputs and status, by name.
        reasons: what the first refused samples were refused for: number of the sample and text.
    """

    sweep: Digest
    chunk: int
    arrays: dict[str, OfArray]
    reasons: list[tuple[int, str]]

    @classmethod
    def of(cls, chunk: Chunk, number: int, layout: Layout) -> Mark:
        arrays = {name: OfArray(digest=hash_array(values), summary=summarise(values))
                  for name, values in chunk.values.items()}
        longest = 100_000  # characters
        reasons = [(sample, why[:longest]) for sample, why in chunk.reasons]
        return cls(sweep=layout.fingerprint, chunk=number, arrays=arrays, reasons=reasons)

    @property
    def digests(self) -> dict[str, str]:
        """Of the values of all arrays, by name."""
        return {name: array.digest for name, array in self.arrays.items()}


def pack_mark(mark: Mark) -> bytes:
    """Return a mark as the bytes of its file."""
    return seal(mark.model_dump_json().encode())


def read_mark(content: bytes, number: int, layout: Layout) -> Mark | None:
    """Return the mark of a chunk from the bytes of its file; None for anything else."""
    text = unseal(content)
    if text is None:
        return None
    try:
        mark = Mark.model_validate_json(text, strict=True)
    except ValidationError:
        return None
    columns = {column.name: column for column in layout.columns}
    low, high = layout.sample_range(number)
    fits = (mark.sweep == layout.fingerprint and mark.chunk == number and mark.arrays.keys() == columns.keys()
            and len(mark.reasons) <= 3 and all(low <= sample < high for sample, _ in mark.reasons)
            and all(_fits(array.summary, columns[name], high - low)
                    for name, array in mark.arrays.items()))
    return mark if fits else None


def _fits(summary: Summary, column: Column, samples: int) -> bool:
    """Whether a summary can be that of so many values of a column."""
    if isinstance(summary, dict):
        return column.text and sum(summary.values()) == samples and all(count > 0 for count in summary.values())
    many = int(np.prod(column.shape, dtype=int))
    return not column.text and len(summary) == many and all(_can_summarise(numbers, samples) for numbers in summary)


def _can_summarise(numbers: Numbers, samples: int) -> bool:
    """Whether numbers can be the summary of one part of at most so many."""
    if not numbers.count:
        return numbers == Numbers()
    if not 0 < numbers.count <= samples or len(numbers.parts) != 1:
        return False
    (count, knots), ends = numbers.parts[0], (numbers.low, numbers.high)
    in_order = all(a <= b for a, b in pairwise(knots)) and all(map(math.isfinite, knots))
    return count == numbers.count and len(knots) == min(KNOTS, count) and in_order and (knots[0], knots[-1]) == ends


def hash_array(values: Any) -> str:
    """Return the SHA-256 of an array, its type and form."""
    array = np.ascontiguousarray(values)
    digest = hashlib.sha256(f"{array.dtype.str} {array.shape}\n".encode())
    digest.update(array.tobytes())
    return digest.hexdigest()
