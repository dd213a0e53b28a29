"""Derivatives of the Lagrange top against differences of the oracle at many digits, and through JAX."""

from collections import defaultdict

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from oracle.lagrange_derivatives import reference_change
from oracle.standing_top import standing_jacobian
from polhode.errors import InvalidInput
from starts import lagrange_motion
from sweeping import first
from twins.families_of_tops import TopCase, draw_tops

WORST = 1e-12
"""Of the Jacobian's largest entry in natural units, where the motion does not magnify errors."""
LONGEST = 6.0
"""Decades of rate × t."""
SOON, LATE = 5.0, 40.0
"""Largest rate × t on the separatrix, in the suite and in the sweep, where tops stand by then; derivatives grow like
e^t there."""
STOOD = 1e-10
"""Of a top that has gone upright, followed to |β|² = 1e-11: what rounding and the cubic term leave there."""
QUICK = ("generic", "steady", "spherical_pendulum", "below", "near_cusp", "near_vertical_passage", "sleeping",
         "weightless_special", "separatrix")  # fmt: skip
SAME = 1e-12
"""Forward against reverse mode, of the size of the entries."""
FAR = (0.3, -7.0, 180.0, 1e6, -1e12)
"""Times at which standing tops are checked, those that fall up to the third."""
UPRIGHT, DOWN, LEVEL = (1.0, 0.0, 0.0, 0.0), (0.0, 0.6, 0.8, 0.0), (0.5, 0.5, 0.5, 0.5)
STANDING = {
    "asleep": (1.1, 3.0, UPRIGHT), "unstable": (1.1, 0.4, UPRIGHT), "threshold": (0.5, 1.0, UPRIGHT),
    "below threshold": (0.5 * (1 - 1e-9), 1.0, UPRIGHT), "above": (0.5 * (1 + 1e-9), 1.0, UPRIGHT),
    "hanging": (1.1, 0.5, DOWN), "hanging at rest": (1.1, 0.0, DOWN), "below": (-1.1, 0.5, UPRIGHT),
    "unstable below": (-1.1, 0.5, DOWN), "at rest": (0.0, 0.0, LEVEL), "free": (0.0, 2.0, UPRIGHT),
}  # fmt: skip
FALLS = ("unstable", "unstable below", "above")


def drawn_tops(count, seed, longest):
    """Draw tops, those on the separatrix for times within the oracle's reach."""
    for case in draw_tops(count, seed, LONGEST):
        rate = np.abs(case.momentum).max() / case.moments[0] + np.sqrt(abs(case.mgl) / case.moments[0])
        most = longest / rate if endless(case) else np.inf
        yield case._replace(time=float(np.clip(case.time, -most, most)))


def endless(case):
    return lagrange_motion(*case[1:5]).regime == "separatrix"


def packed(cases):
    return np.array([(c.moments[0], c.moments[2], c.mgl, *c.momentum, *c.attitude, c.time) for c in cases])


def states(p):
    """Attitude and momentum as one vector (…, 7) of I1, I3, mgl, momentum, attitude and time (…, 11)."""
    moments = jnp.stack([p[..., 0], p[..., 0], p[..., 1]], axis=-1)
    return jnp.concatenate(
        ph.LagrangeMotion(moments, mgl=p[..., 2], momentum=p[..., 3:6], attitude=p[..., 6:10]).state(p[..., 10]),
        axis=-1,
    )


def jacobians(cases):
    """Return (case, 11, 7), by forward and by reverse mode, batched: one column or row at a time of all tops."""
    with jax.enable_x64(True):
        points = jnp.asarray(packed(cases))
        values, push = jax.linearize(states, points)
        pull = jax.linear_transpose(push, points)
        forward = [push(jnp.zeros_like(points).at[:, k].set(1.0)) for k in range(11)]
        backward = [pull(jnp.zeros_like(values).at[:, k].set(1.0))[0] for k in range(7)]
        return np.stack(forward, axis=1), np.stack(backward, axis=2)


def natural_sizes(case):
    """Units in which all columns and rows are comparable."""
    I1, _, I3 = case.moments
    size = max(np.abs(case.momentum).max(), np.sqrt(abs(case.mgl) * I1)) or 1.0
    columns = np.array([I1, I3, size * size / I1, *[size] * 3, *[1.0] * 4, I1 / size])
    return columns[:, None] * np.array([*[1.0] * 4, *[1.0 / size] * 3])


def error_of(case, jacobian, wanted):
    units = natural_sizes(case)
    return np.abs((jacobian - wanted) * units).max() / np.abs(wanted * units).max()


def worst_by_family(cases, found):
    worst = defaultdict(float)
    for case, jacobian in zip(cases, found, strict=True):
        ways = [[float(k == j) for k in range(11)] for j in range(11)]
        wanted = np.array([reference_change(case, way) for way in ways])
        worst[case.family] = max(worst[case.family], error_of(case, jacobian, wanted))
    return worst


def standing_tops():
    return [
        TopCase(name, (0.5, 0.5, 0.7), mgl, (0.0, 0.0, spin), attitude, time)
        for name, (mgl, spin, attitude) in STANDING.items()
        for time in (FAR[:3] if name in FALLS else FAR)
    ]


@pytest.fixture(scope="module")
def drawn():
    """Cases, and their Jacobians by both modes; standing tops last."""
    cases = [case for case in drawn_tops(1, 7, SOON) if case.family in QUICK]
    return cases, jacobians([*cases, *standing_tops()])


@pytest.mark.sweep
def test_derivatives_in_every_family(announce):
    cases = list(drawn_tops(1, 7, LATE))
    check(cases, jacobians(cases)[0], announce)


@pytest.mark.long
def test_derivatives_agree_with_the_oracle(drawn, announce):
    check(drawn[0], drawn[1][0][: len(drawn[0])], announce)


@pytest.mark.sweep
@pytest.mark.parametrize("displacement", first(1, [1e-290, 1e-100]))
def test_derivatives_of_tops_that_leave_from_next_to_nothing(displacement):
    """On the first way down and, after two ways, on the way up again, where changes shrink by half their growth."""
    I1, I3, mgl, spin = 0.8, 0.5, 1.3, 1.1
    doubling = 2.0 * I1 / np.sqrt(4.0 * mgl * I1 - spin * spin)
    cases = [
        TopCase("next_to_nothing", (I1, I1, I3), mgl, (0.3 * displacement, -0.4 * displacement, spin),
                (0.6, displacement, 0.0, 0.8), share * -np.log(displacement) * doubling)
        for share in (0.9, 1.01, -1.5)
    ]  # fmt: skip
    ways = np.eye(11)
    for case, jacobian in zip(cases, jacobians(cases)[0], strict=True):
        assert error_of(case, jacobian, np.array([reference_change(case, way) for way in ways])) < WORST


def check(cases, found, announce):
    assert np.isfinite(found).all()
    worst = worst_by_family(cases, found)
    lines = ["derivatives of the Lagrange top, worst of the Jacobian's size:"]
    announce("\n".join([*lines, *(f"  {family:26}{error:10.1e}" for family, error in worst.items())]))
    assert worst.pop("separatrix", 0.0) <= STOOD
    assert not {family: error for family, error in worst.items() if not error <= WORST}


@pytest.mark.long
def test_a_wrong_derivative_is_caught(drawn):
    pairs = [(c, j) for c, j in zip(drawn[0], drawn[1][0], strict=False) if c.family == "generic"]
    cases, found = zip(*pairs, strict=True)
    assert worst_by_family(cases, [j * (1 + 1e-11) for j in found])["generic"] > WORST


@pytest.mark.sweep
def test_standing_tops_at_any_time_follow_their_linear_equations(drawn):
    cases = standing_tops()
    for case, jacobian in zip(cases, drawn[1][0][-len(cases) :], strict=True):
        assert error_of(case, jacobian, standing_jacobian(case)) < WORST, case


@pytest.mark.sweep
def test_derivatives_stay_finite_where_a_top_goes_upright_for_ever_or_falls(drawn):
    cases = [*drawn[0], *standing_tops()]
    cases = [case._replace(time=(1e4, -1e12)[k % 2]) if endless(case) or case.family in FALLS else case
             for k, case in enumerate(cases)]  # fmt: skip
    assert np.isfinite(jacobians(cases)[0]).all()


@pytest.mark.long
def test_reverse_mode_agrees_with_forward_mode(drawn):
    cases, found = drawn
    for case, forward, reverse in zip(cases, *found, strict=False):
        assert error_of(case, reverse, forward) < SAME, case


@pytest.mark.long
def test_reverse_mode_under_vmap_and_jit_agrees_with_forward_mode(drawn):
    cases, found = drawn
    with jax.enable_x64(True):
        backward = np.asarray(jax.jit(jax.vmap(jax.jacrev(states)))(jnp.asarray(packed(cases))))
    for case, forward, reverse in zip(cases, found[0], backward, strict=False):
        assert error_of(case, reverse.T, forward) < SAME, case


FEW = (0, 1, 2, 5, 7, 10)


@pytest.mark.sweep
def test_second_derivatives_against_differences_of_the_first():
    """Central differences of order eight, at a step of its own, of a top with I1 = I2 as one quantity."""
    point = np.array([1.0, 3.0, 0.7, 0.3, 0.8, 1.5, 0.5, 0.5, -0.5, 0.5, 7.0])

    def height(x):
        attitude = states(x.at[6:10].divide(jnp.linalg.norm(x[6:10])))
        return 1.0 - 2.0 * (attitude[1] ** 2 + attitude[2] ** 2)

    with jax.enable_x64(True):
        found = np.asarray(jax.jit(jax.hessian(height))(jnp.asarray(point)))
        slope = jax.jit(jax.grad(height))
        weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
        moved = lambda k, n: np.asarray(slope(jnp.asarray(point).at[k].add(3e-3 * n)))  # noqa: E731
        wanted = [sum(w * (moved(k, n) - moved(k, -n)) for n, w in weights.items()) / 3e-3 for k in FEW]
    size = np.abs(found).max()
    assert np.abs(found[list(FEW)] - np.array(wanted)).max() < 1e-9 * size
    assert np.abs(found - found.T).max() < 1e-11 * size


def test_third_derivatives_are_refused():
    third = jax.jacfwd(jax.hessian(lambda p: states(p)[0]))
    with jax.enable_x64(True), pytest.raises(InvalidInput, match="first and second derivatives only"):
        jax.eval_shape(third, jnp.asarray(packed(standing_tops()))[0])
