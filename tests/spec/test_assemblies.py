"""Bodies put together from parts: every kind of part, in its place, cut, weighed and refused."""

import json
import math
from fractions import Fraction

import numpy as np
import pytest
import trimesh

import polhode as ph
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec

EXACT = 1e-14
MASSIVE = ph.shapes.box(2.0, (1.0, 2.0, 3.0))
PLATE = """
[body]
[[body.part]]
name = "plate"
shape = "cylinder"
density = "2700 kg/m^3"
radius = "50 mm"
height = "10 mm"
[[body.part]]
name = "hole"
shape = "cylinder"
radius = "10 mm"
height = "10 mm"
cut = true
"""


@pytest.fixture
def read(tmp_path):
    def reader(text, name="case.toml"):
        path = tmp_path / name
        path.write_text(text, "utf-8")
        return read_spec(path)

    return reader


@pytest.fixture
def said(tmp_path, capsys):
    """Return what ``polhode body`` prints as JSON about a text."""

    def run(text, *options):
        path = tmp_path / "case.toml"
        path.write_text(text, "utf-8")
        with pytest.raises(SystemExit) as ended:
            main(["body", str(path), "--json", *options])
        out = capsys.readouterr()
        assert ended.value.code == 0, out.err
        return json.loads(out.out)

    return run


def test_a_plate_with_a_hole(said):
    """An aluminium ring of 100 mm by 10 mm with a hole of 20 mm: m = ρπ(R² − r²)h, I_z = m (R² + r²)/2.

    2700 kg/m³ · π · (0.05² − 0.01²) m² · 0.01 m = 0.20358 kg, and I_z = 2.646e-4 kg m².
    """
    found = said(PLATE, "--about", "z")
    mass = 2700 * math.pi * (0.05**2 - 0.01**2) * 0.01
    assert found["mass"] == pytest.approx(mass, rel=1e-12)
    assert mass == pytest.approx(0.20358, abs=5e-6)
    assert found["about"]["moment"] == pytest.approx(2.646e-4, abs=5e-8)
    assert found["about"]["moment"] == pytest.approx(mass * (0.05**2 + 0.01**2) / 2, rel=1e-12)


@pytest.mark.parametrize(
    ("about", "point", "direction"),
    [
        ("0 mm, 0 mm, 5 cm", (0, 0, 0.05), None), ("x", (0, 0, 0), (1, 0, 0)), ("hole", (0, 0, 0), (0, 0, 1)),
        ("part 1", (0, 0, 0), (0, 0, 1)), ("3 through 1 cm, 2 cm, 0 m", (0.01, 0.02, 0), (0, 0, 1)),
        ("[3, 0, 4] through 1 cm, 0 m, 0 m", (0.01, 0, 0), (0.6, 0, 0.8)),
    ],
)  # fmt: skip
def test_about_a_place(said, about, point, direction):
    found = said(PLATE, "--about", about)["about"]
    mass, height = 2700 * math.pi * (0.05**2 - 0.01**2) * 0.01, 0.01
    squares = np.array([(0.05**2 + 0.01**2) / 4] * 2 + [height**2 / 12])
    point = np.array(point, dtype=float)
    second = np.diag(squares) + np.outer(point, point)
    inertia = mass * (np.trace(second) * np.eye(3) - second)
    assert found["inertia"] == pytest.approx(inertia, rel=1e-12, abs=1e-18)
    assert found["point"] == pytest.approx(point)
    if direction is None:
        assert found["moments"] == pytest.approx(np.diag(inertia), rel=1e-12)
    else:
        moment = np.array(direction) @ inertia @ np.array(direction)
        assert found["moment"] == pytest.approx(moment, rel=1e-12)
        assert found["radius_of_gyration"] == pytest.approx(math.sqrt(moment / mass), rel=1e-12)


@pytest.mark.parametrize(
    ("about", "words"),
    [("hub", "Its parts are plate, hole"), ("1 kg, 0 m, 0 m", "has the wrong unit"), ("x through 1 m", "three lengths"),
     ("0, 0, 0", "a coordinate needs a unit"), ("part 3", "must be a point like")],
)  # fmt: skip
def test_no_such_place(tmp_path, capsys, about, words):
    (tmp_path / "case.toml").write_text(PLATE, "utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["body", str(tmp_path / "case.toml"), "--about", about])
    assert ended.value.code == 2
    assert words in " ".join(capsys.readouterr().err.split())


def test_every_kind_of_part(read, tmp_path):
    """The same box by six ways stands in six places; the sum is that of six boxes."""
    box = trimesh.creation.box((1.0, 2.0, 3.0))
    box.export(tmp_path / "box.stl")
    # a part that is another spec: twice, through a spec between
    (tmp_path / "inner.toml").write_text(
        '[body]\n[[body.part]]\nshape = "box"\nmass = "2 kg"\nsize = ["1 m", "2 m", "3 m"]\n', "utf-8")  # fmt: skip
    (tmp_path / "outer.toml").write_text('[body]\n[[body.part]]\nspec = "inner.toml"\n', "utf-8")
    inertia = MASSIVE.inertia
    about = MASSIVE.about((0.1, 0.2, 0.3))
    rows = [[f"{x!r} kg*m^2" for x in row] for row in (inertia.tolist(), about.tolist())[1]]
    kinds = [
        'shape = "box"\nmass = "2 kg"\nsize = ["1 m", "2 m", "3 m"]',
        """shape = "prism"\ndensity = "0.333333333333333333 kg/m^3"\nheight = "3 m"
        outline = [["-0.5 m", "-1 m"], ["0.5 m", "-1 m"], ["0.5 m", "1 m"], ["-0.5 m", "1 m"]]""",
        'mesh = "box.stl"\nmesh_unit = "m"\nmass = "2 kg"',
        'spec = "inner.toml"',
        'spec = "outer.toml"',
        f'mass = "2 kg"\ninertia = {json.dumps(rows)}\nabout = ["0.1 m", "0.2 m", "0.3 m"]',
    ]
    places = [(0.0, 0.0, 0.0), (5.0, 0.0, 0.0), (0.0, 7.0, 1.0), (3.0, 3.0, -4.0), (-5.0, 1.0, 0.0), (0.0, -6.0, 2.0)]
    turns = [
        ('axis = "x"', [[0, 0, 1], [1, 0, 0], [0, 1, 0]]),
        ("attitude = [0.5, 0.5, 0.5, 0.5]", None),
        ('attitude = {axis = [0, 0, 1], angle = "30 deg"}', None),
        ('attitude = {sequence = "ZXZ", angles = ["10 deg", "20 deg", "30 deg"]}', None),
        ("", None),
        ('attitude = {axis = [1, 2, 3], angle = "-1 rad"}', None),
    ]
    rotations = [
        np.array(turns[0][1], dtype=float), *(np.asarray(ph.rotation.as_matrix(q)) for q in (
            (0.5, 0.5, 0.5, 0.5), ph.rotation.from_axis_angle([0, 0, 1], math.radians(30)),
            ph.rotation.from_euler_angles(np.radians([10.0, 20.0, 30.0]), "ZXZ"), (1.0, 0.0, 0.0, 0.0),
            ph.rotation.from_rotation_vector(-np.array([1, 2, 3]) / math.sqrt(14))))]  # fmt: skip
    text = "[body]\n" + "".join(
        f'[[body.part]]\n{kind}\n{turn}\nat = ["{x} m", "{y} m", "{z} m"]\n'
        for kind, (turn, _), (x, y, z) in zip(kinds, turns, places, strict=True)
    )
    spec = read(text)
    expected = ph.combine([MASSIVE.placed(turn, at) for turn, at in zip(rotations, places, strict=True)])
    assert spec.body.mass == pytest.approx(12.0, rel=EXACT)
    assert spec.body.center_of_mass == pytest.approx(expected.center_of_mass, rel=1e-13)
    assert spec.body.inertia == pytest.approx(expected.inertia, rel=1e-13, abs=1e-12)
    # drawn where they are: the surface's own mass properties are those of the body
    drawn = ph.Body.from_mesh(*spec.surface, mass=12.0, several=True)
    assert drawn.center_of_mass == pytest.approx(expected.center_of_mass, rel=1e-6)
    assert drawn.inertia == pytest.approx(expected.inertia, rel=1e-6, abs=1e-6)


def test_point_masses(read):
    """Eight points of 1 kg at (±p/2, ±p/2, ±50 m), p = 0.01: exact sums of rational numbers."""
    places = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    point = '[[body.part]]\nshape = "point"\nmass = "1 kg"\nat = '
    text = "".join(f'{point}["{0.005 * x} m", "{0.005 * y} m", "{50 * z} m"]\n' for x, y, z in places)
    spec = read("[body]\n" + text)
    p = Fraction(1, 200)
    across, along = 8 * (2500 + p * p), 8 * 2 * p * p
    assert np.diag(spec.body.inertia) == pytest.approx([float(across), float(across), float(along)], rel=1e-12)
    assert len(spec.surface.faces) > 8 * 20


def test_parts_may_be_called_so_too(read):
    one = '{ shape = "box", mass = "1 kg", size = ["1 m", "2 m", "3 m"] }'
    assert np.array_equal(read(f"[body]\npart = [{one}]").body.inertia, read(f"[body]\nparts = [{one}]").body.inertia)
    with pytest.raises(InvalidInput, match=r"body.parts: unknown key; did you mean part\?"):
        read(f"[body]\npart = [{one}]\nparts = [{one}]")


def test_density_of_a_cut(read):
    """Left out, it is that of what is cut; said, it is what is said."""
    solid = PLATE.replace('name = "hole"', 'name = "hole"\ndensity = "2700 kg/m^3"')
    assert read(PLATE).body.inertia == pytest.approx(read(solid).body.inertia, rel=EXACT)
    by_mass = PLATE.replace('density = "2700 kg/m^3"', f'mass = "{2700 * math.pi * 0.05**2 * 0.01!r} kg"')
    assert read(by_mass).body.inertia == pytest.approx(read(PLATE).body.inertia, rel=1e-12)
    for_all = PLATE.replace('density = "2700 kg/m^3"\n', "").replace("[body]", '[body]\ndensity = "2700 kg/m^3"')
    assert read(for_all).body.inertia == pytest.approx(read(PLATE).body.inertia, rel=EXACT)
    bolt = '[[body.part]]\nshape = "point"\nmass = "1 g"\nat = ["1 cm", "0 m", "0 m"]\n'
    assert read(PLATE + bolt).body.mass == pytest.approx(read(PLATE).body.mass + 1e-3, rel=EXACT)
    steel = '[[body.part]]\nshape = "sphere"\nradius = "1 cm"\ndensity = "7850 kg/m^3"\nat = ["1 m", "0 m", "0 m"]\n'
    with pytest.raises(InvalidInput, match=r"body.part.2: says neither mass nor density, and the shapes and meshes"):
        read(PLATE + steel)
    motor = '[[body.part]]\nmass = "1 g"\ninertia = [ROW_X, ROW_Y, ROW_Z]\n'  # nothing is cut of it
    for k, row in enumerate("XYZ"):
        zeros = ['"0 kg*m^2"'] * 3
        zeros[k] = '"1e-9 kg*m^2"'
        motor = motor.replace(f"ROW_{row}", f"[{', '.join(zeros)}]")
    assert read(PLATE + motor).body.mass == pytest.approx(read(PLATE).body.mass + 1e-3, rel=EXACT)


def test_what_cuts_leave_must_be_a_body(read):
    with pytest.raises(InvalidInput, match=r"body: nothing is left: .* kg are cut from"):
        read(PLATE.replace('"10 mm"\nheight = "10 mm"\ncut', '"60 mm"\nheight = "10 mm"\ncut'))
    with pytest.raises(InvalidInput, match="what the cuts leave is no body"):
        aside = '"49 mm"\nheight = "10 mm"\nat = ["20 cm", "0 m", "0 m"]\ncut'
        read(PLATE.replace('"10 mm"\nheight = "10 mm"\ncut', aside))
    with pytest.raises(InvalidInput, match="has cuts only"):
        read('[body]\n[[body.part]]\nshape = "sphere"\nradius = "1 m"\nmass = "1 kg"\ncut = true')
    # a thin plate with almost all of it cut is flat, though rounding says otherwise
    thin = PLATE.replace('height = "10 mm"', 'height = "1e-9 mm"').replace('"10 mm"\nheight', '"49.999999 mm"\nheight')
    moments = read(thin).body.principal_moments
    assert moments[0] + moments[1] == pytest.approx(moments[2], rel=1e-13)


SHELLED = {
    'shape = "sphere"\nradius = "1 m"\nshell = true\nmass = "3 kg"': [2.0] * 3,
    'shape = "cylinder"\nradius = "1 m"\nheight = "2 m"\nshell = true\nopen_ends = true\nmass = "1 kg"': [
        0.5 + 1 / 3, 0.5 + 1 / 3, 1.0],
    'shape = "box"\nsize = ["1 m", "1 m", "1 m"]\nthickness = "1 um"\nmass = "18 kg"': [5.0] * 3,
    'mesh = "cube.stl"\nmesh_unit = "m"\nshell = true\nmass = "18 kg"': [5.0] * 3,
    'mesh = "cube.stl"\nmesh_unit = "m"\ndensity = "1000 kg/m^3"\nthickness = "3 mm"': [5.0] * 3,
}  # fmt: skip


@pytest.mark.parametrize("kind", SHELLED)
def test_shells(read, tmp_path, kind):
    trimesh.creation.box((1.0, 1.0, 1.0)).export(tmp_path / "cube.stl")
    spec = read(f"[body]\n[[body.part]]\n{kind}\n")
    assert spec.body.principal_moments == pytest.approx(SHELLED[kind], rel=1e-11)
    assert len(spec.surface.faces) >= 12


REFUSED = {
    'shape = "sphere"\nradius = "0 m"\nmass = "1 kg"': 'must be positive; got \'0 m\'. A point mass is shape = "point"',
    'mass = "1 kg"': "needs exactly one of shape, mesh, spec and inertia, for what it is; got none",
    'shape = "box"\nmesh = "a.stl"': "for what it is; got shape and mesh",
    'shape = "sphere"\nradius = "1 m"': "mass is missing",
    'shape = "sphere"\nradius = "1 m"\nmass = "1 kg"\ndensity = "1 kg/m^3"': "needs one of mass and density",
    'shape = "rod"\nlength = "1 m"\ndensity = "1 kg/m^3"': "a rod has no volume",
    'shape = "sphere"\nradius = "1 m"\nmass = "1 kg"\naxis = "x"\nattitude = [1, 0, 0, 0]': "both turn the part",
    'shape = "prism"\nheight = "1 m"\nmass = "1 kg"': "needs either sides and radius",
    'shape = "prism"\nheight = "1 m"\nmass = "1 kg"\nsides = 2\nradius = "1 m"': "must be at least 3",
    'shape = "prism"\nheight = "1 m"\nmass = "1 kg"\noutline = [["0 m"]]': "must be a list of corners",
    'shape = "prism"\nheight = "1 m"\nmass = "1 kg"\n'
    'outline = [["0 m", "0 m"], ["1 m", "1 m"], ["1 m", "0 m"], ["0 m", "1 m"]]': "must not cross or touch itself",
    'shape = "sphere"\nradius = "1 m"\ndensity = "1 kg/m^3"\nshell = true': "a shell has the mass of its wall",
    'shape = "cylinder"\nradius = "1 m"\nheight = "1 m"\nmass = "1 kg"\nopen_ends = true': "open_ends goes with shell",
    'shape = "cylinder"\nradius = "1 m"\nheight = "1 m"\nmass = "1 kg"\nthickness = "3 m"': "the wall fills the shape",
    'shape = "cone"\nradius = "1 m"\nheight = "1 m"\nmass = "1 kg"\nshell = true': "a cone has no shell",
    'spec = "b.toml"\nmass = "1 kg"': "mass of another spec's body is given in that spec",
    'spec = "none.toml"': "none.toml",
    'spec = "case.toml"': "is part of itself: case.toml → case.toml",
    'inertia = [["1 kg*m^2", "0 kg*m^2", "0 kg*m^2"], ["0 kg*m^2", "1 kg*m^2", "0 kg*m^2"], '
    '["0 kg*m^2", "0 kg*m^2", "1 kg*m^2"]]': "mass is missing",
    'mass = "1 kg"\ninertia = [["1 kg*m^2", "0 kg*m^2", "0 kg*m^2"], ["0 kg*m^2", "1 kg*m^2", "0 kg*m^2"], '
    '["0 kg*m^2", "0 kg*m^2", "3 kg*m^2"]]': "must satisfy I1 + I2 ≥ I3",
    'mesh = "a.stl"\nmass = "1 kg"': "needs mesh_unit",
}  # fmt: skip


@pytest.mark.parametrize("kind", REFUSED)
def test_parts_that_are_refused(read, kind):
    with pytest.raises(InvalidInput) as caught:
        read(f"[body]\n[[body.part]]\n{kind}\n")
    assert REFUSED[kind] in str(caught.value) and "body.part.1" in str(caught.value)


def test_one_table_in_single_brackets(read):
    with pytest.raises(InvalidInput, match=r"begin each part with \[\[body.part\]\]"):
        read('[body.part]\nshape = "sphere"\nradius = "1 m"\nmass = "1 kg"')


def test_specs_in_a_ring(read, tmp_path):
    for name, other in (("a", "b"), ("b", "c"), ("c", "a")):
        (tmp_path / f"{name}.toml").write_text(f'[body]\n[[body.part]]\nspec = "{other}.toml"\n', "utf-8")
    with pytest.raises(InvalidInput, match=r"is part of itself: a.toml → b.toml → c.toml → a.toml") as caught:
        read_spec(tmp_path / "a.toml")
    assert len(str(caught.value).splitlines()) == 2


def test_a_spec_used_often_is_read_once(read, tmp_path):
    """Forty levels of two parts each are 2⁴⁰ boxes: without a memory of files that would never end."""
    (tmp_path / "0.toml").write_text(
        '[body]\n[[body.part]]\nshape = "box"\nmass = "1 kg"\nsize = ["1 m", "2 m", "3 m"]\n', "utf-8")  # fmt: skip
    for k in range(1, 40):
        part = f'[[body.part]]\nspec = "{k - 1}.toml"\n'
        (tmp_path / f"{k}.toml").write_text(f"[body]\n{part}{part}", "utf-8")
    spec = read_spec(tmp_path / "39.toml")
    assert spec.body.mass == pytest.approx(2.0**39)
    with pytest.raises(InvalidInput, match="pieces with those of other specs, more than 10000"):
        spec.surface  # noqa: B018


ROUNDED = '[body]\nmoments = ["1.23456e-5 kg*m^2", "2.34567e-5 kg*m^2", "3.58024e-5 kg*m^2"]\n'


def test_rounded_moments(read):
    """I₃ − I₁ − I₂ = 1e-10 kg m² is taken off in equal thirds: the nearest point of a plane."""
    with pytest.raises(InvalidInput, match='Rounding to 6 digits explains it: say rounding = "6 digits"'):
        read(ROUNDED)
    with pytest.raises(InvalidInput, match="rounding to 7 digits does not explain it, but to 6 digits would"):
        read(ROUNDED + 'rounding = "7 digits"')
    spec = read(ROUNDED + 'rounding = "6 digits"\n[spin]\nrate = "1 rev/s"\nabout = 3\n')
    third = Fraction("1e-10") / 3
    expected = [Fraction("1.23456e-5") + third, Fraction("2.34567e-5") + third, Fraction("3.58024e-5") - third]
    assert spec.body.principal_moments == pytest.approx([float(x) for x in expected], rel=1e-14)
    (note,) = spec.report().notes[:1]
    assert "miss I₁ + I₂ ≥ I₃ by 2.8e-06 of I₃, which rounding to 6 digits explains" in note
    assert not read('[body]\nmoments = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]\nrounding = "6 digits"').remarks


def test_rounded_tensors_are_projected_onto_the_nearest(read):
    """No physical tensor near by is nearer, tried along a thousand directions; and axes stay."""
    turn = np.asarray(ph.rotation.as_matrix(ph.rotation.from_rotation_vector([0.3, -0.7, 0.4])))
    flat = np.array([[float(f"{x:.5e}") for x in row] for row in turn @ np.diag([1.0, 2.0, 3.000004]) @ turn.T])
    near = ph.Body.from_inertia(flat, digits=6).inertia
    distance = np.linalg.norm(near - flat)
    assert 0 < distance < 1e-5
    rng = np.random.default_rng(0)
    for size in (1e-2, 1.0, 10.0):
        for change in rng.normal(size=(300, 3, 3)) * distance * size:
            tried = near + change + change.T
            low, middle, high = np.linalg.eigvalsh(tried)
            if low + middle >= high:
                assert np.linalg.norm(tried - flat) >= distance * (1 - 1e-9)
    with pytest.raises(InvalidInput, match="rounding to 9 digits does not explain"):
        ph.Body.from_inertia(flat, digits=9)


def test_center_of_mass_beside_inertia(read):
    text = '[body]\nmass = "2 kg"\ncenter_of_mass = ["1 m", "2 m", "3 m"]\n'
    text += 'moments = ["2 kg*m^2", "3 kg*m^2", "4 kg*m^2"]\n'
    assert read(text).body.center_of_mass.tolist() == [1.0, 2.0, 3.0]
    rows = [[f"{x!r} kg*m^2" for x in row] for row in MASSIVE.placed(translation=(1, 2, 3)).about((0, 0, 1)).tolist()]
    body = read(f'[body]\nmass = "2 kg"\ncenter_of_mass = ["1 m", "2 m", "3 m"]\nabout = ["0 m", "0 m", "1 m"]\n'
                f"inertia = {json.dumps(rows)}\n").body  # fmt: skip
    assert body.inertia == pytest.approx(MASSIVE.inertia, rel=1e-13, abs=1e-13)
    with pytest.raises(InvalidInput, match="center_of_mass goes with inertia or moments"):
        read(PLATE.replace("[body]", '[body]\ncenter_of_mass = ["0 m", "0 m", "0 m"]'))


@pytest.mark.long
def test_a_sweep_of_a_part_s_numbers(tmp_path, capsys):
    text = PLATE + """
[spin]
rate = "60 rpm"
about = "z"
tilt = "1 deg"
[sweep]
outputs = ["principal_moments", "mass"]
[sweep.inputs]
"body.part.2.radius" = { grid = ["10 mm", "20 mm"] }
"""
    (tmp_path / "case.toml").write_text(text, "utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["sweep", str(tmp_path / "case.toml"), "--out", str(tmp_path / "out"), "--json"])
    out = capsys.readouterr()
    assert ended.value.code == 0, out.err
    assert "principal_moments" in out.out


def test_through_the_whole_chain(read, tmp_path):
    """Make, simulate, save, report: parts give the motion that the same tensor gives, and the file gives it back."""
    spin = '[spin]\nrate = "60 rpm"\nabout = 3\ntilt = "5 deg"\n[time]\nuntil = "3 s"\nsamples = 50\n'
    parts = PLATE.replace("cut = true", 'cut = true\ndensity = "2700 kg/m^3"')
    parts += '[[body.part]]\nshape = "capsule"\nmass = "30 g"\nradius = "4 mm"\nlength = "40 mm"\n'
    parts += 'at = ["30 mm", "10 mm", "10 mm"]\nattitude = {axis = [1, 1, 0], angle = "40 deg"}\n'
    spec = read(parts + spin)
    rows = [[f"{x!r} kg*m^2" for x in row] for row in spec.body.inertia.tolist()]
    center = [f"{x!r} m" for x in spec.body.center_of_mass.tolist()]
    known = read(f'[body]\nmass = "{spec.body.mass!r} kg"\ncenter_of_mass = {json.dumps(center)}\n'
                 f"inertia = {json.dumps(rows)}\n{spin}", "known.toml")  # fmt: skip
    one, other = spec.report(), known.report()
    assert np.abs(one.trajectory.attitude - other.trajectory.attitude).max() < 1e-12
    path = one.save(tmp_path / "motion.nc")
    from polhode.formats import read_dataset

    back = read_dataset(path)
    assert np.array_equal(back.attitude, one.trajectory.attitude)
    assert back.frame.mass == pytest.approx(spec.body.mass, rel=EXACT)
    assert np.asarray(back.frame.center_of_mass) == pytest.approx(spec.body.center_of_mass, rel=EXACT)
    # a specimen that is broken is seen: a thousandth more mass in the capsule turns otherwise
    broken = read((parts + spin).replace('mass = "30 g"', 'mass = "30.03 g"'), "broken.toml").report()
    assert np.abs(one.trajectory.attitude - broken.trajectory.attitude).max() > 1e-6


def test_an_inertia_about_a_point_holds_that_of_the_mass_there(read):
    """20 kg at 0.374 m have 2.8 kg m² there, more than is given."""
    rows = '[["1.2 J", "0 J", "0 J"], ["0 J", "2.3 J", "0 J"], ["0 J", "0 J", "2.5 J"]]'.replace("J", "kg*m^2")
    about = 'center_of_mass = ["0.1 m", "0.2 m", "0.3 m"]\nabout = ["0 m", "0 m", "0 m"]\n'
    with pytest.raises(InvalidInput, match=r"m d² = 20 kg × \(0.3742 m\)² = 2.8 kg m²"):
        read(f'[body]\nmass = "20 kg"\ninertia = {rows}\n{about}')
