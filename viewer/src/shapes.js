// What the panels are made of: lines of a width in pixels, arrows, dots, surfaces.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DataTexture,
  EdgesGeometry,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshMatcapMaterial,
  OctahedronGeometry,
  Points,
  PointsMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";

const UP = new Vector3(0, 1, 0); // along which three.js builds cylinders and cones
export const GLOBE = 0.995; // radius of the drawn sphere, below the curves on it
const CREASE = 0.6; // rad between faces from which an edge is one
const TURN = 2 * Math.PI;
const METAL = 64; // pixels along the edge of the picture that metal mirrors

const lineMaterial = (color, width, opacity) =>
  new LineMaterial({ color: new Color(color), linewidth: width, transparent: opacity < 1, opacity, alphaToCoverage: false });

/** Return a line through points [x, y, z, x, y, z, …]; `count` of its pieces are drawn. */
export function line(points, color, width, opacity = 1) {
  const found = new Line2(new LineGeometry(), lineMaterial(color, width, opacity));
  found.geometry.setPositions(points.length > 3 ? points : [...points, ...points]);
  found.frustumCulled = false;
  return found;
}

/** Return a line one pixel wide, which costs a fraction of one of another width. */
export const hairline = (points, color, opacity = 1) => hairs(new Line(), points, color, opacity);

function hairs(found, points, color, opacity) {
  found.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
  found.material = new LineBasicMaterial({ color, transparent: opacity < 1, opacity });
  found.frustumCulled = false;
  return found;
}

/** Draw only the first pieces of a line. */
export function drawPieces(found, count) {
  found.geometry.instanceCount = Math.max(0, count);
  found.visible = count > 0;
}

/** Return separate pieces [start, end, start, end, …]; those up to a pixel wide are drawn the cheap way. */
export function pieces(points, color, width, opacity = 1) {
  if (width <= 1) return hairs(new LineSegments(), points, color, opacity);
  const found = new LineSegments2(new LineSegmentsGeometry(), lineMaterial(color, width, opacity));
  found.geometry.setPositions(points);
  found.frustumCulled = false;
  return found;
}

/** Return the samples of a motion: a line through them, or points where the motion between them is not clear. */
export const path = (motion, points, color, width) => (motion.joined ? line(points, color, width) : specks(points, color, width));

/** Draw a path up to a sample. */
export function drawUpTo(motion, found, k) {
  if (motion.joined) drawPieces(found, k);
  else found.geometry.setDrawRange(0, k + 1);
}

/** Return points of a size in pixels. */
export function specks(points, color, size) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
  const found = new Points(geometry, new PointsMaterial({ color, size, sizeAttenuation: false }));
  found.frustumCulled = false;
  return found;
}

/** Return a circle about the z axis, of a width or a hairline. */
export function circle(radius, height, color, width = 1) {
  const points = [];
  for (let k = 0; k <= 128; k++) {
    points.push(radius * Math.cos((TURN * k) / 128), radius * Math.sin((TURN * k) / 128), height);
  }
  return width > 1 ? line(points, color, width) : hairline(points, color);
}

/** Return an arrow from the origin; `point(direction, length)` turns it. */
export function arrow(color, thickness) {
  const material = new MeshLambertMaterial({ color });
  const shaft = new Mesh(new CylinderGeometry(thickness, thickness, 1, 16), material);
  const head = new Mesh(new ConeGeometry(3 * thickness, 8 * thickness, 24), material);
  const found = new Group().add(shaft, head);
  found.point = (direction, length) => {
    const reach = Math.max(length - 8 * thickness, 1e-6);
    found.visible = length > 1e-3;
    shaft.scale.set(1, reach, 1);
    shaft.position.set(0, 0.5 * reach, 0);
    head.position.set(0, length - 4 * thickness, 0);
    found.quaternion.copy(new Quaternion().setFromUnitVectors(UP, direction.clone().normalize()));
    found.userData.tip = direction.clone().normalize().multiplyScalar(length);
  };
  return found;
}

/** Return a dot with a rim that sets it off. */
export function dot(color, rim, radius) {
  const core = new Mesh(new SphereGeometry(radius, 24, 16), new MeshBasicMaterial({ color }));
  const shell = new Mesh(new SphereGeometry(1.35 * radius, 24, 16), new MeshBasicMaterial({ color: rim, side: 1 }));
  return new Group().add(core, shell);
}

/** Return the head of an arrow that lies on the unit sphere. */
export function arrowhead(color, place, direction, size) {
  const found = new Mesh(new ConeGeometry(0.45 * size, size, 16), new MeshBasicMaterial({ color }));
  found.position.copy(place).multiplyScalar(1.003);
  found.quaternion.setFromUnitVectors(UP, direction);
  return found;
}

const MARKS = { stable: () => new SphereGeometry(0.045, 20, 14), unstable: () => new OctahedronGeometry(0.06), undecided: () => new BoxGeometry(0.075, 0.075, 0.075) };

/** Return the mark of an equilibrium on the unit sphere: a ball where it is stable, an octahedron where not, else a cube. */
export function mark(place, verdict, color, rim) {
  const core = new Mesh(MARKS[verdict](), new MeshBasicMaterial({ color }));
  const shell = new Mesh(MARKS[verdict](), new MeshBasicMaterial({ color: rim, side: 1 }));
  shell.scale.setScalar(1.3);
  const found = new Group().add(core, shell);
  found.position.copy(place);
  return found;
}

let polished = null;

/** Return how polished metal looks by the direction that it faces: as a bright room does, with a dark horizon. */
function polish() {
  if (polished) return polished;
  const pixels = new Uint8Array(4 * METAL * METAL);
  for (let i = 0; i < METAL; i++) {
    for (let j = 0; j < METAL; j++) {
      const [x, y] = [(2 * j) / (METAL - 1) - 1, (2 * i) / (METAL - 1) - 1];
      const lamp = Math.exp(-12 * ((x + 0.35) ** 2 + (y - 0.45) ** 2));
      const room = 0.62 + 0.3 * Math.tanh(2.5 * y) - 0.3 * Math.exp(-18 * (y + 0.1) ** 2);
      const shade = Math.round(255 * Math.min(1, Math.max(0.12, room + 0.5 * lamp)));
      pixels.set([shade, shade, shade, 255], 4 * (METAL * i + j));
    }
  }
  polished = new DataTexture(pixels, METAL, METAL);
  polished.needsUpdate = true;
  return polished;
}

/** Return a surface of triangles with its sharp edges drawn, or with colours of its corners; a shiny one looks like metal. */
export function surface(vertices, faces, color, edge, colors = null, shiny = false) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(vertices), 3));
  geometry.setIndex(new BufferAttribute(faces, 1));
  if (colors) {
    const shades = [...colors].flatMap((shade) => new Color(shade).toArray());
    geometry.setAttribute("color", new BufferAttribute(Float32Array.from(shades), 3));
  }
  const smooth = toCreasedNormals(geometry, CREASE);
  const looks = { color: colors ? "#ffffff" : color, vertexColors: Boolean(colors), side: 2, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
  const material = shiny ? new MeshMatcapMaterial({ ...looks, matcap: polish() }) : new MeshLambertMaterial(looks);
  const edges = new LineSegments(new EdgesGeometry(geometry, 30), new LineBasicMaterial({ color: edge, transparent: true, opacity: 0.6 }));
  return new Group().add(new Mesh(smooth, material), edges);
}

/** Return a box about the origin with its edges drawn. */
export function box(edges, color, edge) {
  const geometry = new BoxGeometry(...edges);
  const material = new MeshLambertMaterial({ color, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  const rims = new LineSegments(new EdgesGeometry(geometry), new LineBasicMaterial({ color: edge, transparent: true, opacity: 0.6 }));
  return new Group().add(new Mesh(geometry, material), rims);
}

/** Return an ellipsoid with its three principal circles, which show how it turns. */
export function ellipsoid(semiAxes, color, edge, opacity = 1) {
  const material = new MeshLambertMaterial({
    color,
    transparent: opacity < 1,
    opacity,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  const mesh = new Mesh(new SphereGeometry(1, 80, 48), material);
  mesh.scale.set(...semiAxes);
  const found = new Group().add(mesh);
  for (let k = 0; k < 3; k++) {
    const points = [];
    for (let j = 0; j <= 128; j++) {
      const place = [0, 0, 0];
      place[(k + 1) % 3] = semiAxes[(k + 1) % 3] * Math.cos((TURN * j) / 128);
      place[(k + 2) % 3] = semiAxes[(k + 2) % 3] * Math.sin((TURN * j) / 128);
      points.push(...place);
    }
    found.add(hairline(points, edge, 0.7));
  }
  found.userData.mesh = mesh;
  return found;
}

/** Return the triangles between the origin and neighbouring points [x, y, z, …], seen through. */
export function fan(points, color, opacity) {
  const geometry = new BufferGeometry();
  const corners = new Float32Array(3 * Math.max(0, points.length - 3));
  for (let k = 0; k + 5 < points.length; k += 3) corners.set(points.slice(k, k + 6), 3 * k + 3);
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  const material = new MeshBasicMaterial({ color, transparent: true, opacity, side: 2, depthWrite: false });
  const found = new Mesh(geometry, material);
  found.frustumCulled = false;
  found.renderOrder = 2;
  return found;
}

/** Return the sphere that curves are drawn on; those on its far side show through it, dimmed. */
export function globe(theme) {
  const material = new MeshLambertMaterial({ color: theme.sphere, transparent: true, opacity: 0.8, depthWrite: true });
  const found = new Mesh(new SphereGeometry(GLOBE, 80, 48), material);
  found.renderOrder = 1; // after the lines: it veils those behind it, and fails the depth test against those before it
  return found;
}

/** Return a disk in a plane of constant z, with rings. */
export function floor(radius, height, theme, rings = 4) {
  const geometry = new CylinderGeometry(radius, radius, 1e-4, 96);
  geometry.rotateX(Math.PI / 2);
  const material = new MeshBasicMaterial({
    color: theme.plane,
    transparent: true,
    opacity: 0.75,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
  const mesh = new Mesh(geometry, material);
  const found = new Group().add(mesh);
  for (let k = 1; k <= rings; k++) found.add(circle((radius * k) / rings, 0, theme.ring));
  found.position.set(0, 0, height);
  found.userData.mesh = mesh;
  return found;
}

/** Release what a scene holds on the graphics card. */
export function dispose(scene) {
  scene.traverse((found) => {
    found.geometry?.dispose();
    for (const material of [found.material].flat()) material?.dispose(); // a solid may have one for each side
  });
}
