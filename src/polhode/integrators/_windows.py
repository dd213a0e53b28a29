"""Parts of the intervals between samples, in which two motions are compared."""

from __future__ import annotations

import numpy as np

from polhode.types import Float64


def inner_windows(times: int, steps: int) -> int:
    """Return the number of parts of an interval between samples in which two motions are compared.

    They may by chance be at the same saddle at all samples, and differ only in between.
    """
    least = 48  # times of a comparison
    # of eight steps at least, so that longer steps are longer there too
    return int(np.clip(steps // 8, 1, -(-least // (times - 1))))


def split_into_windows(times: Float64[np.ndarray, "time"], windows: int) -> Float64[np.ndarray, "windows time"]:
    """Split the span into windows of as many times each, which together contain the given ones."""
    fine = np.append(np.linspace(times[:-1], times[1:], windows, endpoint=False, axis=1).ravel(), times[-1])
    return np.stack([fine[k * (len(times) - 1) : (k + 1) * (len(times) - 1) + 1] for k in range(windows)])
