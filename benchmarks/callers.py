"""Motions as users of each library call for them: a function of the tolerance or step that gives the ends (C, …).

heyoka's are in ``heyoka_peer``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
from cases import Case
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.integrators import Taylor

KNOWN = 64  # copies whose errors are measured


def make_copies(case: Case, count: int) -> np.ndarray:
    """Return different starts (C, …) on the motion of the case, its own first."""
    return np.asarray(ph.simulate(case.system, case.start, np.linspace(0.0, 3.0, count), estimate_error=False).states)


def find_exact(case: Case, starts: np.ndarray, span: float) -> np.ndarray:
    """Return ends of some copies with twice as many digits, where the rates allow it."""
    some = starts[:KNOWN]
    try:
        return simulated(case, some, span, method=Taylor(precision="extended"))
    except ph.InvalidInput:
        return simulated(case, some, span, method=Taylor(order=40))


def off(found: np.ndarray, exact: np.ndarray) -> float:
    """Return the largest error of those that are known, of the largest component."""
    return float(np.abs(found[: len(exact)] - exact).max() / np.abs(exact).max())


def simulated(
    case: Case, starts: np.ndarray, span: float, tolerance: float | None = None, known: bool = False, **also: Any
) -> np.ndarray:
    """Return the ends by ``ph.simulate``, with an error estimate if they are to be known."""
    found = ph.simulate(
        case.system, starts[0] if len(starts) == 1 else starts, [0.0, span], estimate_error=known,
        tolerance=None if tolerance is None else float(tolerance), **also,
    )  # fmt: skip
    states = np.asarray(found.states)
    return states.reshape(len(starts), 2, *case.start.shape)[:, -1]


def dopri8(case: Case, starts: np.ndarray, span: float) -> Callable[[float], np.ndarray]:
    """Return diffrax's Dopri8, compiled whole; of several copies, mapped over them."""

    @jax.jit
    def run(states: Any, tolerance: Any) -> Any:
        term = diffrax.ODETerm(lambda t, y, args: case.system.vector_field(t, y))
        control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
        one: Any = lambda state: jnp.asarray(diffrax.diffeqsolve(  # noqa: E731
            term, diffrax.Dopri8(), 0.0, span, None, state, stepsize_controller=control, max_steps=100_000
        ).ys)[-1]  # fmt: skip
        return one(states[0])[None] if len(states) == 1 else jax.vmap(one)(states)

    return lambda tolerance: np.asarray(run(jnp.asarray(starts), tolerance))


def dop853(case: Case, starts: np.ndarray, span: float) -> Callable[[float], np.ndarray]:
    """Return SciPy's DOP853 with compiled rates, one copy after the other."""
    rates, shape = jax.jit(case.system.vector_field), case.start.shape
    slope = lambda t, y: np.asarray(rates(t, y.reshape(shape))).ravel()  # noqa: E731

    def run(tolerance: float) -> np.ndarray:
        by: dict[str, Any] = {"rtol": max(tolerance, 3e-14), "atol": tolerance}
        return np.stack([solve_ivp(slope, (0.0, span), start.ravel(), "DOP853", **by).y[:, -1].reshape(shape)
                         for start in starts])  # fmt: skip

    return run
