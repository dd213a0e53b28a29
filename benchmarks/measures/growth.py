"""How cost grows: with time, with the number of bodies, with the size of an algebra"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from measure import Row, median

import polhode as ph
from polhode.formats.figure_file import save_figure

MOMENTS, START = (1.0, 2.0, 3.0), (0.3, 1.8, 1.5)
STEP = 0.01
_curves: dict[str, tuple[str, dict[str, tuple[Any, Any]]]] = {}


def rows(quick: bool) -> Iterator[Row]:
    """Yield the exponents of the powers by which times grow over the last tenfold, and keep the curves."""
    _curves.update(_measured(quick))
    for axis, (_, curves) in _curves.items():
        for name, (x, y) in curves.items():
            slope = np.log(y[-1] / y[0]) / np.log(x[-1] / x[0])
            note = f"time grows as {axis}^{slope:.2f} from {x[0]:,.0f} to {x[-1]:,.0f}; {y[-1]:.2g} s at the end"
            yield Row(f"against {axis}", name, note=note)


def _measured(quick: bool) -> dict[str, tuple[str, dict[str, tuple[Any, Any]]]]:
    few = 2 if quick else 5
    spans, counts = 10.0 ** np.arange(1, 1 + few), 10 ** np.arange(2, 2 + few)
    sizes = 2 ** np.arange(1, max(few, 3))
    motion, body = ph.FreeMotion(MOMENTS, momentum=START), ph.systems.FreeRigidBody(MOMENTS)
    start = np.array([1.0, 0.0, 0.0, 0.0, *START])
    momenta = np.random.default_rng(0).normal(size=(int(counts[-1]), 3))

    def stepped(span: float) -> Any:
        method = ph.integrators.Splitting
        return ph.simulate(body, start, [0.0, span], method, STEP, order=2, estimate_error=False).states

    def unitary(n: int) -> Any:
        algebra = ph.algebra.SU(n)
        weights = np.linspace(1.0, 2.0, algebra.dim)

        def energy(point: Any) -> Any:
            return 0.5 * (algebra.to_dual_vector(point) ** 2 / weights).sum()

        system = ph.systems.LiePoisson(algebra, energy)
        point = algebra.from_dual_vector(np.random.default_rng(1).normal(size=algebra.dim))
        method = ph.integrators.LieMidpoint
        return lambda: ph.simulate(system, point, [0.0, 1.0], method, STEP, estimate_error=False).states

    of_times = {
        "exact, at that time": [median(lambda t=t: motion.state(t), 5) for t in spans],
        f"splitting of order 2, step {STEP:g}": [median(lambda t=t: stepped(t), 3) for t in spans],
    }
    of_bodies = {
        "exact, with set-up": [
            median(lambda n=n: ph.FreeMotion(MOMENTS, momentum=momenta[:n]).state(50.0), 3) for n in counts
        ]
    }
    of_sizes = {"Lie midpoint on su(N), 100 steps": [median(unitary(int(n)), 3) for n in sizes]}
    return {
        "t": ("time", {name: (spans, np.array(y)) for name, y in of_times.items()}),
        "bodies": ("number of bodies", {name: (counts, np.array(y)) for name, y in of_bodies.items()}),
        "N": ("N of su(N)", {name: (sizes, np.array(y)) for name, y in of_sizes.items()}),
    }


def draw(folder: Path) -> list[Path]:
    """Write a picture of each kind of growth, and return where."""
    from polhode.figures import style

    written = []
    for axis, (label, curves) in _curves.items():
        figure = style.new_figure(height=2.6)
        panel = figure.subplots()
        for colour, marker, (name, (x, y)) in zip((style.BLUE, style.VERMILION), "os", curves.items(), strict=False):
            panel.loglog(x, y, color=colour, marker=marker, ms=3.5, lw=1.1, label=name)
        if axis == "N":
            panel.set_xticks(sizes := next(iter(curves.values()))[0], [str(n) for n in sizes])
            panel.set_xticks([], minor=True)
        panel.set_xlabel(label)
        panel.set_ylabel("time of a call  [s]")
        panel.legend(fontsize=style.FONT - 1, frameon=False)
        style.tidy(panel)
        written.append(save_figure(figure, folder / f"growth_with_{axis}.png"))
    return written
