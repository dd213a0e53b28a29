"""The same code on a GPU: whether its double precision is right there, and how near it comes to the memory's speed.

``python benchmarks/gpu.py`` needs JAX with a GPU (``pip install "jax[cuda13]"`` on Linux with an NVIDIA card). Without
one it says so and ends well. ``--cpu`` runs the same on the processor, where XLA compiles the closed forms as it does
for a GPU; ``--quick`` takes small sizes. Medians of several runs in one process, compiling left out.

What is compared: free bodies and Lagrange tops with the table of hard motions, in units of 2⁻⁵² (the bound is 16 for
bodies at moderate times); states a second of one body at many times, many bodies with their set-up, and many bodies
stepped by splitting, each as bytes that must at least be moved, over what a copy of an array moves.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

import polhode as ph
from polhode.judging import compare_engine, reference_motions

EPS = 2.0**-52
BOUND = 16.0  # eps, as on the CPU
REPEATS = 7


def main() -> None:
    """Run what was asked for, on the device that was asked for."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--cpu", action="store_true", help="on the processor instead")
    options.add_argument("--quick", action="store_true", help="small sizes")
    chosen = options.parse_args()
    jax.config.update("jax_enable_x64", True)
    device = _device("cpu" if chosen.cpu else "gpu")
    if device is None:
        print("skipped: JAX sees no GPU here. Install jax[cuda13] on a machine with one, or try --cpu.")
        return
    print(f"{device.device_kind}, JAX {jax.__version__}, polhode {ph.__version__}")
    with jax.default_device(device), ph.closed_forms("compiled"):
        wrong = _accuracy()
        _speed(100 if chosen.quick else 1)
    if wrong:
        sys.exit(f"beyond {BOUND:g} eps: {', '.join(wrong)}")


def _device(kind: str) -> Any:
    try:
        return jax.devices(kind)[0]
    except RuntimeError:
        return None


def _accuracy() -> list[str]:
    """Print the worst errors over the table of hard motions; return what is beyond the bound."""
    wrong = []
    for kind in ("free body", "Lagrange top"):
        start = time.perf_counter()
        found = compare_engine(_engine(kind), reference_motions(kind=kind)).worst
        attitude, long, momentum = (x / EPS for x in (found.attitude, found.attitude_long, found.momentum))
        taken = time.perf_counter() - start
        errors = f"attitude {attitude:.1f}, at long times {long:.1f}, momentum {momentum:.1f}"
        print(f"{kind}: {found.motions} motions, worst in eps: {errors}; {taken:.0f} s with compiling")
        if kind == "free body" and not max(attitude, long, momentum) <= BOUND:
            wrong.append(kind)
    return wrong


def _engine(kind: str) -> Callable[[Any], tuple[Any, Any]]:
    most = 16  # times of a motion, filled up so that one compiled function serves all

    @jax.jit
    def state(moments: Any, mgl: Any, momentum: Any, attitude: Any, times: Any) -> Any:
        if kind == "free body":
            return ph.FreeMotion(moments, momentum=momentum, attitude=attitude).state(times)
        return ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude).state(times)

    def engine(motion: Any) -> tuple[Any, Any]:
        count = len(motion.times)
        times = np.resize(motion.times, max(most, count))
        attitude, momentum = state(motion.moments, motion.mgl, motion.momentum, motion.attitude, times)
        return np.asarray(attitude)[:count], np.asarray(momentum)[:count]

    return engine


def _median(call: Callable[[], Any]) -> float:
    """Return the median time [s] of a call whose result is waited for, after one that compiles."""
    jax.block_until_ready(call())
    taken = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        jax.block_until_ready(call())
        taken.append(time.perf_counter() - start)
    return statistics.median(taken)


def _speed(less: int) -> None:
    numbers = jnp.zeros(50_000_000 // less)
    copied = jax.jit(lambda x: x + 1.0)
    bandwidth = 2.0 * numbers.nbytes / _median(lambda: copied(numbers))
    print(f"a copy moves {bandwidth / 1e9:.0f} GB/s; the rest in shares of it")
    moments, momentum = jnp.array([1.0, 2.0, 3.0]), jnp.array([0.3, 1.8, 1.5])
    times = jnp.linspace(0.0, 1e6, 4_000_000 // less)
    body = ph.FreeMotion(moments, momentum=momentum)
    one = jax.jit(lambda t: body.state(t))
    _said("one body at many times", len(times), 8 * 8, _median(lambda: one(times)), bandwidth)
    many = momentum + 1e-7 * jnp.arange(1_000_000 // less)[:, None]
    each = jax.jit(lambda L: ph.FreeMotion(moments, momentum=L).state(50.0))
    _said("many bodies, with set-up", len(many), 8 * 10, _median(lambda: each(many)), bandwidth)
    steps, system = 100, ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    method, span = ph.integrators.Splitting, np.array([0.0, steps * 0.01])

    @jax.jit
    def stepped(states: Any) -> Any:
        return jax.vmap(lambda state: ph.solve(system, state, span, method, 0.01, order=2).end_state)(states)

    taken = _median(lambda: stepped(many))
    _said("the same, a step of splitting", len(many) * steps, 8 * 6, taken, bandwidth)


def _said(what: str, count: int, size: int, seconds: float, bandwidth: float) -> None:
    share = count * size / seconds / bandwidth
    rate = f"{seconds / count * 1e9:.2f} ns each, {count / seconds / 1e6:.3g} million a second"
    print(f"{what}: {rate}; {share:.2g} of the copy, at {size} bytes each")


if __name__ == "__main__":
    main()
