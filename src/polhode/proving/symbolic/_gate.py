"""The one place where SymPy is imported: where it is missing, the message says how to get it."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from polhode._base.extras import needing

# without types: SymPy's own are partial, and wrong in places
with needing("Derivations and symbolic brackets need"):
    sympy: Any = import_module("sympy")
    mathml: Any = import_module("sympy.printing.mathml").mathml
    PrettyPrinter: Any = import_module("sympy.printing.pretty.pretty").PrettyPrinter

__all__ = ["PrettyPrinter", "mathml", "sympy"]
