"""The kernel as Python and as Numba compiles it: the same bits, and each used where it is worth its while."""

import numpy as np

from polhode import integrators, simulate, systems
from polhode.taylor import kernels


def motions():
    """Return states of motions of three systems."""
    turning = systems.FreeRigidBody((1.0, 2.0, 3.0))
    top = systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (0.0, 0.6, 0.8))
    vortices = systems.PlaneVortices(np.array([1.0, -0.7, 0.4]))
    starts = [
        (turning, np.array([0.3, 1.9, 0.1])), (top, np.array([1.0, 0, 0, 0, 0.5, 1.0, 2.0, 0, 0, 1.0])),
        (vortices, vortices.pack([[0.0, 0.0], [1.0, 0.2], [-0.3, 0.9]])),
    ]  # fmt: skip
    return [simulate(system, start, np.linspace(0.0, 3.0, 7), integrators.Taylor, throw=False).states
            for system, start in starts]  # fmt: skip


def test_compiled_or_not_the_bits_are_the_same(monkeypatch):
    monkeypatch.setattr(kernels._Spent, "compiled", False)
    monkeypatch.setattr(kernels, "LOADED", np.inf)
    plain = motions()
    kernels.use_compiled_kernel()
    for one, other in zip(plain, motions(), strict=True):
        np.testing.assert_array_equal(one, other)


def test_long_runs_are_compiled_and_short_ones_are_not(monkeypatch):
    monkeypatch.setattr(kernels._Spent, "compiled", False)
    monkeypatch.setattr(kernels, "_is_on_disk", lambda: False)
    for seconds, use in ((0.0, kernels.python_kernel), (1.9, kernels.python_kernel), (2.1, kernels.compiled_kernel)):
        monkeypatch.setattr(kernels._Spent, "seconds", seconds)
        assert kernels.chosen_kernel() is use()


def test_functions_call_each_other_as_they_are_made():
    """One that was left with the names of its own file would call what is not compiled."""
    space = kernels._joined(lambda function, name: function, {})
    own = [value for value in space.values() if getattr(value, "__globals__", None) is space]
    assert len(own) >= 14 and space["advance"] in own and space["first_zero"] in own and space["gather"] in own


def test_what_was_compiled_of_other_sources_is_not_used(monkeypatch):
    """The name under which Numba keeps it changes with each of the files."""
    before = kernels.compiled_kernel.__wrapped__().advance.__qualname__
    monkeypatch.setattr(kernels.zlib, "crc32", lambda data: 1)
    assert kernels.compiled_kernel.__wrapped__().advance.__qualname__ != before
