"""Attitudes as SciPy's rotations, which apply to vectors as polhode's do: body → space."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from polhode import rotation
from polhode._base.extras import needing
from polhode.errors import InvalidInput
from polhode.formats.attitude_checks import single_attitude
from polhode.motion._trajectory import Trajectory

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation, RotationSpline


def as_rotation(trajectory: Trajectory) -> Rotation:
    """Return the attitude (T,) of one body as SciPy's ``Rotation``; ``.apply(v_body)`` gives v_space.

    Args:
        trajectory: of one body. With a frame the rotations are of the given axes, otherwise of the trajectory's own.

    Raises:
        InvalidInput: for motions without attitude, batches, and trajectories without samples.

    >>> import numpy as np, polhode as ph
    >>> trajectory = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 2.0, 0.3)).sample(np.linspace(0.0, 5.0, 6))
    >>> space = as_rotation(trajectory).apply(trajectory.momentum)  # constant
    >>> bool(np.abs(space - (0.1, 2.0, 0.3)).max() < 1e-14)
    True
    """
    return rotation.as_scipy(single_attitude(trajectory.along("given"), "a Rotation"))


def as_rotation_spline(trajectory: Trajectory) -> RotationSpline:
    """Return SciPy's interpolating spline through the attitude of one body; its rates are along the body axes.

    Between samples it is as good as they are close; ``FreeMotion`` and ``LagrangeMotion`` are exact at any time.

    Args:
        trajectory: of one body, at two times or more that ascend.

    Raises:
        InvalidInput: as ``as_rotation``, and for times that do not ascend.
    """
    with needing("Rotations of SciPy need", alone=True):
        from scipy.spatial.transform import RotationSpline

    turns, times = as_rotation(trajectory), np.asarray(trajectory.times)
    ascending = np.diff(times) > 0
    if not (len(ascending) and ascending.all()):
        what = "got one"
        if len(ascending):
            what = f"sample {int(np.argmin(ascending)) + 1} does not come after the one before"
        raise InvalidInput(f"`times` of a spline must be two or more that ascend; {what}. Leave out what repeats.")
    return RotationSpline(times, turns)
