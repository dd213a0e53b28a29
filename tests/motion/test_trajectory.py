"""A trajectory explains itself."""

import dataclasses

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.motion import Ending, Outcome, StateLayout, StatePart
from polhode.motion._layout import ATTITUDE, MOMENTUM
from polhode.systems import TorquedGyrostat

HEAD = "time [s],q_w,q_x,q_y,q_z,omega_1 [rad s-1],omega_2 [rad s-1],omega_3 [rad s-1]\n"
MOMENTS, MOMENTUM_AT_EPOCH = (1.0, 2.0, 3.0), (0.3, 1.8, 1.5)


@pytest.fixture(scope="module")
def motion():
    return ph.FreeMotion(MOMENTS, momentum=MOMENTUM_AT_EPOCH)


def test_it_prints_on_one_screen(motion):
    found = motion.sample(np.linspace(0.0, 10.0, 1000))
    lines = repr(found).splitlines()
    assert len(lines) <= 20 and max(map(len, lines)) <= 120
    assert "1000 samples, 0 s to 10 s of FreeMotion" in lines[0] and "exact" in lines[-1]
    assert found._repr_html_().count("<tr>") == len(lines)


def test_a_system_with_many_invariants_prints_on_one_screen():
    many = {f"invariant {k}": np.ones(3) for k in range(400)}
    found = ph.Trajectory(np.arange(3.0), np.zeros((3, 2)), invariants=many)
    assert len(repr(found).splitlines()) <= 20 and "and 394 more" in repr(found)


def test_parts_are_found_by_name():
    system = TorquedGyrostat(MOMENTS, (0.0, 0.0, 1.0), 0.1, 0.5)
    found = ph.simulate(system, [1.0, 0.0, 0.0, 0.0, *MOMENTUM_AT_EPOCH, 0.2], [0.0, 1.0, 2.0], estimate_error=False)
    assert found.layout.names == ("attitude", "momentum", "rotor_momentum")
    # a constant torque of 0.5 N m
    assert np.abs(found.part("rotor_momentum") - (0.2 + 0.5 * found.times)).max() < 1e-12
    assert np.array_equal(found.part("momentum"), found.momentum)
    with pytest.raises(InvalidInput, match=r"no part 'spin'; its parts are attitude, momentum, rotor_momentum"):
        found.part("spin")


def test_samples_between_two_times(motion):
    found = motion.sample(np.linspace(0.0, 10.0, 11))
    part = found.between(7.2, 2.9)
    assert part.times.tolist() == [3.0, 4.0, 5.0, 6.0, 7.0] and len(part) == 5
    assert np.array_equal(part.momentum, found.momentum[3:8])
    assert np.array_equal(part.invariants["energy"], found.invariants["energy"][3:8])
    assert part.motion is motion
    with pytest.raises(InvalidInput, match="no sample lies between"):
        found.between(2.2, 2.8)


def test_batches_are_cut_along_time():
    motions = ph.FreeMotion(MOMENTS, momentum=np.array([MOMENTUM_AT_EPOCH, (0.1, 0.2, 0.3)]))
    found = motions.sample(np.linspace(0.0, 10.0, 11))
    assert found.batch_shape == (2,) and len(found) == 11
    cut = found.between(2.0, 4.0)
    assert cut.states.shape == (2, 3, 7) and np.array_equal(cut.attitude, found.attitude[:, 2:5])


def test_layout():
    layout = StateLayout((ATTITUDE, MOMENTUM, StatePart("turn", 1, "rad")))
    states = np.arange(16.0).reshape(2, 8)
    assert layout.part(states, "turn").tolist() == [7.0, 15.0]
    assert layout.part(states, "momentum").tolist() == [[4.0, 5.0, 6.0], [12.0, 13.0, 14.0]]
    assert list(layout.scalars) == ["turn"]


@pytest.mark.parametrize(
    ("outcome", "words"),
    [
        (Outcome(), "exact"),
        (Outcome(Ending.EVENT, "lift-off"), "lift-off"),
        (Outcome(Ending.NOT_CONVERGED, message="Dopri8 failed"), "not converged: Dopri8 failed"),
    ],
)
def test_outcomes_in_words(outcome, words, tmp_path, motion):
    assert str(outcome) == words
    written = dataclasses.replace(motion.sample([0.0, 1.0]), outcome=outcome)
    path = ph.formats.write_dataset(written, tmp_path / "motion.nc")
    assert ph.formats.read_dataset(path).outcome == outcome


def test_other_times_of_an_exact_motion_keep_the_frame(motion):
    frame = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).frame
    found = dataclasses.replace(motion.sample([0.0, 1.0]), frame=frame).resample([0.25, 7.0])
    assert found.frame is frame and found.times.tolist() == [0.25, 7.0]
    assert np.array_equal(found.momentum, motion.momentum(np.array([0.25, 7.0])))
    with pytest.raises(InvalidInput, match="not of an exact motion"):
        dataclasses.replace(found, source=None).resample([1.0])


def test_samples_of_a_file_take_the_axes_of_a_body(tmp_path):
    """A table along the sides of a box, whose long side x has the least moment and is the third principal axis."""
    box = ph.shapes.box(1.0, (0.1, 0.2, 0.3))
    turn = [0.8, 0.6, 0.0, 0.0]
    path = tmp_path / "log.csv"
    path.write_text(HEAD + "".join(
        ",".join(map(repr, [t, *turn, 2.0, 0.5, -0.25])) + "\n" for t in (0.0, 1.0)), "utf-8")  # fmt: skip
    read = ph.formats.read_csv(path)
    found = read.with_frame(box.frame)
    assert (found.along("given").angular_velocity == read.angular_velocity).all()
    along = found.along("principal")
    assert np.abs(along.angular_velocity[0]) == pytest.approx(np.abs([-0.25, 0.5, 2.0]))
    for samples in (read, along):  # one and the same vector in space
        in_space = ph.rotation.as_matrix(samples.attitude[0]) @ samples.angular_velocity[0]
        assert in_space == pytest.approx(ph.rotation.as_matrix(np.array(turn)) @ [2.0, 0.5, -0.25], abs=1e-15)
    assert (read.with_frame(box.frame, along="principal").along("principal").attitude == read.attitude).all()


@pytest.mark.parametrize(("change", "words"), [
    (lambda samples, frame: samples.with_frame(frame), "are of an exact motion, whose body is known.* `from_body`"),
    (lambda samples, frame: samples.with_frame(frame, along="giben"), "must be .given. or .principal.*; got 'giben'"),
])  # fmt: skip
def test_bodies_that_samples_cannot_have(change, words, motion, any_type):
    with pytest.raises(InvalidInput, match=words):
        change(motion.sample([0.0, 1.0]), ph.shapes.box(1.0, (0.1, 0.2, 0.3)).frame)
