"""Any trajectory over time, one panel for each part of its state."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.errors import InvalidInput, shown
from polhode.figures import style
from polhode.motion._layout import StatePart
from polhode.motion._trajectory import Trajectory
from polhode.reports.wording import unit_in_words
from polhode.types import Array

FORMS = ("-", "--", "-.", ":")
COLOURS = (style.BLUE, style.ORANGE, style.GREEN, style.VERMILION, style.SKY, style.PURPLE, style.DARK, style.GREY)


def parts(trajectory: Trajectory, *, axes: Any = None) -> Figure:
    """Return every part of the state against time, one above the other.

    Args:
        trajectory: of one body or system.
        axes: as many of matplotlib's as the state has parts; a new figure without them.

    Raises:
        InvalidInput: for a batch, or a trajectory without samples.

    >>> from polhode import FreeMotion
    >>> motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0, 0.5, 1.0])
    >>> [panel.get_ylabel() for panel in parts(motion).axes]
    ['attitude', 'momentum\\n[kg m²/s, body]']
    """
    most = 8  # components drawn of one part; more curves would be confused
    part_height = 1.45  # inches
    if not isinstance(trajectory, Trajectory):
        raise InvalidInput(f"the figure is of a trajectory; got {shown(trajectory)}. Sample a motion for it.")
    if trajectory.batch_shape or not len(trajectory):
        raise InvalidInput(
            f"the figure is of one body or system at one time at least; got {len(trajectory)} samples of a batch of "
            f"shape {trajectory.batch_shape}. Take one of it, and give it times."
        )
    columns = _columns(trajectory)
    figure, panels = style.axes_for(axes, len(columns), height=max(2.2, 0.6 + part_height * len(columns)))
    times = np.asarray(trajectory.times)
    slow = style.power_of_ten((times[0], times[-1]))
    for panel, (part, values) in zip(panels, columns, strict=True):
        power = style.power_of_ten(values)
        count = min(values.shape[1], most)
        for k in range(count):
            panel.plot(times / 10.0**slow, values[:, k] / 10.0**power, color=COLOURS[k], lw=1.0, ls=FORMS[k % 4],
                       marker="o" if len(times) == 1 else None, ms=3, label=_label(part, k))
        panel.set_ylabel(_title(part, power, values.shape[1], count))
        if count > 1:
            panel.legend(fontsize=style.FONT - 2, frameon=False, ncols=count, loc="lower right", borderaxespad=0.1,
                         bbox_to_anchor=(1.0, 1.0), handlelength=1.6, columnspacing=1.0)
        if len(times) > 1:
            panel.set_xlim(times[0] / 10.0**slow, times[-1] / 10.0**slow)
        style.tidy(panel)
    style.label_time(panels, f"time  [{style.factor(slow)}s]")
    return figure


def _columns(trajectory: Trajectory) -> list[tuple[StatePart, Array]]:
    """Return each part with its values (T, size); the whole state as one where its parts have no names."""
    states, count = np.asarray(trajectory.states), len(trajectory)
    if np.iscomplexobj(states):
        real, imaginary = (part.reshape(count, -1) for part in (np.real(states), np.imag(states)))
        return [(StatePart("real part", real.shape[1]), real), (StatePart("imaginary part"), imaginary)]
    if not trajectory.layout.parts:
        whole = states.reshape(count, -1)
        return [(StatePart("state", whole.shape[1]), whole)]
    return [(part, np.asarray(trajectory.part(part.name)).reshape(count, -1)) for part in trajectory.layout.parts]


def _label(part: StatePart, k: int) -> str:
    return "wxyz"[k] if part.name == "attitude" else str(k + 1)


def _title(part: StatePart, power: int, size: int, shown: int) -> str:
    unit = "" if part.unit in ("", "1") else unit_in_words(part.unit)
    frame = "given axes" if part.frame == "given" else part.frame
    inside = ", ".join(filter(None, [f"{style.factor(power)}{unit}".strip(), frame]))
    first = f"\nfirst {shown} of {size}" if shown < size else ""
    return part.name.replace("_", " ") + (f"\n[{inside}]" if inside else "") + first
