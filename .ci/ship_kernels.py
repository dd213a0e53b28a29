"""Compiles all kernels for classes of processors, for the wheel: ``python .ci/ship_kernels.py``.

Each class has a process of its own, as Numba compiles for one processor in a process. Nothing of what is compiled runs,
as this machine may be of a lower class.
"""

import os
import subprocess
import sys
from contextlib import suppress

import numpy as np

from polhode._base.compiled import entries, images


class Written(Exception):
    """An image is on the disk, and would run now."""


def ship(level: str) -> None:
    """Write all images for a class of processors, by calls that end where they would run."""
    from polhode import systems
    from polhode.exact._closed_form import COMPILING
    from polhode.exact.free_body._evaluation import FORM as BODIES
    from polhode.exact.lagrange_top._evaluation import FORM as TOPS
    from polhode.taylor import advancing, kernels
    from polhode.taylor.machine import build_machine
    from polhode.taylor.runs import choose_precision, run_copies

    def stop(image: object) -> None:
        raise Written

    entries.load, entries.processors, entries.find_place = stop, lambda: (level,), lambda module: entries.SHIPPED
    three = lambda *row: np.array([row, row])  # noqa: E731
    moments, momenta, attitudes, weights = three(1, 1, 2.0), three(0.3, 1.8, 1.5), three(0.8, 0.6, 0, 0), three(1.0)
    times, rests = np.linspace(0.0, 1.0, 2), np.zeros(2)
    for form, given in ((BODIES, (moments, momenta, attitudes)), (TOPS, (moments, weights, momenta, attitudes))):
        columns = form.columns(given)
        form._ready = set(COMPILING)
        with suppress(Written):
            form.columns(given)
        with suppress(Written):
            form.states(columns, times, rests)
        with suppress(Written):
            form.states(columns[:, :1], times, rests)
    system, starts = systems.FreeRigidBody((1.0, 2.0, 3.0)), np.tile((0.3, 1.9, 0.1), (9, 1))
    for width in kernels.MODULES:
        by_python, compiled = kernels.python_kernel(width), kernels.compile_kernel(width)
        extended = width == kernels.EXTENDED
        for use in (compiled, compiled._replace(conserved_values=by_python.conserved_values)):
            advancing.choose_kernel = lambda *_, use=use: use
            with suppress(Written):
                if use is not compiled:
                    run_copies(system, starts, np.array([0.0, 1.0]), choose_precision(None, extended=extended))
                elif not extended:
                    advancing.integrals_at(build_machine(system, starts[0], None), starts)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        ship(sys.argv[1])
    else:
        for old in entries.SHIPPED.glob("*"):
            old.unlink()
        started = []
        for name in images.LEVELS:
            chosen = {"NUMBA_CPU_NAME": name, "NUMBA_CPU_FEATURES": ""}
            started.append(subprocess.Popen([sys.executable, __file__, name], env=os.environ | chosen))
        codes = [process.wait() for process in started]
        for lock in entries.SHIPPED.glob("*.lock"):
            lock.unlink()
        written = sorted(entries.SHIPPED.glob(f"*{entries.ENDING}"))
        print(*(f"{path.stat().st_size:>8} {path.name}" for path in written), sep="\n")
        # set-up, states of one and of many, of bodies and of tops; steps and what is conserved, of one copy and of
        # eight; steps with twice as many digits
        sys.exit(any(codes) or len(written) != (2 * 3 + 2 * 2 + 1) * len(images.LEVELS))
