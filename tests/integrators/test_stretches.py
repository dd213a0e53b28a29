"""A run in stretches of its time is the run in one call, stops for Ctrl-C, and compiles once."""

import subprocess
import sys

import numpy as np
import pytest

import polhode as ph
from polhode import systems
from polhode.integrators import _equal_steps as equal_steps
from sweeping import first

BODY = systems.FreeRigidBody((1.0, 2.0, 3.0))
START = np.array([0.3, 1.8, 1.5])
SAME = 1e-13  # the steps of an interval that is cut differ in the last digit


def run(times, step, states=START):
    return ph.simulate(BODY, states, times, step=step, estimate_error=False).states


@pytest.mark.long
@pytest.mark.parametrize("states", first(1, [START * np.array([[1.0], [0.5], [2.0]]), START]), ids=["three", "one"])
def test_stretches_join_into_the_whole_run(monkeypatch, states):
    many, few = np.linspace(0.0, 10.0, 101), np.linspace(0.0, 10.0, 3)
    whole = [run(many, 0.02, states), run(few, 0.02, states)]
    monkeypatch.setattr(equal_steps, "LIMITS", equal_steps.LIMITS._replace(steps_in_call=64))
    found = [run(many, 0.02, states), run(few, 0.02, states)]
    assert np.array_equal(found[0], whole[0])
    assert np.abs(found[1] - whole[1]).max() < SAME
    # the motion backward in time goes the same way
    back = run(few[::-1], 0.02, found[1][..., -1, :])
    assert np.abs(back[..., -1, :] - states).max() < 1e2 * SAME


def test_stretches_cover_every_interval_once():
    counts = np.random.default_rng(1).integers(1, 50, size=200)
    found = equal_steps._stretches(counts, 64)
    assert [k for first, last in found for k in range(first, last)] == list(range(200))
    assert max(counts[first:last].sum() for first, last in found) < 2 * 64 + 50
    assert len(found) > 20


@pytest.mark.long
def test_an_interrupt_ends_a_long_run_soon():
    code = (
        "import os, signal, threading, numpy as np, polhode as ph\n"
        "body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))\n"
        "def run(end):\n"
        "    ph.simulate(body, (0.3, 1.8, 1.5), np.linspace(0, end, 3), step=0.01, estimate_error=False)\n"
        "run(1.0)\n"
        "threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "try:\n"
        "    run(9e7)\n"  # 9e9 steps, below the bound
        "except KeyboardInterrupt:\n"
        "    print('interrupted')\n"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert found.stdout == "interrupted\n", found.stderr[-2000:]


@pytest.mark.sweep
def test_an_interrupt_that_is_lost_in_a_callback_ends_the_run_as_well():
    """The garbage collector forgets what its callbacks raise, and JAX has one."""
    code = (
        "import os, signal, threading, gc, numpy as np, polhode as ph\n"
        "body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))\n"
        "from polhode.integrators import _equal_steps as equal_steps\n"
        "def run(end):\n"
        "    ph.simulate(body, (0.3, 1.8, 1.5), np.linspace(0, end, 3), step=0.01, estimate_error=False)\n"
        "run(1.0)\n"
        "wait, calls = equal_steps.jax.block_until_ready, []\n"
        "def collected(phase, info):\n"
        "    if phase == 'start' and len(calls) == 2:\n"
        "        calls.append(None)\n"
        "        os.kill(os.getpid(), signal.SIGINT)\n"
        "        sum(range(1000))\n"
        "def waiting(x):\n"
        "    wait(x)\n"
        "    calls.append(None)\n"
        "    gc.collect()\n"
        "equal_steps.jax.block_until_ready = waiting\n"
        "gc.callbacks.append(collected)\n"
        "try:\n"
        "    run(9e7)\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted', len(calls))\n"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert found.stdout == "interrupted 3\n", found.stderr[-2000:]
    assert "Exception ignored" in found.stderr
