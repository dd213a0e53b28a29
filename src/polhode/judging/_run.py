"""Drift, growth of errors and where spins end, in the states that a physics engine gave of a free body."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.bodies._inertia import principal_axes
from polhode.exact.free_body import FreeMotion
from polhode.types import Array, Float64


class RunThresholds(NamedTuple):
    """Numbers that decide which drift, growth and end of a spin a run has.

    Attributes:
        max_attitude_error: rad; an attitude with a larger error has lost the phase, and says nothing of growth.
        max_distance_from_axis: of 1/I1 − 1/I3; a spin whose 2E/|L|² is nearer to an axis's value has ended there.
        min_periods: of the polhode; in fewer a drift cannot be distinguished from the swing within a period.
        max_drift: relative change of an invariant up to which its drift has one rate.
        min_samples: that a fitted line needs.
        max_momentum_growth: times |L| at the start; an engine that lets it grow further follows no motion any more.
        min_anisotropy: of 1/I; a body whose values of 1/I differ by less is a sphere, with no axes to end at.
        exponent_tolerance: by which an exponent of growth may miss a whole number.
        min_growth_samples: that an exponent of growth needs.
    """

    max_attitude_error: float = 0.5
    max_distance_from_axis: float = 0.02
    min_periods: float = 2.0
    max_drift: float = 0.1
    min_samples: int = 16
    max_momentum_growth: float = 10.0
    min_anisotropy: float = 1e-9
    exponent_tolerance: float = 0.25
    min_growth_samples: int = 8


LIMITS = RunThresholds()


@dataclass(frozen=True, eq=False)
class EngineRun:
    """States of a torque-free body that an engine computed.

    Attributes:
        inertia: (3, 3) about the centre of mass [kg m², body axes].
        times: (T,) rising, the first that of the start [s].
        attitude: (T, 4) unit quaternions wxyz, body → space; the first is the start's.
        momentum: (T, 3) [kg m²/s, body axes].
        eps: rounding unit of the engine's type of number.
        steps: the number of steps it took.
        printed_unit: unit of the last printed digit, relative to the states; 0 if all digits are there.
    """

    inertia: Float64[Array, "3 3"]
    times: Float64[Array, "time"]
    attitude: Float64[Array, "time 4"]
    momentum: Float64[Array, "time 3"]
    eps: float
    steps: int
    printed_unit: float = 0.0

    @cached_property
    def motion(self) -> FreeMotion:
        """The exact motion from the first state, along the body's axes."""
        return exact_motion(self.inertia, self.attitude[0], self.momentum[0], float(self.times[0]))

    @cached_property
    def angular_velocity(self) -> Float64[Array, "time 3"]:
        """(T, 3) [rad/s, body axes]."""
        return np.linalg.solve(self.inertia, self.momentum.T).T

    @cached_property
    def turned(self) -> Float64[Array, "time"]:
        """(T,) angle through which the exact motion has rotated since the start [rad]."""
        return turned_angle(self.motion, self.times)

    @cached_property
    def periods(self) -> float:
        """The number of periods of its polhode in the run; infinite where the polhode is a point."""
        period = self.motion.period
        return np.inf if period is None else float(self.times[-1] - self.times[0]) / float(period)

    @cached_property
    def energy(self) -> Float64[Array, "time"]:
        """(T,) [J]."""
        return 0.5 * np.sum(self.momentum * self.angular_velocity, axis=-1)

    @cached_property
    def momentum_norm(self) -> Float64[Array, "time"]:
        """(T,) |L| [kg m²/s]."""
        return np.linalg.norm(self.momentum, axis=-1)

    @cached_property
    def angle(self) -> Float64[Array, "time"]:
        """(T,) between the engine's attitude and the exact one [rad]."""
        return np.asarray(rotation.angle_between(self.attitude, np.asarray(self.motion.attitude(self.times))))

    @cached_property
    def direction(self) -> Float64[Array, "time"]:
        """(T,) between L and L at the start, in space [rad]."""
        space = np.asarray(rotation.rotate(self.attitude, self.momentum))
        start = space[0]
        return np.arctan2(np.linalg.norm(np.cross(start, space), axis=-1), space @ start)


class Drift(NamedTuple):
    """How an invariant changes.

    Attributes:
        change: from the first sample to the last, relative.
        per_radian: slope of the fitted line, relative, per radian of rotation.
        swing: half the range of the residuals about that line, relative.
        is_seen: whether the line changes by more than the swing and rounding.
        error: of the slope, from the residuals of the means of eight parts of the run; NaN where it is not known, as in
            a run of less than two periods of the polhode, in which only a change by more than a tenth is a drift.
    """

    change: float
    per_radian: float
    swing: float
    is_seen: bool
    error: float = float("nan")


class Growth(NamedTuple):
    """Growth of the error of attitude.

    Attributes:
        exponent: of the rotation angle, between an eighth of it and its end; None where rounding or loss hides it.
        word: "linear", "quadratic", "faster", "slower", "between linear and quadratic", "lost" or "rounding".
        largest: error in the run [rad].
        lost_after: rotation angle when the error passes 0.5 rad [rad]; None where it does not.
    """

    exponent: float | None
    word: str
    largest: float
    lost_after: float | None


class SpinEnd(NamedTuple):
    """Start and end of a spin by 2E/|L|², which is 1/I about a principal axis of moment I.

    Attributes:
        start, end: 2E/|L|² [1/(kg m²)].
        toward: "largest", "middle" or "least", the principal axis where it has ended; "larger moments" or "smaller
            moments" where it is still on its way; "none" where it does not move; "unknown" where states are too few;
            "undecided" where the run has less than two periods of the polhode, in each of which the spin swings.
    """

    start: float
    end: float
    toward: str

    @property
    def reached(self) -> bool:
        """Whether it has ended at a principal axis."""
        return self.toward in {"largest", "middle", "least"}


def exact_motion(
    inertia: Float64[Array, "3 3"], attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], epoch: float = 0.0
) -> FreeMotion:
    """Return the exact motion of a free body whose inertia (3, 3) need not be diagonal, along its own axes.

    Args:
        inertia: (3, 3) symmetric [kg m², body axes].
        attitude: (4,) unit quaternion wxyz at the epoch, body → space.
        momentum: (3,) at the epoch [kg m²/s, body axes].
        epoch: time at which these hold [s].

    Raises:
        InvalidInput: for what ``FreeMotion`` refuses.
    """
    moments, axes = principal_axes(np.asarray(inertia, dtype=float))
    return FreeMotion(moments, momentum=momentum, attitude=attitude, epoch=epoch, axes=axes)


def turned_angle(motion: FreeMotion, times: Float64[Array, "time"]) -> Float64[Array, "time"]:
    """Integrate |ω| from the first of the times (T,) to each of them, by the trapezoidal rule [rad]."""
    speed = np.linalg.norm(np.asarray(motion.angular_velocity(times)), axis=-1)
    parts = 0.5 * (speed[1:] + speed[:-1]) * np.abs(np.diff(times))
    return np.concatenate([[0.0], np.cumsum(parts)])


def measure_drift(
    values: Float64[Array, "time"], angles: Float64[Array, "time"], rounding: float, periods: float = np.inf
) -> Drift:
    """Measure the drift of an invariant over the rotation angle.

    A drift is measured where the slopes of both halves and of the whole have one sign and the line changes by more than
    the residuals swing; an invariant that only swings, as those of symplectic methods do, has none. The line is fitted
    to the time before the invariant has changed by a tenth for good; one that comes back swings.

    Args:
        values: (T,) of the invariant, the first not 0.
        angles: (T,) of rotation, rising [rad].
        rounding: largest relative change that rounding explains.
        periods: of the polhode in the run.

    >>> import numpy as np
    >>> angles = np.linspace(0.0, 100.0, 1001)
    >>> drift = measure_drift(1.0 - 1e-4 * angles + 1e-3 * np.sin(angles), angles, 1e-12)
    >>> drift.is_seen, round(drift.per_radian, 5)
    (True, -0.0001)
    """
    whole = values / values[0] - 1.0
    out = np.flatnonzero(~(np.abs(whole) < LIMITS.max_drift))
    # the rate is that before the large change; a spin that has ended, or an engine that has diverged, has none after it
    comes_back = len(out) > 0 and (np.abs(whole[out[0] :]) < LIMITS.max_drift / 2.0).any()
    change = whole[: out[0]] if len(out) and out[0] >= LIMITS.min_samples and not comes_back else whole
    angles, last = angles[: len(change)], float(whole[-1])
    if len(change) < LIMITS.min_samples or not np.isfinite(change).all():
        return Drift(last, last / float(angles[-1] or 1.0), 0.0, not abs(last) <= rounding)
    slope, offset = np.polyfit(angles, change, 1)
    residuals = change - (slope * angles + offset)
    swing, line = 0.5 * float(np.ptp(residuals)), abs(float(slope)) * float(angles[-1])
    middle = len(change) // 2
    halves = [np.polyfit(angles[part], change[part], 1)[0] for part in (slice(None, middle), slice(middle, None))]
    one_way = min(float(np.sign(slope) * half) for half in halves) > 0.0
    drifts = one_way and line > max(swing, rounding)
    if periods < LIMITS.min_periods:
        return Drift(last, float(slope), swing, bool(drifts and len(out) > 0 and not comes_back))
    return Drift(last, float(slope), swing, bool(drifts), _slope_error(angles, residuals))


def _slope_error(angles: Float64[Array, "time"], residuals: Float64[Array, "time"]) -> float:
    """Return the standard error of a line's slope by the means of residuals over parts of a run."""
    blocks = 8
    means = np.array([part.mean() for part in np.array_split(residuals, blocks)])
    at = np.array([part.mean() for part in np.array_split(angles, blocks)])
    at -= at.mean()
    return float(np.sqrt((means**2).sum() / (blocks - 2) / (at @ at)))


def measure_growth(errors: Float64[Array, "time"], angles: Float64[Array, "time"], rounding: float) -> Growth:
    """Measure how an error of attitude (T,) [rad] grows with the rotation angle (T,) [rad].

    The exponent is that of the largest error so far, by its logarithm, from an eighth of the way to where the
    attitude is lost. A method that keeps energy on average has 1, one whose frequency drifts has 2.

    Args:
        errors: (T,) [rad].
        angles: (T,) of rotation, rising [rad].
        rounding: largest error that rounding explains [rad].

    >>> import numpy as np
    >>> angles = np.linspace(0.0, 100.0, 1001)
    >>> measure_growth(1e-5 * angles**2, angles, 1e-12).word
    'quadratic'
    """
    lost = np.flatnonzero(~(errors < LIMITS.max_attitude_error))
    stop = int(lost[0]) if len(lost) else len(errors)
    lost_after = float(angles[stop]) if len(lost) else None
    finite = errors[np.isfinite(errors)]
    largest = float(finite.max(initial=0.0)) if len(finite) == len(errors) else float("inf")
    if largest <= rounding:
        return Growth(None, "rounding", largest, None)
    highest, along = np.maximum.accumulate(errors[:stop]), angles[:stop]
    used = (along >= along[-1] / 8.0) & (highest > rounding) & (along > 0.0)
    if used.sum() < LIMITS.min_growth_samples:
        return Growth(None, "lost" if len(lost) else "unknown", largest, lost_after)
    exponent = float(np.polyfit(np.log(along[used]), np.log(highest[used]), 1)[0])
    return Growth(exponent, _word_exponent(exponent), largest, lost_after)


def _word_exponent(exponent: float) -> str:
    for power, word in ((1.0, "linear"), (2.0, "quadratic")):
        if abs(exponent - power) <= LIMITS.exponent_tolerance:
            return word
    if exponent < 1.0:
        return "slower than linear"
    return "between linear and quadratic" if exponent < 2.0 else "faster than quadratic"


def find_spin_end(run: EngineRun) -> SpinEnd:
    """Return where a spin drifts under an engine's own errors, by 2E/|L|² at the start and at the end.

    It moves where the mean of the last eighth, or of the last period of the polhode if this is longer, leaves the start
    by more than it swings and by more than rounding. It has ended where it moved by 2% of the range, and both of the
    last two such parts are within 2% from the value of an axis. Only states before |L| has grown tenfold count.
    """
    moments = np.linalg.eigvalsh(run.inertia)
    with np.errstate(all="ignore"):
        ratio = 2.0 * run.energy / run.momentum_norm**2
        largest = LIMITS.max_momentum_growth * run.momentum_norm[0]
        grown = np.flatnonzero(~(np.isfinite(ratio) & (run.momentum_norm < largest)))
    whole = len(ratio)
    ratio = ratio[: grown[0]] if len(grown) else ratio
    if len(ratio) < LIMITS.min_samples:
        return SpinEnd(float(ratio[0]), float("nan"), "unknown")
    periods = run.periods * len(ratio) / whole
    size = max(2, len(ratio) // 8, min(len(ratio) // 2, int(np.ceil(len(ratio) / max(periods, 1.0)))))
    first, before, last = ratio[:size], ratio[-2 * size : -size], ratio[-size:]
    start, end = float(ratio[0]), float(last.mean())
    span = float(1.0 / moments[0] - 1.0 / moments[2])
    swing = 0.5 * max(float(np.ptp(first)), float(np.ptp(last)))
    moved = end - float(first.mean())
    stays = abs(end - start) <= max(swing, run.eps * run.steps * end) or moved * (end - start) <= 0.0
    if stays or span <= LIMITS.min_anisotropy * end:
        return SpinEnd(start, end, "none")
    reach = LIMITS.max_distance_from_axis * span
    values = {"least": 1.0 / moments[0], "middle": 1.0 / moments[1], "largest": 1.0 / moments[2]}
    for name, value in values.items():
        nearer = abs(end - value) + reach < abs(start - value)
        if nearer and max(abs(end - value), abs(float(before.mean()) - value)) <= reach:
            return SpinEnd(start, end, name)
    if periods < LIMITS.min_periods:
        return SpinEnd(start, end, "undecided")
    return SpinEnd(start, end, "larger moments" if end < start else "smaller moments")
