"""The free rigid body to any number of digits, by Legendre's form: the oracle for the closed form under test.

Nothing here is shared with the theta-function form of the library. The momentum is written with Jacobi's sn, cn, dn,
computed by descending Landen steps without cancellation; the attitude is read off a frame tied to the momentum and
to one principal axis that the momentum never meets, whose azimuth is an incomplete elliptic integral of the third
kind, computed by Carlson's R_J. Inputs are exact rationals (every double is one), so that no cancellation among the
moments loses anything; the rest is ball arithmetic at a precision that is raised until the balls are small enough.

Source: Whittaker, Analytical Dynamics, §69-71; Carlson, Numer. Algorithms 10 (1995) 13.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from flint import acb, arb, ctx, fmpq

ACCURATE_BITS = 160
"""Absolute accuracy of every reference entry: 48 digits, so that 16 eps = 2^-48 is measured exactly."""
HIGHEST_PRECISION = 1 << 17
ZERO = fmpq(0)
Exact = Any
"""A double, an integer or a rational: a number without error."""


class Reference(NamedTuple):
    """Attitude from the identity, body -> space, and direction of the momentum in body axes.

    The quaternion is the one that goes continuously from 1, 0, 0, 0.
    """

    rotation: list[list[arb]]
    direction: list[arb]
    quaternion: list[arb]


def exact(value: Exact) -> fmpq:
    """Return a double, an integer or a rational as the rational it is."""
    return value if isinstance(value, fmpq) else fmpq(*float(value).as_integer_ratio())


def reference_state(
    moments: Sequence[Exact], momentum: Sequence[Exact], t: Exact, bits: int = ACCURATE_BITS
) -> Reference:
    """Return attitude matrix and momentum direction at ``t``, from the identity at 0, to ``bits`` binary digits.

    Args:
        moments: three positive principal moments, in any order.
        momentum: angular momentum at t = 0 along the principal axes.
        t: time; all three are taken as exact numbers.
        bits: absolute accuracy of the entries.

    Returns:
        Rotation entries, L/|L| (zero where L = 0) and quaternion as balls.
    """
    turn, sorted_moments, sorted_momentum = _sorted(moments, momentum)
    precision = bits + 96
    while precision <= HIGHEST_PRECISION:
        with ctx.workprec(precision):
            rotation, direction, (scalar, *vector) = _sorted_state(sorted_moments, sorted_momentum, exact(t))
            quaternion = [scalar, *_turned_back(turn, vector)]
            result = Reference(_conjugated(turn, rotation), _turned_back(turn, direction), quaternion)
            if _radius_below(result, bits):
                return result
        precision *= 2
    raise ArithmeticError(f"no {bits} bits with {HIGHEST_PRECISION} bits of work: {moments}, {momentum}, {t}")


def _sorted(moments: Sequence[Exact], momentum: Sequence[Exact]) -> tuple[list[tuple[int, int]], list, list]:
    """Sort the moments ascending by a proper rotation: new axis i is sign * old axis ``turn[i]``."""
    inertia, vector = [exact(v) for v in moments], [exact(v) for v in momentum]
    order = sorted(range(3), key=lambda i: inertia[i])
    even = tuple(order) in {(0, 1, 2), (1, 2, 0), (2, 0, 1)}
    sign = 1 if even else -1
    return [(i, sign) for i in order], [inertia[i] for i in order], [sign * vector[i] for i in order]


def _turned_back(turn: list[tuple[int, int]], vector: list[arb]) -> list[arb]:
    back = [arb(0)] * 3
    for new, (old, sign) in enumerate(turn):
        back[old] = sign * vector[new]
    return back


def _conjugated(turn: list[tuple[int, int]], matrix: list[list[arb]]) -> list[list[arb]]:
    back = [[arb(0)] * 3 for _ in range(3)]
    for i, (row, _) in enumerate(turn):
        for j, (column, _) in enumerate(turn):
            back[row][column] = matrix[i][j]  # one common sign: it squares away
    return back


def _radius_below(result: Reference, bits: int) -> bool:
    limit = arb(2) ** (-bits)
    entries = [entry for row in result.rotation for entry in row] + result.direction + result.quaternion
    return all(entry.is_finite() and entry.rad() < limit for entry in entries)


def _sorted_state(inertia: list[fmpq], vector: list[fmpq], t: fmpq) -> Reference:
    omega = [x / i for x, i in zip(vector, inertia, strict=True)]
    norm = arb(sum((x * x for x in vector), ZERO)).sqrt()
    if all(x == 0 for x in vector):
        return Reference(_identity(), [arb(0)] * 3, [arb(1), arb(0), arb(0), arb(0)])
    if all(x == 0 for x in _cross(vector, omega)):
        return Reference(_steady_rotation(omega, t), [arb(x) / norm for x in vector], _steady_quaternion(omega, t))
    a = [1 / i for i in inertia]
    gap_a, gap_b, gap_c = a[0] - a[1], a[1] - a[2], a[0] - a[2]
    p = gap_c * vector[0] ** 2 + gap_b * vector[1] ** 2
    q = gap_a * vector[1] ** 2 + gap_c * vector[2] ** 2
    s = gap_a * vector[0] ** 2 - gap_b * vector[2] ** 2
    if s <= 0:
        return _state(_Polhode(0, 2, gap_b, gap_c, p, q, -s, a[0], -1), vector, norm, t)
    return _state(_Polhode(2, 0, gap_a, gap_c, q, p, s, a[2], 1), vector, norm, t)


class _Polhode(NamedTuple):
    """One polhode, about its encircled axis; both modes read alike with axes 1 and 3 exchanged.

    L_swing = sqrt(small/C) cn, L_2 = ± sqrt(small/gap) sn, L_around = ± sqrt(large/C) dn, modulus by
    rate² = gap·large and 1 - m = C·invariant/rate². The momentum never meets the swing axis.
    """

    swing: int
    around: int
    gap: fmpq
    gap_c: fmpq
    small: fmpq
    large: fmpq
    invariant: fmpq
    inverse_moment: fmpq
    sense: int


def _state(body: _Polhode, vector: list[fmpq], norm: arb, t: fmpq) -> Reference:
    around_positive = vector[body.around] >= 0
    sign = 1 if around_positive else -1
    rate = arb(body.gap * body.large).sqrt()
    cn = arb(vector[body.swing]) * (arb(body.gap_c) / arb(body.small)).sqrt()
    sn = sign * arb(vector[1]) * (arb(body.gap) / arb(body.small)).sqrt()
    dn = sign * arb(vector[body.around]) * (arb(body.gap_c) / arb(body.large)).sqrt()
    ratio = arb(body.small / body.large)
    if body.invariant == 0:
        (sn, cn, dn), swept = _on_separatrix(sn, cn, dn, rate * arb(t), ratio)
    else:
        parameter1 = arb(body.gap_c * body.invariant / (body.gap * body.large))
        (sn, cn, dn), swept = _along_polhode((sn, cn, dn), rate * arb(t), parameter1, ratio)
    direction = [arb(0)] * 3
    direction[body.swing] = (arb(body.small) / arb(body.gap_c)).sqrt() * cn / norm
    direction[1] = sign * (arb(body.small) / arb(body.gap)).sqrt() * sn / norm
    direction[body.around] = sign * (arb(body.large) / arb(body.gap_c)).sqrt() * dn / norm
    # The swing axis turns about L at G (2E - a L_swing²)/(G² - L_swing²) = a G ∓ C G/(1 + ratio sn²).
    azimuth = arb(body.inverse_moment) * norm * arb(t) + body.sense * arb(body.gap_c) * norm * swept / rate
    start = [arb(x) / norm for x in vector]
    before, after = _momentum_frame(start, body.swing), _momentum_frame(direction, body.swing)
    sine, cosine = azimuth.sin_cos()
    turned = [
        [cosine * x - sine * y for x, y in zip(after[0], after[1], strict=True)],
        [sine * x + cosine * y for x, y in zip(after[0], after[1], strict=True)],
        after[2],
    ]
    rotation = [[sum((before[k][i] * turned[k][j] for k in range(3)), arb(0)) for j in range(3)] for i in range(3)]
    return Reference(rotation, direction, _quaternion(body, start, azimuth, direction))


def _quaternion(body: _Polhode, start: list[arb], azimuth: arb, direction: list[arb]) -> list[arb]:
    """The quaternion of ``rotation``, continuous in time as those of the momentum's frames are along the polhode."""
    (w, x, y, z), (scalar, *parts) = (_frame_quaternion(n, body) for n in (start, direction))
    sine, cosine = (azimuth / 2).sin_cos()
    turned = _product((cosine, arb(0), arb(0), sine), (scalar, *parts))
    scalar, *parts = _product((w, -x, -y, -z), turned)
    vector = [arb(0)] * 3
    for k in range(3):
        vector[(body.swing + k) % 3] = parts[k]
    return [scalar, *vector]


def _frame_quaternion(n: list[arb], body: _Polhode) -> tuple[arb, ...]:
    """Of the frame below, along the axes swing, j, k: a turn by γ about the first, then one by −β about the second.

    tan γ = n_j/n_k and sin β = n_swing. γ has no jump, as the component along the encircled axis never vanishes.
    """
    j, k = (body.swing + 1) % 3, (body.swing + 2) % 3
    quarter = arb.pi() / 2
    if body.around == k:
        gamma = (n[j] / n[k]).atan() + (2 * quarter if n[k] < 0 else 0)
    else:
        gamma = (quarter if n[j] > 0 else -quarter) - (n[k] / n[j]).atan()
    sine, cosine = (gamma / 2).sin_cos()
    beta = -(n[body.swing] / (n[j] ** 2 + n[k] ** 2).sqrt()).atan()
    sine_beta, cosine_beta = (beta / 2).sin_cos()
    return _product((cosine_beta, arb(0), sine_beta, arb(0)), (cosine, sine, arb(0), arb(0)))


def _product(p: Sequence[arb], q: Sequence[arb]) -> tuple[arb, ...]:
    (a, b, c, d), (w, x, y, z) = p, q
    return (a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w)  # fmt: skip


def _momentum_frame(n: list[arb], swing: int) -> list[list[arb]]:
    """Rows, in body axes: the swing axis seen along L, the direction at right angles, and L/|L|."""
    j, k = (swing + 1) % 3, (swing + 2) % 3
    across_square = n[j] ** 2 + n[k] ** 2
    across = across_square.sqrt()
    first, second = [arb(0)] * 3, [arb(0)] * 3
    first[swing], first[j], first[k] = across, -n[swing] * n[j] / across, -n[swing] * n[k] / across
    second[j], second[k] = n[k] / across, -n[j] / across
    return [first, second, n]


def _along_polhode(
    start: tuple[arb, arb, arb], phase: arb, parameter1: arb, ratio: arb
) -> tuple[tuple[arb, arb, arb], arb]:
    """Return sn, cn, dn after ``phase`` and the swept ∫ du/(1 + ratio sn² u), whole half periods split off."""
    complementary_modulus = parameter1.sqrt()
    quarter = arb.pi() / (2 * agm(arb(1), complementary_modulus))
    third_quarter = quarter - ratio / 3 * carlson_rj(arb(0), parameter1, 1 + ratio)
    sn, cn, dn = start
    first = sn * acb.elliptic_rf(cn**2, dn**2, 1).real
    swept_start = _third_kind(first, sn, cn, dn, ratio)
    if cn < 0:  # the other half of the polhode
        first, swept_start = 2 * quarter - first, 2 * third_quarter - swept_start
    u = first + phase
    half_turns = ((u / (2 * quarter)).mid() + arb("0.5")).floor().mid()
    rest = u - 2 * quarter * half_turns
    sn, cn, dn = jacobi(rest, complementary_modulus)
    swept = _third_kind(rest, sn, cn, dn, ratio) + 2 * third_quarter * half_turns - swept_start
    odd = int((half_turns / 2).floor().unique_fmpz()) * 2 != int(half_turns.unique_fmpz())
    return ((-sn, -cn, dn) if odd else (sn, cn, dn)), swept


def _third_kind(u: arb, sn: arb, cn: arb, dn: arb, ratio: arb) -> arb:
    """∫_0^u dv/(1 + ratio sn² v) for |u| ≤ K."""
    return u - ratio / 3 * sn**3 * carlson_rj(cn**2, dn**2, 1 + ratio * sn**2)


def carlson_rj(x: arb, y: arb, p: arb) -> arb:
    return acb.elliptic_rj(x.nonnegative_part(), y, 1, p).real


def agm(a: arb, b: arb) -> arb:
    return acb(a).agm(acb(b)).real


def jacobi(u: arb, complementary_modulus: arb) -> tuple[arb, arb, arb]:
    """sn, cn, dn by descending Landen steps; every sum has terms of one sign, so small values stay sharp."""
    scale, moduli, other = arb(1), [], complementary_modulus
    negligible = arb(2) ** (-ctx.prec)
    while True:
        total = 1 + other
        step = (1 - other) / total
        moduli.append((step, 2 * other / total))
        scale = scale * 2 / total  # 1 + step
        other = 2 * other.sqrt() / total
        if step.abs_upper() ** 2 < negligible:
            break
    sn, cn = (u / scale).sin_cos()
    dn = arb(1)
    for step, one_minus_step in reversed(moduli):
        square = step * sn**2
        below = 1 + square
        sn, cn, dn = (1 + step) * sn / below, cn * dn / below, (one_minus_step + step * cn**2) / below
    return sn, cn, dn


def _on_separatrix(sn: arb, cn: arb, dn: arb, phase: arb, ratio: arb) -> tuple[tuple[arb, arb, arb], arb]:
    """The same at modulus 1, in hyperbolic functions; a negative cn stays negative for ever."""
    side = 1 if cn > 0 else -1
    start = (sn / dn).asinh()
    root = ratio.sqrt()
    u = start + phase * side  # sn = tanh u falls where cn is negative
    tanh, sech = u.tanh(), u.sech()

    def swept(v: arb) -> arb:
        return (v + root * (root * v.tanh()).atan()) / (1 + ratio)

    return (tanh, side * sech, sech), side * (swept(u) - swept(start))


def _steady_rotation(omega: list[fmpq], t: fmpq) -> list[list[arb]]:
    speed = arb(sum((w * w for w in omega), ZERO)).sqrt()
    x, y, z = (arb(w) / speed for w in omega)
    sine, cosine = (speed * arb(t)).sin_cos()
    half_sine = (speed * arb(t) / 2).sin()
    rise = 2 * half_sine**2
    return [
        [cosine + rise * x * x, rise * x * y - sine * z, rise * x * z + sine * y],
        [rise * x * y + sine * z, cosine + rise * y * y, rise * y * z - sine * x],
        [rise * x * z - sine * y, rise * y * z + sine * x, cosine + rise * z * z],
    ]


def _steady_quaternion(omega: list[fmpq], t: fmpq) -> list[arb]:
    speed = arb(sum((w * w for w in omega), ZERO)).sqrt()
    sine, cosine = (speed * arb(t) / 2).sin_cos()
    return [cosine, *(arb(w) / speed * sine for w in omega)]


def _identity() -> list[list[arb]]:
    return [[arb(int(i == j)) for j in range(3)] for i in range(3)]


def _cross(a: list[fmpq], b: list[fmpq]) -> list[fmpq]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
