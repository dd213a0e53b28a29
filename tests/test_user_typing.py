"""Type checkers know the types of what users call, and find their mistakes."""

import json
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

import polhode

HERE = Path(__file__).parent
SCRIPT, MISTAKES = HERE / "typing" / "user_script.py", HERE / "typing" / "user_mistakes.py"


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """What pyright says of both files in strict mode: line and words of each error, by the file's name."""
    if find_spec("pyright") is None:
        pytest.skip("pyright is not installed; it is in the extra `check`")
    project = tmp_path_factory.mktemp("project")  # a folder of its own, as a user has
    for file in (SCRIPT, MISTAKES):
        (project / file.name).write_text(file.read_text("utf-8"), "utf-8")
    source = str(Path(polhode.__file__).parents[1])
    settings = {"typeCheckingMode": "strict", "pythonVersion": "3.11", "extraPaths": [source]}
    (project / "pyrightconfig.json").write_text(json.dumps(settings), "utf-8")
    command = [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable, "-p", str(project)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
    found = json.loads(done.stdout)
    assert found["summary"]["filesAnalyzed"] == 2
    errors: dict[str, list[tuple[int, str]]] = {SCRIPT.name: [], MISTAKES.name: []}
    for one in found["generalDiagnostics"]:
        errors[Path(one["file"]).name].append((one["range"]["start"]["line"] + 1, one["message"]))
    return errors


@pytest.mark.timeout(1000)
def test_types_are_known(told):
    assert not told[SCRIPT.name]


@pytest.mark.timeout(1000)
def test_mistakes_are_found(told):
    lines = MISTAKES.read_text("utf-8").splitlines()
    wrong = {number for number, line in enumerate(lines, 1) if "# wrong" in line}
    assert len(wrong) > 9 and {number for number, _ in told[MISTAKES.name]} == wrong
