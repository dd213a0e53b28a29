"""Derivatives of the Lagrange top against differences of the oracle at many digits, and through JAX."""

from collections import defaultdict

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from oracle.lagrange_derivatives import reference_change
from oracle.lagrange_families import draw_tops
from polhode.errors import InvalidInput

WORST = 1e-12
"""Of the Jacobian's largest entry in natural units, where the motion does not magnify errors."""
LONGEST = 6.0
"""Decades of rate × t."""
REFUSED = {"separatrix", "near_separatrix", "sleeping", "hanging", "weightless_special", "scaled", "below",
           "not_quite_unit", "planar_pendulum"}  # fmt: skip
"""Families that may hold a top without a period, or nearly so, for which long times give NaN."""
QUICK = ("generic", "cusp", "steady", "near_steady", "near_hanging", "spherical_pendulum", "below")
NEAR_THRESHOLD = 1e-10
"""Of tops beside the threshold, whose slow nutation differs from none by little that float64 holds."""
SAME = 1e-12
"""Forward against reverse mode, of the size of the entries."""


def state(p):
    """Attitude and momentum as one vector of I1, I3, mgl, momentum, attitude and time."""
    moments = jnp.stack([p[0], p[0], p[1]])
    return jnp.concatenate(ph.LagrangeMotion(moments, p[2], p[3:6], p[6:10]).state(p[10]))


def packed(cases):
    return np.array([(c.moments[0], c.moments[2], c.mgl, *c.momentum, *c.attitude, c.time) for c in cases])


def jacobians(cases):
    """Return (case, 11, 7), batched: one column at a time along a direction of all tops."""

    def states(p):
        moments = jnp.stack([p[:, 0], p[:, 0], p[:, 1]], axis=-1)
        return jnp.concatenate(ph.LagrangeMotion(moments, p[:, 2], p[:, 3:6], p[:, 6:10]).state(p[:, 10]), axis=-1)

    with jax.enable_x64(True):
        points = jnp.asarray(packed(cases))
        _, push = jax.linearize(states, points)
        return np.stack([np.asarray(push(jnp.zeros_like(points).at[:, k].set(1.0))) for k in range(11)], axis=1)


def natural_sizes(case):
    """Units in which all columns and rows are comparable."""
    I1, _, I3 = case.moments
    size = max(np.abs(case.momentum).max(), np.sqrt(abs(case.mgl) * I1)) or 1.0
    columns = np.array([I1, I3, size * size / I1, *[size] * 3, *[1.0] * 4, I1 / size])
    return columns[:, None] * np.array([*[1.0] * 4, *[1.0 / size] * 3])


def worst_by_family(cases, found):
    worst = defaultdict(float)
    for case, jacobian in zip(cases, found, strict=True):
        units = natural_sizes(case)
        wanted = np.array([reference_change(case, [float(k == j) for k in range(11)]) for j in range(11)]) * units
        error = np.abs(jacobian * units - wanted).max() / np.abs(wanted).max()
        worst[case.family] = max(worst[case.family], error)
    return worst


@pytest.fixture(scope="module")
def drawn():
    cases = [case for case in draw_tops(1, 7, LONGEST) if case.family in QUICK]
    return cases, jacobians(cases)


@pytest.mark.long
def test_derivatives_in_every_family(announce):
    """Right where finite; finite but for tops without a period, or nearly so."""
    cases = draw_tops(1, 7, LONGEST)
    found = jacobians(cases)
    check(cases, found, announce)
    for case, jacobian in zip(cases, found, strict=True):
        assert np.isfinite(jacobian).all() or (case.family in REFUSED and np.isnan(jacobian).any()), case


def test_derivatives_agree_with_the_oracle(drawn, announce):
    assert np.isfinite(drawn[1]).all()
    check(*drawn, announce)


def check(cases, found, announce):
    pairs = [(c, j) for c, j in zip(cases, found, strict=True) if np.isfinite(j).all() and "separatrix" not in c.family]
    worst = worst_by_family(*zip(*pairs, strict=True))
    lines = ["derivatives of the Lagrange top, worst of the Jacobian's size:"]
    announce("\n".join([*lines, *(f"  {family:26}{error:10.1e}" for family, error in worst.items())]))
    assert worst.pop("near_threshold", 0.0) <= NEAR_THRESHOLD
    assert not {family: error for family, error in worst.items() if not error <= WORST}


def test_a_wrong_derivative_is_caught(drawn):
    pairs = [(c, j) for c, j in zip(*drawn, strict=True) if c.family == "generic"]
    cases, found = zip(*pairs, strict=True)
    assert worst_by_family(cases, [j * (1 + 1e-11) for j in found])["generic"] > WORST


def test_reverse_mode_under_vmap_agrees_with_forward_mode(drawn):
    cases, found = drawn
    with jax.enable_x64(True):
        points = jnp.asarray(packed(cases)[:2])
        backward = np.asarray(jax.vmap(jax.jacrev(state))(points))
    for case, forward, reverse in zip(cases[:2], found[:2], backward, strict=True):
        units = natural_sizes(case)
        difference = np.abs((forward - reverse.T) * units).max()
        assert difference < SAME * np.abs(forward * units).max(), case


def test_second_derivatives_are_refused():
    with jax.enable_x64(True), pytest.raises(InvalidInput, match="first derivatives only"):
        top = ph.LagrangeMotion(jnp.array([1.0, 1.0, 0.5]), jnp.array(1.0), jnp.array([0.1, 0.2, 2.0]))
        jax.hessian(lambda t: top.state(t)[0][0])(1.0)
