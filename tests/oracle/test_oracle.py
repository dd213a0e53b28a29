"""The oracle against a second method, published numbers, itself at higher precision, and broken specimens."""

import pytest
from flint import arb, ctx, fmpq

from oracle.derivatives import Direction, reference_derivative
from oracle.measures import drift_in_eps, error_in_eps
from oracle.reference import Reference, exact, reference_state
from oracle.reference_table import product as quaternion_product
from oracle.taylor import integrated_state
from sweeping import first
from twins.families_of_bodies import FAMILIES, Case, draw

AGREEMENT = 1e-40
"""Both methods carry 45 digits or more; the issue asks for 40."""
MOST_TURN = 300.0
"""|L| t / I_min up to which the series are summed in the suite: their cost grows with it."""
GROWTH_BITS = 60
"""e^{λt} for λt up to 40, which is more than a body goes through in ωt ≤ 20."""
PERIODS = (
    ((0.3, 1.8, 1.5), "10.68012008138356204829621"),
    ((0.9, 1.6, 0.3), "10.48993138150295622095543"),
)


def entries(state: Reference) -> list[arb]:
    return [x for row in state.rotation for x in row] + state.direction + state.quaternion


def distance(one: Reference, other: Reference) -> float:
    with ctx.workprec(300):
        return max(float(abs(a - b)) for a, b in zip(entries(one), entries(other), strict=True))


def turn(case: Case) -> float:
    return max(abs(x) for x in case.momentum) / min(case.moments) * abs(case.time)


@pytest.mark.long_after(4)
@pytest.mark.long_cases("wide_moments", "near_separatrix")
@pytest.mark.parametrize("family", first(10, [family.__name__ for family in FAMILIES]))
def test_legendre_form_agrees_with_integrated_equations(family):
    cases = [c for c in draw(6, seed=7, longest_turn=1.3) if c.family == family and turn(c) < MOST_TURN]
    assert cases
    for case in cases:
        reference = reference_state(case.moments, case.momentum, case.time)
        integrated = integrated_state(case.moments, case.momentum, case.time, GROWTH_BITS)
        assert distance(reference, integrated) < AGREEMENT, case


@pytest.mark.long
def test_a_whole_passage_between_the_saddles_agrees():
    moments, momentum, time = (1, 2, 3), (1e-12, 1.8, -1.5e-12), 75.0  # λt = 39: from one saddle to the other
    reference = reference_state(moments, momentum, time)
    assert float(reference.direction[1]) < 0
    assert distance(reference, integrated_state(moments, momentum, time, growth_bits=120)) < AGREEMENT


@pytest.mark.sweep
@pytest.mark.parametrize("momentum", [(0.3, 1.8, 1.5), (0.9, 1.6, 0.3), (1e-40, 1.8, 1.5e-40)])
def test_long_integrations_agree(momentum):
    time, growth_bits = (220.0, 700) if momentum[0] < 1e-9 else (1000.0, 0)
    reference = reference_state((1, 2, 3), momentum, time)
    assert distance(reference, integrated_state((1, 2, 3), momentum, time, growth_bits)) < AGREEMENT


@pytest.mark.parametrize(("momentum", "period"), PERIODS)
def test_momentum_returns_after_the_published_period(momentum, period):
    whole = fmpq(int(period.replace(".", "")), 10 ** len(period.split(".")[1]))
    momentum = tuple(fmpq(round(10 * x), 10) for x in momentum)
    later = reference_state((1, 2, 3), momentum, 1000 * whole).direction
    start = reference_state((1, 2, 3), momentum, 0).direction
    assert max(float(abs(a - b)) for a, b in zip(later, start, strict=True)) < 1e-19  # 1000 x half the last digit


def test_published_momentum():
    moments, momentum = (0.6, 0.8, 1.0), (1.8, 0.4, -0.9)
    state = reference_state(moments, momentum, 10.0)
    with ctx.workprec(200):
        norm = arb(sum((exact(x) ** 2 for x in momentum), fmpq(0))).sqrt()
        found = [float(norm * n) for n in state.direction]
    assert found == pytest.approx([1.765962508518208, -0.6954641970330868, 0.7795549814818724], abs=2e-16)


def test_doubled_precision_changes_nothing():
    for case in draw(3, seed=11):
        once, twice = (reference_state(case.moments, case.momentum, case.time, bits) for bits in (160, 320))
        assert distance(once, twice) < 2.0**-159, case


def test_composition_of_two_times():
    """R(s + t) = R(s) R_s(t): the second leg starts from the momentum reached by the first, as an exact rational."""
    moments, momentum = (0.6, 0.8, 1.0), (1.8, 0.4, -0.9)
    whole, first = (reference_state(moments, momentum, t, bits=400) for t in (1e9 + 0.5, 1e9))
    with ctx.workprec(500):
        reached = [fmpq(int((n.mid() * arb(2) ** 300).floor().unique_fmpz()), 2**300) for n in first.direction]
        size = sum((exact(x) ** 2 for x in momentum), fmpq(0))
        norm = fmpq(int((arb(size).sqrt() * arb(2) ** 300).floor().unique_fmpz()), 2**300)
    second = reference_state(moments, [norm * n for n in reached], 0.5, bits=250)
    with ctx.workprec(300):
        product = [
            [sum((first.rotation[i][k] * second.rotation[k][j] for k in range(3)), arb(0)) for j in range(3)]
            for i in range(3)
        ]
        turned = quaternion_product(first.quaternion, second.quaternion)
    assert distance(Reference(product, second.direction, turned), whole) < 1e-60


def test_time_derivative_is_the_equation_of_motion():
    moments, momentum, time = (0.6, 0.8, 1.0), (1.8, 0.4, -0.9), 1e6
    found = reference_derivative(moments, momentum, time, Direction(time=1))
    state = reference_state(moments, momentum, time)
    with ctx.workprec(200):
        norm = arb(sum((exact(x) ** 2 for x in momentum), fmpq(0))).sqrt()
        now = [norm * n for n in state.direction]
        spin = [x / arb(i) for x, i in zip(now, moments, strict=True)]
        cross = [now[i - 2] * spin[i - 1] - now[i - 1] * spin[i - 2] for i in range(3)]
        pairs = zip(found.turn + found.momentum, spin + cross, strict=True)
        assert max(float(abs(a - b)) for a, b in pairs) < AGREEMENT


@pytest.mark.parametrize("momentum", [(0.3, 1.8, 1.5), (1e-9, 1.8, 1e-9), (0.0, 0.0, 1.5), (1.0, 2.0, 1.0)])
def test_scaling_the_momentum_runs_time_faster(momentum):
    """δL0 = L0 gives ξ = t Ω(t) and δL(t) = L(t) + t dL/dt, an identity without any formula of the motion."""
    moments, time = (3, 4, 6), 50.0
    scaled = reference_derivative(moments, momentum, time, Direction(momentum=momentum))
    timed = reference_derivative(moments, momentum, time, Direction(time=1))
    state = reference_state(moments, momentum, time)
    with ctx.workprec(200):
        norm = arb(sum((exact(x) ** 2 for x in momentum), fmpq(0))).sqrt()
        expected = [time * x for x in timed.turn]
        expected += [norm * n + time * d for n, d in zip(state.direction, timed.momentum, strict=True)]
        assert max(float(abs(a - b)) for a, b in zip(scaled.turn + scaled.momentum, expected, strict=True)) < AGREEMENT


def test_halving_the_digits_of_the_step_changes_no_derivative():
    case, direction = ((1, 2, 3), (1e-150, 2.0, 3e-150), 300.0), Direction(moments=(1, 0, 0))
    fine, finer = (reference_derivative(*case, direction, bits) for bits in (1200, 2000))
    pairs = zip(fine.turn + fine.momentum, finer.turn + finer.momentum, strict=True)
    assert max(float(abs(a - b)) for a, b in pairs) < AGREEMENT


def test_measures_see_a_broken_specimen():
    """A reference rounded to double passes; the same with a wrong length, sense, mirror or momentum does not."""
    case = Case("specimen", (2.0, 2.0, 2.0), (0.0, 0.0, 4.0), 0.75)  # turns by 1.5 about axis 3
    half, good = [0.7316888688738209, 0.0, 0.0, 0.6816387600233342], (0.0, 0.0, 4.0)  # cos, sin of 0.75
    assert max(error_in_eps(half, good, case)) < 1
    assert max(drift_in_eps(half, good, case)) < 1
    longer = [x * (1 + 1e-14) for x in half]
    assert error_in_eps(longer, good, case).attitude > 50
    assert drift_in_eps(longer, good, case).orthogonality > 50
    backward = [half[0], 0.0, 0.0, -half[3]]
    assert error_in_eps(backward, good, case).attitude > 1e15
    assert error_in_eps([float("nan")] * 4, good, case).attitude == float("inf")
    bent = (1e-13, 0.0, 4.0)
    assert error_in_eps(half, bent, case).momentum > 50
    assert drift_in_eps(half, bent, case).space_momentum > 50
    assert drift_in_eps(half, (0.0, 0.0, 4.0 * (1 + 1e-14)), case).energy > 40
    assert drift_in_eps(half, (0.0, 0.0, 4.0 * (1 + 1e-14)), case).norm > 40


def test_methods_tell_a_wrong_equation():
    """The two methods do not agree by accident: a moment off by one part in 1e30 parts them."""
    off = exact(2.0) + fmpq(1, 10**30)
    wrong = reference_state((1, off, 3), (0.3, 1.8, 1.5), 20.0)
    assert distance(wrong, integrated_state((1, 2, 3), (0.3, 1.8, 1.5), 20.0)) > 1e-31
