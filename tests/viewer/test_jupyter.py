"""``show`` in a real JupyterLab, in chromium: the cell is run through its own interface, the frame is a whole page."""

import json
import os
import secrets
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import TimeoutError

import polhode as ph

pytest.importorskip("jupyterlab", reason="JupyterLab is not installed; the extra `notebook` has it")
nbformat = pytest.importorskip("nbformat")

WAIT = 90.0  # seconds for the server, and for each step in the browser
MOMENTS, MOMENTUM = (1.0, 2.0, 3.0), (0.3, 1.8, 1.5)
CELL = f"import polhode as ph\nph.show(ph.FreeMotion({MOMENTS}, momentum={MOMENTUM}))"
SAME, TRIES = 1e-9, 4
SCREENSHOTS = Path(__file__).parents[2] / "build" / "screenshots"


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """A JupyterLab with a folder of its own that has one notebook; its address with the token."""
    folder = tmp_path_factory.mktemp("lab")
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(CELL)])
    book.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbformat.write(book, folder / "motion.ipynb")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token = secrets.token_hex(16)
    places = {f"JUPYTER_{name}_DIR": str(folder / f".{name.lower()}") for name in ("CONFIG", "DATA", "RUNTIME")}
    run = subprocess.Popen(
        [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}",
         f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={folder}", "--LabApp.news_url=None"],
        env=os.environ | places, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT,
    )  # fmt: skip
    address = f"http://127.0.0.1:{port}"
    try:
        until = time.monotonic() + WAIT
        while True:
            try:
                urllib.request.urlopen(f"{address}/api?token={token}", timeout=5).close()
                break
            except OSError:
                assert run.poll() is None and time.monotonic() < until, "JupyterLab does not answer"
                time.sleep(0.3)
        yield f"{address}/lab/tree/motion.ipynb?token={token}", folder
    finally:
        run.terminate()
        run.wait(30)


class Lab:
    """The notebook in a tab, and the frame below its cell."""

    def __init__(self, browser, address):
        self.context = browser.new_context(viewport={"width": 1280, "height": 1100})
        self.tab = self.context.new_page()
        self.tab.set_default_timeout(WAIT * 1000.0)
        self.complaints = []
        self.tab.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.tab.goto(address)
        self.tab.locator(".jp-Notebook .jp-CodeCell").first.wait_for()

    def run_cell(self):
        """Run the cell by its key; a press that comes before the kernel is there does nothing, and is repeated."""
        for _ in range(TRIES):
            self.tab.locator(".jp-CodeCell .cm-content").first.click()
            self.tab.keyboard.press("Control+Enter")
            try:
                return self.tab.locator(".jp-OutputArea-output iframe").first.wait_for(timeout=1000.0 * WAIT / TRIES)
            except TimeoutError:
                continue
        raise AssertionError("the cell shows nothing")

    def picture(self, name):
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        self.tab.screenshot(path=str(SCREENSHOTS / f"{name}.png"))

    def frame(self):
        """Return the page's own frame once it has drawn."""
        handle = self.tab.locator(".jp-OutputArea-output iframe").first
        handle.wait_for()
        frame = handle.element_handle().content_frame()
        until = time.monotonic() + WAIT
        while not frame.evaluate("Boolean(window.polhode && window.polhode.firstPicture)"):
            assert time.monotonic() < until, "the frame draws nothing"
            time.sleep(0.1)
        return frame


@pytest.fixture
def lab(browser, server):
    opened = []

    def open_it():
        opened.append(Lab(browser, server[0]))
        return opened[-1]

    yield open_it
    for one in opened:
        one.context.close()


def miss(frame, moments, momentum, time):
    """How far the frame's state is from Python's; the sign of a quaternion says nothing."""
    found = frame.evaluate("t => Object.values(window.polhode.state(t)).map((x) => [...x])", time)
    attitude, wanted = ph.FreeMotion(moments, momentum=momentum).state(time)
    return max(1.0 - abs(np.dot(found[0], attitude)), np.abs(np.array(found[1]) - wanted).max())


@pytest.mark.timeout(300)
def test_a_cell_shows_a_motion_that_can_be_set(lab, server):
    one = lab()
    one.run_cell()
    frame = one.frame()
    assert miss(frame, MOMENTS, MOMENTUM, 100.0) < SAME
    # a slider, moved by the keyboard inside of the frame
    slider = frame.locator("#more input[type=range]").first
    frame.locator("#folded summary").click()
    slider.focus()
    slider.press("ArrowRight")
    settings = frame.evaluate("window.polhode.settings()")
    assert settings["body"]["moments"] != list(MOMENTS)
    velocity = np.array(settings["spin"]["angular_velocity"])
    moments = settings["body"]["moments"]
    assert miss(frame, moments, velocity * moments, 20.0) < SAME
    # the clipboard is out of reach of a frame, so the spec stands in a field
    frame.locator("#share summary").click()
    frame.locator("#spec").click()
    assert "[body]" in frame.locator("#copied").input_value() and frame.locator("#shared").text_content()
    frame.locator("#play").click()
    frame.page.wait_for_timeout(600)
    assert frame.evaluate("window.polhode.shown().time") > 0.0
    # nothing of the page is cut off sideways, and the notebook itself still scrolls
    assert frame.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert not one.complaints
    one.picture("jupyter")


@pytest.mark.timeout(300)
def test_a_saved_notebook_shows_it_again_where_it_is_trusted_and_a_sentence_elsewhere(lab, server):
    one = lab()
    one.run_cell()
    one.frame()
    one.tab.keyboard.press("Control+s")
    path, until = server[1] / "motion.ipynb", time.monotonic() + WAIT
    while "iframe" not in path.read_text("utf-8"):
        assert time.monotonic() < until, "the notebook was not saved"
        time.sleep(0.2)
    again = lab()
    assert miss(again.frame(), MOMENTS, MOMENTUM, 3.0) < SAME
    output = json.loads(path.read_text("utf-8"))["cells"][0]["outputs"][0]["data"]
    assert "".join(output["text/plain"]).startswith("<a page of polhode: notebooks show it once they are trusted")
