"""Lie algebras, their duals and the actions of their groups. Importing this room switches JAX to 64 bits."""

from polhode.algebra._precision import enable_double_precision

enable_double_precision()

from polhode.algebra.affine import AffineLine  # noqa: E402
from polhode.algebra.base import AbstractLieAlgebra  # noqa: E402
from polhode.algebra.bidiagonal import Bidiagonal  # noqa: E402
from polhode.algebra.casimirs import polynomial_casimirs  # noqa: E402
from polhode.algebra.constants import ConstantsAlgebra, from_matrices, from_structure_constants  # noqa: E402
from polhode.algebra.dual_numbers import DualNumbers  # noqa: E402
from polhode.algebra.heisenberg import Heisenberg  # noqa: E402
from polhode.algebra.matrix import SL, SO, SU, AbstractMatrixAlgebra, Sp  # noqa: E402
from polhode.algebra.power import Power  # noqa: E402
from polhode.algebra.product import Product  # noqa: E402
from polhode.algebra.properties import centre, index, killing_form  # noqa: E402
from polhode.algebra.pseudo_orthogonal import SOpq  # noqa: E402
from polhode.algebra.quantized_sphere import QuantizedSphere  # noqa: E402
from polhode.algebra.se2 import SE2  # noqa: E402
from polhode.algebra.se3 import SE3  # noqa: E402
from polhode.algebra.semidirect import Semidirect  # noqa: E402
from polhode.algebra.so3 import SO3  # noqa: E402
from polhode.algebra.unitary import U  # noqa: E402

__all__ = [
    "SE2",
    "SE3",
    "SL",
    "SO",
    "SO3",
    "SU",
    "AbstractLieAlgebra",
    "AbstractMatrixAlgebra",
    "AffineLine",
    "Bidiagonal",
    "ConstantsAlgebra",
    "DualNumbers",
    "Heisenberg",
    "Power",
    "Product",
    "QuantizedSphere",
    "SOpq",
    "Semidirect",
    "Sp",
    "U",
    "centre",
    "from_matrices",
    "from_structure_constants",
    "index",
    "killing_form",
    "polynomial_casimirs",
]


def __dir__() -> list[str]:
    return __all__
