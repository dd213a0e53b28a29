"""Compares two attitude histories of one body."""

from __future__ import annotations

from dataclasses import dataclass, replace
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis._attitude_noise import attitude_noise
from polhode.analysis._mechanics import invariants_along
from polhode.analysis._printing import print_answer, write_numbers, write_span
from polhode.analysis.attitude_history import AttitudeHistory
from polhode.errors import InvalidInput, shown
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion
from polhode.spacecraft.comparing._clock_offset import ClockOffset, Moving, Samples, Wanted, find_clock_offset
from polhode.spacecraft.comparing.alignment import Alignment, fit_alignment
from polhode.types import Array, Float64


class ComparisonLimits(NamedTuple):
    """What counts as one time, as noise and as rounding."""

    equal_times: float = 1e-9  # of a step: samples this near are at one time, written with other digits
    max_rms: float = 2.0  # times the noise of the samples, up to which an angle is noise, rms
    max_peak: float = 6.0  # times the noise, which the largest of a million samples of it stays below
    rounding: float = 1e-12  # rad; smaller errors are rounding, and nothing is fitted to them
    # on the rounding of times: a steady turn meets the bound exactly, and speeds are estimates
    rounding_margin: float = 2.0


LIMITS = ComparisonLimits()


class Invariants(NamedTuple):
    """The invariants along one history.

    Attributes:
        times: (T,) [s, A's].
        values: name → (T,) or (T, 3), SI.
        drift: name → largest change from the first sample, relative.
        source: where the angular velocity is from.
    """

    times: Float64[Array, "time"]
    values: dict[str, Float64[Array, "..."]]
    drift: dict[str, float]
    source: str


@dataclass(frozen=True, eq=False)
class Comparison:
    """The difference of two attitude histories where they overlap.

    Attributes:
        names: of A and B.
        times: (T,) [s, A's].
        angle: (T,) of the rotation between them [rad].
        growth: slope of the angle's best line [rad/s], None for one time.
        alignment: constant misalignments and rate that explain most of it; None for one time or no difference.
        invariants: of A and B; None where they are not known.
        method: how both were brought to common times.
        interpolation_error: error of a spline through every second sample of B at the other samples [rad], which is
            larger than that of the spline through all; None where nothing was interpolated.
        rounding: angles up to this are of rounding, that of times included [rad].
        noise: root mean square angle by which the samples of both scatter, printed digits included [rad]; None where
            it is not known.
    """

    names: tuple[str, str]
    times: Float64[Array, "time"]
    angle: Float64[Array, "time"]
    growth: float | None
    alignment: Alignment | None
    invariants: tuple[Invariants | None, Invariants | None]
    method: str
    interpolation_error: float | None
    rounding: float = LIMITS.rounding
    noise: float | None = None

    @property
    def is_noise(self) -> bool:
        """Whether they differ by no more than the samples scatter."""
        return self._is_noise(self.angle)

    def _is_noise(self, angles: Float64[Array, "time"]) -> bool:
        noise = self.noise or 0.0
        rms, peak = float(np.sqrt(np.mean(angles**2))), float(angles.max())
        return rms <= LIMITS.max_rms * noise and peak <= LIMITS.max_peak * noise

    @property
    def is_rounding(self) -> bool:
        """Whether they differ by no more than rounding."""
        return self.largest <= self.rounding

    @property
    def largest(self) -> float:
        """Largest angle [rad]."""
        return float(self.angle.max())

    @property
    def rms(self) -> float:
        """Root of the mean square of the angle [rad]."""
        return float(np.sqrt(np.mean(self.angle**2)))

    @property
    def explained(self) -> bool:
        """Whether the alignment leaves only rounding, interpolation errors, or the noise of the samples."""
        if self.alignment is None or self.is_noise:
            return False
        left = float(self.alignment.remaining.max())
        return left <= max(self.rounding, self.interpolation_error or 0.0) or self._is_noise(self.alignment.remaining)

    def __str__(self) -> str:
        size = f"the rotation between {' and '.join(self.names)} is at most {write_numbers(self.largest, 'rad')}"
        if self.is_rounding:
            size += ", which is rounding"
        elif self.is_noise:
            size += ", no more than their samples scatter"
        elif self.explained:
            size += ", which another choice of axes explains"
        return print_answer(
            size, times=write_span(self.times, "s"), rms=write_numbers(self.rms, "rad"),
            growth=write_numbers(self.growth, "rad/s"),
        )


Source = AttitudeHistory | Trajectory | AbstractMotion


def compare(a: Source, b: Source, *, offset: float = 0.0) -> Comparison:
    """Compare two attitude histories along the same body axes.

    Where one is exact it is evaluated at the other's samples; where both are, at A's; of two sampled ones B is
    interpolated at A's samples by a spline of rotations, unless both have samples there.

    Args:
        a: the one that times are counted by: a history, a trajectory with attitudes, or a motion in closed form.
        b: the other; one of the two must have samples.
        offset: A's time at B's time zero [s].

    Raises:
        InvalidInput: for histories that have no time in common, two motions without samples, or anything else.

    >>> from polhode import FreeMotion
    >>> motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    >>> samples = motion.sample(np.linspace(0.0, 5.0, 100))
    >>> compare(motion, samples).largest < 1e-14
    True
    >>> history = AttitudeHistory("samples", samples.times, samples.attitude)
    >>> compare(history, AttitudeHistory("late", samples.times - 1.0, samples.attitude), offset=1.0).largest < 1e-15
    True
    """
    one, other = _take_samples(a, "a"), _take_samples(b, "b")
    if one is not None:
        return _compare(one, other or _evaluate(b, one.times - offset, "b"), offset)
    if other is not None:
        return _compare(_evaluate(a, other.times + offset, "a"), other, offset)
    raise InvalidInput("`a` and `b` are both motions in closed form, without samples; give a.sample(times) for one.")


def _compare(a: AttitudeHistory, b: AttitudeHistory, offset: float) -> Comparison:
    slack = _digits(a, b, offset)
    times = _common_times(a, b, offset, slack)
    at_a, _, _ = _attitude_at(a, times, 0.0, slack)
    at_b, method, missed = _attitude_at(b, times, offset, slack)
    if a.exact is not None:
        method = "both evaluated exactly" if b.exact is not None else "A evaluated exactly at B's samples"
    angle = rotation.angle_between(at_a, at_b)
    growth = float(np.polyfit(times - times[0], angle, 1)[0]) if len(times) > 1 else None
    rounding = max(LIMITS.rounding, LIMITS.rounding_margin * (a.resolution + b.resolution) * max(a.speed, b.speed))
    # a single rotation is explained by any misalignment
    alignment = fit_alignment(times, at_a, at_b) if len(times) > 1 and angle.max() > rounding else None
    invariants = _invariants(a, times, 0.0, slack), _invariants(b, times, offset, slack)
    return Comparison((a.name, b.name), times, angle, growth, alignment, invariants, method, missed, rounding,
                      _noise(a, b))


def _noise(a: AttitudeHistory, b: AttitudeHistory) -> float | None:
    """Return the noise of both together; an exact motion has none."""
    each = [0.0 if one.exact is not None else attitude_noise(one.times, one.attitude) for one in (a, b)]
    known = [noise for noise in each if noise is not None]
    return None if len(known) < 2 else float(np.hypot(known[0], known[1]))


def align_clocks(
    a: AttitudeHistory, b: AttitudeHistory, *, near: float | None = None, shift: Decimal = Decimal(0)
) -> ClockOffset:
    """Return A's time at B's time zero where the attitudes show it, with its error.

    A constant turn of the body axes is fitted along where the motion distinguishes it from an offset, else the axes are
    supposed to agree.

    Args:
        a: the one that times are counted by.
        b: the other.
        near: about where the offset lies [s], which decides where several fit.
        shift: added to offsets in messages, as times may be counted from stamps [s].

    Raises:
        InvalidInput: where no offset makes the two agree, several do, or the motion does not determine it.

    >>> from polhode import FreeMotion
    >>> motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    >>> a, b = (motion.sample(np.linspace(start, start + 20.0, 400)) for start in (0.0, 3.0))
    >>> one, other = (AttitudeHistory("", each.times - each.times[0], each.attitude) for each in (a, b))
    >>> abs(align_clocks(one, other).offset - 3.0) < 1e-6
    True
    """
    a, b = (_sort_by_time(one) for one in (a, b))
    back = b.exact is not None and a.exact is None
    sign = -1.0 if back else 1.0
    moving, sampled = (b, a) if back else (a, b)
    wanted = Wanted(lambda offset: _word_offset(Decimal(sign * offset) + shift), None if near is None else sign * near)
    samples = Samples(np.asarray(sampled.times), np.asarray(sampled.attitude))
    aligned = find_clock_offset(_make_moving(moving), samples, max(a.speed, b.speed), wanted)
    agreeing = None if aligned.agreeing is None else (sign * aligned.agreeing[0], aligned.agreeing[1])
    return aligned._replace(offset=sign * aligned.offset, agreeing=agreeing)


def _word_offset(offset: Decimal) -> str:
    """Return an offset [s] in words, to six digits and at least to a hundredth of a second."""
    few_digits = 1e4  # s; smaller offsets have a hundredth of a second within six digits
    value = float(offset)
    return f"{value:.6g}" if abs(value) < few_digits else f"{offset:.2f}"


def _make_moving(history: AttitudeHistory) -> Moving:
    first, last = float(history.times[0]), float(history.times[-1])
    if history.exact is not None:
        return Moving(history.exact, first, last, False)
    if len(history.times) < 3:
        raise InvalidInput(f"{history.name} has {len(history.times)} samples, which are too few to align clocks. Say "
                           "the offset by `offset`.")
    spline = _spline(history.times, history.attitude)
    return Moving(lambda times: (rotation.from_scipy(spline(times)), spline(times, 1)), first, last, True)


def _take_samples(source: Any, name: str) -> AttitudeHistory | None:
    """Return the history of a sampled source, None for a motion in closed form."""
    if isinstance(source, AttitudeHistory):
        return _sort_by_time(source)
    if isinstance(source, Trajectory) and source.attitude is not None:
        velocity = None if source.angular_velocity is None else np.asarray(source.angular_velocity)
        return _sort_by_time(AttitudeHistory(name, np.asarray(source.times), np.asarray(source.attitude), velocity))
    if isinstance(source, AbstractMotion):
        return None
    got = "a trajectory without attitudes" if isinstance(source, Trajectory) else shown(source)
    raise InvalidInput(f"`{name}` must be a file, an AttitudeHistory, a Trajectory with attitudes, or a motion; "
                       f"got {got}.")


def _sort_by_time(history: AttitudeHistory) -> AttitudeHistory:
    """Return a history in the order of its times.

    Raises:
        InvalidInput: for two samples at one time.
    """
    steps = np.diff(history.times)
    if (steps > 0).all():
        return history
    order = np.argsort(history.times, kind="stable")
    times = np.asarray(history.times)[order]
    if (np.diff(times) == 0).any():
        again = float(times[1:][np.diff(times) == 0][0])
        raise InvalidInput(f"{history.name} has two samples at {again:.9g} s. Leave out one.")
    velocity = None if history.angular_velocity is None else np.asarray(history.angular_velocity)[order]
    return replace(history, times=times, attitude=np.asarray(history.attitude)[order], angular_velocity=velocity)


def _evaluate(motion: Any, times: Array, name: str) -> AttitudeHistory:
    def exact(t: Array) -> tuple[Array, Array]:
        return np.asarray(motion.attitude(t)), np.asarray(motion.angular_velocity(t))

    return AttitudeHistory(name, times, *exact(times), exact)


def _common_times(a: AttitudeHistory, b: AttitudeHistory, offset: float, slack: float) -> Array:
    if a.exact is not None and b.exact is None:
        return b.times + offset
    if b.exact is not None:
        return a.times
    first, last = float(b.times[0]) + offset, float(b.times[-1]) + offset
    slack = slack + LIMITS.equal_times * (last - first) / max(1, len(b.times) - 1)
    common = a.times[(a.times >= first - slack) & (a.times <= last + slack)]
    if not len(common):
        raise InvalidInput(
            f"A and B have no time in common: A has samples from {a.times[0]:.9g} to {a.times[-1]:.9g} s, B from "
            f"{first:.9g} to {last:.9g} s of the same time. Check their epochs."
        )
    return common


def _digits(a: AttitudeHistory, b: AttitudeHistory, offset: float) -> float:
    """Return the largest gap [s] between equal times of A and B: their written precision, and rounding."""
    largest = max(abs(offset), *(abs(float(time)) for one in (a, b) for time in one.times[[0, -1]]))
    return a.resolution + b.resolution + 4.0 * float(np.spacing(largest))


def _attitude_at(
    history: AttitudeHistory, times: Array, offset: float, slack: float
) -> tuple[Array, str, float | None]:
    """Return the attitude at times [s, A's], the method, and the estimated error of interpolation."""
    if history.exact is not None:
        return history.exact(times - offset)[0], "B evaluated exactly at A's samples", None
    own, wanted = history.times, times - offset
    nearest, between = _nearest(own, wanted, slack)
    attitude = history.attitude[nearest]
    if not between.any():
        return attitude, "both have samples at the same times", None
    attitude[between] = _spline_at(history, wanted[between])
    return attitude, "B interpolated by a spline of rotations at A's samples", _interpolation_error(history, wanted)


def _nearest(own: Array, wanted: Array, slack: float) -> tuple[Array, Array]:
    """Return which samples at times ``own`` (n,) are nearest to times (T,), and whether these lie between samples."""
    if len(own) == 1:
        return np.zeros(len(wanted), dtype=int), np.zeros(len(wanted), dtype=bool)
    right = np.clip(np.searchsorted(own, wanted), 1, len(own) - 1)
    nearest = np.where(wanted - own[right - 1] < own[right] - wanted, right - 1, right)
    return nearest, np.abs(wanted - own[nearest]) > LIMITS.equal_times * (own[right] - own[right - 1]) + slack


def _spline(times: Array, attitude: Array) -> Any:
    from scipy.spatial.transform import RotationSpline

    return RotationSpline(times, rotation.as_scipy(attitude))


def _spline_at(history: AttitudeHistory, times: Array) -> Array:
    clipped = np.clip(times, history.times[0], history.times[-1])
    return rotation.from_scipy(_spline(history.times, history.attitude)(clipped))


def _interpolation_error(history: AttitudeHistory, wanted: Array) -> float:
    """Return the deviation of a spline through every second sample from the others; π where there are too few."""
    times, attitude = history.times, history.attitude
    odd = np.arange(1, len(times) - 1, 2)
    if len(odd) < 2:
        return float(np.pi)
    between = rotation.from_scipy(_spline(times[::2], attitude[::2])(np.clip(times[odd], times[0], times[::2][-1])))
    angle = rotation.angle_between(between, attitude[odd])
    within = (times[odd + 1] >= wanted[0]) & (times[odd - 1] <= wanted[-1])
    return float(angle[within].max() if within.any() else angle.max())


def _invariants(history: AttitudeHistory, common: Array, offset: float, slack: float) -> Invariants | None:
    """Return the invariants along a history's own samples, or at the common times where it is exact."""
    ends = 16  # samples whose rates a spline does not have; its error falls to a quarter with each
    mechanics = history.mechanics
    if mechanics is None:
        return None
    if history.exact is not None:
        times, source = common, "the exact motion"
        attitude, velocity = history.exact(common - offset)
    else:
        own = history.times + offset
        within = (own >= common[0] - slack) & (own <= common[-1] + slack)
        times, attitude, source = own[within], history.attitude[within], "as given"
        if not within.any():
            return None
        if history.angular_velocity is not None:
            velocity = history.angular_velocity[within]
        elif len(own) > 4 * ends and within[ends:-ends].any():
            source = f"from the attitudes, by a spline of rotations without {ends} samples at either end"
            within[:ends] = within[-ends:] = False
            times, attitude = own[within], history.attitude[within]
            velocity = _spline(history.times, history.attitude)(history.times[within], 1)
        else:
            return None
    return Invariants(times, *invariants_along(attitude, velocity, mechanics), source)
