"""Rotations as unit quaternions (w, x, y, z), body → space, and conversions to and from them.

Every function takes leading batch axes, and NumPy, JAX or any array-API arrays. Products follow Hamilton:
R(p q) = R(p) R(q). Formulas: Shuster, J. Astronaut. Sci. 41 (1993) 439, with the scalar moved to the front.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from polhode._base.arrays import as_float64, compiled, is_traced, known_false, namespace
from polhode._base.extras import needing
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

Part = Float64[ArrayOrFloat, "..."]
__all__ = [
    "angle_between",
    "as_matrix",
    "as_rotation_vector",
    "as_scipy",
    "conjugate",
    "from_axis_angle",
    "from_euler_angles",
    "from_matrix",
    "from_rotation_vector",
    "from_scipy",
    "hat",
    "multiply",
    "normalize",
    "perpendicular",
    "quaternion_rate",
    "rotate",
    "shortest_between",
    "vee",
]


class RotationLimits(NamedTuple):
    """Errors beyond which an input is refused as a mistake, and a sum that is rounding."""

    max_length_error: float = 1e-6  # of a unit quaternion
    max_orthogonality_error: float = 1e-6  # of each entry of Rᵀ R
    max_sum_of_opposite: float = 4e-16  # length of the sum of two unit vectors that are opposite to rounding


LIMITS = RotationLimits()


def _arrays(**named: Array) -> tuple[Any, list[Array]]:
    sizes = {"quaternion": 4, "p": 4, "q": 4, "vector": 3, "angular_velocity": 3, "matrix": 3}
    xp = namespace(*named.values())
    values = [as_float64(xp, value, name) for name, value in named.items()]
    for name, value in zip(named, values, strict=True):
        wanted = sizes[name]
        shape = tuple(value.shape)
        if shape[-1:] != (wanted,) or (name == "matrix" and shape[-2:] != (3, 3)):
            expected = "(..., 3, 3)" if name == "matrix" else f"(..., {wanted})"
            raise InvalidInput(f"`{name}` must have shape {expected}; got {shape}.")
    return xp, values


def _parts(value: Array) -> list[Array]:
    return [value[..., k] for k in range(value.shape[-1])]


def multiply(p: Real[ArrayLike, "*#batch 4"], q: Real[ArrayLike, "*#batch 4"]) -> Float64[Array, "*batch 4"]:
    """Return the Hamilton product p q, shape (…, 4): first q, then p."""
    xp, (p, q) = _arrays(p=p, q=q)
    return xp.stack(product_of_parts(_parts(p), _parts(q)), axis=-1)


def product_of_parts(p: Sequence[Part], q: Sequence[Part]) -> tuple[Part, Part, Part, Part]:
    """Return the four components of p q from those of p and q, where they are kept apart."""
    (a, b, c, d), (w, x, y, z) = p, q
    return (
        ((a * w - b * x) - c * y) - d * z,
        ((a * x + b * w) + c * z) - d * y,
        ((a * y - b * z) + c * w) + d * x,
        ((a * z + b * y) - c * x) + d * w,
    )


def quaternion_rate(
    quaternion: Real[ArrayLike, "*#batch 4"], angular_velocity: Real[ArrayLike, "*#batch 3"]
) -> Float64[Array, "*batch 4"]:
    """Return dq/dt = ½ q (0, Ω), shape (…, 4) [1/s], of an attitude whose body turns with Ω.

    Args:
        quaternion: (…, 4) q, body → space; its rate is linear in it, and has its length.
        angular_velocity: (…, 3) Ω [rad/s, body axes].

    >>> quaternion_rate([0.6, 0.0, 0.0, 0.8], [0.0, 0.0, 4.0]).tolist()
    [-1.6, 0.0, 0.0, 1.2]
    """
    xp, (q, v) = _arrays(quaternion=quaternion, angular_velocity=angular_velocity)
    return 0.5 * xp.stack(product_with_vector(_parts(q), _parts(v)), axis=-1)


def product_with_vector(q: Sequence[Part], vector: Sequence[Part]) -> tuple[Part, ...]:
    """Return the four components of q (0, v) from those of q and v, where they are kept apart."""
    (w, x, y, z), (a, b, c) = q, vector
    return -((x * a + y * b) + z * c), (w * a + y * c) - z * b, (w * b - x * c) + z * a, (w * c + x * b) - y * a


def cross_of_parts(a: Sequence[Part], b: Sequence[Part]) -> tuple[Part, Part, Part]:
    """Return the three components of a × b from those of a and b, where they are kept apart."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def conjugate(quaternion: Real[ArrayLike, "*batch 4"]) -> Float64[Array, "*batch 4"]:
    """Return the conjugate (w, −x, −y, −z), the inverse of a unit quaternion."""
    xp, (q,) = _arrays(quaternion=quaternion)
    return q * xp.asarray([1.0, -1.0, -1.0, -1.0], dtype=xp.float64)


def normalize(quaternion: Real[ArrayLike, "*batch 4"]) -> Float64[Array, "*batch 4"]:
    """Return the unit quaternion along the given one.

    Raises:
        InvalidInput: for a quaternion of zero length, which is not a rotation.
    """
    xp, (q,) = _arrays(quaternion=quaternion)
    largest = xp.max(xp.abs(q), axis=-1, keepdims=True)
    if known_false(xp.all((largest > 0) & xp.isfinite(largest))):
        raise InvalidInput("`quaternion` must be finite and not zero; a zero quaternion is not a rotation.")
    q = q / largest
    return q / xp.sqrt(xp.sum(q * q, axis=-1, keepdims=True))


def _refuse_not_unit(q: Array) -> None:
    """Refuse quaternions that would also stretch, unless they are traced; NaN, which marks a failure, passes."""
    if is_traced(q):
        return
    lengths = np.linalg.norm(np.asarray(q), axis=-1)
    wrong = np.abs(lengths - 1.0) > LIMITS.max_length_error
    if wrong.any():
        raise InvalidInput(
            f"`quaternion` must have length 1; got length {lengths[wrong].flat[0]:.6g}. Divide it by its norm, as "
            "`rotation.normalize` does."
        )


def rotate(
    quaternion: Real[ArrayLike, "*#batch 4"], vector: Real[ArrayLike, "*#batch 3"]
) -> Float64[Array, "*batch 3"]:
    """Return the vector (…, 3) rotated from body to space: v + 2w u×v + 2 u×(u×v).

    Raises:
        InvalidInput: for a quaternion that is not of unit length.
    """
    xp, (q, v) = _arrays(quaternion=quaternion, vector=vector)
    _refuse_not_unit(q)
    (w, *u), components = _parts(q), _parts(v)
    across = [2.0 * x for x in cross_of_parts(u, components)]
    parts = zip(components, across, cross_of_parts(u, across), strict=True)
    return xp.stack([x + w * t + further for x, t, further in parts], axis=-1)


def as_matrix(quaternion: Real[ArrayLike, "*batch 4"]) -> Float64[Array, "*batch 3 3"]:
    """Return the rotation matrix (…, 3, 3), v_space = R v_body.

    Raises:
        InvalidInput: for a quaternion that is not of unit length.
    """
    _, (q,) = _arrays(quaternion=quaternion)
    _refuse_not_unit(q)
    return compiled(_matrix, q)(q)


def _matrix(q: Float64[Array, "*batch 4"]) -> Float64[Array, "*batch 3 3"]:
    xp = namespace(q)
    w, x, y, z = _parts(q)
    # R = (w² − |u|²) 1 + 2 u uᵀ + 2w hat(u), with u = (x, y, z)
    rows = (
        ((w * w + x * x) - (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), (w * w + y * y) - (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), (w * w + z * z) - (x * x + y * y)),
    )
    return xp.stack([xp.stack(row, axis=-1) for row in rows], axis=-2)


def from_matrix(matrix: Real[ArrayLike, "*batch 3 3"]) -> Float64[Array, "*batch 4"]:
    """Return the unit quaternion of a rotation matrix (…, 3, 3), with its largest component positive.

    Raises:
        InvalidInput: for a matrix that is not a proper rotation.

    Source: Shepperd, J. Guid. Control 1 (1978) 223: the largest of four candidates leads, so nothing cancels.
    """
    xp, (m,) = _arrays(matrix=matrix)
    if not is_traced(m):
        _refuse_improper(np.asarray(m))
    a, b, c = m[..., 0, 0], m[..., 1, 1], m[..., 2, 2]
    p, q, r = m[..., 2, 1], m[..., 0, 2], m[..., 1, 0]
    s, t, u = m[..., 1, 2], m[..., 2, 0], m[..., 0, 1]
    # row k is 4 q_k (w, x, y, z), since 1 + tr R = 4w², R32 − R23 = 4wx, R21 + R12 = 4xy and so on
    candidates = (
        (1.0 + a + b + c, p - s, q - t, r - u),
        (p - s, 1.0 + a - b - c, r + u, q + t),
        (q - t, r + u, 1.0 - a + b - c, p + s),
        (r - u, q + t, p + s, 1.0 - a - b + c),
    )
    squares = [row[k] for k, row in enumerate(candidates)]
    best = squares[0]
    chosen = xp.stack(candidates[0], axis=-1)
    for row, square in zip(candidates[1:], squares[1:], strict=True):
        better = square > best
        chosen = xp.where(better[..., None], xp.stack(row, axis=-1), chosen)
        best = xp.where(better, square, best)
    return chosen / xp.sqrt(xp.sum(chosen * chosen, axis=-1, keepdims=True))


def _refuse_improper(m: np.ndarray) -> None:
    error = np.abs(np.sum(m[..., :, :, None] * m[..., :, None, :], axis=-3) - np.eye(3))
    a, b, c = (m[..., k, :] for k in range(3))
    determinant = (
        a[..., 0] * (b[..., 1] * c[..., 2] - b[..., 2] * c[..., 1])
        - a[..., 1] * (b[..., 0] * c[..., 2] - b[..., 2] * c[..., 0])
        + a[..., 2] * (b[..., 0] * c[..., 1] - b[..., 1] * c[..., 0])
    )
    if not np.all(error < LIMITS.max_orthogonality_error):
        raise InvalidInput("`matrix` must be orthogonal, Rᵀ R = 1, to 1e-6; orthogonalise it or check its entries.")
    if not np.all(determinant > 0):
        raise InvalidInput("`matrix` must be a proper rotation, det R = +1; got a reflection. Flip one axis.")


def from_rotation_vector(vector: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 4"]:
    """Return exp of a rotation vector (…, 3) [rad] as a unit quaternion; smooth through zero."""
    xp, (v,) = _arrays(vector=vector)
    square = xp.sum(v * v, axis=-1, keepdims=True)
    small = square < 1e-6
    angle = xp.sqrt(xp.where(small, 1.0, square))
    # sin(a/2)/a and cos(a/2) with a the angle; near zero their series in a²
    half_sinc = xp.where(
        small, 0.5 - square / 48.0 + square * square / 3840.0, xp.sin(0.5 * angle) / angle
    )
    cosine = xp.where(small, 1.0 - square / 8.0 + square * square / 384.0, xp.cos(0.5 * angle))
    return xp.concat([cosine, half_sinc * v], axis=-1)


def as_rotation_vector(quaternion: Real[ArrayLike, "*batch 4"]) -> Float64[Array, "*batch 3"]:
    """Return log of a unit quaternion as a rotation vector (…, 3) [rad] of length ≤ π; smooth through zero."""
    xp, (q,) = _arrays(quaternion=quaternion)
    q = xp.where(q[..., :1] < 0, -q, q)
    w, v = q[..., :1], q[..., 1:]
    square = xp.sum(v * v, axis=-1, keepdims=True)
    small = square < 1e-6
    sine = xp.sqrt(xp.where(small, 1.0, square))
    # 2 atan(s/w)/s as a series in (s/w)²
    ratio = square / xp.where(small, w * w, 1.0)
    series = 2.0 / xp.where(small, w, 1.0) * (1.0 - ratio / 3.0 + ratio * ratio / 5.0)
    return v * xp.where(small, series, 2.0 * xp.atan2(sine, w) / sine)


def from_axis_angle(
    axis: Real[ArrayLike, "*#batch 3"], angle: Real[ArrayLike, "*#batch"]
) -> Float64[Array, "*batch 4"]:
    """Return the rotation by an angle [rad] about an axis (…, 3), which need not be of unit length."""
    xp = namespace(axis, angle)
    axis = as_float64(xp, axis, "axis")
    angle = as_float64(xp, angle, "angle")
    largest = xp.max(xp.abs(axis), axis=-1, keepdims=True)
    if known_false(xp.all(largest > 0)):
        raise InvalidInput("`axis` must not be zero; a rotation needs a direction.")
    unit = axis / largest
    unit = unit / xp.sqrt(xp.sum(unit * unit, axis=-1, keepdims=True))
    half = 0.5 * angle[..., None]
    return xp.concat([xp.cos(half) + 0.0 * unit[..., :1], xp.sin(half) * unit], axis=-1)


def from_euler_angles(angles: Real[ArrayLike, "*batch 3"], sequence: str) -> Float64[Array, "*batch 4"]:
    """Return the unit quaternion (…, 4), body → space, of three turns [rad] about coordinate axes, in their order.

    Args:
        angles: (…, 3) of the turns, in the order of the letters [rad].
        sequence: three of x, y, z, no two alike next to each other. Capitals like "ZYX" turn about the body's own
            axes, each as the turns before have left it: R = R_Z(a) R_Y(b) R_X(c). Small letters turn about the axes
            of space: R = R_z(c) R_y(b) R_x(a) for "xyz".

    Raises:
        InvalidInput: for another sequence, and for angles of another shape.

    >>> from_euler_angles([np.pi / 2, 0.0, np.pi], "ZYX").round(12).tolist()
    [0.0, 0.707106781187, 0.707106781187, 0.0]
    """
    letters = sequence.lower() if isinstance(sequence, str) and sequence in (sequence.lower(), sequence.upper()) else ""
    if len(letters) != 3 or set(letters) - set("xyz") or letters[0] == letters[1] or letters[1] == letters[2]:
        raise InvalidInput(
            'sequence must be three of x, y, z, no two alike next to each other: capitals, like "ZXZ", turn about the '
            f"body's own axes one after the other, small letters about the axes of space; got {shown(sequence)}"
        )
    xp = namespace(angles)
    angles = as_float64(xp, angles, "angles")
    if tuple(angles.shape[-1:]) != (3,):
        raise InvalidInput(f"`angles` must have shape (..., 3); got {tuple(angles.shape)}.")
    turns = [
        from_axis_angle(xp.asarray(np.eye(3)["xyz".index(letter)]), angles[..., k]) for k, letter in enumerate(letters)
    ]
    first, second, third = turns if sequence.isupper() else turns[::-1]
    return multiply(multiply(first, second), third)


def hat(vector: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 3 3"]:
    """Return the skew matrix (…, 3, 3) with hat(v) w = v × w."""
    xp, (v,) = _arrays(vector=vector)
    x, y, z = _parts(v)
    o = xp.zeros_like(x)
    return xp.stack([xp.stack(row, axis=-1) for row in ((o, -z, y), (z, o, -x), (-y, x, o))], axis=-2)


def vee(matrix: Real[ArrayLike, "*batch 3 3"]) -> Float64[Array, "*batch 3"]:
    """Return the vector of the skew part of a matrix (…, 3, 3); the inverse of ``hat``."""
    xp, (m,) = _arrays(matrix=matrix)
    parts = (m[..., 2, 1] - m[..., 1, 2], m[..., 0, 2] - m[..., 2, 0], m[..., 1, 0] - m[..., 0, 1])
    return 0.5 * xp.stack(parts, axis=-1)


def angle_between(p: Real[ArrayLike, "*#batch 4"], q: Real[ArrayLike, "*#batch 4"]) -> Float64[Array, "*batch"]:
    """Return the angle (…) [rad] in [0, π] of the rotation from q to p, accurate when it is tiny."""
    xp, (p, q) = _arrays(p=p, q=q)
    relative = multiply(conjugate(q), p)
    sine = xp.sqrt(xp.sum(relative[..., 1:] * relative[..., 1:], axis=-1))
    return 2.0 * xp.atan2(sine, xp.abs(relative[..., 0]))


def shortest_between(
    start: Real[ArrayLike, "*#batch 3"], end: Real[ArrayLike, "*#batch 3"]
) -> Float64[Array, "*batch 4"]:
    """Return the unit quaternion (…, 4) of the shortest rotation that takes one direction (…, 3) to another.

    With unit vectors a, b and s = a + b it is (|s|/2, a × s/|s|), which loses no digits where they are nearly opposite.
    Between opposite directions it is half a turn about an axis that depends on the first alone.

    Raises:
        InvalidInput: for a vector of zero length, which has no direction.

    >>> shortest_between([0.0, 0.0, 3.0], [0.0, 1.0, 0.0]).round(12).tolist()
    [0.707106781187, -0.707106781187, 0.0, 0.0]
    """
    xp = namespace(start, end)
    a, b = _unit(xp, start, "start"), _unit(xp, end, "end")
    between = a + b
    size = xp.sqrt(xp.sum(between * between, axis=-1, keepdims=True))
    opposite = size < LIMITS.max_sum_of_opposite
    turn = xp.concat([0.5 * size, _cross(xp, a, between / xp.where(opposite, 1.0, size))], axis=-1)
    half = xp.concat([xp.zeros_like(size), _cross(xp, perpendicular(a), a) + 0.0 * between], axis=-1)
    turn = xp.where(opposite, half, turn)
    return turn / xp.sqrt(xp.sum(turn * turn, axis=-1, keepdims=True))


def perpendicular(vector: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 3"]:
    """Return a unit vector (…, 3) at right angles to each vector: its cross product with the axis farthest from it.

    Raises:
        InvalidInput: for a vector of zero length.
    """
    xp = namespace(vector)
    v = _unit(xp, vector, "vector")
    farthest = xp.argmin(xp.abs(v), axis=-1)[..., None]
    x, y, z = (v[..., k : k + 1] for k in range(3))
    zero = xp.zeros_like(x)
    normal = xp.concat([y, -x, zero], axis=-1)
    normal = xp.where(farthest == 1, xp.concat([-z, zero, x], axis=-1), normal)
    normal = xp.where(farthest == 0, xp.concat([zero, z, -y], axis=-1), normal)
    return normal / xp.sqrt(xp.sum(normal * normal, axis=-1, keepdims=True))


def _unit(xp: Any, vector: Array, name: str) -> Array:
    v = as_float64(xp, vector, name)
    if tuple(v.shape[-1:]) != (3,):
        raise InvalidInput(f"`{name}` must have shape (..., 3); got {tuple(v.shape)}.")
    largest = xp.max(xp.abs(v), axis=-1, keepdims=True)
    if known_false(xp.all((largest > 0) & xp.isfinite(largest))):
        raise InvalidInput(f"`{name}` must be finite and not zero; a vector of zero length has no direction.")
    v = v / largest
    return v / xp.sqrt(xp.sum(v * v, axis=-1, keepdims=True))


def _cross(xp: Any, a: Array, b: Array) -> Array:
    return xp.stack(cross_of_parts(_parts(a), _parts(b)), axis=-1)


def as_scipy(quaternion: Real[ArrayLike, "*batch 4"]) -> Rotation:
    """Return the rotation as SciPy's ``Rotation``, whose quaternions end with the scalar."""
    with needing("Rotations of SciPy need", alone=True):
        from scipy.spatial.transform import Rotation

    xp, (q,) = _arrays(quaternion=quaternion)
    return Rotation.from_quat(xp.concat([q[..., 1:], q[..., :1]], axis=-1))


def from_scipy(rotation: Rotation) -> Float64[Array, "*batch 4"]:
    """Return SciPy's ``Rotation`` as quaternions (…, 4), scalar first."""
    xyzw = rotation.as_quat()
    xp = namespace(xyzw)
    return xp.concat([xyzw[..., 3:], xyzw[..., :3]], axis=-1)


def __dir__() -> list[str]:
    return __all__
