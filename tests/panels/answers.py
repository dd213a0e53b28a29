"""What the panels of the course compute, asked from node."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "learn" / "panels" / "src"
NODE = shutil.which("node")


def asked(module: str, call: str, *args: Any, **more: Any) -> dict[str, Any]:
    return {"module": module, "call": call, "args": list(args), **more}


def ask(calls, sources=None):
    """Return the answers to calls in one process; infinite numbers are strings."""
    command = [NODE, Path(__file__).parent / "run_panels.mjs", (sources or SOURCES).as_uri()]
    done = subprocess.run(command, input=json.dumps(calls), text=True, capture_output=True, timeout=300, check=False)
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


def broken_sources(folder, file, right, wrong):
    """Return a copy of the panels' sources in which one formula is another."""
    there = folder / "learn" / "panels" / "src"
    for name, target in ((SOURCES, there), (ROOT / "reference", folder / "reference")):
        shutil.copytree(name, target, ignore=shutil.ignore_patterns("node_modules"))
    shutil.copy(ROOT / "reference" / "package.json", folder / "learn" / "package.json")
    path = there / "physics" / file
    text = path.read_text("utf-8")
    assert text.count(right) == 1, f"{file} has {text.count(right)} times {right}"
    path.write_text(text.replace(right, wrong), "utf-8")
    return there
