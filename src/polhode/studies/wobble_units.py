"""Units in which the pole's motion is told."""

import math

DAY, YEAR = 86_400.0, 365.25 * 86_400.0  # s
MAS = math.pi / 648_000_000.0  # rad
