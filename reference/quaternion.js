// Unit quaternions [w, x, y, z], body → space. Products are Hamilton's: R(p q) = R(p) R(q).

export const identity = [1, 0, 0, 0];

/** Return the Hamilton product p q: first q, then p. */
export function multiply([a, b, c, d], [w, x, y, z]) {
  return [
    a * w - b * x - c * y - d * z,
    a * x + b * w + c * z - d * y,
    a * y - b * z + c * w + d * x,
    a * z + b * y - c * x + d * w,
  ];
}

export const conjugate = ([w, x, y, z]) => [w, -x, -y, -z];

export const norm = ([w, x, y, z]) => Math.sqrt(w * w + x * x + y * y + z * z);

/** Return the quaternion over its length. */
export function normalize(q) {
  const size = norm(q);
  return q.map((x) => x / size);
}

/** Return R v: the components in space of a vector given along the body's axes. */
export function rotate([w, x, y, z], [a, b, c]) {
  const s = 2 * (y * c - z * b);
  const t = 2 * (z * a - x * c);
  const u = 2 * (x * b - y * a);
  return [a + w * s + (y * u - z * t), b + w * t + (z * s - x * u), c + w * u + (x * t - y * s)];
}

/** Return Rᵀ v: the components along the body's axes of a vector given in space. */
export const rotateBack = (q, v) => rotate(conjugate(q), v);

/** Return the rotation matrix R by rows. */
export function asMatrix([w, x, y, z]) {
  return [
    [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
  ];
}

/** Return the quaternion of a turn by an angle [rad] about an axis, which need not be of unit length. */
export function fromAxisAngle([x, y, z], angle) {
  const size = Math.hypot(x, y, z);
  if (!(size > 0)) throw new RangeError("the axis of a turn must not be zero: give three numbers that are not all 0");
  const s = Math.sin(0.5 * angle) / size;
  return [Math.cos(0.5 * angle), x * s, y * s, z * s];
}

/** Return the angle between two attitudes [rad], in [0, π]. */
export function angleBetween(p, q) {
  const [w, x, y, z] = multiply(conjugate(p), q);
  return 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w));
}
