"""The exact derivative of the free motion with respect to moments, momentum and time, regular everywhere.

L(t) is differentiated in the form that the addition theorem gives it, so that nothing is divided by the distance from a
principal axis; ρ, σ and the phase are those of ``tangent_kernel``. The attitude's derivative ξ, δR = R hat(ξ), follows
from the momentum's and from δ∫2E dt by algebra: no elliptic integral of the third kind enters. A passage from one
saddle to the other is referred to its midpoint, where the growing solution is smallest. Everything that multiplies the
perturbations is finite, and enters linearly, so that reverse mode works by transposition.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode._base.arrays import namespace
from polhode.exact.free_body._formulas_reduction import Reduction
from polhode.exact.free_body._preparation import FORMULAS, Prepared
from polhode.exact.free_body._tangent_kernel import Kernel, elliptic_kernel
from polhode.special import _doubledouble as dd
from polhode.types import Array, Bool, Float64

Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]
Vector = tuple[Number, Number, Number]
Change = Float64[Array, "*more"]  # with any axes before those of the batch
Moved = tuple[Change, ...]  # three
Changes = tuple[Change, ...]  # of A, B, C, P, Q, b, κ, and of the momentum at the epoch


class Canonical(NamedTuple):
    """The motion's invariants in textbook form, sorted and mirrored, in the reduction's scaled units."""

    A: Number
    B: Number
    C: Number
    P: Number
    Q: Number
    S: Number
    b: Number
    g: Number
    kappa: Number
    full: Flag
    mirrored: Flag


class Passage(NamedTuple):
    """What the perturbations multiply: kernel, vectors at both ends, and whether the midpoint form is used."""

    kernel: Kernel
    middle: Flag
    signs: Vector
    start: Vector
    end: Vector
    rho: Number
    sigma: Number


class Tangent(NamedTuple):
    """What the derivative of the state is made of.

    Attributes:
        change: δL(t) at fixed time.
        flow: L̇(t).
        present: L(t), each component relative to its own amplitude; the state's is relative to |L|.
        work: δE t + ½ Σ δa_i ∫L_i².
    """

    change: Moved
    flow: Vector
    present: Vector
    work: Change


def momentum_tangent(prepared: Prepared, time: Number, d_moments: Moved, d_momentum: Moved) -> Tangent:
    """Return the parts of the derivative along the sorted axes, in scaled units.

    Args:
        prepared: the motion.
        time: scaled time since the epoch.
        d_moments: perturbation of the sorted scaled moments.
        d_momentum: perturbation of the sorted scaled momentum at the epoch.
    """
    body = prepared.body
    form = canonical_form(prepared)
    passage = _passage(prepared, form, time)
    mirrored = form.mirrored
    a = tuple(1.0 / x for x in body.moments)
    da = tuple(-x * y * y for x, y in zip(d_moments, a, strict=True))
    xp = namespace(form.A)
    moved = tuple(s * x for s, x in zip(passage.signs, mirror(mirrored, d_momentum), strict=True))
    changes = changed_form(form, passage.start, da, moved)
    # from t = ∫ ds/√((1 − bs²)(1 − gs²)) with g = b − κ: at fixed t, δs = c d Y − ½ s³ δb with Y = ½(ρ δb + σ δκ), as
    # (s³/cd)˙ = s² + s²/c² + s²/d² takes the singular integrals away. What goes with Y is a shift of time, by L̇
    Y = 0.5 * (passage.rho * changes[5] + passage.sigma * changes[6])
    rate = rate_of_momentum(form, passage.end)
    fixed = _from_start(form, passage, changes)
    middle = _from_middle(form, passage, changes)
    use = passage.middle
    shifted = tuple(r * (middle.shift + Y) + x for r, x in zip(middle.rate, middle.static, strict=True))
    drift = tuple(xp.where(use, mid, r * Y + far) for mid, r, far in zip(shifted, rate, fixed, strict=True))
    at_fixed_time, flow, present = (
        mirror(mirrored, tuple(s * x for s, x in zip(passage.signs, v, strict=True)))
        for v in (drift, rate, passage.end)
    )
    J = mirror(mirrored, _squares(form, passage, time))
    L = body.momentum
    dE = _dot(tuple(x * y for x, y in zip(a, L, strict=True)), d_momentum) + 0.5 * _dot(da, tuple(x * x for x in L))
    return Tangent(at_fixed_time, flow, present, time * dE + 0.5 * _dot(da, J))


def changed_form(form: Canonical, start: Vector, da: Moved, moved: Moved) -> Changes:
    """Return the changes of the invariants, and of the momentum at the epoch along the canonical axes.

    Args:
        form: the invariants.
        start: canonical momentum at the epoch.
        da: changes of 1/I along the sorted axes.
        moved: change of the canonical momentum.
    """
    A, B, C, _, Q, S = form[:6]
    l1, l2, l3 = start
    e1, e2, e3 = moved
    m = namespace(A).where(form.mirrored, -1.0, 1.0)
    dac = tuple(m * x for x in mirror(form.mirrored, da))
    dA, dB, dC = dac[0] - dac[1], dac[1] - dac[2], dac[0] - dac[2]
    # P = C L1² + B L2², Q = A L2² + C L3², S = A L1² − B L3², b = BQ, κ = −CS
    dP = dC * (l1 * l1) + dB * (l2 * l2) + (2.0 * C * l1) * e1 + (2.0 * B * l2) * e2
    dQ = dA * (l2 * l2) + dC * (l3 * l3) + (2.0 * A * l2) * e2 + (2.0 * C * l3) * e3
    dS = dA * (l1 * l1) - dB * (l3 * l3) + (2.0 * A * l1) * e1 - (2.0 * B * l3) * e3
    return dA, dB, dC, dP, dQ, dB * Q + B * dQ, -(dC * S + C * dS), e1, e2, e3


def canonical_form(prepared: Prepared) -> Canonical:
    """Return the invariants of a prepared motion."""
    body, rates = prepared.body, prepared.frequencies
    V = body.V[0]
    A, B, C, P, Q, S = (x[0] / V for x in (body.A, body.B, body.C, body.P, body.Q, body.S))
    xp = namespace(A)
    b, g = B * Q, A * P
    # S vanishes only on the separatrix; where it underflows near the saddle its root does not
    kappa = C * (body.root_S[0] / V) * body.root_S[0]
    # nearer still κ underflows too, and a derivative without it would be wrong
    least = 1e-306
    kappa = xp.where((kappa > least) | rates.constant, kappa, xp.nan)
    kappa = xp.where(rates.separatrix, 0.0, kappa)
    return Canonical(A, B, C, P, Q, S, b, g, kappa, g <= kappa, body.long_axis)


def _passage(prepared: Prepared, form: Canonical, time: Array) -> Passage:
    body, rates = prepared.body, prepared.frequencies
    xp = namespace(time, form.b)
    moving = form.b > 0
    separatrix = moving & ~(form.kappa > 0)  # permanent rotation about the middle axis too
    mean = dd.where(rates.constant, rates.modulus_rate, rates.mean)
    zero = 0.0 * (time + form.b)
    pi = tuple(c + zero for c in dd.PI)
    two_K = dd.divide(dd.multiply(rates.modulus_rate, pi), mean)
    two_K = dd.where(moving & ~separatrix, two_K, (1.0 + zero, zero))
    turn_rate = dd.divide(dd.divide(mean, pi), body.V)
    angle = dd.multiply_float(turn_rate, time)
    periodic = moving & ~separatrix
    turns = xp.where(periodic, xp.round(angle[0]), 0.0)
    rest = dd.two_sum(angle[0] - turns, angle[1])
    unlimited = dd.multiply_float(dd.divide(rates.modulus_rate, body.V), time)
    w = dd.where(separatrix, unlimited, dd.multiply(rest, two_K))
    w = dd.where(moving, w, (zero, zero))
    # e^2w, by which a motion away from the saddle magnifies changes, must not overflow
    largest = 340.0
    w = dd.where(xp.abs(w[0]) > largest, (xp.where(w[0] < 0, -largest, largest), zero), w)
    K = 0.5 * two_K[0]
    side = xp.where(rest[0] < 0, -1.0, 1.0)
    to_quarter = xp.where(separatrix, xp.inf, K * ((1.0 - 2.0 * xp.abs(rest[0])) - 2.0 * side * rest[1]))
    # a passage between saddles: the phase u0 at the epoch and u1 now lie on both sides of its middle
    start = dd.multiply(tuple(x + zero for x in prepared.motion[7:9]), two_K)
    u0 = dd.where(form.full | ~moving, (zero, zero), start)
    u1 = dd.add(u0, w)
    more = xp.where(periodic, xp.round(u1[0] / two_K[0]), 0.0)
    u1 = dd.where(more != 0, dd.subtract(u1, dd.multiply_float(two_K, more)), u1)
    middle = (form.g > form.kappa) & (turns + more == 0) & (u0[0] * u1[0] < 0)
    rate = xp.sqrt(xp.where(moving, form.b, 1.0))
    gap = lambda u: xp.where(separatrix, xp.inf, K - xp.abs(u))  # noqa: E731
    kernel = elliptic_kernel(
        xp.where(middle, u1[0] / rate, time), form.b, form.g, form.kappa, xp.where(middle, 0.0, turns),
        dd.where(middle, u1, w), xp.where(middle, gap(u1[0]), to_quarter),
    )
    # the other phase: the epoch's for a passage, else the present one, whose cn and dn are small near a saddle
    other = dd.where(middle, u0, u1)
    second = elliptic_kernel(other[0] / rate, form.b, form.g, form.kappa, zero, other, gap(other[0]))
    half_turn = body.half_turn
    side = xp.where(body.canonical[0] < 0, -1.0, 1.0)
    signs = tuple(xp.where(middle, x, 1.0) for x in (half_turn * side, side, half_turn))
    mirrored_start = mirror(form.mirrored, body.momentum)
    first = tuple(x * y for x, y in zip(signs, mirrored_start, strict=True))
    odd = 1.0 - 2.0 * ((turns + more) - 2.0 * xp.floor(0.5 * (turns + more)))
    s, c, d = (xp.where(middle, x, y) for x, y in zip(kernel[:3], second[:3], strict=True))
    P, Q, C = form.P, form.Q, xp.where(form.C > 0, form.C, 1.0)
    by_phase = xp.sqrt(P / C) * c, xp.sqrt(P) * xp.sqrt(Q) * s, xp.sqrt(Q / C) * d
    flips = (half_turn * side * odd, side * odd, half_turn)
    flips = tuple(xp.where(middle, 1.0, x) for x in flips)
    by_phase = tuple(x * y for x, y in zip(flips, by_phase, strict=True))
    by_addition = _addition_theorem(form, kernel, first)
    added = form.full | rates.constant
    last = tuple(xp.where(added, x, y) for x, y in zip(by_addition, by_phase, strict=True))
    return Passage(
        kernel, middle, signs, first, last,
        kernel.rho - xp.where(middle, second.rho, 0.0), kernel.sigma - xp.where(middle, second.sigma, 0.0),
    )


def _addition_theorem(form: Canonical, kernel: Kernel, start: Vector) -> Vector:
    """Return L(t), each component as accurate as the larger two of its start."""
    xp = namespace(form.b)
    A, B, C = form[:3]
    s, c, d = kernel[:3]
    l1, l2, l3 = start
    # cn, sn and dn of a sum (DLMF 22.8.1–3), with L at the epoch for the functions of its phase; their divisor
    # 1 − m sn² sn0² as a sum of squares
    divisor = c * c + B * C * l3 * l3 * s * s
    divisor = xp.where(divisor > 0, divisor, 1.0)
    return (
        (l1 * c - B * l2 * l3 * s * d) / divisor,
        (l2 * c * d + C * l1 * l3 * s) / divisor,
        (l3 * d - A * l1 * l2 * s * c) / divisor,
    )


def _from_start(form: Canonical, passage: Passage, changes: Changes) -> Moved:
    """Return r/Δ: the derivative of the addition theorem at fixed b and κ phases, from the epoch on.

    With U = AC L1², W = BC L3² and y = AB L2² at the epoch, b = y + W and g = y + U: written in their changes, the
    terms quadratic in time cancel by algebra near a symmetric body's equator, where b and g vanish and y does not.
    """
    xp = namespace(form.b)
    A, B, C = form[:3]
    s, c, d = passage.kernel[:3]
    l1, l2, l3 = passage.start
    dA, dB, dC, _, _, db, dkappa, e1, e2, e3 = changes
    ss = s * s
    U = A * C * (l1 * l1)
    dU = (C * l1 * l1) * dA + (A * l1 * l1) * dC + (2.0 * A * C * l1) * e1
    dW = (C * l3 * l3) * dB + (B * l3 * l3) * dC + (2.0 * B * C * l3) * e3
    y = A * B * (l2 * l2)
    dy = (B * l2 * l2) * dA + (A * l2 * l2) * dB + (2.0 * A * B * l2) * e2
    divisor = c * c + B * C * l3 * l3 * ss
    divisor = xp.where(passage.middle | ~(divisor > 0), 1.0, divisor)
    safe = xp.where(d > 0, d, 1.0)
    half, inner = 0.5 * ss, ss / divisor
    w = inner * dW
    h = half * db
    own = dy - (y * ss) * db
    # apart from Y, δs/s = δc/c = −½ s² δb = −h and δd/d = −h + ½ (s/d)² δκ; of the divisor, δD/D = w − 2h
    # by rows, what goes with L1 and L2 L3 s, with L2 and L3 L1 s, and with L3 alone
    first = xp.where(form.full, (0.5 * inner) * (own - dW), h - w)
    second = xp.where(form.full, ((ss * U) * w - half * (dU + dW)) / safe, (half / safe) * dkappa - w * d)
    third = xp.where(form.full, (d * inner) * own - (half / safe) * (dy + dU - (form.g * ss) * db), d * h + second)
    n1 = c * e1 - (s * d) * ((l2 * l3) * dB + B * (l3 * e2 + l2 * e3)) + (c * l1) * first - (B * l2 * l3 * s) * second
    n2 = (c * d) * e2 + s * ((l1 * l3) * dC + C * (l3 * e1 + l1 * e3)) + (C * l1 * l3 * s) * first + (l2 * c) * second
    n3 = d * e3 - (s * c) * ((l1 * l2) * dA + A * (l2 * e1 + l1 * e2)) + l3 * third + (A * l1 * l2 * s * c) * w
    return n1 / divisor, n2 / divisor, n3 / divisor


class Middle(NamedTuple):
    """The midpoint form: the static change now, the shift of the epoch's phase, and L̇ now."""

    static: Moved
    shift: Change
    rate: Vector


def _from_middle(form: Canonical, passage: Passage, changes: Changes) -> Middle:
    xp = namespace(form.b)
    use = passage.middle
    P, Q, C, b, l3 = (xp.where(use, x, 1.0) for x in (form.P, form.Q, form.C, form.b, passage.start[2]))
    A, B = form.A, xp.where(use, form.B, 1.0)
    l1, l2, _ = passage.start
    dA, dB, dC, dP, dQ, db, dkappa, e1, e2, e3 = changes
    # L = (√(P/C) c, √(PQ) s, √(Q/C) d): ½ δ ln of P, Q and C make up the changes of the amplitudes
    p, q, gamma = (0.5 / P) * dP, (0.5 / Q) * dQ, (0.5 / C) * dC
    # ½ δ ln(P/B), which vanishes at the saddle with L1 and δL2 though neither of its parts does
    level = ((0.5 * l1 / B) * (l1 * (B * dA - A * dB) + (2.0 * B * C) * e1) + (B * l2) * e2) / P

    def static(x: Array, y: Array, z: Array, ss: Array, sd2: Array, cc: Array) -> Vector:
        h = (0.5 * ss) * db
        return x * (p - gamma - h), y * (level + (0.5 * cc / b) * db), z * (q - gamma - h + (0.5 * sd2) * dkappa)

    rate = rate_of_momentum(form, (l1, l2, l3))
    size = xp.where(use, _dot(rate, rate), 1.0)
    size = xp.where(size > 0, size, 1.0)
    ss = l2 * l2 / P / Q
    before = static(l1, l2, l3, ss, l2 * l2 / P / C / l3 / l3, C * l1 * l1 / P)
    # what the static terms leave of the epoch's change is a shift of time, along L̇
    shift = _dot(tuple(r / size for r in rate), (e1 - before[0], e2 - before[1], e3 - before[2]))
    s, c, d = passage.kernel[:3]
    x, y, z = xp.sqrt(P / C) * c, xp.sqrt(P) * xp.sqrt(Q) * s, xp.sqrt(Q / C) * d
    safe = xp.where(use & (d > 0), d, 1.0)
    return Middle(static(x, y, z, s * s, (s / safe) ** 2, c * c), shift, rate_of_momentum(form, (x, y, z)))


def _squares(form: Canonical, passage: Passage, time: Array) -> Vector:
    """Return ∫₀ᵗ L_i² dt, each without cancellation."""
    xp = namespace(form.b)
    A, B, C, P, Q = form[:5]
    S = xp.where(form.kappa > 0, form.kappa, 0.0)  # C|S|
    s, c, d = passage.kernel[:3]
    l1, l2, l3 = passage.start
    n2 = passage.end[1]
    use = passage.middle
    J2 = xp.where(use, 0.0, l2 * n2 * s) + P * Q * passage.rho
    safe_C, safe_B = xp.where(C > 0, C, 1.0), xp.where(B > 0, B, 1.0)
    # in the full form ∫L2² gives the others, by C L1² = P − B L2² and C L3² = Q − A L2²; in the complementary form ∫L1²
    # comes from σ, and B L3² = A L1² − S
    share = xp.where(C > 0, (l2 * l2 * time - J2) / safe_C, 0.0)
    divisor = c * c + B * C * l3 * l3 * s * s
    divisor = xp.where(divisor > 0, divisor, 1.0)
    safe_d = xp.where(d > 0, d, 1.0)
    far = l1 * (l1 * c - B * l2 * l3 * s * d) / divisor * s / safe_d
    P_, Q_, l3_ = (xp.where(use, x, 1.0) for x in (P, Q, l3))
    near = xp.sqrt(P_ / safe_C) * c * xp.sqrt(P_) * xp.sqrt(Q_) * s / (xp.sqrt(Q_ / safe_C) * safe_d) - l1 * l2 / l3_
    J1 = P * (S / safe_C) * passage.sigma + xp.where(use, near / safe_C, far)
    J3 = (A * J1 + (S / safe_C) * time) / safe_B
    return xp.where(form.full, l1 * l1 * time + B * share, J1), J2, xp.where(form.full, l3 * l3 * time + A * share, J3)


def mirror(mirrored: Array, v: Any) -> Vector:
    """Swap the first and third component where the mirror was applied."""
    xp = namespace(mirrored, v[0])
    return xp.where(mirrored, v[2], v[0]), v[1], xp.where(mirrored, v[0], v[2])


def rate_of_momentum(form: Canonical, v: Vector) -> Vector:
    """Return L̇ = (−B L2 L3, C L1 L3, −A L1 L2)."""
    x, y, z = v
    return -form.B * y * z, form.C * x * z, -form.A * x * y


def _dot(x: Any, y: Any) -> Array:
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]


def sorted_sizes(body: Reduction, sizes: Float64[Array, "*more 3"]) -> Moved:
    """Return what goes with each axis, without sign, in sorted order."""
    xp = namespace(body.long_axis)
    a, b, c = ([xp.abs(x) * sizes[..., i] for x in row] for i, row in enumerate(FORMULAS.axes_of(body)))
    columns = [x + y + z for x, y, z in zip(a, b, c, strict=True)]
    first, third = (xp.where(body.long_axis, columns[2 - j], columns[j]) for j in (0, 2))
    return first, columns[1], third
