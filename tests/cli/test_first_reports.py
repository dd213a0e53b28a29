"""What the first report on an example takes: how many programs XLA compiles, as most take longer than what they do."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
SLOW = pytest.mark.sweep
MOST = {"jupiter_cyclones": 26, "sphere_turbulence": 32, "euler_disk": 48}
"""Programs that a report compiles and keeps; once 49, 103 and 86, each operation by itself."""


@pytest.mark.parametrize("example", [
    pytest.param("jupiter_cyclones", marks=pytest.mark.long),
    pytest.param("sphere_turbulence", marks=SLOW),
    pytest.param("euler_disk", marks=SLOW),
])
def test_few_programs_are_compiled(example, tmp_path):
    kept = tmp_path / "programs"
    known = {**os.environ, "POLHODE_REPORTS_CACHE": "", "POLHODE_COMPILED_CACHE": str(kept)}
    command = [sys.executable, "-m", "polhode", "report", str(EXAMPLES / f"{example}.toml"), "--out", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, env=known, timeout=600)
    assert done.returncode == 0, done.stderr
    names = [path.name for path in kept.iterdir()]
    assert 0 < len(names) <= MOST[example], sorted(names)
