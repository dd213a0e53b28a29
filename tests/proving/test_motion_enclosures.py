"""Enclosures of motions in closed form: regimes decided exactly, known digits, verdicts, axes, and bad input."""

import copy
import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx

import polhode as ph
from polhode.errors import InvalidInput
from polhode.proving.enclosures import _ball_formulas
from polhode.proving.enclosures._ball_formulas import FOR_BALLS
from polhode.proving.enclosures._free_body_balls import FORMULAS, FreeBody
from polhode.proving.enclosures._lagrange_top_balls import FORMULAS as OF_TOPS
from polhode.proving.enclosures._lagrange_top_balls import LagrangeTop
from polhode.proving.enclosures._motion_starts import exact_start
from polhode.proving.enclosures.enclosed_numbers import EnclosedNumber
from starts import lagrange_motion
from twins.families_of_tops import draw_tops

MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.2, 1.0))
TOP = ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(0.8, 0.6, 0.0, 0.0))
DECIMALS = {"momentum": ("0.3", "0.2", "1")}


@pytest.mark.parametrize(("exact", "period"), [
    (DECIMALS, "20.2049347380819979889700509566080377946"),
    (None, "20.2049347380819978396"),
])  # fmt: skip
def test_the_known_period_is_enclosed_to_fifty_digits(exact, period):
    """Of four independent routes; the decimals and their nearest doubles part in the 17th digit."""
    result = ph.certify(MOTION, digits=50, exact=exact).period
    half = Fraction(1, 2 * 10 ** len(period.split(".")[1]))
    assert abs((result.lower + result.upper) / 2 - Fraction(period)) <= half
    assert result.upper - result.lower < Fraction(1, 10**48)
    assert str(result).startswith(period[:-1])


def test_decimals_may_be_in_a_regime_that_their_doubles_are_not():
    """(I2 − I1) I3 L1² = (I3 − I2) I1 L3² holds of the decimals."""
    motion = ph.FreeMotion((0.3, 0.4, 0.6), momentum=(0.1, 0.25, 0.1))
    of_doubles = ph.certify(motion)
    exact = {"moments": (Fraction(3, 10), Decimal("0.4"), "3/5"), "momentum": ("0.1", "1/4", "0.1")}
    result = ph.certify(motion, exact=exact)
    assert of_doubles.regime != "separatrix" == result.regime
    assert float(result.period) == np.inf and str(result.period) == "inf" and result.action is None
    assert 1e30 not in result.period
    with pytest.raises(OverflowError):
        result.period.lower  # noqa: B018
    assert result.taken == {"moments": "the exact numbers given", "momentum": "the exact numbers given",
                           "attitude": "the nearest doubles", "epoch": "the nearest doubles"}  # fmt: skip


def test_the_threshold_of_sleeping_is_decided_exactly():
    """L3² = 4 I1 mgl of the decimals 1.2² = 4 · 0.9 · 0.4; there the upright axis is stable still."""
    top = ph.LagrangeMotion((0.9, 0.9, 0.5), mgl=0.4, momentum=(0.0, 0.0, 1.2))
    exact = {"moments": ("0.9", "0.9", "0.5"), "mgl": "0.4", "momentum": (0, 0, "1.2")}
    assert ph.certify(top, exact=exact).verdict == "stable"
    below = {**exact, "momentum": (0, 0, "1.19999999999999999999999999")}
    assert ph.certify(top, exact=below).verdict == "unstable"
    assert ph.certify(top, exact=exact).regime == "sleeping"


@pytest.mark.parametrize(("moments", "verdicts"), [
    ((1.0, 2.0, 3.0), "SUS"), ((2.0, 3.0, 1.0), "USS"), ((2.0, 1.0, 2.0), "USU"), ((1.5, 1.0, 1.0), "SUU"),
    ((1.0, 1.0, 1.0), "SSS"), ((1.0, np.nextafter(1.0, 2.0), 1.0), "USU"),
])  # fmt: skip
def test_a_spin_is_stable_if_its_moment_is_strictly_extremal_or_all_are_equal(moments, verdicts):
    verdicts = ["stable" if letter == "S" else "unstable" for letter in verdicts]
    result = ph.certify(ph.FreeMotion(moments, momentum=(0.3, 0.2, 1.0)))
    assert list(result.verdicts.values()) == verdicts
    for k in range(3):
        assert ph.certify(ph.FreeMotion(moments, momentum=1.3 * np.eye(3)[k])).verdict == verdicts[k]


@pytest.mark.parametrize(("spin", "upright"), [(0.0, "unstable"), (1.9, "unstable"), (2.0, "stable"), (-3.0, "stable")])
@pytest.mark.parametrize("mgl", [1.0, -1.0])
def test_a_top_sleeps_from_its_threshold_on(spin, upright, mgl):
    """L3² ≥ 4 I1 mgl, here 2²."""
    for attitude, above in (((1.0, 0.0, 0.0, 0.0), mgl > 0), ((0.0, 1.0, 0.0, 0.0), mgl < 0)):
        result = ph.certify(ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=mgl, momentum=(0.0, 0.0, spin), attitude=attitude))
        assert result.verdicts == {"upright": upright, "hanging": "stable"}
        assert result.verdict == (upright if above else "stable")


@pytest.mark.sweep
@pytest.mark.parametrize("moments", [(1.0, 2.0, 3.0), (2.0, 1.0, 2.0), (1.5, 1.0, 1.0), (1.0, 1.0, 1.0)])
def test_verdicts_on_spins_are_those_of_energy_casimir(moments):
    result = ph.certify(ph.FreeMotion(moments, momentum=(0.3, 0.2, 1.0))).verdicts
    for k in range(3):
        proof = ph.stability(ph.systems.FreeRigidBody(moments), 1.3 * np.eye(3)[k])
        assert result[f"axis {k + 1}"] == proof.verdict, (moments, k)


@pytest.mark.sweep
@pytest.mark.parametrize("spin", [0.0, 1.9, 2.1, -3.0])
def test_verdicts_on_tops_are_those_of_energy_casimir(spin):
    proofs = ph.analysis.top_stability(ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0), spin / 0.5)
    result = ph.certify(ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, spin)))
    assert result.verdicts == {"upright": proofs.upright.verdict, "hanging": proofs.hanging.verdict}


def test_moving_tops_and_bodies_have_no_verdict():
    assert ph.certify(MOTION).verdict is None and ph.certify(TOP).verdict is None
    assert ph.certify(ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=0.0, momentum=(0.1, 0.0, 1.0))).verdicts == {}


def test_more_digits_lie_within_fewer():
    few, many = (ph.certify(motion, digits=digits) for motion in (MOTION,) for digits in (15, 200))
    for name in ("period", "precession_per_period", "geometric_phase", "action", "energy"):
        coarse, fine = getattr(few, name), getattr(many, name)
        assert coarse.lower <= fine.upper and fine.lower <= coarse.upper, name
        assert fine.radius < 1e-198 and coarse.radius < 1e-13


def test_a_state_is_along_the_axes_of_the_motion():
    body = ph.Body(1.0, (0.0, 0.0, 0.0), [[2.0, 0.1, 0.2], [0.1, 3.0, 0.3], [0.2, 0.3, 4.0]])
    motion = ph.FreeMotion.from_body(body, momentum=(0.3, 0.2, 1.0), attitude=(0.5, 0.5, -0.5, 0.5), epoch=0.25)
    for one in (motion, motion.along("principal")):
        result = ph.certify(one).state(100.0)
        attitude, momentum = one.state(100.0)
        assert np.abs(result.values - [*attitude, *momentum]).max() < 4e-15
        assert np.abs([float(x) for x in result.angular_velocity] - one.angular_velocity(100.0)).max() < 4e-15
        rows = np.array([[float(x) for x in row] for row in result.rotation_matrix])
        assert np.abs(rows - one.rotation_matrix(100.0)).max() < 4e-15
        assert (result.radii < 1e-24).all()


def test_the_start_is_enclosed_with_its_sign():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.2, 1.0), attitude=(-0.5, 0.5, 0.5, 0.5), epoch=2.0)
    result = ph.certify(motion).state(2)
    given = (-0.5, 0.5, 0.5, 0.5, 0.3, 0.2, 1.0)
    assert all(x in enclosed for x, enclosed in zip(given, result.attitude + result.momentum, strict=True))


def test_an_angular_velocity_is_taken_exactly():
    motion = ph.FreeMotion((0.1, 0.2, 0.25), angular_velocity=(0.3, 0.1, 0.7))
    exact = {"moments": ("0.1", "0.2", "0.25"), "angular_velocity": ("0.3", "0.1", "0.7")}
    result = ph.certify(motion, exact=exact)
    assert Fraction("0.06675") in result.energy  # ½ (0.1·0.09 + 0.2·0.01 + 0.25·0.49)
    assert result.taken["momentum"] == "the exact numbers given"


def test_words_bound_what_they_say():
    for enclosed in (ph.certify(MOTION).period, ph.certify(TOP).action, ph.certify(TOP, digits=3).nutation_period):
        middle, radius = (Fraction(part) for part in str(enclosed).split(" ± "))
        assert middle - radius <= enclosed.lower and enclosed.upper <= middle + radius
        assert abs(Fraction(enclosed.value) - middle) < Fraction(1, 10**13) * abs(middle) + radius
    assert str(ph.certify(MOTION, exact=DECIMALS, digits=5).momentum_square).startswith("1.1300 ± ")
    assert repr(ph.certify(MOTION)) == "<FreeEnclosure: short-axis, 25 digits>"
    exact = ph.certify(ph.FreeMotion((1.0, 2.0, 4.0), momentum=(1.0, 1.0, 1.0))).energy
    assert str(exact) == "0.8750000000000000000000000" and exact.radius == 0.0 and Fraction(7, 8) in exact


@pytest.mark.parametrize(("call", "message"), [
    (lambda: ph.certify(MOTION, [1.0, 2.0, 3.0]), "`state` is a system's; a FreeMotion has its own start"),
    (lambda: ph.certify(MOTION, radius=1e-12), "`radius` is a system's"),
    (lambda: ph.certify(ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), digits=30), "`digits` is a motion's"),
    (lambda: ph.certify(ph.systems.FreeRigidBody((1.0, 2.0, 3.0))), "`state` and `times` must be given"),
    (lambda: ph.certify(3), "must be a system, or a motion in closed form; got 3"),
    (lambda: ph.certify(MOTION, digits=0), "whole number from 1 to 10,000; got 0"),
    (lambda: ph.certify(MOTION, digits=10**5), "whole number from 1 to 10,000; got 100000"),
    (lambda: ph.certify(ph.FreeMotion([[1.0, 2.0, 3.0]] * 2, momentum=(1.0, 2.0, 3.0))), r"no batch; got \(2,\)"),
    (lambda: ph.certify(MOTION, exact={"mass": 1}), "some of moments, momentum, attitude, epoch, angular_velocity"),
    (lambda: ph.certify(MOTION, exact={"momentum": ("0.3", "0.2", "1.1")}), "must be the numbers that the motion"),
    (lambda: ph.certify(MOTION, exact={"momentum": ("0.3", "0.2")}), r"`exact\[momentum\]` must be 3 numbers"),
    (lambda: ph.certify(MOTION, exact={"moments": ("1", "2", "x")}), "decimals like"),
    (lambda: ph.certify(MOTION).state("1e9999999"), "within 1e±5000"),
    (lambda: ph.certify(MOTION).state([1.0, 2.0]), "`t` must be given as doubles"),
    (lambda: ph.certify(MOTION).state(float("inf")), "`t` must be finite"),
    (lambda: ph.certify(MOTION).state(np.float32(0.1)), "double precision"),
    (lambda: ph.certify(MOTION).state(True), "`t` must be given as doubles"),
])  # fmt: skip
def test_bad_input_is_one_clear_error(call, message):
    with pytest.raises(InvalidInput, match=message):
        call()


def test_a_number_holds_what_it_should():
    with ctx.workprec(200):
        number = EnclosedNumber(arb("0.1", "1e-20"))
    assert "0.1" in number and Fraction(1, 10) in number and "0.10000000000000000002" not in number
    assert number.radius >= 1e-20 and number.lower < Fraction(1, 10) < number.upper


@pytest.mark.parametrize("motion", [
    ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)),
    ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 4.0, 0.0)),  # whose period is infinite
    ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=0.75, momentum=(0.3, 0.2, 1.5), attitude=(1.0, 0.0, 0.0, 0.0)),
], ids=["body", "at rest", "top"])  # fmt: skip
def test_proofs_can_be_pickled_and_copied(motion):
    proof = ph.certify(motion)
    for other in (pickle.loads(pickle.dumps(proof)), copy.deepcopy(proof)):
        for one, two in zip(other.state("7.5").momentum, proof.state("7.5").momentum, strict=True):
            assert (one.lower, one.upper) == (two.lower, two.upper)
    state = proof.state(1.0)
    assert str(pickle.loads(pickle.dumps(state))) == str(state)


@pytest.mark.parametrize(("moments", "momentum"), [
    ((1.0, 2.0, 3.0), (0.3, 0.2, 1.0)), ((3.0, 4.0, 6.0), (1.0, 2.5, -1.0)),
    ((1e150, 2.1e-150, 0.7), (1e-160, 0.3, 1e160)), ((0.1, 0.1, np.nextafter(0.1, 1.0)), (5e-324, 1.7e308, 0.3)),
])  # fmt: skip
def test_what_formulas_compare_is_exact(moments, momentum):
    """Else a comparison of balls that overlap would take one way without a proof."""
    body = FreeBody(exact_start(ph.FreeMotion(moments, momentum=momentum), {}))
    assert all(_exact(body._reduced()).values())
    with ctx.workprec(53):
        rounded = FORMULAS.reduction(*(tuple(map(arb, x)) for x in (body._whole_moments, body._whole_momentum)))
    assert all(_exact(rounded).values()) == (momentum == (1.0, 2.5, -1.0))


def _exact(body):
    return {name: getattr(body, name)[0].is_exact() for name in ("A", "B", "C", "P", "Q", "S", "V", "G2", "canonical")}


@pytest.mark.parametrize("small", [0.5, 1e-3, 1e-30, 1e-300])
def test_a_sum_of_the_third_kind_is_enclosed_or_refused(small, monkeypatch):
    a, g, pp = ((arb(x), arb(0)) for x in (1.0, small, 0.3))

    def total(bits):
        with ctx.workprec(bits):
            return FOR_BALLS["third_kind_mean"](a, g, pp)[1][0]

    assert all(total(bits).contains(total(600)) for bits in range(40, 200))
    monkeypatch.setattr(_ball_formulas, "MOST_STEPS", 3)
    assert not total(100).is_finite()


@pytest.mark.parametrize("name", ["_first_alpha", "_first_beta"])
@pytest.mark.parametrize("mgl", [0.0, 0.1, 1.0, 30.0])
def test_either_form_of_a_rate_is_right(name, mgl, monkeypatch):
    """So that balls may take the other one where a comparison is open; what one form rounds off less is no matter."""
    top = LagrangeTop(exact_start(ph.LagrangeMotion((1, 1, 0.5), mgl=mgl, momentum=(0.5, -0.25, 2.5),
                                                    attitude=(0.8, 0.36, 0.48, 0.0)), {}))  # fmt: skip
    space = OF_TOPS.frequencies.__globals__
    right = space[name]
    with ctx.workprec(200):
        _, _, one = top._rates()
        monkeypatch.setitem(space, name, lambda *given: not right(*given))
        _, _, other = top._rates()
        for x, y in ((one.alpha[0], other.alpha[0]), (one.beta[0], other.beta[0])):
            assert x.overlaps(y) and (x - y).rad() < arb(2) ** -150
        monkeypatch.setitem(space, "start_of_alpha", lambda first, *given: FOR_BALLS["scale"](given[0], 1.5))
        assert mgl == 0.0 or not top._rates()[2].alpha[0].overlaps(one.alpha[0])


def test_few_bits_take_no_top_for_one_whose_roots_coincide():
    for case in draw_tops(2, seed=9):
        top = LagrangeTop(exact_start(lagrange_motion(*case[1:5]), {}))
        with ctx.workprec(10):
            rates = top._rates()[2]
        coincide = top.separatrix, top.steady and not top.permanent
        assert (rates.separatrix, rates.steady) == coincide, case
