"""From measured motion to the body: throws, attitudes over time, swings on a pendulum.

It answers which moments of inertia and principal axes explain a phone's gyro log, a recorded attitude or the periods
of a swinging body, each with its covariance, and says what the model leaves unexplained. Sources: Kane and Tseng (1967)
and Jardin and Mueller (2009) on pendulums, MacKay (1992) on unmodelled torques. From the core it takes free bodies
(``exact``), estimates (``estimation``) and tests of residuals (``special``).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
