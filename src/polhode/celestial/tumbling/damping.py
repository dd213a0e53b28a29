"""Shape and damping time of a tumbling asteroid, from its moments and its motion."""

from __future__ import annotations

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.types import ArrayLike, Float64, Real


@known_numbers_only
def equivalent_ellipsoid(moments: Real[ArrayLike, "3"]) -> Float64[np.ndarray, "3"]:
    """Return the semi-axes a ≥ b ≥ c, over a, of the uniform ellipsoid with given ratios of moments.

    Of an ellipsoid I1 = M (b² + c²)/5 and cyclically, so a² goes with I2 + I3 − I1.

    Args:
        moments: (3,) I1 ≤ I2 ≤ I3 in any unit.

    Raises:
        InvalidInput: if they are not positive and rising, or do not obey I1 + I2 > I3: then no solid body has them.

    Example:
        >>> equivalent_ellipsoid([0.61, 0.965, 1.0]).round(3).tolist()
        [1.0, 0.69, 0.651]
    """
    i1, i2, i3 = check.array("moments", moments, (3,), above=0, ascending=True).tolist()
    squares = np.array([i2 + i3 - i1, i3 + i1 - i2, i1 + i2 - i3])
    if not squares[2] > 1e-12 * i3:
        raise InvalidInput(f"`moments` must obey I1 + I2 > I3, as those of every solid body do; got {shown(moments)}.")
    return np.sqrt(squares / squares[0])


@known_numbers_only
def internal_damping_time(
    period: float, diameter: float, density: float = 2000.0, rigidity: float = 5e11, shape_factor: float = 0.03
) -> float:
    """Return the time in which internal friction turns tumbling into spin about the axis of greatest inertia [s].

    It is μQ/(ρ K₃² R² ω³) of Burns & Safronov (MNRAS 165, 403, 1973). The values assumed are those of Harris (Icarus
    107, 209, 1994), with which the time is P³/(17³ D²) thousand million years for P in hours and D in kilometres; they
    are uncertain by a factor of ten either way.

    Args:
        period: of the precession, or of the spin to which it leads [s].
        diameter: 2 R, mean [m].
        density: ρ [kg/m³].
        rigidity: μQ, the shear modulus times the quality factor [Pa].
        shape_factor: K₃², .01 for nearly round bodies to .1 for long ones.

    Raises:
        InvalidInput: if one of them is not positive and finite.

    Example:
        >>> year = 365.25 * 86400
        >>> round(internal_damping_time(27.38 * 3600, 340.0) / year / 1e9, 1)  # Apophis
        35.3
    """
    check.positive(
        period=period, diameter=diameter, density=density, rigidity=rigidity, shape_factor=shape_factor
    )
    rate = 2 * np.pi / period
    return float(rigidity / (density * shape_factor * (0.5 * diameter) ** 2 * rate**3))
