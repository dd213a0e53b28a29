"""Units of the pole's motion in reports and figures."""

import math

DAY, YEAR = 86_400.0, 365.25 * 86_400.0  # s
MAS = math.pi / 648_000_000.0  # rad
