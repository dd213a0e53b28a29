"""Systems that move: Hamiltonians on the duals of Lie algebras, bodies under torques, spins on orbits."""

from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem, Balance
from polhode.systems.body_in_potential import BodyInPotential
from polhode.systems.body_with_rotor import RotorInBody, rotor_in_body
from polhode.systems.brun_body import BrunBody
from polhode.systems.double_bracket import DoubleBracket
from polhode.systems.double_bracket_damping import DoubleBracketDamping
from polhode.systems.euler_disk import EulerDisk
from polhode.systems.free_rigid_body import FreeRigidBody
from polhode.systems.gyrostat import Gyrostat, TorquedGyrostat
from polhode.systems.heavy_top import HeavyTop
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.systems.kirchhoff import Kirchhoff
from polhode.systems.lattice import Bond, Lattice, exchange_matrix
from polhode.systems.lie_poisson import LiePoisson
from polhode.systems.manakov import Manakov
from polhode.systems.mounts import AbstractMount, EnergySink, HeldWheel, SphericalSlug, Wheel
from polhode.systems.point_vortices import PlaneVortices, SphereVortices
from polhode.systems.rigid_body import AbstractRigidBody, RigidBody
from polhode.systems.rolling_dissipation import (
    AirLayer,
    BoundaryLayer,
    DrillingFriction,
    DryContourFriction,
    RollingCouple,
    RollingDissipation,
    ViscousContourFriction,
)
from polhode.systems.sphere_fluid import SphereFluid
from polhode.systems.sphere_mhd import SphereMHD
from polhode.systems.spin_lattice import SpinLattice
from polhode.systems.spin_orbit import SpinOrbit
from polhode.systems.toda import Toda
from polhode.systems.torqued_body import TorquedBody
from polhode.systems.torques import AbstractTorque, GravityGradient, LaggedTorque, LinearDrag, QuadraticDrag
from polhode.systems.variations import Variations
from polhode.systems.vlasov_poisson import VlasovPoisson, quiet_start

__all__ = [
    "AbstractLiePoissonSystem",
    "AbstractMount",
    "AbstractRigidBody",
    "AbstractSystem",
    "AbstractTorque",
    "AirLayer",
    "Balance",
    "BodyInPotential",
    "Bond",
    "BoundaryLayer",
    "BrunBody",
    "DoubleBracket",
    "DoubleBracketDamping",
    "DrillingFriction",
    "DryContourFriction",
    "EnergySink",
    "EulerDisk",
    "FreeRigidBody",
    "GravityGradient",
    "Gyrostat",
    "HeavyTop",
    "HeldWheel",
    "KeplerOrbit",
    "Kirchhoff",
    "LaggedTorque",
    "Lattice",
    "LiePoisson",
    "LinearDrag",
    "Manakov",
    "PlaneVortices",
    "QuadraticDrag",
    "RigidBody",
    "RollingCouple",
    "RollingDissipation",
    "RotorInBody",
    "SphereFluid",
    "SphereMHD",
    "SphereVortices",
    "SphericalSlug",
    "SpinLattice",
    "SpinOrbit",
    "Toda",
    "TorquedBody",
    "TorquedGyrostat",
    "Variations",
    "ViscousContourFriction",
    "VlasovPoisson",
    "Wheel",
    "exchange_matrix",
    "quiet_start",
    "rotor_in_body",
]


def __dir__() -> list[str]:
    return __all__
