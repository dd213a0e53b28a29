"""The laws of dissipation in a spec of a rolling disk, each with its own key and unit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator, Field

from polhode.errors import shown
from polhode.spec.fields import Length, Viscosity, is_number, one_of
from polhode.spec.models import Strict
from polhode.spec.units import parse_quantity

if TYPE_CHECKING:
    from polhode.rolling.euler_disk.dissipation import RollingDissipation


class Law(NamedTuple):
    """How a spec writes a law.

    Attributes:
        key: the name of the law's constant.
        unit: of it, empty for a plain number.
        example: how a spec writes it.
    """

    key: str
    unit: str
    example: str


LAWS = {
    "air-layer": Law("viscosity", "Pa*s", '"1.8e-5 Pa*s"'),
    "boundary-layer": Law("coefficient", "W*s^2.5", '"2e-9 W*s^2.5"'),
    "viscous-contour-friction": Law("coefficient", "W*s^2", '"2e-8 W*s^2"'),
    "dry-contour-friction": Law("coefficient", "", "1e-4"),
    "rolling-couple": Law("arm", "m", '"20 um"'),
    "drilling-friction": Law("arm", "m", '"0.1 mm"'),
}
KEYS = ("viscosity", "coefficient", "arm")


def _coefficient(value: Any, info: Any) -> float:
    """Return the constant in the unit of its law, which pydantic has read before; unchecked where the law is wrong."""
    law = LAWS.get(info.data.get("law", ""))
    if law is None or law.key != "coefficient":
        return 0.0
    if law.unit:
        number = parse_quantity(value, law.unit)
    elif not is_number(value):
        raise ValueError(f"must be a plain finite number, without unit or quotes; got {shown(value)}")
    else:
        number = float(value)
    if not 0.0 < number < float("inf"):
        raise ValueError(f"must be positive; got {shown(value)}. Leave the law out where it is zero")
    return number


class LawTable(Strict):
    """One law, with exactly the key of its constant."""

    law: Annotated[
        Literal["air-layer", "boundary-layer", "viscous-contour-friction", "dry-contour-friction", "rolling-couple",
                "drilling-friction"], one_of(*LAWS)] = Field(description='give it like "air-layer"')
    viscosity: Viscosity | None = None
    coefficient: Annotated[float, BeforeValidator(_coefficient)] | None = None
    arm: Length | None = None

    def build(self) -> RollingDissipation:
        """Return the law."""
        from polhode.rolling.euler_disk.dissipation import LAWS as MODELS  # imports JAX, which reading a spec need not

        model: Any = next(model for model in MODELS if model.name == self.law)
        return model(getattr(self, LAWS[self.law].key))


def law_rules(law: dict[str, Any]) -> Iterator[str]:
    """Yield violations of rules by the keys of a raw law."""
    name = law.get("law")
    if not isinstance(name, str) or name not in LAWS:
        return
    wanted, _, example = LAWS[name]
    if wanted not in law:
        yield f"{name} needs {wanted}, like {example}"
    for key in KEYS:
        if key in law and key != wanted:
            yield f"{name} has no {key}; it takes {wanted}, like {example}"
