"""The Lie–Poisson engine beside a C loop and a Poisson-geometry package: ``python benchmarks/lie_poisson.py``.

One core, one process, ratios of medians. The C loop is ``splitting.c`` beside this file, compiled on the spot; the
package is ``numericalpoissongeometry`` (extra ``bench``). Each is left out, and said so, where it is missing.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false")

import jax
import jax.numpy as jnp
import numpy as np

import polhode as ph

MOMENTS = (1.0, 2.0, 3.0)
START = np.array([1.0, 0.0, 0.0, 0.0, 0.3, 1.8, 1.5])
STEPS, STEP, REPEATS = 1_000_000, 0.01, 5
POINTS, PEER_POINTS = 1_000_000, 2_000


def median(function, repeats: int = REPEATS) -> float:
    """Return the median time of a call [s]."""
    taken = []
    for _ in range(repeats):
        start = time.perf_counter()
        function()
        taken.append(time.perf_counter() - start)
    return float(np.median(taken))


def c_loop(compensated: bool):
    """Return a function that runs the C loop, or None without a compiler."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        return None
    library = Path(tempfile.mkdtemp()) / "splitting.so"
    flags = ["-O3", "-march=native", "-shared", "-fPIC", *(["-DCOMPENSATED"] if compensated else [])]
    source = str(Path(__file__).with_name("splitting.c"))
    subprocess.run([compiler, *flags, source, "-o", str(library), "-lm"], check=True)
    run = ctypes.CDLL(str(library)).run
    numbers = ctypes.POINTER(ctypes.c_double)
    run.argtypes = [ctypes.c_long, ctypes.c_double, numbers, numbers]

    def call() -> np.ndarray:
        state, moments = START.copy(), np.array(MOMENTS)
        run(STEPS, STEP, moments.ctypes.data_as(numbers), state.ctypes.data_as(numbers))
        return state

    return call


def trajectory() -> None:
    body = ph.systems.FreeRigidBody(MOMENTS)
    times = np.linspace(0.0, STEPS * STEP, 11)
    method = ph.integrators.Splitting
    simulate = lambda: ph.simulate(body, START, times, method, STEP, order=2, estimate_error=False)  # noqa: E731
    found = simulate()
    ours = median(simulate) / STEPS
    print(f"one trajectory, splitting of order 2 with attitude: {ours * 1e9:.0f} ns a step through simulate")
    print(f"  drift over {STEPS:.0e} steps: |L|² {found.drift['|L|²']:.1e}, momentum in space "
          f"{found.drift['momentum_space']:.1e}, energy {found.drift['energy']:.1e}")  # fmt: skip
    for compensated in (True, False):
        loop = c_loop(compensated)
        if loop is None:
            print("  no C compiler here: the C loop was left out")
            return
        state = loop()
        taken = median(loop) / STEPS
        name = "same, compensated sums" if compensated else "plain sums"
        norm = float(np.sum(state[4:] ** 2) / np.sum(START[4:] ** 2) - 1.0)
        print(f"  C loop, {name:24}{taken * 1e9:6.0f} ns a step   ratio {ours / taken:.2f} (target 1.5)   "
              f"|L|² off by {norm:.1e}, states differ by {np.abs(state - found.states[-1]).max():.1e}")  # fmt: skip


def geometry() -> None:
    points = np.random.default_rng(0).normal(size=(POINTS, 3))
    so3, a = ph.algebra.SO3(), jnp.asarray(MOMENTS)
    H, F = (lambda L: 0.5 * jnp.sum(L * L / a)), (lambda L: L[0] * L[1])
    ours = {
        "bracket": jax.jit(ph.poisson.bracket(so3, H, F)),
        "Hamiltonian field": jax.jit(ph.poisson.hamiltonian_field(so3, H)),
        "Poisson tensor": jax.jit(lambda L: ph.poisson.poisson_tensor(so3, L)),
    }
    peers = peer(points[:PEER_POINTS])
    put = jnp.asarray(points)
    print(f"\ngeometry at {POINTS:.0e} points of so(3)* (the peer, linear in points, at {PEER_POINTS})")
    for name, function in ours.items():
        values = jax.block_until_ready(function(put))
        taken = median(lambda f=function: jax.block_until_ready(f(put))) / POINTS
        line = f"  {name:20}{taken * 1e9:8.1f} ns a point"
        if peers:
            wanted, per_point = peers[name]
            off = np.abs(np.abs(np.asarray(values[:PEER_POINTS])) - np.abs(wanted)).max()
            line += f"   numericalpoissongeometry {per_point * 1e9:8.0f} ns   ratio {per_point / taken:.0f}"
            line += f" (target 100)   agree to {off:.0e}"
        print(line)


def peer(points: np.ndarray) -> dict:
    try:
        from numpoisson.numpoisson import NumPoissonGeometry
    except ImportError:
        print("numericalpoissongeometry is not installed: left out")
        return {}
    geometry = NumPoissonGeometry(3)
    bivector = {(1, 2): "-x3", (1, 3): "x2", (2, 3): "-x1"}
    H, F = "x1**2/2 + x2**2/4 + x3**2/6", "x1*x2"
    calls = {
        "bracket": lambda: geometry.num_poisson_bracket(bivector, H, F, points),
        "Hamiltonian field": lambda: geometry.num_hamiltonian_vf(bivector, H, points),
        "Poisson tensor": lambda: geometry.num_bivector(bivector, points),
    }
    shapes = {"bracket": (-1,), "Hamiltonian field": (-1, 3), "Poisson tensor": (-1, 3, 3)}
    return {
        name: (np.asarray(call(), dtype=float).reshape(shapes[name]), median(call, 3) / len(points))
        for name, call in calls.items()
    }


if __name__ == "__main__":
    trajectory()
    geometry()
