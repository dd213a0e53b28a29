"""The method ``plot`` of motions and trajectories, which calls the figures of the rooms above."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Plotted:
    """Base of what can be plotted: motions in closed form and trajectories."""

    __slots__ = ()

    def plot(self: Any) -> Figure:
        """Return the picture that shows most of the motion, a matplotlib figure; notebooks show it at once.

        A free body's is its momentum sphere, with Ω and L over time; a top's is the path of its axis, with tilt and
        Ω; of other trajectories, every part of the state. ``polhode.figures`` draws each on axes of yours, and
        ``polhode.figures.save(motion.plot(), "motion.png")`` writes a file.

        Raises:
            InvalidInput: for a batch of several bodies, or a trajectory without samples.
        """
        import polhode  # which hands in what draws, as pictures know motions and not motions pictures

        return polhode.plot(self)
