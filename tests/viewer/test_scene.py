"""The body's scene: arrows and cones to switch, a frame that does not spin, the ellipsoid, and the disk's sound."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.kinds.page import write_page
from polhode.kinds.reading import read_spec

pytestmark = pytest.mark.browser
EXAMPLES = Path(__file__).parents[2] / "examples"
DRAWN = 2e-6
"""Of lengths of order one, which the graphics card has in single precision."""
DIFFERENCE = 1e-4
"""Of dL/dt by central differences over a thousandth of a turn."""
ARROWS, CONES = ("L", "Ω", "mg", "τ"), ("space cone", "body cone", "axis cone")


@pytest.fixture(scope="module")
def top_page(tmp_path_factory):
    """A leaning top that nods."""
    lean = math.radians(40.0)
    attitude = (math.cos(0.5 * lean), math.sin(0.5 * lean), 0.0, 0.0)
    motion = ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.2, 3.0), attitude=attitude)
    return write_page(motion, tmp_path_factory.mktemp("top") / "top.html")


@pytest.fixture(scope="module")
def coning():
    """An oblate body whose axis cones about L, so that its cones are circular."""
    return ph.FreeMotion((1.0, 1.0, 1.8), momentum=(0.6, 0.0, 1.8))


@pytest.fixture(scope="module")
def coning_page(coning, tmp_path_factory):
    return write_page(coning, tmp_path_factory.mktemp("coning") / "coning.html")


def box(page, part):
    return page.tab.locator(f"input[data-part='{part}']")


def test_each_arrow_is_switched_by_its_checkbox(top_page, opened):
    page = opened(top_page)
    for name in ARROWS:
        assert page.measure("body")["vectors"][name]
        box(page, name).uncheck()
        shown = page.measure("body")["vectors"]
        assert shown[name] is None and all(shown[other] for other in ARROWS if other != name)
        box(page, name).check()
        assert page.measure("body")["vectors"][name]
    assert not page.complaints


def test_checkboxes_are_reached_and_pressed_by_keys(coning_page, opened):
    page = opened(coning_page)
    keys, met = page.tab.keyboard, []
    part = "document.activeElement.dataset.part ?? null"
    while len(met) < 60 and not {"L", "Ω", *CONES, "energy"} <= set(met):
        if {"L", "Ω", *CONES} <= set(met):
            page.enlarge("sphere")  # small pictures have no legend
        keys.press("Tab")
        met.append(page.tab.evaluate(part))
        if met[-1] == "L":
            before = page.position()
            keys.press(" ")
            assert page.measure("body")["vectors"]["L"] is None
            assert page.position() == before and not page.tab.evaluate("window.polhode.playing")
    assert {"L", "Ω", *CONES, "energy"} <= set(met)
    assert all(one.get_attribute("aria-label") for one in page.tab.locator("input[type=checkbox]").all())


def test_a_choice_stays_when_the_picture_is_drawn_anew(coning_page, opened):
    page = opened(coning_page)
    box(page, "Ω").uncheck()
    page.tab.locator("#theme").click()
    assert page.measure("body")["vectors"]["Ω"] is None and not box(page, "Ω").is_checked()
    assert page.tab.evaluate("window.polhode.set({spin: {rate: 3}})")
    assert page.measure("body")["vectors"]["Ω"] is None


def test_cones_are_those_of_omega_and_of_the_axis(coning, coning_page, opened):
    cones = opened(coning_page).measure("body")["cones"]
    L, axis = np.array([0.6, 0.0, 1.8]), np.array([0.0, 0.0, 1.0])
    omega = L / np.array([1.0, 1.0, 1.8])

    def between(a, b):
        return math.acos(a @ b / np.linalg.norm(a) / np.linalg.norm(b))

    wanted = {"space cone": between(omega, L), "body cone": between(omega, axis), "axis cone": between(L, axis)}
    for name, half in wanted.items():
        assert cones[name]["halves"] == pytest.approx([half, half], abs=DRAWN) and cones[name]["shown"]
    # an oblate body's space cone lies inside of its body cone, which rolls round it: the angles differ by the axis'
    assert wanted["body cone"] - wanted["space cone"] == pytest.approx(wanted["axis cone"])


def test_a_body_that_turns_over_begins_without_cones(example_page, opened):
    page = opened(example_page("t_handle"))
    assert not any(cone["shown"] for cone in page.measure("body")["cones"].values())
    box(page, "space cone").check()
    assert page.measure("body")["cones"]["space cone"]["shown"]
    page.picture("t_handle-space-cone")


def torque_misses(page, sign=1.0):
    """Return by how much the drawn torque misses dL/dt in direction, at some times."""
    worst, times = 0.0, page.times()
    for k in (10, len(times) // 3, len(times) // 2):
        page.seek(k)
        step, states = 1e-3, []
        for time in (times[k] - step, times[k] + step):
            found = page.tab.evaluate("time => window.polhode.state(time)", time)
            states.append(rotation.rotate(np.array(found["attitude"]), np.array(found["momentum"])))
        rate = (states[1] - states[0]) / (2.0 * step)
        drawn = sign * np.array(page.measure("body")["vectors"]["τ"]["tip"])
        worst = max(worst, float(np.linalg.norm(rate / np.linalg.norm(rate) - drawn / np.linalg.norm(drawn))))
    return worst


def test_the_torque_is_how_fast_l_changes(top_page, opened):
    page = opened(top_page)
    assert torque_misses(page) < DIFFERENCE
    assert torque_misses(page, sign=-1.0) > 1.0  # r × mg with the weight upward


def test_the_weight_hangs_from_the_axis(top_page, opened):
    page = opened(top_page)
    page.seek(50)
    body = page.measure("body", "vectors", "axisTip")
    weight, tip = body["vectors"]["mg"], np.array(body["axisTip"])
    assert weight["tip"][:2] == pytest.approx([0.0, 0.0], abs=DRAWN) and weight["tip"][2] < 0.0
    assert np.cross(weight["from"], tip) == pytest.approx(np.zeros(3), abs=DRAWN)


def off_the_ellipsoid(drawn, axes):
    """Return by how much points of the polhode, unit vectors, miss the ellipsoid."""
    points = np.reshape(drawn["path"], (-1, 3))
    return float(np.abs(np.sum((points / axes) ** 2, axis=1) - 1.0).max())


def test_sphere_and_ellipsoid_meet_in_the_polhode(example_page, opened):
    page = opened(example_page("t_handle"))
    assert not page.measure("sphere")["surface"]["shown"]
    page.enlarge("sphere")  # small pictures have no legend
    box(page, "energy").check()
    drawn = page.measure("sphere")
    axes = np.array(drawn["surface"]["axes"])
    moments = np.asarray(read_spec(EXAMPLES / "t_handle.toml").body.principal_moments)
    assert axes / axes[0] == pytest.approx(np.sqrt(moments / moments[0]))  # L_k² / (2 E I_k) = 1
    assert off_the_ellipsoid(drawn, axes) < DRAWN
    assert off_the_ellipsoid(drawn, axes * [1.01, 1.0, 1.0]) > 1e-3
    corners = np.reshape(drawn["surface"]["corners"], (-1, 3)) / 0.995  # as the drawn sphere is smaller
    near = corners[np.linalg.norm(corners, axis=1) < 1.3]
    assert len(near) > 1000 and np.abs(np.sum((near / axes) ** 2, axis=1) - 1.0).max() < 1e-5
    page.picture("t_handle-ellipsoid")


def test_the_gyroscopes_frame_leans_with_it_and_does_not_spin(opened, tmp_path):
    spec = replace(read_spec(EXAMPLES / "gyroscope.toml"), until=0.2, samples=400)
    page = opened(write_page(spec, tmp_path / "gyroscope.html"))
    for k in (0, 40, 90):
        page.seek(k)
        body = page.measure("body", "cage", "axisTip", "matrix")
        frame = np.array(body["cage"]).reshape(4, 4).T[:3, :3]
        axis = np.array(body["axisTip"]) / np.linalg.norm(body["axisTip"])
        assert frame[:, 2] == pytest.approx(axis, abs=DRAWN)
        assert frame[2, 0] == pytest.approx(0.0, abs=DRAWN)  # one of its sides stays level
        assert np.linalg.det(frame) == pytest.approx(1.0, abs=DRAWN)
    page.picture("gyroscope-frame")


@pytest.mark.sweep
def test_the_disk_sounds_at_the_rate_of_its_contact(opened, tmp_path):
    spec = replace(read_spec(EXAMPLES / "euler_disk.toml"), until=1.0, samples=400)
    report = spec.report()
    page = opened(write_page(report, tmp_path / "disk.html"))
    button = page.tab.locator("button", has_text="sound")
    assert button.get_attribute("aria-pressed") == "false" and not page.measure("disk")["sound"]["on"]
    assert page.measure("disk")["sound"]["frequency"] is None  # no oscillator before a press
    button.focus()
    page.tab.keyboard.press("Enter")
    assert button.get_attribute("aria-pressed") == "true"
    page.seek(50)
    rate = abs(float(report.disk.precession(report.begin))) / (2.0 * math.pi)
    assert page.measure("disk")["sound"]["rate"] == pytest.approx(rate, rel=0.01)
    sound = "window.polhode.measure('disk').sound"
    page.until(f"Math.abs({sound}.frequency - {sound}.rate) < 0.5")
    page.until(f"{sound}.gain < 0.01")  # nothing moves
    button.click()
    assert not page.measure("disk")["sound"]["on"]
    assert page.requests == [page.url] and not page.complaints
