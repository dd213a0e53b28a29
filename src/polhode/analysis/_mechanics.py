"""Energy and momentum of a free body, or of a body about a fixed point, along any attitude history."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.motion._invariants import drift
from polhode.types import Array, Float64


class Mechanics(NamedTuple):
    """The constants in the invariants of a body, free or turning about a fixed point under its weight.

    Attributes:
        inertia: (3, 3) about the point it turns about [kg m², body axes].
        weight: (3,) mgl χ, weight times the centre of mass from the fixed point [N m, body axes]; None for a free one.
    """

    inertia: Float64[Array, "3 3"]
    weight: Float64[Array, "3"] | None = None


def invariants_along(
    attitude: Float64[Array, "time 4"], velocity: Float64[Array, "time 3"], mechanics: Mechanics
) -> tuple[dict[str, Float64[Array, "..."]], dict[str, float]]:
    """Return the invariants and their drift, relative to the first value or to a top's own scales.

    Energy, |L| and L in space of a free body; energy and vertical momentum of a top.

    Args:
        attitude: (T, 4) unit quaternions wxyz, body → space.
        velocity: (T, 3) [rad/s, body axes].
        mechanics: along the same body axes.

    >>> still = np.array([[1.0, 0.0, 0.0, 0.0]])
    >>> values, _ = invariants_along(still, np.array([[0.0, 0.0, 2.0]]), Mechanics(np.diag([1.0, 2.0, 3.0])))
    >>> float(values["energy"][0]), float(values["momentum_norm"][0])
    (6.0, 6.0)
    """
    momentum = velocity @ np.asarray(mechanics.inertia)
    in_space = rotation.rotate(attitude, momentum)
    kinetic = 0.5 * np.sum(momentum * velocity, axis=-1)
    size = None
    if mechanics.weight is None:
        values = {"energy": kinetic, "momentum_norm": np.linalg.norm(momentum, axis=-1), "momentum_space": in_space}
    else:
        # mgl times the height of the centre of mass, the z of R (mgl χ)
        height = rotation.rotate(attitude, np.asarray(mechanics.weight))[..., 2]
        values = {"energy": kinetic + height, "vertical_momentum": in_space[..., 2]}
        # a top's energy and vertical momentum may be zero; what they are sums of is not
        size = np.stack([kinetic + np.linalg.norm(mechanics.weight), np.linalg.norm(momentum, axis=-1)]).max(axis=-1)
    drifts = {
        name: float(drift(np, value, name == "momentum_space", None if size is None else size[k : k + 1]))
        for k, (name, value) in enumerate(values.items())
    }
    return values, drifts
