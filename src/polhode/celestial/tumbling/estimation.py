"""The motion of a body that tumbles freely, from its two periods and the ratios of its moments of inertia."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize.elementwise import find_root
from scipy.spatial.transform import Rotation

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.estimation._estimate import Estimate
from polhode.exact.free_body.motion import FreeMotion
from polhode.motion._inputs import number_of
from polhode.types import Array, ArrayLike, Float64, Real

Mode = Literal["short-axis", "long-axis"]
PrecessingAxis = Literal["encircled", "long", "short"]
DRAWS = 2048  # within the errors, for an interval: its ends scatter by 0.06 standard deviations
MODES: tuple[Mode, Mode] = ("short-axis", "long-axis")
NAMES = ("energy_ratio", "cone_angle", "momentum_rate")


@dataclass(frozen=True, eq=False)
class TumblingInterval:
    """Intervals of the motion, from the errors of periods and moments.

    Attributes:
        estimate: energy ratio, cone angle [rad] and momentum rate [rad/s] with the covariance of the draws.
        low: (3,) ends of the intervals of 95 %, below which 2.5 % of the admissible draws lie.
        high: (3,) above which 2.5 % lie.
        admissible: share of the draws for which there is a motion in this mode.
    """

    estimate: Estimate
    low: Float64[Array, "3"]
    high: Float64[Array, "3"]
    admissible: float


@dataclass(frozen=True, eq=False)
class Tumbling:
    """A free motion with given periods.

    Attributes:
        mode: "short-axis" or "long-axis": about which principal axis the polhode runs. L stays nearer to this axis.
        moments: (3,) I1 ≤ I2 ≤ I3 over I3.
        energy_ratio: E/E0, E0 = L²/2I3 being the least energy of this angular momentum.
        cone_angle: of the encircled axis with L where L₂ = 0 [rad].
        tilts: least and greatest angle of the encircled axis with L [rad].
        momentum_rate: L/I3 [rad/s]: the spin about axis 3 in the state of least energy.
        precession: mean period of the encircled axis about L [s], P_φ of Kaasalainen 2001 and Pravec et al. 2005.
        rotation: period of the motion along the body's axes [s], P_ψ there.
        long_axis: mean period of the long axis about L [s].
        short_axis: mean period of the short axis about L [s].
        motion: along the principal axes, moments over I3, times in seconds. In space L is along z; the motion begins
            where L₁ = 0 (short-axis) or L₃ = 0 (long-axis).
        interval: by the errors of the input; None where none are given.
    """

    mode: Mode
    moments: Float64[Array, "3"]
    energy_ratio: float
    cone_angle: float
    tilts: tuple[float, float]
    momentum_rate: float
    precession: float
    rotation: float
    long_axis: float
    short_axis: float
    motion: FreeMotion
    interval: TumblingInterval | None = None


@known_numbers_only
def fit_tumbling(
    precession: float,
    rotation: float,
    moments: Real[ArrayLike, "3"],
    axis: PrecessingAxis = "encircled",
    errors: Real[ArrayLike, "5"] | None = None,
    seed: int = 0,
) -> tuple[Tumbling, ...]:
    """Return the motions with given periods, the one of least energy first; there are one or two.

    The ratio P_ψ/P_φ falls from infinity at the separatrix to its limit at the permanent rotation in either mode, so
    each mode has one motion or none; ``least_period_ratios`` are the limits. The energy follows from the ratio, and the
    size of the angular momentum from the periods.

    Args:
        precession: mean period of a principal axis about L [s].
        rotation: period of the motion along the body's axes [s].
        moments: (3,) I1 ≤ I2 ≤ I3 in any unit.
        axis: whose precession is meant: the encircled axis (short in the short-axis mode, long in the long-axis mode;
            Kaasalainen, A&A 376, 302, 2001), the long axis in either mode (Samarasinha & A'Hearn, Icarus 93, 194,
            1991), or the short axis in either mode.
        errors: standard deviations of precession, rotation and the three moments, in their units; the last may be 0.
        seed: of the draws within the errors.

    Raises:
        InvalidInput: if a period is not positive and finite, the moments are not those of a body in rising order, all
            three are equal, or no motion has these periods.

    Example:
        >>> apophis = fit_tumbling(27.38, 263.0, [0.61, 0.965, 1.0])[0]
        >>> apophis.mode, round(apophis.energy_ratio, 6)
        ('short-axis', 1.023637)
    """
    moments = _check_moments(moments)
    precession, rotation = check.positive(precession=precession, rotation=rotation)
    check.one_of("axis", axis, ("encircled", "long", "short"))
    sizes = _check_errors(errors)
    motions = []
    for mode in MODES:
        solved = _solve(mode, np.array([precession]), np.array([rotation]), moments[None], axis)
        if not np.isfinite(solved.place[0]):
            continue
        interval = None if sizes is None else _interval(mode, precession, rotation, moments, axis, sizes, seed)
        motions.append(_make_motion(mode, solved, rotation, interval))
    if not motions:
        raise InvalidInput(_why_none(precession, rotation, moments, axis))
    return tuple(motions)


@known_numbers_only
def least_period_ratios(moments: Real[ArrayLike, "3"]) -> tuple[float, float]:
    """Return the least P_ψ/P_φ of the short-axis and of the long-axis mode, P_φ being of the encircled axis.

    They are those of small wobbles about axis 3 and axis 1; infinite where the mode does not exist, for an oblate body
    (no long-axis mode) and a prolate one (no short-axis mode).

    Args:
        moments: (3,) I1 ≤ I2 ≤ I3 in any unit.

    Raises:
        InvalidInput: if they are not moments of a body in rising order, or all equal.

    Example:
        >>> [round(limit, 3) for limit in least_period_ratios([0.61, 0.965, 1.0])]
        [7.567, 1.64]
    """
    i1, i2, i3 = _check_moments(moments).tolist()
    with np.errstate(divide="ignore"):
        # small wobbles about axis 3 with L in the body at λ = ω √((I3−I1)(I3−I2)/(I1 I2)); the axis goes round L at
        # ω + λ, so that P_ψ/P_φ = 1 + ω/λ, and about axis 1 at ω − λ
        short = 1.0 + np.sqrt(np.divide(i1 * i2, (i3 - i1) * (i3 - i2)))
        long = np.sqrt(np.divide(i2 * i3, (i2 - i1) * (i3 - i1))) - 1.0
    return float(short), float(long)


def _check_moments(moments: ArrayLike) -> Float64[Array, "3"]:
    values = check.array("moments", moments, (3,), above=0, ascending=True)
    i1, i2, i3 = values.tolist()
    if i1 + i2 < i3 * (1 - 1e-12):
        raise InvalidInput(f"`moments` must obey I1 + I2 >= I3, as those of every body do; got {shown(moments)}.")
    if i1 == i3:
        raise InvalidInput("`moments` must not all be equal: a sphere does not tumble.")
    return values / i3


def _check_errors(errors: ArrayLike | None) -> Float64[Array, "5"] | None:
    if errors is None:
        return None
    remedy = "Give the standard deviations of precession, rotation and the three moments."
    sizes = check.array("errors", errors, (5,), least=0, remedy=remedy)
    return sizes if sizes.any() else None


@dataclass(frozen=True, eq=False)
class _Solved:
    """Motions of one mode (n,): ln of the ratio of the components of L, not a number where there is none."""

    place: Float64[Array, "n"]
    momentum: Float64[Array, "n 3"]
    moments: Float64[np.ndarray, "n 3"]
    rate: Float64[Array, "n"]

    @property
    def energy_ratio(self) -> Float64[Array, "n"]:
        return (self.momentum**2 / self.moments).sum(axis=-1)

    def numbers(self, mode: Mode) -> Float64[Array, "n 3"]:
        """Return energy ratio, cone angle and momentum rate."""
        return np.stack([self.energy_ratio, self.angles(mode)[0], self.rate], axis=-1)

    def angles(self, mode: Mode) -> tuple[Float64[Array, "n"], Float64[Array, "n"]]:
        """Return the angle of the encircled axis with L where L₂ = 0, and where the other component is.

        The section at the start has the tangent of the second angle for ratio; the energy gives the first.
        """
        with np.errstate(invalid="ignore", divide="ignore"):
            i1, i2, i3 = np.moveaxis(self.moments, -1, 0)
            second = np.arctan2(self.momentum[:, 1], self.momentum[:, 2 if mode == "short-axis" else 0])
            if mode == "short-axis":  # at both places sin² times 1/I − 1/I3 is the energy over the least
                ratio = i1 * (i3 - i2) / (i2 * (i3 - i1))
            else:
                ratio = i3 * (i2 - i1) / (i2 * (i3 - i1))
            first = np.arcsin(np.minimum(np.sin(second) * np.sqrt(ratio), 1.0))
        return first, second


def _solve(mode: Mode, precession: Array, rotation: Array, moments: Array, axis: PrecessingAxis) -> _Solved:
    """Return the motion of a mode for each of n pairs of periods and moments (n, 3) over I3."""
    # of ln(L3/L2) or ln(L1/L2); closer to either end, double precision does not resolve the periods
    separatrix, principal = -320.0, 40.0
    wanted = rotation / precession  # turns of the precession in a period of rotation
    if mode == "short-axis" and axis == "long":
        wanted = wanted + 1.0
    if mode == "long-axis" and axis == "short":
        wanted = wanted - 1.0
    exists = moments[:, 2] > moments[:, 1] if mode == "short-axis" else moments[:, 1] > moments[:, 0]
    safe = np.where(exists[:, None], moments, [1.0, 1.5, 2.0])

    def excess(place: Array, i1: Array, i2: Array, i3: Array, turns: Array) -> Array:
        return _turns(mode, np.stack([i1, i2, i3], axis=-1), place)[0] - turns

    roots = find_root(excess, (separatrix, principal), args=(*safe.T, wanted))
    place = np.where(roots.success, roots.x, 0.0)
    exists &= roots.success
    _, period, momentum = _turns(mode, safe, place)
    place = np.where(exists, place, np.nan)
    nowhere = np.where(exists, 1.0, np.nan)
    return _Solved(place, momentum * nowhere[:, None], np.asarray(moments), nowhere * period / rotation)


def _turns(mode: Mode, moments: Array, place: Array) -> tuple[Array, Array, Array]:
    """Return turns of the precession in a period, the period, and L of size 1, where L begins at the section."""
    small, large = np.exp(np.minimum(place, 0.0)), np.exp(np.minimum(-place, 0.0))
    none = np.zeros_like(place)
    parts = (none, large, small) if mode == "short-axis" else (small, large, none)
    momentum = np.stack(parts, axis=-1) / np.hypot(small, large)[:, None]
    motion = FreeMotion(moments, momentum=momentum)
    return np.asarray(motion.precession_per_period) / (2 * np.pi), np.asarray(motion.period), momentum


def _interval(
    mode: Mode, precession: float, rotation: float, moments: Array, axis: PrecessingAxis, sizes: Array, seed: int
) -> TumblingInterval | None:
    """Return the intervals, by draws within the errors: near its limits a motion depends on them nonlinearly."""
    normal = np.random.default_rng(seed).standard_normal((DRAWS, 5))
    draws = np.array([precession, rotation, *moments]) + normal * sizes
    drawn = np.sort(draws[:, 2:], axis=-1)
    drawn = drawn / drawn[:, 2:]
    possible = (draws[:, :2] > 0).all(axis=-1) & (drawn[:, 0] > 0) & (drawn[:, 0] + drawn[:, 1] >= 1.0)
    possible &= drawn[:, 0] < 1.0
    solved = _solve(mode, draws[possible, 0], draws[possible, 1], drawn[possible], axis)
    numbers = solved.numbers(mode)
    numbers = numbers[np.isfinite(numbers).all(axis=-1)]
    if len(numbers) < 2:
        return None
    low, high = np.quantile(numbers, [0.025, 0.975], axis=0)
    estimate = Estimate(NAMES, np.median(numbers, axis=0), np.cov(numbers, rowvar=False))
    return TumblingInterval(estimate, low, high, len(numbers) / DRAWS)


def _make_motion(mode: Mode, solved: _Solved, rotation: float, interval: TumblingInterval | None) -> Tumbling:
    energy, cone, rate = solved.numbers(mode)[0].tolist()
    angles = sorted(float(angle[0]) for angle in solved.angles(mode))
    moments = solved.moments[0]
    start = solved.momentum[0]
    upright = Rotation.align_vectors([0.0, 0.0, 1.0], start)[0].as_quat(scalar_first=True)
    motion = FreeMotion(moments, momentum=rate * start, attitude=upright)
    precession = 2 * np.pi / (number_of(motion.precession_per_period) / number_of(motion.period))
    # an axis that L does not circle turns by the precession less or plus one turn in a period
    turn, roll = 1.0 / precession, 1.0 / rotation
    long = 1.0 / (turn - roll) if mode == "short-axis" else precession
    short = precession if mode == "short-axis" else 1.0 / (turn + roll)
    return Tumbling(
        mode, moments, energy, cone, (angles[0], angles[1]), rate, precession, rotation, long, short, motion, interval
    )


def _why_none(precession: float, rotation: float, moments: Array, axis: PrecessingAxis) -> str:
    short, long = least_period_ratios(moments)
    if axis == "long":
        short -= 1.0
    if axis == "short":
        long += 1.0
    limits = [f"the {mode} mode needs more than {limit:.4g}" for mode, limit in zip(MODES, (short, long), strict=True)
              if np.isfinite(limit)]
    return (
        f"no motion of a body with moments {', '.join(f'{x:.4g}' for x in moments)} has these periods: the period of "
        f"rotation is {rotation / precession:.4g} times that of precession, and {'; '.join(limits)}. Check which "
        "period is which, whose precession it is (`axis`), and the moments."
    )
