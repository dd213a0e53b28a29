"""What a page reaches by steps is the motion that Python steps; its spec brings it back, and it goes on for ever."""

from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode.kinds.page import write_page
from polhode.kinds.reading import read_spec
from viewer.test_instrument import STEPPED_SAME, drawn, miss_of, settings_of

pytestmark = pytest.mark.browser


COPIED = {
    "heavy-top": "{system: {mgl: 2.5}, spin: {angular_velocity: [1, 0.2, 3]}}",
    "damped-body": "{system: {damping: 0.1}, spin: {angular_velocity: [1, 0.2, 0.3]}}",
}


@pytest.mark.parametrize("kind", COPIED)
def test_the_spec_of_what_is_stepped_gives_the_same_motion(kind, opened, tmp_path):
    start = packed(GIVEN[kind], (0.8, 0.6, 0.0, 0.0), (0.3, 1.8, 1.5))
    sampled = ph.simulate(GIVEN[kind], start, np.linspace(0.0, 6.0, 61), step=0.01, order=6)
    page = opened(write_page(sampled, tmp_path / "stepped.html"))
    assert page.tab.evaluate(f"window.polhode.set({COPIED[kind]})")
    spec = tmp_path / "again.toml"
    spec.write_text(page.tab.evaluate("window.polhode.spec()"))
    assert miss_of(replace(read_spec(spec), until=5.0, samples=400).report().trajectory, page) < STEPPED_SAME


STEPPED = {
    "heavy-top": lambda moments, system: ph.systems.HeavyTop(moments, system["mgl"], system["axis"]),
    "gyrostat": lambda moments, system: ph.systems.Gyrostat(
        moments, np.multiply(system["rotor_momentum"], system["rotor_axis"])
    ),
    "damped-body": lambda moments, system: ph.systems.DoubleBracket(moments, system["sink_rate"]),
}
GIVEN = {
    "heavy-top": ph.systems.HeavyTop((1.0, 2.0, 2.5), 1.5, (0.3, 0.0, 1.0)),
    "gyrostat": ph.systems.Gyrostat((1.0, 2.0, 3.0), (0.0, 0.4, 0.0)),
    "damped-body": ph.systems.DoubleBracket((1.0, 2.0, 3.0), 0.02),
}


def packed(system, attitude, momentum):
    if isinstance(system, ph.systems.HeavyTop):
        return system.pack(attitude, momentum=momentum)
    return np.concatenate([attitude, momentum])


OTHERS = [pytest.param(name, marks=pytest.mark.sweep) for name in ("heavy-top", "damped-body")]


@pytest.mark.parametrize("kind", ["gyrostat", *OTHERS])
def test_what_has_no_closed_form_is_stepped(kind, opened, tmp_path):
    start = packed(GIVEN[kind], (0.8, 0.6, 0.0, 0.0), (0.3, 1.8, 1.5))
    sampled = ph.simulate(GIVEN[kind], start, np.linspace(0.0, 6.0, 61), step=0.01, order=6)
    page = opened(write_page(sampled, tmp_path / "stepped.html"))
    assert page.count() == 61 and page.tab.locator("#instrument").is_visible()
    attitude, momentum = drawn(page, [0.0, 3.0, 6.0])
    assert attitude == pytest.approx(sampled.attitude[[0, 30, 60]], abs=STEPPED_SAME)
    assert momentum == pytest.approx(sampled.momentum[[0, 30, 60]], abs=STEPPED_SAME)
    page.tab.locator(".control:has(#set-spin-tilt) input[type=range]").fill("640")
    settings = settings_of(page)
    assert settings["system"]["kind"] == kind
    moments = np.array((settings["system"] if kind == "heavy-top" else settings["body"])["moments"])
    system = STEPPED[kind](moments, settings["system"])
    inner = np.asarray(getattr(system, "rotor", np.zeros(3)))
    first = moments * settings["spin"]["angular_velocity"] + inner
    start = packed(system, settings["spin"]["attitude"], first)
    again = ph.simulate(system, start, np.array([0.0, 6.0]), step=0.01, order=6)
    attitude, momentum = drawn(page, [6.0])
    assert attitude[0] == pytest.approx(again.attitude[-1], abs=STEPPED_SAME)
    assert momentum[0] == pytest.approx(again.momentum[-1], abs=STEPPED_SAME)
    assert np.abs(momentum[0] - sampled.momentum[-1]).max() > 1e-3 and not page.complaints


def test_samples_of_what_is_stepped_go_on_for_ever(opened, tmp_path):
    start = packed(GIVEN["gyrostat"], (0.8, 0.6, 0.0, 0.0), (0.3, 1.8, 1.5))
    sampled = ph.simulate(GIVEN["gyrostat"], start, np.linspace(0.0, 6.0, 61), step=0.01, order=6)
    page = opened(write_page(sampled, tmp_path / "stepped.html"))
    page.tab.evaluate("window.polhode.goTo(5.99)")
    page.tab.locator("#play").click()
    page.until("window.polhode.shown().time > 6.5")
    assert page.tab.evaluate("window.polhode.playing") is True and not page.complaints
