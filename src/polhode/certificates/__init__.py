"""Certificates of stability as exact data: found, checked, and written for a prover."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
