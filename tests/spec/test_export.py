"""The table [export]: labels of attitude files, checked when the spec is read."""

import pytest

from polhode.errors import InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.kinds.reading import read_spec

BODY = 'name = "{name}"\n[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n[export]\n'


@pytest.fixture
def read(tmp_path):
    def reader(text, name="box"):
        path = tmp_path / "case.toml"
        path.write_text(BODY.replace("{name}", name) + text, "utf-8")
        return read_spec(path).labels

    return reader


def test_what_is_left_out_has_its_default(read):
    assert read("") == AttitudeLabels(object_name="box")


def test_every_key(read):
    text = """object_name = "MY SAT"
object_id = "2026-001A"
center = "EARTH"
reference_frame = "ICRF"
body_frame = "SC_BODY_2"
epoch = "2026-060T12:00:00.5Z"
time_system = "TAI"
originator = "ME"
spice_id = -77
"""
    frames = ("EARTH", "ICRF", "SC_BODY_2")
    assert read(text) == AttitudeLabels("MY SAT", "2026-001A", *frames, "2026-03-01T12:00:00.5", "TAI", "ME", -77)


@pytest.mark.parametrize(("given", "wanted"), [
    ('"2026-03-01T12:00:00"', "2026-03-01T12:00:00"),
    ('"2026-03-01"', "2026-03-01T00:00:00"),
    ("2026-03-01", "2026-03-01T00:00:00"),
    ("2026-03-01T12:00:00", "2026-03-01T12:00:00"),
    ("2026-03-01T12:00:00.125", "2026-03-01T12:00:00.125"),
    ("2026-03-01T12:00:00+02:00", "2026-03-01T10:00:00"),
    ('"2016-12-31T23:59:60"', "2016-12-31T23:59:60"),
])  # fmt: skip
def test_epochs(read, given, wanted):
    assert read(f"epoch = {given}").epoch == wanted


@pytest.mark.parametrize(("name", "wanted"), [
    ("Größe", "Gro_e"), ("two\\nlines", "two lines"), ("月", "_"), ("é=</script>", "e=</script>"), ("x\\u0000", "x_"),
])  # fmt: skip
def test_names_of_any_script(read, name, wanted):
    assert read("", name).object_name == wanted


BAD = [
    ('object_name = "Größe"', "export.object_name: must be one line of printable ASCII"),
    ('object_name = "two\\nlines"', "export.object_name: must be one line"),
    ('center = ""', "export.center: must be one line"),
    ("object_id = 5", "export.object_id: must be one line"),
    ("spice_id = 999", "export.spice_id: must be a negative whole number"),
    ("spice_id = -1000000000", "and not below -2147483; got -1000000000"),
    ('body_frame = "EME2000"', "export.body_frame: must differ from the other frame"),
    ('reference_frame = "sc body 1"', "export.reference_frame: must differ from the other frame"),
    ('body_frame = "j2000"', "export.body_frame: is an inertial frame"),
    ("spice_id = true", "export.spice_id: must be a negative whole number"),
    ('time_system = "PST"', "export.time_system: must be one of"),
    ('epoch = "soon"', "export.epoch: must be an epoch like"),
    ("epoch = 12:00:00", "export.epoch: must be a date and time like"),
    ('epoch = "2026-02-29T00:00:00"', "export.epoch: has no such day; got 02-29 of 2026"),
    ('epoch = "2025-12-31T23:59:60"', "export.epoch: has no such time of day in UTC"),
    ('epoch = "1969-07-20T20:17:40"', "export.epoch: lies before 1972"),
    ('time_system = "TT"\nepoch = 2026-03-01T12:00:00Z', "export.epoch: has a zone, which only UTC has"),
    ('object = "a"', "export.object: unknown key; did you mean object_id"),
]


@pytest.mark.parametrize(("text", "words"), BAD)
def test_what_is_refused(read, text, words):
    with pytest.raises(InvalidInput) as error:
        read(text)
    assert words in str(error.value) and "1 mistake" in str(error.value)


def test_all_mistakes_at_once(read):
    with pytest.raises(InvalidInput, match="2 mistakes") as error:
        read('epoch = "2026-13-01"\ntime_system = "MARS"')
    assert "epoch: has no such day" in str(error.value)
    with pytest.raises(InvalidInput, match="3 mistakes"):
        read('spice_id = 1\nepoch = "soon"\noriginator = ""')
