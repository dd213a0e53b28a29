"""``polhode.tumble``: how a body tumbles, from its two periods and the ratios of its moments."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from polhode._base import check
from polhode.celestial.tumbling.damping import equivalent_ellipsoid, internal_damping_time
from polhode.celestial.tumbling.estimation import MODES, Mode, Tumbling, fit_tumbling, least_period_ratios
from polhode.celestial.tumbling.known_tumblers import KnownTumbler, known_tumbler
from polhode.celestial.tumbling.light_curves import light_curve, light_curve_lines
from polhode.celestial.tumbling.report import TumbleReport
from polhode.celestial.tumbling.tumbler import Damping, LightCurve
from polhode.errors import InvalidInput, shown
from polhode.spec.reach import check_reach
from polhode.spec.uncertain import Uncertain, uncertain

Axis = Literal["encircled", "long", "short"]
AXES: tuple[Axis, ...] = ("encircled", "long", "short")


class Friction(NamedTuple):
    """Constants from which the time of damping by internal friction follows.

    Attributes:
        diameter: mean [m].
        density: [kg/m³].
        rigidity: shear modulus times quality factor, μQ [Pa].
        shape_factor: K₃², .01 round to .1 long.
    """

    diameter: float
    density: float = 2000.0
    rigidity: float = 5e11
    shape_factor: float = 0.03


def tumble(
    body: str | None = None, *, precession: Uncertain | None = None, rotation: Uncertain | None = None,
    moments: Sequence[Uncertain] | None = None, semi_axes: Sequence[float] | None = None, axis: Axis = "encircled",
    mode: Mode | None = None, friction: Friction | None = None, aspect: float = np.pi / 3, phase: float = np.pi / 9,
) -> TumbleReport:
    """Return a report on how a body tumbles: its energy, its tilt against L, periods, light curve and damping.

    Quantities are in SI, with their standard deviations where these are known, (value, error), or texts like
    "27.38 ± 0.07 h".

    Args:
        body: one whose periods and moments are catalogued, like "apophis"; values given beside it take their place.
        precession: mean period of an axis about L [s], P_φ.
        rotation: period of the motion along the body's axes [s], P_ψ.
        moments: (3,) principal moments, in any unit; or
        semi_axes: (3,) of a uniform ellipsoid, in any unit.
        axis: whose precession: that of the encircled axis (the long one in the long-axis mode, the short one in the
            short-axis mode), of the long or of the short axis.
        mode: "short-axis" or "long-axis"; that of least energy if it is left out.
        friction: for the time of damping.
        aspect, phase: between L and the observer, and between Sun and observer across L [rad], of the light curve.

    Raises:
        InvalidInput: for data that are missing, cannot be read, or have no motion.

    Source: Pravec et al., Icarus 173 (2005) 108; Kaasalainen, Astron. Astrophys. 376 (2001) 302.

    >>> import polhode as ph
    >>> report = ph.tumble(precession="27.38 h", rotation="263 h", moments=(0.61, 0.965, 1.0))
    >>> report.summary[:22]
    'Short-axis mode (SAM):'
    """
    if mode is not None:
        check.one_of("mode", mode, MODES)
    for name, angle, most in (("aspect", aspect, 180.0), ("phase", phase, 170.0)):
        radians = float(np.radians(most))
        rule = f"from 0 to {radians:.4g}, {most:g}°,"
        check.number(name, angle, "rad", least=0, most=radians * (1 + 1e-15), rule=rule)
    lists = {"moments": moments, "semi_axes": semi_axes}
    for name, some in lists.items():
        if some is not None and (isinstance(some, str) or np.ndim(some) == 0 or len(some) != 3):
            raise InvalidInput(f"`{name}` must be three quantities; got {shown(some)}.")
    if friction is not None and not isinstance(friction, Friction):
        raise InvalidInput(f"`friction` must be a polhode.celestial.tumbling.study.Friction; got {shown(friction)}.")
    known = None if body is None else known_tumbler(str(body))
    inputs = Given(precession, rotation, moments, semi_axes, axis, mode, friction, aspect, phase)
    return tumble_report(known, inputs)


class Given(NamedTuple):
    """The data on a body; see ``tumble``."""

    precession: Uncertain | None = None
    rotation: Uncertain | None = None
    moments: Sequence[Uncertain] | None = None
    semi_axes: Sequence[float] | None = None
    axis: Axis = "encircled"
    mode: Mode | None = None
    friction: Friction | None = None
    aspect: float = np.pi / 3
    phase: float = np.pi / 9


def tumble_report(known: KnownTumbler | None, inputs: Given) -> TumbleReport:
    """Return the report on a body's motion.

    Args:
        known: the catalogued body, if it is one.
        inputs: data that replace those of the catalogue.

    Raises:
        InvalidInput: as ``tumble`` does.
    """
    periods, moments, errors = _gather_measured(known, inputs)
    motions = fit_tumbling(*periods, moments, inputs.axis, errors if any(errors) else None)
    mode: Mode = inputs.mode or (motions[0].mode if known is None else known.mode)  # type: ignore[assignment]
    chosen = [motion for motion in motions if motion.mode == mode]
    if not chosen:
        there, limit = motions[0].mode, least_period_ratios(moments)[MODES.index(mode)]
        raise InvalidInput(f"no motion in the {mode} mode has these periods: with these moments the rotation must take "
                           f"more than {limit:.4g} times as long as the precession. There is one in the {there} mode: "
                           f'`mode="{there}"`.')
    motion, friction = chosen[0], inputs.friction
    damping = None if friction is None else Damping(internal_damping_time(motion.precession, *friction), *friction)
    return TumbleReport(
        "tumbler" if known is None else known.name, "" if known is None else known.source, motion,
        tuple(other for other in motions if other is not motion), least_period_ratios(moments),
        _light(motion, inputs.aspect, inputs.phase), damping,
    )


def _gather_measured(known: KnownTumbler | None, inputs: Given) -> tuple[tuple[float, float], list[float], list[float]]:
    """Return both periods [s], the moments by size, and the errors of all five."""
    if inputs.moments is not None and inputs.semi_axes is not None:
        raise InvalidInput("`moments` and `semi_axes` both give the moments. Leave one out.")
    texts = {"precession": inputs.precession or (known and known.precession),
             "rotation": inputs.rotation or (known and known.rotation)}  # fmt: skip
    moments = inputs.moments
    if moments is None and inputs.semi_axes is None and known is not None:
        moments = known.moments
    missing = [f"`{name}`" for name, text in texts.items() if text is None]
    missing += ["`moments`"] if moments is None and inputs.semi_axes is None else []
    if missing:
        whose = "" if known is None else f" of {known.name}"
        raise InvalidInput(f"{' and '.join(missing)} {'are' if len(missing) > 1 else 'is'} missing{whose}. Give for "
                           'example `precession="27.38 h"`, `rotation="263 h"` and `moments=(0.61, 0.965, 1)`, '
                           "or name a known body.")
    (first, d_first), (second, d_second) = (
        uncertain(f"`{name}`", text, "s") for name, text in texts.items() if text is not None
    )
    if moments is not None:
        pairs = sorted(uncertain("`moments`", x, "kg*m^2", bare=True) for x in moments)
        return (first, second), [x for x, _ in pairs], [d_first, d_second, *(error for _, error in pairs)]
    semi_axes = np.asarray(inputs.semi_axes, float)
    check_reach("`semi_axes`", *semi_axes.tolist())
    squares = np.sort(np.square(semi_axes))[::-1]
    if not (np.isfinite(squares).all() and squares[2] > 0):
        raise InvalidInput(f"`semi_axes` must be three positive numbers; got {shown(inputs.semi_axes)}.")
    return (first, second), (squares.sum() - squares).tolist(), [d_first, d_second, 0.0, 0.0, 0.0]


def _light(motion: Tumbling, aspect: float, phase: float) -> LightCurve | None:
    turns = 12.0  # of the precession, that a light curve shows
    samples = 2400
    if motion.moments[0] + motion.moments[1] <= 1 + 1e-12:
        return None
    axes = equivalent_ellipsoid(motion.moments)
    # L is along z in space
    observer = np.array([np.sin(aspect), 0.0, np.cos(aspect)])
    sun = np.cos(phase) * observer + np.sin(phase) * np.array([0.0, 1.0, 0.0])
    lines = light_curve_lines(motion.motion, axes, sun, observer)
    times = np.linspace(0.0, turns * motion.precession, samples + 1)
    return LightCurve(axes, aspect, phase, lines, times, light_curve(motion.motion, times, axes, sun, observer))
