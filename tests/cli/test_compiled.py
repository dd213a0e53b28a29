"""What the command compiles is kept for its next run, and nothing else changes by it."""

import os
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import platformdirs
import pytest

from polhode.cli import compiled
from polhode.cli import main as entry

PROGRAM = """
import os
from polhode.cli.compiled import keep_compiled
keep_compiled()
import jax, diffrax, polhode.algebra
rates = diffrax.ODETerm(lambda t, y, args: -y)
times = diffrax.SaveAt(ts=jax.numpy.array([0.5, 1.0]))
solve = jax.jit(lambda y: diffrax.diffeqsolve(rates, diffrax.Heun(), 0.0, 1.0, 0.1, y, saveat=times, throw=False).ys)
print(float(solve(1.0)[-1]))
"""
FLAGS = """
import os, sys
from polhode.cli.compiled import compile_quickly
compile_quickly()
assert "jax" not in sys.modules
print(os.environ.get("XLA_FLAGS", ""))
import jax
assert float(jax.jit(lambda x: 2.0 * x)(1.5)) == 3.0
"""
IMPORT = """
import os, polhode, polhode.algebra, jax
assert jax.config.jax_compilation_cache_dir is None
assert not {"EQX_ON_ERROR", "XLA_FLAGS"} & set(os.environ)
jax.jit(jax.numpy.sin)(1.0)
"""


def run(program, cache, **more):
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("JAX_", "EQX_", "TF_", "XLA_"))}
    environment |= {"XDG_CACHE_HOME": str(cache), "HOME": str(cache)} | more
    done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, timeout=300,
                          check=False)  # fmt: skip
    assert done.returncode == 0 and done.stderr == "", done.stderr
    return done.stdout


def kept(cache):
    return {path: path.stat().st_ino for path in cache.glob("**/compiled/*/*-cache")}


@pytest.fixture(scope="module")
def filled(tmp_path_factory):
    """What the program says when it runs for the first time, and the folder where it keeps what it compiled."""
    cache = tmp_path_factory.mktemp("cache")
    return run(PROGRAM, cache), cache


@pytest.mark.sweep
def test_what_is_compiled_is_kept_even_a_solver_with_checks(filled):
    said, cache = filled
    files = kept(cache)
    assert abs(float(said) - 0.367879) < 1e-3
    assert any("lambda" in path.name for path in files)
    assert run(PROGRAM, cache) == said and kept(cache) == files  # all of it was found


@pytest.mark.sweep
def test_what_is_broken_or_cannot_be_written_is_compiled_again_in_silence(filled, tmp_path):
    said, cache = filled
    shutil.copytree(cache, tmp_path / "good")
    broken = kept(tmp_path / "good")
    for path in broken:
        path.write_bytes(path.read_bytes()[:40])
    assert run(PROGRAM, tmp_path / "good") == said
    assert all(path.stat().st_size > 40 for path in broken)
    (tmp_path / "file").write_text("")
    assert run(PROGRAM, tmp_path / "file") == said


def test_without_a_home_nothing_is_kept(monkeypatch, without_home):
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(os, "environ", {"PATH": os.environ["PATH"]})
    with warnings.catch_warnings():
        compiled.compile_quickly()
        compiled.keep_compiled()
    assert not [name for name in os.environ if name.endswith(("_CACHE", "_FLAGS"))]


@pytest.mark.parametrize("folder", ["~/.cache/polhode", "/home/me/.cache/polhode"])
def test_a_home_that_is_not_known_is_no_folder(monkeypatch, folder):
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: Path(folder))
    assert compiled._cache_folder() == (None if folder.startswith("~") else Path(folder))


@pytest.mark.long
def test_a_folder_that_the_user_chose_is_left_as_it_is(tmp_path):
    run(PROGRAM, tmp_path / "cache", JAX_COMPILATION_CACHE_DIR=str(tmp_path / "chosen"))
    assert (tmp_path / "chosen").is_dir() and not kept(tmp_path / "cache")


@pytest.mark.long
def test_importing_the_library_switches_nothing_on(tmp_path):
    run(IMPORT, tmp_path)
    assert not kept(tmp_path)


@pytest.mark.long
def test_the_compiler_knows_the_flags_and_the_users_own_win(tmp_path):
    own = "--xla_cpu_enable_fast_math=false"
    assert "optimization_level" in run(FLAGS, tmp_path)
    assert run(FLAGS, tmp_path, XLA_FLAGS=own).strip() == own


COUNTED = """
import os, subprocess
from polhode.cli import compiled
run, trials = subprocess.run, []
subprocess.run = lambda *args, **kwargs: trials.append(1) or run(*args, **kwargs)
compiled.compile_quickly((compiled.QUICKLY[0], "--xla_flag_of_another_release=1"))
print(os.environ.get("XLA_FLAGS"), len(trials))
"""


@pytest.mark.long
def test_a_flag_that_the_compiler_does_not_know_is_left_out(tmp_path):
    """It would end the process. Which these are is asked once."""
    known = "--xla_backend_optimization_level=1"
    assert run(COUNTED + "import jax; jax.jit(lambda x: x + 1.0)(1.0)", tmp_path).split() == [known, "3"]
    assert run(COUNTED, tmp_path).split() == [known, "0"]
    (kept,) = (tmp_path / "polhode" / "flags").iterdir()
    for damaged in ("", "--xla_dump_to=/"):  # without its seal
        kept.write_text(damaged)
        assert run(COUNTED, tmp_path).split() == [known, "3"]


def test_a_compiler_that_cannot_be_remembered_is_given_no_flags(tmp_path):
    (tmp_path / "file").write_text("")
    assert run(COUNTED, tmp_path / "file").split() == ["None", "0"]


UNITS = """
from polhode.cli.compiled import keep_compiled
keep_compiled()
from polhode.spec.units import parse_quantity
print(parse_quantity("60 rpm", "rad/s"), parse_quantity("3 cpm", "rad/s"), parse_quantity("12 g*cm^2", "kg*m^2"))
"""


@pytest.mark.sweep
def test_the_table_of_units_is_kept_and_a_damaged_one_is_read_again(tmp_path):
    said = run(UNITS, tmp_path)
    assert said.split() == ["6.283185307179586", "0.3141592653589793", "1.2000000000000002e-06"]
    files = [path for path in tmp_path.glob("**/units/*") if path.is_file()]
    assert files
    assert run(UNITS, tmp_path) == said
    for damaged in (b"", b"\x80\x05", b"not a pickle"):
        for path in files:
            path.write_bytes(damaged)
        assert run(UNITS, tmp_path) == said


@pytest.mark.long
def test_a_cache_that_cannot_be_written_changes_nothing(tmp_path):
    (tmp_path / "file").write_text("")
    assert run(UNITS, tmp_path, POLHODE_UNITS_CACHE=str(tmp_path / "file")) == run(UNITS, tmp_path)


@pytest.mark.parametrize(("command", "count"), [("sweep", 0), ("report", 1)])
def test_sweeps_compile_as_the_library_does(monkeypatch, command, count):
    """A store goes on in Python, and on workers elsewhere, to the same bits; other flags round otherwise."""
    called = []
    monkeypatch.setattr("polhode.cli.compiled.compile_quickly", lambda: called.append(1))
    monkeypatch.setattr("polhode.cli.compiled.keep_compiled", lambda: None)
    monkeypatch.setattr(sys, "argv", ["polhode", command, "none.toml"])
    assert entry._run(None) == 2 and len(called) == count
