from ._series import Taylor as Taylor
from .base import AbstractOrbitSolver as AbstractOrbitSolver
from .isospectral_midpoint import IsospectralMidpoint as IsospectralMidpoint
from .lie_midpoint import LieMidpoint as LieMidpoint
from .munthe_kaas import MuntheKaas as MuntheKaas
from .spherical_midpoint import SphericalMidpoint as SphericalMidpoint
from .splitting import Splitting as Splitting
