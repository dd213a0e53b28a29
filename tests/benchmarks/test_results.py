"""The benchmarks run at tiny sizes, with plausible numbers; what is written down is of all of them."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

HOME = Path(__file__).parents[2] / "benchmarks"
MEASURES = sorted(path.stem for path in (HOME / "measures").glob("*.py"))
ROW = re.compile(r"^\| (?!work|-)([^|]+)\| ([^|]+)\|" + 5 * r" ([^|]*)\|" + r"(?:[^|]*\|)*$", re.MULTILINE)
EXACT, LARGEST, COARSE = 1e-14, 2e-2, 1.0
"""Errors of closed forms, of anything (a million steps of .01 at order 2: 7e-3), and of coarse steps of a fluid."""


def check(text, names):
    for name in names:
        part = text.split(f"`measures/{name}.py`")[1].split("\n## ")[0]
        rows = [[cell.strip() for cell in row] for row in ROW.findall(part)]
        assert rows, name
        for work, peer, ours, theirs, ratio, spread, note in rows:
            assert work and peer and (ratio or note)
            if ratio:
                value = float(ratio.replace(",", ""))
                low, high = (float(x.replace(",", "")) for x in spread.split(" to "))
                assert 0.0 < low <= value <= high < 1e9
            most = COARSE if peer.startswith("IsospectralMidpoint") else LARGEST
            assert 0.0 <= float(ours or 0.0) < LARGEST and 0.0 <= float(theirs or 0.0) < most
            if ours and name == "attitude_at_a_time":
                assert float(ours) < EXACT and (not theirs or float(theirs) > float(ours))


def test_all_are_written_down():
    text = (HOME / "RESULTS.md").read_text("utf-8")
    check(text, MEASURES)
    for name in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text):
        assert (HOME / name).stat().st_size > 1000
    assert "/home" not in text and "/work" not in text and "/tmp" not in text


@pytest.mark.sweep
@pytest.mark.parametrize("name", MEASURES)
def test_each_runs_at_tiny_sizes(name):
    command = [sys.executable, str(HOME / "run.py"), "--quick", "--only", name]
    found = subprocess.run(command, capture_output=True, text=True, timeout=600)
    assert found.returncode == 0, found.stderr[-2000:]
    check(found.stdout, [name])


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["its value, jitted", "its value, jitted ", "simulate it", "heavy top"])
def test_first_calls_are_calls(name, monkeypatch):
    """They are texts, which no rename of an argument reaches."""
    monkeypatch.syspath_prepend(str(HOME))
    import first_calls

    if name in first_calls.SYSTEMS:
        code, before = first_calls.SIMULATED, first_calls.FIRST.format(*first_calls.SYSTEMS[name])
    else:
        code, before = first_calls.CALLS.get(name, first_calls.ENGINE.get(name))[0], first_calls.SYSTEM
    assert first_calls.seconds(code, "host", 1, before) > 0.0
