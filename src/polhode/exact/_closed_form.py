"""Runs a closed form's kernels, by Python for little work and compiled for much, to the same bits.

For one body at a few times, neither loading nor compiling is worth it. Where nothing is compiled, NumPy takes much
work, by the array forms that JAX traces too: a tenth of Python's time, so that compiling is worth it for millions of
bodies.
"""

from __future__ import annotations

import importlib
import math
import pkgutil
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from polhode._base.compiled.kernel_modules import KernelModules, is_worth
from polhode._base.compiled.threads import in_threads
from polhode.exact import _kernel_loops as kernel_loops
from polhode.exact._blocks import Columns, Vectors, columns_in_blocks, flatten_motion
from polhode.exact._kernel_arithmetic import BLOCK
from polhode.types import Array, Float64

COMMON = tuple(f"polhode.exact.{name}" for name in (
    "_kernel_arithmetic", "_kernel_records", "_kernel_agm", "_formulas", "_kernel_loops",
))
ROWS = 8192  # states at a time by NumPy, whose temporaries then stay in the cache; worth a thread, as bodies are
AT_ONCE = 8 * BLOCK  # bodies whose constants stay in the cache until their states are computed: .8 MB
ARITHMETIC = "polhode.exact._compiled_arithmetic"  # which imports Numba
State = tuple[float, float, float, float, float, float, float]


class Cost(NamedTuple):
    """About how long a state or the set-up of a body takes without compiled code [s]."""

    one: float  # by Python
    calls: float  # by NumPy, for however few
    each: float  # by NumPy, and for each of many

    def time(self, count: int) -> float:
        """Return the time of the quicker of the two."""
        return self.calls + self.each * count if self.is_for_numpy(count) else self.one * count

    def is_for_numpy(self, count: int) -> bool:
        return self.calls + self.each * count < self.one * count


STATE, SET_UP = Cost(7e-6, 4e-4, 5e-7), Cost(1.5e-4, 5e-3, 3e-6)


class CompilingTimes(NamedTuple):
    """About how long compiling a kernel takes [s]: after so much time without it, it is worth it."""

    set_up: float = 10.0
    states_of_one: float = 1.5
    states_of_many: float = 2.5


COMPILING = CompilingTimes()._asdict()


class Kernels(NamedTuple):
    """Functions that Python runs, of one body and one time; the kernels describe each."""

    unflatten: Callable[..., Any]
    state_at: Callable[..., State]
    set_up_one: Callable[..., Any]


class Compiled(NamedTuple):
    """Functions that are compiled, of many."""

    set_up: Callable[..., None]
    states_of_one: Callable[..., None]
    states_of_many: Callable[..., None]


class ClosedForm:
    """The kernels of a motion in closed form.

    Args:
        package: with ``_formulas``, ``_kernel_setup`` and what these need.
        prepare: returns the columns of bodies that the kernels leave to NumPy.
    """

    def __init__(self, package: str, prepare: Callable[..., Columns]) -> None:
        self._package, self._prepare = package, prepare
        self._spent, self._ready = dict.fromkeys(COMPILING, 0.0), set[str]()
        self._latest: tuple[Any, Any] = (), None  # numbers of a motion, and the motion

    @cached_property
    def _modules(self) -> KernelModules:
        path = importlib.import_module(self._package).__path__
        own = sorted(name for _, name, _ in pkgutil.iter_modules(path) if name.startswith(("_kernel", "_formulas")))
        modules = [importlib.import_module(name) for name in (*COMMON, *(f"{self._package}.{name}" for name in own))]
        numba = lambda: importlib.import_module(ARITHMETIC).FOR_NUMBA  # noqa: E731
        return KernelModules(self._package.rpartition(".")[2], "closed forms", modules, numba, [ARITHMETIC])

    @cached_property
    def _python(self) -> Kernels:
        spaces = self._modules.by_python()
        setup, loops = spaces[f"{self._package}._kernel_setup"], spaces[kernel_loops.__name__]
        return Kernels(loops["unflatten"], loops["state_at"], setup["set_up_one"])

    @cached_property
    def _compiled(self) -> Compiled:
        return Compiled(*(self._modules.entry(name) for name in Compiled._fields))

    @cached_property
    def _sizes(self) -> tuple[int, int]:
        """How many constants a motion has, and for how many bodies a thread is worth its start."""
        formulas, setup = (importlib.import_module(f"{self._package}.{x}") for x in ("_formulas", "_kernel_setup"))
        return formulas.COLUMNS, setup.WORTH

    def _is_worth(self, name: str, seconds: float) -> bool:
        """Return whether a compiled kernel is there, or worth it for work that takes so long without."""
        if name not in self._ready:
            spent = self._spent[name] + seconds
            if is_worth(spent, COMPILING[name], lambda: self._modules.is_on_disk(name)):
                self._ready.add(name)
        return name in self._ready

    # ------------------------------------------------------------------ set-up

    def columns(self, arguments: Vectors) -> Float64[np.ndarray, "columns *bodies"]:
        """Return the constants of the motions of bodies, arrays (…, k) that broadcast against each other."""
        shape, flat = _flatten(arguments)
        count = math.prod(shape)
        columns, left = np.empty((self._sizes[0], count)), np.ones(count, bool)
        if self._is_worth("set_up", seconds := SET_UP.time(count)):
            self._set_up_many(flat, columns, left)
        else:
            self._spent["set_up"] += seconds
            if SET_UP.is_for_numpy(count):
                in_threads(lambda low, high: self._set_up_rows(slice(low, high), flat, columns), count, ROWS)
                left[:] = False
            else:
                for k in range(count):
                    self._set_up_one([v[k] for v in flat], k, columns, left)
        if left.any():
            self._set_up_rows(left, flat, columns)
        return columns.reshape(len(columns), *shape)

    def _set_up_rows(self, rows: Any, flat: Sequence[Array], columns: Array) -> None:
        for column, values in zip(columns, columns_in_blocks(self._prepare, tuple(v[rows] for v in flat)), strict=True):
            column[rows] = values

    def _set_up_many(self, flat: Sequence[Array], columns: Array, left: Array) -> None:
        inputs = [_own(v) for v in flat]
        fill = lambda low, high: self._compiled.set_up(  # noqa: E731
            *(v[low:high] for v in inputs), columns, left[low:high], low  # whole, as parts of rows are strided
        )
        in_threads(fill, len(left), self._sizes[1])

    def _set_up_one(self, inputs: list[Array], k: int, columns: Array, left: Array) -> None:
        try:
            motion = self._python.set_up_one(*(tuple(v.tolist()) for v in inputs))
        except (ArithmeticError, ValueError):  # beyond doubles, which Numba's kernel leaves to NumPy too
            return
        if motion is not None:
            columns[:, k], left[k] = flatten_motion(motion), False

    # ------------------------------------------------------------------ states

    def state(self, column: Sequence[float], time: float, rest: float) -> State:
        """Return attitude and momentum of one body at a time since the epoch, given in two parts."""
        kept, motion = self._latest
        if kept is not column:  # the states of one body are computed again and again
            motion = self._python.unflatten(column)
            self._latest = column, motion
        try:
            return self._python.state_at(motion, time, rest)
        except (ArithmeticError, ValueError):
            attitude, momentum = np.empty((1, 4)), np.empty((1, 3))
            self._of_one(column, np.array([time]), np.array([rest]), attitude, momentum)
            return (*attitude[0].tolist(), *momentum[0].tolist())

    def states(
        self, columns: Float64[np.ndarray, "columns *bodies"], elapsed: Float64[Array, "..."],
        rest: Float64[Array, "..."],
    ) -> tuple[Float64[np.ndarray, "*shape 4"], Float64[np.ndarray, "*shape 3"]]:
        """Return attitude (…, 4) and momentum (…, 3) at times since the epoch, which broadcast against the bodies."""
        batch = np.shape(columns)[1:]
        shape = np.broadcast_shapes(batch, np.shape(elapsed))
        times, rests = (_own(np.broadcast_to(x, shape)).reshape(-1) for x in (elapsed, rest))
        count = math.prod(batch)
        flat = columns.reshape(len(columns), count)
        name = "states_of_one" if count == 1 else "states_of_many"
        compiled = self._is_worth(name, seconds := STATE.time(len(times)))
        self._spent[name] += 0.0 if compiled else seconds
        bodies = None if count == 1 else np.broadcast_to(np.arange(count).reshape(batch), shape).reshape(-1)
        outputs = np.empty((len(times), 4)), np.empty((len(times), 3))  # apart, as strided ones would not do for others
        if not compiled and STATE.is_for_numpy(len(times)):
            self._by_arrays(flat, bodies, times, rests, *outputs)
        elif not compiled:
            self._by_python(flat, bodies, times, rests, *outputs)
        elif bodies is None:
            self._of_one(flat[:, 0].tolist(), times, rests, *outputs)
        else:
            self._of_many(flat, bodies, times, rests, *outputs)
        return outputs[0].reshape(*shape, 4), outputs[1].reshape(*shape, 3)

    # ------------------------------------------------------------------ both

    def states_of(
        self, motion: Any, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
    ) -> tuple[Float64[np.ndarray, "*shape 4"], Float64[np.ndarray, "*shape 3"]]:
        """Return ``states`` of a motion, which keeps the constants of many bodies from its second call on.

        They are seven times as large as states: to touch so much memory for the first time takes longer than set-up.
        """
        kept = vars(motion)
        if "_columns" not in kept and "_was_asked" not in kept:
            kept["_was_asked"] = True
            if self._is_at_once(motion._arguments, elapsed):
                return self._states_at_once(motion._arguments, elapsed, rest)
        return self.states(motion._columns, elapsed, rest)

    def _is_at_once(self, arguments: Vectors, elapsed: Float64[Array, "..."]) -> bool:
        """Return whether kernels compute one state for each of many bodies."""
        shape = np.broadcast_shapes(*(v.shape[:-1] for v in arguments))
        if (count := math.prod(shape)) < 2 or np.broadcast_shapes(shape, np.shape(elapsed)) != shape:
            return False
        return self._is_worth("set_up", SET_UP.time(count)) and self._is_worth("states_of_many", STATE.time(count))

    def _states_at_once(
        self, arguments: Vectors, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
    ) -> tuple[np.ndarray, np.ndarray]:
        shape, flat = _flatten(arguments)
        inputs, count = [_own(v) for v in flat], math.prod(shape)
        times, rests = (_own(np.broadcast_to(x, shape)).reshape(-1) for x in (elapsed, rest))
        attitude, momentum, left = np.empty((count, 4)), np.empty((count, 3)), np.ones(count, bool)

        def fill(start: int, end: int) -> None:
            columns = np.empty((self._sizes[0], AT_ONCE))
            for low in range(start, end, AT_ONCE):
                rows = slice(low, min(low + AT_ONCE, end))
                self._compiled.set_up(*(v[rows] for v in inputs), columns, left[rows], 0)
                bodies = np.arange(rows.stop - low)
                if left[rows].any():  # whose states are computed below, so that any others do here
                    bodies[left[rows]] = np.argmin(left[rows])
                if not left[rows].all():
                    self._compiled.states_of_many(
                        columns, bodies, times[rows], rests[rows], attitude[rows], momentum[rows]
                    )

        in_threads(fill, count, self._sizes[1])
        if left.any():  # all of them together, as NumPy's calls are many
            columns = np.empty((self._sizes[0], np.count_nonzero(left)))
            self._set_up_rows(slice(None), [v[left] for v in inputs], columns)
            attitude[left], momentum[left] = self.states(columns, times[left], rests[left])
        return attitude.reshape(*shape, 4), momentum.reshape(*shape, 3)

    # ------------------------------------------------------------------ in each way

    def _by_python(
        self, flat: Array, bodies: Array | None, times: Array, rests: Array, attitude: Array, momentum: Array
    ) -> None:
        rows = flat.T.tolist()
        for i, (time, rest) in enumerate(zip(times.tolist(), rests.tolist(), strict=True)):
            components = self.state(rows[0 if bodies is None else bodies[i]], time, rest)
            attitude[i], momentum[i] = components[:4], components[4:]

    def _by_arrays(
        self, flat: Array, bodies: Array | None, times: Array, rests: Array, attitude: Array, momentum: Array
    ) -> None:
        states = importlib.import_module(f"{self._package}._preparation").STATES
        in_order = bodies is not None and np.array_equal(bodies, np.arange(flat.shape[1]))  # each at its time

        def fill(start: int, end: int) -> None:
            for low in range(start, end, ROWS):
                rows = slice(low, min(low + ROWS, end))
                full, *others = flat[:, rows if in_order else 0 if bodies is None else bodies[rows]]
                with np.errstate(all="ignore"):
                    parts = states.evaluate((full != 0.0, *others), times[rows], rests[rows])
                for k, part in enumerate(parts):
                    (attitude[rows, k] if k < 4 else momentum[rows, k - 4])[:] = part

        in_threads(fill, len(times), ROWS)

    def _of_one(
        self, column: Sequence[float], times: Array, rests: Array, attitude: Array, momentum: Array
    ) -> None:
        fill = lambda low, high: self._compiled.states_of_one(  # noqa: E731
            tuple(column), times[low:high], rests[low:high], attitude[low:high], momentum[low:high]
        )
        in_threads(fill, len(times), kernel_loops.WORTH)

    def _of_many(
        self, flat: Array, bodies: Array, times: Array, rests: Array, attitude: Array, momentum: Array
    ) -> None:
        flat, bodies = _own(flat), _own(bodies, int)
        fill = lambda low, high: self._compiled.states_of_many(  # noqa: E731
            flat, bodies[low:high], times[low:high], rests[low:high], attitude[low:high], momentum[low:high]
        )
        in_threads(fill, len(times), kernel_loops.WORTH)


def _flatten(arguments: Vectors) -> tuple[tuple[int, ...], list[Array]]:
    """Return the common batch shape of arrays (…, k), and all of them flat, (bodies, k)."""
    if all(v.ndim == 1 for v in arguments):  # of one body, where broadcasting takes as long as the kernel
        return (), [v[None] for v in arguments]
    shape = np.broadcast_shapes(*(np.shape(v)[:-1] for v in arguments))
    return shape, [np.broadcast_to(v, (*shape, np.shape(v)[-1])).reshape(-1, np.shape(v)[-1]) for v in arguments]


def _own(values: Array, of: type = float) -> Array:
    """Return numbers as a contiguous array that may be written; Numba compiles again for any other, for seconds."""
    return np.require(values, of, ["C", "W"])
