"""Formulas on pages are set in the font that ships, offline."""

import pytest

from polhode.proving import derive


@pytest.mark.browser
def test_a_derivation_is_set_in_its_own_font(browser, tmp_path):
    path = tmp_path / "page.html"
    path.write_text(derive("free-body").render("html"), "utf-8")
    tab = browser.new_context(offline=True).new_page()
    asked = []
    tab.on("request", lambda request: asked.append(request.url))
    tab.goto(path.as_uri())
    tab.evaluate("() => document.fonts.ready")
    assert tab.evaluate("[...document.fonts].map(font => `${font.family} ${font.status}`)") == ["polhode math loaded"]
    # a dot stands above its letter, and a subscript below the line: without a MATH table both are on it
    over, sub = (tab.locator(f"math {tag}").first for tag in ("mover", "msub"))
    boxes = [[each.locator("xpath=*").nth(k).bounding_box() for k in (0, 1)] for each in (over, sub)]
    (letter, dot), (base, index) = boxes
    assert dot["y"] < letter["y"] and index["y"] + index["height"] > base["y"] + base["height"]
    assert all(url.startswith(("file:", "data:")) for url in asked)
    tab.context.close()
