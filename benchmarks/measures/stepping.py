"""Splitting steps of a free body with its attitude, against a C loop"""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from measure import Row, compared, missing

import polhode as ph

MOMENTS, STEP = (1.0, 2.0, 3.0), 0.01
START = np.array([1.0, 0.0, 0.0, 0.0, 0.3, 1.8, 1.5])
SOURCE = Path(__file__).parents[1] / "splitting.c"


def rows(quick: bool) -> Iterator[Row]:
    """Yield the C loop's time over ours, with compensated sums as ours and with plain ones."""
    steps = 10_000 if quick else 1_000_000
    body, times = ph.systems.FreeRigidBody(MOMENTS), np.linspace(0.0, steps * STEP, 11)
    exact = np.concatenate(ph.FreeMotion(MOMENTS, START[4:]).state(times[-1]))

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
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        return None
    flags = ["-O3", "-march=native", "-shared", "-fPIC", *(["-DCOMPENSATED"] if compensated else [])]
    with tempfile.TemporaryDirectory() as folder:
        library = str(Path(folder) / "splitting.so")
        subprocess.run([compiler, *flags, str(SOURCE), "-o", library, "-lm"], check=True)
        run = ctypes.CDLL(library).run
    numbers = ctypes.POINTER(ctypes.c_double)
    run.argtypes = [ctypes.c_long, ctypes.c_double, numbers, numbers]

    def call() -> np.ndarray:
        state, moments = START.copy(), np.array(MOMENTS)
        run(steps, STEP, moments.ctypes.data_as(numbers), state.ctypes.data_as(numbers))
        return state

    return call
