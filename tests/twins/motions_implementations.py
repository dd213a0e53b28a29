"""All implementations of the closed forms, each a function from motions to states: a new one needs its row here.

``test_motions.py`` looks for what has none: files in ``reference/``, ways in which JAX evaluates, kernels, and packages
of ``polhode.exact``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from functools import cache, partial
from pathlib import Path
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from flint import arb

import polhode as ph
from oracle.numpy_alone import compiled_alone, numpy_alone, python_alone, under
from oracle.optimized import OPTIMIZED
from reference.solvers import (
    COMPILER,
    NODE,
    REFERENCE,
    RUSTC,
    Given,
    compiled,
    compiled_rust,
    in_c,
    in_javascript,
    in_rust,
)
from twins.motions import COMMITTED, Motion

States = Callable[[Sequence[Motion]], np.ndarray]
EXACT = {"body": "free_body", "top": "lagrange_top"}
"""The package of ``polhode.exact`` that has each kind of motion."""


class Implementation(NamedTuple):
    """How one gives states, and what of the repository it is.

    Attributes:
        states: motions of one kind → states (N, 7), attitude and momentum.
        by_default: so many of each family of the table are asked for outside the sweeps; 0 where XLA compiles for long.
        is_long: whether that is a long test, as Numba compiles for half a minute.
        is_swept: whether the sweep asks for thousands more.
        files: patterns of its files in ``reference/``.
        way: the word for it in ``ph.closed_forms``.
        kernels: of ``polhode.exact``, that it calls.
        needs: a program; None where that is missing.
    """

    states: States
    by_default: int = COMMITTED
    is_long: bool = False
    is_swept: bool = True
    files: tuple[str, ...] = ()
    way: str | None = None
    kernels: tuple[str, ...] = ()
    needs: str | None = "python"


def columns(motions: Sequence[Motion]) -> dict[str, np.ndarray]:
    names = [name for name in Motion._fields[1:] if getattr(motions[0], name) is not None]
    return {name: np.array([getattr(motion, name) for motion in motions]) for name in names}


def motion_of(moments, momentum, attitude, epoch, mgl=None):
    if mgl is None:
        return ph.FreeMotion(moments, momentum=momentum, attitude=attitude, epoch=epoch)
    return ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude, epoch=epoch)


def state_of(time, **given):
    return jnp.concatenate(motion_of(**given).state(time), axis=-1)


def at_once(motions):
    given = columns(motions)
    times = given.pop("time")
    return np.concatenate(motion_of(**given).state(times), axis=-1)


def one_by_one(motions):
    return np.array([np.concatenate(motion_of(*m[1:6]).state(m.time)) for m in motions])


def at_many_times(motions):
    """One motion at a time, at an array of times that has one."""
    return np.concatenate([np.concatenate(motion_of(*m[1:6]).state(np.array([m.time])), axis=-1) for m in motions])


@cache
def jitted(where, mapped):
    """One function for all families, which is compiled once for each count of bodies or tops."""
    of_columns = lambda given: state_of(**given)  # noqa: E731 so that each way has a function of its own
    return jax.jit(jax.vmap(of_columns) if mapped else of_columns, compiler_options=OPTIMIZED)


def by_jax(motions, where, mapped):
    with jax.enable_x64(True), ph.closed_forms(where):
        return np.asarray(jitted(where, mapped)({name: jnp.asarray(x) for name, x in columns(motions).items()}))


def by_xla_one_by_one(motions):
    given = columns(motions)
    with jax.enable_x64(True), ph.closed_forms("compiled"):
        state = jitted("compiled", False)
        return np.array([state({name: x[k] for name, x in given.items()}) for k in range(len(motions))])


def by_javascript(motions, module=REFERENCE / "polhode.js"):
    answers = in_javascript([Given(*m[1:6]) for m in motions], [[m.time] for m in motions], module=module)
    return np.array([answer["states"][0] for answer in answers], np.float64)


@cache
def program() -> Path:
    return compiled(Path(tempfile.mkdtemp(prefix="polhode-c-")))


def by_c(motions, program=program):
    found = in_c(program(), [Given(*m[1:6]) for m in motions], [[m.time] for m in motions])
    assert not found.of_motion.any() and not found.of_times.any()
    return found.states[:, 0]


@cache
def rust_program() -> Path:
    return compiled_rust(Path(tempfile.mkdtemp(prefix="polhode-rust-")))


def by_rust(motions, program=rust_program):
    found = in_rust(program(), [Given(*m[1:6]) for m in motions], [[m.time] for m in motions])
    assert not found.of_motion.any() and not found.of_times.any()
    return found.states[:, 0]


def balls_of(motion) -> list[arb]:
    found = ph.certify(motion_of(*motion[1:6])).state(motion.time)
    return [x.ball for x in (*found.attitude, *found.momentum)]


def by_balls(motions):
    """The middles of enclosures."""
    return np.array([[float(x) for x in balls_of(motion)] for motion in motions])


IMPLEMENTATIONS = {
    "NumPy": Implementation(under(numpy_alone, at_once)),
    "Python, one by one": Implementation(one_by_one, by_default=5, is_swept=False, kernels=("set_up_one", "state_at")),
    "kernels, by Python": Implementation(under(python_alone, at_once), by_default=10, is_swept=False),
    "kernels, by Numba": Implementation(
        under(compiled_alone, at_once), is_long=True, kernels=("set_up", "states_of_many")),
    "kernels, by Numba, one by one": Implementation(
        under(compiled_alone, at_many_times), by_default=10, is_long=True, is_swept=False, kernels=("states_of_one",)),
    "JAX, jit": Implementation(partial(by_jax, where="host", mapped=False), way="host"),
    "JAX, vmap": Implementation(partial(by_jax, where="host", mapped=True), way="host"),
    "XLA, jit": Implementation(partial(by_jax, where="compiled", mapped=False), by_default=0, way="compiled"),
    "XLA, vmap": Implementation(partial(by_jax, where="compiled", mapped=True), by_default=0, way="compiled"),
    "XLA, one by one": Implementation(by_xla_one_by_one, by_default=0, way="compiled"),
    "JavaScript": Implementation(by_javascript, files=("*.js", "formulas/*.js"), needs=NODE),
    "C": Implementation(by_c, files=("polhode.h",), needs=COMPILER),
    "Rust": Implementation(by_rust, files=("rust",), needs=RUSTC),
    "balls": Implementation(by_balls, by_default=2, is_swept=False),
}  # fmt: skip
