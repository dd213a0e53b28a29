"""``polhode tumble``: how an asteroid tumbles, from its two periods and the ratios of its moments."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode.celestial.tumbling.estimation import MODES
from polhode.celestial.tumbling.known_tumblers import known_tumbler, known_tumblers
from polhode.celestial.tumbling.study import AXES, Friction, Given, tumble_report
from polhode.cli.publish import publish
from polhode.cli.render import as_json
from polhode.cli.terminal import spell_command
from polhode.errors import InvalidInput, shown
from polhode.spec.reach import check_reach
from polhode.spec.uncertain import quantity


class TumbleOptions(NamedTuple):
    """The options as given; None where they are not."""

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


def run_list(json: bool) -> None:
    """Print the known tumblers."""
    rows = [known._asdict() for known in known_tumblers().values()]
    if json:
        listed = {"name": "tumblers", "kind": "tumblers", "summary": f"{len(rows)} bodies are known by name."}
        print(as_json({**listed, "tumblers": rows, "units": {}, "notes": [], "files": []}))
        return
    for known in known_tumblers().values():
        moments = "moments unknown" if known.moments is None else " : ".join(known.moments)
        print(f"{known.key:<14}{known.name}: P_φ {known.precession}, P_ψ {known.rotation}, {moments}, {known.mode}\n"
              f"{'':<14}{known.source}")
    print(f"\nNext: {spell_command('tumble', 'apophis')}")


def run_tumble(body: str | None, options: TumbleOptions, json: bool) -> None:
    """Solve for the motion, print the report, and write and draw as the options ask."""
    if options.out is not None and options.out.suffix.lower() not in (".csv", ".toml"):
        raise InvalidInput(f"--out must end in .csv (light curve) or .toml (spec); got {shown(str(options.out))}.")
    known = None if body is None else known_tumbler(body)
    inputs = Given(
        options.precession, options.rotation, options.moments, options.semi_axes,
        _check_choice("--axis", options.axis, AXES) or "encircled", _check_choice("--mode", options.mode, MODES),
        _friction(options), _angle("--aspect", options.aspect, "60 deg", 180.0),
        _angle("--phase", options.phase, "20 deg", 170.0),
    )
    report = tumble_report(known, inputs)
    publish(report, json, options.out, options.figures)


def _friction(options: TumbleOptions) -> Friction | None:
    if options.diameter is None:
        named = {"--density": options.density, "--rigidity": options.rigidity, "--shape-factor": options.shape_factor}
        if wrong := [name for name, value in named.items() if value is not None]:
            raise InvalidInput(f"{', '.join(wrong)} is for the time of damping, which needs --diameter. Give it too.")
        return None
    diameter = quantity("--diameter", options.diameter, "m")
    density = quantity("--density", options.density or "2000 kg/m^3", "kg/m^3")
    rigidity = quantity("--rigidity", options.rigidity or "5e11 Pa", "Pa")
    shape = 0.03 if options.shape_factor is None else options.shape_factor
    check.number("--shape-factor", shape, above=0, remedy="0.03 is usual.")
    check_reach("--shape-factor", shape)
    return Friction(diameter, density, rigidity, shape)


def _angle(name: str, text: str | None, usual: str, most: float) -> float:
    value = quantity(name, usual if text is None else text, "rad", positive=False)
    if not 0.0 <= value <= np.radians(most) * (1 + 1e-15):
        raise InvalidInput(f"{name} must be between 0 and {most:g} deg; got {shown(text)}.")
    return value


def _check_choice(name: str, text: str | None, known: tuple[str, ...]) -> Any:
    return text if text is None else check.one_of(name, text, known)
