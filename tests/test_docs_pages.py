"""Pages of the documents: the reference has one for each room, pictures say what they show, search works offline."""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md", *sorted(DOCS.rglob("*.md"))]
REFERENCE = sorted((DOCS / "reference").glob("*.md"))
PICTURE = re.compile(r"!\[([^\]]*)\]\([^)]*\)")
DIRECTIVE = re.compile(r"^\.\. auto(?:module|class|function):: (\S+)$", re.MULTILINE)
DRAWS = re.compile(r"\bplt\.(?!rc)|\.plot\(|\.figure\(|add_subplot|subplots\(|figures\[|figures\.\w+\(|\bImage\(")
PICTURED = re.compile(r"\{(?:figure|image)\}")
FEWEST = 3  # words of an alt text: fewer are a name, not a description
HOMES = {
    "FreeMotion": "motions", "LagrangeMotion": "motions", "Trajectory": "motions", "as_dataset": "motions",
    "closed_forms": "motions", "exact": "motions", "motion": "motions", "MotionPlan": "motions", "Body": "bodies",
    "combine": "bodies", "Fold": "integrators", "planning": "integrators", "solving": "integrators",
    "simulation": "integrators", "special": "rotation", "reports": "studies",
}  # fmt: skip
"""Rooms and names that stand on the page of another room."""


class Pictures(HTMLParser):
    """Collects the alt texts of images in HTML; None where there is none."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_starttag(self, tag, attributes):
        if tag == "img":
            self.found.append(dict(attributes).get("alt"))


def pictures(text):
    """Return the alt text of each picture of a page, "" or None where it has none."""
    blocks = re.compile(r"^(`{3,})(.*?)$.*?^\1$", re.DOTALL | re.MULTILINE)
    prose = blocks.sub(lambda block: block[0] if PICTURED.match(block[2]) else "", text)
    html = Pictures()
    html.feed(prose)
    of_directives = []
    for block in re.findall(r"^```\{(?:figure|image)\}.*?^```", prose, re.DOTALL | re.MULTILINE):
        found = re.search(r"^:alt: *(.*)$", block, re.MULTILINE)
        of_directives.append(found and found[1])
    cells = re.findall(r"^```\{code-cell\}.*?^```$", text, re.DOTALL | re.MULTILINE)
    said = [re.search(r'^:mystnb: .*alt: "([^"]*)"', cell, re.MULTILINE) for cell in cells if DRAWS.search(cell)]
    of_cells = [found and found[1] for found in said]
    return [*PICTURE.findall(prose), *html.found, *of_directives, *of_cells]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_picture_says_what_it_shows(page):
    for alt in pictures(page.read_text("utf-8")):
        assert alt and len(alt.split()) >= FEWEST, f"{page.name}: a picture with the alt text {alt!r}"


def test_pictures_without_words_are_found():
    assert pictures("![](a.png)") == [""] and pictures('<img src="a.png">') == [None]
    assert pictures("```{figure} a.png\n:alt: What it shows\n```\n\n```{image} b.png\n```") == ["What it shows", None]
    cell = "```{code-cell}\n%smotion.plot()\n```\n"
    assert pictures(cell % "") == [None] and pictures(cell % ':mystnb: {image: {alt: "A sphere"}}\n') == ["A sphere"]
    assert pictures("```python\nx = '![](a.png)'\n```\n![A top that leans](b.png)") == ["A top that leans"]


def test_what_the_reference_shows_stands_on_the_page_of_its_room_once():
    shown = [(page.stem, name) for page in REFERENCE for name in DIRECTIVE.findall(page.read_text("utf-8"))]
    names = [name for _, name in shown]
    assert len(names) == len(set(names)) > 150
    for page, name in shown:
        room = name.split(".")[1]
        assert HOMES.get(room, room) == page, f"{name} stands on {page}.md"


def test_the_reference_lists_its_pages():
    listed = re.findall(r"^reference/(\w+)$", (DOCS / "reference.md").read_text("utf-8"), re.MULTILINE)
    assert sorted(listed) == [page.stem for page in REFERENCE]


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Return the folder of two pages of the reference, built as the documents are."""
    application = pytest.importorskip("sphinx.application")
    for name in ("furo", "myst_nb", "latex2mathml"):
        pytest.importorskip(name)
    source, out = tmp_path_factory.mktemp("docs"), tmp_path_factory.mktemp("built")
    (source / "index.md").write_text("# Pages\n\n```{toctree}\nrotation\nerrors\n```\n")
    for name in ("rotation", "errors"):
        (source / f"{name}.md").write_text((DOCS / "reference" / f"{name}.md").read_text("utf-8"))
    mine = {"nb_execution_mode": "off", "html_static_path": [str(DOCS / "_static")], "exclude_patterns": []}
    (source / "conf.py").write_text(
        f"__file__ = {str(DOCS / 'conf.py')!r}\nexec(compile(open(__file__).read(), __file__, 'exec'))\n"
        "draw_figures = lambda app: None\nwrite_live_pages = build_course = lambda app, exception: None\n"
        + "".join(f"{name} = {value!r}\n" for name, value in mine.items())
    )
    application.Sphinx(source, source, out, out / "trees", "html", status=None, warning=sys.stderr).build()
    return out


@pytest.mark.browser
@pytest.mark.timeout(900)  # the pages are built before
def test_search_works_from_a_disk(built, browser):
    context = browser.new_context(offline=True)
    tab = context.new_page()
    complaints = []
    tab.on("console", lambda message: message.type == "error" and complaints.append(message.text))
    tab.on("pageerror", lambda error: complaints.append(str(error)))
    tab.goto((built / "index.html").as_uri())
    field = tab.locator("input[name=q]").first
    field.fill("from_euler_angles")
    field.press("Enter")
    result = tab.locator("#search-results li a").first
    result.wait_for(timeout=20_000)
    assert "from_euler_angles" in result.text_content()
    result.click()
    assert tab.url.startswith("file:") and "rotation.html" in tab.url and not complaints
    context.close()
