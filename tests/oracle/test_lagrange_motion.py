"""LagrangeMotion against the oracle, over every nasty family, in NumPy and JAX, in one mixed batch and one by one."""

from __future__ import annotations

from collections import defaultdict
from functools import cache, lru_cache, partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from flint import arb, ctx

import polhode as ph
from oracle.lagrange import TopState, largest_momentum, reference_top
from oracle.lagrange_families import TopCase, draw_tops
from oracle.measures import EPS, rotation_of
from oracle.numpy_alone import compiled_alone, numpy_alone, python_alone, under
from oracle.optimized import OPTIMIZED
from starts import lagrange_motion
from sweeping import first

WORST_ERROR = 16.0
"""eps, for every attitude entry and every entry of L over the largest |L| of the motion: the promise of the library."""
SUITE_PER_FAMILY, SWEEP_PER_FAMILY, MIXED_PER_FAMILY = 8, 250, 3
"""224, 7,000 and 84 cases over the 28 families."""


class TopErrors(NamedTuple):
    """Largest error of an attitude entry, of a signed quaternion entry, and of L over the largest |L|, in eps."""

    attitude: float
    quaternion: float
    momentum: float


@lru_cache(maxsize=20_000)
def reference(case: TopCase) -> tuple[TopState, arb]:
    state = reference_top(*case[1:])
    with ctx.workprec(400):
        return state, largest_momentum(*case[1:5])


def errors(attitude: np.ndarray, momentum: np.ndarray, case: TopCase) -> TopErrors:
    state, size = reference(case)
    with ctx.workprec(400):
        found, wanted = rotation_of(attitude), rotation_of(state.quaternion)
        entries = [abs(a - b) for x, y in zip(found, wanted, strict=True) for a, b in zip(x, y, strict=True)]
        signed = [abs(arb(float(a)) - b) for a, b in zip(attitude, state.quaternion, strict=True)]
        over = size if size > 0 else arb(1)
        moved = [abs(arb(float(a)) - b) / over for a, b in zip(momentum, state.momentum, strict=True)]
        return TopErrors(*(max(float(v) / EPS if v.is_finite() else np.inf for v in part)
                           for part in (entries, signed, moved)))  # fmt: skip


def columns(cases: list[TopCase]) -> tuple[np.ndarray, ...]:
    return tuple(np.array([case[i] for case in cases], dtype=np.float64) for i in range(1, 6))


def many_states(cases: list[TopCase]) -> tuple[np.ndarray, np.ndarray]:
    *top, times = columns(cases)
    return lagrange_motion(*top).state(times)


numpy_states, python_states, kernel_states = (
    under(alone, many_states) for alone in (numpy_alone, python_alone, compiled_alone)
)


def one_state(moments, mgl, momentum, attitude, time):
    return ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude).state(time)


def jax_states(cases: list[TopCase], where="compiled") -> tuple[np.ndarray, np.ndarray]:
    with jax.enable_x64(True), ph.closed_forms(where):
        states = jax.jit(lambda *case: one_state(*case), compiler_options=OPTIMIZED)
        found = states(*map(jnp.asarray, columns(cases)))
        return np.asarray(found[0]), np.asarray(found[1])


def jax_vmapped_states(cases: list[TopCase], where="compiled") -> tuple[np.ndarray, np.ndarray]:
    with jax.enable_x64(True), ph.closed_forms(where):
        states = jax.jit(jax.vmap(lambda *case: one_state(*case)), compiler_options=OPTIMIZED)
        found = states(*map(jnp.asarray, columns(cases)))
        return np.asarray(found[0]), np.asarray(found[1])


ENGINES = {
    "numpy": numpy_states, "kernel": kernel_states, "python": python_states, "jax": partial(jax_states, where="host"),
    "jax-vmap": partial(jax_vmapped_states, where="host"),
    "compiled": jax_states, "compiled-vmap": jax_vmapped_states,
}  # fmt: skip


@cache
def drawn(count: int, seed: int) -> list[TopCase]:
    return draw_tops(count, seed)


@cache
def states_of(engine: str, count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    return ENGINES[engine](drawn(count, seed))


def worst_per_family(cases, states) -> dict[str, TopErrors]:
    worst: dict[str, TopErrors] = defaultdict(lambda: TopErrors(0.0, 0.0, 0.0))
    for case, attitude, momentum in zip(cases, *states, strict=True):
        worst[case.family] = TopErrors(*map(max, errors(attitude, momentum, case), worst[case.family]))
    return worst


def table(title: str, count: int, worst: dict[str, TopErrors]) -> str:
    lines = [f"{title}, {count} cases, worst in eps:", " " * 28 + "".join(f"{n:>12}" for n in TopErrors._fields)]
    return "\n".join([*lines, *(f"  {f:26}" + "".join(f"{x:12.2f}" for x in v) for f, v in worst.items())])


def check(engine: str, count: int, seed: int, announce) -> None:
    cases = drawn(count, seed)
    worst = worst_per_family(cases, states_of(engine, count, seed))
    announce(table(f"LagrangeMotion against the oracle, {engine}", len(cases), worst))
    assert not {family: sizes for family, sizes in worst.items() if not max(sizes) <= WORST_ERROR}


@pytest.mark.long_cases("numpy", "kernel", "jax", "jax-vmap")
@pytest.mark.parametrize("engine", first(5, ["numpy", "kernel", "python", "jax", "jax-vmap", "compiled"]))
def test_states_are_exact_in_every_family(engine, announce):
    assert len(drawn(SUITE_PER_FAMILY, 1)) >= 200
    check(engine, SUITE_PER_FAMILY, 1, announce)


@pytest.mark.sweep
@pytest.mark.parametrize("engine", ENGINES)
def test_sweep_of_all_families(engine, announce):
    check(engine, SWEEP_PER_FAMILY, 2024, announce)


def test_the_bound_rejects_a_slightly_wrong_phase():
    cases = [case for case in drawn(SUITE_PER_FAMILY, 1) if case.family == "generic"]
    attitudes, momenta = numpy_states(cases)
    off = np.array([np.cos(1e-14), 0.0, 0.0, np.sin(1e-14)])
    assert worst_per_family(cases, (ph.rotation.multiply(off, attitudes), momenta))["generic"].attitude > WORST_ERROR


@pytest.mark.long
@pytest.mark.parametrize("count", [3, pytest.param(MIXED_PER_FAMILY, marks=pytest.mark.sweep)])
def test_a_mixed_batch_equals_its_tops_one_by_one(count):
    """By Numba and by Python, to the bit."""
    cases = drawn(count, 5)
    attitudes, momenta = kernel_states(cases)
    others = python_states(cases)
    assert np.array_equal(attitudes, others[0]) and np.array_equal(momenta, others[1])
    for case, attitude, momentum in zip(cases, attitudes, momenta, strict=True):
        alone = lagrange_motion(*case[1:5]).state(case.time)
        assert np.array_equal(alone[0], attitude) and np.array_equal(alone[1], momentum), case


def test_the_error_does_not_grow_with_time():
    """One top of each regime at 1, 1e4, 1e8 and 1e12."""
    cases = [case._replace(time=time) for case in drawn(1, 3) for time in (1.0, 1e4, 1e8, 1e12)
             if case.family not in ("scaled", "wide_ratio", "huge_spin")]  # fmt: skip
    worst = worst_per_family(cases, numpy_states(cases))
    assert max(max(sizes) for sizes in worst.values()) <= WORST_ERROR
