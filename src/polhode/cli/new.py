"""``polhode new [EXAMPLE]``: a spec to begin with, copied from the examples that come with the package."""

from __future__ import annotations

import difflib
import shutil
import tomllib
from pathlib import Path

import polhode
from polhode.cli.terminal import as_typed
from polhode.errors import InvalidInput, one_line, printable, shown
from polhode.formats.paths import written_together


def run_new(example: str | None, out: Path | None) -> None:
    """Copy an example and the files that it needs into a folder, or list the examples."""
    known = examples()
    if example is None:
        width = max(map(len, known))
        for name, path in known.items():
            print(printable(f"{name:<{width}}  {_about(path)}"))
        print(f"\nNext: {as_typed('new', 't_handle')} copies one of them.")
        return
    chosen = known.get(example.removesuffix(".toml"))
    if chosen is None:
        near = difflib.get_close_matches(example, known, 1)
        meant = f"; did you mean {near[0]}?" if near else "."
        raise InvalidInput(f"no example is called {shown(example)}{meant} `polhode new` lists them.")
    folder = Path() if out is None else out
    wanted = [chosen, *_needed(chosen)]
    there = [folder / path.name for path in wanted if (folder / path.name).exists()]
    if there:
        raise InvalidInput(f"{there[0]}: is there already, and nothing was copied. Name another folder by --out.")
    with written_together(folder) as draft:
        for path in wanted:
            shutil.copyfile(path, draft / path.name)
    print(f"Written: {', '.join(one_line(str(folder / path.name)) for path in wanted)}")
    print(f"Next: {as_typed('report', str(folder / chosen.name))}")


def examples() -> dict[str, Path]:
    """Return the specs that come with the package, by name; in a clone they stand next to the sources.

    Raises:
        InvalidInput: if they are missing.
    """
    package = Path(polhode.__file__).parent
    for folder in (package / "examples", package.parents[1] / "examples"):
        if found := sorted(folder.glob("*.toml")):
            return {path.stem: path for path in found}
    raise InvalidInput("the examples are missing from this installation. Install polhode again.")


def _about(spec: Path) -> str:
    """Return the first sentence of the comment that an example begins with."""
    lines = []
    for line in spec.read_text("utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return " ".join(lines).split(". ")[0].split(": ")[0].rstrip(".") + "."


def _needed(spec: Path) -> list[Path]:
    """Return the files that a spec names, in any table."""
    tables = [table for table in tomllib.loads(spec.read_text("utf-8")).values() if isinstance(table, dict)]
    named = [value for table in tables for value in table.values() if isinstance(value, str)]
    return [path for path in (spec.parent / value for value in named) if path.is_file()]
