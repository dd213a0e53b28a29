"""Where the built course is: in the package, or where the documentation has been built."""

from __future__ import annotations

from pathlib import Path

from polhode.course.exercises import chapters_of_files, choose_chapter
from polhode.errors import InvalidInput, shown

SITE = Path(__file__).parent / "site"


def built_course(folder: str | Path | None = None) -> Path:
    """Return the first page of the course.

    Args:
        folder: a built course or built documentation; the course that came with the package if left out.

    Raises:
        InvalidInput: where there is none.
    """
    if folder is None:
        if (SITE / "index.html").is_file():
            return SITE / "index.html"
        raise InvalidInput(
            "this installation of polhode has no built course. In a checkout with the extras docs and symbolic, "
            "`python -m sphinx learn out/learn` builds it, and `polhode learn --from out/learn` opens it."
        )
    for page in (Path(folder) / "learn" / "index.html", Path(folder) / "index.html"):
        if page.is_file() and (page.parent / "panels").is_dir():
            return page
    raise InvalidInput(f"`folder` must be the folder of a built course or of the built documentation; got "
                       f"{shown(str(folder))}, which holds no course.")  # fmt: skip


def page_of_chapter(front: Path, chapter: str) -> Path:
    """Return the page of a chapter.

    Args:
        front: the first page of the course.
        chapter: its name, such as "two-surfaces", or its number.

    Raises:
        InvalidInput: for a chapter that the course does not hold.
    """
    pages = chapters_of_files((front.parent / "chapters").glob("*.html"))
    return pages[choose_chapter(pages, chapter)]
