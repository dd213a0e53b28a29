"""A heavy top over 20 time units, at the error that the peer has"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
from measure import Row, compared, median
from scipy.integrate import solve_ivp

from polhode.integrators import Splitting
from polhode.systems import HeavyTop

SPAN = 20.0  # this top is chaotic: much later no two methods agree
STEPS = (0.8, 0.4, 0.2, 0.1, 0.05)
TOLERANCES = (1e-4, 1e-7, 1e-10, 1e-13)


def rows(quick: bool) -> Iterator[Row]:
    """Yield each peer at each tolerance beside the cheapest splitting whose error is no larger."""
    top = HeavyTop((2.0, 1.5, 1.0), 1.0, (0.3, 0.2, 0.9))
    start = top.pack(angular_velocity=(0.6, 0.4, 1.8))
    dopri8 = _dopri8(top, start)
    exact = np.asarray(dopri8(1e-14))
    choices = []
    for order in (6, 8):
        run = _splitting(top, start, order)
        for step in STEPS[1:3] if quick else STEPS:
            error = float(np.abs(np.asarray(run(step)) - exact).max())
            taken = median(lambda run=run, step=step: run(step).block_until_ready(), 3)
            choices.append((taken, error, order, step, run))
    field = jax.jit(top.vector_field)

    def dop853(tolerance: float) -> Any:
        slope = lambda t, y: np.asarray(field(t, y))  # noqa: E731
        return solve_ivp(slope, (0.0, SPAN), start, "DOP853", rtol=max(tolerance, 3e-14), atol=tolerance).y[:, -1]

    peers = {"diffrax Dopri8": lambda x: dopri8(x).block_until_ready(), "SciPy DOP853": dop853}
    for name, peer in peers.items():
        for tolerance in TOLERANCES[1:2] if quick else TOLERANCES:
            error = float(np.abs(np.asarray(peer(tolerance)) - exact).max())
            able = sorted((one for one in choices if one[1] <= error), key=lambda one: one[0])
            work = f"error at most {error:.0e}"
            if not able:
                yield Row(work, f"{name}, {tolerance:g}", None, error, note="no splitting tried here is as exact")
                continue
            _, ours, order, step, run = able[0]
            found = compared(lambda run=run, step=step: run(step).block_until_ready(),
                             lambda peer=peer, tolerance=tolerance: peer(tolerance), 5)  # fmt: skip
            yield Row(work, f"{name}, {tolerance:g}", ours, error, *found, f"splitting of order {order}, step {step:g}")


def _dopri8(top: HeavyTop, start: Any) -> Callable[[float], Any]:
    @jax.jit
    def run(tolerance: Any) -> Any:
        controller = diffrax.PIDController(rtol=tolerance, atol=tolerance)
        return diffrax.diffeqsolve(
            diffrax.ODETerm(lambda t, y, _: top.vector_field(t, y)), diffrax.Dopri8(), 0.0, SPAN, 1e-3, start,
            stepsize_controller=controller, max_steps=None,
        ).ys[-1]  # fmt: skip

    return run


def _splitting(top: HeavyTop, start: Any, order: int) -> Callable[[float], Any]:
    @jax.jit
    def run(step: Any) -> Any:
        solver = Splitting(top, step, order)
        return solver.advance(0.0, jnp.asarray(SPAN), start, solver.memory(start))[0]

    return run
