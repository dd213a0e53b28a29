"""What fits share: estimates with their covariance, last steps of least squares, tests of residuals."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
