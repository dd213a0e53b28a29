"""The angular momentum of a molecule at a temperature, by classical equipartition."""

from __future__ import annotations

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.types import Array, ArrayLike, Float64, Real

BOLTZMANN = 1.380649e-23  # J/K, exact by definition
REDUCED_PLANCK = 6.62607015e-34 / (2.0 * np.pi)  # J s, h exact by definition


@known_numbers_only
def thermal_momentum(
    moments: Real[ArrayLike, "*#batch 3"], temperature: Real[ArrayLike, "*#batch"]
) -> Float64[Array, "*batch 3"]:
    """Return √(k T I) along each principal axis (…, 3) [kg m²/s], the root mean square at a temperature.

    In classical equilibrium the components of L are independent and normal with variance k T I, so that each axis has
    ½ k T on average. The momentum with these components has the mean energy, 3/2 k T, exactly. An axis without
    moment has no momentum.

    Args:
        moments: (…, 3) principal moments [kg m²], not negative.
        temperature: (…) [K], positive.

    Raises:
        InvalidInput: for another temperature or moments.

    Source: Landau & Lifshitz, *Statistical Physics*, §44.

    >>> L = thermal_momentum((1e-47, 2e-47, 3e-47), 300.0)
    >>> print(f"{0.5 * np.sum(L**2 / (1e-47, 2e-47, 3e-47)) / (BOLTZMANN * 300.0):.12f}")
    1.500000000000
    """
    I = check.array("moments", moments, ("…", 3), "kg m²", least=0)  # noqa: E741
    T = check.array("temperature", temperature, None, "K", above=0)
    return np.sqrt(BOLTZMANN * T)[..., None] * np.sqrt(I)


@known_numbers_only
def rotational_temperature(moments: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 3"]:
    """Return ħ²/(2 I k) (…, 3) [K]; rotation is classical at temperatures far above all three.

    Args:
        moments: (…, 3) principal moments [kg m²], positive.

    Raises:
        InvalidInput: for other moments.

    >>> rotational_temperature((1.0e-47, 1.9e-47, 2.9e-47)).round(1).tolist()
    [40.3, 21.2, 13.9]
    """
    I = check.array("moments", moments, ("…", 3), "kg m²", above=0)  # noqa: E741
    return REDUCED_PLANCK / I * (0.5 * REDUCED_PLANCK / BOLTZMANN)
