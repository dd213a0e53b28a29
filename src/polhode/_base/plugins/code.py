"""The code of other packages by content: their files, what these import of their makers, and versions of libraries.

A package counts as a whole, with its files of data, and so does whatever else its code imports: other modules of the
same distribution, modules that lie on the path, packages that are installed to be edited. Of a library that was
installed from an index the version counts. Imports are looked for in the text, wherever they stand, so that the digest
does not depend on what a process has imported so far.
"""

from __future__ import annotations

import hashlib
import re
import sys
import zipfile
from collections.abc import Collection, Iterator
from functools import lru_cache
from importlib import metadata
from importlib.machinery import ModuleSpec
from importlib.util import find_spec, resolve_name
from pathlib import Path
from typing import Any, NamedTuple

INSTALLED = ("site-packages", "dist-packages")  # folders of packages whose code nobody edits in place
_IMPORT = re.compile(r"^[ \t]*(?:.*;[ \t]*)?(?:from[ \t]+([\w.]+)[ \t]+import[ \t]*(\([^)]*\)|[^#;\n]*)"
                     r"|import[ \t]+([^#;\n]+))", re.MULTILINE)
_BY_CALL = re.compile(r"\b(?:import_module|__import__|find_spec)\(\s*[\"']([\w.]+)[\"']")
_NAME = re.compile(r"[\w.]+")


class _File(NamedTuple):
    """A file of code: its SHA-256, and the modules that it imports, relative ones with their dots."""

    digest: str
    imports: tuple[str, ...]


def digest_code(module: str, own: Collection[str] = (), known: Collection[str] = ()) -> str:
    """Return a SHA-256 of the code that a module runs.

    Args:
        module: by its name, which need not be importable.
        own: other modules of its distribution, at the top, whose code counts even where they are installed.
        known: modules at the top that count elsewhere.
    """
    files: dict[str, str] = {}
    libraries: dict[str, str] = {}
    waiting, seen = [module], set[str]()
    while waiting:
        name = waiting.pop()
        spec = None if name.partition(".")[0] in known else _find(name)
        if spec is None or spec.name in seen:
            continue
        seen.add(spec.name)
        top = spec.name.partition(".")[0]
        version = None if len(seen) == 1 or top in own or not _is_installed(spec) else find_version(top)
        if version is not None:
            libraries[spec.name] = version
            continue
        for path, file in _read_code(spec):
            files[f"{spec.name}/{path}"] = file.digest
            waiting += [_absolute(one, spec) for one in file.imports]
    return hashlib.sha256(repr((sorted(files.items()), sorted(libraries.items()))).encode()).hexdigest()


def list_edited_modules(known: Collection[str] = ()) -> Iterator[Path]:
    """Yield the files of what this process has imported by whatever name, but Python's own, and what is installed.

    Names of modules that are put together while a program runs are in no text.

    Args:
        known: modules at the top that count elsewhere.
    """
    for name, module in list(sys.modules.items()):
        top, path = name.partition(".")[0], getattr(module, "__file__", None)
        if path is None or top in known or top in sys.stdlib_module_names or top == "__main__":
            continue
        if not any(parent.name in INSTALLED for parent in Path(path).parents) and Path(path).is_file():
            yield Path(path)


def modules_of(distribution: Any) -> frozenset[str]:
    """Return the names at the top of what a distribution installs; none where it does not say."""
    if distribution is None:
        return frozenset()
    listed = (distribution.read_text("top_level.txt") or "").split()
    parts = [path.parts[0] for path in distribution.files or () if path.suffix == ".py" or len(path.parts) > 1]
    return frozenset({*listed, *(part.removesuffix(".py") for part in parts)})


@lru_cache(maxsize=256)
def find_version(module: str) -> str | None:
    """Return the version of the distribution that has a module at its top; None where none is installed."""
    try:
        return metadata.version(module.replace("_", "-"))
    except metadata.PackageNotFoundError:
        names = _distributions().get(module)
    return None if not names else " ".join(f"{name} {metadata.version(name)}" for name in sorted(set(names)))


@lru_cache(maxsize=1)
def _distributions() -> Any:
    return metadata.packages_distributions()


def _find(name: str) -> ModuleSpec | None:
    """Return the first package or module of a dotted name that has code; None for Python's own, and for missing ones.

    Namespaces have no code, and may have parts of several makers.
    """
    parts = name.split(".")
    if parts[0] in sys.stdlib_module_names:
        return None
    for count in range(1, len(parts) + 1):
        try:
            spec = find_spec(".".join(parts[:count]))
        except (ImportError, ValueError, AttributeError):
            return None
        if spec is None or spec.origin is not None:
            return spec
    return None


def _is_installed(spec: ModuleSpec) -> bool:
    return any(parent.name in INSTALLED for parent in Path(spec.origin or "").parents)


def _absolute(name: str, spec: ModuleSpec) -> str:
    """Return the whole name of what a module in a namespace imports by dots; a package's own parts count anyway."""
    if not name.startswith("."):
        return name
    if spec.submodule_search_locations is not None or not spec.parent:
        return spec.name
    try:
        return resolve_name(name, spec.parent)
    except ImportError:
        return spec.name


def _read_code(spec: ModuleSpec) -> Iterator[tuple[str, _File]]:
    """Yield the files of a package or module, by their paths within it."""
    origin = Path(spec.origin or "")
    if archive := next((parent for parent in origin.parents if parent.is_file()), None):
        yield from _members(archive, *_state(archive))
    elif spec.submodule_search_locations is None:
        if origin.is_file():
            yield origin.name, _read(origin, *_state(origin))
    else:
        for top in map(Path, spec.submodule_search_locations):
            for path in sorted(top.rglob("*")):
                if path.parent.name != "__pycache__" and path.is_file():
                    yield path.relative_to(top).as_posix(), _read(path, *_state(path))


def _state(path: Path) -> tuple[int, ...]:
    """Return what differs when a file was written since."""
    status = path.stat()
    return status.st_size, status.st_mtime_ns, status.st_ctime_ns, status.st_ino


@lru_cache(maxsize=4096)
def _read(path: Path, *state: int) -> _File:
    return _file(path.name, path.read_bytes())


@lru_cache(maxsize=64)
def _members(archive: Path, *state: int) -> list[tuple[str, _File]]:
    with zipfile.ZipFile(archive) as files:
        return [(name, _file(name, files.read(name))) for name in sorted(files.namelist())]


def _file(name: str, content: bytes) -> _File:
    imports = tuple(sorted(set(_imports(content.decode("utf-8", "replace"))))) if name.endswith(".py") else ()
    return _File(hashlib.sha256(content).hexdigest(), imports)


def _imports(text: str) -> Iterator[str]:
    """Yield what a text may import: the module of ``from``, and its names too, which may be modules of a namespace."""
    for origin, names, listed in _IMPORT.findall(text.replace("\\\n", " ")):
        if listed:
            yield from (match[0] for part in listed.split(",") if (match := _NAME.match(part.strip())))
        else:
            yield origin
            each = (re.sub(r"#.*", "", names)).strip("() \t\n").split(",")
            joint = "" if origin.endswith(".") else "."
            yield from (f"{origin}{joint}{match[0]}" for part in each if (match := _NAME.match(part.strip())))
    yield from _BY_CALL.findall(text)
