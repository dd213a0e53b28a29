"""Is another engine right: tables of hard motions, and verdicts on what an engine computed of them.

It answers of which order a physics engine's method is, what its energy and momentum do, and which known mistake
explains its errors, from its states in a file or from its step in Python. The motions are those of free bodies, exact
to rounding. From the core it takes closed forms; from the application reports and figures.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
