"""Moments of inertia from the periods of a body on filaments or on a pivot, with their errors.

A body on two or three filaments (bifilar, trifilar) twists about the vertical and rises as it does; a body on a pivot
swings as a compound pendulum. Both periods are exact quadratures at any amplitude. Errors of all measured quantities
are propagated together, so that a rig's length, shared by all swings, correlates their moments.

Source: Kane & Tseng, Int. J. Mech. Sci. 9 (1967) 83, for the bifilar pendulum; Jardin & Mueller, J. Aircraft 46 (2009)
763, for its use on vehicles; JCGM 100:2008 (GUM), annex G.4, for effective degrees of freedom.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.errors import InvalidInput, shown
from polhode.estimation._estimate import Estimate
from polhode.measuring.pendulum._swing_center import find_center
from polhode.measuring.pendulum._swing_moments import combine_moments, fit_tensor, propagate, unit_vector
from polhode.measuring.pendulum.periods import filament_moment, quarter_period
from polhode.special._residual_noise import NoiseTest, test_known_errors
from polhode.types import Array, Float64

SILENT = NoiseTest(1.0, 0.0)  # of a fit that is not tested yet


class Measured(NamedTuple):
    """A measured quantity. Swings that share one object share its error.

    Attributes:
        value: in SI units.
        error: its standard deviation.
        freedom: degrees of freedom of a scatter that the error was estimated from; None where it is known.
    """

    value: float
    error: float = 0.0
    freedom: float | None = None


STANDARD = Measured(STANDARD_GRAVITY)  # by definition without error


class Filaments(NamedTuple):
    """A rig of equal filaments on two circles, one above the other.

    Attributes:
        length: of a filament between its attachments [m].
        upper, lower: radii of the circles of attachments [m]; of two filaments, half of their distance.
        offset: horizontal distance of the body's centre of mass from the lower circle's centre [m].
    """

    length: Measured
    upper: Measured
    lower: Measured
    offset: Measured = Measured(0.0)


class Pivot(NamedTuple):
    """A horizontal pivot.

    Attributes:
        distance: from the pivot to the body's centre of mass [m]; None where it is to be fitted.
        place: of the pivot on a scale along a line through the centre of mass [m], where the distance is None.
    """

    distance: Measured | None
    place: float = 0.0


class Jig(NamedTuple):
    """The holder of the body, which swings with it.

    Attributes:
        mass: [kg].
        moment: about the vertical on filaments, about the pivot on a pivot [kg m²]; None where its period gives it.
        period: of the jig alone in the same rig [s]; None where its moment is known.
        amplitude: of that swing at the start [rad].
        distance: from the pivot to the jig's centre of mass [m]; of no use on filaments, where it hangs centred.
        last_amplitude: of the jig's swing at the end [rad]; None without a decay.
        turns: oscillations between the two.
    """

    mass: Measured
    moment: Measured | None = None
    period: Measured | None = None
    amplitude: float = 0.0
    distance: Measured = Measured(0.0)
    last_amplitude: float | None = None
    turns: float = 1.0


class Swing(NamedTuple):
    """A measured period of oscillation.

    Attributes:
        axis: (3,) of the twist or swing in the body's given axes, of any length, through the centre of mass.
        rig: that holds the body.
        period: mean of one oscillation [s].
        amplitude: largest angle from rest at the start [rad].
        last_amplitude: largest angle at the end [rad]; None without a decay.
        turns: oscillations between the two.
        jig: the holder of the body; None without.
    """

    axis: tuple[float, float, float]
    rig: Filaments | Pivot
    period: Measured
    amplitude: float = 0.0
    last_amplitude: float | None = None
    turns: float = 1.0
    jig: Jig | None = None


class PendulumFit(NamedTuple):
    """A body's inertia about its centre of mass, from periods.

    Attributes:
        moments: of each swing [kg m²], in their order.
        axes: (k, 3) different axes of the swings, of length one.
        combined: the moment about each of these [kg m²].
        inertia: Jxx, Jyy, Jzz, Jxy, Jxz, Jyz of the tensor in the given axes [kg m²]; None with too few axes.
        principal: I1, I2, I3 in ascending order [kg m²], with errors of first order; None without a tensor.
        principal_axes: (3, 3) by columns; None without a tensor.
        misfit: χ² of the swings against one body, weighted by all their errors.
        freedom: of the misfit; zero where nothing is left to check.
        test: whether errors alone explain the misfit; where they do not, moments of a body have no errors (NaN).
        unphysical: kg m² by which the largest principal moment exceeds the sum of the others; zero for a possible body.
        center: place of the centre of mass on the pivots' scale [m]; None where distances were given.
    """

    moments: Estimate
    axes: Float64[Array, "k 3"]
    combined: Estimate
    inertia: Estimate | None
    principal: Estimate | None
    principal_axes: Float64[Array, "3 3"] | None
    misfit: float
    freedom: int
    test: NoiseTest
    unphysical: float
    center: Estimate | None


def fit_pendulum(
    swings: Sequence[Swing], mass: Measured, gravity: Measured = STANDARD
) -> PendulumFit:
    """Estimate a body's inertia about its centre of mass from the periods of its swings as a pendulum.

    Swings about the same axis are combined; six or more axes that are independent give the tensor, by least squares
    weighted with the covariance of all moments. Pivots whose distances from the centre of mass are unknown are given by
    their places on a scale, at least two about the same axis: then the place of the centre is fitted too. With two, up
    to three places explain the periods, which is refused; three pivots determine it.

    Args:
        swings: at least one.
        mass: of the body alone [kg].
        gravity: [m/s²].

    Raises:
        InvalidInput: for values out of range, periods without any error, swings that no body makes, and pivots that
            leave the place of the centre of mass open.

    >>> rig = Filaments(Measured(1.0, 1e-3), Measured(0.2, 2e-4), Measured(0.2, 2e-4))
    >>> fit = fit_pendulum([Swing((0, 0, 1), rig, Measured(1.00321, 1e-3))], Measured(1.0, 1e-3))
    >>> print(fit.combined.value.round(6), fit.combined.standard_error.round(6))
    [0.01] [2.8e-05]
    """
    if not swings:
        raise InvalidInput("`swings` is empty. Give at least one measured period.")
    for swing in swings:
        _check_swing(swing)
    searched = [swing for swing in swings if isinstance(swing.rig, Pivot) and swing.rig.distance is None]
    if searched:
        if len(searched) != len(swings):
            raise InvalidInput("some pivots have a distance and others only a place. Give all swings the one or the "
                               "other.")
        axes = np.stack([unit_vector(swing.axis) for swing in swings])
        places = np.array([swing.rig.place for swing in searched if isinstance(swing.rig, Pivot)])
        reach = [gravity.value * _squared_per_quarter(swing, swing.period.value) for swing in swings]
        moments_at = lambda s: propagate(swings, mass, gravity, lambda *x: _moment(*x, center=s))  # noqa: E731
        center, moments, combined, misfit = find_center(moments_at, mass.value, axes, places, np.array(reach))
        left = len(swings) - 2
        fit = PendulumFit(moments, axes[:1], combined, None, None, None, misfit, left, SILENT, 0.0, center)
        return _test_swings(fit)
    moments = propagate(swings, mass, gravity, _moment)
    if (low := np.flatnonzero(moments.value <= 0.0)).size:
        k = int(low[0])
        raise InvalidInput(
            f"swing {k + 1} gives a moment of {moments.value[k]:.4g} kg m², and no body has one that is not positive. "
            "Check its period, lengths, masses and jig."
        )
    axes = np.stack([unit_vector(swing.axis) for swing in swings])
    different, combined, misfit, freedom = combine_moments(moments, axes)
    tensor = fit_tensor(different, combined)
    if tensor is None:
        fit = PendulumFit(moments, different, combined, None, None, None, misfit, freedom, SILENT, 0.0, None)
        return _test_swings(fit)
    inertia, principal, principal_axes, more, spare = tensor
    excess = float(max(principal.value[2] - principal.value[0] - principal.value[1], -principal.value[0], 0.0))
    return _test_swings(PendulumFit(moments, different, combined, inertia, principal, principal_axes, misfit + more,
                                    freedom + spare, SILENT, excess, None))


def _test_swings(fit: PendulumFit) -> PendulumFit:
    """Return the fit with its test, without errors of the body where errors of the swings do not explain the misfit."""
    test = test_known_errors(fit.misfit, fit.freedom, fit.moments.degrees_of_freedom)
    if test.is_noise:
        return fit._replace(test=test)
    bare = [None if one is None else one.without_errors() for one in (fit.inertia, fit.principal, fit.center)]
    inertia, principal, center = bare
    return fit._replace(combined=fit.combined.without_errors(), inertia=inertia, principal=principal, center=center,
                        test=test)


def _moment(swing: Swing, mass: float, gravity: float, value: dict[int, float], center: float | None = None) -> float:
    """Return the moment of a swing about the body's centre of mass, of values of its measured quantities by identity.

    With an offset e of the common centre of mass from the circle's, k = Mg(R² − e²)/h replaces MgRr/h at small angles:
    Σ T_i |r_i|²/h, with tensions T_i whose moments about the centre of mass cancel, at any number of filaments.
    """

    def get(measured: Measured) -> float:
        return value.get(id(measured), measured.value)

    jig = swing.jig
    jig_mass = 0.0 if jig is None else get(jig.mass)
    if isinstance(swing.rig, Pivot):
        far = swing.rig.distance
        distance = abs((center or 0.0) - swing.rig.place) if far is None else get(far)
        leverage = mass * distance + (0.0 if jig is None else jig_mass * get(jig.distance))
        whole = gravity * leverage * _squared_per_quarter(swing, get(swing.period))
        if jig is not None and jig.period is not None:
            alone = gravity * jig_mass * get(jig.distance) * _squared_per_quarter(jig, get(jig.period))
        else:
            alone = 0.0 if jig is None or jig.moment is None else get(jig.moment)
        return whole - alone - mass * distance**2
    rig, whole_mass = swing.rig, mass + jig_mass
    sizes = get(rig.length), get(rig.upper), get(rig.lower)
    whole = _on_filaments(swing, get(swing.period), whole_mass, sizes, gravity)
    alone = 0.0 if jig is None or jig.moment is None else get(jig.moment)
    if jig is not None and jig.period is not None:
        alone = _on_filaments(jig, get(jig.period), jig_mass, sizes, gravity)
    offset = get(rig.offset)
    common = mass * offset / whole_mass  # of the common centre of mass
    whole *= 1.0 - common**2 / (sizes[1] * sizes[2])
    return whole - alone - mass * jig_mass / whole_mass * offset**2


def _amplitudes(swing: Swing | Jig) -> tuple[Array, Array]:
    """Return amplitudes and weights (n,) of the mean over a decay, which falls by an equal factor in each period."""
    if swing.last_amplitude is None or not swing.amplitude:
        return np.array([swing.amplitude]), np.array([1.0])
    nodes, weights = np.polynomial.legendre.leggauss(8)
    part = 0.5 * (nodes + 1.0)
    return swing.amplitude ** (1.0 - part) * swing.last_amplitude**part, 0.5 * weights


def _squared_per_quarter(swing: Swing | Jig, period: float) -> float:
    """Return (T/4K)² of an undamped period, which is a moment over the weight times its lever."""
    angles, weights = _amplitudes(swing)
    quarter = float(sum(w * quarter_period(float(angle)) for angle, w in zip(angles, weights, strict=True)))
    return (_undamped_period(swing, period) / (4.0 * quarter)) ** 2


def _on_filaments(
    swing: Swing | Jig, period: float, mass: float, sizes: tuple[float, float, float], gravity: float
) -> float:
    """Return the moment of all that swings on filaments, the mean over the decay."""
    undamped, (angles, weights) = _undamped_period(swing, period), _amplitudes(swing)
    length, upper, lower = sizes
    return float(sum(w * filament_moment(undamped, mass, length, upper, lower, float(angle), gravity)
                     for angle, w in zip(angles, weights, strict=True)))


def _undamped_period(swing: Swing | Jig, period: float) -> float:
    """Return the period without linear drag, T/√(1 + (Λ/2π)²), Λ the logarithmic decrement of a period."""
    if swing.last_amplitude is None:
        return period
    decrement = math.log(swing.amplitude / swing.last_amplitude) / swing.turns
    return period / math.hypot(1.0, decrement / (2.0 * math.pi))


def _check_swing(swing: Swing) -> None:
    unit_vector(swing.axis)
    measured = {"period": swing.period}
    if isinstance(swing.rig, Filaments):
        measured |= {"length": swing.rig.length, "upper": swing.rig.upper, "lower": swing.rig.lower}
        offset = swing.rig.offset.value
        if not 0.0 <= offset < min(swing.rig.upper.value, swing.rig.lower.value):
            raise InvalidInput(f"the offset of the centre of mass must lie within the filaments; got {offset:.6g} m.")
        if offset and swing.rig.upper.value != swing.rig.lower.value:
            raise InvalidInput("an offset of the centre of mass needs vertical filaments, with upper and lower circle "
                               "alike.")
    elif swing.rig.distance is not None:
        measured["distance"] = swing.rig.distance
    if swing.jig is not None:
        measured["mass of the jig"] = swing.jig.mass
        if (swing.jig.moment is None) == (swing.jig.period is None):
            raise InvalidInput("a jig needs its moment or the period of its own swing, one of the two.")
        if isinstance(swing.rig, Pivot) and not swing.jig.distance.value > 0.0:
            raise InvalidInput("a jig on a pivot needs the distance from the pivot to its own centre of mass.")
    for name, one in measured.items():
        if not (0.0 < one.value < math.inf and 0.0 <= one.error < math.inf):
            raise InvalidInput(f"the {name} must be positive, with an error that is not negative; got {shown(one)}.")
    if not swing.period.error > 0.0:
        raise InvalidInput(
            "a period needs an error, which gives that of the moment. Give one, like 2.31 ± 0.01 s, or several "
            "timings."
        )
    for of, one in (("", swing), (" of the jig", swing.jig)):
        last = None if one is None else one.last_amplitude
        if one is not None and last is not None and not 0.0 < last <= one.amplitude:
            raise InvalidInput(f"the last amplitude{of} must be positive and at most the first; got {shown(last)} rad.")
