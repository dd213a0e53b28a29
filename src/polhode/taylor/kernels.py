"""The kernel, as plain Python and compiled by Numba, for one copy at a time and for eight, bit for bit alike.

A third form moves one copy at a time with twice as many digits.

Compiling takes seconds, once for an installation. Short runs are over by then, and are left to Python, and few copies
to the kernel that moves them one after the other. What was compiled before is loaded at once.
"""

from __future__ import annotations

from functools import cache
from types import ModuleType
from typing import Any, ClassVar, NamedTuple

from polhode._base.compiled.kernel_modules import KernelModules, can_compile, is_worth, loading_time
from polhode.special import _doubledouble as doubledouble
from polhode.taylor import (
    kernel,
    kernel_at_once,
    kernel_companions,
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

EXTENDED = 2  # for one copy with twice as many digits; other forms are named by how many copies they move at a time
COMMON: tuple[ModuleType, ...] = (kernel_space, kernel_kepler, kernel_series, kernel_zeros, kernel_invariants,
                                  kernel_companions, kernel)  # fmt: skip
MODULES = {1: (vectors, kernel_products, *COMMON), lanes.LANES: (lanes, kernel_lanes, *COMMON),
           EXTENDED: (vectors, kernel_products, doubledouble, *COMMON, kernel_extended)}  # fmt: skip
ARITHMETIC = ("polhode.taylor.recurrences", "polhode.taylor.loops", "polhode.taylor.compiled_vectors",
              "polhode.taylor.llvm_writer", "polhode.exact._compiled_arithmetic")  # fmt: skip
ENTRIES = ("advance", "conserved_values")
AT_ONCE = "evaluate_steps", "measure_coefficients", "sum_of_sizes", "expand_watched"
WHAT = {1: "Taylor series", lanes.LANES: "Taylor series of many copies", EXTENDED: "Taylor series of more digits"}
Function = Any  # of Numba's or of Python's own


class CodeLimits(NamedTuple):
    """When kernels are compiled, and for which programs code is written."""

    # about how long compiling takes [s]: after slower runs of that time, no run costs more than twice the better choice
    seconds_of_one: float = 10.0
    seconds_of_lanes: float = 12.0
    seconds_of_extended: float = 12.0
    seconds_of_least_run: float = 0.01  # s that Python takes for the shortest run, about
    min_seconds_of_operation: float = 1e-3  # s of slower runs for each operation, in which writing pays off
    max_operations: int = 4000
    max_integral_operations: int = 4000  # LLVM takes .5 ms for each, and 4 ms and 100 kB where it is of eight copies


LIMITS = CodeLimits()
COMPILED = {1: LIMITS.seconds_of_one, lanes.LANES: LIMITS.seconds_of_lanes, EXTENDED: LIMITS.seconds_of_extended}


class Kernel(NamedTuple):
    """Functions of ``kernel``.

    Attributes:
        lanes: how many copies it moves at a time.
        is_compiled: whether by Numba; else it is Python.
        stretch: how many operations of a program one call does in its steps, so that Ctrl-C acts between two calls.
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
    is_due = lambda length: spent >= LIMITS.min_seconds_of_operation * length  # noqa: E731
    if program.length > LIMITS.max_operations or not is_due(program.length) or not can_compile():
        return None, None
    from polhode.taylor.straight_line import generate, generate_values

    # Python's own steps take longer than what this saves
    simple = use.is_compiled and integrals.outputs and integrals.is_of_products
    simple = simple and integrals.length <= LIMITS.max_integral_operations and is_due(integrals.length)
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
    """Have the next part of a run compiled where the rest [s] would take Python longer than compiling.

    The progress meter extrapolates from the first second, so a run must not spend ten in Python before it is compiled.
    """
    width = EXTENDED if extended else 1
    if not use.is_compiled and spent >= loading_time() and seconds >= COMPILED[width] and can_compile():
        _Spent.ready.add(width)


def _is_worth(width: int, spent: float) -> bool:
    seconds = spent + LIMITS.seconds_of_least_run
    if width not in _Spent.ready and is_worth(seconds, COMPILED[width], lambda: _is_on_disk(width)):
        _Spent.ready.add(width)
    return width in _Spent.ready


@cache
def python_kernel(width: int) -> Kernel:
    """Return the kernel as it is written, of one copy with NumPy for what all components have in common."""
    replaced = {name: getattr(kernel_at_once, name) for name in AT_ONCE} if width == 1 else {}
    space = _modules(width).by_python(replaced)[kernel.__name__]
    return Kernel(_lanes(width), False, space["advance"], space["conserved_values"], 1_000)


@cache
def compile_kernel(width: int) -> Kernel:
    """Return the kernel as Numba compiles it when it is first called, or has it on the disk."""
    advance, conserved_values = (_modules(width).entry(name) for name in ENTRIES)
    return Kernel(_lanes(width), True, advance, conserved_values, 2_000_000)


def _lanes(width: int) -> int:
    return 1 if width == EXTENDED else width


@cache
def _modules(width: int) -> KernelModules:
    return KernelModules(str(width), WHAT[width], MODULES[width], lambda: _for_numba(width), ARITHMETIC, joined=True)


def _for_numba(width: int) -> dict[str, Any]:
    from polhode.exact._compiled_arithmetic import two_product
    from polhode.taylor import compiled_vectors

    operations = compiled_vectors.of_one_copy() if _lanes(width) == 1 else compiled_vectors.of_lanes()
    return operations | ({"two_product": two_product} if width == EXTENDED else {})


@cache
def _is_on_disk(width: int) -> bool:
    """Whether Numba has compiled it before."""
    names = ENTRIES[:1] if width == EXTENDED else ENTRIES  # whose conserved quantities others compute
    return all(_modules(width).is_on_disk(name) for name in names)
