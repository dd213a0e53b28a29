"""Pages of examples, each made once, and what the browser says about them."""

from dataclasses import replace
from pathlib import Path

import pytest

from polhode.kinds import playground
from polhode.kinds.page import page_of_report
from polhode.kinds.reading import read_spec
from viewer.playgrounds import EXAMPLES, quick

SHORTER = {"euler_disk": {"until": 0.6, "samples": 600}}  # to its end it takes half a minute
SCREENSHOTS = Path(__file__).parents[2] / "build" / "screenshots"


@pytest.fixture(scope="session")
def example_page(tmp_path_factory):
    """Return the page of an example by its name."""
    folder, made = tmp_path_factory.mktemp("pages"), {}

    def page(name):
        if name not in made:
            spec = replace(read_spec(EXAMPLES[name]), **SHORTER.get(name, {}))
            report = spec.report()
            made[name] = page_of_report(report, folder / f"{name}.html", surface=spec.picture)
        return made[name]

    return page


@pytest.fixture(scope="session")
def short(tmp_path_factory):
    """The playground without the motions that take long to compile."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(playground, "presets", quick)
        return playground.write_playground(tmp_path_factory.mktemp("short") / "playground.html", EXAMPLES)


@pytest.fixture(scope="session")
def whole(tmp_path_factory):
    return playground.write_playground(tmp_path_factory.mktemp("whole") / "playground.html", EXAMPLES)


class Opened:
    """A page in the browser, offline, with what it complained about and asked for."""

    def __init__(self, window, path, fragment=""):
        self.window, self.context, self.tab = window, window.context, window.tab
        self.complaints, self.requests = window.complaints, window.requests
        self.url = path.as_uri() + fragment
        self.tab.goto(self.url)
        self.until("window.polhode && window.polhode.firstPicture")

    def until(self, condition, tries=1500):
        """Wait until an expression is true; playwright's own way evaluates text, which the page's policy forbids."""
        for _ in range(tries):
            if self.tab.evaluate(f"Boolean({condition})"):
                return
            self.tab.wait_for_timeout(40)
        pytest.fail(f"never came true: {condition}")

    def settle(self, after=0):
        self.window.settle(after)

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
def opened(windows):
    """Open a page in a window with these options, after a script of a test has run there.

    A window with a script, or with more that stays in it, is the test's own.
    """
    taken = []

    def opening(path, fragment="", script=None, own=False, **options):
        taken.append(windows.take(own=own or script is not None, **options))
        if script:
            taken[-1].tab.add_init_script(script)
        return Opened(taken[-1], path, fragment)

    yield opening
    for window in taken:
        windows.give_back(window)
