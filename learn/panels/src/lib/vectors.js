// Vectors of three numbers.
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const sum = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
export const size = (a) => Math.sqrt(dot(a, a));
export const unit = (a) => times(a, 1 / size(a));
export const degrees = (radians) => (radians * 180) / Math.PI;
export const radians = (angle) => (angle * Math.PI) / 180;

/** Return two unit vectors that make a right-handed frame with a third. */
export function across(axis) {
  const far = Math.abs(axis[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const first = unit(cross(axis, far));
  return [first, cross(unit(axis), first)];
}

/** Return `count` + 1 points of a circle about an axis. */
export function circle(centre, axis, radius, count = 96) {
  const [u, v] = across(axis);
  return Array.from({ length: count + 1 }, (_, k) => {
    const angle = (2 * Math.PI * k) / count;
    return sum(centre, sum(times(u, radius * Math.cos(angle)), times(v, radius * Math.sin(angle))));
  });
}
