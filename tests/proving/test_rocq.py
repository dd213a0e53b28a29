"""Files for the prover: equal to those in proofs/, refused where they are altered, and compiled where Rocq is there."""

import importlib.util
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import jaxtyping
import numpy as np
import pytest
from flint import fmpq

import polhode as ph
from certificates.test_exact import ALTERED, BODY, TOP, UPRIGHT, exact, judge
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.proving import check_by_z3, write_proof
from polhode.proving.verdicts.rocq import THEORY, proof_text, theory

pytest.importorskip("flint")
ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "proofs" / "certificates"
SPEC = importlib.util.spec_from_file_location("write_certificates", FOLDER / "write_certificates.py")
written = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(written)
with_prover = pytest.mark.skipif(shutil.which("coqc") is None, reason="no coqc here")


@pytest.mark.long_after(8)
@pytest.mark.long_cases("so4_two_planes", "so4_one_plane")
@pytest.mark.parametrize("name", written.CASES)
def test_files_are_what_the_package_writes(name):
    assert (FOLDER / f"{name}.v").read_text("utf-8") == written.texts([name])[f"{name}.v"]


def test_the_theory_beside_them_is_the_packages():
    assert (FOLDER / THEORY).read_text("utf-8") == theory()
    there = {path.name for path in FOLDER.glob("*.v")}
    assert there == {THEORY} | {f"{name}.v" for name in written.CASES}


def test_controls_alter_what_is_there():
    lines = (ROOT / "proofs" / "controls_certificates.txt").read_text("utf-8").splitlines()
    assert len(lines) >= 10
    for line in lines:
        file, old, new = line.split("|")
        assert old in (ROOT / "proofs" / file).read_text("utf-8") and old != new


def compile_file(folder, name):
    command = ["coqc", "-w", "none", "-Q", ".", "Polhode", name]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, check=False)


@pytest.fixture(scope="module")
def workshop(tmp_path_factory):
    folder = tmp_path_factory.mktemp("proofs")
    (folder / THEORY).write_text(theory(), "utf-8")
    assert compile_file(folder, THEORY).returncode == 0
    return folder


@pytest.mark.sweep
@with_prover
def test_rocq_accepts_a_fresh_certificate(workshop):
    body = ph.systems.FreeRigidBody((0.9, 1.3, 1.7))
    write_proof(exact(body, [0.0, 0.0, 0.7]), workshop / "fresh.v")
    result = compile_file(workshop, "fresh.v")
    assert result.returncode == 0 and "Axioms" in result.stdout, result.stderr


@pytest.mark.sweep
@with_prover
@pytest.mark.parametrize("name", ALTERED)
def test_rocq_refuses_altered_certificates(name, workshop):
    (workshop / "altered.v").write_text(proof_text(ALTERED[name](), "altered"), "utf-8")
    assert "Error" in compile_file(workshop, "altered.v").stderr


def test_a_file_says_what_it_proves(tmp_path):
    path = write_proof(exact(TOP, UPRIGHT), tmp_path / "upright.v")
    text = path.read_text("utf-8")
    assert "(0, 0, 12, 0, 0, 1) is stable" in text and "Theorem equilibrium_is_stable" in text
    assert (tmp_path / THEORY).read_text("utf-8") == theory()
    write_proof(exact(BODY, [0, 1, 0]), tmp_path / "middle.v")
    assert "Theorem equilibrium_is_unstable" in (tmp_path / "middle.v").read_text("utf-8")


@pytest.mark.parametrize("name", ["proof.txt", "1.v", "two words.v", THEORY])
def test_names_that_are_no_modules_are_refused(name, tmp_path):
    with pytest.raises(InvalidInput, match=r"must be named like top_1\.v"):
        write_proof(exact(BODY, [0, 0, 1]), tmp_path / name)


@pytest.mark.parametrize("prove", [check_by_z3, lambda certificate: write_proof(certificate, "top_1.v")])
def test_the_sentence_of_a_verdict_is_no_exact_certificate(monkeypatch, prove):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match=r"must be a RationalCertificate; got .* Make one by `as_rational\(\)`"):
        prove(judge(BODY, [0, 0, 1]).certificate)


def test_an_altered_certificate_is_not_written(tmp_path):
    with pytest.raises(InvalidInput, match="must prove its verdict"):
        write_proof(ALTERED["a weight"](), tmp_path / "wrong.v")
    assert not list(tmp_path.iterdir())


@pytest.mark.long
def test_a_report_writes_its_proofs(tmp_path, capsys):
    spec = str(ROOT / "examples" / "t_handle.toml")
    with pytest.raises(SystemExit) as ended:
        main(["report", spec, "--out", str(tmp_path / "out"), "--proof", str(tmp_path / "proof")])
    assert not ended.value.code
    names = {path.name for path in (tmp_path / "proof").iterdir()}
    assert names == {THEORY, "axes_1.v", "axes_2.v", "axes_3.v"}
    assert "checks a proof by" in capsys.readouterr().out.replace("\n", " ")


@pytest.mark.long
def test_a_report_is_written_with_its_proofs_or_not_at_all(tmp_path):
    spec = tmp_path / "case.toml"
    moments = '["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]'
    spec.write_text(f'[body]\nmoments = {moments}\n[spin]\nrate = "1 rpm"\nabout = 1\n', "utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["report", str(spec), "--out", str(tmp_path / "out"), "--proof", str(spec)])
    assert ended.value.code == 2 and not (tmp_path / "out").exists()


def test_a_proof_says_how_far_its_point_is():
    certificate = judge(BODY, [0, 0, 1]).certificate.as_rational()
    assert "This exact equilibrium" not in proof_text(certificate, "exact")
    moved = replace(certificate, equations=replace(certificate.equations, moved=fmpq(1, 10**12)))
    assert "This exact equilibrium is 1.0e-12 from the point that was asked about." in proof_text(moved, "moved")


def test_instability_is_that_of_the_sampled_motion():
    """A start on the ray of V leaves the ball of the proof, as the theorem says of every solution."""
    result = judge(BODY, [0, 1, 0]).certificate.as_rational()
    ray = np.array(result.proof.direction, float)
    start = np.array([0.0, 1.0, 0.0]) + 1e-4 * float(result.proof.radius) * ray
    states = ph.simulate(BODY, start, np.linspace(0.0, 40.0, 200)).states
    assert np.linalg.norm(states - [0.0, 1.0, 0.0], axis=1).max() > float(result.proof.radius)
