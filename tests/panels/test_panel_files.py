"""The pages of the panels as files: small, whole, whose policy allows their own script and style alone."""

import base64
import hashlib
import json
import re

import pytest

from panels.answers import ROOT, SOURCES

LARGEST = 60_000  # bytes: what the course promises of a panel
LONGEST = 450  # lines of a source
PAGES = sorted((ROOT / "learn" / "panels").glob("*.html"))


def digest(text):
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def complaints_about(text):
    """Return what is wrong with the text of a page."""
    found = []
    if len(text.encode()) > LARGEST:
        found.append("too large")
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]+)"', text)
    scripts = re.findall(r"<script>(.*?)</script>", text, re.DOTALL)
    styles = re.findall(r"<style>(.*?)</style>", text, re.DOTALL)
    own = f"script-src {digest(scripts[0])}; style-src {digest(styles[0])}"
    wanted = f"default-src 'none'; {own}; base-uri 'none'; form-action 'none'"
    if policy is None or policy[1] != wanted or len(scripts) != 1 or len(styles) != 1:
        found.append("policy")
    if re.search(r"""\b(src|href)=["']?(https?:)?//|url\(|@import|fetch\(|XMLHttpRequest|WebSocket""", text):
        found.append("asks for something")
    if re.search(r"<[a-z][^>]* (style|on[a-z]+)=", text.replace(scripts[0], "")):
        found.append("inline style or handler")
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_page_is_small_and_closed(page):
    assert complaints_about(page.read_text("utf-8")) == []


def test_complaints_are_seen():
    text = PAGES[0].read_text("utf-8")
    assert complaints_about(text.replace("</body>", "x" * LARGEST + "</body>")) == ["too large"]
    assert complaints_about(text.replace("script-src '", "script-src 'unsafe-inline' '")) == ["policy"]
    assert complaints_about(text.replace("</style>", " </style>")) == ["policy"]
    asking = text.replace("</body>", '<img src="https://example.org/x.png"></body>')
    assert complaints_about(asking) == ["asks for something"]
    assert complaints_about(text.replace("<header>", '<header style="color:red">')) == ["inline style or handler"]


def test_every_panel_has_title_and_sentence():
    titles = json.loads((SOURCES / "titles.json").read_text("utf-8"))
    assert set(titles) == {page.stem for page in PAGES} == {path.stem for path in SOURCES.glob("*.js")}
    for words in titles.values():
        assert words["title"] and words["sentence"].endswith(".") and len(words["sentence"].split()) < 40


def test_sources_stay_small():
    lines = {path.name: len(path.read_text("utf-8").splitlines()) for path in SOURCES.rglob("*.js")}
    assert max(lines.values()) <= LONGEST
