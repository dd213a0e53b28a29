"""The kernel, as plain Python and compiled by Numba, for one copy at a time and for eight: always the same bits.

A third form moves one copy at a time with twice as many digits.

Compiling takes seconds, once for an installation, and loading what was compiled a third of one. Short runs are over by
then, and are left to Python, and few copies to the kernel that moves them one after the other.
"""

from __future__ import annotations

import inspect
import os
import zlib
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any, ClassVar, NamedTuple

from polhode.special import _doubledouble as doubledouble
from polhode.taylor import (
    kernel,
    kernel_at_once,
    kernel_extended,
    kernel_invariants,
    kernel_kepler,
    kernel_lanes,
    kernel_products,
    kernel_series,
    kernel_space,
    kernel_zeros,
    lanes,
    vectors,
)
from polhode.taylor.program import Program

LOADED = 0.3  # s that slower runs take before a kernel is loaded
WRITTEN, LONGEST = 1e-3, 4000  # or code is written for each operation of a program, and the longest that it is for
EXTENDED = 2  # for one copy with twice as many digits; other forms are named by how many copies they move at a time
# or compiled: as long as that takes, so that no run costs more than twice what the better choice would have
COMPILED = {1: 10.0, lanes.LANES: 12.0, EXTENDED: 12.0}
COMMON: tuple[ModuleType, ...] = kernel_space, kernel_kepler, kernel_series, kernel_zeros, kernel_invariants, kernel
MODULES = {1: (vectors, kernel_products, *COMMON), lanes.LANES: (lanes, kernel_lanes, *COMMON),
           EXTENDED: (vectors, kernel_products, doubledouble, *COMMON, kernel_extended)}  # fmt: skip
ENTRIES = ("advance", "conserved_values")
AT_ONCE = "evaluate_steps", "measure_coefficients", "sum_of_sizes", "expand_watched"
# all other functions are made part of those that call them
CALLED = ("function", "orbital", "hyperbolic", "eccentric_anomaly_at", "has_values", "reach_of", "first_zero",
          "change_within", "changes_sign", "zero_between", "bound_change", "sum_of_sizes",
          "first_coefficients", "power_of_pair")  # fmt: skip
WHAT = {1: "Taylor series", lanes.LANES: "Taylor series of many copies", EXTENDED: "Taylor series of more digits"}
Function = Any  # of Numba's or of Python's own


class Kernel(NamedTuple):
    """Functions of ``kernel``.

    Attributes:
        lanes: how many copies it moves at a time.
        is_compiled: whether by Numba; else it is Python.
        stretch: how many operations of a program one call does in its steps, so that Ctrl-C is seen between two calls.
    """

    lanes: int
    is_compiled: bool
    advance: Function
    conserved_values: Function
    stretch: int


class _Spent:
    """Time [s] that this process has spent in runs that a faster kernel would have taken, and which ones it has."""

    by_python = 0.0
    one_by_one = 0.0
    by_program: ClassVar[dict[int, float]] = {}
    ready: ClassVar[set[int]] = set()
    called: ClassVar[set[Kernel]] = set()


def choose_kernel(copies: int, extended: bool = False) -> Kernel:
    """Return the fastest kernel for so many copies that is compiled already or worth compiling."""
    if extended:
        build = compile_kernel if _is_worth(EXTENDED, _Spent.by_python) else python_kernel
        return build(EXTENDED)
    if not _is_worth(1, _Spent.by_python):
        return python_kernel(1)
    if copies >= lanes.LANES and _is_worth(lanes.LANES, _Spent.one_by_one):
        return compile_kernel(lanes.LANES)
    return compile_kernel(1)


def write_code(use: Kernel, program: Program, integrals: Program) -> tuple[Any, Any]:
    """Return ``Code`` of a program that has run for as long as it takes to write that, else None; and of integrals."""
    spent = _Spent.by_program.get(program.form, 0.0)
    if program.length > LONGEST or spent < WRITTEN * program.length:
        return None, None
    from polhode.taylor.straight_line import generate, generate_values

    # Python's own steps take longer than what this saves
    simple = use.is_compiled and integrals.outputs and integrals.is_of_products
    return generate(program, use.lanes), generate_values(integrals, use.lanes) if simple else None


def note(use: Kernel, copies: int, program: Program, seconds: float) -> None:
    """Record the time of a run, for the choice of the next kernel; not of the first, which compiles or loads."""
    if use in _Spent.called or not use.is_compiled:
        _Spent.by_program[program.form] = _Spent.by_program.get(program.form, 0.0) + seconds
    if use not in _Spent.called:
        _Spent.called.add(use)
    elif not use.is_compiled:
        _Spent.by_python += seconds
    elif copies >= lanes.LANES:
        _Spent.one_by_one += seconds


def note_rest(use: Kernel, extended: bool, spent: float, seconds: float) -> None:
    """Have the next part of a run compiled where what is left of it [s] would take Python longer than compiling.

    The progress meter extrapolates from the first second, so a run must not spend ten in Python before it is compiled.
    """
    width = EXTENDED if extended else 1
    if not use.is_compiled and spent >= LOADED and seconds >= COMPILED[width]:
        _Spent.ready.add(width)


def _is_worth(width: int, spent: float) -> bool:
    if width not in _Spent.ready and spent >= LOADED and (spent >= COMPILED[width] or _is_on_disk(width)):
        _Spent.ready.add(width)
    return width in _Spent.ready


@cache
def python_kernel(width: int) -> Kernel:
    """Return the kernel as it is written, of one copy with NumPy for what all components have in common."""
    replaced = {name: getattr(kernel_at_once, name) for name in AT_ONCE} if width == 1 else {}
    space = _join_modules(width, lambda function, name: function, replaced)
    return Kernel(_lanes(width), False, *(space[name] for name in ENTRIES), stretch=1_000)


@cache
def compile_kernel(width: int) -> Kernel:
    """Return the kernel as Numba compiles it when it is first called, or has it on the disk."""
    from polhode.exact import _compiling as compiling
    from polhode.taylor import compiled_vectors

    operations = compiled_vectors.of_one_copy() if _lanes(width) == 1 else compiled_vectors.of_lanes()
    operations = operations | ({"two_product": compiling.two_product} if width == EXTENDED else {})
    take: Any = compiling.njit  # whose types do not know all of its options

    def compiled(function: FunctionType, name: str) -> Any:
        if name in ENTRIES:
            # Numba looks at one file alone for changes, and keeps what it compiles by this name
            function.__qualname__ = _kept_name(name, width)
            return compiling.Entry(WHAT[width], take(error_model="numpy", nogil=True, cache=True)(function))
        return take(error_model="numpy", nogil=True, forceinline=name not in CALLED, no_cpython_wrapper=True,
                    no_cfunc_wrapper=True)(function)  # fmt: skip

    space = _join_modules(width, compiled, operations)
    return Kernel(_lanes(width), True, *(space[name] for name in ENTRIES), stretch=2_000_000)


def _lanes(width: int) -> int:
    return 1 if width == EXTENDED else width


@cache
def _kept_name(name: str, width: int) -> str:
    """Return the name by which Numba keeps an entry, which is that of all sources that it is made of."""
    rooms = "polhode.taylor.compiled_vectors", "polhode.exact._compiling"  # which import Numba
    specs = [find_spec(room) for room in rooms]
    files = [*map(inspect.getfile, MODULES[width]), *(spec.origin for spec in specs if spec and spec.origin), __file__]
    return f"{name}_{width}_{zlib.crc32(b''.join(Path(file).read_bytes() for file in files)):08x}"


@cache
def _is_on_disk(width: int) -> bool:
    """Whether Numba has compiled it before; mostly it can be told without Numba, whose import takes longer."""
    named, folder = os.environ.get("NUMBA_CACHE_DIR"), Path(__file__).parent / "__pycache__"
    if named or os.access(folder, os.W_OK):  # else Numba chooses another place
        place, within = (Path(named), "*/") if named else (folder, "")
        if not all(any(place.glob(f"{within}*{_kept_name(name, width)}-*.nbi")) for name in ENTRIES):
            return False
    return all(entry.is_on_disk() for entry in compile_kernel(width)[2:4])


def _join_modules(
    width: int, convert: Callable[[FunctionType, str], Any], operations: dict[str, Any]
) -> dict[str, Any]:  # fmt: skip
    """Return the names of all modules, in which functions, made into what is wanted, call each other."""
    space: dict[str, Any] = {}
    for module in reversed(MODULES[width]):  # the first ones say what numbers are
        space.update({name: value for name, value in vars(module).items() if not inspect.isfunction(value)})
    own = [(name, value) for module in MODULES[width] for name, value in vars(module).items()
           if inspect.isfunction(value) and value.__module__ == module.__name__]  # fmt: skip
    for name, value in own:
        plain = inspect.unwrap(value)  # tests wrap functions to check annotations
        space[name] = operations.get(name) or convert(FunctionType(plain.__code__, space, name), name)
    return space
