"""What a benchmark measures, and how: rows of ours against a peer, both timed by turns in one process."""

from __future__ import annotations

import ctypes
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from first_motion import First


class Row(NamedTuple):
    """One comparison.

    Attributes:
        work: what both do.
        peer: who else does it.
        ours: our error; None where there is none to tell.
        theirs: the peer's.
        ratio: of the peer's time to ours, the median of several turns; above 1 we are quicker. None if not measured.
        spread: the smallest and largest of these ratios.
        note: why something is missing, or what else must be known.
        first: CPU seconds of fresh processes, in columns of their own.
    """

    work: str
    peer: str
    ours: float | None = None
    theirs: float | None = None
    ratio: float | None = None
    spread: tuple[float, float] | None = None
    note: str = ""
    first: First | None = None


def seconds(call: Callable[[], Any]) -> float:
    """Return the CPU time of a call [s], in all threads of this process."""
    start = time.process_time()
    call()
    return time.process_time() - start


def median(call: Callable[[], Any], repeats: int) -> float:
    """Return the median time of a call [s], after one that may compile."""
    call()
    return statistics.median(seconds(call) for _ in range(repeats))


def compared(
    ours: Callable[[], Any], theirs: Callable[[], Any], repeats: int, shares: tuple[float, float] = (1.0, 1.0)
) -> tuple[float, tuple[float, float]]:
    """Return the median and the range of the ratio of the peer's time to ours, measured by turns.

    Args:
        ours: our work, after which its result is there.
        theirs: the peer's.
        repeats: turns.
        shares: how much of the work each call does, where the peer's would take too long for all of it.
    """
    ours(), theirs()
    ratios = [(seconds(theirs) / shares[1]) / (seconds(ours) / shares[0]) for _ in range(repeats)]
    return statistics.median(ratios), (min(ratios), max(ratios))


def missing(work: str, peer: str, remedy: str) -> Row:
    """Return the row of a peer that is not installed."""
    return Row(work, peer, note=f"not installed here: {remedy}")


def c_function(source: str, *flags: str) -> Callable[..., None] | None:
    """Return the function ``run`` of a C file next to this one, or None without a compiler.

    It takes whole numbers, then floats and pointers to arrays of them, as the file says.
    """
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        library = str(Path(folder) / "peer.so")
        path = str(Path(__file__).parent / source)
        subprocess.run(
            [compiler, "-O3", "-march=native", "-shared", "-fPIC", *flags, path, "-o", library, "-lm"], check=True
        )
        function = ctypes.CDLL(library).run

    def run(*arguments: Any) -> None:
        kinds = {int: ctypes.c_long, float: ctypes.c_double}
        function(*(kinds[type(x)](x) if type(x) in kinds else x for x in arguments))

    return run


def pointer(values: np.ndarray) -> Any:
    """Return an array of floats as C takes it, which must live as long as the call."""
    return values.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
