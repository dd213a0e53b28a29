"""Sphinx: pages in Markdown, those with code cells run at every build, and the reference from docstrings."""

import polhode

project = "polhode"
author = "The polhode developers"
release = version = polhode.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_theme = "furo"
exclude_patterns = ["build"]
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # shapes and units stand in the text; most types are "array"
napoleon_use_rtype = False


def escape_bars(app, what, name, obj, options, lines):
    """|L| is a norm, not one of reStructuredText's substitutions."""
    lines[:] = [line if line.lstrip().startswith(">>>") else line.replace("|", r"\|") for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", escape_bars)
