"""A spacecraft with wheels, gravity gradient, rods and a PD law in mpmath, its equations written once more.

Nothing of polhode is used. State: quaternion of the given axes, Ω along them, momenta of the wheels; equations about
the centre of mass with rotation matrices, steps by extrapolation of the midpoint rule.
"""

import mpmath as mp


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def times(matrix, vector):
    return [dot(row, vector) for row in matrix]


def matrix_of(q):
    w, x, y, z = q
    return [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]


def transposed(matrix):
    return [list(column) for column in zip(*matrix, strict=True)]


def product(a, b):
    return [[dot(row, column) for column in transposed(b)] for row in a]


class Craft:
    """The spacecraft.

    Args:
        inertia: (3, 3) with wheels locked; axes, moment, friction: of the wheels.
        stiffness, damping: (3, 3) gains of the law τ = −2 P v − D (Ω − Ω_t), v from the matrix of the turn.
        orbit: semi-major axis, GM, eccentricity, mean anomaly, inclination, node, periapsis.
        dump: gain of the rods, and g with the Earth's rotation and radius.
    """

    def __init__(self, inertia, axes, moment, friction, stiffness, damping, orbit, dump=None):
        exact = lambda value: [exact(x) for x in value] if isinstance(value, list | tuple) else mp.mpf(value)  # noqa: E731
        self.inertia, self.moment, self.friction = exact(inertia), mp.mpf(moment), mp.mpf(friction)
        self.axes = [[x / mp.sqrt(dot(axis, axis)) for x in axis] for axis in exact(axes)]
        self.stiffness, self.damping = exact(stiffness), exact(damping)
        self.orbit, self.dump = exact(orbit), None if dump is None else exact(dump)
        count = len(self.axes)
        columns = mp.matrix(3, count)
        for k, axis in enumerate(self.axes):
            for i in range(3):
                columns[i, k] = axis[i]
        shares = columns.T * (columns * columns.T) ** -1
        self.shares = [[shares[k, i] for i in range(3)] for k in range(count)]
        spins = self.moment * columns * columns.T
        carrier = mp.matrix(self.inertia) - spins
        inverse = carrier**-1
        self.carrier = [[carrier[i, j] for j in range(3)] for i in range(3)]
        self.inverse = [[inverse[i, j] for j in range(3)] for i in range(3)]

    def place(self, t):
        """Return direction, distance, velocity direction in the orbit, normal, and ḟ."""
        a, gm, e, start, i, node, peri = self.orbit
        n = mp.sqrt(gm / a**3)
        M = n * t + start
        E = M + e * mp.sin(M)
        for _ in range(8):  # Newton's steps double the digits
            E -= (E - e * mp.sin(E) - M) / (1 - e * mp.cos(E))
        r = a * (1 - e * mp.cos(E))
        f = mp.atan2(mp.sqrt(1 - e * e) * mp.sin(E), mp.cos(E) - e)
        u = peri + f
        out = [mp.cos(node) * mp.cos(u) - mp.sin(node) * mp.sin(u) * mp.cos(i),
               mp.sin(node) * mp.cos(u) + mp.cos(node) * mp.sin(u) * mp.cos(i), mp.sin(u) * mp.sin(i)]
        normal = [mp.sin(node) * mp.sin(i), -mp.cos(node) * mp.sin(i), mp.cos(i)]
        rate = mp.sqrt(gm * a * (1 - e * e)) / r**2
        return out, r, cross(normal, out), normal, rate

    def rates(self, t, state):
        q, spin, momenta = state[:4], state[4:7], state[7:]
        R = matrix_of(q)
        back = transposed(R)
        out, r, ahead, normal, turning = self.place(t)
        # gravity gradient: 3 GM/r³ ô × I ô
        o = times(back, out)
        torque = [3 * self.orbit[1] / r**3 * x for x in cross(o, times(self.inertia, o))]
        if self.dump is not None:
            gain, g, earth, radius, greenwich = self.dump
            angle = greenwich + earth * t
            turned = [g[0] * mp.cos(angle) - g[1] * mp.sin(angle), g[0] * mp.sin(angle) + g[1] * mp.cos(angle), g[2]]
            field = times(back, [(radius / r) ** 3 * (3 * dot(turned, out) * x - y) for x, y in
                                 zip(out, turned, strict=True)])
            stored = [0, 0, 0]
            for h, axis in zip(momenta, self.axes, strict=True):
                stored = [s + (h - self.moment * dot(axis, spin)) * x for s, x in zip(stored, axis, strict=True)]
            share = dot(field, stored) / dot(field, field)
            torque = [x - gain * (s - share * b) for x, s, b in zip(torque, stored, field, strict=True)]
        # the axes that look down: x ahead, y against the normal, z down; error matrix Tᵀ R
        target = transposed([ahead, [-x for x in normal], [-x for x in out]])
        error = product(transposed(target), R)
        trace = error[0][0] + error[1][1] + error[2][2]
        w = mp.sqrt(1 + trace) / 2  # positive: the shorter way
        v = [(error[2][1] - error[1][2]) / (4 * w), (error[0][2] - error[2][0]) / (4 * w),
             (error[1][0] - error[0][1]) / (4 * w)]
        aim = times(back, [turning * x for x in normal])
        wrong = [x - y for x, y in zip(spin, aim, strict=True)]
        wanted = [-2 * x - y for x, y in zip(times(self.stiffness, v), times(self.damping, wrong), strict=True)]
        whole = times(self.carrier, spin)
        changes, reaction = [], [0, 0, 0]
        for h, axis, share in zip(momenta, self.axes, self.shares, strict=True):
            motor = -dot(share, wanted) - self.friction * (h / self.moment - dot(axis, spin))
            changes.append(motor)
            whole = [x + h * y for x, y in zip(whole, axis, strict=True)]
            reaction = [x + motor * y for x, y in zip(reaction, axis, strict=True)]
        total = [x + y - z for x, y, z in zip(cross(whole, spin), torque, reaction, strict=True)]
        w0, x0, y0, z0 = q
        p1, p2, p3 = spin
        turn = [(-x0 * p1 - y0 * p2 - z0 * p3) / 2, (w0 * p1 + y0 * p3 - z0 * p2) / 2,
                (w0 * p2 + z0 * p1 - x0 * p3) / 2, (w0 * p3 + x0 * p2 - y0 * p1) / 2]
        return [*turn, *times(self.inverse, total), *changes]


def integrate(rates, state, end, steps, columns=14):
    """Return the state at the end by Gragg's midpoint rule, extrapolated in h² (Hairer, Nørsett & Wanner, §II.9)."""
    h, t = mp.mpf(end) / steps, mp.mpf(0)
    for _ in range(steps):
        table = []
        for j in range(columns):
            parts = 2 * (j + 1)
            small = h / parts
            before, slope = state, rates(t, state)
            now = [x + small * y for x, y in zip(state, slope, strict=True)]
            for k in range(1, parts):
                slope = rates(t + k * small, now)
                before, now = now, [x + 2 * small * y for x, y in zip(before, slope, strict=True)]
            row = [now]
            for k in range(1, j + 1):
                factor = (mp.mpf(parts) / (2 * (j - k + 1))) ** 2 - 1
                row.append([x + (x - y) / factor for x, y in zip(row[k - 1], table[j - 1][k - 1], strict=True)])
            table.append(row)
        state, t = table[-1][-1], t + h
    return state
