"""One heavy top over a short and a long time, at the error that the peer has"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
from measure import Row, compared, median
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.integrators import Splitting
from polhode.systems import HeavyTop

ORDERS, STEPS = (2, 4, 6, 8), (1.6, 0.8, 0.4, 0.28, 0.2, 0.14, 0.1, 0.07, 0.05)
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14)


class Case(NamedTuple):
    """A top, its packed start, how long it moves, and what it is at the end: its first components, and why so."""

    name: str
    top: HeavyTop
    start: Any
    span: float
    end: Any


def rows(quick: bool) -> Iterator[Row]:
    """Yield each peer at each tolerance beside the cheapest splitting whose error is no larger."""
    for case in cases(quick):
        choices = list(_choices(case, quick))
        peers = {"diffrax Dopri8": _dopri8(case), "SciPy DOP853": _dop853(case)}
        for name, peer in peers.items():
            for tolerance in TOLERANCES[1:2] if quick else TOLERANCES:
                error = _error(case, peer(tolerance))
                if not error < 1e-2:
                    continue
                able = sorted((one for one in choices if one[1] <= error), key=lambda one: one[0])
                work = f"{case.name}, error at most {error:.0e}"
                if not able:
                    yield Row(work, f"{name}, {tolerance:g}", None, error, note="no splitting tried here is as exact")
                    continue
                _, ours, order, step, run = able[0]
                found = compared(lambda run=run, step=step: run(step).block_until_ready(),
                                 lambda peer=peer, tolerance=tolerance: np.asarray(peer(tolerance)), 5)  # fmt: skip
                note = f"splitting of order {order}, step {step:g}"
                yield Row(work, f"{name}, {tolerance:g}", ours, error, *found, note)


def cases(quick: bool) -> Iterator[Case]:
    """Yield a chaotic top over a short time, and over a long one a top whose motion is known in closed form."""
    top = HeavyTop((2.0, 1.5, 1.0), 1.0, (0.3, 0.2, 0.9))
    case = Case("no integrable case, t = 20", top, top.pack(angular_velocity=(0.6, 0.4, 1.8)), 20.0, None)
    yield case._replace(end=np.asarray(_dopri8(case)(1e-15)))
    attitude = np.array([0.9, 0.3, 0.2, 0.1]) / np.sqrt(0.95)
    moments = (1.5, 1.5, 1.0)
    top = HeavyTop(moments, 1.0)
    start = top.pack(attitude, angular_velocity=(0.6, 0.4, 1.8))
    motion = ph.LagrangeMotion(moments, mgl=1.0, momentum=np.asarray(start[4:7]), attitude=attitude)
    for span in (20.0,) if quick else (20.0, 1000.0):
        yield Case(f"Lagrange's, t = {span:,.0f}", top, start, span, np.concatenate(motion.state(span)))


def _error(case: Case, end: Any) -> float:
    return float(np.abs(np.asarray(end)[: len(case.end)] - case.end).max())


def _choices(case: Case, quick: bool) -> Iterator[tuple[float, float, int, float, Any]]:
    for order in ORDERS[2:] if quick else ORDERS:
        run = _splitting(case, order)
        for step in STEPS[2:3] if quick else STEPS:
            error = _error(case, run(step))
            taken = median(lambda run=run, step=step: run(step).block_until_ready(), 3)
            yield taken, error, order, step, run


def _dopri8(case: Case) -> Callable[[float], Any]:
    @jax.jit
    def run(tolerance: Any) -> Any:
        controller = diffrax.PIDController(rtol=tolerance, atol=tolerance)
        return diffrax.diffeqsolve(
            diffrax.ODETerm(lambda t, y, _: case.top.vector_field(t, y)), diffrax.Dopri8(), 0.0, case.span, 1e-3,
            case.start, stepsize_controller=controller, max_steps=None,
        ).ys[-1]  # fmt: skip

    return run


def _dop853(case: Case) -> Callable[[float], Any]:
    field = jax.jit(case.top.vector_field)

    def run(tolerance: float) -> Any:
        slope = lambda t, y: np.asarray(field(t, y))  # noqa: E731
        relative = max(tolerance, 3e-14)
        return solve_ivp(slope, (0.0, case.span), case.start, "DOP853", rtol=relative, atol=tolerance).y[:, -1]

    return run


def _splitting(case: Case, order: int) -> Callable[[float], Any]:
    @jax.jit
    def run(step: Any) -> Any:
        solver = Splitting(case.top, step, order)
        return solver.advance(0.0, jnp.asarray(case.span), case.start, solver.memory(case.start))[0]

    return run
