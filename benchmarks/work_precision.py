"""Error against work of every integrator, as the docs show it: ``python benchmarks/work_precision.py PICTURE``.

A free body and a heavy top, attitude included, over a fixed time; errors are the largest of all components against a
converged solution (the free body's closed form; for the top Dopri8 and a short-step splitting, which must agree). Work
is counted in evaluations of the velocity, for splittings in exact flows, and measured as time on one core.
"""

from __future__ import annotations

import os
import sys
import time
import warnings

if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

import diffrax
import jax
import jax.numpy as jnp
import matplotlib.pyplot as plt
import numpy as np
from heyoka_peer import heyoka_equations
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.integrators import LieMidpoint, MuntheKaas, Splitting
from polhode.taylor.runs import choose_precision, run_copies

SPAN = 20.0
MOMENTS = (1.0, 2.0, 3.0)
ATTITUDE = (1.0, 0.0, 0.0, 0.0)
STEPS = 0.4 * 2.0 ** -np.arange(0, 8)
REPEATS = 3
TOLERANCES = 10.0 ** -np.arange(4, 14)
METHODS = {
    "splitting 2": (Splitting, 2), "splitting 4": (Splitting, 4), "splitting 6": (Splitting, 6),
    "splitting 8": (Splitting, 8),
    "Lie midpoint 2": (LieMidpoint, 2), "Lie midpoint 4": (LieMidpoint, 4),
    "Munthe-Kaas 2": (MuntheKaas, 2), "Munthe-Kaas 4": (MuntheKaas, 4),
}  # fmt: skip
STAGES = {2: 1, 4: 5, 6: 9, 8: 17}
OTHERS = ("Dopri8", "DOP853", "Taylor", "heyoka")


def evaluations(method: type, order: int, found: ph.Trajectory, flows: dict) -> int:
    """Return evaluations of the velocity, or of flows."""
    steps, flows = found.statistics["steps"], len(flows)
    if method is Splitting:
        return steps * STAGES[order] * (2 * flows - 1)
    if method is MuntheKaas:
        return steps * order
    return found.statistics["iterations"]


def ours(system, start: np.ndarray, exact: np.ndarray) -> dict[str, np.ndarray]:
    """Return rows of evaluations, seconds and error for each method and step."""
    curves = {}
    for name, (method, order) in METHODS.items():
        rows, bare = [], _bare(system, start, method, order)
        for step in STEPS:
            found = ph.simulate(system, start, [0.0, SPAN], method, step=float(step), order=order, estimate_error=False)
            bare(step).block_until_ready()
            taken = min(_seconds(lambda h=step, run=bare: run(h).block_until_ready()) for _ in range(REPEATS))
            error = np.abs(found.states[-1] - exact).max()
            rows.append((evaluations(method, order, found, system.flows), taken, error))
        curves[name] = np.array(rows)
    return curves


def _bare(system, start: np.ndarray, method: type, order: int):
    """Return the integration alone, compiled, as Dopri8's below."""

    @jax.jit
    def run(step):
        return diffrax.diffeqsolve(
            diffrax.ODETerm(lambda t, y, args: system.vector_field(t, y)), method(system, step, order=order), 0.0, SPAN,
            None, jnp.asarray(start), stepsize_controller=diffrax.StepTo(jnp.array([0.0, SPAN])),
            adjoint=diffrax.ForwardMode(),
        ).ys[-1]  # fmt: skip

    return run


def general_purpose(system, start: np.ndarray, exact: np.ndarray) -> dict[str, np.ndarray]:
    """Return the same for diffrax's Dopri8 and SciPy's DOP853."""
    field = jax.jit(lambda t, y: system.vector_field(t, y))

    @jax.jit
    def dopri8(tolerance):
        return diffrax.diffeqsolve(
            diffrax.ODETerm(lambda t, y, args: system.vector_field(t, y)), diffrax.Dopri8(), 0.0, SPAN, 0.01,
            jnp.asarray(start), stepsize_controller=diffrax.PIDController(rtol=tolerance, atol=tolerance),
            max_steps=1_000_000, adjoint=diffrax.ForwardMode(),
        )  # fmt: skip

    def dop853(tolerance):
        slope = lambda t, y: np.asarray(field(t, y))  # noqa: E731
        return solve_ivp(slope, (0.0, SPAN), start, "DOP853", rtol=max(tolerance, 3e-14), atol=tolerance)

    rows = {"Dopri8": [], "DOP853": []}
    dop853(1e-3)
    for tolerance in TOLERANCES:
        found = dopri8(tolerance)
        taken = min(_seconds(lambda t=tolerance: dopri8(t).ys.block_until_ready()) for _ in range(REPEATS))
        error = float(jnp.abs(found.ys[-1] - exact).max())
        rows["Dopri8"].append((14 * int(found.stats["num_steps"]), taken, error))
        begun = time.perf_counter()
        solved = dop853(tolerance)
        rows["DOP853"].append((solved.nfev, time.perf_counter() - begun, np.abs(solved.y[:, -1] - exact).max()))
    return {name: np.array(values) for name, values in rows.items()}


def by_series(system, start: np.ndarray, exact: np.ndarray) -> dict[str, np.ndarray]:
    """Return the same for our Taylor series and heyoka's; each order of each step counts as one evaluation."""
    import heyoka

    rows, times = {"Taylor": [], "heyoka": []}, np.array([0.0, SPAN])
    equations = heyoka_equations(system, start)
    for tolerance in (*TOLERANCES, 1e-15, 1e-17):
        precision = choose_precision(tolerance)
        run = lambda by=precision: run_copies(system, start[None], times, by)  # noqa: E731
        found = run()
        taken = min(_seconds(run) for _ in range(REPEATS * 3))
        evaluated = int(found.steps[0]) * precision.order
        rows["Taylor"].append((evaluated, taken, np.abs(found.states[0, -1] - exact).max()))
        engine = heyoka.taylor_adaptive(equations, list(start), tol=float(tolerance))

        def whole(engine=engine) -> int:
            engine.time, engine.state[:] = 0.0, start
            return engine.propagate_until(SPAN)[3]

        steps = whole()
        taken = min(_seconds(whole) for _ in range(REPEATS * 3))
        rows["heyoka"].append((steps * engine.order, taken, np.abs(engine.state - exact).max()))
    return {name: np.array(values) for name, values in rows.items()}


def _seconds(function) -> float:
    begun = time.perf_counter()
    function()
    return time.perf_counter() - begun


def cases():
    """Return the systems with start and converged end."""
    momentum = (0.3, 1.8, 1.5)
    body = ph.systems.FreeRigidBody(MOMENTS)
    motion = ph.FreeMotion(MOMENTS, momentum=momentum)
    yield "free rigid body", body, np.concatenate([ATTITUDE, momentum]), np.concatenate(motion.state(SPAN))
    top = ph.systems.BodyInPotential(MOMENTS, lambda up: 0.7 * up[2] + 0.3 * up[0])
    start = np.concatenate([ATTITUDE, momentum, [0.6, 0.0, 0.8]])
    proved = ph.certify(top, start, [0.0, SPAN])
    yield "heavy top", top, start, proved.states[-1]


def draw(path: str) -> None:
    """Write the picture."""
    figure, axes = plt.subplots(2, 2, figsize=(11, 8.5), layout="constrained", sharey="row")
    shades = [*plt.get_cmap("tab10").colors[: len(METHODS)], "black", "navy", "red", "darkorange"]
    colours = dict(zip([*METHODS, *OTHERS], shades, strict=True))
    for row, (title, system, start, exact) in zip(axes, cases(), strict=True):
        curves = ours(system, start, exact) | general_purpose(system, start, exact) | by_series(system, start, exact)
        for name, values in curves.items():
            style = {"color": colours[name], "marker": ".", "ls": "--" if name in OTHERS else "-"}
            for axis, column in zip(row, (0, 1), strict=True):
                axis.loglog(values[:, column], values[:, 2], label=name, **style)
            print(f"{title:16} {name:18} best error {values[:, 2].min():.1e} with {int(values[-1, 0])} evaluations")
        for axis, label in zip(row, ("evaluations of velocity or flows", "time [s]"), strict=True):
            axis.set_xlabel(label)
            axis.set_title(f"{title}, t = {SPAN:.0f}")
            axis.grid(alpha=0.3)
        row[0].set_ylabel("largest error of attitude and momentum")
    axes[0, 1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    warnings.filterwarnings("ignore", message="a step of")
    draw(sys.argv[1])
