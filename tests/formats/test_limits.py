"""Limits of files: on either side of each, a file is read or refused, or written in one way or another."""

import os
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.formats import (
    animation_keys,
    attitude_checks,
    calendar_stamps,
    column_meaning,
    drafts,
    gltf,
    mesh,
    mesh_archives,
    molecule,
    numerals,
    plain_table,
    xml_nodes,
    zarr_gate,
)

INSIDE, OUTSIDE = 0.99, 1.01  # of a limit


def refuses(refused, *, match=None, error=FormatError):
    """Expect an error if one is due."""
    return pytest.raises(error, match=match) if refused else nullcontext()


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_quaternions_of_files_are_of_unit_length(factor):
    attitude = np.array([[1.0 + factor * attitude_checks.LIMITS.max_norm_error, 0.0, 0.0, 0.0]])
    with refuses(factor > 1.0, match="unit quaternion"):
        attitude_checks.check_recorded(Path("a.nc"), np.zeros(1), attitude)


@pytest.mark.parametrize("digits", (0, 1))
def test_a_number_has_four_hundred_characters_at_most(digits):
    text = "1." + "0" * (numerals.LIMITS.max_number - 2 + digits)
    with refuses(digits, error=ValueError):
        assert numerals.read_number(text) == 1.0


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_an_atom_is_within_a_metre(factor, tmp_path):
    path = tmp_path / "atoms.xyz"
    path.write_text(f"2\n\nH 0 0 0\nH {1e10 * factor * molecule.LIMITS.max_extent} 0 0\n")
    with refuses(factor > 1.0, match="atom 2 is not at a place within 1 m"):
        molecule.read_molecule(path)


@pytest.mark.parametrize("more", (1, 2))
def test_elements_of_xml_lie_within_thirty_others(more, tmp_path):
    depth = xml_nodes.LIMITS.max_depth + more
    path = tmp_path / "deep.xml"
    path.write_text("<a>" * depth + "</a>" * depth)
    with refuses(more > 1, match="too deep"):
        xml_nodes.read_xml(path, "message", 10_000)


@pytest.mark.parametrize("blank", (199, 200))
def test_the_kind_of_a_column_is_that_of_its_first_200_cells(blank, tmp_path):
    assert calendar_stamps.LIMITS.max_rows_inspected == 200
    path = tmp_path / "log.csv"
    path.write_text("day,x,y\n" + ",1,2\n" * blank + "2026-03-01T12:00:00,1,2\n")
    form = plain_table.table_form(path)
    assert calendar_stamps.kind_of_cells(path, form, 0) == (calendar_stamps.DATE if blank < 200 else None)


@pytest.mark.parametrize("angle, clear", [(0.9, True), (1.1, False)])
def test_rates_show_a_direction_where_a_step_turns_by_less_than_a_radian(angle, clear):
    times = np.arange(6.0)
    attitude = rotation.from_rotation_vector(times[:, None] * np.array([0.0, 0.0, angle]))
    known = column_meaning.agreement(times, attitude, np.tile([0.0, 0.0, angle], (6, 1)))
    assert (known is not None) == clear


@pytest.mark.parametrize("factor, clear", [(0.9, False), (1.1, True)])
def test_rates_show_a_direction_where_the_body_turns_by_more_than_noise(factor, clear):
    times = np.arange(6.0)
    rate = factor * column_meaning.LIMITS.min_rms_turn / 4.0  # four steps are the longest stride that is compared
    attitude = rotation.from_rotation_vector(times[:, None] * np.array([0.0, 0.0, rate]))
    longest = column_meaning.agreement(times, attitude, np.tile([0.0, 0.0, 4.0 * rate], (6, 1)))
    assert (longest is not None) == (4.0 * rate > column_meaning.LIMITS.min_rms_turn) == clear


@pytest.mark.parametrize("scale, known", [(0.92, True), (0.88, False)])
def test_a_direction_needs_rates_that_agree_within_a_tenth(scale, known):
    times = np.arange(6.0)
    attitude = rotation.from_rotation_vector(times[:, None] * np.array([0.0, 0.0, 0.5]))
    velocity = np.tile([0.0, 0.0, scale * 0.5], (6, 1))
    with refuses(not known, match="does not show it", error=InvalidInput):
        assert column_meaning.find_direction(Path("a.csv"), times, attitude, velocity) is False


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_a_mesh_has_an_extent_whose_fifth_power_is_a_double(factor, tmp_path):
    far = factor * mesh.LIMITS.max_extent
    path = tmp_path / "far.obj"
    path.write_text(f"v 0 0 0\nv {far} 0 0\nv 0 {far} 0\nv 0 0 {far}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
    with refuses(factor > 1.0, match="no body is that large"):
        mesh.load_mesh(path, 1.0)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_the_unit_of_an_archive_is_its_own(factor, tmp_path):
    pytest.importorskip("collada")
    text = b'<COLLADA><asset><unit name="mm" meter="0.001"/></asset></COLLADA>'
    unit = 1e-3 * (1.0 + factor * mesh_archives.LIMITS.relative_unit_difference)
    with refuses(factor > 1.0, error=InvalidInput):
        assert mesh_archives.check_archive(tmp_path / "a.dae", "dae", text, unit) == 1e-3


@pytest.mark.parametrize("more", (0, 1))
def test_arrays_of_a_store_are_as_large_as_compression_allows(more, tmp_path):
    declared = zarr_gate.LIMITS.spare_bytes + zarr_gate.LIMITS.max_compression * 10 + more
    with refuses(more):
        zarr_gate.check_size(tmp_path, declared, 10)


@pytest.mark.parametrize("age, left", [(0.9, True), (1.1, False)])
def test_a_draft_that_is_a_minute_old_is_abandoned(age, left, tmp_path):
    home = tmp_path / ".polhode-0123456789abcdef"
    home.mkdir()
    old = home.stat().st_mtime - age * drafts.LIMITS.min_age
    os.utime(home, (old, old))
    drafts.remove_abandoned(tmp_path)
    assert home.is_dir() == left


@pytest.mark.parametrize("span, speed", [(1.0, 1.0), (600.0, 1.0), (0.99, 0.01), (601.0, 10.0)])
def test_motions_of_a_second_to_ten_minutes_are_shown_in_real_time(span, speed):
    assert gltf._watchable_speed(span) == speed


@pytest.mark.parametrize("reach, unit", [(0.01, 1.0), (1000.0, 1.0), (0.0099, 1e-3), (1001.0, 1000.0)])
def test_bodies_of_a_centimetre_to_a_kilometre_are_shown_in_their_own_size(reach, unit):
    assert gltf._viewable_unit(reach) == pytest.approx(unit, rel=1e-15)


@pytest.mark.parametrize("rate, refused", [(9e4, False), (1.1e5, True)])
def test_an_animation_has_a_million_keys_at_most(rate, refused):
    assert animation_keys.LIMITS.max_keys == 1_000_000
    with refuses(refused, match="more than the 1000000", error=InvalidInput):
        assert len(animation_keys._evenly(10.0, 10.0 * rate)) == 10.0 * rate + 1


@pytest.mark.parametrize("factor, own", [(0.9, True), (2.0, False)])
def test_a_trajectory_along_other_axes_than_its_motion_is_not_evaluated_again(factor, own):
    motion = FreeMotion((1.0, 2.0, 2.5), momentum=(0.1, 2.0, 0.2))
    trajectory = motion.sample(np.linspace(0.0, 1.0, 3))
    turn = rotation.from_rotation_vector([0.0, 0.0, factor * animation_keys.LIMITS.max_attitude_difference])
    other = replace(trajectory, attitude=rotation.multiply(np.asarray(trajectory.attitude), turn))
    assert (animation_keys.exact_motion(other) is not None) == own
