"""What Windows and macOS need, as far as Linux can tell: names of files, and code without what they lack."""

import ast
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import lacking
import polhode as ph
from polhode._base.compiled.threads import available_cores, in_threads
from polhode.errors import InvalidInput
from polhode.kinds.registry import known_figures
from polhode.sweeps.running import _deaf_to_interrupts
from polhode.testing.kinds import FILE_NAME

ROOT = Path(__file__).parents[1]
LONGEST = 150  # characters of a path, below a folder of 100 as people have; Windows ends at 260
RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
FORBIDDEN = re.compile(r'[<>:"|?*\\\x00-\x1f]|[. ]$')
ON_POSIX_ALONE = {
    "os": {"fork", "forkpty", "getuid", "geteuid", "getgid", "getpgid", "killpg", "setsid", "setpgid", "mkfifo",
           "mknod", "uname", "chown", "nice", "sched_getaffinity", "sched_setaffinity", "sysconf", "statvfs",
           "wait3", "wait4", "O_NONBLOCK", "O_NOCTTY", "O_NOFOLLOW", "O_DIRECTORY", "O_CLOEXEC"},
    "signal": {"SIGHUP", "SIGKILL", "SIGALRM", "SIGUSR1", "SIGUSR2", "SIGCHLD", "SIGPIPE", "SIGSTOP", "SIGCONT",
               "alarm", "setitimer", "pthread_sigmask", "pthread_kill", "sigwait"},
}  # fmt: skip
MODULES_ON_POSIX_ALONE = {"fcntl", "resource", "termios", "tty", "pty", "pwd", "grp", "posix", "syslog"}


def packed_files():
    """Files under version control, or of an unpacked source archive."""
    if (ROOT / ".git").exists():
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True)
        return listed.stdout.decode().strip("\0").split("\0")
    return [path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*")
            if path.is_file() and not {"__pycache__", ".venv", ".pytest_cache"} & set(path.parts)]  # fmt: skip


def test_no_two_files_differ_by_case_alone():
    every = {part.as_posix() for name in packed_files() for part in (Path(name), *Path(name).parents)}
    assert len(every) > 100
    assert len({name.casefold() for name in every}) == len(every)


def test_files_have_names_that_every_system_takes():
    for name in packed_files():
        assert len(name) <= LONGEST, name
        for part in Path(name).parts:
            assert not FORBIDDEN.search(part) and not RESERVED.fullmatch(part), name


def test_what_reports_write_has_such_names():
    for name in known_figures():
        assert FILE_NAME.fullmatch(name) and not FORBIDDEN.search(name) and not RESERVED.fullmatch(name)
    for name in ("aux", "Momentum", "a:b", "con"):
        assert not FILE_NAME.fullmatch(name)


def test_a_report_is_not_written_over_its_input_by_another_name_of_it(tmp_path):
    """A second name of the file stands for LEVELS.NC and levels.nc, which some systems take for one."""
    shutil.copy(ROOT / "examples" / "water.xyz", tmp_path / "water.xyz")
    report = ph.levels(tmp_path / "water.xyz", j_max=1)
    os.link(tmp_path / "water.xyz", tmp_path / "levels.nc")
    with pytest.raises(InvalidInput, match=r"would destroy it\. Name another folder"):
        report.write(tmp_path)
    assert (tmp_path / "water.xyz").read_bytes() == (ROOT / "examples" / "water.xyz").read_bytes()


def lacking_on_windows(tree):
    """Yield what a module uses of ``os`` and ``signal``, and which modules it imports, that are not on Windows."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            if node.attr in ON_POSIX_ALONE.get(node.value.id, ()):
                yield f'hasattr({node.value.id}, "{node.attr}")'
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        yield from sorted(MODULES_ON_POSIX_ALONE.intersection(names))


@pytest.mark.long
def test_sources_ask_before_they_use_what_windows_lacks():
    assert list(lacking_on_windows(ast.parse("import fcntl\nos.fork()"))) == ["fcntl", 'hasattr(os, "fork")']
    for path in sorted((ROOT / "src").rglob("*.py")):
        text = path.read_text("utf-8")
        unasked = [asked for asked in lacking_on_windows(ast.parse(text)) if "(" not in asked or asked not in text]
        assert not unasked, f"{path.name}: {unasked}"


def a_test_of_pipes(path):
    os.mkfifo(path)


def test_tests_that_need_what_a_system_lacks_are_skipped_there():
    assert lacking.missing(a_test_of_pipes, {"mkfifo": False, "/dev/": False}) == ["mkfifo"]
    assert lacking.missing(lambda path: a_test_of_pipes(path), {"mkfifo": False}) == ["mkfifo"]
    assert lacking.missing(a_test_of_pipes, {"mkfifo": True}) == []


def test_cores_are_counted_where_nobody_tells_which_may_be_used(monkeypatch):
    monkeypatch.delattr(os, "sched_getaffinity", raising=False)
    monkeypatch.setattr(os, "cpu_count", lambda: 3)
    parts = []
    in_threads(lambda low, high: parts.append((low, high)), 9, 2)
    assert available_cores() == 3 and sorted(parts) == [(0, 3), (3, 6), (6, 9)]


def test_workers_start_where_signals_cannot_be_masked(monkeypatch):
    monkeypatch.delattr(signal, "pthread_sigmask", raising=False)
    with _deaf_to_interrupts():
        pass


LIKE_WINDOWS = """
import os, signal, sys
import filelock, h5netcdf, matplotlib.pyplot, numba, platformdirs, psutil, scipy  # which ask for the real system's
LACKING, COMMANDS = eval(sys.argv[1])
for module, names in LACKING.items():
    for name in names - {"O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC"}:  # which filelock reads at every lock
        sys.modules[module].__dict__.pop(name, None)
from polhode.formats import drafts
drafts.WINDOWS = True
from polhode.cli import main
for command in COMMANDS:
    try:
        main.main(command)
    except SystemExit as end:
        assert end.code in (0, None), (command, end.code)
"""


@pytest.mark.sweep
def test_commands_work_without_what_windows_lacks(tmp_path):
    commands = [["new", "t_handle"], ["report", "t_handle.toml", "--html"], ["export", "t_handle.toml", "--to", "aem"],
                ["import", "t_handle.aem"], ["compare", "t_handle.toml", "t_handle.aem"]]  # fmt: skip
    program = [sys.executable, "-c", LIKE_WINDOWS, repr((ON_POSIX_ALONE, commands))]
    ran = subprocess.run(program, cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
    assert ran.returncode == 0, ran.stderr
    assert {"motion.nc", "momentum_sphere.png"} <= {path.name for path in (tmp_path / "t_handle").iterdir()}
