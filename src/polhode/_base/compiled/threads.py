"""Threads for compiled code, which does not hold Python's lock: one for each core where there is work enough."""

from __future__ import annotations

import os
from collections.abc import Callable
from threading import Thread
from typing import Any


def available_cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def in_threads(fill: Callable[[int, int], Any], size: int, worth: int) -> None:
    """Call ``fill(low, high)`` on parts of 0 … size, one for each core where a part is worth a thread's start.

    The caller's own thread takes the first part. What a part raises is raised when all have ended.
    """
    count = min(available_cores(), max(1, size // worth))
    ends = [size * k // count for k in range(count + 1)]
    errors = list[BaseException]()

    def run(k: int) -> None:
        try:
            fill(ends[k], ends[k + 1])
        except BaseException as error:  # of another thread, whose caller would not learn of it
            errors.append(error)

    # with threads of one's own, as a pool's module takes longer to import than a short run
    others = [Thread(target=run, args=(k,)) for k in range(1, count)]
    for thread in others:
        thread.start()
    run(0)
    for thread in others:
        thread.join()
    if errors:
        raise errors[0]
