"""The course, built once; by a step of CI before this one where POLHODE_COURSE names the folder."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

COURSE = Path(__file__).parents[2] / "learn"


@pytest.fixture(scope="session")
def course(tmp_path_factory):
    """The folder of the built course; Sphinx's warnings are errors."""
    if built := os.environ.get("POLHODE_COURSE"):
        return Path(built)
    pytest.importorskip("sphinx_proof", reason="needs the extra docs")
    out = tmp_path_factory.mktemp("course")
    subprocess.run([sys.executable, "-m", "sphinx", "-W", "-q", str(COURSE), str(out)], check=True)
    return out
