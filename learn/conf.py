"""Sphinx: the course. Every number is computed, every line of a derivation is checked while the pages are built."""

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_ext"))
sys.path.insert(0, str(HERE.parent / "docs"))

import polhode  # noqa: E402  after the paths, as extensions

project = "polhode: a course"
author = "The polhode developers"
release = version = polhode.__version__
extensions = ["myst_parser", "sphinx_design", "sphinx_proof", "mathml", "course_pages"]
html_theme = "furo"
html_title = "How things turn"
# the math font is that of derivations, and its style that of the documentation
html_static_path = ["_static", "../docs/_static", "../src/polhode/proving/symbolic/assets"]
html_css_files = ["pages.css", "course.css"]
html_js_files = ["offline_search.js", ("exercises.js", {"defer": "defer"})]
html_copy_source = False
html_show_sourcelink = False
html_use_index = False
html_show_copyright = False
html_show_sphinx = False
exclude_patterns = ["_ext", "panels", "derivations", "build"]
myst_heading_anchors = 3
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist", "attrs_inline"]
html_math_renderer = "mathml"
suppress_warnings = ["myst.header"]
