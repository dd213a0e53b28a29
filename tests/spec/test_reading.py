"""Specs read into bodies and spins, against values made by hand."""

import numpy as np
import pytest

import polhode as ph
from polhode.errors import FormatError, InvalidInput
from polhode.kinds.reading import read_spec

EXACT = 1e-14
MOMENTS = 'moments = ["3 kg*m^2", "1 kg*m^2", "2.5 kg*m^2"]'


@pytest.fixture
def read(tmp_path):
    def reader(body, rest=""):
        path = tmp_path / "case.toml"
        path.write_text(f"[body]\n{body}\n{rest}", "utf-8")
        return read_spec(path)

    return reader


def momentum(spec):
    return spec.start(spec.body.principal_moments, spec.body.principal_axes)[0]


def attitude(spec):
    return spec.start(spec.body.principal_moments, spec.body.principal_axes)[1]


def space_momentum(spec):
    return ph.rotation.rotate(attitude(spec), momentum(spec))


def test_no_spin_is_rest_and_the_name_is_the_file(read):
    spec = read(MOMENTS)
    assert spec.name == "case" and not momentum(spec).any() and spec.until is None
    assert spec.body.principal_moments.tolist() == [1.0, 2.5, 3.0]


def test_components_along_given_and_principal_axes(read):
    given = read(MOMENTS, '[spin]\nangular_velocity = ["1 rad/s", "2 rad/s", "3 rad/s"]')
    assert space_momentum(given) == pytest.approx([3.0, 2.0, 7.5], rel=EXACT)
    principal = read(MOMENTS, '[spin]\nframe = "principal"\nmomentum = ["1 J*s", "2 J*s", "3 J*s"]')
    assert momentum(principal).tolist() == [1.0, 2.0, 3.0]
    # the body's y is its first principal axis, z the second, x the third
    assert space_momentum(principal) == pytest.approx([3.0, 1.0, 2.0], rel=EXACT)


@pytest.mark.parametrize(("about", "wanted"), [("2", (0, 0.6, 0.8)), ('"x"', (0.6, 0.8, 0)), ('"z"', (0.8, 0, 0.6))])
def test_rate_about_an_axis_tilted_towards_the_next(read, about, wanted):
    tilt = np.degrees(np.arctan2(0.8, 0.6))
    spec = read(MOMENTS, f'[spin]\nrate = "2 rad/s"\nabout = {about}\ntilt = "{tilt:.17g} deg"')
    velocity = momentum(spec) / spec.body.principal_moments
    if about != "2":
        velocity = spec.body.principal_axes @ velocity
    assert velocity == pytest.approx(2.0 * np.array(wanted), abs=1e-14)


def test_attitude_is_of_the_given_axes(read):
    turn = np.array([0.5, 0.5, 0.5, 0.5])  # x → y → z → x
    spec = read(MOMENTS, f'[spin]\nattitude = {turn.tolist()}\nangular_velocity = ["1 rad/s", "0 rpm", "0 rpm"]')
    assert space_momentum(spec) == pytest.approx([0.0, 3.0, 0.0], abs=1e-14)


def test_parts_are_turned_and_placed(read):
    spec = read("""
    parts = [
      {shape = "cylinder", mass = "2 kg", radius = "1 m", height = "3 m", axis = "x"},
      {shape = "box", mass = "1 kg", size = ["1 m", "2 m", "3 m"], at = ["0 m", "0 m", "4 m"], axis = "y"},
    ]""")
    turned = ph.shapes.box(1.0, (2.0, 3.0, 1.0)).placed((1.0, 0, 0, 0), (0, 0, 4.0))  # its z along y, x along z
    across = 2.0 * (0.25 + 9 / 12)
    wanted = ph.combine([ph.Body(2.0, (0, 0, 0), np.diag([1.0, across, across])), turned])
    assert spec.body.inertia == pytest.approx(wanted.inertia, rel=EXACT)
    assert spec.body.center_of_mass == pytest.approx([0, 0, 4 / 3], rel=EXACT)


def test_inertia_with_products_and_times(read):
    rows = [["3 kg*m^2", "1 kg*m^2", "0 kg*m^2"], ["1 kg*m^2", "3 kg*m^2", "0 kg*m^2"], ["0 kg*m^2"] * 2 + ["3 kg*m^2"]]
    spec = read(f"inertia = {rows}", '[time]\nuntil = "2 min"\nsamples = 7')
    assert spec.body.principal_moments == pytest.approx([2.0, 3.0, 4.0], rel=EXACT)
    assert (spec.until, spec.samples) == (120.0, 7)


def test_every_mistake_at_once_with_its_key(read):
    with pytest.raises(InvalidInput) as caught:
        read('moment = ["1 kg"]\nmass = "-1 kg"\nparts = [{shape = "box", mass = "x"}]', "[spinn]\n[time]\nuntil = 3")
    text = str(caught.value)
    wanted = (
        "7 mistakes", "body.moment: unknown key; did you mean moments?", "body.mass: must be positive",
        "body: mass follows from the parts", "body.part.1: a box needs size", "body.part.1.mass",
        "spinn: unknown key; did you mean spin?", "time.until: needs a number",
    )  # fmt: skip
    assert not [words for words in wanted if words not in text]


def test_keys_of_a_table_further_in_are_sent_there(read):
    with pytest.raises(InvalidInput) as caught:
        read('moments = ["1 kg*m^2", "2 kg*m^2", "2 kg*m^2"]\nthickness = "2 mm"', "[time]\nmoments = 3")
    assert "body.thickness: unknown key; it goes into [[body.part]]" in str(caught.value)
    assert "time.moments: unknown key; known here are until, samples" in str(caught.value)


def test_wrong_values_hide_no_broken_rule(read):
    with pytest.raises(InvalidInput) as caught:
        read('mesh = "a.stl"\ndensty = "1 kg/m^3"', """
        [spin]
        rate = "60 Hz"
        attitude = [0.0, 0.0, 0.0, 0.0]
        [time]
        until = "-3 s"
        samples = 100.0""")
    wanted = (
        "9 mistakes", "a.stl: no such mesh file",
        "body: needs mesh_unit", "body: needs exactly one of mass and density", "body.densty: unknown",
        "spin: rate needs about", "spin.rate: is ambiguous", "spin.attitude: must be a quaternion",
        "time.until: must be positive", "time.samples: must be a whole number; got 100.0",
    )  # fmt: skip
    assert not [words for words in wanted if words not in str(caught.value)]


def test_unphysical_bodies_are_said_beside_the_rest(read):
    with pytest.raises(InvalidInput) as caught:
        read('moments = ["1 kg*m^2", "1 kg*m^2", "3 kg*m^2"]', "[spin]\nattitude = [0.0, 0.0, 0.0, 0.0]")
    for words in ("2 mistakes", "I1 + I2 ≥ I3", "must be a quaternion"):
        assert words in str(caught.value)
    torus = '{shape = "torus", mass = "1 kg", major_radius = "1 m", minor_radius = "2 m"}'
    with pytest.raises(InvalidInput) as caught:
        read(f'parts = [{torus}, {{shape = "box", mass = "1 kg", sise = "1 m"}}]')
    for words in ("3 mistakes", "body.part.1: ", "body.part.2.sise: unknown key; did you mean size?"):
        assert words in str(caught.value)


def test_the_source_of_a_body_is_tried_beside_other_mistakes_in_its_table(read):
    with pytest.raises(InvalidInput) as caught:
        read('moments = ["1 kg*m^2", "1 kg*m^2", "3 kg*m^2"]\nmass = "1 lbf"\nbogus = 1', '[spin]\nrate = "3 Hz"')
    for words in ("5 mistakes", "I1 + I2 ≥ I3", "body.mass", "body.bogus", "spin.rate", "spin: rate needs about"):
        assert words in str(caught.value)


def test_quarter_turns_of_tilt_are_exact(read):
    quarters = {"90 deg": [0, 0, 1], "180 deg": [0, -1, 0], "360 deg": [0, 1, 0], "0.25 rev": [0, 0, 1]}
    for tilt, wanted in quarters.items():
        spec = read(MOMENTS, f'[spin]\nrate = "2 rad/s"\nabout = 2\ntilt = "{tilt}"')
        assert (momentum(spec) / spec.body.principal_moments).tolist() == [2.0 * x for x in wanted]


def test_rest_may_have_an_attitude(read):
    spec = read(MOMENTS, "[spin]\nattitude = [0.5, 0.5, 0.5, 0.5]")
    assert not momentum(spec).any()
    axes = ph.rotation.from_matrix(spec.body.principal_axes)
    turned = ph.rotation.multiply(attitude(spec), ph.rotation.conjugate(axes))
    assert turned == pytest.approx([0.5, 0.5, 0.5, 0.5], abs=1e-15)


@pytest.mark.parametrize("unit", ['""', '"kg"', '"5 mm"', '"MM"', "5"])
def test_mesh_units_are_units_of_length_alone(read, unit):
    with pytest.raises(InvalidInput, match='must be a unit of length alone, in quotes, like "mm"'):
        read(f'mesh = "a.stl"\nmass = "1 kg"\nmesh_unit = {unit}')


@pytest.mark.parametrize(
    ("rest", "words"),
    [
        ('rate = "1 rpm"\nabout = true', '"x", "y", "z"; got true'),
        ('rate = "1 rpm"\nabout = 2.0', "must be one of 1, 2, 3"),
        ('attitude = ["1", "0", "0", "1"]', "four plain numbers"),
        ('momentum = "1 J*s"', "three quantities in a list"),
        ('momentum = ["1 J*s", "1 J*s"]', "three quantities in a list"),
    ],
)
def test_values_of_the_wrong_kind(read, rest, words):
    with pytest.raises(InvalidInput, match=words):
        read(MOMENTS, f"[spin]\n{rest}")


@pytest.mark.parametrize(("key", "value"), [("repair", '"yes"'), ("repair", "1"), ("mesh", "3"), ("part", '"box"')])
def test_body_values_of_the_wrong_kind(read, key, value):
    with pytest.raises(InvalidInput, match=f"body.{key}: must be"):
        read(f"{key} = {value}")


def test_a_byte_order_mark_is_no_mistake(tmp_path):
    (tmp_path / "mark.toml").write_text(f"[body]\n{MOMENTS}", "utf-8-sig")
    assert read_spec(tmp_path / "mark.toml").name == "mark"


def test_part_measures_and_sources(read):
    sphere = '{shape = "sphere", mass = "1 kg", radius = "1 m", height = "1 m"}'
    with pytest.raises(InvalidInput, match="a sphere has no height; it takes radius"):
        read(f"parts = [{sphere}]")
    with pytest.raises(InvalidInput, match="exactly one of mesh, moments"):
        read(MOMENTS + '\nmolecule = "a.xyz"')
    with pytest.raises(InvalidInput, match="goes with a mesh"):
        read(MOMENTS + "\nrepair = true")
    with pytest.raises(InvalidInput, match="quaternion"):
        read(MOMENTS, "[spin]\nattitude = [0.0, 0.0, 0.0, 0.0]\nmomentum = ['1 J*s', '0 J*s', '0 J*s']")


def test_files_that_are_no_specs(tmp_path):
    with pytest.raises(InvalidInput, match="is a folder, not a spec file"):
        read_spec(tmp_path)
    (tmp_path / "noise.toml").write_bytes(bytes(range(256)))
    with pytest.raises(FormatError, match="not UTF-8 text"):
        read_spec(tmp_path / "noise.toml")
    (tmp_path / "empty.toml").write_text("")
    with pytest.raises(InvalidInput, match="body: is missing"):
        read_spec(tmp_path / "empty.toml")
