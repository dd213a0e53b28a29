"""The mass properties of a rigid body: mass, centre of mass and inertia."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.bodies._inertia import (
    LIMITS,
    ROUNDING,
    MassProperties,
    check_moments,
    finite_array,
    nearest_physical,
    point_inertia,
    principal_axes,
    take_rounded,
)
from polhode.errors import InvalidInput, shown
from polhode.motion.frame import BodyFrame
from polhode.rotation import as_matrix, from_matrix, normalize
from polhode.types import Array, ArrayLike, Float64, Real

MOMENT_TIMES_CONSTANT = 6.62607015e-34 / (8.0 * math.pi**2)  # h/8π² [kg m² Hz], h exact by definition


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
        mass = self.mass
        if mass is not None:
            mass = check.number("mass", mass, "kg", above=0, remedy="Check sign and units.")
        center = finite_array("center_of_mass", self.center_of_mass, (3,))
        inertia = finite_array("inertia", self.inertia, (3, 3))
        scale = np.abs(inertia).max()
        far = np.abs(center).max()
        largest = LIMITS.largest
        if max(scale, mass or 0.0) > largest or far > math.sqrt(largest) or 0.0 < scale < 1.0 / largest:
            raise InvalidInput(
                f"mass, inertia and squared distances must lie within 1e±150 in SI units; got {scale:.3g} kg m², "
                f"centre of mass at {far:.3g} m. No body is like that; check the units."
            )
        if np.abs(inertia - inertia.T).max() > LIMITS.max_asymmetry * scale:
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
        cls, moments: Real[ArrayLike, "3"], mass: float | None = None, *, effective: bool = False
    ) -> Body:
        """Return the body with inertia diag(I1, I2, I3) about its centre of mass, at the origin [kg m²].

        The axes stay as given; ``moments`` of the body are sorted, and ``principal_axes`` says which axis went where.

        Args:
            moments: (3,) I1, I2, I3 about the given axes [kg m²], in any order, as ``FreeMotion`` takes them.
            mass: [kg], or None.
            effective: whether they are averages over vibration, which need not be those of any rigid body.

        Raises:
            InvalidInput: for moments that no rigid body has, unless they are effective.

        >>> Body.from_moments((3.0, 1.0, 2.5)).moments
        array([1. , 2.5, 3. ])
        """
        return cls(mass, (0.0, 0.0, 0.0), np.diag(finite_array("moments", moments, (3,))), effective)

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
        constants = check.array("the rotational constants", (A, B, C), (3,), "Hz", above=0, remedy="Check signs.")
        return cls(mass, (0.0, 0.0, 0.0), np.diag(MOMENT_TIMES_CONSTANT / constants), effective)

    @classmethod
    @known_numbers_only
    def from_inertia(
        cls, inertia: Real[ArrayLike, "3 3"], mass: float | None = None, *, digits: int | None = None
    ) -> Body:
        """Return the body with an inertia tensor (3, 3) about its centre of mass, at the origin [kg m²].

        Args:
            inertia: symmetric.
            mass: [kg], or None.
            digits: significant digits of the entries, where they were rounded: a tensor that no body has for that
                reason alone is replaced by the nearest one, in Frobenius' norm, that a body can have.

        Raises:
            InvalidInput: for a tensor that no rigid body has, which rounding to so many digits does not explain.

        >>> Body.from_inertia([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 2.5]]).principal_moments
        array([1. , 2.5, 3. ])
        """
        if digits is not None:
            inertia = finite_array("inertia", inertia, (3, 3))
            if np.array_equal(inertia, inertia.T):  # others are refused as they are
                inertia = take_rounded(inertia, digits)
        return cls(mass, (0.0, 0.0, 0.0), inertia)

    @classmethod
    @known_numbers_only
    def from_points(cls, masses: Real[ArrayLike, "n"], positions: Real[ArrayLike, "n 3"]) -> Body:
        """Return point masses as one rigid body: J = Σ m (|r|² 1 − r rᵀ), r from the centre of mass.

        Args:
            masses: (n,) [kg], positive.
            positions: (n, 3) [m].

        Raises:
            InvalidInput: for shapes that do not match, masses that are not positive, or points all in one place.

        >>> Body.from_points([1.0, 1.0], [[-1, 0, 0], [1, 0, 0]]).principal_moments
        array([0., 2., 2.])
        """
        from polhode.bodies._points import mass_properties

        return cls(*mass_properties(masses, positions))

    @classmethod
    @known_numbers_only
    def from_atoms(
        cls, symbols: Sequence[str], positions: Real[ArrayLike, "n 3"], masses: Real[ArrayLike, "n"] | None = None
    ) -> Body:
        """Return a molecule as a rigid body of point masses, from which its rotational constants follow.

        Masses are standard atomic weights, averaged over isotopes; a spectroscopist gives the isotopes' masses instead.
        The rotational constants of an equilibrium geometry are not those of the vibrational ground state.

        Positions with 3 to 8 decimals in ångström are taken as rounded to these, as programs print them. Moments that
        differ by less than this rounding are set equal, and a moment smaller than it is set to zero, so that linear
        molecules stay linear and symmetric tops symmetric, in any orientation.

        Args:
            symbols: (n,) chemical symbols.
            positions: (n, 3) [m].
            masses: (n,) [kg], or None for the table's; multiples of ``ATOMIC_MASS_UNIT`` for isotopes.

        Raises:
            InvalidInput: for unknown symbols, atoms at one place, or arrays that do not match.
        """
        from polhode.bodies.atoms import mass_properties

        return cls(*mass_properties(symbols, positions, masses))

    @classmethod
    @known_numbers_only
    def from_mesh(
        cls, vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], *, mass: float | None = None,
        density: float | None = None, several: bool = False, repair: bool = False,
    ) -> Body:
        """Return the homogeneous body inside a closed triangle mesh: J = ρ ∫ (|r|² 1 − r rᵀ) dV about the centroid.

        Args:
            vertices: (n, 3) corners [m].
            faces: (m, 3) indices of corners, counterclockwise from outside. A closed surface that faces inward and
                lies inside another one is a cavity.
            mass: [kg]; this or ``density``.
            density: [kg/m³].
            several: accept disjoint bodies, touching or not, as one rigid body.
            repair: first orient the faces (bodies outward, surfaces inside them inward, as cavities) and drop
                triangles with repeated corners. Only on request, as this guesses. Holes are not filled; to fill them,
                read the mesh from a file with repair.

        Raises:
            InvalidInput: if the mesh is open, wound inconsistently, inverted, overlapping, or of several bodies; if not
                exactly one of mass and density is given, positive.

        >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        >>> Body.from_mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], density=6.0).mass
        1.0

        Source: Tonon, J. Math. Stat. 1 (2004) 8 (signed tetrahedra); Mirtich, J. Graphics Tools 1 (1996) 31.
        """
        from polhode.bodies._mesh import mass_properties

        return cls(*mass_properties(vertices, faces, mass=mass, density=density, several=several, repair=repair))

    @classmethod
    @known_numbers_only
    def from_sheet(
        cls, vertices: Real[ArrayLike, "n 3"], faces: Real[ArrayLike, "m 3"], *, mass: float | None = None,
        density: float | None = None, thickness: float | None = None,
    ) -> Body:
        """Return a thin sheet along a triangle mesh, open or closed: its mass lies on the triangles, evenly.

        A wall of finite thickness differs by the square of thickness over size.

        Args:
            vertices: (n, 3) corners [m].
            faces: (m, 3) indices of corners, either way round; triangles that are there twice count twice.
            mass: [kg]; this, or ``density`` and ``thickness``.
            density: [kg/m³].
            thickness: [m].

        Raises:
            InvalidInput: for a mesh without area, or if not exactly one of mass and density is given.

        >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        >>> Body.from_sheet(square, [[0, 1, 2], [0, 2, 3]], mass=12.0).principal_moments
        array([1., 1., 2.])
        """
        from polhode.bodies._mesh import sheet_properties

        return cls(*sheet_properties(vertices, faces, mass=mass, density=density, thickness=thickness))

    @cached_property
    def _principal(self) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"]]:
        moments, axes = principal_axes(self.inertia)
        moments.flags.writeable = axes.flags.writeable = False
        return moments, axes

    @property
    def principal_moments(self) -> Float64[Array, "3"]:
        """(3,) moments about the centre of mass, ascending [kg m²]; exact where the inertia is diagonal.

        Otherwise moments that differ by no more than the rounding of the inertia's entries come out equal, and those
        that do not rise above it as zero, so that a rotated cylinder stays symmetric and a rotated rod thin.
        """
        return self._principal[0]

    @property
    def moments(self) -> Float64[Array, "3"]:
        """(3,) ``principal_moments`` [kg m²] by the name that motions and systems take them by."""
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
            offset = self.center_of_mass - finite_array("point", point, (3,))
            inertia = self.inertia + self._require_mass("the inertia about another point") * point_inertia(offset)
        if not np.isfinite(inertia).all():
            raise InvalidInput(f"the inertia about `point` overflows; got {shown(point)} m. Check its unit.")
        return inertia

    def placed(
    self, rotation: ArrayLike = (1.0, 0.0, 0.0, 0.0), translation: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0)
) -> Body:
        """Return the body rotated about the origin, then shifted: r → R r + d, J → R J Rᵀ.

        Args:
            rotation: (4,) unit quaternion wxyz, normalised here, (3, 3) rotation matrix, or a scipy Rotation.
            translation: (3,) [m].

        Raises:
            InvalidInput: for a matrix that is not a rotation.
        """
        if hasattr(rotation, "as_matrix"):
            rotation = rotation.as_matrix()
        if np.shape(rotation) == (4,):
            turn = as_matrix(normalize(finite_array("rotation", rotation, (4,))))
        else:
            turn = finite_array("rotation", rotation, (3, 3))
            from_matrix(turn)  # refuses reflections and matrices that are not orthogonal
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
            center = turn @ self.center_of_mass + finite_array("translation", translation, (3,))
            return Body(self.mass, center, turn @ self.inertia @ turn.T, self.effective)

    def _require_mass(self, purpose: str) -> float:
        if self.mass is None:
            raise InvalidInput(f"{purpose} needs the body's mass; give `mass` when making it.")
        return self.mass


def check_is_body(body: Any) -> None:
    """Refuse anything but a ``Body``.

    Raises:
        InvalidInput: then.
    """
    check.instance("body", body, Body, "a Body", "Make one with polhode.shapes or Body.from_mesh.")


def combine(bodies: Sequence[Body | MassProperties], cut: Sequence[Body | MassProperties] = ()) -> Body:
    """Return several bodies as one rigid body: J = Σ J_k + m_k (|d_k|² 1 − d_k d_kᵀ), d_k from the common centre.

    Args:
        bodies: each with its mass; ``shapes.point`` makes point masses to put beside them.
        cut: material taken away, such as holes: these count with negative mass.

    Raises:
        InvalidInput: for an empty list or a body without mass, and if more is cut than was there, so that no body is
            left.

    >>> from polhode.bodies import shapes
    >>> ring = combine([shapes.disk(4.0, 2.0)], cut=[shapes.disk(1.0, 1.0)])  # 3/2 (R² + r²)
    >>> ring.mass, float(ring.inertia[2, 2])
    (3.0, 7.5)
    """
    for name, value in (("bodies", bodies), ("cut", cut)):
        if not isinstance(value, Body | Iterable):
            raise InvalidInput(f"`{name}` must be a list of Body objects; got {shown(value)}.")
    added, taken = ([one] if isinstance(one, Body) else list(one or []) for one in (bodies, cut))
    if not added:
        raise InvalidInput("`bodies` must name at least one body to combine; got none.")
    if strange := [body for body in (*added, *taken) if not isinstance(body, Body | MassProperties)]:
        check.refuse("bodies", "Body objects", strange[0], "Make one with polhode.shapes or Body.")
    whole = [*added, *taken]
    signs = np.array([1.0] * len(added) + [-1.0] * len(taken))
    masses = signs * [_mass_of(body) for body in whole]
    centers = np.array([body.center_of_mass for body in whole])
    effective = any(isinstance(body, Body) and body.effective for body in added)
    if taken and not masses.sum() > ROUNDING * np.abs(masses).sum():
        left = f"{-masses[masses < 0].sum():.6g} kg are cut from {masses[masses > 0].sum():.6g} kg"
        raise InvalidInput(f"nothing is left: {left}. Check the masses or densities of what is cut.")
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
        center = masses @ (centers - centers[0]) / masses.sum() + centers[0]
        shifted = masses[:, None, None] * point_inertia(centers - center)
        own = signs[:, None, None] * np.array([body.inertia for body in whole])
        inertia = own.sum(axis=0) + shifted.sum(axis=0)
        if not taken:
            return Body(float(masses.sum()), center, inertia, effective)
        size = np.abs(own).sum() + np.abs(shifted).sum()
    return Body(float(masses.sum()), center, _left_by_cut(inertia, size), effective)


def _mass_of(body: Body | MassProperties) -> float:
    return body._require_mass("combining bodies") if isinstance(body, Body) else body.mass


def _left_by_cut(inertia: Array, size: float) -> Array:
    """Return the tensor after cutting: flat bodies may miss I1 + I2 ≥ I3 by rounding where terms cancel."""
    if not np.isfinite(inertia).all():
        return inertia  # the body refuses it
    near = nearest_physical(inertia)
    if np.linalg.norm(near - inertia) > ROUNDING * size:
        moments = ", ".join(f"{x:.6g}" for x in np.linalg.eigvalsh(inertia))
        raise InvalidInput(
            f"what the cuts leave is no body: its principal moments would be ({moments}) kg m², and I1 + I2 ≥ I3 ≥ 0 "
            "must hold. More is cut somewhere than is there: check places and sizes of what is cut."
        )
    return near if np.linalg.norm(near - inertia) > ROUNDING * np.abs(inertia).max() else inertia
