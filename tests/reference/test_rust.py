"""The crate in `reference/rust`: compiled by rustc alone, and its own tests."""

import re
import subprocess

import pytest

import polhode as ph
from reference.solvers import REFERENCE, RUSTC, compiled_rust

CRATE = REFERENCE / "rust"
needs_rustc = pytest.mark.skipif(RUSTC is None, reason="rustc is missing")


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("rust")
    compiled_rust(folder)
    return folder / "libpolhode.rlib"


def output_of(library, source, program, *options):
    command = [RUSTC, "--edition", "2021", *options, "--extern", f"polhode={library}", source, "-o", program]
    subprocess.run(command, check=True, timeout=120)
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
    assert not done.returncode, done.stdout
    return done.stdout


@needs_rustc
@pytest.mark.parametrize("path", sorted((CRATE / "tests").glob("*.rs")), ids=lambda path: path.stem)
def test_its_own_tests(library, tmp_path, path):
    assert "test result: ok" in output_of(library, path, tmp_path / "tests", "--test")


@needs_rustc
def test_the_readme_in_rust(library, tmp_path):
    (example,) = re.findall(r"```rust\n(.*?)```", (REFERENCE / "README.md").read_text("utf-8"), re.DOTALL)
    (tmp_path / "example.rs").write_text(example, "utf-8")
    printed = output_of(library, tmp_path / "example.rs", tmp_path / "example")
    assert printed.split() == [x for line in re.findall(r"// prints (.*)", example) for x in line.split()]


def test_it_needs_nothing_and_has_the_version_of_polhode():
    text = (CRATE / "Cargo.toml").read_text("utf-8")
    assert f'\nversion = "{ph.__version__}"\n' in text and text.rstrip().endswith("[dependencies]")
    assert f'pub const VERSION: &str = "{ph.__version__}";' in (CRATE / "src" / "lib.rs").read_text("utf-8")
