"""The command for machines with a GPU: without one it says so; on the processor it keeps the bound."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "gpu.py"


def run(*arguments):
    return subprocess.run([sys.executable, str(SCRIPT), *arguments], capture_output=True, text=True, timeout=600)


@pytest.mark.sweep
def test_it_skips_with_a_reason_or_keeps_the_bound():
    found = run("--quick")
    assert found.returncode == 0, found.stdout + found.stderr
    assert "skipped: JAX sees no GPU here" in found.stdout or "worst in eps" in found.stdout


@pytest.mark.sweep
def test_compiled_forms_keep_the_bound_on_the_processor():
    found = run("--cpu", "--quick")
    assert found.returncode == 0, found.stdout + found.stderr
    for kind in ("free body", "Lagrange top"):
        errors = re.search(rf"{kind}: \d+ motions, worst in eps: attitude ([\d.]+), at long times ([\d.]+), "
                           r"momentum ([\d.]+)", found.stdout)  # fmt: skip
        assert errors and max(map(float, errors.groups())) <= 16.0, found.stdout
