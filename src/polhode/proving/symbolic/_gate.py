"""The one place where SymPy is imported: where it is missing, the message says how to get it."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from polhode.errors import not_installed

# without types: SymPy's own are partial, and wrong in places
try:
    sympy: Any = import_module("sympy")
    mathml: Any = import_module("sympy.printing.mathml").mathml
    PrettyPrinter: Any = import_module("sympy.printing.pretty.pretty").PrettyPrinter
except ImportError:
    raise not_installed("Derivations and symbolic brackets", "sympy", "symbolic") from None

__all__ = ["PrettyPrinter", "mathml", "sympy"]
