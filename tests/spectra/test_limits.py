"""Thresholds of spectra: the two sides of each that decides a verdict, a refusal or a method."""

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.spectra import (
    DEBYE,
    MeasuredLines,
    Racket,
    Rotor,
    fit_rotor,
    fitting,
    line_fit,
    racket,
    rotor,
    semiclassical_levels,
    semiclassics,
    spec_rotors,
    spin,
    spin_matrices,
)
from polhode.spectra import _partition as partition
from polhode.spectra._partition import partition_sum
from polhode.spectra.figures import wigner_figure
from polhode.spectra.formats import spcat
from polhode.spectra.quantum_rotor import answers
from polhode.spectra.rotor import check_j, equal_constants, find_fallen
from polhode.spectra.spec_rotors import Atoms, SpecRotor

INSIDE, OUTSIDE = 0.8, 1.25  # of a threshold
W = (27.0, 14.0, 9.0)
TOP = Rotor((27e9, 14e9, 9e9), dipole=(0.0, DEBYE, 0.0))


def with_limits(monkeypatch, module, **fields):
    monkeypatch.setattr(module, "LIMITS", module.LIMITS._replace(**fields))


def summable(constant=1e10, dipole=1.0, temperature=1.0, j_max=3):
    spec_rotors.check_summable(SpecRotor(Rotor(3 * [constant], dipole=3 * [dipole * DEBYE]), temperature, j_max, ()))


def hottest():
    """The temperature at which a constant of 10 GHz has levels up to the largest J of a sum."""
    return spec_rotors.LIMITS.max_summed_j**2 * 1e10 / (partition.LIMITS.negligible_energy * partition.THERMAL)


LARGEST = spec_rotors.LIMITS.max_constant
REFUSALS = {
    "levels of a large J": lambda share: check_j("J", round(share * rotor.LIMITS.max_j)),
    "a racket's J": lambda share: Racket(W, round(share * racket.LIMITS.max_j)),
    "a Wigner function's J": lambda share: wigner_figure.check_drawable(round(share * wigner_figure.LIMITS.max_j)),
    "an order for small J": (
        lambda share: semiclassical_levels(W, int(semiclassics.LIMITS.min_second_order_j / share), 2)
    ),
    "a dipole": lambda share: summable(dipole=share * LARGEST),
    "populated levels": lambda share: summable(temperature=share**2 * hottest()),
    "lines": lambda share: spec_rotors._check_countable(
        TOP, int(share * (2.0 * spec_rotors.LIMITS.max_lines) ** (1.0 / 3.0))),
}  # fmt: skip


@pytest.mark.parametrize("what", REFUSALS)
def test_what_is_refused_beyond_a_threshold(what):
    REFUSALS[what](INSIDE)
    with pytest.raises(InvalidInput):
        REFUSALS[what](OUTSIDE)


def test_constants_beyond_any_molecule(monkeypatch):
    for most, refused in ((2e10, False), (1e9, True)):
        with_limits(monkeypatch, spec_rotors, max_constant=most)
        if refused:
            with pytest.raises(InvalidInput, match="Check units"):
                summable(dipole=0.0)
        else:
            summable(dipole=0.0)


def test_large_spins(monkeypatch):
    for most, refused in ((3.0, False), (2.5, True)):
        with_limits(monkeypatch, spin, max_spin=most)
        if refused:
            with pytest.raises(InvalidInput, match="at most"):
                spin_matrices(3)
        else:
            spin_matrices(3)


def test_constants_that_are_equal():
    limits = rotor.LIMITS
    for share, equal in ((INSIDE, True), (OUTSIDE, False)):
        near = share * limits.symmetric_difference * 2.0
        assert (equal_constants((3.0, 1.0 + near, 1.0)) == "BC") == equal
        assert (equal_constants((3.0, 3.0 - near, 1.0)) == "AB") == equal
    one = 1.0 + 2.0**-52
    assert equal_constants((1.0 + 200.0 * (one - 1.0), one, 1.0)) == "ABC"  # of ABC by 4e-14
    assert equal_constants((1.0 + 2000.0 * (one - 1.0), 1.0 + 1000.0 * (one - 1.0), 1.0)) == ""


def test_levels_that_fall_below_the_ground_state():
    J, energy = np.array([0, 1, 1]), np.array([0.0, 0.0, 1.0])
    for share, fallen in ((INSIDE, False), (OUTSIDE, True)):
        energy[1] = -share * rotor.LIMITS.min_runaway
        assert find_fallen(J, energy).any() == fallen


def test_a_body_is_linear_below_a_moment(any_type):
    class Body:
        principal_moments = np.ones(3)

    for share, linear in ((INSIDE, True), (OUTSIDE, False)):
        Body.principal_moments = np.array([share * rotor.LIMITS.min_moment, 1.0, 1.0])
        assert Rotor.from_body(Body()).is_linear == linear


def test_a_partition_function_ends_where_levels_no_longer_count():
    most = partition.LIMITS.negligible_energy * partition.THERMAL
    summed = []

    def levels_of(J):
        summed.append(J)
        return np.array([J * most / 4.5]), np.ones(1)

    partition_sum(levels_of, np.array(1.0), 100)
    assert summed[-1] == 5  # the first beyond 4.5


def test_an_atom_is_where_its_symmetry_puts_it():
    for share, symmetric in ((INSIDE, True), (OUTSIDE, False)):
        off = share * spec_rotors.LIMITS.max_displacement
        atoms = Atoms(["H", "H"], np.ones(2), np.array([[1e-10, 0.0, 0.0], [-1e-10, off, 0.0]]))
        assert spec_rotors._has_half_turn(atoms, 2) == symmetric


def test_order_two_warns_without_room(monkeypatch, recwarn):
    room = (14.0 - 9.0) * 10.5**2 / (27.0 - 9.0)
    for share, warned in ((INSIDE, False), (OUTSIDE, True)):
        with_limits(monkeypatch, semiclassics, min_room=share * room)
        recwarn.clear()
        semiclassical_levels(W, 10, 2)
        assert any("no room" in str(each.message) for each in recwarn) == warned


@pytest.mark.parametrize("field", ["interpolated_share", "series_argument"])
def test_levels_depend_little_on_where_formulas_meet(monkeypatch, field):
    exact = Rotor(W).levels_of(20).energy
    for factor in (0.5, 2.0):
        with_limits(monkeypatch, semiclassics, **{field: factor * getattr(semiclassics.LIMITS, field)})
        assert np.abs(semiclassical_levels(W, 20).energy - exact).max() < 1e-2 * (W[0] - W[2])


def measured(wrong=0.0):
    """Lines of a rotor up to J = 4, each second one off by ``wrong`` of its error."""
    lines = TOP.lines(4)
    error = np.full(len(lines.frequency), 1e4)
    off = wrong * error * (-1.0) ** np.arange(len(error))
    return MeasuredLines(lines.upper, lines.lower, lines.frequency + off, error)


def test_a_fit_has_errors_up_to_a_scatter(monkeypatch):
    rms = fit_rotor(TOP, measured(3.0), ["A", "B", "C"]).rms
    for share, determined in ((OUTSIDE, True), (INSIDE, False)):
        with_limits(monkeypatch, fitting, max_scatter=share * rms)
        assert fit_rotor(TOP, measured(3.0), ["A", "B", "C"]).determined == determined


def test_constants_that_are_not_determined(monkeypatch):
    with_limits(monkeypatch, fitting, min_singular_value=1.0)  # the largest itself is not above it
    with pytest.raises(InvalidInput, match="not determined by"):
        fit_rotor(TOP, measured(), ["A", "B", "C"])


def test_constants_that_no_line_depends_on():
    assert fit_rotor(TOP, measured()).names == ("A", "B", "C")
    rounding, terms = fitting.LIMITS.max_rounding, np.ones((1, 1))
    assert fitting._is_rounding(INSIDE * rounding * terms, terms).all()
    assert not fitting._is_rounding(OUTSIDE * rounding * terms, terms).any()


def test_correlated_constants_are_remarked(monkeypatch):
    fit = fit_rotor(TOP, measured(), ["A", "B", "C"])
    largest = np.abs(np.triu(fit.correlation, 1)).max()
    for limit, remarked in ((0.999 * largest, True), (1.001 * largest, False)):
        with_limits(monkeypatch, line_fit, close_correlation=limit)
        assert any("go together" in said for said in line_fit._remarks(fit)) == remarked


def test_words_on_shapes_and_pairs():
    limits = answers.LIMITS
    for kappa, word in ((-0.91, "prolate"), (-0.89, "asymmetric"), (0.89, "asymmetric"), (0.91, "oblate")):
        assert word in answers._shape(kappa)
    assert answers.is_split(INSIDE * limits.max_pair_splitting, 1.0)
    assert not answers.is_split(OUTSIDE * limits.max_pair_splitting, 1.0)


def test_catalogues_hold_what_their_columns_do(monkeypatch):
    lines = TOP.lines(1, 300.0)
    assert len(spcat.catalogue_of(lines).frequency) == 2
    with_limits(monkeypatch, spcat, max_frequency=20e9)  # between both lines
    assert len(spcat.catalogue_of(lines).frequency) == 1
    with_limits(monkeypatch, spcat, min_brightness=0.0)
    assert not len(spcat.catalogue_of(lines).frequency)
    largest = spcat.LIMITS.max_error
    assert spcat.catalogue_of(TOP.lines(1, 300.0), error=2e6 * largest).error.max(initial=0.0) <= largest
