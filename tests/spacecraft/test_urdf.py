"""Mass properties of links against other readers of URDF, and back again."""

import xml.etree.ElementTree as ET

import numpy as np
import pytest
import yourdfpy
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import polhode as ph
from polhode.errors import FormatError, InvalidInput
from polhode.kinds.reading import read_spec
from polhode.spacecraft.formats.urdf import read_urdf_inertial, write_urdf_inertial

EXACT = 1e-14
"""A few roundings of a matrix product, relative to its largest entry."""
BODY = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).placed((0.8, 0.2, -0.4, 0.4), (5.0, -7.0, 11.0))
# the upper arm of a robot as it might stand in a package: two links, the first without mass
ARM = """<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base_link"/>
  <link name="upper_arm">
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <inertial>
      <origin rpy="0.3 -1.1 2.7" xyz="0.1 -0.2 0.05"/>
      <mass value="3.7"/>
      <inertia ixx="0.031" ixy="-0.002" ixz="0.0015" iyy="0.027" iyz="0.0007" izz="0.012"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute"><parent link="base_link"/><child link="upper_arm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>
"""


@pytest.fixture
def saved(tmp_path):
    def save(text, name="robot.urdf"):
        path = tmp_path / name
        path.write_text(text, "utf-8")
        return path

    return save


def by_hand(path, link):
    """Return mass, centre (3,) and inertia (3, 3) along the link's axes, by SciPy's turns about fixed axes."""
    found = next(x for x in ET.parse(path).getroot() if x.get("name") == link).find("inertial")
    origin, entry = found.find("origin"), found.find("inertia")
    xx, xy, xz, yy, yz, zz = (float(entry.get(k)) for k in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    turn = Rotation.from_euler("xyz", [float(x) for x in origin.get("rpy").split()]).as_matrix()
    inertia = turn @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turn.T
    return float(found.find("mass").get("value")), [float(x) for x in origin.get("xyz").split()], inertia


def check(body, mass, center, inertia, allowed=EXACT):
    assert body.mass == mass and body.center_of_mass.tolist() == list(center)
    assert np.abs(body.inertia - inertia).max() <= allowed * np.abs(inertia).max()


def test_the_inertial_frame_is_turned(saved):
    path = saved(ARM)
    check(read_urdf_inertial(path, "upper_arm"), *by_hand(path, "upper_arm"))
    check(read_urdf_inertial(path), *by_hand(path, "upper_arm"))  # the only one with mass


def test_the_bound_would_notice_turns_in_the_other_order(saved):
    path = saved(ARM)
    mass, center, _ = by_hand(path, "upper_arm")
    other = Rotation.from_euler("XYZ", [0.3, -1.1, 2.7]).as_matrix()
    given = np.array([[0.031, -0.002, 0.0015], [-0.002, 0.027, 0.0007], [0.0015, 0.0007, 0.012]])
    with pytest.raises(AssertionError):
        check(read_urdf_inertial(path), mass, center, other @ given @ other.T)


def test_yourdfpy_reads_the_same(saved):
    own = write_urdf_inertial(BODY, saved("", "b.urdf"), principal=True)
    for path, link in ((saved(ARM), "upper_arm"), (own, "body")):
        found = yourdfpy.URDF.load(str(path), load_meshes=False, build_scene_graph=False).link_map[link].inertial
        turn = found.origin[:3, :3]
        wanted = turn @ found.inertia @ turn.T
        check(read_urdf_inertial(path, link), found.mass, found.origin[:3, 3], wanted, 10 * EXACT)


def test_written_along_the_given_axes_it_comes_back_bit_for_bit(tmp_path):
    path = write_urdf_inertial(BODY, tmp_path / "body.urdf")
    check(read_urdf_inertial(path), BODY.mass, BODY.center_of_mass, BODY.inertia, 0.0)
    check(BODY, *by_hand(path, "body"), 0.0)


def turned_by(roll, pitch, yaw):
    moments = np.diag([1.0, 1.4, 2.1])
    turn = Rotation.from_euler("xyz", [roll, pitch, yaw]).as_matrix()
    return ph.Body(1.0, (0.0, 0.0, 0.0), turn @ moments @ turn.T)


ANGLES = st.floats(-np.pi, np.pi)


@pytest.mark.long
@given(ANGLES, st.one_of(ANGLES, st.sampled_from([np.pi / 2, -np.pi / 2, np.pi / 2 - 1e-9, np.pi / 2 + 1e-12])), ANGLES)
@settings(max_examples=60, deadline=None)
def test_written_along_the_principal_axes_it_is_diagonal(tmp_path_factory, roll, pitch, yaw):
    body = turned_by(roll, pitch, yaw)
    path = write_urdf_inertial(body, tmp_path_factory.mktemp("urdf") / "body.urdf", principal=True)
    entry = ET.parse(path).getroot().find("link/inertial/inertia")
    assert [float(entry.get(k)) for k in ("ixy", "ixz", "iyz")] == [0.0, 0.0, 0.0]
    assert [float(entry.get(k)) for k in ("ixx", "iyy", "izz")] == body.principal_moments.tolist()
    check(body, *by_hand(path, "body"), 10 * EXACT)
    check(read_urdf_inertial(path), *by_hand(path, "body"), 10 * EXACT)


@pytest.mark.parametrize("name", ["</script>", 'a "b" & <c>', "Трёхосный 陀螺 🪀"])
def test_any_printable_name(tmp_path, name):
    path = write_urdf_inertial(BODY, tmp_path / "body.urdf", name)
    assert read_urdf_inertial(path, name).mass == BODY.mass


def test_defaults_of_the_format(saved):
    text = ARM.replace('<origin rpy="0.3 -1.1 2.7" xyz="0.1 -0.2 0.05"/>', "")
    body = read_urdf_inertial(saved(text))
    assert not body.center_of_mass.any() and body.inertia[0].tolist() == [0.031, -0.002, 0.0015]
    only_place = ARM.replace('rpy="0.3 -1.1 2.7" ', "")
    assert read_urdf_inertial(saved(only_place)).center_of_mass.tolist() == [0.1, -0.2, 0.05]


ONE_LINK = ARM[ARM.index('  <link name="upper_arm">') : ARM.index("  <joint")]
TWO = ARM.replace('<link name="base_link"/>', ONE_LINK.replace("upper_arm", "fore_arm"))


def test_which_link(saved):
    with pytest.raises(InvalidInput, match=r"has 2 links with mass; name one as `link`, or.*: fore_arm, upper_arm"):
        read_urdf_inertial(saved(TWO))
    assert read_urdf_inertial(saved(TWO), "fore_arm").mass == 3.7
    with pytest.raises(InvalidInput, match="has no link 'hand'; those with mass are upper_arm"):
        read_urdf_inertial(saved(ARM), "hand")
    with pytest.raises(FormatError, match=r"link 'base_link' has no <inertial>.*that have are upper_arm"):
        read_urdf_inertial(saved(ARM), "base_link")
    with pytest.raises(InvalidInput, match="has 2 links called 'upper_arm'"):
        read_urdf_inertial(saved(TWO.replace("fore_arm", "upper_arm")), "upper_arm")
    with pytest.raises(FormatError, match="no link has an <inertial>"):
        read_urdf_inertial(saved('<robot name="a"><link name="b"/></robot>'))


BOMB = '<!DOCTYPE robot [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]><robot name="x"><link name="&b;"/></robot>'


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('<mass value="3.7"/>', "", "link 'upper_arm': its <inertial> has no <mass>"),
        ('<mass value="3.7"/>', "<mass/>", "<mass> has no value"),
        ('<mass value="3.7"/>', '<mass value="-1"/>', "`mass` must be positive"),
        ('<mass value="3.7"/>', '<mass value="0"/>', "`mass` must be positive"),
        ('"3.7"', '"3,7"', "value of <mass> must be finite numbers in decimal digits; got '3,7'"),
        ('"3.7"', '"nan"', "must be finite"),
        ('"3.7"', '"${arm_mass}"', "Expand the xacro first"),
        ('ixy="-0.002" ', "", "<inertia> has no ixy"),
        ('ixx="0.031"', 'ixx="0.31"', "I1 \\+ I2 ≥ I3"),
        ('rpy="0.3 -1.1 2.7"', 'rpy="0.3 -1.1"', "rpy of <origin> must be three numbers"),
        ('xyz="0.1 -0.2 0.05"', 'xyz="0.1 -0.2 inf"', "xyz of <origin> must be finite"),
        ("<robot", "<sdf", "is XML|not URDF"),
        (ARM, "", "is not URDF, which is XML"),
        (ARM, "<sdf/>", "outermost element must be <robot>; got <sdf>"),
        (ARM, ARM[:300], "is not URDF, which is XML"),
        (ARM, BOMB, "declares a document type"),
        (ARM, '<?xml version="1.0" encoding="klingon"?><robot/>', "is not URDF"),
    ],
)
def test_files_that_are_wrong(saved, old, new, words):
    assert old in ARM
    with pytest.raises(FormatError, match=rf"(?s)robot\.urdf.*({words})"):
        read_urdf_inertial(saved(ARM.replace(old, new)))


def test_what_cannot_be_written(tmp_path):
    with pytest.raises(InvalidInput, match="URDF holds the mass"):
        write_urdf_inertial(ph.Body.from_moments((1.0, 2.0, 2.5)), tmp_path / "body.urdf")
    for name in ("", "  ", "a\nb", "a\0"):
        with pytest.raises(InvalidInput, match="`name` must be printable"):
            write_urdf_inertial(BODY, tmp_path / "body.urdf", name)
    with pytest.raises(InvalidInput, match="is a folder"):
        write_urdf_inertial(BODY, tmp_path)
    with pytest.raises(InvalidInput, match="no such URDF file"):
        read_urdf_inertial(tmp_path / "none.urdf")
    assert not list(tmp_path.iterdir())


def test_a_spec_takes_a_link(saved, tmp_path):
    saved(TWO)
    spec = saved('[body]\nurdf = "robot.urdf"\nlink = "fore_arm"', "case.toml")
    found = read_spec(spec)
    check(found.body, *by_hand(tmp_path / "robot.urdf", "fore_arm"))
    assert found.surface is None
    mistakes = {
        'urdf = "robot.urdf"': "has 2 links with mass; name one as `link`",
        'urdf = "robot.urdf"\nlink = "fore_arm"\nmass = "1 kg"': "mass follows from the urdf; leave it out",
        'link = "fore_arm"\nmoments = ["1 kg*m^2", "2 kg*m^2", "2 kg*m^2"]': "link goes with urdf, sdf or mjcf",
        'urdf = "robot.urdf"\nmolecule = "a.xyz"': "rotational_constants, part, molecule, urdf, sdf and mjcf; got",
        'urdf = "robot.urdf"\nlink = "fore_arm"\ndensity = "1 kg/m^3"': "density goes with a mesh, not with urdf",
        'urdf = "none.urdf"': "no such URDF file",
    }
    for body, words in mistakes.items():
        with pytest.raises(InvalidInput, match=words):
            read_spec(saved(f"[body]\n{body}", "case.toml"))
