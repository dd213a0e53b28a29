"""One sentence on the motion of a free body."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode.analysis.cone import axis_angles, cone_angles, rotation_form
from polhode.exact.free_body import FreeMotion
from polhode.motion._inputs import number_of
from polhode.reports.wording import angles, in_its_unit
from polhode.types import Float64, FloatOrArray


class HeadlineLimits(NamedTuple):
    """A number that decides how a steady motion is described."""

    max_angle: float = 1e-12  # rad; an axis as near to L counts as the one that the body spins about


LIMITS = HeadlineLimits()


def headline(motion: FreeMotion) -> str:
    """Return the sentence, by the form of the rotation."""
    if motion.regime == "separatrix":
        return (
            "Exactly on the separatrix: in all of time L goes once from one end of the intermediate axis to the other."
        )
    return {
        "rest": lambda motion: "The body is at rest.", "steady": _steady, "coning": _describe_coning,
        "tumbling": _describe_tumbling, "flipping": _describe_flipping,
    }[rotation_form(motion)](motion)


def _steady(motion: FreeMotion) -> str:
    turn = in_its_unit(2.0 * math.pi / float(np.linalg.norm(motion.momentum_at_epoch / motion.moments)))
    if motion.regime == "spherical":
        return f"Steady spin: all moments are equal, and the body turns about a fixed axis, once in {turn}."
    leaning = axis_angles(motion)
    assert leaning is not None
    near = [k for k in range(3) if min(leaning[k, 1], math.pi - leaning[k, 0]) < LIMITS.max_angle]
    about = f"axis {near[0] + 1}{_rank(motion, near[0])}" if near else "an axis of the plane of equal moments"
    return f"Steady spin about {about}, fixed in the body and in space, once in {turn}."


def _describe_coning(motion: FreeMotion) -> str:
    axis = _find_encircled_axis(motion)
    return (
        f"Spin about axis {axis + 1}{_rank(motion, axis)}, which cones (nutates): it leans {_cone(motion)} from "
        f"the angular momentum L and goes round it every {_word_time(motion.tumbling_periods[0])}; in the body L goes "
        f"round it every {_word_time(motion.period)}."
    )


def _describe_tumbling(motion: FreeMotion) -> str:
    axis = _find_encircled_axis(motion)
    return (
        f"Tumbling: axis {axis + 1}{_rank(motion, axis)} leans {_cone(motion)} from the angular momentum L and "
        f"goes round it every {_word_time(motion.tumbling_periods[0])}, while the body rolls about that axis: L is "
        f"back in the body every {_word_time(motion.period)}."
    )


def _describe_flipping(motion: FreeMotion) -> str:
    moments = np.asarray(motion.moments)
    middle, axis = int(np.argsort(moments, kind="stable")[1]), _find_encircled_axis(motion)
    turns = 0.5 * number_of(motion.precession_per_period) / (2.0 * math.pi)
    return (
        f"Flipping: the body turns over along axis {middle + 1}, its intermediate one, every "
        f"{_word_time(motion.flip_interval)}, {turns:.3g} turns about the angular momentum L; axis "
        f"{axis + 1}{_rank(motion, axis)} leans {_cone(motion)} from L."
    )


def _word_time(answer: Float64[FloatOrArray, ""] | None) -> str:
    return in_its_unit(number_of(answer))


def _find_encircled_axis(motion: FreeMotion) -> int:
    axis = motion.encircled_axis
    assert isinstance(axis, int)
    return axis


def _cone(motion: FreeMotion) -> str:
    cone = cone_angles(motion)
    assert cone is not None
    return angles(cone)


def _rank(motion: FreeMotion, axis: int) -> str:
    """Return a phrase on whether an axis has the largest, middle or smallest moment."""
    moments = np.asarray(motion.moments)
    if (moments == moments[axis]).sum() > 1:
        return ""
    return (" (least moment)", " (intermediate moment)", " (largest moment)")[int((moments < moments[axis]).sum())]
