"""Answers about motions and systems: verdicts with certificates, periods, precession, how motions differ and end."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
