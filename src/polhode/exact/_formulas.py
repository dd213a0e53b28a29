"""Formulas of both motions, each written once, over the functions of ``kernel_arithmetic``: the *words*.

Python runs them with single numbers. Copies are made for Numba, with ``compiled_arithmetic``, and for arrays of NumPy
or JAX, with ``array_arithmetic``; other languages are printed from them. So they are written in a small language, which
is that of all files named ``_formulas``:

* A value is a double, whether something holds, or a tuple of values. Records are classes of ``NamedTuple`` with
  annotated fields, made by place and never changed; double-double numbers are pairs (high, low). Only words look into
  a ``Sum``, whose terms are never added up.
* A function consists of assignments to names, also by taking a tuple apart, and of one ``return``. A name may be
  assigned again, to a value of the same kind.
* Expressions are names, numbers, constants of modules and of ``math``, ``+ - * /``, unary ``-``, ``abs``, comparisons
  of two values, ``&`` and ``|`` of what holds, fields, indices and slices by whole numbers, tuples, and calls by place
  of words, formulas and records.
* What depends on a number is a ``where`` of doubles or a ``choice`` of pairs, both sides of which are evaluated, or
  ``choose(condition, f, g, values)``, which evaluates one function of the values where it can. Loops are
  ``iterate(count, step, state)`` and ``iterate_until(step, finished, state, at_once, most)``. Functions are named in
  calls of these three alone.
* Where nothing depends on the order of evaluation, none is meant; sums and products are rounded as their parentheses
  say, and never contracted.
"""

from __future__ import annotations

from polhode.exact._kernel_arithmetic import (
    Pair,
    Rate,
    Time,
    add,
    binary_exponent,
    constant,
    divide,
    fast_two_sum,
    halves,
    iterate_until,
    multiply,
    nearest,
    phase,
    root,
    scale,
    smaller,
    square,
    square_root,
    subtract,
    times_power,
    two_sum,
)

CONVERGED = 2e-8  # the closing formulas of the mean leave an error of the fourth power
MOST_STEPS = 20
AT_ONCE = 3  # steps of all, before the first is looked at


def exponent(x: float, rest: float, upper: float, lower: float) -> Pair:
    """Return the leading part of −(x + rest)(upper + lower), which is exact, and the factor for the rest."""
    # −(x + rest)(upper + lower) = −high · upper − small, and e^(−small) to second order
    high, low = halves(x)
    small = (high * lower + low * (upper + lower)) + rest * upper
    return -(high * upper), 1.0 - small * (1.0 - 0.5 * small)


def reduced_argument(rate: Rate, start: Pair, periodic: float, time: Time) -> tuple[float, float, float]:
    """Return an argument in half periods as a number within ±½ and its rest, and the half periods taken out.

    On the separatrix, where ``periodic`` is zero, it runs to infinity and none is taken out.
    """
    fraction, rest, turned = phase(rate, time)
    total, first_error = two_sum((1.0 - periodic) * turned, fraction)
    u, second_error = two_sum(total, start[0])
    u, u_rest = fast_two_sum(u, rest + (start[1] + (first_error + second_error)))
    more = periodic * nearest(u)
    return u - more, u_rest, periodic * turned + more


def nome_per_parameter(parameter: float, k: float) -> float:
    """Return ``elliptic.nome_per_parameter``."""
    more = 1.0 + square_root(k)
    ratio = 0.5 / ((1.0 + k) * more * more)
    e = ratio * parameter
    e4 = (e * e) * (e * e)
    return ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))))


def by_theta(period: Pair, nome: float) -> Pair:
    """Return a period over θ3², of which 1/θ3² is 1 less a small correction."""
    q4 = (nome * nome) * (nome * nome)
    e = 2.0 * (nome + q4 + q4 * q4 * nome)
    return add(period, (-period[0] * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), 0.0))


def mean_step(a: Pair, g: Pair, pp: Pair, q: Pair, total: Pair) -> tuple[Pair, Pair, Pair, Pair, Pair]:
    """Take a step of the arithmetic–geometric mean and its third-kind sum, in double-double.

    With ε = (p²−ag)/(p²+ag), Q ← Qε/2 and p ← (p²+ag)/2p; the sum is of all Q, from Q = 1. Arithmetic and square roots
    alone give complete elliptic integrals of the first and third kind, so that the rates of exact motion carry thirty
    digits and their phases stay right for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231.
    """
    ag = multiply(a, g)
    both = add(pp, ag)
    q = scale(multiply(q, divide(subtract(pp, ag), both)), 0.5)
    return scale(add(a, g), 0.5), root(ag), scale(divide(square(both), pp), 0.25), q, add(total, q)


def mean_distance(a: Pair, g: Pair, pp: Pair) -> tuple[float, float, Pair]:
    """Return x = (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε."""
    middle = scale(add(a, g), 0.5)
    half = 0.5 * ((a[0] - g[0]) + (a[1] - g[1]))
    d = subtract(pp, square(middle))
    e = d[0] + d[1] + half * half
    return half / middle[0], e / (2.0 * middle[0] * middle[0] + e), middle


def mean_closed(x: float, e: float, middle: Pair, q: float, total: Pair) -> tuple[Pair, Pair]:
    """Return the mean and the sum of what ``mean_distance`` returns, exact where that is below ``CONVERGED``."""
    last = 0.5 * q * e
    rest = last + last * (0.25 * (e * e - 0.5 * x * x))
    # agm(1 + x, 1 − x) = 1 − x²/4 + O(x⁴)
    return add(middle, (-0.25 * middle[0] * x * x, 0.0)), add(total, (rest, 0.0))


# ---------------------------------------------------------------------- the mean, from its start to its end

Mean = tuple[Pair, Pair, Pair, Pair, Pair]  # a, g, p², Q and the sum of all Q


def mean_start(a: Pair, g: Pair, pp: Pair) -> tuple[Mean, float]:
    """Return where the mean of positive a and g begins, with the sum that starts from p², and the exponent taken out.

    Rates go down to 1e-150, whose fourth powers would underflow. Scaled down, a tiny g would.
    """
    power = smaller(binary_exponent(a[0]), 0.0 * a[0])
    up = times_power(1.0, -power)
    one = constant((1.0, 0.0), a[0])
    return (scale(a, up), scale(g, up), scale(scale(pp, up), up), one, one), power


def mean_next(state: Mean) -> Mean:
    """Return the mean after a step."""
    a, g, pp, q, total = state
    return mean_step(a, g, pp, q, total)


def mean_converged(state: Mean) -> bool:
    """Return whether the closing formulas are exact."""
    x, e, _ = mean_distance(state[0], state[1], state[2])
    return (abs(x) < CONVERGED) & (abs(e) < CONVERGED)


def mean_end(state: Mean) -> tuple[Pair, Pair]:
    """Return mean and sum, of which the first lacks the exponent taken out."""
    x, e, middle = mean_distance(state[0], state[1], state[2])
    return mean_closed(x, e, middle, state[3][0], state[4])


def third_kind_mean(a: Pair, g: Pair, pp: Pair) -> tuple[Pair, Pair]:
    """Return agm(a, g) of positive numbers, and the sum that starts from p² = pp."""
    state, power = mean_start(a, g, pp)
    mean, total = mean_end(iterate_until(mean_next, mean_converged, state, AT_ONCE, MOST_STEPS))
    return scale(mean, times_power(1.0, power)), total
