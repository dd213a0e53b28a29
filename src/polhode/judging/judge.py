"""``polhode.judging.judge``: is an engine's step right, how wrong is it, and where does it lead."""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.exact.free_body import FreeMotion
from polhode.formats.paths import as_path
from polhode.judging._mistakes import StateConvention
from polhode.judging._state_files import GivenMotion, checked_tensor, read_engine_states
from polhode.judging._stepping import Step, SteppedEngine
from polhode.judging._verdicts import default_start, judge_engine
from polhode.judging._written_states import judge_states
from polhode.judging.report import JudgeReport
from polhode.kinds.reading import read_spec
from polhode.reports.report import with_inputs
from polhode.types import ArrayLike, Real


class JudgeThresholds(NamedTuple):
    """Numbers that decide which arguments of ``judge`` are refused.

    Attributes:
        max_steps: of a long run; more take hours in Python.
        min_steps: of a long run; in fewer no drift is measured.
        max_step_angle: rad, through which the body rotates in a step; orders hold for short ones alone.
        length_tolerance: by which the length of the attitude at the start may miss 1.
    """

    max_steps: int = 10_000_000
    min_steps: int = 64
    max_step_angle: float = 0.5
    length_tolerance: float = 1e-6


LIMITS = JudgeThresholds()


def judge(
    step: Step, dt: float, inertia: Real[ArrayLike, "3"] | Real[ArrayLike, "3 3"] = (1.0, 2.0, 3.0), *,
    variable: str = "momentum", axes: str = "body", attitude: Real[ArrayLike, "4"] | None = None,
    momentum: Real[ArrayLike, "3"] | None = None, steps: int = 20_000, name: str = "engine",
) -> JudgeReport:
    """Judge a function that steps a free rigid body, against the exact motion.

    The function is called as ``step(quaternion, rate, dt)`` and returns quaternion and rate after dt. What they mean is
    declared by ``variable`` and ``axes``; the quaternion is wxyz, body → space. The judge makes short runs with dt,
    dt/2, dt/4 and so on, for the order and for whether their limit is the exact motion, and three long runs with dt for
    drift and for where spins end. An engine whose limit is not the exact motion is tried with common mistakes: ω given
    for L, quaternion xyzw, the inverse rotation, rates along the other axes, degrees, a gyroscopic term that is missing
    or has the wrong sign, an inertia that is not rotated, a factor ½, damping. One is named only if with it the engine
    converges. For an engine whose states do not stay finite, the report names the first step at which they are not.

    Args:
        step: as above; in float32 if it returns arrays of it. It must take shorter steps, and keep
            nothing between calls.
        dt: the step to be judged [s].
        inertia: (3,) principal moments or (3, 3) tensor of the body that ``step`` moves [kg m², body axes].
        variable: "momentum" if the rate is L [kg m²/s], "angular velocity" if it is ω [rad/s].
        axes: "body" or "space", which the rate's components are along.
        attitude: (4,) unit quaternion wxyz at the start, body → space; a general one if not given.
        momentum: (3,) L at the start [kg m²/s, body axes]; near no axis and with 1 rad/s if not given.
        steps: of each long run.
        name: of the engine, for the report.

    Raises:
        InvalidInput: for values that are not as above, for a dt of more than 0.5 rad, and for a step that does not
            return a quaternion (4,) and a rate (3,).

    Source: Richardson, Phil. Trans. R. Soc. A 226 (1927) 299, for the limit of short steps.

    >>> import numpy as np
    >>> from polhode import rotation
    >>> moments = np.array([1.0, 2.0, 3.0])
    >>> def step(q, L, dt):
    ...     L = L + dt * np.cross(L, L / moments)
    ...     return rotation.multiply(q, rotation.from_rotation_vector(dt * L / moments)), L
    >>> report = judge(step, 0.02, moments, steps=1000)
    >>> report.verdict, round(report.judgements[0].convergence.order, 1)
    ('right', 1.0)
    """
    if not callable(step):
        raise InvalidInput(f"`step` must be a function of quaternion, rate and dt; got {shown(step)}. See `judge`.")
    convention = StateConvention(variable, axes)
    tensor = checked_tensor(inertia)
    usual = default_start(tensor)
    q = usual[0] if attitude is None else check.array("attitude", attitude, (4,))
    L = usual[1] if momentum is None else check.array("momentum", momentum, (3,), "kg m²/s")
    if abs(np.linalg.norm(q) - 1.0) > LIMITS.length_tolerance:
        raise InvalidInput(f"`attitude` must have length 1; got length {np.linalg.norm(q):.6g}. Divide it by its norm.")
    if not L.any():
        raise InvalidInput("`momentum` must not be zero: a body at rest shows nothing. Leave it out for a general one.")
    rate = float(np.linalg.norm(np.linalg.solve(tensor, L)))
    if not (isinstance(dt, int | float) and math.isfinite(dt) and 0.0 < dt * rate <= LIMITS.max_step_angle):
        most = LIMITS.max_step_angle
        raise InvalidInput(f"`dt` must be a step of {most} rad at most, here {most / rate:.4g} s; got {shown(dt)}.")
    steps = check.whole("steps", steps, LIMITS.min_steps, LIMITS.max_steps)
    engine = SteppedEngine(step, tensor, convention)
    return JudgeReport(name, (judge_engine(engine, q / np.linalg.norm(q), L, float(dt), steps),))


def judge_file(path: str | Path, spec: str | Path | None = None) -> JudgeReport:
    """Judge the states that an engine wrote into a JSON file, as ``polhode judge`` does.

    The file is an object with `format` "polhode engine states", `version` 1, `engine` (a name), and `runs`, a list of
    objects: `motion` (a name of the table of motions) or `inertia` (three moments or 3 × 3), `attitude` and `momentum`
    or `angular_velocity` at time 0; `times`, `attitudes` (wxyz, body → space), and `momenta` or `angular_velocities`;
    `dt`; `axes`, "body" or "space", of the rates. A run that has neither motion nor inertia is of the spec. Runs of one
    motion with dt, dt/2 and dt/4 are judged together by their limit. A run that cannot be judged is listed in
    ``refused``: one with a number that is not finite, with a key of another name, or with two starts.

    Args:
        path: of the file.
        spec: of a free body, for runs that name no motion.

    Raises:
        InvalidInput: for a file that cannot be read, has another format or unknown keys at its top, and for a spec of
            anything but a free body.
    """
    place = as_path("path", path)
    given = None if spec is None else _of_spec(as_path("spec", spec))

    def make() -> JudgeReport:
        name, states, refused = read_engine_states(place, given)
        judged, more = judge_states(states)
        return JudgeReport(name, tuple(judged), (*refused, *more))

    return with_inputs(make)


def _of_spec(path: Path) -> GivenMotion:
    spec = read_spec(path)
    motion = spec.motion().trajectory.motion
    if not isinstance(motion, FreeMotion):
        raise InvalidInput(f"{path}: is of kind {spec.kind.name}; judged are free bodies. Give the spec of one.")
    axes = np.eye(3) if motion.axes is None else np.asarray(motion.axes)
    inertia = axes @ np.diag(np.asarray(motion.moments)) @ axes.T
    return GivenMotion(path.stem, inertia, np.asarray(motion.attitude_at_epoch), np.asarray(motion.momentum_at_epoch))
