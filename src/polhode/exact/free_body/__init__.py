"""The free rigid body in closed form."""

from polhode.exact.free_body.motion import FreeMotion

__all__ = ["FreeMotion"]
