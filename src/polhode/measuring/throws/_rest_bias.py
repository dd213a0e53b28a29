"""The bias of a gyro, from stretches in which the device lies still."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.measuring.throws.flight import Window
from polhode.measuring.throws.gyro_log import GyroLog
from polhode.measuring.throws.rest import rest_stretches
from polhode.types import Float64


class RestBias(NamedTuple):
    """The bias of a gyro by rests.

    Attributes:
        value: (3,) [rad/s, device frame].
        spread: (3,) its standard deviation in a throw [rad/s].
        seconds: how long the rests are together.
    """

    value: Float64[np.ndarray, "3"]
    spread: Float64[np.ndarray, "3"]
    seconds: float


def rest_bias(logs: list[GyroLog], windows: list[list[Window]]) -> RestBias | None:
    """Return the bias of a gyro at rest, or None where one of the logs has no rest.

    Args:
        logs: of one gyro.
        windows: of each log, the stretches in which the body is free, without rests.
    """
    means, lengths = [], []
    for log, flights in zip(logs, windows, strict=True):
        seconds = 0.0
        for start, end in rest_stretches(log):
            if any(start < free.end and end > free.start for free in flights):
                continue
            within = (log.times >= start) & (log.times <= end)
            means.append(log.rates[within].mean(axis=0))
            lengths.append(end - start)
            seconds += end - start
        if not seconds:
            return None
    weights = np.array(lengths) / sum(lengths)
    value = weights @ np.array(means)
    apart = np.sqrt(weights @ (np.array(means) - value) ** 2)
    drift = 0.003  # rad/s, standard deviation of a bias in a throw from that at rest
    return RestBias(value, np.hypot(drift, apart), float(sum(lengths)))
