"""Bodies: mass, centre of mass and inertia, from shapes, points, atoms and meshes; and their surfaces."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
