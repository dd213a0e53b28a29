"""Pages: one self-contained HTML file with a motion and the code that draws it."""

from __future__ import annotations

import base64
import hashlib
import html
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import resources
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput, shown
from polhode.motion._trajectory import Trajectory
from polhode.reports.wording import unit_in_words
from polhode.types import Array
from polhode.viewer.encoding import as_script_json, pack, with_powers
from polhode.viewer.panels import (
    PageContent,
    choose_content,
    choose_title,
    choose_up,
    find_free_moments,
    keeps_motion_of,
)
from polhode.viewer.samples import Samples, take_samples

UNTRUSTED = "This is the page of a motion. Run this cell, or trust the notebook, to see it."


@dataclass(frozen=True, repr=False)
class NotebookPage:
    """A page inside a frame of its own, as notebooks show it.

    Attributes:
        page: the whole HTML text.
        height: of the frame [pixels].
    """

    page: str
    height: int

    def __repr__(self) -> str:
        """Return the text for a console, or for a notebook that is not trusted."""
        return (
            "<a page of polhode: notebooks show it once they are trusted; elsewhere `write_page` makes a file of it>"
        )

    def _repr_html_(self) -> str:
        # browsers never show the words inside a frame; a notebook that is not trusted drops the frame and keeps them
        return (
            f'<iframe srcdoc="{html.escape(self.page)}" width="100%" height="{self.height}" '
            'sandbox="allow-scripts" allow="clipboard-write *" style="border:0" title="polhode: a motion">'
            f"{UNTRUSTED}</iframe>"
        )


class Page(NamedTuple):
    """The content of a page.

    Attributes:
        title: of the motion.
        data: for its script.
        scripts: of panels that the page's own script does not know.
    """

    title: str
    data: dict[str, Any]
    scripts: tuple[str, ...]

    @property
    def text(self) -> str:
        """The whole HTML; characters that UTF-8 cannot write, as half a pair is, become "?"."""
        return _fill_template(self.title, self.data, self.scripts).encode("utf-8", "replace").decode("utf-8")


def make_page(
    trajectory: Trajectory, *, name: str | None, summary: str, surface: Surface | None,
    notes: Sequence[str], content: Callable[[Trajectory, Samples, Surface | None], PageContent | None],
    scatters: Sequence[dict[str, Any]] = (),
) -> Page:
    """Return the content of a page of one motion.

    Args:
        trajectory: of one body.
        name: heading of the page; what moves, if left out.
        summary: a sentence below it.
        surface: what the body looks like, in the given axes.
        notes: more lines below.
        content: function of trajectory, samples and surface that chooses the pictures; None from it for those of any
            body.
        scatters: more to draw of two numbers against each other.

    Raises:
        InvalidInput: for a trajectory that is empty, a batch, not finite, or has nothing to draw.
    """
    check_given(trajectory, name, summary, notes)
    samples = take_samples(trajectory)
    frame = trajectory.frame
    drawn = surface if surface is None or frame is None else surface.along(frame)
    shown = content(trajectory, samples, drawn) or choose_content(trajectory.source, samples, drawn, frame)
    if not shown.panels:
        raise InvalidInput(
            "the page has nothing to draw: this motion has neither an attitude nor a momentum that a sphere could "
            "show. Give the state its attitude, or write a dataset instead."
        )
    title = name or choose_title(trajectory.source)
    model = shown.model or make_model(trajectory)
    # how samples were chosen is of no concern where the page solves the motion at any time
    solved = shown.solved if shown.model else model is not None
    chosen = () if solved else samples.notes
    said = [note[:1].upper() + note[1:] for note in (*map(with_powers, chosen), *notes)]
    data = {
        "name": title, "summary": summary, "notes": said, "notesOnSamples": len(chosen), "panels": shown.panels,
        "drift": {key: float(np.max(value)) for key, value in trajectory.drift.items() if np.size(value)},
        "model": model, "scatters": [*shown.scatters, *scatters],
        "plots": _plots(trajectory, samples) if shown.plots is None else shown.plots,
        **_arrays(trajectory.source, samples, solved), **shown.words,
    }  # fmt: skip
    return Page(title, data, shown.scripts)


def make_playground(presets: Sequence[tuple[Page, dict[str, Any]]]) -> Page:
    """Return the content of a page of many motions, which shows one at a time.

    Args:
        presets: each motion, with its key, title and story.
    """
    scripts = tuple(dict.fromkeys(script for page, _ in presets for script in page.scripts))
    return Page("polhode: a playground", {"presets": [page.data | words for page, words in presets]}, scripts)


def check_given(trajectory: Any, name: Any, summary: Any, notes: Any) -> None:
    """Raise InvalidInput for anything but a trajectory and texts."""
    if not isinstance(trajectory, Trajectory):
        raise InvalidInput(
            f"the page shows an exact motion, a trajectory, a report or a spec; got {type(trajectory).__name__}. Give "
            "it a FreeMotion, or what `simulate`, `report` or `read_spec` returns."
        )
    if name is not None and not isinstance(name, str):
        raise InvalidInput(f"`name` must be text; got {shown(name)}. Put it in quotes.")
    check.instance("summary", summary, str, "text", "Put it in quotes.")
    if isinstance(notes, str) or not all(isinstance(note, str) for note in notes):
        check.refuse("notes", "a list of texts", notes, "Put each line in quotes, all in brackets.")


def make_model(trajectory: Trajectory) -> dict[str, Any] | None:
    """Return the data of an exact motion for the page's own solver, along its principal axes; None for others."""
    motion = trajectory.motion
    if motion is None or motion.batch_shape or not motion.page_solver:
        return None
    names_it = next(one for one in type(motion).__mro__ if "page_solver" in vars(one))
    if not keeps_motion_of((names_it,), motion):
        return None
    along = motion.along("principal")
    numbers = {name: float(getattr(along, name)) for name in along.body_numbers}
    return {
        "solver": motion.page_solver, "moments": np.asarray(along.moments).tolist(), **numbers,
        "momentum": np.asarray(along.momentum_at_epoch).tolist(),
        "attitude": np.asarray(along.attitude_at_epoch).tolist(), "epoch": float(along.epoch),
        **({} if trajectory.frame is None or trajectory.frame.mass is None else {"mass": float(trajectory.frame.mass)}),
    }  # fmt: skip


def _arrays(system: Any, samples: Samples, solved: bool) -> dict[str, Any]:
    """Return the samples, or only their times where the page has the closed form of the motion."""
    turn, up = choose_up(system, samples)

    def array(values: Array | None, kind: str = "f8") -> dict[str, Any] | None:
        return None if values is None else pack(values, kind)

    return {
        "times": pack(samples.times),
        **({} if solved else {
            "attitude": array(samples.attitude), "momentum": array(samples.momentum),
            "velocity": array(samples.angular_velocity, "f4"), "energy": array(samples.energy),
        }),
        "energyName": samples.energy_name, "energyUnit": samples.energy_unit, "joined": samples.joined,
        "free": find_free_moments(system, samples),
        "space": turn.tolist(), "up": up,
    }  # fmt: skip


def _plots(trajectory: Trajectory, samples: Samples) -> list[dict[str, Any]]:
    """Return the angles and rates of a state that has no attitude, to be drawn against time."""
    if samples.attitude is not None:
        return []
    layout = trajectory.layout
    return [
        {"title": name.replace("_", " "), "unit": unit_in_words(part.unit),
         "series": [{"name": name, "values": pack(layout.part(samples.states, name), "f4")}]}
        for name, part in layout.scalars.items()
    ]


def _fill_template(title: str, data: dict[str, Any], scripts: tuple[str, ...]) -> str:
    """Return the template with style, script and data in their places, and the policy that allows only these."""
    assets = resources.files("polhode.viewer") / "assets"
    template, style, script = (
        (assets / name).read_text("utf-8") for name in ("template.html", "page.css", "page.js")
    )
    allowed = " ".join(f"'{_hash(one)}'" for one in (*scripts, script))
    policy = (
        f"default-src 'none'; script-src {allowed}; style-src '{_hash(style)}'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    panels = "".join(f"<script>{one}</script>\n" for one in scripts)
    parts = {
        "policy": policy, "title": html.escape(title), "style": style, "script": script, "data": as_script_json(data),
        "panels": panels,
    }  # fmt: skip
    pieces = template.split("@@")
    # odd pieces name a part; the content of a part is not searched again
    return "".join(parts[piece] if k % 2 else piece for k, piece in enumerate(pieces))


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")
