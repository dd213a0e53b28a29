"""Vortices condense on a sphere at rest: the picture of docs/pattern.md, ``python docs/condensation.py``.

A random vorticity of rms 1 on a few large scales is stirred into filaments, while its energy gathers at the largest
ones. In the end few blobs are left, as many as there are point vortices whose motion is integrable: four without
angular momentum, three with some (Modin & Viviani, J. Fluid Mech. 884 (2020) A22, with N = 501). Here N is 48, and the
filaments end as noise on the grid; the maps show degrees up to 6. Three stand out in the end with angular momentum;
without it two, opposite each other in a belt of the other sign. Both runs take two or three minutes on one core.
"""

from __future__ import annotations

from pathlib import Path

import jax.numpy as jnp
import matplotlib.pyplot as plt
import numpy as np

import polhode as ph
from polhode.integrators import IsospectralMidpoint

N, LAST_DEGREE, SMOOTH = 48, 10, 6
TIMES = np.array([0.0, 20.0, 200.0, 1000.0])
LOWEST = 0.35  # of the largest blob
ITERATIONS = 19.0  # of a step in the end, when the flow turns faster
STARTS = {"L = 0": 0.0, "L = 0.3": 0.3}  # |L| over the root of ∫ω²
PICTURE = Path(__file__).parent / "images" / "vortex_condensation.png"


def start_of(fluid: ph.fields.SphereFluid, share: float, seed: int) -> jnp.ndarray:
    """Return a vorticity of rms 1, with equal parts of the degrees from 2 on and a given angular momentum."""
    rng = np.random.default_rng(seed)
    f = np.zeros((N, N), complex)
    for degree in range(2, LAST_DEGREE + 1):
        f[degree, : degree + 1] = rng.normal(size=degree + 1) + 1j * rng.normal(size=degree + 1)
        f[degree, 0] = f[degree, 0].real
    rest = np.sqrt(np.sum(np.abs(f[:, 0]) ** 2) + 2.0 * np.sum(np.abs(f[:, 1:]) ** 2))
    f *= np.sqrt(4.0 * np.pi) * np.sqrt(1.0 - 3.0 * share**2 / (4.0 * np.pi)) / rest
    f[1, 0] = np.sqrt(3.0) * share  # ∫ x₃ Y₁₀ = √(4π/3)
    return fluid.from_harmonics(f)


def smoothed(
    fluid: ph.fields.SphereFluid, state: np.ndarray, colatitude: np.ndarray, azimuth: np.ndarray, last: int = SMOOTH
) -> np.ndarray:
    """Return the map of low degrees."""
    f = np.array(fluid.to_harmonics(state))
    f[last + 1 :] = 0.0
    return fluid.on_grid(fluid.algebra.from_harmonics(f), colatitude, azimuth)


def blobs(field: np.ndarray, mu: np.ndarray, azimuth: np.ndarray) -> list[tuple[float, float, float]]:
    """Return longitude, sine of latitude and height, relative to the largest, of the highest and lowest places."""
    inner, size = np.abs(field[:, :-1]), np.abs(field).max()
    around = [np.roll(inner, shift, 1)[1 + row : len(mu) - 1 + row] for shift in (-1, 0, 1) for row in (-1, 0, 1)]
    places = np.argwhere((inner[1:-1] >= np.max(around, axis=0)) & (inner[1:-1] > LOWEST * size))
    found = [(azimuth[c], mu[r + 1], field[r + 1, c] / size) for r, c in places]
    return [(round(float(a), 2), round(float(b), 2), round(float(c), 2)) for a, b, c in found]


def main() -> None:
    """Run both starts, say what was kept, and draw the maps."""
    fluid = ph.fields.SphereFluid(N)
    mu, azimuth = np.linspace(-1.0, 1.0, 121)[1:-1], np.linspace(0.0, 2.0 * np.pi, 181)
    figure, axes = plt.subplots(len(STARTS), len(TIMES), figsize=(12, 4.6), sharex=True, sharey=True)
    for row, (name, share) in zip(axes, STARTS.items(), strict=True):
        start = start_of(fluid, share, seed=2)
        step = 0.3 / float(fluid.algebra.rate(fluid.stream_function(start)))
        cost = fluid.cost(int(TIMES[-1] / step), len(TIMES), ITERATIONS)
        print(f"{name}: about {cost.seconds:.0f} s and {cost.bytes / 2**20:.0f} MiB")
        run = ph.simulate(fluid, start, TIMES, IsospectralMidpoint, step=step, order=2, estimate_error=False)
        spectrum = np.asarray(fluid.algebra.spectrum(run.states))
        print(name, run.statistics, "spectrum:", np.abs(spectrum - spectrum[0]).max() / np.abs(spectrum).max(),
              "energy:", run.drift["energy"])  # fmt: skip
        end = smoothed(fluid, run.states[-1], np.arccos(mu), azimuth, last=3)
        energies = fluid.energy_spectrum(run.states[-1])
        print("share of degree 2 in the energy at the end:", float(energies[2] / energies.sum()))
        print("blobs:", blobs(end, mu, azimuth))
        for axis, state, time in zip(row, run.states, TIMES, strict=True):
            field = smoothed(fluid, state, np.arccos(mu), azimuth)
            size = np.abs(field).max()
            axis.pcolormesh(azimuth, mu, field, cmap="RdBu_r", vmin=-size, vmax=size, shading="nearest")
            axis.set_title(f"{name}, t = {time:g}", fontsize=9)
        row[0].set_ylabel("sine of latitude")
    for axis in axes[-1]:
        axis.set_xlabel("longitude [rad]")
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=80)


if __name__ == "__main__":
    main()
