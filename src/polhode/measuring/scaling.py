"""Turns fitted inertia ratios into absolute moments: by one moment that is known, or by a weight that was added."""

from __future__ import annotations

import re
from typing import NamedTuple

from polhode.errors import InvalidInput, shown
from polhode.estimation._estimate import Estimate
from polhode.measuring.attitudes.attitude_fit import AttitudeFit
from polhode.measuring.scale import moments_from_one, moments_from_weight
from polhode.measuring.throws.throw import ThrowFit
from polhode.spec.uncertain import quantity

_MOMENT = re.compile(r"\s*I([123])\s*=\s*(.+)")
_PLACE = re.compile(r"(.+?)\s+at\s+(.+?),(.+?),\s*(\S+)\s+(\S+)\s*")


class Weight(NamedTuple):
    """A weight on a body: both masses [kg], and its place from the body's centre of mass [m, device axes]."""

    mass: float
    weight: float
    place: tuple[float, float, float]


class KnownScale(NamedTuple):
    """The known scale of the moments: one of them (which, and its value [kg m²]), or an added weight."""

    moment: tuple[int, float] | None
    weight: Weight | None

    def moments(self, fit: ThrowFit | AttitudeFit, with_weight: ThrowFit | None) -> Estimate | None:
        """Return the three moments [kg m²]; None where scale or ratios are unknown."""
        if fit.degenerate is not None:
            return None
        if self.moment is not None:
            return moments_from_one(fit, *self.moment)
        if self.weight is None or with_weight is None:
            return None
        if with_weight.degenerate is not None:
            raise InvalidInput(f"the throws with the weight do not determine the inertia: {with_weight.degenerate}")
        return moments_from_weight(fit, with_weight, *self.weight)


def read_scale(moment: str | None, mass: str | None, added_weight: str | None, has_logs: bool) -> KnownScale:
    """Return the known scale of the moments.

    Args:
        moment: like "I3 = 1.2e-4 kg m^2".
        mass: of the body without the weight, like "150 g".
        added_weight: like "20 g at 0, 70, 0 mm".
        has_logs: whether there are logs of throws with the weight.

    Raises:
        InvalidInput: for what cannot be read, and for a weight of which something is missing.
    """
    parts = (mass, added_weight, has_logs)
    if any(parts) and not all(parts):
        names = "`mass`, `added_weight` and `weighted`"
        raise InvalidInput(f"{names} belong together: the body's mass, the weight with its place, and logs of throws "
                           "with it. Give all three.")
    if any(parts) and moment is not None:
        raise InvalidInput("`moment` and `added_weight` both give the moments. Leave one out.")
    if mass is None or added_weight is None:
        return KnownScale(None if moment is None else _moment(moment, "`moment`"), None)
    name, match = "`added_weight`", _PLACE.fullmatch(added_weight)
    if match is None:
        raise InvalidInput(f'{name} must be like "20 g at 0, 70, 0 mm"; got {shown(added_weight)}.')
    x, y, z = (quantity(name, f"{match[k].strip()} {match[5]}", "m", False) for k in (2, 3, 4))
    whole = quantity("`mass`", mass, "kg")
    return KnownScale(None, Weight(whole, quantity(name, match[1].strip(), "kg"), (x, y, z)))


def _moment(text: str, name: str) -> tuple[int, float]:
    match = _MOMENT.fullmatch(text)
    if match is None:
        raise InvalidInput(f'{name} must be like "I3 = 1.2e-4 kg m^2", the largest being I3; got {shown(text)}.')
    return int(match[1]), quantity(name, match[2].strip(), "kg*m^2")
