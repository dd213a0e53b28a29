"""What sliders ask for, as a motion and what is to be drawn of it; nothing here knows of a browser."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.analysis.free_axes import axis_stability
from polhode.analysis.poinsot import ellipsoid_semi_axes, touching_point
from polhode.analysis.polhodes import polhode_family, separatrix
from polhode.bodies.surface import Surface, box_of_same_inertia
from polhode.bodies.turned import ball
from polhode.exact.free_body import FreeMotion
from polhode.motion.inputs import finite
from polhode.types import Array, ArrayLike, Float64, Real

PERIODS, POINTS = 6, 2400  # of the herpolhode that is drawn
OWN = 400  # points of the motion's polhode


class Setting(NamedTuple):
    """A body and how it spins at first.

    Attributes:
        moments: (3,) principal moments in any order [kg m²].
        rate: |Ω| [rad/s].
        off: angle of Ω from the second axis [rad].
        around: angle of Ω about the second axis, from the third towards the first [rad].
    """

    moments: Float64[Array, "3"]
    rate: float
    off: float
    around: float

    @classmethod
    def of(cls, moments: Real[ArrayLike, "3"], velocity: Real[ArrayLike, "3"]) -> Setting:
        """Return the setting with an angular velocity (3,) [rad/s, principal axes]."""
        x, y, z = (float(v) for v in velocity)
        across = float(np.hypot(x, z))
        around = float(np.arctan2(x, z)) % (2.0 * np.pi)
        return cls(np.asarray(moments, dtype=float), float(np.hypot(across, y)), float(np.arctan2(across, y)), around)

    @property
    def velocity(self) -> Float64[Array, "3"]:
        """(3,) Ω [rad/s, principal axes]."""
        s, c = np.sin(self.off), np.cos(self.off)
        return self.rate * np.array([s * np.sin(self.around), c, s * np.cos(self.around)])

    def motion(self) -> FreeMotion:
        """Return the motion; L points along the third axis of space."""
        momentum = np.asarray(self.moments) * self.velocity
        return FreeMotion(self.moments, momentum, rotation.shortest_between(momentum, (0.0, 0.0, 1.0)))


def allowed(moments: Real[ArrayLike, "3"], k: int) -> tuple[float, float]:
    """Return the least and the greatest value of one moment, given the two others: |I_i − I_j| ≤ I_k ≤ I_i + I_j."""
    i, j = (float(moments[n]) for n in range(3) if n != k)
    return abs(i - j), i + j


class Pose(NamedTuple):
    """The motion at one time.

    Attributes:
        attitude: (4,) body → space.
        momentum: (3,) direction of L, body axes: the point on the momentum sphere.
        velocity: (3,) direction of Ω, space axes.
        contact: (3,) where Poinsot's ellipsoid touches the plane, space axes.
    """

    attitude: Float64[Array, "4"]
    momentum: Float64[Array, "3"]
    velocity: Float64[Array, "3"]
    contact: Float64[Array, "3"]


class Picture(NamedTuple):
    """What is drawn of a setting; lengths are relative, the largest of each picture 1.

    Attributes:
        setting: what was asked for.
        motion: it.
        clock: its period, of a turn where it has none [s].
        body: along the principal axes.
        ellipsoid: of inertia, along the principal axes.
        plane_height: of the invariable plane, below the centre.
        family: other polhodes (n, 2, 3) on the unit sphere, as pieces; likewise
        separatrix: (n, 2, 3),
        own: (n, 2, 3) this motion's.
        polhode: (n, 2, 3) on the ellipsoid, in the body.
        herpolhode: (n, 2, 3) on the plane, in space.
    """

    setting: Setting
    motion: FreeMotion
    clock: float
    body: Surface
    ellipsoid: Surface
    plane_height: float
    family: Float64[Array, "_ 2 3"]
    separatrix: Float64[Array, "_ 2 3"]
    own: Float64[Array, "_ 2 3"]
    polhode: Float64[Array, "_ 2 3"]
    herpolhode: Float64[Array, "_ 2 3"]

    def at(self, time: float) -> Pose:
        """Return the motion at a time [s]."""
        attitude, momentum = self.motion.state(time)
        unit = momentum / np.linalg.norm(momentum)
        velocity = rotation.rotate(attitude, momentum / self.setting.moments)
        contact = -rotation.rotate(attitude, touching_point(unit, self.setting.moments)) / _longest(self.setting)
        return Pose(attitude, unit, velocity / np.linalg.norm(velocity), contact)

    def readout(self) -> str:
        """Return what is said of the motion, as Markdown."""
        motion = self.motion
        lines = [
            ("regime", motion.regime),
            ("energy", _number(motion.energy, "J")),
            ("size of L", _number(motion.momentum_norm, "kg m²/s")),
            ("polhode period", _number(motion.period, "s")),
            ("flip interval", _number(motion.flip_interval, "s")),
            ("precession per period", _number(motion.precession_per_period, "rad")),
        ]
        verdicts = axis_stability(np.sort(self.setting.moments), motion.momentum_norm or 1.0)
        rank = np.argsort(np.argsort(self.setting.moments, kind="stable"), kind="stable")
        lines += [(f"axis {k + 1}", verdicts[rank[k]].verdict) for k in range(3)]
        return "| | |\n|---|---|\n" + "\n".join(f"| {name} | {value} |" for name, value in lines)


def picture_of(setting: Setting, surface: Surface | None = None) -> Picture:
    """Return what is drawn of a setting.

    Args:
        setting: moments that a body has, and a rate that is not zero.
        surface: what the body looks like, along the principal axes; None for the box of the same inertia.
    """
    motion, moments = setting.motion(), np.asarray(setting.moments)
    order = np.argsort(moments, kind="stable")
    clock = finite(motion.period) or 2.0 * np.pi / setting.rate
    own = np.asarray(motion.momentum(np.linspace(0.0, clock, OWN))) / motion.momentum_norm
    body = surface or box_of_same_inertia(moments)
    assert body is not None
    size, longest = np.linalg.norm(body.vertices, axis=-1).max(), _longest(setting)
    round_ball = ball()
    attitude, momentum = motion.state(np.linspace(0.0, PERIODS * clock, POINTS))
    contact = -rotation.rotate(attitude, touching_point(momentum, moments)) / longest
    return Picture(
        setting, motion, float(clock),
        Surface(np.asarray(body.vertices) / size, body.faces),
        Surface(round_ball.vertices * ellipsoid_semi_axes(moments) / longest, round_ball.faces),
        float(contact[0, 2]),
        _pieces(polhode_family(moments[order]), order), _pieces(separatrix(moments[order]), order),
        _pieces([own]), _pieces([-touching_point(own, moments) / longest]), _pieces([contact]),
    )  # fmt: skip


def _longest(setting: Setting) -> float:
    return float(ellipsoid_semi_axes(setting.moments).max())


def _pieces(curves: list[Array], order: Array | None = None) -> Array:
    """Return curves (T, 3) as pieces (n, 2, 3), of axes that were sorted put back in their order."""
    if not curves:
        return np.empty((0, 2, 3))
    found = np.concatenate([np.stack([curve[:-1], curve[1:]], axis=1) for curve in curves])
    return found if order is None else found[..., np.argsort(order)]


def _number(value: float | None, unit: str) -> str:
    if value is None:
        return "–"
    return "infinite" if np.isinf(value) else f"{value:.6g} {unit}"
