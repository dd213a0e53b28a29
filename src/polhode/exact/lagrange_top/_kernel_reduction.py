"""The steps of ``reduction`` for a block of tops, compiled by Numba, and which of them the kernels take.

Tops without weight and those with numbers farther apart than ``RANGE`` and ``SPREAD`` are left to NumPy. What cancels
by more than ``NEAR`` is summed exactly, as NumPy sums all.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import (
    Pair,
    add,
    bits_of,
    divide,
    multiply,
    multiply_float,
    of_bits,
    pair,
    put,
    scale,
    subtract,
    two_product,
    two_sum,
)
from polhode.exact.lagrange_top import _kernel_store as at

RANGE = 1e-100, 1e100  # of the first moment, of mgl and of the largest component of momentum
SPREAD = 2.0**-60  # of moments, weight, and components of momentum and attitude that are not zero: nothing underflows
NEAR = 2.0**-10  # of what cancels, where it is summed exactly
TINY = 2.0**-150  # below it, what is left after cancelling is NumPy's
TERMS = 128  # room for an exact sum and its parts
# where parts of an exact sum begin
S_, T_, N_, REAL, IMAGINARY, TWIST_, C_, ENERGY, REST, LOOSE = 0, 4, 8, 12, 16, 20, 24, 28, 33, 37


def _power(exponent: int) -> float:
    return of_bits((exponent + 1023) << 52)


def _exponent(x: float) -> int:
    """Return the exponent of ``frexp`` of a normal number, whatever its sign."""
    return ((bits_of(x) >> 52) & 2047) - 1022


def _apart(x: float, lowest: float) -> bool:
    return x == 0.0 or abs(x) >= lowest


def _load(w: Any, i: int, moments: Any, mgl: float, momentum: Any, attitude: Any) -> bool:
    """Turn and scale a top as ``reduction.reduce_top``; return whether its numbers are near enough together."""
    a, c, weight = moments[0], moments[2], abs(mgl)
    x, y, z = momentum[0], momentum[1], momentum[2]
    q0, q1, q2, q3 = attitude[0], attitude[1], attitude[2], attitude[3]
    turned = mgl < 0.0
    side = -1.0 if turned else 1.0
    largest = max(max(abs(x), abs(y)), abs(z))
    within = RANGE[0] < a < RANGE[1] and RANGE[0] < weight < RANGE[1] and (largest == 0.0 or RANGE[0] < largest)
    within = within and largest < RANGE[1] and SPREAD * a < c and SPREAD * c < a
    if not within:
        return False
    of_moment = _exponent(a)
    half = (of_moment + _exponent(weight) + 1) // 2
    of_momentum = max(_exponent(largest), half) if largest > 0.0 else half
    down, lower = _power(-of_moment), _power(-of_momentum)
    x, y, z, weight = x * lower, side * y * lower, side * z * lower, weight * _power(of_moment) * lower * lower
    w[at.I1 + i], w[at.I3 + i], w[at.L1 + i], w[at.L2 + i], w[at.L3 + i] = a * down, c * down, x, y, z
    w[at.E0 + i], w[at.E1 + i] = (-q1 if turned else q0), (q0 if turned else q1)
    w[at.E2 + i], w[at.E3 + i] = (q3 if turned else q2), (-q2 if turned else q3)
    w[at.REVERSED + i] = 1.0 if turned else 0.0
    w[at.SIZE + i], w[at.RATE + i] = _power(of_momentum), _power(of_momentum - of_moment)
    g = two_product(weight, a * down)
    put(w, at.G + i, scale(g, 2.0))
    near = _apart(x, SPREAD) and _apart(y, SPREAD) and _apart(z, SPREAD) and weight >= SPREAD
    near = near and _apart(q0, SPREAD) and _apart(q1, SPREAD) and _apart(q2, SPREAD) and _apart(q3, SPREAD)
    return near


def _spare(x: Pair, size: float) -> float:
    """Return a number below zero if more has cancelled of terms of this size than ``NEAR`` allows."""
    return abs(x[0]) - NEAR * size


@called
def _sums(w: Any, count: int) -> None:
    """Form |q|², S, T, in_phase, twist, c and c' of ``reduction._invariants``; UP is below zero if too much cancels."""
    for i in range(count):
        q0, q1, q2, q3 = w[at.E0 + i], w[at.E1 + i], w[at.E2 + i], w[at.E3 + i]
        x, y, z = w[at.L1 + i], w[at.L2 + i], w[at.L3 + i]
        S, T = add(two_product(q1, q1), two_product(q2, q2)), add(two_product(q0, q0), two_product(q3, q3))
        a, b, c, d = two_product(q1, q0), two_product(q2, q3), two_product(q1, q3), two_product(-q2, q0)
        real, imaginary = add(a, b), add(c, d)
        of_real, of_imaginary = abs(a[0]) + abs(b[0]), abs(c[0]) + abs(d[0])
        in_phase = subtract(multiply_float(real, x), multiply_float(imaginary, y))
        twist = scale(add(multiply_float(real, y), multiply_float(imaginary, x)), 2.0)
        below, above = multiply_float(S, 2.0 * z), multiply_float(T, 2.0 * z)
        c, c_plus = subtract(twist, below), add(twist, above)
        of_twist = 2.0 * (of_real * abs(y) + of_imaginary * abs(x))
        of_c = of_twist + abs(below[0])
        spare = min(_spare(in_phase, of_real * abs(x) + of_imaginary * abs(y)), _spare(twist, of_twist))
        put(w, at.NORM + i, add(S, T))
        put(w, at.S0 + i, S)
        put(w, at.T0 + i, T)
        put(w, at.P + i, in_phase)
        put(w, at.TWIST + i, twist)
        put(w, at.C + i, c)
        put(w, at.C_PLUS + i, c_plus)
        w[at.UP + i] = min(spare, min(_spare(c, of_c), _spare(c_plus, of_twist + abs(above[0]))))
        w[at.NOME + i] = of_c * abs(z)


@called
def _energies(w: Any, count: int) -> None:
    """Form |w|², F and D; NOME has the size of what is taken from F."""
    for i in range(count):
        x, y, z, n, g = w[at.L1 + i], w[at.L2 + i], w[at.L3 + i], pair(w, at.NORM + i), pair(w, at.G + i)
        w2 = add(two_product(x, x), two_product(y, y))
        kinetic, fall = multiply(n, w2), scale(multiply(g, pair(w, at.S0 + i)), 2.0)
        energy = subtract(kinetic, fall)
        F0 = subtract(energy, multiply_float(pair(w, at.C + i), z))
        D0 = subtract(multiply(n, subtract(scale(g, 2.0), two_product(z, z))), energy)
        of_energy = kinetic[0] + fall[0]
        of_D = of_energy + n[0] * (2.0 * g[0] + z * z)
        put(w, at.W2 + i, w2)
        put(w, at.F + i, F0)
        put(w, at.D + i, D0)
        w[at.UP + i] = min(w[at.UP + i], min(_spare(F0, of_energy + w[at.NOME + i]), _spare(D0, of_D)))


@called
def _quotients(w: Any, count: int) -> None:
    """Divide all by |q|²; products would need no fewer steps."""
    for i in range(count):
        n = pair(w, at.NORM + i)
        S, T = pair(w, at.S0 + i), pair(w, at.T0 + i)
        put(w, at.U0 + i, divide(subtract(T, S), n))
        put(w, at.S0 + i, divide(scale(S, 2.0), n))
        put(w, at.T0 + i, divide(scale(T, 2.0), n))
        put(w, at.P + i, divide(scale(pair(w, at.P + i), -2.0), n))
        for k in (at.TWIST, at.C, at.C_PLUS, at.F, at.D):
            put(w, k + i, divide(pair(w, k + i), n))


# ---------------------------------------------------------------------- exact sums


@called
def _products(t: Any, begin: int, end: int, factor: float, out: int) -> int:
    """Append the exact products of terms and a factor at ``out``; return where they end."""
    for j in range(begin, end):
        t[out], t[out + 1] = two_product(t[j], factor)
        out += 2
    return out


@called
def _sweeps(t: Any, begin: int, end: int, count: int) -> None:
    """Sweep as ``doubledouble._sweep``, ``count`` times."""
    for _ in range(count):
        running = t[begin]
        for j in range(begin + 1, end):
            running, error = two_sum(running, t[j])
            t[j - 1] = error
        t[end - 1] = running


@called
def _compressed(t: Any, end: int, count: int, to: int) -> None:
    """Move the sum of the loose terms up to ``end``, as ``count`` terms, to ``to``, ``doubledouble.compress``."""
    _sweeps(t, LOOSE, end, count + 1)
    for j in range(count):
        t[to + j] = t[end - count + j]


@called
def _put_quotient(w: Any, k: int, t: Any, begin: int, end: int, factor: float, n: Any) -> None:
    """Store a sum of terms times a power of two over n."""
    _sweeps(t, begin, end, 5)
    rest = t[begin]
    for j in range(begin + 1, end - 1):
        rest += t[j]
    put(w, k, divide(scale(two_sum(t[end - 1], rest), factor), n))


@called
def _exact(w: Any, i: int, t: Any) -> None:
    """Form the invariants of one top as ``reduction._invariants`` does."""
    q0, q1, q2, q3 = w[at.E0 + i], w[at.E1 + i], w[at.E2 + i], w[at.E3 + i]
    x, y, z, g, n = w[at.L1 + i], w[at.L2 + i], w[at.L3 + i], pair(w, at.G + i), pair(w, at.NORM + i)
    t[S_], t[S_ + 1] = two_product(q1, q1)
    t[S_ + 2], t[S_ + 3] = two_product(q2, q2)
    t[T_], t[T_ + 1] = two_product(q0, q0)
    t[T_ + 2], t[T_ + 3] = two_product(q3, q3)
    t[REAL], t[REAL + 1] = two_product(q1, q0)
    t[REAL + 2], t[REAL + 3] = two_product(q2, q3)
    t[IMAGINARY], t[IMAGINARY + 1] = two_product(q1, q3)
    t[IMAGINARY + 2], t[IMAGINARY + 3] = two_product(-q2, q0)
    for j in range(8):
        t[LOOSE + j] = t[S_ + j]
    _compressed(t, LOOSE + 8, 4, N_)
    end = _products(t, IMAGINARY, IMAGINARY + 4, -y, _products(t, REAL, REAL + 4, x, LOOSE))
    _compressed(t, end, 4, TWIST_)
    _put_quotient(w, at.P + i, t, TWIST_, TWIST_ + 4, -2.0, n)
    end = _products(t, IMAGINARY, IMAGINARY + 4, 2.0 * x, _products(t, REAL, REAL + 4, 2.0 * y, LOOSE))
    _compressed(t, end, 4, TWIST_)
    for part, sign, k in ((T_, 2.0, at.C_PLUS), (S_, -2.0, at.C)):
        end = _products(t, part, part + 4, sign * z, LOOSE)
        for j in range(4):
            t[end + j] = t[TWIST_ + j]
        _compressed(t, end + 4, 4, C_)
        for j in range(4):
            t[LOOSE + j] = t[C_ + j]
        _put_quotient(w, k + i, t, LOOSE, LOOSE + 4, 1.0, n)
    _put_quotient(w, at.TWIST + i, t, TWIST_, TWIST_ + 4, 1.0, n)
    _exact_energies(w, i, t, (x, y, z), g, n)


@called
def _exact_energies(w: Any, i: int, t: Any, momentum: Any, g: Any, n: Any) -> None:
    """Form F and D of one top from what ``_exact`` has found."""
    x, y, z = momentum
    end = LOOSE
    for factor in two_product(x, x):
        end = _products(t, N_, N_ + 4, factor, end)
    for factor in two_product(y, y):
        end = _products(t, N_, N_ + 4, factor, end)
    for factor in g:
        end = _products(t, S_, S_ + 4, -2.0 * factor, end)
    _compressed(t, end, 5, ENERGY)
    end = _products(t, C_, C_ + 4, -z, LOOSE)
    for j in range(5):
        t[end + j] = t[ENERGY + j]
    _put_quotient(w, at.F + i, t, LOOSE, end + 5, 1.0, n)
    t[REST], t[REST + 1] = 2.0 * g[0], 2.0 * g[1]
    t[REST + 2], t[REST + 3] = two_product(z, -z)
    end = LOOSE
    for j in range(4):
        end = _products(t, N_, N_ + 4, t[REST + j], end)
    for j in range(5):
        t[end + j] = -t[ENERGY + j]
    _put_quotient(w, at.D + i, t, LOOSE, end + 5, 1.0, n)


@called
def begin(moments: Any, mgl: Any, momentum: Any, attitude: Any, w: Any, place: Any, terms: Any) -> int:
    """Reduce a block; return how many of its tops the kernels may take. ``place`` has them."""
    count = 0
    for i in range(len(moments)):
        if _load(w, count, moments[i], mgl[i][0], momentum[i], attitude[i]):
            place[count] = i
            count += 1
    _sums(w, count)
    _energies(w, count)
    _quotients(w, count)
    for i in range(count):
        if w[at.UP + i] < 0.0:
            _exact(w, i, terms)
    for i in range(count):
        small = False
        for k in (at.P, at.C, at.C_PLUS, at.TWIST, at.F, at.D):
            small |= not (w[k + i] == 0.0 or abs(w[k + i]) > TINY)
        w[at.UP + i] = 1.0 if small else 0.0
    return count
