"""What is said of parts that lie in each other, against volumes that are known."""

import re

import pytest

from polhode.kinds.reading import build_spec

BALL = {"shape": "sphere", "radius": "1 m"}
PLATE = {"name": "plate", "shape": "box", "size": ["2 m", "2 m", "0.2 m"]}
HOLE = {"shape": "cylinder", "radius": "0.3 m", "height": "0.2 m", "cut": True}


def remarks(*parts, folder, **body):
    tables = {"system": {"kind": "free-body"}, "body": {"density": "1000 kg/m^3", "part": list(parts)} | body}
    return build_spec(tables, folder / "parts.toml").remarks_on_body


def percents(notes):
    return [int(number) for note in notes for number in re.findall(r"about (\d+) %", note)]


@pytest.mark.long_after(1)
@pytest.mark.parametrize(
    "turn", [{}, {"axis": "x"}, {"attitude": {"axis": [1, 2, 3], "angle": "50 deg"}}], ids=["", "axis", "attitude"]
)
def test_a_part_in_another_counts_twice(tmp_path, turn):
    # two balls of radius 1 at a distance of 1 share a lens of 5/16 of each
    [note] = remarks(BALL, BALL | turn | {"at": ["0 m", "0.6 m", "0.8 m"]}, folder=tmp_path)
    assert percents([note]) == [pytest.approx(31.25, abs=4.0)] and "part 1 and part 2 overlap" in note
    assert "counts twice" in note
    # masses that are given may lie in each other, as a battery's in the box that stands for a satellite
    by_mass = {"mass": "1 kg"}
    assert remarks(BALL | by_mass, BALL | by_mass | turn | {"at": ["0 m", "1 m", "0 m"]}, folder=tmp_path) == ()


@pytest.mark.parametrize(("x", "outside"), [("0.7 m", 0.0), ("1 m", 50.0), ("1.2 m", 87.5)])
def test_a_cut_that_sticks_out_is_told(tmp_path, x, outside):
    notes = remarks(PLATE, HOLE | {"at": [x, "0 m", "0 m"]}, folder=tmp_path)
    assert percents(notes) == ([pytest.approx(outside, abs=4.0)] if outside else [])
    assert all("part 2, a cut, sticks out" in note for note in notes)


def test_what_is_as_it_should_be_has_no_note(tmp_path):
    rib = {"shape": "box", "size": ["2 m", "0.1 m", "0.4 m"], "at": ["0 m", "0.5 m", "0.3 m"]}  # on the plate
    assert remarks(PLATE, rib, HOLE, HOLE | {"at": ["0.6 m", "0 m", "0 m"]}, folder=tmp_path) == ()


def test_holes_that_meet_and_parts_that_are_there_twice(tmp_path):
    notes = remarks(PLATE, HOLE, HOLE | {"at": ["0.3 m", "0 m", "0 m"]}, folder=tmp_path)
    assert len(notes) == 1 and "is taken away twice" in notes[0]
    assert percents(notes) == [pytest.approx(39.1, abs=4.0)]  # two circles at a distance of one radius
    notes = remarks(PLATE, {**PLATE, "name": "again"}, folder=tmp_path)
    assert notes == ("plate and again are the same thing in the same place; the masses of both count.",)
    point = {"shape": "point", "mass": "1 kg", "at": ["1 m", "0 m", "0 m"]}
    assert "part 2 and part 3 are the same thing" in remarks(PLATE, point, point, folder=tmp_path)[0]
    assert "both are taken away" in remarks(PLATE, HOLE, HOLE, folder=tmp_path)[0]
