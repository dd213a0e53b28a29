"""Reports of tops against the exact motion made by hand, and what a spec of one may not say."""

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec

CONE = 'parts = [{shape = "cone", mass = "60 g", radius = "3 cm", height = "4 cm", at = ["0 m", "0 m", "3 cm"]}]'
BOX = 'parts = [{shape = "box", mass = "1 kg", size = ["1 m", "2 m", "3 m"], at = ["0.5 m", "1 m", "1.5 m"]}]'
PIVOT = 'pivot = ["0 m", "0 m", "0 m"]'


@pytest.fixture
def read(tmp_path):
    def reader(body, system, rest=""):
        path = tmp_path / "case.toml"
        path.write_text(f"{'' if '[' in system else system}\n[body]\n{body}\n{system if '[' in system else ''}\n{rest}")
        return read_spec(path)

    return reader


def lagrange(extra=""):
    return f'[system]\nkind = "lagrange-top"\n{PIVOT}\n{extra}'


def test_the_cone_is_lagranges_top(read):
    spec = read(CONE, lagrange('lean = "30 deg"'), '[spin]\nrate = "200 rad/s"\nabout = "z"')
    values = spec.report().as_json_dict()
    m, r, h, d = 0.06, 0.03, 0.04, 0.03
    I3 = 0.3 * m * r * r
    I1 = 0.15 * m * (r * r + h * h / 4) + m * d * d
    half = np.radians(15.0)
    top = ph.LagrangeMotion(
        (I1, I1, I3), mgl=m * 9.80665 * d, momentum=(0, 0, I3 * 200.0), attitude=(np.cos(half), np.sin(half), 0, 0)
    )
    assert values["regime"] == "cusp"
    for key in ("nutation_period", "precession_per_period", "spin_per_period", "energy"):
        assert values[key] == pytest.approx(getattr(top, key), rel=1e-12)
    slow, fast = values["steady_precession"]["slow"], values["steady_precession"]["fast"]
    for precession in (slow, fast):
        left = I1 * np.cos(2 * half) * precession**2 - I3 * 200.0 * precession + m * 9.80665 * d
        assert abs(left) < 1e-12 * I3 * 200.0 * precession


@pytest.mark.sweep
def test_heavy_and_lagrange_agree_and_name_the_case(read):
    spin = '[spin]\nangular_velocity = ["1 rad/s", "0 rad/s", "90 rad/s"]\n[time]\nuntil = "0.5 s"\nsamples = 11'
    exact = read(CONE, lagrange('lean = "30 deg"'), spin).report()
    split = read(CONE, f'[system]\nkind = "heavy-top"\norder = 6\nlean = "30 deg"\n{PIVOT}', spin).report()
    assert split.values()["integrable_case"] == "Lagrange"
    assert np.abs(exact.axis_in_space - split.axis_in_space).max() < 1e-9
    assert exact.values()["tilt"]["largest"] == pytest.approx(split.values()["tilt"]["largest"], abs=1e-9)


def test_verdicts_flip_at_the_threshold(read):
    I1, I3, mgl = 0.15 * 0.06 * (9e-4 + 4e-4) + 0.06 * 9e-4, 0.3 * 0.06 * 9e-4, 0.06 * 9.80665 * 0.03
    edge = 2 * np.sqrt(I1 * mgl) / I3
    for factor, word in ((1.001, "stable"), (0.999, "unstable")):
        spec = read(CONE, lagrange(), f'[spin]\nrate = "{factor * edge:.12f} rad/s"\nabout = "z"')
        report = spec.report()
        upright = next(found for name, found in report.verdicts.items() if name.startswith("upright"))
        assert (upright.verdict == word and "Π·χ" in upright.certificate) or word == "unstable"


@pytest.mark.sweep
def test_a_pivot_at_the_centre_of_mass_is_said(read):
    at_centre = '[system]\nkind = "heavy-top"\npivot = ["0.5 m", "1 m", "1.5 m"]'
    report = read(BOX, at_centre, '[spin]\nrate = "1 rad/s"\nabout = 2\n[time]\nuntil = "1 s"\nsamples = 3').report()
    assert "the body is free" in report.notes[0] and float(report.top.mgl) == 0.0


@pytest.mark.parametrize(
    ("body", "system", "rest", "words"),
    [
        (BOX, lagrange(), "", ["not symmetric about the line from pivot", 'kind = "heavy-top"']),
    ],
)
def test_bodies_that_are_no_such_top(read, body, system, rest, words):
    spec = read(body, system, rest)
    with pytest.raises(InvalidInput) as caught:
        spec.report()
    assert all(word in str(caught.value) for word in words)


@pytest.mark.parametrize(
    ("system", "rest", "words"),
    [
        ('system = "spinning-top"', "", ["system.kind: must be one of", "got 'spinning-top'"]),
        ("system = 3", "", ["system: must be a table, or one of its kinds"]),
        ("[system]\npivto = 3", "", ["system.kind: must be one of", "it is missing"]),
        ('[system]\nkind = "heavy-top"\npivto = 3', "", ["system.pivto: unknown key; did you mean pivot?",
                                                         "system.pivot: is missing"]),
        ('[system]\nkind = "heavy-top"\norder = 3\npivot = ["1 kg", "0 m", "0 m"]', "",
         ["system.order: must be one of 2, 4, 6", "system.pivot.1: has the wrong unit"]),
        (lagrange('lean = "3 deg"\ngravity = "-9.81 m/s^2"'), "[spin]\nattitude = [1.0, 0.0, 0.0, 0.0]",
         ["system.lean: goes without spin.attitude", "system.gravity: must be positive"]),
    ],
)  # fmt: skip
def test_specs_that_say_it_wrong(read, system, rest, words):
    with pytest.raises(InvalidInput) as caught:
        read(CONE, system, rest)
    assert not [word for word in words if word not in str(caught.value)], str(caught.value)


def test_moments_without_mass_have_no_weight(read):
    with pytest.raises(InvalidInput) as caught:
        read('moments = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]', lagrange("foo = 3"), '[spin]\nrate = "1 rpm"')
    for words in ("3 mistakes", "needs mass", "system.foo: unknown key", "rate needs about"):
        assert words in str(caught.value)


@pytest.mark.long
def test_a_run_too_long_is_refused_before_it_starts(read):
    long = '[spin]\nrate = "9 rad/s"\nabout = "z"\n[time]\nuntil = "1e12 s"'
    spec = read(CONE, f'[system]\nkind = "heavy-top"\n{PIVOT}', long)
    with pytest.raises(InvalidInput, match=r"would take .* steps"):
        spec.report()


@pytest.mark.parametrize(
    ("lean", "spin", "regime"), [("180 deg", 5, "hanging"), ("0 deg", 1, "sleeping"), ("90 deg", 0, "planar")]
)
def test_whole_quarter_leans_are_exact(read, lean, spin, regime):
    report = read(CONE, lagrange(f'lean = "{lean}"'), f'[spin]\nrate = "{spin} rad/s"\nabout = "z"').report()
    values = report.as_json_dict()
    assert values["regime"] == regime and ("too slowly" in values["summary"]) == (regime == "sleeping")
    if regime == "planar":
        assert values["precession_rate"] is None and values["steady_precession"] is None


def test_moments_that_are_equal_but_for_rounding(read):
    """At this pivot 0.832 + 1.7 · 0.2² is an ulp above 0.9: the top is spherical there."""
    body = 'mass = "1.7 kg"\nmoments = ["0.8320000000000001 kg*m^2", "0.8320000000000001 kg*m^2", "0.9 kg*m^2"]'
    system = '[system]\nkind = "lagrange-top"\npivot = ["0 m", "0 m", "-0.2 m"]\nlean = "30 deg"'
    found = read(body, system, '[spin]\nrate = "9 rad/s"\nabout = "z"\n[time]\nuntil = "1 s"\nsamples = 5').report()
    assert np.ptp(found.exact.moments) == 0.0 and found.exact.moments[0] == pytest.approx(0.9, rel=1e-15)


TOLD = '[spin]\nspin = "40 rev/s"\nprecession = "{}"\n[time]\nuntil = "0.2 s"\nsamples = 50'


@pytest.mark.long_cases("slow")
@pytest.mark.parametrize("which", ["slow", "fast"])
def test_steady_precession_is_steady(read, which):
    """To rounding of the exact motion, and as well as splitting follows it."""
    exact = read(CONE, lagrange('lean = "30 deg"'), TOLD.format(which)).report()
    assert exact.constant_tilt and np.abs(exact.tilt - np.radians(30.0)).max() < 1e-14
    values = exact.as_json_dict()
    assert values["spin_rate"] == pytest.approx(80.0 * np.pi, rel=1e-12)
    assert values["precession_rate"] == pytest.approx(values["steady_precession"][which], rel=1e-12)
    system = f'[system]\nkind = "heavy-top"\nlean = "30 deg"\n{PIVOT}'
    split = read(CONE, system, TOLD.format(which).replace("0.2 s", "0.01 s")).report()
    assert np.abs(split.tilt - np.radians(30.0)).max() < 1e-9


def test_a_top_let_go_halts_in_cusps_and_one_that_is_pushed_does_not(read):
    regimes = {'spin = "30 rev/s"': "cusp", 'spin = "30 rev/s"\nprecession = "-2 rad/s"': "loop"}
    for spin, regime in regimes.items():
        assert read(CONE, lagrange('lean = "30 deg"'), f"[spin]\n{spin}").report().values()["regime"] == regime


def test_the_start_has_the_rates_that_are_given(read):
    spin = '[spin]\nspin = "9 rad/s"\nprecession = "0.5 rad/s"\nnutation_rate = "0.2 rad/s"\n'
    short = '[time]\nuntil = "1e-6 s"\nsamples = 3'
    report = read(BOX, f'[system]\nkind = "heavy-top"\nlean = "40 deg"\n{PIVOT}', spin + short).report()
    axis, tilt, times = report.axis_in_space, report.tilt, report.trajectory.times
    azimuth = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
    assert np.diff(azimuth[[0, 2]]) / times[2] == pytest.approx(0.5, rel=1e-4)
    assert np.diff(tilt[[0, 2]]) / times[2] == pytest.approx(0.2, rel=1e-4)
    along = np.asarray(report.trajectory.angular_velocity)[0] @ np.asarray(report.top.axis)
    assert along == pytest.approx(9.0 + 0.5 * np.cos(np.radians(40.0)), rel=1e-14)


@pytest.mark.parametrize(
    ("spin", "words"),
    [
        ('spin = "1 rev/s"\nprecession = "slow"', "the least spin is"),
        ('spin = "40 rev/s"\nprecession = "steady"', "which of the two steady precessions"),
        ('spin = "40 rev/s"\nprecession = "3 kg"', 'or "slow" or "fast"'),
        ('spin = "40 rev/s"\nprecession = "slow"\nnutation_rate = "1 rpm"', "keeps the tilt"),
        ('spin = "40 rev/s"\nframe = "given"', "frame goes with the components"),
        ('spin = "40 rev/s"\nabout = "z"', "about and tilt go with rate, not with spin"),
        ('spin = "40 rev/s"\nrate = "1 rpm"\nabout = "z"', "or of a top spin, precession and nutation_rate together"),
        ('spin = "1e200 rad/s"', "must give an energy below"),
    ],
)
def test_spins_of_tops_that_say_it_wrong(read, spin, words):
    with pytest.raises(InvalidInput, match=words):
        read(CONE, lagrange('lean = "30 deg"'), f"[spin]\n{spin}").report()


def test_a_level_axis_has_one_steady_precession(read):
    values = read(CONE, lagrange('lean = "90 deg"'), TOLD.format("slow")).report().as_json_dict()
    mgl, I3 = 0.06 * 9.80665 * 0.03, 0.3 * 0.06 * 9e-4
    assert values["precession_rate"] == pytest.approx(mgl / (I3 * 80.0 * np.pi), rel=1e-12)
    with pytest.raises(InvalidInput, match="one steady precession alone"):
        read(CONE, lagrange('lean = "90 deg"'), TOLD.format("fast")).report()


@pytest.mark.long
def test_a_level_gyroscope_goes_round_in_the_known_time_and_in_no_other(read):
    """A disk of 170 g and 5.5 cm on a stand 10.5 cm from it, at 45 turns a second: T = 2π ½ m R² ψ̇/(m g l) = 2.60950 s.

    cos 90° is 6e-17 in numbers, by which a second, "fast" precession of 1.28e17 rad/s was listed.
    """
    disk = 'parts = [{shape = "disk", mass = "170 g", radius = "5.5 cm", at = ["0 m", "0 m", "10.5 cm"]}]'
    for lean in ("90 deg", "1.5707963267948966 rad", "0.25 rev"):
        values = read(disk, lagrange(f'lean = "{lean}"'), '[spin]\nspin = "45 rev/s"\nprecession = "slow"').report()
        values = values.as_json_dict()
        exact = 2 * np.pi * 0.5 * 0.055**2 * 90 * np.pi / (9.80665 * 0.105)
        assert 2 * np.pi / values["precession_rate"] == pytest.approx(exact, rel=1e-12) and abs(exact - 2.60950) < 1e-5
        assert values["steady_precession"]["fast"] is None
        assert values["steady_precession"]["slow"] == pytest.approx(values["precession_rate"], rel=1e-12)
    tilted = read(disk, lagrange('lean = "89.9 deg"'), '[spin]\nspin = "45 rev/s"\nprecession = "slow"').report()
    assert 1e4 < tilted.as_json_dict()["steady_precession"]["fast"] < 1e5  # p/(I1 cos θ), and real


ROTOR = """
[system]
kind = "gyrostat"
rotor_axis = [0.0, 0.0, 1.0]
rotor_moment = "0.02 kg*m^2"
rotor_rate = "3000 rpm"
"""


def test_other_bodies_have_no_vertical(read):
    with pytest.raises(InvalidInput, match="spin gives the rates of a top's Euler angles, which the system gyrostat"):
        read('moments = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]', ROTOR, '[spin]\nspin = "1 rpm"')
