"""How long to a flat spin, against closed forms, quadrature without elliptic functions, and integrated motions."""

import itertools
import math

import diffrax
import mpmath
import numpy as np
import pytest
from scipy.integrate import quad

import polhode as ph
from polhode.errors import InvalidInput
from polhode.spacecraft import damped_axis_stability, flat_spin_time, sink_rate_by_loss, sink_rate_by_time
from polhode.spacecraft.damped_body.energy_sink import _mean_products
from polhode.systems import DoubleBracket
from sweeping import first

FIVE = math.radians(5.0)
LONG, SHORT = np.array([1.0, 0.05, 0.02]), np.array([0.3, 1.0, 0.4])


@pytest.mark.parametrize("tilt", [1e-6, 0.1, 1.0])
def test_symmetric_bodies_have_closed_forms(tilt):
    """The tangent of the angle from the axis of symmetry changes as exp(α|L|²(1/I1 − 1/I3) t)."""
    L = 2.0 * np.array([math.cos(tilt), 0.0, math.sin(tilt)])
    prolate = math.log(math.tan(0.5 * math.pi - FIVE) / math.tan(tilt)) / (0.01 * 4.0 * (1.0 - 0.5))
    assert flat_spin_time((1.0, 2.0, 2.0), L, 0.01) == pytest.approx(prolate, rel=1e-9)
    oblate = math.log(1.0 / math.tan(tilt) / math.tan(FIVE)) / (0.01 * 4.0 * (1.0 - 0.5))
    assert flat_spin_time((1.0, 1.0, 2.0), L, 0.01) == pytest.approx(oblate, rel=1e-9)


@pytest.mark.long_cases("L0", "L1")
@pytest.mark.parametrize("L", [LONG, SHORT, np.array([0.2, 0.9, 0.6])])
def test_it_is_the_integral_over_the_energy(L):
    """∫ dE/(α⟨|L × Ω|²⟩), the means by quadrature over the angle φ about the encircled axis, dt = dφ/φ̇."""
    I, norm2 = np.array([1.0, 2.0, 3.0]), float(L @ L)  # noqa: E741
    saddle, start = 0.5 * norm2 / I[1], 0.5 * float(L @ (L / I))
    end = 0.5 * norm2 * (math.sin(FIVE) ** 2 / I[1] + math.cos(FIVE) ** 2 / I[2])

    def mean(E):
        x, y, z = (1, 2, 0) if saddle < E else (0, 1, 2)

        def at(phi):
            across = math.cos(phi) ** 2 * (1 / I[x] - 1 / I[z]) + math.sin(phi) ** 2 * (1 / I[y] - 1 / I[z])
            r2 = (2.0 * E - norm2 / I[z]) / across
            squares = {x: r2 * math.cos(phi) ** 2, y: r2 * math.sin(phi) ** 2, z: norm2 - r2}
            loss = sum((1 / I[i] - 1 / I[j]) ** 2 * squares[i] * squares[j] for i, j in ((0, 1), (0, 2), (1, 2)))
            rate = math.sqrt(squares[z]) * abs(across)  # φ̇
            return loss / rate, 1.0 / rate

        lost, time = (quad(lambda phi, k=k: at(phi)[k], 0.0, 0.5 * math.pi, limit=200)[0] for k in (0, 1))
        return lost / time

    borders = [end, saddle, start] if start > saddle else [end, start]
    parts = [quad(lambda E: 1.0 / mean(E), *ends, epsrel=1e-7, limit=100)[0] for ends in itertools.pairwise(borders)]
    assert flat_spin_time(I, L, 0.01) == pytest.approx(sum(parts) / 0.01, rel=2e-6)


@pytest.mark.parametrize("m", [1e-12, 0.05, 0.0999, 0.1001, 0.7, 0.999, 1.0 - 2.0**-30])
def test_means_of_products_of_jacobi_functions(m):
    """Against quadrature over the amplitude at 30 digits; the closed forms and the series meet at 0.1."""
    with mpmath.workdps(30):
        ends = [0, 0.8, 1.5, 1.57, mpmath.pi / 2]
        slope = lambda x: mpmath.sqrt(1 - mpmath.mpf(m) * mpmath.sin(x) ** 2)  # noqa: E731
        turn = mpmath.quad(lambda x: 1 / slope(x), ends)
        cs = mpmath.quad(lambda x: (mpmath.sin(x) * mpmath.cos(x)) ** 2 / slope(x), ends) / turn
        sd = mpmath.quad(lambda x: mpmath.sin(x) ** 2 * slope(x), ends) / turn
        cd = mpmath.quad(lambda x: mpmath.cos(x) ** 2 * slope(x), ends) / turn
    found = _mean_products(np.array([m]), np.array([1.0 - m]))
    assert [float(each[0]) for each in found] == pytest.approx([float(cs), float(sd), float(cd)], rel=2e-14)


@pytest.mark.long
@pytest.mark.parametrize("L", first(1, [LONG, SHORT, np.array([1.0, 1e-3, 2e-3])]))
def test_motions_with_weak_losses_take_that_long(L):
    rate, body = 1e-3, (1.0, 2.0, 3.0)
    expected = flat_spin_time(body, L, rate)
    times = np.linspace(0.0, 1.1 * expected, 30001)
    states = ph.simulate(DoubleBracket(body, rate), L, times, diffrax.Dopri8(), estimate_error=False).states
    angle = np.arctan2(np.hypot(states[:, 0], states[:, 1]), np.abs(states[:, 2]))
    assert times[np.flatnonzero(angle > FIVE).max()] == pytest.approx(expected, rel=2e-3)


def test_where_losses_lead_nowhere():
    assert flat_spin_time((1.0, 2.0, 3.0), (0.0, 0.01, 1.0), 0.1) == 0.0
    for L in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)):
        assert flat_spin_time((1.0, 2.0, 3.0), L, 0.1) is None
    assert flat_spin_time((2.0, 2.0, 2.0), (1.0, 1.0, 0.0), 0.1) is None


def test_the_strength_follows_from_the_power_and_takes_it():
    rate = sink_rate_by_loss((1.0, 2.0, 3.0), LONG, 1e-6)
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=LONG)
    times = np.linspace(0.0, motion.period, 20001)
    L = motion.momentum(times)
    loss = rate * np.sum(np.cross(L, L / np.array([1.0, 2.0, 3.0])) ** 2, axis=-1)
    assert np.trapezoid(loss, times) / motion.period == pytest.approx(1e-6, rel=1e-8)
    with pytest.raises(InvalidInput, match="nothing is lost"):
        sink_rate_by_loss((1.0, 2.0, 3.0), (1.0, 0.0, 0.0), 1e-6)


@pytest.mark.parametrize("body", [(1.0, 2.0, 3.0), (1.0, 2.9, 3.0), (1.0, 3.0, 3.0), (1.0, 1.0, 3.0)])
@pytest.mark.parametrize("time", [1e4, 300.0, 0.3])
def test_the_strength_follows_from_the_damping_time(body, time):
    rate = sink_rate_by_time(body, 0.5, time)
    found = damped_axis_stability(DoubleBracket(body, rate), 0.5)[2]
    assert -1.0 / found.rate == pytest.approx(time, rel=1e-6)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: flat_spin_time((2.0, 1.0, 3.0), LONG, 0.1), "ascending"),
        (lambda: flat_spin_time((1.0, 2.0, 3.0), LONG, -0.1), "`rate`"),
        (lambda: flat_spin_time((1.0, 2.0, 3.0), (1.0, np.nan, 0.0), 0.1), "`momentum`"),
        (lambda: flat_spin_time((1.0, 2.0, 3.0), LONG, 0.1, 2.0), "`angle`"),
        (lambda: sink_rate_by_time((2.0, 2.0, 2.0), 1.0, 5.0), "sphere"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
