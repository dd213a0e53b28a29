"""How does this thing rotate? Exact rigid-body motion and what it means."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from polhode import (
        algebra,
        analysis,
        errors,
        figures,
        formats,
        integrators,
        poisson,
        rotation,
        special,
        systems,
        testing,
        viewer,
    )
    from polhode.analysis.equilibria import find_equilibria
    from polhode.analysis.stability import stability
    from polhode.bodies import shapes
    from polhode.bodies.atoms import from_atoms
    from polhode.bodies.body import Body, combine
    from polhode.bodies.mesh import from_mesh
    from polhode.bodies.points import from_points
    from polhode.errors import FormatError, InvalidInput, NotConverged
    from polhode.exact.free_body import FreeMotion
    from polhode.exact.lagrange_top import LagrangeMotion
    from polhode.formats.dataset import as_dataset
    from polhode.simulation import simulate
    from polhode.trajectory import Trajectory

__version__ = "0.1.0"

_HOME = {
    "Body": "polhode.bodies.body",
    "as_dataset": "polhode.formats.dataset",
    "combine": "polhode.bodies.body",
    "from_atoms": "polhode.bodies.atoms",
    "from_mesh": "polhode.bodies.mesh",
    "from_points": "polhode.bodies.points",
    "FormatError": "polhode.errors",
    "FreeMotion": "polhode.exact.free_body",
    "InvalidInput": "polhode.errors",
    "LagrangeMotion": "polhode.exact.lagrange_top",
    "NotConverged": "polhode.errors",
    "Trajectory": "polhode.trajectory",
    "find_equilibria": "polhode.analysis.equilibria",
    "simulate": "polhode.simulation",
    "stability": "polhode.analysis.stability",
}
_ROOMS = {"shapes": "polhode.bodies.shapes"} | {
    room: f"polhode.{room}"
    for room in (
        "algebra", "analysis", "errors", "figures", "formats", "integrators", "poisson", "rotation", "special",
        "systems", "testing", "viewer",
    )
}
__all__ = [
    "Body",
    "FormatError",
    "FreeMotion",
    "InvalidInput",
    "LagrangeMotion",
    "NotConverged",
    "Trajectory",
    "algebra",
    "analysis",
    "as_dataset",
    "combine",
    "errors",
    "figures",
    "find_equilibria",
    "formats",
    "from_atoms",
    "from_mesh",
    "from_points",
    "integrators",
    "poisson",
    "rotation",
    "shapes",
    "simulate",
    "special",
    "stability",
    "systems",
    "testing",
    "viewer",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(_HOME[name]), name)
    if name in _ROOMS:
        return importlib.import_module(_ROOMS[name])
    raise AttributeError(f"module 'polhode' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
