"""Checks of the laws that algebras and systems must obey, and hard motions by which to judge an engine."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
