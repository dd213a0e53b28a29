"""Poincaré sections of the motion of any system."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only
from polhode.analysis._printing import count_things, print_answer, write_numbers
from polhode.analysis._tangent_flow import check_start
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.integrators._adaptive import check_events
from polhode.integrators._interrupts import keep_interrupts
from polhode.integrators._series import check_sizes
from polhode.motion._outcome import Status
from polhode.systems._forms import check_finite_rates, one_number
from polhode.systems.base import AbstractSystem
from polhode.taylor.expressions import Untraceable
from polhode.taylor.runs import choose_precision, find_crossings
from polhode.types import Array, ArrayLike, Double, Float64, Real

DIRECTIONS = ("rising", "falling", "either")


class SectionLimits(NamedTuple):
    """What decides that a crossing is not the start."""

    start_rounding: float = 4e-15  # of the times: a crossing within this of the first time is the start itself


LIMITS = SectionLimits()


class Section(NamedTuple):
    """The points at which a motion crosses a surface.

    Attributes:
        times: (K,) [s], in the order of the motion.
        states: the system's K states there, one after the other.
        end: [s] the time up to which crossings were sought.
        event: name of the system's event that ended the motion, or None.
    """

    times: Float64[Array, "crossings"]
    states: Double[Array, "..."]
    end: float
    event: str | None

    def __str__(self) -> str:
        crossings, end = count_things(len(self.times), "crossing"), write_numbers(self.end, "s")
        why = f", where the motion ended by {self.event}" if self.event else ""
        return print_answer(f"{crossings} up to {end}{why}", times=write_numbers(self.times, "s"))


@known_numbers_only
def section(
    system: AbstractSystem,
    state: Real[ArrayLike, "..."],
    surface: Callable[[Any, Any], Any],
    times: Real[ArrayLike, "2"],
    direction: str = "rising",
    most: int = 1_000_000,
) -> Section:
    """Return the Poincaré section of a motion: each time when a function of it is zero, and the state then.

    The motion goes by Taylor series, whose zeros are isolated by excluding where none can be, so that none is missed
    within a step, and times are exact to rounding. Zeros that the function only touches do not count, unless a rounding
    takes it across, and of two that are nearer to each other than some 1e-8 of a step both may be missed. One at the
    start does not count.

    Args:
        system: what moves; its rates must be made of products, powers and elementary functions.
        state: one, packed as ``simulate`` takes it.
        surface: a function of the time [s] and the state, one number, written with JAX; zero on the surface.
        times: first and last [s].
        direction: "rising" counts where the function goes from negative to positive along the motion, "falling" the
            opposite, "either" both.
        most: how many crossings end the search.

    Raises:
        InvalidInput: for a batch of states, invalid times, direction or number, or rates that have no Taylor series.
        NotConverged: if the motion runs into a singularity before.

    >>> import polhode as ph
    >>> body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    >>> crossings = ph.section(body, [0.3, 1.9, 0.1], lambda t, momentum: momentum[1], (0.0, 100.0))
    >>> bool(abs(crossings.states[:, 1]).max() < 1e-13)
    True

    Source: Hénon, Physica D 5 (1982) 412, for what a section is; the zeros by Taylor series on each step.
    """
    start, first, last = check_start(system, state, times)
    ends = np.array([first, last])
    check.one_of("direction", direction, DIRECTIONS)
    most = check.whole("most", most, 1)
    check_sizes(np.asarray(start)[None])
    _check_surface(surface, ends[0], start)
    check_events(system, ends[0], start)
    through = surface if direction != "rising" else _negative(surface)
    with keep_interrupts() as check_interrupts:
        try:
            crossings = find_crossings(system, np.asarray(start), through, ends, choose_precision(None), most,
                                 direction != "either", lambda share: check_interrupts())
        except Untraceable as error:
            raise InvalidInput(
                f"a section of {type(system).__name__} needs Taylor series, and its rates of change or `surface` "
                f"contain {error}. Simulate it with close samples instead, and look for changes of sign."
            ) from None
    if crossings.status == Status.NOT_CONVERGED:
        check_finite_rates(system, ends[0], start)
        raise NotConverged(
            f"the motion of {type(system).__name__}, or `surface` along it, runs into a singularity before "
            f"{ends[1]:g} s. Give an earlier last time, or a `surface` that stays finite, as a product for a quotient."
        )
    event = tuple(system.events)[crossings.event] if crossings.status == Status.EVENT else None
    # a start that is a crossing of an earlier section misses the surface by a rounding
    later = np.abs(crossings.times - ends[0]) > LIMITS.start_rounding * np.abs(ends).max()
    return Section(crossings.times[later], crossings.states[later], crossings.end, event)


def _check_surface(surface: Any, t: float, start: Double[Array, "..."]) -> None:
    """Refuse what is not a function of time and state with one real number at the start."""
    if not callable(surface):
        raise InvalidInput(f"`surface` must be a function of time and state; got {shown(surface)}.")
    value = compiled_for_few_calls(lambda t, state: one_number("`surface`", surface(t, state)))
    at_start = float(value(jnp.asarray(t), jnp.asarray(start)))
    if not np.isfinite(at_start):
        raise InvalidInput(
            f"`surface` must be a finite number along the motion; got {at_start} at the start. Begin where it is one, "
            "or write it otherwise, as a product for a quotient."
        )


def _negative(surface: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    return lambda t, state: -surface(t, state)
