"""Splitting steps of a free body with its attitude, against a C loop"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from measure import Row, c_function, compared, missing, pointer

import polhode as ph

MOMENTS, STEP = (1.0, 2.0, 3.0), 0.01
START = np.array([1.0, 0.0, 0.0, 0.0, 0.3, 1.8, 1.5])


def rows(quick: bool) -> Iterator[Row]:
    """Yield the C loop's time over ours, with compensated sums as ours and with plain ones."""
    steps = 10_000 if quick else 1_000_000
    body, times = ph.systems.FreeRigidBody(MOMENTS), np.linspace(0.0, steps * STEP, 11)
    exact = np.concatenate(ph.FreeMotion(MOMENTS, momentum=START[4:]).state(times[-1]))

    def ours() -> np.ndarray:
        method = ph.integrators.Splitting
        return ph.simulate(body, START, times, method, STEP, order=2, estimate_error=False).states[-1]

    error = float(np.abs(ours() - exact).max())
    for compensated in (True, False):
        name = "C loop, cc -O3, " + ("compensated sums" if compensated else "plain sums")
        loop = c_loop(compensated, steps)
        if loop is None:
            yield missing(f"order 2, {steps:,} steps", name, "a C compiler, as cc")
            continue
        found = compared(ours, loop, 3 if quick else 7)
        yield Row(f"order 2, {steps:,} steps", name, error, float(np.abs(loop() - exact).max()), *found)


def c_loop(compensated: bool, steps: int) -> Callable[[], np.ndarray] | None:
    """Return a function that runs the C loop, or None without a compiler."""
    run = c_function("splitting.c", *(["-DCOMPENSATED"] if compensated else []))
    if run is None:
        return None

    def call() -> np.ndarray:
        state = START.copy()
        run(steps, STEP, pointer(np.array(MOMENTS)), pointer(state))
        return state

    return call
