"""What a refusal says of a file is true of it, and the file is read once its remedy is followed."""

import re

import numpy as np
import pytest

from polhode.bodies.atoms import ATOMIC_MASS_UNIT, atomic_masses
from polhode.bodies.body import Body
from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput
from polhode.formats.molecule import read_molecule
from polhode.kinds.reading import read_spec
from polhode.spacecraft.formats.adm_state import read_apm
from polhode.spacecraft.formats.mjcf import read_mjcf_inertial
from polhode.spacecraft.formats.sdf import read_sdf_inertial, read_sdf_robot
from polhode.spacecraft.formats.urdf import read_urdf_inertial
from spacecraft.test_attitude_messages import RATES, TURN, apm, saved

DEUTERIUM = 2.01410177812  # u, NIST
INERTIA = "INERTIA_START\nINERTIA_REF_FRAME = {}\nIXX = 2\nIYY = 3\nIZZ = 4\nINERTIA_STOP\n"


def refusal_of(act, *given):
    with pytest.raises((FormatError, InvalidInput)) as caught:
        act(*given)
    return str(caught.value)


# ---------------------------------------------------------------- CCSDS messages


def told_by(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        main(list(words))
    said = capsys.readouterr()
    return ended.value.code, re.sub(r"\s+", " ", said.err + said.out)


def test_an_inertia_along_other_axes_is_not_called_missing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    saved(tmp_path, apm() + INERTIA.format("IMU_FRAME_1"), "sat.apm")
    code, said = told_by(capsys, "import", "sat.apm", "--out", "sat.toml")
    assert code == 2 and "no such inertia (the inertia is left out, as it is along IMU_FRAME_1," in said
    assert "has no inertia" not in said
    assert told_by(capsys, "import", "sat.apm", "--out", "sat.nc")[0] == 0
    saved(tmp_path, '[body]\nmoments = ["2 kg*m^2", "3 kg*m^2", "4 kg*m^2"]\n', "body.toml")
    assert told_by(capsys, "import", "sat.apm", "--spec", "body.toml", "--out", "sat.toml")[0] == 0
    report = read_spec(tmp_path / "sat.toml").report()
    assert np.asarray(report.trajectory.motion.moments) == pytest.approx([2.0, 3.0, 4.0])


def test_attitudes_between_other_frames_do_not_differ(tmp_path):
    """The second is relative to another frame, so that no angle between the two says anything."""
    lines = apm().split("QUAT_START\n")[1].split("QUAT_STOP")[0]
    for name, again in (("EME2000", "LVLH"), ("SC_BODY_1", "SC_BODY_2")):
        second = re.sub("Q1 = .*", "Q1 = 0.0", re.sub("Q2 = .*", "Q2 = 0.0", lines.replace(name, again)))
        second = re.sub("Q3 = .*", "Q3 = 0.0", re.sub("QC = .*", "QC = 1.0", second))
        found = read_apm(saved(tmp_path, apm().replace("ANGVEL_START", f"QUAT_START\n{second}QUAT_STOP\nANGVEL_START")))
        assert "attitudes between other frames too" in found.outcome.message and again in found.outcome.message
        assert "differ" not in found.outcome.message
    turned = re.sub("QC = .*", "QC = 1.0", re.sub("Q([123]) = .*", r"Q\1 = 0.0", lines))
    found = read_apm(saved(tmp_path, apm().replace("ANGVEL_START", f"QUAT_START\n{turned}QUAT_STOP\nANGVEL_START")))
    assert f"its attitudes differ by {TURN.magnitude():.3g} rad" in found.outcome.message


def test_rates_of_another_body_are_not_taken_for_this_one(tmp_path):
    head, tail = apm("SC_BODY_2").split("ANGVEL_START")
    text = f"{head}ANGVEL_START{tail.replace('SC_BODY_1', 'SC_BODY_2')}"
    assert "REF_FRAME_B must be that of the attitude, SC_BODY_1," in refusal_of(read_apm, saved(tmp_path, text))
    found = read_apm(saved(tmp_path, text.replace("SC_BODY_2", "SC_BODY_1")))
    assert found.angular_velocity[0] == pytest.approx(np.radians(RATES), abs=1e-15)


def test_rates_against_another_frame_than_the_attitude_are_said(tmp_path):
    assert read_apm(saved(tmp_path, apm())).outcome.message == ""
    found = read_apm(saved(tmp_path, apm(rated_against="LVLH")))
    assert "its angular velocity is relative to LVLH, and the attitude to EME2000" in found.outcome.message


# ---------------------------------------------------------------- robots

BOX = '<collision name="c"><density>2700</density><geometry><box><size>1 2 3</size></box></geometry></collision>'
MOMENTS = np.array([5.0, 10.0, 13.0]) / 12.0 * 16200.0
"""Of the box: m (b² + c²)/12, and m = 2700 · 6 kg."""


def sdf(inertial):
    return f'<sdf version="1.11"><model name="m"><link name="a">{inertial}{BOX}</link></model></sdf>'


ONE = "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>"


@pytest.mark.parametrize("inertial", ['<inertial auto="true"/>', f'<inertial auto="1"><mass>1</mass>{ONE}</inertial>'])
@pytest.mark.parametrize("read", [read_sdf_inertial, lambda path: read_sdf_robot(path, {})])
def test_gazebo_computes_an_automatic_inertia_and_the_remedies_give_it(tmp_path, inertial, read):
    said = refusal_of(read, saved(tmp_path, sdf(inertial), "a.sdf"))
    assert "computes mass and inertia from its collisions" in said and "1 kg" not in said
    xx, yy, zz = MOMENTS[::-1].tolist()
    entries = f"<ixx>{xx}</ixx><iyy>{yy}</iyy><izz>{zz}</izz>"
    written = f"<inertial><mass>16200</mass><inertia>{entries}</inertia></inertial>"
    assert read(saved(tmp_path, sdf(written), "b.sdf")).principal_moments == pytest.approx(MOMENTS)
    parts = '[[body.part]]\nshape = "box"\nsize = ["1 m", "2 m", "3 m"]\ndensity = "2700 kg/m^3"\n'
    assert read_spec(saved(tmp_path, parts, "parts.toml")).body.principal_moments == pytest.approx(MOMENTS)


@pytest.mark.parametrize(("inertial", "said"), [
    ("", "has no <inertial>, for which SDF puts 1 kg and 1 kg m² about each axis"),
    (f"<inertial>{ONE}</inertial>", "no <mass>, for which SDF puts 1 kg."),
    ("<inertial><mass>2</mass></inertial>", "has no <inertia>, for which SDF puts 1 kg m² about each axis."),
])  # fmt: skip
def test_what_is_missing_in_a_link_is_named(tmp_path, inertial, said):
    assert said in refusal_of(read_sdf_inertial, saved(tmp_path, sdf(inertial), "a.sdf"))


def test_a_zero_inertia_is_not_called_missing(tmp_path):
    """Each of these has an inertia: it is zero."""
    zero = 'ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"'
    urdf = f'<robot name="r"><link name="a"><inertial><mass value="1"/><inertia {zero}/></inertial></link></robot>'
    tags = "".join(f"<{name}>0</{name}>" for name in ("ixx", "iyy", "izz"))
    inertial = '<inertial mass="1" pos="0 0 0" diaginertia="0 0 0"/>'
    mjcf = f'<mujoco><worldbody><body name="a">{inertial}</body></worldbody></mujoco>'
    files = ((read_urdf_inertial, urdf, "a.urdf"), (read_mjcf_inertial, mjcf, "a.xml"),
             (read_sdf_inertial, sdf(f"<inertial><mass>1</mass><inertia>{tags}</inertia></inertial>"), "a.sdf"))
    for read, text, name in files:
        said = refusal_of(read, saved(tmp_path, text, name))
        assert "its inertia is zero, and a point has no attitude. Give its " in said


# ---------------------------------------------------------------- parts


def test_a_hole_in_a_flat_disc(tmp_path):
    """A disc of 1 kg and radius 1 m, less one of ¼ kg and ½ m at x = ½ m, by hand: its centre is at −1/6 m."""
    text = """[[body.part]]
shape = "disk"
radius = "1 m"
mass = "1 kg"
[[body.part]]
shape = "disk"
radius = "0.5 m"
at = ["0.5 m", "0 m", "0 m"]
cut = true
"""
    assert "mass is missing" in refusal_of(read_spec, saved(tmp_path, text, "hole.toml"))
    body = read_spec(saved(tmp_path, f'{text}mass = "0.25 kg"\n', "hole.toml")).body
    across = 0.25 - 0.25 * 0.25**2
    about_y = 0.25 - 0.25 * (0.25**2 + 0.25) - 0.75 / 36.0
    assert body.mass == 0.75 and body.center_of_mass == pytest.approx([-1.0 / 6.0, 0.0, 0.0])
    assert body.principal_moments == pytest.approx([about_y, across, about_y + across], rel=1e-14)


# ---------------------------------------------------------------- atoms

WATER = "3\n{}\nO 0 0 0{}\n{} 0 0.76 0.59{}\nH 0 -0.76 0.59{}\n"


@pytest.mark.parametrize("symbol", ["D", "d", "T"])
def test_heavy_hydrogen_is_written_with_its_mass(tmp_path, symbol):
    said = refusal_of(read_molecule, saved(tmp_path, WATER.format("", "", symbol, "", ""), "a.xyz"))
    mass = re.search(r"hydrogen of ([\d.]+) u: write H, with this mass", said)[1]
    columns = re.search(r"Properties=\S*R:1", said)[0]
    assert float(mass) == {"D": DEUTERIUM, "T": 3.0160492779}[symbol.upper()]
    text = WATER.format(columns, " 15.995", "H", f" {mass}", " 1.008")
    symbols, _, masses = read_molecule(saved(tmp_path, text, "b.xyz"))
    assert symbols == ["O", "H", "H"] and masses / ATOMIC_MASS_UNIT == pytest.approx([15.995, float(mass), 1.008])


WORDS = {"1": "H", "8": "O", "H2": "H", "C13": "C", "Fe_2": "Fe", "13C": "C", "H5'": "H", "HW1": "H", "Cl-": "Cl"}


@pytest.mark.parametrize(("word", "symbol"), WORDS.items())
def test_numbers_labels_and_isotopes_are_named_for_what_they_are(tmp_path, word, symbol):
    said = refusal_of(read_molecule, saved(tmp_path, WATER.format("", "", word, "", ""), "a.xyz")).split("a.xyz")[1]
    if word.isdecimal():
        assert f"{word} is the atomic number of {symbol}: write the symbol." in said and "mass" not in said
    else:
        assert f"Write {symbol}" in said and "with its mass for an isotope" in said
        assert ("label" in said) == (not word[0].isdecimal())
    assert read_molecule(saved(tmp_path, WATER.format("", "", symbol, "", ""), "b.xyz"))[0][1] == symbol


@pytest.mark.parametrize("word", ["Xx", "119", "0", "Q"])
def test_of_other_words_nothing_is_claimed(tmp_path, word):
    said = refusal_of(read_molecule, saved(tmp_path, WATER.format("", "", word, "", ""), "a.xyz"))
    assert said.endswith("is not a chemical element. Write symbols like C, and leave out what is no atom.")


def test_the_library_says_the_same():
    places = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1e-10]])
    assert "D is hydrogen of 2.01410177812 u" in refusal_of(Body.from_atoms, ["D", "H"], places)
    assert "8 is the atomic number of O" in refusal_of(atomic_masses, ["8"])
    masses = np.array([DEUTERIUM, 1.00782503223]) * ATOMIC_MASS_UNIT
    assert Body.from_atoms(["D", "H"], places, masses).mass == pytest.approx(masses.sum())
