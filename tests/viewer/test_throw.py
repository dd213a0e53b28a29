"""The page's fit of gyro logs is that of polhode: the same samples, flights and start, from files as apps write."""

import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from measuring.thrown import BODIES, throw
from polhode.errors import PolhodeError
from polhode.formats.column_mapping import ColumnMapping
from polhode.measuring.throws._rest_bias import rest_bias
from polhode.measuring.throws._saturation import saturation
from polhode.measuring.throws._throw_models import compute_moments
from polhode.measuring.throws._throw_search import Start
from polhode.measuring.throws.flight import free_flights
from polhode.measuring.throws.gyro_log import clean_log
from polhode.measuring.throws.gyro_logs import read_gyro_log
from polhode.measuring.throws.throw import _cut, fit_throw

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "viewer" / "src" / "throw"
EXAMPLE = ROOT / "examples" / "phone_throw.csv"
NODE = shutil.which("node")
SAME = 1e-6  # of moments over the largest, and of the axes; measured are 1e-13
BROKEN = 1e-3  # what a wrong formula must miss by at least
pytestmark = pytest.mark.skipif(NODE is None, reason="node is missing")


def in_javascript(cases, folder=SOURCES):
    """Return what the page finds in texts of files: a list of dicts, {refused} where it refuses."""
    done = subprocess.run([NODE, Path(__file__).with_name("run_throw.mjs"), folder.as_uri()], input=json.dumps(cases),
                          text=True, capture_output=True, timeout=300, check=False)  # fmt: skip
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


def with_a_hand(seed, body, spin, **options):
    """Return times and rates of a log with a rest, a hand that turns the device, the throw, and a rest again."""
    rng = np.random.default_rng(seed)
    rate = options.pop("rate", 100.0)
    t, rates, _ = throw(
        rng, np.array(BODIES[body]), spin, rate=rate, start=2.0, bias=0.0, gain=0.0, drag=0.0, **options
    )
    offset = rng.uniform(-0.04, 0.04, 3)
    rates = rates + offset
    still = lambda n: offset + 1e-3 * rng.normal(size=(n, 3))  # noqa: E731
    before, after = np.arange(0.0, 2.0, 1 / rate), t[-1] + np.arange(1, round(1.5 * rate)) / rate
    # a hand swings it with torques that no body has, and stops it within a tenth of a second
    swing = np.clip((before - 1.2) / 0.6, 0, 1)[:, None] ** 2
    first = still(len(before)) + swing * (rates[np.isfinite(rates[:, 0])][0] + 2.0 * np.sin(40 * before)[:, None])
    last = still(len(after)) + np.exp(-(after - t[-1]) / 0.02)[:, None] * rates[np.isfinite(rates[:, 0])][-1]
    return np.concatenate([before, t, after]), np.concatenate([first, rates, last])


def lines(header, columns, form="{}", sign=","):
    text = [sign.join("" if not np.isfinite(x) else form.format(x) for x in row) for row in np.column_stack(columns)]
    return "\n".join([header, *text]) + "\n"


def phyphox():
    t, rates = with_a_hand(1, "phone", (0.9, 11.0, 0.9))
    header = '"Time (s)";"Gyroscope x (rad/s)";"Gyroscope y (rad/s)";"Gyroscope z (rad/s)"'
    return lines(header, (t, rates), "{:.9E}", ";").replace(".", ","), None


def sensor_logger():
    t, rates = with_a_hand(2, "book", (2.0, 3.0, 9.0), seconds=0.8, rate=200.0)
    return lines("time,seconds_elapsed,z,y,x", (1.7e18 + 1e9 * t, t, rates[:, ::-1]), "{:.17g}"), None


def androsensor():
    t, rates = with_a_hand(3, "racket", (2.0, 11.0, 1.0), seconds=0.7)
    weight = np.where((t > 2.0) & (t < 2.68), 0.05, 9.8)[:, None] * [0.0, 0.6, 0.8]
    header = ",".join([*(f"ACCELEROMETER {c} (m/s²)" for c in "XYZ"), *(f"GYROSCOPE {c} (rad/s)" for c in "XYZ"),
                       "Time since start in ms"])  # fmt: skip
    return lines(header, (weight, rates, np.round(1000 * t)), "{:.5f}"), None


def betaflight():
    t, rates = with_a_hand(4, "phone", (2.0, 8.0, 4.0), seconds=1.2, rate=1000.0, dropped=0.0)
    counts = np.clip(np.round(np.degrees(rates) * 65.6) / 65.6, -500.0, 500.0)  # at its limit
    header = "loopIteration,time (us),gyroADC[0],gyroADC[1],gyroADC[2]"
    return lines(header, (np.arange(len(t)), np.round(1e6 * t), counts), "{:.10g}"), None


def own_table():
    t, rates = with_a_hand(5, "book", (8.0, 3.0, 2.0), seconds=1.0, dropped=0.0)
    head = "# made by a board of one's own\nstamp\tgx\tgy\tgz"
    stamps = [f"{1605400445005000000 + round(1e9 * x)}" for x in t]
    text = "\n".join([head, *("\t".join([s, *(f"{v:.6f}" for v in row)])
                              for s, row in zip(stamps, np.degrees(rates), strict=True))])  # fmt: skip
    return text, {"time": 0, "timeUnit": "ns", "gyro": [1, 2, 3], "rateUnit": "deg/s"}


def coarse_clock():
    t, rates = with_a_hand(6, "phone", (1.0, 12.0, 1.5), rate=250.0, dropped=0.0)
    return lines("Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)",
                 (np.floor(100 * t) / 100, rates), "{:.7f}"), None  # fmt: skip


LOGS = {each.__name__: each for each in (phyphox, sensor_logger, androsensor, betaflight, own_table, coarse_clock)}
LOGS["example"] = lambda: (EXAMPLE.read_text(), None)


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """Return for each log what the page and what polhode finds: (dict, log, flights, level, start)."""
    folder = tmp_path_factory.mktemp("logs")
    made = {name: each() for name, each in LOGS.items()}
    asked = [{"text": text, "mapping": mapping, "fit": name in ("phyphox", "example")}
             for name, (text, mapping) in made.items()]  # fmt: skip
    found = {}
    for answer, (name, (text, mapping)) in zip(in_javascript(asked), made.items(), strict=True):
        path = folder / f"{name}.csv"
        path.write_text(text)
        words = mapping and ColumnMapping(
            mapping["time"] + 1, mapping["timeUnit"], gyro=tuple(k + 1 for k in mapping["gyro"]), unit="deg/s"
        )
        log = read_gyro_log(path, words).log
        level = saturation([log])
        flights = free_flights(log, level)
        throws = [_cut(log, window, level)[1] for window in flights]
        found[name] = answer, log, flights, level, Start.of(throws)
    return found


def apart(start, answer):
    """Return by how much moments and axes, up to their signs, differ."""
    axes = np.array(answer["start"]["axes"])
    turned = np.abs(start.axes.T @ axes)
    return max(float(np.abs(compute_moments(start.shape) - answer["start"]["moments"]).max()),
               float(np.abs(turned - np.eye(3)).max()))  # fmt: skip


@pytest.mark.long_cases("phyphox", "sensor_logger")
@pytest.mark.parametrize("name", LOGS)
def test_the_start_is_that_of_polhode_fit(both, name):
    answer, log, flights, level, start = both[name]
    assert len(answer["times"]) == len(log.times)
    np.testing.assert_allclose(answer["times"], log.times, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.reshape(answer["rates"], (-1, 3)), log.rates, rtol=1e-14)
    assert answer["limit"] == (None if level is None else pytest.approx(level, rel=1e-12))
    assert [[w["start"], w["end"]] for w in answer["windows"]] == [pytest.approx([w.start, w.end]) for w in flights]
    assert flights and start.degenerate is None and answer["start"]["degenerate"] is None
    assert apart(start, answer) < SAME
    np.testing.assert_allclose(answer["start"]["singularValues"], start.singular_values, rtol=SAME)
    assert answer["start"]["noise"] == pytest.approx(start.noise, rel=SAME)
    bias = rest_bias([log], [flights])
    assert (answer["rest"] is None) == (bias is None)
    if bias is not None:
        np.testing.assert_allclose(answer["rest"]["value"], bias.value, atol=1e-12)
        np.testing.assert_allclose(answer["rest"]["spread"], bias.spread, atol=1e-12)


def test_every_way_of_finding_a_flight_is_among_the_logs(both):
    reasons = {window["reason"] for answer, *_ in both.values() for window in answer["windows"]}
    assert reasons == {"keeps an angular momentum", "the accelerometer feels no weight"}
    assert both["betaflight"][0]["limit"] is not None and both["phyphox"][0]["rest"] is not None
    assert any("rounded" in note for note in both["coarse_clock"][0]["notes"])


@pytest.mark.parametrize("name", ["phyphox", "example"])
def test_the_least_squares_is_that_of_polhode_without_drag_and_gains(both, name):
    answer, log, *_ = both[name]
    wanted = fit_throw(log, drag=False, gain=False, rotor=False)
    off = np.abs(np.array(answer["fit"]["moments"][:2]) - wanted.ratios.value) / wanted.ratios.standard_error
    assert off.max() < 0.3  # its weights are those of one noise, without the clock's part
    assert np.abs(np.array(answer["fit"]["bias"]) - wanted.bias.value).max() < 0.2 * wanted.bias.standard_error.max()
    [free] = [score.rms for score in wanted.criterion if score.chosen]
    assert answer["fit"]["rms"] == pytest.approx(free, rel=1e-3)
    assert answer["misfit"] is None
    turned = np.abs(wanted.axes.T @ np.array(answer["fit"]["axes"]))
    assert np.abs(turned - np.eye(3)).max() < 1e-3


@pytest.mark.sweep
def test_drag_is_fitted_gains_are_said_and_noise_alone_is_not():
    header = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)"
    asked, logs = [], []
    for drag, gain in ((0.0, 0.0), (0.01, 0.0), (0.01, 0.05)):
        t, rates, _ = throw(np.random.default_rng(7), np.array(BODIES["phone"]), (2.0, 10.0, 3.0), seconds=1.5,
                            gain=gain, drag=drag, jitter=0.0, bias=0.0, dropped=0.0)  # fmt: skip
        asked.append({"text": lines(header, (t, rates), "{:.9f}"), "mapping": None, "fit": True})
        logs.append(clean_log(t, rates))
    clean, slowed, wrong = in_javascript(asked)
    assert clean["misfit"] is None and clean["fit"]["drag"] is None and 0.9e-3 < clean["fit"]["rms"] < 1.1e-3
    np.testing.assert_allclose(clean["fit"]["moments"], BODIES["phone"], atol=2e-3)
    wanted = fit_throw(logs[1], gain=False, rotor=False, drag=True)
    assert slowed["misfit"] is None and 0.9e-3 < slowed["fit"]["rms"] < 1.1e-3
    off = np.abs(np.array(slowed["fit"]["moments"][:2]) - wanted.ratios.value) / wanted.ratios.standard_error
    assert off.max() < 0.5 and wanted.linear_drag is None
    np.testing.assert_allclose(slowed["fit"]["drag"], wanted.drag.value, atol=0.5 * wanted.drag.standard_error.max())
    assert "residuals" in wrong["misfit"] and "gains" in wrong["misfit"]
    for one, sign, count in ((slowed, "=", 3), (wrong, "≈", 2)):  # digits of a ratio whose error is not known
        said = re.findall(rf"I[12]/I3 {sign} 0\.(\d+)", one["page"]["summary"])
        assert [len(each) for each in said] == [count, count] and "±" not in str(one["page"])
        assert one["page"]["story"][1].startswith(f"I1/I3 {sign} 0.{said[0]}")
    assert wrong["misfit"] in wrong["page"]["story"] and wrong["misfit"].count(" ") > 10


@pytest.mark.parametrize(("wrong", "right", "file"), [
    ("w[q] + R[i][q] * w[p]", "w[q] - R[i][q] * w[p]", "linear_fit.js"),
    ("maps[18 * k + 6 * i + j] - means[6 * i + j]", "maps[18 * k + 6 * i + j]", "linear_fit.js"),
])  # fmt: skip
def test_a_broken_formula_is_seen(both, tmp_path, wrong, right, file):
    folder = tmp_path / "viewer" / "src" / "throw"
    shutil.copytree(SOURCES.parent, folder.parent)
    shutil.copytree(ROOT / "reference", tmp_path / "reference")
    text = (folder / file).read_text()
    assert text.count(wrong) == 1
    (folder / file).write_text(text.replace(wrong, right))
    text, mapping = LOGS["sensor_logger"]()
    [answer] = in_javascript([{"text": text, "mapping": mapping, "fit": False}], folder)
    assert "refused" in answer or answer["start"]["degenerate"] or apart(both["sensor_logger"][4], answer) > BROKEN


BAD = {
    "empty": ("", "no line of numbers"),
    "a picture": ("\x89PNG\r\n\x1a\n\0\0\0", "not UTF-8 text"),
    "a header alone": ("Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n", "no sample"),
    "a word": ("Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n0,1,2,3\n0.1,1,x,3\n", "line 3"),
    "a short line": ("Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n0,1,2,3\n1,2,3\n", "cells"),
    "few samples": ("Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n0,1,2,3\n1,2,3,4\n", "8"),
    "unknown columns": ("a,b,c,d\n0,1,2,3\n1,2,3,4\n", "not known which columns"),
    "no unit": ("t_s,gx,gy,gz\n0,1,2,3\n1,2,3,4\n", "not known"),
}


def test_what_is_no_log_is_refused_in_a_sentence():
    answers = in_javascript([{"text": text, "mapping": None, "fit": False} for text, _ in BAD.values()])
    for (name, (_, words)), answer in zip(BAD.items(), answers, strict=True):
        assert words in answer["refused"] and "\n" not in answer["refused"], (name, answer)


def test_a_unit_is_never_guessed(tmp_path):
    text = "t_s,gx,gy,gz\n" + "".join(f"{k / 100},1,2,{k}\n" for k in range(40))
    columns = {"time": 0, "gyro": [1, 2, 3]}
    units = ("deg/s", "rad/s", "rpm", None)
    *known, refused = in_javascript([{"text": text, "mapping": {**columns, "rateUnit": unit}, "fit": False}
                                     for unit in units])  # fmt: skip
    path = tmp_path / "log.csv"
    path.write_text(text)
    assert "Choose deg/s, rad/s or rpm" in refused["refused"]
    assert not any("is not known" in each.get("refused", "") for each in known)
    with pytest.raises(PolhodeError, match="deg/s"):
        read_gyro_log(path, ColumnMapping("t_s", gyro="gx,gy,gz"))


def test_a_steady_spin_and_degrees_read_as_radians_are_refused_as_polhode_does():
    t = np.arange(0.0, 2.0, 0.01)
    steady = np.array([0.0, 9.0, 0.0]) + 1e-3 * np.random.default_rng(3).normal(size=(len(t), 3))
    header = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)"
    felt = "".join(f",Acceleration {c} (m/s^2)" for c in "xyz")
    example, _ = LOGS["example"]()
    rows = [row.split(",") for row in example.splitlines() if row[:1].isdigit()]
    degrees = [",".join([row[0], *(f"{np.degrees(float(x)):.6f}" for x in row[1:4]), *row[4:]]) for row in rows]
    texts = lines(header + felt, (t, steady, 0 * steady), "{:.6f}"), "\n".join([header + felt, *degrees])
    one, two = in_javascript([{"text": text, "mapping": None, "fit": False} for text in texts])
    assert "spins about a principal axis" in (one.get("refused") or one["start"]["degenerate"])
    assert "deg/s" in (two.get("refused") or two["start"]["degenerate"])
