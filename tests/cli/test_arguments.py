"""Options with values that they cannot have: exit code 2 and one message, and nothing written."""

import os
import subprocess
import sys

import pytest

from cli.specs import SPEC
from polhode.cli.main import main

WAIT = 120  # s, of a command in a process of its own
HUGE = "9" * 400


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(SPEC)
    os.mkfifo(tmp_path / "pipe")
    return tmp_path


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["report", ""], "an argument is empty"),
        (["report", "case.toml", "--out", ""], "an argument is empty"),
        (["report", "case.toml", "--out="], "an argument is empty"),
        (["report", "case.toml", "--out", "a\0b"], "NUL"),
        (["body", "a\0b"], "NUL"),
        (["report", "case.toml", "--out", "a", "--out", "b"], "--out is given 2 times"),
        (["body", "case.toml", "--json", "--json"], "--json is given 2 times"),
        (["view", "case.toml", "--out", "a.html", "--no-open", "--out=b.html"], "--out is given 2 times"),
        (["report", "case.toml", "--figure-format", "png,gif"], "--figure-format"),
        (["report", "case.toml", "--figure-format", ","], "--figure-format"),
        (["report", "case.toml", "--figure-format", "x" * 10**5], "--figure-format"),
        (["report", "case.toml", "--out", "a" * 9999], "Choose another folder"),
        (["report", "case.toml", "--out", "pipe"], "is a file, where a folder is needed"),
        (["export", "case.toml", "--to", "csv", "--out", "pipe"], "pipe"),
        (["export", "case.toml", "--to", "csv", "--out", "a" * 9999], "be read or written"),
        (["export", "case.toml", "--to", "csv", "--out", "."], "folder"),
        (["export", "case.toml", "--to", "CSV "], "Did you mean csv"),
        (["export", "case.toml", "--to", HUGE * 300], "--to"),
        (["export", "case.toml"], "--to"),
        (["export", "pipe", "--to", "csv"], "is a pipe"),
        (["body", "pipe"], "is a pipe"),
        (["compare", "pipe", "case.toml"], "is a pipe"),
        (["compare", "case.toml", "case.toml", "--spec", "pipe"], "is a pipe"),
        (["import", "pipe"], "is a pipe"),
        (["import", "/dev/zero"], "is a device"),
        (["import", "case.toml", "--spice-id", HUGE], "--spice-id"),
        (["import", "case.toml", "--spice-id", "2_5"], "--spice-id"),
        (["body", "case.toml", "more"], "more"),
        (["nothing"], "nothing"),
    ],
    ids=lambda value: " ".join(value)[:40].replace("\0", "0") if isinstance(value, list) else "",
)
def test_hostile_arguments(folder, capfd, arguments, words):
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    out, err = capfd.readouterr()
    assert stopped.value.code == 2 and out == "" and words in err and "Traceback" not in err
    assert len(err) < 2500  # a frame of spaces around some
    assert sorted(path.name for path in folder.iterdir()) == ["case.toml", "pipe"]


@pytest.mark.long_cases("body case.toml-2>&-", "body case.toml-<&-", "body none.toml-2>&-")
@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&-", ">&- 2>&- <&-"])
@pytest.mark.parametrize("arguments", ["body case.toml", "body none.toml"])
def test_streams_that_are_closed(folder, arguments, closed):
    command = f'"{sys.executable}" -m polhode.cli.main {arguments} {closed}'
    done = subprocess.run(["sh", "-c", command], capture_output=True, timeout=WAIT, check=False)
    assert done.returncode in ((2,) if "none" in arguments else (0, 2))
    assert b"Traceback" not in done.stderr + done.stdout and b"Exception" not in done.stderr
