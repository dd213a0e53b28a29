"""The rigid body with wheels, other mounts and torques, on an orbit and under control."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.spacecraft.rigid_body.table import RigidBodyTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from pydantic import BaseModel

    from polhode.kinds.base import Figures, Spec, SpecMotion
    from polhode.spacecraft.rigid_body.answers import RigidBodyReport
    from polhode.spacecraft.rigid_body.panel import RigidBodyPanel


class RigidBodyKind(AbstractKind[RigidBodyTable]):
    """The rigid body with wheels, other mounts and torques, on an orbit and under control."""

    name: ClassVar[str] = "rigid-body"
    table: ClassVar[type[SystemTable]] = RigidBodyTable
    figure_names: ClassVar[tuple[str, ...]] = ("rates", "pointing", "wheels")

    def model_of(self, raw: dict[str, Any]) -> type[BaseModel]:
        from polhode.spacecraft.rigid_body.table import model_of

        return model_of(raw)

    def settle(self, checked: Any) -> RigidBodyTable:
        from polhode.spacecraft.rigid_body.table import settle

        return settle(checked)

    def report(self, spec: Spec[RigidBodyTable]) -> RigidBodyReport:
        from polhode.spacecraft.rigid_body.answers import make_report

        return make_report(spec)

    def motion(self, spec: Spec[RigidBodyTable]) -> SpecMotion:
        from polhode.spacecraft.rigid_body.answers import simulate_motion

        return simulate_motion(spec)

    def figures(self) -> Figures:
        from polhode.spacecraft.rigid_body.figures import FIGURES

        return FIGURES

    def panel(self) -> RigidBodyPanel:
        from polhode.spacecraft.rigid_body.panel import RigidBodyPanel

        return RigidBodyPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spacecraft.rigid_body.rules import find_broken_rules

        return find_broken_rules(tables["system"])


KIND = RigidBodyKind()
