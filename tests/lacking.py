"""What tests need that not every system has; they are left out there, by what their source names."""

import inspect
import os
import re
import socket
import sys
from pathlib import Path

LINUX, WINDOWS = sys.platform.startswith("linux"), sys.platform == "win32"
THERE = {
    "/proc/": LINUX,
    "/dev/full": Path("/dev/full").exists(),
    "/dev/": not WINDOWS,
    "mkfifo": hasattr(os, "mkfifo"),
    "AF_UNIX": hasattr(socket, "AF_UNIX"),
    "symlink_to": not WINDOWS,  # only administrators may make links there
    "device": not WINDOWS,
    "with limited(": not WINDOWS,  # sizes of files
    "SIGKILL": not WINDOWS,
    "SIGHUP": not WINDOWS,
    "start_new_session": not WINDOWS,
}
"""Words of a test's source → whether this system has what they stand for."""

# modules that cannot be imported there: they set limits, send signals or read /proc throughout
NOT_THERE = [
    *(() if LINUX else ("cli/test_ends.py", "spec/test_ends.py")),
    *(() if not WINDOWS else ("faults", "cli/test_stopping.py", "formats/test_full_disk.py", "formats/test_opening.py",
                              "formats/test_reader_fuzz.py", "spec/test_fuzz.py", "sweeps/test_damaged_stores.py")),
]  # fmt: skip


def missing(function, there=None):
    """Return the words for what is missing in a test's source, and in what it names of its module."""
    lacking = [word for word, has in (THERE if there is None else there).items() if not has]
    if not lacking:
        return []
    text = inspect.getsource(function)
    for name in set(re.findall(r"\w+", text)):
        helper = inspect.unwrap(getattr(function, "__globals__", {}).get(name))  # fixtures too
        if inspect.isfunction(helper) and helper.__module__ == function.__module__:
            text += inspect.getsource(helper)
    return [word for word in lacking if word in text]
