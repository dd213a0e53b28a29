"""The live view: what sliders ask for is what is drawn, in the app and in a browser; ports, and how it ends."""

import re
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from polhode import rotation
from polhode.bodies.surface import box_of_same_inertia
from polhode.cli.live import run_live
from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.viewer.live import LiveApp
from polhode.viewer.live_motion import Setting, allowed, picture_of
from sweeping import first

MOMENTS = np.array([1.0, 2.0, 2.6])
SINGLE = 1e-6
"""What goes to the browser is float32, relative to lengths of about 1."""
ROUNDING = 1e-12
TIME_STEP = 1e-4  # of the slider, in periods
EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def app():
    app = LiveApp(Setting.of(MOMENTS, np.array([0.3, 2.0, 0.4])), name="a <b>body</b>", port=0)
    app.play.value = False
    yield app
    app.stop()


def drawn(app, name):
    return np.asarray(app.nodes[name].points, dtype=float)


# ---------------------------------------------------------------------- the motion behind it


@pytest.mark.parametrize("velocity", [(0.3, 2.0, 0.4), (1.0, 0.0, 0.0), (0.0, -2.0, 0.0), (-1.0, 0.5, -2.0)])
def test_a_setting_says_the_velocity_it_came_from(velocity):
    setting = Setting.of(MOMENTS, np.array(velocity))
    assert setting.velocity == pytest.approx(velocity, abs=ROUNDING)
    attitude, momentum = setting.motion().state(0.7)
    # L points up at all times
    up = rotation.rotate(attitude, momentum) / np.linalg.norm(momentum)
    assert up == pytest.approx([0.0, 0.0, 1.0], abs=ROUNDING)


@pytest.mark.parametrize("moments", [(1.0, 2.0, 2.6), (2.6, 1.0, 2.0), (2.0, 2.0, 1.0), (1.5, 1.5, 1.5)])
def test_all_curves_belong_to_the_motion(moments):
    """Levels of the energy, in whatever order the moments are; the contact is on the plane, and at rest."""
    moments = np.array(moments)
    picture = picture_of(Setting.of(moments, np.array([0.3, 1.0, 0.4])))

    def energy(unit):
        return 0.5 * np.sum(unit**2 / moments, axis=-1)

    own = picture.own
    assert energy(own) == pytest.approx(energy(own[0, 0]), rel=ROUNDING)
    if len(picture.separatrix):
        middle = np.sort(moments)[1]
        assert energy(picture.separatrix) == pytest.approx(0.5 / middle, rel=ROUNDING)
    for curve in (picture.family, picture.separatrix, own):
        assert np.linalg.norm(curve, axis=-1) == pytest.approx(1.0, rel=ROUNDING)
    # the herpolhode lies in the plane, and polhode and herpolhode are equally long, as nothing slips
    assert picture.herpolhode[..., 2] == pytest.approx(picture.plane_height, abs=ROUNDING)
    pose, later = picture.at(0.3), picture.at(0.3 + 1e-6)
    speed = np.linalg.norm(later.contact - pose.contact) / 1e-6
    inside = [rotation.rotate(rotation.conjugate(p.attitude), p.contact) for p in (pose, later)]
    assert np.linalg.norm(inside[1] - inside[0]) / 1e-6 == pytest.approx(speed, rel=1e-4, abs=1e-6)
    # the point that touches is where the axis of rotation pierces the ellipsoid
    assert np.cross(pose.velocity, pose.contact) == pytest.approx(0.0, abs=ROUNDING)


def test_a_moment_may_be_what_a_body_has():
    assert allowed([1.0, 2.0, 2.6], 0) == pytest.approx((0.6, 4.6))
    low, high = allowed([1.0, 2.0, 2.6], 2)
    for value in (low, high):
        assert box_of_same_inertia(np.array([1.0, 2.0, value])) is not None
    assert box_of_same_inertia(np.array([1.0, 2.0, high + 0.01])) is None


# ---------------------------------------------------------------------- the app


def test_sliders_move_the_scene_as_the_exact_motion_says(app):
    app.moments[0].value, app.off.value, app.around.value = 1.5, 40.0, 110.0
    app.time.value = 0.35
    moments = np.array([1.5, 2.0, 2.6])
    off, around = np.radians([40.0, 110.0])
    velocity = app.setting.rate * np.array([np.sin(off) * np.sin(around), np.cos(off), np.sin(off) * np.cos(around)])
    motion = FreeMotion(moments, moments * velocity, app.picture.motion.attitude_at_epoch)
    attitude, momentum = motion.state(0.35 * motion.period)
    assert np.asarray(app.nodes["body/turning"].wxyz) == pytest.approx(attitude, abs=ROUNDING)
    assert np.asarray(app.nodes["poinsot/turning"].wxyz) == pytest.approx(attitude, abs=ROUNDING)
    unit = momentum / np.linalg.norm(momentum)
    assert np.asarray(app.nodes["point"].position) == pytest.approx(unit, abs=ROUNDING)
    # the running point is on the polhode drawn, between two of its points
    gap = np.linalg.norm(drawn(app, "sphere/own") / 1.004 - unit, axis=-1).min()
    assert gap < np.pi / 300
    omega = rotation.rotate(attitude, momentum / moments)
    arrow = drawn(app, "body/velocity")[0, 1]
    assert arrow / np.linalg.norm(arrow) == pytest.approx(omega / np.linalg.norm(omega), abs=SINGLE)
    box = box_of_same_inertia(moments).vertices
    assert np.asarray(app.nodes["solid"].vertices) == pytest.approx(box / np.linalg.norm(box[0]), abs=SINGLE)
    assert f"{motion.period:.6g} s" in app.readout.content and motion.regime in app.readout.content


def test_a_body_that_cannot_be_is_held(app):
    app.moments[2].value = 3.9
    assert app.moments[2].value == pytest.approx(3.0) and "I3 ≤ I1 + I2" in app.message.content
    app.moments[1].value = 2.5
    assert app.moments[1].value == 2.5 and app.message.content == ""
    app.moments[0].value = 0.2
    assert app.moments[0].value == pytest.approx(0.5) and "I1 ≥ |I2 − I3|" in app.message.content
    assert np.sort(app.picture.setting.moments) == pytest.approx([0.5, 2.5, 3.0])


@pytest.mark.parametrize("typed", first(1, [float("nan"), 1e9, 0.0]))
def test_a_value_typed_beyond_its_slider_is_held_at_the_end(app, typed):
    for slider in (app.rate, app.off, app.around, app.time, app.pace, *app.moments):
        before = slider.value
        slider.value = typed
        app.advance(0.1)
        rate, moments = app.setting.rate, app.picture.setting.moments
        assert app.rate.min <= rate <= app.rate.max and 0.0 <= app.time.value < 20.0
        assert moments.min() > 0.0 and 2.0 * moments.max() <= moments.sum() * (1.0 + ROUNDING)
        assert np.isfinite(drawn(app, "sphere/own")).all() and "nan" not in app.readout.content
        if slider is app.rate:
            assert rate == (slider.max if typed == 1e9 else slider.min) and "held" in app.spin_message.content
        slider.value = before


def test_numbers_are_short_and_stand_for_the_exact_body():
    moments, velocity = np.array([6.000834567, 2.12345678, 7.0001234]) * 1e-5, np.array([3e-5, 7.1234567e-5, 1e-6])
    start = Setting.of(moments, velocity)
    app = LiveApp(start, port=0)
    try:
        for slider in (*app.moments, app.rate, app.off, app.around):
            assert len(f"{slider.value:g}") <= 6 and len(f"{slider.min:g}") <= 5 and len(f"{slider.max:g}") <= 5
        assert app.setting.moments == pytest.approx(moments, rel=ROUNDING)
        assert app.setting.velocity == pytest.approx(velocity, rel=ROUNDING)
        app.moments[0].value = 6.5
        assert app.setting.moments == pytest.approx([6.5e-5, *moments[1:]], rel=ROUNDING)
    finally:
        app.stop()


def test_play_goes_on_and_begins_anew(app):
    app.pace.value, app.time.value = 4.0, 19.9
    app.advance(1.0)
    assert app.time.value == pytest.approx(0.15, abs=TIME_STEP)


def test_the_bodys_own_shape_is_drawn_until_its_moments_change():
    from polhode.cli.live import _start

    start, surface, name = _start(EXAMPLES / "t_handle.toml")
    app = LiveApp(start, surface, name, port=0)
    try:
        assert len(app.nodes["solid"].vertices) == len(surface.vertices) != 8
        app.moments[0].value *= 1.1
        assert len(app.nodes["solid"].vertices) == 8
    finally:
        app.stop()


# ---------------------------------------------------------------------- the command


def test_a_port_that_is_taken():
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        with pytest.raises(InvalidInput, match=f"port {port} .* taken.*--port"):
            run_live(None, port, False)
    with pytest.raises(InvalidInput, match="65535"):
        run_live(None, 70000, False)


def test_what_the_live_view_does_not_show(tmp_path):
    with pytest.raises(InvalidInput, match=r"top\.toml.*free bodies"):
        run_live(EXAMPLES / "top.toml", 0, False)
    still = tmp_path / "still.toml"
    still.write_text('[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n')
    with pytest.raises(InvalidInput, match="spin"):
        run_live(still, 0, False)


def test_interrupting_ends_it_cleanly():
    command = [sys.executable, "-m", "polhode.cli.main", "live", "--port", "0", "--no-open"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        port = int(re.search(r"127\.0\.0\.1:(\d+)", running.stdout.readline())[1])
        time.sleep(0.5)
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=60)
    assert running.returncode == 0 and "Traceback" not in errors
    with socket.socket() as trial:
        assert trial.connect_ex(("127.0.0.1", port)) != 0


# ---------------------------------------------------------------------- a browser


@pytest.mark.browser
def test_the_page_loads_and_a_slider_in_it_moves_the_motion(app, browser):
    errors, outside = [], []
    # small, as software draws every frame of it, and drawing without pause starves everything else on a busy machine
    page = browser.new_page(viewport={"width": 480, "height": 320})
    page.set_default_timeout(60_000)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda line: errors.append(line.text) if line.type == "error" else None)
    inside = (app.address, app.address.replace("http", "ws"), "data:", "blob:")
    page.on("request", lambda asked: None if asked.url.startswith(inside) else outside.append(asked.url))
    page.goto(app.address)
    page.wait_for_selector("canvas")
    page.get_by_text("a <b>body</b>", exact=True).wait_for()
    field = page.locator("input[type=text], input[inputmode=decimal]").first
    before = app.moments[0].value
    field.fill("1.25")
    field.press("Enter")
    until = time.monotonic() + 30.0
    while app.moments[0].value == before and time.monotonic() < until:
        page.wait_for_timeout(100)
    folder = Path(__file__).parents[2] / "build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    page.wait_for_timeout(1500)
    page.screenshot(path=folder / "live.png")
    page.close()
    assert app.moments[0].value == pytest.approx(1.25) and app.picture.setting.moments[0] == pytest.approx(1.25)
    assert not errors and not outside
