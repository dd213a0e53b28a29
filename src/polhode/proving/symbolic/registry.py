"""The list of derivations: the files of the folder `derivations`, and what other packages add to them.

Another package offers a function without arguments that returns a ``Page``, in the entry-point group
``polhode.derivations``.
"""

from __future__ import annotations

import difflib
import inspect
import pkgutil
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from polhode._base.plugins import FAILURES, find_entry_points, load_entry_point
from polhode.errors import InvalidInput, PolhodeError, one_line, shown
from polhode.proving.symbolic.rendering import Page

HOME = Path(__file__).parent / "derivations"
GROUP = "polhode.derivations"


def own_derivations() -> list[str]:
    """Return the names of polhode's own derivations, sorted; none of them is imported."""
    return sorted(module.name.replace("_", "-") for module in pkgutil.iter_modules([str(HOME)]))


@cache
def _others() -> dict[str, Any]:
    return find_entry_points(GROUP, own_derivations())


def derivation_names() -> list[str]:
    """Return the names of all derivations, polhode's own first; none of them is imported."""
    return [*own_derivations(), *sorted(_others())]


def derive(name: str) -> Page:
    """Return a derivation as a page, after checking each of its steps.

    Args:
        name: such as "clebsch"; ``derivation_names`` lists them.

    Raises:
        InvalidInput: for an unknown name, and where the function of another package fails or does not return a page.
        DerivationBroken: if a step does not hold, by symbols or against the numerical system.

    >>> derive("clebsch").title
    "Clebsch's case"
    """
    if name in own_derivations():
        return import_module(f"{__package__}.derivations.{name.replace('-', '_')}").derive()
    if name not in _others():
        near = difflib.get_close_matches(str(name), derivation_names(), 1)
        hint = f"Did you mean {near[0]}?" if near else "Choose one of these."
        raise InvalidInput(f"a derivation must be one of {', '.join(derivation_names())}; got {shown(name)}. {hint}")
    point = _others()[name]
    function = load_entry_point(point)
    try:
        page = function() if callable(function) else function
    except PolhodeError:  # such as DerivationBroken
        raise
    except FAILURES as error:
        what = f"{type(error).__name__}: {one_line(str(error))}"
        raise InvalidInput(f"the derivation {name} of another package, {point.value}, fails ({what}). Update or "
                           "remove it.") from error
    if not isinstance(page, Page):
        raise InvalidInput(f"the derivation {name} of another package, {point.value}, must be a function that returns "
                           f"a Page; got {shown(page)}. Update or remove it.")
    return page


def describe_derivation(name: str) -> str:
    """Return a derivation's subject: the first line of its file's docstring, or of another package's function."""
    if name in _others():
        try:
            text = inspect.getdoc(load_entry_point(_others()[name])) or ""
        except InvalidInput as error:
            return str(error)
        return text.partition("\n")[0]
    text = (HOME / f"{name.replace('-', '_')}.py").read_text("utf-8")
    return text.split('"""')[1].split("\n")[0]
