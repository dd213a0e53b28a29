"""Free bodies and tops to any number of digits by mpmath, without elliptic functions: an oracle for enclosures.

States are Taylor series of the equations of motion, q' = ½ q Ω and L' = L × Ω + mgl Γ × e3; periods and turns are
trapezoidal sums over an angle that goes round once, which converge exponentially as all integrands are periodic.
Inputs are rationals.

Source: Montgomery, Amer. J. Phys. 59 (1991) 394, for the cap; Trefethen & Weideman, SIAM Review 56 (2014) 385.
"""

from fractions import Fraction
from operator import mul

import mpmath as mp

BITS = 300
ORDER, SHARE = 100, 0.3  # terms, and the angle by which a motion turns in a step, about


def number(x):
    """Return a rational as mpmath has it."""
    x = Fraction(x)
    return mp.mpf(x.numerator) / x.denominator


def fraction(x):
    """Return a number of mpmath as the rational that it is."""
    sign, mantissa, exponent, _ = mp.mpf(x)._mpf_
    return (-1) ** sign * mantissa * Fraction(2) ** exponent


def integrated_state(moments, momentum, attitude, t, mgl=0):
    """Return quaternion and momentum at ``t`` by Taylor steps, in units of 2^−BITS and so with whole numbers."""
    inertia, L, q = ([number(x) for x in part] for part in (moments, momentum, attitude))
    norm, weight, t = mp.sqrt(sum(x * x for x in q)), number(mgl), number(t)
    rate = max(abs(x / i) for x, i in zip(L, inertia, strict=True)) + mp.sqrt(abs(weight) / min(inertia))
    steps = int(mp.ceil(abs(t) * rate / SHARE)) or 1
    fixed = [[_fixed(x) for x in part] for part in ([1 / x for x in inertia], [x / norm for x in q], L)]
    inverse, q, L = fixed
    for _ in range(steps):
        q, L = _step(inverse, q, L, _fixed(weight), _fixed(t / steps))
    return tuple([mp.ldexp(x, -BITS) for x in part] for part in (q, L))


def _fixed(x):
    return int(mp.floor(mp.ldexp(x, BITS)))


def _step(inverse, q, L, weight, h):
    """Return the state after a step, by the recurrences of the equations' quadratic terms; in fixed point."""
    q, L, up, spin = [[x] for x in q], [[x] for x in L], [[], [], []], [[], [], []]

    def product(a, b, n):
        return sum(map(mul, a, b[n::-1])) >> BITS

    for n in range(ORDER):
        for k in range(3):
            spin[k].append(L[k][n] * inverse[k] >> BITS)
        w, x, y, z = q
        up[0].append(2 * (product(x, z, n) - product(w, y, n)))
        up[1].append(2 * (product(y, z, n) + product(w, x, n)))
        torque = weight * up[1][n] >> BITS, -weight * up[0][n] >> BITS, 0
        rates = [product(L[k - 2], spin[k - 1], n) - product(L[k - 1], spin[k - 2], n) + torque[k] for k in range(3)]
        a, b, c = spin
        turning = (-product(x, a, n) - product(y, b, n) - product(z, c, n),
                   product(w, a, n) + product(y, c, n) - product(z, b, n),
                   product(w, b, n) + product(z, a, n) - product(x, c, n),
                   product(w, c, n) + product(x, b, n) - product(y, a, n))  # fmt: skip
        for row, value in zip(L, rates, strict=True):
            row.append((value * h >> BITS) // (n + 1))
        for row, value in zip(q, turning, strict=True):
            row.append((value * h >> BITS) // (2 * (n + 1)))
    return [sum(row) for row in q], [sum(row) for row in L]


def whole_sum(integrand, points):
    """Return the integral of a function of period 2π by equal steps."""
    return mp.fsum(integrand(2 * mp.pi * k / points) for k in range(points)) * 2 * mp.pi / points


def free_numbers(moments, momentum, around, points):
    """Return period, precession per period, solid angle and action of a polhode about an axis, by quadrature."""
    inertia, L = ([number(x) for x in part] for part in (moments, momentum))
    square = sum(x * x for x in L)
    twice_energy = sum(x * x / i for x, i in zip(L, inertia, strict=True))
    norm, k, i, j = mp.sqrt(square), around, (around + 1) % 3, (around + 2) % 3

    def parts(angle):
        c, s = mp.cos(angle), mp.sin(angle)
        across = (twice_energy - square / inertia[k]) / (c * c / inertia[i] + s * s / inertia[j] - 1 / inertia[k])
        along = mp.sqrt(square - across)
        rate = along * (c * c * (1 / inertia[i] - 1 / inertia[k]) - s * s * (1 / inertia[k] - 1 / inertia[j]))
        turning = norm * (twice_energy - along * along / inertia[k]) / across
        return along / norm, abs(rate), turning

    period = whole_sum(lambda angle: 1 / parts(angle)[1], points)
    turn = whole_sum(lambda angle: parts(angle)[2] / parts(angle)[1], points)
    cap = whole_sum(lambda angle: 1 - parts(angle)[0], points)
    return {"period": period, "precession_per_period": turn, "solid_angle": cap, "action": norm * cap / (2 * mp.pi)}


def top_numbers(moments, mgl, momentum, attitude, points):
    """Return limits, period, turns and action of a nutating top, mgl > 0, by quadrature."""
    (I1, _, I3), L, q = ([number(x) for x in part] for part in (moments, momentum, attitude))
    size = sum(x * x for x in q)
    w, x, y, z = q
    up = [2 * (x * z - w * y) / size, 2 * (y * z + w * x) / size, (w * w - x * x - y * y + z * z) / size]
    a, p = L[2], sum(r * s for r, s in zip(L, up, strict=True))
    k = 2 * I1 * number(mgl)
    e = L[0] ** 2 + L[1] ** 2 + k * up[2]
    roots = mp.polyroots([k, -e - a * a, 2 * p * a - k, e - p * p], maxsteps=500, extraprec=500)
    u1, u2, u3 = sorted(mp.re(root) for root in roots)

    def along(integrand):
        """Integrate a function of u over dt/I1 round the nutation."""
        def at(angle):
            u = (u1 + u2) / 2 - (u2 - u1) / 2 * mp.cos(angle)
            return integrand(u, angle) / mp.sqrt(k * (u3 - u))
        return whole_sum(at, points)  # fmt: skip

    period = I1 * along(lambda u, angle: 1)
    turn = along(lambda u, angle: (p - a * u) / (1 - u * u))
    spin = along(lambda u, angle: I1 * a / I3 - u * (p - a * u) / (1 - u * u))
    action = along(lambda u, angle: k * (u3 - u) * ((u2 - u1) / 2 * mp.sin(angle)) ** 2 / (1 - u * u)) / (2 * mp.pi)
    return {"limits": (u1, u2), "nutation_period": period, "precession_per_period": turn, "spin_per_period": spin,
            "action": action}  # fmt: skip
