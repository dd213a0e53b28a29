"""A million Heisenberg spins on a cubic lattice, against a C loop over their bonds"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from measure import Row, c_function, compared, missing, pointer

import polhode as ph

STEP, STEPS = 0.05, 2
CELLS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def rows(quick: bool) -> Iterator[Row]:
    """Yield the C loop's time over ours for sweeps over all bonds, and errors of the total spin."""
    size = 20 if quick else 100
    lattice = ph.fields.Lattice(np.eye(3), shape=(size,) * 3)
    system = ph.fields.SpinLattice(lattice, bonds=[ph.fields.Bond(0, 0, cell, 1.0) for cell in CELLS])
    start = np.array(system.aligned(np.random.default_rng(1).normal(size=(*lattice.shape, 1, 3))))
    times = np.array([0.0, STEP * STEPS])
    run = c_function("spin_lattice.c")
    work, name = f"{size**3:,} Heisenberg spins, {STEPS} steps", "C loop, cc -O3, the same bonds in the same order"
    if run is None:
        yield missing(work, name, "a C compiler, as cc")
        return

    def ours() -> np.ndarray:
        return np.asarray(ph.solve(system, start, times, ph.integrators.Splitting, STEP, order=2).end_state)

    def theirs() -> np.ndarray:
        states = start.copy()
        run(size, STEPS, STEP, pointer(states))
        return states

    total = start.sum(axis=(0, 1, 2, 3))
    errors = [float(np.abs(call().sum(axis=(0, 1, 2, 3)) - total).max()) for call in (ours, theirs)]
    apart = float(np.abs(ours() - theirs()).max())
    yield Row(work, name, *errors, *compared(ours, theirs, 3 if quick else 5),
              f"errors: of the total spin; states differ by {apart:.1e}")  # fmt: skip
