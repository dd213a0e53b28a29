"""The solvers of `reference/`, run in one process over many cases, and how far their answers are from polhode's."""

import json
import shutil
import struct
import subprocess
from pathlib import Path
from typing import NamedTuple

import numpy as np

import polhode as ph
from polhode import rotation

ROOT = Path(__file__).parents[2]
REFERENCE = ROOT / "reference"
HERE = Path(__file__).parent
NODE = shutil.which("node")
COMPILER = shutil.which("cc") or shutil.which("gcc")
RUSTC = shutil.which("rustc")
STRICT = ("-O2", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off")


class Given(NamedTuple):
    """What a motion is made of: moments, momentum, attitude, epoch, and mgl of a top."""

    moments: tuple[float, ...]
    momentum: tuple[float, ...]
    attitude: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0)
    epoch: float = 0.0
    mgl: float | None = None


class Errors(NamedTuple):
    """Between two answers: angle between attitudes [rad], and |L| relative to the largest there is."""

    attitude: np.ndarray
    momentum: np.ndarray

    @property
    def worst(self):
        return float(max(self.attitude.max(), self.momentum.max()))


def in_javascript(givens, times=(), numbers=(), along=0, module=REFERENCE / "polhode.js"):
    """Return the answers of polhode.js: {states (T, 7), numbers, along} or {refused}."""
    times = times if len(times) else [[] for _ in givens]
    cases = [
        {"kind": "free" if g.mgl is None else "top", "given": {k: v for k, v in g._asdict().items() if v is not None},
         "times": list(t), "numbers": list(numbers), "along": along}
        for g, t in zip(givens, times, strict=True)
    ]  # fmt: skip
    return run_javascript(cases, module)


def run_javascript(cases, module=REFERENCE / "polhode.js"):
    """Return what run_polhode.mjs answers to cases as it takes them."""
    done = subprocess.run([NODE, HERE / "run_polhode.mjs", module.as_uri()], input=json.dumps(cases), text=True,
                          capture_output=True, timeout=300, check=False)  # fmt: skip
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


def compiled(folder, options=("-std=c99", *STRICT), header=REFERENCE):
    """Return the program that answers cases by polhode.h."""
    program = folder / "run_polhode"
    command = [COMPILER, *options, "-I", header, HERE / "run_polhode.c", "-o", program, "-lm"]
    subprocess.run(command, check=True, timeout=300)
    return program


def compiled_rust(folder, crate=REFERENCE / "rust", options=("-O",)):
    """Return the program that answers cases by the crate, which rustc alone has compiled."""
    library, program = folder / "libpolhode.rlib", folder / "run_polhode_rs"
    strict = (RUSTC, "--edition", "2021", "-D", "warnings", *options)
    commands = [
        [*strict, "--crate-type", "rlib", "--crate-name", "polhode", crate / "src" / "lib.rs", "-o", library],
        [*strict, "--extern", f"polhode={library}", HERE / "run_polhode.rs", "-o", program],
    ]
    for command in commands:
        subprocess.run(command, check=True, timeout=300)
    return program


class Listed(NamedTuple):
    """What a compiled program answers to N cases, with the error codes of the motions (N,) and of the times (N, T)."""

    states: np.ndarray  # (N, T, 7)
    of_motion: np.ndarray
    of_times: np.ndarray
    regimes: np.ndarray
    numbers: np.ndarray  # (N, 8), as the programs list them


def in_c(program, givens, times):
    """Return the answers of polhode.h."""
    return _listed(program, givens, times, float.hex, float.fromhex)


def in_rust(program, givens, times):
    """Return the answers of the crate."""
    bits = lambda x: struct.pack(">d", x).hex()  # noqa: E731
    return _listed(program, givens, times, bits, lambda text: struct.unpack(">d", bytes.fromhex(text))[0])


def _listed(program, givens, times, written, read):
    lines = []
    for g, t in zip(givens, times, strict=True):
        numbers = (*g.moments, *g.momentum, *g.attitude, g.epoch, g.mgl or 0.0, *t)
        lines.append(f"{int(g.mgl is not None)} {len(t)} " + " ".join(written(float(x)) for x in numbers))
    done = subprocess.run([program], input="\n".join(lines), text=True, capture_output=True, timeout=300, check=True)
    rows = [line.split() for line in done.stdout.splitlines()]
    codes = np.array([row[:2] for row in rows], int)
    values = np.array([[read(x) for x in row[2:]] for row in rows])
    states = values[:, 8:].reshape(len(givens), -1, 8)
    return Listed(states[..., 1:], codes[:, 0], states[..., 0].astype(int), codes[:, 1], values[:, :8])


def together(givens):
    """Return the motions (N,) of cases of one kind as one."""
    moments, momentum, attitude, epoch = (np.array([g[k] for g in givens]) for k in range(4))
    if givens[0].mgl is None:
        return ph.FreeMotion(moments, momentum=momentum, attitude=attitude, epoch=epoch)
    return ph.LagrangeMotion(
        moments, mgl=np.array([g.mgl for g in givens]), momentum=momentum, attitude=attitude, epoch=epoch
    )


def by_polhode(givens, times):
    """Return the states (N, T, 7) by FreeMotion or LagrangeMotion at times (N, T)."""
    motion = together(givens)
    return np.stack([np.concatenate(motion.state(t), axis=-1) for t in np.transpose(times)], axis=1)


def errors(found, wanted, givens):
    """Return the errors (N, T) of states (N, T, 7); a quaternion of the other sign counts as a whole turn."""
    relative = rotation.multiply(rotation.conjugate(wanted[..., :4]), found[..., :4])
    angle = 2.0 * np.arctan2(np.linalg.norm(relative[..., 1:], axis=-1), relative[..., 0])
    scale = np.array([size(g) for g in givens])[:, None]
    momentum = np.linalg.norm((found[..., 4:] - wanted[..., 4:]) / scale[..., None], axis=-1)
    return Errors(np.where(np.isnan(angle), np.inf, angle), np.where(np.isnan(momentum), np.inf, momentum))


def size(given):
    """Return the size of a motion's momentum: |L|, of a top also √(mgl I1)."""
    largest = np.abs(given.momentum).max() or 1.0
    norm = largest * float(np.linalg.norm(np.array(given.momentum) / largest))
    if given.mgl is not None:
        norm = max(norm, np.sqrt(abs(given.mgl)) * np.sqrt(given.moments[0]))
    return norm or 1.0
