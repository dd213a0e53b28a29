"""What the figures of a free body draw."""

from __future__ import annotations

from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.formats.given_axes import along_principal_axes
from polhode.motion.trajectory import Trajectory


def free_motion_of(trajectory: Trajectory) -> tuple[FreeMotion, Trajectory]:
    """Return the exact motion of one free body, and its samples, both along the principal axes.

    Raises:
        InvalidInput: for a trajectory of anything else, a batch, or one without samples.
    """
    samples = along_principal_axes(trajectory)
    motion = samples.motion
    if not isinstance(motion, FreeMotion):
        made = "a file" if samples.source is None else type(samples.source).__name__
        raise InvalidInput(f"the figure is of a FreeMotion; got a trajectory of {made}. Sample a FreeMotion for it.")
    if samples.batch_shape or not len(samples):
        raise InvalidInput(
            f"the figure is of one body at one time at least; got {len(samples)} samples of a batch of shape "
            f"{samples.batch_shape}. Take one body, and give it times."
        )
    return motion, samples
