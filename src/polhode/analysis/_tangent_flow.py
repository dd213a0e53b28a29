"""The flow of any system with its derivative by the state, from one time to another."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._adaptive import AdaptiveMotion, solve_adaptively
from polhode.integrators._series import NoSeries, Taylor, has_series, solve_by_series
from polhode.integrators.probing import find_undeclared_jumps, name_jumps
from polhode.systems._forms import refuse_other_objects
from polhode.systems.base import AbstractSystem
from polhode.systems.variations import Variations
from polhode.types import Array, ArrayLike, Complex128, Double, Float64, Real

EPS = float(np.finfo(float).eps)


class TangentFlow:
    """A system's flow and its derivative: by Taylor series, or by adaptive steps where there are none.

    Args:
        system: what moves.
        start: one state.
        times: [s] between which it is asked for.

    Attributes:
        size: n, the number of real numbers of a state.
    """

    def __init__(self, system: AbstractSystem, start: Double[np.ndarray, "..."], times: tuple[float, float]) -> None:
        self._system = name_jumps(system, find_undeclared_jumps(system, start, np.array(times)))
        self._shape, self._kind, self._times = np.shape(start), start.dtype, times
        self._by_series: dict[int, bool] = {}
        self.size = start.size * (2 if np.iscomplexobj(start) else 1)

    def __call__(
        self, now: float, end: float, state: Double[np.ndarray, "..."], changes: Float64[np.ndarray, "n k"]
    ) -> tuple[Double[np.ndarray, "..."], Float64[np.ndarray, "n k"]]:
        """Return the state at the end, and the changes there, each a column of a flat state's real numbers.

        Raises:
            InvalidInput: if an event ends the motion before.
        """
        count = changes.shape[1]
        varied = Variations(self._system, count)
        own = np.ascontiguousarray(changes.T).view(self._kind).reshape(count, *self._shape)
        stacked = np.concatenate([state[None], own])
        if count not in self._by_series:
            self._by_series[count] = has_series(varied, stacked, self._times)
        motion = self._move(varied, stacked, np.array([now, end]))
        if motion.event is not None:
            raise InvalidInput(
                f"`times` must be within the motion of {type(self._system).__name__}, which ends at "
                f"{motion.times[-1]:g} s by the event {motion.event}. Give an earlier last time."
            )
        after = np.asarray(motion.states[-1])
        return after[0], np.ascontiguousarray(after[1:]).reshape(count, -1).view(float).T

    def _move(self, varied: Variations, stacked: Array, ends: Float64[np.ndarray, "2"]) -> AdaptiveMotion:
        if self._by_series[varied.count]:
            try:
                return solve_by_series(varied, Taylor(), stacked, ends)
            except NoSeries as error:
                if not error.part:
                    raise
                # such as a border along which the motion goes: other steps would go on with a wrong derivative
                raise InvalidInput(
                    f"the derivative of the motion of {type(self._system).__name__} is not known, as its rates of "
                    f"change contain {error.part}. Give smooth ones, or times in which the motion does not come there."
                ) from error
        return solve_adaptively(varied, diffrax.Dopri8(), stacked, ends)

    def flat(self, state: Double[np.ndarray, "..."]) -> Float64[np.ndarray, "n"]:
        """Return a state's real numbers."""
        return np.array(state, self._kind).reshape(-1).view(float)

    def state(self, numbers: Float64[np.ndarray, "n"]) -> Double[np.ndarray, "..."]:
        """Return the state with these real numbers."""
        return np.ascontiguousarray(numbers).view(self._kind).reshape(self._shape)

    def rates(self, t: float, state: Double[np.ndarray, "..."]) -> Float64[np.ndarray, "n"]:
        """Return the rates of change of a state's real numbers."""
        return self.flat(np.asarray(self._system.vector_field(jnp.asarray(t), jnp.asarray(state))))


def one_state(system: AbstractSystem, state: Real[ArrayLike, "..."]) -> Double[np.ndarray, "..."]:
    """Return one state of a system.

    Raises:
        InvalidInput: if it is not a system, or for a batch of states.
    """
    refuse_other_objects(system)
    start = np.asarray(system.check_state(state))
    if np.ndim(start) != system.state_axes:
        raise InvalidInput(f"`state` must be one state, no batch; got shape {np.shape(start)}. Call it for each.")
    return start


def check_start(
    system: AbstractSystem, state: Real[ArrayLike, "..."], times: Real[ArrayLike, "2"]
) -> tuple[Double[np.ndarray, "..."], float, float]:
    """Return one state, first and last time.

    Raises:
        InvalidInput: if it is not a system, for a batch of states, or for invalid times.
    """
    start = one_state(system, state)
    first, last = check.array("times", times, (2,), "s").tolist()
    if first == last:
        check.refuse("times", "a first and another last time [s]", times)
    return start, first, last


def compute_multipliers(
    matrix: Float64[np.ndarray, "n n"],
) -> tuple[Complex128[np.ndarray, "n"], Float64[np.ndarray, "n"]]:
    """Return the eigenvalues, the largest first, and the error of each by rounding of the matrix."""
    values, vectors = np.linalg.eig(matrix)
    noise = 100.0 * EPS * np.linalg.norm(matrix)
    # a group of m eigenvalues that fall together is off by the m-th root of what rounding makes of the matrix
    errors = np.empty(len(values))
    with np.errstate(all="ignore"):
        # a simple eigenvalue moves by the noise over |y·x|, of unit left and right eigenvectors (Wilkinson)
        alignment = 1.0 / (np.linalg.norm(np.linalg.pinv(vectors), axis=1) * np.linalg.norm(vectors, axis=0))
        simple = noise / np.maximum(alignment, EPS)
    for k, value in enumerate(values):
        together = np.sort(np.abs(values - value))
        sizes = np.arange(1, len(values) + 1)
        spread = noise ** (1.0 / sizes)
        within = together <= 10.0 * spread
        errors[k] = max(float((10.0 * spread[within]).max(initial=0.0)), 0.0) if within[1:].any() else simple[k]
    order = np.argsort(-np.abs(values), kind="stable")
    return values[order].astype(complex), errors[order]
