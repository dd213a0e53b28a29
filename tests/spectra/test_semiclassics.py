"""Levels as quantised polhodes: their classical numbers against other formulas, their errors as published here."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

import polhode as ph
from polhode.errors import InvalidInput
from polhode.spectra import (
    Rotor,
    doublet_splitting,
    semiclassical_levels,
    semiclassical_pairs,
    semiclassics,
    spin_matrices,
)
from polhode.spectra._level_polhodes import find_above, level_polhodes
from polhode.spectra._orbits import orbit
from polhode.spectra.semiclassics import quantise, without_casimir

W = (27.0, 14.0, 9.0)
# J: rms error and largest of order 1, then of order 2
ERRORS = {5: (3.95, 4.41, 0.0211, 0.044), 10: (3.95, 4.40, 0.00571, 0.0143), 20: (3.95, 4.42, 0.0017, 0.0050),
          50: (3.95, 4.44, 5.1e-4, 1.8e-3), 100: (3.95, 4.45, 1.3e-4, 4.7e-4)}  # fmt: skip
# exact splittings of W at J = 20 by 60 digits, and by what factor the formula misses them
SPLITTINGS = {(0, 20): (2.36322693245e-7, 1.015), (15, 6): (5.26759218461e-8, 0.9997),
              (20, 1): (9.43761230884e-19, 1.010)}  # fmt: skip


def start(energy, G):
    """A point of the polhode at an energy, L_b = 0."""
    A, _, C = W
    along_c = math.sqrt((A * G * G - energy) / (A - C))
    return math.sqrt(G * G - along_c**2), 0.0, along_c


@pytest.mark.parametrize("energy", [1100.0, 1200.0, 1540.0, 1545.0, 1700.0, 2900.0])
def test_actions_are_areas_and_periods_those_of_the_free_body(energy):
    G = 10.5
    motion = ph.FreeMotion(tuple(0.5 / x for x in W), momentum=start(energy, G))
    result = orbit(W, G, np.array(energy))
    area = motion.solid_angle if energy < W[1] * G * G else 2.0 * math.pi - motion.solid_angle
    assert result.action == pytest.approx(0.5 * G * area, rel=1e-12)
    assert result.period == pytest.approx(motion.period, rel=1e-12)


@pytest.mark.parametrize(("energy", "action", "barrier"), [
    (1200.0, 3.5076875574923904, 6.8345502679306373), (1700.0, 15.969176436820106, -2.8492090762570651)])  # fmt: skip
def test_action_and_barrier_of_w(energy, action, barrier):
    result = orbit(W, 10.5, np.array(energy))
    assert (result.action, result.barrier) == (pytest.approx(action, rel=1e-13), pytest.approx(barrier, rel=1e-13))


@pytest.mark.parametrize("energy", [1200.0, 1700.0])
def test_periods_are_slopes(energy):
    h = 1e-3
    low, high = (orbit(W, 10.5, np.array(energy + step)) for step in (-h, h))
    at = orbit(W, 10.5, np.array(energy))
    assert (high.action - low.action) / (2 * h) == pytest.approx(0.5 * at.period, rel=1e-8)
    assert (high.barrier - low.barrier) / (2 * h) == pytest.approx(-0.5 * at.barrier_period, rel=1e-8)


def test_the_barrier_is_lames_integral():
    """θ by quadrature of |L_c| over the forbidden angle, which knows nothing of zeta functions."""
    A, B, C = W
    G, energy = 10.5, 1200.0

    def momentum(angle):
        # L_c of angle χ between the axes a and b, where it is imaginary: E = (A cos² + B sin²)(G² − L_c²) + C L_c²
        across = A * math.cos(angle) ** 2 + B * math.sin(angle) ** 2
        return (energy - across * G * G) / (C - across)

    # at χ = π/2 the rest is (E − BG²)/(C − B) > 0: allowed; the forbidden region stands about a in the other chart
    along_a = lambda x: (energy - (B * math.cos(x) ** 2 + C * math.sin(x) ** 2) * G * G) / (  # noqa: E731
        A - (B * math.cos(x) ** 2 + C * math.sin(x) ** 2))  # fmt: skip
    edge = math.acos(math.sqrt((energy - C * G * G) / ((B - C) * G * G)))
    result = 2.0 * quad(lambda x: math.sqrt(max(-along_a(x), 0.0)), 0.0, edge, epsabs=1e-12)[0]
    assert momentum(math.pi / 2) > 0.0
    assert orbit(W, G, np.array(energy)).barrier == pytest.approx(result, rel=1e-9)


@pytest.mark.parametrize("J", [pytest.param(J, marks=[pytest.mark.sweep] if J in (50, 100) else []) for J in ERRORS])
def test_errors_of_levels(J):
    exact = Rotor(W).levels_of(J)
    for order in (1, 2):
        result = semiclassical_levels(W, J, order)
        off = result.energy - exact.energy
        rms, largest = ERRORS[J][2 * order - 2 : 2 * order]
        assert np.sqrt(np.mean(off**2)) < rms and np.abs(off).max() < largest
        assert (result.Ka.tolist(), result.Kc.tolist()) == (exact.Ka.tolist(), exact.Kc.tolist())


def test_levels_at_the_bottom_the_saddle_and_the_top():
    """Order 1 as computed at 30 digits; order 2 as near to the exact levels as it is without what all levels share."""
    first, second = (semiclassical_levels(W, 10, order) for order in (1, 2))
    for label, one, exact, bound in (((0, 10), 1088.1203818815, 1083.7274225953, 0.0075),
                                     ((4, 7), 1548.7004917558, 1544.5797661999, 0.003),
                                     ((10, 0), 2820.5684537284, 2817.1422643477, 0.0003)):  # fmt: skip
        k = np.flatnonzero((first.Ka == label[0]) & (first.Kc == label[1]))[0]
        assert first.energy[k] == pytest.approx(one, abs=1e-9)
        assert second.energy[k] == pytest.approx(exact, abs=bound)


@pytest.mark.long
def test_what_all_levels_share_is_exact():
    """A nearly spherical rotor: errors of 6, a quarter of a constant, before d J(J + 1) was taken out."""
    constants, J = (24.308, 23.885, 23.715), 58
    exact = Rotor(constants).levels_of(J).energy
    assert np.abs(semiclassical_levels(constants, J).energy - exact).max() < 3e-5
    assert 5.9 < np.abs(semiclassical_levels(constants, J, 1).energy - exact).max() < 6.1  # an eighth of A + B
    near = [(10.0 + 2.0 * size, 10.0 + size, 10.0) for size in (1e-2, 1e-6, 1e-10)]
    for constants in near:  # and as near to a sphere as doubles go
        exact = Rotor(without_casimir(constants)[0]).levels_of(10).energy
        result, _, _ = quantise(without_casimir(constants)[0], 10, 2)
        assert np.abs(result - exact).max() < 1e-3 * (constants[0] - constants[2])


@pytest.mark.parametrize("off", [1e-5, 1e-8])
@pytest.mark.parametrize(("A", "B", "C"), [(30.0, 10.0, 10.0), (10.0, 10.0, 5.0)])
def test_nearly_symmetric_rotors_have_levels_and_a_warning(A, B, C, off):
    """These ended in "y must not be negative in Carlson's integrals" for (B − C)/B of 1e-5 and less."""
    constants = (A, B * (1.0 + off), C) if B == C else (A * (1.0 + off), B, C)
    with pytest.warns(UserWarning, match="so nearly symmetric"):
        result = semiclassical_levels(constants, 10)
    off = np.abs(result.energy - Rotor(constants).levels_of(10).energy).max()
    assert off < 0.25 * (A - C) and np.isfinite(result.period).all()


@pytest.mark.parametrize("J", [10, 11])
def test_a_level_at_the_very_saddle(J):
    """κ = 0: the middle level of an even J lies at the saddle, by symmetry."""
    result = semiclassical_levels((3.0, 2.0, 1.0), J)
    assert np.abs(result.energy - Rotor((3.0, 2.0, 1.0)).levels_of(J).energy).max() < 2e-3
    assert result.energy[J] == pytest.approx(2.0 * J * (J + 1), abs=1e-3) and np.isfinite(result.period).all()


def test_neighbouring_levels_are_an_orbits_frequency_apart():
    exact, result = Rotor(W).levels_of(100), semiclassical_levels(W, 100)
    for low, bound in ((52, 3e-4), (95, 1e-4)):
        gap = exact.of(100, low + 1, 100 - low) - exact.of(100, low, 101 - low)
        middle = 0.5 * (exact.of(100, low + 1, 100 - low) + exact.of(100, low, 101 - low))
        assert gap == pytest.approx(2.0 * math.pi / orbit(W, 100.5, np.array(middle)).period, rel=bound)
    assert np.all(result.period > 0.0)


def test_splittings_of_doublets():
    levels = Rotor(W).levels_of(20)
    for (Ka, Kc), (exact, ratio) in SPLITTINGS.items():
        assert doublet_splitting(W, 20, levels.of(20, Ka, Kc)) / exact == pytest.approx(ratio, abs=2e-3)


@pytest.mark.parametrize("s", [9.5, 20.5])
def test_kramers_pairs(s):
    x, y, z = spin_matrices(s)
    exact = np.linalg.eigvalsh(27.0 * x @ x + 14.0 * y @ y + 9.0 * z @ z)[::2]
    assert np.abs(semiclassical_pairs(W, s) - exact).max() < 0.05
    assert 4.0 < np.abs(semiclassical_pairs(W, s, 1) - exact).max() < 4.5


def test_without_the_barrier_levels_at_the_saddle_are_missed(monkeypatch):
    monkeypatch.setattr("polhode.spectra.semiclassics._gamma_phase", lambda epsilon: 0.0 * epsilon)
    off = semiclassical_levels(W, 10, 1).energy - Rotor(W).levels_of(10).energy
    assert np.abs(off).max() > 6.0


@pytest.mark.sweep
def test_random_rotors():
    """Exactly 2J + 1 levels each, off by an eighth of two constants, and at second order by less where it holds."""
    rng = np.random.default_rng(7)
    for _ in range(100):  # a thousand were within the same bounds
        B, C = np.sort(rng.uniform(0.2, 0.97, 2))[::-1]
        constants, J = (1.0, B, min(C, 0.97 * B)), int(rng.integers(5, 61))
        exact = Rotor(constants).levels_of(J).energy
        room = min(1.0 - B, B - constants[2]) * (J + 0.5) ** 2
        for order, bound in ((1, 0.125 * (1.0 + B)), (2, 0.1 / J if room > 10.0 else 0.125 * (1.0 + B))):
            result = semiclassical_levels(constants, J, order).energy
            assert len(result) == 2 * J + 1
            assert np.abs(result - exact).max() < bound, (constants, J, order)


@pytest.mark.parametrize(
    ("call", "said"),
    [(lambda: semiclassical_levels((27.0, 14.0, 14.0), 10), "three different ones"),
     (lambda: semiclassical_levels(W, 3), "`order`"), (lambda: semiclassical_levels(W, 10, 3), "`order`"),
     (lambda: semiclassical_pairs(W, 10.0), "half an odd"), (lambda: doublet_splitting(W, 10, 5000.0), "`energy`")],
)  # fmt: skip
def test_what_is_refused(call, said):
    with pytest.raises(InvalidInput, match=said):
        call()


@pytest.mark.long_after(1)
@pytest.mark.parametrize("constants", [W, (27.0, 26.9999, 9.0), (27.0, 9.000001, 9.0), (8.35e11, 4.35e11, 2.78e11)])
def test_levels_of_many_J_are_above_the_saddle_as_those_of_each(constants):
    """Near the symmetric tops too, where order 2 has no room and some levels have order 1."""
    each = [found.above for J in range(1, 9) if (found := level_polhodes(constants, J)) is not None]
    searches, original = [], semiclassics.elementwise.find_root
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(semiclassics.elementwise, "find_root", lambda *given, **more: searches.append(1) or original(
            *given, **more))  # fmt: skip
        many = find_above(constants, 8)
    assert many is not None and np.array_equal(many, np.concatenate(each))
    assert len(searches) == 3  # order 1 of the lowest J, orders 1 and 2 of all others


@pytest.mark.parametrize("constants", [(27.0, 9.0, 9.0), (27.0, 27.0, 9.0), (math.inf, 9.0, 9.0)])
def test_symmetric_and_linear_molecules_have_no_saddle(constants):
    assert find_above(constants, 3) is None
