"""Which motions of the playground the default tests open."""

from pathlib import Path

from polhode.kinds.playground import presets

EXAMPLES = {path.stem: path for path in (Path(__file__).parents[2] / "examples").glob("*.toml")}
COMPILED = {"gyroscope", "dual_spin", "explorer_1", "euler_disk"}
"""Examples whose motions take seconds to compile: they are tried in the sweep."""


def quick():
    """Return the presets of the others."""
    return [one for one in presets() if one["example"] not in COMPILED]
