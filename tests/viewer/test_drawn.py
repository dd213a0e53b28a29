"""What is drawn obeys the mechanics: read from the scenes of real pages, in a browser."""

from dataclasses import replace

import numpy as np
import pytest

import polhode as ph
from polhode.kinds.page import write_page
from polhode.systems import FreeRigidBody
from sweeping import only

pytestmark = pytest.mark.browser
TOUCH = 1e-6
"""Of the ellipsoid's size: what the page promises."""
SAME_LENGTH = 1e-6
"""Of an arc's length, after Richardson's step; chords alone would be short by h²/24."""
BETWEEN = 1e-12
"""Of a turn: the page solves the motion at any time, and 1e-12 of a matrix of single precision is not asked for."""
AT_REST = 1e-5
"""Of |Ω| times the distance: five-point differences at steps of some hundredths of a radian leave 1e-7 or less."""
ON_LINE = 3e-6
"""Of the sphere's radius: chords of the drawn polhode miss it by up to 2e-6, where L runs between its long stays."""

HALTS = 1e-4
"""Of the height of the axis, by which samples may miss its turning points."""
SLOW = [pytest.param(name, marks=pytest.mark.sweep) for name in ("dual_spin", "explorer_1")]
"""Whose reports are compiled for ten seconds."""
SMALL = {"viewport": {"width": 720, "height": 500}}


def matrix(elements):
    return np.array(elements).reshape(4, 4).T


def distance_to_path(point, path):
    """Return the distance of a point from a line through points (n, 3)."""
    start, step = path[:-1], np.diff(path, axis=0)
    length = np.maximum(np.sum(step * step, axis=1), 1e-300)
    part = np.clip(np.sum((point - start) * step, axis=1) / length, 0.0, 1.0)
    return float(np.linalg.norm(start + part[:, None] * step - point, axis=1).min())


def arc(points):
    """Return the length of the curve through an odd number of points: (4 S(h) − S(2h))/3."""

    def chords(points):
        return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()

    return (4.0 * chords(points) - chords(points[::2])) / 3.0


def touching(drawn):
    """Return by how much the ellipsoid misses the plane, the contact's marker both of them, over the size."""
    ellipsoid, plane = matrix(drawn["ellipsoid"])[:3, :3], matrix(drawn["plane"])
    normal, place = plane[:3, 2] / np.linalg.norm(plane[:3, 2]), plane[:3, 3]
    lowest = -ellipsoid @ ellipsoid.T @ normal / np.linalg.norm(ellipsoid.T @ normal)
    size = np.linalg.norm(ellipsoid, axis=0).max()
    return abs(normal @ (lowest - place)) / size, np.linalg.norm(lowest - drawn["contact"]) / size


def slipping(drawn):
    """Return how much longer the herpolhode is than the polhode, relative, and how fast the contact moves."""
    polhode, herpolhode = (np.reshape(drawn[name], (-1, 3)) for name in ("polhode", "herpolhode"))
    odd = len(polhode) - (len(polhode) + 1) % 2
    return abs(arc(herpolhode[:odd]) / arc(polhode[:odd]) - 1.0)


def contact_speed(page, k):
    """Return the speed of the body's point at the contact over |Ω| times its distance, by five-point differences."""
    turns = {}
    for j in (-2, -1, 0, 1, 2):
        page.seek(k + j)
        turns[j] = page.measure("poinsot", "bodyMatrix", "contact")
    bodies = {j: matrix(found["bodyMatrix"])[:3, :3] for j, found in turns.items()}
    times = page.times()
    step = times[k + 1] - times[k]
    own = bodies[0].T @ np.array(turns[0]["contact"])
    rate = (8.0 * (bodies[1] - bodies[-1]) - (bodies[2] - bodies[-2])) / (12.0 * step)
    return np.linalg.norm(rate @ own) / (np.linalg.norm(rate, 2) * np.linalg.norm(own))


def check_rolls(page):
    """Fail unless the drawn ellipsoid rolls on the drawn plane without slipping."""
    last = page.count() - 1
    drawn = page.measure("poinsot")
    for k in (0, last // 3, last // 2, last):
        page.seek(k)
        drawn |= page.measure("poinsot", "ellipsoid", "plane", "contact", "bodyMatrix", "spaceMatrix", "shown")
        assert max(touching(drawn)) < TOUCH
        at = matrix(drawn["bodyMatrix"])[:3, :3].T @ drawn["contact"]
        assert distance_to_path(at, np.reshape(drawn["polhode"], (-1, 3))) < ON_LINE
        in_space = matrix(drawn["spaceMatrix"])[:3, :3].T @ drawn["contact"]
        assert distance_to_path(in_space, np.reshape(drawn["herpolhode"], (-1, 3))) < ON_LINE
        assert drawn["shown"] == k
    for k in np.linspace(0, last - 1, 9).round() + 0.5:
        page.seek(float(k))
        assert max(touching(page.measure("poinsot", "ellipsoid", "plane", "contact"))) < TOUCH
    assert slipping(drawn) < SAME_LENGTH
    assert max(contact_speed(page, k) for k in (last // 5, last - 2)) < AT_REST


@pytest.mark.parametrize("name", only(["t_handle"], ["t_handle", "water", "apophis"]))
def test_ellipsoid_rolls_without_slipping(example_page, opened, name):
    page = opened(example_page(name), **SMALL)
    check_rolls(page)
    assert not page.complaints and page.requests == [page.url]


@pytest.mark.parametrize("places", only([5], [5, 15]))
def test_coarse_steps_roll_too(opened, tmp_path, places):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    page = opened(write_page(motion.sample(np.linspace(0.0, 3000.0, 300)), tmp_path / "coarse.html"), **SMALL)
    times, worst = np.array(page.times()), 0.0
    assert np.diff(times).max() * np.linalg.norm(motion.angular_velocity(times), axis=-1).max() > 0.24  # rad
    for k in np.linspace(0, len(times) - 2, places).round():
        for part in (0.25, 0.5, 0.9):
            page.seek(k + part)
            drawn = page.measure("poinsot", "ellipsoid", "plane", "contact", "bodyMatrix", "spaceMatrix")
            worst = max(worst, *touching(drawn))
            attitude = matrix(drawn["spaceMatrix"])[:3, :3].T @ matrix(drawn["bodyMatrix"])[:3, :3]
            time = times[int(k)] + part * (times[int(k) + 1] - times[int(k)])
            assert np.abs(attitude - ph.rotation.as_matrix(motion.attitude(time))).max() < BETWEEN
    assert worst < TOUCH
    assert slipping(page.measure("poinsot")) < SAME_LENGTH


def test_plane_too_low_is_found(opened, tmp_path):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    stepped = replace(motion.sample(np.linspace(0.0, 20.0, 1001)), source=FreeRigidBody((1.0, 2.0, 3.0)))
    path = write_page(stepped, tmp_path / "low.html")
    text = path.read_text("utf-8")
    assert text.count('"free":[1.0,') == 1
    path.write_text(text.replace('"free":[1.0,', '"free":[1.0001,'), "utf-8")
    page = opened(path, **SMALL)
    with pytest.raises(AssertionError):
        check_rolls(page)


def test_body_that_turns_too_fast_is_found(opened, tmp_path):
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    right = motion.sample(np.linspace(0.0, 20.0, 1001))
    right = replace(right, source=FreeRigidBody((1.0, 2.0, 3.0)))
    check_rolls(opened(write_page(right, tmp_path / "right.html"), **SMALL))
    faster = replace(right, attitude=motion.attitude(1.001 * right.times))
    wrong = opened(write_page(faster, tmp_path / "wrong.html"), **SMALL)
    wrong.seek(1000)
    drawn = wrong.measure("poinsot")
    assert max(touching(drawn)) > TOUCH and slipping(drawn) > SAME_LENGTH
    assert contact_speed(wrong, 500) > AT_REST


@pytest.mark.parametrize("name", [*only(["water"], ["t_handle", "water"]), *SLOW])
def test_running_point_is_on_the_drawn_path(example_page, opened, name):
    page = opened(example_page(name), **SMALL)
    last = page.count() - 1
    drawn = page.measure("sphere")
    for k in (0, last // 7, last // 5, 2 * last // 5, last // 2, last):
        page.seek(k)
        drawn |= page.measure("sphere", "point")
        point, path = np.array(drawn["point"]), np.reshape(drawn["path"], (-1, 3))
        assert distance_to_path(point, path) < ON_LINE
        assert distance_to_path(1.0001 * point, path) > ON_LINE
        assert np.linalg.norm(point) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("name", ["t_handle", "top", *SLOW])
def test_axis_ends_on_its_trace(example_page, opened, name):
    page = opened(example_page(name))
    last = page.count() - 1
    for k in (0, last // 3, last):
        page.seek(k)
        drawn = page.measure("body")
        trace = np.reshape(drawn["trace"], (-1, 3)) @ space_of(page).T
        assert np.linalg.norm(trace[-1] - drawn["axisTip"]) < ON_LINE
    page.picture(name)
    assert not page.complaints and page.requests == [page.url]


def space_of(page):
    """Return the rotation from space to the picture, known from the data, not from the scene."""
    w, x, y, z = page.tab.evaluate("JSON.parse(document.getElementById('motion').textContent).space")
    return ph.rotation.as_matrix(np.array([w, x, y, z]))


def test_top_stays_between_its_circles(example_page, opened):
    page = opened(example_page("top"), **SMALL)
    drawn = page.measure("axis")
    path, (low, high) = np.reshape(drawn["path"], (-1, 3)), sorted(drawn["limits"])
    for k in (0, int(path[:, 2].argmin()), int(path[:, 2].argmax()), len(path) - 1):
        page.seek(k)
        assert distance_to_path(np.array(page.measure("axis", "point")["point"]), path) < ON_LINE
    assert low - TOUCH < path[:, 2].min() < low + HALTS and high - HALTS < path[:, 2].max() < high + TOUCH


@pytest.mark.sweep
def test_disk_touches_the_plane_at_its_contact(example_page, opened):
    page = opened(example_page("euler_disk"))
    last = page.count() - 1
    for k in (0, last // 2, last - 5):
        page.seek(k)
        drawn = page.measure("disk")
        coin = matrix(drawn["coin"])
        turned, center = coin[:3, :3], coin[:3, 3]
        # the lowest point of the lower rim
        down = turned.T @ np.array([0.0, 0.0, -1.0])
        rim = down[:2] / np.linalg.norm(down[:2])
        lowest = turned @ np.array([*rim, np.sign(down[2]) * drawn["half"]]) + center
        assert np.linalg.norm(lowest - drawn["point"]) < TOUCH
        assert distance_to_path(np.array(drawn["point"]), np.reshape(drawn["path"], (-1, 3))) < ON_LINE
    page.picture("euler_disk")
    assert not page.complaints and page.requests == [page.url]
