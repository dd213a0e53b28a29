"""The wobble estimated from polar motion: true values within the errors, published numbers for the Earth's."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.stats import multivariate_normal

from celestial.wobbling import AMPLITUDE, ANNUAL, DAY, MAS, PERIOD, RATE, YEAR, kicked, lines, white
from polhode.celestial import (
    euler_chain,
    fit_chandler,
    fit_chandler_process,
    fit_chandler_windows,
    polar_excitation,
    pole_spectrum,
    read_polar_motion,
)
from polhode.celestial.wobble import process as wobble_process  # fmt: skip
from polhode.errors import InvalidInput

FAR = 5.0  # standard errors, which one in a million passes


def rng(seed):
    return np.random.default_rng(seed)


def off(estimate, truth):
    return np.abs(estimate.value[: len(truth)] - truth) / estimate.standard_error[: len(truth)]


def test_lines_in_red_noise():
    fit = fit_chandler(*lines(rng(1)))
    assert (off(fit.estimate, [PERIOD, AMPLITUDE]) < FAR).all()
    size, error = fit.amplitude("annual_prograde")
    assert abs(size - ANNUAL) < FAR * error < 0.2 * ANNUAL
    assert abs(fit.term("mean") - (50 - 300j) * MAS) < 10 * MAS
    assert fit.energy_ratio < 0.01
    assert fit.rms == pytest.approx(20 * MAS, rel=0.15)  # mean square of AR(1) noise as made
    assert fit.inflation < 1.1


@pytest.mark.long
def test_errors_that_take_the_noise_for_white_are_too_small():
    """Red noise of a memory of 100 d is 2.5 times as large at the wobble's rate as white noise of its size."""
    fits = [fit_chandler(*lines(rng(seed))) for seed in range(9)]
    fit = sorted(fits, key=lambda fit: fit.estimate.standard_error[0])[4]
    plain = np.sqrt(6.0 * 2.0 * fit.rms**2 / len(fit.times)) / AMPLITUDE / (fit.times[-1] - fit.times[0])
    plain *= PERIOD**2 / (2 * np.pi)
    assert 1.8 * plain < fit.estimate.standard_error[0] < 5.0 * plain


@pytest.mark.long_cases(*(f"{noise}-{days}" for noise in ("1e-12", "1e-06") for days in (10.0, 1.0)), "0.0-1.0")
@pytest.mark.parametrize("days", [10.0, 5.0, 1.0])
@pytest.mark.parametrize("noise", [0.0, 1e-12, 1e-6])
def test_errors_hold_at_any_noise(days, noise):
    """A line and seasons in extended precision; 5 d are samples of the pole, not means over the step."""
    for seed in range(3):
        draw = rng(seed)
        period, amplitude, phase = draw.uniform(425, 440) * DAY, draw.uniform(100, 200) * MAS, draw.uniform(-3, 3)
        times = days * DAY * np.arange(int(25 * 365 / days))
        angle = 2 * np.pi * (times.astype(np.longdouble) - 0.5 * times[-1])
        m = amplitude * np.exp(1j * (angle / period + phase))
        m += ANNUAL * np.exp(1j * angle / YEAR) + 5 * MAS * np.exp(-1j * angle / YEAR)
        m = m.astype(complex) + noise * amplitude * (draw.normal(size=(len(times), 2)) @ [1, 1j])
        fit = fit_chandler(times, m.real, -m.imag)
        epoch = 2 * np.pi / period * (fit.epoch - 0.5 * times[-1])
        assert (off(fit.estimate, [period, amplitude, phase + epoch]) < FAR).all()
        assert fit.rms < 2 * noise * amplitude + 1e-14 * amplitude


@pytest.mark.parametrize("broken", [lambda x, y: (x, -y), lambda x, y: (y, x)], ids=["flipped", "swapped"])
def test_a_wrong_sense_is_noticed(broken):
    times, x, y = lines(rng(3), 14.0)
    with pytest.raises(InvalidInput, match=r"turns against the Earth's spin.*sign of y"):
        fit_chandler(times, *broken(x, y))


def changed(k, entry):
    return lambda *series: [np.concatenate([a[:90], [entry], a[91:]]) if i == k else a for i, a in enumerate(series)]


@pytest.mark.parametrize(("spoil", "words"), [
    (changed(1, np.nan), "`x` must be finite numbers.*; got nan at index 90"),
    (changed(0, 0.0), "`times` must ascend; entry 90"),
    (lambda t, x, y: (t, x / MAS, y / MAS), "must be in radians"),
    (lambda t, x, y: (t, x[:-1], y), "equally long"),
    (lambda t, x, y: (t[:20], x[:20], y[:20]), "at 50 times at least; got 20"),
    (lambda t, x, y: (t[:400], x[:400], y[:400]), "must last 12.8 years.*got 10.9"),
    (lambda t, x, y: (t, 0 * x, 0 * y), "no Chandler wobble"),
])  # fmt: skip
def test_refused(spoil, words):
    with pytest.raises(InvalidInput, match=words):
        fit_chandler(*spoil(*lines(rng(4), 14.0)))


def test_noise_alone_has_no_wobble():
    times = 10 * DAY * np.arange(700)
    m = MAS * white(rng(5), 700)
    with pytest.raises(InvalidInput, match=r"no Chandler wobble|turns against"):
        fit_chandler(times, m.real, -m.imag)


@pytest.mark.long
def test_a_wobble_that_is_kicked():
    series = kicked(rng(6), 40.0)
    fit, found = fit_chandler(*series), fit_chandler_process(*series)
    assert fit.noise.walk > 0.0
    assert abs(fit.estimate.value[0] - PERIOD) < FAR * fit.estimate.standard_error[0]
    assert abs(found.estimate.value[0] - PERIOD) < FAR * found.estimate.standard_error[0]
    (low, high), (lowest, highest) = found.quality_intervals[0.6827], found.quality_intervals[0.95]
    q = found.estimate.value[1]
    assert lowest < low < q < high < highest and high / q > q / low  # wider above
    assert lowest < 100.0 < highest
    assert found.whiteness > 1e-3
    turned = np.abs(found.wobble)
    assert 0.2 * AMPLITUDE < turned.mean() < 3 * AMPLITUDE and found.noise < 10 * MAS


@pytest.mark.long
def test_the_likelihood_is_that_of_a_dense_covariance():
    """Restricted likelihood by another way: real Gaussian numbers orthogonal to the annual term, by SciPy."""
    count, step, rate = 12, PERIOD, 1.001 * RATE
    data = white(rng(7), 2 * count).reshape(count, 2)
    band = wobble_process._Band(data, rate, step)

    def by_scipy(p):
        grid = (np.arange(200) + 0.5) / 200  # the process averaged over each step, by the midpoint rule
        decay = np.pi * np.exp(-p[1]) / (p[0] * 433 * DAY)
        t = (np.arange(count)[:, None] + grid).ravel() * step
        lag = t[:, None] - t
        kernel = np.exp(-decay * abs(lag) + 1j * (2 * np.pi / (p[0] * 433 * DAY) - rate) * lag) / (2 * decay * step)
        dense = kernel.reshape(count, 200, count, 200).mean(axis=(1, 3)) + np.exp(p[2]) * np.eye(count)
        basis = np.linalg.svd(data[:, 1:])[0][:, 1:]  # the complement of the annual term
        inside, seen = basis.conj().T @ dense @ basis, basis.conj().T @ data[:, 0]
        scale = (seen.conj() @ np.linalg.solve(inside, seen)).real / len(seen)
        both = 0.5 * scale * np.block([[inside.real, -inside.imag], [inside.imag, inside.real]])
        return -multivariate_normal(np.zeros(2 * len(seen)), both).logpdf(np.r_[seen.real, seen.imag])

    points = [np.array(p) for p in ((1.0, np.log(60.0), 0.0), (1.02, np.log(20.0), -1.0), (0.97, np.log(300.0), 1.0))]
    ours = [wobble_process._filter(p, band).cost for p in points]
    theirs = [by_scipy(p) for p in points]
    assert np.allclose(np.diff(ours), np.diff(theirs), atol=2e-3)


def test_windows_follow_what_changes():
    times, x, y = lines(rng(8), 30.0, 2 * MAS)
    m = x - 1j * y + AMPLITUDE * (times / times[-1]) * np.exp(1j * (RATE * times + 1.0))
    found = fit_chandler_windows(times, m.real, -m.imag, period=PERIOD)
    truth = AMPLITUDE * (1 + found.centres / times[-1])
    assert (np.abs(found.amplitude - truth) < FAR * found.amplitude_error + 0.01 * AMPLITUDE).all()
    assert np.abs(found.phase - found.phase.mean()).max() < 0.05
    assert found.centres[0] == pytest.approx(3 * YEAR, abs=10 * DAY)


@pytest.mark.parametrize(("window", "words"), [
    (3 * YEAR, "from 4 years"), (40 * YEAR, "20.0|19.9"), (np.nan, "window")])  # fmt: skip
def test_windows_that_cannot_be(window, words):
    with pytest.raises(InvalidInput, match=words):
        fit_chandler_windows(*lines(rng(9), 20.0), window=window, period=PERIOD)


def test_excitation_drives_the_pole_again():
    """The pole is integrated with a known excitation; deconvolution gives it back."""
    sigma = RATE * (1 + 0.5j / 80)
    psi = lambda t: (30 * np.cos(t / (60 * DAY)) + 20j * np.sin(t / (90 * DAY))) * MAS  # noqa: E731
    times = DAY * np.arange(1500.0)
    path = solve_ivp(lambda t, m: 1j * sigma * (m - psi(t)), (0, times[-1]), [0.1j * AMPLITUDE], t_eval=times,
                     rtol=1e-10, atol=1e-16, method="DOP853").y[0]  # fmt: skip
    found = polar_excitation(times, path.real, -path.imag, PERIOD, 80.0)
    assert np.abs(found.psi - psi(found.times)).max() < 0.3 * MAS
    wrong = polar_excitation(times, path.real, path.imag, PERIOD, 80.0)  # y's sign flipped
    assert np.abs(wrong.psi - psi(wrong.times)).max() > 10 * MAS


@pytest.mark.long
def test_covariance_of_the_excitation():
    times, noise = 10 * DAY * np.arange(4000.0), MAS * white(rng(10), 4000)
    found = polar_excitation(times, noise.real, -noise.imag, PERIOD, 100.0, noise=MAS)
    assert found.psi.real.std() == pytest.approx(found.error, rel=0.05)
    next_one = np.mean(found.psi[1:] * found.psi[:-1].conj()) / np.mean(np.abs(found.psi) ** 2)
    assert next_one == pytest.approx(found.correlation, abs=0.05)
    assert np.allclose(found.covariance[1, 0], 2 * found.error**2 * found.correlation)


def test_the_spectrum_holds_all_power():
    times, x, y = lines(rng(11), 40.0)
    found = pole_spectrum(times, x, y)
    lobe = lambda f: np.sum(found.density[np.abs(found.frequencies - f) < 0.06 / YEAR]) * np.diff(found.frequencies)[0]  # noqa: E731
    assert lobe(1 / PERIOD) == pytest.approx(AMPLITUDE**2, rel=0.1)
    assert lobe(1 / YEAR) == pytest.approx(ANNUAL**2, rel=0.1)
    assert lobe(-1 / PERIOD) < 1e-2 * AMPLITUDE**2


def test_the_chain_from_euler_to_chandler():
    """Published periods (Smith & Dahlen 1981), and the rigid one from Euler's equations themselves."""
    periods = np.array([stage.period for stage in euler_chain()]) / DAY
    assert np.allclose(periods, [303.62, 445.0, 394.5, 425.8, 430.6], atol=0.15)
    h = 3.273795e-3
    moments, sidereal = np.array([1 - h, 1 - h, 1.0]), 86164.0989

    def euler(t, w):
        return np.cross(moments * w, w) / moments

    rate = 2 * np.pi
    half = solve_ivp(euler, (0, 400), [1e-6, 0, rate], rtol=1e-10, atol=1e-13, dense_output=True, method="DOP853").sol
    turned = brentq(lambda t: half(t)[1], 250, 350)  # the axis is back on its side after a period
    assert turned * sidereal / DAY == pytest.approx(periods[0], rel=1e-5)
    with pytest.raises(InvalidInput, match=r"Love number from 0 to below 0.938"):
        euler_chain(elastic=0.95)


@pytest.fixture(scope="module")
def earth():
    return read_polar_motion()


@pytest.mark.long
@pytest.mark.parametrize(("first", "last", "period", "amplitude"), [
    (37665, 61312, 432.6, 122), (42778, 51544, 433.0, 172)])  # fmt: skip
def test_the_earth(earth, first, last, period, amplitude):
    inside = (earth.days >= first) & (earth.days < last)
    fit = fit_chandler(earth.days[inside] * DAY, earth.x[inside], earth.y[inside])
    assert fit.estimate.value[0] / DAY == pytest.approx(period, abs=1.0)
    assert fit.estimate.value[1] / MAS == pytest.approx(amplitude, abs=2.0)
    assert 0.5 < fit.estimate.standard_error[0] / DAY < 5.0
    assert fit.energy_ratio < 1e-3
    with pytest.raises(InvalidInput, match="against the Earth's spin"):
        fit_chandler(earth.days[inside] * DAY, earth.x[inside], -earth.y[inside])


@pytest.mark.long
def test_the_seasons_and_q_of_the_earth(earth):
    inside = earth.days < 61312
    series = earth.days[inside] * DAY, earth.x[inside], earth.y[inside]
    fit, found = fit_chandler(*series), fit_chandler_process(*series)
    assert fit.amplitude("annual_prograde")[0] / MAS == pytest.approx(92.0, abs=1.0)
    assert fit.amplitude("annual_retrograde")[0] / MAS == pytest.approx(4.8, abs=0.5)
    assert found.estimate.value[0] / DAY == pytest.approx(433.0, abs=3.0)
    low, high = found.quality_intervals[0.95]
    assert low < 49 < 179 < high  # Furuya & Chao 1996, Wilson & Vicente 1990
    windows = fit_chandler_windows(*series, period=432.6 * DAY)
    years = 1858.8761 + windows.centres / (365.25 * DAY)
    near = lambda year: windows.amplitude[np.argmin(np.abs(years - year))] / MAS  # noqa: E731
    assert near(1996) == pytest.approx(180, abs=10) and near(2020) < 30


def covered(runs, make, look):
    inside = []
    for seed in range(runs):
        try:
            inside.append(look(make(rng(1000 + seed))))
        except InvalidInput:
            continue
    assert len(inside) > 0.97 * runs
    return np.mean(inside, axis=0)


def within(interval, truth):
    return bool(interval[0] < truth < interval[1])


@pytest.mark.sweep
@pytest.mark.parametrize(("years", "make", "lowest"), [(14, lines, 0.92), (25, lines, 0.92), (25, kicked, 0.86),
                                                       (64, kicked, 0.86)])  # fmt: skip
def test_coverage_of_the_line(years, make, lowest):
    """95 % intervals; for a wobble that is kicked some 90 %, as the rate is not linear in so much walking."""
    look = lambda series: within(fit_chandler(*series).estimate.interval()[0], PERIOD)  # noqa: E731
    got = covered(300, lambda r: make(r, years), look)
    assert lowest < got < 0.995


@pytest.mark.sweep
def test_coverage_of_the_amplitude():
    look = lambda s: within(fit_chandler(*s).estimate.interval()[1], AMPLITUDE)  # noqa: E731
    assert 0.91 < covered(300, lambda r: lines(r, 20), look) < 0.995


@pytest.mark.sweep
@pytest.mark.parametrize("quality", [50.0, 100.0])
def test_coverage_of_the_process(quality):
    def look(series):
        found = fit_chandler_process(*series)
        return [within(found.period_intervals[level], PERIOD) for level in (0.6827, 0.95)] + [
            within(found.quality_intervals[level], quality) for level in (0.6827, 0.95)]  # fmt: skip

    got = covered(90, lambda r: kicked(r, 64, quality), look)
    assert (np.abs(got[[0, 2]] - 0.6827) < 0.12).all() and (np.abs(got[[1, 3]] - 0.95) < 0.06).all()


@pytest.mark.sweep
def test_coverage_of_windows():
    """Windows apart from each other, of the same line in red noise."""
    def look(series):
        found = fit_chandler_windows(*series, period=PERIOD)
        apart = slice(None, None, 24)
        return np.mean(np.abs(found.amplitude[apart] - AMPLITUDE) < 1.96 * found.amplitude_error[apart])

    assert 0.88 < covered(300, lambda r: lines(r, 25), look) < 0.99
