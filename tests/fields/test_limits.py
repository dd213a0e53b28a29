"""Thresholds of fields: the two sides of each that decides a verdict, a refusal or a method."""

import jax.numpy as jnp
import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.fields import (
    MAXWELLIAN,
    Lattice,
    PlasmaWave,
    SphereFluid,
    SphereVortices,
    SpinLattice,
    Toda,
    exchange_matrix,
    fit_growth,
    plasma_wave,
    spin_waves,
    structure_factor,
    vortex_turn,
)
from polhode.fields.point_vortices import answers, equilibria
from polhode.fields.point_vortices import system as vortices
from polhode.fields.sphere import fluid
from polhode.fields.sphere_mhd import answers as magnetic_answers
from polhode.fields.spin_lattice import correlations, lattice, wave_theory
from polhode.fields.spin_lattice import rules as spin_rules
from polhode.fields.spin_lattice import system as spins
from polhode.fields.spin_lattice._bonds import LIMITS as BONDS
from polhode.fields.spin_lattice._bonds import BondType
from polhode.fields.toda import system as toda
from polhode.fields.vlasov_poisson import growth, rules, waves

INSIDE, OUTSIDE = 0.8, 1.25  # of a threshold
CHAIN = Lattice([[1.0]], shape=(4,))
UP = np.array([0.0, 0.0, 1.0])
RING = SphereVortices(np.ones(4))


def bond_of(matrix):
    return BondType(0, 0, (1, 0, 0), tuple(map(tuple, matrix.tolist()))).exchange


def torque_on(angle):
    """Spin waves of a spin beside a field along z; |S × B| is sin angle."""
    alone = SpinLattice(Lattice([[1.0]], shape=(1,)), field=UP)
    return spin_waves(alone, [[np.sin(angle), 0.0, np.cos(angle)]], [0.0])


def easy_axis_across(curvature):
    """Spin waves of a spin along a field of one, with curvature 1 along y, and along an easy axis x as given."""
    onsite = np.diag([0.5 * (1.0 - curvature), 0.0, 0.0])
    return spin_waves(SpinLattice(Lattice([[1.0]], shape=(1,)), onsite=onsite, field=UP), [UP], [0.0])


def sampled(spread):
    times = np.arange(8.0)
    times[3] += 0.5 * spread * np.ptp(times)
    return structure_factor(CHAIN, times, np.broadcast_to(UP, (8, 4, 1, 1, 1, 3)), [[0.0]])


def tilted_ring(off):
    """A ring of equal vortices that turns, one of them shifted along the equator's meridian by ``off``."""
    places = np.array(RING.positions(RING.ring(0.5 * np.pi)))
    places[0] += (0.0, 0.0, off)
    return vortex_turn(RING, RING.pack(places))


ONSITE = np.diag([0.0, 0.0, 1.0])
SKEW = np.zeros((3, 3))
SKEW[0, 2] = 1.0
REFUSALS = {
    "a state off its orbit": (
        lambda share: RING.check_state(RING.ring(1.0) * (1.0 + share * vortices.LIMITS.max_orbit_error))
    ),
    "vectors near a plane": (
        # the least singular value is d/√2 of rows (1, 0) and (1, d)
        lambda share: Lattice([[1.0, 0.0], [1.0, 2.0**0.5 * lattice.LIMITS.min_relative_extent / share]], shape=(1, 1))
    ),
    "matrices that are not symmetric": (
        lambda share: SpinLattice(CHAIN, onsite=ONSITE + share * spins.LIMITS.max_asymmetry * SKEW)
    ),
    "a state that moves": lambda share: torque_on(share * wave_theory.LIMITS.max_torque),
    "a state that is no minimum": (lambda share: easy_axis_across(-share * wave_theory.LIMITS.max_negative_curvature)),
    "uneven times": lambda share: sampled(share * correlations.LIMITS.max_step_spread),
}


@pytest.mark.parametrize("what", REFUSALS)
def test_what_is_refused_beyond_a_threshold(what):
    REFUSALS[what](INSIDE)
    with pytest.raises(InvalidInput):
        REFUSALS[what](OUTSIDE)


def test_vortices_turn_as_a_whole_up_to_a_residual(monkeypatch):
    with pytest.raises(InvalidInput, match="do not turn as a whole") as caught:
        tilted_ring(1e-3)
    residual = float(str(caught.value).split(": ")[1].split()[0])
    for share, turns in ((OUTSIDE, True), (INSIDE, False)):
        monkeypatch.setattr(equilibria, "LIMITS", equilibria.LIMITS._replace(max_other_field=share * residual))
        if turns:
            tilted_ring(1e-3)
        else:
            with pytest.raises(InvalidInput):
                tilted_ring(1e-3)


def test_a_verdict_is_given_up_to_a_number_of_vortices(monkeypatch):
    state = RING.ring(0.9)
    turn = vortex_turn(RING, state)
    for most, judged in ((4, True), (3, False)):
        monkeypatch.setattr(answers, "LIMITS", answers.LIMITS._replace(max_judged_vortices=most))
        assert (answers._judge(RING, state, turn)[0] is not None) == judged


def test_resolutions_that_go_by_series():
    most = fluid.LIMITS.max_series_size
    assert SphereFluid(most).series_of_arrays and not SphereFluid(most + 1).series_of_arrays


def test_exchange_is_plain_up_to_rounding():
    matrix = exchange_matrix(1.0)
    for share, plain in ((INSIDE, True), (OUTSIDE, False)):
        assert (bond_of(matrix + share * BONDS.max_anisotropy * SKEW) is not None) == plain


def test_the_toda_motion_ends_at_an_exponent(monkeypatch):
    chain, state = Toda(2), jnp.array([0.0, 1.0, 0.5])
    spread = float(np.ptp(np.linalg.eigvalsh(chain.matrix(state))))
    monkeypatch.setattr(toda, "LIMITS", toda.LIMITS._replace(max_exponent=10.0))  # where weights do not underflow yet
    before, after = (float(chain.exact(state, share * 10.0 / spread)[2]) for share in (INSIDE, OUTSIDE))
    assert before > 0.0 and after == 0.0


def test_growth_is_fitted_to_enough_values_in_the_linear_time():
    t, limits = np.linspace(0.0, 20.0, 81), growth.LIMITS
    wave, field = PlasmaWave(0.5, 0.0, 0.2, 1.0, 0.0), 1e-6 * np.exp(0.2 * t)
    late = limits.late_share * 20.0  # after the settling time, 5
    assert fit_growth(t, field, 0.5, wave, 20.0).begin == pytest.approx(late, abs=0.25)
    assert fit_growth(t, field, 0.5, wave, 7.0).begin == limits.settling_time
    for count, is_fitted in ((limits.min_values, True), (limits.min_values - 1, False)):
        assert (fit_growth(t, field, 0.5, wave, 5.0 + 0.25 * (count - 0.5)) is not None) == is_fitted
    # √(kE) reaches 0.3 of the growth where k E = 0.0036; the line ends there
    strong = field * (limits.max_bounce_rate * 0.2) ** 2 / 0.5 / field[60]
    assert fit_growth(t, strong, 0.5, wave, 20.0).end == pytest.approx(t[60], abs=0.26)


def test_a_damped_field_ends_in_the_noise():
    t = np.linspace(0.0, 100.0, 401)
    wave = PlasmaWave(0.5, 0.0, -0.2, 1.0, 0.0)
    fit = fit_growth(t, 1e-6 * np.exp(-0.2 * t), 0.5, wave, 100.0)
    assert fit.end == pytest.approx(-np.log(growth.LIMITS.min_damped_field) / 0.2, abs=0.26)


def mistakes_of_shares(error):
    beams = [{"share": 0.5}, {"share": 0.5 + error}]
    return list(rules.find_mistakes({"system": {"beams": beams}}))


def mistakes_of_sizes(count):
    return list(rules.find_mistakes({"system": {"velocities": count, "particles_per_velocity": 1, "modes": 1}}))


def mistakes_of_cells(count):
    return list(spin_rules.find_mistakes({"system": {"vectors": [[1.0]], "cells": [count]}}))


def test_sizes_of_specs():
    share, most = rules.LIMITS.max_share_error, rules.LIMITS.max_particle_modes
    assert not mistakes_of_shares(INSIDE * share) and mistakes_of_shares(OUTSIDE * share)
    assert not mistakes_of_sizes(most) and mistakes_of_sizes(most + 1)
    most = spin_rules.LIMITS.max_spins
    assert not mistakes_of_cells(most) and any("at most" in said for _, said in mistakes_of_cells(most + 1))


@pytest.mark.parametrize("field, value", [("max_steps", 3), ("max_dispersion", 0.0)])
def test_newtons_method_converges_or_not(monkeypatch, field, value):
    assert plasma_wave(MAXWELLIAN, 0.5).growth < 0.0
    monkeypatch.setattr(waves, "LIMITS", waves.LIMITS._replace(**{field: value}))
    with pytest.raises(Exception, match="finds no mode"):
        plasma_wave(MAXWELLIAN, 0.5)


class MagneticRun:
    """What ``is_zonal`` and ``growth`` of a report read: energies by order, at times."""

    def __init__(self, of_waves, times=(0.0, 1.0, 2.0, 3.0, 4.0, 5.0)):
        self.trajectory = type("Run", (), {"times": np.array(times)})
        self.energies_by_order = np.stack([np.ones(len(times)), np.asarray(of_waves, float)], axis=1)


def test_a_flow_is_zonal_up_to_a_share_of_waves():
    limits, judge = magnetic_answers.LIMITS, magnetic_answers.MagneticReport.is_zonal.func
    share = 1.0 - limits.min_zonal_share
    assert judge(MagneticRun(6 * [INSIDE * share])) and not judge(MagneticRun(6 * [OUTSIDE * share]))


def test_waves_grow_while_they_are_small_and_above_rounding():
    limits, growth_of = magnetic_answers.LIMITS, magnetic_answers.MagneticReport.growth
    growing = np.exp(0.2 * np.arange(6.0))
    assert growth_of(MagneticRun(1e-8 * growing), 1) == pytest.approx(0.1)
    assert growth_of(MagneticRun(OUTSIDE * limits.min_wave_share * growing), 1) == pytest.approx(0.1)
    assert growth_of(MagneticRun(INSIDE * limits.min_wave_share * growing), 1) is None
    # two of six values are above the share of linear waves, and the later half of four is too short for a line
    assert growth_of(MagneticRun(limits.max_linear_share * growing / growing[4] * OUTSIDE), 1) is None
    assert growth_of(MagneticRun(limits.max_linear_share * growing / growing[5] * INSIDE), 1) == pytest.approx(0.1)
