"""Frames of the course's panels, against the time that a screen of 60 Hz leaves"""

from __future__ import annotations

import shutil
import statistics
from collections.abc import Iterator
from pathlib import Path

from measure import Row, missing

PANELS = Path(__file__).parents[2] / "learn" / "panels"
SCREEN = "screen of 60 Hz"
FRAME = 1000.0 / 60.0  # ms
SIZE = {"width": 1280, "height": 800}
PLAY = """async () => {
  for (let k = 0; k < 50; k++) {
    if (k === 10) panel.times.length = 0;
    if (panel.settings.turn !== undefined) panel.set('turn', panel.settings.turn + 0.01);
    panel.seek(panel.time + 0.017);
    await new Promise((done) => requestAnimationFrame(() => done()));
  }
  return [...panel.times].sort((a, b) => a - b)[panel.times.length >> 1];
}"""


def rows(quick: bool) -> Iterator[Row]:
    """Yield how many frames, drawn while time passes and the picture is turned, fit into one of the screen's."""
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        chromium = None
    if chromium is None:
        yield missing("one frame of a panel", SCREEN, "pip install playwright, and Chromium")
        return
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium)
        for path in sorted(PANELS.glob("*.html"))[: 1 if quick else None]:
            page = browser.new_page(viewport=SIZE)
            page.goto(path.as_uri())
            page.wait_for_function("globalThis.panel && panel.times.length")
            medians = [page.evaluate(PLAY) for _ in range(1 if quick else 5)]
            ratios = [FRAME / each for each in medians]
            note = f"{statistics.median(medians):.1f} ms a frame"
            yield Row(
                f"panel `{path.stem}`", SCREEN, None, None, statistics.median(ratios), (min(ratios), max(ratios)), note
            )
            page.close()
        browser.close()
