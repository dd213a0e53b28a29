"""Running code that might never end in a process of its own, so that a hang is a failure and not a stuck suite.

It is compiled as for a user: what XLA's optimization makes endless must end.
"""

import os
import subprocess
import sys
import textwrap

import pytest


def run_limited(code: str, seconds: float) -> str:
    """Return what the Python code prints; fail the test if it does not end in time, or fails."""
    try:
        done = subprocess.run(
            [sys.executable, "-c", textwrap.dedent(code)], env=os.environ | {"XLA_FLAGS": ""}, capture_output=True,
            text=True, timeout=seconds, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired as late:
        printed = late.stdout.decode() if isinstance(late.stdout, bytes) else late.stdout or ""
        pytest.fail(f"did not end within {seconds:g} s; printed so far: {printed[-500:]!r}")
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout
