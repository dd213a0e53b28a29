"""Threads for compiled code, which does not hold Python's lock: one for each core where there is work enough."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any


def available_cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def in_threads(fill: Callable[[int, int], Any], size: int, worth: int) -> None:
    """Call ``fill(low, high)`` on parts of 0 … size, one for each core where a part is worth a thread's start."""
    count = min(available_cores(), max(1, size // worth))
    if count == 1:
        fill(0, size)
        return
    ends = [size * k // count for k in range(count + 1)]
    with ThreadPoolExecutor(count) as pool:
        list(pool.map(lambda pair: fill(*pair), pairwise(ends)))
