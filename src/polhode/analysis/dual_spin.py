"""What losses in the two parts of a gyrostat do to its nutation, by the energy-sink method.

At a small nutation angle θ the axis of symmetry goes round L at λ₀ = h/A, with h the axial momentum and A the moment
across the axis. A part that spins at ω feels the transverse motion at λ = λ₀ − ω. If it loses the mean power D θ², its
axial momentum changes by the torque −Dθ²/λ; L is conserved, and A λ₀ θ̇/θ = −Σ D/λ. Losses in a part calm where it
spins slower than λ₀, and raise where it spins faster: with dampers on both parts of a dual-spin craft the sum decides,
the criterion of Landon and Iorillo.

Source: Landon & Stewart, J. Spacecraft 1 (1964) 682; Iorillo, ASME winter meeting (1965); Likins, J. Spacecraft 4
(1967) 1638; Hughes, *Spacecraft Attitude Dynamics*, §7.3.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.types import ArrayLike, Real

CALM, RAISE, NEITHER = "calm", "raise", "leave"


class DualSpinDamping(NamedTuple):
    """How losses in both parts of a dual-spin spacecraft change its nutation.

    Attributes:
        nutation_rate: λ₀ = h/A, at which the axis goes round the angular momentum [rad/s].
        felt_rates: λ₀ − ω of platform and rotor, at which each feels it [rad/s].
        effects: of losses in platform and rotor on nutation: "calm", "raise" or "leave".
        growth: θ̇/θ [1/s], negative where nutation dies away.
        time_constant: in which the angle changes by e [s], positive where nutation dies away, negative where it grows,
            infinite where it stays.
    """

    nutation_rate: float
    felt_rates: tuple[float, float]
    effects: tuple[str, str]
    growth: float
    time_constant: float

    @property
    def stable(self) -> bool:
        """Whether nutation dies away."""
        return self.growth < 0.0


@known_numbers_only
def dual_spin_damping(
    transverse: float, axial: Real[ArrayLike, "2"], spins: Real[ArrayLike, "2"], losses: Real[ArrayLike, "2"]
) -> DualSpinDamping:
    """Return how losses in platform and rotor change the nutation of a dual-spin spacecraft, both about one axis.

    Args:
        transverse: A, the moment of the whole across the axis, about the centre of mass [kg m²].
        axial: (2,) moments of platform and rotor about the axis [kg m²].
        spins: (2,) their rates about it, against the stars [rad/s].
        losses: (2,) mean power over the square of the nutation angle, in each [W/rad²], as ``damper_loss`` gives it.

    Raises:
        InvalidInput: for moments that are not positive, negative losses, no spin at all, or losses in a part that feels
            the nutation at rest, where no energy-sink method holds.

    >>> craft = dual_spin_damping(100.0, (60.0, 20.0), (0.0, 10.0), (0.2, 0.0))
    >>> craft.nutation_rate, craft.felt_rates, craft.effects, craft.time_constant
    (2.0, (2.0, -8.0), ('calm', 'raise'), 2000.0)
    """
    C, w, D = (np.asarray(x, dtype=float) for x in (axial, spins, losses))
    good = all(x.shape == (2,) and np.isfinite(x).all() for x in (C, w, D)) and 0.0 < transverse < math.inf
    if not (good and (C > 0.0).all() and (D >= 0.0).all()):
        raise InvalidInput(
            "the transverse moment must be positive, and `axial` two positive moments, `spins` two rates and `losses` "
            f"two powers that are not negative; got {shown((transverse, C.tolist(), w.tolist(), D.tolist()))}."
        )
    rate = float(C @ w) / transverse
    if rate == 0.0:
        raise InvalidInput("the axial momentum must not be zero, or nothing nutates. Give platform or rotor a spin.")
    felt = rate - w
    if wrong := [name for name, x, d in zip(("platform", "rotor"), felt, D, strict=True) if d and not x]:
        raise InvalidInput(
            f"the {wrong[0]} spins at the nutation's own rate, {rate:.6g} rad/s, and feels it at rest: the energy-sink "
            "method says nothing of its losses. Change its spin, or leave its losses out."
        )
    growth = -float(sum(d / x for d, x in zip(D, felt, strict=True) if d)) / (transverse * rate)
    # θ falls where λ/λ₀ > 0: the sense of L does not matter
    effects = [CALM if x * rate > 0.0 else RAISE if x * rate < 0.0 else NEITHER for x in felt]
    return DualSpinDamping(rate, (float(felt[0]), float(felt[1])), (effects[0], effects[1]), growth,
                           -1.0 / growth if growth else math.inf)
