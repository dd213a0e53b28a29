"""Reports from Python: the numbers of the command, shown in a notebook, without files."""

import json

import jaxtyping
import pytest

import polhode as ph
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.reports.report import Report
from polhode.studies.tumble import Friction

KEYS = {"name", "kind", "summary", "units", "notes"}


def said_by(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments), "--json"])
    assert not end.value.code
    return json.loads(capsys.readouterr().out)


def test_a_tumbler_is_that_of_the_command(capsys):
    found = ph.tumble("apophis", friction=Friction(340.0))
    said = said_by(capsys, "tumble", "apophis", "--diameter", "340 m")
    assert said.pop("files") == [] and said == json.loads(found.json())
    assert KEYS <= said.keys() and said["kind"] == "tumble" and found.determined
    by_hand = ph.tumble(precession="27.38 ± 0.07 h", rotation=(263 * 3600.0, 6 * 3600.0),
                        moments=("0.61 ± 0.03", 0.965, 1.0))  # fmt: skip
    assert by_hand.values()["energy_ratio"] == pytest.approx(found.values()["energy_ratio"], rel=1e-2)


def test_a_notebook_shows_it():
    found = ph.tumble("apophis")
    shown = found._repr_html_()
    assert shown.count("<table>") >= 4 and "Apophis" in shown and found.summary[:20] in shown
    assert set(found.plot()) == {"polhode", "light_curve", "spectrum"}
    assert "<script>" not in Report("<script>", "x", "", [])._repr_html_()


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({}, "`precession` and `rotation` and `moments` are missing"),
        ({"precession": -1.0, "rotation": 2.0, "moments": (1, 2, 2.5)}, "`precession` must be positive; got -1.0"),
        ({"precession": 1.0, "rotation": "2 ± x h", "moments": (1, 2, 2.5)}, "`rotation`"),
        ({"precession": 1.0, "rotation": (2.0, -1.0), "moments": (1, 2, 2.5)}, "`rotation` must not have a negative"),
        ({"precession": 1.0, "rotation": 2.0, "moments": (1, 2, 2.5), "semi_axes": (1, 1, 1)}, "both tell the moments"),
        ({"precession": 1.0, "rotation": 2.0, "semi_axes": (1, 0, 1)}, "three positive numbers"),
        ({"body": "apophis", "mode": "tumbling"}, "`mode` must be short-axis or long-axis; got 'tumbling'"),
        ({"body": "apophis", "aspect": 60.0}, "`aspect` must be between 0 and 180° in radians; got 60"),
        ({"body": "apophis", "rotation": (1.0, 2.0, 3.0)}, "a number, one with its standard deviation, or a text"),
        ({"body": 5}, "no tumbler is called '5'"),
    ],
)
def test_mistakes_name_the_argument(given, words, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)  # as nobody checks the types of a user's numbers
    with pytest.raises(InvalidInput, match=words):
        ph.tumble(**given)


@pytest.mark.parametrize("command", ["body", "report"])
def test_every_json_has_the_same_keys(command, capsys, tmp_path):
    (tmp_path / "box.toml").write_text(
        '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]\n'
        '[spin]\nangular_velocity = ["0.1 rad/s", "1 rad/s", "0 rad/s"]\n'
    )
    out = [] if command == "body" else ["--out", tmp_path / "out"]
    said = said_by(capsys, command, tmp_path / "box.toml", *out)
    assert KEYS | {"files"} <= said.keys()
