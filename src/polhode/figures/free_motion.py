"""The motion that the figures of a free body draw, from a trajectory or an exact motion."""

from __future__ import annotations

import numpy as np

from polhode.errors import InvalidInput
from polhode.errors import shown as in_words
from polhode.exact.free_body import FreeMotion
from polhode.motion._trajectory import Trajectory


def take_free_motion(shown: Trajectory | FreeMotion) -> tuple[FreeMotion, Trajectory]:
    """Return the exact motion of one free body, and its samples, both along the principal axes.

    Args:
        shown: samples, or a motion, of which three periods are taken; three turns where it has no period.

    Raises:
        InvalidInput: for a trajectory of anything else, a batch, or one without samples.
    """
    if not isinstance(shown, FreeMotion | Trajectory):
        raise InvalidInput(f"the figure is of a FreeMotion, or of samples of one; got {in_words(shown)}.")
    samples = (_sample(shown) if isinstance(shown, FreeMotion) else shown).along("principal")
    motion = samples.motion
    if not isinstance(motion, FreeMotion):
        origin = "a file" if samples.source is None else type(samples.source).__name__
        raise InvalidInput(f"the figure is of a FreeMotion; got a trajectory of {origin}. Sample a FreeMotion for it.")
    if samples.batch_shape or not len(samples):
        raise InvalidInput(
            f"the figure is of one body at one time at least; got {len(samples)} samples of a batch of shape "
            f"{samples.batch_shape}. Take one body, and give it times."
        )
    return motion, samples


def _sample(motion: FreeMotion) -> Trajectory:
    periods, samples = 3, 1000
    if motion.batch_shape:
        raise InvalidInput(f"the figure is of one body; got a batch of shape {motion.batch_shape}. Take one of it.")
    return motion.sample(float(motion.epoch) + np.linspace(0.0, periods * motion.cycle, samples))
