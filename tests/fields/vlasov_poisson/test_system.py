"""The plasma of particles against linear theory, direct sums, and published numbers."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad

import polhode as ph
from polhode.errors import InvalidInput, NotConverged
from polhode.fields import VlasovPoisson, quiet_start
from polhode.fields.vlasov_poisson.waves import (
    MAXWELLIAN,
    Beam,
    bump_on_tail,
    dispersion,
    plasma_wave,
    two_stream,
    velocity_distribution,
)
from polhode.integrators import Splitting
from polhode.testing import LawBroken, check_system
from sweeping import first

TABLE = {
    0.3: (1.159846481, -0.01262036842, 2.547135463, 0.1142673995),
    0.4: (1.285056970, -0.06612795869, 1.799136538, 0.3357725239),
    0.5: (1.415661889, -0.15335946691, 1.470807161, 0.5362450261),
}
RNG = np.random.default_rng(6)


def maxwellian(v):
    return velocity_distribution(MAXWELLIAN, v)


def first_field(system, state, times, step, order=2):
    """Return the amplitude of the longest wave of the field, with its sign, of motions that stay even in x."""
    motion = ph.solve(system, state, times, Splitting, step=step, order=order).saved
    return 2.0 * np.asarray(system.density_modes(motion))[:, 0, 0] / float(system.wavenumber), motion


def test_field_is_that_of_a_sum_over_pairs():
    system = VlasovPoisson(3.0, 4, 5)
    x, weights = RNG.uniform(0.0, 3.0, 5), RNG.uniform(0.5, 2.0, 5)
    force = np.zeros(5)
    for p in range(5):
        for q in range(5):
            for j in range(1, 5):
                wave = 2.0 * np.pi * j / 3.0
                force[p] += 2.0 / 3.0 * weights[q] * np.sin(wave * (x[p] - x[q])) / wave
    result = system.vector_field(0.0, system.pack(x, np.ones(5), weights))
    np.testing.assert_allclose(result[:, 0], force, atol=1e-14)
    np.testing.assert_allclose(result[:, 1], 1.0, atol=1e-15)


@pytest.mark.parametrize("k", TABLE)
def test_landau_roots_and_amplitudes(k):
    wave = plasma_wave(MAXWELLIAN, k)
    np.testing.assert_allclose((wave.frequency, wave.growth, wave.response, wave.phase), TABLE[k], rtol=5e-10)


@pytest.mark.parametrize("beams", [MAXWELLIAN, two_stream(2.4), bump_on_tail(0.1, 4.0, 0.5)])
def test_dispersion_against_its_integral(beams):
    k, omega = 0.4, 0.7 + 0.3j

    def integrand(v):  # −f₀'(v)/(v − ω/k), by a difference of fourth order
        f = lambda x: float(velocity_distribution(beams, np.array(x)))  # noqa: E731
        h = 1e-3
        slope = (8.0 * (f(v + h) - f(v - h)) - f(v + 2.0 * h) + f(v - 2.0 * h)) / (12.0 * h)
        return -slope / (v - omega / k)

    parts = [quad(lambda v, p=p: getattr(integrand(v), p), -15.0, 15.0, limit=300, epsabs=1e-10)[0]
             for p in ("real", "imag")]  # fmt: skip
    assert abs(dispersion(beams, k, omega) - (1.0 + complex(*parts) / k**2)) < 1e-8


def test_two_streams_grow_as_published():
    wave = plasma_wave(two_stream(2.4), 0.2, 0.2j)
    assert abs(wave.growth - 0.2258442550) < 1e-9
    assert abs(wave.frequency) < 1e-12


@pytest.mark.long
def test_a_quiet_start_has_the_density_asked_for():
    system = VlasovPoisson(4.0 * np.pi, 3, 8 * 64)
    for mode in (1, 2):
        state = quiet_start(system, maxwellian, 8, 0.3, mode)
        wanted = np.zeros((3, 2))
        wanted[mode - 1, 0] = 0.15
        np.testing.assert_allclose(system.density_modes(state), wanted, atol=1e-12)
        assert abs(float(jnp.sum(1.0 / state[:, 2])) / (4.0 * np.pi) - 1.0) < 1e-14


@pytest.mark.sweep
def test_landau_damping_follows_its_curve():
    system, wave, times = VlasovPoisson(4.0 * np.pi, 1, 1024), plasma_wave(MAXWELLIAN, 0.5), np.linspace(0, 25, 251)
    field, motion = first_field(system, quiet_start(system, maxwellian, 64, 0.01), times, 0.1)
    curve = 0.01 * wave.response * np.exp(wave.growth * times) * np.cos(wave.frequency * times - wave.phase)
    late = times > 6.0
    assert np.abs(field - curve)[late].max() < 0.005 * 0.01 * wave.response
    momentum = np.asarray(system.invariants(motion)["momentum Σwv"])
    assert np.abs(momentum - momentum[0]).max() < 1e-14
    assert np.ptp(np.asarray(system.energy(motion))) < 1e-5


@pytest.mark.long
@pytest.mark.parametrize(("order", "steps"), [(2, (0.1, 0.05)), (4, (0.2, 0.1))])
def test_orders(order, steps):
    system = VlasovPoisson(4.0 * np.pi, 2, 64)
    start = quiet_start(system, maxwellian, 8, 0.5)
    ends = [first_field(system, start, (0.0, 8.0), h, order)[1][-1] for h in (*steps, 0.02)]
    errors = [float(jnp.abs(end - ends[2])[:, :2].max()) for end in ends[:2]]
    # the finest step's own error is a known share of the others'
    expected = np.log2((steps[0] ** order - 0.02**order) / (steps[1] ** order - 0.02**order))
    assert abs(np.log2(errors[0] / errors[1]) - expected) < 0.15


@pytest.mark.sweep
@pytest.mark.parametrize(("k", "accuracy"), [(0.5, 0.003), (0.4, 0.005), (0.3, 0.01)])
def test_damping_rates(k, accuracy):
    wave, system = plasma_wave(MAXWELLIAN, k), VlasovPoisson(2.0 * np.pi / k, 3, 1024)
    times = np.arange(0.0, 0.9 * 2.0 * np.pi / k / (12.0 / 64.0) * 0.5, 0.05)
    field, _ = first_field(system, quiet_start(system, maxwellian, 64, 0.001), times, 0.05)
    rotated = np.abs(field)
    peaks = [n for n in range(1, len(times) - 1) if rotated[n - 1] < rotated[n] >= rotated[n + 1] and times[n] > 8.0]
    rate = np.polyfit(times[peaks], np.log(rotated[peaks]), 1)[0]
    assert abs(rate / wave.growth - 1.0) < accuracy


@pytest.mark.sweep
@pytest.mark.parametrize(
    ("distribution", "k", "growth", "accuracy"),
    [(lambda v: velocity_distribution(two_stream(2.4), v), 0.2, 0.2258442550, 0.004),
     (lambda v: v**2 * maxwellian(v), 0.5, 0.2592499317, 0.001)],
)  # fmt: skip
def test_growth_of_streams(distribution, k, growth, accuracy):
    system, times = VlasovPoisson(2.0 * np.pi / k, 3, 2048), np.linspace(0.0, 40.0, 161)
    state = quiet_start(system, distribution, 128, 1e-6, fastest=8.0)
    field, _ = first_field(system, state, times, 0.05)
    late = times > 25.0
    assert abs(np.polyfit(times[late], np.log(np.abs(field[late])), 1)[0] / growth - 1.0) < accuracy


@pytest.mark.sweep
def test_strong_damping_peaks_as_published():
    system, times = VlasovPoisson(4.0 * np.pi, 8, 128 * 64), np.arange(0.0, 5.5, 0.05)
    motion = first_field(system, quiet_start(system, maxwellian, 128, 0.5), times, 0.05)[1]
    amplitudes = np.asarray(system.field_amplitudes(motion))[:, 0]
    peaks = [n for n in range(1, len(times) - 1) if amplitudes[n - 1] < amplitudes[n] >= amplitudes[n + 1]]
    np.testing.assert_allclose(times[peaks], [2.45, 4.55], atol=0.06)
    np.testing.assert_allclose(np.log(amplitudes[peaks]), [-0.813, -1.425], atol=0.02)


@pytest.mark.sweep
def test_a_strong_wave_decays_grows_and_leaves_a_plateau():
    """Cheng & Knorr, J. Comput. Phys. 22 (1976) 330: −0.281 and 0.084; others have −0.29 for the first."""
    system, times = VlasovPoisson(4.0 * np.pi, 4, 128 * 64), np.arange(0.0, 60.05, 0.1)
    motion = first_field(system, quiet_start(system, maxwellian, 128, 0.5, fastest=7.0), times, 0.1)[1]
    field = np.asarray(system.field_amplitudes(motion))[:, 0]
    peaks = np.flatnonzero((field[1:-1] > field[:-2]) & (field[1:-1] > field[2:])) + 1
    rising = peaks[(times[peaks] > 20.0) & (times[peaks] < 40.0)]
    decay, growth = (np.polyfit(times[i], np.log(field[i]), 1)[0] for i in (peaks[:2], rising))
    assert decay == pytest.approx(-0.281, abs=0.015) and growth == pytest.approx(0.084, abs=0.006)
    states = np.asarray(motion)[400:]
    near, far = (np.mean(1.0 / states[..., 2] * (np.abs(np.abs(states[..., 0]) - v) < 0.15)) for v in (2.5, 3.2))
    assert near / far < 2.0 < 5.0 < np.exp(0.5 * (3.2**2 - 2.5**2))


class Attracted(VlasovPoisson):
    def velocity(self, point):
        return super().velocity(point) * jnp.array([1.0, -1.0, 1.0])


class SlowDrift(VlasovPoisson):
    def _drift(self, time, state):
        return super()._drift(0.999 * time, state)


@pytest.mark.sweep
@pytest.mark.parametrize(("broken", "law"), first(1, [(Attracted, "velocity"), (SlowDrift, "add up")]))
def test_broken_plasmas_are_caught(broken, law):
    with pytest.raises(LawBroken, match=law):
        check_system(broken(5.0, 2, 3))


def test_bad_input():
    system = VlasovPoisson(1.0, 1, 8)
    for call, word in [
        (lambda: VlasovPoisson(-1.0, 1, 8), "length"), (lambda: VlasovPoisson(1.0, 0, 8), "modes"),
        (lambda: VlasovPoisson(1.0, 1, 0), "particles"), (lambda: quiet_start(system, maxwellian, 3, 0.1), "beams"),
        (lambda: quiet_start(system, maxwellian, 4, 1.0), "amplitude"),
        (lambda: quiet_start(system, lambda v: -v, 4, 0.1), "distribution"),
        (lambda: system.check_state(np.zeros((8, 3))), "1/w"),
        (lambda: plasma_wave(MAXWELLIAN, -0.5), "wavenumber"), (lambda: plasma_wave((Beam(0.5),), 0.5), "shares"),
    ]:  # fmt: skip
        with pytest.raises(InvalidInput, match=word):
            call()
    with pytest.raises(NotConverged, match="guess"):
        plasma_wave(MAXWELLIAN, 0.5, complex(np.nan))
