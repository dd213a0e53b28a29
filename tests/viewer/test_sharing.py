"""The address is that of what is seen, and is followed; links, embed code, pictures and films are what they say."""

import base64
import html
import re
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import polhode as ph
from polhode.kinds import playground
from polhode.kinds.page import write_page
from polhode.kinds.playground import presets, write_playground

pytestmark = pytest.mark.browser
EXAMPLES = {path.stem: path for path in (Path(__file__).parents[2] / "examples").glob("*.toml")}
FEW = {"t_handle", "earth", "top"}
SEEN = """[window.polhode.settings(), document.querySelector("h1").textContent,
  document.querySelector(".large strong").textContent, window.polhode.shown().time]"""
LATER = 350
"""Milliseconds, longer than the address takes to follow."""
FILM = 1.0
"""Seconds that the film of a test takes."""


@pytest.fixture(scope="module")
def few(tmp_path_factory):
    """A playground of three motions."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(playground, "presets", lambda: [one for one in presets() if one["example"] in FEW])
        return write_playground(tmp_path_factory.mktemp("few") / "playground.html", EXAMPLES)


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 2.0, 0.1))
    return write_page(motion, tmp_path_factory.mktemp("book") / "book.html", name="a book")


def address_of(page):
    """Return the part of the address after #, once it has followed the last change."""
    page.settle(LATER)
    return page.tab.evaluate("location.hash")


def check_address(page):
    """Go through buttons; after each, the address alone must bring back what is seen."""
    tab, visited = page.tab, []
    for preset in tab.locator("#presets button").all():
        preset.click()
        key = {"T-handle": "t_handle", "Earth": "earth", "Spinning top": "top"}[preset.text_content()]
        assert tab.evaluate("location.hash") == f"#preset={key}"  # and nothing of the motion before
        for button in tab.locator("#story button").all():
            button.click()
            visited.append((address_of(page), tab.evaluate(SEEN)))
    tab.evaluate("window.polhode.goTo(window.polhode.times[7])")
    visited.append((address_of(page), tab.evaluate(SEEN)))
    tab.locator("#reset").click()
    tab.evaluate("window.polhode.goTo(0)")
    tab.evaluate("window.polhode.enlarge('body')")
    assert address_of(page) == "#preset=top"
    for address, seen in visited:
        tab.evaluate("address => (location.hash = address)", address)
        page.settle()
        assert tab.evaluate(SEEN) == seen, address


def test_the_address_is_always_that_of_what_is_seen_and_is_followed(few, opened):
    """After a story's button, choosing the Earth left the T-handle's address."""
    page = opened(few)
    check_address(page)
    assert not page.complaints


@pytest.mark.parametrize("broken", [
    "History.prototype.replaceState = () => {}",
    "addEventListener('hashchange', (event) => event.stopImmediatePropagation())",
])  # fmt: skip
def test_an_address_that_is_left_behind_is_found(few, opened, broken):
    page = opened(few, script=broken)
    with pytest.raises(AssertionError):
        check_address(page)


def test_a_slider_changes_the_address_soon(book, opened):
    page = opened(book)
    assert address_of(page) == ""
    page.tab.locator(".control:has(#set-spin-tilt) input[type=range]").fill("300")
    page.until("location.hash.includes('spin.angular_velocity=')")
    page.tab.locator("#reset").click()
    page.until("location.hash === ''")


# ---------------------------------------------------------------- links and code


def copied(page, button):
    page.tab.locator(button).click()
    page.until("!document.querySelector('#copied').hidden && document.querySelector('#shared').textContent")
    return page.tab.locator("#copied").input_value()


def test_the_link_and_the_embed_code_show_the_same(few, opened, tmp_path):
    page = opened(few, own=True)
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.tab.locator("#story button").nth(2).click()
    page.tab.evaluate("window.polhode.enlarge('poinsot')")
    page.unfold()
    link = copied(page, "#link")
    assert link == page.tab.evaluate("location.href") and "view=poinsot" in link
    assert page.tab.evaluate("navigator.clipboard.readText()") == link
    assert "opens on this computer only" in page.tab.locator("#shared").text_content()
    code = copied(page, "#embed")
    assert html.unescape(re.findall(r'src="([^"]*)"', code)[0]) == link and 'title="polhode: T-handle"' in code
    host = tmp_path / "host.html"
    host.write_text(f"<!doctype html><script>window.polhode = {{firstPicture: 1}}</script>{code}", "utf-8")
    other = opened(host)
    inner = other.tab.frame_locator("iframe")
    inner.locator(".large strong", has_text="Poinsot").wait_for()
    assert other.tab.frames[1].evaluate(SEEN)[:3] == page.tab.evaluate(SEEN)[:3]
    assert not page.complaints and not other.complaints


def test_a_frame_that_may_only_run_scripts_says_what_it_cannot_and_shows_the_text(book, opened, tmp_path):
    host = tmp_path / "host.html"
    script = "<script>window.polhode = {firstPicture: 1}</script>"
    frame = f'<iframe src="{book.as_uri()}" sandbox="allow-scripts" width="900" height="760"></iframe>'
    host.write_text(f"<!doctype html>{script}{frame}", "utf-8")
    page = opened(host)
    page.tab.frame_locator("iframe").locator("#share summary").click()
    inner = page.tab.frames[1]
    inner.locator("#link").click()
    inner.locator("#copied").wait_for()
    assert inner.locator("#copied").input_value() == book.as_uri()
    assert "copy the text from the field below" in inner.locator("#shared").text_content()
    inner.locator("#picture").click()
    inner.locator("#saved").wait_for()
    assert inner.locator("#saved").get_attribute("src").startswith("data:image/png;base64,")
    assert inner.evaluate("document.querySelector('#saved').naturalWidth") > 300
    assert "may not save files" in inner.locator("#shared").text_content()


# ---------------------------------------------------------------- pictures and films


def saved(page, button):
    with page.tab.expect_download() as found:
        page.tab.locator(button).click()
    return found.value


@pytest.mark.parametrize(("scheme", "ground"), [("light", (255, 255, 255)), ("dark", (20, 23, 27))])
def test_the_picture_is_the_large_one_on_its_ground(book, opened, scheme, ground):
    page = opened(book, color_scheme=scheme)
    page.unfold()
    page.tab.evaluate("window.polhode.enlarge('sphere')")
    page.settle()
    found = saved(page, "#picture")
    assert found.suggested_filename == "a-book.png"
    picture = np.asarray(Image.open(BytesIO(Path(found.path()).read_bytes())).convert("RGB"))
    wide, high = page.tab.evaluate("(one => [one.width, one.height])(document.querySelector('.large canvas'))")
    assert picture.shape[0] in (high, high - 1) and picture.shape[1] in (wide, wide - 1)
    assert tuple(picture[0, 0]) == ground and len(np.unique(picture.reshape(-1, 3), axis=0)) > 100
    assert not page.complaints


FRAMES = """data => new Promise((done, failed) => {
  const film = document.createElement("video"), found = [];
  const paper = document.createElement("canvas").getContext("2d");
  film.onerror = () => failed(film.error.message);
  const seek = (time) => new Promise((there) => { film.onseeked = there; film.currentTime = time; });
  film.onloadeddata = async () => {
    await seek(1e6);
    const length = film.currentTime;
    for (const part of [0, 1]) { // its ends: a machine under load may have drawn little between them
      await seek(part * length);
      [paper.canvas.width, paper.canvas.height] = [film.videoWidth, film.videoHeight];
      paper.drawImage(film, 0, 0);
      found.push([...paper.getImageData(0, 0, film.videoWidth, film.videoHeight).data]);
    }
    const apart = found[0].reduce((most, value, k) => Math.max(most, Math.abs(value - found[1][k])), 0);
    done({ length, wide: film.videoWidth, apart });
  };
  film.src = "data:video/webm;base64," + data;
})"""


def test_the_film_lasts_as_long_as_was_asked_and_moves(book, opened):
    page = opened(book, viewport={"width": 800, "height": 600})
    page.unfold()
    field = page.tab.locator("#film-length")
    assert float(field.input_value()) > 0.5  # one period at this speed
    field.fill("1000")
    page.tab.keyboard.press("Enter")
    assert "0.5 to 60 s; got 1000" in page.tab.locator("#shared").text_content()
    field.fill(str(FILM))
    page.tab.keyboard.press("Enter")
    found = saved(page, "#film")
    assert found.suggested_filename == "a-book.webm" and page.tab.evaluate("window.polhode.playing") is False
    data = Path(found.path()).read_bytes()
    assert data.startswith(b"\x1aE\xdf\xa3")
    blank = page.context.new_page()  # the page itself plays no films: its policy allows none
    film = blank.evaluate(FRAMES, base64.b64encode(data).decode())
    assert film["length"] == pytest.approx(FILM, abs=0.6) and film["wide"] > 200 and film["apart"] > 50
    assert not page.complaints


def test_a_browser_that_records_nothing_says_so(book, opened):
    page = opened(book)
    page.unfold()
    page.tab.evaluate("delete window.MediaRecorder")
    page.tab.locator("#film").click()
    assert "This browser cannot record films" in page.tab.locator("#shared").text_content()
    assert not page.complaints
