"""Pages of examples, each made once, and what the browser says about them."""

from dataclasses import replace
from pathlib import Path

import pytest

from polhode.kinds.page import page_of_report
from polhode.kinds.reading import read_spec

EXAMPLES = Path(__file__).parents[2] / "examples"
SHORTER = {"euler_disk": {"until": 0.6, "samples": 600}}  # to its end it takes half a minute
SCREENSHOTS = Path(__file__).parents[2] / "build" / "screenshots"


@pytest.fixture(scope="session")
def example_page(tmp_path_factory):
    """Return the page of an example by its name."""
    folder, made = tmp_path_factory.mktemp("pages"), {}

    def page(name):
        if name not in made:
            spec = replace(read_spec(EXAMPLES / f"{name}.toml"), **SHORTER.get(name, {}))
            report = spec.report()
            made[name] = page_of_report(report, folder / f"{name}.html", surface=spec.picture)
        return made[name]

    return page


class Opened:
    """A page in the browser, offline, with what it complained about and asked for."""

    def __init__(self, browser, path, **options):
        settings = {"viewport": {"width": 1280, "height": 860}, "reduced_motion": "reduce", "offline": True}
        self.context = browser.new_context(**settings | options)
        self.tab = self.context.new_page()
        self.complaints, self.requests = [], []
        self.tab.on("console", lambda message: message.type == "error" and self.complaints.append(message.text))
        self.tab.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.tab.on("request", lambda request: self.requests.append(request.url))
        self.url = path.as_uri()
        self.tab.goto(self.url)
        self.until("window.polhode && window.polhode.firstPicture")

    def until(self, condition, tries=600):
        """Wait until an expression is true; playwright's own way evaluates text, which the page's policy forbids."""
        for _ in range(tries):
            if self.tab.evaluate(f"Boolean({condition})"):
                return
            self.tab.wait_for_timeout(100)
        pytest.fail(f"never came true: {condition}")

    def unfold(self):
        """Open all that is folded."""
        self.tab.evaluate("document.querySelectorAll('details').forEach(one => (one.open = true))")

    def enlarge(self, panel):
        assert self.tab.evaluate("type => window.polhode.enlarge(type)", panel)

    def seek(self, index):
        self.tab.evaluate("index => window.seek(index)", index)

    def measure(self, panel, *names):
        return self.tab.evaluate("names => window.polhode.measure(...names)", [panel, *names])

    def position(self):
        return self.tab.evaluate("window.polhode.shown().position")

    def count(self):
        return self.tab.evaluate("window.polhode.count")

    def times(self):
        return self.tab.evaluate("[...window.polhode.times]")

    def picture(self, name):
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        return self.tab.screenshot(path=str(SCREENSHOTS / f"{name}.png"))


@pytest.fixture
def opened(browser):
    """Open a page; it is closed with the test."""
    found = []

    def opening(path, **options):
        found.append(Opened(browser, path, **options))
        return found[-1]

    yield opening
    for page in found:
        page.context.close()
