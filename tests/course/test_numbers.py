"""Numbers in the course's prose are computed where they stand, or have a source; the syllabus leads somewhere."""

import re
import tomllib
from pathlib import Path

import pytest

from polhode.course.exercises import chapter_names, read_chapter

COURSE = Path(__file__).parents[2] / "learn"
CHAPTERS = sorted((COURSE / "chapters").glob("*.md"))
TEXTS = [path for path in CHAPTERS if path.stem != "15_history"]  # whose numbers are years and pages
MEASURED = tomllib.loads((COURSE / "measured.toml").read_text("utf-8"))
# code, formulas, roles and links hold numbers of their own, which are computed, checked or names
HELD = re.compile(
    r"^(`{3,}|:{3,})\{setup\}[\s\S]*?^\1\s*$|\$\$[\s\S]*?\$\$|\$[^$\n]+\$|\{n\}`[^`]*`|`[^`\n]*`|\]\([^)\s]*\)"
    r"|<[/a-zA-Z][^>\n]*>|^#.*$|^:(?:state|height|sync|sync-group):.*$|^\(.*\)=$", re.MULTILINE)  # fmt: skip
NUMBER = re.compile(r"(?<![\w.,])\d+(?:[.,]\d+)*(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")
YEAR = re.compile(r"1[5-9]\d\d|20[0-2]\d")


CODE = re.compile(r"\{setup\}[\s\S]*?^(?:`{3,}|:{3,})\s*$|\{n\}`[^`]*`", re.MULTILINE)
CITED = re.compile(
    r"\d+\s+\(\d{4}\)(?:,?\s+\d+)?|arXiv\s\d+\.\d+|\*Nature\*\s+\d+,\s+\d+|\*Treatise[^*]*\*\s3\.09"
)


def numbers_of(text):
    """Return the numbers of a text that it must account for: with decimals or more than two digits.

    Years and volumes of journals are none, nor is what the code of the same text computes with, in whatever unit: the
    data of an example.
    """
    given = {_digits(number) for number in NUMBER.findall(" ".join(CODE.findall(text)))}
    plain = CITED.sub(" ", HELD.sub(" ", text))
    return {number for number in NUMBER.findall(plain)
            if ("." in number or len(number.replace(",", "")) > 2) and not YEAR.fullmatch(number)
            and _digits(number) not in given}  # fmt: skip


def _digits(number):
    """Return the digits of a number that count, whatever its power of ten."""
    return re.sub(r"\D", "", number.partition("·")[0]).strip("0")


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.stem)
def test_numbers_are_computed_or_have_a_source(path):
    said = MEASURED.get(path.stem, {})
    assert numbers_of(path.read_text("utf-8")) - set(said) == set()
    assert set(said) <= numbers_of(path.read_text("utf-8")), "a source of a number that stands nowhere"
    assert all(len(source) > 8 for source in said.values())


def test_a_number_without_a_source_is_seen():
    text = (
        "# 5.25 heads\nIt takes 20.2 s, {n}`20.3 | .3g` s, $20.4$, in 1834, of 3 kg, 20.5.\n"
        "```{setup}\nx = 20.5\n```\n"
    )
    assert numbers_of(text) == {"20.2"}


def test_rows_of_the_syllabus_lead_to_what_is_there():
    rows = tomllib.loads((COURSE / "syllabus.toml").read_text("utf-8"))["row"]
    assert [row["number"] for row in rows] == list(range(1, 27))
    text = {path.stem: path.read_text("utf-8") for path in CHAPTERS}
    chapters = [read_chapter(name) for name in chapter_names()]
    names = {one.name for chapter in chapters for one in (*chapter.exercises, *chapter.choices)}
    for row in rows:
        assert row["sections"] and row["panels"] and row["derivations"] and row["exercises"], row["number"]
        pages = [section.removeprefix("chapters/") for section in row["sections"]]
        assert set(pages) <= set(text), row["number"]
        assert all((COURSE / "panels" / f"{panel}.html").is_file() for panel in row["panels"]), row["number"]
        assert set(row["exercises"]) <= names, (row["number"], set(row["exercises"]) - names)


def test_every_exercise_panel_and_derivation_is_shown():
    text = "".join(path.read_text("utf-8") for path in CHAPTERS)
    shown = set(" ".join(re.findall(r"\{exercises\} (.*)", text)).split())
    for name in chapter_names():
        chapter = read_chapter(name)
        assert {one.name for one in (*chapter.exercises, *chapter.choices)} <= shown, name
    for folder, ending, directive in (("panels", "html", "panel"), ("derivations", "py", "derivation")):
        there = {path.stem for path in (COURSE / folder).glob(f"*.{ending}")}
        assert there == set(re.findall(rf"\{{{directive}\}} (\S+)", text)), folder
