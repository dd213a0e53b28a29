"""The course: exercises with answers that polhode computes, worksheets, and where the built course is."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
