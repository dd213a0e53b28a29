"""Many heavy tops stepped in one call, against a C loop over them"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from measure import Row, c_function, compared, missing, pointer

import polhode as ph

MOMENTS, WEIGHT, SPAN = (2.0, 1.5, 1.0), (0.3, 0.2, 0.9), 5.0
STEPS = (0.05, 0.025)


def rows(quick: bool) -> Iterator[Row]:
    """Yield the C loop's time over ours at two steps, and the largest errors of both."""
    count = 200 if quick else 10_000
    top = ph.systems.HeavyTop(MOMENTS, float(np.linalg.norm(WEIGHT)), WEIGHT)
    spins = np.random.default_rng(1).normal(size=(count, 3))
    start, times = np.array(top.pack(angular_velocity=spins)), np.array([0.0, SPAN])
    exact = np.asarray(ph.solve(top, start, times, ph.integrators.Splitting, 0.025, order=8).end_state)
    run = c_function("heavy_tops.c")
    for step in STEPS:
        work, name = f"{count:,} tops, step {step:g}", "C loop, cc -O3, the same order and sums"
        if run is None:
            yield missing(work, name, "a C compiler, as cc")
            continue

        def ours(step: float = step) -> np.ndarray:
            return np.asarray(ph.solve(top, start, times, ph.integrators.Splitting, step, order=2).end_state)

        def theirs(step: float = step) -> np.ndarray:
            states = start.copy()
            run(count, round(SPAN / step), step, pointer(np.array(MOMENTS)), pointer(np.array(WEIGHT)), pointer(states))
            return states

        errors = [float(np.median(np.abs(call() - exact).max(axis=1))) for call in (ours, theirs)]
        yield Row(work, name, *errors, *compared(ours, theirs, 3 if quick else 7), "errors: medians of all tops")
