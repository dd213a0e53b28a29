"""The npm package and the C header carry version, licence, types and tables, and what is packed can be imported."""

import json
import re
import shutil
import subprocess
import tarfile

import pytest

import polhode as ph
from polhode.judging import fixed_step_cases, reference_motions
from reference.solvers import NODE, REFERENCE, ROOT

NPM = shutil.which("npm")
ASK = """
import * as all from "polhode-reference";
import * as stepped from "polhode-reference/stepped";
import { createRequire } from "node:module";
const load = createRequire(import.meta.url);
const motions = load("polhode-reference/motions").motions, cases = load("polhode-reference/cases").cases;
const state = new all.FreeMotion(motions[0]).state(motions[0].times[3]);
console.log(JSON.stringify({ version: all.version, names: Object.keys(all), stepped: Object.keys(stepped),
  quaternion: Object.keys(all.quaternion), fields: Object.keys(new all.FreeMotion(motions[0])), motions: motions.length,
  cases: cases.length, error: Math.max(...state.momentum.map((x, k) => Math.abs(x - motions[0].momenta[3][k]))) }));
"""


def test_the_version_is_that_of_polhode():
    assert json.loads((REFERENCE / "package.json").read_text("utf-8"))["version"] == ph.__version__
    assert f'#define POLHODE_VERSION "{ph.__version__}"' in (REFERENCE / "polhode.h").read_text("utf-8")
    assert f'export const version = "{ph.__version__}"' in (REFERENCE / "index.js").read_text("utf-8")


def test_each_says_its_licence():
    for name in ("polhode.h", "polhode_cases.h", "polhode.js", "index.js", "index.d.ts"):
        assert "SPDX-License-Identifier: MIT" in (REFERENCE / name).read_text("utf-8")[:200], name
    assert "MIT License" in (ROOT / "LICENSE").read_text("utf-8")


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """The packed package, unpacked where node finds it."""
    if NPM is None or NODE is None:
        pytest.skip("npm is missing")
    folder = tmp_path_factory.mktemp("npm")
    clone = folder / "repository"
    for part in ("reference", "src/polhode/judging"):
        shutil.copytree(ROOT / part, clone / part)
    shutil.copy(ROOT / "LICENSE", clone)
    done = subprocess.run([NPM, "pack", "--offline", "--json"], cwd=clone / "reference", capture_output=True, text=True,
                          timeout=120, check=False)  # fmt: skip
    assert not done.returncode, done.stderr
    (archive,) = (clone / "reference").glob("*.tgz")
    with tarfile.open(archive) as packed:
        packed.extractall(folder, filter="data")
    (folder / "node_modules").mkdir()
    (folder / "package").rename(folder / "node_modules" / "polhode-reference")
    return folder


@pytest.mark.long
def test_what_is_packed_can_be_imported_and_has_the_tables(installed):
    (installed / "ask.mjs").write_text(ASK)
    done = subprocess.run([NODE, "ask.mjs"], cwd=installed, capture_output=True, text=True, timeout=60, check=False)
    assert not done.returncode, done.stderr
    found = json.loads(done.stdout)
    assert (found["version"], found["motions"]) == (ph.__version__, len(reference_motions()))
    assert found["cases"] == len(fixed_step_cases()) and found["error"] < 1e-14
    package = installed / "node_modules" / "polhode-reference"
    for name in ("LICENSE", "README.md", "polhode.h", "polhode_cases.h", "index.d.ts"):
        assert (package / name).exists(), name
    assert not (package / "gather.mjs").exists()
    types = (package / "index.d.ts").read_text("utf-8")
    for name in (*found["names"], *found["quaternion"]):
        assert re.search(rf"\b(class|const|function|namespace) {name}\b", types), name
    for name in found["fields"]:
        assert name.startswith("_") or re.search(rf"readonly {name}:", types), name
    stepped = (package / "stepped" / "index.d.ts").read_text("utf-8")
    assert {name for name in found["stepped"] if f"class {name}" not in stepped} <= {"Stepped"}
