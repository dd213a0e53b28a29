"""Symmetric compositions that raise the order of symmetric methods of order two.

Sources: Suzuki, Phys. Lett. A 146 (1990) 319 (order 4, five stages); Kahan & Li, Math. Comp. 66 (1997) 1089 (order 6,
nine stages, s9odr6a).
"""

from __future__ import annotations

import numpy as np

from polhode.errors import InvalidInput

_SUZUKI = 1.0 / (4.0 - 4.0 ** (1.0 / 3.0))
_KAHAN_LI = (0.39216144400731413928, 0.33259913678935943860, -0.70624617255763935981, 0.08221359629355080023)
STAGES: dict[int, tuple[float, ...]] = {
    2: (1.0,),
    4: (_SUZUKI, _SUZUKI, 1.0 - 4.0 * _SUZUKI, _SUZUKI, _SUZUKI),
    6: (*_KAHAN_LI, 1.0 - 2.0 * sum(_KAHAN_LI), *_KAHAN_LI[::-1]),
}


def stages(order: int) -> np.ndarray:
    """Return the fractions of a step that compose a method of the order.

    Raises:
        InvalidInput: for another order than 2, 4 or 6.
    """
    if order not in STAGES:
        raise InvalidInput(f"`order` of a composition must be 2, 4 or 6; got {order!r}.")
    return np.array(STAGES[order])


def stage_times(order: int) -> np.ndarray:
    """Return the fraction of the step at which each stage begins."""
    fractions = stages(order)
    return np.cumsum(fractions) - fractions
