"""What a second motion of the same structure takes: nothing is traced or compiled, and few modules are looked at."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph

TRACED, COMPILED = "jaxpr_trace_duration", "backend_compile_duration"
MADE, FLATTENED, CALLED = "modules made", "modules flattened", "functions of polhode called"
EQUINOX = "_module.py"
TIMES = np.array([0.0, 2.0])
TOP = ph.systems.HeavyTop((1.0, 2.0, 3.5), 1.3, (0.6, 0.0, 0.8))
STATE = np.array([1.0, 0.0, 0.0, 0.0, 0.3, 2.0, 0.35, 0.0, 0.0, 1.0])
# of one motion with its estimate; once 19 modules were made, one for each method that was called, and 111 flattened
MOST = {TRACED: 0, COMPILED: 0, MADE: 0, FLATTENED: 0}
OURS = f"{Path(ph.__file__).parent}{os.sep}"
RUN = "run_copies"  # whose own steps may be Python's
MOST_CALLED = 240  # around the run of a motion without estimate: 199 of the top; once 1,034
inside = [0]
noted: Counter[str] = Counter()


def note_duration(event: str, duration_secs: float, **others: Any) -> None:
    noted[event.rpartition("/")[2]] += 1


jax.monitoring.register_event_duration_secs_listener(note_duration)


def note_call(frame: Any, event: str, argument: Any) -> None:
    code = frame.f_code
    if code.co_name == RUN:
        inside[0] += {"call": 1, "return": -1}.get(event, 0)
    if event != "call":
        return
    noted[CALLED] += OURS in code.co_filename and not inside[0]  # not what checks annotations
    if code.co_name == "__call__" and code.co_filename.endswith(EQUINOX):
        noted[MADE] += 1
    elif code.co_filename.startswith("<generated_flatten"):
        noted[FLATTENED] += 1


def work_of(function: Callable[[], Any]) -> Counter[str]:
    """Return how much of what a call did."""
    before = sys.getprofile()
    noted.clear()
    sys.setprofile(note_call)
    try:
        function()
    finally:
        sys.setprofile(before)
    return noted.copy()


def too_much(work: Counter[str]) -> list[str]:
    return [name for name, most in MOST.items() if work[name] > most]


def same_top() -> Any:
    return ph.simulate(TOP, STATE, TIMES)


def another_closure() -> Any:
    """A specimen: Hamilton's function is another one at each call, which is traced."""
    return ph.simulate(ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: jnp.sum(L**2)), STATE[4:7], TIMES)


@pytest.mark.parametrize(("move", "is_kept"), [(same_top, True), (another_closure, False)])
def test_a_second_motion_traces_and_compiles_nothing(move, is_kept):
    for _ in range(2):
        move()
    assert (too_much(work_of(move)) == []) is is_kept


@pytest.mark.parametrize("of_new_closure", [False, True])
def test_a_second_motion_calls_few_functions_around_its_run(of_new_closure):
    def move() -> Any:
        if of_new_closure:  # a specimen, whose structure is looked at anew
            return ph.simulate(ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: jnp.sum(L**2)), STATE[4:7], TIMES,
                               estimate_error=False)
        return ph.simulate(TOP, STATE, TIMES, estimate_error=False)

    for _ in range(2):
        move()
    assert (work_of(move)[CALLED] <= MOST_CALLED) is not of_new_closure


@pytest.mark.parametrize("last", [3.9, 3.5], ids=["other numbers", "equal numbers"])
def test_a_motion_of_another_system_of_the_same_structure_traces_and_compiles_nothing(last):
    def move(moment: float) -> Any:
        return ph.simulate(ph.systems.HeavyTop((1.0, 2.0, moment), 1.3, (0.6, 0.0, 0.8)), STATE, TIMES)

    for moment in (3.5, 3.7):
        move(moment)
    work = work_of(lambda: move(last))
    assert work[TRACED] == work[COMPILED] == 0
