"""The interface of the exact motion that a trajectory was sampled from."""

from __future__ import annotations

import abc
from typing import TYPE_CHECKING

from polhode.motion.plotting import Plotted
from polhode.types import Array, ArrayLike, Float64, Real

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


class ExactMotion(Plotted, abc.ABC):
    """A motion in closed form, known at any time."""

    @abc.abstractmethod
    def sample(self, times: Real[ArrayLike, "time"] | None = None) -> Trajectory:
        """Return the motion at times (T,) [s]."""

    @abc.abstractmethod
    def _standing(self, axes: Float64[Array, "3 3"] | None) -> ExactMotion:
        """Return the motion along other axes, in which the columns of ``axes`` are the principal ones."""
