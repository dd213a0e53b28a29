"""What other packages add by entry points: kinds, formats, torques, mounts, control laws, commands and more."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Collection, Iterable, Iterator
from contextvars import ContextVar
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, NamedTuple

from polhode.errors import InvalidInput

# whose versions change numbers, or how a spec is read; a test of the house looks for others
COMPUTED_BY = ("numpy", "scipy", "array-api-compat", "numba", "llvmlite", "jax", "jaxlib", "equinox", "diffrax",
               "optimistix", "lineax", "pydantic", "pydantic-core", "pint", "trimesh", "ase", "xarray", "h5netcdf",
               "h5py", "zarr", "numcodecs")  # fmt: skip
GROUPS = {
    "polhode.kinds": "kind", "polhode.formats": "format", "polhode.torques": "torque", "polhode.mounts": "mount",
    "polhode.control": "control law", "polhode.commands": "command", "polhode.bodies": "format of bodies",
    "polhode.fits": "fit", "polhode.report-options": "option of report", "polhode.figures": "figure",
    "polhode.derivations": "derivation",
}  # fmt: skip
"""The groups of entry points, and the word for one of each in messages."""
FAILURES = (Exception, SystemExit)
"""What code of other packages may raise that polhode catches: their ``sys.exit`` is to end no command of polhode."""
_KNOWN = frozenset({"polhode", *(name.replace("-", "_") for name in COMPUTED_BY)})  # counted with the program itself


class Plugin(NamedTuple):
    """An entry point of another package.

    Attributes:
        group: of ``GROUPS``.
        name: by which specs and commands name it.
        value: module and object.
    """

    group: str
    name: str
    value: str

    @property
    def word(self) -> str:
        """What it is, in a word."""
        return GROUPS.get(self.group, self.group)  # what was kept may be of groups that another version has

    def __str__(self) -> str:
        return f"the {self.word} {self.name} of another package, {self.value}"


_recordings: ContextVar[tuple[set[Plugin], ...]] = ContextVar("recordings", default=())
_warned: set[tuple[Plugin, Plugin]] = set()
_loaded: dict[Plugin, str] = {}  # with the digest of the code that this process imported


def find_entry_points(group: str, own: Collection[str]) -> dict[str, Any]:
    """Return the entry points of a group by name, but those that have the name of something of polhode's own.

    Of several packages that bring one name, the first by the alphabet is taken, whatever the order on the path. Where
    ``importlib_metadata`` has been imported, they are of its class.

    Args:
        group: of ``GROUPS``.
        own: names that are taken, which a warning tells.
    """
    found: dict[str, Any] = {}
    for point in sorted(entry_points(group=group), key=_rank):
        first = found.setdefault(point.name, point)
        if point.value != first.value:
            _warn_of_two(first, point)
    for name in sorted(found.keys() & set(own)):
        warnings.warn(f"{_plugin(found.pop(name))}, is ignored, as polhode has one of this name itself. Rename or "
                      "remove it.", stacklevel=2)
    return found


def list_plugins() -> list[Plugin]:
    """Return all that other packages bring, whether or not it takes part."""
    points = entry_points()  # asking for each group would read the files of all packages as often
    return sorted({_plugin(point) for group in GROUPS for point in points.select(group=group)})


def load_entry_point(point: Any) -> Any:
    """Return what an entry point names, which is recorded as taking part.

    Raises:
        InvalidInput: where it cannot be imported.
    """
    note_use(point)
    plugin = _plugin(point)
    if plugin not in _loaded:  # before it is imported, so that this is not the digest of later code
        _loaded[plugin] = _digest(point)
    try:
        return point.load()
    except FAILURES as error:
        why = f"{'it calls sys.exit with ' if isinstance(error, SystemExit) else ''}{error}"
        raise InvalidInput(f"{plugin}, cannot be imported: {why}. Update or remove it.") from error


@contextlib.contextmanager
def record_plugins() -> Iterator[set[Plugin]]:
    """Yield a set of the entry points that take part while the block runs; other threads are not recorded."""
    used: set[Plugin] = set()
    before = _recordings.set((*_recordings.get(), used))
    try:
        yield used
    finally:
        _recordings.reset(before)


@contextlib.contextmanager
def record_nothing() -> Iterator[None]:
    """Let a block look at what is there without it taking part."""
    before = _recordings.set(())
    try:
        yield
    finally:
        _recordings.reset(before)


def note_use(point: Any) -> None:
    """Record that an entry point takes part."""
    for used in _recordings.get():
        used.add(_plugin(point))


def digest_plugins(plugins: Iterable[Plugin]) -> dict[Plugin, str]:
    """Return the digests of the code of entry points, "" for those that are gone or name something else by now.

    Raises:
        InvalidInput: where this process has imported code that was changed since: which of the two runs is not known.
    """
    found = {}
    for plugin in sorted(set(plugins)):
        points = [point for point in entry_points(group=plugin.group) if _plugin(point) == plugin]
        found[plugin] = _digest(points[0]) if points else ""
        if _loaded.get(plugin, found[plugin]) != found[plugin]:
            raise InvalidInput(f"{plugin}, changed after this process had imported it. Put it back, or begin again in "
                               "a new process.")
    return found


def list_modules_of_others() -> list[Path]:
    """Return the files of modules of this process that are neither polhode's nor installed, whoever imported them."""
    from polhode._base.plugins.code import list_edited_modules

    return sorted(set(list_edited_modules(_KNOWN)))


def _rank(point: Any) -> tuple[str, str, str]:
    return point.name, _package(point), point.value


def _package(point: Any) -> str:
    return str(getattr(getattr(point, "dist", None), "name", None) or "")


def _warn_of_two(taken: Any, other: Any) -> None:
    """Warn that two packages bring one name, once in a process: commands look for entry points again and again."""
    both = _plugin(taken), _plugin(other)
    if both in _warned:
        return
    first, second = (f"{point.value} of {_package(point) or 'another package'}" for point in (taken, other))
    warnings.warn(f"two packages bring the {both[0].word} {taken.name}: {first}, which is taken, and {second}, which "
                  "is ignored. Rename or remove one.", stacklevel=3)
    _warned.add(both)


def _plugin(point: Any) -> Plugin:
    return Plugin(point.group, point.name, point.value)


def _digest(point: Any) -> str:
    from polhode._base.plugins.code import digest_code, modules_of

    own = modules_of(getattr(point, "dist", None))
    return digest_code(str(point.value).partition(":")[0].strip(), own, _KNOWN)
