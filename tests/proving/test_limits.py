"""Thresholds of proofs: the two sides of each that decides a refusal or how far a proof gets."""

import numpy as np
import pytest

import polhode as ph
from polhode.algebra import SO3
from polhode.errors import InvalidInput, NotConverged
from polhode.proving.enclosures import _motion_starts, enclosure
from polhode.proving.symbolic import derivation, integrals
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, DerivationBroken, Numerical
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems import FreeRigidBody

sympy = pytest.importorskip("sympy")
INSIDE, OUTSIDE = 0.8, 1.25  # of a threshold
MOMENTS, MOMENTUM = (1.0, 2.0, 3.0), (0.3, 0.2, 1.0)
BODY = FreeRigidBody(MOMENTS)


def with_limits(monkeypatch, module, **fields):
    monkeypatch.setattr(module, "LIMITS", module.LIMITS._replace(**fields))


def test_exact_numbers_are_those_of_the_motion_to_rounding():
    motion = ph.FreeMotion(MOMENTS, momentum=MOMENTUM)
    for share, refused in ((INSIDE, False), (2.0, True)):
        third = 3.0 * (1.0 + share * _motion_starts.LIMITS.max_rounding)
        given = {"moments": ("1", "2", f"{third:.20f}")}
        if refused:
            with pytest.raises(InvalidInput, match="to the last digit"):
                ph.certify(motion, exact=given)
        else:
            ph.certify(motion, exact=given)


def certify(state=MOMENTUM, end=1.0):
    return ph.certify(BODY, state, [0.0, end])


def test_a_proof_takes_no_more_digits_or_terms_than_its_limits(monkeypatch):
    proof = certify()
    for field, value in (("max_bits", proof.bits), ("max_order", proof.order)):
        with_limits(monkeypatch, enclosure, **{field: value})
        assert certify().order == proof.order
        with_limits(monkeypatch, enclosure, **{field: value - 1})
        with pytest.raises(NotConverged, match="would be needed"):
            certify()
        monkeypatch.undo()


def test_digits_and_terms_have_a_least(monkeypatch):
    assert certify().bits == enclosure.LIMITS.min_bits
    with_limits(monkeypatch, enclosure, min_bits=300, tube_order=70)
    proof = certify()
    assert proof.bits == 300 and proof.order == 70
    assert np.abs(proof.states[-1] - ph.FreeMotion(MOMENTS, momentum=MOMENTUM).momentum(1.0)).max() < 1e-14


@pytest.mark.parametrize("fields, words", [
    ({"max_slope": 1e-3}, "no finite derivative"),
    ({"max_trials": 0}, "runs into a singularity"),
    ({"min_disc": 1e3}, "runs into a singularity"),
])  # fmt: skip
def test_a_proof_gives_up_where_its_limits_say(monkeypatch, fields, words):
    with_limits(monkeypatch, enclosure, **fields)
    with pytest.raises(NotConverged, match=words):
        certify()


@pytest.mark.parametrize("fields", [{"widening": 1.05}, {"rings": 3}, {"min_ring": 0.06}, {"max_excursion": 0.5},
                                    {"spare_growth": 30.0}])  # fmt: skip
def test_other_limits_cost_steps_and_keep_the_proof(monkeypatch, fields):
    with_limits(monkeypatch, enclosure, **fields)
    proof, exact = certify(), ph.FreeMotion(MOMENTS, momentum=MOMENTUM).momentum(1.0)
    assert (np.abs(proof.states[-1] - exact) <= proof.radii[-1] + 1e-15).all()


I1, I2, I3 = sympy.symbols("I1 I2 I3", positive=True)
BRACKET = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3])
L1, L2, L3 = BRACKET.coordinates
SYMBOLIC = SymbolicSystem(BRACKET, L1**2 / (2 * I1) + L2**2 / (2 * I2) + L3**2 / (2 * I3))
SAMPLES = [{"I1": 1.0, "I2": 2.0, "I3": 3.0}]


@pytest.mark.parametrize("share, broken", [(0.01, False), (100.0, True)])
def test_a_step_holds_to_some_roundings(share, broken):
    off = 1.0 + share * derivation.LIMITS.max_difference
    numerical = Numerical(lambda v: FreeRigidBody((off * v["I1"], v["I2"], v["I3"])), SAMPLES)
    page = Derivation("A page", SYMBOLIC, numerical)
    if broken:
        with pytest.raises(DerivationBroken, match="numerical system differs"):
            page.hamiltonian("Its energy.")
    else:
        page.hamiltonian("Its energy.")


def test_symbols_are_taken_up_to_a_number_of_monomials(monkeypatch):
    for most, refused in ((10, False), (9, True)):  # of degree two in three variables
        with_limits(monkeypatch, integrals, max_symbolic_monomials=most)
        if refused:
            with pytest.raises(InvalidInput, match="more than 9 monomials"):
                integrals.polynomial_integrals(SYMBOLIC, 2)
        else:
            assert integrals.polynomial_integrals(SYMBOLIC, 2) == []


def test_a_solver_has_a_time(monkeypatch):
    z3 = pytest.importorskip("z3")
    from polhode.proving.verdicts import smt

    given = []
    monkeypatch.setattr(z3.Solver, "set", lambda self, name, value: given.append((name, value)))
    with_limits(monkeypatch, smt, max_time=1234)
    certificate = ph.stability(BODY, np.array([0.0, 0.0, 1.0])).certificate.as_rational()
    smt.check_by_z3(certificate)
    assert set(given) == {("timeout", 1234)}
