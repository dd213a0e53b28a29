"""Steps of a fluid on a sphere, against the same scheme written with NumPy and SciPy, and series against steps"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from measure import Row, compared
from scipy.linalg import lapack

import polhode as ph
from polhode.fields.sphere._laplacian import diagonals
from polhode.taylor.array_series import run_arrays
from polhode.taylor.runs import choose_precision

ANGLE = 0.25  # rad by which the fastest rotation turns in a step
ENOUGH = 2e-16  # of the vorticity: the change below which the peer's iterations end


def rows(quick: bool) -> Iterator[Row]:
    """Yield the peer's time over ours for isospectral midpoint steps to rounding, and how far the spectrum moved."""
    for n, steps in ((16, 4),) if quick else ((64, 40), (128, 20), (256, 10)):
        fluid = ph.fields.SphereFluid(n)
        degree = np.arange(10)
        start = fluid.random(np.where(degree > 0, 1.0 / np.maximum(degree, 1) ** 3, 0.0), seed=1)
        step = ANGLE / float(fluid.algebra.rate(fluid.stream_function(start)))
        times = np.array([0.0, step * steps])
        theirs = peer(np.asarray(start), step, steps)

        def ours(fluid=fluid, start=start, times=times, step=step) -> np.ndarray:
            method = ph.integrators.IsospectralMidpoint
            return np.asarray(ph.solve(fluid, start, times, method, step, order=2).end_state)

        before = np.linalg.eigvalsh(-1j * np.asarray(start))
        ends = [call() for call in (ours, theirs)]
        errors = [float(np.abs(np.linalg.eigvalsh(-1j * end) - before).max() / np.abs(before).max()) for end in ends]
        apart = float(np.abs(ends[0] - ends[1]).max() / np.abs(ends[0]).max())
        yield Row(f"N = {n}, {steps} steps", "NumPy and SciPy, W̃ by two complex products an iteration", *errors,
                  *compared(ours, theirs, 3 if quick else 7),
                  f"errors: of the spectrum; states differ by {apart:.1e}")  # fmt: skip


    for n, turned in ((16, 4.0),) if quick else ((33, 60.0), (96, 60.0)):
        yield from series_rows(n, turned, 3 if quick else 7)


def series_rows(n: int, turned: float, repeats: int) -> Iterator[Row]:
    """Yield the time of midpoint steps of several orders over that of Taylor series, with errors of the vorticity."""
    fluid = ph.fields.SphereFluid(n)
    start = np.asarray(fluid.random(np.where(np.arange(12) > 2, 1.0, 0.0), seed=1))
    rate = float(fluid.algebra.rate(fluid.stream_function(start)))
    times, scale = np.array([0.0, turned / rate]), np.abs(start).max()
    by = choose_precision(None)
    exact = run_arrays(fluid, start, times, by.order + 6, 0.7 * by.reach, scale=scale).states[-1]
    error = lambda state: float(np.abs(state - exact).max() / scale)  # noqa: E731
    ours = lambda: run_arrays(fluid, start, times, by.order, by.reach, scale=scale).states[-1]  # noqa: E731
    for order in (2, 4, 8):

        def theirs(order: int = order) -> np.ndarray:
            method = ph.integrators.IsospectralMidpoint
            return np.asarray(ph.solve(fluid, start, times, method, ANGLE / rate, order=order).end_state)

        errors, found = (error(ours()), error(theirs())), compared(ours, theirs, repeats)
        yield Row(f"N = {n}, {turned:g} rad by Taylor series", f"IsospectralMidpoint of order {order}", *errors, *found,
                  "errors: of the vorticity")  # fmt: skip


def peer(start: np.ndarray, step: float, steps: int) -> Callable[[], np.ndarray]:
    """Return a function that takes the steps as Modin and Viviani wrote them, each diagonal by LAPACK's LDLᵀ."""
    n = len(start)
    hbar, entries, beside = 2.0 / np.sqrt(n * n - 1.0), *diagonals(n)
    entries[0, 0] -= 1.0
    factors = [lapack.dpttrf(-entries[: n - m, m], -beside[: n - m - 1, m])[:2] for m in range(n - 1)]

    def stream_function(vorticity: np.ndarray) -> np.ndarray:
        found = np.zeros_like(vorticity)
        for m in range(n):
            values = vorticity.diagonal(-m)
            if m == 0:
                values = values - values.mean()
            if m < n - 1:
                both, _ = lapack.dpttrs(*factors[m], np.stack([values.real, values.imag], axis=1))
                values = -(both[:, 0] + 1j * both[:, 1])
            else:
                values = values / entries[0, m]
            if m == 0:
                values = values - values.mean()
            np.fill_diagonal(found[m:], values)
            if m:
                np.fill_diagonal(found[:, m:], -values.conj())
        return found

    def run() -> np.ndarray:
        now = start.copy()
        for _ in range(steps):
            middle, size = now, np.abs(now).max()
            for _ in range(100):
                x = 0.5 * step / hbar * stream_function(middle)
                product = x @ middle
                commutator = product - product.conj().T
                better = now + commutator + product @ x
                change, middle = np.abs(better - middle).max(), better
                if change <= ENOUGH * size:
                    break
            now = now + 2.0 * commutator
        return now

    return run
