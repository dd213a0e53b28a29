"""The panels that a kind adds to its page."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from polhode.errors import InvalidInput

if TYPE_CHECKING:
    from polhode.bodies.surface import Surface
    from polhode.motion._trajectory import Trajectory
    from polhode.viewer.panels import PageContent, Panel
    from polhode.viewer.samples import Samples


class KindPanel:
    """The pictures of a kind; ``panel.js`` in its folder draws those that the page does not have already.

    A kind with a motion overrides ``panels``, ``plots``, ``model`` or ``scatters``; one without overrides ``shown`` and
    ``content``.
    """

    def panels(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> list[Panel] | None:
        """Return the panels; None for those of any body.

        Args:
            trajectory: of the kind.
            samples: of it, as the page shows them, along the principal axes.
            surface: of the body, along the axes of the samples.
        """
        return None

    def plots(self, trajectory: Trajectory, samples: Samples) -> dict[str, Any]:
        """Return ``plots`` and ``scatters`` of ``PageContent``, by name; by default Ω, angles or parts are plotted."""
        return {}

    def model(self, trajectory: Trajectory) -> dict[str, Any] | None:
        """Return the page's own solver for this motion and its numbers; None where the page shows the samples alone."""
        return None

    def scatters(self, report: Any) -> tuple[dict[str, Any], ...]:
        """Return the further pictures of a report's page."""
        return ()

    def shown(self, report: Any) -> Trajectory:
        """Return the motion that the page of a report without a motion shows.

        Raises:
            InvalidInput: where there is nothing to show.
        """
        raise InvalidInput(f"a report of kind {report.kind} has nothing that moves to show.")

    def content(self, report: Any, samples: Samples, surface: Surface | None) -> PageContent:
        """Return the pictures on the page of a report without a motion of its own.

        Raises:
            InvalidInput: where there is nothing to show.
        """
        raise InvalidInput(f"a report of kind {report.kind} has nothing to show on a page.")
