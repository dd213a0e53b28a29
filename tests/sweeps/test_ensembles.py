"""Answers about many samples at once are those of the report on each."""

import json

import numpy as np
import pytest

from polhode.kinds.free_body.ensemble import NUMBERS
from polhode.kinds.lagrange_top.ensemble import NUMBERS as TOP_NUMBERS
from polhode.sweeps.evaluation import Evaluator
from polhode.sweeps.plan import read_plan
from sweeping import first, only

TRIAXIAL = 'moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]'
SYMMETRIC = 'moments = ["2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]'
SPHERE = 'moments = ["2 g*cm^2", "2 g*cm^2", "2 g*cm^2"]'
SPHERICAL = '"spin.angular_velocity" = { sphere = { log-uniform = ["1 rpm", "100 rpm"] } }\n'
TILT = '"spin.tilt" = { grid = ["0 deg", "1 deg", "35 deg", "90 deg", "180 deg"] }\n'
PARTS = """parts = [{shape = "cylinder", mass = "30 g", radius = "3 mm", height = "60 mm"},
{shape = "box", mass = "10 g", size = ["9 mm", "7 mm", "5 mm"], at = ["20 mm", "3 mm", "0 mm"], axis = "x"}]"""
RATES = 'angular_velocity = ["1 rpm", "2 rpm", "3 rpm"]'
MOMENTS = """
"body.moments" = { von-mises-fisher = { mean = [1, 1, 1], concentration = 20, length = "3 g*cm^2" } }
"""
CROSSING = """
"body.moments.1" = { grid = ["0 kg*m^2", "1 g*cm^2", "2 g*cm^2", "2.5 g*cm^2", "2.9 g*cm^2", "4 g*cm^2"] }
"""
PLACES = """
"body.parts.2.at.1" = { normal = ["20 mm", "5 mm"] }
"spin.momentum.2" = { normal = ["2e-6 kg*m^2/s", "1e-7 kg*m^2/s"] }
"""
ABOUT = """
"spin.momentum" = { von-mises-fisher = { mean = [0, 1, 0], concentration = 9, length = "1e-6 kg*m^2/s" } }
"""
CASES = {
    "directions": (TRIAXIAL, "", SPHERICAL),
    "attitudes": (TRIAXIAL, RATES, '"spin.attitude" = { so3 = "uniform" }\n'),
    "symmetric": (SYMMETRIC, 'about = 1\nrate = "9 rpm"', TILT),
    "sphere": (SPHERE, 'about = 2\nrate = "9 rpm"', TILT),
    "about middle": (TRIAXIAL, 'about = 2\nrate = "9 rpm"', TILT),
    "about given": (PARTS, 'about = "x"\nrate = "9 rpm"', TILT),
    "rest": (TRIAXIAL, "about = 1", '"spin.rate" = { grid = ["0 rpm", "1 rpm", "1e250 rad/s", "1e-250 rad/s"] }\n'),
    "moments": (TRIAXIAL, f'{RATES}\nframe = "principal"', MOMENTS),
    "crossing": (TRIAXIAL, 'about = "y"\nrate = "9 rpm"\ntilt = "1 deg"', CROSSING),
    "parts": (PARTS, 'momentum = ["1e-6 kg*m^2/s", "2e-6 kg*m^2/s", "1e-7 kg*m^2/s"]', PLACES),
    "heat": (TRIAXIAL, "", '"spin.temperature" = { uniform = ["10 K", "300 K"] }\n'),
    "frame": (PARTS, 'frame = "principal"', ABOUT),
}  # fmt: skip


def evaluator(tmp_path, case, outputs, times=""):
    body, spin, inputs = CASES[case]
    path = tmp_path / "case.toml"
    draws = "" if "grid" in inputs else "samples = 12\n"
    path.write_text(f"[body]\n{body}\n[spin]\n{spin}\n[time]\nsamples = 5\n[sweep]\nseed = 5\n{draws}{times}\n"
                    f"outputs = {outputs}\n[sweep.inputs]\n{inputs}")  # fmt: skip
    return Evaluator(read_plan(path))


@pytest.mark.long_cases("directions", "parts", "heat")
@pytest.mark.parametrize("case", only(("directions", "about middle", "parts", "heat"), CASES))
def test_as_the_report_on_each(tmp_path, case):
    found = evaluator(tmp_path, case, [*NUMBERS, "states.attitude", "states.momentum", "states.angular_velocity"],
                      'times = ["0.5 s", "7 s"]')  # fmt: skip
    agree(found)


def agree(found):
    """Check that what is computed at once is what the reports say."""
    assert found.at_once
    count = found.plan.design.count
    together, each = found.chunk(0, count), Evaluator(found.plan)
    each.__dict__["_first"] = None
    each.__dict__["columns"] = found.columns
    alone = each.chunk(0, count)
    assert np.array_equal(together.values["sample_status"], alone.values["sample_status"])
    for column in found.columns:
        one, other = together.values[column.name], alone.values[column.name]
        assert np.array_equal(one, other, equal_nan=not column.text), column.name


def test_a_last_digit_is_noticed(tmp_path, monkeypatch):
    exact = NUMBERS["energy"]
    monkeypatch.setitem(NUMBERS, "energy", lambda bodies: np.nextafter(exact(bodies), np.inf))
    with pytest.raises(AssertionError, match="energy"):
        agree(evaluator(tmp_path, "about middle", ["regime", "energy"]))


def test_samples_do_not_depend_on_the_chunk_that_they_are_in(tmp_path):
    found = evaluator(tmp_path, "directions", [*NUMBERS, "states.attitude"], 'times = ["0.5 s", "7 s"]')
    whole, *parts = (found.chunk(low, high).values for low, high in ((0, 12), (0, 5), (5, 6), (6, 12)))
    for name, values in whole.items():
        assert np.concatenate([part[name] for part in parts]).tobytes() == np.asarray(values).tobytes(), name


LEANS = ('lean = "20 deg"', 'lean = "0 deg"', 'lean = "180 deg"')
STARTS = ('spin = "1500 rpm"\nprecession = "slow"', 'spin = "1500 rpm"', "precession = \"3 rad/s\"")


CASES_OF_TOPS = [*((LEANS[0], start) for start in STARTS), *((lean, STARTS[1]) for lean in LEANS)]


@pytest.mark.long
@pytest.mark.parametrize(("lean", "start"), first(3, CASES_OF_TOPS))
def test_tops_as_the_report_on_each(tmp_path, lean, start):
    names = json.dumps([*TOP_NUMBERS, "states.attitude", "states.momentum", "states.angular_velocity"])
    path = tmp_path / "top.toml"
    path.write_text(f"""
[body]
parts = [{{ shape = "disk", mass = "50 g", radius = "30 mm", at = ["0 mm", "0 mm", "40 mm"] }}]
[system]
kind = "lagrange-top"
pivot = ["0 mm", "0 mm", "0 mm"]
{lean}
[spin]
{start}
[time]
samples = 5
[sweep]
samples = 3
times = ["0.1 s", "5 s"]
outputs = {names}
[sweep.inputs]
"system.gravity" = {{ normal = ["9.8 m/s^2", "1 m/s^2"] }}
"body.parts.1.radius" = {{ grid = ["30 mm", "35 mm"] }}
""")
    agree(Evaluator(read_plan(path)))


STARTS_OF_TOPS = {
    "precession": ('lean = "20 deg"', 'spin = "1500 rpm"\nprecession = "slow"'),
    "nutation": ("", 'precession = "3 rad/s"\nnutation_rate = "1 rad/s"\nattitude = [0.9, 0.3, 0.1, 0.0]'),
    "velocity": ('lean = "20 deg"', 'angular_velocity = ["1 rad/s", "0 rad/s", "90 rad/s"]'),
}
VARIED_OF_TOPS = {
    "precession": """
"spin.spin" = { uniform = ["-50 rpm", "2000 rpm"] }
"system.lean" = { uniform = ["-10 deg", "60 deg"] }
""",
    "nutation": """
"spin.nutation_rate" = { grid = ["0 rad/s", "1 rad/s", "-2 rad/s"] }
"spin.attitude" = { so3 = "uniform" }
""",
    "velocity": '"spin.angular_velocity.3" = { normal = ["90 rad/s", "5 rad/s"] }',
}  # fmt: skip


def tops(tmp_path, kind, case, outputs, more=""):
    (lean, start), varied = STARTS_OF_TOPS[case], VARIED_OF_TOPS[case]
    path = tmp_path / "top.toml"
    path.write_text(f"""
[body]
parts = [{{ shape = "disk", mass = "50 g", radius = "30 mm", at = ["0 mm", "0 mm", "40 mm"] }}]
[system]
kind = "{kind}"
pivot = ["0 mm", "0 mm", "0 mm"]
{lean}
[spin]
{start}
[time]
until = "1 s"
samples = 200
[sweep]
samples = 6
outputs = {json.dumps(outputs)}
{more}
[sweep.inputs]
"system.gravity" = {{ normal = ["9.8 m/s^2", "4 m/s^2"] }}
{varied}
""")
    return Evaluator(read_plan(path))


@pytest.mark.parametrize("case", STARTS_OF_TOPS)
def test_tops_start_together_as_alone(tmp_path, monkeypatch, case):
    found, made = tops(tmp_path, "lagrange-top", case, list(TOP_NUMBERS)), []
    agree(found)
    make = Evaluator.make_spec
    monkeypatch.setattr(Evaluator, "make_spec", lambda *args: made.append(1) or make(*args))
    refused = (found.chunk(0, found.plan.design.count).values["sample_status"] == "refused").sum()
    assert len(made) <= refused  # specs of their own are read of refused samples alone


def test_what_is_not_known_at_once_takes_reports(tmp_path):
    found = evaluator(tmp_path, "directions", ["regime", "axes.1.exponents"])
    assert not found.at_once and found.chunk_size == 12
    assert found.chunk(0, 3).values["axes.1.exponents"].shape == (3, 2, 2)


def test_components_count_from_one(tmp_path):
    found = evaluator(tmp_path, "directions", ["angular_velocity", "angular_velocity.3", "axes.1.moment"])
    values = found.chunk(0, 12).values
    assert np.array_equal(values["angular_velocity.3"], values["angular_velocity"][:, 2])
    assert values["axes.1.moment"] == pytest.approx(1.2e-7)
    assert values["angular_velocity"] == pytest.approx(values["spin.angular_velocity"], rel=1e-15)


def test_refused_samples_say_why(tmp_path):
    chunk = evaluator(tmp_path, "crossing", ["regime", "energy"]).chunk(0, 6)
    status = chunk.values["sample_status"].tolist()
    assert status == ["refused", "done", "done", "done", "done", "done"]
    assert chunk.reasons[0][0] == 0 and "I1 + I2" in chunk.reasons[0][1]
    assert chunk.values["regime"][0] == "" and np.isnan(chunk.values["energy"][0])
