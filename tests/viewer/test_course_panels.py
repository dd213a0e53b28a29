"""The panels of the course in a browser: what they show, what moves them, and how fast they draw."""

import json
import math
import re
from pathlib import Path

import pytest

import polhode as ph
from polhode.analysis.poinsot import herpolhode
from polhode.spectra import Rotor
from sweeping import only

pytestmark = pytest.mark.browser
FOLDER = Path(__file__).parents[2] / "learn" / "panels"
PANELS = sorted(path.stem for path in FOLDER.glob("*.html"))
ALIKE = ("disk", "quanta", "surfaces")
"""Panels that stand for all where what they share is tried: one plays, one does not, one is turned."""
SIZES = {
    "frame": (700, 420), "phone": (390, 844), "laptop": (1366, 768), "frame on a phone": (358, 630),
    "low frame": (358, 440),
}  # fmt: skip
SETTLING = 300  # ms, longer than the timers of a panel, which draws finer and writes its address once it rests
SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


class Shown:
    """A panel in a window, offline, with all it complained about and asked for."""

    def __init__(self, window, path, fragment=""):
        self.window, self.context, self.tab = window, window.context, window.tab
        self.complaints, self.requests = window.complaints, window.requests
        self.tab.goto(path.as_uri() + fragment)
        self.until("globalThis.panel && panel.times.length", tries=100)  # some are opened that have no panel

    def until(self, condition, tries=1000):
        """Wait until an expression is true, and return whether it came true."""
        for _ in range(tries):
            if self.tab.evaluate(f"Boolean({condition})"):
                return True
            self.tab.wait_for_timeout(30)
        return False

    def settings(self):
        return json.loads(self.tab.evaluate("JSON.stringify(panel.settings)"))

    def words(self, key):
        return self.tab.locator(f'#readings [data-key="{key}"] b').inner_text()

    def number(self, key):
        """Return the number that stands in the readings, and half of its last digit."""
        text = self.words(key).translate(SUPERSCRIPTS)
        mantissa, _, power = re.match(r"([−-]?[\d.]+)(·10(-?\d+))?", text).groups()
        scale = 10.0 ** int(power or 0)
        return float(mantissa.replace("−", "-")) * scale, 0.5001 * scale * 10.0 ** -len(mantissa.partition(".")[2])

    def picture(self):
        return self.tab.evaluate("document.getElementById('picture').toDataURL()")

    def settle(self):
        """Wait until all is drawn and the address written."""
        self.window.settle(SETTLING)

    def out_of_sight(self):
        """Return what of picture, controls and numbers is not inside the window, and whether the page scrolls."""
        return self.tab.evaluate("""() => {
          const seen = [...document.querySelectorAll('#picture, #controls > *, #readings, #buttons, h1')];
          const hidden = seen.filter((part) => {
            const box = part.getBoundingClientRect();
            return box.top < -0.5 || box.left < -0.5 || box.bottom > innerHeight + 0.5 || box.right > innerWidth + 0.5;
          });
          const side = document.getElementById('side');
          const found = hidden.map((part) => part.id || part.className);
          if (document.documentElement.scrollHeight > innerHeight + 1) found.push('page scrolls');
          if (side.scrollHeight > side.clientHeight + 1) found.push('controls scroll');
          return found;
        }""")


@pytest.fixture
def shown(windows):
    taken = []

    def showing(name, fragment="", size=(700, 420), **options):
        path = name if isinstance(name, Path) else FOLDER / f"{name}.html"
        taken.append(windows.take(viewport={"width": size[0], "height": size[1]}, **options))
        return Shown(taken[-1], path, fragment)

    yield showing
    for window in taken:
        windows.give_back(window)


def check_in_sight(page):
    assert page.out_of_sight() == []
    box = page.tab.locator("#picture").bounding_box()
    assert box["width"] >= 320 and box["height"] >= 150
    assert page.complaints == [] and len(page.requests) == 1


@pytest.mark.parametrize("name", PANELS)
def test_picture_and_controls_are_in_sight_together(shown, name):
    page = shown(name)
    for width, height in SIZES.values():
        page.tab.set_viewport_size({"width": width, "height": height})
        page.window.settle()
        assert page.tab.evaluate("[innerWidth, innerHeight]") == [width, height]
        check_in_sight(page)


@pytest.mark.sweep
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", PANELS)
def test_picture_and_controls_of_a_panel_opened_at_a_size_are_in_sight(shown, name, size):
    check_in_sight(shown(name, size=SIZES[size]))


def test_what_is_out_of_sight_or_goes_wrong_is_seen(shown, tmp_path):
    """Broken specimens: a page that is too tall, one whose policy has another hash, one that asks for a picture."""
    text = (FOLDER / "surfaces.html").read_text("utf-8")
    specimens = {
        "tall": text.replace('<div id="controls">', '<div id="controls">' + "<br>" * 60),
        "policy": text.replace("script-src 'sha256-", "script-src 'sha256-A"),
        "asks": text.replace("<header>", '<header><img alt="" src="https://example.org/x.png">'),
    }
    pages = {}
    for name, broken in specimens.items():
        path = tmp_path / f"{name}.html"
        path.write_text(broken, "utf-8")
        pages[name] = shown(path)
    assert pages["tall"].out_of_sight()
    assert pages["policy"].complaints and not pages["policy"].tab.evaluate("Boolean(globalThis.panel)")
    assert pages["asks"].complaints, "the policy keeps it from being loaded, and says so"


def surfaces():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(2 * math.sqrt(0.2125), 0.0, 2 * math.sqrt(0.7875)))
    return {"period": motion.period, "cap": motion.solid_angle, "norm": 2.0}


def book():
    moments = ph.read_spec(FOLDER.parents[1] / "examples" / "book.toml").body.principal_moments
    norm, tilt = moments[1] * 3.0 * math.pi, math.radians(1.0)
    motion = ph.FreeMotion(moments, momentum=(0.0, norm * math.cos(tilt), norm * math.sin(tilt)))
    return {"flip": motion.flip_interval, "modulus": motion.modulus, "turns": 1.5 * motion.flip_interval}


def cones():
    tilt = math.radians(28.0)
    motion = ph.FreeMotion((1.0, 1.0, 1.6), momentum=(2 * math.sin(tilt), 0.0, 2 * math.cos(tilt)))
    rate = motion.angular_velocity(0.0)
    cone = math.degrees(math.atan2(rate[0], rate[2]))
    return {"period": motion.period, "precession": math.pi, "bodyCone": cone, "spaceCone": cone - 28.0}


def gyroscope():
    mass, radius, arm, lean, spin = 0.12, 0.028, 0.035, math.radians(75.0), 1500 * 2 * math.pi / 60
    across = 0.5 * mass * radius**2 + mass * arm**2
    motion = ph.LagrangeMotion((across, across, mass * radius**2), mgl=mass * 9.80665 * arm,
                               momentum=(0.0, 0.0, mass * radius**2 * spin),
                               attitude=(math.cos(lean / 2), math.sin(lean / 2), 0.0, 0.0))  # fmt: skip
    lowest = math.degrees(math.acos(motion.nutation_limits[0]))
    return {"precession": 2 * math.pi / motion.precession_rate, "nutation": motion.nutation_period, "lowest": lowest}


def inertia():
    points = [[0.9, 0.25, 0.1], [-0.7, 0.55, 0.0], [-0.5, -0.75, 0.2], [0.3, 0.1, 0.65], [0.15, -0.35, -0.55]]
    body = ph.Body.from_points([1.0, 1.5, 1.0, 0.8, 1.2], points)
    moments = dict(zip(("I1", "I2", "I3"), body.principal_moments, strict=True))
    return {**moments, "Jxx": body.inertia[0, 0], "Jxy": body.inertia[0, 1], "mass": 5.5}


def poinsot():
    share = (1.86 / 4.0 - 1.0 / 3.0) / (2.0 / 3.0)
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(2 * math.sqrt(share), 0.0, 2 * math.sqrt(1.0 - share)))
    inner, outer, distance = (math.sqrt(1.86) * x for x in herpolhode(motion))  # rad/s instead of Ω/√(2E)
    return {"along": distance, "inner": inner, "outer": outer,
            "period": motion.period, "turn": math.degrees(motion.precession_per_period)}  # fmt: skip


def axes():
    tilt = math.radians(3.0)
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 4 * math.cos(tilt), 4 * math.sin(tilt)))
    return {"rate": 2.0 / math.sqrt(3.0), "exact": motion.flip_interval}


def bracket():
    level = 1.5 * math.sqrt(1.0 - 0.35**2)
    return {"rate": -0.5 * level**2 * math.cos(0.9) * math.sin(0.9), "F": 0.525}


def disk():
    return {"exponent": 1.0 / 3.0, "power": -0.5}


def quanta():
    energy = sorted(Rotor((27.0, 14.0, 9.0)).levels(6, 6).energy)[2]
    return {"energy": energy, "states": 13, "root": 2 * math.sqrt(42.0)}


SHOWN = {f.__name__: f for f in (surfaces, book, cones, gyroscope, inertia, poinsot, axes, bracket, disk, quanta)}
LOOSE = {"disk": 0.006}  # exponents of a disk that is not yet at its end


def numbers_that_differ(page, name):
    differing = []
    for key, wanted in SHOWN[name]().items():
        found, half = page.number(key)
        if not abs(found - wanted) <= max(half, LOOSE.get(name, 0.0)):
            differing.append(f"{key}: {page.words(key)}, not {wanted}")
    return differing


@pytest.mark.parametrize("name", PANELS)
def test_numbers_in_the_page_are_pythons(shown, name):
    page = shown(name)
    assert numbers_that_differ(page, name) == []
    assert page.tab.get_attribute("#readings", "aria-live") == "polite"


def test_a_wrong_number_is_seen(shown):
    page = shown("surfaces")
    page.tab.evaluate("""() => {
      const right = panel.readings;
      panel.readings = (model, settings) => right({ ...model, period: 1.0001 * model.period }, settings);
      panel.set('energy', 1.9);
    }""")
    page.settle()
    assert len(numbers_that_differ(page, "surfaces")) == 1


@pytest.mark.parametrize("name, fragment, key, said", [
    ("surfaces", "#energy=1.3333333333333333", "period", "L stays on the axis"), ("surfaces", "#energy=4", "cap", "—"),
    ("surfaces", "#energy=2", "period", "never comes back"), ("cones", "#ratio=1", "period", "Ω stays on L"),
])  # fmt: skip
def test_words_stand_where_there_is_no_number(shown, name, fragment, key, said):
    page = shown(name, fragment)
    assert page.words(key) == said
    assert "undefined" not in page.tab.locator("#readings").inner_text()


def test_sliders_reach_both_ends(shown):
    """The range of this one is no multiple of its step."""
    page = shown("surfaces")
    page.tab.locator("#energy").focus()
    reached = [page.tab.keyboard.press(key) or page.settings()["energy"] for key in ("End", "Home")]
    assert reached == [4, pytest.approx(4 / 3, abs=1e-12)]


def parts_out_of_reach(page):
    """Return what the tabulator does not come to, and what has no label."""
    parts = "canvas, #side input, #side select, #side button"
    wanted = page.tab.evaluate("""parts => [...document.querySelectorAll(parts)]
      .filter((part) => part.type !== 'radio' || part.checked).map((part) => part.id)""", parts)
    reached = []
    for _ in range(len(wanted) + 2):
        page.tab.keyboard.press("Tab")
        reached.append(page.tab.evaluate("document.activeElement.id"))
    names = [part.get_attribute("id") for part in page.tab.locator("#side input, #side select").all()]
    unlabelled = [name for name in names if not page.tab.locator(f"label[for='{name}']").count()]
    return sorted({*wanted} - {*reached}) + unlabelled


@pytest.mark.parametrize("name", PANELS)
def test_everything_is_reached_and_moved_by_keyboard(shown, name):
    page = shown(name)
    assert parts_out_of_reach(page) == []
    for slider in page.tab.locator("#side input[type=range]").all():
        before = page.picture(), slider.input_value(), slider.get_attribute("aria-valuetext")
        slider.focus()
        at_its_end = slider.get_attribute("id") in ("level", "left")
        key = "ArrowLeft" if at_its_end else "ArrowRight"
        for _ in range(6):
            page.tab.keyboard.press(key)
        page.settle()
        assert slider.input_value() != before[1] and slider.get_attribute("aria-valuetext")
        assert page.picture() != before[0], slider.get_attribute("id")
    if "turns" in page.tab.get_attribute("#picture", "class"):
        turn = page.settings()["turn"]
        page.tab.locator("#picture").focus()
        page.tab.keyboard.press("ArrowRight")
        assert page.settings()["turn"] == pytest.approx(turn + 0.1)
    assert page.complaints == []


@pytest.mark.parametrize("name", PANELS)
def test_the_address_is_the_state(shown, name):
    page = shown(name)
    initial = page.settings()
    for slider in page.tab.locator("#side input[type=range]").all():
        slider.focus()
        for _ in range(3):
            page.tab.keyboard.press("ArrowRight")
    for box in page.tab.locator("#side input[type=checkbox]").all():
        box.click()
    page.settle()
    fragment = page.tab.evaluate("location.hash")
    assert len(fragment) > 3
    again = shown(name, fragment)
    assert again.settings() == page.settings() != initial
    page.tab.evaluate("location.hash = ''")  # changes of the address are followed
    page.settle()
    assert page.settings() == initial
    assert shown(name, "#energy=NaN&tilt=%zz&J=many&H=nothing&a=1,2&turn=x").complaints == []


def frames_of_forty_changes(page):
    """Return how many frames are drawn while time passes and the picture is turned, forty times."""
    return page.tab.evaluate("""async () => {
      await new Promise((done) => requestAnimationFrame(() => done()));
      panel.times.length = 0;
      for (let k = 0; k < 40; k++) {
        if (panel.settings.turn !== undefined) panel.set('turn', panel.settings.turn + 0.01);
        panel.seek(panel.time + 0.017);
        await new Promise((done) => requestAnimationFrame(() => done()));
      }
      return panel.times.length;
    }""")


def frames_at_rest(page):
    """Return how many frames are drawn in half a second in which nothing changes."""
    page.settle()  # it draws once more, finer
    page.tab.evaluate("panel.times.length = 0")
    page.tab.wait_for_timeout(500)
    return page.tab.evaluate("panel.times.length")


@pytest.mark.parametrize("name", PANELS)
def test_no_frame_is_drawn_in_vain(shown, name):
    """How long one takes is measured in ``benchmarks/measures/panel_frames.py``."""
    page = shown(name, size=(1280, 800))
    assert 0 < frames_of_forty_changes(page) <= 41  # the one before may still be under way
    assert frames_at_rest(page) == 0


def test_a_wasteful_or_restless_panel_is_seen(shown):
    page = shown("surfaces")
    page.tab.evaluate("void (panel.redraw = () => panel.picture(performance.now()))")  # each wish a frame
    assert frames_of_forty_changes(page) > 41
    page = shown("axes")
    page.tab.evaluate("void setInterval(() => panel.redraw(), 50)")
    assert frames_at_rest(page) > 0


def test_what_the_keyboard_does_not_reach_or_the_address_forgets_is_seen(shown):
    page = shown("book")
    page.tab.evaluate("document.getElementById('rate').tabIndex = -1")
    page.tab.evaluate("document.querySelector('label[for=tilt]').removeAttribute('for')")
    assert parts_out_of_reach(page) == ["rate", "tilt"]
    page = shown("book")
    page.settle()  # else the address that it writes as it opens would have the change
    page.tab.evaluate("void (panel.remember = () => {})")
    page.tab.locator("#rate").focus()
    page.tab.keyboard.press("ArrowRight")
    page.settle()
    fragment = page.tab.evaluate("location.hash")
    assert shown("book", fragment).settings() != page.settings()


@pytest.mark.parametrize("name", only(ALIKE, PANELS))
def test_it_runs_unless_asked_for_less_motion(shown, name):
    still = shown(name)
    assert not still.tab.evaluate("panel.running")
    if not still.tab.evaluate("panel.plays"):
        return
    moving = shown(name, reduced_motion="no-preference")
    assert moving.until("panel.running && panel.time > 0")
    moving.tab.click("#play")
    time = moving.tab.evaluate("panel.time")
    moving.tab.wait_for_timeout(300)
    assert moving.tab.evaluate("panel.time") == pytest.approx(time, abs=0.2)
    assert moving.tab.get_attribute("#play", "aria-label") == "play"
    assert moving.complaints == []


@pytest.mark.parametrize("name", only(ALIKE, PANELS))
def test_the_line_to_embed_shows_what_is_seen(shown, name, tmp_path):
    page = shown(name)
    page.tab.locator("#side input[type=range]").first.focus()
    page.tab.keyboard.press("ArrowRight")
    page.settle()
    page.tab.click("#embed")
    line = page.tab.input_value("#snippet")
    assert page.tab.evaluate("location.href").replace("&", "&amp;") in line and "<iframe" in line
    around = tmp_path / "around.html"
    around.write_text(f"<!doctype html><meta charset=utf-8><body style='width:700px'>{line}</body>", "utf-8")
    outer = page.context.new_page()
    outer.goto(around.as_uri())
    frame = outer.frame_locator("iframe")
    assert frame.locator("h1").inner_text() == page.tab.locator("h1").inner_text()
    frame.locator("#readings b").first.wait_for()


def test_points_are_dragged(shown):
    """The masses, the tilt in the book's graph, and the camera."""
    page = shown("inertia")
    x, y = page.tab.evaluate("panel.view.pixel(panel.settings.d)")
    box = page.tab.locator("#picture").bounding_box()
    drag(page, box, (x, y), (x + 40, y - 30))
    moved = page.settings()["d"]
    assert page.settings()["mass"] == "d" and moved != [0.3, 0.1, 0.65]
    assert page.tab.evaluate("panel.view.pixel(panel.settings.d)") == pytest.approx([x + 40, y - 30], abs=1.5)
    page = shown("book")
    box = page.tab.locator("#picture").bounding_box()
    drag(page, box, (150, box["height"] - 70), (110, box["height"] - 70))
    assert page.settings()["tilt"] < 0.1 and page.tab.evaluate("panel.time") == 0
    page = shown("surfaces")
    turn = page.settings()["turn"]
    box = page.tab.locator("#picture").bounding_box()
    drag(page, box, (150, 150), (210, 150))
    assert page.settings()["turn"] == pytest.approx(turn - 60 * 0.009, abs=0.02)


def drag(page, box, start, end):
    page.tab.mouse.move(box["x"] + start[0], box["y"] + start[1])
    page.tab.mouse.down()
    for k in range(1, 6):
        page.tab.mouse.move(*(box[c] + a + (b - a) * k / 5 for c, a, b in zip("xy", start, end, strict=True)))
    page.tab.mouse.up()


def test_the_sound_is_switched_on_by_hand_alone(shown):
    page = shown("disk", reduced_motion="no-preference")
    assert not page.tab.evaluate("'sound' in panel.settings && panel.settings.sound")
    page.tab.click("#sound")
    assert page.until("panel.settings.sound === 1")
    page.settle()
    assert page.complaints == []
