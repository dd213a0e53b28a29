"""What is written: whole or not at all, small enough, without a way out, and clear about what cannot be shown."""

import base64
import hashlib
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import polhode as ph
from polhode.bodies.surface import Surface
from polhode.celestial import SpinOrbit
from polhode.errors import InvalidInput
from polhode.formats.labels import AttitudeLabels, Recording
from polhode.kinds.free_body.answers import free_body_report
from polhode.kinds.page import page_of_report, show, write_page
from polhode.kinds.reading import read_spec
from polhode.spacecraft import LinearDrag, RigidBody, Wheel
from polhode.systems import FreeRigidBody, HeavyTop
from polhode.viewer.encoding import with_powers
from polhode.viewer.page import check_given
from polhode.viewer.samples import LIMITS

EXAMPLES = Path(__file__).parents[2] / "examples"
LARGEST = 1_500_000
"""Bytes: what the page promises."""
MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
TIMES = np.linspace(0.0, 20.0, 101)


def data_of(path):
    text = path.read_text("utf-8")
    return json.loads(re.search(r'<script type="application/json" id="motion">(.*?)</script>', text, re.DOTALL)[1])


def array(field):
    kinds = {"f8": "<f8", "f4": "<f4", "u4": "<u4", "u2": "<u2"}
    return np.frombuffer(base64.b64decode(field["data"]), kinds[field["kind"]]).reshape(field["shape"])


def kinds(data):
    return [panel["type"] for panel in data["panels"]]


def test_free_body_has_its_three_panels(tmp_path):
    path = write_page(MOTION.sample(TIMES), tmp_path / "page.html", name="a body")
    data = data_of(path)
    assert kinds(data) == ["body", "sphere", "poinsot"] and data["up"] == "L"
    assert path.stat().st_size < LARGEST
    times = array(data["times"])
    assert (times[0], times[-1]) == (TIMES[0], TIMES[-1]) and "attitude" not in data
    assert data["model"] == {
        "solver": "FreeMotion", "moments": [1.0, 2.0, 3.0], "momentum": [0.3, 1.8, 1.5],
        "attitude": [1.0, 0.0, 0.0, 0.0], "epoch": 0.0,
    }  # fmt: skip
    assert not list(tmp_path.glob(".*"))


@pytest.mark.long
def test_levels_of_the_energy_where_all_turns_with_the_body(tmp_path):
    """With a rotor inside, ½ L·I⁻¹L is not the energy, and its levels say nothing."""
    moments = (1.0, 2.0, 3.0)
    for mounts, torques, levels in (([Wheel((0.0, 0.0, 1.0), 0.1)], [], False), ([], [LinearDrag(0.1)], True)):
        body = RigidBody(moments, mounts, torques)
        start = body.pack((1.0, 0.0, 0.0, 0.0), (0.3, 0.9, 0.5), rates=[8.0] * len(mounts))
        data = data_of(write_page(ph.simulate(body, start, TIMES[:21], estimate_error=False), tmp_path / "page.html"))
        assert kinds(data) == ["body", "sphere"]
        assert (data["panels"][1]["family"] is not None) == levels


def test_principal_axes_of_a_motion_in_given_ones(tmp_path):
    body = ph.Body.from_moments((1.0, 2.0, 3.0))
    turned = ph.Body(None, (0.0, 0.0, 0.0), np.array([[2.0, 0.5, 0.0], [0.5, 1.5, 0.2], [0.0, 0.2, 2.9]]))
    for found in (body, turned):
        motion = ph.FreeMotion.from_body(found, angular_velocity=(0.1, 1.0, 0.3))
        data = data_of(write_page(motion.sample(TIMES), tmp_path / "page.html"))
        momentum, attitude = np.array(data["model"]["momentum"]), np.array(data["model"]["attitude"])
        assert data["model"]["moments"] == found.principal_moments.tolist()
        energy = 0.5 * np.sum(momentum**2 / found.principal_moments)
        assert np.allclose(energy, motion.energy, rtol=1e-13, atol=0)
        in_space = ph.rotation.rotate(attitude, momentum)
        given = ph.rotation.rotate(motion.attitude(0.0), motion.momentum(0.0))
        assert np.allclose(in_space, given, rtol=0, atol=1e-13 * motion.momentum_norm)


def test_page_holds_nothing_that_leads_out():
    page = show(MOTION.sample(TIMES)).page
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page)[1]
    assert policy.startswith("default-src 'none'")
    for tag, kind in (("script", "script"), ("style", "style")):
        inside = re.search(rf"<{tag}>(.*?)</{tag}>", page, re.DOTALL)[1]
        assert f"{kind}-src 'sha256-{base64.b64encode(hashlib.sha256(inside.encode()).digest()).decode()}'" in policy
    markup = re.sub(r"<script.*?</script>|<style.*?</style>", "", page, flags=re.DOTALL)
    assert not re.search(r"https?:|\bsrc=|\bhref=", markup)


@pytest.mark.long
def test_markup_in_names_stays_inside_the_data(tmp_path):
    name = "</script><!-- \u2028 @@script@@"
    path = write_page(MOTION.sample(TIMES), tmp_path / "page.html", name=name, notes=[name])
    text = path.read_text("utf-8")
    assert text.count("</script>") == 2 and "<!--" not in text
    assert data_of(path)["name"] == name


@pytest.mark.long
def test_million_samples_are_thinned_and_it_says_so(tmp_path):
    exact = MOTION.sample(np.linspace(0.0, 20.0, 1_000_000))
    data = data_of(write_page(exact, tmp_path / "exact.html"))
    assert len(array(data["times"])) <= LIMITS.max_samples and not data["notes"]
    stepped = replace(exact, source=FreeRigidBody((1.0, 2.0, 3.0)))
    path = write_page(stepped, tmp_path / "stepped.html")
    data = data_of(path)
    assert data["notes"][0] == "Thinned for display: every 250th of 1000000 samples."
    assert len(array(data["times"])) == LIMITS.max_samples and data["joined"] and path.stat().st_size < LARGEST


def test_many_turns_of_an_exact_motion_begin_with_the_first(tmp_path):
    data = data_of(write_page(MOTION.sample(np.linspace(0.0, 1e6, 500)), tmp_path / "long.html"))
    times = array(data["times"])
    assert times[0] == 0.0 and times[-1] < 2e3 and data["joined"] and not data["notes"]


def test_samples_too_far_apart_are_not_joined(tmp_path):
    sampled = MOTION.sample(np.linspace(0.0, 300.0, 40))
    labelled = replace(sampled, source=Recording(labels=AttitudeLabels()), momentum=None, angular_velocity=None)
    for found in (replace(sampled, source=FreeRigidBody((1.0, 2.0, 3.0))), labelled):
        data = data_of(write_page(found, tmp_path / "apart.html"))
        assert not data["joined"] and any("it jumps" in note for note in data["notes"])


def test_attitudes_alone_and_momentum_alone(tmp_path):
    sampled = replace(MOTION.sample(TIMES), source=Recording("X", labels=AttitudeLabels(object_name="X")))
    alone = replace(sampled, momentum=None, angular_velocity=None)
    data = data_of(write_page(alone, tmp_path / "attitude.html"))
    assert kinds(data) == ["body"] and "surface" not in data["panels"][0]
    bare = replace(MOTION.sample(TIMES), source=FreeRigidBody((1.0, 2.0, 3.0)), attitude=None)
    assert kinds(data_of(write_page(bare, tmp_path / "momentum.html"))) == ["sphere"]


@pytest.mark.long
def test_backward_times_run_forward(tmp_path):
    backward = replace(MOTION.sample(TIMES[::-1]), source=FreeRigidBody((1.0, 2.0, 3.0)))
    assert (np.diff(array(data_of(write_page(backward, tmp_path / "page.html"))["times"])) > 0).all()


def test_at_rest_and_one_sample(tmp_path):
    rest = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 0.0)).sample(TIMES)
    assert kinds(data_of(write_page(rest, tmp_path / "rest.html"))) == ["body"]
    assert kinds(data_of(write_page(MOTION.sample([1.0]), tmp_path / "one.html"))) == ["body", "sphere", "poinsot"]


@pytest.mark.parametrize(("moments", "momentum"), [
    ((1.0, 2.0, 3.0), (0.0, 2.0, 0.0)), ((2.0, 2.0, 2.0), (0.3, 0.4, 0.5)), ((1.0, 1.0, 2.0), (0.3, 0.4, 1.0)),
    ((1.0, 2.0, 9.0), (0.3, 0.4, 1.0)), ((3.0, 1.0, 2.0), (0.3, 0.4, 1.0)),
    ((1e-47, 2e-47, 3e-47), (1e-34, 1e-34, 0.0)),
])  # fmt: skip
def test_all_kinds_of_moments(tmp_path, moments, momentum):
    motion = ph.FreeMotion(moments, momentum=momentum)
    span = 2.0 * np.pi * motion.momentum_norm / motion.energy
    data = data_of(write_page(motion.sample(np.linspace(0.0, span, 200)), tmp_path / "page.html"))
    body, _, _ = data["panels"]
    assert ("ellipsoid" in body) == (2.0 * max(moments) > 1.0001 * sum(moments))
    assert data["model"]["moments"] == list(moments) and data["free"] == list(moments)


def test_surface_is_turned_into_the_axes_of_the_motion(tmp_path):
    body = ph.shapes.box(2.0, (3.0, 1.0, 2.0)).placed(np.eye(3), (5.0, 0.0, 0.0))
    corners = np.array([[x, y, z] for x in (3.5, 6.5) for y in (-0.5, 0.5) for z in (-1.0, 1.0)])
    surface = Surface(corners, np.array([[0, 1, 3], [4, 6, 7], [0, 4, 5]]))
    motion = ph.FreeMotion(body.principal_moments, momentum=(1.0, 2.0, 3.0))
    trajectory = replace(motion.sample(TIMES), frame=body.frame)
    path = write_page(trajectory, tmp_path / "page.html", surface=surface)
    drawn = data_of(path)["panels"][0]
    # edges in the order of the axes of ascending moments: 3, 2 and 1 m
    assert np.allclose(np.abs(array(drawn["surface"]["vertices"])).max(axis=0), (1.5, 1.0, 0.5))
    assert drawn["shape"] == ""


def test_what_cannot_be_shown_is_said(tmp_path):
    batch = ph.FreeMotion((1.0, 2.0, 3.0), momentum=[[0.3, 1.8, 1.5], [0.0, 1.0, 1.0]]).sample(TIMES)
    with pytest.raises(InvalidInput, match=r"one body; got a batch of shape \(2,\)"):
        write_page(batch, tmp_path / "page.html")
    empty = MOTION.sample(TIMES).select(slice(0))
    with pytest.raises(InvalidInput, match="trajectory is empty"):
        write_page(empty, tmp_path / "page.html")
    nothing = replace(MOTION.sample(TIMES), source=Recording(labels=AttitudeLabels()), attitude=None, momentum=None)
    with pytest.raises(InvalidInput, match="nothing to draw"):
        write_page(nothing, tmp_path / "page.html")
    broken = MOTION.sample(TIMES)
    with pytest.raises(InvalidInput, match="`momentum` of the trajectory has NaN"):
        write_page(replace(broken, momentum=np.full((101, 3), np.nan)), tmp_path / "page.html")
    with pytest.raises(InvalidInput, match="cannot be written"):
        write_page(MOTION.sample(TIMES), tmp_path / "nowhere" / "page.html")
    with pytest.raises(InvalidInput, match="is a folder"):
        write_page(MOTION.sample(TIMES), tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(InvalidInput, match="cannot be written"):
        write_page(MOTION.sample(TIMES), tmp_path / "file" / "page.html")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_words_that_are_none(tmp_path):
    sampled = MOTION.sample(TIMES)
    right: dict[str, Any] = {"trajectory": sampled, "name": None, "summary": "", "notes": []}
    wrongs = {"`name` must be text": {"name": 5}, "`summary` must": {"summary": None}, "`notes` must": {"notes": "x"},
              "shows an exact motion, a trajectory, a report or a spec; got int": {"trajectory": 5}}  # fmt: skip
    for words, wrong in wrongs.items():
        with pytest.raises(InvalidInput, match=words):
            check_given(**right | wrong)
    assert data_of(write_page(sampled, tmp_path / "half.html", name="half \ud800 pair"))["name"] == "half ? pair"
    assert data_of(write_page(sampled, tmp_path / "none.html"))["name"] == "Free motion"


def test_numbers_of_its_own_notes_have_powers_of_ten(tmp_path):
    stepped = replace(MOTION.sample(np.linspace(0.0, 20.0, 101)), source=FreeRigidBody((1.0, 2.0, 3.0)))
    note = data_of(write_page(stepped, tmp_path / "long.html", notes=["it lasts 1e+09 s"]))["notes"][0]
    assert note == "It lasts 1e+09 s"  # what a caller says stays as it is
    assert with_powers("the first 2.5e+06 s") == "the first 2.5·10⁶ s"


@pytest.mark.long
def test_what_holds_a_top(tmp_path):
    for name, pivot in (("precessing_top", "post"), ("top", "ground")):
        spec = read_spec(EXAMPLES / f"{name}.toml")
        report = spec.report()
        page = page_of_report(report, tmp_path / "top.html", surface=spec.surface)
        drawn = data_of(page)["panels"][0]
        assert drawn["pivot"] == pivot and "along" not in drawn
    flat = report.trajectory
    axis = np.array([1.0, 2.0, 2.0]) / 3.0
    turn = np.array([1.0 - axis[2], -axis[1], axis[0], 0.0])  # brings the axis down
    hanging = replace(flat, source=HeavyTop((1.0, 2.0, 2.5), 1.0, axis),
                      attitude=np.tile(turn / np.linalg.norm(turn), (len(flat.times), 1)))  # fmt: skip
    drawn = data_of(write_page(hanging, tmp_path / "hanging.html"))["panels"][0]
    assert drawn["pivot"] == "hook" and np.allclose(drawn["along"], axis)


def test_old_page_survives_a_failed_write(tmp_path, monkeypatch):
    path = write_page(MOTION.sample(TIMES), tmp_path / "page.html")
    before = path.read_bytes()

    def full(self, *_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(type(path), "write_text", full)
    with pytest.raises(InvalidInput, match="No space left"):
        write_page(MOTION.sample(TIMES), path)
    assert path.read_bytes() == before and len(list(tmp_path.iterdir())) == 1


def test_frame_of_a_notebook_needs_no_quotes_of_the_page():
    frame = show(MOTION.sample(TIMES), name='"a" & <b>', height=450)._repr_html_()
    assert frame.startswith('<iframe srcdoc="') and 'height="450"' in frame and frame.count('"') == 14
    assert "allow-same-origin" not in frame


def test_page_of_a_report(tmp_path):
    body = ph.shapes.box(1.0, (0.3, 0.2, 0.1))
    report = replace(free_body_report(body, (0.0, 0.01, 1e-4), (1.0, 0.0, 0.0, 0.0)), name="box")
    data = data_of(page_of_report(report, tmp_path / "page.html"))
    assert data["summary"] == report.summary and data["name"] == "box"
    assert set(data["drift"]) == {"energy", "momentum_norm", "momentum_space"}


@pytest.mark.long
def test_a_moon_has_a_twin_and_a_section(tmp_path):
    """The twin is the linearised motion's while both are near; the section's points repeat the motion at periapsis."""
    system = SpinOrbit(0.89, 0.1, 2.0)
    period = np.pi
    moved = ph.simulate(system, np.array([0.3, 2.0]), period * np.linspace(0.0, 10.0, 101))
    data = data_of(write_page(moved, tmp_path / "moon.html"))
    angle, distance, rate = (array(plot["series"][0]["values"]) for plot in data["plots"])
    assert angle == pytest.approx(np.degrees(np.mod(moved.part("angle") + np.pi / 2, np.pi) - np.pi / 2), abs=1e-3)
    assert rate == pytest.approx(moved.part("rate") / 2.0, abs=1e-5)
    near = ph.simulate(system, np.array([0.3 + 1e-4, 2.0]), period * np.linspace(0.0, 10.0, 101))
    growth = np.abs(near.part("angle") - moved.part("angle"))[:15] / 1e-4
    assert distance[:15] == pytest.approx(np.log10(growth * 1e-6), abs=0.01)
    (section,) = data["scatters"]
    x, y = array(section["x"]), array(section["y"])
    assert y[:11] == pytest.approx(moved.part("rate")[::10] / 2.0, abs=1e-4) and x[0] == pytest.approx(np.degrees(0.3))


def test_an_exact_motion_and_a_spec_are_shown_as_they_are(tmp_path):
    assert data_of(write_page(MOTION, tmp_path / "motion.html"))["model"]["momentum"] == [0.3, 1.8, 1.5]
    top = ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(0.8, 0.6, 0.0, 0.0))
    assert data_of(write_page(top, tmp_path / "top.html"))["model"]["mgl"] == 1.0
    spec = read_spec(EXAMPLES / "t_handle.toml")
    shown = data_of(write_page(spec, tmp_path / "spec.html"))
    assert shown["name"] == spec.name and shown["summary"]
    with pytest.raises(InvalidInput, match="a spec has its own"):
        write_page(spec, tmp_path / "twice.html", summary="mine")
    with pytest.raises(InvalidInput, match=r"`times` must be given for a batch of bodies, here of shape \(2,\)"):
        write_page(ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((2, 3))), tmp_path / "batch.html")
