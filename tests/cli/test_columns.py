"""``polhode import`` and ``polhode compare`` on tables of other tools."""

import json

import numpy as np
import pytest

from polhode import FreeMotion, rotation
from polhode.bodies import shapes
from polhode.cli.main import main
from polhode.formats import read_dataset, write_csv

BOX = """
[body]
parts = [{ shape = "box", mass = "2 kg", size = ["10 cm", "20 cm", "30 cm"] }]
[spin]
angular_velocity = ["0.1 rad/s", "2 rad/s", "0.3 rad/s"]
[time]
until = "5 s"
samples = 251
"""
TIMES = np.linspace(0.0, 5.0, 251)
SIMULATOR = ["--time", "time_ms", "--quat", "qx,qy,qz,qw", "--direction", "space-to-body", "--gyro", "gx,gy,gz",
             "--unit", "deg/s"]  # fmt: skip
MAPPING = """
time = 1
time_unit = "s"
[b]
euler = ["yaw", "pitch", "roll"]
sequence = "ZYX"
[a]
time = "time_ms"
time_unit = "ms"
quat = "qx,qy,qz,qw"
direction = "space-to-body"
"""


@pytest.fixture(scope="module")
def motion():
    return FreeMotion.from_body(shapes.box(2.0, (0.1, 0.2, 0.3)), angular_velocity=(0.1, 2.0, 0.3)).sample(TIMES)


@pytest.fixture
def files(tmp_path, monkeypatch, motion):
    """One motion as a simulator, a game engine, a phone and polhode itself write it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "box.toml").write_text(BOX)
    backward = rotation.conjugate(motion.attitude)[:, [1, 2, 3, 0]]
    rates = np.degrees(motion.angular_velocity)
    save("simulator.csv", [1e3 * TIMES, backward, rates], "time_ms,qx,qy,qz,qw,gx,gy,gz", ",")
    angles = rotation.as_scipy(motion.attitude).as_euler("ZYX", degrees=True)
    save("engine.csv", [TIMES, angles], "t;yaw [deg];pitch [deg];roll [deg]", ";")
    save("phone.txt", [TIMES, motion.angular_velocity], "t wx wy wz", " ")
    (tmp_path / "both.toml").write_text(MAPPING)
    write_csv(motion, "own.csv")
    return tmp_path


def save(name, columns, header, delimiter):
    np.savetxt(name, np.column_stack(columns), header=header, delimiter=delimiter, comments="", fmt="%.17g")


def run(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(list(map(str, arguments)))
    out, err = capsys.readouterr()
    return stopped.value.code or 0, out, err


def values_of(arguments, capsys):
    code, out, err = run([*arguments, "--json"], capsys)
    assert code == 0, err
    return json.loads(out)


def test_import_says_how_it_reads_a_table_and_writes_it(files, capsys, motion):
    found = values_of(["import", "simulator.csv", *SIMULATOR, "--spec", "box.toml"], capsys)
    assert found["read_as"]["time"] == "column 1 'time_ms', in ms" and "space to body" in found["read_as"]["attitude"]
    assert found["read_as"]["largest_deviation"] < 1e-15 and found["read_as"]["rates_apart"] < 1e-3
    assert (found["samples"], found["last"], found["notes"]) == (251, 5.0, [])
    assert max(found["drift"].values()) < 1e-12
    back = read_dataset("simulator_imported.nc")
    given = rotation.multiply(back.attitude, rotation.conjugate(rotation.from_matrix(back.frame.axes)))
    assert rotation.angle_between(given, motion.attitude).max() < 1e-14
    assert np.abs(back.angular_velocity @ back.frame.axes.T - motion.angular_velocity).max() < 1e-14
    _, out, _ = run(["import", "simulator.csv", *SIMULATOR], capsys)
    text = " ".join(out.split())
    assert "How the table is read" in text and "from space to body" in text and "in deg/s" in text
    assert "251, 0 to 5 s" in text and "|q| from 1" in text and "drift" not in text


def test_the_wrong_direction_is_noticed_by_the_rates(files, capsys):
    forward = [word if word != "space-to-body" else "body-to-space" for word in SIMULATOR]
    (note,) = values_of(["import", "simulator.csv", *forward], capsys)["notes"]
    assert "does not follow the angular velocity" in note


def test_rates_alone_are_imported(files, capsys, motion):
    words = ["--time", 1, "--time-unit", "s", "--gyro", "2,3,4", "--unit", "rad/s"]
    found = values_of(["import", "phone.txt", *words], capsys)
    assert found["largest_turn"] is None and found["read_as"]["attitude"] is None and found["drift"] == {}
    back = read_dataset("phone_imported.nc")
    assert np.array_equal(back.angular_velocity, motion.angular_velocity) and back.attitude is None
    found = values_of(["import", "phone.txt", *words, "--spec", "box.toml"], capsys)
    assert set(found["drift"]) == {"energy", "momentum_norm"} and max(found["drift"].values()) < 1e-12
    energy = 0.5 * (0.1**2 * 0.13 + 2.0**2 * 0.1 + 0.3**2 * 0.05) * 2.0 / 12.0  # of a box: m (b² + c²)/12 about a
    assert read_dataset("phone_imported.nc").invariants["energy"] == pytest.approx(energy, rel=1e-12)


@pytest.mark.long_cases("pair0")
@pytest.mark.parametrize("pair", [["box.toml", "simulator.csv"], ["simulator.csv", "own.csv"]])
def test_compare_takes_options_for_the_tables_among_both(files, capsys, pair):
    found = values_of(["compare", *pair, *SIMULATOR], capsys)
    assert found["angle"]["largest"] < 1e-12
    side = "ab"[pair.index("simulator.csv")]
    assert list(found["read_as"]) == [side] and "qw" in found["read_as"][side]["attitude"]


def test_compare_takes_a_mapping_for_each(files, capsys):
    found = values_of(["compare", "simulator.csv", "engine.csv", "--mapping", "both.toml"], capsys)
    assert found["angle"]["largest"] < 1e-12 and set(found["read_as"]) == {"a", "b"}
    assert "Z by column 2 'yaw [deg]'" in found["read_as"]["b"]["attitude"]
    _, out, _ = run(["compare", "simulator.csv", "engine.csv", "--mapping", "both.toml"], capsys)
    assert "How simulator.csv (A) is read" in out and "How engine.csv (B) is read" in out


def test_a_mapping_file_is_the_same_as_the_options(files, capsys):
    (files / "one.toml").write_text('time = "time_ms"\ngyro = ["gx", "gy", "gz"]\nunit = "deg/s"\n')
    by_file = values_of(["import", "simulator.csv", "--mapping", "one.toml"], capsys)
    words = ["--time", "time_ms", "--gyro", "gx,gy,gz", "--unit", "deg/s"]
    assert by_file == values_of(["import", "simulator.csv", *words], capsys)


REFUSED = [
    (["import", "simulator.csv"], ["is a table with the columns time_ms, qx", "--time t"]),
    (["import", "bare.csv"], ["of 4 columns without names"]),
    (["compare", "box.toml", "engine.csv"], ["engine.csv: is a table with the columns t, yaw"]),
    (["import", "simulator.csv", "--quat", "qx,qy", "--order", "up"], ["--time is missing", "4 columns", "--order"]),
    (["import", "simulator.csv", *SIMULATOR, "--time-unit", "iso"], ["--time-unit must be one of s, ms"]),
    (["import", "simulator.csv", "--time", "time", "--gyro", "gx,gy,gw"], ["Did you mean 'time_ms'", "'gw'", "--unit"]),
    (["import", "box.toml", *SIMULATOR], ["is no AEM"]),
    (["import", "bad.csv", "--time", "1", "--time-unit", "s", "--gyro", "2,3,4", "--unit", "rpm"],
     ["line 2, column 3"]),
    (["import", "simulator.csv", *SIMULATOR, "--mapping", "both.toml"], ["--mapping has what --time, --quat"]),
    (["import", "simulator.csv", "--mapping", "both.toml"], ["has a table [a]"]),
    (["import", "simulator.csv", "--mapping", "none.toml"], ["none.toml: no such mapping file"]),
    (["import", "simulator.csv", "--mapping", "typo.toml"], ["typo.toml: 'time-unit'", "did you mean time_unit"]),
    (["import", "simulator.csv", "--mapping", "kinds.toml"], ["kinds.toml: time must", "quat must", "time_unit must"]),
    (["compare", "box.toml", "own.csv", *SIMULATOR], ["neither box.toml nor own.csv is a table"]),
    (["compare", "box.toml", "engine.csv", "--mapping", "both.toml"], ["box.toml: is a spec, and a mapping is for"]),
    (["compare", "box.toml", "phone.txt", "--time", "1", "--time-unit", "s", "--gyro", "2,3,4", "--unit", "rpm"],
     ["phone.txt: a comparison is of attitudes"]),
    (["import", "simulator.csv", *SIMULATOR, "--out", "simulator.csv"], ["writing would destroy it"]),
    (["import", "simulator.csv", *SIMULATOR, "--out", "again.csv"],
     ["again.csv: import writes a dataset, .nc, or a spec, .toml, and .csv is the ending of a CSV table",
      "Name it again.nc", "`polhode export SPEC --to csv`"]),
    (["import", "simulator.csv", *SIMULATOR, "--out", "again.AEM"], [".aem is the ending of an AEM", "--to aem"]),
    (["import", "simulator.csv", *SIMULATOR, "--out", "again.zarr"], ["a Zarr store. Name it again.nc."]),
    (["import", "simulator.csv", *SIMULATOR, "--out", "again.txt"], ["a GMAT report. Name it again.nc."]),
    (["import", "simulator.csv", "--time", "time_ms", "--quat", "qw,qx,qy"], ["end in w, x, y. Give four, w, x, y, z"]),
    *((["import", name, *words], [f"{name}: is empty"]) for name in ("empty.csv", "blank.csv")
      for words in ([], SIMULATOR)),
    (["compare", "box.toml", "empty.csv"], ["empty.csv: is empty"]),
    (["compare", "empty.csv", "box.toml", *SIMULATOR], ["empty.csv: is empty"]),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "words"), REFUSED)
def test_mistakes_end_in_one_message_and_nothing_is_written(files, capsys, arguments, words):
    (files / "bare.csv").write_text("0,1,2,3\n1,1,2,3\n")
    (files / "bad.csv").write_text("0,1,2,3\n1,1,two,3\n")
    (files / "typo.toml").write_text('time = "t"\ntime-unit = "s"\n')
    (files / "empty.csv").touch()
    (files / "blank.csv").write_text("\ufeff \n\n")
    (files / "kinds.toml").write_text('time = 1.5\nquat = 3\ntime_unit = 5\n')
    before = sorted(files.iterdir())
    code, out, err = run(arguments, capsys)
    assert code == 2 and not out and "Traceback" not in err and sorted(files.iterdir()) == before
    assert all(one in err for one in words), err


def test_help_names_the_options(capsys):
    for command in ("import", "compare"):
        _, out, _ = run([command, "--help"], capsys)
        assert all(word in out for word in ("--time-unit", "--quat", "--direction", "--sequence", "--mapping"))
        assert "gmat: days from JD 2430000" in " ".join(out.replace("│", " ").split())


def test_an_ending_that_no_form_has_is_taken(files, capsys, motion):
    values_of(["import", "simulator.csv", *SIMULATOR, "--out", "again.h5"], capsys)
    assert np.allclose(read_dataset("again.h5").times, motion.times, rtol=0.0, atol=1e-15)
