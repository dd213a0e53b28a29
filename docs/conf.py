"""Sphinx: pages in Markdown, those with code cells run at every build, and the reference from docstrings."""

import re
import subprocess
import sys
from pathlib import Path

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

import polhode
from polhode.cli.compiled import compile_quickly
from polhode.formats.figure_file import save_figure
from polhode.kinds.playground import write_playground
from polhode.kinds.reading import read_spec

sys.path.insert(0, str(Path(__file__).parent))
from module_lists import files_of, markdown_list

logger = logging.getLogger(__name__)
compile_quickly()  # here and in the kernels that run the cells
project = "polhode"
author = "The polhode developers"
release = version = polhode.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "mathml"]
html_theme = "furo"
html_static_path = ["_static", "../src/polhode/proving/symbolic/assets"]  # the math font is that of derivations
html_css_files = ["pages.css"]
html_js_files = ["offline_search.js"]
exclude_patterns = ["build"]
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
myst_heading_anchors = 3
myst_enable_extensions = ["dollarmath"]
html_math_renderer = "mathml"  # browsers draw it themselves: no script, and no request to anywhere
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # shapes and units stand in the text; most types are "array"
napoleon_use_rtype = False


def escape_marks(app, what, name, obj, options, lines):
    """|L| is a norm and ad* a map: neither is markup."""
    for n, line in enumerate(lines):
        if not line.lstrip().startswith(">>>"):
            lines[n] = re.sub(r"\*(?=element_shape)|(?<=ad)\*|(?<=Ad)\*", r"\\*", line.replace("|", r"\|"))


def draw_figures(app):
    """Draw every images/drawn/EXAMPLE-FIGURE.png that a page asks for, of the example's report."""
    docs, wanted = Path(__file__).parent, {}
    for page in docs.glob("*.md"):
        for example, figure in re.findall(r"images/drawn/(\w+)-(\w+)\.png", page.read_text("utf-8")):
            wanted.setdefault(example, set()).add(figure)
    drawn = docs / "images" / "drawn"
    drawn.mkdir(parents=True, exist_ok=True)
    for example, figures in sorted(wanted.items()):
        spec = read_spec(docs.parent / "examples" / f"{example}.toml")
        report = spec.report()
        for figure in sorted(figures):
            save_figure(report.figure(figure), drawn / f"{example}-{figure}.png")


def write_live_pages(app, exception):
    """The pages that documents show in frames stand next to them."""
    if exception is None and app.builder.format == "html":
        examples = {path.stem: path for path in (Path(__file__).parents[1] / "examples").glob("*.toml")}
        write_playground(Path(app.outdir) / "playground-page.html", examples)


def build_course(app, exception):
    """The course is a book of its own, in the folder `learn` beside these pages."""
    if exception is None and app.builder.format == "html":
        course = Path(__file__).parents[1] / "learn"
        command = [sys.executable, "-m", "sphinx", "-W", "-q", str(course), str(Path(app.outdir) / "learn")]
        subprocess.run(command, check=True)


class FilesOfRooms(SphinxDirective):
    """The files of one or more rooms of the package, by their docstrings, to be opened by a click."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self):
        listed, names = nodes.container(), self.arguments[0].split()
        for name in names:
            for path in files_of(name):
                self.env.note_dependency(str(path))
        text = "\n".join(markdown_list(name) for name in names)
        self.state.nested_parse(StringList(text.splitlines(), "module_lists.py"), 0, listed)
        count = len(text.splitlines())
        opened = f"<details><summary>{count} file{'s' if count > 1 else ''}</summary>"
        return [nodes.raw("", opened, format="html"), listed, nodes.raw("", "</details>", format="html")]


def ask_for_words(app, doctree):
    """Warn of pictures without an alt text: those who do not see them get a file's name, or nothing."""
    for picture in doctree.findall(nodes.image):
        if not picture.get("alt"):
            logger.warning("%s: a picture has no alt text", picture.get("uri"), location=picture)


def skip_fields(app, what, name, member, skip, options):
    """Leave out the fields of named tuples, which the text of their class describes under "Attributes"."""
    return True if type(member).__name__ == "_tuplegetter" else None


def setup(app):
    app.add_directive("files", FilesOfRooms)
    app.connect("autodoc-process-docstring", escape_marks)
    app.connect("autodoc-skip-member", skip_fields)
    app.connect("builder-inited", draw_figures)
    app.connect("doctree-read", ask_for_words)
    app.connect("build-finished", write_live_pages)
    app.connect("build-finished", build_course)
