"""Bodies: mass, centre of mass and inertia, from shapes, points, atoms and meshes; and their surfaces."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
