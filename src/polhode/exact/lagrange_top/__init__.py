"""The Lagrange top in closed form."""

from polhode.exact.lagrange_top.motion import LagrangeMotion

__all__ = ["LagrangeMotion"]
