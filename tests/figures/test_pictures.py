"""The three classical pictures: what they draw is the motion, and what hides what is right."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

from polhode.analysis.poinsot import touching_point
from polhode.bodies._turned import ball
from polhode.bodies.body import Body
from polhode.bodies.surface import Surface, cuboid
from polhode.exact.free_body import FreeMotion
from polhode.figures import style
from polhode.figures.axis_figure import axis_locus
from polhode.figures.ellipsoid_figure import inertia_ellipsoid
from polhode.figures.scene import Scene, circle_about, convex_outline, corner_normals
from polhode.figures.sphere import view_frame
from polhode.figures.tilt_figure import top_motion
from polhode.figures.top_figure import spinning_top
from polhode.figures.top_shown import sample_axis, take_top
from polhode.kinds.free_body.answers import free_body_report
from polhode.kinds.reading import read_spec
from polhode.rolling.euler_disk.rolling_figure import _choose_moments, _disk, draw_rolling_disk
from sweeping import first

EXAMPLES = Path(__file__).parents[2] / "examples"
ROUNDING = 1e-12
PIXEL = 0.004  # of what is seen: a few of the image's pixels
FACETS = 2e-3  # a rim of 96 corners lies inside its circle by 1 − cos(π/96) at most, 0.05 %
FLAT_VIEW = np.eye(3)
TILTED = np.array([[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]])


def scene(window=(-1.5, 1.5, -1.2, 1.2), frame=FLAT_VIEW, eye=None):
    return Scene(style.new_figure().add_subplot(), frame, window, eye)


def curve(figure, colour):
    """Return what is drawn in a colour in data coordinates, as points (n, 2) of its thickest line."""
    lines = [a for a in figure.axes[0].lines if to_hex(a.get_color()).upper() == colour.upper()]
    lines = [a for a in lines if len(a.get_xdata()) > 3]  # neither marks nor the legend's
    widest = max(a.get_linewidth() for a in lines)
    points = np.vstack([np.stack(a.get_data(), axis=-1) for a in lines if a.get_linewidth() == widest])
    return points[np.isfinite(points).all(axis=-1)]


# ---------------------------------------------------------------------- solids


def test_a_ball_covers_its_disk_and_hides_what_is_behind():
    picture = scene()
    picture.solid(ball(96), "#808080")
    covered = np.isfinite(picture.depth).sum() * picture.pixel**2
    assert covered == pytest.approx(np.pi, rel=5e-3)
    middle = picture.depth[picture.depth.shape[0] // 2, picture.depth.shape[1] // 2]
    assert middle == pytest.approx(1.0, abs=PIXEL)
    points = np.array([[0, 0, 1.1], [0, 0, 1.0], [0, 0, 0.5], [0, 0, -1], [1.2, 0, -5]])
    assert picture.is_visible(points).tolist() == [True, True, False, False, True]


def test_solids_that_cut_each_other():
    """A rod through a box: seen where it comes out, hidden inside, whichever is drawn first."""
    rod = Surface(cuboid((0.2, 0.2, 2.4)).vertices @ TILTED.T,
                  cuboid((1, 1, 1)).faces)  # fmt: skip
    images = []
    for order in ((0, 1), (1, 0)):
        picture = scene()
        for k in order:
            picture.solid((cuboid((1.0, 1.0, 1.0)), rod)[k], ("#ff0000", "#0000ff")[k])
        images.append(picture.colour.copy())
    assert np.array_equal(*images)
    # along the rod's line on the page: out of the side, under the top face, inside, out of the top, nothing
    for x, wanted in ((-0.6, "blue"), (-0.4, "red"), (0.0, "red"), (0.6, "blue"), (0.9, "none")):
        r, _, b, a = images[0][picture.depth.shape[0] // 2, int((x + 1.5) / picture.pixel)]
        assert ("none" if not a else "red" if r > b else "blue") == wanted, x


def test_perspective_keeps_lines_straight_and_the_order_along_them():
    picture = scene(eye=4.0)
    line = np.linspace([-1.0, -0.5, -1.0], [1.0, 0.7, 1.5], 7)
    x, y, depth = picture.project(line)
    across = (x - x[0]) * (y[-1] - y[0]) - (y - y[0]) * (x[-1] - x[0])
    assert across == pytest.approx(0.0, abs=ROUNDING)
    # linear on the page, so that interpolating between corners is exact
    assert np.interp(x, x[[0, -1]], depth[[0, -1]]) == pytest.approx(depth, rel=ROUNDING)
    assert (np.diff(depth) > 0).all()


def test_normals_are_smooth_but_across_creases():
    smooth = ball(64)
    found = corner_normals(smooth.vertices, smooth.faces)
    assert np.sum(found * smooth.vertices[smooth.faces], axis=-1).min() > np.cos(np.radians(3.0))
    box = cuboid((1.0, 2.0, 3.0))
    found = corner_normals(box.vertices, box.faces)
    assert np.abs(found).max(axis=-1) == pytest.approx(1.0) and np.array_equal(found[:, 0], found[:, 1])


def test_outlines_and_rims():
    turn = np.linspace(0.0, 6.0, 200)
    inside = np.stack([np.cos(turn), np.sin(turn)], -1) * np.linspace(0.1, 0.9, 200)[:, None]
    corners = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    assert convex_outline(np.vstack([inside, corners])) == pytest.approx(corners)
    axis = np.array([0.6, 0.0, 0.8])
    rim = circle_about(axis, 0.3, 2.0)
    assert np.linalg.norm(rim, axis=-1) == pytest.approx(2.0) and rim @ axis == pytest.approx(2.0 * np.cos(0.3))


# ---------------------------------------------------------------------- the inertia ellipsoid


def test_the_point_that_touches():
    """It is on the ellipsoid, its normal is L, and the plane keeps its distance √(2E)/|L|; L itself fails all three."""
    moments = np.array([1.0, 2.0, 2.6])
    motion = FreeMotion(moments, momentum=(0.3, 4.0, 0.2))
    momentum = motion.momentum(np.linspace(0.0, 3.0, 50))
    distance = np.sqrt(2.0 * motion.energy) / motion.momentum_norm

    def broken(point):
        unit = momentum / motion.momentum_norm
        on = np.abs(np.sum(moments * point**2, axis=-1) - 1.0).max()
        normal = moments * point / np.linalg.norm(moments * point, axis=-1, keepdims=True)
        return on, np.abs(normal - unit).max(), np.abs(np.sum(point * unit, axis=-1) - distance).max()

    assert max(broken(touching_point(momentum, moments))) < ROUNDING
    assert min(broken(momentum / motion.momentum_norm)) > 0.1


def test_the_ellipsoid_that_is_drawn_has_the_motions_polhode_on_it():
    report = read_spec(EXAMPLES / "t_handle.toml").report()
    figure = inertia_ellipsoid(report.trajectory)
    frame = view_frame(np.array([0.80, 0.46, 0.38]))
    motion = report.motion
    velocity = motion.angular_velocity(np.linspace(0.0, motion.period, 4000)) / np.sqrt(2.0 * motion.energy)
    wanted = (frame[:2] @ (velocity * np.sqrt(motion.moments[0])).T).T
    drawn = curve(figure, style.BLUE)
    gaps = np.linalg.norm(drawn[::20, None] - wanted[None], axis=-1).min(axis=-1)
    assert gaps.max() < PIXEL
    # its silhouette: where the image ends to the right is √Σ (right_i semi_i)²
    semi = np.sqrt(motion.moments[0] / np.asarray(motion.moments))
    assert drawn[:, 0].max() <= np.linalg.norm(frame[0] * semi) + ROUNDING
    assert "(kg m²)" in figure.axes[0].get_title()


@pytest.mark.parametrize("moments", first(1, [[1.0, 1.9, 1.9], [0.01, 1.0, 1.005], [1.0, 1.0, 1.0], [1.0, 1.0, 1.8]]))
@pytest.mark.parametrize("momentum", first(1, [[0.5, 0.1, 0.5], [0.0, 0.0, 1.0]]))
def test_any_body_and_spin_can_be_drawn(moments, momentum):
    report = free_body_report(Body.from_moments(moments), np.array(momentum), np.array([1.0, 0.0, 0.0, 0.0]))
    assert inertia_ellipsoid(report.trajectory) is not None


# ---------------------------------------------------------------------- the top


@pytest.fixture(scope="module")
def precessing():
    return read_spec(EXAMPLES / "precessing_top.toml").report()


@pytest.mark.long
def test_the_cones_of_steady_precession(precessing):
    """By hand: Ω = p e_z + (w3 − p cos θ) e3, on both cones at all times, the angles adding up to the tilt."""
    path, tilt, p = sample_axis(take_top(precessing.trajectory)), np.radians(30.0), precessing.steady.slow
    spin = 253.0 * np.pi / 30.0 + p * np.cos(tilt)
    unit = path.velocity / np.linalg.norm(path.velocity, axis=-1, keepdims=True)
    in_space, in_body = np.arccos(unit[:, 2]), np.arccos(np.sum(unit * path.axis, axis=-1))
    body = np.arctan2(p * np.sin(tilt), spin)
    assert in_body == pytest.approx(body, abs=1e-9) and in_space == pytest.approx(tilt - body, abs=1e-9)
    figure = spinning_top(precessing.trajectory, surface=precessing.surface)
    words = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert "space cone of Ω" in words and "body cone of Ω" in words
    # the rims as drawn touch
    red, green = (curve(figure, colour) for colour in (style.HERPOLHODE, style.BODY_CONE))
    assert np.linalg.norm(red[:, None] - green[None], axis=-1).min() < 0.02


def test_a_tilt_constant_to_rounding_is_steady_in_words_and_pictures(precessing):
    values = precessing.as_json_dict()
    assert values["regime"] == "undulating" and precessing.constant_tilt
    assert "precesses steadily" in precessing.summary and "nutates" not in precessing.summary
    assert f"{values['precession_rate']:.6g} rad/s" in precessing.summary
    figure = axis_locus(precessing.trajectory)
    assert "steady" in figure.axes[0].get_title()
    assert not any(to_hex(line.get_color()).upper() == style.VERMILION for line in figure.axes[0].lines)
    figure = top_motion(precessing.trajectory)
    figure.canvas.draw()
    low, high = figure.axes[0].get_ylim()
    assert low == pytest.approx(29.5) and high == pytest.approx(30.5)
    assert not any(axis.get_offset_text().get_text() for axes in figure.axes for axis in (axes.xaxis, axes.yaxis))
    nodding = read_spec(EXAMPLES / "top.toml").report()
    assert not nodding.constant_tilt and "nutates" in nodding.summary


def test_a_nodding_top_stays_between_two_cones():
    report = read_spec(EXAMPLES / "top.toml").report()
    figure = spinning_top(report.trajectory, surface=report.surface)
    words = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert words == ["tip of the axis", "cones at its least and largest tilt"]
    assert {text.get_text() for text in figure.axes[0].texts} >= {"L", "Ω", "mg"}


def test_tops_without_a_shape_or_a_weight(tmp_path):
    text = (EXAMPLES / "top.toml").read_text()
    free = tmp_path / "free.toml"
    free.write_text(text.replace('pivot = ["0 m", "0 m", "0 m"]', 'pivot = ["0 m", "0 m", "0.0315625 m"]').replace(
        'lean = "20 deg"', ""))  # fmt: skip
    assert spinning_top(read_spec(free).report().trajectory) is None
    given = tmp_path / "given.toml"
    given.write_text("""
[body]
mass = "64 g"
moments = ["1.2e-5 kg*m^2", "1.2e-5 kg*m^2", "1.6e-5 kg*m^2"]
[system]
kind = "lagrange-top"
pivot = ["0 cm", "0 cm", "-3 cm"]
lean = "20 deg"
[spin]
rate = "1500 rpm"
about = "z"
""")
    assert spinning_top(read_spec(given).report().trajectory) is not None  # as the box of the same inertia


# ---------------------------------------------------------------------- the disk


@pytest.mark.parametrize("system", first(0, ['tilt = "60 deg"\nprecession = "5 rad/s"',
                                             'tilt = "10 deg"\nthickness = "4 mm"']))  # fmt: skip
def test_a_disk_touches_the_plane_where_it_should(tmp_path, system):
    path = tmp_path / "coin.toml"
    path.write_text(f'[system]\nkind = "euler-disk"\nmass = "10 g"\nradius = "15 mm"\n{system}\n')
    report = read_spec(path).report()
    times, states = _choose_moments(report)
    assert len(times) > 3 and (np.diff(times) > 0).all()
    for state in states:
        placed = _disk(report, state)
        lowest = placed.vertices[np.argmin(placed.vertices[:, 2])]
        half = 0.5 * (0.02 * 0.015 if report.disk.is_thin else 0.0)  # a thin disk is drawn a little thick
        assert abs(lowest[2]) < FACETS * 0.015 + half
        contact = placed.vertices[:, :2] - state[3:5]
        touching = np.abs(placed.vertices[:, 2] - placed.vertices[:, 2].min()) < 1e-4 * 0.015
        assert np.linalg.norm(contact[touching], axis=-1).min() < 0.05 * 0.015 + half
    figure = draw_rolling_disk(report)
    assert any("mm" in text.get_text() for text in figure.axes[0].texts) and "°" in figure.axes[0].get_title()


@pytest.mark.parametrize("eye", [None, 6.0])
def test_far_sides_left_out_change_no_pixel(monkeypatch, eye):
    """Of a closed solid; where a triangle is missing, or it is inside out, all sides are drawn."""
    from polhode.figures import scene as module

    solid = ball(24)
    assert module._is_closed(solid.vertices, solid.faces)
    assert not module._is_closed(solid.vertices, solid.faces[1:])
    assert not module._is_closed(solid.vertices, solid.faces[:, ::-1])
    drawn = []
    for closed in (True, False):
        monkeypatch.setattr(module, "_is_closed", lambda *_, closed=closed: closed)
        window = scene(eye=eye)
        window.solid(solid, "#336699")
        drawn.append(window.colour)
    assert np.array_equal(*drawn) and (drawn[0][..., 3] > 0.0).any()
