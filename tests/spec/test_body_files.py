"""Files that hold a body, of formats that wings and other packages bring by the keys of [body]."""

import pickle
import sys

import numpy as np
import pytest

import polhode as ph
from polhode._base.plugins.wings import wing_points
from polhode.errors import FormatError, InvalidInput
from polhode.spec import body_files

MASSES = "1 2 0 0\n1 -2 0 0\n2 0 1 0\n2 0 -1 0\n"  # by hand: I = (4, 8, 12) kg m²
SPEC = '[body]\nmasses = "four.txt"\n'


@pytest.fixture(autouse=True)
def others(plugin):
    """Have packages of others found by their entry points."""


@pytest.fixture
def read(tmp_path):
    (tmp_path / "four.txt").write_text(MASSES)

    def spec_of(text):
        (tmp_path / "spec.toml").write_text(text)
        return ph.read_spec(tmp_path / "spec.toml")

    return spec_of


def test_a_format_of_another_package(read, tmp_path):
    spec = read(SPEC)
    assert spec.body.mass == 6.0 and np.array_equal(spec.body.inertia, np.diag([4.0, 8.0, 12.0]))
    (used,) = spec.plugins
    assert str(used) == "the format of bodies masses of another package, mass_list:BODY_FILE"
    assert pickle.loads(pickle.dumps(spec)).source.file == spec.source.file == ("masses", "four.txt")
    assert ph.report(tmp_path / "spec.toml").inputs == (tmp_path / "four.txt", tmp_path / "spec.toml")


def test_as_a_part(read, tmp_path):
    (tmp_path / "inner.toml").write_text(SPEC)
    whole = read('[body]\n[[body.part]]\nspec = "inner.toml"\nat = ["1 m", "0 m", "0 m"]\n')
    assert whole.body.center_of_mass[0] == 1.0 and whole.body.principal_moments == pytest.approx([4.0, 8.0, 12.0])


@pytest.mark.parametrize(("body", "words"), [
    ('masses = "none.txt"', r"none\.txt: no such masses file\. Check the path; in a spec it counts from"),
    ("masses = 3", r"body\.masses: must be text in quotes; got 3"),
    ('masses = "four.txt"\nmass = "1 kg"', r"mass follows from the masses; leave it out"),
    ('masses = "four.txt"\njoints = { a = "30 deg" }', r"four\.txt: is of a format without joints; leave `joints` out"),
    ('masses = "four.txt"\nurdf = "a.urdf"', r"needs exactly one of .*mjcf and masses; got urdf and masses"),
    ('mases = "four.txt"', r"body\.mases: unknown key; did you mean masses\?"),
    ('link = "a"\nmass = "1 kg"', r"link goes with urdf, sdf, mjcf or masses; leave it out"),
])  # fmt: skip
def test_mistakes_are_those_of_every_key(read, body, words):
    with pytest.raises(InvalidInput, match=words):
        read(f"[body]\n{body}\n")


@pytest.mark.parametrize(("text", "words"), [
    ("1 2 3\n", r"four\.txt: must have three masses or more, each with x, y, z; got 1 lines of 3 numbers"),
    ("a b\n", r"four\.txt: the format of bodies masses of another package cannot read it \(ValueError: could not"),
])  # fmt: skip
def test_whatever_its_reader_raises_names_the_file(read, tmp_path, text, words):
    (tmp_path / "four.txt").write_text(text)
    read_spec = ph.read_spec
    (tmp_path / "spec.toml").write_text(SPEC)
    with pytest.raises(FormatError, match=words):
        read_spec(tmp_path / "spec.toml")


def leave(path, link, digits):
    sys.exit(0)


LEAVING = body_files.BodyFile(leave)


def test_one_whose_reader_leaves_is_named(read, add_entry_points):
    add_entry_points(body_files.GROUP, ("odd", f"{__name__}:LEAVING"))
    with pytest.raises(FormatError, match=r"format of bodies odd of another package cannot read it \(SystemExit: 0\)"):
        read('[body]\nodd = "four.txt"\n')


def test_one_that_is_none_is_named(read, add_entry_points):
    add_entry_points(body_files.GROUP, ("odd", "math:pi"), ("gone", "nowhere:BODY_FILE"))
    with pytest.raises(InvalidInput, match=r"the format of bodies odd of another package, math:pi, is not a BodyFile"):
        read('[body]\nodd = "four.txt"\n')
    with pytest.raises(InvalidInput, match=r"the format of bodies gone .*, nowhere:BODY_FILE, cannot be imported"):
        read('[body]\ngone = "four.txt"\n')


@pytest.mark.parametrize("taken", ["moments", "urdf"])
def test_keys_that_polhode_has_are_its_own(add_entry_points, taken):
    add_entry_points(body_files.GROUP, (taken, "math:pi"))
    with pytest.warns(UserWarning, match=f"the format of bodies {taken} of another package, math:pi, is ignored"):
        assert body_files.body_file_keys().count(taken) == (taken == "urdf")


def test_without_the_wing_its_keys_are_unknown(read, monkeypatch):
    """The application has no list of its own."""
    assert set(wing_points(body_files.GROUP)) == {"urdf", "sdf", "mjcf"}
    monkeypatch.setattr(body_files, "wing_points", lambda group: {})
    with pytest.raises(InvalidInput, match=r"body\.urdf: unknown key; known here are .*molecule, masses, link, joints"):
        read('[body]\nurdf = "a.urdf"\n')
