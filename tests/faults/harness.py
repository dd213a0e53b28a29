"""Commands struck by signals at chosen moments, and what must hold afterwards."""

import os
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

from polhode.formats import drafts

PATIENCE = 240  # s until a command counts as hanging; many may share a core
SPEC = """
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]
mass = "1 kg"
[spin]
rate = "60 rpm"
about = 2
tilt = "1 deg"
[time]
until = "3 s"
samples = 200
"""
FIGURES = ("momentum_sphere", "inertia_ellipsoid", "components", "herpolhode")
# what a command writes
COMMANDS = {
    ("report", "case.toml", "--html"): [*(f"case/{n}.png" for n in FIGURES), "case/motion.nc", "case/page.html"],
    ("view", "case.toml", "--no-open"): ["case.html"],
    ("compare", "case.toml", "other.toml", "--figures", "both"): ["both/comparison.png"],
    **{("export", "case.toml", "--to", form): [f"case.{ending}" for ending in endings.split()] for form, endings in {
        "csv": "csv", "netcdf": "nc", "zarr": "zarr", "aem": "aem", "ck": "bc tf tsc tls", "gltf": "glb",
        "urdf": "urdf",
    }.items()},
}  # fmt: skip
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}
DATED = re.compile(rb"CREATION_DATE = .*")


def start(command, folder, **more):
    """Start a command in a folder, apart from the terminal."""
    settings = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL} | more
    arguments = [sys.executable, "-m", "polhode.cli.main", *command]
    return subprocess.Popen(arguments, cwd=folder, start_new_session=True, preexec_fn=_heed_signals, **settings)


def _heed_signals():
    """Undo what `nohup` and a shell's background jobs leave to their children: signals that are ignored."""
    for number in CODES:
        signal.signal(number, signal.SIG_DFL)


def listens(process):
    """Whether a process has a handler for SIGTERM by now, as Linux tells."""
    status = Path(f"/proc/{process.pid}/status").read_text()
    caught = int(re.search(r"SigCgt:\s*(\w+)", status)[1], 16)
    return bool(caught >> (signal.SIGTERM - 1) & 1)


def strike(command, folder, number, moment):
    """Run a command and send a signal: so many seconds after it listens, or None for when it has begun to write.

    Returns:
        Exit code and standard error.
    """
    process = start(command, folder)
    try:
        begun = time.monotonic()
        while process.poll() is None and time.monotonic() - begun < PATIENCE and not listens(process):
            time.sleep(0.005)
        if moment is None:
            # a draft without ``new`` may yet be locked, and stays for a minute
            while process.poll() is None and time.monotonic() - begun < PATIENCE and not any(
                (draft / "new").is_dir() for draft in left(folder)
            ):
                time.sleep(0.002)
        else:
            time.sleep(moment)
        process.send_signal(number)
        err = process.communicate(timeout=PATIENCE)[1].decode()
    finally:
        process.kill()
        process.communicate()
    return process.returncode, err


def left(folder):
    """Return the drafts in a folder or in one of its folders."""
    return [*Path(folder).glob(f"{drafts.PREFIX}*"), *Path(folder).glob(f"*/{drafts.PREFIX}*")]


def contents(path):
    """Return the bytes of a file, or of all in a folder, without dates."""
    if path.is_dir():
        return {str(p.relative_to(path)): contents(p) for p in sorted(path.rglob("*")) if p.is_file()}
    return DATED.sub(b"", path.read_bytes())


def prepare(folder):
    """Make a folder with the specs."""
    folder.mkdir()
    (folder / "case.toml").write_text(SPEC, "utf-8")
    (folder / "other.toml").write_text(SPEC.replace("1 deg", "2 deg"), "utf-8")
    return folder


class Reference:
    """What a command writes when nothing happens, and how long it takes."""

    def __init__(self, command, folder):
        self.command = command
        begun = time.monotonic()
        done = start(command, prepare(folder))
        err = done.communicate(timeout=PATIENCE)[1]
        assert done.returncode == 0, err
        self.seconds = time.monotonic() - begun
        self.folder = folder
        self.after = {name: contents(folder / name) for name in COMMANDS[command]}

    def attack(self, folder, number, moment):
        """Strike the command among older files, and check what it leaves."""
        prepare(folder)
        older = self._older(folder)
        code, err = strike(self.command, folder, number, moment)
        told = f"{' '.join(self.command)}, {number.name} after {moment}: exit code {code}, {err!r}"
        assert "Traceback" not in err and "Exception ignored" not in err, told
        if number == signal.SIGKILL:
            assert code in (0, -number), told
        else:
            # Python itself may be ending: then the work is done, and the signal ends it without a word
            assert code in (0, CODES[number], -number), told
            if code == CODES[number]:
                assert err == f"polhode: stopped by {number.name}.\n", told
            assert not left(folder), told
        for place in {folder / name for name in ("", "case", "both")}:
            if place.is_dir():
                drafts.remove_abandoned(place)  # as the next command does that writes there
        assert not left(folder), told
        found = {name: contents(folder / name) for name in COMMANDS[self.command] if (folder / name).exists()}
        for name, old in older.items():
            assert found[name] in (old, self.after[name]), f"{told}: {name} is neither the older nor the newer"
        if code in (0, -number) and number != signal.SIGKILL:
            assert found == self.after, told
        return code

    def _older(self, folder):
        """Put files of an earlier run, whole ones but for a text at their end, where the command writes."""
        found = {}
        for name in COMMANDS[self.command]:
            source, place = self.folder / name, folder / name
            place.parent.mkdir(exist_ok=True)
            if source.is_dir():
                for path in source.rglob("*"):
                    target = place / path.relative_to(source)
                    target.parent.mkdir(parents=True, exist_ok=True)
                    if path.is_file():
                        target.write_bytes(path.read_bytes())
                (place / "older").write_bytes(b"older")
            else:
                place.write_bytes(source.read_bytes() + b"\n")
            found[name] = contents(place)
        return found


def moments(seed, count, seconds):
    """Return moments at random, a third of them None: in the midst of writing."""
    chance = random.Random(seed)
    return [None if k % 3 == 0 else chance.uniform(0.0, seconds) for k in range(count)]


def environment(**more):
    """Return the environment of a command with more in it."""
    return os.environ | more
