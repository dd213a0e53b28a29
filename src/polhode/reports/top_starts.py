"""How tops start: one, or many that differ by weight, lean and spin."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis.top_motion import axis_tilt
from polhode.analysis.top_start import LIMITS as START_LIMITS
from polhode.analysis.top_start import euler_velocity, lean_sine, steady_precession_at, top_velocity
from polhode.bodies._pivot import axis_of_symmetry
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top.steady_precession import precession_roots
from polhode.spec.building import build_spin, compute_momentum
from polhode.spec.models import SpinTable
from polhode.systems.heavy_top import HeavyTop, lean_from_upright
from polhode.types import Array, ArrayLike, Bool, Float64, Real


class TopLimits(NamedTuple):
    """A number beyond which the spin of a top is refused."""

    max_energy: float = 1e200  # J


LIMITS = TopLimits()


def build_top(body: Body, pivot: Real[ArrayLike, "3"], gravity: float) -> HeavyTop:
    """Return the top of a spec; its body may be free, which the report says.

    Raises:
        InvalidInput: for a body without mass.
    """
    if body.mass is None:
        raise InvalidInput("`body.mass` is needed for the weight of a top; give it together with moments or inertia.")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return HeavyTop.from_body(body, pivot, gravity)


def build_start(
    top: HeavyTop, spin: SpinTable | None, momentum: Float64[Array, "3"], attitude: Float64[Array, "4"],
    lean: float | None,
) -> tuple[Float64[Array, "3"], Float64[Array, "4"]]:
    """Return momentum (3,) along, and attitude (4,) of, the principal axes at the start.

    Args:
        top: the top.
        spin: as the spec has it.
        momentum: (3,) as given, unless the spec gives spin, precession and nutation.
        attitude: (4,) as given, unless the spec gives a tilt.
        lean: of the axis from the upward vertical [rad], or None.

    Raises:
        InvalidInput: for a body without an axis that leans, or a spin without the steady precession that is asked for.
    """
    if lean is not None:
        if float(top.mgl) == 0.0:
            raise InvalidInput("`system.lean` needs a centre of mass apart from the fixed point; leave it out.")
        attitude = top.leaning(lean)
    if spin is not None and spin.is_of_a_top:
        if float(top.mgl) == 0.0:
            raise InvalidInput("`spin.spin`, `spin.precession` and `spin.nutation_rate` need a centre of mass apart "
                               "from the fixed point; give `spin.angular_velocity`.")
        turn, precession = spin.spin or 0.0, spin.precession or 0.0
        if isinstance(precession, str):
            tilt = float(axis_tilt(top, attitude)) if lean is None else lean
            steady = steady_precession_at(top, tilt, turn)
            wanted = steady.slow if precession == "slow" else steady.fast
            if wanted is None:
                raise InvalidInput("there is one steady precession alone at this tilt; write `spin.precession = "
                                   '"slow"`.')
            precession = wanted
        velocity = top_velocity(top, attitude, turn, precession, spin.nutation_rate or 0.0)
        momentum = compute_momentum(np.asarray(top.moments), velocity)
    if not _bearable(np.asarray(top.moments), momentum):
        raise InvalidInput(f"the spin must give an energy below {LIMITS.max_energy:g} J; its momentum is "
                           f"{momentum.tolist()} kg m²/s. Check the rate and its unit.")
    return momentum, attitude


class TopStarts(NamedTuple):
    """Starts of many tops that differ by weight, lean and spin.

    Attributes:
        mgl: (sample,) weight times distance [N m].
        momentum: (sample, 3) along their principal axes.
        attitude: (sample, 4) of these.
        doubtful: (sample,) whether a start may be refused, and means nothing.
    """

    mgl: Float64[Array, "sample"]
    momentum: Float64[Array, "sample 3"]
    attitude: Float64[Array, "sample 4"]
    doubtful: Bool[Array, "sample"]


def build_starts(
    top: HeavyTop, mgl: Float64[Array, "sample"], spin: SpinTable | None, lean: float | Float64[Array, "sample"] | None
) -> TopStarts:
    """Return the starts that ``build_start`` gives each sample, to the last bit.

    Args:
        top: with moments and axes of all, apart from its fixed point.
        mgl: of each.
        spin: with arrays (sample, …) in place of numbers that vary.
        lean: of the axis from the upward vertical [rad], or None.
    """
    count, moments, axis = len(mgl), np.asarray(top.moments), np.asarray(top.axis)
    each = lambda value: np.array(np.broadcast_to(0.0 if value is None else value, count), dtype=float)  # noqa: E731
    momentum, attitude = build_spin(spin, moments, np.asarray(top.axes))
    doubtful = ~(np.isfinite(mgl) & (mgl > 0.0))
    if lean is not None:
        lean = each(lean)
        doubtful |= ~((lean >= 0.0) & (lean <= np.pi))
        attitude = lean_from_upright(np.asarray(top.axes), axis, np.where(doubtful, 0.0, lean))
    attitude = np.array(np.broadcast_to(attitude, (count, 4)))
    if spin is not None and spin.rate is not None:
        doubtful |= each(spin.rate) == 0.0  # a tilt may go without direction
    if spin is not None and spin.is_of_a_top:
        turn, nutation = each(spin.spin) + 0.0, each(spin.nutation_rate) + 0.0
        if isinstance(spin.precession, str):
            tilt = axis_tilt(top, attitude) if lean is None else lean
            precession = _steady_rates(moments, axis, spin.precession, mgl, tilt, turn)
            doubtful |= np.isnan(precession)
        else:
            precession = each(spin.precession) + 0.0
        unit = rotation.normalize(attitude)
        doubtful |= (nutation != 0.0) & (lean_sine(rotation.rotate(unit, axis)) <= START_LIMITS.min_tilt)
        momentum = compute_momentum(moments, euler_velocity(axis, unit, turn, precession, nutation))
    momentum = np.array(np.broadcast_to(momentum, (count, 3)))
    doubtful |= ~_bearable(moments, momentum)
    return TopStarts(mgl, momentum, attitude, doubtful)


def _steady_rates(moments: Array, axis: Array, which: str, mgl: Array, tilt: Array, spin_rate: Array) -> Array:
    """Return the rates φ̇ (sample,) of ``steady_precession_at``; NaN where it has none."""
    rates, k = np.full(len(mgl), np.nan), axis_of_symmetry(moments, axis)
    if k is None:
        return rates
    across, along = float(moments[(k + 1) % 3]), float(moments[k])
    leans = (tilt > START_LIMITS.min_tilt) & (tilt < np.pi - START_LIMITS.min_tilt)
    for i in np.flatnonzero(leans & np.isfinite(spin_rate)):
        steady = precession_roots(across - along, along, float(mgl[i]), float(tilt[i]), float(spin_rate[i]))
        rate = None if steady is None else steady.slow if which == "slow" else steady.fast
        rates[i] = np.nan if rate is None else rate
    return rates


def _bearable(moments: Float64[Array, "3"], momentum: Float64[Array, "*batch 3"]) -> Bool[Array, "*batch"]:
    """Whether squares of momenta (…, 3) of a top stay in the range of numbers."""
    with np.errstate(over="ignore"):
        return np.sum((momentum / np.sqrt(moments)) ** 2, axis=-1) < LIMITS.max_energy
