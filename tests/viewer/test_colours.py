"""Colours mean the same in pages and figures: one table, to which pages' legends and figures' curves are held."""

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex, to_rgb

import polhode as ph
from polhode.figures import style
from polhode.kinds.page import write_page

BODY = {"L": "momentum", "Ω": "velocity", "cone of Ω about L (space cone)": "herpolhode",
        "cone of Ω in the body": "bodyCone"}  # fmt: skip
SPHERE = {"this motion": "motion", "separatrix": "border", "other polhodes": "family", "stable": "stable",
          "unstable": "border", "ellipsoid of the same energy": "energy"}  # fmt: skip
POINSOT = {"polhode": "motion", "herpolhode": "herpolhode", "contact, −Ω": "velocity"}
SHARED = {"this motion": "motion", "separatrix": "border", "other polhodes": "family", "herpolhode": "herpolhode"}
APART = 0.12
"""Of the cube of colours: as far apart as two roles must be to be told apart beside each other."""
MANY = 24
LEGENDS = """[...document.querySelectorAll('figcaption .legend > *')].map(item =>
    [item.textContent, getComputedStyle(item.querySelector('i')).backgroundColor])"""


@pytest.fixture(scope="module")
def motion():
    return ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 2.0, 0.4))


def hex_of(color):
    """Return "rgb(1, 2, 3)" as "#010203"."""
    return "#" + "".join(f"{int(part):02x}" for part in color.strip("rgb()").split(",")[:3])


def strays(drawn, table):
    """Return the entries of legends whose colour is not the one that the table has for what they are."""
    wanted = {**BODY, **SPHERE, **POINSOT}
    return [words for words, color in drawn if words in wanted and color.lower() != table[wanted[words]].lower()]


@pytest.mark.browser
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_pages_legends_have_the_tables_colours(motion, theme, opened, tmp_path):
    page = opened(write_page(motion, tmp_path / "page.html"), color_scheme=theme)
    drawn = [(words, hex_of(color)) for words, color in page.tab.evaluate(LEGENDS)]
    assert {*BODY, *SPHERE, *POINSOT} <= {words for words, _ in drawn}
    table = style.COLOURS[theme]
    assert not strays(drawn, table)
    broken = {**table, "herpolhode": table["border"]}  # as the page had it
    assert strays(drawn, broken)
    axes = next(panel for panel in page.tab.evaluate("window.polhode.plots()") if "Ω along" in panel["title"])
    assert [one["color"] for one in axes["styles"]] == table["axes"]


def test_the_figures_have_the_pages_colours(motion):
    found = {}
    for figure in (ph.figures.momentum_sphere(motion), ph.figures.herpolhode(motion)):
        legends = [one.get_legend() for one in figure.axes if one.get_legend()] + figure.legends
        for legend in legends:
            for handle, text in zip(legend.legend_handles, legend.get_texts(), strict=True):
                found[text.get_text()] = to_hex(handle.get_color()).lower()
    table = style.COLOURS["light"]
    said = {words: role for words, role in SHARED.items() if words in found}
    assert {"this motion", "separatrix", "herpolhode"} <= set(said)
    assert {words: found[words] for words in said} == {words: table[role].lower() for words, role in said.items()}
    assert tuple(table["axes"]) == style.AXIS_COLOURS


@pytest.mark.skipif(shutil.which("node") is None, reason="node is missing")
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_many_curves_on_a_page_differ_by_colour_or_dashes(theme):
    here = Path(__file__)
    source = here.parents[2] / "viewer" / "src"
    asked = [["theme.js", "seriesStyle", [style.COLOURS[theme], k]] for k in range(MANY)]
    command = [shutil.which("node"), here.parent / "run_settings.mjs", source.as_uri()]
    done = subprocess.run(command, text=True, timeout=60, input=json.dumps(asked), capture_output=True, check=True)
    found = [(one["color"], tuple(one["dash"])) for one in json.loads(done.stdout)]
    assert len(set(found)) == MANY and len({color for color, _ in found}) == 6
    assert not any(dash for _, dash in found[:6]) and all(dash for _, dash in found[6:])


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_what_stands_in_one_picture_can_be_told_apart(theme):
    table = style.COLOURS[theme]
    assert set(style.COLOURS["light"]) == set(style.COLOURS["dark"])
    for roles in (("momentum", "velocity", "weight", "torque", "bodyCone"),
                  ("motion", "border", "family", "stable", "energy"),
                  ("quantum", "classical", "ensemble")):  # fmt: skip
        colors = [np.array(to_rgb(table["motion" if role == "quantum" else role])) for role in roles]
        gaps = [np.abs(a - b).max() for k, a in enumerate(colors) for b in colors[:k]]
        assert min(gaps) > APART, roles
