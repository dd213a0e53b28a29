"""Exact certificates against the numerical verdicts, against sampled values, and against altered ones."""

import pickle
import sys
from dataclasses import replace
from fractions import Fraction
from functools import partial

import jax.numpy as jnp
import numpy as np
import pytest
from flint import fmpq

import polhode as ph
from polhode._base.rational._matrices import as_floats
from polhode._base.rational._polynomials import half_hessian, rate, variables
from polhode._base.rational.numbers import as_fmpq, as_fraction, read_number
from polhode.algebra.casimirs import rational_brackets
from polhode.analysis._conserved import Energy
from polhode.analysis._exact_equations import Field
from polhode.analysis.energy_casimir import energy_casimir
from polhode.certificates._confinement import Confinement
from polhode.certificates._exact_tracing import trace_polynomials
from polhode.certificates._growth import Drift, Growth
from polhode.errors import InvalidInput
from polhode.proving import check_by_z3
from polhode.proving.symbolic._polynomials import to_rational
from polhode.proving.verdicts.rocq import proof_text

BODY = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
TOP = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0)
HULL = ph.systems.Kirchhoff((1.0, 2.0, 3.0, 3.0, 2.0, 1.0))
UPRIGHT, HANGING = [0.0, 0.0, 12.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0, 0.0, -1.0]


LAGRANGE = ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0)
PRECESSING = [1.2, 0.0, 2.1, 0.6, 0.0, 0.8]  # steadily, at 2 rad/s about the vertical


def spin(point):
    return point[2]


def judge(system, point, **options):
    return ph.stability(system, np.array(point, float), **options)


def exact(system, point, **options):
    return judge(system, point, **options).certificate.as_rational()


def random_cases(count=24):
    """Systems with numbers of two digits, and points at rest along an axis."""
    rng = np.random.default_rng(7)
    for k in range(count):
        moments = np.round(rng.uniform(0.6, 1.4, 3), 2)
        axis, spin = np.eye(3)[k % 3], round(float(rng.uniform(0.3, 6.0)), 1)
        up = float(rng.choice([-1.0, 1.0]))
        kind = k // 3 % 4
        if kind == 0:
            yield ph.systems.FreeRigidBody(moments), spin * axis
        elif kind == 1:
            weight = round(float(rng.uniform(0.2, 1.0)), 1)
            yield ph.systems.HeavyTop(moments, weight, axis), [*(spin * axis), *(up * axis)]
        elif kind == 2:
            yield ph.systems.Gyrostat(moments, round(float(rng.uniform(-2.0, 2.0)), 1) * axis), spin * axis
        else:
            masses = np.round(rng.uniform(0.5, 3.0, 3), 1)
            yield ph.systems.Kirchhoff(np.r_[moments, masses]), [*(spin * axis), *(0.5 * up * axis)]


@pytest.mark.long_after(8)
@pytest.mark.parametrize("number", range(24))
def test_exact_and_numerical_verdicts_agree(number):
    system, point = list(random_cases())[number]
    verdict = judge(system, point)
    if verdict.verdict == "undecided":
        with pytest.raises(InvalidInput, match=r"needs a decided verdict; got undecided"):
            verdict.certificate.as_rational()
        return
    found = verdict.certificate.as_rational()
    assert found.verdict == verdict.verdict and not found.find_faults()
    assert found.equations.moved == 0 and [float(x) for x in found.equations.point] == list(point)
    rng = np.random.default_rng(number)
    for x in rng.normal(size=(5, found.equations.size)):
        exactly = [float(f(*map(as_fmpq, x.tolist()))) for f in found.equations.field]
        assert np.allclose(exactly, system.vector_field(0.0, jnp.asarray(x)), rtol=1e-12, atol=1e-12)
    if found.verdict == "stable":  # G at sampled points inside the radius, and the numerical function's sign
        g, z = found.proof.function(found.equations), found.equations.point
        for v in rng.normal(size=(40, len(z))):
            v = [as_fmpq(Fraction(float(x)).limit_denominator(1000)) for x in v / np.linalg.norm(v)]
            v = [x * found.proof.radius * fmpq(9, 10) for x in v]
            assert g(*(a + b for a, b in zip(z, v, strict=True))) > g(*z)
    else:
        real = np.linalg.eigvals(as_floats(found.equations.linearization)).real
        assert (real > float(found.proof.rate)).sum() == found.proof.beyond
        assert real.max() == pytest.approx(verdict.rate, rel=1e-6)


@pytest.mark.long_after(8)
@pytest.mark.parametrize("number", range(24))
def test_z3_agrees_with_the_exact_check(number):
    pytest.importorskip("z3")
    system, point = list(random_cases())[number]
    verdict = judge(system, point)
    if verdict.verdict != "undecided":
        check_by_z3(verdict.certificate.as_rational())


def alter(certificate, **changes):
    return replace(certificate, proof=replace(certificate.proof, **changes))


def alter_equations(certificate, **changes):
    return replace(certificate, equations=replace(certificate.equations, **changes))


def with_other_field(certificate, k, factor):
    field = list(certificate.equations.field)
    field[k] = field[k] * factor
    return alter_equations(certificate, field=tuple(field))


def first_square(certificate, factor):
    (d, row), *others = certificate.proof.forms
    return alter(certificate, forms=((d * factor, row), *others))


def changed(values, name, factor):
    return {k: x * factor if k == name else x for k, x in values.items()}


ALTERED = {
    "a weight": lambda: alter(c := exact(BODY, [1, 0, 0]), weights=changed(c.proof.weights, "|L|²", fmpq(3, 2))),
    "the sign of a weight": lambda: alter(c := exact(TOP, HANGING), weights=changed(c.proof.weights, "Π·P", -1)),
    "a square that is left out": lambda: alter(exact(TOP, UPRIGHT), squares={}),
    "a larger square": lambda: first_square(exact(BODY, [0, 0, 1]), fmpq(101, 100)),
    "a negative square": lambda: first_square(exact(TOP, HANGING), -1),
    "a larger margin": lambda: alter(c := exact(BODY, [0, 0, 1]), margin=2 * c.proof.margin),
    "a larger radius": lambda: alter(exact(HULL, [0, 0, 4, 0, 0, 0.5]), radius=fmpq(1)),
    "other equations": lambda: with_other_field(exact(BODY, [0, 0, 1]), 1, fmpq(7, 6)),
    "another point": lambda: alter_equations(
        exact(HULL, [0, 0, 0, 1, 0, 0]), point=tuple(map(fmpq, (0, 0, fmpq(1, 9), 1, 0, 0)))),
    "the middle axis": lambda: alter_equations(exact(BODY, [0, 0, 1]), point=tuple(map(fmpq, (0, 1, 0)))),
    "a faster rate": lambda: alter(exact(BODY, [0, 1, 0]), rate=fmpq(1)),
    "a direction in which V falls": lambda: alter(exact(BODY, [0, 1, 0]), direction=tuple(map(fmpq, (0, 1, 0)))),
    "another drift": lambda: alter(c := exact(ph.systems.FreeRigidBody((1.0, 1.0, 2.0)), [1, 0, 0]),
                                   conserved=c.proof.conserved * 2),
    "a wrong turn": lambda: alter_equations(c := exact(LAGRANGE, PRECESSING, integrals=[spin]),
                                            flow=tuple(f * 2 for f in c.equations.flow)),
    "no square across the orbit": lambda: alter(exact(LAGRANGE, PRECESSING, integrals=[spin]), slice=fmpq(0)),
    "a stable system's growth": lambda: replace(exact(BODY, [0, 0, 1]), proof=exact(BODY, [0, 1, 0]).proof),
}  # fmt: skip


@pytest.mark.parametrize("name", ALTERED)
def test_altered_certificates_are_refused(name):
    altered = ALTERED[name]()
    with pytest.raises(InvalidInput, match="the certificate must prove its verdict; but"):
        altered.check()


@pytest.mark.parametrize("name", ["a weight", "the sign of a weight", "other equations", "the middle axis",
                                  "a faster rate", "a direction in which V falls", "another drift"])  # fmt: skip
def test_z3_refuses_wrong_claims_too(name):
    """It is not given margins and squares, so that wrong ones do not mislead it."""
    pytest.importorskip("z3")
    with pytest.raises(InvalidInput, match="the claim must hold that"):
        check_by_z3(ALTERED[name]())


def test_each_way_of_proof_is_used():
    kinds = [(BODY, [0, 0, 1], Confinement), (BODY, [0, 1, 0], Growth),
             (ph.systems.FreeRigidBody((1.0, 1.0, 2.0)), [1, 0, 0], Drift)]  # fmt: skip
    for system, point, kind in kinds:
        assert isinstance(exact(system, point).proof, kind)


def test_a_verdict_up_to_a_flow_says_so():
    verdict = judge(LAGRANGE, PRECESSING, integrals=[spin])
    assert verdict.verdict == "stable" and verdict.restriction == "up to the flow of J1"
    found = verdict.certificate.as_rational()
    assert "up to the flow of J1" in found.statement
    v = variables(6)
    assert found.equations.flow == (v[1], -v[0], v[0] * 0, v[4], -v[3], v[0] * 0)
    # the point itself moves, along the symmetry's orbit alone
    field, along = ([float(x) for x in row] for row in
                    ([f(*found.equations.point) for f in found.equations.field], found.equations.along))  # fmt: skip
    assert np.linalg.norm(field) > 0.1 and np.linalg.matrix_rank(np.array([field, along]), 1e-12) == 1
    quadratic = judge(LAGRANGE, PRECESSING, integrals=[lambda point: point[2] ** 2])
    with pytest.raises(InvalidInput, match="needs one that turns all coordinates at one rational rate"):
        quadratic.certificate.as_rational()


def test_a_verdict_on_the_leaf_alone_is_proved_there():
    """Without P a top is a free body; of motions on leaves nearby, where P is small, nothing is known."""
    verdict = judge(TOP, [0, 0, 1, 0, 0, 0])
    assert verdict.verdict == "undecided" and "leaves nearby are larger" in verdict.certificate
    found = verdict.certificate.as_rational()
    assert found.verdict == "undecided" and "every solution with x4 = x5 = x6 = 0, that" in found.statement
    assert "of other solutions, on leaves nearby, nothing is proved" in found.statement
    assert found.as_json()["verdict"] == "undecided" and found.as_json()["within"] == "x4 = x5 = x6 = 0"
    assert found.equations.field == exact(BODY, [0, 0, 1]).equations.field
    with pytest.raises(InvalidInput, match="needs coordinates that are zero on it and stay so, and others that move"):
        exact(TOP, [0, 0, 0, 0, 0, 0])


def test_integrals_that_nobody_named_are_found():
    """Where no Casimirs are given the verdict is by the leaf; the proof finds integrals of second degree itself."""
    verdict = judge(BODY, [0, 0, 1], casimirs=[])
    assert verdict.verdict == "stable" and "the point is regular" in verdict.certificate
    found = verdict.certificate.as_rational()
    assert len(found.proof.weights) == 2 and not found.find_faults()


def test_instability_with_losses_has_a_proof_and_stability_says_why_not():
    damped = ph.systems.DoubleBracket((1.0, 2.0, 3.0), 0.1)
    assert isinstance(exact(damped, [1, 0, 0]).proof, Growth)
    with pytest.raises(InvalidInput, match="needs a conserved energy"):
        exact(damped, [0, 0, 1])


def test_the_least_known_case_by_hand():
    """H − |L|²/6 about the third axis of (1, 2, 3): ½ D² is diag(1/3, 1/12, 0) before the square."""
    found = exact(BODY, [0, 0, 1])
    assert found.proof.weights == {"|L|²": fmpq(-1, 6), "H": fmpq(1)}
    second = half_hessian(found.proof.raised(found.equations), [fmpq(0)] * 3)
    square = found.proof.squares["|L|²"]
    assert [second[k, k] for k in range(3)] == [fmpq(1, 3), fmpq(1, 12), 4 * square]


@pytest.mark.long
def test_whoever_has_only_the_plain_data_can_check_them():
    """From the JSON alone: polynomials, weights and squares, with other code than the package's."""
    import json
    from itertools import product

    data = json.loads(exact(TOP, HANGING).json())
    z = [Fraction(x) for x in data["point"]]
    proof = data["proof"]

    def value(terms, x):
        return sum(Fraction(c) * np.prod([a**e for a, e in zip(x, m, strict=True)]) for c, m in terms)

    def g(x):
        at = {k: value(t, x) for k, t in data["conserved"].items()}
        here = {k: value(t, z) for k, t in data["conserved"].items()}
        return (sum(Fraction(w) * at[k] for k, w in proof["weights"].items())
                + sum(Fraction(s) * (at[k] - here[k]) ** 2 for k, s in proof["squares"].items()))  # fmt: skip

    for v in product([Fraction(0), Fraction(1, 3), Fraction(-2, 5)], repeat=6):
        squares = sum(Fraction(d) * sum(Fraction(a) * b for a, b in zip(row, v, strict=True)) ** 2
                      for d, row in proof["forms"])  # fmt: skip
        assert g([a + b for a, b in zip(z, v, strict=True)]) - g(z) == (
            Fraction(proof["margin"]) * sum(b * b for b in v) + squares)  # fmt: skip


@pytest.mark.long
def test_an_irrational_equilibrium_is_moved_or_refused():
    gyrostat = ph.systems.Gyrostat((1.0, 2.0, 3.0), (0.1, 0.7, 0.4))
    point = ph.find_equilibria(gyrostat, np.array([0.3, 0.4, 1.0]))[0]
    found = exact(gyrostat, point)
    assert 0 < float(found.equations.moved) < 1e-9 and not any(f(*found.equations.point) for f in found.equations.field)
    turned = np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])
    skew = turned @ np.diag([1.0, 0.5, 1 / 3]) @ turned.T + 0.01 * np.ones((3, 3))
    body = ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: 0.5 * L @ skew @ L)
    axis = np.linalg.eigh(skew)[1][:, 0]
    with pytest.raises(InvalidInput, match=r"must be an equilibrium in rational numbers .* within a billionth"):
        exact(body, axis)


SUM = 0.1 + 0.2  # and 0.3: two doubles


@pytest.mark.parametrize("read_as", ["exact", "decimal"])
def test_certificates_symbols_and_casimirs_read_a_double_alike(read_as):
    """The field of a certificate, by Euler's equations in fractions of the moments, and by symbols; and its words."""
    moments, point = (SUM, 0.7, 1 / 3), [0.0, 0.1, 0.0]
    found = judge(ph.systems.FreeRigidBody(moments), point).certificate.as_rational(read_as)
    a, b, c = (1 / as_fmpq(Fraction(m if read_as == "exact" else repr(m))) for m in moments)
    x, y, z = variables(3)
    assert found.equations.field == ((c - b) * y * z, (a - c) * z * x, (b - a) * x * y)
    assert as_fraction(found.equations.point[1]) == read_number(0.1, read_as)
    words = {"exact": "each double is the binary fraction that it is",
             "decimal": "each double is the shortest decimal that rounds to it"}[read_as]  # fmt: skip
    assert found.as_json()["numbers"] == words and words in proof_text(found, "body")
    symbolic = ph.proving.SymbolicSystem.from_system(ph.systems.FreeRigidBody(moments), read_as=read_as)
    for symbols, mine in zip(symbolic.equations.values(), found.equations.field, strict=True):
        assert to_rational(symbols, symbolic.bracket.coordinates) == mine
    scaled = ph.algebra.from_structure_constants(ph.algebra.SO3().structure_constants() * SUM)
    assert rational_brackets(scaled, read_as)[0][1] == {2: read_number(SUM, read_as)}


@pytest.mark.parametrize("read_as", ["exact", "decimal"])
def test_moments_that_differ_by_an_ulp_are_two_for_all(read_as):
    """A top with moments (0.1 + 0.2, 0.3, 0.15) is not Lagrange's, though 3/10 would make it that."""
    top = ph.systems.HeavyTop((SUM, 0.3, 0.15), 1.0)
    assert ph.proving.polynomial_integrals(top, 1, read_as) == []
    assert len(ph.proving.polynomial_integrals(ph.systems.HeavyTop((0.3, 0.3, 0.15), 1.0), 1, read_as)) == 1
    field = trace_polynomials(Field(top), 6, partial(read_number, read_as=read_as))
    assert rate(variables(6)[2], field)  # L3 moves


def test_what_has_no_exact_proof_is_said():
    with pytest.raises(InvalidInput, match=r'`read_as` must be "exact" or "decimal"; got \'short\''):
        judge(BODY, [0, 0, 1]).certificate.as_rational("short")
    curved = ph.systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: jnp.sin(up[2]))
    with pytest.raises(InvalidInput, match=r"must be a polynomial .* it has sine of something that moves"):
        exact(curved, [0, 0, 0, 0, 0, -1])
    matrices = energy_casimir(np.zeros((3, 3)), np.zeros(3), np.eye(3), np.zeros((0, 3)), np.zeros((0, 3, 3)))
    with pytest.raises(InvalidInput, match=r"an exact proof needs the equations"):
        matrices.certificate.as_rational()


def test_a_certificate_is_still_a_sentence():
    found = judge(BODY, [0, 0, 1])
    assert isinstance(found.certificate, str) and "positive definite" in found.certificate
    exactly = found.certificate.as_rational()
    assert pickle.loads(pickle.dumps(exactly)) == exactly
    again = pickle.loads(pickle.dumps(found))
    assert again.certificate == found.certificate == pickle.loads(pickle.dumps(found.certificate))
    with pytest.raises(InvalidInput, match="an exact proof needs the equations"):
        again.certificate.as_rational()


def test_z3_is_asked_for_by_name(monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    with pytest.raises(InvalidInput, match=r"checks by z3 need z3-solver, which is not installed"):
        check_by_z3(exact(BODY, [0, 0, 1]))


# ---------------------------------------------------------------------- the tools below


def test_polynomials_of_functions_have_their_values():
    rng = np.random.default_rng(3)
    for system, _ in random_cases(12):
        n = system.algebra.dim
        (energy,) = trace_polynomials(Energy(system), n)
        for x in rng.normal(size=(3, n)):
            value = float(system.energy(jnp.asarray(x)))
            assert float(energy(*map(as_fmpq, x.tolist()))) == pytest.approx(value, rel=1e-13)
