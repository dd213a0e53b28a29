"""Specs at the ends of the range: each key of each kind is computed, or refused in one message that names it."""

import random
import shutil

import pytest

import judged
from judged import faults_of, run
from polhode.errors import PolhodeError
from polhode.kinds.reading import read_spec
from polhode.reports.report import Report
from polhode.reports.wording import duration, number
from spec.ends import at_end, host_of, hosts_of, keys_of
from spec.mutations import EXAMPLES, FILES, KINDS

READ, REPORTED, SWEPT = 300, 1, 12  # cases: specs that are read, of all kinds; reports of each kind, in a sweep more
SHARED = ("body", "spin", "time", "export")


@pytest.fixture
def folder(tmp_path):
    for name in FILES:
        shutil.copy(EXAMPLES / name, tmp_path)
    return tmp_path


@pytest.fixture(scope="module")
def hosts(tmp_path_factory):
    """Return, by kind, keys with a spec that each is set in, None where there is none."""
    made = tmp_path_factory.mktemp("hosts")
    for name in FILES:
        shutil.copy(EXAMPLES / name, made)
    found = {}

    def of(kind):
        if kind not in found:
            kept = hosts_of(kind, made)
            found[kind] = [(key, host_of(key, kept, made)) for key in keys_of(kind)]
        return found[kind]

    return of


def drawn(hosts, kind, chance):
    """Return a key, an end of its range and the spec that says it."""
    while True:
        key, host = chance.choice(hosts(kind))
        end = chance.choice(key.ends)
        if host is not None and (text := at_end(host, key, end)) is not None:
            return f"{key} = {str(end)[:20]}", text


def reported(folder, text, *options):
    (folder / "case.toml").write_text(text)
    outcome = run(["report", "case.toml", "--out", "out", *options], folder)
    shutil.rmtree(folder / "out", ignore_errors=True)
    return faults_of(outcome, text)


@pytest.mark.long
def test_every_number_has_a_spec_that_it_is_drawn_in(hosts, any_type):
    """A new key is drawn too, or this says which spec of ``mutations.EXTRA`` it must be added to."""
    numbers = [(key, host) for kind in KINDS for key, host in hosts(kind) if key.form in ("number", "whole")
               and key.path[:2] != ("body", "joints")]  # fmt: skip  # of robots' files, in spacecraft/test_robots.py
    missing = [str(key) for key, host in numbers if host is None and key.path[0] == "system"]
    reached = {key.path for key, host in numbers if host is not None}
    missing += sorted({".".join(map(str, key.path)) for key, _ in numbers if key.path not in reached})
    assert not missing and len(reached) > 120


@pytest.mark.sweep
def test_specs_are_read_or_refused(hosts, folder, any_type):
    chance = random.Random(27)
    path = folder / "case.toml"
    refused = 0
    for k in range(READ):
        what, text = drawn(hosts, KINDS[k % len(KINDS)], chance)
        path.write_text(text)
        with judged.bounded():
            try:
                read_spec(path)
            except PolhodeError as error:
                refused += 1
                assert not judged.NOT_A_NUMBER.search(str(error)) or "nan" in text or "inf" in text, (what, str(error))
    assert 0.3 * READ < refused < 0.95 * READ


@pytest.mark.sweep
def test_reports_are_made_or_refused(hosts, folder, any_type, monkeypatch):
    monkeypatch.setattr(Report, "draw", lambda *_: [])
    chance = random.Random(1)
    found = {}
    for kind in KINDS:
        for _ in range(REPORTED):
            what, text = drawn(hosts, kind, chance)
            if faults := reported(folder, text, "--json"):
                found[what] = faults
    assert not found


@pytest.mark.sweep
@pytest.mark.parametrize("kind", KINDS)
def test_many_reports_with_figures_and_pages_are_made_or_refused(hosts, folder, any_type, kind):
    chance = random.Random(2)
    cases = [drawn(hosts, kind, chance) for _ in range(SWEPT)]
    found = {what: faults for what, text in cases if (faults := reported(folder, text, "--html"))}
    assert not found


FOUND = {
    "field whose square underflows": ("sphere-mhd", "system.random_field.field", "1e-150"),
    "turning that overflows": ("sphere-mhd", "system.alfven_wave.turning", "1e300"),
    "spread that overflows": ("vlasov-poisson", "system.beams.0.spread", "1e300"),
    "spread that underflows": ("vlasov-poisson", "system.beams.0.spread", "1e-300"),
    "distortion that overflows": ("quantum-rotor", "system.distortion.*", "1e300"),
    "weights that overflow": ("quantum-rotor", "system.spin_weights.0", "1.7e308"),
    "places that overflow": ("point-vortices", "system.positions.0.0", "1e300"),
    "inf m/s in a sentence": ("point-vortices", "system.ring_radius", "1e300"),
    "a sphere that overflows": ("point-vortices", "system.sphere_radius", "1e300"),
    "a sphere that underflows": ("sphere-fluid", "system.radius", "1e-300"),
    "infinite degrees": ("sphere-fluid", "system.vortices.0.latitude", "1.7e308"),
    "energy that overflows": ("spin-lattice", "system.bonds.0.exchange", "1e300"),
    "rotor that overflows": ("gyrostat", "system.rotor_rate", "1e300"),
}


@pytest.mark.parametrize("name", FOUND)
def test_what_the_ends_found_is_refused_by_name(hosts, folder, any_type, name):
    kind, place, end = FOUND[name]
    key, host = next((key, host) for key, host in hosts(kind) if ".".join(map(str, key.path)) == place)
    text = at_end(host, key, end)
    (folder / "case.toml").write_text(text)
    outcome = run(["report", "case.toml", "--out", "out"], folder)
    assert not faults_of(outcome, text)
    last = next(part for part in reversed(key.path) if isinstance(part, str) and part != "*")
    assert outcome.code == 2 and last in outcome.error


def test_what_is_not_a_number_has_no_words():
    assert number(float("nan"), "rad/s") is None and duration(float("nan")) is None
    assert number(float("-inf")) == "infinite"


@pytest.mark.parametrize(("outcome", "said"), [
    (judged.Outcome(0, "moves at inf m/s", "", "", 0.0, []), "printed"),
    (judged.Outcome(0, '{"rms": NaN}', "", "", 0.0, []), "JSON"),
    (judged.Outcome(0, "", "a.py:3: RuntimeWarning: overflow", "", 0.0, []), "code on standard error"),
    (judged.Outcome(2, "", "polhode: no.", "", 0.0, ["out/a.png"]), "left"),
    (judged.Outcome(2, "", "", "", 0.0, []), "without a word"),
    (judged.Outcome(None, "", "", "OverflowError", 0.0, []), "OverflowError"),
    (judged.Outcome(7, "", "", "", 0.0, []), "exit code 7"),
    (judged.Outcome(2, "", "polhode: must be small; it is inf rad/s.", "", 0.0, []), "said"),
])  # fmt: skip
def test_a_bad_end_is_noticed(outcome, said):
    assert any(said in fault for fault in faults_of(outcome, "rate = 1e300"))
