"""Heavy top: error and CPU time of splittings against Dopri8, compiled, in one process: ``python benchmarks/tops.py``.

Errors are the largest of all components at the end, against Dopri8 at 1e-14; times are medians. The top is
triaxial and chaotic: at t = 1000 the errors are of order one for every method, and only the times tell something.
"""

from __future__ import annotations

import time

import diffrax
import jax
import jax.numpy as jnp
import numpy as np

from polhode.integrators import Splitting
from polhode.systems import HeavyTop

REPEATS = 3


def main() -> None:
    """Print a line for each method, length of the motion, and step or tolerance."""
    top = HeavyTop((2.0, 1.5, 1.0), 1.0, (0.3, 0.2, 0.9))
    start = top.pack(angular_velocity=(0.6, 0.4, 1.8))

    @jax.jit
    def dopri8(tolerance, span):
        controller = diffrax.PIDController(rtol=tolerance, atol=tolerance)
        term = diffrax.ODETerm(lambda t, y, _: top.vector_field(t, y))
        return diffrax.diffeqsolve(
            term, diffrax.Dopri8(), 0.0, span, 1e-3, start, stepsize_controller=controller,
            saveat=diffrax.SaveAt(t1=True), max_steps=None,
        ).ys[-1]  # fmt: skip

    runs = {"Dopri8": (dopri8, (1e-4, 1e-7, 1e-10, 1e-13))}
    for order in (6, 8):
        runs[f"splitting {order}"] = (_splitting(top, start, order), (0.8, 0.4, 0.2, 0.1))
    for span in (20.0, 1000.0):
        exact = dopri8(1e-14, span)
        for name, (run, choices) in runs.items():
            for choice in choices:
                error = float(jnp.abs(run(choice, span) - exact).max())
                taken = _milliseconds(run, choice, span)
                print(f"t = {span:4.0f}  {name:12s} {choice:7.0e}  error {error:.1e}  {taken:9.2f} ms", flush=True)


def _splitting(top, start, order):
    @jax.jit
    def run(step, span):
        solver = Splitting(top, step, order)
        return solver.advance(0.0, span, start, solver.memory(start))[0]

    return run


def _milliseconds(run, *given) -> float:
    taken = []
    for _ in range(REPEATS):
        begin = time.process_time()
        run(*given).block_until_ready()
        taken.append(time.process_time() - begin)
    return 1e3 * float(np.median(taken))


if __name__ == "__main__":
    main()
