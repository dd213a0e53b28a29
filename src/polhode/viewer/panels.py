"""Which panels fit a system, and the data that each of them draws."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode import rotation
from polhode.analysis.poinsot import herpolhode
from polhode.analysis.polhodes import level_segments, polhode, polhode_family, saddle_energies, separatrix
from polhode.bodies.surface import Surface
from polhode.exact.free_body import FreeMotion
from polhode.exact.lagrange_top import LagrangeMotion
from polhode.viewer.encoding import packed
from polhode.viewer.samples import Samples
from polhode.viewer.shapes import body_shape, top_shape

Array = Any
Panel = dict[str, Any]
PERIOD_POINTS = 2000  # of the drawn polhode, so that its chords miss it by 2e-6 at most
KEPT = 1e-6  # of |L|: a momentum in space that stays within this is the one that a page's "up" can be
TITLES = {
    "FreeMotion": "Free motion", "FreeRigidBody": "Free motion", "LagrangeMotion": "Lagrange top",
    "HeavyTop": "Heavy top", "BodyInPotential": "Body in a potential", "BrunBody": "Brun's body",
    "EulerDisk": "Euler's disk", "SpinOrbit": "Spin on an orbit", "Gyrostat": "Gyrostat",
    "TorquedGyrostat": "Gyrostat with a driven rotor", "TorquedBody": "Body under torques",
}  # fmt: skip
TOPS = ("LagrangeMotion", "HeavyTop", "BodyInPotential", "BrunBody")  # their space has an up of its own
FREE = ("FreeMotion", "FreeRigidBody")
LOW = 0.4  # cosine of the tilt below which a top of unknown shape would dip into the ground, and stands on a post
DIPS = 0.02  # of its size by which a top may do so, as the tip of a stem is not a point
LOOKS = 300  # samples at which that is looked at
ALIGNED = 0.99999  # cosine up to which a top's axis is one of its principal axes
AXIS = np.array([0.0, 0.0, 1.0])


def kind_of(system: Any) -> str:
    """Return the name of a system's class, "" for what is none of polhode's."""
    return type(system).__name__ if type(system).__module__.startswith("polhode.") else ""


def title_of(system: Any) -> str:
    """Return what a motion without a name is called: the object's name in its file, or the kind of motion."""
    return getattr(system, "object_name", None) or TITLES.get(kind_of(system), "Motion")


def panels_of(system: Any, samples: Samples, surface: Surface | None) -> list[Panel]:
    """Return the panels that fit a motion, the body first; none where there is nothing to draw.

    Args:
        system: what moves.
        samples: of it.
        surface: of the body, along the axes of the samples.
    """
    kind = kind_of(system)
    if kind == "EulerDisk":
        return [_disk(system, samples)]
    if kind == "SpinOrbit":
        return [_orbit(system, samples)]
    moments = moments_of(system)
    if kind in TOPS:
        return _of_top(kind, system, samples, moments, surface)
    found = []
    if samples.attitude is not None:
        found.append(_body(samples, moments, *body_shape(moments, surface)))
    if samples.momentum is None or not np.linalg.norm(samples.momentum, axis=-1).any():
        return found
    free = _as_free_motion(kind, system, samples)
    if free is None:
        return [*found, _sphere_of_levels(kind, system, samples, samples.momentum, moments)]
    found.append(_sphere_of_polhodes(free))
    if samples.attitude is not None and free.energy:
        found.append(_poinsot(free))
    return found


def moments_of(system: Any) -> Array | None:
    """Return the principal moments (3,) of the one body that a system has, or None."""
    moments = getattr(system, "moments", None)
    if moments is None or np.shape(moments) != (3,):
        return None
    return np.asarray(moments, dtype=float)


def free_moments_of(system: Any, samples: Samples) -> list[float] | None:
    """Return the principal moments of a body without torques that turns, or None: the page then knows how L goes on."""
    if kind_of(system) not in FREE or samples.momentum is None or not np.linalg.norm(samples.momentum, axis=-1).all():
        return None
    return np.asarray(system.moments, dtype=float).tolist()


def up_of(system: Any, samples: Samples) -> tuple[Array, str]:
    """Return the unit quaternion (4,) that turns space for the page, and what then points up.

    The momentum points up where it is kept in space, else the space axis z.
    """
    as_given = np.array([1.0, 0.0, 0.0, 0.0]), "z"
    if kind_of(system) in ("", *TOPS, "EulerDisk", "SpinOrbit"):
        return as_given
    if samples.attitude is None or samples.momentum is None:
        return as_given
    in_space = rotation.rotate(samples.attitude, samples.momentum)
    norm = np.linalg.norm(in_space[0])
    if not norm or np.abs(in_space - in_space[0]).max() > KEPT * norm:
        return as_given
    return rotation.shortest_between(in_space[0], AXIS), "L"


# ---------------------------------------------------------------------- the body


def _body(samples: Samples, moments: Array | None, surface: Surface | None, words: str) -> Panel:
    """Return the body with the trace of the axis nearest to L at first."""
    nearest = AXIS if samples.momentum is None else samples.momentum[0]
    panel: Panel = {"type": "body", "traced": int(np.abs(nearest).argmax()), "shape": words}
    if surface is not None:
        wide = len(surface.vertices) > 65535
        panel["surface"] = {"vertices": packed(surface.vertices, "f4"),
                            "faces": packed(surface.faces, "u4" if wide else "u2")}  # fmt: skip
    elif moments is not None:
        panel["ellipsoid"] = (1.0 / np.sqrt(moments)).tolist()
    return panel


def _of_top(kind: str, system: Any, samples: Samples, moments: Array | None, surface: Surface | None) -> list[Panel]:
    if samples.attitude is None:
        return []
    axis = np.asarray(getattr(system, "axis", AXIS), dtype=float)
    weighed = kind in ("LagrangeMotion", "HeavyTop")
    shape = top_shape(moments, axis, surface) if weighed and moments is not None else body_shape(moments, surface)
    own: Panel = {"traced": int(np.abs(axis).argmax()), "pivot": _pivot(samples.attitude, axis, shape[0])}
    if weighed and axis[own["traced"]] < ALIGNED * np.linalg.norm(axis):
        own["along"] = (axis / np.linalg.norm(axis)).tolist()
    body = _body(samples, moments, *shape) | own
    limits = []
    if isinstance(system, LagrangeMotion):
        limits = [float(x) for x in system.nutation_limits if x is not None and abs(x) < 1.0]
    locus = {"type": "axis", "axis": axis.tolist(), "limits": limits, "center": weighed}
    return [body, locus]


def _pivot(attitude: Array, axis: Array, surface: Surface | None) -> str:
    """Return what holds the pivot: the ground, a post where the body reaches below it, a hook where it hangs."""
    up = rotation.rotate(rotation.conjugate(attitude[:: -(-len(attitude) // LOOKS)]), AXIS)  # in the body
    height = rotation.rotate(attitude, axis)[:, 2]
    if height.mean() < 0:
        return "hook"
    if surface is None:
        return "ground" if height.min() > LOW * np.linalg.norm(axis) else "post"
    corners = np.asarray(surface.vertices, dtype=float)
    lowest = min(float((corners @ direction).min()) for direction in up)
    return "ground" if lowest > -DIPS * np.linalg.norm(corners, axis=1).max() else "post"


# ---------------------------------------------------------------------- the momentum sphere


def _as_free_motion(kind: str, system: Any, samples: Samples) -> FreeMotion | None:
    """Return the exact motion through a free body's first sample; None for other systems."""
    if kind not in FREE or samples.momentum is None:
        return None
    attitude = (1.0, 0.0, 0.0, 0.0) if samples.attitude is None else samples.attitude[0]
    return FreeMotion(np.asarray(system.moments, dtype=float), samples.momentum[0], attitude, float(samples.times[0]))


def _sphere_of_polhodes(motion: FreeMotion) -> Panel:
    moments = np.asarray(motion.moments)
    order = np.argsort(moments, kind="stable")
    back = np.argsort(order)
    family = [curve[:, back] for curve in polhode_family(moments[order])]
    borders = [curve[:, back] for curve in separatrix(moments[order])]
    own = polhode(motion, PERIOD_POINTS)
    return {"type": "sphere", "title": "Momentum sphere", "own": None if own is None else packed(own),
            "family": _pieces(family), "separatrix": _pieces(borders), "legend": "other polhodes",
            "words": "L in body axes runs along its polhode"}  # fmt: skip


def _sphere_of_levels(kind: str, system: Any, samples: Samples, momentum: Array, moments: Array | None) -> Panel:
    """Return the sphere with levels of the energy at the momentum of the last sample."""
    norm = float(np.linalg.norm(momentum[-1])) or float(np.linalg.norm(momentum, axis=-1).max())
    panel: Panel = {"type": "sphere", "title": "Momentum sphere", "own": None, "family": None, "separatrix": None,
                    "legend": "levels of energy", "words": "direction of L in body axes"}  # fmt: skip
    if moments is None:
        return panel
    rotor = np.zeros(3)
    if kind == "Gyrostat":
        rotor = np.asarray(system.rotor, dtype=float)
    elif kind == "TorquedGyrostat":
        rotor = float(samples.states[-1, 7]) * np.asarray(system.axis, dtype=float)
        panel["words"] = "direction of L in body axes; levels are those at the end"

    def energy(u: Array) -> Array:
        return 0.5 * np.sum((norm * u - rotor) ** 2 / moments, axis=-1)

    borders = level_segments(energy, saddle_energies(moments, rotor, norm))
    return panel | {"family": packed(level_segments(energy), "f4"), "separatrix": packed(borders, "f4")}


def _pieces(curves: list[Array]) -> dict[str, Any] | None:
    """Return curves as pieces (n, 2, 3), of every third of their points."""
    if not curves:
        return None
    curves = [curve[np.linspace(0, len(curve) - 1, len(curve) // 3).round().astype(int)] for curve in curves]
    return packed(np.concatenate([np.stack([curve[:-1], curve[1:]], axis=1) for curve in curves]), "f4")


# ---------------------------------------------------------------------- Poinsot's picture


def _poinsot(motion: FreeMotion) -> Panel:
    found = herpolhode(motion)
    assert found is not None
    return {"type": "poinsot", "moments": np.asarray(motion.moments).tolist(), "energy": motion.energy,
            "distance": found.plane_distance, "inner": found.inner_radius, "outer": found.outer_radius}  # fmt: skip


# ---------------------------------------------------------------------- disk and orbit


def _disk(system: Any, samples: Samples) -> Panel:
    center = np.asarray(system.center(samples.states))
    sizes = system.mechanics
    return {"type": "disk", "radius": float(sizes.radius), "thickness": 2.0 * float(sizes.half_thickness),
            "contact": packed(samples.states[:, 3:5]), "center": packed(center)}  # fmt: skip


def _orbit(system: Any, samples: Samples) -> Panel:
    orbit = system.orbit
    place = np.asarray(orbit.direction(samples.times)) * np.asarray(orbit.distance_ratio(samples.times))[:, None]
    return {"type": "orbit", "angle": packed(samples.states[:, 0]), "place": packed(place[:, :2]),
            "eccentricity": float(orbit.eccentricity), "asphericity": float(system.asphericity)}  # fmt: skip
