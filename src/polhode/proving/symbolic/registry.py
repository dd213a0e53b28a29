"""The list of derivations: the files of the folder `derivations`, each with a function `derive`."""

from __future__ import annotations

import difflib
import pkgutil
from importlib import import_module
from pathlib import Path

from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic.rendering import Page

HOME = Path(__file__).parent / "derivations"


def derivation_names() -> list[str]:
    """Return the names of all derivations, sorted; none of them is imported."""
    return sorted(found.name.replace("_", "-") for found in pkgutil.iter_modules([str(HOME)]))


def derive(name: str) -> Page:
    """Return a derivation as a page, after checking each of its steps.

    Args:
        name: such as "clebsch"; ``derivation_names`` lists them.

    Raises:
        InvalidInput: for a name that is none.
        DerivationBroken: if a step does not hold, by symbols or against the numerical system.

    >>> derive("clebsch").title
    "Clebsch's case"
    """
    if name not in derivation_names():
        near = difflib.get_close_matches(str(name), derivation_names(), 1)
        hint = f"Did you mean {near[0]}?" if near else "Choose one of these."
        raise InvalidInput(f"a derivation must be one of {', '.join(derivation_names())}; got {shown(name)}. {hint}")
    return import_module(f"{__package__}.derivations.{name.replace('-', '_')}").derive()


def describe_derivation(name: str) -> str:
    """Return what a derivation shows, in a line: the first of its file's docstring."""
    text = (HOME / f"{name.replace('-', '_')}.py").read_text("utf-8")
    return text.split('"""')[1].split("\n")[0]
