"""The flow of a spherical Lagrange top over a short time by Taylor series, regular everywhere, to be differentiated.

Both Cayley–Klein parameters are oscillators in one potential: α'' = −(h + G|β|²) α and β'' = (G/2 − h − G|β|²) β, with
h = (a² + |w|² − G s)/4, which follows from 2α' = i a α − w̄ β, 2β' = w α − i a β, w' = G ᾱ β. Beside the vertical α is
|α| e^{iχ} with χ' = c'/4|α|², so that β alone, as slow as the nutation, needs to be stepped.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays import is_jax, iterate, namespace, stop_gradient
from polhode.types import Array, ArrayOrFloat, Complex128, Float64

Number = Float64[ArrayOrFloat, "..."] | Complex128[Array, "..."]  # complex steps differentiate
Start = tuple[Number, ...]  # Re and Im of α, β and w, then G and a


class FlowLimits(NamedTuple):
    """The series of a step, and where only β is stepped."""

    order: int = 24
    max_step: float = 0.75  # rate times length: the terms left out are below 1e-17
    max_steps: int = 4000  # of one flow; a top on the separatrix is upright long before
    max_upright_tilt: float = 0.5  # 1 − cos θ up to which only β is stepped


LIMITS = FlowLimits()


def slopes(start: Start) -> tuple[Number, ...]:
    """Return α', β' and w', real and imaginary parts."""
    ar, ai, br, bi, wr, wi, G, a = start
    return (
        0.5 * (-a * ai - (wr * br + wi * bi)), 0.5 * (a * ar - (wr * bi - wi * br)),
        0.5 * (wr * ar - wi * ai + a * bi), 0.5 * (wr * ai + wi * ar - a * br),
        G * (ar * br + ai * bi), G * (ar * bi - ai * br),
    )  # fmt: skip


def flow(start: Start, tau: Number, D: Number, tilt: Number) -> tuple[Number, ...]:
    """Return α, β, w after ``tau``, real and imaginary parts.

    Args:
        start: at τ = 0, |α|² + |β|² = 1.
        tau: elapsed τ = t/I1, constant.
        D: accurate value of 2G − a² − |w|² + G s, constant; its changes are taken from ``start``.
        tilt: largest 1 − cos θ of the motion, constant.
    """
    xp = namespace(*start)
    G, a = start[6:]
    s = 2.0 * (start[2] ** 2 + start[3] ** 2)
    loose = 2.0 * G - a * a - (start[4] ** 2 + start[5] ** 2) + G * s
    D = D + (loose - _constant(xp, loose))
    slow = tilt < LIMITS.max_upright_tilt
    everywhere = _everywhere(start, xp.where(slow, 0.0, tau), D)
    near = _near_upright(start, xp.where(slow, tau, 0.0), D, tilt)
    return tuple(xp.where(slow, x, y) for x, y in zip(near, everywhere, strict=True))


def _constant(xp: Any, value: Array) -> Array:
    """Return a value without its derivative, by JAX or by a complex step."""
    return xp.real(stop_gradient(value))


def _steps(xp: Any, rate: Array, tau: Array) -> Array:
    """Return the number of steps, one for all of a batch."""
    turn = _constant(xp, rate) * xp.abs(tau)
    count = xp.ceil(xp.max(xp.where(turn > 0, turn, 0.0)) / LIMITS.max_step)  # NaN counts for nothing
    return xp.asarray(xp.minimum(xp.maximum(count, 1.0), float(LIMITS.max_steps)), dtype=xp.int64)


def _everywhere(start: Start, tau: Array, D: Array) -> tuple[Array, ...]:
    xp = namespace(*start)
    G, a = start[6:]
    # β'' = (D/4 − G|β|²) β by the definition of D
    h = 0.5 * G - 0.25 * D
    rate = xp.sqrt(start[4] ** 2 + start[5] ** 2 + a * a + 2.0 * G)
    count = _steps(xp, rate, tau)
    length = tau / count
    dar, dai, dbr, dbi = slopes(start)[:4]
    now = xp.stack([*start[:4], dar, dai, dbr, dbi])

    def rates(series: Array, k: Array) -> Array:
        pull = G * _dot(xp, series[:, :4], series[:, 8:9], k)
        alpha, beta = -h * series[k, 0:2], 0.25 * D * series[k, 2:4]
        return xp.concat([series[k, 4:8], alpha - pull[0:2], beta - pull[2:4]])

    def step(y: Array) -> Array:
        return _taylor(xp, y, length, (lambda c, k: _square(xp, c[:, 2:4], k),), rates)

    ar, ai, br, bi, dar, dai, dbr, dbi = iterate(count, step, now, like=now)
    # w = 2 (ᾱβ' − βᾱ')
    return ar, ai, br, bi, *_momentum((ar, ai), (br, bi), (dar, dai), (dbr, dbi))


def _momentum(alpha: Any, beta: Any, alpha_slope: Any, beta_slope: Any) -> tuple[Array, Array]:
    (ar, ai), (br, bi), (dar, dai), (dbr, dbi) = alpha, beta, alpha_slope, beta_slope
    return (
        2.0 * ((ar * dbr + ai * dbi) - (br * dar + bi * dai)),
        2.0 * ((ar * dbi - ai * dbr) - (bi * dar - br * dai)),
    )


def _near_upright(start: Start, tau: Array, D: Array, tilt: Array) -> tuple[Array, ...]:
    xp = namespace(*start)
    ar, ai, br, bi, wr, wi, G, a = start
    # where this form is not used, anything regular
    slow = tilt < LIMITS.max_upright_tilt
    ar, ai, br, bi = (xp.where(slow, v, x) for v, x in zip((ar, ai, br, bi), (1.0, 0.0, 0.0, 0.0), strict=True))
    ready = (ar, ai, br, bi, wr, wi, G, a)
    dbr, dbi = slopes(ready)[2:4]
    kappa = 0.25 * D
    # c' = p_φ + a = 2 Im β̄αw + a t
    c = 2.0 * ((br * ar + bi * ai) * wi + (br * ai - bi * ar) * wr) + 2.0 * a * (ar * ar + ai * ai)
    safe = xp.where(tilt > 0, tilt, 1.0)
    rate = xp.sqrt(xp.abs(_constant(xp, kappa)) + G * tilt) + xp.sqrt(2.0 * (dbr * dbr + dbi * dbi) / safe)
    count = _steps(xp, rate, tau)
    length = tau / count
    now = xp.stack([br, bi, dbr, dbi, 0.0 * br])

    def rates(series: Array, k: Array) -> Array:
        beta = kappa * series[k, 0:2] - G * _dot(xp, series[:, 0:2], series[:, 5:6], k)
        return xp.concat([series[k, 2:4], beta, _dot(xp, series[:, 5:6], series[:, 6:7], k)])

    def step(y: Array) -> Array:
        def inverse(series: Array, k: Array) -> Array:
            """Coefficient k of 1/|α|² from (1 − |β|²)/|α|² = 1; its own term is still zero in the sum."""
            rest = xp.where(k == 0, 1.0, 0.0) + _dot(xp, series[:, 5], series[:, 6], k)
            return rest / (1.0 - (y[0] * y[0] + y[1] * y[1]))

        return _taylor(xp, y, length, (lambda c, k: _square(xp, c[:, 0:2], k), inverse), rates)

    br_t, bi_t, dbr_t, dbi_t, swept = iterate(count, step, now, like=now)
    size0, size = (xp.sqrt(1.0 - (x * x + y * y)) for x, y in ((br, bi), (br_t, bi_t)))
    # ¼c' ∫ dτ/|α|² = ¼c' (τ + ∫ |β|²/|α|² dτ)
    angle = 0.25 * c * (tau + swept)
    cosine, sine = xp.cos(angle) * size / size0, xp.sin(angle) * size / size0
    ar_t, ai_t = ar * cosine - ai * sine, ar * sine + ai * cosine
    # α'/α = −Re β̄β'/|α|² + i c'/4|α|²
    grow, turn = -(br_t * dbr_t + bi_t * dbi_t) / (size * size), 0.25 * c / (size * size)
    slope = grow * ar_t - turn * ai_t, grow * ai_t + turn * ar_t
    return ar_t, ai_t, br_t, bi_t, *_momentum((ar_t, ai_t), (br_t, bi_t), slope, (dbr_t, dbi_t))


def _dot(xp: Any, x: Array, y: Array, k: Any) -> Array:
    """Return Σ_j x_j y_{k−j}; coefficients beyond k are still zero, so a traced index may wrap."""
    if isinstance(k, int):
        return np.einsum("j...,j...->...", x[: k + 1], y[k::-1])
    return xp.sum(x * y[k - xp.arange(LIMITS.order + 1)], axis=0)


def _square(xp: Any, series: Array, k: Array) -> Array:
    """Return coefficient k of |z|² for z given by its two parts."""
    return xp.sum(_dot(xp, series, series, k), axis=0)


def _taylor(xp: Any, now: Array, length: Array, products: Any, rates: Any) -> Array:
    """Return the sum over one step of the series of rows ``now`` whose coefficients follow from ``rates``.

    ``products`` give coefficient k of further rows, from all that is known up to k.
    """
    if not is_jax(now):
        return _taylor_in_place(now, length, products, rates)
    index = xp.reshape(xp.arange(LIMITS.order + 1), (LIMITS.order + 1,) + (1,) * now.ndim)
    idle = xp.zeros((len(products), *now.shape[1:]), dtype=xp.float64)
    series = xp.where(index == 0, xp.concat([now, idle])[None], 0.0)
    rows = now.shape[0]

    def put(series: Array, row: int, k: Array, values: Array) -> Array:
        count = values.shape[0]
        part = xp.where(index == k, values[None], series[:, row : row + count])
        return xp.concat([series[:, :row], part, series[:, row + count :]], axis=1)

    def add_order(carried: tuple[Array, Array]) -> tuple[Array, Array]:
        k, series = carried
        for number, product in enumerate(products):
            series = put(series, rows + number, k, product(series, k)[None])
        return k + 1, put(series, 0, k + 1, rates(series, k) * (length / (k + 1)))

    series = iterate(LIMITS.order, add_order, (xp.asarray(0, dtype=xp.int64), series), like=now)[1]
    return xp.sum(series[::-1, :rows], axis=0)


def _taylor_in_place(now: Array, length: Array, products: Any, rates: Any) -> Array:
    """Return the sum of ``_taylor``, on NumPy."""
    rows = now.shape[0]
    series = np.zeros((LIMITS.order + 1, rows + len(products), *now.shape[1:]), dtype=np.result_type(now, length))
    series[0, :rows] = now
    for k in range(LIMITS.order):
        for number, product in enumerate(products):
            series[k, rows + number] = product(series, k)
        series[k + 1, :rows] = rates(series, k) * (length / (k + 1))
    return np.sum(series[::-1, :rows], axis=0)
