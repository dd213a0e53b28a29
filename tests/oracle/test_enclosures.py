"""Enclosures of closed forms against mpmath and the ball oracle; and doubles against enclosures, a third oracle.

``ph.certify`` takes the library's formulas with theta functions in place of series. ``oracle.reference`` takes Landen's
steps and the azimuth of an axis, ``oracle.lagrange`` integrals of the third kind, and ``oracle.mpmath_motions`` no
elliptic function at all.
"""

import itertools
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from flint import arb, ctx

import polhode as ph
from oracle.lagrange import largest_momentum, reference_top
from oracle.measures import EPS
from oracle.mpmath_motions import fraction, free_numbers, integrated_state, top_numbers
from oracle.reference import reference_state
from polhode.proving.enclosures import _free_body_balls as free_body_balls
from polhode.proving.enclosures import _lagrange_top_balls as lagrange_top_balls
from starts import lagrange_motion
from twins.families_of_bodies import draw
from twins.families_of_tops import draw_tops

WORST_ERROR = 16.0
"""eps, of attitude entries and of L over |L|: the promise of the library."""
WORST_NUMBER = 40.0
"""eps, of periods and turns relative to themselves, and of angles to 2π."""
DIGITS = 60
LATEST = 1e9
FREE_NUMBERS = ("period", "precession_per_period", "precession_rate", "solid_angle", "geometric_phase", "action",
                "energy", "momentum_norm")  # fmt: skip
TOP_NUMBERS = ("nutation_period", "precession_per_period", "spin_per_period", "precession_rate", "spin_rate", "energy",
               "vertical_momentum", "axial_momentum")  # fmt: skip

# moments, momentum, attitude: one of each regime, exact in a few binary digits
BODIES = {
    "rest": ((1, 2, 3), (0, 0, 0), (1, 0, 0, 0)),
    "spherical": ((2, 2, 2), (0.5, -1, 0.25), (1, 0, 0, 0)),
    "permanent": ((1, 2, 3), (0, 1.5, 0), (0.5, 0.5, -0.5, 0.5)),
    "symmetric, oblate": ((1, 1, 1.5), (0.5, -0.25, 0.75), (0.5, 0.5, 0.5, 0.5)),
    "symmetric, prolate": ((2, 0.5, 2), (0.5, -0.75, 0.25), (1, 0, 0, 0)),
    "short-axis": ((1, 2, 3), (0.25, -0.5, 1), (1, 0, 0, 0)),
    "short-axis, backward": ((3, 1, 2), (-1.25, -0.25, 0.125), (0.5, -0.5, 0.5, 0.5)),
    "long-axis": ((1, 2, 3), (-1, 0.5, 0.25), (1, 0, 0, 0)),
    "long-axis, reordered": ((2, 3, 1), (0.5, -0.25, 1), (1, 0, 0, 0)),
    "separatrix": ((3, 4, 6), (1, 2.5, -1), (1, 0, 0, 0)),
    "separatrix, far half": ((4, 3, 6), (0.5, -1, -1), (0.5, 0.5, 0.5, -0.5)),
}
TOPS = {
    "rest": ((1, 1, 0.5), 1, (0, 0, 0), (1, 0, 0, 0)),
    "sleeping": ((1, 1, 0.5), 1, (0, 0, 3), (0.5, 0, 0, 0.5)),
    "hanging": ((1, 1, 0.5), 1, (0, 0, 0.5), (0, 0.5, 0.5, 0)),
    "steady": ((2, 2, 1), 1, (0, 0.5, 4), (0.5, 0.5, 0.5, 0.5)),
    "free": ((1, 1, 0.5), 0, (0.5, -0.25, 1), (0.5, 0.5, 0.25, 1)),
    "planar, swinging": ((1, 1, 0.5), 2, (0.5, 0, 0), (0.5, 0.5, 0.5, 0.5)),
    "planar, turning over": ((1, 1, 0.5), 1, (4, 0, 0), (0.5, 0.5, 0.5, 0.5)),
    "undulating": ((1, 1, 0.5), 1, (0.25, 1.5, 2.5), (0.5, 0.5, 0.25, 1)),
    "cusp": ((1, 1, 0.5), 1, (0, 0, 2.5), (1, 0.5, 0, 0)),
    "loop": ((1, 1, 0.5), 1, (0.5, -0.5, 2.5), (1, 0.5, 0, 0)),
    "separatrix": ((1, 1, 0.5), 12.5, (3, 4, 4), (0.5, 0.5, 0.5, 0.5)),
    "separatrix, planar": ((1, 1, 0.5), 2, (2, 0, 0), (0.5, 0.5, 0.5, 0.5)),
    "undulating, from upright": ((1, 1, 0.5), 1, (0.5, 1, 1.5), (1, 0, 0, 0.5)),
    "undulating, from straight down": ((1, 1, 0.5), 1, (0.5, 1, 1.5), (0, 1, 0.5, 0)),
    "undulating, weight below": ((1, 1, 0.5), -1, (0.25, 1.5, 2.5), (0.5, 0.5, 0.25, 1)),
}


def free(name):
    moments, momentum, attitude = BODIES[name]
    return ph.FreeMotion(moments, momentum=momentum, attitude=unit(attitude)), (moments, momentum, attitude)


def top(name):
    moments, mgl, momentum, attitude = TOPS[name]
    return ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=unit(attitude)), (
        moments, momentum, attitude, mgl)  # fmt: skip


def unit(attitude):
    return np.array(attitude, float) / np.linalg.norm(attitude)


def holds(enclosed, value):
    """Whether mpmath's value is in the ball, but for its own error: it has 20 digits more."""
    error = Fraction(1, 10 ** (DIGITS + 15))
    return enclosed.lower - error <= fraction(value) <= enclosed.upper + error


def check_state(found, wanted):
    for enclosed, value in zip((*found.attitude, *found.momentum), (*wanted[0], *wanted[1]), strict=True):
        assert holds(enclosed, value), (enclosed, mp.nstr(value, 30))
        assert enclosed.radius < 10.0 ** (3 - DIGITS)


@pytest.mark.parametrize("name", BODIES)
def test_states_of_bodies_hold_those_of_integrated_equations(name):
    motion, given = free(name)
    found = ph.certify(motion, digits=DIGITS, exact={"attitude": given[2]})
    assert found.regime == motion.regime == name.split(",")[0]
    with mp.workdps(DIGITS + 20):
        check_state(found.state("2.7"), integrated_state(*given, Fraction("2.7")))


@pytest.mark.long_after(5)
@pytest.mark.long_cases("separatrix")
@pytest.mark.parametrize("name", TOPS)
def test_states_of_tops_hold_those_of_integrated_equations(name):
    motion, given = top(name)
    found = ph.certify(motion, digits=DIGITS, exact={"attitude": given[2]})
    assert found.regime == motion.regime == name.split(",")[0]
    with mp.workdps(DIGITS + 20):
        check_state(found.state("-1.9"), integrated_state(*given[:3], Fraction("-1.9"), given[3]))


@pytest.mark.long_after(1)
@pytest.mark.parametrize("name", [name for name in BODIES if name.startswith(("short-axis", "long-axis", "symmetric"))])
def test_numbers_of_bodies_hold_quadratures(name):
    motion, given = free(name)
    found = ph.certify(motion, digits=DIGITS)
    with mp.workdps(DIGITS + 20):
        wanted = free_numbers(*given[:2], found.encircled_axis, 1000)
        for key, value in wanted.items():
            assert holds(getattr(found, key), value), (key, getattr(found, key), mp.nstr(value, 40))
        # Montgomery's formula: the turn of the axis is that of the energy, less the cap's, up to whole turns
        least = motion.moments[found.encircled_axis] == min(motion.moments)
        dynamic = 2 * fraction_of(found.energy) * wanted["period"] / fraction_of(found.momentum_norm)
        turns = (wanted["precession_per_period"] - dynamic - (1 if least else -1) * wanted["solid_angle"]) / (2 * mp.pi)
        assert abs(turns - mp.nint(turns)) < 1e-50


def fraction_of(enclosed):
    middle = (enclosed.lower + enclosed.upper) / 2
    return mp.mpf(middle.numerator) / middle.denominator


@pytest.mark.parametrize("name", ["undulating", "cusp", "loop"])
def test_numbers_of_tops_hold_quadratures(name):
    motion, (moments, momentum, attitude, mgl) = top(name)
    found = ph.certify(motion, digits=DIGITS, exact={"attitude": attitude})
    with mp.workdps(DIGITS + 20):
        wanted = top_numbers(moments, mgl, momentum, attitude, 1600)
        for enclosed, value in zip(found.nutation_limits, wanted.pop("limits"), strict=True):
            assert holds(enclosed, value)
        for key, value in wanted.items():
            assert holds(getattr(found, key), value), (key, getattr(found, key), mp.nstr(value, 40))


def slightly_wrong(function):
    return lambda *given, **named: function(*given[:-1], given[-1] * (1 + arb("1e-55")), **named)


STATES = {free_body_balls: test_states_of_bodies_hold_those_of_integrated_equations,
          lagrange_top_balls: test_states_of_tops_hold_those_of_integrated_equations}  # fmt: skip


@pytest.mark.parametrize(("module", "function", "name"), [
    (free_body_balls, "thetas", "short-axis"), (free_body_balls, "carlson", "symmetric, oblate"),
    (lagrange_top_balls, "thetas", "loop"), (lagrange_top_balls, "carlson", "cusp"),
])  # fmt: skip
def test_a_wrong_function_is_seen(monkeypatch, module, function, name):
    """An argument that misses a part in 1e55 leaves the balls of 60 digits."""
    monkeypatch.setattr(module, function, slightly_wrong(getattr(module, function)))
    with pytest.raises(AssertionError):
        STATES[module](name)


@pytest.mark.long
@pytest.mark.parametrize(("module", "check", "name"), [
    (free_body_balls, test_numbers_of_bodies_hold_quadratures, "long-axis"),
    (lagrange_top_balls, test_numbers_of_tops_hold_quadratures, "cusp"),
])  # fmt: skip
def test_a_wrong_mean_is_seen(monkeypatch, module, check, name):
    """Quadratures tell a sum of the third kind of which a start misses a part in 1e55."""
    space = module.FORMULAS.frequencies.__globals__
    right = space["third_kind_mean"]
    monkeypatch.setitem(space, "third_kind_mean", lambda a, g, pp: right(a, g, (pp[0] * (1 + arb("1e-55")), pp[1])))
    with pytest.raises(AssertionError):
        check(name)


# ------------------------------------------------------------------ a third oracle for the doubles, in every family


def errors_of_state(found, state, size):
    """Return the largest error of attitude entries, and of L over its size, in eps."""
    with ctx.workprec(400):
        turned = [abs(x.ball - arb(float(y))) for x, y in zip(found.attitude, state[0], strict=True)]
        moved = [abs(x.ball - arb(float(y))) / size for x, y in zip(found.momentum, state[1], strict=True)]
        return max(float(x) for x in turned) / EPS, max(float(x) for x in moved) / EPS


def least_sizes(found, motion):
    """Return the sizes of what cancels in some numbers, to which their errors are relative."""
    turns = dict.fromkeys(("precession_per_period", "spin_per_period", "solid_angle", "geometric_phase"), 1.0)
    if motion.kind == "free-body":
        return {**turns, "solid_angle": 2.0 * np.pi, "geometric_phase": 2.0 * np.pi, "action": motion.momentum_norm}
    size = float(np.linalg.norm(motion.momentum_at_epoch))
    kinetic = 0.5 * float(np.sum(motion.momentum_at_epoch**2 / motion.moments))
    rate = 0.0 if found.nutation_period is None else 1.0 / float(found.nutation_period)
    return {**turns, "precession_rate": rate, "spin_rate": rate, "energy": kinetic + abs(float(motion.mgl)),
            "vertical_momentum": size, "axial_momentum": size}  # fmt: skip


def check_numbers(found, motion, names, case):
    for name in names:
        enclosed, double = getattr(found, name), getattr(motion, name)
        assert (enclosed is None) == (double is None), (name, case)
        if enclosed is None or not enclosed.ball.is_finite():
            assert enclosed is None or double == np.inf, (name, case)
            continue
        size = max(abs(float(enclosed)), least_sizes(found, motion).get(name, 0.0))
        with ctx.workprec(400):
            off = abs(float(enclosed.ball - arb(double)))
        assert off <= WORST_NUMBER * EPS * size + 1e-300, (name, enclosed, double, case)


def check_free_cases(cases):
    regimes = set()
    for case in cases:
        motion = ph.FreeMotion(case.moments, momentum=case.momentum)
        found = ph.certify(motion)
        regimes.add(found.regime)
        assert (found.regime, found.encircled_axis) == (motion.regime, motion.encircled_axis), case
        check_numbers(found, motion, FREE_NUMBERS, case)
        for time in (case.time, LATEST / max(np.abs(case.momentum) / np.array(case.moments).min())):
            errors = errors_of_state(found.state(time), motion.state(time), found.momentum_norm.ball)
            assert max(errors) <= WORST_ERROR, (errors, case)
    return regimes


def check_top_cases(cases):
    regimes = set()
    for case in cases:
        motion = lagrange_motion(*case[1:5])
        found = ph.certify(motion)
        regimes.add(found.regime)
        # the library's tilt stays if its limits are the same in double-double
        assert found.regime == motion.regime or "steady" in (found.regime, motion.regime), case
        if found.regime == motion.regime:
            check_numbers(found, motion, TOP_NUMBERS, case)
        with ctx.workprec(400):
            size = largest_momentum(*case[1:5])
        for time in (case.time, min(LATEST, abs(case.time))):
            errors = errors_of_state(found.state(time), motion.state(time), size if size > 0 else arb(1))
            assert max(errors) <= WORST_ERROR, (errors, case)
    return regimes


@pytest.mark.long
def test_doubles_of_bodies_lie_by_their_enclosures():
    assert len(check_free_cases(draw(4, seed=29))) >= 6


@pytest.mark.long
def test_doubles_of_tops_lie_by_their_enclosures():
    assert len(check_top_cases(draw_tops(3, seed=31))) >= 9


@pytest.mark.sweep
def test_sweep_of_doubles_and_enclosures():
    check_free_cases(draw(100, seed=30))
    check_top_cases(draw_tops(60, seed=32))


@pytest.mark.parametrize("moments", [(1.1, 1.1, 1.7), (1.7, 1.1, 1.1)])
@pytest.mark.parametrize("along", [1e-100, 1e-9, 0.3, 1e5])
def test_the_cap_of_a_symmetric_body_is_exact_anywhere(moments, along):
    """As a difference of turns, which have no bound near the equator, it came out as −1e69."""
    momentum = np.array([along, 0.7, 3.1]) if moments[0] > 1.5 else np.array([0.7, 3.1, along])
    motion = ph.FreeMotion(moments, momentum=momentum)
    found = ph.certify(motion)
    for name in ("solid_angle", "geometric_phase", "action"):
        assert abs(Fraction(getattr(motion, name)) / getattr(found, name).lower - 1) < 8 * EPS, name
    batch = ph.FreeMotion([moments] * 2, momentum=[momentum, [0.0, 1.0, 0.0]])
    assert batch.solid_angle[0] == motion.solid_angle and np.isnan(batch.solid_angle[1])


def test_a_slightly_wrong_phase_is_seen():
    motion, _ = free("short-axis")
    found = ph.certify(motion).state(1000.0)
    attitude, momentum = motion.state(1000.0)
    off = ph.rotation.multiply(np.array([np.cos(5e-15), 0.0, 0.0, np.sin(5e-15)]), attitude)
    assert max(errors_of_state(found, (attitude, momentum), 1)) < WORST_ERROR
    assert max(errors_of_state(found, (off, momentum), 1)) > WORST_ERROR


def test_both_oracles_agree_in_every_family():
    """To 60 digits, by two azimuths and two ways to Jacobi's functions: their balls overlap."""
    for case in draw(2, seed=33):
        found = ph.certify(ph.FreeMotion(case.moments, momentum=case.momentum), digits=DIGITS).state(case.time)
        wanted = reference_state(case.moments, case.momentum, case.time, bits=220)
        with ctx.workprec(400):
            pairs = zip(*(itertools.chain(*rows) for rows in (found.rotation_matrix, wanted.rotation)), strict=True)
            assert all(x.ball.overlaps(y) for x, y in pairs), case
    for case in draw_tops(2, seed=34):
        found = ph.certify(lagrange_motion(*case[1:5]), digits=DIGITS).state(case.time)
        wanted = reference_top(*case[1:], bits=220)
        pairs = zip((*found.attitude, *found.momentum), (*wanted.quaternion, *wanted.momentum), strict=True)
        assert all(x.ball.overlaps(y) for x, y in pairs), case
