"""What specs' bodies look like: closed surfaces of the right shape in the right place."""

from pathlib import Path

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.spec.surfaces import surface_of_atoms

DRAWN = 0.02
"""Round shapes are drawn with 64 flat faces to the turn, and flat ones 2 % thick."""
EXACT = 1e-13
EXAMPLES = Path(__file__).parents[2] / "examples"
SHAPES = {
    "box": 'size = ["1 cm", "2 cm", "3 cm"]',
    "cylinder": 'radius = "1 cm", height = "3 cm"',
    "cylinder, hollow": 'radius = "1 cm", height = "3 cm", inner_radius = "6 mm"',
    "ellipsoid": 'semi_axes = ["1 cm", "2 cm", "3 cm"]',
    "sphere": 'radius = "2 cm"',
    "sphere, hollow": 'radius = "2 cm", inner_radius = "1 cm"',
    "cone": 'radius = "1 cm", height = "3 cm"',
    "disk": 'radius = "2 cm"',
    "disk, hollow": 'radius = "2 cm", inner_radius = "1 cm"',
    "rod": 'length = "7 cm"',
    "torus": 'major_radius = "2 cm", minor_radius = "5 mm"',
}


@pytest.fixture
def read(tmp_path):
    def reader(text):
        path = tmp_path / "case.toml"
        path.write_text(text, "utf-8")
        return read_spec(path)

    return reader


@pytest.mark.parametrize("axis", ["x", "z"])
@pytest.mark.parametrize("shape", SHAPES)
def test_a_part_is_drawn_where_and_as_it_is(read, shape, axis):
    kind, measures = shape.split(",")[0], SHAPES[shape]
    spec = read(f"""[body]
    parts = [{{shape = "{kind}", mass = "2 kg", {measures}, axis = "{axis}", at = ["10 cm", "-20 cm", "30 cm"]}}]""")
    drawn = ph.Body.from_mesh(*spec.surface, mass=2.0)
    assert drawn.center_of_mass == pytest.approx([0.1, -0.2, 0.3], rel=EXACT)
    assert np.abs(drawn.inertia - spec.body.inertia).max() <= DRAWN * np.abs(spec.body.inertia).max()


@pytest.mark.parametrize(("shape", "inner"), [("cylinder", ', height = "1 cm"'), ("disk", ""), ("sphere", "")])
def test_a_shell_without_thickness_is_drawn_with_a_little(read, shape, inner):
    spec = read(f"""[body]
    parts = [{{shape = "{shape}", mass = "2 kg", radius = "1 cm", inner_radius = "1 cm"{inner}}}]""")
    drawn = ph.Body.from_mesh(*spec.surface, mass=2.0)
    assert np.abs(drawn.inertia - spec.body.inertia).max() <= 2 * DRAWN * np.abs(spec.body.inertia).max()


@pytest.mark.parametrize(("axis", "apex"), [("z", (0, 0, 3)), ("-z", (0, 0, -3)), ("-x", (-3, 0, 0)), ("y", (0, 3, 0))])
def test_a_cone_points_where_its_axis_says(read, axis, apex):
    spec = read(f"""[body]
    parts = [{{shape = "cone", mass = "2 kg", radius = "1 m", height = "4 m", axis = "{axis}"}}]""")
    vertices = spec.surface.vertices
    farthest = vertices[np.linalg.norm(vertices, axis=1).argmax()]
    assert farthest == pytest.approx(apex, abs=EXACT)
    assert (vertices @ apex).min() == pytest.approx(-3.0, rel=EXACT)  # the base, h/4 the other way
    assert ph.Body.from_mesh(*spec.surface, mass=2.0).mass == 2.0  # turned, not mirrored: the gate would say inverted


def test_parts_are_drawn_together(read):
    spec = read("""[body]
    parts = [{shape = "sphere", mass = "1 kg", radius = "1 cm"},
             {shape = "box", mass = "1 kg", size = ["1 cm", "1 cm", "1 cm"], at = ["0 cm", "5 cm", "0 cm"]}]""")
    low, high = spec.surface.vertices.min(axis=0), spec.surface.vertices.max(axis=0)
    assert low == pytest.approx([-0.01, -0.01, -0.01], rel=EXACT)
    assert high == pytest.approx([0.01, 0.055, 0.01], rel=EXACT)


def test_a_mesh_is_its_own_triangles():
    spec = read_spec(EXAMPLES / "t_handle.toml")
    drawn = ph.Body.from_mesh(*spec.surface, mass=spec.body.mass)
    assert drawn.inertia == pytest.approx(spec.body.inertia, rel=EXACT)
    assert drawn.center_of_mass == pytest.approx(spec.body.center_of_mass, rel=EXACT)


def test_a_molecule_is_balls_and_bars():
    from ase.data import covalent_radii
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    surface = read_spec(EXAMPLES / "water.toml").surface
    edges = np.vstack([surface.faces[:, [0, 1]], surface.faces[:, [1, 2]]])
    graph = coo_array((np.ones(len(edges)), edges.T), shape=(len(surface.vertices),) * 2)
    count, label = connected_components(graph, directed=False)
    assert count == 5  # an oxygen, two hydrogens, two bonds: hydrogens are not bonded to each other
    balls = [surface.vertices[label == k] for k in range(count) if (label == k).sum() > 100]
    sizes = [np.ptp(ball, axis=0).max() for ball in balls]
    assert sorted(sizes) == pytest.approx([covalent_radii[k] * 1e-10 for k in (1, 1, 8)], rel=DRAWN)
    assert balls[np.argmax(sizes)].mean(axis=0) == pytest.approx([0.0, 0.0, 0.0], abs=1e-20)


def test_atoms_in_one_place_have_no_bar_between_them():
    """It had no direction, and its corners were NaN."""
    surface = surface_of_atoms(["H", "H", "O"], np.array([[0.0, 0, 0], [0, 0, 0], [1e-10, 0, 0]]))
    assert np.isfinite(surface.vertices).all()


def test_a_rolling_disk_is_drawn_by_its_own_sizes():
    spec = read_spec(EXAMPLES / "euler_disk.toml")
    assert spec.body is None
    assert np.ptp(spec.surface.vertices, axis=0) == pytest.approx([0.0762, 0.0762, 0.0127], rel=EXACT)


def test_moments_alone_have_no_surface_and_it_is_made_once(read):
    assert read('[body]\nmoments = ["3 kg*m^2", "1 kg*m^2", "2.5 kg*m^2"]').surface is None
    assert read_spec(EXAMPLES / "hyperion.toml").surface is None
    spec = read_spec(EXAMPLES / "book.toml")
    assert spec.surface is spec.surface


def test_a_mesh_that_is_gone_since(tmp_path):
    for name in ("t_handle.toml", "t_handle.stl"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes())
    spec = read_spec(tmp_path / "t_handle.toml")
    (tmp_path / "t_handle.stl").unlink()
    with pytest.raises(InvalidInput, match="no such mesh file"):
        spec.surface  # noqa: B018
