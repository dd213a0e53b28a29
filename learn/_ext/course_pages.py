"""Directives of the course: panels, exercises, checked derivations, computed numbers, links to checked proofs."""

from __future__ import annotations

import html
import json
import math
import re
import shutil
import tomllib
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from checked_lines import Lines
from docutils import nodes
from docutils.parsers.rst import directives
from docutils.statemachine import StringList
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective, SphinxRole

import polhode
from polhode.course import Choice, chapter_names, read_chapter, worksheet

HERE = Path(__file__).resolve().parents[1]
PROOFS = HERE.parent / "proofs"
VARIANTS = 24  # sets of numbers that a page holds of an exercise
SEED = 1  # of the worksheets beside the course
SHOWN = {"panels": "panels", "derivations and proofs": "derivations", "exercises": "exercises"}
SOURCE = "https://github.com/polhode/polhode/blob/main"


def chapter_of(document: str) -> str:
    """Return the name of the chapter that a document belongs to: chapters/05_two_surfaces is two-surfaces."""
    return Path(document).name.partition("_")[2].replace("_", "-")


class Panel(SphinxDirective):
    """A panel in a frame, with a caption: ``{panel} surfaces``; the option `state` goes into its address."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar = {"height": directives.positive_int, "state": directives.unchanged}

    def run(self):
        name = self.arguments[0]
        page = HERE / "panels" / f"{name}.html"
        if not page.is_file():
            raise self.error(f"there is no panel {name!r} in learn/panels")
        self.env.note_dependency(str(page))
        title = re.search(r"<title>(.*?)</title>", page.read_text("utf-8"))
        state = self.options.get("state", "")
        root = "../" * self.env.docname.count("/")
        frame = (
            f'<iframe class="panel" src="{root}panels/{name}.html{"#" + html.escape(state) if state else ""}" '
            f'title="{title[1] if title else name}" loading="lazy" height="{self.options.get("height", 440)}"></iframe>'
        )
        figure = nodes.container(classes=["panel-figure"], ids=[f"panel-{name}"])
        figure += nodes.raw("", frame, format="html")
        self.state.nested_parse(self.content, self.content_offset, figure)
        return [figure]


class Exercises(SphinxDirective):
    """Exercises and choices of this chapter, by name, in the order given."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self):
        chapter = read_chapter(chapter_of(self.env.docname))
        return [nodes.raw("", _as_html(chapter.find(name)), format="html") for name in self.arguments[0].split()]


def _as_html(one) -> str:
    if isinstance(one, Choice):
        data: dict[str, Any] = {"options": [option.model_dump() for option in one.options], "text": one.text}
    else:
        questions = [one.draw(seed) for seed in range(VARIANTS)]
        data = {
            "unit": one.unit, "tolerance": one.tolerance,
            "variants": [[q.text, q.answer, [value for value, _ in q.mistakes], q.solution] for q in questions],
            "hints": [mistake.hint for mistake in one.mistakes],
        }  # fmt: skip
    kind = "choice" if isinstance(one, Choice) else "exercise"
    text = one.text if isinstance(one, Choice) else questions[0].text
    packed = html.escape(json.dumps(data, ensure_ascii=False, separators=(",", ":")))
    return f'<div class="{kind}" id="{one.name}" data-{kind}="{packed}"><p>{html.escape(text)}</p></div>'


class Derivation(SphinxDirective):
    """A derivation of the folder `derivations`; each line is checked here, and a broken one stops the build."""

    required_arguments = 1

    def run(self):
        name = self.arguments[0]
        lines = checked_lines(name)
        self.env.note_dependency(str(HERE / "derivations" / f"{name}.py"))
        text = []
        for number, line in enumerate(lines, 1):
            mark = " [✓]{.checked}" if line.checked else ""
            text += [f"{number}. {line.text}{mark}", ""]
            for formula in line.formulas:
                text += ["   $$", f"   {formula}", "   $$", ""]
        block = nodes.container(classes=["derivation"], ids=[f"derivation-{name.replace('_', '-')}"])
        self.state.nested_parse(StringList(text, f"derivations/{name}.py"), 0, block)
        return [block]


def checked_lines(name: str):
    """Return the lines of a derivation after checking them.

    Raises:
        LineBroken: for a line that does not follow.
    """
    path = HERE / "derivations" / f"{name}.py"
    spec = spec_from_file_location(f"derivation_{name}", path)
    if spec is None or spec.loader is None or not path.is_file():
        raise ExtensionError(f"there is no derivation learn/derivations/{name}.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    lines = Lines()
    module.derive(lines)
    return lines.lines


class Setup(SphinxDirective):
    """Python that runs and is not shown: it gives names to the roles `n` of the document."""

    has_content = True

    def run(self):
        exec("\n".join(self.content), _names(self.env))
        return []


class Number(SphinxRole):
    """A number that is computed where it stands: {n}`expression | format`, the format as Python's, .3g if left out."""

    def run(self):
        expression, _, form = self.text.rpartition("|") if "|" in self.text else (self.text, "", ".3g")
        try:
            value = eval(expression.strip(), _names(self.env))
        except Exception as error:
            raise ExtensionError(f"{self.env.docname}: {{n}}`{self.text}` fails: {error}") from error
        if isinstance(value, str):
            return [nodes.Text(value)], []
        if not math.isfinite(value):
            raise ExtensionError(f"{self.env.docname}: {{n}}`{self.text}` is {value}")
        return [nodes.Text(_in_words(format(float(value), form.strip())))], []


def _in_words(text: str) -> str:
    mantissa, _, exponent = text.partition("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")) if exponent else ""
    return mantissa.replace("-", "−") + (f"·10{raised}" if raised else "")


def _names(env) -> dict[str, Any]:
    kept = env.temp_data.setdefault("course_names", {})
    if not kept:
        kept.update({name: getattr(math, name) for name in dir(math) if not name.startswith("_")}, np=np, ph=polhode)
    return kept


class CheckedProof(SphinxRole):
    """A theorem of proofs/, which must be there: {rocq}`euler_iff_hamilton`."""

    def run(self):
        name = self.text.strip()
        pattern = re.compile(rf"^\s*(Theorem|Lemma|Corollary|Proposition)\s+{re.escape(name)}\b", re.MULTILINE)
        for path in sorted(PROOFS.rglob("*.v")):
            if pattern.search(path.read_text("utf-8")):
                target = f"{SOURCE}/proofs/{path.relative_to(PROOFS).as_posix()}"
                return [nodes.reference("", "", nodes.literal("", name), refuri=target, classes=["rocq"])], []
        raise ExtensionError(f"{self.env.docname}: proofs/ holds no theorem {name!r}")


class Syllabus(SphinxDirective):
    """The table of the syllabus: each row with its sections, panels or figures, derivations and exercises."""

    def run(self):
        rows = tomllib.loads((HERE / "syllabus.toml").read_text("utf-8"))["row"]
        text = ["| # | topic | tier | where it is |", "|---|---|---|---|"]
        for row in rows:
            pages = ", ".join(f"[{_title(page)}]({page}.md)" for page in row["sections"])
            rest = (f"*{what}:* {', '.join(row[key]).replace('_', ' ')}" for what, key in SHOWN.items())
            text.append(f"| {row['number']} | {row['topic']} | {row['tier']} | {'<br>'.join([pages, *rest])} |")
        table = nodes.container()
        self.state.nested_parse(StringList(text, "syllabus.toml"), 0, table)
        return [table]


def _title(page: str) -> str:
    text = (HERE / f"{page}.md").read_text("utf-8")
    return re.search(r"^# (.*)$", text, re.MULTILINE)[1]


def write_beside(app, exception):
    """Panels and worksheets stand beside the pages."""
    if exception is not None or app.builder.format != "html":
        return
    out = Path(app.outdir)
    (out / "panels").mkdir(exist_ok=True)
    for page in (HERE / "panels").glob("*.html"):
        shutil.copy(page, out / "panels" / page.name)
    (out / "worksheets").mkdir(exist_ok=True)
    for name in chapter_names():
        for key in (False, True):
            sheet = out / "worksheets" / f"{name}{'-key' if key else ''}.html"
            sheet.write_text(worksheet(name, SEED, key=key), "utf-8")


def setup(app):
    app.add_directive("panel", Panel)
    app.add_directive("exercises", Exercises)
    app.add_directive("derivation", Derivation)
    app.add_directive("setup", Setup)
    app.add_directive("syllabus", Syllabus)
    app.add_role("n", Number())
    app.add_role("rocq", CheckedProof())
    app.connect("build-finished", write_beside)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
