"""A body to play with: sliders for its moments and spin, and its motion, exact, as they move (extra ``live``)."""

from __future__ import annotations

import contextlib
import io
import socket
import threading
import time
from collections.abc import Iterator
from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput, not_installed
from polhode.types import Array
from polhode.viewer.live_motion import Picture, Pose, Setting, allowed, picture_of

HOST = "127.0.0.1"  # only this machine: the page has no password
FRAMES = 30  # a second
SHOWN = 20  # periods on the time slider
DIGITS = 4  # shown of a value; its box has room for six characters
LEAST, MOST = 0.02, 2.5  # of the largest moment at first: ends of the sliders
BODY_AT, SPHERE_AT, POINSOT_AT = (-2.7, 0.0, 0.0), (0.0, 0.0, 0.0), (2.7, 0.0, 0.0)
OMEGA_LONG, L_LONG = 1.25, 1.55
TURNED = (0.446, 0.0, 0.0, -0.895)  # of the momentum sphere, so that axes 1 and 2 come towards the viewer
# Okabe & Ito's palette, as in the figures
BLUE, VERMILION, PURPLE = (0, 114, 178), (213, 94, 0), (204, 121, 167)
GREY, STEEL, PALE, DARK = (130, 130, 130), (170, 184, 200), (225, 228, 232), (34, 34, 34)
COLOURS = "Black: L. Purple: Ω. Blue: this motion's polhode. Vermilion: separatrix and herpolhode. Grey: others."


class LiveApp:
    """The running app. Moving a slider, here or in the browser, makes the motion again.

    Args:
        start: what it begins with.
        surface: of the body along its principal axes, drawn until the moments change.
        name: of the body.
        port: where the browser finds it; 0 for any free one.

    Raises:
        InvalidInput: for a port that is taken or forbidden, a body at rest or without moments, and without viser.
    """

    def __init__(self, start: Setting, surface: Surface | None = None, name: str = "body", port: int = 8080):
        if not (np.min(start.moments) > 0.0 and start.rate > 0.0):
            raise InvalidInput("the live view needs a body with three positive moments that spins; give it a [spin].")
        viser = _viser()
        _check_port(port)
        self.start, self.surface, self.lock = start, surface, threading.RLock()
        with contextlib.redirect_stdout(io.StringIO()):  # its banner; the command says where it is
            self.server = viser.ViserServer(host=HOST, port=port, label=f"polhode: {name}", verbose=False)
        self.port = int(self.server.get_port())
        if port and self.port != port:
            self.stop()
            raise InvalidInput(_taken(port))
        self.unit = 10.0 ** np.floor(np.log10(np.max(start.moments)))
        self.rate_unit = 1.0 if 1e-2 <= start.rate < 1e3 else 10.0 ** np.floor(np.log10(start.rate))
        self.busy = False
        self.nodes: dict[str, Any] = {}
        self._controls(name)
        self._stage()
        self._rebuild()

    @property
    def address(self) -> str:
        """Where the browser finds it."""
        return f"http://{HOST}:{self.port}"

    def stop(self) -> None:
        """Close every connection and free the port."""
        self.server.stop()

    def run(self) -> None:
        """Play until interrupted."""
        while True:
            before = time.monotonic()
            time.sleep(1.0 / FRAMES)
            if self.play.value:
                self.advance(time.monotonic() - before)

    def advance(self, seconds: float) -> None:
        """Go on by so much of the viewer's time; at the end of the slider begin again."""
        self.time.value = round((_kept(self.time) + seconds / _kept(self.pace)) % SHOWN, 4)

    @property
    def setting(self) -> Setting:
        """What the sliders say, a value typed beyond the ends of one being that end."""
        off, around = np.radians([self._value(self.off), self._value(self.around)])
        moments = np.array([self._value(slider) for slider in self.moments]) * self.unit
        return Setting(moments, self._value(self.rate) * self.rate_unit, float(off), float(around))

    def _value(self, slider: Any) -> float:
        """Return what a slider stands for: at first that is more than its rounded number says."""
        shown, exact = self.first[id(slider)]
        return exact if slider.value == shown else _kept(slider)

    # ------------------------------------------------------------------ controls

    def _controls(self, name: str) -> None:
        gui, start = self.server.gui, self.start
        self.first: dict[int, tuple[float, float]] = {}  # the number each shows at first, and its exact one
        largest = float(np.max(start.moments)) / self.unit
        least = min(LEAST * largest, 0.5 * float(np.min(start.moments)) / self.unit)
        unit = _times(self.unit) + "kg m²"
        gui.add_markdown(f"**{_plain(name)}**")
        with gui.add_folder("Moments of inertia"):
            self.moments = [
                self._slider(f"I{k + 1} [{unit}]", _short(least), _short(MOST * largest), float(value) / self.unit)
                for k, value in enumerate(start.moments)
            ]
            self.message = gui.add_markdown("")
        with gui.add_folder("Spin at first"):
            rate, unit = float(start.rate / self.rate_unit), _times(self.rate_unit) + "rad/s"
            off, around = float(np.degrees(start.off)), float(np.degrees(start.around))
            self.rate = self._slider(f"|Ω| [{unit}]", _short(0.02 * rate), _short(4.0 * rate), rate)
            self.off = self._slider("Ω from axis 2 [°]", 0.0, 180.0, off, 0.01)
            self.around = self._slider("around it, from axis 3 [°]", 0.0, 360.0, around, 0.01)
            self.spin_message = gui.add_markdown("")
        with gui.add_folder("Time"):
            self.play = gui.add_checkbox("play", True)
            self.time = gui.add_slider("periods", 0.0, float(SHOWN), 1e-3, 0.0)
            self.pace = gui.add_slider("a period takes [s]", 1.0, 30.0, 0.1, 6.0)
        self.readout = gui.add_markdown("")
        gui.add_markdown(COLOURS)
        for k, slider in enumerate(self.moments):
            slider.on_update(lambda _, k=k: self._moment_moved(k))
        for slider in (self.rate, self.off, self.around):
            slider.on_update(lambda _: self._spin_moved())
        self.time.on_update(lambda _: self._show())

    def _slider(self, label: str, low: float, high: float, first: float, step: float | None = None) -> Any:
        """Return a slider whose numbers are short enough for its box."""
        step = step or float(10.0 ** (np.floor(np.log10(first)) - DIGITS + 1))
        shown = round(first, max(0, round(-np.log10(step))))
        slider = self.server.gui.add_slider(label, low, high, step, shown)
        self.first[id(slider)] = (shown, first)
        return slider

    def _spin_moved(self) -> None:
        """Say where a value typed beyond its slider is held; its box is left alone, as one may be typing there."""
        held = [slider for slider in (self.rate, self.off, self.around) if _kept(slider) != slider.value]
        self.spin_message.content = " ".join(f"{_plain(s.label)}: held at {_kept(s):.4g}." for s in held)
        self._rebuild()

    def _moment_moved(self, k: int) -> None:
        """Keep a moment to what a body can have together with the two others, and say so."""
        with self.lock:
            if self.busy:
                return
            low, high = allowed([self._value(s) for s in self.moments], k)
            value, inside = float(self.moments[k].value), self._value(self.moments[k])
            kept = min(max(inside, low), high)
            i, j = (n + 1 for n in range(3) if n != k)
            if inside != _kept(self.moments[k]) and kept == inside:  # the number shown at first
                kept = value
            if kept != value:
                with self._quietly():
                    self.moments[k].value = kept
                rule = f"I{k + 1} ≤ I{i} + I{j}" if value > high else f"I{k + 1} ≥ |I{i} − I{j}|"
                self.message.content = (
                    f"Held at {kept:.4g}, an end of its slider." if kept == inside
                    else f"Held at {kept:.4g}: a body has {rule}. Move the others first."
                )  # fmt: skip
            else:
                self.message.content = ""
            self._rebuild()

    @contextlib.contextmanager
    def _quietly(self) -> Iterator[None]:
        self.busy = True
        try:
            yield
        finally:
            self.busy = False

    # ------------------------------------------------------------------ scene

    def _stage(self) -> None:
        """Draw what never changes."""
        scene = self.server.scene
        scene.set_up_direction("+z")
        self.server.initial_camera.position = (0.9, -5.6, 1.9)
        self.server.initial_camera.look_at = (0.9, 0.0, 0.15)
        for name, place, words in (("body", BODY_AT, "body in space"), ("sphere", SPHERE_AT, "momentum, body axes"),
                                   ("poinsot", POINSOT_AT, "Poinsot's ellipsoid")):  # fmt: skip
            self.nodes[name] = scene.add_frame(f"/{name}", show_axes=False, position=place,
                                               wxyz=TURNED if name == "sphere" else (1.0, 0.0, 0.0, 0.0))  # fmt: skip
            scene.add_label(f"/{name}/words", words, position=(0.0, 0.0, 1.95), anchor="bottom-center")
        for name in ("body", "poinsot"):
            self.nodes[f"{name}/turning"] = scene.add_frame(f"/{name}/turning", show_axes=False)
        scene.add_icosphere("/sphere/ball", radius=0.992, color=PALE, subdivisions=5, opacity=0.85)
        for k in range(3):
            axis = np.eye(3)[k]
            scene.add_line_segments(f"/sphere/axis{k + 1}", np.stack([axis, 1.2 * axis])[None], DARK, thickness=0.012)
            scene.add_label(f"/sphere/name{k + 1}", f"L{k + 1}", position=tuple(1.28 * axis), anchor="center-center")
        self.nodes["point"] = scene.add_icosphere("/sphere/point", radius=0.045, color=BLUE)
        self.nodes["contact"] = scene.add_icosphere("/poinsot/contact", radius=0.03, color=BLUE)
        up = np.array([[[0.0, 0.0, 0.0], [0.0, 0.0, L_LONG]]])
        for where in ("body", "poinsot"):
            self.nodes[f"{where}/L"] = _arrow(scene, f"/{where}/L", up, DARK)
            scene.add_label(f"/{where}/L/name", "L", position=(0.0, 0.0, L_LONG + 0.06), anchor="bottom-center")
        self.nodes["body/velocity"] = _arrow(scene, "/body/velocity", up, PURPLE)
        self.nodes["body/velocity/name"] = scene.add_label("/body/velocity_name", "Ω", anchor="center-center")

    def _rebuild(self) -> None:
        """Draw the motion that the sliders ask for."""
        with self.lock:
            setting = self.setting
            same = np.allclose(setting.moments, self.start.moments, rtol=1e-9)
            self.picture = picture = picture_of(setting, self.surface if same else None)
            scene = self.server.scene
            self.nodes["solid"] = scene.add_mesh_simple(
                "/body/turning/solid", _floats(picture.body.vertices), _indices(picture.body.faces), color=STEEL,
                flat_shading=True, side="double")  # fmt: skip
            self.nodes["ellipsoid"] = scene.add_mesh_simple(
                "/poinsot/turning/ellipsoid", _floats(picture.ellipsoid.vertices), _indices(picture.ellipsoid.faces),
                color=PALE, opacity=0.7, side="double")  # fmt: skip
            self._curves(picture)
            self.readout.content = picture.readout()
            self._show()

    def _curves(self, picture: Picture) -> None:
        scene = self.server.scene
        for name, pieces, colour, width in (
            ("sphere/family", picture.family, GREY, 0.008), ("sphere/separatrix", picture.separatrix, VERMILION, 0.015),
            ("sphere/own", 1.004 * picture.own, BLUE, 0.03), ("poinsot/turning/polhode", picture.polhode, BLUE, 0.02),
            ("poinsot/herpolhode", picture.herpolhode, VERMILION, 0.012),
        ):  # fmt: skip
            old = self.nodes.pop(name, None)
            if len(pieces):
                self.nodes[name] = scene.add_line_segments(f"/{name}", _floats(pieces), colour, thickness=width)
            elif old is not None:
                old.remove()
        self.nodes["plane"] = scene.add_box(
            "/poinsot/plane", color=(205, 200, 190), dimensions=(2.6, 2.6, 0.004), opacity=0.45,
            position=(0.0, 0.0, picture.plane_height - 0.003))  # fmt: skip

    def _show(self) -> None:
        """Move everything to the time on the slider."""
        with self.lock, self.server.atomic():
            pose: Pose = self.picture.at(_kept(self.time) * self.picture.clock)
            for name in ("body/turning", "poinsot/turning"):
                self.nodes[name].wxyz = tuple(pose.attitude)
            self.nodes["point"].position = tuple(pose.momentum)
            self.nodes["contact"].position = tuple(pose.contact)
            self.nodes["body/velocity"].points = _floats(np.stack([np.zeros(3), OMEGA_LONG * pose.velocity])[None])
            self.nodes["body/velocity/name"].position = tuple((OMEGA_LONG + 0.14) * pose.velocity)


def _arrow(scene: Any, name: str, points: Array, colour: tuple[int, int, int]) -> Any:
    return scene.add_arrows(name, _floats(points), colour, shaft_radius=0.018, head_radius=0.05, head_length=0.13)


def _kept(slider: Any) -> float:
    """Return a slider's value, or its end where more was typed into its box."""
    value = float(slider.value)
    return min(max(value, float(slider.min)), float(slider.max)) if np.isfinite(value) else float(slider.min)


def _short(end: float) -> float:
    """Return the end of a slider with two digits, as it is written beneath."""
    return float(f"{end:.1e}")


def _times(unit: float) -> str:
    power = round(np.log10(unit))
    return f"10^{power} " if power else ""


def _floats(values: Array) -> Array:
    return np.ascontiguousarray(values, dtype=np.float32)


def _indices(faces: Array) -> Array:
    return np.ascontiguousarray(faces, dtype=np.uint32)


def _plain(name: str) -> str:
    """Return a name without what Markdown would read as marks."""
    return "".join(f"\\{c}" if c in "\\`*_{}[]<>()#+-.!|" else c for c in name)


def _taken(port: int) -> str:
    return f"port {port} of this machine is taken. Give another with --port, or 0 for any free one."


def _check_port(port: int) -> None:
    """Refuse a port that cannot be had; viser itself would go on to the next one without a word."""
    if not 0 <= port < 65536:
        raise InvalidInput(f"`port` must be from 0 to 65535; got {port}. Leave it out for 8080.")
    with socket.socket() as trial:
        trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            trial.bind((HOST, port))
        except PermissionError:
            raise InvalidInput(f"port {port} is not for everyone. Give one from 1024 on with --port.") from None
        except OSError:
            raise InvalidInput(_taken(port)) from None


def _viser() -> Any:
    try:
        import viser
    except ImportError:
        raise not_installed("live views", "viser", "live") from None
    return viser
