"""FreeMotion against the oracle, over every nasty family, in NumPy and in JAX, in one mixed batch and one by one."""

from collections import defaultdict
from functools import cache, partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from oracle.families import Case, draw
from oracle.measures import EPS, drift_in_eps, error_in_eps
from oracle.numpy_alone import compiled_alone, numpy_alone, python_alone, under
from oracle.optimized import OPTIMIZED
from sweeping import first

WORST_ERROR = 16.0
"""eps, for every attitude entry, every entry of L/|L| and every conservation law: the promise of the library."""
SUITE_PER_FAMILY, SWEEP_PER_FAMILY, MIXED_PER_FAMILY = 50, 900, 8
"""1,200, 21,600 and 192 cases over the 24 families."""
SWEEP_SEED = 2024


def columns(cases: list[Case]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return tuple(np.array([case[i] for case in cases], dtype=np.float64) for i in (1, 2, 3))


def many_states(cases: list[Case]) -> tuple[np.ndarray, np.ndarray]:
    moments, momentum, times = columns(cases)
    return ph.FreeMotion(moments, momentum=momentum).state(times)


numpy_states, python_states, kernel_states = (
    under(alone, many_states) for alone in (numpy_alone, python_alone, compiled_alone)
)


def jax_states_one_by_one(cases: list[Case]) -> tuple[np.ndarray, np.ndarray]:
    with jax.enable_x64(True), ph.closed_forms("compiled"):
        compiled = jax.jit(lambda *case: one_state(*case), compiler_options=OPTIMIZED)
        found = [compiled(*case) for case in zip(*columns(cases), strict=True)]
        return np.array([attitude for attitude, _ in found]), np.array([momentum for _, momentum in found])


def jax_states(cases: list[Case], where="compiled") -> tuple[np.ndarray, np.ndarray]:
    with jax.enable_x64(True), ph.closed_forms(where):
        states = jax.jit(lambda *case: one_state(*case), compiler_options=OPTIMIZED)
        found = states(*(jnp.asarray(column) for column in columns(cases)))
        return np.asarray(found[0]), np.asarray(found[1])


def jax_vmapped_states(cases: list[Case], where="compiled") -> tuple[np.ndarray, np.ndarray]:
    with jax.enable_x64(True), ph.closed_forms(where):
        states = jax.jit(jax.vmap(lambda *case: one_state(*case)), compiler_options=OPTIMIZED)
        found = states(*(jnp.asarray(column) for column in columns(cases)))
        return np.asarray(found[0]), np.asarray(found[1])


def one_state(moments, momentum, time):
    return ph.FreeMotion(moments, momentum=momentum).state(time)


ENGINES = {
    "numpy": numpy_states, "kernel": kernel_states, "python": python_states, "jax": partial(jax_states, where="host"),
    "jax-vmap": partial(jax_vmapped_states, where="host"),
    "compiled-one-by-one": jax_states_one_by_one, "compiled": jax_states, "compiled-vmap": jax_vmapped_states,
}  # fmt: skip
"""The first five by default: the others are compiled for seconds."""


@cache
def drawn(count: int, seed: int) -> list[Case]:
    return draw(count, seed)


@cache
def states_of(engine: str, count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    return ENGINES[engine](drawn(count, seed))


def worst_per_family(cases: list[Case], states: tuple[np.ndarray, np.ndarray], measure) -> dict[str, tuple]:
    worst: dict[str, tuple] = defaultdict(lambda: (0.0,))
    for case, attitude, momentum in zip(cases, *states, strict=True):
        sizes = measure(attitude, momentum, case)
        before = worst[case.family]
        worst[case.family] = type(sizes)(*map(max, sizes, before if len(before) > 1 else sizes))
    return worst


def table(title: str, count: int, worst: dict[str, tuple]) -> str:
    fields = next(iter(worst.values()))._fields
    lines = [f"{title}, {count} cases, worst in eps:", " " * 28 + "".join(f"{name:>16}" for name in fields)]
    lines += [f"  {family:26}" + "".join(f"{x:16.2f}" for x in sizes) for family, sizes in worst.items()]
    return "\n".join(lines)


def assert_all_within(worst: dict[str, tuple], bound: float) -> None:
    beyond = {family: sizes for family, sizes in worst.items() if not max(sizes) <= bound}
    assert not beyond


@pytest.mark.long_cases("numpy", "kernel")
@pytest.mark.parametrize("engine", first(5, ENGINES))
def test_states_are_exact_in_every_family(engine, announce):
    cases = drawn(SUITE_PER_FAMILY, 1)
    assert len(cases) >= 1000
    worst = worst_per_family(cases, states_of(engine, SUITE_PER_FAMILY, 1), error_in_eps)
    announce(table(f"FreeMotion against the oracle, {engine}", len(cases), worst))
    assert_all_within(worst, WORST_ERROR)


@pytest.mark.parametrize("engine", first(1, ENGINES))
def test_conservation_laws_hold_at_every_time(engine, announce):
    cases = drawn(SUITE_PER_FAMILY, 1)
    worst = worst_per_family(cases, states_of(engine, SUITE_PER_FAMILY, 1), drift_in_eps)
    announce(table(f"Conservation laws, {engine}", len(cases), worst))
    assert_all_within(worst, WORST_ERROR)


@pytest.mark.sweep
@pytest.mark.parametrize("engine", ENGINES)
def test_sweep_of_all_families(engine, announce):
    cases = drawn(SWEEP_PER_FAMILY, SWEEP_SEED)
    assert len(cases) >= 20_000
    states = states_of(engine, SWEEP_PER_FAMILY, SWEEP_SEED)
    errors, drifts = (worst_per_family(cases, states, measure) for measure in (error_in_eps, drift_in_eps))
    announce(table(f"Sweep against the oracle, {engine}", len(cases), errors))
    announce(table(f"Sweep of conservation laws, {engine}", len(cases), drifts))
    assert_all_within(errors, WORST_ERROR)
    assert_all_within(drifts, WORST_ERROR)


@pytest.mark.long
@pytest.mark.parametrize("count", first(1, [2, MIXED_PER_FAMILY]))
def test_a_mixed_batch_equals_its_bodies_one_by_one(count):
    """All families and regimes in one call, by Numba and by Python; each body alone must give the same, to the bit."""
    cases = drawn(count, 5)
    attitudes, momenta = kernel_states(cases)
    others = python_states(cases)
    assert np.array_equal(attitudes, others[0]) and np.array_equal(momenta, others[1])
    for case, attitude, momentum in zip(cases, attitudes, momenta, strict=True):
        alone = ph.FreeMotion(case.moments, momentum=case.momentum).state(case.time)
        assert np.array_equal(alone[0], attitude) and np.array_equal(alone[1], momentum), case


def test_all_bodies_at_all_times_equal_the_flat_batch():
    cases = drawn(1, 6)
    moments, momentum, times = columns(cases)
    longest = 1e26 / (np.abs(momentum).max(-1) / moments.min(-1)).max()  # of the fastest body, which meets all times
    times = np.clip(times, -longest, longest)
    attitudes, momenta = ph.FreeMotion(moments[:, None], momentum=momentum[:, None]).state(times)
    count = len(cases)
    flat = ph.FreeMotion(np.repeat(moments, count, 0), momentum=np.repeat(momentum, count, 0)).state(
        np.tile(times, count)
    )
    assert np.array_equal(attitudes, flat[0].reshape(count, count, 4))
    assert np.array_equal(momenta, flat[1].reshape(count, count, 3))


def test_attitude_and_epoch_are_taken_up():
    """R(t) = R0 R_identity(t - epoch), the quaternion itself at the epoch, its sign included."""
    cases = drawn(MIXED_PER_FAMILY, 5)
    moments, momentum, times = columns(cases)
    rng = np.random.default_rng(9)
    start = rng.normal(size=(len(cases), 4))
    start /= np.linalg.norm(start, axis=-1, keepdims=True)
    motion = ph.FreeMotion(moments, momentum=momentum, attitude=start, epoch=-times)
    from_identity = ph.FreeMotion(moments, momentum=momentum).state(2 * times)  # t - epoch is exact
    attitudes, momenta = motion.state(times)
    product = quaternion_product(start, from_identity[0])
    sign = np.sign((product * attitudes).sum(-1, keepdims=True))
    assert np.abs(sign * attitudes - product).max() <= WORST_ERROR * EPS
    assert (np.abs(momenta - from_identity[1]).max(-1) / np.abs(momentum).max(-1)).max() <= WORST_ERROR * EPS
    at_epoch = motion.state(-times)
    assert np.abs(at_epoch[0] - start).max() <= WORST_ERROR * EPS
    assert (np.abs(at_epoch[1] - momentum).max(-1) / np.abs(momentum).max(-1)).max() <= WORST_ERROR * EPS


def quaternion_product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    w, v, a, u = p[:, :1], p[:, 1:], q[:, :1], q[:, 1:]
    return np.concatenate([w * a - (v * u).sum(-1, keepdims=True), w * u + a * v + np.cross(v, u)], axis=-1)


@pytest.mark.parametrize("moments", [(1.0, 2.0, 3.0), (2.0, 2.0, 2.0), (1e12, 1.0, 1e-12)])
def test_a_body_at_rest_stays(moments):
    attitude, momentum = ph.FreeMotion(moments, momentum=(0.0, 0.0, 0.0), attitude=(0.5, 0.5, -0.5, 0.5)).state(1e9)
    assert attitude.tolist() == [0.5, 0.5, -0.5, 0.5]
    assert momentum.tolist() == [0.0, 0.0, 0.0]


def test_the_bound_rejects_a_slightly_wrong_phase():
    """The same states with a phase off by 1e-14 do not pass: the comparison can fail."""
    cases = [case for case in drawn(MIXED_PER_FAMILY, 5) if case.family == "generic"]
    attitudes, momenta = numpy_states(cases)
    off = np.array([np.cos(1e-14), 0.0, 0.0, np.sin(1e-14)])
    turned = quaternion_product(np.broadcast_to(off, attitudes.shape), attitudes)
    worst = worst_per_family(cases, (turned, momenta), error_in_eps)
    assert worst["generic"].attitude > WORST_ERROR
