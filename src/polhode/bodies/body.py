"""A rigid body as far as its rotation goes: mass, centre of mass and inertia."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput

Array = Any
ROUNDING = 64 * np.finfo(float).eps  # what the sums behind an inertia matrix may leave, relative to its largest entry


@dataclass(frozen=True, eq=False)
class Body:
    """Mass properties of one rigid body, as NumPy float64.

    Args:
        mass: [kg], or None where only the rotation matters.
        center_of_mass: (3,) [m, given axes].
        inertia: (3, 3) symmetric, about the centre of mass [kg m², given axes]; J = ∫ (|r|² 1 − r rᵀ) dm.

    The principal moments must satisfy the triangle inequality, I1 + I2 ≥ I3; flat bodies (equality) and thin rods
    (I1 = 0) are physical limits and accepted.

    Raises:
        InvalidInput: for values that no rigid body has, with what to check.

    >>> Body(2.0, (0, 0, 0), [[3.0, 0, 0], [0, 1.0, 0], [0, 0, 2.5]]).principal_moments
    array([1. , 2.5, 3. ])
    """

    mass: float | None
    center_of_mass: Array
    inertia: Array

    def __post_init__(self) -> None:
        mass = None if self.mass is None else _finite("mass", self.mass, ())
        center = _finite("center_of_mass", self.center_of_mass, (3,))
        inertia = _finite("inertia", self.inertia, (3, 3))
        if mass is not None and not mass > 0:
            raise InvalidInput(f"`mass` must be positive; got {float(mass):g} kg. Check sign and units.")
        scale = np.abs(inertia).max()
        if np.abs(inertia - inertia.T).max() > 1e-9 * scale:
            raise InvalidInput(f"`inertia` must be symmetric; got {inertia.tolist()}. Give J_ij = J_ji.")
        object.__setattr__(self, "mass", None if mass is None else float(mass))
        object.__setattr__(self, "center_of_mass", center)
        object.__setattr__(self, "inertia", 0.5 * (inertia + inertia.T))
        check_moments(self.principal_moments)

    @classmethod
    def from_moments(cls, I1: float, I2: float, I3: float, mass: float | None = None) -> Body:
        """Return the body whose inertia is diagonal in the given axes, in the given order [kg m²]."""
        return cls(mass, (0.0, 0.0, 0.0), np.diag(_finite("moments", (I1, I2, I3), (3,))))

    @cached_property
    def _principal(self) -> tuple[Array, Array]:
        return principal_axes(self.inertia)

    @property
    def principal_moments(self) -> Array:
        """(3,) moments about the centre of mass, ascending [kg m²]."""
        return self._principal[0]

    @property
    def principal_axes(self) -> Array:
        """(3, 3) right-handed rotation whose columns are the principal axes in the given frame.

        Deterministic: each axis points along its largest component, the third makes the frame right-handed; where
        moments coincide, the axes nearest to the given ones are taken.
        """
        return self._principal[1]

    def about(self, point: Array) -> Array:
        """Return the inertia (3, 3) about a point (3,) [m, given axes], by the parallel-axis theorem [kg m²].

        Raises:
            InvalidInput: if the body has no mass.
        """
        offset = self.center_of_mass - _finite("point", point, (3,))
        return self.inertia + self._known_mass("the inertia about another point") * point_inertia(offset)

    def placed(self, rotation_: Array, translation: Array = (0.0, 0.0, 0.0)) -> Body:
        """Return the body turned about the origin, then shifted.

        Args:
            rotation_: (4,) unit quaternion wxyz or (3, 3) rotation matrix.
            translation: (3,) [m].
        """
        value = np.asarray(rotation_, dtype=float)
        turn = rotation.as_matrix(rotation.normalize(value)) if value.shape == (4,) else value
        rotation.from_matrix(turn)
        center = turn @ self.center_of_mass + _finite("translation", translation, (3,))
        return Body(self.mass, center, turn @ self.inertia @ turn.T)

    def _known_mass(self, purpose: str) -> float:
        if self.mass is None:
            raise InvalidInput(f"{purpose} needs the body's mass; give `mass` when making it.")
        return self.mass


def combine(bodies: Sequence[Body]) -> Body:
    """Return several bodies as one rigid body, by the parallel-axis theorem.

    Raises:
        InvalidInput: for an empty list or a body without mass.
    """
    bodies = list(bodies)
    if not bodies:
        raise InvalidInput("`bodies` must name at least one body to combine; got none.")
    masses = np.array([body._known_mass("combining bodies") for body in bodies])
    centers = np.array([body.center_of_mass for body in bodies])
    center = masses @ (centers - centers[0]) / masses.sum() + centers[0]
    shifted = masses[:, None, None] * point_inertia(centers - center)
    inertia = np.sum([body.inertia for body in bodies], axis=0) + shifted.sum(axis=0)
    return Body(float(masses.sum()), center, inertia)


def point_inertia(offset: Array) -> Array:
    """Return |r|² 1 − r rᵀ (…, 3, 3), the inertia of a unit mass at r, its diagonal as sums of squares."""
    x, y, z = np.moveaxis(np.asarray(offset, dtype=float), -1, 0)
    rows = ((y * y + z * z, -x * y, -x * z), (-x * y, x * x + z * z, -y * z), (-x * z, -y * z, x * x + y * y))
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def check_moments(moments: Array) -> None:
    """Refuse moments (3,) ascending that no rigid body has.

    Raises:
        InvalidInput: if one is negative beyond rounding, all vanish, or I1 + I2 < I3 beyond rounding.
    """
    I1, I2, I3 = moments
    shown = ", ".join(f"{x:.6g}" for x in moments)
    if not I3 > 0:
        raise InvalidInput(f"`moments` must not all vanish; got ({shown}) kg m². A point has no attitude.")
    if I1 < -ROUNDING * I3:
        raise InvalidInput(
            f"`moments` must not be negative; got ({shown}) kg m². Check the signs of the products of inertia."
        )
    if I1 + I2 < I3 * (1.0 - ROUNDING):
        raise InvalidInput(
            f"`moments` must satisfy I1 + I2 ≥ I3; got ({shown}) kg m². No rigid body has these; check units and order."
        )


def principal_axes(inertia: Array) -> tuple[Array, Array]:
    """Return ascending moments (3,) and right-handed axes (3, 3), by columns, of a symmetric matrix."""
    scale = np.abs(inertia).max()
    off_diagonal = np.abs(inertia - np.diag(np.diag(inertia))).max()
    if off_diagonal == 0.0 or scale == 0.0:
        order = np.argsort(np.diag(inertia), kind="stable")
        moments, axes = np.diag(inertia)[order], np.eye(3)[:, order]
    else:
        moments, axes = np.linalg.eigh(inertia / scale)
        groups = _groups(moments)
        axes = np.column_stack([column for group in groups for column in _nearest_axes(axes[:, group])])
        moments = np.maximum(moments, 0.0) * scale if moments[0] > -ROUNDING else moments * scale
    leading = np.argmax(np.abs(axes) > (1.0 - 1e-9) * np.abs(axes).max(axis=0), axis=0)
    axes = axes * np.where(axes[leading, range(3)] < 0, -1.0, 1.0)
    if np.linalg.det(axes) < 0:
        axes[:, 2] = -axes[:, 2]
    return moments, axes + 0.0


def _groups(moments: Array) -> list[list[int]]:
    """Return the indices of ascending relative moments, those equal to rounding together."""
    groups = [[0]]
    for k in (1, 2):
        if moments[k] - moments[k - 1] <= ROUNDING:
            groups[-1].append(k)
        else:
            groups.append([k])
    return groups


def _nearest_axes(space: Array) -> list[Array]:
    """Return an orthonormal basis of the column space, each vector nearest to a given coordinate axis in turn."""
    basis: list[Array] = []
    if space.shape[1] == 1:
        return [space[:, 0]]
    projections = space @ space.T
    order = np.argsort(-np.round(np.diag(projections), 9), kind="stable")[: space.shape[1]]
    for k in sorted(order):
        vector = projections[:, k] - sum((b * (b @ projections[:, k]) for b in basis), np.zeros(3))
        basis.append(vector / np.linalg.norm(vector))
    return basis


def _finite(name: str, value: Any, shape: tuple[int, ...]) -> Array:
    try:
        array = np.array(value, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"`{name}` must be numbers of shape {shape}; got {value!r}.") from None
    if array.shape != shape:
        raise InvalidInput(f"`{name}` must have shape {shape}; got {array.shape}.")
    if not np.isfinite(array).all():
        raise InvalidInput(f"`{name}` must be finite; got {array.tolist()}. Check where the value comes from.")
    return array
