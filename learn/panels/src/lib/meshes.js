// Bodies made of facets.
import { quaternion } from "../../../../reference/polhode.js";
import { cross, dot, size, sum, times } from "./vectors.js";

/** Return a function that takes body components to space, for an attitude [w, x, y, z]. */
export const turnedBy = (attitude) => (v) => quaternion.rotate(attitude, v);

/** Return the unit quaternion of the shortest turn that takes one direction to another. */
export function turnBetween(from, to) {
  const [a, b] = [times(from, 1 / size(from)), times(to, 1 / size(to))];
  const w = 1 + dot(a, b);
  if (w < 1e-12) return [0, ...(Math.abs(a[0]) < 0.9 ? unitCross(a, [1, 0, 0]) : unitCross(a, [0, 1, 0]))];
  return quaternion.normalize([w, ...cross(a, b)]);
}

const unitCross = (a, b) => {
  const c = cross(a, b);
  return times(c, 1 / size(c));
};

/** Return the six faces of a box about a centre, by axis and side: {k, side, normal, points}. */
export function boxFaces([a, b, c], centre = [0, 0, 0]) {
  const half = [a / 2, b / 2, c / 2];
  return [0, 1, 2].flatMap((k) => [1, -1].map((side) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    const corner = (u, v) => {
      const p = [...centre];
      p[k] += side * half[k];
      p[i] += u * half[i];
      p[j] += v * half[j];
      return p;
    };
    const normal = [0, 0, 0];
    normal[k] = side;
    return { k, side, normal, points: [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)] };
  })); // prettier-ignore
}

/** Return facets {points, normal, octant} of an ellipsoid along the axes of a body. */
export function ellipsoidFacets([a, b, c], rings = 16, around = 32) {
  const at = (i, j) => {
    const [polar, angle] = [(Math.PI * i) / rings, (2 * Math.PI * j) / around];
    return [a * Math.sin(polar) * Math.cos(angle), b * Math.sin(polar) * Math.sin(angle), c * Math.cos(polar)];
  };
  const facets = [];
  for (let i = 0; i < rings; i++) {
    for (let j = 0; j < around; j++) {
      const points = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      const middle = points.reduce(sum).map((x) => x / 4);
      const outward = [middle[0] / (a * a), middle[1] / (b * b), middle[2] / (c * c)];
      facets.push({ points, normal: times(outward, 1 / size(outward)), octant: (i < rings / 2) !== Math.floor((4 * j) / around) % 2 > 0 });
    }
  }
  return facets;
}

/** Add facets of a body to a scene, turned and moved. */
export function addFacets(scene, facets, turn, colourOf, { centre = [0, 0, 0], oneSided = true, ...more } = {}) {
  for (const facet of facets) {
    if (oneSided && scene.view.depth(turn(facet.normal)) <= 0) continue; // before its corners are turned
    scene.facet(facet.points.map((p) => sum(centre, turn(p))), colourOf(facet), { normal: turn(facet.normal), oneSided, ...more });
  }
}
