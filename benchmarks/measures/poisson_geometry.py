"""Brackets and fields at many points of so(3)*, against a Poisson-geometry package"""

from __future__ import annotations

from collections.abc import Iterator

import jax
import jax.numpy as jnp
import numpy as np
from measure import Row, compared, missing

import polhode as ph

MOMENTS, PEER = (1.0, 2.0, 3.0), "numericalpoissongeometry"
BIVECTOR = {(1, 2): "-x3", (1, 3): "x2", (2, 3): "-x1"}
H, F = "x1**2/2 + x2**2/4 + x3**2/6", "x1*x2"


def rows(quick: bool) -> Iterator[Row]:
    """Yield the peer's time over ours, a point each; the peer is linear in points, and gets fewer."""
    many, few = (10_000, 50) if quick else (1_000_000, 2000)
    points = np.random.default_rng(0).normal(size=(many, 3))
    so3, a = ph.algebra.SO3(), jnp.asarray(MOMENTS)
    energy, other = (lambda L: 0.5 * jnp.sum(L * L / a)), (lambda L: L[0] * L[1])
    ours = {
        "bracket": jax.jit(ph.poisson.bracket(so3, energy, other)),
        "Hamiltonian field": jax.jit(ph.poisson.hamiltonian_field(so3, energy)),
        "Poisson tensor": jax.jit(lambda L: ph.poisson.poisson_tensor(so3, L)),
    }
    try:
        from numpoisson.numpoisson import NumPoissonGeometry
    except ImportError:
        yield from (missing(name, PEER, "pip install numericalpoissongeometry") for name in ours)
        return
    geometry, part = NumPoissonGeometry(3), points[:few]
    theirs = {
        "bracket": lambda: geometry.num_poisson_bracket(BIVECTOR, H, F, part),
        "Hamiltonian field": lambda: geometry.num_hamiltonian_vf(BIVECTOR, H, part),
        "Poisson tensor": lambda: geometry.num_bivector(BIVECTOR, part),
    }
    # in closed form: {H, F} for this F, and L × Ω
    L, W = part, part / np.array(MOMENTS)
    tensor = np.stack([np.cross(np.eye(3)[k], L) for k in range(3)], axis=-2)
    exact = {"bracket": np.sum(W * np.cross(np.stack([L[:, 1], L[:, 0], 0 * L[:, 0]], -1), L), -1),
             "Hamiltonian field": np.cross(L, W), "Poisson tensor": tensor}  # fmt: skip
    put = jnp.asarray(points)
    for name, function in ours.items():
        found = compared(lambda f=function: jax.block_until_ready(f(put)), theirs[name], 3, (1.0, few / many))
        both = (np.asarray(function(put))[:few], np.asarray(theirs[name](), dtype=float).reshape(exact[name].shape))
        # the sign of a bracket is a convention, one for each package and quantity
        errors = [min(float(np.abs(sign * x - exact[name]).max()) for sign in (1.0, -1.0)) for x in both]
        yield Row(f"{name}, {many:,} points", PEER, *errors, *found, f"the peer at {few:,}")
