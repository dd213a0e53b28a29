"""Swings of another model than the one fitted have no errors; the same swings fitted by their own model have them."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from polhode.errors import InvalidInput
from polhode.measuring import Filaments, Measured, Pivot, Swing, filament_period, fit_pendulum

G = 9.80665
MASS, MOMENT, FAR = 1.2, 0.02, 0.3  # kg, kg m² about the centre of mass, m to the pivot
CENTRE = 0.45  # m, of the body on the scale of the pivots
AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1), (1, 1, 1))
J = np.array([[0.030, 0.002, -0.001], [0.002, 0.035, 0.003], [-0.001, 0.003, 0.050]])
TIMED = 1e-4  # s, errors of the periods


def measured(rng, period):
    return Measured(period + TIMED * rng.normal(), TIMED)


def swung(amplitude):
    """Period of a compound pendulum by SciPy, θ″ = −mgd sin θ/(I + md²)."""
    stiffness = MASS * G * FAR / (MOMENT + MASS * FAR**2)
    bottom = lambda t, state: state[0]  # noqa: E731
    bottom.terminal = True
    found = solve_ivp(lambda t, state: (state[1], -stiffness * np.sin(state[0])), (0.0, 9.0), (amplitude, 0.0),
                      events=bottom, rtol=1e-11, atol=1e-12)  # fmt: skip
    return 4.0 * found.t_events[0][0]


@pytest.mark.parametrize("told", [True, False], ids=["amplitudes", "none"])
def test_large_swings_taken_for_small_ones(told):
    rng, rig = np.random.default_rng(1), Pivot(Measured(FAR, 1e-4))
    swings = [Swing((0, 0, 1), rig, measured(rng, swung(angle)), angle if told else 0.0) for angle in (0.1, 0.6, 1.0)]
    fit = fit_pendulum(swings, Measured(MASS, 1e-4))
    assert fit.freedom == 2 and np.isfinite(fit.combined.standard_error[0]) == told == fit.test.is_noise
    assert (abs(fit.combined.value[0] - MOMENT) < 4 * fit.combined.standard_error[0]) == told
    assert np.isfinite(fit.moments.standard_error).all()  # those of single swings are of their own measurement


@pytest.mark.parametrize("stretched", [1.0, 1.01])
def test_a_filament_that_stretched_in_one_swing(stretched):
    """Seven axes, of which the tensor needs six; the last hung 1 % lower than it was measured."""
    rng, swings = np.random.default_rng(2), []
    rig = Filaments(Measured(1.5, 1e-4), Measured(0.2, 1e-5), Measured(0.2, 1e-5))
    for k, axis in enumerate(AXES):
        unit = np.array(axis) / np.linalg.norm(axis)
        length = 1.5 * (stretched if k == 6 else 1.0)
        period = filament_period(float(unit @ J @ unit), MASS, length, 0.2, 0.2, 0.1)
        swings.append(Swing(axis, rig, measured(rng, period), 0.1))
    fit = fit_pendulum(swings, Measured(MASS, 1e-4))
    right = stretched == 1.0
    assert fit.freedom == 1 and fit.test.is_noise == right
    for one in (fit.combined, fit.inertia, fit.principal):
        assert one is not None and np.isfinite(one.standard_error).all() == right
    off = np.abs(fit.principal.value - np.linalg.eigvalsh(J)) / fit.principal.standard_error
    assert (off < 4).all() == right


def on_edge(blunt):
    """Six pivots on a scale, each an edge of radius r on which the body rolls: (I + m(d − r)²) θ″ = −mgd θ."""
    rng, swings = np.random.default_rng(3), []
    for place in (0.02, 0.1, 0.2, 0.3, 0.72, 0.8):
        d = abs(CENTRE - place)
        period = 2 * np.pi * np.sqrt((MOMENT + MASS * (d - blunt) ** 2) / (MASS * G * d))
        swings.append(Swing((0, 0, 1), Pivot(None, place), measured(rng, period)))
    return fit_pendulum(swings, Measured(MASS))


def test_a_blunt_edge_gives_no_centre_of_mass():
    sharp = on_edge(0.0)
    assert sharp.freedom == 4 and sharp.test.is_noise
    assert abs(sharp.center.value[0] - CENTRE) < 4 * sharp.center.standard_error[0] < 1e-3
    with pytest.raises(InvalidInput, match="fit no place of the centre of mass"):
        on_edge(4e-4)
