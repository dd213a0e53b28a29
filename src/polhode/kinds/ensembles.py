"""Many motions at once: the samples of a sweep that a kind computes together, and its answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import numpy as np
from pydantic import BaseModel

from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.kinds.base import Spec

TableT = TypeVar("TableT", bound=BaseModel | None)


class Bodies(NamedTuple):
    """Bodies of many samples.

    Attributes:
        moments: (sample, 3) principal moments [kg m²], or (3,) for all.
        axes: (sample, 3, 3) principal axes by columns in the given ones, or (3, 3) for all.
        refused: sample → why there is no such body.
    """

    moments: Float64[Array, "*sample 3"]
    axes: Float64[Array, "*sample 3 3"]
    refused: dict[int, str]


class ManySpecs(NamedTuple):
    """Samples of a sweep: specs that share all but some numbers.

    Attributes:
        spec: of one sample; its fixed numbers hold for all.
        varied: key → values (sample, …) of the spec's numbers that differ, SI.
        bodies: of the samples; None for kinds without a body.
        spec_of: the spec of a sample; raises InvalidInput where it breaks a rule.
    """

    spec: Spec
    varied: Mapping[str, Any]
    bodies: Bodies | None
    spec_of: Callable[[int], Spec]

    @property
    def size(self) -> int:
        """How many samples there are."""
        return len(next(iter(self.varied.values())))


class Ensemble(NamedTuple):
    """Answers for many samples.

    Attributes:
        values: name of an answer, as the JSON has it → values (sample, …), NaN where it is not defined; of
            ``states.`` and a part of the state, (sample, time, …).
        refused: sample → why there is no such motion.
        alone: samples whose own reports have the answers, and whose values here mean nothing.
        by_steps: whether the motions go by steps, which take longer than closed forms.
    """

    values: dict[str, Any]
    refused: dict[int, str]
    alone: Sequence[int] = ()
    by_steps: bool = False


def vary_table(table: TableT, name: str, varied: Mapping[str, Any], count: int) -> TableT:
    """Return a spec's table with arrays (sample, …) where its numbers are varied, whole or by components.

    Args:
        table: of one sample; None stays.
        name: of the table in keys.
        varied: key → values (sample, …), those of other tables among them.
        count: how many samples there are.
    """
    if table is None:
        return table
    whole: dict[str, Any] = {}
    for key, values in varied.items():
        first, _, rest = key.partition(".")
        field, _, place = rest.partition(".")
        if first != name:
            continue
        if place:
            base = whole.get(field, np.tile(np.asarray(getattr(table, field), dtype=float), (count, 1)))
            base[:, int(place) - 1] = values
            whole[field] = base
        else:
            whole[field] = values
    return table.model_copy(update=whole)
