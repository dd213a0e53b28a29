"""``polhode learn``: opens the course, or writes a worksheet or its key."""

from __future__ import annotations

from pathlib import Path

import typer

from polhode.cli.terminal import open_in_browser
from polhode.course.exercises import chapter_names, choose_chapter
from polhode.course.site import built_course, page_of_chapter
from polhode.course.worksheets import worksheet
from polhode.errors import InvalidInput, one_line, shown
from polhode.formats.paths import write_whole


def run_learn(
    chapter: str | None, sheet: bool, key: bool, seed: int | None, out: Path | None, source: Path | None, open_it: bool
) -> None:
    """Open a page of the course, or write the worksheet or key of a chapter, or both."""
    if sheet or key:
        if source is not None:
            raise InvalidInput(f"--from names a built course to open; got {shown(str(source))} with a worksheet, which "
                               "needs none. Leave it out.")
        if sheet and key and out is not None:
            raise InvalidInput("--out names one file; with --worksheet and --key two are written. Leave it out, or "
                               "write one at a time.")
        for one in [False] * sheet + [True] * key:
            _write_sheet(chapter, one, seed or 0, out)
        return
    if seed is not None or out is not None:
        raise InvalidInput("--seed and --out are of a worksheet. Add --worksheet or --key.")
    front = built_course(source)
    page = front if chapter is None else page_of_chapter(front, chapter)
    typer.echo(one_line(str(page)))
    if open_it:
        open_in_browser(page)


def _write_sheet(chapter: str | None, key: bool, seed: int, out: Path | None) -> None:
    if chapter is None:
        raise InvalidInput(f"a worksheet is of a chapter: name one of {', '.join(chapter_names())}.")
    chapter = choose_chapter(chapter_names(), chapter)
    target = out or Path(f"{chapter}{'-key' if key else ''}.html")
    if target.suffix.lower() not in (".html", ".htm"):
        raise InvalidInput(f"--out must end with .html, as a worksheet is a page; got {shown(str(target))}.")
    text = worksheet(chapter, seed, key=key)
    with write_whole(target) as draft:
        draft.write_text(text, "utf-8")
    typer.echo(one_line(str(target)))
