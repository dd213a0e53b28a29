"""Refuses systems that do not move by their energy alone, which no verdict on equilibria is for."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.jaxprs import depends_on
from polhode.analysis._conserved import Energy, differentiate
from polhode.errors import InvalidInput
from polhode.systems._agreement import moves_by_generator
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Float64


class MotionLimits(NamedTuple):
    """What decides that a generator is that of the energy."""

    generator_error: float = 1e-9  # of the generator against dH, relative: both are right to rounding


LIMITS = MotionLimits()


def check_motion(system: AbstractLiePoissonSystem, samples: Callable[[], Float64[Array, "m n"]]) -> None:
    """Refuse a system that does not move by its energy alone, or where energy is lost by a generator without time.

    Systems of this package are taken to do so, as their tests check.

    Args:
        system: any.
        samples: () → (m, n) coordinates of points, which systems of this package do not need.

    Raises:
        InvalidInput: naming what is overridden.
    """
    kind, base = type(system), AbstractLiePoissonSystem
    if not moves_by_generator(system):
        raise InvalidInput(
            f"{kind.__name__} overrides `vector_field`, so it need not move as its energy says. "
            "Override `generator(t, point)` instead."
        )
    if kind.__module__.partition(".")[0] == "polhode" or (kind.generator is base.generator
                                                          and kind.velocity is base.velocity):
        return
    algebra, around = system.algebra, samples()
    points = algebra.from_dual_vector(jnp.asarray(around))
    # read off the operations, which misses nothing as samples of times could
    if depends_on(jax.make_jaxpr(system.generator)(jnp.zeros(()), points[0]), 0):
        raise InvalidInput(
            f"the `generator` of {kind.__name__} depends on time, and a verdict needs equations of motion without it. "
            "Leave the drive out, or put it in as a constant."
        )
    moved = np.asarray(algebra.to_vector(system.generator(0.0, points)))
    wanted = moved
    if system.conserves_energy:
        gradients, _ = differentiate(Energy(system), around, around[:1])
        wanted = -system.sign * np.asarray(gradients)[:, 0]
    good = np.isfinite(wanted).all(axis=1)
    off = np.abs(moved - wanted)[good].max(initial=0.0) / (np.abs(wanted[good]).max(initial=0.0) or 1.0)
    if off > LIMITS.generator_error:
        raise InvalidInput(
            f"{kind.__name__} does not move by its energy alone: its `generator` differs from dH by {off:.2g}. "
            "Where energy is lost, let `conserves_energy` be False."
        )
