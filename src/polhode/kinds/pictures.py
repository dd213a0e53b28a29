"""The names from other rooms that authors of panels for pages need, gathered for ``polhode.kinds``."""

from polhode.bodies.surface import Surface
from polhode.viewer.encoding import pack
from polhode.viewer.panels import PageContent, Panel
from polhode.viewer.samples import Samples

__all__ = ["PageContent", "Panel", "Samples", "Surface", "pack"]
