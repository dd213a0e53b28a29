"""The table of hard motions: it is what the oracles say, the closed forms agree with it, and a wrong digit is found."""

import copy
import itertools
import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from flint import arb, ctx

import polhode as ph
from oracle import lagrange_taylor, taylor
from oracle.hard_motions import FREE
from oracle.measures import rotation_of
from oracle.reference_table import CONVENTIONS, TABLE, VERSION, digits_of, families, hard_motions, motion_text
from polhode.judging import motion_table, reference_motions

EPS = 2.0**-52
WORST = 16.0
"""eps of an attitude's entries and of L over its largest, as the library promises."""
PAGE = Path(__file__).parents[2] / "docs" / "reference_motions.md"
SOME = ("flips, 1 deg to the third axis", "long-axis side of the separatrix, 1e-12", "cusps of a toy top")
MOTIONS = {motion.name: motion for motion in hard_motions()}


def as_written():
    """The table with its numbers as text."""
    return json.loads(TABLE.read_text(encoding="utf-8"), parse_float=str, parse_int=str)


WRITTEN = {motion["name"]: motion for motion in as_written()["motions"]}


def misfits(written, motion):
    """Which keys of a written motion are not what the oracle says."""
    wanted = json.loads(motion_text(motion), parse_float=str, parse_int=str)
    return [key for key in {**wanted, **written} if wanted.get(key) != written.get(key)]


def swept(names, some):
    return [name if name in some else pytest.param(name, marks=pytest.mark.sweep) for name in names]


def worst_in_eps(motions):
    """Largest error of the closed forms over motions, in one call for each kind and number of times."""
    alike = lambda motion: (motion.kind, motion.times.size)  # noqa: E731
    worst = 0.0
    for (kind, _), group in itertools.groupby(sorted(motions, key=alike), alike):
        group = list(group)
        moments, momentum, attitude, mgl, times, q, L = (
            np.array([getattr(motion, name) for motion in group])
            for name in ("moments", "momentum", "attitude", "mgl", "times", "attitudes", "momenta")
        )
        start = {"momentum": momentum[:, None], "attitude": attitude[:, None]}
        motion = (ph.FreeMotion(moments[:, None], **start) if kind == "free body"
                  else ph.LagrangeMotion(moments[:, None], mgl=mgl[:, None], **start))  # fmt: skip
        attitudes, momenta = motion.state(times)
        sign = np.sign(np.sum(attitudes * q, axis=-1, keepdims=True))
        size = np.linalg.norm(L, axis=-1).max(axis=-1)[:, None, None]
        worst = max(worst, np.abs(sign * attitudes - q).max() / EPS, (np.abs(momenta - L) / size).max() / EPS)
    return worst


@pytest.mark.long
def test_the_closed_forms_agree_at_every_time(announce):
    worst = worst_in_eps(reference_motions())
    announce(f"Closed forms against the reference motions: {worst:.2f} eps")
    assert worst <= WORST


@pytest.mark.parametrize("name", swept(MOTIONS, SOME))
def test_the_oracle_gives_the_same_digits(name):
    assert not misfits(WRITTEN[name], MOTIONS[name])


def test_the_table_has_the_motions_that_are_defined_and_no_others():
    table = as_written()
    assert [motion["name"] for motion in table["motions"]] == list(MOTIONS)
    assert (table["version"], motion_table.VERSION) == (str(VERSION), VERSION)
    assert (table["conventions"], table["families"]) == (CONVENTIONS, families())
    for name, motion in MOTIONS.items():
        for key in ("moments", "momentum", "attitude", "times"):
            assert list(map(float, WRITTEN[name][key])) == list(getattr(motion, key))


@pytest.mark.parametrize("name", ["random 7", "wing nut", "separatrix of 3, 5, 8", "loops, 1 backwards"])
def test_integrated_equations_of_motion_agree(name):
    """By power series, which know nothing of elliptic functions, through a turn or two."""
    motion = next(m for m in reference_motions() if m.name == name)
    for t, q, L in list(zip(motion.times, motion.attitudes, motion.momenta, strict=True))[1:4]:
        if motion.kind == "Lagrange top":
            state = lagrange_taylor.integrated_top(motion.moments, motion.mgl, motion.momentum, motion.attitude, t)
            turned, momentum = rotation_of(state.quaternion), np.array([float(x) for x in state.momentum])
            found = np.array([[float(x) for x in row] for row in turned])
        else:
            state = taylor.integrated_state(motion.moments, motion.momentum, t)
            found = ph.rotation.as_matrix(motion.attitude) @ [[float(x) for x in row] for row in state.rotation]
            momentum = np.linalg.norm(motion.momentum) * np.array([float(x) for x in state.direction])
        assert np.abs(found - ph.rotation.as_matrix(q)).max() <= 4 * EPS
        assert np.abs(momentum - L).max() <= 4 * EPS * np.linalg.norm(L)


def with_last_digit_changed(text):
    digits, e, exponent = text.partition("e")
    return digits[:-1] + str((int(digits[-1]) + 5) % 10) + e + exponent


@pytest.mark.parametrize("key", ["attitudes", "momenta"])
def test_one_wrong_digit_is_found(key):
    broken = copy.deepcopy(WRITTEN[SOME[0]])
    broken[key][4][2] = with_last_digit_changed(broken[key][4][2])
    assert misfits(broken, MOTIONS[SOME[0]]) == [key]


def scalar_last(motion):
    motion["attitudes"] = [[*q[1:], q[0]] for q in motion["attitudes"]]


def transposed(motion):
    motion["attitudes"] = [[q[0], *(-x for x in q[1:])] for q in motion["attitudes"]]


def late(motion):
    motion["times"] = [t * (1.0 + 1e-12) for t in motion["times"]]


def off_in_the_fourteenth_digit(motion):
    motion["momenta"][3][2] += 1e-14 * sum(abs(x) for x in motion["momentum"])


@pytest.mark.parametrize("breaking", [scalar_last, transposed, late, off_in_the_fourteenth_digit])
@pytest.mark.parametrize("kind", ["free body", "Lagrange top"])
def test_closed_forms_do_not_agree_with_a_broken_table(kind, breaking):
    table = json.loads(TABLE.read_text(encoding="utf-8"))
    name = SOME[0] if kind == "free body" else SOME[2]
    table["motions"] = [motion for motion in table["motions"] if motion["name"] == name]
    assert worst_in_eps(motion_table.parse_motions(table)) <= WORST
    breaking(table["motions"][0])
    assert worst_in_eps(motion_table.parse_motions(table)) > WORST


def test_numbers_are_rounded_from_what_is_certain():
    with ctx.workprec(200):
        assert str(digits_of(arb("0.12345678901234567499"), 1.0)) == "0.12345678901234567"
        assert str(digits_of(arb("-0.12345678901234567501"), 1.0)) == "-0.12345678901234568"
        assert digits_of(arb(0, 1e-60), 1.0) == 0
        with pytest.raises(ArithmeticError, match="too few digits"):
            digits_of(arb(0.3, 1e-15), 1.0)


def test_what_a_motion_is():
    for motion in reference_motions():
        count = motion.times.size
        assert motion.attitudes.shape == (count, 4) and motion.momenta.shape == (count, 3) and count >= 9
        assert motion.times[0] == 0.0 and (motion.times < 0.0).any() and motion.moderate.sum() >= 5
        assert (np.diff(np.abs(motion.times)) > 0.0).all()
        assert list(motion.moderate) == list(motion.rate * np.abs(motion.times) <= motion_table.MODERATE)
        assert np.abs(np.linalg.norm(motion.attitudes, axis=-1) - 1.0).max() <= 2 * EPS
        assert ph.rotation.angle_between(motion.attitudes[0], motion.attitude) <= 4 * EPS
        assert motion.momenta[0] == pytest.approx(motion.momentum, rel=EPS)
        for array in (motion.moments, motion.times, motion.attitudes):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 0.0
    assert TABLE.stat().st_size < 1.5e6


def test_how_fast_a_body_turns_is_bounded():
    for motion in reference_motions(kind="free body"):
        speeds = np.linalg.norm(motion.momenta / motion.moments, axis=-1)
        assert speeds.max() <= 1.001 * motion.rate


def test_motions_are_chosen_by_family_kind_and_turning():
    assert {motion.family for motion in reference_motions("flips")} == {"flips"}
    tops = reference_motions(kind="Lagrange top")
    assert len(tops) + len(reference_motions(kind="free body")) == len(reference_motions()) == len(MOTIONS)
    for motion in reference_motions("spheres", up_to=20.0):
        assert motion.times.shape == motion.moderate.shape == motion.attitudes.shape[:1] == motion.momenta.shape[:1]
        assert 3 <= motion.times.size < 8 and (motion.rate * np.abs(motion.times) <= 20.0).all()
    assert {m.kind for m in MOTIONS.values() if m.family == "flips"} == {FREE}


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"family": "flip"}, r"`family` must be one of \"short-axis\", .*\"top-random\"; got 'flip'"),
        ({"kind": "top"}, r"`kind` must be \"free body\" or \"Lagrange top\"; got 'top'"),
        ({"family": "flips", "kind": "Lagrange top"}, r"family 'flips' has no motions of kind 'Lagrange top'"),
        ({"up_to": -1.0}, r"`up_to` must be a number that is not negative .rad.; got -1.0"),
        ({"up_to": float("nan")}, r"`up_to` must be a number that is not negative .rad.; got nan"),
    ],
)
def test_what_the_table_does_not_have_is_refused(given, said):
    with pytest.raises(ph.InvalidInput, match=said):
        reference_motions(**given)


@pytest.mark.parametrize("head", [{"version": 2}, {"format": "another"}, {"version": "1"}])
def test_other_tables_are_refused(head):
    table = {"format": motion_table.FORMAT, "version": VERSION, "motions": []} | head
    with pytest.raises(ph.FormatError, match="must be of format polhode reference motions, version 1; got"):
        list(motion_table.parse_motions(table))


def test_reading_needs_no_jax():
    code = ("import sys, polhode as ph; motions = ph.judging.reference_motions('flips', up_to=10.0); "
            "print(ph.judging.compare_engine(lambda m: (m.attitudes, m.momenta), motions)); "
            "sys.exit('jax' in sys.modules)")  # fmt: skip
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert found.returncode == 0, found.stderr


def test_the_script_in_the_docs_judges_in_javascript(tmp_path):
    node = shutil.which("node")
    if node is None:
        pytest.skip("Node is not installed")
    script = PAGE.read_text(encoding="utf-8").partition("```js\n")[2].partition("```")[0]
    (tmp_path / "judge.js").write_text(script, encoding="utf-8")
    shutil.copy(TABLE, tmp_path)
    found = subprocess.run([node, "judge.js"], cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert found.returncode == 0, found.stderr
    worst = json.loads(found.stdout)
    assert worst["steady"] < 1e-12 and worst["flips"] > 1.0
