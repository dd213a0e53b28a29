"""Motions as animations that any viewer of glTF plays."""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode.bodies._turned import revolve
from polhode.bodies.surface import Surface, box_in_place
from polhode.errors import InvalidInput
from polhode.formats.animation_keys import make_keys
from polhode.formats.attitude_checks import single_attitude
from polhode.formats.glb import Glb
from polhode.formats.labels import AttitudeLabels
from polhode.formats.paths import as_path, write_whole
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.types import Array

# Okabe and Ito's colours, which the colour-blind tell apart
TO_AXES = (np.eye(3)[[1, 2, 0]], np.eye(3)[[2, 0, 1]], np.eye(3))  # of rows: z to x, to y, to z


class ViewingLimits(NamedTuple):
    """Numbers that decide how a motion is shown."""

    min_duration: float = 1.0  # s; a shorter motion is not shown in real time
    max_duration: float = 600.0  # s
    min_reach: float = 1e-2  # m; a smaller body is not shown in its own size
    max_reach: float = 1e3  # m
    max_steady_change: float = 1e-6  # of a direction: single precision hardly shows it


LIMITS = ViewingLimits()


def write_gltf(
    trajectory: Trajectory,
    path: str | Path,
    *,
    labels: AttitudeLabels | None = None,
    surface: Surface | None = None,
    rate: float | None = None,
    speed: float | None = None,
) -> Path:
    """Write a motion as a glTF 2.0 animation in one binary file (.glb).

    The body turns about its centre of mass or its fixed point, which is at the origin; a rolling disk moves along.
    Arrows show principal axes 1, 2, 3 in vermilion, green and blue, and the angular momentum in orange. Space z is up:
    a node turns it to glTF's y. Numbers are in single precision, as the format has them: attitudes at the keys to
    1.2e-7 rad, and between them viewers interpolate. Exact motions are evaluated at the very times that the file holds,
    other samples keep theirs, rounded.

    Args:
        trajectory: of one body, with attitude.
        path: of the file, replaced if it is there.
        labels: its ``object_name`` is that of the node.
        surface: of the body, in the given axes; without it the box of the same inertia, or arrows alone.
        rate: keys per second of the animation, for exact motions; the trajectory's own samples without it, or finer
            where these are too far apart.
        speed: seconds of motion in a second of animation; without it real time, or the power of ten that makes motions
            shorter than a second or longer than ten minutes last from 10 to 100 s.

    Returns:
        The path. The file's ``asset.extras`` say the speed, the size of its unit, metres for bodies of 1 cm to 1 km,
        and the time [s] in the motion of its first key.

    Raises:
        InvalidInput: for trajectories without attitude, of several bodies, or with samples so far apart that the
            direction of rotation is open; for files that cannot be written.

    >>> import tempfile
    >>> from polhode.exact.free_body import FreeMotion
    >>> motion = FreeMotion((1.0, 2.0, 2.5), momentum=(0.1, 2.0, 0.2))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_gltf(motion.sample(np.linspace(0.0, 20.0, 600)), f"{folder}/tumbling.glb").name
    'tumbling.glb'
    """
    arrow_length = 1.3  # of the body's reach
    path = as_path("path", path)
    for name, value in (("rate", rate), ("speed", speed)):
        if value is not None:
            check.number(name, value, above=0, remedy="Give it in SI units.")
    if not np.isfinite(single_attitude(trajectory, "glTF")).all():
        raise InvalidInput("glTF holds finite attitudes, and not all of these are. Cut the trajectory where they end.")
    speed = _watchable_speed(float(trajectory.times[-1] - trajectory.times[0])) if speed is None else speed
    clock, keyed = make_keys(trajectory, speed, rate)
    drawn = _about_origin(trajectory.frame, surface)
    reach = 0.0 if drawn is None else float(np.linalg.norm(drawn.vertices, axis=1).max())
    unit = _viewable_unit(reach)
    solid = None if drawn is None else Surface(drawn.vertices / unit, drawn.faces)
    start = float(keyed.times[0])
    extras = {"seconds_per_second": speed, "metres_per_unit": unit, "seconds_at_start": start}
    glb = Glb({"asset": {"version": "2.0", "generator": "polhode", "extras": extras}, "scene": 0})
    name, length = (labels or AttitudeLabels()).object_name, arrow_length * reach / unit or 1.0
    place, body = _add_body(glb, name, solid, trajectory.frame, length)
    attitude = np.asarray(keyed.along("given").attitude)
    tracks = [(body, "rotation", _xyzw(_continuous(attitude)))]
    center = getattr(keyed.source, "center", None)
    if callable(center):
        tracks.append((place, "translation", np.asarray(center(keyed.states)) / unit))
    tracks += _add_momentum(glb, place, keyed, arrow_length * reach / unit or 1.0)
    glb.animate("motion", clock, tracks)
    with write_whole(path) as draft:
        draft.write_bytes(glb.as_bytes())
    return path


def _watchable_speed(span: float) -> float:
    if span <= 0.0 or LIMITS.min_duration <= span <= LIMITS.max_duration:
        return 1.0
    return 10.0 ** (math.floor(math.log10(span)) - 1)


def _viewable_unit(reach: float) -> float:
    if reach == 0.0 or LIMITS.min_reach <= reach <= LIMITS.max_reach:
        return 1.0
    return 10.0 ** math.floor(math.log10(reach))


def _about_origin(frame: BodyFrame | None, surface: Surface | None) -> Surface | None:
    """Return the surfaces to draw, along the given axes, with the fixed point or centre of mass as origin."""
    if frame is None:
        return surface
    surface = box_in_place(frame) if surface is None else surface
    return None if surface is None else Surface(np.asarray(surface.vertices) - frame.origin, surface.faces)


def _add_body(
    glb: Glb, name: str, solid: Surface | None, frame: BodyFrame | None, length: float
) -> tuple[int, int]:
    """Add the nodes of space, place, body and axes; return those of place and body, which move."""
    z_up = [-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]  # xyzw, takes z to glTF's y, which is up
    body_color = (0.62, 0.70, 0.78)
    axis_colors = ((0.84, 0.37, 0.0), (0.0, 0.62, 0.45), (0.0, 0.45, 0.70))
    place = glb.node("place", glb.node("space, z up", rotation=z_up))
    body = glb.node(name, place, **({} if solid is None else glb.mesh((solid, body_color))))
    arrow = _arrow(length)
    three = glb.mesh(*((Surface(arrow.vertices @ turn, arrow.faces), color)
                        for turn, color in zip(TO_AXES, axis_colors, strict=True)))
    axes = np.eye(3) if frame is None else np.asarray(frame.axes)
    called = "body axes" if frame is None else "principal axes"
    glb.node(called, body, **three, rotation=_xyzw(rotation.from_matrix(axes)).tolist())
    return place, body


def _add_momentum(glb: Glb, place: int, keyed: Trajectory, length: float) -> list[tuple[int, str, Array]]:
    """Add the arrow along the angular momentum, if there is any; return its animation, if it moves."""
    momentum_color = (0.90, 0.62, 0.0)
    if keyed.momentum is None:
        return []
    momentum = rotation.rotate(np.asarray(keyed.attitude), np.asarray(keyed.momentum))
    size = np.linalg.norm(momentum, axis=-1, keepdims=True)
    if not (size > 0).all():
        return []
    toward = momentum / size
    turns = rotation.shortest_between((0.0, 0.0, 1.0), toward)
    arrow = glb.node("angular momentum", place, **glb.mesh((_arrow(length), momentum_color)),
                      rotation=_xyzw(turns[0]).tolist())
    moves = np.abs(toward - toward[0]).max() > LIMITS.max_steady_change
    return [(arrow, "rotation", _xyzw(_continuous(turns)))] if moves else []


def _arrow(length: float) -> Surface:
    profile = np.array([(0.0, 0.0), (0.012, 0.0), (0.012, 0.86), (0.036, 0.86), (0.0, 1.0)])
    return revolve(profile * length, sections=16)


def _continuous(quaternions: Array) -> Array:
    """Return quaternions (K, 4) with the signs that make each near the one before, so that viewers go the short way."""
    dots = np.einsum("ki,ki->k", quaternions[1:], quaternions[:-1])
    signs = np.cumprod(np.where(dots < 0.0, -1.0, 1.0))
    return np.concatenate([quaternions[:1], quaternions[1:] * signs[:, None]])


def _xyzw(quaternions: Array) -> Array:
    return np.roll(quaternions, -1, axis=-1)
