"""Derivatives of the free motion against differences of the oracle with hundreds of digits, and through JAX."""

from collections import defaultdict

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from mpmath import mp

import polhode as ph
from oracle.derivatives import Direction, reference_derivative
from polhode._base.arrays.few_calls import quick_options
from polhode.errors import InvalidInput
from polhode.exact.free_body._derivative import state_tangent
from starts import free_motion
from twins.families_of_bodies import Case, draw

WORST = 1e-13
"""Relative to the size of the Jacobian's block (turn or momentum, by moments, momentum or time): the promise."""
GROWTH_SHOWN = 300.0
"""λt; a motion that starts at the saddle leaves it as e^{λt}, which is capped at e^340: there derivatives need only be
finite. The oracle's steps do not reach further either."""
UNRESOLVED = ("tiny_components",)
"""The oracle's steps are made for starts down to 1e-150: of smaller components its own error is all it shows."""
PER_FAMILY = 1
LONGEST = 12.0
"""Decades of ωt."""
BLOCKS = {"moments": range(3), "momentum": range(3, 6), "time": range(6, 7)}
SAME = 1e-14
"""Two evaluations of one formula, of size ten or so."""


def direction(k):
    unit = [float(j == k) for j in range(7)]
    return Direction(unit[:3], unit[3:6], unit[6])


def jacobian(cases):
    """Return turn and momentum derivatives (cases, 7, 3) by the exact tangent."""
    moments, momentum, time = (np.array([case[i] for case in cases]) for i in (1, 2, 3))
    count = len(cases)
    start = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    state = ph.FreeMotion(moments, momentum=momentum).state(time)
    turns, changes = [], []
    for k in range(7):
        unit = direction(k)
        change = (np.tile(unit.moments, (count, 1)), np.tile(unit.momentum, (count, 1)), 0.0 * start,
                  np.full(count, unit.time))  # fmt: skip
        with np.errstate(all="ignore"):
            d_attitude, d_momentum = state_tangent((moments, momentum, start, time), state, change)
        turns.append(2.0 * ph.rotation.multiply(ph.rotation.conjugate(state[0]), d_attitude)[:, 1:])
        changes.append(d_momentum)
    return np.stack(turns, axis=1), np.stack(changes, axis=1)


def at_the_saddle_too_long(case):
    low, middle, high = sorted(case.moments)
    rate = np.linalg.norm(case.momentum) * np.sqrt((middle - low) / low * (high - middle) / high) / middle
    return free_motion(*case[1:3]).regime in ("separatrix", "permanent") and rate * abs(case.time) > GROWTH_SHOWN


def worst_by_family(cases, found):
    worst = defaultdict(float)
    assert np.isfinite(found[0]).all() and np.isfinite(found[1]).all()
    for i, case in enumerate(cases):
        if at_the_saddle_too_long(case):
            continue
        for columns in BLOCKS.values():
            for part, name in enumerate(("turn", "momentum")):
                wanted = np.array([
                    [float(x) for x in getattr(reference_derivative(*case[1:4], direction(k)), name)] for k in columns
                ])  # fmt: skip
                got = found[part][i, list(columns)]
                size = np.abs(wanted).max() or 1.0
                worst[case.family] = max(worst[case.family], np.abs(got - wanted).max() / size)
    return worst


def check(count, seed, announce):
    cases = [case for case in draw(count, seed, LONGEST) if any(case.momentum) and case.family not in UNRESOLVED]
    worst = worst_by_family(cases, jacobian(cases))
    lines = [f"derivatives against the oracle, {len(cases)} cases, worst of the Jacobian's size:"]
    announce("\n".join([*lines, *(f"  {family:26}{error:10.1e}" for family, error in worst.items())]))
    assert not {family: error for family, error in worst.items() if not error <= WORST}


@pytest.mark.sweep
def test_derivatives_in_every_family(announce):
    check(PER_FAMILY, 5, announce)


@pytest.mark.sweep
def test_derivatives_in_a_larger_draw(announce):
    check(20, 6, announce)


@pytest.mark.long_cases("0")
@pytest.mark.parametrize("leading", [0, 1, 2])
def test_derivatives_beside_an_axis_are_those_on_it_or_none(leading):
    momenta = np.zeros((6, 3))
    momenta[:, leading], momenta[1:, (leading + 1) % 3] = 1.0, (1e-100, 1e-150, 1e-156, 1e-200, 1e-290)
    on, *beside = zip(*jacobian([Case("beside", MOMENTS, tuple(L), 2.0) for L in momenta]), strict=True)
    for k, (turn, change) in enumerate(beside):
        if leading == 1 and k > 1:
            # κ = −CS, which ties them to the saddle, has underflowed
            assert np.isnan(turn).any() and np.isnan(change).any()
        else:
            assert np.abs(turn - on[0]).max() < SAME and np.abs(change - on[1]).max() < SAME


def test_a_wrong_derivative_is_caught():
    cases = draw(1, 5, LONGEST)[:3]
    turns, changes = jacobian(cases)
    broken = turns * (1.0 + 1e-12), changes
    assert max(worst_by_family(cases, broken).values()) > WORST


def attitude_and_momentum(moments, momentum, attitude, time, epoch=0.0):
    return jnp.concatenate(ph.FreeMotion(moments, momentum=momentum, attitude=attitude, epoch=epoch).state(time))


MOMENTS, MOMENTUM, TIME = (1.0, 2.0, 3.0), (0.3, 1.8, 1.5), 7.0
ATTITUDE = (0.5, -0.5, 0.1, 0.7)


def test_by_time_jax_gives_the_rates_of_the_equations_of_motion():
    """q̇ = ½ q ω and L̇ = L × ω, of one motion; by all that makes a motion, compiled for half a minute, in the sweep."""
    motion = ph.FreeMotion(MOMENTS, momentum=MOMENTUM)
    with jax.enable_x64(True):
        by_time = jax.jit(lambda t: jax.jvp(motion.state, (t,), (jnp.ones(()),)), compiler_options=quick_options())
        (attitude, momentum), rates = jax.tree.map(np.asarray, by_time(jnp.asarray(TIME)))
    velocity = motion.angular_velocity(TIME)
    assert np.abs(rates[0] - 0.5 * ph.rotation.multiply(attitude, np.array([0.0, *velocity]))).max() < SAME
    assert np.abs(rates[1] - np.cross(momentum, velocity)).max() < SAME


@pytest.fixture(scope="module")
def by_jax():
    with jax.enable_x64(True):
        attitude = np.array(ATTITUDE) / np.linalg.norm(ATTITUDE)
        arguments = tuple(map(jnp.asarray, (MOMENTS, MOMENTUM, attitude, TIME)))
        forward = jax.jit(jax.jacfwd(attitude_and_momentum, argnums=(0, 1, 2, 3)))(*arguments)
        backward = jax.jit(jax.jacrev(attitude_and_momentum, argnums=(0, 1, 2, 3)))(*arguments)
        return arguments, [np.asarray(x) for x in forward], [np.asarray(x) for x in backward]


@pytest.mark.long
def test_forward_and_reverse_mode_agree(by_jax):
    _, forward, backward = by_jax
    for a, b in zip(forward, backward, strict=True):
        assert np.abs(a - b).max() < SAME


def test_jax_gives_the_exact_tangent(by_jax):
    (moments, momentum, attitude, time), forward, _ = by_jax
    values = tuple(map(np.asarray, (moments, momentum, attitude, time)))
    state = free_motion(*values[:3]).state(values[3])
    for k in range(7):
        unit = direction(k)
        change = (np.array(unit.moments), np.array(unit.momentum), np.zeros(4), np.array(unit.time))
        with np.errstate(all="ignore"):
            wanted = np.concatenate(state_tangent(values, state, change))
        block = 0 if k < 3 else 1 if k < 6 else 3
        got = forward[block] if block == 3 else forward[block][:, k % 3]
        assert np.abs(got - wanted).max() < 10 * SAME


def test_the_attitude_passes_its_change_on(by_jax):
    (moments, momentum, attitude, time), forward, _ = by_jax
    turn = np.array([0.0, 0.3, -0.2, 0.5])
    change = ph.rotation.multiply(turn, np.asarray(attitude))
    later = free_motion(*map(np.asarray, (moments, momentum, attitude))).attitude(float(time))
    assert np.abs(forward[2][:4] @ change - ph.rotation.multiply(turn, later)).max() < SAME
    # a longer quaternion is the same attitude
    assert np.abs(forward[2] @ np.asarray(attitude)).max() < SAME


def test_vmap_of_grad_where_formulas_divide_by_zero():
    starts = np.array([[0.0, 0, 0], [0, 2, 0], [0, 0, 2], [2, 0, 0], [1, 0, 1], [1.0, 2, 3]])
    bodies = np.array([[1.0, 2, 3], [2, 2, 2], [2, 2, 3], [1, 3, 3], [3, 4, 6]])
    with jax.enable_x64(True):

        def size(moments, momentum, time):
            return attitude_and_momentum(moments, momentum, jnp.array([1.0, 0, 0, 0]), time).sum()

        gradient = jax.grad(size, argnums=(0, 1, 2))
        every = jax.jit(jax.vmap(jax.vmap(gradient, (None, 0, None)), (0, None, None)))
        for part in every(jnp.asarray(bodies), jnp.asarray(starts), jnp.asarray(3.0)):
            assert np.isfinite(np.asarray(part)).all()


@pytest.mark.long
def test_epoch_and_time_are_opposite():
    with jax.enable_x64(True):
        arguments = (jnp.asarray(MOMENTS), jnp.asarray(MOMENTUM), jnp.array([1.0, 0, 0, 0]), jnp.asarray(TIME))
        by_time = jax.jacfwd(attitude_and_momentum, argnums=3)(*arguments, jnp.asarray(2.0))
        by_epoch = jax.jacfwd(attitude_and_momentum, argnums=4)(*arguments, jnp.asarray(2.0))
        assert np.abs(np.asarray(by_time + by_epoch)).max() < SAME


@pytest.mark.sweep
def test_second_derivatives_against_differences_of_the_first():
    """Central differences of order eight at a step of their own, from a generic start and beside the saddle."""
    for momentum in (MOMENTUM, (1e-4, 2.0, -1e-4)):
        point = np.array([*MOMENTS, *momentum, 4.0])
        height = lambda x: ph.FreeMotion(x[:3], momentum=x[3:6]).rotation_matrix(x[6])[2, 0]  # noqa: E731
        with jax.enable_x64(True):
            found = np.asarray(jax.jit(jax.hessian(height))(jnp.asarray(point)))
            slope = jax.jit(jax.grad(height))
            weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
            moved = lambda k, n: np.asarray(slope(jnp.asarray(point).at[k].add(2e-4 * n)))  # noqa: B023, E731
            wanted = [sum(w * (moved(k, n) - moved(k, -n)) for n, w in weights.items()) / 2e-4 for k in range(7)]
        size = np.abs(found).max()
        assert np.abs(found - np.array(wanted)).max() < 1e-9 * size and np.abs(found - found.T).max() < 1e-11 * size


def test_third_derivatives_are_refused():
    with jax.enable_x64(True), pytest.raises(InvalidInput, match="first and second derivatives only"):
        body = lambda t: ph.FreeMotion(jnp.asarray(MOMENTS), momentum=jnp.asarray(MOMENTUM)).attitude(t)[0]  # noqa: E731
        jax.eval_shape(jax.grad(jax.grad(jax.grad(body))), TIME)


@pytest.mark.long
def test_a_motion_passes_through_jit_and_vmap():
    with jax.enable_x64(True):
        many = jax.vmap(lambda momentum: ph.FreeMotion(jnp.asarray(MOMENTS), momentum=momentum))(jnp.eye(3) + 0.1)
        states = jax.jit(jax.vmap(lambda motion: motion.state(TIME)[0]))(many)
    wanted = ph.FreeMotion(MOMENTS, momentum=np.eye(3) + 0.1).attitude(TIME)
    assert np.abs(np.asarray(states) - wanted).max() < SAME


def numbers_of(*x):
    """Modulus, period, precession rate, precession per period and solid angle by the textbook's complete integrals."""
    moments, L = x[:3], x[3:]
    size2 = sum(v * v for v in L)
    energy2 = sum(v * v / i for v, i in zip(L, moments, strict=True))
    long_axis = energy2 * moments[1] > size2
    (a1, l1), (a2, l2), (a3, l3) = [(1 / i, v) for i, v in zip(moments, L, strict=True)][:: -1 if long_axis else 1]
    sense = -1 if long_axis else 1
    A, B, C = sense * (a1 - a2), sense * (a2 - a3), sense * (a1 - a3)
    P, Q = C * l1**2 + B * l2**2, A * l2**2 + C * l3**2
    m = A * P / (B * Q)
    period = 4 * mp.ellipk(m) / mp.sqrt(B * Q)
    # φ̇ = |L| (a1 L1² + a2 L2²)/(L1² + L2²) with L1² = P/C cn², L2² = P/B sn²
    n = 1 - C / B
    share = C / (C - B) * (1 - mp.ellippi(n, m) / mp.ellipk(m))
    rate = mp.sqrt(size2) * (a1 + (a2 - a1) * share)
    angle = sense * (energy2 / mp.sqrt(size2) - rate) * period + 2 * mp.pi
    return mp.sqrt(m), period, rate, rate * period, angle


@pytest.mark.long_cases("short axis")
@pytest.mark.parametrize("momentum", [
    (0.3, 1.8, 1.5), (1.5, 0.4, 0.2), (1e-5, -2e-5, 1.0), (1e-3, 1.0, 1.001e-3), (1.0, 1e-7, 0.0)
], ids=["short axis", "long axis", "beside an axis", "near the saddle", "beside the long axis"])  # fmt: skip
def test_derivatives_of_the_numbers(momentum):
    """Against differences of the textbook's formulas with 60 digits, relative to the largest of each number."""
    names = ("modulus", "period", "precession_rate", "precession_per_period", "solid_angle")
    with jax.enable_x64(True):
        numbers = lambda I, L: jnp.stack([getattr(ph.FreeMotion(I, momentum=L), name) for name in names])  # noqa: E731, E741
        found = np.concatenate(jax.jacfwd(numbers, argnums=(0, 1))(*map(jnp.asarray, (MOMENTS, momentum))), axis=1)
    with mp.workdps(60):
        point = [*map(mp.mpf, MOMENTS), *map(mp.mpf, momentum)]
        values = [float(x) for x in numbers_of(*point)]
        assert values == pytest.approx(
            [getattr(ph.FreeMotion(MOMENTS, momentum=momentum), name) for name in names], rel=1e-13
        )
        along = lambda j, h: numbers_of(*(x + (h if k == j else 0) for k, x in enumerate(point)))  # noqa: E731
        h = mp.mpf(10) ** -25
        wanted = [[float((a - b) / (2 * h)) for a, b in zip(along(j, h), along(j, -h), strict=True)] for j in range(6)]
    wanted = np.array(wanted).T
    sizes = np.abs(wanted).max(axis=1, keepdims=True)
    assert np.abs((found - wanted) / sizes).max() < 1e-13
    assert np.abs((found * [1, 1, 1 + 1e-12, 1, 1, 1] - wanted) / sizes).max() > 1e-13


def test_meaning_has_derivatives_in_either_mode():
    """∂T against differences of the textbook formula with 40 digits; 2π dJ/T = Ω · dL − (ω − 2π/T) d|L| at fixed I."""
    moments, momentum = (1.0, 2.0, 3.0), (0.3, 1.8, 1.5)
    with jax.enable_x64(True):
        arrays = jnp.array(moments), jnp.array(momentum)
        answers = lambda I, L: jnp.stack([ph.FreeMotion(I, momentum=L).period, ph.FreeMotion(I, momentum=L).action])  # noqa: E731, E741
        of_moments, of_momentum = jax.jit(jax.jacrev(answers, argnums=(0, 1)))(*arrays)
        way = jnp.array([0.1, 0.7, -0.4])
        forward = jax.jit(lambda I, L, d: jax.jvp(lambda x: answers(I, x), (L,), (d,))[1])(*arrays, way)[1]  # noqa: E741
    found, reverse = (of_moments[0], of_momentum[0]), of_momentum[1]

    def period(*x):
        (i1, i2, i3), (l1, l2, l3) = x[:3], x[3:]
        p = i2 * (i3 - i1) * l1**2 + i1 * (i3 - i2) * l2**2
        q = i3 * (i2 - i1) * l2**2 + i2 * (i3 - i1) * l3**2
        a, b = i3 * (i2 - i1), i1 * (i3 - i2)
        return 4 * mp.ellipk(a * p / (b * q)) * i1 * i2 * i3 / mp.sqrt(b * q)

    with mp.workdps(40):
        point = (*moments, *momentum)
        wanted = [float(mp.diff(period, point, tuple(int(j == k) for j in range(6)))) for k in range(6)]
    assert np.concatenate(found) == pytest.approx(wanted, rel=1e-12)

    plain, L = ph.FreeMotion(moments, momentum=momentum), np.array(momentum)
    long_axis_rate = plain.precession_rate - 2 * np.pi / plain.period
    by_hand = plain.period / (2 * np.pi) * (L / moments - long_axis_rate * L / np.linalg.norm(L))
    assert np.asarray(reverse) == pytest.approx(by_hand, rel=1e-12)
    assert float(forward) == pytest.approx(by_hand @ [0.1, 0.7, -0.4], rel=1e-12)
