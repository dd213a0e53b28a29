"""Systems that move: Hamiltonians on the duals of Lie algebras."""

from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.systems.body_in_potential import BodyInPotential
from polhode.systems.brun_body import BrunBody
from polhode.systems.double_bracket import DoubleBracket
from polhode.systems.free_rigid_body import FreeRigidBody
from polhode.systems.gyrostat import Gyrostat, TorquedGyrostat
from polhode.systems.heavy_top import HeavyTop
from polhode.systems.kirchhoff import Kirchhoff
from polhode.systems.lie_poisson import LiePoisson
from polhode.systems.manakov import Manakov

__all__ = [
    "AbstractLiePoissonSystem",
    "AbstractSystem",
    "BodyInPotential",
    "BrunBody",
    "DoubleBracket",
    "FreeRigidBody",
    "Gyrostat",
    "HeavyTop",
    "Kirchhoff",
    "LiePoisson",
    "Manakov",
    "TorquedGyrostat",
]
