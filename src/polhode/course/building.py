"""Builds the course of a checkout by Sphinx, as a release does before it makes its archives."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from polhode._base.extras import is_there, not_installed
from polhode.errors import InvalidInput, one_line

NEEDED = "sphinx", "furo", "latex2mathml", "myst_nb", "sphinx_design", "sphinx_proof"  # by ``learn/conf.py``


def build_course(checkout: Path) -> Path:
    """Return the first page of the course of a checkout, built if it was not since its sources were changed.

    Args:
        checkout: the folder with ``learn``; the course is built into ``build/learn``, which Git ignores.

    Raises:
        InvalidInput: where Sphinx or a part of it is missing, or does not build the course.
    """
    sources, built = checkout / "learn", checkout / "build" / "learn"
    front = built / "index.html"
    if front.is_file() and front.stat().st_mtime >= _last_change(sources, Path(__file__).parent):
        return front
    for module in NEEDED:
        if not is_there(module):
            raise not_installed("the course is not built yet in this checkout; to build it, polhode needs", module)
    print("polhode: building the course, which takes some minutes …", file=sys.stderr, flush=True)
    built.parent.mkdir(exist_ok=True)
    draft = Path(tempfile.mkdtemp(prefix=".learn-", dir=built.parent))
    try:
        command = [sys.executable, "-m", "sphinx", "-q", "-d", str(draft / "trees"), str(sources), str(draft / "learn")]
        done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", errors="replace")
        if done.returncode != 0:
            raise InvalidInput(f"Sphinx cannot build {one_line(str(sources))}: {_reason(done.stderr)}. Mend it, or "
                               "give the folder of a built course as `folder`.")
        shutil.rmtree(built, ignore_errors=True)
        (draft / "learn").rename(built)
    finally:
        shutil.rmtree(draft, ignore_errors=True)
    return front


def _last_change(*folders: Path) -> float:
    """Return when the newest file below the folders was written; compiled Python does not count."""
    files = (path for folder in folders for path in folder.rglob("*") if "__pycache__" not in path.parts)
    return max(path.stat().st_mtime for path in files if path.is_file())


def _reason(text: str) -> str:
    """Return the last line that names an error; behind it Sphinx asks for reports of it."""
    lines = [line.strip().rstrip(".") for line in text.splitlines() if line.strip()]
    named = [line for line in lines if re.search(r"(rror|xception)\b.*: \S", line)]
    return one_line((named or lines or ["it does not say why"])[-1])
