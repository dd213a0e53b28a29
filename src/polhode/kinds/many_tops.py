"""How the tops of many samples start: at once where weight, lean and spin vary, otherwise each by its own spec."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from polhode.bodies._pivot import about_pivot, with_gravity
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.ensembles import ManySpecs, vary_table
from polhode.reports.top_starts import TopStarts, build_starts
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, Float64

MakeStart = Callable[[Spec[Any]], tuple[HeavyTop, Float64[Array, "3"], Float64[Array, "4"]]]
AT_ONCE = ("system.gravity", "system.lean")  # and all of [spin]; what else varies changes the body or its pivot


class ManyTops(NamedTuple):
    """Tops of samples, along their principal axes; those refused are at rest.

    Attributes:
        moments: (sample, 3) about the fixed point [kg m²].
        mgl: (sample,) weight times distance [N m].
        momentum: (sample, 3) at the start [kg m²/s].
        attitude: (sample, 4) then.
        tops: the system of each sample that was set up by itself.
        refused: sample → why there is no such top.
    """

    moments: Float64[Array, "sample 3"]
    mgl: Float64[Array, "sample"]
    momentum: Float64[Array, "sample 3"]
    attitude: Float64[Array, "sample 4"]
    tops: Mapping[int, HeavyTop]
    refused: dict[int, str]


def start_tops(samples: ManySpecs, make_start: MakeStart) -> ManyTops:
    """Return the tops of samples, and how they start.

    Args:
        samples: what differs between them.
        make_start: of one spec, which may refuse it.
    """
    count = samples.size
    moments, mgl, momentum = np.ones((count, 3)), np.ones(count), np.zeros((count, 3))
    attitude = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    alone, tops, refused = np.arange(count), {}, {}
    if all(key in AT_ONCE or key.startswith("spin.") for key in samples.varied):
        top = make_start(samples.spec)[0]
        if float(top.mgl) != 0.0:
            starts = start_together(samples, top)
            fine, alone = ~starts.doubtful, np.flatnonzero(starts.doubtful)
            moments[:], mgl[fine] = np.asarray(top.moments), starts.mgl[fine]
            momentum[fine], attitude[fine] = starts.momentum[fine], starts.attitude[fine]
    for k in alone.tolist():
        try:
            tops[k], momentum[k], attitude[k] = make_start(samples.spec_of(k))
            moments[k], mgl[k] = np.asarray(tops[k].moments), float(tops[k].mgl)
        except InvalidInput as error:
            refused[k] = str(error)
    return ManyTops(moments, mgl, momentum, attitude, tops, refused)


def start_together(samples: ManySpecs, top: HeavyTop) -> TopStarts:
    """Return how many samples of a top that is not free start, which differ by weight, lean and spin."""
    spec, count = samples.spec, samples.size
    assert spec.body is not None
    table = vary_table(spec.system, "system", samples.varied, count)
    mgl = np.full(count, float(top.mgl))
    if "system.gravity" in samples.varied:
        mgl = with_gravity(spec.body, about_pivot(spec.body, table.pivot, 1.0).arm, np.asarray(table.gravity))
    return build_starts(top, mgl, vary_table(spec.spin, "spin", samples.varied, count), table.lean)
