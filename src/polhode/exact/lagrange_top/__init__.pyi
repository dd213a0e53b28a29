from .motion import LagrangeMotion as LagrangeMotion
