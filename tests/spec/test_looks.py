"""Looks that a spec can name: they paint the body where it is, go with what they can paint, and change no motion."""

import re
from pathlib import Path

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec
from polhode.motion.frame import BodyFrame
from polhode.spec.looks import LAND, LOOKS, OCEAN
from polhode.spec.models import LOOK_SOURCES

EXAMPLES = Path(__file__).parents[2] / "examples"
PAINTED = {"book": "book", "smartphone": "phone", "earth": "earth", "t_handle": "metal", "gyroscope": "gyroscope",
           "dual_spin": "satellite", "explorer_1": "rocket", "top": "top"}  # fmt: skip
OF_LAND = 0.29
"""Of the Earth's surface: 148.9 of 510.1 million km², in every atlas."""
OUTSIDE = 0.03
"""Of the size: camera and title stand out of a body by so much at most."""


def spec_of(example):
    return read_spec(EXAMPLES / f"{example}.toml")


def test_every_look_is_a_choice_and_is_shown_by_an_example():
    assert set(LOOKS) == set(LOOK_SOURCES) == set(PAINTED.values())


@pytest.mark.parametrize(("example", "look"), PAINTED.items())
def test_a_look_paints_the_body_where_it_is(example, look, tmp_path):
    spec = spec_of(example)
    assert spec.source.look == look and spec.picture.colors is not None
    text = (EXAMPLES / f"{example}.toml").read_text("utf-8").replace(f'look = "{look}"\n', "")
    plain_file = EXAMPLES / f"{example}.toml" if spec.source.mesh else tmp_path / "plain.toml"
    if spec.source.mesh is None:
        plain_file.write_text(text, "utf-8")
        plain = read_spec(plain_file)
        assert np.array_equal(plain.body.inertia, spec.body.inertia)
        assert plain.picture is plain.surface
    if spec.surface is not None:
        own, drawn = (np.asarray(one.vertices) for one in (spec.surface, spec.picture))
        size = np.ptp(own, axis=0).max()
        assert np.abs(own.min(axis=0) - drawn.min(axis=0)).max() < OUTSIDE * size
        assert np.abs(own.max(axis=0) - drawn.max(axis=0)).max() < OUTSIDE * size


def color_at(picture, longitude, latitude):
    """Return the colour next to a place [degrees]; the Earth's pole is its axis z, its prime meridian axis x."""
    a, b = np.radians([longitude, latitude])
    place = np.array([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)])
    return picture.colors[int(np.argmax(np.asarray(picture.vertices) @ place))]


ON_LAND = [(37.6, 55.8), (10.0, 20.0), (-60.0, -6.0), (134.0, -25.0), (-100.0, 45.0), (40.0, -82.0), (100.0, 62.0)]
AT_SEA = [(-150.0, 0.0), (-35.0, 30.0), (75.0, -20.0), (160.0, 35.0), (-20.0, -30.0), (0.0, 88.0), (-120.0, -50.0)]


def misplaced(look_at):
    wanted = [(place, LAND) for place in ON_LAND] + [(place, OCEAN) for place in AT_SEA]
    return [place for place, color in wanted if look_at(*place) != color]


def test_continents_are_where_they_are():
    picture = spec_of("earth").picture
    assert not misplaced(lambda a, b: color_at(picture, a, b))
    # a globe with east and west exchanged, and one that is turned, are noticed
    assert misplaced(lambda a, b: color_at(picture, -a, b)) and misplaced(lambda a, b: color_at(picture, a + 90.0, b))
    heights = np.asarray(picture.vertices)[:, 2]
    weight = np.sqrt(np.maximum(0.0, 1.0 - heights**2))  # of a grid of even steps of latitude
    share = float(np.sum(weight * (picture.colors == LAND)) / np.sum(weight))
    assert share == pytest.approx(OF_LAND, abs=0.015)


def test_the_equator_and_the_prime_meridian_are_marked():
    wide = [points for points, _, width in spec_of("earth").picture.paint.lines if width > 1.0]
    equator, meridian = sorted(wide, key=lambda points: np.abs(points[:, 2]).max())
    assert np.abs(equator[:, 2]).max() < 1e-12
    assert np.abs(meridian[:, 1]).max() < 1e-12 and meridian[:, 0].min() > -1e-12


def test_what_is_painted_turns_with_the_body():
    picture = spec_of("gyroscope").picture
    turn = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    frame = BodyFrame(np.ones(3), turn, np.array([0.0, 0.0, 0.01]), 1.0, pivot=np.zeros(3))
    center, radius = picture.along(frame).paint.cage
    assert np.asarray(center) == pytest.approx(np.asarray(picture.paint.cage[0]) @ turn)
    assert radius == picture.paint.cage[1]
    globe = spec_of("earth").picture
    lines = globe.along(BodyFrame(np.ones(3), turn, np.zeros(3), 1.0)).paint.lines
    assert lines[0][0] == pytest.approx(globe.paint.lines[0][0] @ turn)


BOX = '{ shape = "box", mass = "1 kg", size = ["1 cm", "2 cm", "3 cm"] }'
MOMENTS = 'moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]'


@pytest.mark.parametrize(("body", "words"), [
    (f'look = "book"\n{MOMENTS}', 'look = "book" goes with part, not with moments'),
    (f'look = "earth"\nparts = [{BOX}]', 'look = "earth" goes with moments, not with part'),
    (f'look = "phone"\nparts = [{BOX}, {BOX}]', "paints one part, a box; got 2 parts"),
    (f'look = "teapot"\nparts = [{BOX}]', 'must be one of "book"'),
])  # fmt: skip
def test_looks_that_do_not_fit_are_refused(body, words, tmp_path):
    path = tmp_path / "spec.toml"
    path.write_text(f'[body]\n{body}\n[spin]\nrate = "1 rad/s"\nabout = 3\n', "utf-8")
    with pytest.raises(InvalidInput, match=re.escape(words)):
        read_spec(path)
