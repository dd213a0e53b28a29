"""``polhode new [EXAMPLE]``: copies a spec from the examples that come with the package."""

from __future__ import annotations

import contextlib
import difflib
import shutil
import tomllib
from collections.abc import Iterator
from pathlib import Path

import polhode
from polhode.cli.terminal import spell_command
from polhode.errors import InvalidInput, PolhodeError, one_line, printable, shown
from polhode.formats.paths import write_together
from polhode.kinds.base import AbstractKind
from polhode.kinds.registry import find_kind, kind_names


def run_new(example: str | None, out: Path | None) -> None:
    """Copy an example and the files that it needs into a folder, or list the examples."""
    known, foreign = examples(), kinds_of_others()
    if example is None:
        width = max(map(len, {**known, **foreign}))
        for name, path in known.items():
            print(printable(f"{name:<{width}}  {_about(path.read_text('utf-8'))}"))
        for name, kind in foreign.items():
            about = _about(kind.example) or _first_sentence((type(kind).__doc__ or f"A motion of kind {name}").strip())
            print(printable(f"{name:<{width}}  {about} (package {type(kind).__module__.split('.')[0]})"))
        print(f"\nNext: {spell_command('new', 't_handle')} copies one of them.")
        return
    asked, folder = example.removesuffix(".toml"), Path() if out is None else out
    if asked not in known and asked in foreign:
        with _copy_together([folder / f"{asked}.toml"], folder) as draft:
            (draft / f"{asked}.toml").write_text(foreign[asked].example, "utf-8")
        return
    chosen = known.get(asked)
    if chosen is None:
        near = difflib.get_close_matches(example, [*known, *foreign], 1)
        meant = f"; did you mean {near[0]}?" if near else "."
        raise InvalidInput(f"no example is called {shown(example)}{meant} `polhode new` lists them.")
    wanted = [chosen, *_list_needed_files(chosen)]
    with _copy_together([folder / path.name for path in wanted], folder) as draft:
        for path in wanted:
            shutil.copyfile(path, draft / path.name)


@contextlib.contextmanager
def _copy_together(wanted: list[Path], folder: Path) -> Iterator[Path]:
    """Yield a draft folder whose files take the wanted names, the spec first, and print these."""
    if there := [path for path in wanted if path.exists()]:
        raise InvalidInput(f"{there[0]}: is there already, and nothing was copied. Name another folder by --out.")
    with write_together(folder) as draft:
        yield draft
    print(f"Written: {', '.join(one_line(str(path)) for path in wanted)}")
    print(f"Next: {spell_command('report', str(wanted[0]))}")


def kinds_of_others() -> dict[str, AbstractKind]:
    """Return the kinds that other packages bring, by name; those that cannot be imported are left out."""
    kinds = {}
    for name in kind_names():
        with contextlib.suppress(PolhodeError):
            kind = find_kind(name)
            if kind is not None and not type(kind).__module__.startswith("polhode."):
                kinds[name] = kind
    return kinds


def examples() -> dict[str, Path]:
    """Return the specs that come with the package, by name; in a clone they stand next to the sources.

    Raises:
        InvalidInput: if they are missing.
    """
    package = Path(polhode.__file__).parent
    for folder in (package / "examples", package.parents[1] / "examples"):
        if paths := sorted(folder.glob("*.toml")):
            return {path.stem: path for path in paths}
    raise InvalidInput("the examples are missing from this installation. Install polhode again.")


def _about(spec: str) -> str:
    """Return the first sentence of the comment that an example begins with; "" without one."""
    lines = []
    for line in spec.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return _first_sentence(" ".join(lines)) if any(lines) else ""


def _first_sentence(text: str) -> str:
    """Return the first sentence of a text, up to a colon."""
    return " ".join(text.split()).split(". ")[0].split(": ")[0].rstrip(".:") + "."


def _list_needed_files(spec: Path) -> list[Path]:
    """Return the files that a spec names, in any table."""
    tables = [table for table in tomllib.loads(spec.read_text("utf-8")).values() if isinstance(table, dict)]
    named = [value for table in tables for value in table.values() if isinstance(value, str)]
    return [path for path in (spec.parent / value for value in named) if path.is_file()]
