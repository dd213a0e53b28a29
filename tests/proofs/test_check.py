"""The proofs are those that Rocq last accepted, and say what the page about them says; without Rocq, by hashes."""

import hashlib
import importlib
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from certificates.test_exact import ALTERED

ROOT = Path(__file__).parents[2]
PROOFS = ROOT / "proofs"
README = (PROOFS / "README.md").read_text("utf-8")
SOURCES = sorted(PROOFS.rglob("*.v"))
ABSURD = [path for path in SOURCES if path.parent.name == "controls"]  # proofs of 2 = 1, to be refused
THEORY = [path for path in SOURCES if path.parent.name not in ("certificates", "controls")]  # the first are data
LISTS = {"controls.txt", "controls_certificates.txt", "assumptions.txt"}
ROWS = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        for line in README.splitlines() if line.startswith("| `")]  # fmt: skip
needs_shell = pytest.mark.skipif(not (shutil.which("sh") and shutil.which("xargs")), reason="no POSIX shell here")


def compare_hashes(folder):
    run = subprocess.run(["sh", str(folder / "check.sh"), "--hashes"], capture_output=True, text=True, timeout=60)
    return run.returncode, run.stdout


@needs_shell
def test_the_sources_are_those_that_were_checked():
    code, said = compare_hashes(PROOFS)
    assert code == 0, said
    assert said.splitlines()[-1] == "0 passed, 0 failed, 1 skipped"


@needs_shell
def test_a_changed_source_is_noticed(tmp_path):
    copy = tmp_path / "proofs"
    shutil.copytree(PROOFS, copy, ignore=shutil.ignore_patterns("*.vo*", "*.glob", ".*.aux", "__pycache__"))
    hashed = [path for path in copy.rglob("*") if path.suffix in (".v", ".gappa") or path.name in LISTS]
    lines = {path.relative_to(copy).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in hashed}
    (copy / "CHECKED").write_text("".join(f"{lines[name]}  {name}\n" for name in sorted(lines)), "utf-8")
    assert compare_hashes(copy)[0] == 0
    (copy / "Euler.v").write_text((copy / "Euler.v").read_text("utf-8").replace("cross L h", "cross h L", 1), "utf-8")
    (copy / "New.v").write_text("Theorem new : True.\nProof. exact I. Qed.\n", "utf-8")
    (copy / "Motion.v").unlink()
    code, said = compare_hashes(copy)
    assert code == 1
    assert re.findall(r"^  (\S+)$", said, re.MULTILINE) == ["Euler.v", "Motion.v", "New.v"]
    assert said.splitlines()[-1] == "0 passed, 1 failed"


@needs_shell
def test_an_unknown_option_is_refused():
    run = subprocess.run(["sh", str(PROOFS / "check.sh"), "--fast"], capture_output=True, text=True, timeout=60)
    assert run.returncode == 2 and '"--fast"' in run.stderr and "--hashes" in run.stderr


def test_nothing_is_left_unproved():
    """Also without Rocq; a comment may not say these words either."""
    for path in set(SOURCES) - set(ABSURD):
        found = re.search(r"\b(Admitted|Axiom|Parameter|Conjecture|Abort|admit|give_up)\b", path.read_text("utf-8"))
        assert not found, f"{path.name}: {found[0]}"


def test_there_are_enough_controls_each_with_its_reason():
    text = (PROOFS / "controls.txt").read_text("utf-8")
    records = re.findall(r"^file: (.+)\nfrom: (.+)\nto: (.+)\nwhy: (.+)$", text, re.MULTILINE)
    assert len(records) == len(re.findall("^file: ", text, re.MULTILINE)) >= 12
    for file, old, new, why in records:
        assert old in (PROOFS / file).read_text("utf-8"), f"{file}: {old}"
        assert old != new and len(why.split()) > 4
        changed = [word for word in re.findall(r"\w+|\S", new) if word not in re.findall(r"\w+|\S", old)]
        assert len(changed) <= 2 or sorted(re.findall(r"\w+|\S", old)) == sorted(re.findall(r"\w+|\S", new)), (old, new)


def test_pages_say_how_many_controls_there_are():
    """Counted in the files, and the certificates that tests alter."""
    statements = len(re.findall("^file: ", (PROOFS / "controls.txt").read_text("utf-8"), re.MULTILINE))
    certificates = len((PROOFS / "controls_certificates.txt").read_text("utf-8").splitlines())
    page = " ".join((ROOT / "docs" / "proofs.md").read_text("utf-8").split())
    for words in (f"{statements} statements that are false by one token", f"{len(ABSURD)} proofs of 2 = 1",
                  f"{certificates} certificates with one number",
                  f"Tests have Rocq refuse {len(ALTERED)} further"):  # fmt: skip
        assert words in page, words
    readme = " ".join(README.split())
    for words in (f"the {statements} false statements", f"the {certificates} of [controls_certificates.txt]",
                  f"the {len(ABSURD)} proofs of 2 = 1"):  # fmt: skip
        assert words in readme, words


def test_a_check_has_a_control_for_each_way_to_leave_it_out():
    """An axiom under any name, and each flag of the kernel that a proof may rest on."""
    texts = [path.read_text("utf-8") for path in ABSURD]
    assert all("Theorem two_is_one : 2 = 1." in text for text in texts)
    for way in ("Hypothesis magic'", "bypass_check(guard)", "bypass_check(positivity)"):
        assert any(way in text for text in texts), way


def test_the_sources_are_written_to_be_read():
    for path in THEORY:
        lines = path.read_text("utf-8").splitlines()
        assert len(lines) <= 450, f"{path.name} has {len(lines)} lines"
        assert max(map(len, lines)) <= 120, path.name
        assert lines[0].startswith("(*"), f"{path.name} does not say what it proves"


@pytest.mark.parametrize("names, file, says, docs, code", ROWS, ids=lambda cell: cell[:30])
def test_the_table_of_theorems(names, file, says, docs, code):
    """Each theorem is in its file, its formula under the words in the docs, and the code is there."""
    text = (PROOFS / file.strip("`")).read_text("utf-8")
    for name in re.findall(r"`(\w+)`", names):
        assert re.search(rf"^(Theorem|Corollary|Lemma) {name}\b", text, re.MULTILINE), f"{file}: {name}"
    page, words = re.fullmatch(r"`(\S+)`: (.+)", docs).groups()
    assert words in (ROOT / "docs" / page).read_text("utf-8"), docs
    module, _, name = code.strip("`").rpartition(".")
    assert hasattr(importlib.import_module(module), name), code
    assert says


def test_the_table_has_every_file():
    listed = " ".join(README.split())
    helpers = {"Calculus.v", "Vec3.v", "RealRing.v", "Grid.v"}  # what the others need of calculus, algebra and floats
    missing = [path.name for path in THEORY if path.name not in helpers
               and f"`{path.relative_to(PROOFS).as_posix()}`" not in listed]  # fmt: skip
    assert not missing
