"""CPU seconds of a fresh process up to its first motion, and of its set-up: ``first_motion.py WHO CASE``.

The process starts, imports the library, makes one motion to t = 20 at an error of about 1e-12, and makes it again: what
the first took longer is set-up. Kernels of polhode lie compiled on the disk, as after the first use; heyoka compiles
anew in each process. How heyoka's equations are written from our system is not counted.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

SPAN, TOLERANCE = 20.0, 1e-13


class First(NamedTuple):
    """CPU seconds.

    Attributes:
        ours: of our process up to its first motion.
        theirs: of the peer's.
        our_setup: of these, what a second motion does not cost again, imports left out.
        their_setup: of the peer.
    """

    ours: float
    theirs: float
    our_setup: float
    their_setup: float


def first_motion(case: str) -> First:
    """Return the times of a case, each of the second of two processes."""
    found = []
    for who in ("polhode", "heyoka"):
        command = [sys.executable, __file__, who, case]
        subprocess.run(command, check=True, capture_output=True)
        told = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        found.append([float(x) for x in told.split()])
    (ours, our_setup), (theirs, their_setup) = found
    return First(ours, theirs, our_setup, their_setup)


def main() -> None:
    """Print both times."""
    who, name = sys.argv[1:]
    sys.path.insert(0, str(Path(__file__).parent))
    imported, run = _ours(name) if who == "polhode" else _theirs(name)
    begun = time.process_time()
    again = run()
    first = time.process_time() - begun
    begun = time.process_time()
    again()
    print(imported + first, first - (time.process_time() - begun))


def _ours(name: str) -> tuple[float, Any]:
    import polhode as ph

    case = _case(name)
    imported = time.process_time()

    def run() -> Any:
        again = lambda: ph.simulate(case.system, case.start, [0.0, SPAN], tolerance=TOLERANCE, estimate_error=False)  # noqa: E731
        again()
        return again

    return imported, run


def _theirs(name: str) -> tuple[float, Any]:
    import heyoka

    imported = time.process_time()
    from heyoka_peer import heyoka_equations

    case = _case(name)
    equations = heyoka_equations(case.system, case.start)

    def run() -> Any:
        integrator = heyoka.taylor_adaptive(equations, list(case.start.ravel()), tol=TOLERANCE)

        def again() -> None:
            integrator.time, integrator.state[:] = 0.0, case.start.ravel()
            integrator.propagate_until(SPAN)

        again()
        return again

    return imported, run


def _case(name: str) -> Any:
    from cases import cases

    return next(case for case in cases() if case.name == name)


if __name__ == "__main__":
    main()
