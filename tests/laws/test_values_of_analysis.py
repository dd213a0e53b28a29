"""Functions of analysis and ``solve``, which take traced numbers, alone under jit, vmap, jvp and grad."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import rolling, systems
from polhode.analysis import poinsot
from transformed import check_alone

RNG = np.random.default_rng(8)
DISK = rolling.EulerDisk(0.4, 0.04, 0.01, dissipation=[rolling.AirLayer(1.8e-4)])
BODY = systems.FreeRigidBody((1.0, 2.0, 3.0))
VECTORS = RNG.normal(size=(3, 3))
STATES = np.array([0.4, 0.3, 0.2, 0.01, 0.02, 0.1, 6.0, 1.0]) * (1.0 + 0.1 * RNG.uniform(size=(3, 8)))
VALUES = {
    "contact_point": (lambda velocity: poinsot.contact_point(velocity, 0.7), VECTORS),
    "touching_point": (poinsot.touching_point, VECTORS, np.abs(VECTORS) + 0.5),
    "ellipsoid_semi_axes": (poinsot.ellipsoid_semi_axes, np.abs(VECTORS) + 0.5),
    "solve": (lambda state: ph.solve(BODY, state, (0.0, 0.15, 0.3), step=0.1, order=2).saved, VECTORS),
    "adiabaticity": (lambda state: jnp.asarray(rolling.adiabaticity(DISK, state)), STATES),
}


@pytest.mark.long_cases("solve")
@pytest.mark.parametrize("name", [pytest.param(n, marks=[] if n in ("contact_point", "solve") else [pytest.mark.sweep])
                                  for n in VALUES])  # fmt: skip
def test_value_alone(name):
    function, *points = VALUES[name]
    check_alone(function, *points, batched=False)
