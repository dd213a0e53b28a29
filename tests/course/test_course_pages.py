"""The built course in a browser: nothing from outside, no complaint, exercises that respond, tabs that open."""

import re
from pathlib import Path

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.timeout(900)]  # the course is built before the first of them
SIZES = [(1366, 768), (390, 844)]


class Reader:
    """A page of the course as a reader has it, offline."""

    def __init__(self, window):
        self.window, self.tab = window, window.tab
        self.complaints, self.requests = window.complaints, window.requests

    def open(self, path, target=""):
        self.tab.goto(path.as_uri() + target)
        self.window.settle(100)
        return self.tab

    def wake(self):
        """Load the frames that wait until they are scrolled to, and have each drawn."""
        self.tab.evaluate("document.querySelectorAll('iframe').forEach(frame => frame.loading = 'eager')")
        self.until(lambda: all(frame.url.startswith("file:") for frame in self.tab.frames))
        for frame in self.tab.frames[1:]:
            self.until(lambda frame=frame: frame.evaluate("Boolean(globalThis.panel && panel.times.length)"))

    def until(self, condition, tries=300):
        """Wait until a condition holds; what never holds is left to what is asserted next."""
        for _ in range(tries):
            if condition():
                return
            self.tab.wait_for_timeout(30)


@pytest.fixture
def reader(windows):
    """Open a reader of a width and height; closed with the test."""
    taken = []

    def make(width=1366, height=768):
        taken.append(windows.take(viewport={"width": width, "height": height}))
        return Reader(taken[-1])

    yield make
    for window in taken:
        windows.give_back(window)


def pages(course):
    return [course / "index.html", course / "syllabus.html", *sorted((course / "chapters").glob("*.html"))]


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_every_page_opens_offline_without_complaint_and_fits(course, reader, size):
    one = reader(*size)
    assert len(pages(course)) >= 16
    for page in pages(course):
        tab = one.open(page)
        one.wake()
        width = tab.evaluate("document.documentElement.scrollWidth")
        assert width <= size[0] + 1, f"{page.name} is {width} pixels wide"
        assert one.complaints == [], page.name
    assert [url for url in one.requests if not url.startswith(("file:", "data:", "blob:", "about:"))] == []


def test_exercises_respond(course, reader):
    tab = reader().open(course / "chapters" / "05_two_surfaces.html")
    box = tab.locator(".exercise").first
    data = tab.evaluate("box => JSON.parse(box.dataset.exercise)", box.element_handle())
    _, answer, mistakes, solution = data["variants"][0]
    field, said = box.locator("input"), box.locator("output")
    for typed, expected in [("", "Enter a number."), (repr(answer), "Right."), (repr(mistakes[0]), data["hints"][0]),
                            (repr(answer).replace(".", ","), "Right.")]:  # fmt: skip
        field.fill(typed)
        field.press("Enter")
        assert said.inner_text() == expected
    box.get_by_role("button", name="Show how").click()
    assert said.inner_text() == solution
    text = box.locator("p").inner_text()
    box.get_by_role("button", name="Other numbers").click()
    assert box.locator("p").inner_text() != text and said.inner_text() == ""


def test_a_choice_says_why(course, reader):
    tab = reader().open(course / "chapters" / "05_two_surfaces.html")
    box = tab.locator(".choice").first
    options = tab.evaluate("box => JSON.parse(box.dataset.choice).options", box.element_handle())
    for option in options:
        box.get_by_text(option["text"], exact=True).click()
        assert box.locator("output").inner_text() == option["response"]


def test_an_address_opens_the_tier_that_holds_it(course, reader):
    one = reader()
    page = course / "chapters" / "05_two_surfaces.html"
    hidden = re.findall(r'<div class="derivation[^"]*" id="(derivation-[^"]+)"', page.read_text("utf-8"))
    tab = one.open(page, f"#{hidden[0]}")
    assert tab.locator(f"#{hidden[0]}").is_visible()
    assert not one.open(page, "#").locator(f"#{hidden[0]}").is_visible() or one.tab.reload() is not None


def test_search_finds_offline(course, reader):
    one = reader()
    tab = one.open(course / "search.html", "?q=Casimir")
    tab.locator("ul.search li").first.wait_for()
    assert tab.locator("ul.search li").count() > 0
    assert one.complaints == []


def test_each_syllabus_row_leads_somewhere(course, reader):
    tab = reader().open(course / "syllabus.html")
    rows = tab.evaluate(
        "[...document.querySelectorAll('table tbody tr')].map(row => [...row.cells].map(cell => cell.innerText.trim()))"
    )
    assert len(rows) == 26
    for row in rows:
        assert all(row), row
    links = tab.evaluate("[...document.querySelectorAll('table a')].map(link => link.href)")
    for link in links:
        path = Path(link.removeprefix("file://").partition("#")[0])
        assert path.is_file(), link
