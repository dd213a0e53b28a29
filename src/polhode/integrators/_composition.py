"""Symmetric compositions that raise the order of symmetric methods of order two.

Sources: Suzuki, Phys. Lett. A 146 (1990) 319 (order 4, five stages); Kahan & Li, Math. Comp. 66 (1997) 1089 (order 6,
nine stages, s9odr6a; order 8, seventeen stages, s17odr8a); Blanes & Moan, J. Comput. Appl. Math. 142 (2002) 313
(Runge–Kutta–Nyström splittings of order 4, six stages, SRKN6b, and of order 6, eleven stages, SRKN11b).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.integrators._step_results import Change, Scalar
from polhode.types import Array, Double, Float64

Stage = Callable[[Scalar, Scalar, Double[Array, "..."]], Change]
HintedStage = Callable[[Scalar, Scalar, Double[Array, "..."], Any], tuple[Change, Any]]
# 4s³ + (1 − 4s)³ = 0: the errors of third order of the five stages cancel (Suzuki 1990)
_SUZUKI = 1.0 / (4.0 - 4.0 ** (1.0 / 3.0))
_KAHAN_LI = (0.39216144400731413928, 0.33259913678935943860, -0.70624617255763935981, 0.08221359629355080023)
_KAHAN_LI_8 = (
    0.13020248308889008087881763, 0.56116298177510838456196441, -0.38947496264484728640807860,
    0.15884190655515560089621075, -0.39590389413323757733623154, 0.18453964097831570709183254,
    0.25837438768632204729397911, 0.29501172360931029887096624,
)  # fmt: skip
DEFAULT_ORDER = 8
STAGES: dict[int, tuple[float, ...]] = {
    2: (1.0,),
    4: (_SUZUKI, _SUZUKI, 1.0 - 4.0 * _SUZUKI, _SUZUKI, _SUZUKI),
    6: (*_KAHAN_LI, 1.0 - 2.0 * sum(_KAHAN_LI), *_KAHAN_LI[::-1]),
    8: (*_KAHAN_LI_8, 1.0 - 2.0 * sum(_KAHAN_LI_8), *_KAHAN_LI_8[::-1]),
}

_KICKS = (
    0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807, -0.0115113874206879,
)  # fmt: skip
_DRIFTS = (0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075, 0.357208872795928)
_KICKS_4 = (0.0829844064174052, 0.396309801498368, -0.0390563049223486)
_DRIFTS_4 = (0.245298957184271, 0.604872665711080)
_INNER_KICKS, _INNER_DRIFT = 0.5 - sum(_KICKS), 1.0 - 2.0 * sum(_DRIFTS)
# order → shares of kicks and of drifts between them, where {V, {V, {V, T}}} = 0 leaves fewer conditions
NYSTROM: dict[int, tuple[tuple[float, ...], tuple[float, ...]]] = {
    4: (
        (*_KICKS_4, 1.0 - 2.0 * sum(_KICKS_4), *_KICKS_4[::-1]),
        (*_DRIFTS_4, 0.5 - sum(_DRIFTS_4), 0.5 - sum(_DRIFTS_4), *_DRIFTS_4[::-1]),
    ),
    6: (
        (*_KICKS, _INNER_KICKS, _INNER_KICKS, *_KICKS[::-1]),
        (*_DRIFTS, _INNER_DRIFT, *_DRIFTS[::-1]),
    )
}


def stages(order: int) -> Float64[np.ndarray, "stages"]:
    """Return the fractions of a step that compose a method of the order.

    Raises:
        InvalidInput: for another order than 2, 4, 6 or 8.
    """
    if order not in STAGES:
        raise InvalidInput(f"`order` of a composition must be 2, 4, 6 or 8; got {shown(order)}.")
    return np.array(STAGES[order])


def stage_times(order: int) -> Float64[np.ndarray, "stages"]:
    """Return the fraction of the step at which each stage begins."""
    fractions = stages(order)
    return np.cumsum(fractions) - fractions


def compose(
    stage: Stage, order: int, t: Scalar, h: Scalar, state: Double[Array, "..."],
    beside: Callable[[Scalar], Scalar] | None = None,
) -> Change:
    """Return the change by stages of t, their length and state that make a step of the order."""
    return compose_with_hints(lambda t, h, state, _: (stage(t, h, state), ()), order, t, h, state, (), beside)[0]


def compose_with_hints(
    stage: HintedStage, order: int, t: Scalar, h: Scalar, state: Double[Array, "..."], hints: Any,
    beside: Callable[[Scalar], Scalar] | None = None,
) -> tuple[Change, Any]:
    """Return the change by stages that tell each other, from step to step, where to start their search.

    Args:
        stage: (t, length, state, hint) → its change, and the hint for that stage of the next step.
        order: of the step.
        t: its start [s].
        h: its length [s].
        state: at its start.
        hints: a nest of arrays, the stages along their first axes.
        beside: keeps the middle of a stage on the step's side of each jump; None without jumps.
    """
    if order == 2:
        change, hint = stage(t, h, state, jax.tree.map(lambda x: x[0], hints))
        return change, jax.tree.map(lambda x: x[None], hint)
    fractions, begins = jnp.asarray(stages(order)), jnp.asarray(stage_times(order))

    def add(k: Array, carried: tuple[Array, Change, Any]) -> tuple[Array, Change, Any]:
        now, total, hints = carried
        begin, length = t + begins[k] * h, fractions[k] * h
        if beside is not None:
            begin = beside(begin + 0.5 * length) - 0.5 * length
        change, hint = stage(begin, length, now, jax.tree.map(lambda x: x[k], hints))
        total = Change(
            total.state + change.state, total.iterations + change.iterations, total.converged & change.converged
        )
        return now + change.state, total, jax.tree.map(lambda xs, x: xs.at[k].set(x), hints, hint)

    none = Change(jnp.zeros_like(state), jnp.zeros((), int), jnp.asarray(True))
    return jax.lax.fori_loop(0, len(fractions), add, (state, none, hints))[1:]
