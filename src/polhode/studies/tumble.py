"""``polhode.tumble``: how a body tumbles, from its two periods and the ratios of its moments."""

from __future__ import annotations

import csv
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from polhode.analysis.light_curves import light_curve, light_curve_lines
from polhode.analysis.tumblers import equivalent_ellipsoid, internal_damping_time
from polhode.errors import InvalidInput, shown
from polhode.estimation.tumbling import MODES, Mode, Tumbling, fit_tumbling, least_period_ratios
from polhode.formats.known_tumblers import KnownTumbler, known_tumbler
from polhode.formats.paths import written_whole
from polhode.reports.report import Report
from polhode.reports.tumble import Damping, LightCurve, Tumbler, tumble_groups, tumble_notes, tumble_summary
from polhode.spec.reach import check_reach
from polhode.spec.uncertain import Uncertain, uncertain

TURNS, SAMPLES = 12.0, 2400  # of the precession, that a light curve shows
Axis = Literal["encircled", "long", "short"]
AXES: tuple[Axis, ...] = ("encircled", "long", "short")


def in_python(name: str) -> str:
    """Return how an argument is called in Python."""
    return f"`{name}`"


class Friction(NamedTuple):
    """What the time of damping by internal friction is made of.

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
) -> Report:  # fmt: skip
    """Return a report on how a body tumbles: its energy, its tilt against L, periods, light curve and damping.

    Quantities are in SI, with their standard deviations where these are known, (value, error), or texts like
    "27.38 ± 0.07 h".

    Args:
        body: one whose periods and moments are known, like "apophis"; what is given beside it takes their place.
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
        InvalidInput: for what is missing, cannot be read, or has no motion.

    Source: Pravec et al., Icarus 173 (2005) 108; Kaasalainen, Astron. Astrophys. 376 (2001) 302.

    >>> import polhode as ph
    >>> found = ph.tumble(precession="27.38 h", rotation="263 h", moments=(0.61, 0.965, 1.0))
    >>> found.summary[:22]
    'Short-axis mode (SAM):'
    """
    if mode not in (None, *MODES):
        raise InvalidInput(f"`mode` must be {' or '.join(MODES)}; got {shown(mode)}.")
    for name, angle, most in (("aspect", aspect, 180.0), ("phase", phase, 170.0)):
        if not 0.0 <= angle <= np.radians(most) * (1 + 1e-15):
            raise InvalidInput(f"`{name}` must be between 0 and {most:g}° in radians; got {shown(angle)}.")
    known = None if body is None else known_tumbler(str(body))
    given = Given(precession, rotation, moments, semi_axes, axis, mode, friction, aspect, phase)
    return report_on(tumbler_of(known, given, in_python))


class Given(NamedTuple):
    """What is known of a body; see ``tumble``."""

    precession: Uncertain | None = None
    rotation: Uncertain | None = None
    moments: Sequence[Uncertain] | None = None
    semi_axes: Sequence[float] | None = None
    axis: Axis = "encircled"
    mode: Mode | None = None
    friction: Friction | None = None
    aspect: float = np.pi / 3
    phase: float = np.pi / 9


def tumbler_of(known: KnownTumbler | None, given: Given, called: Callable[[str], str]) -> Tumbler:
    """Return the motion, with all that is said of it.

    Args:
        known: a body, if it is one of those that are known.
        given: what takes the place of what is known.
        called: returns how an argument is called where it is given, for messages.

    Raises:
        InvalidInput: as ``tumble`` does.
    """
    periods, moments, errors = _measured(known, given, called)
    motions = fit_tumbling(*periods, moments, given.axis, errors if any(errors) else None)
    mode: Mode = given.mode or (motions[0].mode if known is None else known.mode)  # type: ignore[assignment]
    chosen = [motion for motion in motions if motion.mode == mode]
    if not chosen:
        there, limit = motions[0].mode, least_period_ratios(moments)[MODES.index(mode)]
        raise InvalidInput(f"no motion in the {mode} mode has these periods: with these moments the rotation must take "
                           f"more than {limit:.4g} times as long as the precession. There is one in the {there} mode: "
                           f"{called('mode')} {there}.")  # fmt: skip
    motion, friction = chosen[0], given.friction
    damping = None if friction is None else Damping(internal_damping_time(motion.precession, *friction), *friction)
    return Tumbler(
        "tumbler" if known is None else known.name, "" if known is None else known.source, motion,
        tuple(other for other in motions if other is not motion), least_period_ratios(moments),
        _light(motion, given.aspect, given.phase), damping,
    )  # fmt: skip


def _measured(
    known: KnownTumbler | None, given: Given, called: Callable[[str], str]
) -> tuple[tuple[float, float], list[float], list[float]]:
    """Return both periods [s], the moments by size, and the errors of all five."""
    if given.moments is not None and given.semi_axes is not None:
        raise InvalidInput(f"{called('moments')} and {called('semi_axes')} both tell the moments. Leave one out.")
    texts = {"precession": given.precession or (known and known.precession),
             "rotation": given.rotation or (known and known.rotation)}  # fmt: skip
    moments = given.moments
    if moments is None and given.semi_axes is None and known is not None:
        moments = known.moments
    missing = [called(name) for name, text in texts.items() if text is None]
    missing += [called("moments")] if moments is None and given.semi_axes is None else []
    if missing:
        whose = "" if known is None else f" of {known.name}"
        raise InvalidInput(f"{' and '.join(missing)} {'are' if len(missing) > 1 else 'is'} missing{whose}. Give for "
                           f'example {called("precession")} "27.38 h", {called("rotation")} "263 h" and '
                           f"{called('moments')} 0.61 0.965 1, or name a known body.")  # fmt: skip
    (first, d_first), (second, d_second) = (
        uncertain(called(name), text, "s") for name, text in texts.items() if text is not None
    )
    if moments is not None:
        pairs = sorted(uncertain(called("moments"), x, "kg*m^2", bare=True) for x in moments)
        return (first, second), [x for x, _ in pairs], [d_first, d_second, *(error for _, error in pairs)]
    semi_axes = np.asarray(given.semi_axes, float)
    check_reach(called("semi_axes"), *semi_axes.tolist())
    squares = np.sort(np.square(semi_axes))[::-1]
    if not (np.isfinite(squares).all() and squares[2] > 0):
        raise InvalidInput(f"{called('semi_axes')} must be three positive numbers; got {shown(given.semi_axes)}.")
    return (first, second), (squares.sum() - squares).tolist(), [d_first, d_second, 0.0, 0.0, 0.0]


def report_on(found: Tumbler) -> Report:
    """Return the report on what was found."""

    def draw() -> dict[str, Any]:
        from polhode.figures.tumble_figure import tumble_figures

        return tumble_figures(found)

    return Report(found.name, "tumble", tumble_summary(found), tumble_groups(found), tumble_notes(found), draw,
                  partial(write, found))  # fmt: skip


def write(found: Tumbler, path: Path) -> Path:
    """Write the light curve as .csv, or a spec of the motion as .toml.

    Raises:
        InvalidInput: for another ending, and for the light curve of a flat body.
    """
    ending = path.suffix.lower()
    if ending not in (".csv", ".toml"):
        raise InvalidInput(f"{path}: must end in .csv (light curve) or .toml (spec); got {shown(path.suffix)}.")
    if ending == ".toml":
        with written_whole(path) as draft:
            draft.write_text(_spec(found), "utf-8")
        return path
    if found.light is None:
        raise InvalidInput(f"{path}: a flat body, I1 + I2 = I3, has no light curve here. Give moments of a solid body.")
    with written_whole(path) as draft, draft.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time [s]", "magnitude [mag]"])
        writer.writerows(zip(found.light.times.tolist(), found.light.magnitudes.tolist(), strict=True))
    return path


def _light(motion: Tumbling, aspect: float, phase: float) -> LightCurve | None:
    if motion.moments[0] + motion.moments[1] <= 1 + 1e-12:
        return None
    axes = equivalent_ellipsoid(motion.moments)
    # L is along z in space
    observer = np.array([np.sin(aspect), 0.0, np.cos(aspect)])
    sun = np.cos(phase) * observer + np.sin(phase) * np.array([0.0, 1.0, 0.0])
    lines = light_curve_lines(motion.motion, axes, sun, observer)
    times = np.linspace(0.0, TURNS * motion.precession, SAMPLES + 1)
    return LightCurve(axes, aspect, phase, lines, times, light_curve(motion.motion, times, axes, sun, observer))


def _spec(found: Tumbler) -> str:
    motion = found.motion
    spin = np.asarray(motion.motion.angular_velocity(0.0)).tolist()
    moments = ", ".join(f'"{x:.17g} kg*m^2"' for x in motion.moments.tolist())
    rates = ", ".join(f'"{x:.17g} rad/s"' for x in spin)
    return (
        f"# {found.name}: {motion.mode} mode, P_phi = {motion.precession:.10g} s, P_psi = {motion.rotation:.10g} s.\n"
        f"# Periods leave the scale of the moments open; the largest is 1 kg m^2 here.\n"
        f'name = "{found.name}"\n\n[body]\nmoments = [{moments}]\n\n'
        f'[spin]\nangular_velocity = [{rates}]\nframe = "principal"\n\n[time]\nuntil = "{5 * motion.rotation:.10g} s"\n'
    )
