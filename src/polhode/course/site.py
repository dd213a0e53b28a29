"""Where the built course is: in the package, in a checkout that builds it, or where the documentation was built."""

from __future__ import annotations

from pathlib import Path

from polhode.course.building import build_course
from polhode.course.exercises import chapters_of_files, choose_chapter
from polhode.errors import InvalidInput, shown

SITE = Path(__file__).parent / "site"
CHECKOUT = Path(__file__).parents[3]  # above src


def built_course(folder: str | Path | None = None) -> Path:
    """Return the first page of the course.

    Args:
        folder: a built course or built documentation. Left out, the course that came with the package; a checkout
            has only its sources, and builds it.

    Raises:
        InvalidInput: where there is none, or a checkout cannot build it.
    """
    if folder is None:
        if (SITE / "index.html").is_file():
            return SITE / "index.html"
        if (CHECKOUT / "learn" / "conf.py").is_file() and (CHECKOUT / "pyproject.toml").is_file():
            return build_course(CHECKOUT)
        raise InvalidInput(
            "this installation of polhode has no built course, which comes with releases. Install one, or give the "
            "folder of a built course as `folder`."
        )
    for page in (Path(folder) / "learn" / "index.html", Path(folder) / "index.html"):
        if page.is_file() and (page.parent / "panels").is_dir():
            return page
    raise InvalidInput(f"`folder` must be the folder of a built course or of the built documentation; got "
                       f"{shown(str(folder))}, which holds no course.")


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
