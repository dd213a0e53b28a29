"""Jacobi's functions of a phase that grows with time, and integrals of the third kind along it, in balls.

The functions are quotients of theta functions, the integrals Carlson's; no code is shared with the doubles of
``polhode.special`` and ``polhode.exact``, so that each may test the other.

Source: DLMF §20.2, §22.2, §19.25; Carlson, Numer. Algorithms 10 (1995) 13; Johansson, Arb, IEEE Trans. Comput. 66
(2017) 1281.
"""

from __future__ import annotations

import abc
from typing import Any, NamedTuple

from flint import acb, arb

from polhode.analysis._exact_arithmetic import Ball


def quarter_period(parameter1: Ball) -> Ball:
    """Return K(m) from 1 − m > 0, by the arithmetic–geometric mean."""
    return arb.pi() / 2 / arb(1).agm(parameter1.sqrt())


def _third_kind_excess(sn: Ball, cn: Ball, dn: Ball, n: Ball, n1: Ball) -> Ball:
    """Return ∫ du/(1 − n sn²) − u from 0 to a place within a quarter period, n1 = 1 − n."""
    square = cn * cn
    across = square + n1 * sn * sn
    return n / 3 * sn * sn * sn * acb.elliptic_rj(acb(square.nonnegative_part()), acb(dn * dn), 1, acb(across)).real


class Place(NamedTuple):
    """A point of an oscillation: sn, cn, dn, and the number of half periods split off from the phase."""

    phase: Ball  # without the half periods
    half_periods: int
    sn: Ball
    cn: Ball
    dn: Ball

    @property
    def sign(self) -> int:
        """−1 after an odd number of half periods."""
        return -1 if self.half_periods % 2 else 1


class Oscillation(abc.ABC):
    """Jacobi's functions at parameter m, started from a given place."""

    start: Place

    @abc.abstractmethod
    def after(self, phase: Ball) -> Place:
        """Return the place after a phase."""

    @abc.abstractmethod
    def third_kind(self, place: Place, n: Ball, n1: Ball) -> Ball:
        """Return ∫ du/(1 − n sn² u) from the zero of sn with the place's count of half periods up to it."""

    @abc.abstractmethod
    def swept(self, place: Place, n: Ball, n1: Ball) -> Ball:
        """Return ∫ du/(1 − n sn² u), n1 = 1 − n > 0, from the start to a place."""


class Periodic(Oscillation):
    """The oscillation for m < 1.

    Args:
        parameter, parameter1: m and 1 − m, each sharp relative to its own size.
        sn, cn: at the start; a cn that may be zero is exactly zero.
    """

    def __init__(self, parameter: Ball, parameter1: Ball, sn: Ball, cn: Ball) -> None:
        self.parameter1 = parameter1
        self.quarter = quarter_period(parameter1)
        self.thetas: Any = None
        if not parameter == 0:
            self.tau = acb(0, quarter_period(parameter) / self.quarter)
            _, c2, c3, c4 = (c.real for c in acb.modular_theta(acb(0), self.tau))
            self.thetas = c3 / c2, c4 / c2, c4 / c3
        half_periods = bool(cn < 0)
        sign = -1 if half_periods else 1
        dn = (cn * cn + parameter1 * sn * sn).sqrt()
        first = sign * sn * acb.elliptic_rf(acb(cn * cn), acb(dn * dn), 1).real
        self.start = Place(first, int(half_periods), sn, cn, dn)

    def after(self, phase: Ball) -> Place:
        start = self.start
        whole = start.phase + phase
        count = (whole / (2 * self.quarter)).mid() + arb("0.5")
        halves = int(count.floor().unique_fmpz() or 0)
        rest = whole - 2 * self.quarter * halves
        halves += start.half_periods
        sn, cn, dn = self._functions(rest)
        sign = -1 if halves % 2 else 1
        return Place(rest, halves, sign * sn, sign * cn, dn)

    def _functions(self, rest: Ball) -> tuple[Ball, Ball, Ball]:
        if self.thetas is None:
            return *rest.sin_cos(), arb(1)
        t1, t2, t3, t4 = (t.real for t in acb.modular_theta(acb(rest / (2 * self.quarter)), self.tau))
        by_sn, by_cn, by_dn = self.thetas
        return by_sn * t1 / t4, by_cn * t2 / t4, by_dn * t3 / t4

    def complete(self, n: Ball, n1: Ball) -> Ball:
        """Return ∫ du/(1 − n sn²) over a quarter period."""
        if n == 0:
            return self.quarter
        return self.quarter + n / 3 * acb.elliptic_rj(0, acb(self.parameter1), 1, acb(n1)).real

    def third_kind(self, place: Place, n: Ball, n1: Ball) -> Ball:
        if n == 0:
            return place.phase
        sign = place.sign
        integral = place.phase + _third_kind_excess(sign * place.sn, sign * place.cn, place.dn, n, n1)
        if bool(abs(place.phase) <= self.quarter):
            return integral
        # the ball reaches beyond the quarter period, where the integral was taken as far on the near side
        beyond = (abs(place.phase).upper() - self.quarter).upper()
        return integral + arb(0, (2 * beyond * abs(n) / n1.min(arb(1))).upper())

    def swept(self, place: Place, n: Ball, n1: Ball) -> Ball:
        start = self.start
        halves = place.half_periods - start.half_periods
        whole = 2 * halves * self.complete(n, n1) if halves else arb(0)
        return whole + self.third_kind(place, n, n1) - self.third_kind(start, n, n1)

    def mean_square(self) -> Ball:
        """Return the mean of sn² over a period: (K − E)/mK."""
        return acb.elliptic_rd(0, acb(self.parameter1), 1).real / 3 / self.quarter


class Separatrix(Oscillation):
    """The oscillation for m = 1, in hyperbolic functions; cn keeps its sign."""

    def __init__(self, sn: Ball, cn: Ball) -> None:
        half_periods = bool(cn < 0)
        first = (sn / cn).asinh()  # of both, without the half period
        self.start = Place(first, int(half_periods), sn, cn, abs(cn))

    def after(self, phase: Ball) -> Place:
        last, sign = self.start.phase + phase, self.start.sign
        return Place(last, self.start.half_periods, sign * last.tanh(), sign * last.sech(), last.sech())

    def third_kind(self, place: Place, n: Ball, n1: Ball) -> Ball:
        tanh = place.sign * place.sn
        if n == 0:
            return place.phase
        if bool(n < 0):
            root = (-n).sqrt()
            return (place.phase + root * (root * tanh).atan()) / n1
        root = n.sqrt()
        return (place.phase - root * (root * tanh).atanh()) / n1

    def swept(self, place: Place, n: Ball, n1: Ball) -> Ball:
        return self.third_kind(place, n, n1) - self.third_kind(self.start, n, n1)
