"""Integrators that conserve what a Lie–Poisson system conserves, as diffrax solvers."""

from polhode.integrators._series import Taylor
from polhode.integrators.base import AbstractOrbitSolver
from polhode.integrators.isospectral_midpoint import IsospectralMidpoint
from polhode.integrators.lie_midpoint import LieMidpoint
from polhode.integrators.munthe_kaas import MuntheKaas
from polhode.integrators.spherical_midpoint import SphericalMidpoint
from polhode.integrators.splitting import Splitting
from polhode.integrators.sublattice_turns import SublatticeTurns
from polhode.integrators.thermal_noise import Bath, NoiseDriftNoise
from polhode.integrators.transport_noise import TransportNoise

__all__ = [
    "AbstractOrbitSolver",
    "Bath",
    "IsospectralMidpoint",
    "LieMidpoint",
    "MuntheKaas",
    "NoiseDriftNoise",
    "SphericalMidpoint",
    "Splitting",
    "SublatticeTurns",
    "Taylor",
    "TransportNoise",
]


def __dir__() -> list[str]:
    return __all__
