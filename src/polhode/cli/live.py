"""``polhode live [SPEC]``: sliders for a body and its spin, in the browser."""

from __future__ import annotations

import signal
import webbrowser
from pathlib import Path

import numpy as np
import typer

from polhode.bodies.surface import Surface
from polhode.cli.stopping import Stopped
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.viewer.live import LiveApp
from polhode.viewer.live_motion import Setting

# without a spec: moments as of a T-handle, spun about the middle axis
MOMENTS, VELOCITY = (1.0, 2.0, 2.6), (0.0, 6.0, 0.1)


def run_live(path: Path | None, port: int, open_it: bool) -> None:
    """Start the app, open it, and play until interrupted."""
    start, surface, name = _start(path)
    app = LiveApp(start, surface, name, port)
    typer.echo(f"{app.address}  (Ctrl-C ends it)")
    try:
        if open_it and not webbrowser.open(app.address):
            typer.echo("polhode: no browser was found to open it. Open the address yourself.", err=True)
        app.run()
    except Stopped as stop:
        if stop.number != signal.SIGINT:
            raise
        stop.expected = True
    finally:
        app.stop()


def _start(path: Path | None) -> tuple[Setting, Surface | None, str]:
    """Return what the sliders begin with, the body's surface along its principal axes, and its name."""
    if path is None:
        return Setting.of(np.array(MOMENTS), np.array(VELOCITY)), None, "a body"
    spec = read_spec(path)
    if not spec.kind.is_default or spec.body is None:
        raise InvalidInput(f"{path}: the live view shows free bodies. Leave out [system], or see it by `polhode view`.")
    frame = spec.body.frame
    momentum, _ = spec.start(frame.moments, frame.axes)
    if not frame.moments[0] > 0.0 or not np.linalg.norm(momentum) > 0.0:
        raise InvalidInput(f"{path}: the live view needs three positive moments and a spin. Give the spec a [spin].")
    surface = spec.surface
    drawn = None if surface is None else surface.along(frame)
    return Setting.of(frame.moments, momentum / frame.moments), drawn, spec.name
