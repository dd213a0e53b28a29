"""The mass properties of a rigid body: mass, centre of mass and inertia."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from polhode.arrays import as_float64, is_traced, known_numbers_only
from polhode.bodies.digits import judge_moments
from polhode.errors import InvalidInput, shown
from polhode.motion.frame import BodyFrame
from polhode.rotation import as_matrix, from_matrix, normalize
from polhode.types import Array, ArrayLike, Float64, Real

ROUNDING = 64 * np.finfo(float).eps  # what the sums behind an inertia matrix may leave, relative to its entries
MOST_DEFECT = 1.0 / 3.0  # of I3: more than vibration does to any molecule that stays in one shape
MOMENT_TIMES_CONSTANT = 6.62607015e-34 / (8.0 * math.pi**2)  # h/8π² [kg m² Hz], h exact by definition
SYMMETRY = 1e-9  # a matrix less symmetric than this was mistyped, not rounded
LARGEST = 1e150  # SI; beyond it products of two overflow, and no body is near
TIE = 1e-9  # direction cosines closer than this are equal, so that rounding never decides between two axes


@dataclass(frozen=True, eq=False)
class Body:
    """Mass properties of one rigid body, as read-only NumPy float64.

    Args:
        mass: [kg], or None where only the rotation matters.
        center_of_mass: (3,) [m, given axes].
        inertia: (3, 3) symmetric, about the centre of mass [kg m², given axes]; J = ∫ (|r|² 1 − r rᵀ) dm.
        effective: whether the moments were measured on a molecule that vibrates, and so need not be those of any rigid
            body: its rotational constants are averages, and I1 + I2 may fall short of I3 by up to a third of it.

    The principal moments must satisfy the triangle inequality, I1 + I2 ≥ I3; flat bodies (equality) and thin rods
    (I1 = 0) are physical limits and accepted. A rod is good as a part of other bodies; ``FreeMotion`` refuses it, as
    its spin about itself is undefined.

    JAX arrays of known value are converted. To differentiate, give moments straight to ``FreeMotion``: sorting the
    moments and choosing axes are decisions on numbers.

    Raises:
        InvalidInput: for values that no rigid body has, with what to check.

    >>> Body(2.0, (0, 0, 0), [[3.0, 0, 0], [0, 1.0, 0], [0, 0, 2.5]]).principal_moments
    array([1. , 2.5, 3. ])
    """

    mass: float | None
    center_of_mass: Real[ArrayLike, "3"]  # given so; kept as float64 arrays
    inertia: Real[ArrayLike, "3 3"]
    effective: bool = False

    def __post_init__(self) -> None:
        mass = None if self.mass is None else _finite("mass", self.mass, ())
        center = _finite("center_of_mass", self.center_of_mass, (3,))
        inertia = _finite("inertia", self.inertia, (3, 3))
        if mass is not None and not mass > 0:
            raise InvalidInput(f"`mass` must be positive; got {float(mass):g} kg. Check sign and units.")
        scale = np.abs(inertia).max()
        far = np.abs(center).max()
        if max(scale, mass or 0.0) > LARGEST or far > math.sqrt(LARGEST) or 0.0 < scale < 1.0 / LARGEST:
            raise InvalidInput(
                f"mass, inertia and squared distances must lie within 1e±150 in SI units; got {scale:.3g} kg m², "
                f"centre of mass at {far:.3g} m. No body is like that; check the units."
            )
        if np.abs(inertia - inertia.T).max() > SYMMETRY * scale:
            raise InvalidInput(f"`inertia` must be symmetric; got {inertia.tolist()}. Give J_ij = J_ji.")
        inertia = 0.5 * inertia + 0.5 * inertia.T
        center.flags.writeable = inertia.flags.writeable = False
        object.__setattr__(self, "mass", None if mass is None else float(mass))
        object.__setattr__(self, "center_of_mass", center)
        object.__setattr__(self, "inertia", inertia)
        check_moments(self.principal_moments, self.effective)

    @classmethod
    @known_numbers_only
    def from_moments(
        cls, I1: float, I2: float, I3: float, mass: float | None = None, *, effective: bool = False
    ) -> Body:
        """Return the body with inertia diag(I1, I2, I3) about its centre of mass, at the origin [kg m²].

        The axes stay as given; ``principal_moments`` is sorted, and ``principal_axes`` says which axis went where.

        >>> Body.from_moments(3.0, 1.0, 2.5).principal_moments
        array([1. , 2.5, 3. ])
        """
        return cls(mass, (0.0, 0.0, 0.0), np.diag(_finite("moments", (I1, I2, I3), (3,))), effective)

    @classmethod
    @known_numbers_only
    def from_rotational_constants(
        cls, A: float, B: float, C: float, mass: float | None = None, *, effective: bool = False
    ) -> Body:
        """Return the molecule with these rotational constants along its given axes: I = h/(8π² A), and so on.

        Args:
            A, B, C: as frequencies [Hz]; wave numbers times the speed of light. In any order.
            mass: [kg], or None.
            effective: whether they are averages over vibration, which need not be those of any rigid body.

        Raises:
            InvalidInput: for constants that are not positive, or that no rigid body has unless they are effective.

        >>> water = Body.from_rotational_constants(835.84e9, 435.35e9, 278.14e9, effective=True)
        >>> print((water.principal_moments / 1.66053906892e-47).round(3), f"{water.inertial_defect:.3g}")
        [0.605 1.161 1.817] 8.55e-49
        """
        constants = _finite("constants", (A, B, C), (3,))
        if not (constants > 0.0).all():
            raise InvalidInput(f"rotational constants must be positive; got {constants.tolist()} Hz. Check signs.")
        return cls(mass, (0.0, 0.0, 0.0), np.diag(MOMENT_TIMES_CONSTANT / constants), effective)

    @classmethod
    @known_numbers_only
    def from_inertia(cls, inertia: Real[ArrayLike, "3 3"], mass: float | None = None) -> Body:
        """Return the body with an inertia tensor (3, 3) about its centre of mass, at the origin [kg m²].

        >>> Body.from_inertia([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 2.5]]).principal_moments
        array([1. , 2.5, 3. ])
        """
        return cls(mass, (0.0, 0.0, 0.0), inertia)

    @cached_property
    def _principal(self) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"]]:
        moments, axes = principal_axes(self.inertia)
        moments.flags.writeable = axes.flags.writeable = False
        return moments, axes

    @property
    def principal_moments(self) -> Float64[Array, "3"]:
        """(3,) moments about the centre of mass, ascending [kg m²]; exact where the inertia is diagonal.

        Otherwise moments that differ by no more than the rounding of the inertia's entries come out equal, and those
        that do not rise above it as zero, so that a turned cylinder stays symmetric and a turned rod thin.
        """
        return self._principal[0]

    @property
    def principal_axes(self) -> Float64[Array, "3 3"]:
        """(3, 3) right-handed rotation whose columns are the principal axes in the given frame.

        Deterministic: each axis points along its largest component, the third makes the frame right-handed; where
        moments coincide, the axes nearest to the given ones are taken.
        """
        return self._principal[1]

    @property
    def inertial_defect(self) -> float:
        """I3 − I1 − I2 [kg m²]: zero of a flat body, negative of others, positive of effective moments alone."""
        I1, I2, I3 = (float(x) for x in self.principal_moments)
        defect = I3 - I1 - I2
        return 0.0 if abs(defect) <= ROUNDING * I3 else defect

    @property
    def frame(self) -> BodyFrame:
        """The principal axes at the centre of mass, and the mass properties that go with them."""
        return BodyFrame(self.principal_moments, self.principal_axes, self.center_of_mass, self.mass)

    def about(self, point: Real[ArrayLike, "3"]) -> Float64[Array, "3 3"]:
        """Return the inertia (3, 3) about a point (3,) [m, given axes], by the parallel-axis theorem [kg m²].

        Raises:
            InvalidInput: if the body has no mass, or the point is so far away that the inertia overflows.
        """
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
            offset = self.center_of_mass - _finite("point", point, (3,))
            inertia = self.inertia + self._require_mass("the inertia about another point") * point_inertia(offset)
        if not np.isfinite(inertia).all():
            raise InvalidInput(f"the inertia about `point` overflows; got {shown(point)} m. Check its unit.")
        return inertia

    def placed(
    self, rotation: ArrayLike = (1.0, 0.0, 0.0, 0.0), translation: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0)
) -> Body:
        """Return the body turned about the origin, then shifted: r → R r + d, J → R J Rᵀ.

        Args:
            rotation: (4,) unit quaternion wxyz, normalised here, (3, 3) rotation matrix, or a scipy Rotation.
            translation: (3,) [m].

        Raises:
            InvalidInput: for a matrix that is not a rotation.
        """
        if hasattr(rotation, "as_matrix"):
            rotation = rotation.as_matrix()
        if np.shape(rotation) == (4,):
            turn = as_matrix(normalize(_finite("rotation", rotation, (4,))))
        else:
            turn = _finite("rotation", rotation, (3, 3))
            from_matrix(turn)  # refuses reflections and matrices that are not orthogonal
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
            center = turn @ self.center_of_mass + _finite("translation", translation, (3,))
            return Body(self.mass, center, turn @ self.inertia @ turn.T, self.effective)

    def _require_mass(self, purpose: str) -> float:
        if self.mass is None:
            raise InvalidInput(f"{purpose} needs the body's mass; give `mass` when making it.")
        return self.mass


def check_is_body(body: Any) -> None:
    """Refuse what is not a ``Body``.

    Raises:
        InvalidInput: then.
    """
    if not isinstance(body, Body):
        raise InvalidInput(
            f"`body` must be a Body; got {shown(body)}. "
            "Make one with polhode.shapes, from_mesh or Body."
        )


def combine(bodies: Sequence[Body]) -> Body:
    """Return several bodies as one rigid body: J = Σ J_k + m_k (|d_k|² 1 − d_k d_kᵀ), d_k from the common centre.

    Raises:
        InvalidInput: for an empty list or a body without mass.
    """
    bodies = [bodies] if isinstance(bodies, Body) else list(bodies or [])
    if not bodies:
        raise InvalidInput("`bodies` must name at least one body to combine; got none.")
    if strange := [body for body in bodies if not isinstance(body, Body)]:
        raise InvalidInput(
            f"`bodies` must be Body objects; got {shown(strange[0])}. "
            "Make one with polhode.shapes or Body."
        )
    masses = np.array([body._require_mass("combining bodies") for body in bodies])
    centers = np.array([body.center_of_mass for body in bodies])
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
        center = masses @ (centers - centers[0]) / masses.sum() + centers[0]
        shifted = masses[:, None, None] * point_inertia(centers - center)
        inertia = np.sum([body.inertia for body in bodies], axis=0) + shifted.sum(axis=0)
        return Body(float(masses.sum()), center, inertia, any(body.effective for body in bodies))


def point_inertia(offset: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 3 3"]:
    """Return |r|² 1 − r rᵀ (…, 3, 3), the inertia of a unit mass at r, its diagonal as sums of squares."""
    x, y, z = np.moveaxis(np.asarray(offset, dtype=float), -1, 0)
    rows = ((y * y + z * z, -x * y, -x * z), (-x * y, x * x + z * z, -y * z), (-x * z, -y * z, x * x + y * y))
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def check_moments(moments: Float64[Array, "3"], effective: bool = False) -> None:
    """Refuse moments (3,) ascending that no rigid body has, or effective ones that no molecule has.

    Raises:
        InvalidInput: if one is negative beyond rounding, all vanish, or I1 + I2 < I3 beyond rounding, of effective ones
            by more than a third of I3.
    """
    I1, I2, I3 = moments
    shown = ", ".join(f"{x:.6g}" for x in moments)
    if not I3 > 0:
        raise InvalidInput(f"the principal moments must not all vanish; got ({shown}) kg m². A point has no attitude.")
    if I1 < -ROUNDING * I3:
        raise InvalidInput(
            f"the principal moments must not be negative; got ({shown}) kg m². "
            "Check signs and sizes of the products of inertia."
        )
    if I1 + I2 < I3 * (1.0 - (MOST_DEFECT if effective else ROUNDING)):
        rule, bodies = ("I1 + I2 ≥ 2/3 I3", "molecule") if effective else ("I1 + I2 ≥ I3", "rigid body")
        raise InvalidInput(
            f"the principal moments must satisfy {rule}; got ({shown}) kg m². No {bodies} has these; "
            "check units and order."
        )


def principal_axes(inertia: Float64[Array, "3 3"]) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"]]:
    """Return ascending moments (3,) and right-handed axes (3, 3), by columns, of a symmetric matrix."""
    diagonal = np.diag(inertia)
    if np.array_equal(inertia, np.diag(diagonal)):
        order = np.argsort(diagonal, kind="stable")
        moments, axes = diagonal[order], np.eye(3)[:, order]
        moments = np.where((moments < 0) & (moments > -ROUNDING * moments[2]), 0.0, moments)
    else:
        scale = 2.0 ** np.frexp(np.abs(inertia).max())[1]  # a power of two, so that scaling rounds nothing
        moments, axes = _jacobi(inertia / scale)
        # what relative rounding of the entries does to each moment: v · |J| v with |v|
        unsure = ROUNDING * np.einsum("ik,ij,jk->k", np.abs(axes), np.abs(inertia / scale), np.abs(axes))
        moments, groups = judge_moments(moments, unsure)
        columns = [axis for group in groups for axis in _nearest_axes(axes[:, group])]
        moments, axes = moments * scale, np.column_stack(columns)
    leading = [_first_largest(np.abs(axes[:, k])) for k in range(3)]
    axes = axes * np.where(axes[leading, range(3)] < 0, -1.0, 1.0)
    if np.linalg.det(axes) < 0:
        axes[:, 2] = -axes[:, 2]
    return moments, axes + 0.0


def _jacobi(matrix: Array) -> tuple[Array, Array]:
    """Return ascending eigenvalues and eigenvectors of a symmetric (3, 3) matrix by Jacobi's rotations.

    Unlike LAPACK's reduction to tridiagonal form it keeps the relative accuracy of small eigenvalues of a positive
    matrix that is nearly diagonal after scaling.

    Source: Rutishauser, Numer. Math. 9 (1966) 1; Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204.
    """
    a, v = np.array(matrix), np.eye(3)
    for _ in range(40):  # converges quadratically, in 4 to 6 sweeps
        if not a[[0, 0, 1], [1, 2, 2]].any():
            break
        for p, q in ((0, 1), (0, 2), (1, 2)):
            small = np.finfo(float).eps / 4 * np.sqrt(abs(a[p, p])) * np.sqrt(abs(a[q, q]))
            if abs(a[p, q]) <= max(small, np.finfo(float).tiny):
                a[p, q] = a[q, p] = 0.0
                continue
            theta = 0.5 * (a[q, q] - a[p, p]) / a[p, q]
            t = 1.0 / (theta + np.copysign(np.hypot(theta, 1.0), theta))
            c = 1.0 / np.hypot(t, 1.0)
            s, change, r = t * c, t * a[p, q], 3 - p - q
            a[p, p], a[q, q], a[p, q], a[q, p] = a[p, p] - change, a[q, q] + change, 0.0, 0.0
            a[p, r], a[q, r] = c * a[p, r] - s * a[q, r], s * a[p, r] + c * a[q, r]
            a[r, p], a[r, q] = a[p, r], a[q, r]
            v[:, p], v[:, q] = c * v[:, p] - s * v[:, q], s * v[:, p] + c * v[:, q]
    order = np.argsort(np.diag(a), kind="stable")
    return np.diag(a)[order], v[:, order]


def _nearest_axes(space: Array) -> list[Array]:
    """Return an orthonormal basis of the column space: the given axes nearest to it, projected in turn."""
    if space.shape[1] == 1:
        return [space[:, 0]]
    projections = space @ space.T
    nearness = np.diag(projections).copy()
    chosen: list[int] = []
    for _ in range(space.shape[1]):
        chosen.append(_first_largest(nearness))
        nearness[chosen[-1]] = -1.0
    basis: list[Array] = []
    for k in sorted(chosen):
        vector = projections[:, k] - sum((b * (b @ projections[:, k]) for b in basis), np.zeros(3))
        basis.append(vector / np.linalg.norm(vector))
    return basis


def _first_largest(values: Array) -> int:
    return int(np.flatnonzero(values > values.max() - TIE)[0])


def _finite(name: str, value: Any, shape: tuple[int, ...]) -> Array:
    """Return a float64 copy of the wanted shape, finite."""
    if is_traced(value):
        raise InvalidInput(f"`{name}` must be known numbers, not traced by JAX; give moments to FreeMotion instead.")
    array = np.array(as_float64(np, value, name))
    if array.shape != shape:
        raise InvalidInput(f"`{name}` must have shape {shape}; got {array.shape}.")
    if not np.isfinite(array).all():
        raise InvalidInput(f"`{name}` must be finite; got {shown(array.tolist())}. Check where the value comes from.")
    return array
