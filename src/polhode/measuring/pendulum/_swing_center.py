"""The place of the centre of mass on the scale of the pivots that a body swung about, from the periods alone."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.stats import chi2

from polhode.errors import InvalidInput
from polhode.estimation._estimate import Estimate
from polhode.measuring.pendulum._swing_moments import LIMITS as MOMENT_LIMITS
from polhode.measuring.pendulum._swing_moments import whiten
from polhode.types import Array, Float64


class CenterThresholds(NamedTuple):
    """Numbers that decide which places of the centre of mass explain the periods.

    Attributes:
        min_probability: of a misfit; a place with a less probable one is excluded.
        place_tolerance: of the scale; places that differ by less are one.
        min_moment: of m·reach²; no body has a smaller one.
    """

    min_probability: float = 1e-3
    place_tolerance: float = 1e-6
    min_moment: float = 1e-9


LIMITS = CenterThresholds()
MAX_ERRORS = math.sqrt(float(chi2.isf(LIMITS.min_probability, 1)))  # standard errors with that probability


class _Place(NamedTuple):
    """The best place on a stretch of the scale between pivots.

    Attributes:
        at: the place, on the stretch [m].
        moments: of the swings there.
        step: to the place of least χ² where that lies beyond the stretch, else about zero [m].
        moment: common to the swings, with that step [kg m²].
        covariance: of step and moment; infinite where the swings do not determine the place.
        misfit: χ² at ``at``.
        held: the common moment at ``at`` [kg m²], and its error there, without that of the place.
        stretch: its ends [m].
    """

    at: float
    moments: Estimate
    step: float
    moment: float
    covariance: Array
    misfit: float
    held: tuple[float, float]
    stretch: tuple[float, float]

    @property
    def error(self) -> float:
        return math.sqrt(self.covariance[0, 0])

    @property
    def is_open(self) -> bool:
        """Whether its error is as wide as the stretch, so that each place on it fits."""
        return self.error > self.stretch[1] - self.stretch[0]

    def may_be_a_body(self, least: float) -> bool:
        """Whether the moment is positive within its error; for one of about zero, without the error of the place.

        At a pivot without a jig the moment is zero, without an error.
        """
        moment, error = self.held
        return moment + MAX_ERRORS * (error if abs(moment) <= least else math.sqrt(self.covariance[1, 1])) > least

    def __str__(self) -> str:
        if self.is_open:
            return "anywhere from {} to {} m".format(*map(_digits, self.stretch))
        return f"at {_digits(self.at)} m ({self.held[0]:.4g} kg m²)"


def find_center(
    moments_at: Callable[[float], Estimate], mass: float, axes: Array, places: Array, reach: Array
) -> tuple[Estimate, Estimate, Estimate, float]:
    """Return the place of the centre of mass on the pivots' scale, the moments there, the common one, and the misfit.

    A centre s gives each swing a moment; the right centre makes them all equal. About a pivot at p it is
    A + m(L|s − p| − (s − p)²), where L is the length of the simple pendulum of its period and A the jig's share. Plus
    ms² it is linear in s between neighbouring pivots, so that each such stretch has one solution of least squares,
    apart from the weights, which change with s.

    Args:
        moments_at: of a place, the moments of the swings.
        mass: of the body [kg].
        axes: (n, 3) of the swings.
        places: (n,) of the pivots on the scale [m].
        reach: (n,) L of each [m].

    Raises:
        InvalidInput: for pivots of several axes or at one place, and where no or several places explain the periods.
    """
    if len(places) < 2 or np.ptp(places) == 0.0:
        raise InvalidInput("the place of the centre of mass follows from pivots at two places at least. Give a second "
                           "swing, or the distance.")
    if max(np.linalg.norm(np.cross(axes[0], axis)) for axis in axes) > MOMENT_LIMITS.axis_tolerance:
        raise InvalidInput("pivots on one scale must swing about the same axis; give distances for several axes.")
    far = _farthest(moments_at, mass, places, reach)
    low, high = float(np.max(places - far)), float(np.min(places + far))
    if not low < high:
        raise InvalidInput(_too_far_apart(places, far))
    borders = [low, *sorted(p for p in set(places.tolist()) if low < p < high), high]
    tried = [one for stretch in pairwise(borders) for one in _solve_stretch(moments_at, mass, places, reach, stretch)]
    least = LIMITS.min_moment * mass * float(np.max(reach)) ** 2
    bodies = [one for one in tried if one.may_be_a_body(least)]
    freedom = max(len(places) - 2, 1)
    fitting = [one for one in bodies if chi2.sf(one.misfit, freedom) > LIMITS.min_probability]
    united = _unite(fitting, high - low)
    _check_unique(united, bodies or tried, freedom)
    (one,) = united
    known = one.moments.degrees_of_freedom
    center = Estimate(("center",), np.array([one.at + one.step]), one.covariance[:1, :1], known)
    combined = Estimate(("axis 1",), np.array([one.moment]), one.covariance[1:, 1:], known)
    return center, one.moments, combined, one.misfit


def _farthest(moments_at: Callable[[float], Estimate], mass: float, places: Array, reach: Array) -> Float64[Array, "n"]:
    """Return the distance from each pivot at which its moment, with its error, falls to zero.

    That is L/2 + √(L²/4 + A/m), plus its error: the measured moment of a thin body may be negative.
    """
    away = np.abs(places[0] - places)
    jig = moments_at(float(places[0])).value / mass - away * (reach - away)
    root = np.sqrt(np.maximum(0.25 * reach**2 + jig, 0.0))
    far = 0.5 * reach + root
    error = np.array([moments_at(p + d).standard_error[k] for k, (p, d) in enumerate(zip(places, far, strict=True))])
    return far + MAX_ERRORS * error / (2.0 * mass * np.maximum(root, LIMITS.place_tolerance * reach))


def _solve_stretch(
    moments_at: Callable[[float], Estimate], mass: float, places: Array, reach: Array, stretch: tuple[float, float]
) -> Iterator[_Place]:
    """Yield the places on a stretch at which weighted least squares converge; one, unless weights change much."""
    low, high = stretch
    converged = 1e-9 * (high - low)  # the last step is added
    side = np.sign(0.5 * (low + high) - places)
    for start in (0.05, 0.5, 0.95):
        at, left = low + start * (high - low), 20  # rounds; a place that fits needs two or three
        while True:
            slope = mass * (side * reach - 2.0 * (at - places))
            one = _fit_place(moments_at(at), slope, at, stretch)
            closer, left = min(max(at + one.step, low), high), left - 1
            if one.is_open or abs(closer - at) <= converged or not left:
                break
            at = closer
        yield one


def _fit_place(moments: Estimate, slope: Array, at: float, stretch: tuple[float, float]) -> _Place:
    """Return the step from a place, and the common moment, that fit moments with these slopes by least squares."""
    solve = partial(whiten, moments.covariance)
    ones, rise, value = solve(np.stack([np.ones(len(slope)), slope, moments.value], axis=1)).T
    weight = float(ones @ ones)
    mean, mean_rise = float(ones @ value) / weight, float(ones @ rise) / weight
    residual, turn = value - mean * ones, rise - mean_rise * ones
    known = float(turn @ turn)
    step = -float(turn @ residual) / known if known else 0.0
    spread = 1.0 / known if known else math.inf
    # where each place fits, this one represents all
    held = 0.0 if math.sqrt(spread) > stretch[1] - stretch[0] else min(max(step, stretch[0] - at), stretch[1] - at)
    joint = spread * np.array([[1.0, mean_rise], [mean_rise, mean_rise**2]]) if known else np.full((2, 2), math.inf)
    joint[1, 1] += 1.0 / weight
    return _Place(at, moments, step, mean + step * mean_rise, joint, float(np.sum((residual + held * turn) ** 2)),
                  (mean + held * mean_rise, 1.0 / math.sqrt(weight)), stretch)


def _unite(places: list[_Place], whole: float) -> list[_Place]:
    """Merge places that are one within their errors into the best; across a pivot their distance adds to its error.

    By its error, a centre of mass at the pivot of a jig may lie on either side of it.
    """
    united: list[_Place] = []
    rounding = LIMITS.place_tolerance * whole
    for one in sorted(places, key=lambda one: one.misfit):
        twin = next((k for k, other in enumerate(united) if _are_one(one, other, rounding)), None)
        if twin is None:
            united.append(one)
        elif one.stretch != united[twin].stretch:
            united[twin] = _join(united[twin], one)
    return united


def _are_one(one: _Place, other: _Place, rounding: float) -> bool:
    gap = abs(one.at - other.at)
    if one.stretch == other.stretch:
        return gap <= max(rounding, one.error, other.error)
    if not (one.is_open or other.is_open):
        return gap <= max(rounding, MAX_ERRORS * math.hypot(one.error, other.error))
    (low, high), (other_low, other_high) = (x.stretch if x.is_open else (x.at, x.at) for x in (one, other))
    return low <= other_high + rounding and other_low <= high + rounding


def _join(one: _Place, other: _Place) -> _Place:
    """Return a place that may also be another beyond a pivot."""
    if one.is_open or other.is_open:
        ends = [end for x in (one, other) for end in (x.stretch if x.is_open else (x.at, x.at))]
        return one._replace(stretch=(min(ends), max(ends)), covariance=np.full((2, 2), math.inf))
    apart = np.array([one.at + one.step - other.at - other.step, one.moment - other.moment])
    return one._replace(covariance=one.covariance + np.outer(apart, apart))


def _check_unique(places: list[_Place], tried: list[_Place], freedom: int) -> None:
    """Refuse unless the periods determine one place, with a positive moment."""
    if not places:
        best = min(tried, key=lambda one: one.misfit)
        raise InvalidInput(
            f"the periods fit no place of the centre of mass on the pivots' scale: even {best} the moments of the "
            f"swings differ, with a χ² of {best.misfit:.3g} where about {freedom} is expected. Check the timings, the "
            "count of oscillations in each, their errors and the pivots."
        )
    if len(places) > 1 or places[0].is_open:
        *most, last = map(str, sorted(places, key=lambda one: one.at))
        said, open_to = (f"{', '.join(most)} or {last}", "which") if most else (last, "where")
        raise InvalidInput(
            f"the periods fit a centre of mass {said} on the pivots' scale, and do not determine {open_to}. Give "
            "the distance of each pivot from the centre, or a further pivot."
        )
    one = places[0]
    if not one.moment > 0.0:
        raise InvalidInput(
            f"the swings give a moment of {one.moment:.4g} kg m² about a centre of mass at {_digits(one.at)} m, with "
            f"an error of {math.sqrt(one.covariance[1, 1]):.2g}, and no body has one that is not positive. "
            "Check periods, pivots, masses and jig."
        )


def _digits(place: float) -> str:
    """Return a place in words, to a nanometre, so that zero with a rounding error is zero."""
    return f"{round(place, 9) + 0.0:.4g}"


def _too_far_apart(places: Array, far: Array) -> str:
    k, n = int(np.argmin(places + far)), int(np.argmax(places - far))
    if k == n:
        return (f"the pivot at {places[k]:.4g} m gives no positive moment for any place of the centre of mass. Check "
                "the timings, the count of oscillations in each, masses and jig.")
    return (
        f"the pivots at {places[k]:.4g} and {places[n]:.4g} m are {places[n] - places[k]:.4g} m apart, but by their "
        f"periods a centre of mass is within {far[k]:.4g} m of the one and within {far[n]:.4g} m of the other. Check "
        "the timings, the count of oscillations in each, and the pivots."
    )
