"""Poisson geometry on the dual of a Lie algebra: brackets, orbits with their form, reduction and reconstruction."""

from polhode.poisson.brackets import bracket, differential, hamiltonian_field, poisson_tensor, time_derivative
from polhode.poisson.group_reconstruction import GroupPath, reconstruct_group
from polhode.poisson.orbits import (
    kks_form,
    kks_matrix,
    liouville_volume,
    orbit_dimension,
    orbit_tangent,
    restricted_bracket,
    symplectic_area,
)
from polhode.poisson.reconstruction import Reconstruction, reconstruct
from polhode.poisson.reduction import (
    body_momentum,
    left_trivialize,
    lifted_action,
    reduce,
    right_trivialize,
    space_momentum,
)

__all__ = [
    "GroupPath",
    "Reconstruction",
    "body_momentum",
    "bracket",
    "differential",
    "hamiltonian_field",
    "kks_form",
    "kks_matrix",
    "left_trivialize",
    "lifted_action",
    "liouville_volume",
    "orbit_dimension",
    "orbit_tangent",
    "poisson_tensor",
    "reconstruct",
    "reconstruct_group",
    "reduce",
    "restricted_bracket",
    "right_trivialize",
    "space_momentum",
    "symplectic_area",
    "time_derivative",
]


def __dir__() -> list[str]:
    return __all__
