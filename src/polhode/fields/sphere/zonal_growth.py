"""Growth of waves on zonal flows and fields, by linear theory."""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.fields.sphere.fluid import SphereFluid
from polhode.fields.sphere.mhd import SphereMHD
from polhode.types import Array, ArrayLike, Complex128, Real


class ZonalGrowth(NamedTuple):
    """How fast the quickest wave of one order grows.

    Attributes:
        rate: [rad/s] of growth; 0 to rounding where all waves keep their size.
        frequency: [rad/s] at which it goes round eastward, times its order.
    """

    rate: float
    frequency: float


@known_numbers_only
def zonal_growth(system: SphereFluid | SphereMHD, state: Real[ArrayLike, "..."], order: int) -> ZonalGrowth:
    """Return the fastest growth of waves of an order m on the zonal part of a state.

    That part is a steady motion; linearised about it, each diagonal of the matrices moves by itself, ẋ = A x with N − m
    entries, twice as many with a magnetic field. Growing modes out of a continuous spectrum converge as 1/N².

    Args:
        system: fluid on a sphere, with or without a magnetic field.
        state: (N, N), or (2, N, N) with a field, of which only the diagonals count.
        order: m, 1 ≤ m < N.

    Raises:
        InvalidInput: for another system, or an order outside.

    >>> import math
    >>> fluid = SphereFluid(16)
    >>> jet = fluid.from_harmonics({(3, 0): math.sqrt(4.0 * math.pi)})           # √7 P₃ of the sine of latitude
    >>> round(zonal_growth(fluid, jet, 2).rate, 3)
    0.261

    Source: Baines, J. Fluid Mech. 73 (1976) 193; Gilman & Fox, Astrophys. J. 484 (1997) 439.
    """
    check.instance("system", system, (SphereFluid, SphereMHD), "a SphereFluid or a SphereMHD")
    order = check.whole("order", order, 1, system.size - 1)
    state = jnp.asarray(system.check_state(state))
    rates = np.linalg.eigvals(np.asarray(_matrix(system, state * jnp.eye(system.size), order)))
    fastest = rates[np.argmax(rates.real)]
    return ZonalGrowth(float(fastest.real), float(-fastest.imag))


@eqx.filter_jit
def _matrix(system: SphereFluid | SphereMHD, state: Complex128[Array, "..."], order: int) -> Complex128[Array, "k k"]:
    """Return A of the entries below the diagonal by ``order``."""
    n = system.size
    rows = np.arange(n - order)
    parts = 1 if isinstance(system, SphereFluid) else 2
    shape = (parts, n, n)

    def column(part: Array, k: Array) -> Array:
        # a disturbance of one diagonal, with what makes it antihermitian
        entry = jnp.zeros(shape, complex).at[part, k + order, k].set(1.0)
        entry = (entry - jnp.conj(jnp.swapaxes(entry, -1, -2))).reshape(state.shape)
        moved = jax.jvp(lambda z: system.vector_field(0.0, z), (state,), (entry,))[1]
        return moved.reshape(shape)[:, rows + order, rows].ravel()

    return jax.vmap(column)(np.repeat(np.arange(parts), n - order), np.tile(rows, parts)).T
