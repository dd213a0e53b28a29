"""Options and tables of numbers at the ends of the range: each command does its work, or refuses it in one message."""

import random
import tempfile
from pathlib import Path

import pytest

from cli.ends import COMMANDS, EXAMPLES, GIVEN, all_arguments, log_of, with_option, write_given
from judged import faults_of, run

FEW, MANY = 1, 25  # cases of a command


def tried(folder, arguments):
    """Return what is wrong with how a command ends, in a folder of its own, and how it ended."""
    with tempfile.TemporaryDirectory(dir=folder) as own:
        write_given(Path(own))
        outcome = run(arguments, Path(own))
    return faults_of(outcome, " ".join(arguments)), outcome


def faults_at_ends(folder, chance, cases):
    arguments = all_arguments()
    found = {}
    for command in COMMANDS:
        of_this = [one for one in arguments if one[0] == command]
        for one in chance.sample(of_this, min(cases, len(of_this))):
            if faults := tried(folder, one)[0]:
                found[" ".join(one)] = faults
    return found


@pytest.mark.sweep
def test_every_command_has_something_to_do(tmp_path, any_type):
    assert set(GIVEN) == set(COMMANDS)
    assert EXAMPLES.is_dir()
    for command, all_given in GIVEN.items():
        for given in all_given:
            faults, outcome = tried(tmp_path, [command, *given])
            assert not faults and outcome.code == 0, (command, given, outcome.error)


@pytest.mark.sweep
def test_options_are_taken_or_refused(tmp_path, any_type):
    assert not faults_at_ends(tmp_path, random.Random(1), FEW)


@pytest.mark.sweep
def test_many_options_are_taken_or_refused(tmp_path, any_type):
    assert not faults_at_ends(tmp_path, random.Random(2), MANY)


@pytest.mark.parametrize("arguments", [
    ["tumble", "apophis", "--diameter", "1e300 m"],
    ["tumble", "apophis", "--semi-axes", "1e300", "1", "1"],
    ["tumble", "apophis", "--precession", "1e200 h", "--rotation", "1e201 h"],
    ["lines", "water.xyz", "--j-max", "2", "--dipole", "0,1e300,0"],
])  # fmt: skip
def test_options_beyond_reach_are_refused_by_name(tmp_path, any_type, arguments):
    faults, outcome = tried(tmp_path, arguments)
    named = [word for word in arguments if word.startswith("--")]
    assert not faults and outcome.code == 2 and any(name in outcome.error for name in named)


SCALES = [(1.0, 1e150), (1.0, 1e300), (1e300, 1.0), (1e150, 1.0), (1.0, 1e13), (1e13, 1.0), (1.0, 1e-19), (1.0, 1e-300),
          (1e-19, 1.0), (1e-300, 1.0), (1.0, 0.0), (1e-9, 1e9)]  # fmt: skip


@pytest.mark.long_after(5)
@pytest.mark.parametrize("scale", SCALES)
def test_logs_at_the_ends_are_fitted_or_refused(tmp_path, any_type, scale):
    write_given(tmp_path)
    (tmp_path / "log.csv").write_text(log_of(scale))
    for command in ("fit", "import"):
        given = GIVEN[command][0]
        if command == "fit":
            option = next(one for one in COMMANDS["fit"].params if "--window" in one.opts)
            given = with_option(given, option, [f"0,{0.89 * scale[0]:g}"])
        outcome = run([command, *given], tmp_path)
        assert not faults_of(outcome, ""), command
        if command == "fit" and max(scale) > 1e12:
            assert outcome.code == 2 and ("rates" in outcome.error or "times" in outcome.error)
