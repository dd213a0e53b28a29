"""The page of a molecule: what its script computes is what Python computes, and levels can be chosen."""

import numpy as np
import pytest

from polhode import FreeMotion
from polhode.errors import InvalidInput
from polhode.kinds.page import write_page
from polhode.kinds.reading import read_spec
from polhode.spectra import Rotor
from polhode.spectra._level_polhodes import level_polhodes
from polhode.spectra._operators import Representation, rigid_terms
from polhode.spectra._strengths import compute_states
from polhode.spectra.quantum_rotor.panel import LIMITS
from polhode.spectra.racket import Racket
from polhode.spectra.symbols import symbol

CONSTANTS = (27e9, 14e9, 9e9)
# a multiple d of |L|² that levels share is d J(J + 1), of polhodes on |L| = J + ½ it is d (J + ½)²: a quarter of d more
ZERO = 0.25 * (9e9 - 1e-3 * (27e9 - 9e9))
MIDDLE_IS_Z = Representation.IIr
TIMES = (0.0, 1.3e-12, 41e-12)
SPEC = '[system]\nkind = "quantum-rotor"\nconstants = ["27 GHz", "14 GHz", "9 GHz"]\ntemperature = "10 K"\nj_max = 3\n'


@pytest.fixture
def spec_of(tmp_path):
    def read(more, text=SPEC):
        (tmp_path / "case.toml").write_text(text + more)
        return read_spec(tmp_path / "case.toml")

    return read


@pytest.fixture
def page_of(spec_of, opened, tmp_path):
    return lambda *more: opened(write_page(spec_of(*more), tmp_path / "page.html"))


def directions(rows):
    """Return where the page's map has its values, along the spin's x, y, z: polar angles from z, azimuths from x."""
    polar = (np.arange(rows) + 0.5) * np.pi / rows
    azimuth = (np.arange(2 * rows) + 0.5) * np.pi / rows
    polar, azimuth = np.meshgrid(polar, azimuth, indexing="ij")
    return np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)


def wigner_of(state, rows):
    return symbol(np.outer(state, np.conj(state)), directions(rows)).real.ravel()


@pytest.mark.browser
def test_the_flip_is_the_one_that_python_computes(page_of):
    """State, its Wigner function and classical bodies at any time; the spin's time runs the right way."""
    page = page_of('j = 7\nracket = { tilt = "20 deg", towards = "c" }\n')
    racket = Racket(CONSTANTS, 7, np.radians(20.0), "c")
    for time, state in zip(TIMES, racket.states(TIMES), strict=True):
        page.tab.evaluate("time => window.polhode.goTo(time)", time)
        found = page.measure("wigner", "values", "rows", "mean", "cloud")
        wanted = wigner_of(state, found["rows"])
        assert found["values"] == pytest.approx(wanted, abs=2e-6)  # held in single precision
        assert found["mean"][1] == pytest.approx(float(racket.quantum([time])[0]), abs=1e-12)
        one = page.tab.evaluate("time => window.polhode.state(time).momentum", time)
        assert one[1] / np.linalg.norm(one) == pytest.approx(float(racket.classical([time])[0]), abs=1e-12)
        mean = np.mean(found["cloud"], axis=0)[1] * 7.5 / 7.0
        assert mean == pytest.approx(float(racket.ensemble([time])[0]), abs=0.02)
        if time:
            backward = wigner_of(racket.states([-time])[0], found["rows"])
            assert np.abs(backward - wanted).max() > 0.5


@pytest.mark.browser
def test_the_cloud_moves_by_euler_s_equations(page_of):
    """400 bodies about the saddle, on both sides of it, against the exact motion."""
    page = page_of("j = 7\nracket = { }\n")
    begun = np.array(page.measure("wigner", "cloud")["cloud"])
    energy = begun**2 @ np.array(CONSTANTS)
    assert (energy > CONSTANTS[1]).any() and (energy < CONSTANTS[1]).any()
    motion = FreeMotion(1.0 / (4.0 * np.pi * np.array(CONSTANTS)), momentum=7.5 * begun[:, None, :])
    for time in TIMES[1:]:
        page.tab.evaluate("time => window.polhode.goTo(time)", time)
        wanted = np.asarray(motion.momentum(np.array([time])))[:, 0] / 7.5
        assert np.array(page.measure("wigner", "cloud")["cloud"]) == pytest.approx(wanted, abs=1e-8)


@pytest.mark.browser
def test_what_is_measured_has_been_drawn(page_of):
    """Also before the browser has come to its next frame, for which a busy one takes its time."""
    page = page_of("j = 7\nracket = { }\n")
    both = """() => [0, 4e-11].map((time) => {
        window.polhode.goTo(time);
        return window.polhode.measure("wigner", "mean").mean;
    })"""
    first, then = page.tab.evaluate(both)
    assert np.abs(np.subtract(first, then)).max() > 0.1
    sharp, level = page.tab.evaluate("""() => [-1, 3].map((level) => {
        window.polhode.set({ state: { level } });
        return Math.max(...window.polhode.measure("wigner", "values").values);
    })""")
    assert abs(sharp - level) > 0.1


@pytest.mark.browser
def test_levels_are_chosen_by_name_and_by_hand(page_of):
    """Each with its own Wigner function and a polhode of its energy; the point is dragged from level to level."""
    page = page_of("j = 6\n")
    found = level_polhodes(CONSTANTS, 6)
    states = compute_states(rigid_terms(CONSTANTS, MIDDLE_IS_Z), 6, MIDDLE_IS_Z)
    options = page.tab.locator("#set-state-level option").all_text_contents()
    assert options[0] == "L as sharp as it can be" and options[1:4] == ["6_0,6", "6_1,6", "6_1,5"]
    above = int(np.argmax(found.above))
    assert page.tab.evaluate("window.polhode.settings().state.level") == above  # next above the saddle
    for level in (0, 5, 12):
        assert page.tab.evaluate("level => window.polhode.set({ state: { level } })", level)
        shown = page.measure("wigner", "values", "rows")
        wanted = wigner_of(states.vectors[::-1, level], shown["rows"])
        assert shown["values"] == pytest.approx(wanted, abs=2e-6)
        momentum = np.array(page.tab.evaluate("window.polhode.state(3e-12).momentum"))
        energy = 6.5**2 * (momentum / np.linalg.norm(momentum)) ** 2 @ np.array(CONSTANTS)
        assert energy - ZERO == pytest.approx(found.semiclassical[level], rel=1e-12)
        assert options[1 + level] in page.tab.locator("figcaption").nth(2).text_content()
    assert "tunnelling splits the pair by" in page.tab.locator("#facts").text_content()


@pytest.mark.browser
def test_a_drag_goes_to_the_nearest_level(page_of):
    page = page_of("j = 6\n")
    page.tab.evaluate("window.polhode.set({ state: { level: 12 } })")
    page.enlarge("sphere")
    x, y, _ = page.measure("sphere", "seen")["seen"]
    box = page.tab.locator(".large canvas").bounding_box()
    at = [box["x"] + 0.5 * (1 + x) * box["width"], box["y"] + 0.5 * (1 - y) * box["height"]]
    page.tab.mouse.move(*at)
    page.tab.mouse.down()
    page.tab.mouse.move(at[0] + 60, at[1] - 25, steps=6)
    page.tab.mouse.up()
    level = page.tab.evaluate("window.polhode.settings().state.level")
    assert 0 <= level < 12
    unit = np.array(page.measure("sphere", "point")["point"])
    assert 6.5**2 * unit**2 @ np.array(CONSTANTS) - ZERO == pytest.approx(
        level_polhodes(CONSTANTS, 6).semiclassical[level], rel=1e-9
    )
    page.until("window.location.hash === '#state.level=" + str(level) + "&view=sphere'")


@pytest.mark.browser
def test_what_cannot_be_set_is_said(page_of):
    page = page_of("j = 4\n")
    for tables, said in (
        ({"state": {"level": 9}}, "from 0 to 8; got 9"),
        ({"state": {"level": 1.5}}, "whole number"),
        ({"state": {"direction": [0, 0, 0]}}, "must not be zero"),
        ({"spin": {"rate": 1}}, "no table spin here"),
    ):
        assert not page.tab.evaluate("tables => window.polhode.set(tables)", tables)
        assert said in page.tab.locator("#refused").text_content()
    assert not page.complaints


@pytest.mark.browser
def test_waves_too_fine_to_draw_leave_the_polhodes(page_of):
    page = page_of(f"j = {LIMITS.max_j + 1}\n")
    captions = page.tab.locator("figcaption strong").all_text_contents()
    assert captions[1] == f"Levels of J = {LIMITS.max_j + 1} as polhodes"
    assert not page.tab.evaluate("window.polhode.set({ state: { direction: [0, 1, 0] } })")
    assert f"up to J = {LIMITS.max_j}" in page.tab.locator("#refused").text_content()
    assert page.tab.evaluate("window.polhode.set({ state: { level: 3 } })") and not page.complaints


@pytest.mark.browser
@pytest.mark.parametrize("constants", ['"9 GHz", "4 GHz", "4 GHz"', '"9 GHz", "9 GHz", "4 GHz"'])
def test_levels_of_symmetric_molecules_go_by_K(page_of, constants):
    """|L| cos θ = K about the unique axis."""
    text = SPEC.replace('"27 GHz", "14 GHz", "9 GHz"', constants)
    page = page_of("j = 5\n", text)
    axis = 0 if '"4 GHz", "4 GHz"' in constants else 2
    levels = Rotor([float(part.split()[0].strip('"')) * 1e9 for part in constants.split(", ")]).levels_of(5)
    for level in (0, 3, 10):
        page.tab.evaluate("level => window.polhode.set({ state: { level } })", level)
        unit = np.array(page.measure("sphere", "point")["point"])
        K = (levels.Ka if axis == 0 else levels.Kc)[level]
        assert abs(unit[axis]) * 5.5 == pytest.approx(K, abs=1e-9)
        assert abs(page.measure("wigner", "largest")["largest"]) > 0.1
    assert not page.complaints


@pytest.mark.parametrize(
    ("more", "constants", "said"),
    [
        ("j = 0\n", '"27 GHz", "14 GHz", "9 GHz"', "with `j` = 0 there is no L"),
        ("", '"9 GHz", "9 GHz", "9 GHz"', "every L rests in the body"),
        ("", '"9 GHz"', "a linear molecule has no motion about its axis"),
    ],
)
def test_where_nothing_moves_there_is_no_page(spec_of, tmp_path, more, constants, said):
    spec = spec_of(more, SPEC.replace('"27 GHz", "14 GHz", "9 GHz"', constants))
    with pytest.raises(InvalidInput, match=said):
        write_page(spec, tmp_path / "page.html")
    assert not (tmp_path / "page.html").exists()
