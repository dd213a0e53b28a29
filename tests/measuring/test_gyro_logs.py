"""Gyro logs by their headers: units, order of columns, decimal commas, samples out of order, and what is no log."""

import zipfile

import numpy as np
import pytest

from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput
from polhode.formats.column_mapping import ColumnMapping
from polhode.measuring.throws.gyro_logs import read_gyro_log

TIMES = np.arange(12) / 50.0 - 0.04
RATES = np.column_stack([np.linspace(1.0, 2.0, 12), np.linspace(-3.0, 3.0, 12), np.linspace(0.1, 9.0, 12)])
FELT = np.column_stack([np.linspace(0.0, 1.0, 12), np.full(12, -2.0), np.linspace(9.0, 9.8, 12)])
PHYPHOX = ["Time (s)", *(f"Gyroscope {x} (rad/s)" for x in "xyz")]
PHYPHOX_FELT = ["Time (s)", *(f"Acceleration {x} (m/s^2)" for x in "xyz")]


def table(names, columns, sign=",", comma=False, quotes=True):
    rows = [sign.join(f'"{name}"' if quotes else name for name in names)]
    rows += [sign.join(f"{x:.12g}" for x in row) for row in np.column_stack(columns)]
    text = "\n".join(rows) + "\n"
    return text.replace(".", ",") if comma else text


def written(folder, text, name="log.csv", encoding="utf-8"):
    path = folder / name
    path.write_bytes(text.encode(encoding))
    return path


@pytest.mark.parametrize(("sign", "comma", "encoding"), [
    (",", False, "utf-8"), (",", False, "utf-8-sig"), ("\t", False, "utf-8"), ("\t", True, "utf-8"),
    (";", True, "utf-8-sig"),
])  # fmt: skip
def test_phyphox_with_any_signs(tmp_path, sign, comma, encoding):
    text = table(PHYPHOX, [TIMES, RATES], sign, comma)
    found = read_gyro_log(written(tmp_path, text.replace("\n", "\n\n", 3), encoding=encoding))
    assert (found.dialect, found.rate_unit, found.acceleration_from, found.notes) == ("phyphox", "rad/s", None, ())
    np.testing.assert_allclose(found.log.times, TIMES, atol=1e-12)
    np.testing.assert_allclose(found.log.rates, RATES, atol=1e-11)


@pytest.mark.parametrize("packed", [False, True])
def test_phyphox_with_two_clocks_in_a_folder_or_an_archive(tmp_path, packed):
    gyro = table(PHYPHOX, [TIMES, RATES])
    felt = table(PHYPHOX_FELT, [TIMES + 0.003, FELT])
    written(tmp_path, gyro, "Gyroscope.csv")
    written(tmp_path, felt, "Accelerometer.csv")
    path = tmp_path
    if packed:
        path = tmp_path / "throw.zip"
        with zipfile.ZipFile(path, "w") as archive:
            for name in ("Gyroscope.csv", "Accelerometer.csv"):
                archive.write(tmp_path / name, f"throw/{name}")
    found = read_gyro_log(path)
    np.testing.assert_allclose(found.log.rates, RATES, atol=1e-11)
    np.testing.assert_allclose(found.log.acceleration_times, TIMES + 0.003, atol=1e-12)
    np.testing.assert_allclose(found.log.acceleration, FELT, atol=1e-11)
    assert found.acceleration_from == "Accelerometer.csv"


def test_sensor_logger_has_z_first_and_gravity_in_the_total_acceleration(tmp_path):
    names = ["time", "seconds_elapsed", "z", "y", "x"]
    epoch = 1.7e18 + 1e9 * TIMES
    path = written(tmp_path, table(names, [epoch, TIMES, RATES[:, ::-1]], quotes=False), "Gyroscope.csv")
    written(tmp_path, table(names, [epoch, TIMES, 0 * FELT], quotes=False), "Accelerometer.csv")  # without gravity
    assert read_gyro_log(path).log.acceleration is None
    written(tmp_path, table(names, [epoch, TIMES, FELT[:, ::-1]], quotes=False), "TotalAcceleration.csv")
    found = read_gyro_log(path)
    assert found.dialect == "Sensor Logger" and found.acceleration_from == "TotalAcceleration.csv"
    np.testing.assert_allclose(found.log.times, TIMES, atol=1e-12)
    np.testing.assert_allclose(found.log.rates, RATES, atol=1e-11)
    np.testing.assert_allclose(found.log.acceleration, FELT, atol=1e-11)


def test_androsensor_in_milliseconds(tmp_path):
    names = [*(f"ACCELEROMETER {x} (m/s²)" for x in "XYZ"), *(f"LINEAR ACCELERATION {x} (m/s²)" for x in "XYZ"),
             *(f"GYROSCOPE {x} (rad/s)" for x in "XYZ"), "Time since start in ms "]  # fmt: skip
    found = read_gyro_log(written(tmp_path, table(names, [FELT, 0 * FELT, RATES, 1e3 * TIMES], ";", quotes=False)))
    assert found.dialect == "AndroSensor"
    np.testing.assert_allclose(found.log.times, TIMES, atol=1e-12)
    np.testing.assert_allclose(found.log.acceleration, FELT, atol=1e-11)


@pytest.mark.parametrize("unit", ["", " (deg/s)"])
def test_betaflight_in_microseconds_and_degrees_below_other_lines(tmp_path, unit):
    names = ["loopIteration", " time (us)", *(f" gyroADC[{k}]{unit}" for k in range(3)),
             *(f" accSmooth[{k}]" for k in range(3))]  # fmt: skip
    columns = [np.arange(12), 1e6 * TIMES, np.degrees(RATES), 2048 * FELT]
    above = "".join(f"H name{k}:{k},{k}\n" for k in range(150))
    found = read_gyro_log(written(tmp_path, above + table(names, columns, quotes=False)))
    assert found.dialect == "Betaflight" and found.log.acceleration is None
    assert any("unit is not known" in note for note in found.notes)
    np.testing.assert_allclose(found.log.times, TIMES, atol=1e-12)
    np.testing.assert_allclose(found.log.rates, RATES, atol=1e-10)


def test_any_table_by_a_mapping(tmp_path):
    path = written(tmp_path, table(["t_ms", "p", "q", "r"], [1e3 * TIMES, np.degrees(RATES)]))
    with pytest.raises(FormatError, match=r"log\.csv: has the columns t_ms, p, q, r, which are not .*\"gyro\""):
        read_gyro_log(path)
    found = read_gyro_log(path, ColumnMapping("t_ms", gyro="p,q,r", unit="deg/s"))
    np.testing.assert_allclose(found.log.rates, RATES, atol=1e-11)


def test_samples_out_of_order_repeated_and_missing(tmp_path):
    times = TIMES.copy()
    times[[3, 4]] = times[[4, 3]]
    rates = RATES.copy()
    rates[7, 1] = np.nan
    text = table(PHYPHOX, [np.append(times, times[-1]), np.vstack([rates, rates[-1] + 1.0])])
    found = read_gyro_log(written(tmp_path, text))
    assert (found.log.dropped, found.log.repeats, found.log.reordered) == (1, 1, True) and len(found.notes) == 3
    order = [k for k in [0, 1, 2, 4, 3, *range(5, 12)] if k != 7]
    np.testing.assert_allclose(found.log.rates, RATES[order], atol=1e-11)


@pytest.mark.parametrize(("text", "said"), [
    ("", r"no line of numbers"),
    (",".join(PHYPHOX) + "\n", r"line 1: no sample follows the header"),
    (table(PHYPHOX, [TIMES, np.full((12, 3), np.nan)]), r"8 finite samples"),
    (table(PHYPHOX, [TIMES[:3], RATES[:3]]), r"8 finite samples .* got 3"),
    (table(PHYPHOX[:3], [TIMES, RATES[:, :2]]), r"has the columns Time \(s\), Gyroscope x"),
    (table(PHYPHOX, [TIMES, RATES]) + "1.0,2.0,abc,3\n", r"line 14, column 3 .*abc"),
    (table(PHYPHOX, [TIMES, RATES]) + "1.0,2.0\n", r"line 14: has 2 cells"),
    (table(PHYPHOX, [TIMES, RATES]) + "23:59:50.02,1,2,3\n", r"line 14, .*'23:59:50\.02'.*all of the column must be"),
])  # fmt: skip
def test_what_is_no_log_is_refused_by_name(tmp_path, text, said):
    with pytest.raises(InvalidInput, match=rf"log\.csv.*{said}"):
        read_gyro_log(written(tmp_path, text))


def test_the_unit_of_a_known_apps_table_can_be_said(tmp_path, capsys):
    """The remedy for rates in deg/s under a header of rad/s was --unit, which alone ended in: time is missing."""
    path = written(tmp_path, table(PHYPHOX, [TIMES, RATES]))
    found, plain = read_gyro_log(path, rate_unit="deg/s"), read_gyro_log(path)
    np.testing.assert_allclose(found.log.rates, np.radians(plain.log.rates), rtol=1e-15)
    assert any("it is read in deg/s, as said" in note for note in found.notes)
    with pytest.raises(InvalidInput, match="unit"):
        read_gyro_log(path, rate_unit="Hz")
    for unit, said in (("deg/s", "--window"), ("Hz", "'Hz'")):
        with pytest.raises(SystemExit):
            main(["fit", str(path), "--unit", unit])
        assert "time is missing" not in (err := capsys.readouterr().err) and said in err


def test_a_folder_or_an_archive_without_a_gyro_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"has no Gyroscope\.csv"):
        read_gyro_log(tmp_path)
    with zipfile.ZipFile(tmp_path / "empty.zip", "w"):
        pass
    with pytest.raises(InvalidInput, match=r"empty\.zip: has no Gyroscope\.csv"):
        read_gyro_log(tmp_path / "empty.zip")


def test_reading_tells_how_far_it_is(tmp_path):
    lines = []
    read_gyro_log(written(tmp_path, table(PHYPHOX, [TIMES, RATES])), progress=lines.append)
    assert lines == [13]


def test_stamps_of_nineteen_digits_lose_nothing(tmp_path):
    """Nanoseconds since 1970, whose doubles are 2.4e-7 s apart; and seconds, in the gyro's and the other's file."""
    begin, steps = 1_605_400_445_000_000_123, [k * 10_000_000 + (k * 7919) % 1000 for k in range(12)]
    (tmp_path / "log.csv").write_text("t_ns,x,y,z\n" + "".join(f"{begin + n},1,2,3\n" for n in steps))
    found = read_gyro_log(tmp_path / "log.csv", ColumnMapping("t_ns", gyro="x,y,z", unit="rad/s"))
    assert found.log.times.tolist() == pytest.approx([n * 1e-9 for n in steps], abs=1e-16)
    assert any("1605400445.000000123 s" in note for note in found.notes)
    for name, late in (("Gyroscope", 0), ("TotalAcceleration", 1_500_001)):
        stamps = [f"{(begin + late + n) // 10**9}.{(begin + late + n) % 10**9:09d}" for n in steps]
        rows = "".join(f"{k},{stamp},1,2,3\n" for k, stamp in enumerate(stamps))
        (tmp_path / f"{name}.csv").write_text("time,seconds_elapsed,z,y,x\n" + rows)
    both = read_gyro_log(tmp_path).log
    assert both.times.tolist() == found.log.times.tolist()
    assert both.acceleration_times.tolist() == pytest.approx([(n + 1_500_001) * 1e-9 for n in steps], abs=1e-16)
