"""The page by mouse, by keys alone, on a phone, in the dark, and with a name that tries to be markup."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

import polhode as ph
from polhode.formats.labels import AttitudeLabels, Recording
from polhode.kinds.page import show, write_page
from polhode.systems import FreeRigidBody

pytestmark = pytest.mark.browser
PHONE = {"viewport": {"width": 390, "height": 780}, "has_touch": True, "is_mobile": True}
EMPTY = 4000  # bytes of a picture with nothing in it
FINGER = 40  # pixels a control should measure


@pytest.fixture(scope="module")
def page_of_a_book(tmp_path_factory):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 2.0, 0.1))
    path = tmp_path_factory.mktemp("book") / "book.html"
    return write_page(motion.sample(np.linspace(0.0, 30.0, 601)), path, name="a book", notes=["thrown"])


def test_time_bar_moves_the_scene(page_of_a_book, opened):
    page = opened(page_of_a_book)
    page.seek(0)
    before, picture = page.measure("body")["matrix"], page.picture("book-first")
    page.tab.locator("#seek").fill("300")
    assert page.position() == 300
    page.settle()
    assert page.measure("body")["matrix"] != before and page.picture("book") != picture
    page.tab.locator("#forth").click()
    page.tab.locator("#forth").click()
    page.tab.locator("#back").click()
    assert page.position() == 301
    page.until("document.querySelector('#now').textContent === window.polhode.shown().time.toFixed(2) + ' s'")
    page.tab.locator("#play").click()
    page.until("window.polhode.shown().position > 303")
    page.tab.locator("#play").click()
    assert page.tab.evaluate("window.polhode.playing") is False
    assert not page.complaints


def test_nothing_is_drawn_while_nothing_changes(page_of_a_book, opened):
    page = opened(page_of_a_book)
    page.settle(300)
    drawn = page.tab.evaluate("window.polhode.drawn")
    page.tab.wait_for_timeout(500)
    assert page.tab.evaluate("window.polhode.drawn") == drawn


def test_keys_alone_do_everything(page_of_a_book, opened):
    page = opened(page_of_a_book)
    keys, name = page.tab.keyboard, "document.activeElement.id || document.activeElement.tagName"
    last = page.count() - 1
    leads = {"End": last, "ArrowLeft": last - 1, "Home": 0, "ArrowRight": 1, "Shift+ArrowRight": 21}
    for key, position in leads.items():
        keys.press(key)
        assert page.position() == position
    speed = page.tab.locator("#speed").text_content()
    keys.press("+")
    assert page.tab.locator("#speed").text_content() != speed
    keys.press("-")
    assert page.tab.locator("#speed").text_content() == speed
    keys.press(" ")
    assert page.tab.evaluate("window.polhode.playing") is True
    keys.press(" ")
    assert page.tab.evaluate("window.polhode.playing") is False
    keys.press("Home")  # it played to between two samples
    met = []
    while "faster" not in met and len(met) < 60:
        keys.press("Tab")
        met.append(page.tab.evaluate(name))
        if met[-1] == "CANVAS":
            before, position = page.tab.evaluate("window.polhode.view.azimuth"), page.position()
            keys.press("ArrowLeft")
            assert page.tab.evaluate("window.polhode.view.azimuth") != before and page.position() == position
        if met[-1] == "theme":
            keys.press("Enter")
            assert page.tab.evaluate("window.polhode.shown().theme") == "dark"
        if met[-1] == "seek":
            position = page.position()
            keys.press("ArrowRight")
            assert page.position() == position + 1
    assert {"theme", "CANVAS", "back", "play", "forth", "seek", "slower", "faster"} <= set(met)
    for control in page.tab.locator("button, input").all():
        assert control.get_attribute("aria-label") or control.text_content()
    assert not page.complaints


def test_space_plays_after_a_click_on_another_button(page_of_a_book, opened):
    page = opened(page_of_a_book)
    speed = page.tab.locator("#speed")
    for name in ("#slower", "#theme", "#forth"):
        page.tab.locator(name).click()
        shown = speed.text_content(), page.tab.evaluate("window.polhode.shown().theme")
        for playing in (True, False):
            page.tab.keyboard.press(" ")
            assert page.tab.evaluate("window.polhode.playing") is playing
        assert (speed.text_content(), page.tab.evaluate("window.polhode.shown().theme")) == shown
    page.tab.locator("#faster").focus()
    page.tab.keyboard.press(" ")  # reached by key, a button is pressed
    assert speed.text_content() != shown[0] and page.tab.evaluate("window.polhode.playing") is False


def test_speed_has_ends(page_of_a_book, opened):
    page = opened(page_of_a_book)
    for key, words in (("+", "×30"), ("-", "×0.0083")):
        for _ in range(60):
            page.tab.keyboard.press(key)
        assert page.tab.locator("#speed").text_content() == words


LABELS = "[...document.querySelectorAll('canvas')].map(x => x.getAttribute('aria-label'))"


def test_pictures_are_described(page_of_a_book, example_page, opened):
    body, *_ = opened(page_of_a_book).tab.evaluate(LABELS)
    assert body.startswith("The body in space: box of the same inertia. Arrow keys")
    assert opened(example_page("t_handle")).tab.evaluate(LABELS)[0].startswith("The body in space. Arrow keys")


@pytest.mark.sweep  # its report is compiled for ten seconds
def test_pictures_that_do_not_turn_are_described_otherwise(example_page, opened):
    page = opened(example_page("hyperion"))
    assert "Arrow" not in page.tab.evaluate(LABELS)[0] and not page.complaints
    page.picture("hyperion")


def test_without_scripts_the_page_says_so(browser, page_of_a_book):
    context = browser.new_context(java_script_enabled=False)
    tab = context.new_page()
    tab.goto(page_of_a_book.as_uri())
    assert "needs JavaScript" in tab.locator("noscript").inner_text()
    context.close()


def test_drag_turns_all_views_at_once(page_of_a_book, opened):
    page = opened(page_of_a_book)
    box = page.tab.locator(".large canvas").bounding_box()
    before = page.tab.locator("canvas").nth(1).screenshot()
    page.tab.mouse.move(box["x"] + 100, box["y"] + 100)
    page.tab.mouse.down()
    page.tab.mouse.move(box["x"] + 200, box["y"] + 130, steps=4)
    page.tab.mouse.up()
    page.settle()
    assert page.tab.locator("canvas").nth(1).screenshot() != before


def test_motion_starts_by_itself_unless_less_motion_is_wanted(page_of_a_book, opened):
    assert opened(page_of_a_book).tab.evaluate("window.polhode.playing") is False
    lively = opened(page_of_a_book, reduced_motion="no-preference")
    lively.until("window.polhode.shown().position > 2")


def overlap(a, b):
    return all(a[x] < b[x] + b[w] - 0.5 and b[x] < a[x] + a[w] - 0.5 for x, w in (("x", "width"), ("y", "height")))


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_phone(example_page, opened, scheme):
    page = opened(example_page("t_handle"), color_scheme=scheme, **PHONE)
    assert page.tab.evaluate("document.documentElement.scrollWidth") <= 390
    boxes = [panel.bounding_box() for panel in page.tab.locator("figure").all()]
    assert all(box["x"] + box["width"] <= 390 for box in boxes)
    assert not any(overlap(a, b) for a, b in combinations(boxes, 2))
    page.unfold()
    controls = [control.bounding_box() for control in page.tab.locator("button:visible").all()]
    assert all(min(box["width"], box["height"]) >= FINGER and box["x"] + box["width"] <= 390 for box in controls)
    assert page.tab.evaluate("window.polhode.shown().theme") == scheme
    parts = [part.bounding_box() for part in page.tab.locator("#timebar :is(button, output, input):visible").all()]
    assert not any(overlap(a, b) for a, b in combinations(parts, 2))
    assert page.tab.evaluate("[...document.querySelectorAll('output')].every(x => x.scrollWidth <= x.clientWidth)")
    rows = {round(part["y"] + part["height"] / 2.0) for part in parts}
    assert len(rows) == 2  # more would hide the pictures
    page.tab.locator("#forth").tap()
    assert page.position() == 1
    page.picture(f"t_handle-phone-{scheme}")


def test_dark_ground_and_the_toggle(page_of_a_book, opened):
    page = opened(page_of_a_book, color_scheme="dark")
    ground = "getComputedStyle(document.body).backgroundColor"
    dark = page.tab.evaluate(ground)
    assert max(int(x) for x in dark[4:-1].split(",")) < 64
    page.tab.locator("#theme").click()
    assert min(int(x) for x in page.tab.evaluate(ground)[4:-1].split(",")) > 192
    assert not page.complaints


def test_a_name_is_text(opened, tmp_path):
    name = "</script><script>window.hacked = 1</script><!-- <b>&amp;\u2028 @@data@@"
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0, 0.1, 0.2])
    page = opened(write_page(motion, tmp_path / "name.html", name=name, summary=name, notes=[name]))
    assert page.tab.evaluate("window.hacked") is None
    assert page.tab.locator("h1").text_content() == name
    assert page.tab.locator("#notes li").text_content() == name and page.tab.title().startswith("</script>")
    assert not page.complaints and page.requests == [page.url]


def test_policy_refuses_other_scripts(page_of_a_book, opened):
    page = opened(page_of_a_book)
    page.tab.evaluate("document.body.insertAdjacentHTML('beforeend', '<img src=x onerror=\"window.hacked=1\">')")
    page.tab.wait_for_timeout(200)
    assert page.tab.evaluate("window.hacked") is None


def test_samples_too_far_apart_are_not_joined(opened, tmp_path):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample(np.linspace(0.0, 300.0, 40))
    motion = replace(motion, source=FreeRigidBody((1.0, 2.0, 3.0)))
    page = opened(write_page(motion, tmp_path / "apart.html"))
    assert "it jumps" in page.tab.locator("#notes").text_content()
    page.seek(7)
    page.tab.locator("#play").click()
    page.until("window.polhode.shown().position >= 9")
    assert float(page.position()).is_integer()
    assert not page.complaints


ODD = {
    "rest": ((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), 20.0, 50),
    "one": ((1.0, 2.0, 3.0), (0.3, 1.8, 1.5), 0.0, 1),
    "spherical": ((2.0, 2.0, 2.0), (0.3, 0.4, 0.5), 20.0, 50),
    "permanent": ((1.0, 2.0, 3.0), (0.0, 2.0, 0.0), 20.0, 50),
    "no body": ((1.0, 2.0, 9.0), (0.3, 0.4, 1.5), 20.0, 50),
    "needle": ((1e-6, 1.0, 1.0), (1e-6, 0.4, 0.5), 20.0, 50),
    "molecule": ((1e-47, 2e-47, 2.9e-47), (1e-34, 1e-34, 0.0), 1e-11, 50),
}


@pytest.mark.parametrize("name", ODD)
def test_odd_motions_are_drawn(opened, tmp_path, name):
    moments, momentum, end, count = ODD[name]
    motion = ph.FreeMotion(moments, momentum=momentum).sample(np.linspace(0.0, end, count))
    page = opened(write_page(motion, tmp_path / "odd.html", name=name))
    page.seek(page.count() - 1)
    assert page.tab.locator("#failure").is_hidden() and not page.complaints
    for panel in page.tab.evaluate("[...document.querySelectorAll('.panel')].map((_, k) => k)"):
        page.enlarge(panel)
        page.settle()
        assert len(page.tab.locator(".large canvas").screenshot()) > EMPTY
    values = page.tab.locator("#readouts").text_content()
    assert "NaN" not in values and "Infinity" not in values


def test_attitudes_alone_are_drawn(opened, tmp_path):
    whole = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample(np.linspace(0.0, 9.0, 91))
    read = Recording(labels=AttitudeLabels())
    bare = replace(whole, source=read, momentum=None, angular_velocity=None, invariants={})
    page = opened(write_page(bare, tmp_path / "bare.html"))
    before = page.measure("body")["axisTip"]
    page.seek(50.5)
    assert page.measure("body")["axisTip"] != before and not page.complaints


def test_without_webgl_the_page_says_so(browser, page_of_a_book):
    context = browser.new_context()
    tab = context.new_page()
    tab.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    tab.goto(page_of_a_book.as_uri())
    assert "WebGL 2" in tab.locator("#failure").text_content()
    assert tab.locator("h1").text_content() == "a book"
    context.close()


def test_frame_of_a_notebook(opened, tmp_path):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample(np.linspace(0.0, 9.0, 91))
    host = tmp_path / "notebook.html"
    frame = show(motion, name='"quoted"', height=500)._repr_html_()
    host.write_text(f"<!doctype html><script>window.polhode = {{firstPicture: 1}}</script>{frame}", "utf-8")
    page = opened(host)
    inner = page.tab.frame_locator("iframe")
    inner.locator("#readouts dd").first.wait_for()
    assert inner.locator("h1").text_content() == '"quoted"'
    assert not page.complaints
