"""The derivative of a free motion's periods, precession and solid angle along perturbations of moments and momentum.

With b = BQ and κ = −CS, the period 4K/√b changes by −½ (ρ δb + σ δκ), where ρ and σ are the integrals of
``tangent_kernel`` over a period. The solid angle is the action's: with the mean of the squares over a period,
± |L| δΩ = T Ω⊥ · δL + ½ Σ δ(1/I_i) (T L_i² − ∮ L_i² dt), where Ω⊥ is the part of the angular velocity across L
(Arnold, *Mathematical Methods of Classical Mechanics*, §50). Nothing cancels near a principal axis.
"""

from __future__ import annotations

import math

from polhode._base.arrays import namespace
from polhode.exact.free_body._geometry import Characteristics
from polhode.exact.free_body._preparation import Prepared, as_sorted
from polhode.exact.free_body._tangent import (
    Canonical,
    canonical_form,
    changed_form,
    mirror,
    rate_of_momentum,
    sorted_sizes,
)
from polhode.exact.free_body._tangent_kernel import Kernel, elliptic_kernel
from polhode.rotation import cross_of_parts
from polhode.special import _doubledouble as dd
from polhode.types import Array, Float64

Number = Float64[Array, "*batch"]
Change = Float64[Array, "*shape"]  # with any axes before those of the batch
Numbers = tuple[Change, Change, Change, Change, Change]  # modulus to solid angle of ``Characteristics``


def changed_numbers(
    prepared: Prepared, numbers: Characteristics, d_moments: Float64[Array, "*shape 3"],
    d_momentum: Float64[Array, "*shape 3"],
) -> Numbers:
    """Return the changes of modulus, period, precession rate, precession per period and solid angle.

    Args:
        prepared: the motion.
        numbers: the values.
        d_moments: changes of the moments, along the given axes.
        d_momentum: changes of the momentum, likewise; the result is linear in both.
    """
    body, rates = prepared.body, prepared.frequencies
    xp = namespace(d_moments, d_momentum)
    form = canonical_form(prepared)
    scale, rate = body.momentum_scale, body.rate_scale
    change = tuple(x / scale for x in as_sorted(body, d_momentum))
    a = tuple(1.0 / x for x in body.moments)
    da = tuple(-x * (rate / scale) * y * y for x, y in zip(sorted_sizes(body, d_moments), a, strict=True))
    start = mirror(form.mirrored, body.momentum)
    changed = changed_form(form, start, da, mirror(form.mirrored, change))
    _, _, _, dP, _, db, dkappa = changed[:7]

    period, kernel = _whole_period(prepared, form)
    # a zero of s moves in time by −Y, Y = ½(ρ δb + σ δκ), as δs = c d Y there
    d_period = -0.5 * (kernel.rho * db + kernel.sigma * dkappa)
    G2 = body.G2[0]
    G = xp.sqrt(G2)
    sense = xp.where(body.long_axis, -1.0, 1.0)
    work, across = _energy_change(form, body.momentum, G2, a, change)
    excess = mirror(form.mirrored, _excess_of_squares(form, start, kernel, period))
    d_angle = sense / G * (period * across + 0.5 * sum(x * y for x, y in zip(da, excess, strict=True)))
    energy = 0.5 * sum(x * y * y for x, y in zip(a, body.momentum, strict=True))
    d_energy = work + 0.5 * sum(x * y * y for x, y in zip(da, body.momentum, strict=True))
    d_size = sum(x * y for x, y in zip(body.momentum, change, strict=True)) / G
    # the turn about L in a period is 2ET/G − Ω, or + Ω round the long axis (Montgomery, Am. J. Phys. 59 (1991) 394)
    d_turn = 2.0 / G * (period * d_energy + energy * d_period - energy * period / G * d_size) - sense * d_angle

    # k² = g/b, or by κ near one
    dg = changed[0] * form.P + form.A * dP
    k = numbers.modulus
    by_g, by_kappa = dg - k * k * db, form.kappa / form.b * db - dkappa
    d_modulus = 0.5 / k * xp.where(form.full, by_g, by_kappa) / form.b
    undefined = rates.constant | rates.separatrix
    d_rate = (d_turn - numbers.precession_rate / rate * d_period) / period * rate
    changes = (d_modulus, d_period / rate, d_rate, d_turn, d_angle)
    whole = tuple(xp.where(undefined, math.nan, x) for x in changes)
    return whole  # type: ignore[return-value]


def _whole_period(prepared: Prepared, form: Canonical) -> tuple[Number, Kernel]:
    """Return the period in scaled units and the kernel over it."""
    body, rates = prepared.body, prepared.frequencies
    xp = namespace(form.b)
    zero = 0.0 * form.b
    pi = tuple(c + zero for c in dd.PI)
    none = rates.constant | rates.separatrix
    mean = dd.where(none, dd.from_float(xp.ones_like(form.b)), rates.mean)
    half_period = dd.divide(dd.multiply(mean, pi), dd.multiply(mean, mean))  # π/agm, in units of V
    period = dd.scale(dd.multiply(half_period, body.V), 2.0)[0]
    quarter = 0.25 * period * xp.sqrt(xp.where(form.b > 0, form.b, 1.0))
    kernel = elliptic_kernel(period, form.b, form.g, form.kappa, zero + 2.0, (zero, zero), quarter)
    return period, kernel


def _energy_change(
    form: Canonical, L: tuple[Number, ...], G2: Number, a: tuple[Number, ...], change: tuple[Change, ...]
) -> tuple[Change, Change]:
    """Return Ω · δL and Ω⊥ · δL, with Ω⊥ = (L̇ × L)/|L|²."""
    rate = mirror(form.mirrored, rate_of_momentum(form, mirror(form.mirrored, L)))
    # (L × Ω) × L = |L|² Ω − (L·Ω) L
    across = cross_of_parts(rate, L)
    work = sum(x * y * z for x, y, z in zip(a, L, change, strict=True))
    return work, sum(x * y for x, y in zip(across, change, strict=True)) / G2  # type: ignore[return-value]


def _excess_of_squares(
    form: Canonical, start: tuple[Number, ...], kernel: Kernel, period: Number
) -> tuple[Number, Number, Number]:
    """Return T L_i² − ∮ L_i² dt, each without cancellation."""
    xp = namespace(form.b)
    A, B, C, P, Q = form[:5]
    l1, l2, l3 = start
    second = period * l2 * l2 - P * Q * kernel.rho
    share = xp.where(C > 0, second / xp.where(C > 0, C, 1.0), 0.0)
    over = form.kappa / xp.where(C > 0, C, 1.0)
    J1 = P * over * kernel.sigma
    J3 = (A * J1 + over * period) / xp.where(B > 0, B, 1.0)
    first = xp.where(form.full, -B * share, period * l1 * l1 - J1)
    return first, second, xp.where(form.full, -A * share, period * l3 * l3 - J3)
