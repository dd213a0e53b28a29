"""Newton's and Euler's laws for a hub with parts that move in it, in 40 digits, with the hub's acceleration unknown.

Every part is a body of its own: Newton's law gives the force on it, Euler's the couple, both from accelerations in
space, and what the hinges cannot hold is equal to springs, dampers and motors (Kane's projection). Nothing is
eliminated: not the centre of mass, whose acceleration comes out, and no momenta or energies are used. A pendulum is a
point on a sphere, without angles.

Vectors are lists of three numbers along the hub's axes. A motion is extrapolated from Gragg's midpoint steps.

Source: Kane & Levinson, *Dynamics* (1985), ch. 6; Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*
(1993), §II.9.
"""

from dataclasses import dataclass
from typing import Any

import mpmath as mp
import numpy as np

DIGITS = 40
LEVELS = 14


def add(*vectors):
    return [sum(x) for x in zip(*vectors, strict=True)]


def scale(number, vector):
    return [number * x for x in vector]


def dot(x, y):
    return sum(a * b for a, b in zip(x, y, strict=True))


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def times(matrix, vector):
    return [dot(row, vector) for row in matrix]


def spread(vector):
    square = dot(vector, vector)
    return [[square * (i == j) - vector[i] * vector[j] for j in range(3)] for i in range(3)]


def plus(*matrices):
    return [add(*rows) for rows in zip(*matrices, strict=True)]


def numbers(values):
    """Return doubles, in lists, as they are."""
    if isinstance(values, mp.mpf):
        return values
    return [numbers(x) for x in values] if np.ndim(values) else mp.mpf(float(values))


ZERO = [mp.mpf(0)] * 3


@dataclass
class Piece:
    """A rigid body of a part in the hub's axes: mass, place, velocity, acceleration but for q̈, ∂r/∂q; and turning."""

    mass: Any
    place: list
    speed: list
    bias: list
    shifts: list
    inertia: list | None = None
    turning: list | None = None
    turning_bias: list | None = None
    axes: list | None = None


class SprungMass:
    """State q, q̇ along perpendicular directions."""

    def __init__(self, place, directions, mass, stiffness, damping):
        self.place, self.mass = numbers(place), numbers(mass)
        self.stiffness, self.damping = numbers(stiffness), numbers(damping)
        rows = numbers(directions)
        self.directions = [scale(1 / mp.sqrt(dot(row, row)), row) for row in rows]
        self.count = len(rows)
        self.size = 2 * self.count

    def pieces(self, state):
        q, rate = state[: self.count], state[self.count :]
        place = add(self.place, *(scale(x, e) for x, e in zip(q, self.directions, strict=True)))
        speed = add(ZERO, *(scale(x, e) for x, e in zip(rate, self.directions, strict=True)))
        return [Piece(self.mass, place, speed, ZERO, self.directions)]

    def forces(self, t, state, omega):
        q, rate = state[: self.count], state[self.count :]
        return [-k * x - self.damping * v for k, x, v in zip(self.stiffness, q, rate, strict=True)]

    def rates(self, t, state, omega, found):
        return [*state[self.count :], *found]


class HingedPart:
    """State θ, θ̇; a point without inertia."""

    def __init__(self, hinge, axis, center, mass, inertia, stiffness, damping, motor=lambda t: 0):
        self.hinge, axis, self.mass = numbers(hinge), numbers(axis), numbers(mass)
        self.axis = scale(1 / mp.sqrt(dot(axis, axis)), axis)
        self.arm = add(numbers(center), scale(-1, self.hinge))
        self.inertia = None if inertia is None else numbers(inertia)
        self.stiffness, self.damping, self.motor = numbers(stiffness), numbers(damping), motor
        self.count, self.size = 1, 2

    def turned(self, angle, vector):
        along = scale(dot(self.axis, vector), self.axis)
        return add(along, scale(mp.cos(angle), add(vector, scale(-1, along))),
                   scale(mp.sin(angle), cross(self.axis, vector)))  # fmt: skip

    def pieces(self, state):
        angle, rate = state
        arm = self.turned(angle, self.arm)
        shift = cross(self.axis, arm)
        bias = scale(rate**2, cross(self.axis, shift))
        piece = Piece(self.mass, add(self.hinge, arm), scale(rate, shift), bias, [shift])
        if self.inertia is not None:
            # columns of R I, then R (R I)ᵀ
            half = [self.turned(angle, [row[j] for row in self.inertia]) for j in range(3)]
            back = [self.turned(angle, [half[j][i] for j in range(3)]) for i in range(3)]
            piece.inertia, piece.turning = back, scale(rate, self.axis)
            piece.turning_bias, piece.axes = ZERO, [self.axis]
        return [piece]

    def forces(self, t, state, omega):
        return [-self.stiffness * state[0] - self.damping * state[1] + self.motor(t)]

    def rates(self, t, state, omega, found):
        return [state[1], found[0]]


class SphericalPendulum:
    """State n, ṅ: the direction of the rod, a unit vector; q̈ are the accelerations along two vectors across it."""

    def __init__(self, pivot, arm, mass, stiffness, damping):
        self.pivot, arm, self.mass = numbers(pivot), numbers(arm), numbers(mass)
        self.length = mp.sqrt(dot(arm, arm))
        self.rest = scale(1 / self.length, arm)
        self.stiffness, self.damping = numbers(stiffness), numbers(damping)
        self.count, self.size = 2, 6

    def across(self, n):
        k = min(range(3), key=lambda j: abs(n[j]))
        first = cross(n, [mp.mpf(k == j) for j in range(3)])
        first = scale(1 / mp.sqrt(dot(first, first)), first)
        return [first, cross(n, first)]

    def pieces(self, state):
        n, rate, length = state[:3], state[3:], self.length
        bias = scale(-length * dot(rate, rate), n)
        shifts = [scale(length, e) for e in self.across(n)]
        return [Piece(self.mass, add(self.pivot, scale(length, n)), scale(length, rate), bias, shifts)]

    def forces(self, t, state, omega):
        # −∇ k (1 − n·n₀), and −c ṅ
        pull = add(scale(self.stiffness, self.rest), scale(-self.damping, state[3:]))
        return [dot(e, pull) for e in self.across(state[:3])]

    def rates(self, t, state, omega, found):
        n, rate = state[:3], state[3:]
        e, f = self.across(n)
        return [*rate, *add(scale(-dot(rate, rate), n), scale(found[0], e), scale(found[1], f))]


class Gyroscope:
    """A gimbal (γ, γ̇) with a rotor in it (rate σ): two bodies with their centres on the gimbal's axis."""

    def __init__(self, place, gimbal_axis, spin_axis, gimbal_inertia, rotor_axial, rotor_across, mass,
                 gimbal_torque, spin_torque):  # fmt: skip
        self.gimbal, self.spin = numbers(gimbal_axis), numbers(spin_axis)
        self.place, self.mass = numbers(place), numbers(mass)
        self.inertia = numbers(gimbal_inertia)
        self.axial, self.side = numbers(rotor_axial), numbers(rotor_across)
        self.gimbal_torque, self.spin_torque = gimbal_torque, spin_torque
        self.count, self.size = 2, 3

    def turned(self, angle, vector):
        along = scale(dot(self.gimbal, vector), self.gimbal)
        return add(along, scale(mp.cos(angle), add(vector, scale(-1, along))),
                   scale(mp.sin(angle), cross(self.gimbal, vector)))  # fmt: skip

    def pieces(self, state):
        angle, rate, spin = state
        axis = self.turned(angle, self.spin)
        half = [self.turned(angle, [row[j] for row in self.inertia]) for j in range(3)]
        frame = [self.turned(angle, [half[j][i] for j in range(3)]) for i in range(3)]
        rotor = [[self.side * (i == j) + (self.axial - self.side) * axis[i] * axis[j] for j in range(3)]
                 for i in range(3)]  # fmt: skip
        still = [ZERO, ZERO]
        return [
            Piece(self.mass, self.place, ZERO, ZERO, still, frame, scale(rate, self.gimbal), ZERO, [self.gimbal, ZERO]),
            Piece(mp.mpf(0), self.place, ZERO, ZERO, still, rotor, add(scale(rate, self.gimbal), scale(spin, axis)),
                  scale(rate * spin, cross(self.gimbal, axis)), [self.gimbal, axis]),
        ]  # fmt: skip

    def forces(self, t, state, omega):
        return [self.gimbal_torque(t, state), self.spin_torque(t, state)]

    def rates(self, t, state, omega, found):
        return [state[1], found[0], found[1]]


@dataclass
class Hub:
    """All together: mass, centre and inertia about it with the parts at rest, its parts, and torques on it.

    Attributes:
        push: (force, place) of t, along the hub's axes; None for none.
        orbit: mean motion of a circular orbit in the x-y plane from +x, whose gravity gradient acts on every body.
        burn: ṁ, tank, nozzle, exhaust velocity and inertia of a kilogram in the tank: mass that leaves from t = 0 on.
    """

    mass: Any
    center: list
    inertia: list
    parts: list
    rest: list
    push: Any = None
    orbit: Any = None
    burn: Any = None

    def __post_init__(self):
        self.mass, self.center, self.inertia = numbers(self.mass), numbers(self.center), numbers(self.inertia)
        # the hub alone: mass, first moment and inertia about the origin, less the parts at rest
        about = plus(self.inertia, [scale(self.mass, row) for row in spread(self.center)])
        mass, first = self.mass, scale(self.mass, self.center)
        for part, state in zip(self.parts, self.rest, strict=True):
            for piece in part.pieces(state):
                mass, first = mass - piece.mass, add(first, scale(-piece.mass, piece.place))
                about = plus(about, [scale(-piece.mass, row) for row in spread(piece.place)])
                if piece.inertia is not None:
                    about = plus(about, [scale(-1, row) for row in piece.inertia])
        place = scale(1 / mass, first)
        self.alone = Piece(mass, place, ZERO, ZERO, [], plus(about, [scale(-mass, row) for row in spread(place)]), ZERO,
                           ZERO, [])  # fmt: skip

    def rates(self, t, state):
        quaternion, omega, behind = state[:4], state[4:7], state[7:]
        owns = []
        for part in self.parts:
            owns.append(behind[: part.size])
            behind = behind[part.size :]
        count = sum(part.count for part in self.parts)
        bodies, start = [(self.alone, [None] * count)], 0
        for part, own in zip(self.parts, owns, strict=True):
            for piece in part.pieces(own):
                where = [None] * count
                for j in range(part.count):
                    where[start + j] = j
                bodies.append((piece, where))
            start += part.count
        size = 6 + count
        matrix, right = mp.zeros(size), mp.zeros(size, 1)
        if self.burn is not None:  # a body of negative mass, for the propellant that has left
            lost = numbers(self.burn[0]) * t
            inertia = [scale(-lost, row) for row in numbers(self.burn[4])]
            gone = Piece(-lost, numbers(self.burn[1]), ZERO, ZERO, [], inertia, ZERO, ZERO, [])
            bodies.append((gone, [None] * count))
            self.add_flow(right, bodies, omega)
        for piece, where in bodies:
            self.add_body(matrix, right, piece, where, omega)
        self.add_loads(right, bodies, t, quaternion)
        k = 6
        for part, own in zip(self.parts, owns, strict=True):
            for force in part.forces(t, own, omega):
                right[k] += force
                k += 1
        found = list(mp.lu_solve(matrix, right))
        w, x, y, z = quaternion
        a, b, c = omega
        turning = scale(mp.mpf("0.5"), [-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c,
                                        w * c + x * b - y * a])  # fmt: skip
        changes, k = [], 6
        for part, own in zip(self.parts, owns, strict=True):
            changes += part.rates(t, own, omega, found[k : k + part.count])
            k += part.count
        return [*turning, *found[3:6], *changes]

    def add_body(self, matrix, right, piece, where, omega):
        """Add one body to the sums of forces, of moments about the origin, and to the projections on each q̇."""
        units = [[mp.mpf(i == j) for i in range(3)] for j in range(3)]
        known = add(cross(omega, cross(omega, piece.place)), scale(2, cross(omega, piece.speed)), piece.bias)
        # the acceleration and angular acceleration that each unknown causes
        linear = [*units, *(cross(unit, piece.place) for unit in units)]
        angular = [ZERO, ZERO, ZERO, *units]
        for j in where:
            linear.append(ZERO if j is None else piece.shifts[j])
            angular.append(ZERO if j is None or piece.axes is None else piece.axes[j])
        couple = ZERO
        if piece.inertia is not None:
            whole = add(omega, piece.turning)
            known_turning = add(cross(omega, piece.turning), piece.turning_bias)
            couple = add(times(piece.inertia, known_turning), cross(whole, times(piece.inertia, whole)))
        for i in range(len(linear)):
            if linear[i] is ZERO and angular[i] is ZERO:
                continue
            right[i] -= piece.mass * dot(linear[i], known) + dot(angular[i], couple)
            for j in range(len(linear)):
                value = piece.mass * dot(linear[i], linear[j])
                if piece.inertia is not None:
                    value += dot(angular[i], times(piece.inertia, angular[j]))
                matrix[i, j] += value

    def add_flow(self, right, bodies, omega):
        """Add thrust, and what mass takes along: it vanishes from the tank, and leaves through the nozzle.

        d/dt Σ m v = Σ m a − ṁ v_t is the thrust less ṁ v_n, and so about a point at rest for the moments. Velocities
        are those against the centre of mass; Eke, NASA CR-1998-208246.
        """
        flow, tank, nozzle, exhaust, gyration = (numbers(x) for x in self.burn)
        whole = sum(piece.mass for piece, _ in bodies)
        speeds = [scale(piece.mass / whole, add(cross(omega, piece.place), piece.speed)) for piece, _ in bodies]
        drift = add(ZERO, *speeds)
        at_nozzle, at_tank = (add(cross(omega, x), scale(-1, drift)) for x in (nozzle, tank))
        thrust = scale(-flow, exhaust)
        force = add(thrust, scale(-flow, at_nozzle), scale(flow, at_tank))
        moment = add(cross(nozzle, add(thrust, scale(-flow, at_nozzle))), scale(flow, cross(tank, at_tank)),
                     scale(flow, times(gyration, omega)))  # fmt: skip
        for i, value in enumerate([*force, *moment]):
            right[i] += value

    def add_loads(self, right, bodies, t, quaternion):
        if self.push is not None:
            force, place = self.push(t)
            for i, value in enumerate([*force, *cross(place, force)]):
                right[i] += value
        if self.orbit is None:
            return
        w, x, y, z = quaternion
        n = numbers(self.orbit)
        c, s = mp.cos(n * t), mp.sin(n * t)
        centre = [c * (1 - 2 * (y * y + z * z)) + s * 2 * (x * y + w * z),
                  c * 2 * (x * y - w * z) + s * (1 - 2 * (x * x + z * z)),
                  c * 2 * (x * z + w * y) + s * 2 * (y * z - w * x)]  # fmt: skip
        middle = scale(1 / self.mass, add(*(scale(piece.mass, piece.place) for piece, _ in bodies)))
        for piece, where in bodies:
            away = add(piece.place, scale(-1, middle))
            force = scale(n**2 * piece.mass, add(scale(3 * dot(centre, away), centre), scale(-1, away)))
            couple = ZERO
            if piece.inertia is not None:
                couple = scale(3 * n**2, cross(centre, times(piece.inertia, centre)))
            for i, value in enumerate([*force, *add(cross(piece.place, force), couple)]):
                right[i] += value
            for k, j in enumerate(where):
                if j is not None:
                    right[6 + k] += dot(force, piece.shifts[j])
                    if piece.axes is not None:
                        right[6 + k] += dot(couple, piece.axes[j])


def integrate(rates, state, start, end, steps, levels=LEVELS):
    """Return the state at the end, by as many steps, each extrapolated from 2, 4, … 2 ``levels`` midpoint steps."""
    t, h = mp.mpf(start), (mp.mpf(end) - mp.mpf(start)) / steps
    counts = [2 * (k + 1) for k in range(levels)]
    for _ in range(steps):
        first, table = rates(t, state), []
        for k, count in enumerate(counts):
            small = h / count
            before, now = state, add(state, scale(small, first))
            for j in range(1, count):
                before, now = now, add(before, scale(2 * small, rates(t + j * small, now)))
            row = [now]
            for j in range(k):
                ratio = (mp.mpf(count) / counts[k - 1 - j]) ** 2 - 1
                row.append([a + (a - b) / ratio for a, b in zip(row[j], table[j], strict=True)])
            table = row
        state, t = table[-1], t + h
    return state
