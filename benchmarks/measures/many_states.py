"""Many states of free bodies and tops, against one call of Jacobi's functions for each"""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator

import numpy as np
from measure import Row, compared
from scipy.special import ellipj

import polhode as ph

MOMENTS, PEER = (1.0, 2.0, 3.0), "SciPy ellipj (sn, cn, dn alone)"
BODIES = {"short-axis": (0.3, 1.8, 1.5), "long-axis": (0.9, 1.6, 0.3), "next to the separatrix": (1e-6, 2.0, 3e-6)}


def rows(quick: bool) -> Iterator[Row]:
    """Yield the time of ``ellipj`` over ours, a state each; errors are those of the tests' oracles."""
    rng, count, repeats = np.random.default_rng(0), 2000 if quick else 100_000, 3 if quick else 9
    times = rng.uniform(0.0, 1e6, count)
    host = "Numba" if importlib.util.find_spec("numba") else "NumPy"
    jacobi = lambda: ellipj(times, 0.3)  # noqa: E731
    for name, momentum in BODIES.items():
        motion = ph.FreeMotion(MOMENTS, momentum=momentum)
        found = compared(lambda m=motion: m.state(times), jacobi, repeats)
        yield Row(f"one body, {name}, {count:,} times", PEER, None, None, *found, host)
    moments, momenta = rng.uniform(0.5, 3.0, (count, 3)), rng.normal(size=(count, 3))
    found = compared(lambda: ph.FreeMotion(moments, momentum=momenta).state(times), jacobi, repeats)
    yield Row(f"{count:,} bodies with set-up, one time each", PEER, None, None, *found, host)
    top = ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.1, 0.2, 2.5), attitude=(0.8, 0.6, 0.0, 0.0))
    found = compared(lambda: top.state(times), jacobi, repeats)
    yield Row(f"one Lagrange top, {count:,} times", PEER, None, None, *found, host)
    bodies, attitudes = moments[:, [0, 0, 1]], rng.normal(size=(count, 4))
    attitudes, mgl = attitudes / np.linalg.norm(attitudes, axis=1, keepdims=True), rng.uniform(0.2, 3.0, count)
    found = compared(
        lambda: ph.LagrangeMotion(bodies, mgl=mgl, momentum=momenta, attitude=attitudes).state(times), jacobi, repeats
    )
    yield Row(f"{count:,} Lagrange tops with set-up, one time each", PEER, None, None, *found, host)
