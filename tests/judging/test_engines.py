"""The harness: it measures what was put in, in every precision, and finds each kind of fault."""

import numpy as np
import pytest

import polhode as ph
from polhode.judging import compare_engine, reference_motions

ANGLE = 1e-5


def exact(motion):
    return motion.attitudes, motion.momenta


def turned(motion):
    """The exact attitude, turned about a body axis."""
    return ph.rotation.multiply(motion.attitudes, ph.rotation.from_axis_angle((1.0, 2.0, -2.0), ANGLE)), motion.momenta


def conjugated(motion):
    return ph.rotation.conjugate(motion.attitudes), motion.momenta


def scalar_last(motion):
    return np.roll(motion.attitudes, -1, axis=-1), motion.momenta


def wrong_sense(motion):
    """Euler's equations with the wrong sign run backwards."""
    return motion.attitudes, ph.FreeMotion(motion.moments, momentum=motion.momentum).momentum(-motion.times)


def opposite_quaternions(motion):
    return -motion.attitudes, motion.momenta


def drifting(motion):
    return motion.attitudes, motion.momenta * (1.0 + 1e-6 * motion.rate * np.abs(motion.times))[:, None]


def growing(motion):
    return 1.01 * motion.attitudes, motion.momenta


def lost_at_the_end(motion):
    momenta = motion.momenta.copy()
    momenta[-1, 2] = np.nan
    return motion.attitudes, momenta


FLIPS = reference_motions("flips", up_to=100.0)


def test_exact_states_have_no_errors():
    found = compare_engine(exact, reference_motions())
    assert found.worst.motions == len(reference_motions())
    assert found.precision == np.float64 and found.eps == 2.0**-52
    assert max(found.worst[1:]) < 1e-15


@pytest.mark.parametrize(
    ("engine", "fault", "at_least", "others_below"),
    [
        (turned, "attitude", 0.99 * ANGLE, 1e-15),
        (conjugated, "attitude", 1.0, 1e-15),
        (scalar_last, "attitude", 1.0, 1e-15),
        (wrong_sense, "momentum", 0.1, 1e-14),
        (growing, "length", 0.0099, 1e-15),
    ],
)
def test_each_fault_shows_where_it_belongs(engine, fault, at_least, others_below):
    worst = compare_engine(engine, FLIPS).worst._asdict()
    assert worst.pop("motions") == len(FLIPS)
    assert worst.pop(fault) >= at_least
    assert max(worst.values()) <= others_below


def test_the_angle_is_measured():
    found = compare_engine(turned, FLIPS)
    for errors in found.motions:
        assert errors.attitude == pytest.approx(np.full(errors.motion.times.size, ANGLE), rel=1e-9)


def test_both_signs_of_a_quaternion_are_one_attitude():
    assert compare_engine(opposite_quaternions, FLIPS).worst.attitude < 1e-15


def test_drift_shows_in_energy_and_grows_with_time():
    found = compare_engine(drifting, FLIPS)
    for errors in found.motions:
        turns = errors.motion.rate * np.abs(errors.motion.times)
        motion = errors.motion
        energy = np.sum(motion.momentum**2 / motion.moments) / 2.0
        speeds, sizes = (np.linalg.norm(x, axis=-1).max() for x in (motion.momenta / motion.moments, motion.momenta))
        assert errors.energy == pytest.approx(2e-6 * turns * energy / (speeds * sizes), rel=1e-3, abs=1e-15)
        assert errors.attitude.max() < 1e-15


def test_the_energy_of_a_top_counts_its_height():
    """A top whose axis rises by δ too much has mgl sin θ δ too much energy."""
    (motion,) = (m for m in reference_motions("top-pendulum") if m.name == "pendulum, from level")

    def raised(motion):
        turn = ph.rotation.from_axis_angle((1.0, 0.0, 0.0), 1e-6)
        return ph.rotation.multiply(motion.attitudes, turn), motion.momenta

    errors = compare_engine(raised, [motion]).motions[0]
    axis = ph.rotation.rotate(motion.attitudes, (0.0, 0.0, 1.0))
    sides = ph.rotation.rotate(motion.attitudes, (0.0, 1.0, 0.0))
    scale = np.linalg.norm(motion.momenta / motion.moments, axis=-1).max()
    scale = scale * np.linalg.norm(motion.momenta, axis=-1).max() + motion.mgl
    assert abs(axis[0, 2]) < 1e-15 and abs(sides[0, 2]) > 0.1
    assert errors.energy[0] == pytest.approx(1e-6 * motion.mgl * abs(sides[0, 2]) / scale, rel=1e-6)


def test_what_is_not_a_number_is_infinitely_wrong():
    found = compare_engine(lost_at_the_end, FLIPS)
    assert found.worst.momentum == np.inf and found.worst.energy == np.inf
    assert "inf" in str(found)


def test_single_precision_is_judged_by_its_own_eps():
    """Rounding alone gives an engine's floor, and the rounding of what is given another one."""
    motions = reference_motions("near-separatrix", up_to=100.0) + reference_motions("scales", up_to=100.0)

    def engine(motion):
        return motion.attitudes.astype(np.float32), motion.momenta.astype(np.float32)

    found = compare_engine(engine, motions)
    assert found.precision == np.float32 and found.eps == 2.0**-23
    assert found.worst.attitude < found.eps and found.worst.length < found.eps
    assert found.families["near-separatrix"].rounding > 1e3 * found.eps
    tiny = [errors for errors in found.motions if errors.motion.name == "moments of 1e-40"]
    assert 1e-5 < tiny[0].rounding.max()  # numbers below the normal ones have fewer digits
    with np.errstate(over="ignore"):
        half = compare_engine(lambda m: tuple(x.astype(np.float16) for x in exact(m)), motions)
    assert half.eps == 2.0**-10 and half.worst.rounding == np.inf


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_stepping_engine_gains_by_its_order(dtype):
    """Euler's method and the midpoint rule: half the step, half or a quarter of the error."""
    motions = reference_motions("symmetric", up_to=5.0)

    def engine(count, order):
        def stepped(motion):
            q, L = [], []
            for t in motion.times:
                state, h = np.concatenate([motion.attitude, motion.momentum]).astype(dtype), dtype(t / count)
                moments = motion.moments.astype(dtype)
                for _ in range(count):
                    rate = rates(state, moments)
                    state = state + h * (rate if order == 1 else rates(state + h / 2 * rate, moments))
                q.append(state[:4] / np.linalg.norm(state[:4]))
                L.append(state[4:])
            return np.array(q, dtype), np.array(L, dtype)

        return stepped

    for order in (1, 2):
        coarse, fine = (compare_engine(engine(count, order), motions[:2]).worst.attitude for count in (64, 128))
        assert coarse / fine == pytest.approx(2.0**order, rel=0.25)


def rates(state, moments):
    (w, x, y, z), L = state[:4], state[4:]
    a, b, c = spin = L / moments
    turn = np.array([-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a]) / 2
    return np.concatenate([turn, np.cross(L, spin)]).astype(state.dtype)


def test_the_table_has_one_line_a_family():
    motions = reference_motions("flips") + reference_motions("top-cusps")
    lines = str(compare_engine(exact, motions)).splitlines()
    assert lines[0].startswith("float64, eps = 2.22e-16")
    assert [line.split()[0] for line in lines[1:]] == ["family", "flips", "top-cusps", "all"]
    assert lines[-1].split()[1] == str(len(motions))
    assert len({len(line) for line in lines[1:]}) == 1


def test_long_times_stand_apart():
    def late(motion):
        off = ph.rotation.from_axis_angle((0.0, 0.0, 1.0), np.where(motion.moderate, 0.0, 0.1))
        return ph.rotation.multiply(motion.attitudes, off), motion.momenta

    worst = compare_engine(late, reference_motions("flips")).worst
    assert worst.attitude < 1e-15 and worst.attitude_long == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("engine", "said"),
    [
        (lambda m: m.attitudes, "must return attitudes and momenta, two arrays; got"),
        (lambda m: (m.attitudes[1:], m.momenta), r"attitudes of shape \(9, 4\) in floating point; got .*\(8, 4\)"),
        (lambda m: (m.attitudes, m.momenta.astype(int)), r"momenta of shape \(9, 3\) in floating point; got int64"),
    ],
)
def test_answers_of_a_wrong_form_are_refused(engine, said):
    with pytest.raises(ph.InvalidInput, match=said):
        compare_engine(engine, reference_motions("flips", up_to=1000.0))


def test_no_motions_are_refused():
    with pytest.raises(ph.InvalidInput, match="got none"):
        compare_engine(exact, [])
