"""FreeMotion over every nasty family: what it conserves, mixed batches, attitude, epoch. tests/twins has the errors."""

from collections import defaultdict
from functools import cache

import numpy as np
import pytest

import polhode as ph
from oracle.measures import EPS, drift_in_eps
from oracle.numpy_alone import compiled_alone, numpy_alone, python_alone, under
from sweeping import first
from twins.families_of_bodies import Case, draw

WORST_ERROR = 16.0
"""eps: the promise of the library, for states and for every conservation law."""
MIXED_PER_FAMILY = 8


def columns(cases: list[Case]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return tuple(np.array([case[i] for case in cases], dtype=np.float64) for i in (1, 2, 3))


def many_states(cases: list[Case]) -> tuple[np.ndarray, np.ndarray]:
    moments, momentum, times = columns(cases)
    return ph.FreeMotion(moments, momentum=momentum).state(times)


numpy_states, python_states, kernel_states = (
    under(alone, many_states) for alone in (numpy_alone, python_alone, compiled_alone)
)


@cache
def drawn(count: int, seed: int) -> list[Case]:
    return draw(count, seed)


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


@pytest.mark.parametrize(("count", "seed"), [(50, 1), pytest.param(900, 2024, marks=pytest.mark.sweep)])
def test_conservation_laws_hold_at_every_time(count, seed, announce):
    cases = drawn(count, seed)
    worst = worst_per_family(cases, numpy_states(cases), drift_in_eps)
    announce(table("Conservation laws", len(cases), worst))
    assert_all_within(worst, WORST_ERROR)


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
