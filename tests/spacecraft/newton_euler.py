"""Newton's and Euler's laws for a rolling disk, in space vectors and 40 digits, with the contact force as an unknown.

Nothing of the frame equations is used: the attitude is a matrix, the contact is the lowest point of the rim, and the
rolling constraint is differentiated as a vector equation.
"""

import mpmath as mp

DIGITS = 40


def vector(*x):
    return mp.matrix([mp.mpf(k) for k in x])


def cross(x, y):
    return vector(x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])


def dot(x, y):
    return sum(p * q for p, q in zip(x, y, strict=True))


def accelerations(sizes, axis, omega, couple):
    """Return the angular acceleration and the contact force, in space.

    Args:
        sizes: m, a, b, A, C, g.
        axis: the disk's, from the face that touches inwards.
        omega: angular velocity.
        couple: of the laws of dissipation.
    """
    m, a, b, A, C, g = (mp.mpf(float(k)) for k in sizes)
    up = vector(0, 0, 1)
    # the face's direction of steepest ascent leads from the contact to the face's centre
    rise = up - dot(up, axis) * axis
    s = mp.sqrt(dot(rise, rise))
    arm = a * rise / s + b * axis  # contact to centre
    # its rate: the axis turns with the disk, the contact stays the lowest point
    axis_rate = cross(omega, axis)
    rise_rate = -dot(up, axis_rate) * axis - dot(up, axis) * axis_rate
    arm_rate = a * (rise_rate / s - rise * dot(rise, rise_rate) / s**3) + b * axis_rate
    inertia = A * mp.eye(3) + (C - A) * (axis * axis.T)
    gyroscopic = cross(omega, inertia * omega)
    # unknowns: α (3), contact force F (3)
    #   m (α × arm + ω × d(arm)/dt) = F − m g z,   J α + ω × J ω = −arm × F + couple
    matrix, right = mp.zeros(6), mp.zeros(6, 1)
    for k in range(3):
        unit = vector(*(1 if n == k else 0 for n in range(3)))
        column = m * cross(unit, arm)
        torque = cross(arm, unit)
        for n in range(3):
            matrix[n, k], matrix[n, 3 + k] = column[n], -unit[n]
            matrix[3 + n, k], matrix[3 + n, 3 + k] = inertia[n, k], torque[n]
    known = -m * g * up - m * cross(omega, arm_rate)
    for n in range(3):
        right[n], right[3 + n] = known[n], couple[n] - gyroscopic[n]
    found = mp.lu_solve(matrix, right)
    return found[:3], found[3:]
