"""C-kernels, judged by SPICE itself, and kernels of every type that SPICE writes."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
import spiceypy as spice

from polhode import FreeMotion, InvalidInput, rotation
from polhode.bodies import shapes
from polhode.errors import FormatError
from polhode.formats.labels import AttitudeLabels
from polhode.formats.time_scales import leap_seconds_kernel
from polhode.spacecraft.formats import spice as writer
from polhode.spacecraft.formats.spice import write_ck
from polhode.spacecraft.formats.spice_kernels import Clock
from polhode.spacecraft.formats.spice_reading import read_ck

EXACT = 1e-12  # rad and relative; SPICE and we multiply a few matrices at rounding
EPHEMERIS = 1.2e-7  # s, what SPICE's ephemeris time tells apart in 2026
MOTION = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), attitude=(0.5, 0.5, -0.5, 0.5))
TIMES = np.linspace(0.0, 20.0, 301)
LABELS = AttitudeLabels(object_name="Tumbler 1", body_frame="TUMBLER_BODY", epoch="2026-03-01T12:34:56.789",
                        spice_id=-777)  # fmt: skip


@pytest.fixture
def furnished():
    yield lambda files: [spice.furnsh(str(file)) for file in files]
    spice.kclear()


def errors_by_spice(trajectory, labels, bits=40):
    """Return the largest errors of SPICE's values at the samples, in attitude [rad] and angular velocity."""
    wrong = []
    number = 1000 * labels.spice_id
    for k, t in enumerate(trajectory.times):
        matrix, rate, _ = spice.ckgpav(number, float(t) * 2.0**bits, 0.0, "J2000")
        attitude = rotation.from_matrix(matrix.T)
        expected = rotation.rotate(trajectory.attitude[k], trajectory.angular_velocity[k])
        apart = np.linalg.norm(rate - expected) / np.linalg.norm(expected)
        wrong.append((rotation.angle_between(attitude, trajectory.attitude[k]), apart))
    return np.max(wrong, axis=0)


@pytest.mark.parametrize("system", ["UTC", "TAI", "TT", "TDB", "GPS"])
def test_spice_finds_our_attitude_and_angular_velocity(tmp_path, furnished, system):
    labels, samples = replace(LABELS, time_system=system), MOTION.sample(TIMES)
    files = write_ck(samples, tmp_path / "a.bc", labels=labels)
    assert [file.suffix for file in files] == [".bc", ".tf", ".tsc", ".tls"][: 3 + (system != "TDB")]
    furnished(files)
    assert max(errors_by_spice(samples, labels)) <= EXACT


def test_an_attitude_the_wrong_way_round_would_be_seen(tmp_path, furnished, monkeypatch):
    monkeypatch.setattr(writer.rotation, "conjugate", lambda quaternion: quaternion)
    files = write_ck(MOTION.sample(TIMES), tmp_path / "a.bc", labels=LABELS)
    monkeypatch.undo()
    furnished(files)
    assert errors_by_spice(MOTION.sample(TIMES), LABELS)[0] > 1.0


@pytest.mark.parametrize(("system", "theirs"), [("UTC", ""), ("TDB", "TDB")])
def test_pxform_and_sxform_at_a_calendar_epoch(tmp_path, furnished, system, theirs):
    furnished(write_ck(MOTION.sample(TIMES), tmp_path / "a.bc", labels=replace(LABELS, time_system=system)))
    if system == "TDB":  # str2et wants leap seconds even for this
        (tmp_path / "b.tls").write_text(leap_seconds_kernel())
        furnished([tmp_path / "b.tls"])
    moment = spice.str2et(f"2026-03-01 12:35:06.789 {theirs}".strip())  # ten seconds in, a sample
    expected = rotation.as_matrix(MOTION.attitude(10.0)).T
    velocity = MOTION.angular_velocity(10.0)
    rounding = EPHEMERIS * np.linalg.norm(velocity)
    assert np.abs(spice.pxform("J2000", "TUMBLER_BODY", moment) - expected).max() <= rounding
    # dC/dt = −hat(Ω) C along the body's axes
    rate = spice.sxform("J2000", "TUMBLER_BODY", moment)[3:, :3]
    assert np.abs(rate + rotation.hat(velocity) @ expected).max() <= 3 * rounding
    assert spice.bodc2n(-777) == "TUMBLER_1"


def test_the_file_is_about_the_given_axes(tmp_path, furnished):
    body = shapes.box(2.0, (0.1, 0.2, 0.4)).placed(rotation.as_matrix(rotation.from_rotation_vector((0.3, -0.5, 0.7))))
    given = FreeMotion.from_body(body, angular_velocity=(1.0, 2.0, 0.3))
    axes = body.principal_axes
    attitude = rotation.multiply(given.attitude_at_epoch, rotation.from_matrix(axes))
    principal = FreeMotion(body.principal_moments, momentum=given.momentum_at_epoch @ axes, attitude=attitude)
    furnished(write_ck(replace(principal.sample(TIMES), frame=body.frame), tmp_path / "a.bc", labels=LABELS))
    assert max(errors_by_spice(given.sample(TIMES), LABELS)) <= EXACT


@pytest.mark.parametrize("scale", [1e-11, 1e-3, 1.0, 1e6, 1e9])
def test_times_come_back_bit_for_bit_at_any_scale(tmp_path, scale):
    samples = FreeMotion((1.0, 2.0, 3.0), momentum=np.array([0.3, 1.8, 1.5]) / scale).sample(TIMES * scale)
    back = read_ck(write_ck(samples, tmp_path / "a.bc", labels=LABELS)[0])
    assert np.array_equal(back.times, samples.times)
    assert rotation.angle_between(back.attitude, samples.attitude).max() <= EXACT
    assert np.abs(back.angular_velocity - samples.angular_velocity).max() * scale <= EXACT
    assert back.source.labels == replace(LABELS, object_name="TUMBLER_1", object_id=None, originator=None)


def test_times_before_zero_and_a_single_sample(tmp_path):
    for times in (TIMES - 7.3, TIMES[3:4]):
        back = read_ck(write_ck(MOTION.sample(times), tmp_path / "a.bc", labels=LABELS)[0])
        assert np.abs(back.times - times).max() <= 1e-15 * 20
        assert rotation.angle_between(back.attitude, MOTION.attitude(times)).max() <= EXACT


def test_without_angular_velocity(tmp_path, furnished):
    files = write_ck(MOTION.sample(TIMES), tmp_path / "a.bc", labels=LABELS, angular_velocity=False)
    assert read_ck(files[0]).angular_velocity is None
    assert spice.ktotal("ALL") == 0
    furnished(files)
    with pytest.raises(spice.exceptions.NotFoundError):
        spice.ckgpav(-777000, 0.0, 0.0, "J2000")


def test_no_interpolation_over_half_turns(tmp_path, furnished):
    fast = FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 3.0 * 2.0)).sample(np.arange(5.0))  # two radians a second
    slow = FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 3.0 * 4.0)).sample(np.arange(5.0))
    for name, samples, found in (("a", fast, True), ("b", slow, False)):
        furnished(write_ck(samples, tmp_path / f"{name}.bc", labels=LABELS))
        if found:
            spice.ckgpav(-777000, 0.5 * 2.0**40, 0.0, "J2000")
        else:
            with pytest.raises(spice.exceptions.NotFoundError):
                spice.ckgpav(-777000, 0.5 * 2.0**40, 0.0, "J2000")
        spice.kclear()


# ---------------------------------------------------------------- kernels of others


def others(path, write, count=41, clock=None):
    """Write a C-kernel by SPICE's own writers, with the clock of ours or another, and return it."""
    samples = MOTION.sample(np.linspace(0.0, 5.0, count))
    write_ck(samples, path.with_suffix(".bc"), labels=LABELS)
    path.unlink(missing_ok=True)
    handle = spice.ckopn(str(path), "others", 0)
    write(handle, samples, samples.times * 2.0**40)
    spice.ckcls(handle)
    if clock is not None:
        path.with_suffix(".tsc").write_text(clock)
    return samples


def space_rates(samples):
    return rotation.rotate(samples.attitude, samples.angular_velocity)


def type_1(handle, samples, ticks):
    spice.ckw01(handle, ticks[0], ticks[-1], -777000, "J2000", True, "one", len(ticks), ticks,
                rotation.conjugate(samples.attitude), space_rates(samples))  # fmt: skip


def type_2(handle, samples, ticks):
    spice.ckw02(handle, ticks[0], ticks[-1], -777000, "J2000", "two", len(ticks) - 1, ticks[:-1], ticks[1:],
                rotation.conjugate(samples.attitude[:-1]), space_rates(samples)[:-1],
                np.full(len(ticks) - 1, 2.0**-40))  # fmt: skip


def type_5(handle, samples, ticks):
    packets = np.concatenate([rotation.conjugate(samples.attitude), space_rates(samples)], axis=-1)
    spice.ckw05(handle, 3, 7, ticks[0], ticks[-1], -777000, "J2000", True, "five", ticks, packets,
                2.0**-40, 1, ticks[:1])  # fmt: skip


@pytest.mark.parametrize("write", [type_1, type_2, type_5])
@pytest.mark.parametrize("count", [4, 101, 102, 350])  # about the edges of the kernels' directories
def test_other_types_are_sampled_at_their_records(tmp_path, write, count):
    samples = others(tmp_path / "b.bc", write, count)
    back = read_ck(tmp_path / "b.bc")
    assert np.array_equal(back.times, samples.times)
    upto = slice(None, -1) if write is type_2 else slice(None)  # whose last record ends where no other begins
    assert rotation.angle_between(back.attitude, samples.attitude)[upto].max() <= EXACT
    assert np.abs(back.angular_velocity - samples.angular_velocity)[upto].max() <= EXACT


CLOCK = """KPL/SCLK
\\begindata
SCLK_KERNEL_ID = ( @2000-01-01 )
SCLK_DATA_TYPE_777 = ( 1 )
SCLK01_TIME_SYSTEM_777 = ( 2 )
SCLK01_N_FIELDS_777 = ( 2 )
SCLK01_MODULI_777 = ( 8192 1099511627776 )
SCLK01_OFFSETS_777 = ( 0 0 )
SCLK01_OUTPUT_DELIM_777 = ( 1 )
SCLK_PARTITION_START_777 = ( 0 )
SCLK_PARTITION_END_777 = ( 9007199254740991 )
SCLK01_COEFFICIENTS_777 = ( 0             820000000.25  1
                            2199023255552 820000002.25  1.5 )
\\begintext
"""


def test_a_clock_that_changes_its_rate(tmp_path):
    samples = others(tmp_path / "b.bc", type_1, clock=CLOCK)
    back = read_ck(tmp_path / "b.bc")
    expected = np.where(samples.times < 2.0, samples.times, 2.0 + 1.5 * (samples.times - 2.0)) + 0.25
    assert np.abs(back.times - expected).max() <= EXACT
    # TT seconds since J2000 of the clock's zero, 9490.7407 days on
    assert (back.source.labels.epoch, back.source.labels.time_system) == ("2025-12-26T05:46:40", "TT")


def test_which_body_is_asked_when_there_are_several(tmp_path):
    def both(handle, samples, ticks):
        type_1(handle, samples, ticks)
        spice.ckw01(handle, ticks[0], ticks[-1], -777001, "J2000", False, "two", len(ticks), ticks, samples.attitude,
                    np.zeros((len(ticks), 3)))  # fmt: skip

    samples = others(tmp_path / "b.bc", both)
    with pytest.raises(InvalidInput, match=r"-777001, -777000.*`spice_id`"):
        read_ck(tmp_path / "b.bc")
    assert rotation.angle_between(read_ck(tmp_path / "b.bc", spice_id=-777).attitude, samples.attitude).max() <= EXACT
    second = read_ck(tmp_path / "b.bc", spice_id=-777001)
    assert rotation.angle_between(second.attitude, rotation.conjugate(samples.attitude)).max() <= EXACT


# ---------------------------------------------------------------- refusals


def test_files_that_are_not_what_they_claim(tmp_path):
    files = write_ck(MOTION.sample(TIMES), tmp_path / "a.bc", labels=LABELS)
    text = tmp_path / "text.bc"
    text.write_text("no kernel")
    with pytest.raises(FormatError, match="is not a C-kernel"):
        read_ck(text)
    cut = tmp_path / "cut.bc"
    cut.write_bytes(files[0].read_bytes()[:1500])
    with pytest.raises(InvalidInput, match=r"cut\.bc: needs the clock kernel"):
        read_ck(cut)
    for size in (1500, 3000):
        cut.write_bytes(files[0].read_bytes()[:size])
        with pytest.raises(FormatError, match=r"cut\.bc: .*cut short or damaged"):
            read_ck(cut, sclk=files[2], fk=files[1])
    with pytest.raises(FormatError, match=r"a\.bc.*clock kernel"):
        read_ck(files[0], sclk=files[3])
    with pytest.raises(InvalidInput, match="no such clock kernel file"):
        read_ck(files[0], sclk=tmp_path / "none.tsc")
    assert spice.ktotal("ALL") == 0


@pytest.mark.parametrize(
    ("labels", "words"),
    [
        ({"spice_id": 5}, "spice_id"), ({"reference_frame": "MOON_SHINE"}, "MOON_SHINE"),
        ({"body_frame": "ECLIPJ2000"}, "SPICE's own"), ({"epoch": "soon"}, "soon"), ({"time_system": "UT1"}, "UT1"),
    ],
)  # fmt: skip
def test_labels_that_spice_has_no_words_for(tmp_path, labels, words):
    with pytest.raises(InvalidInput, match=words):
        write_ck(MOTION.sample(TIMES), tmp_path / "a.bc", labels=replace(LABELS, **labels))
    assert list(tmp_path.iterdir()) == []


def test_names_that_would_break_a_kernel(tmp_path, furnished):
    labels = replace(LABELS, object_name="it's\n\\begintext Ω", body_frame="ü b'")
    files = write_ck(MOTION.sample(TIMES), tmp_path / "a.bc", labels=labels)
    furnished(files)
    assert spice.bodc2n(-777) == "IT_S__BEGINTEXT__"
    assert max(errors_by_spice(MOTION.sample(TIMES), labels)) <= EXACT


def test_motions_that_a_kernel_cannot_hold(tmp_path):
    samples = MOTION.sample(TIMES)
    for broken, words in (
        (replace(samples, attitude=None), "attitude"), (replace(samples, times=TIMES[::-1]), "rise"),
        (FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((2, 3))).sample(TIMES), "batch"),
    ):  # fmt: skip
        with pytest.raises(InvalidInput, match=words):
            write_ck(broken, tmp_path / "a.bc", labels=LABELS)
    with pytest.raises(InvalidInput, match="may not end"):
        write_ck(samples, tmp_path / "a.tsc", labels=LABELS)
    with pytest.raises(InvalidInput, match="too long"):
        Clock.of(0.0, 1e20)
    with pytest.raises(InvalidInput, match="is not a folder"):
        write_ck(samples, tmp_path / "none" / "a.bc", labels=LABELS)


def test_kernels_of_others_stay(tmp_path):
    samples = MOTION.sample(TIMES[:20])
    for ending in ("tsc", "tf", "tls"):
        theirs = tmp_path / f"{ending}.{ending}"
        theirs.write_text("KPL/SCLK\n\nA mission's.\n")
        with pytest.raises(InvalidInput, match=rf"{ending}: is in the way, and polhode did not write it"):
            write_ck(samples, tmp_path / f"{ending}.bc", labels=LABELS)
        assert theirs.read_text() == "KPL/SCLK\n\nA mission's.\n" and not (tmp_path / f"{ending}.bc").exists()
    newer = leap_seconds_kernel().replace("by polhode", "by NAIF")
    (tmp_path / "a.tls").write_text(newer)  # leap seconds that are newer than ours serve as well
    for _ in range(2):
        write_ck(samples, tmp_path / "a.bc", labels=LABELS)
    assert (tmp_path / "a.tls").read_text() == newer
    assert np.array_equal(read_ck(tmp_path / "a.bc").times, samples.times)


THREADS = """
import contextlib, sys, threading
import numpy as np
from polhode import FreeMotion
from polhode.spacecraft.formats import spice, spice_kernels
from polhode.spacecraft.formats.spice_reading import read_ck
if "unlocked" in sys.argv:
    spice.spice_alone = spice_kernels.spice_alone = contextlib.nullcontext
samples, wrong = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample(np.linspace(0.0, 20.0, 50)), []
def work(name):
    for _ in range(40):
        try:
            spice.write_ck(samples, f"{name}.bc")
            found = read_ck(f"{name}.bc")
            assert np.abs(found.attitude - samples.attitude).max() < 1e-12 and len(found.times) == 50
        except Exception as error:
            wrong.append(error)
            return
threads = [threading.Thread(target=work, args=(name,)) for name in "abcd"]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
sys.exit(len(wrong))
"""


@pytest.mark.long_cases("locked")
@pytest.mark.parametrize("how", ["locked", "unlocked"])
def test_threads_take_turns(tmp_path, how):
    command = [sys.executable, "-c", THREADS, how]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=120, check=False)
    assert (done.returncode == 0) == (how == "locked"), done.stderr
