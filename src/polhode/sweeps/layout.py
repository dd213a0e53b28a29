"""The layout of a sweep's store. It follows from the sweep alone, so that nothing in a store need be trusted.

Arrays are those of Zarr's format 2: for each array a folder with documents about it, and a file for each chunk.
"""

from __future__ import annotations

import hashlib
import json
import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from polhode._base.extras import needing
from polhode.formats.zarr_gate import OF_A_SWEEP
from polhode.sweeps.columns import Column

HOME, PLAN, CHUNKS, LOCK = OF_A_SWEEP, "plan.json", "chunks", "lock"
FORMAT, EARLIER_FORMATS = 3, (1, 2)
COMPONENTS = {3: "axis", 4: "quaternion"}
COMPRESSOR = {"id": "blosc", "cname": "lz4", "clevel": 5, "shuffle": 1, "blocksize": 0}
"""Said here, as zarr's own choice changes with its releases."""


def import_zarr() -> Any:
    """Return zarr, or raise InvalidInput where it is not installed."""
    with needing("Sweeps need"):
        import zarr
        import zarr.storage
    return zarr


@dataclass(frozen=True, eq=False)
class Layout:
    """The store of one sweep.

    Attributes:
        parts: digests of everything that its numbers depend on, by what it is in words.
        samples: how many.
        chunk: samples in one chunk; the last may have fewer.
        keep: "all", or "statistics" alone.
        columns: of inputs, outputs and status.
        times: of states [s].
        header: global attributes.
    """

    parts: dict[str, str]
    samples: int
    chunk: int
    keep: str
    columns: tuple[Column, ...]
    times: tuple[float, ...]
    header: dict[str, Any]

    @property
    def fingerprint(self) -> str:
        """The digest of everything that its numbers depend on."""
        return hashlib.sha256(json.dumps(sorted(self.parts.items())).encode()).hexdigest()

    @property
    def chunks(self) -> int:
        return math.ceil(self.samples / self.chunk)

    @property
    def plan(self) -> dict[str, Any]:
        """The fingerprint that identifies the store, as JSON."""
        return {"format": FORMAT, "fingerprint": self.fingerprint, "samples": self.samples, "chunk": self.chunk,
                "keep": self.keep, "made_from": self.parts}  # fmt: skip

    @property
    def arrays(self) -> dict[str, Column]:
        """The columns that are kept as arrays, by name."""
        return {column.name: column for column in self.columns} if self.keep == "all" else {}

    def sample_range(self, number: int) -> tuple[int, int]:
        """Return the samples low, …, high − 1 of a chunk."""
        low = number * self.chunk
        return low, min(low + self.chunk, self.samples)

    def chunk_path(self, column: Column, number: int) -> str:
        """Return the path of a chunk of an array, within the store."""
        return f"{column.name}/{'.'.join([str(number), *['0'] * len(column.shape)])}"

    @property
    def largest_mark(self) -> int:
        """Bytes that a mark may have: three reasons, knots of each component, and each sample another word."""
        numbers = sum(int(np.prod(column.shape, dtype=int)) for column in self.columns)
        words = self.chunk * sum(column.text for column in self.columns)
        return 1_000_000 + 10_000 * numbers + 400 * words

    @cached_property
    def documents(self) -> dict[str, bytes]:
        """The files of the store besides chunks of samples, by path: documents, and the times."""
        zarr = import_zarr()
        packed: dict[str, Any] = {}
        store = zarr.storage.MemoryStore(packed)
        group = zarr.create_group(store, zarr_format=2, attributes={"source": "polhode", **self.header})
        for column in self.arrays.values():
            group.create_array(
                column.name, shape=(self.samples, *column.shape), chunks=(self.chunk, *column.shape),
                dtype=column.type, fill_value=None if column.text else np.nan, compressors=COMPRESSOR, filters=None,
                attributes={"_ARRAY_DIMENSIONS": _dimensions(column, bool(self.times)), **_attributes(column)},
            )
        if self.times and self.arrays:
            clock = group.create_array("time", shape=(len(self.times),), chunks=(len(self.times),), dtype="<f8",
                                       compressors=COMPRESSOR, filters=None,
                                       attributes={"_ARRAY_DIMENSIONS": ["time"], "units": "s"})
            clock[:] = np.asarray(self.times)
        zarr.consolidate_metadata(store, zarr_format=2)
        documents = {path: part.to_bytes() for path, part in packed.items()}
        return documents | {f"{HOME}/{PLAN}": json.dumps(self.plan, indent=1).encode()}


def _dimensions(column: Column, states: bool) -> list[str]:
    own = list(column.shape)
    names = ["sample"]
    if states and column.name.startswith("states."):
        names.append("time")
        own = own[1:]
    return names + [COMPONENTS.get(size, f"component_{size}") for size in own]


def _attributes(column: Column) -> dict[str, str]:
    unit = column.unit.replace("²", "2").replace("³", "3").replace("°", "deg")
    attributes = {} if column.text else {"units": unit or "1"}
    return attributes | ({"comment": column.note} if column.note else {})
