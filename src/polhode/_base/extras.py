"""Libraries that polhode can do without: where one is missing, an error names it, and the extra that brings it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from importlib.util import find_spec
from typing import Any, NamedTuple

import lazy_loader

from polhode.errors import NotInstalled


class Library(NamedTuple):
    """What messages call a library, which is what an index calls it but for capitals, and the extra that brings it."""

    name: str
    extra: str


_OF_JAX = {"jax": "JAX", "jaxlib": "jaxlib", "equinox": "Equinox", "diffrax": "Diffrax", "optimistix": "Optimistix",
           "flint": "python-flint"}  # fmt: skip
_OF_APP = {
    "SALib": "SALib", "astropy_iers_data": "astropy-iers-data", "collada": "pycollada", "dask": "dask",
    "distributed": "distributed", "filelock": "filelock", "h5netcdf": "h5netcdf", "h5py": "h5py", "lxml": "lxml",
    "matplotlib": "Matplotlib", "networkx": "networkx", "numcodecs": "numcodecs", "pint": "Pint",
    "platformdirs": "platformdirs", "pydantic": "pydantic", "rich": "rich", "sympy": "SymPy", "tqdm": "tqdm",
    "scipy": "SciPy", "trimesh": "trimesh", "typer": "Typer", "xarray": "xarray", "zarr": "zarr",
}  # fmt: skip
_OF_DOCS = {"furo": "furo", "latex2mathml": "latex2mathml", "myst_nb": "myst-nb", "sphinx": "Sphinx",
            "sphinx_design": "sphinx-design", "sphinx_proof": "sphinx-proof"}  # fmt: skip
LIBRARIES = {
    **{module: Library(name, "jax") for module, name in _OF_JAX.items()},
    **{module: Library(name, "app") for module, name in _OF_APP.items()},
    **{module: Library(name, "docs") for module, name in _OF_DOCS.items()},
    "ase": Library("ASE", "molecules"), "spiceypy": Library("spiceypy", "spice"), "z3": Library("z3-solver", "prove"),
}
"""By the name of what is imported."""


@cache
def is_there(module: str) -> bool:
    """Return whether a library can be imported, without importing it.

    >>> is_there("numpy")
    True
    """
    try:
        return find_spec(module) is not None
    except (ImportError, ValueError):
        return False


def not_installed(what: str, module: str, otherwise: str = "", alone: bool = False) -> NotInstalled:
    """Return the error for a library that is missing, with the command that installs it.

    The command is of the Python that runs now, so that the library goes where it is missing. An extra of a polhode that
    is installed, be it from a clone, pip takes from there and not from an index; of one that is not, the command names
    the library itself.

    Args:
        what: needs the library, with that verb: "Zarr stores need".
        module: its root, a key of ``LIBRARIES``.
        otherwise: another remedy, a sentence.
        alone: whether the library does by itself, where its extra would bring many more.
    """
    from importlib import metadata

    library = LIBRARIES[module]
    try:
        about = metadata.metadata("polhode")
        extras, listed = about.get_all("Provides-Extra") or [], about.get_all("Requires-Dist") or []
    except metadata.PackageNotFoundError:
        extras, listed = [], []
    if library.extra in extras and not alone:
        wanted = f"polhode[{library.extra}]"
    else:  # the library by its own name, with the lowest version that works
        named = (line.split(";")[0].strip() for line in listed)
        name = library.name.lower()
        wanted = next((one for one in named if one.lower().startswith((f"{name}>", f"{name}="))), library.name)
    python = f'"{sys.executable}"' if " " in sys.executable else sys.executable or "python"
    said = f'{what} {library.name}, which is not installed. Run `{python} -m pip install "{wanted}"`. {otherwise}'
    return NotInstalled(said.rstrip(), name=module)


@contextmanager
def needing(what: str, otherwise: str = "", alone: bool = False) -> Iterator[None]:
    """Name what a block imports and is missing, as ``not_installed`` does; other errors stay.

    >>> with needing("Stores need"):
    ...     import numpy
    """
    try:
        yield
    except ModuleNotFoundError as error:
        raise named(what, error, otherwise, alone) from None


def named(
    what: str, error: ModuleNotFoundError, otherwise: str = "", alone: bool = False
) -> ModuleNotFoundError:
    """Return the error of ``not_installed`` for a library of ``LIBRARIES``, the error itself for other modules."""
    module = (error.name or "").partition(".")[0]
    if isinstance(error, NotInstalled) or module not in LIBRARIES:
        return error
    if LIBRARIES[module].extra == "jax" and module != "flint" and not is_there("jax"):
        module = "jax"  # whatever is imported first
    return not_installed(what, module, otherwise, alone)


def attach_stub(package: str, file: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return ``__getattr__``, ``__dir__`` and ``__all__`` of a package as ``lazy_loader.attach_stub`` does.

    A name whose module needs a library that is missing says so.
    """
    load, names, listed = lazy_loader.attach_stub(package, file)

    def load_or_refuse(name: str) -> Any:
        try:
            return load(name)
        except ModuleNotFoundError as error:
            raise named(f"`{package}.{name}` needs", error) from None

    return load_or_refuse, names, listed
