"""What a table [sweep] may say, and how each mistake is told."""

import re

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.spec.keys import Number, number_at, with_value
from polhode.spec.models import SystemTable
from polhode.sweeps.evaluation import Evaluator
from polhode.sweeps.plan import LIMITS, choose_chunk, read_plan
from polhode.sweeps.running import Sweep

HEAD = '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n[spin]\nabout = 2\nrate = "1 rpm"\n'
GOOD = 'samples = 9\noutputs = ["energy"]\n[sweep.inputs]\n"spin.tilt" = { uniform = ["0 deg", "9 deg"] }\n'


def plan(tmp_path, sweep, head=HEAD):
    path = tmp_path / "case.toml"
    path.write_text(f"{head}[sweep]\n{sweep}")
    return read_plan(path)


def test_keys_without_quotes_and_lengths(tmp_path):
    found = plan(tmp_path, GOOD.replace('"spin.tilt"', "spin.tilt"))
    assert list(found.design.inputs) == ["spin.tilt"] and found.units == {"spin.tilt": "rad"}
    nested = plan(tmp_path, GOOD.split("[sweep.inputs]")[0].replace("energy", "regime") + "[sweep.inputs]\n"
                  'spin.angular_velocity = { sphere = { uniform = ["1 rpm", "2 rpm"] } }\n')  # fmt: skip
    assert list(nested.design.inputs) == ["spin.angular_velocity"]


def test_the_base_spec_is_read_without_the_sweep(tmp_path):
    path = plan(tmp_path, GOOD).path
    assert read_spec(path).spin.rate == pytest.approx(2.0 * np.pi / 60.0)


@pytest.mark.parametrize(
    ("sweep", "words"),
    [
        (GOOD.replace("samples = 9\n", ""), "sweep.samples: is missing"),
        (GOOD.replace('uniform = ["0 deg", "9 deg"]', 'grid = ["1 deg", "2 deg"]'), "repeats each point of the grids"),
        (GOOD.replace('["0 deg", "9 deg"]', '{ from = "1 deg", to = "2 deg", count = 10000000000 }').replace(
            "uniform", "grid"), "a count from 2 to 1,000,000"),
        (GOOD.replace("samples", "sample"), "did you mean samples"),
        (GOOD.replace("9\n", "0\n", 1), "must be at least 1"),
        ('samples = 1\noutputs = ["energy"]\n', "say what varies"),
        (GOOD.replace('"spin.tilt"', '"spin.tlit"'), "has no tlit; did you mean tilt?"),
        (GOOD.replace('"spin.tilt"', '"spin"'), "must begin with body., spin., time. or system."),
        (GOOD.replace('"spin.tilt"', '"spin.about"'), "is not a number with a unit"),
        (GOOD.replace('"spin.tilt"', '"body.moments.4"'), "a place from 1 to 3"),
        (GOOD.replace("9 deg", "9 kg"), "wrong unit"),
        (GOOD.replace('["energy"]', "[]"), "at least one output"),
        (GOOD.replace('["energy"]', '["energy", "energy"]'), "names energy twice"),
        (GOOD.replace('["energy"]', '["spin.tilt"]'), "as an input too"),
        (GOOD.replace('["energy"]', '["states.attitude"]'), "states need times"),
        (GOOD.replace("samples", 'times = ["1 s"]\nsamples'), "goes with outputs such as"),
        (GOOD.replace("samples", 'points = "halton"\nsamples'), 'one of "random", "sobol"'),
        ("sensitivity = true\n" + GOOD.replace('uniform = ["0 deg", "9 deg"]', 'grid = ["1 deg"]'), "neither grids"),
        (GOOD.replace("samples", 'keep = "statistics"\nsensitivity = true\nsamples'), "needs all samples"),
        (GOOD + '"body.moments" = { sphere = "1 kg*m^2" }\n"body.moments.1" = { grid = ["1 kg*m^2"] }\n', "twice"),
        ('points = "sobol"\n' + GOOD.replace("samples = 9", "samples = 9000000000"), "at most 4.29e+09"),
    ],
)  # fmt: skip
def test_mistakes(tmp_path, sweep, words):
    with pytest.raises(InvalidInput, match=re.escape(words)):
        plan(tmp_path, sweep)


def test_all_mistakes_at_once(tmp_path):
    with pytest.raises(InvalidInput) as caught:
        plan(tmp_path, 'outputs = []\n[sweep.inputs]\n"spin.tlit" = 1\n"spin.rate" = { normal = ["1 rpm"] }\n')
    text = str(caught.value)
    assert "3 mistakes" in text or "4 mistakes" in text
    assert all(word in text for word in ("tlit", "standard deviation", "outputs"))


def test_specs_without_the_table(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(HEAD)
    with pytest.raises(InvalidInput, match=r"has no table \[sweep\]"):
        read_plan(path)
    path.write_text("sweep = 1\n" + HEAD)
    with pytest.raises(InvalidInput, match="must be a table"):
        read_plan(path)


@pytest.mark.parametrize(
    ("output", "words"),
    [
        ("enrgy", "did you mean energy?"),
        ("summary", "is a sentence"),
        ("axes", "is a table of answers; name one, like axes."),
        ("axes.4.verdict", "no answer"),
        ("states.spin", "the state has no part 'spin'; it has attitude, momentum, angular_velocity"),
    ],
)
def test_outputs_that_the_report_does_not_have(tmp_path, output, words):
    times = 'times = ["1 s"]\n' if output.startswith("states") else ""
    with pytest.raises(InvalidInput, match=re.escape(words)):
        _ = Evaluator(plan(tmp_path, times + GOOD.replace("energy", output))).columns


def test_sweeps_of_which_nothing_can_be_computed(tmp_path):
    with pytest.raises(InvalidInput, match=r"(?s)none of 9 samples tried can be computed; .*I1 \+ I2"):
        Sweep.of(plan(tmp_path, GOOD.replace('"spin.tilt"', '"body.moments.1"').replace(
            '"0 deg", "9 deg"', '"0.1 kg*m^2", "0.2 kg*m^2"')))  # fmt: skip


STEAM = """
[body]
moments = ["1e-47 kg*m^2", "1.9e-47 kg*m^2", "2.9e-47 kg*m^2"]
[spin]
temperature = "100 degC"
"""
HOT = 'samples = 400\noutputs = ["energy"]\n[sweep.inputs]\n"spin.temperature" = { normal = [MEAN] }\n'


def test_a_deviation_in_celsius_is_a_difference(tmp_path):
    found = {}
    for mean in ('"100 degC", "5 degC"', '"373.15 K", "5 K"'):
        design = plan(tmp_path, HOT.replace("MEAN", mean), STEAM).design
        found[mean] = design.values(0, 400)["spin.temperature"]
    first, second = found.values()
    assert first == pytest.approx(second, rel=1e-12) and 4.0 < np.std(first) < 6.0


def test_impossible_temperatures_are_marked_and_the_others_as_without_them(tmp_path):
    made = Sweep.of(plan(tmp_path, HOT.replace("MEAN", '"373 K", "200 K"'), STEAM))
    assert made.evaluator.at_once
    chunk = made.evaluator.chunk(0, 400)
    cold = chunk.values["spin.temperature"] <= 0.0
    assert 5 < cold.sum() < 40
    assert (np.asarray(chunk.values["sample_status"]) == "refused").tolist() == cold.tolist()
    assert np.isnan(chunk.values["energy"]).tolist() == cold.tolist()
    warm = np.flatnonzero(~cold)[:5]
    Boltzmann = 1.380649e-23
    assert chunk.values["energy"][warm] == pytest.approx(1.5 * Boltzmann * chunk.values["spin.temperature"][warm])
    assert "temperature" in chunk.reasons[0][1]


def test_a_grid_may_begin_where_no_body_is(tmp_path):
    text = GOOD.replace("samples = 9\n", "").replace('"spin.tilt" = { uniform = ["0 deg", "9 deg"] }', (
        '"body.moments.1" = { grid = { from = "1e-9 kg*m^2", to = "1.2 kg*m^2", count = 60 } }'))  # fmt: skip
    sweep = Sweep.of(plan(tmp_path, text))
    status = sweep.evaluator.chunk(0, 60).values["sample_status"]
    assert {"done", "refused"} == set(status.tolist())


def test_yes_and_no_are_words(tmp_path):
    from polhode.sweeps.columns import Column, answer_column, fit_to_column

    column = answer_column("certain", {"certain": True}, {})
    assert column == Column("certain", text=True)
    assert [fit_to_column(column, value) for value in (True, False)] == ["yes", "no"]


TOP = """
[body]
parts = [{ shape = "disk", mass = "50 g", radius = "30 mm", at = ["0 mm", "0 mm", "40 mm"] }]
[system]
kind = "lagrange-top"
pivot = ["0 mm", "0 mm", "0 mm"]
lean = "20 deg"
[spin]
spin = "1500 rpm"
precession = "slow"
[time]
samples = 9
"""
STARTS = """
samples = 6
outputs = ["energy", "start_tilt", "states.attitude"]
times = ["0.1 s"]
[sweep.inputs]
"spin.spin" = { grid = ["2 rpm", "1500 rpm"] }
"system.gravity" = { normal = ["9.8 m/s^2", "1 m/s^2"] }
"""


@pytest.mark.long
def test_what_a_kind_cannot_do_at_once_is_computed_one_by_one(tmp_path):
    """A top's answers and states, some of its starts refused: those are the numbers of its own report."""
    found = Evaluator(plan(tmp_path, STARTS, TOP))
    assert not found.at_once and found.plan.design.count == 12
    chunk = found.chunk(0, 12)
    assert chunk.values["sample_status"].tolist() == ["refused"] * 6 + ["done"] * 6
    assert "precession" in chunk.reasons[0][1]
    spec = found.make_spec(found.draw_inputs(0, 12), 8)
    assert chunk.values["energy"][8] == spec.report().as_json_dict()["energy"]
    assert chunk.values["states.attitude"].shape == (12, 1, 4)
    assert spec.system.gravity == chunk.values["system.gravity"][8]


def test_keys_of_every_form():
    assert number_at("body.parts.3.at.2", SystemTable) == Number("m")
    assert number_at("spin.attitude", SystemTable) == Number("", 4)
    assert number_at("body.inertia.1.2", SystemTable) == Number("kg*m^2")
    tables = {"body": {"moments": ["1", "2", "3"]}, "system": "heavy-top"}
    changed = with_value(with_value(tables, "body.moments.2", 5), "system.gravity", 6)
    assert changed == {"body": {"moments": ["1", 5, "3"]}, "system": {"kind": "heavy-top", "gravity": 6}}
    assert tables == {"body": {"moments": ["1", "2", "3"]}, "system": "heavy-top"}
    with pytest.raises(ValueError, match="place 4 of a list of 3"):
        with_value(tables, "body.moments.4", 5)
    with pytest.raises(ValueError, match="has no list or table at 'part'"):
        with_value(tables, "body.parts.1.mass", 5)


def test_rotational_constants_may_be_wave_numbers(tmp_path):
    head = '[body]\nrotational_constants = ["27.8806 1/cm", "14.5216 1/cm", "9.2778 1/cm"]\nallow_vibration = true\n'
    text = GOOD.replace('"spin.tilt" = { uniform = ["0 deg", "9 deg"] }', (
        '"body.rotational_constants.1" = { normal = ["27.8806 1/cm", "0.1 1/cm"] }'))  # fmt: skip
    found = plan(tmp_path, text, head + '[spin]\ntemperature = "300 K"\n').design.values(0, 9)
    values = found["body.rotational_constants.1"] / 29979.2458e6
    assert values == pytest.approx(27.8806 * np.ones(9), abs=0.4) and np.std(values) > 0.02


def test_progress_is_told_in_lines_where_nobody_watches(monkeypatch, capsys):
    from polhode.sweeps import command as sweep

    monkeypatch.setattr(sweep._Lines, "interval", 0.0)
    lines = sweep._Lines(100, 1000)
    lines.add(300)
    lines.add(600)
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 1 and told[0].startswith("400 of 1,000 samples, ") and told[0].endswith(" left")


@pytest.mark.parametrize(("at_once", "by_steps", "least", "most"), [
    (True, False, 65536, 2**20), (True, True, 1024, 2**14), (False, False, 64, 1024),
])  # fmt: skip
def test_chunks_double_where_they_would_be_too_many(at_once, by_steps, least, most):
    full = least * LIMITS.many_chunks
    assert choose_chunk(12, at_once, by_steps) == 12
    assert choose_chunk(full, at_once, by_steps) == least and choose_chunk(full + 1, at_once, by_steps) == 2 * least
    for samples in (10**5, 10**7, full + 1, 7 * full, 10**9):
        chunk = choose_chunk(samples, at_once, by_steps)
        assert chunk == most or samples / chunk <= LIMITS.many_chunks
        assert chunk == least or samples / (chunk / 2) > LIMITS.many_chunks
    assert choose_chunk(10**10, at_once, by_steps) == most
