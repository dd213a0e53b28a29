"""What makes moments of the ratios that throws tell: one that is known, or a weight that was added."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

from polhode.errors import InvalidInput, shown
from polhode.estimation.attitude_fit import AttitudeFit
from polhode.estimation.estimate import Estimate
from polhode.estimation.scale import moments_from_one, moments_from_weight
from polhode.estimation.throw import ThrowFit
from polhode.spec.uncertain import quantity

_MOMENT = re.compile(r"\s*I([123])\s*=\s*(.+)")
_PLACE = re.compile(r"(.+?)\s+at\s+(.+?),(.+?),\s*(\S+)\s+(\S+)\s*")


class ScaleOptions(NamedTuple):
    """The options as they are given; None and empty where they are not."""

    moment: str | None = None
    mass: str | None = None
    added_weight: str | None = None
    weighted: list[Path] = []  # noqa: RUF012


class Weight(NamedTuple):
    """A weight on a body: both masses [kg], and its place from the body's centre of mass [m, device axes]."""

    mass: float
    weight: float
    place: tuple[float, float, float]


class KnownScale(NamedTuple):
    """What is known beside the ratios: a moment (which, and how large in kg m²), or a weight."""

    moment: tuple[int, float] | None
    weight: Weight | None

    def moments(self, fit: ThrowFit | AttitudeFit, with_weight: ThrowFit | None) -> Estimate | None:
        """Return the three moments [kg m²]; None where nothing is known, or the ratios are not."""
        if fit.degenerate is not None:
            return None
        if self.moment is not None:
            return moments_from_one(fit, *self.moment)
        if self.weight is None or with_weight is None:
            return None
        if with_weight.degenerate is not None:
            raise InvalidInput(f"the throws with the weight tell no inertia: {with_weight.degenerate}")
        return moments_from_weight(fit, with_weight, *self.weight)


def scale_of(options: ScaleOptions) -> KnownScale:
    """Return what is known.

    Raises:
        InvalidInput: for what cannot be read, and for a weight of which something is missing.
    """
    parts = (options.mass, options.added_weight, options.weighted or None)
    if any(parts) and not all(parts):
        raise InvalidInput("--mass, --added-weight and --weighted belong together: the body's mass, the weight with "
                           "its place, and logs of throws with it. Give all three.")  # fmt: skip
    if any(parts) and options.moment is not None:
        raise InvalidInput("--moment and --added-weight both tell the moments. Leave one out.")
    moment = None if options.moment is None else _moment(options.moment)
    if options.mass is None or options.added_weight is None:
        return KnownScale(moment, None)
    found = _PLACE.fullmatch(options.added_weight)
    if found is None:
        raise InvalidInput(f'--added-weight must be like "20 g at 0, 70, 0 mm"; got {shown(options.added_weight)}.')
    x, y, z = (quantity("--added-weight", f"{found[k].strip()} {found[5]}", "m", False) for k in (2, 3, 4))
    mass = quantity("--mass", options.mass, "kg")
    return KnownScale(None, Weight(mass, quantity("--added-weight", found[1].strip(), "kg"), (x, y, z)))


def _moment(text: str) -> tuple[int, float]:
    found = _MOMENT.fullmatch(text)
    if found is None:
        raise InvalidInput(f'--moment must be like "I3 = 1.2e-4 kg m^2", the largest being I3; got {shown(text)}.')
    return int(found[1]), quantity("--moment", found[2].strip(), "kg*m^2")
