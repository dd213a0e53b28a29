"""Links come from anywhere: whatever they say, a page or a panel stays whole, draws, and says what it does not take."""

import itertools
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from sweeping import only

pytestmark = pytest.mark.browser
ROOT = Path(__file__).parents[2]
PANELS = {path.stem: path for path in sorted((ROOT / "learn" / "panels").glob("*.html"))}
SETTINGS = {
    "t_handle": "free_body", "top": "lagrange_top", "quantum_racket": "quantum_rotor", "explorer_1": "damped_body",
    "dual_spin": "gyrostat", "gyroscope": "heavy_top", "euler_disk": "euler_disk",
}  # fmt: skip
"""An example for each way to set a motion on its page, and the script that knows its keys."""
QUICK = ("t_handle", "top")
"""Examples that are solved in closed form: the others step, some links for seconds."""
SETTLING = 250  # ms, longer than a panel takes to write its address
NUMBERS = ("1e300", "-1e300", "5e-324", "1e100", "-1e100", "1e-100", "0", "1e999", "NaN", "2.5", "x", "", "1,2", "1,,3",
           "__proto__")  # fmt: skip
LONG = "&".join(["spin.rate=1"] * 3000)
REFUSED = {
    "#__proto__.foo=7": "__proto__", "#__proto__=7": "__proto__", "#constructor.foo=7": "constructor",
    "#toString=1": "toString", "#hasOwnProperty.call=1": "hasOwnProperty", "#valueOf=__proto__": "valueOf",
    "#=3": "=3", "#.x=3": ".x=3", "#a.b.c=1": "a.b.c=1", "#x=%E0%A4%A": "%E0%A4%A", "#nothing=1e5": "nothing",
    "#nothing=1e300": "nothing", f"#{'n' * 5000}=1": "nnnnn",
}  # fmt: skip
"""Links that no page and no panel takes, and what the sentence about each must name."""
REFUSED_BY_PAGES = {
    "#t=1e300": "t must be", "#t=-1e300": "t must be", "#t=1e99": "t must be", "#t=-1e20": "t", "#t=NaN": "t must be",
    "#t=1e999": "t must be", "#t=5&t.x=1": "t must be", "#t=1,2": "t must be", "#view=constructor": "view must be",
    "#view=1": "view must be", "#lang=__proto__": "lang must be", "#preset=__proto__": "preset", "#spin=1": "spin",
}  # fmt: skip
WHOLE = """() => {
  const names = (one) => Object.getOwnPropertyNames(one).sort().join();
  return [Object.prototype, Object, Array.prototype, Function.prototype, String.prototype].map(names);
}"""
STATE = "JSON.stringify([window.polhode.settings(), window.polhode.state(window.polhode.shown().time)])"
COLOURS = """selector => {
  const canvas = document.querySelector(selector);
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const paper = copy.getContext("2d");
  paper.drawImage(canvas, 0, 0);
  return new Set(new Uint32Array(paper.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
}"""
DRAWN = 40
"""Colours in a picture, at the least: an empty one has one."""


def keys_of(module):
    """Return the keys that links may set, as "spin.rate", with how many numbers each has; 0 for a word."""
    path = (ROOT / "viewer" / "src" / "settings" / f"{module}.js").as_uri()
    script = f"import('{path}').then(m => console.log(JSON.stringify(m.keys)))"
    done = subprocess.run([shutil.which("node"), "-e", script], capture_output=True, text=True, check=True)
    return {f"{table}.{key}": count for table, keys in json.loads(done.stdout).items() for key, count in keys.items()}


def wrong_values(keys, thinned):
    """Yield links with each number at each key, or with a few of them: which ones changes from key to key."""
    for k, (key, count) in enumerate(keys.items()):
        chosen = NUMBERS[k % 4 :: 4] if thinned else NUMBERS
        for value in chosen:
            yield f"#{key}=" + ",".join([value] * max(count, 1))
            if count > 1:
                yield f"#{key}=" + ",".join([value] + ["0"] * (count - 1))


class Attacked:
    """A page or panel that is followed from link to link."""

    def __init__(self, page, picture):
        self.page, self.picture = page, picture
        self.whole = page.tab.evaluate(WHOLE)

    def follow(self, link):
        self.page.tab.evaluate("link => (location.hash = link)", link)
        self.page.window.settle()
        assert self.page.complaints == [], link[:80]
        assert self.page.tab.evaluate(WHOLE) == self.whole, link[:80]
        return self.page.tab.locator("#refused").text_content()

    def check_refused(self, links):
        for link, named in links.items():
            said = self.follow(link)
            assert named in said and said.endswith("."), (link[:80], said)
            assert len(said) < 600

    def colours(self):
        return self.page.tab.evaluate(COLOURS, self.picture)


def attack_page(page, module, thinned):
    attacked = Attacked(page, ".large canvas")
    attacked.check_refused(REFUSED | REFUSED_BY_PAGES)
    first = page.tab.evaluate("window.polhode.settings()")
    for link in itertools.chain(wrong_values(keys_of(module), thinned), [f"#{LONG}"]):
        attacked.follow(link)
        state = page.tab.evaluate(STATE)
        assert "null" not in state.replace('"attitude":null', ""), link[:80]
        assert attacked.colours() > DRAWN, link[:80]
    attacked.follow("#")
    assert page.tab.evaluate("window.polhode.settings()") == first


@pytest.mark.parametrize("name", QUICK)
def test_a_page_survives_every_link(example_page, opened, name):
    attack_page(opened(example_page(name)), SETTINGS[name], thinned=True)


@pytest.mark.sweep
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", SETTINGS)
def test_each_page_survives_every_number_at_every_key(example_page, opened, name):
    attack_page(opened(example_page(name)), SETTINGS[name], thinned=False)


def test_numbers_that_are_far_apart_lead_to_a_sentence(example_page, opened):
    """Each number is one that a spec may have; their products leave double precision."""
    page = opened(example_page("t_handle"))
    attacked = Attacked(page, ".large canvas")
    for moment, rate in itertools.product(("1e100", "1e-100"), repeat=2):
        moments, velocity = ",".join([moment] * 3), ",".join([rate] * 3)
        said = attacked.follow(f"#body.moments={moments}&spin.angular_velocity={velocity}")
        numbers = page.tab.evaluate("window.polhode.state(0).momentum")
        assert None not in numbers and attacked.colours() > DRAWN and "undefined" not in said


def test_a_page_opens_at_a_hostile_link(example_page, opened):
    for link, named in (REFUSED | REFUSED_BY_PAGES).items():
        page = opened(example_page("t_handle"), link)
        assert page.complaints == [] and named in page.tab.locator("#refused").text_content(), link[:80]


def test_a_page_without_anything_to_set_says_so(example_page, opened):
    page = opened(example_page("hyperion"))
    assert not page.tab.evaluate("window.polhode.settings()")
    attacked = Attacked(page, ".large canvas")
    attacked.check_refused({"#__proto__.foo=7": "__proto__", "#spin.rate=3": "nothing to set"})
    attacked.check_refused({"#t=1e12": "t must be from", "#t=-1": "t must be from"})
    last = page.tab.evaluate("window.polhode.times.at(-1)")
    assert attacked.follow(f"#t={last}") == "" and page.tab.evaluate("window.polhode.shown().time") == last


def test_what_a_script_asks_for_is_refused_alike(example_page, opened):
    page = opened(example_page("t_handle"))
    for wrong in ("{constructor: {name: 'x'}}", "JSON.parse('{\"__proto__\": {\"rate\": 1}}')", "{spin: {toString: 1}}",
                  "{spin: {rate: 1e300}}", "{spin: [1]}", "{spin: {angular_velocity: {length: 3}}}"):  # fmt: skip
        assert page.tab.evaluate(f"window.polhode.set({wrong})") is False
        assert page.tab.locator("#refused").text_content().endswith(".")
    for time in ("1e300", "NaN", "'x'"):
        assert page.tab.evaluate(f"window.polhode.goTo({time})") is False
        assert re.match("t must be|`t` ", page.tab.locator("#refused").text_content())
    assert page.tab.evaluate("window.polhode.goTo(3)") is True and page.complaints == []


# ---------------------------------------------------------------- panels


class OpenedPanel:
    """A panel of the course in a window."""

    def __init__(self, window, path, link=""):
        self.window, self.tab, self.complaints = window, window.tab, window.complaints
        self.tab.goto(path.as_uri() + link)
        self.window.settle(SETTLING)


@pytest.fixture
def panel(windows):
    taken = []

    def opening(name, link=""):
        taken.append(windows.take())
        return OpenedPanel(taken[-1], PANELS[name], link)

    yield opening
    for window in taken:
        windows.give_back(window)


def attack_panel(page, thinned):
    attacked = Attacked(page, "#picture")
    initial = page.tab.evaluate("panel.settings")
    attacked.check_refused(REFUSED)
    keys = {key: len(value) if isinstance(value, list) else 1 for key, value in initial.items()}
    for link in wrong_values(keys, thinned):
        said = attacked.follow(link)
        settings = page.tab.evaluate("panel.settings")
        assert list(settings) == list(initial) and None not in settings.values(), link
        assert (settings == initial) or not said, link  # what was said not to be taken was not taken
        readings = page.tab.locator("#readings").text_content()
        assert "undefined" not in readings and "NaN" not in readings, link
        assert attacked.colours() > DRAWN, link


@pytest.mark.parametrize("name", only(("inertia", "quanta", "bracket"), PANELS))
def test_a_panel_survives_every_link(panel, name):
    attack_panel(panel(name), thinned=True)


@pytest.mark.sweep
@pytest.mark.parametrize("name", PANELS)
def test_each_panel_survives_every_number_at_every_key(panel, name):
    attack_panel(panel(name), thinned=False)


def test_a_panel_says_what_it_does_not_take_until_something_is_changed(panel):
    page = panel("book", "#tilt=1e300&rate=2")
    assert page.tab.locator("#refused").text_content() == (
        'tilt must be zero or of a size from 1e-100 to 1e+100; got "1e300". Check the number, which is in SI units.'
    )
    page.tab.evaluate("location.hash = 'tilt=90&speed=7'")
    page.window.settle(SETTLING)
    said = page.tab.locator("#refused").text_content()
    assert "tilt must be a number from 0.001 to 60; got 90." in said
    assert "speed must be 1 or 0.2 or 0.05; got 7." in said
    assert page.tab.evaluate("panel.settings.tilt") == 1
    page.tab.locator("#rate").focus()
    page.tab.keyboard.press("ArrowRight")
    assert page.tab.locator("#refused").text_content() == "" and page.complaints == []
