"""The oracle of the top against its integrated equations, itself at higher precision, and broken specimens."""

import pytest
from flint import arb, ctx, fmpq

from oracle.lagrange import TopState, largest_momentum, reference_top
from oracle.lagrange_taylor import integrated_top
from oracle.reference import exact
from twins.families_of_tops import FAMILIES, TopCase, draw_tops

AGREEMENT = 1e-40
"""Both methods carry 45 digits or more, of the attitude and of the largest |L|."""
MOST_TURN, MOST_TURN_OF_THE_SWEEP = 30.0, 60.0
"""√(|L|² + 4 mgl I1) t / I_min up to which the series are summed: their cost grows with its square."""
TOP = TopCase("specimen", (0.6, 0.6, 0.3), 1.5, (0.4, -0.7, 0.9), (0.8, 0.2, -0.4, 0.4), 3.0)


def distance(one: TopState, other: TopState, case: TopCase) -> float:
    with ctx.workprec(600):
        size = largest_momentum(*case[1:5])
        turned = [abs(a - b) for a, b in zip(one.quaternion, other.quaternion, strict=True)]
        moved = [abs(a - b) / (size if size > 0 else 1) for a, b in zip(one.momentum, other.momentum, strict=True)]
        return max(float(x) for x in turned + moved)


def turn(case: TopCase) -> float:
    unit = (sum(x * x for x in case.momentum) + 4 * abs(case.mgl) * case.moments[0]) ** 0.5
    return unit / min(case.moments) * abs(case.time)


def check_by_series(cases: list[TopCase]) -> None:
    for case in cases:
        assert distance(reference_top(*case[1:]), integrated_top(*case[1:]), case) < AGREEMENT, case


def short_tops(count: int, seed: int, most_turn: float) -> list[TopCase]:
    """Tops of every family for up to several nutations, longer times cut."""
    cases = draw_tops(count, seed, longest_turn=1.5)
    cases = [c._replace(time=c.time * min(1.0, most_turn / (turn(c) or 1.0))) for c in cases]
    assert {case.family for case in cases} == {family.__name__ for family in FAMILIES}
    return cases


@pytest.mark.long
def test_legendre_form_agrees_with_integrated_equations():
    check_by_series(short_tops(1, 7, MOST_TURN))


@pytest.mark.sweep
def test_legendre_form_agrees_with_integrated_equations_in_a_larger_draw():
    check_by_series(short_tops(6, 8, MOST_TURN_OF_THE_SWEEP))


@pytest.mark.long
def test_methods_tell_a_wrong_equation():
    """The two methods do not agree by accident: a weight off by one part in 1e30 parts them."""
    wrong = TOP._replace(mgl=exact(TOP.mgl) * (1 + fmpq(1, 10**30)))
    assert distance(reference_top(*TOP[1:]), integrated_top(*TOP[1:]), TOP) < AGREEMENT
    assert distance(reference_top(*wrong[1:]), integrated_top(*TOP[1:]), TOP) > 1e-31


def test_doubled_precision_changes_nothing():
    for case in draw_tops(2, 11):
        once, twice = (reference_top(*case[1:], bits=bits) for bits in (160, 320))
        assert distance(once, twice, case) < 2.0**-158, case


def test_composition_of_two_times():
    """1e9 and a bit in one leap equals the bit after 1e9, from the exact rationals nearest to the state then."""
    rest = 0.75
    whole, first = (reference_top(*TOP[1:5], time, bits=400) for time in (1e9 + rest, 1e9))
    with ctx.workprec(500):
        quaternion, momentum = (
            [fmpq(int((x.mid() * arb(2) ** 380).floor().unique_fmpz()), 2**380) for x in part] for part in first
        )
    momentum[2] = exact(TOP.momentum[2])
    assert distance(reference_top(TOP.moments, TOP.mgl, momentum, quaternion, rest, bits=250), whole, TOP) < 1e-60
