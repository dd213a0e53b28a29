"""Brackets, equations, integrals and stability in symbols, by SymPy (extra `symbolic`), and derivations as pages."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
