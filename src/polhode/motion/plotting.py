"""The methods ``plot``, ``show`` and ``save`` of motions and trajectories, which call the rooms above."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.bodies.surface import Surface
    from polhode.viewer.page import NotebookPage


class Plotted:
    """What can be plotted, shown and saved: motions in closed form and trajectories."""

    __slots__ = ()

    # the package is imported inside each method because the code that draws and writes imports motions

    def plot(self: Any) -> Figure:
        """Return the picture that shows most of the motion, a matplotlib figure; notebooks show it at once.

        A free body's is its momentum sphere, with Ω and L over time; a top's is the path of its axis, with tilt and
        Ω; of other trajectories, every part of the state. ``polhode.figures`` draws each on axes of yours, and
        ``polhode.figures.save(motion.plot(), "motion.png")`` writes a file.

        Raises:
            InvalidInput: for a batch of several bodies, or a trajectory without samples.
        """
        import polhode

        return polhode.plot(self)

    def show(
        self: Any, *, name: str | None = None, summary: str = "", surface: Surface | None = None,
        notes: Sequence[str] = (), height: int = 760,
    ) -> NotebookPage:
        """Return the motion's page for a notebook to show, as ``polhode.show`` does.

        Args:
            name: heading of the page; what moves, if left out.
            summary: a sentence below it.
            surface: what the body looks like, in the given axes; without it, a shape with the same inertia is drawn.
            notes: more lines below.
            height: of the frame [pixels].

        Raises:
            InvalidInput: for a trajectory that is empty, a batch, not finite, or has nothing to draw.
        """
        import polhode

        return polhode.show(self, name=name, summary=summary, surface=surface, notes=notes, height=height)

    def save(self: Any, path: str | Path) -> Path:
        """Write the motion into a file that appears whole or not at all, and return its path.

        Of a motion in closed form the samples are those of ``sample()``.

        Args:
            path: its ending chooses the format: .nc, .zarr, .csv, .aem, .bc or .glb, as
                ``polhode.formats.write_motion`` says.

        Raises:
            InvalidInput: for another ending, a motion that the format cannot hold, or a path that cannot be written.
        """
        import polhode

        return polhode.formats.write_motion(self, path)
