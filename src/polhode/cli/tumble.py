"""``polhode tumble``: how a body tumbles, from its two periods and the ratios of its moments."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.analysis.light_curves import light_curve, light_curve_lines
from polhode.analysis.tumblers import equivalent_ellipsoid, internal_damping_time
from polhode.cli.fit_scale import quantity
from polhode.cli.render import as_json, print_report
from polhode.cli.terminal import as_typed
from polhode.errors import InvalidInput, shown
from polhode.estimation.tumbling import MODES, Mode, Tumbling, fit_tumbling, least_period_ratios
from polhode.formats.known_tumblers import KnownTumbler, known_tumbler, known_tumblers
from polhode.formats.numerals import read_number
from polhode.formats.paths import written_whole
from polhode.reports.answer import units_of, values_of
from polhode.reports.base import plain
from polhode.reports.tumble import Damping, LightCurve, Tumbler, tumble_groups, tumble_notes, tumble_summary
from polhode.spec.reach import check_reach

_ERROR = re.compile(r"\s*(?:±|\+/-|\+-)\s*")
_TRAILING_UNIT = re.compile(r"[a-zA-Zµμ][^±]*$")
TURNS, SAMPLES = 12.0, 2400  # of the precession, that a light curve shows
AXES = ("encircled", "long", "short")


class TumbleOptions(NamedTuple):
    """The options, as they are given; None where they are not."""

    precession: str | None = None
    rotation: str | None = None
    moments: tuple[str, str, str] | None = None
    semi_axes: tuple[float, float, float] | None = None
    axis: str | None = None
    mode: str | None = None
    diameter: str | None = None
    density: str | None = None
    rigidity: str | None = None
    shape_factor: float | None = None
    aspect: str | None = None
    phase: str | None = None
    figures: Path | None = None
    out: Path | None = None


class _Given(NamedTuple):
    """Periods [s] and moments with their standard deviations."""

    precession: tuple[float, float]
    rotation: tuple[float, float]
    moments: tuple[list[float], list[float]]


def run_list(json: bool) -> None:
    """Print the known tumblers."""
    rows = [known._asdict() for known in known_tumblers().values()]
    if json:
        print(as_json({"tumblers": rows}))
        return
    for known in known_tumblers().values():
        moments = "moments unknown" if known.moments is None else " : ".join(known.moments)
        print(f"{known.key:<14}{known.name}: P_φ {known.precession}, P_ψ {known.rotation}, {moments}, {known.mode}\n"
              f"{'':<14}{known.source}")  # fmt: skip
    print(f"\nNext: {as_typed('tumble', 'apophis')}")


def run_tumble(body: str | None, options: TumbleOptions, json: bool) -> None:
    """Solve for the motion, print what it is like, and write and draw what is asked for."""
    if options.out is not None and options.out.suffix.lower() not in (".csv", ".toml"):
        raise InvalidInput(f"--out must end in .csv (light curve) or .toml (spec); got {shown(str(options.out))}.")
    found = tumbler_of(body, options)
    files = _written(found, options)
    groups, notes = tumble_groups(found), tumble_notes(found)
    if json:
        told = {"name": found.name, **values_of(groups), "units": units_of(groups), "notes": notes, "files": files}
        print(as_json(plain(told)))
        return
    print_report(found.name, tumble_summary(found), groups, notes, files)


def tumbler_of(body: str | None, options: TumbleOptions) -> Tumbler:
    """Return what is to be told of a known body, or of one given by options.

    Raises:
        InvalidInput: for what is missing, cannot be read, or has no motion.
    """
    known = None if body is None else known_tumbler(body)
    given = _given(known, options)
    (precession, d_precession), (rotation, d_rotation), (moments, d_moments) = given
    axis = _one_of("--axis", options.axis, AXES) or "encircled"
    wanted = _one_of("--mode", options.mode, MODES)
    errors = [d_precession, d_rotation, *d_moments]
    sizes = errors if any(errors) else None
    motions = fit_tumbling(precession, rotation, moments, axis, sizes)  # type: ignore[arg-type]
    published = known.mode if known is not None else motions[0].mode
    mode: Mode = wanted or published  # type: ignore[assignment]
    chosen = [motion for motion in motions if motion.mode == mode]
    if not chosen:
        there = motions[0].mode
        limit = least_period_ratios(moments)[MODES.index(mode)]
        raise InvalidInput(f"no motion in the {mode} mode has these periods: with these moments the rotation must take "
                           f"more than {limit:.4g} times as long as the precession. There is one in the {there} mode: "
                           f"--mode {there}.")  # fmt: skip
    motion = chosen[0]
    others = tuple(other for other in motions if other is not motion)
    return Tumbler(
        "tumbler" if known is None else known.name, "" if known is None else known.source, motion, others,
        least_period_ratios(moments), _light(motion, options), _damping(motion, options),
    )  # fmt: skip


def _given(known: KnownTumbler | None, options: TumbleOptions) -> _Given:
    texts = {
        "--precession": options.precession or (known.precession if known else None),
        "--rotation": options.rotation or (known.rotation if known else None),
    }
    if options.moments is not None and options.semi_axes is not None:
        raise InvalidInput("--moments and --semi-axes both tell the moments. Leave one out.")
    moments = options.moments or (None if options.semi_axes or known is None else known.moments)
    missing = [name for name, text in texts.items() if text is None]
    missing += ["--moments"] if moments is None and options.semi_axes is None else []
    if missing:
        whose = "" if known is None else f" of {known.name}"
        raise InvalidInput(f"{' and '.join(missing)} {'are' if len(missing) > 1 else 'is'} missing{whose}. Write for "
                           'example --precession "27.38 h" --rotation "263 h" --moments 0.61 0.965 1, or name a body '
                           "of --list.")  # fmt: skip
    periods = [_uncertain(name, str(text), "s") for name, text in texts.items()]
    if moments is not None:
        return _Given(periods[0], periods[1], _moments(moments))
    assert options.semi_axes is not None
    check_reach("--semi-axes", *options.semi_axes)
    squares = np.sort(np.square(options.semi_axes))[::-1]
    if not (np.isfinite(squares).all() and squares[2] > 0):
        raise InvalidInput(f"--semi-axes must be three positive numbers; got {shown(options.semi_axes)}.")
    return _Given(periods[0], periods[1], ((squares.sum() - squares).tolist(), [0.0] * 3))


def _moments(texts: tuple[str, str, str]) -> tuple[list[float], list[float]]:
    pairs = sorted((_uncertain("--moments", text, "kg*m^2", bare=True) for text in texts), key=lambda pair: pair[0])
    return [value for value, _ in pairs], [error for _, error in pairs]


def _uncertain(name: str, text: str, unit: str, bare: bool = False) -> tuple[float, float]:
    """Return a quantity with its standard deviation, like "27.38 ± 0.07 h", in SI; without a unit where allowed."""
    value, *rest = _ERROR.split(text.strip())
    if len(rest) > 1:
        raise InvalidInput(f'{name} must be like "27.38 ± 0.07 h"; got {shown(text)}.')
    last = rest[-1] if rest else value
    found = _TRAILING_UNIT.search(last)
    if found is None and bare:
        try:
            numbers = [read_number(part) for part in (value, *rest)]
        except ValueError:
            raise InvalidInput(f"{name} must be numbers; got {shown(text)}.") from None
        check_reach(name, *numbers)
        parts = numbers
        if not parts[0] > 0:
            raise InvalidInput(f"{name} must be positive; got {shown(text)}.")
    else:
        own = _TRAILING_UNIT.search(value)
        first = value if own or found is None else f"{value} {found.group()}"
        parts = [quantity(name, first, unit), *(quantity(name, part, unit, positive=False) for part in rest)]
    error = parts[1] if rest else 0.0
    if error < 0:
        raise InvalidInput(f"{name} must not have a negative error; got {shown(text)}.")
    return parts[0], error


def _light(motion: Tumbling, options: TumbleOptions) -> LightCurve | None:
    aspect = _angle("--aspect", options.aspect, "60 deg", 180.0)
    phase = _angle("--phase", options.phase, "20 deg", 170.0)
    if motion.moments[0] + motion.moments[1] <= 1 + 1e-12:
        return None
    axes = equivalent_ellipsoid(motion.moments)
    # L is along z in space
    observer = np.array([np.sin(aspect), 0.0, np.cos(aspect)])
    sun = np.cos(phase) * observer + np.sin(phase) * np.array([0.0, 1.0, 0.0])
    lines = light_curve_lines(motion.motion, axes, sun, observer)
    times = np.linspace(0.0, TURNS * motion.precession, SAMPLES + 1)
    return LightCurve(axes, aspect, phase, lines, times, light_curve(motion.motion, times, axes, sun, observer))


def _damping(motion: Tumbling, options: TumbleOptions) -> Damping | None:
    if options.diameter is None:
        named = {"--density": options.density, "--rigidity": options.rigidity, "--shape-factor": options.shape_factor}
        if wrong := [name for name, value in named.items() if value is not None]:
            raise InvalidInput(f"{', '.join(wrong)} is for the time of damping, which needs --diameter. Give it too.")
        return None
    diameter = quantity("--diameter", options.diameter, "m")
    density = quantity("--density", options.density or "2000 kg/m^3", "kg/m^3")
    rigidity = quantity("--rigidity", options.rigidity or "5e11 Pa", "Pa")
    shape = 0.03 if options.shape_factor is None else options.shape_factor
    if not 0 < shape < np.inf:
        raise InvalidInput(f"--shape-factor must be positive, like 0.03; got {shown(shape)}.")
    check_reach("--shape-factor", shape)
    time = internal_damping_time(motion.precession, diameter, density, rigidity, shape)
    return Damping(time, diameter, density, rigidity, shape)


def _angle(name: str, text: str | None, usual: str, most: float) -> float:
    value = quantity(name, usual if text is None else text, "rad", positive=False)
    if not 0.0 <= value <= np.radians(most) * (1 + 1e-15):
        raise InvalidInput(f"{name} must be between 0 and {most:g} deg; got {shown(text)}.")
    return value


def _one_of(name: str, text: str | None, known: tuple[str, ...]) -> str | None:
    if text is not None and text not in known:
        raise InvalidInput(f"{name} must be {', '.join(known[:-1])} or {known[-1]}; got {shown(text)}.")
    return text


def _written(found: Tumbler, options: TumbleOptions) -> list[str]:
    files = []
    if options.out is not None:
        if options.out.suffix.lower() == ".toml":
            _write_spec(found, options.out)
        else:
            _write_curve(found, options.out)
        files.append(str(options.out))
    if options.figures is not None:
        from polhode.figures.style import save
        from polhode.figures.tumble_figure import tumble_figures
        from polhode.formats.paths import written_together

        with written_together(options.figures) as draft:
            for name, figure in tumble_figures(found).items():
                save(figure, draft / f"{name}.png")
                files.append(str(options.figures / f"{name}.png"))
    return files


def _write_curve(found: Tumbler, path: Path) -> None:
    if found.light is None:
        raise InvalidInput(f"{path}: a flat body, I1 + I2 = I3, has no light curve here. Give moments of a solid body.")
    with written_whole(path) as draft, draft.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time [s]", "magnitude [mag]"])
        writer.writerows(zip(found.light.times.tolist(), found.light.magnitudes.tolist(), strict=True))


def _write_spec(found: Tumbler, path: Path) -> None:
    motion = found.motion
    spin = np.asarray(motion.motion.angular_velocity(0.0)).tolist()
    moments = ", ".join(f'"{x:.17g} kg*m^2"' for x in motion.moments.tolist())
    rates = ", ".join(f'"{x:.17g} rad/s"' for x in spin)
    text = (
        f"# {found.name}: {motion.mode} mode, P_phi = {motion.precession:.10g} s, P_psi = {motion.rotation:.10g} s.\n"
        f"# Periods leave the scale of the moments open; the largest is 1 kg m^2 here.\n"
        f'name = "{found.name}"\n\n[body]\nmoments = [{moments}]\n\n'
        f'[spin]\nangular_velocity = [{rates}]\nframe = "principal"\n\n[time]\nuntil = "{5 * motion.rotation:.10g} s"\n'
    )
    with written_whole(path) as draft:
        draft.write_text(text, "utf-8")
