"""What fits share: estimates with their covariance, last steps of least squares, tests of residuals."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
