"""The panels for any body, and the data that each of them draws."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis.polhodes import level_segments, saddle_energies
from polhode.bodies.surface import Surface
from polhode.motion.frame import BodyFrame
from polhode.types import Array, Float64
from polhode.viewer.encoding import pack
from polhode.viewer.samples import Samples
from polhode.viewer.shapes import body_shape, is_celestial, semi_axes_squared, top_shape

Panel = dict[str, Any]
AXIS = np.array([0.0, 0.0, 1.0])


class PanelLimits(NamedTuple):
    """Numbers that decide what a panel shows."""

    # of |L|: a momentum in space that stays within this is the one that a page's "up" can be
    max_momentum_change: float = 1e-6
    # of the tilt; below it a top of unknown shape would dip into the ground, and is put on a post
    min_cosine: float = 0.4
    max_dip: float = 0.02  # of its size, as the tip of a stem is not a point
    max_aligned_cosine: float = 0.99999  # up to which a top's axis is not one of its principal axes


LIMITS = PanelLimits()


@dataclass(frozen=True)
class PageContent:
    """The pictures of a motion on a page.

    Attributes:
        panels: the data of each picture, named by its "type"; none where there is nothing to draw.
        scripts: JavaScript that makes the panels that the page's own script does not know.
        plots: pictures over time, a title, a unit and named series each; None for the parts of the state.
        scatters: pictures of two numbers against each other, likewise.
        model: what the page's own solver needs to go on with the motion: its name as "solver", and its arguments; None
            where the page only shows samples.
        solved: whether that solver knows the motion at any time, so that the page needs no samples but their times.
        words: further words of the page: ``axes``, names of the body's axes, and ``units`` of energy and momentum, a
            size in SI and a name each.
    """

    panels: list[Panel]
    scripts: tuple[str, ...] = ()
    model: dict[str, Any] | None = None
    plots: list[dict[str, Any]] | None = None
    scatters: tuple[dict[str, Any], ...] = ()
    solved: bool = False
    words: dict[str, Any] = field(default_factory=dict)


def choose_content(
    source: Any, samples: Samples, surface: Surface | None, frame: BodyFrame | None = None
) -> PageContent:
    """Return the pictures for any body, the body first, as its system or exact motion determines.

    Args:
        source: of the trajectory: a system, an exact motion, or anything else.
        samples: of it.
        surface: of the body, along the axes of the samples.
        frame: of the body, with the distance of a top's centre of mass from its pivot; None where it is not known.
    """
    moments = find_moments(source)
    if is_mechanical(source) and source.has_vertical:
        return PageContent(top_panels(source, samples, moments, surface, frame))
    panels = body_panels(samples, moments, surface)
    if samples.momentum is None or not np.linalg.norm(samples.momentum, axis=-1).any():
        return PageContent(panels)
    if find_free_moments(source, samples) is None:
        levels = moments if _turns_as_one(samples, moments) else None
        return PageContent([*panels, sphere_of_levels(samples.momentum, levels)])
    panels.append(_sphere_of_polhodes())
    if samples.attitude is not None:
        panels.append({"type": "poinsot"})
    return PageContent(panels)


def is_mechanical(source: Any) -> bool:
    """Whether a trajectory's source is an exact motion or a system."""
    return hasattr(source, "has_vertical") and hasattr(source, "free_moments")


def keeps_motion_of(classes: Iterable[type], source: Any) -> bool:
    """Whether a source is of one of these classes and overrides nothing: a subclass may move otherwise."""
    ancestors = type(source).__mro__
    own = next((kind for kind in ancestors if kind in set(classes)), None)
    if own is None:
        return False
    added = {name for heir in ancestors[: ancestors.index(own)] for name in vars(heir)}
    return not any(hasattr(own, name) for name in added if not name.startswith(("__", "_abc_")) and name != "title")


def _turns_as_one(samples: Samples, moments: Array | None) -> bool:
    """Whether L = IΩ: with rotors inside, levels of ½ L·I⁻¹L are not those of the energy."""
    momentum, velocity = samples.momentum, samples.angular_velocity
    if moments is None or momentum is None or velocity is None:
        return True
    return bool(np.abs(momentum - moments * velocity).max() <= LIMITS.max_momentum_change * np.abs(momentum).max())


def choose_title(source: Any) -> str:
    """Return the title of a motion without a name: from its file, or by the kind of motion."""
    return getattr(source, "title", None) or "Motion"


def find_moments(source: Any) -> Float64[Array, "3"] | None:
    """Return the principal moments (3,) of the one body that a system has, or None."""
    moments = getattr(source, "moments", None)
    if moments is None or np.shape(moments) != (3,):
        return None
    return np.asarray(moments, dtype=float)


def find_free_moments(source: Any, samples: Samples) -> list[float] | None:
    """Return the principal moments of a turning body without torques, or None; the page computes L from them."""
    if not is_mechanical(source) or source.free_moments is None:
        return None
    says_so = next(kind for kind in type(source).__mro__ if "free_moments" in vars(kind))
    if not keeps_motion_of((says_so,), source):
        return None
    if samples.momentum is None or not np.linalg.norm(samples.momentum, axis=-1).all():
        return None
    return np.asarray(source.free_moments, dtype=float).tolist()


def choose_up(source: Any, samples: Samples) -> tuple[Float64[Array, "4"], str]:
    """Return the unit quaternion (4,) that turns space for the page, and the name of its upward direction.

    The momentum points up where it is kept in space, else the space axis z.
    """
    as_given = np.array([1.0, 0.0, 0.0, 0.0]), "z"
    if not is_mechanical(source) or source.has_vertical or samples.attitude is None or samples.momentum is None:
        return as_given
    in_space = rotation.rotate(samples.attitude, samples.momentum)
    norm = np.linalg.norm(in_space[0])
    if not norm or np.abs(in_space - in_space[0]).max() > LIMITS.max_momentum_change * norm:
        return as_given
    return rotation.shortest_between(in_space[0], AXIS), "L"


# ---------------------------------------------------------------------- the body


def body_panels(samples: Samples, moments: Float64[Array, "3"] | None, surface: Surface | None) -> list[Panel]:
    """Return the body in space; none without attitudes."""
    return [] if samples.attitude is None else [_body(samples, moments, *body_shape(moments, surface))]


def _body(samples: Samples, moments: Array | None, surface: Surface | None, words: str) -> Panel:
    """Return the body with the trace of the axis nearest to L at first."""
    nearest = AXIS if samples.momentum is None else samples.momentum[0]
    panel: Panel = {"type": "body", "traced": int(np.abs(nearest).argmax()), "shape": words}
    if surface is not None:
        wide = len(surface.vertices) > 65535
        panel["surface"] = {"vertices": pack(surface.vertices, "f4"),
                            "faces": pack(surface.faces, "u4" if wide else "u2")}  # fmt: skip
        if surface.colors is not None:
            panel["surface"]["colors"] = pack(surface.colors, "u4")
        if moments is not None and is_celestial(moments):
            panel["round"] = True
        panel |= _paint(panel["surface"], surface)
    elif moments is not None and is_celestial(moments):
        panel |= {"ellipsoid": np.sqrt(semi_axes_squared(moments)).tolist(), "round": True}
    elif moments is not None:
        panel["ellipsoid"] = (1.0 / np.sqrt(moments)).tolist()
    return panel


def _paint(drawn: Panel, surface: Surface) -> Panel:
    """Add a surface's paint to its data; return the cage around it, in units of the surface's reach."""
    paint, reach = surface.paint, _reach(surface)
    if paint is None:
        return {}
    drawn["shiny"] = paint.shiny
    drawn["lines"] = [
        {"points": pack(points, "f4"), "color": int(color), "width": width} for points, color, width in paint.lines
    ]
    if paint.cage is None:
        return {}
    center, radius = paint.cage
    return {"cage": {"center": float(np.linalg.norm(center)) / reach, "radius": radius / reach}}


def _reach(surface: Surface) -> float:
    """Return the distance of the farthest corner from where the body turns [m]."""
    return float(np.linalg.norm(np.asarray(surface.vertices, dtype=float), axis=1).max())


def top_panels(
    source: Any, samples: Samples, moments: Float64[Array, "3"] | None, surface: Surface | None,
    frame: BodyFrame | None = None,
) -> list[Panel]:
    """Return a body about a fixed point, and the path of its axis; none without attitudes."""
    if samples.attitude is None:
        return []
    axis = np.asarray(getattr(source, "axis", AXIS), dtype=float)
    weighed = hasattr(source, "mgl")
    shape = top_shape(moments, axis, surface) if weighed and moments is not None else body_shape(moments, surface)
    own: Panel = {"traced": int(np.abs(axis).argmax()), "pivot": _pivot(samples.attitude, axis, shape[0])}
    if weighed:
        own["weight"] = {"center": _center(shape, surface is not None, axis, frame)}
    if weighed and axis[own["traced"]] < LIMITS.max_aligned_cosine * np.linalg.norm(axis):
        own["along"] = (axis / np.linalg.norm(axis)).tolist()
    body = _body(samples, moments, *shape) | own
    limits = [float(x) for x in getattr(source, "nutation_limits", ()) if x is not None and abs(x) < 1.0]
    locus = {"type": "axis", "axis": axis.tolist(), "limits": limits, "center": weighed}
    return [body, locus]


def _center(shape: tuple[Surface | None, str], is_own: bool, axis: Array, frame: BodyFrame | None) -> float:
    """Return how far from the pivot a top's centre of mass is drawn, in units of the drawn surface's reach."""
    unknown_place = 0.6  # of the reach of a top: where its weight is drawn if its place is not given
    drawn, words = shape
    if drawn is None:
        return unknown_place
    if is_own and frame is not None and frame.pivot is not None:
        return float(np.linalg.norm(np.asarray(frame.center_of_mass) - np.asarray(frame.pivot))) / _reach(drawn)
    if is_own or "stem" not in words:
        return unknown_place
    disk = np.asarray(drawn.vertices)[: len(drawn.vertices) // 2]  # on a massless stem
    return abs(float(disk.mean(axis=0) @ axis)) / float(np.linalg.norm(axis)) / _reach(drawn)


def _pivot(attitude: Array, axis: Array, surface: Surface | None) -> str:
    """Return the support of the pivot: the ground, a post where the body reaches below it, a hook where it hangs."""
    most_samples = 300  # at which it is checked
    up = rotation.rotate(rotation.conjugate(attitude[:: -(-len(attitude) // most_samples)]), AXIS)  # in the body
    height = rotation.rotate(attitude, axis)[:, 2]
    if height.mean() < 0:
        return "hook"
    if surface is None:
        return "ground" if height.min() > LIMITS.min_cosine * np.linalg.norm(axis) else "post"
    corners = np.asarray(surface.vertices, dtype=float)
    lowest = min(float((corners @ direction).min()) for direction in up)
    return "ground" if lowest > -LIMITS.max_dip * np.linalg.norm(corners, axis=1).max() else "post"


# ---------------------------------------------------------------------- the momentum sphere


def _sphere_of_polhodes() -> Panel:
    """Return the sphere of a free body, whose curves the page draws itself."""
    return {"type": "sphere", "title": "Momentum sphere", "legend": "other polhodes",
            "words": "L in body axes runs along its polhode"}  # fmt: skip


def sphere_of_levels(
    momentum: Float64[Array, "time 3"],
    moments: Float64[Array, "3"] | None,
    rotor: Float64[Array, "3"] | None = None,
    words: str = "direction of L in body axes",
) -> Panel:
    """Return the sphere with levels of the energy ½ (L − h)·I⁻¹(L − h) at the |L| of the last sample.

    Args:
        momentum: (T, 3) of the samples.
        moments: (3,), None for a sphere without levels.
        rotor: (3,) h of a rotor inside; None without one.
        words: above it.
    """
    norm = float(np.linalg.norm(momentum[-1])) or float(np.linalg.norm(momentum, axis=-1).max())
    panel: Panel = {"type": "sphere", "title": "Momentum sphere", "own": None, "family": None, "separatrix": None,
                    "legend": "levels of energy", "words": words}  # fmt: skip
    if moments is None:
        return panel
    inner = np.zeros(3) if rotor is None else rotor

    def energy(u: Array) -> Array:
        return 0.5 * np.sum((norm * u - inner) ** 2 / moments, axis=-1)

    borders = level_segments(energy, saddle_energies(moments, inner, norm))
    return panel | {"family": pack(level_segments(energy), "f4"), "separatrix": pack(borders, "f4")}
