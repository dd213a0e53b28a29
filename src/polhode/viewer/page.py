"""Pages: one HTML file that holds a motion and all that draws it, and asks for nothing from outside."""

from __future__ import annotations

import base64
import hashlib
import html
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from polhode.bodies.frame import BodyFrame
from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput, shown
from polhode.formats.paths import written_whole
from polhode.report.base import AbstractReport
from polhode.trajectory import Trajectory
from polhode.viewer.encoding import as_script_json, packed, with_powers
from polhode.viewer.panels import free_moments_of, panels_of, title_of, up_of
from polhode.viewer.samples import Samples, samples_of

Array = Any


@dataclass(frozen=True)
class NotebookPage:
    """A page inside a frame of its own, as notebooks show it.

    Attributes:
        page: the whole HTML text.
        height: of the frame [pixels].
    """

    page: str
    height: int

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{html.escape(self.page)}" width="100%" height="{self.height}" '
            'sandbox="allow-scripts" style="border:0" title="polhode: a motion"></iframe>'
        )


def write_page(
    trajectory: Trajectory,
    path: str | Path,
    *,
    name: str | None = None,
    summary: str = "",
    frame: BodyFrame | None = None,
    surface: Surface | None = None,
    notes: Sequence[str] = (),
) -> Path:
    """Write a motion as one HTML file that opens from disk; the file appears whole or not at all.

    Args:
        trajectory: of one body.
        path: the file; its folder must exist.
        name: heading of the page; the object's or the system's name if left out.
        summary: a sentence below it.
        frame: the principal axes that the trajectory is along, which a surface in given axes needs.
        surface: what the body looks like, in the given axes; without it, a shape with the same inertia is drawn.
        notes: more lines below.

    Raises:
        InvalidInput: for a trajectory that is empty, a batch, not finite, or has nothing to draw, and for a path that
            cannot be written.

    >>> import polhode as ph, tempfile, pathlib
    >>> motion = ph.FreeMotion((1.0, 2.0, 3.0), (0.3, 1.8, 1.5))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = write_page(motion.sample([0.0, 1.0, 2.0]), pathlib.Path(folder) / "motion.html", name="a body")
    ...     path.stat().st_size < 1_500_000
    True
    """
    path = Path(path)
    text = page_text(trajectory, name=name, summary=summary, frame=frame, surface=surface, notes=notes)
    with written_whole(path) as draft:
        draft.write_text(text, "utf-8")
    return path


def show(
    trajectory: Trajectory,
    *,
    name: str | None = None,
    summary: str = "",
    frame: BodyFrame | None = None,
    surface: Surface | None = None,
    notes: Sequence[str] = (),
    height: int = 600,
) -> NotebookPage:
    """Return a motion's page for a notebook to show; arguments as of ``write_page``, height [pixels]."""
    text = page_text(trajectory, name=name, summary=summary, frame=frame, surface=surface, notes=notes)
    return NotebookPage(text, height)


def page_of_report(report: AbstractReport, path: str | Path, *, name: str, surface: Surface | None = None) -> Path:
    """Write the page of a report's motion, with what the report says of it.

    Args:
        report: any.
        path: the file.
        name: heading of the page.
        surface: what the body looks like, in the given axes.

    Raises:
        InvalidInput: as ``write_page`` does.
    """
    trajectory, notes = report.shown, list(report.notes)
    if trajectory is not report.trajectory and trajectory.status not in ("exact", "successful"):
        notes.append(f"Shown: the last turns, until the disk is {trajectory.status}.")
    return write_page(
        trajectory, path, name=name, summary=with_powers(report.summary), frame=report.frame, surface=surface,
        notes=[with_powers(note) for note in notes],
    )  # fmt: skip


def page_text(
    trajectory: Trajectory, *, name: str | None, summary: str, frame: BodyFrame | None, surface: Surface | None,
    notes: Sequence[str],
) -> str:  # fmt: skip
    """Return the whole page; characters that UTF-8 cannot write, as half a pair is, become "?"."""
    check_given(trajectory, name, summary, notes)
    samples = samples_of(trajectory)
    drawn = surface if surface is None or frame is None else surface.along(frame)
    panels = panels_of(trajectory.system, samples, drawn)
    if not panels:
        raise InvalidInput(
            "the page has nothing to draw: this motion has neither an attitude nor a momentum that a sphere could "
            "show. Give the state its attitude, or write a dataset instead."
        )
    title = name or title_of(trajectory.system)
    said = [note[:1].upper() + note[1:] for note in (*map(with_powers, samples.notes), *notes)]
    data = {
        "name": title, "summary": summary, "notes": said, "panels": panels,
        "drift": {key: float(np.max(value)) for key, value in trajectory.drift.items() if np.size(value)},
        **_arrays(trajectory.system, samples),
    }  # fmt: skip
    return _filled(title, data).encode("utf-8", "replace").decode("utf-8")


def check_given(trajectory: Any, name: Any, summary: Any, notes: Any) -> None:
    """Raise InvalidInput for what is no trajectory or no text."""
    if not isinstance(trajectory, Trajectory):
        raise InvalidInput(
            f"the page shows a Trajectory; got {type(trajectory).__name__}. Give it what `sample` or `solve` returns."
        )
    if name is not None and not isinstance(name, str):
        raise InvalidInput(f"`name` must be text; got {shown(name)}. Put it in quotes.")
    if not isinstance(summary, str):
        raise InvalidInput(f"`summary` must be text; got {shown(summary)}. Put it in quotes.")
    if isinstance(notes, str) or not all(isinstance(note, str) for note in notes):
        raise InvalidInput(
            f"`notes` must be a list of texts; got {shown(notes)}. "
            "Put each line in quotes, all in brackets."
        )


def _arrays(system: Any, samples: Samples) -> dict[str, Any]:
    turn, up = up_of(system, samples)

    def array(values: Array | None, kind: str = "f8") -> dict[str, Any] | None:
        return None if values is None else packed(values, kind)

    return {
        "times": packed(samples.times), "attitude": array(samples.attitude), "momentum": array(samples.momentum),
        "velocity": array(samples.angular_velocity, "f4"), "energy": array(samples.energy),
        "energyName": samples.energy_name, "energyUnit": samples.energy_unit, "joined": samples.joined,
        "free": free_moments_of(system, samples),
        "space": turn.tolist(), "up": up,
    }  # fmt: skip


def _filled(title: str, data: dict[str, Any]) -> str:
    """Return the template with style, script and data in their places, and the policy that allows only these."""
    assets = resources.files("polhode.viewer") / "assets"
    template, style, script = (
        (assets / name).read_text("utf-8") for name in ("template.html", "page.css", "page.js")
    )
    policy = (
        f"default-src 'none'; script-src '{_hash(script)}'; style-src '{_hash(style)}'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    parts = {
        "policy": policy, "title": html.escape(title), "style": style, "script": script, "data": as_script_json(data),
    }  # fmt: skip
    pieces = template.split("@@")
    # odd pieces name a part; nothing inside a part is looked at again
    return "".join(parts[piece] if k % 2 else piece for k, piece in enumerate(pieces))


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")
