"""The page as an instrument: the picture stays in sight while anything is set, and nothing moves under the pointer."""


import numpy as np
import pytest

import polhode as ph
from polhode.kinds.page import show
from polhode.kinds.playground import presets
from sweeping import only

SIZES = [(1366, 768), (1280, 900), (390, 844)]
ENDS = [SIZES[0], pytest.param(SIZES[1], marks=pytest.mark.sweep), SIZES[2]]
"""The lowest window and the narrowest; what lies between is tried in the sweep."""
UNLIKE = {SIZES[0]: {"T-handle"}, SIZES[1]: {"T-handle", "Spinning top", "Quantum racket"},
          SIZES[2]: {"Spinning top", "Quantum racket"}}  # fmt: skip
"""Motions that have all the kinds of controls between them; the sweep tries every one at every size."""
IN_SIGHT = 0.6
"""Of the large picture, while a control is used."""
JUMP = 2.0
"""Pixels that what is under the pointer may move by."""
PARTS = (0.2, 0.8)
"""Of a slider's way, where a drag stops."""

LOOK = """element => {
  const picture = document.querySelector(".large canvas"), box = picture.getBoundingClientRect();
  const at = (rect, x, y) => document.elementFromPoint(rect.left + x * rect.width, rect.top + y * rect.height);
  let seen = 0;
  for (let i = 0.5; i < 10; i++) for (let j = 0.5; j < 10; j++) seen += at(box, i / 10, j / 10) === picture;
  const own = element.getClientRects()[0], hit = element.contains(at(own, 0.5, 0.5));
  return { seen: seen / 100, left: own.left, top: own.top, width: own.width, height: own.height, hit,
           words: element.id || element.ariaLabel || element.textContent };
}"""


class Watch:
    """Looks at the large picture and at one control while this is used."""

    def __init__(self, page, control):
        self.mouse, self.control = page.tab.mouse, control.element_handle()
        self.control.evaluate("one => { one.scrollIntoView({ block: 'nearest' }); one.focus(); }")
        self.first = self.control.evaluate(LOOK)
        assert self.first["hit"], f"{self.first['words']} is covered"
        self.check()

    def place(self, part):
        return self.first["left"] + part * self.first["width"], self.first["top"] + 0.5 * self.first["height"]

    def check(self):
        now = self.control.evaluate(LOOK)
        moved = max(abs(now[side] - self.first[side]) for side in ("left", "top"))
        assert now["seen"] >= IN_SIGHT, f"{now['words']}: {now['seen']:.0%} of the picture is in sight"
        assert moved <= JUMP, f"{now['words']} jumps by {moved:.0f} pixels"


def drag(page, slider):
    watch = Watch(page, slider)
    for k, part in enumerate(PARTS):
        watch.mouse.move(*watch.place(part))
        if not k:
            watch.mouse.down()
        watch.check()
    watch.mouse.up()
    watch.check()


def choose(page, select):
    watch = Watch(page, select)
    values = select.locator("option").evaluate_all("all => all.map(one => one.value)")
    for value in [*values[1:2], values[0]]:
        select.select_option(value)
        watch.check()


def press(page, button):
    watch = Watch(page, button)
    watch.mouse.click(*watch.place(0.5))
    watch.check()


def type_in(page, field):
    watch = Watch(page, field)
    for text in ("none", "1"):
        field.fill(text)
        page.tab.keyboard.press("Enter")
        watch.check()


def use_everything(page):
    """Use every control of the motion that is shown, by the mouse and by typing."""
    tab = page.tab
    page.unfold()
    for button in tab.locator("#story button").all():
        press(page, button)
    tab.evaluate("window.polhode.enlarge(0)")
    ways = {"input[type=range]": drag, "select": choose, "input[type=text]": type_in}
    for kind, use in ways.items():
        names = tab.locator(f"#instrument .control {kind}").evaluate_all(
            "all => all.map(one => one.closest('.control').querySelector('[id]').id)"
        )
        for name in names:
            control = tab.locator(f".control:has(#{name}) {kind}")
            if control.count():  # a choice may have taken it away
                use(page, control)
    for button in tab.locator("#reset, #share button:visible:not(#film), #timebar button:visible").all():
        press(page, button)
    drag(page, tab.locator("#seek"))


def use_every_motion(page, size, titles=None):
    for button in page.tab.locator("#presets button").all():
        press(page, button)
        if titles is None or button.text_content() in titles:
            use_everything(page)
    assert page.tab.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert not page.complaints
    page.picture(f"used-{size[0]}")


def sized(size):
    return {"viewport": dict(zip(("width", "height"), size, strict=True))}


@pytest.mark.browser
@pytest.mark.timeout(600)
@pytest.mark.parametrize("size", ENDS)
def test_the_picture_stays_in_sight_and_nothing_jumps(short, opened, size):
    """With the tilt slider in view, none of the picture was; a plot that appeared moved the slider by 248 pixels."""
    use_every_motion(opened(short, **sized(size)), size, UNLIKE[size])


@pytest.mark.browser
@pytest.mark.sweep
@pytest.mark.timeout(900)
@pytest.mark.parametrize("size", SIZES)
def test_the_whole_playground_stays_in_sight(whole, opened, size):
    use_every_motion(opened(whole, **sized(size)), size)


def with_rules(page, rules):
    """Break a page by rules of style; the page's policy leaves sheets that scripts construct alone."""
    page.tab.evaluate(
        "rules => { const s = new CSSStyleSheet(); s.replaceSync(rules); document.adoptedStyleSheets = [s]; }", rules
    )


@pytest.mark.browser
@pytest.mark.parametrize("size", ENDS)
def test_a_picture_that_scrolls_away_is_found(short, opened, size):
    page = opened(short, **sized(size))
    with_rules(page, "#panels { position: static !important; } #side { padding-top: 900px; }")
    with pytest.raises(AssertionError, match="of the picture is in sight"):
        use_everything(page)


@pytest.mark.browser
def test_what_pushes_a_slider_away_is_found(short, opened):
    page = opened(short, **sized(SIZES[0]))
    page.tab.evaluate("addEventListener('input', () => document.querySelector('#story').prepend('pushed'))")
    with pytest.raises(AssertionError, match="jumps by"):
        use_everything(page)


def scrolled_by_itself(page):
    """Return by how much a plot that vanishes pulls up the page, which is scrolled to its end."""
    page.tab.evaluate("window.polhode.set({ spin: { rate: 12, about: 3, tilt: 1e-4 } })")
    page.tab.evaluate("window.scrollTo(0, 1e6)")
    before, count = page.tab.evaluate("window.scrollY"), page.tab.locator(".plot").count()
    page.tab.evaluate("window.polhode.set({ spin: { rate: 12, about: 2, tilt: 0.3 } })")
    assert page.tab.locator(".plot").count() == count - 1
    return abs(page.tab.evaluate("window.scrollY") - before)


@pytest.mark.browser
def test_a_plot_that_goes_leaves_its_room(short, opened):
    page = opened(short, **sized(SIZES[2]))
    assert scrolled_by_itself(page) <= JUMP
    with_rules(page, "#plots { min-height: 0 !important; }")
    assert scrolled_by_itself(page) > 50.0


@pytest.mark.browser
@pytest.mark.parametrize("size", ENDS)
def test_any_picture_is_made_large_by_a_click_or_a_key(short, opened, size):
    page = opened(short, **sized(size))
    areas = "[...document.querySelectorAll('.panel canvas')].map(one => one.clientWidth * one.clientHeight)"
    for which, use in ((1, "click"), (2, "key"), (0, "key")):
        button = page.tab.locator(".enlarge").nth(which)
        assert button.get_attribute("aria-label").startswith("Make large: ")
        if use == "click":
            button.click()
        else:
            button.focus()
            page.tab.keyboard.press("Enter")
            assert page.tab.evaluate("document.activeElement.closest('.large') !== null")
        found = page.tab.evaluate(areas)
        assert int(np.argmax(found)) == which and found[which] > 4.0 * sorted(found)[1]
    assert not page.complaints


def check_legend(page):
    """Every checkbox of the large picture's legend is in sight above the time bar, whole, without scrolling."""
    found = page.tab.evaluate("""() => {
      const bar = document.querySelector("#timebar").getBoundingClientRect().top;
      const legend = document.querySelector(".large .legend").getBoundingClientRect();
      return [...document.querySelectorAll(".large .legend > *")].map((one) => one.getBoundingClientRect())
        .map((box) => [box.bottom - Math.min(bar, legend.bottom), box.right - legend.right]);
    }""")
    assert found and all(below <= 1.0 and beside <= 1.0 for below, beside in found)


def check_every_legend(page):
    for button in page.tab.locator("#presets button").all():
        button.click()
        for k in range(page.tab.locator(".panel").count()):
            page.enlarge(k)
            check_legend(page)


@pytest.mark.browser
@pytest.mark.parametrize("language", only(["de"], ["en", "de", "fr", "es"]))
def test_the_legend_is_in_sight_below_the_scene(short, opened, language):
    """A row above the scene pushed its checkboxes below the window, 768 pixels high; German words are the longest."""
    page = opened(short, f"#lang={language}", **sized(SIZES[0]))
    check_every_legend(page)
    page.picture(f"legend-{language}")
    with_rules(page, ".large .legend { height: 20px !important; }")
    with pytest.raises(AssertionError):
        check_every_legend(page)


@pytest.mark.browser
def test_a_log_is_opened_at_the_end_of_what_can_be_set(short, opened):
    page = opened(short, **sized(SIZES[0]))
    boxes = [page.tab.locator(name).bounding_box() for name in ("#panels", "#instrument", "#share", "#log")]
    panels, instrument, share, log = boxes
    assert panels["y"] < 80 and log["x"] >= share["x"] > panels["x"] + panels["width"]
    assert instrument["y"] < share["y"] < log["y"]
    page.tab.locator("#share summary").focus()
    page.tab.keyboard.press("Tab")
    assert page.tab.evaluate("document.activeElement.closest('#log') !== null")


@pytest.mark.browser
def test_a_sentence_shows_what_it_is_about(short, opened):
    """Its button stands in it, and keys reach it."""
    page = opened(short)
    steps = page.tab.locator("#story li")
    assert steps.nth(1).text_content() == "Tilt it by 5°, and it still turns over, only sooner."
    steps.nth(1).locator("button").focus()
    page.tab.keyboard.press("Enter")
    changed = page.tab.evaluate("window.polhode.settings()")
    steps.nth(0).locator("button").click()
    assert page.tab.evaluate("window.polhode.settings()") != changed
    assert page.tab.evaluate("location.hash") == "#preset=t_handle"
    steps.nth(4).locator("button").click()
    assert page.tab.locator(".large strong").text_content() == "Momentum sphere"


def test_every_sentence_has_its_button_in_it():
    """A sentence without brackets would have it at its end, or none."""
    said = [step["say"] for one in presets() for step in one["story"]]
    assert all(say.count("[") == say.count("]") == 1 for say in said)


@pytest.mark.browser
@pytest.mark.parametrize("width", [780, 900, 1060])
def test_a_notebooks_frame_shows_all_pictures(opened, tmp_path, width):
    frame = show(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)))._repr_html_()
    host = tmp_path / "notebook.html"
    words = "<!doctype html><script>window.polhode = {firstPicture: 1}</script>"
    host.write_text(f'{words}<body style="margin:0"><div style="width:{width}px">{frame}</div>', "utf-8")
    page = opened(host, viewport={"width": 1280, "height": 900})
    page.tab.frame_locator("iframe").locator("#readouts dd").first.wait_for()
    inner = page.tab.frames[1]
    boxes = inner.evaluate("""[...document.querySelectorAll('.panel canvas')].map(one => one.getBoundingClientRect())
      .map(({ left, top, right, bottom }) => [left, top, right, bottom])""")
    bar = inner.evaluate("document.querySelector('#timebar').getBoundingClientRect().top")
    assert len(boxes) == 3
    assert all(left >= 0 and top >= 0 and right <= width and bottom <= bar for left, top, right, bottom in boxes)
    assert all(min(right - left, bottom - top) > 100 for left, top, right, bottom in boxes)
    page.picture(f"notebook-{width}")


# ---------------------------------------------------------------- wheel and fingers

AT_REST = """() => new Promise((done) => {
  let [before, same] = [null, 0];
  const look = () => {
    same = window.scrollY === before ? same + 1 : 0;
    before = window.scrollY;
    if (same > 10) done();
    else requestAnimationFrame(look);
  };
  look();
})"""
"""Scrolling goes on for some frames, the more the slower they are."""


def wheel(page, by, times=3):
    """Turn the wheel over the middle of the large picture; return how far the page scrolls, and by what it zooms."""
    box = page.tab.locator(".large canvas").bounding_box()
    look = "[window.scrollY, window.polhode.view.zoom]"
    top, zoom = page.tab.evaluate(look)
    page.tab.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    for _ in range(times):
        page.tab.mouse.wheel(0, by)
        page.settle(60)
    page.tab.evaluate(AT_REST)
    now, closer = page.tab.evaluate(look)
    return now - top, closer / zoom


def check_wheel(page):
    page.unfold()
    scrolled, zoomed = wheel(page, 60)
    assert scrolled > 100 and zoomed == 1.0
    assert wheel(page, -60)[0] < -100
    page.tab.keyboard.down("Control")
    scrolled, zoomed = wheel(page, -60)
    page.tab.keyboard.up("Control")
    assert scrolled == 0 and zoomed > 1.1
    for let_go in (lambda: page.tab.keyboard.press("Escape"), lambda: page.tab.locator("h1").click()):
        box = page.tab.locator(".large canvas").bounding_box()
        page.tab.mouse.click(box["x"] + 0.3 * box["width"], box["y"] + 0.3 * box["height"])
        assert page.tab.locator(".held").count() == 1
        scrolled, zoomed = wheel(page, 60)
        assert scrolled == 0 and zoomed < 0.9
        let_go()
        assert page.tab.locator(".held").count() == 0
        scrolled, zoomed = wheel(page, 60)
        assert scrolled > 100 and zoomed == 1.0
        page.tab.evaluate("window.scrollTo(0, 0)")


@pytest.mark.browser
def test_the_wheel_scrolls_unless_a_click_or_ctrl_gives_it_to_the_picture(short, opened):
    """Fourteen notches over a picture scrolled by nothing."""
    page = opened(short, **sized(SIZES[0]))
    check_wheel(page)
    assert not page.complaints


@pytest.mark.browser
def test_a_picture_that_keeps_the_wheel_is_found(short, opened):
    page = opened(short, **sized(SIZES[0]))
    keep = "(event) => event.preventDefault()"
    page.tab.evaluate(f"document.querySelector('.large').addEventListener('wheel', {keep}, {{ passive: false }})")
    with pytest.raises(AssertionError):
        check_wheel(page)


@pytest.mark.browser
def test_two_fingers_bring_the_picture_closer(short, opened):
    page = opened(short, viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    box = page.tab.locator(".large canvas").bounding_box()
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
    fingers = page.context.new_cdp_session(page.tab)

    def touch(kind, apart):
        points = [{"x": x - apart, "y": y, "id": 0}, {"x": x + apart, "y": y, "id": 1}] if apart else []
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    touch("touchStart", 30)
    for apart in (40, 50, 60):
        touch("touchMove", apart)
    touch("touchEnd", 0)
    assert page.tab.evaluate("window.polhode.view.zoom") == pytest.approx(2.0, rel=0.1)
    assert page.tab.evaluate("window.scrollY") == 0 and page.tab.locator(".held").count() == 0
