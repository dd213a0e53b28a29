"""One motion, made again and again: it takes plain numbers, and gives the bits of arrays."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import polhode as ph
from polhode.exact.free_body import _evaluation as evaluation
from polhode.exact.free_body import _formulas_numbers as formulas_numbers
from polhode.exact.free_body import _geometry as geometry

HOUSE = Path(ph.__file__).parent
MOST_CALLS = 95  # of polhode's functions while a motion is made; by arrays these are more than a hundred
BODIES = 60
MOMENTS, MOMENTUM = (1.0, 2.0, 3.5), (0.3, 1.0, 0.1)


def bodies() -> tuple[np.ndarray, np.ndarray]:
    """Return moments and momenta of bodies of all regimes, ordinary and extreme."""
    rng = np.random.default_rng(5)
    moments, momentum = np.exp(rng.normal(size=(BODIES, 3))), rng.normal(size=(BODIES, 3))
    moments[::6, 1] = moments[::6, 0]
    moments[1::12, :] = 2.0
    momentum[2::12, :2] = 0.0
    momentum[3::6, rng.integers(3)] *= 1e-9
    near = slice(4, None, 6)
    a, b, c = np.sort(moments[near]).T
    moments[near] = np.stack([a, b, c], axis=-1)  # almost on the separatrix, (I2 − I1) I3 L1² = (I3 − I2) I1 L3²
    momentum[near, 0], momentum[near, 2] = np.sqrt((c - b) * a), np.sqrt((b - a) * c) * (1.0 + 1e-9)
    moments[5::12] *= 1e130
    momentum[-1] = 0.0
    return moments, momentum


def differing() -> list[int]:
    """Return the bodies whose numbers are others alone than among others."""
    moments, momentum = bodies()
    among = evaluation.characteristics(moments, momentum)
    return [k for k in range(BODIES) if any(
        np.asarray(x).tobytes() != np.asarray(of_all[k]).tobytes()
        for x, of_all in zip(evaluation.characteristics(moments[k], momentum[k]), among, strict=True)
    )]  # fmt: skip


def test_numbers_of_one_body_have_the_bits_that_arrays_give():
    assert differing() == []


def test_other_bits_are_noticed(monkeypatch):
    original = formulas_numbers.numbers

    def off_by_a_rounding(*arguments: Any) -> Any:
        numbers = original(*arguments)
        return numbers._replace(period=np.nextafter(numbers.period, np.inf))

    monkeypatch.setattr(formulas_numbers, "numbers", off_by_a_rounding)
    assert len(differing()) > BODIES // 3


@pytest.mark.parametrize(("size", "by_arrays"), [(1.0, 0), (1e130, 1)])
def test_numbers_of_one_body_take_no_arrays_unless_they_are_extreme(size, by_arrays, monkeypatch):
    original, calls = geometry.characteristics, list[Any]()
    monkeypatch.setattr(geometry, "characteristics", lambda *given: calls.append(given) or original(*given))
    assert ph.FreeMotion(np.multiply(MOMENTS, size), momentum=MOMENTUM).period
    assert len(calls) == by_arrays


def calls_in(function: Callable[[], Any]) -> int:
    """Return how many of polhode's functions a second call of a function calls."""
    function()
    count = 0

    def note(frame: Any, event: str, argument: Any) -> None:
        nonlocal count
        count += event == "call" and HOUSE in Path(frame.f_code.co_filename).parents

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        function()
    finally:
        sys.setprofile(before)
    return count


def of_plain_numbers() -> Any:
    return ph.FreeMotion(MOMENTS, momentum=MOMENTUM)


def of_arrays() -> Any:
    return ph.FreeMotion(np.asarray(MOMENTS), momentum=np.asarray(MOMENTUM), attitude=np.asarray([0.6, 0.8, 0.0, 0.0]))


def a_top() -> Any:
    return ph.LagrangeMotion((2.0, 2.0, 3.5), mgl=1.3, momentum=MOMENTUM)


def one_of_a_batch() -> Any:
    """A specimen: one body as a batch of one is looked at by arrays."""
    return ph.FreeMotion([MOMENTS], momentum=[MOMENTUM])


MAKERS = [(of_plain_numbers, True), (of_arrays, True), (a_top, True), (one_of_a_batch, False)]


@pytest.mark.parametrize(("make", "by_plain_numbers"), MAKERS, ids=lambda x: getattr(x, "__name__", ""))
def test_making_one_motion_calls_few_functions(make, by_plain_numbers):
    assert (calls_in(make) <= MOST_CALLS) is by_plain_numbers
