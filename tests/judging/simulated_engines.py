"""Engines of known order, written out here with nothing of polhode's, and the same with mistakes."""

import numpy as np


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return np.array([a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
                     a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w])  # fmt: skip


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def matrix(q):
    w, x, y, z = q
    return np.array([[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]])  # fmt: skip


def unit(q):
    return q / np.sqrt(q @ q)


def equations(inertia, gyroscopic=1.0, factor=1.0, in_space=False, damping=0.0):
    inverse = np.linalg.inv(inertia)

    def slopes(q, L):
        w = inverse @ L
        turn = np.array([0.0, *w]) * (factor / 2.0)
        return product(turn, q) if in_space else product(q, turn), gyroscopic * cross(L, w) - damping * L

    return slopes


def explicit_euler(slopes):
    def step(q, L, h):
        a, b = slopes(q, L)
        return unit(q + h * a), L + h * b

    return step


def semi_implicit(slopes):
    def step(q, L, h):
        L = L + h * slopes(q, L)[1]
        return unit(q + h * slopes(q, L)[0]), L

    return step


def midpoint(slopes):
    def step(q, L, h):
        a, b = slopes(q, L)
        a, b = slopes(q + h / 2 * a, L + h / 2 * b)
        return unit(q + h * a), L + h * b

    return step


def rk4(slopes):
    def step(q, L, h):
        k1 = slopes(q, L)
        k2 = slopes(q + h / 2 * k1[0], L + h / 2 * k1[1])
        k3 = slopes(q + h / 2 * k2[0], L + h / 2 * k2[1])
        k4 = slopes(q + h * k3[0], L + h * k3[1])
        q, L = (y + h / 6 * (a + 2 * b + 2 * c + d) for y, a, b, c, d in zip((q, L), k1, k2, k3, k4, strict=True))
        return unit(q), L

    return step


def rk4_by_mean_rate(slopes):
    """Runge and Kutta's L, and an attitude turned by the mean of the four rates, as MuJoCo's RK4 does it."""
    inner = rk4(slopes)

    def step(q, L, h):
        k1 = slopes(q, L)[1]
        k2 = slopes(q, L + h / 2 * k1)[1]
        k3 = slopes(q, L + h / 2 * k2)[1]
        still = np.array([1.0, 0.0, 0.0, 0.0])
        # the rate of the identity under each stage's L is (0, ω)/2
        halves = [slopes(still, L + f * h * k)[0] for f, k in ((0, k1), (0.5, k1), (0.5, k2), (1, k3))]
        turn = h / 6 * (halves[0] + 2 * halves[1] + 2 * halves[2] + halves[3])
        half = np.sqrt(turn @ turn)
        small = np.array([np.cos(half), *(np.sinc(half / np.pi) * turn[1:])])
        return product(q, small), inner(q, L, h)[1]

    return step


ORDERS = {explicit_euler: 1, semi_implicit: 1, midpoint: 2, rk4: 4, rk4_by_mean_rate: 2}


def restoring(step):
    """The same with |L| as it was before each step."""

    def restored(q, L, h):
        size = np.sqrt(L @ L)
        q, L = step(q, L, h)
        return q, L * (size / np.sqrt(L @ L))

    return restored


def in_single_precision(inertia):
    """Semi-implicit Euler, all of whose numbers are float32."""
    moments = np.diag(inertia).astype(np.float32)

    def step(q, L, h):
        q, L, h = np.asarray(q, np.float32), np.asarray(L, np.float32), np.float32(h)
        L = L + h * cross(L, L / moments)
        x, y, z = h * L / moments / np.float32(2)
        p, a, b, c = q
        q = q + np.array([-a * x - b * y - c * z, p * x + b * z - c * y, p * y - a * z + c * x, p * z + a * y - b * x])
        return unit(q), L

    return step


def in_space_axes(inertia):
    """Keeps L along space axes, which nothing turns; ω = R I⁻¹ Rᵀ L at the beginning of the step."""
    inverse = np.linalg.inv(inertia)

    def step(q, L, h):
        R = matrix(q)
        return unit(q + h / 2 * product(np.array([0.0, *(R @ inverse @ R.T @ L)]), q)), L

    return step


def not_turned(inertia, start):
    """The same, with the inertia as it stood in space at the start."""
    R = matrix(start)
    inverse = R @ np.linalg.inv(inertia) @ R.T
    return lambda q, L, h: (unit(q + h / 2 * product(np.array([0.0, *(inverse @ L)]), q)), L)


def random_inertia(rng):
    """A tensor of a body: of points, so that it is one, turned anyhow."""
    points = rng.normal(size=(8, 3)) * rng.uniform(0.4, 1.6, size=3)
    return np.eye(3) * np.sum(points**2) - points.T @ points
