"""What a first call costs, in CPU seconds: ``python benchmarks/first_calls.py``.

Each line is measured in fresh processes, from the first use of the library on, imports included, with nothing kept from
earlier runs; medians of three. ``compiled`` is the same with ``ph.closed_forms("compiled")``, where XLA compiles what
NumPy evaluates otherwise.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys

HEAD = """
import time
begin = time.process_time()
import jax, jax.numpy as jnp, numpy as np
jax.config.update("jax_enable_x64", True)
loaded = time.process_time()
import polhode as ph
body, start = jnp.array([1.0, 2.0, 3.0]), jnp.array([0.0, 2.0, 0.0])
top = lambda L: ph.LagrangeMotion(
    jnp.array([1.0, 1.0, 0.5]), mgl=1.0, momentum=L, attitude=jnp.array([0.8, 0.6, 0.0, 0.0])
).attitude(50.0)[1]
height = lambda L: ph.FreeMotion(body, momentum=L).rotation_matrix(50.0)[2, 0]
many = 1.0 + jnp.linspace(0.0, 0.1, 100_000)[:, None] * jnp.ones(3)
with ph.closed_forms({where!r}):
    jax.block_until_ready({code})
print(time.process_time() - loaded)
"""
CALLS = {
    "gradient of a free motion": ("jax.grad(height)(start)", 2.0),
    "its value, jitted": ("jax.jit(height)(start)", 1.0),
    "1e5 bodies under jit and vmap": ("jax.jit(jax.vmap(height))(many)", 2.0),
    "gradient of a Lagrange top": ("jax.grad(top)(jnp.array([0.1, 0.2, 2.5]))", 2.0),
    "its value, jitted ": ("jax.jit(top)(jnp.array([0.1, 0.2, 2.5]))", 1.0),
    "1e5 tops under jit and vmap": ("jax.jit(jax.vmap(top))(many)", 2.0),
    "Hessian of a free motion": ("jax.jit(jax.hessian(height))(jnp.array([0.3, 1.8, 1.5]))", None),
}
ENGINE = {
    "three verdicts on a new system": (
        "[ph.stability(system, axis).rate for axis in np.eye(3)]", 1.5,
    ),
    "simulate it": ("ph.simulate(system, [0.3, 1.8, 1.5], np.linspace(0, 100, 11)).states", 3.0),
}  # fmt: skip
SYSTEMS = {
    "heavy top": (
        "HeavyTop((1.0, 2.0, 3.5), 1.3, (0.6, 0.0, 0.8))",
        "system.pack(attitude=(1, 0, 0, 0), angular_velocity=(0.3, 1, 0.1))",
    ),
    "Kirchhoff's body": ("Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0))", "[0.3, 1.0, 0.2, 0.5, -0.4, 1.0]"),
    "Toda, four": ("Toda(4)", "[0.5, -0.2, 0.1, 0.3, 1.0, 0.8, 1.2]"),
    "three vortices": (
        "PlaneVortices(np.array([1.0, 0.8, -0.7]))", "system.pack([[0.0, 0.0], [1.5, 0.2], [-0.3, 1.9]])",
    ),
    "body with a wheel": (
        "RigidBody((1.0, 2.0, 3.5), [ph.spacecraft.Wheel((0, 0, 1), 0.1)])",
        "system.pack((1, 0, 0, 0), (0.1, 1.0, 0.2), rates=[3.0])",
    ),
    "fluid of su(17)": ("SphereFluid(17)", "system.random([0.0, 1.0, 1.0, 1.0])"),
}
"""Systems of ``ph.systems`` and where they start, whose first motion is measured; aim 1.5."""
SIMULATED = "ph.simulate(system, start, np.linspace(0.0, 10.0, 11)).states"
FIRST = "system = ph.systems.{}\nstart = {}\nwith ph.closed"
SYSTEM = "system = ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: 0.5 * jnp.sum(L**2 / body))\nwith ph.closed"


def seconds(code: str, where: str, runs: int, before: str = "with ph.closed") -> float:
    """Return the median CPU time of a piece of code, and of what stands before, in fresh processes."""
    text = HEAD.format(where=where, code=code).replace("with ph.closed", before)
    quiet = {key: value for key, value in os.environ.items() if key not in ("JAX_COMPILATION_CACHE_DIR", "XLA_FLAGS")}
    found = [
        subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True, env=quiet).stdout
        for _ in range(runs)
    ]
    return statistics.median(map(float, found))


def main() -> None:
    given = argparse.ArgumentParser(description=__doc__)
    given.add_argument("--runs", type=int, default=3, help="processes for each line")
    given.add_argument("--compiled", action="store_true", help="also let XLA compile the closed forms")
    options = given.parse_args()
    print(f"{'first call, CPU s':40}{'by NumPy':>10}{'aim':>8}{'compiled':>10}")
    for name, (code, aim) in {**CALLS, **ENGINE}.items():
        host = seconds(code, "host", options.runs, SYSTEM if name in ENGINE else "with ph.closed")
        other = seconds(code, "compiled", options.runs) if options.compiled and name in CALLS and aim else None
        words = f"{aim:8.1f}" if aim else " " * 8
        print(f"{name:40}{host:10.2f}{words}{'' if other is None else f'{other:10.2f}'}", flush=True)
    for name, parts in SYSTEMS.items():
        host = seconds(SIMULATED, "host", options.runs, FIRST.format(*parts))
        print(f"{'simulate: ' + name:40}{host:10.2f}{1.5:8.1f}", flush=True)


if __name__ == "__main__":
    main()
