"""Gyro logs in zip archives: which table is read and said, and archives that are refused before they fill anything."""

import io
import json
import zipfile

import numpy as np
import pytest

from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput
from polhode.measuring.throws.gyro_logs import read_gyro_log

TIMES = np.arange(40) / 50.0
RATES = np.column_stack([2 * np.cos(6 * TIMES), 2 * np.sin(6 * TIMES), 9.0 + 0 * TIMES])


def sensor_logger(rates, names=("time", "seconds_elapsed", "z", "y", "x")):
    rows = [f"{int(1e9 * t)},{t:.6f},{z:.9f},{y:.9f},{x:.9f}" for t, (x, y, z) in zip(TIMES, rates, strict=True)]
    return ",".join(names) + "\n" + "\n".join(rows) + "\n"


def packed(folder, members, name="x.zip", method=zipfile.ZIP_DEFLATED):
    with zipfile.ZipFile(folder / name, "w", method) as archive:
        for member, text in members.items():
            archive.writestr(member, text)
    return folder / name


def test_one_log_among_the_members_of_sensor_logger_is_read_and_said(tmp_path):
    felt = np.broadcast_to([0.0, 0.0, 9.8], RATES.shape)
    path = packed(tmp_path, {
        "2026-01-01/Accelerometer.csv": sensor_logger(0 * RATES), "2026-01-01/Gyroscope.csv": sensor_logger(RATES),
        "2026-01-01/GyroscopeUncalibrated.csv": sensor_logger(RATES + 1),
        "2026-01-01/TotalAcceleration.csv": sensor_logger(felt), "2026-01-01/Metadata.csv": "version\n3\n",
        "__MACOSX/2026-01-01/._Gyroscope.csv": "x", "other/TotalAcceleration.csv": sensor_logger(RATES),
    })  # fmt: skip
    found = read_gyro_log(path)
    np.testing.assert_allclose(found.log.rates, RATES, atol=1e-8)
    np.testing.assert_allclose(found.log.acceleration, felt, atol=1e-8)
    assert found.dialect == "Sensor Logger" and found.notes == ("2026-01-01/Gyroscope.csv in the archive is read.",)


def test_the_only_table_of_an_archive_may_have_any_name(tmp_path):
    path = packed(tmp_path, {"my throw.csv": sensor_logger(RATES), "readme.md": "# a throw"}, "throw")
    assert read_gyro_log(path).notes == ("my throw.csv in the archive is read.",)
    path = packed(tmp_path, {"data/a.csv": sensor_logger(RATES).replace("9.0", "oops", 1)})
    with pytest.raises(FormatError, match=r"x\.zip/data/a\.csv, line 2, .*oops"):
        read_gyro_log(path)


@pytest.mark.long
def test_the_command_takes_an_archive(tmp_path, capsys):
    path = packed(tmp_path, {"Gyroscope.csv": sensor_logger(RATES)})
    with pytest.raises(SystemExit, match="2"):
        main(["fit", str(path), "--window", "5,6"])
    assert "which goes from 0 s to 0.78 s" in capsys.readouterr().err  # it was read
    with pytest.raises(SystemExit, match="2"):
        main(["compare", str(path), str(path)])
    assert "is a zip archive" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["fit", str(path), "--window", "0,0.7", "--json", "--no-gain", "--no-drag"])
    assert any("Gyroscope.csv in the archive" in note for note in json.loads(capsys.readouterr().out)["notes"])


@pytest.mark.parametrize(("members", "said"), [
    ({}, r"has no Gyroscope\.csv or Raw Data\.csv or Gyroscope rotation rate\.csv\."),
    ({"a.csv": "1", "b/c.csv": "2"}, r"has no Gyroscope.*; its tables are a\.csv, b/c\.csv\. Unpack it"),
    ({"1/Gyroscope.csv": "", "2/Gyroscope.csv": ""}, r"has 2 logs, 1/Gyroscope\.csv, 2/Gyroscope\.csv\. Unpack it"),
    ({"Gyroscope.csv": "0," * 15_000_000}, r"Gyroscope\.csv in it has 30 MB packed into \d+ bytes, which no log is"),
])  # fmt: skip
def test_archives_that_are_refused(tmp_path, members, said):
    with pytest.raises(InvalidInput, match=rf"x\.zip: {said}"):
        read_gyro_log(packed(tmp_path, members))


def test_a_name_that_leads_out_of_the_archive_writes_nothing_there(tmp_path):
    path = packed(tmp_path, {"../../Gyroscope.csv": sensor_logger(RATES)})
    assert len(read_gyro_log(path).log.times) == 40
    assert not (tmp_path.parent / "Gyroscope.csv").exists() and not (tmp_path / "Gyroscope.csv").exists()


def _announced(data, at, value):
    """Return an archive whose end says that its list of members has another size."""
    end = data.rindex(b"PK\x05\x06")
    return data[: end + at] + value.to_bytes(4, "little") + data[end + at + 4 :]


def _central(data, at, value):
    """Return an archive whose list of members has another entry for the first."""
    begin = data.rindex(b"PK\x01\x02")
    return data[: begin + at] + value.to_bytes(4, "little") + data[begin + at + 4 :]


@pytest.mark.parametrize(("damage", "said"), [
    (lambda data: data[:-30], "cut off"),
    (lambda data: _announced(data, 12, 4_000_000_000), "more members than a log has"),
    (lambda data: _announced(data, 12, 40), "can be unpacked"),
    (lambda data: _central(data, 24, 4_000_000_000), "packed into"),
    (lambda data: _central(data, 24, 100), "can be unpacked|8 finite samples"),
    (lambda data: _central(data, 16, 1), "can be unpacked"),  # its checksum
    (lambda data: _central(data, 8, 1), "can be unpacked.*(encrypted|password)"),
    (lambda data: data[:60] + bytes([data[60] ^ 255]) + data[61:], "can be unpacked"),
])  # fmt: skip
def test_damaged_archives_are_refused_in_words(tmp_path, damage, said):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Gyroscope.csv", sensor_logger(RATES))
    path = tmp_path / "x.zip"
    path.write_bytes(damage(buffer.getvalue()))
    with pytest.raises(InvalidInput, match=said):
        read_gyro_log(path)
