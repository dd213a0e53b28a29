"""One of each algebra and system, for the tests of laws."""

import jax.numpy as jnp
import numpy as np

from polhode import algebra as lie
from polhode import fields, systems

SL2_MATRICES = np.array([[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]], float)
so3 = lie.SO3()
ALGEBRAS = [
    so3, lie.SE3(), lie.SO(2), lie.SO(3), lie.SO(4), lie.SO(5), lie.SO(6), lie.SU(2), lie.SU(3), lie.SU(4), lie.SL(2),
    lie.SL(3), lie.Sp(1), lie.Sp(2), lie.Heisenberg(1), lie.Heisenberg(3), lie.AffineLine(), lie.SE2(),
    fields.QuantizedSphere(4), lie.U(1), fields.Bidiagonal(3), lie.U(3), lie.SOpq(2, 1), lie.SOpq(3, 1), lie.SOpq(1, 4),
    lie.DualNumbers(lie.SU(2)),
    lie.Power(so3, 4), lie.Power(so3, (2, 1, 2)), lie.Power(so3, 3, (1.0, -2.0, 0.5)),
    lie.Power(lie.SU(2), (2, 2), ((1.0, -2.0), (0.5, 3.0))),
    lie.Power(lie.SU(3), 2), lie.Product(so3, lie.SU(2), lie.AffineLine()),
    lie.Semidirect(so3, so3.structure_constants().transpose(0, 2, 1)),
    lie.Semidirect(lie.SL(2), np.asarray(lie.SL(2).basis)),
    lie.from_structure_constants(lie.SL(3).structure_constants()), lie.from_matrices(SL2_MATRICES),
    lie.from_matrices(lie.SU(2).basis),
]  # fmt: skip


def spins(points):
    return -jnp.dot(points[0], points[1]) - 0.3 * points[0, 2] ** 2


def in_su3(point):
    return 0.5 * jnp.sum(lie.SU(3).to_dual_vector(point) ** 2 / jnp.arange(1.0, 9.0))


LATTICE = fields.Lattice([[1.0, 0.0], [0.5, 0.8]], [[0.0, 0.0], [0.5, 0.3]], shape=(3, 2), periodic=(True, False))
OPEN = fields.Lattice([[1.0, 0.0], [0.5, 0.8]], [[0.0, 0.0], [0.5, 0.3]], shape=(2, 2), periodic=False)
BONDS = [fields.Bond(0, 1, (0, 0), fields.exchange_matrix((1.0, 1.0, 0.6), (0.0, 0.0, 0.3))),
         fields.Bond(0, 0, (1, 0), -0.4)]  # fmt: skip
EASY = np.diag([0.0, 0.0, 0.2])

SYSTEMS = [
    systems.FreeRigidBody((1.0, 2.0, 3.0)),
    systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: 0.7 * up[2] + 0.1 * up[0] ** 2),
    systems.HeavyTop((1.0, 2.0, 3.0), 0.7, (1.0, 2.0, 0.5)),
    systems.HeavyTop((2.0, 1.0, 2.0), 0.7, (0.6, 0.0, -0.8)),
    systems.BrunBody((1.0, 2.0, 3.0), 0.7),
    systems.Gyrostat((1.0, 2.0, 3.0), (0.1, 0.2, 0.5), rotor_moment=0.2, free=True),
    systems.DoubleBracket((1.0, 2.0, 3.0), 0.3),
    systems.DoubleBracketDamping(systems.HeavyTop((1.0, 2.0, 3.0), 0.7, (1.0, 2.0, 0.5)), 0.3),
    systems.DoubleBracketDamping(systems.LiePoisson(lie.SU(3), in_su3, sign=1), 0.2, np.diag(np.arange(1.0, 9.0))),
    systems.Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0)),
    systems.Kirchhoff(np.diag([1.0, 2.0, 3.0, 2.0, 3.0, 5.0]) + 0.1),
    fields.SphereFluid(4, 0.7),
    fields.SphereMHD(3, 0.7),
    systems.Manakov((1.0, 2.0, 3.0)),
    systems.Manakov((1.0, 2.0, 3.0, 4.0)),
    systems.Manakov((1.0, 0.5, 3.0, 4.0, 2.0)),
    systems.LiePoisson(lie.Power(so3, 2), spins, {"Sz": lambda w: w[0, 2] + w[1, 2]}),
    systems.LiePoisson(lie.SU(3), in_su3),
    systems.LiePoisson(lie.SU(3), in_su3, sign=1),
    systems.LiePoisson(lie.Heisenberg(2), lambda m: 0.5 * jnp.sum(m[:4] ** 2) + m[0] ** 4),
    fields.SpinLattice(LATTICE, 1.0, BONDS, EASY, (0.0, 0.0, 0.3)),
    fields.SpinLattice(OPEN, 1.0, BONDS, EASY, (0.1, 0.0, 0.3), dipolar=0.1),
    fields.SpinLattice(OPEN, 1.0, BONDS, field=(0.1, 0.0, 0.3), damping=0.1),
    fields.SphereVortices((1.0, -0.7, 0.4)),
    fields.PlaneVortices((1.0, -0.7, 0.4, -1.0)),
    fields.VlasovPoisson(5.0, 3, 4),
    fields.Toda(4),
    systems.LiePoisson(lie.AffineLine(), lambda m: jnp.sum(m**2)),
]


def named(specimen):
    algebra = getattr(specimen, "algebra", specimen)
    return specimen.name if specimen in ALGEBRAS else f"{type(specimen).__name__} on {algebra.name}"
