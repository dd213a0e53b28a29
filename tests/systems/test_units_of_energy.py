"""Energies are said in joules only where they are: of bodies, whose states are momenta in SI."""

import numpy as np
import pytest

from polhode import algebra
from polhode.fields import PlaneVortices, SphereFluid, SphereVortices, Toda, VlasovPoisson
from polhode.systems import DoubleBracketDamping, FreeRigidBody, Kirchhoff, LiePoisson

PLACES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))


@pytest.mark.parametrize(("system", "unit"), [
    (FreeRigidBody((1.0, 2.0, 3.0)), "J"),
    (Kirchhoff(np.eye(6)), "J"),
    (LiePoisson(algebra.SO3(), lambda L: L @ L), "J"),
    (DoubleBracketDamping(FreeRigidBody((1.0, 2.0, 3.0)), 0.1), "J"),
    (SphereFluid(5), "rad2 s-2"),
    (SphereVortices((1.0, -1.0)), "rad2 s-2"),
    (PlaneVortices((1.0, -1.0)), "m4 s-2"),
    (DoubleBracketDamping(SphereVortices((1.0, -1.0)), 0.1), "rad2 s-2"),
    (Toda(3), ""),
    (VlasovPoisson(12.0, particles=10, modes=2), ""),
    (LiePoisson(algebra.SL(2), lambda x: (x * x).sum()), ""),
], ids=lambda value: type(value).__name__ if not isinstance(value, str) else value)  # fmt: skip
def test_joules_are_of_bodies(system, unit):
    found = system.quantities.get("energy")
    assert (found.unit if found else "") == unit


@pytest.mark.long
def test_vortices_and_fluids_count_in_rates_squared():
    """Twice as strong, all goes twice as fast, and the energy is four times as much: (m²/s)² and (rad/s)²."""
    for make, places in ((PlaneVortices, np.array(PLACES)[:, :2]), (SphereVortices, np.array(PLACES))):
        one, two = (make(strengths) for strengths in ((1.0, 2.0), (2.0, 4.0)))
        points = [np.asarray(each.pack(places)) for each in (one, two)]
        energies = [float(each.energy(point)) for each, point in zip((one, two), points, strict=True)]
        rates = [np.asarray(each.vector_field(0.0, point)) for each, point in zip((one, two), points, strict=True)]
        assert energies[1] == pytest.approx(4.0 * energies[0], rel=1e-12)
        moved = [np.asarray(each.positions(point + 1e-6 * rate)) - np.asarray(each.positions(point))
                 for each, point, rate in zip((one, two), points, rates, strict=True)]  # fmt: skip
        assert moved[1] == pytest.approx(2.0 * moved[0], abs=1e-11)
