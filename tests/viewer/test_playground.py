"""The playground: every motion opens on desktop and phone, says what to watch, and its steps do what they say."""

from itertools import combinations

import pytest

from polhode.kinds.playground import presets
from viewer.playgrounds import EXAMPLES, quick

LARGEST = 1_750_000
"""Bytes; the words in three more languages are 87 000 of these."""
PHONE = {"viewport": {"width": 390, "height": 780}, "has_touch": True, "is_mobile": True}


def overlap(a, b):
    return a[0] < b[0] + b[2] and b[0] < a[0] + a[2] and a[1] < b[1] + b[3] and b[1] < a[1] + a[3]


def check_every_motion(page, words):
    for k, preset in enumerate(words):
        page.tab.locator("#presets button").nth(k).click()
        assert page.tab.locator("#presets button[aria-pressed=true]").text_content() == preset["title"]
        steps = page.tab.locator("#story li")
        assert steps.count() == len(preset["story"])
        for panel in reversed(range(page.tab.locator(".panel").count())):
            page.enlarge(panel)  # small pictures have no names
            for part in (0.0, 0.37, 1.0) if panel == 0 else (0.37,):
                page.seek(part * (page.count() - 1))
                boxes = page.tab.evaluate("window.polhode.names()")[panel]
                assert not any(overlap(a, b) for a, b in combinations(boxes, 2)), (preset["title"], part, boxes)
        for j, step in enumerate(preset["story"]):
            if "set" in step:
                page.enlarge(0)
                before = page.tab.evaluate("window.polhode.settings()")
                steps.nth(j).locator("button").click()
                assert page.tab.evaluate("window.polhode.settings()") != before
                assert page.tab.locator("#refused").text_content() == ""
    page.tab.locator("#theme").click()  # the last one is thrown away and made again
    page.tab.locator("#presets button").first.click()
    page.seek(0)
    assert page.tab.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert page.tab.locator("#failure").is_hidden() and not page.complaints


@pytest.mark.browser
@pytest.mark.parametrize(
    "options", [pytest.param({}, id="desktop"), pytest.param(PHONE, id="phone", marks=pytest.mark.sweep)]
)
def test_every_motion_opens(short, opened, options):
    check_every_motion(opened(short, **options), quick())


@pytest.mark.browser
@pytest.mark.sweep
@pytest.mark.parametrize("options", [{}, PHONE], ids=["desktop", "phone"])
def test_every_motion_of_the_whole_playground_opens(whole, opened, options):
    assert whole.stat().st_size < LARGEST
    check_every_motion(opened(whole, **options), presets())


@pytest.mark.browser
def test_a_link_names_the_motion(short, opened):
    page = opened(short)
    page.tab.locator("#presets button").nth(5).click()
    page.tab.locator("#story button").first.click()
    page.until("location.hash.includes('preset=top')")
    address = page.tab.evaluate("location.href")
    other = opened(short, address.removeprefix(short.as_uri()))
    assert other.tab.locator("h1").text_content() == page.tab.locator("h1").text_content()
    assert other.tab.evaluate("window.polhode.settings()") == page.tab.evaluate("window.polhode.settings()")
    other.tab.goto("about:blank")
    other.tab.goto(address.split("#")[0] + "#preset=nonsense")
    other.until("window.polhode && window.polhode.firstPicture")
    assert "no motion called nonsense" in other.tab.locator("#story").text_content()


def test_stories_are_about_examples_that_there_are():
    words = presets()
    assert len({one["title"] for one in words}) == len(words) >= 9
    assert all(one["example"] in EXAMPLES and one["story"] for one in words)


# ---------------------------------------------------------------- speeds


def watched(page, title, seconds):
    """Return how long one watches for so much of a motion to pass, at the speed that it opens with [s]."""
    page.tab.locator("#presets button", has_text=title).click()
    words = page.tab.locator("#speed").text_content()
    powers = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
    if words == "real time":
        return seconds
    size, _, power = words.removeprefix("×").replace("−", "-").partition("·10")
    return seconds / (float(size) * 10.0 ** float(power.translate(powers) or 0))


LASTS = {"T-handle": 1.45616, "Book": 1.39237, "Phone": 1.23018, "Earth": 303.625 * 86400.0, "Apophis": 952567.0}
"""Seconds until these have done what there is to see."""


@pytest.mark.browser
def test_what_there_is_to_see_happens_within_twenty_seconds(short, opened):
    """A round of the Earth's pole took nine minutes of watching."""
    page = opened(short)
    for title, seconds in LASTS.items():
        assert watched(page, title, seconds) <= 20.0, title


@pytest.mark.sweep
@pytest.mark.browser
def test_explorer_goes_flat_within_twenty_seconds(whole, opened):
    assert watched(opened(whole), "Explorer 1", 1.6205) <= 20.0
