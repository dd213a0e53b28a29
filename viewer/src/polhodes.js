// Curves on the momentum sphere of a free body, in closed form: where it meets the cones Σ u²/I = const.
const TURN = 2 * Math.PI;
const PARTS = [0.08, 0.25, 0.5, 0.75]; // of the way from a stable axis to the separatrix, where other polhodes are drawn
const FINE = 2400; // pieces of a turn: chords of a circle miss it by 1e-6
const COARSE = 160;
const LADDER = 0.05; // relative steps of the points that lead into a bend

/** Return the axes in the order of their moments. */
export const ascending = (moments) => [0, 1, 2].sort((i, j) => moments[i] - moments[j] || i - j);

/** Whether all three moments differ, so that there is an intermediate axis. */
export function isTriaxial(moments) {
  const [i, j, k] = ascending(moments);
  return moments[i] < moments[j] && moments[j] < moments[k];
}

/**
 * Return the closed polhode through a unit vector as points [x, y, z, …], the last equal to the first.
 *
 * Null where L stays in its place, as on a principal axis, and on the separatrix, which is not closed.
 */
export function polhodeThrough(moments, unit, pieces = FINE) {
  const order = ascending(moments);
  const [I1, I2, I3] = order.map((k) => moments[k]);
  const [x, y, z] = order.map((k) => unit[k] / Math.hypot(...unit));
  if (I1 === I3) return null;
  const towards = (I1 * (I3 - I2) * z * z) - (I3 * (I2 - I1) * x * x); // sign: about which axis it runs
  if (towards === 0 && I1 < I2 && I2 < I3) return null;
  const aboutThird = towards > 0;
  // semi-axes of the ellipse that the curve is, seen along its axis
  const ratio = aboutThird ? (I1 * (I3 - I2)) / (I2 * (I3 - I1)) : (I3 * (I2 - I1)) / (I2 * (I3 - I1));
  const across = aboutThird ? x : z;
  const wide = Math.sqrt(y * y + (ratio > 0 ? (across * across) / ratio : 0)); // along the middle axis
  const narrow = Math.sqrt(across * across + ratio * y * y);
  if (narrow === 0 || !(wide <= 1 + 1e-12)) return null;
  const side = Math.sign(aboutThird ? z : x) || 1;
  const points = [];
  for (const angle of angles(Math.min(wide, 1), pieces)) {
    const [a, b] = [narrow * Math.cos(angle), wide * Math.sin(angle)];
    const c = side * Math.sqrt(Math.max(0, 1 - a * a - b * b));
    const at = [0, 0, 0];
    [at[order[0]], at[order[1]], at[order[2]]] = aboutThird ? [a, b, c] : [c, b, a];
    points.push(...at);
  }
  return points;
}

/** Return angles from 0 to 2π, closer where the curve bends sharply on its way past the intermediate axis. */
function angles(wide, pieces) {
  const found = [];
  for (let k = 0; k < pieces; k++) found.push((TURN * k) / pieces);
  const bend = Math.sqrt(Math.max(0, 1 - wide * wide));
  for (let x = 0.02 * bend; bend > 0 && x < 0.5; x += LADDER * Math.max(x, 0.4 * bend)) {
    const angle = Math.asin(x);
    for (const middle of [0.25 * TURN, 0.75 * TURN]) found.push(middle - angle, middle + angle);
  }
  found.push(TURN);
  return found.sort((a, b) => a - b);
}

/** Return where spin is steady, and whether it is stable: both ends of each axis; none of a sphere, which has no axes. */
export function rests(moments) {
  const order = ascending(moments);
  const [I1, I2, I3] = order.map((k) => moments[k]);
  if (I1 === I3) return [];
  // of two equal moments neither axis keeps a spin that is pushed: it drifts along the circle between them
  const stable = [I1 < I2, I1 === I3, I2 < I3];
  return order.flatMap((axis, k) => [1, -1].map((sign) => {
    const at = [0, 0, 0];
    at[axis] = sign;
    return { at, verdict: stable[k] ? "stable" : "unstable" };
  }));
}

/** Return other polhodes as separate pieces [start, end, …] of points. */
export function family(moments) {
  const order = ascending(moments);
  const [I1, I2, I3] = order.map((k) => moments[k]);
  const found = [];
  if (I1 === I3) return found;
  // on the great circle through the first and the third axis the separatrix stands at this angle from the third
  const saddle = Math.atan2(Math.sqrt((I3 - I2) * I1), Math.sqrt((I2 - I1) * I3));
  for (const [near, far, reach] of [[order[2], order[0], saddle], [order[0], order[2], 0.5 * Math.PI - saddle]]) {
    if (reach < 1e-9) continue;
    for (const part of PARTS) {
      const unit = [0, 0, 0];
      [unit[near], unit[far]] = [Math.cos(part * reach), Math.sin(part * reach)];
      found.push(...pairThrough(moments, unit));
    }
  }
  return found;
}

/** Return the polhode through a unit vector and its mirror image as separate pieces; none where L rests. */
export function pairThrough(moments, unit) {
  const curve = polhodeThrough(moments, unit, COARSE);
  return curve ? [...asPieces(curve), ...asPieces(curve.map((v) => -v))] : [];
}

/** Return the separatrix, two great circles through the intermediate axis, as separate pieces; none of other bodies. */
export function separatrix(moments) {
  if (!isTriaxial(moments)) return [];
  const order = ascending(moments);
  const [I1, I2, I3] = order.map((k) => moments[k]);
  const angle = Math.atan2(Math.sqrt((I3 - I2) * I1), Math.sqrt((I2 - I1) * I3));
  const found = [];
  for (const sign of [1, -1]) {
    const curve = [];
    for (let k = 0; k <= COARSE; k++) {
      const at = [0, 0, 0];
      const s = (TURN * k) / COARSE;
      at[order[1]] = Math.cos(s);
      at[order[0]] = sign * Math.sin(s) * Math.sin(angle);
      at[order[2]] = Math.sin(s) * Math.cos(angle);
      curve.push(...at);
    }
    found.push(...asPieces(curve));
  }
  return found;
}

const GRID = 64; // cells along the edge of each face of the cube that levels are looked for on
const LEVELS = 9;

/** Return levels of ½ (L − h)·I⁻¹(L − h) on the sphere of |L|, evenly spread, as separate pieces of unit vectors. */
export function levels(moments, rotor, size) {
  if (!(size > 0)) return [];
  const energy = (u) => u.reduce((sum, value, k) => sum + (size * value - rotor[k]) ** 2 / moments[k], 0);
  const corners = [];
  let [low, high] = [Infinity, -Infinity];
  for (let face = 0; face < 6; face++) {
    const grid = [];
    for (let i = 0; i <= GRID; i++) {
      for (let j = 0; j <= GRID; j++) {
        const at = [0, 0, 0];
        at[face % 3] = face < 3 ? 1 : -1;
        at[(face + 1) % 3] = Math.tan(((2 * i) / GRID - 1) * 0.25 * Math.PI);
        at[(face + 2) % 3] = Math.tan(((2 * j) / GRID - 1) * 0.25 * Math.PI);
        const length = Math.hypot(...at);
        const unit = at.map((value) => value / length);
        const value = energy(unit);
        [low, high] = [Math.min(low, value), Math.max(high, value)];
        grid.push([unit, value]);
      }
    }
    corners.push(grid);
  }
  const found = [];
  if (!(high - low > 1e-12 * Math.abs(high))) return found;
  for (const grid of corners) {
    for (let i = 0; i < GRID; i++) {
      for (let j = 0; j < GRID; j++) {
        const [a, b, c, d] = [grid[i * (GRID + 1) + j], grid[(i + 1) * (GRID + 1) + j], grid[(i + 1) * (GRID + 1) + j + 1], grid[i * (GRID + 1) + j + 1]];
        for (const triangle of [[a, b, c], [a, c, d]]) crossings(triangle, low, high, found);
      }
    }
  }
  return found;
}

/** Add the pieces in which levels cross a triangle. */
function crossings(triangle, low, high, found) {
  const values = triangle.map(([, value]) => value);
  const step = (high - low) / (LEVELS + 1);
  const first = Math.max(1, Math.ceil((Math.min(...values) - low) / step));
  const last = Math.min(LEVELS, Math.floor((Math.max(...values) - low) / step));
  for (let k = first; k <= last; k++) {
    const wanted = low + k * step;
    const ends = [];
    for (let n = 0; n < 3; n++) {
      const [[u, p], [v, q]] = [triangle[n], triangle[(n + 1) % 3]];
      if (p < wanted === q < wanted) continue;
      const part = (wanted - p) / (q - p);
      const at = u.map((value, m) => value + part * (v[m] - value));
      const length = Math.hypot(...at);
      ends.push(at.map((value) => value / length));
    }
    if (ends.length === 2) found.push(...ends[0], ...ends[1]);
  }
}

function asPieces(curve) {
  const found = [];
  for (let k = 0; k + 5 < curve.length; k += 3) found.push(...curve.slice(k, k + 6));
  return found;
}
