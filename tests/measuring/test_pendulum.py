"""Moments from pendulums, against bodies on filaments by Newton's laws, published formulas, and simulated timings."""

import math

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import polhode as ph
from polhode.errors import InvalidInput
from polhode.measuring import (
    Filaments,
    Jig,
    Measured,
    Pivot,
    Swing,
    compound_moment,
    compound_period,
    filament_moment,
    filament_period,
    fit_pendulum,
)

G = 9.80665
ROUND = 2e-11  # of a period; the integration keeps 1e-12 over some thousand steps
SIX = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1))
J = np.array([[0.030, 0.002, -0.001], [0.002, 0.035, 0.003], [-0.001, 0.003, 0.050]])


def period_by_newton(moment, mass, length, upper, lower, count, amplitude):
    """Return the period of a body on ``count`` filaments with six degrees of freedom, tensions as multipliers."""
    angles = 2.0 * np.pi * np.arange(count) / count
    circle = np.stack([np.cos(angles), np.sin(angles), np.zeros(count)], axis=1)
    above, below, inertia = upper * circle, lower * circle, np.diag([1.3, 0.9, 1.0]) * moment
    mobility = np.linalg.inv(np.block([[mass * np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), inertia]]))

    def rates(t, state):
        place, turn, speed, spin = state[:3], state[3:7], state[7:10], state[10:]
        R = Rotation.from_quat(np.roll(turn, -1)).as_matrix()
        taut, bend = [], []
        for top, foot in zip(above, below, strict=True):
            thread, moving = place + R @ foot - top, speed + R @ np.cross(spin, foot)
            taut.append(np.r_[thread, np.cross(foot, R.T @ thread)])
            bend.append(moving @ moving + thread @ (R @ np.cross(spin, np.cross(spin, foot))))
        taut, force = np.array(taut), np.r_[0.0, 0.0, -mass * G, -np.cross(spin, inertia @ spin)]
        tension = np.linalg.lstsq(taut @ mobility @ taut.T, -(taut @ mobility @ force + bend), rcond=None)[0]
        change = 0.5 * np.r_[-turn[1:] @ spin, turn[0] * spin + np.cross(turn[1:], spin)]
        return np.r_[speed, change, mobility @ (force + taut.T @ tension)]

    height = math.sqrt(length**2 - upper**2 - lower**2 + 2 * upper * lower * math.cos(amplitude))
    start = np.r_[0, 0, -height, math.cos(amplitude / 2), 0, 0, math.sin(amplitude / 2), np.zeros(6)]
    passes = lambda t, state: state[6]  # noqa: E731
    passes.terminal = True
    found = solve_ivp(rates, (0, 60), start, "DOP853", events=passes, rtol=1e-12, atol=1e-13)
    return 4.0 * found.t_events[0][0]


@pytest.mark.parametrize(
    "rig",
    [(0.01, 1.0, 0.5, 0.2, 0.2, 2, 2.2), (0.02, 2.0, 0.6, 0.3, 0.15, 3, 1.5), (0.002, 1.0, 0.4, 0.15, 0.15, 3, 1)],
)
def test_periods_are_those_of_newtons_laws(rig):
    *sizes, count, amplitude = rig
    assert filament_period(*sizes, amplitude) == pytest.approx(period_by_newton(*sizes, count, amplitude), rel=ROUND)


def test_the_rise_of_the_body_matters():
    """Without the kinetic energy of rising, M h′², the period at 126° on short filaments is wrong by a per cent."""
    true = period_by_newton(0.01, 1.0, 0.5, 0.2, 0.2, 2, 2.2)
    without = filament_period(0.01, 1e-12, 0.5, 0.2, 0.2, 2.2, G * 1e12)  # the same weight, and no mass that rises
    assert abs(without / true - 1.0) > 5e-3


def test_small_swings_have_the_published_formulas():
    """W A² T²/(16π²L) of two filaments at distance A (NACA Report 467), m g d₁ d₂ T²/(4π²h) of sloping ones."""
    assert filament_moment(2.0, 1.5, 1.2, 0.2, 0.2) == pytest.approx(1.5 * G * 0.4**2 * 4 / (16 * math.pi**2 * 1.2))
    h = math.sqrt(1.2**2 - 0.1**2)
    assert filament_moment(2.0, 1.5, 1.2, 0.2, 0.3) == pytest.approx(1.5 * G * 0.06 * 4 / (4 * math.pi**2 * h))
    # a uniform rod on its end swings as a simple pendulum of 2/3 of its length
    assert compound_period(1.0 / 12.0, 1.0, 0.5) == pytest.approx(2 * math.pi * math.sqrt(2.0 / 3.0 / G), rel=1e-14)


@pytest.mark.parametrize("amplitude", [0.0, 0.3, 2.0, 3.0])
def test_compound_pendulums_at_any_amplitude(amplitude):
    exact = 4 * math.sqrt((0.02 + 0.09) / (G * 0.3)) * float(mpmath.ellipk(mpmath.sin(amplitude / 2) ** 2))
    assert compound_period(0.02, 1.0, 0.3, amplitude) == pytest.approx(exact, rel=1e-14)
    assert compound_moment(exact, 1.0, 0.3, amplitude) == pytest.approx(0.02, rel=1e-12)


def test_an_offset_of_the_centre_of_mass():
    """Filaments at distances a and b from the centre of mass: I = m g a b T²/(4π²ℓ), and the jig's share of it."""
    rig = Filaments(Measured(1.2), Measured(0.2), Measured(0.2), Measured(0.05))
    fit = fit_pendulum([Swing((0, 0, 1), rig, Measured(2.0, 0.01))], Measured(1.5))
    assert fit.moments.value[0] == pytest.approx(1.5 * G * 0.25 * 0.15 * 4 / (4 * math.pi**2 * 1.2), rel=1e-12)


def swings_of(noise=None, timings=4, mass=1.5):
    """Return swings about six axes of a body of tensor J on two filaments, with a jig, errors drawn if asked for."""
    draw = (lambda value, error: value) if noise is None else (lambda value, error: noise.normal(value, error))
    rig = Filaments(Measured(draw(1.5, 2e-3), 2e-3), Measured(draw(0.2, 3e-4), 3e-4), Measured(0.2, 0.0))
    rig = rig._replace(lower=rig.upper)
    jig = Jig(Measured(draw(0.1, 1e-3), 1e-3), Measured(draw(5e-4, 1e-5), 1e-5))
    found = []
    for axis in SIX:
        n = np.array(axis) / np.linalg.norm(axis)
        true = filament_period(n @ J @ n + 5e-4, mass + 0.1, 1.5, 0.2, 0.2, 0.3)
        if noise is None:
            period = Measured(true, 1e-3)
        else:
            times = noise.normal(true, 4e-3, timings)
            period = Measured(times.mean(), times.std(ddof=1) / math.sqrt(timings), timings - 1.0)
        found.append(Swing(axis, rig, period, 0.3, jig=jig))
    return found, Measured(draw(mass, 2e-3), 2e-3)


def test_six_axes_give_the_tensor():
    fit = fit_pendulum(*swings_of())
    assert fit.inertia is not None and fit.principal is not None and fit.principal_axes is not None
    np.testing.assert_allclose(fit.inertia.value, [*np.diag(J), J[0, 1], J[0, 2], J[1, 2]], atol=1e-12)
    np.testing.assert_allclose(fit.principal_axes @ np.diag(fit.principal.value) @ fit.principal_axes.T, J, atol=1e-12)
    assert fit.unphysical == 0.0 and fit.freedom == 0


@pytest.mark.sweep
def test_errors_cover_the_truth():
    """95 % intervals of six entries and of single axes, each over 150 drawn experiments with four timings a swing."""
    noise, inside, inside_tensor = np.random.default_rng(5), [], []
    true = np.array([n @ J @ n / (n @ n) for n in np.array(SIX, float)])
    entries = np.array([*np.diag(J), J[0, 1], J[0, 2], J[1, 2]])
    for _ in range(150):
        fit = fit_pendulum(*swings_of(noise))
        for estimate, values, hits in ((fit.combined, true, inside), (fit.inertia, entries, inside_tensor)):
            ends = estimate.interval()
            hits.append((ends[:, 0] < values) & (values < ends[:, 1]))
    assert 0.93 < np.mean(inside) < 0.99 and 0.93 < np.mean(inside_tensor) <= 1.0


def test_errors_of_a_shared_rig_do_not_average_out():
    """Ten swings on one pair of filaments know the moment no better than its length and spacing are known."""
    rig = Filaments(Measured(1.5, 0.015), Measured(0.2), Measured(0.2))
    alone = lambda: Filaments(Measured(1.5, 0.015), Measured(0.2), Measured(0.2))  # noqa: E731
    period = lambda: Measured(2.0, 1e-5)  # noqa: E731
    shared = fit_pendulum([Swing((0, 0, 1), rig, period()) for _ in range(10)], Measured(1.5)).combined
    own = fit_pendulum([Swing((0, 0, 1), alone(), period()) for _ in range(10)], Measured(1.5)).combined
    assert shared.standard_error[0] / shared.value[0] == pytest.approx(0.01, rel=0.01)
    assert own.standard_error[0] / own.value[0] == pytest.approx(0.01 / math.sqrt(10), rel=0.01)


@pytest.mark.sweep
def test_the_centre_of_mass_on_a_scale():
    mass, moment, place = 1.2, 0.03, 0.31
    noise, off = np.random.default_rng(1), []
    for _ in range(8):
        swings = [
            Swing((0, 1, 0), Pivot(None, p),
                  Measured(noise.normal(compound_period(moment, mass, abs(place - p), 0.2), 5e-4), 5e-4), 0.2)
            for p in (0.0, 0.1, 0.55)
        ]  # fmt: skip
        fit = fit_pendulum(swings, Measured(mass, 1e-3))
        assert fit.center is not None
        off += [(fit.center.value[0] - place) / fit.center.standard_error[0],
                (fit.combined.value[0] - moment) / fit.combined.standard_error[0]]  # fmt: skip
    assert 0.5 < np.std(off) < 1.6


@pytest.mark.sweep
@pytest.mark.parametrize("noise", [1e-15, 1e-12, 1e-6])
def test_precise_timings_tell_the_centre_as_well_as_they_say(noise):
    mass, moment, place, draw = 1.2, 0.03, 0.31, np.random.default_rng(2)
    periods = [compound_period(moment, mass, abs(place - p), 0.2) for p in (0.0, 0.1, 0.55)]
    for _ in range(4):
        swings = [Swing((0, 1, 0), Pivot(None, p), Measured(t * (1 + noise * draw.normal()), noise * t), 0.2)
                  for p, t in zip((0.0, 0.1, 0.55), periods, strict=True)]  # fmt: skip
        fit = fit_pendulum(swings, Measured(mass))
        assert abs(fit.center.value[0] - place) < 5 * fit.center.standard_error[0]
        assert abs(fit.combined.value[0] - moment) < 5 * fit.combined.standard_error[0]


def test_drag_is_taken_out():
    """θ̈ = −mgd sin θ/I − cθ̇ from 0.3 rad: the time of ten swings, and the last amplitude, give the moment back."""
    mass, moment, d = 1.0, 0.02, 0.3
    whole = moment + mass * d**2
    swing = lambda t, s: [s[1], -mass * G * d * math.sin(s[0]) / whole - 0.08 * s[1]]  # noqa: E731
    turns = lambda t, s: s[1]  # noqa: E731
    found = solve_ivp(swing, (0, 30), [0.3, 0.0], "DOP853", events=turns, rtol=1e-11, atol=1e-12)
    times, ends = found.t_events[0], np.abs(found.y_events[0][:, 0])
    times, ends = (times[1:], ends[1:]) if times[0] < 0.1 else (times, ends)
    period, last = times[19] / 10.0, float(ends[19])
    given = lambda end: Swing((0, 0, 1), Pivot(Measured(d)), Measured(period, 1e-4), 0.3, end, 10)  # noqa: E731
    assert fit_pendulum([given(last)], Measured(mass)).moments.value[0] == pytest.approx(moment, rel=3e-5)
    assert abs(fit_pendulum([given(None)], Measured(mass)).moments.value[0] / moment - 1.0) > 1e-2


def test_swings_that_disagree_are_seen():
    rig = Filaments(Measured(1.5), Measured(0.2), Measured(0.2))
    swings = [Swing((0, 0, 1), rig, Measured(period, 1e-3)) for period in (2.0, 2.02)]
    fit = fit_pendulum(swings, Measured(1.5))
    assert fit.misfit == pytest.approx((0.02 / 1e-3) ** 2 / 2.0, rel=0.02) and fit.freedom == 1


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: filament_period(-1.0, 1.0, 1.0, 0.2, 0.2), "`moment` must be positive"),
        (lambda: filament_period(1.0, 1.0, 0.3, 0.2, 0.2, 2.0), "too short"),
        (lambda: filament_moment(0.01, 1.0, 0.45, 0.2, 0.2, 2.0), "period 0.01 s is too short"),
        (lambda: compound_period(1.0, 1.0, 1.0, 3.14), "amplitude"),
        (lambda: fit_pendulum([], Measured(1.0)), "empty"),
        (lambda: fit_pendulum([Swing((0, 0, 1), Pivot(Measured(0.3)), Measured(1.0))], Measured(1.0)), "an error"),
        (lambda: fit_pendulum([Swing((0, 0, 1), Pivot(Measured(0.3)), Measured(1.0, 0.1))], Measured(1.0)), "positive"),
        (lambda: fit_pendulum([Swing((0, 0, 1), Pivot(None), Measured(1.0, 0.1))], Measured(1.0)), "two places"),
        (lambda: fit_pendulum([Swing((0, 0, 0), Pivot(None), Measured(1.0, 0.1))], Measured(1.0)), "not all zero"),
    ],
)  # fmt: skip
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


FILE = """
mass = "1.523 ± 0.001 kg"
[pendulum]
kind = "bifilar"
length = "1.500 ± 0.001 m"
spacing = "0.400 ± 0.0005 m"
turns = 10
amplitude = "15 deg"
[pendulum.jig]
mass = "80 ± 1 g"
moment = "4.0e-4 ± 1e-5 kg*m^2"
[[swing]]
axis = "z"
periods = ["19.62 s", "19.58 s", "19.60 s", "19.63 s"]
"""


def test_a_file_of_periods(tmp_path):
    path = tmp_path / "drone.toml"
    path.write_text(FILE, encoding="utf-8")
    report = ph.fit(path, pendulum=True)
    moment = report.values()["moments"][0]
    period = np.mean([19.62, 19.58, 19.60, 19.63]) / 10.0
    whole = filament_moment(period, 1.603, 1.5, 0.2, 0.2, math.radians(15.0))
    assert moment["moment"] == pytest.approx(whole - 4e-4, rel=1e-12)
    # 2·0.0005/0.4 of the spacing leads, then the length, the masses and the timings
    parts = (2 * 0.0005 / 0.4, 0.001 / 1.5, math.hypot(0.001, 0.001) / 1.603, 2 * 0.0111 / 19.6)
    assert moment["standard_error"] == pytest.approx(math.hypot(*(whole * part for part in parts), 1e-5), rel=2e-3)
    assert "about z" in report.summary and report.json()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (('"bifilar"', '"bifiler"'), "must be one of"),
        (('spacing = "0.400 ± 0.0005 m"\n', ""), r"swing.1.spacing: is missing"),
        (('spacing = "0.400', 'radius = "0.400'), "is not a size of a bifilar pendulum"),
        (('["19.62 s", "19.58 s", "19.60 s", "19.63 s"]', '"19.6 s"'), "one timing without an error"),
        (('"19.62 s", "19.58 s", "19.60 s", "19.63 s"', '"19.6 s", "19.6 s"'), "all the same"),
        (('"19.63 s"', '"1.963 s"'), r"has 1\.963 s among timings about 19\.59 s"),
        (('axis = "z"', "axis = [0, 0, 0]"), "not all zero"),
        (('moment = "4.0e-4 ± 1e-5 kg*m^2"\n', ""), "needs moment, or periods"),
        (("turns = 10", "turns = 0"), "positive number of oscillations"),
        (('mass = "1.523 ± 0.001 kg"', "mass = 1.5"), "needs a number with its unit"),
    ],
)
def test_mistakes_in_a_file(tmp_path, change, words):
    path = tmp_path / "drone.toml"
    path.write_text(FILE.replace(*change), encoding="utf-8")
    with pytest.raises(InvalidInput, match=words):
        ph.fit(path, pendulum=True)


JIG_FILE = FILE.replace('moment = "4.0e-4 ± 1e-5 kg*m^2"', 'periods = ["12.31 s", "12.33 s"]')


def written(tmp_path, text):
    path = tmp_path / "drone.toml"
    path.write_text(text, encoding="utf-8")
    return path


def moment_of(tmp_path, text):
    return ph.fit(written(tmp_path, text), pendulum=True).values()["moments"][0]["moment"]


def small_filament_moment(period, mass, amplitude):
    """Return mgR²T²/(16K²h) of long filaments; the rise is less than a thousandth of the moment here."""
    return mass * G * 0.2**2 / 1.5 * (period / (4 * float(mpmath.ellipk(math.sin(amplitude / 2) ** 2)))) ** 2


def test_a_jig_is_timed_like_the_swings(tmp_path):
    """Ten oscillations of the jig in each of its timings, from the same amplitude, unless it has its own."""
    amplitude, period = math.radians(15.0), np.mean([19.62, 19.58, 19.60, 19.63]) / 10.0
    whole = filament_moment(period, 1.603, 1.5, 0.2, 0.2, amplitude)
    shared = moment_of(tmp_path, JIG_FILE)
    assert shared == pytest.approx(whole - filament_moment(1.232, 0.08, 1.5, 0.2, 0.2, amplitude), rel=1e-12)
    assert whole - shared == pytest.approx(small_filament_moment(1.232, 0.08, amplitude), rel=5e-3)
    five = moment_of(tmp_path, JIG_FILE.replace('mass = "80 ± 1 g"', 'mass = "80 ± 1 g"\nturns = 20'))
    assert five == pytest.approx(whole - filament_moment(0.616, 0.08, 1.5, 0.2, 0.2, amplitude), rel=1e-12)
    wide = moment_of(tmp_path, JIG_FILE.replace('mass = "80 ± 1 g"', 'mass = "80 ± 1 g"\namplitude = "60 deg"'))
    assert wide == pytest.approx(whole - filament_moment(1.232, 0.08, 1.5, 0.2, 0.2, math.radians(60)), rel=1e-12)


def test_a_jig_of_one_swing_is_timed_like_that_swing(tmp_path):
    head, _, tail = JIG_FILE.partition("[pendulum.jig]\n")
    jig, _, swing = tail.partition("[[swing]]\n")
    own = f"{head}[[swing]]\n{swing}turns = 10\n[swing.jig]\n{jig}".replace("turns = 10\namplitude", "amplitude", 1)
    assert moment_of(tmp_path, own) == moment_of(tmp_path, JIG_FILE)


def test_a_jig_slows_down_like_the_swings(tmp_path):
    """On a pivot, θ̈ = −m′gd′ sin θ/I′ − cθ̇ of the jig alone too: its decay is taken out of its period."""
    mass, moment, d = 1.0, 0.02, 0.3

    def timed(whole, leverage, drag):
        swing = lambda t, s: [s[1], -G * leverage * math.sin(s[0]) / whole - drag * s[1]]  # noqa: E731
        turns = lambda t, s: s[1]  # noqa: E731
        found = solve_ivp(swing, (0, 30), [1.2, 0.0], "DOP853", events=turns, rtol=1e-11, atol=1e-12)
        keep = found.t_events[0] > 0.1
        return float(found.t_events[0][keep][19]), float(abs(found.y_events[0][keep][19, 0]))

    alone, last_alone = timed(0.05, 0.5 * 0.2, 0.03)
    both, last = timed(0.05 + moment + mass * d**2, 0.5 * 0.2 + mass * d, 0.03)
    text = f"""
mass = "1 kg"
[pendulum]
kind = "compound"
distance = "0.3 m"
turns = 10
amplitude = "1.2 rad"
last_amplitude = "{last!r} rad"
[pendulum.jig]
mass = "0.5 kg"
distance = "0.2 m"
periods = "{alone!r} ± 1e-3 s"
last_amplitude = "{last_alone!r} rad"
[[swing]]
periods = "{both!r} ± 1e-3 s"
"""
    assert moment_of(tmp_path, text) == pytest.approx(moment, rel=2e-3)
    own = f'last_amplitude = "{last_alone!r} rad"'
    same = moment_of(tmp_path, text.replace(own, f'last_amplitude = "{last!r} rad"'))
    assert moment_of(tmp_path, text.replace(own, "")) == same
    # a jig that keeps its amplitude would have another moment
    assert abs(moment_of(tmp_path, text.replace(own, 'last_amplitude = "1.2 rad"')) / moment - 1.0) > 1e-2
    with pytest.raises(InvalidInput, match=r"jig.last_amplitude: must be positive and at most the jig's amplitude"):
        moment_of(tmp_path, text.replace('[pendulum.jig]', '[pendulum.jig]\namplitude = "5 deg"'))


def test_every_size_without_error_is_named(tmp_path):
    notes = ph.fit(written(tmp_path, JIG_FILE.replace("80 ± 1 g", "80 g")), pendulum=True).notes
    assert any("taken as exact: jig.mass" in note for note in notes)


def test_the_file_is_taken_alone(tmp_path):
    path = tmp_path / "drone.toml"
    path.write_text(FILE, encoding="utf-8")
    for call in (lambda: ph.fit(path, path, pendulum=True), lambda: ph.fit(path, pendulum=True, drag=True)):
        with pytest.raises(InvalidInput, match="one file of periods alone"):
            call()
