"""The currency between motion and everything after it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

Array = Any


@dataclass(frozen=True)
class Trajectory:
    """Sampled motion of one system or a batch of them; plain arrays, SI units.

    Attributes:
        system: what moved, as it was given to the method that made the samples.
        times: (T,) [s].
        states: packed states (batch…, T, n): attitude wxyz first where carried, then the momentum.
        attitude: (batch…, T, 4) unit quaternions wxyz, body → space; None where meaningless.
        momentum: (batch…, T, 3) [kg m²/s, body axes]; None where meaningless.
        angular_velocity: (batch…, T, 3) [rad/s, body axes]; None where meaningless.
        invariants: name → values along the motion, (batch…, T) or (batch…, T, k).
        balances: name → quantities that change at a known rate, along the motion, (batch…, T).
        received: name → the integral of that rate from the first time, (batch…, T); dissipated energy is its negative.
        drift: name → largest deviation of that invariant from its first sample, or of that balance from its first
            sample and what it received since, relative to its size or that of its terms, (batch…).
        status: what the method says of itself ("exact", how a solve ended, or the event that ended the motion).
        statistics: how many steps and iterations of implicit steps it took.
        error_estimate: estimated largest error of the states, relative to the size of attitude and momentum, (batch…);
            infinite where it is not known, None where it was not asked for or the motion is exact.
    """

    system: Any
    times: Array
    states: Array
    attitude: Array | None = None
    momentum: Array | None = None
    angular_velocity: Array | None = None
    invariants: dict[str, Array] = field(default_factory=dict)
    balances: dict[str, Array] = field(default_factory=dict)
    received: dict[str, Array] = field(default_factory=dict)
    drift: dict[str, Array] = field(default_factory=dict)
    status: str = "exact"
    statistics: dict[str, int] = field(default_factory=dict)
    error_estimate: Array | None = None
