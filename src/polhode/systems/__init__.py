"""Systems that move: Hamiltonians on the duals of Lie algebras."""

from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.systems.body_in_potential import BodyInPotential
from polhode.systems.free_rigid_body import FreeRigidBody
from polhode.systems.kirchhoff import Kirchhoff
from polhode.systems.lie_poisson import LiePoisson
from polhode.systems.manakov import Manakov

__all__ = [
    "AbstractLiePoissonSystem",
    "AbstractSystem",
    "BodyInPotential",
    "FreeRigidBody",
    "Kirchhoff",
    "LiePoisson",
    "Manakov",
]
