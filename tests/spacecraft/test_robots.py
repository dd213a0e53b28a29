"""Robots as one body at a pose: URDF, SDF and MJCF against other programs and against products of matrices."""

import math
import re
import warnings

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from polhode.errors import FormatError, InvalidInput
from polhode.kinds.reading import read_spec
from polhode.spacecraft.formats.mjcf import read_mjcf_inertial, read_mjcf_robot
from polhode.spacecraft.formats.sdf import read_sdf_inertial, read_sdf_robot
from polhode.spacecraft.formats.urdf import read_urdf_robot

EXACT = 1e-12
URDF = """<robot name="arm">
<link name="base"><inertial><origin xyz="0.1 0 0.2" rpy="0.1 0.2 0.3"/><mass value="5"/>
  <inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.4" iyz="-0.03" izz="0.5"/></inertial></link>
<link name="upper"><inertial><origin xyz="0 0.1 0.3"/><mass value="2"/>
  <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.12" iyz="0" izz="0.05"/></inertial></link>
<link name="tool"><inertial><origin xyz="0 0 0.05" rpy="0 1 0"/><mass value="0.5"/>
  <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.004"/></inertial></link>
<link name="finger"><inertial><mass value="0.1"/>
  <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial></link>
<link name="camera"/>
<link name="marker"><inertial><mass value="0"/>
  <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
  <origin xyz="0.2 -0.1 0.4" rpy="0.5 -0.2 0.1"/><axis xyz="0.6 0 0.8"/>
  <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="slide" type="prismatic"><parent link="upper"/><child link="tool"/>
  <origin xyz="0 0 0.5" rpy="0 0 1"/><axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="grip" type="prismatic"><parent link="tool"/><child link="finger"/><axis xyz="0 1 0"/>
  <mimic joint="slide" multiplier="-0.5" offset="0.02"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="eye" type="fixed"><parent link="tool"/><child link="camera"/></joint>
<joint name="mark" type="fixed"><parent link="camera"/><child link="marker"/></joint>
</robot>"""
POSE = {"shoulder": (0.7, "rad"), "slide": (0.3, "m")}


def put_together(pieces):
    """Return mass, centre and inertia of pieces (mass, 4×4 place of its inertial frame, inertia)."""
    mass = sum(m for m, _, _ in pieces)
    center = sum(m * T[:3, 3] for m, T, _ in pieces) / mass
    inertia = np.zeros((3, 3))
    for m, T, J in pieces:
        d = T[:3, 3] - center
        inertia += T[:3, :3] @ J @ T[:3, :3].T + m * (d @ d * np.eye(3) - np.outer(d, d))
    return mass, center, inertia


def check(body, expected, allowed=EXACT):
    mass, center, inertia = expected
    assert body.mass == pytest.approx(mass, rel=allowed)
    assert body.center_of_mass == pytest.approx(center, abs=allowed)
    assert body.inertia == pytest.approx(inertia, abs=allowed * np.abs(inertia).max())


@pytest.fixture
def saved(tmp_path):
    def save(text, name):
        path = tmp_path / name
        path.write_text(text, "utf-8")
        return path

    return save


def test_urdf_against_yourdfpy(saved):
    yourdfpy = pytest.importorskip("yourdfpy")
    path = saved(URDF, "arm.urdf")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        robot = yourdfpy.URDF.load(str(path), load_meshes=False)
        robot.update_cfg({name: value for name, (value, _) in POSE.items()})
    pieces = []
    for name, link in robot.link_map.items():
        if link.inertial is not None and link.inertial.mass:
            inner = np.eye(4) if link.inertial.origin is None else link.inertial.origin
            pieces.append((link.inertial.mass, robot.get_transform(name, "base") @ inner, link.inertial.inertia))
    check(read_urdf_robot(path, POSE), put_together(pieces))
    with pytest.raises(AssertionError):
        check(read_urdf_robot(path, POSE | {"slide": (0.3001, "m")}), put_together(pieces))


def homogeneous(R=None, d=(0.0, 0.0, 0.0)):
    T = np.eye(4)
    T[:3, :3] = np.eye(3) if R is None else R.as_matrix()
    T[:3, 3] = d
    return T


SDF = """<sdf version="1.9"><model name="arm">
<link name="base"><pose>0 0 1 0 0 0.3</pose><inertial><pose>0.1 0 0.2 0.1 0.2 0.3</pose><mass>5</mass>
 <inertia><ixx>0.3</ixx><ixy>0.01</ixy><ixz>0.02</ixz><iyy>0.4</iyy><iyz>-0.03</iyz><izz>0.5</izz></inertia></inertial></link>
<link name="arm"><pose relative_to="base">0.5 0 0 0 0.4 0</pose><inertial><mass>2</mass>
 <inertia><ixx>0.1</ixx><iyy>0.12</iyy><izz>0.05</izz></inertia></inertial></link>
<link name="hand"><pose relative_to="arm" degrees="true">0 0 0.6 90 0 0</pose><inertial><mass>1</mass>
 <inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial></link>
<joint name="hinge" type="revolute"><pose>0 0 -0.1 0 0 0</pose><parent>base</parent><child>arm</child>
 <axis><xyz>0 1 1</xyz></axis></joint>
<joint name="rail" type="prismatic"><parent>arm</parent><child>hand</child>
 <axis><xyz expressed_in="__model__">0 0 1</xyz></axis></joint>
</model></sdf>"""


def test_sdf_by_products_of_matrices(saved):
    """Each link's place at zero, then the joints above it rotated or moved in the model."""
    base = homogeneous(Rotation.from_euler("xyz", [0, 0, 0.3]), (0, 0, 1))
    arm = base @ homogeneous(Rotation.from_euler("xyz", [0, 0.4, 0]), (0.5, 0, 0))
    hand = arm @ homogeneous(Rotation.from_euler("xyz", [90, 0, 0], degrees=True), (0, 0, 0.6))
    joint = arm @ homogeneous(d=(0, 0, -0.1))
    turn = homogeneous(Rotation.from_rotvec(0.8 * np.array([0, 1, 1]) / math.sqrt(2)))
    hinged = joint @ turn @ np.linalg.inv(joint)
    slid = hinged @ homogeneous(d=(0, 0, 0.25)) @ hand
    inner = homogeneous(Rotation.from_euler("xyz", [0.1, 0.2, 0.3]), (0.1, 0, 0.2))
    full = np.array([[0.3, 0.01, 0.02], [0.01, 0.4, -0.03], [0.02, -0.03, 0.5]])
    pieces = [(5.0, base @ inner, full), (2.0, hinged @ arm, np.diag([0.1, 0.12, 0.05])), (1.0, slid, 0.01 * np.eye(3))]
    path = saved(SDF, "arm.sdf")
    check(read_sdf_robot(path, {"hinge": (0.8, "rad"), "rail": (0.25, "m")}), put_together(pieces))
    one = read_sdf_inertial(path, "base")
    R = inner[:3, :3]
    assert one.inertia == pytest.approx(R @ full @ R.T, rel=EXACT, abs=EXACT)
    assert one.center_of_mass.tolist() == [0.1, 0.0, 0.2]


MJCF = """<mujoco><compiler angle="degree" eulerseq="xyz"/>
<default><joint axis="0 1 0"/><default class="rail"><joint type="slide" axis="0 0 2"/></default></default>
<worldbody><body name="base" pos="1 2 3" quat="0.5 0.5 0.5 0.5">
 <inertial pos="0.1 0 0.2" mass="5" fullinertia="0.3 0.4 0.5 0.01 0.02 -0.03"/><freejoint/>
 <body name="arm" pos="0.2 -0.1 0.4" euler="30 -20 10">
  <joint name="hinge" pos="0 0 -0.1"/><joint name="twist" axis="1 0 1" ref="15"/>
  <inertial pos="0 0.1 0.3" quat="1 0.2 0 0.1" mass="2" diaginertia="0.1 0.12 0.05"/>
  <body name="hand" pos="0 0 0.6" axisangle="0 1 1 40" childclass="rail">
   <joint name="rail"/><inertial pos="0 0 0.05" mass="0.5" diaginertia="0.01 0.01 0.004" zaxis="1 1 1"/>
   <body name="tip" xyaxes="0 1 0 -1 0 0.2" pos="0 0.1 0">
    <inertial pos="0 0 0" mass="0.1" diaginertia="1e-3 1e-3 1e-3"/></body>
   <body name="frame"/></body></body></body></worldbody></mujoco>"""
# at hinge = 0.7 rad, twist = −0.4 rad, rail = 0.3 m: mass, centre and inertia in the base, by MuJoCo 3.5.0
# (mj_kinematics, then body_mass, xipos, ximat and body_inertia summed)
BY_MUJOCO = (
    7.6,
    [0.2212778823209, 0.009720671812773, 0.4041225503664],
    [[1.144740852341, -0.001173033832401, -0.435166248441],
     [-0.001173033832401, 1.524176843319, -0.03485805014993],
     [-0.435166248441, -0.03485805014993, 0.8391927199873]],
)


def test_mjcf_against_mujoco(saved):
    pose = {"hinge": (0.7, "rad"), "twist": (-0.4, "rad"), "rail": (0.3, "m")}
    body = read_mjcf_robot(saved(MJCF, "arm.xml"), pose)
    check(body, tuple(map(np.array, BY_MUJOCO)), 1e-9)  # MuJoCo turns a full inertia to principal axes by iteration
    with pytest.raises(AssertionError):
        check(read_mjcf_robot(saved(MJCF, "arm.xml"), pose | {"twist": (-0.3999, "rad")}), BY_MUJOCO, 1e-9)
    one = read_mjcf_inertial(saved(MJCF, "arm.xml"), "base")
    assert one.inertia.tolist() == [[0.3, 0.01, 0.02], [0.01, 0.4, -0.03], [0.02, -0.03, 0.5]]


def test_through_a_spec(saved):
    saved(URDF, "arm.urdf")
    joints = '[body.joints]\nshoulder = "0.7 rad"\nslide = "30 cm"\n'
    spec = read_spec(saved(f'[body]\nurdf = "arm.urdf"\n{joints}', "a.toml"))
    check(spec.body, (lambda b: (b.mass, b.center_of_mass, b.inertia))(read_urdf_robot(spec.folder / "arm.urdf", POSE)))
    saved(SDF, "arm.sdf")
    assert read_spec(saved('[body]\nsdf = "arm.sdf"\nlink = "arm"\n', "b.toml")).body.mass == 2.0
    saved(MJCF, "arm.xml")
    assert read_spec(saved('[body]\nmjcf = "arm.xml"\njoints = {}\n', "c.toml")).body.mass == pytest.approx(7.6)


SDF_LIMITS = "<axis><xyz>0 1 1</xyz><limit><lower>-1</lower><upper>{}</upper></limit></axis>"
LIMITS = [
    (read_urdf_robot, URDF, {"shoulder": (2.5, "rad")}, "'shoulder' at 2.5 rad, beyond -2 to 2"),
    (read_urdf_robot, URDF, {"slide": (-0.1, "m")}, "'slide' at -0.1 m, beyond 0 to 1"),
    (read_urdf_robot, URDF, {"slide": (1.0, "m"), "shoulder": (-2.0, "rad")}, None),
    (read_urdf_robot, URDF.replace('lower="-1" upper="1"', 'lower="0" upper="1"'), {"slide": (0.5, "m")},
     "'grip' at -0.23 m, beyond 0 to 1"),
    (read_urdf_robot, URDF.replace('lower="0" upper="1"', 'lower="0" upper="0"'), {"slide": (1.9, "m")}, None),
    (read_urdf_robot, URDF.replace('lower="0" upper="1"', 'lower="0.2" upper="1"'), {}, "'slide' at 0 m, beyond 0.2"),
    (read_sdf_robot, SDF.replace("<axis><xyz>0 1 1</xyz></axis>", SDF_LIMITS.format("0.5")), {"hinge": (0.8, "rad")},
     "'hinge' at 0.8 rad, beyond -1 to 0.5"),
    (read_sdf_robot, SDF.replace("<axis><xyz>0 1 1</xyz></axis>", SDF_LIMITS.format("inf")), {"hinge": (8.0, "rad")},
     None),
    (read_mjcf_robot, MJCF.replace('<joint name="rail"', '<joint name="rail" range="-1 2"'), {"rail": (3.0, "m")},
     "'rail' at 3 m, beyond -1 to 2"),
    (read_mjcf_robot, MJCF.replace('ref="15"', 'ref="15" range="-90 90"'), {"twist": (2.0, "rad")},
     "'twist' at 2 rad, beyond -1.5708 to 1.5708"),
    (read_mjcf_robot, MJCF.replace('ref="15"', 'ref="15" range="-90 90" limited="false"'), {"twist": (2.0, "rad")},
     None),
    (read_mjcf_robot,
     MJCF.replace('ref="15"', 'ref="15" range="-90 90"').replace("eulerseq", 'autolimits="false" eulerseq'),
     {"twist": (2.0, "rad")}, None),
]  # fmt: skip


@pytest.mark.parametrize(("read", "text", "pose", "words"), LIMITS)
def test_poses_beyond_limits_are_said(saved, read, text, pose, words):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert read(saved(text, "arm.xml"), pose).mass > 3.0
    said = [str(one.message) for one in caught]
    assert said == [] if words is None else len(said) == 1 and words in said[0]


WRONG = {
    ("urdf", '[body.joints]\nelbow = "1 rad"'): "has no joint 'elbow'; those that can be set are shoulder, slide",
    ("urdf", '[body.joints]\nslide = "1 rad"'): "joint 'slide' must be at a distance like \"10 cm\"",
    ("urdf", '[body.joints]\nshoulder = "1 m"'): "joint 'shoulder' must be at an angle like \"30 deg\"",
    ("urdf", '[body.joints]\ngrip = "1 m"'): "joint 'grip' follows 'slide'; set that one",
    ("urdf", '[body.joints]\neye = "1 m"'): "joint 'eye' is fixed, or has more than one coordinate, and cannot be set",
    ("urdf", '[body.joints]\nshoulder = "1 kg"'): '1 mistake:\n  body.joints.shoulder: must be an angle like "30 deg"',
    ("urdf", 'joints = "all"'): 'a.toml has 1 mistake:\n  body.joints: must be a table of positions, like { elbow',
    ("urdf", 'link = "base"\njoints = {}'): "link names one link, and joints put all of them together",
    ("urdf", 'mass = "1 kg"\njoints = {}'): "mass follows from the urdf",
    ("sdf", ""): "has 3 links; name one as `link`",
    ("mjcf", 'link = "frame"'): "has no body 'frame' with mass; those with mass are base, arm, hand, tip",
}


@pytest.mark.parametrize(("kind", "keys"), WRONG)
def test_poses_that_are_refused(saved, kind, keys):
    saved({"urdf": URDF, "sdf": SDF, "mjcf": MJCF}[kind], f"arm.{kind}")
    with pytest.raises(InvalidInput) as caught:
        read_spec(saved(f'[body]\n{kind} = "arm.{kind}"\n{keys}\n', "a.toml"))
    assert WRONG[kind, keys] in str(caught.value)


BROKEN = {
    "urdf": [
        (('<parent link="tool"/><child link="camera"', '<parent link="nil"/><child link="camera"'), "no link 'nil'"),
        (('<child link="upper"/>', '<child link="base"/>'), "must make one tree"),
        (('type="revolute"', 'type="bent"'), "its type must be one of"),
        (('xyz="0.6 0 0.8"', 'xyz="0 0 0"'), "must not be zero"),
        (('mimic joint="slide"', 'mimic joint="grip"'), "follows itself"),
        (('ixx="0.1" ixy="0"', 'ixx="0.1" ixy="a"'), "finite numbers in decimal digits"),
        (('iyy="0.12"', 'iyy="0.1500001"'), 'say rounding = "7 digits"'),
    ],
    "sdf": [
        (('relative_to="base"', 'relative_to="hand"'), "goes round in circles"),
        (('relative_to="base"', 'relative_to="nil"'), "names 'nil', which is not one link, joint or frame"),
        (("<mass>2</mass>", ""), "has no <mass>, for which SDF puts 1 kg. Add"),
        (("<parent>arm</parent>", "<parent>hand</parent>"), "make a ring"),
        (('<model name="arm">', '<model name="arm"><include/>'), "has a <include> in it"),
        (("<ixx>0.1</ixx>", "<ixx>0.3</ixx>"), "must satisfy I1 + I2 ≥ I3"),
    ],
    "mjcf": [
        (('pos="0 0.1 0.3" quat', 'pos="0 0.1 0.3" euler="1 2 3" quat'), "says its orientation 2 times"),
        (('<body name="frame"/>', '<body name="frame"><geom size="1"/></body>'), "takes its mass from its geoms"),
        (("<worldbody>", '<include file="a.xml"/><worldbody>'), "has an <include>"),
        (('eulerseq="xyz"', 'balanceinertia="true"'), "changes masses and inertias"),
        (('type="slide"', 'type="screw"'), 'its type must be one of "hinge", "slide", "ball", "free"'),
        (("</worldbody>", '<body name="second"/></worldbody>'), "must have one outermost body"),
        (('fullinertia="0.3 0.4', 'diaginertia="1 1 1" fullinertia="0.3 0.4'), "must have one of"),
        (('eulerseq="xyz"', 'eulerseq="xyy2"'), "eulerseq"),
    ],
}


@pytest.mark.parametrize(("kind", "change", "words"), [(k, c, w) for k, cases in BROKEN.items() for c, w in cases])
def test_broken_robots(saved, kind, change, words):
    text = {"urdf": URDF, "sdf": SDF, "mjcf": MJCF}[kind]
    assert change[0] in text
    reader = {"urdf": read_urdf_robot, "sdf": read_sdf_robot, "mjcf": read_mjcf_robot}[kind]
    with pytest.raises(FormatError) as caught:
        reader(saved(text.replace(*change), f"arm.{kind}"), {})
    assert words in str(caught.value)


@pytest.mark.parametrize("kind", ["urdf", "sdf"])
def test_all_links_that_are_no_bodies_are_named_at_once(saved, kind):
    mass, wrong, text = {
        "urdf": (r'<mass value="[^"]*"/>', '<mass value="-1"/>', URDF),
        "sdf": ("<mass>[^<]*</mass>", "<mass>-1</mass>", SDF),
    }[kind]
    text, count = re.subn(mass, wrong, text)
    reader = {"urdf": read_urdf_robot, "sdf": read_sdf_robot}[kind]
    with pytest.raises(FormatError, match=f"{count} of {count} links have faulty mass properties") as caught:
        reader(saved(text, f"arm.{kind}"), {})
    assert str(caught.value).count("mass") > count and str(caught.value).count(f"arm.{kind}") == 1
