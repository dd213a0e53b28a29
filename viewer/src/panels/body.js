// The body itself, turning in space, with the trace of one of its axes, and arrows and cones that can be switched.
import { Group, Vector3 } from "three";
import { unpacked } from "../motion.js";
import { perMinute } from "../numbers.js";
import { say } from "../say.js";
import { box, circle, drawPieces, ellipsoid, floor, hairline, line, specks, surface } from "../shapes.js";
import { rotorOf } from "../rotor.js";
import { newPanel } from "../stage.js";
import { isOn, switched } from "../switches.js";
import { cageOf } from "./cage.js";
import { coneThrough, isConing, sweptRays } from "./cones.js";
import { lengthPerRate, vectorsOf } from "./vectors.js";

const REACH = 1.22; // how far axes and trace stand off from a body of size one
const HEIGHTS = { ground: 0, post: -REACH, hook: REACH }; // of the plane that holds the pivot
const LOW = 0.4; // height of the axis below which a top would dip into the ground
const GLASS = 0.35; // opacity of a body with a rotor inside
const FINE = 0.06; // rad between points of the trace

export function bodyPanel(motion, given, theme) {
  const data = given.pivot && motion.solver ? { ...given, pivot: holding(motion, given.pivot) } : given;
  const panel = newPanel(theme, { title: "The body in space", words: data.changed ? "box or ellipsoid of the same inertia" : data.shape, radius: data.pivot === "ground" ? 1.5 : 1.62 });
  if (!data.pivot) panel.target = new Vector3(0, 0, 0.08); // as arrows point up more often than down
  if (data.pivot === "ground") panel.target = new Vector3(0, 0, 0.42);
  const space = new Group();
  space.quaternion.copy(motion.space);
  panel.scene.add(space);
  const body = shapeOf(motion, data, theme);
  space.add(body);
  const rotor = data.rotor ? rotorOf(motion, data.rotor, theme) : null;
  if (rotor) {
    seeThrough(body);
    body.add(rotor.object);
  }
  const tips = [0, 1, 2].map((k) => {
    const tip = new Vector3().setComponent(k, REACH);
    body.add(line([0, 0, 0, ...tip.toArray()], theme.axes[k], k === data.traced && !data.along ? 2.5 : 1.5));
    return tip;
  });
  const color = theme.axes[data.traced];
  const direction = data.along ? new Vector3(...data.along) : new Vector3().setComponent(data.traced, 1);
  const end = direction.multiplyScalar(REACH);
  if (data.along) body.add(line([0, 0, 0, ...end.toArray()], color, 2.5));
  const trace = traceOf(motion, end, color);
  space.add(trace.object);
  if (data.pivot) panel.scene.add(floor(data.pivot === "ground" ? REACH : 0.7, HEIGHTS[data.pivot], theme));
  else panel.scene.add(circle(REACH, 0, theme.ring));
  if (data.pivot === "post") panel.scene.add(line([0, 0, -REACH, 0, 0, 0], theme.edge, 5));
  if (data.pivot === "hook") panel.scene.add(line([0, 0, 0, 0, 0, REACH], theme.edge, 5));
  const vectors = vectorsOf(motion, data.weight ? center(data, end) : null, theme);
  const cones = conesOf(motion, end, data, color, theme);
  const cage = data.cage && !data.changed ? cageOf(data, theme) : null;
  if (cage) panel.scene.add(cage.object);
  for (const found of vectors.objects) panel.scene.add(found);
  for (const cone of cones) (cone.inBody ? body : panel.scene).add(cone.object);
  let state = null;

  panel.legend = [
    { color, text: data.along ? "trace of the axis through the centre of mass" : say("trace of axis {axis}", { axis: data.axes?.[data.traced] ?? data.traced + 1 }) },
    ...vectors.entries,
    ...cones.map(({ entry }) => entry),
    ...(rotor ? [{ color: theme.rotor, text: turning(rotor.rate({ position: 0 })) }] : []),
  ];
  panel.update = (now) => {
    state = now;
    body.quaternion.copy(now.attitude);
    trace.show(now.position);
    rotor?.turn(now);
    vectors.show(now);
    cage?.turn(end.clone().applyQuaternion(now.attitude).applyQuaternion(motion.space));
    for (const cone of cones) cone.object.visible = isOn(cone.entry);
  };
  panel.labels = () => [
    ...tips.map((tip, k) => ({
      text: data.axes?.[k] ?? `${k + 1}`,
      color: theme.axes[k],
      place: tip.clone().multiplyScalar(1.07).applyQuaternion(state.attitude).applyQuaternion(motion.space),
    })),
    ...vectors.labels(),
  ];
  panel.probe = () => {
    body.updateWorldMatrix(true, false);
    return {
      matrix: [...body.matrixWorld.elements],
      axisTip: end.clone().applyMatrix4(body.matrixWorld).toArray(),
      trace: [...trace.points].slice(0, 3 * (trace.shown + 1)),
      momentumTip: vectors.probe().L?.tip ?? null,
      vectors: vectors.probe(),
      cage: cage ? cage.object.matrix.elements.slice() : null,
      cones: Object.fromEntries(cones.map(({ entry, halves, object }) => [entry.key, { halves, shown: object.visible }])),
      rotor: rotor ? [...rotor.object.children[0].quaternion.toArray(), rotor.rate(state)] : null,
    };
  };
  return panel;
}

/** Let what is inside of the body be seen through it. */
function seeThrough(body) {
  body.traverse((found) => {
    if (!found.isMesh) return;
    Object.assign(found.material, { transparent: true, opacity: GLASS, depthWrite: false });
    found.renderOrder = 1; // after the rotor
  });
}

/** Return where a top's centre of mass is drawn: on its axis, in units of its reach. */
const center = ({ weight }, end) => end.clone().normalize().multiplyScalar(weight.center).toArray();

/** Return the cones of Ω in space and in the body, and of the traced axis; shown at first of a body that cones. */
function conesOf(motion, end, data, color, theme) {
  if (!motion.joined || !motion.attitudes || motion.count < 3) return [];
  const axes = [0, 1, 2].map((k) => new Vector3().setComponent(k, 1));
  const coned = axes.find((axis) => isConing(motion, axis)) ?? null; // which axis that is, a slider may have changed
  const traced = isConing(motion, end.clone().normalize());
  const rays = sweptRays(motion, lengthPerRate(motion), end);
  const up = new Vector3(0, 0, 1);
  const about = coned ?? end.clone().normalize();
  if (rays.body.length && new Vector3().fromArray(rays.body).dot(about) < 0) about.negate();
  return [
    { key: "space cone", text: data.pivot ? "cone of Ω in space" : "cone of Ω about L (space cone)", rays: rays.space, about: up, tint: theme.herpolhode },
    { key: "body cone", text: "cone of Ω in the body", rays: rays.body, about, tint: theme.bodyCone, inBody: true },
    { key: "axis cone", text: "cone of the axis", rays: rays.axis, about: up, tint: color },
  ].flatMap(({ key, text, rays: ends, about: line, tint, inBody = false }) => {
    const cone = coneThrough(ends, line, tint);
    return cone ? [{ ...cone, inBody, entry: switched(key, tint, text, key === "axis cone" ? traced : coned !== null) }] : [];
  });
}

/** Return how fast a rotor turns at first, in words. */
function turning(rate) {
  if (rate === null) return "rotor, drawn at rest: its moment is not given";
  return say("rotor, {rate} against the body", { rate: perMinute(rate) });
}

/** Return what holds the pivot of a motion set on the page: what holds it as given, if the body stays clear of the ground. */
function holding(motion, pivot) {
  const heights = [];
  for (let k = 0; k < motion.count; k++) heights.push(new Vector3(0, 0, 1).applyQuaternion(motion.attitude(k)).z);
  if (heights.reduce((sum, height) => sum + height, 0) < 0) return "hook";
  return pivot !== "ground" || Math.min(...heights) < LOW ? "post" : "ground";
}

/** Return what is drawn as the body; one whose moments were changed on the page is the box of the same inertia. */
function shapeOf(motion, data, theme) {
  const found = new Group();
  const edges = data.changed && motion.free ? boxOf(motion.free) : null;
  if (edges && data.round) return found.add(ellipsoid(edges.map((edge) => 0.5 * edge), theme.body, theme.edge));
  if (data.changed && !edges && motion.moments) data = { ellipsoid: motion.moments.map((moment) => 1 / Math.sqrt(moment)) };
  if (edges) return found.add(box(edges, theme.body, theme.edge));
  if (data.surface) {
    const vertices = unpacked(data.surface.vertices);
    const size = farthest(vertices);
    const { faces, colors, shiny = false, lines = [] } = data.surface;
    found.add(surface(vertices.map((x) => x / size), unpacked(faces), theme.body, theme.edge, unpacked(colors), shiny));
    for (const { points, color, width } of lines) {
      const ends = [...unpacked(points)].map((x) => x / size);
      const shade = `#${color.toString(16).padStart(6, "0")}`;
      found.add(width > 1 ? line(ends, shade, width) : hairline(ends, shade));
    }
  } else if (data.ellipsoid) {
    const size = Math.max(...data.ellipsoid);
    found.add(ellipsoid(data.ellipsoid.map((x) => x / size), theme.body, theme.edge));
  }
  return found;
}

/** Return the distance of the farthest of points [x, y, z, …] from where the body turns. */
function farthest(points) {
  let found = 0;
  for (let k = 0; k < points.length; k += 3) found = Math.max(found, Math.hypot(points[k], points[k + 1], points[k + 2]));
  return found;
}

/** Return the edges of a homogeneous box with these moments, its half diagonal 1; null where no box has them. */
function boxOf([a, b, c]) {
  const squares = [b + c - a, c + a - b, a + b - c];
  const sum = a + b + c;
  if (squares.some((square) => square < 1e-9 * sum)) return null;
  return squares.map((square) => 2 * Math.sqrt(square / sum));
}

/** Return the path of an axis' end in space: a line with points between the samples, or the samples alone. */
function traceOf(motion, end, color) {
  const points = [];
  const ends = []; // by sample, how many pieces lead to it
  const place = (q) => points.push(...end.clone().applyQuaternion(q).toArray());
  let last = null;
  for (let j = 0; j < motion.count; j++) {
    const here = motion.attitude(j);
    if (last && motion.joined) {
      const between = Math.min(20, Math.ceil(last.angleTo(here) / FINE));
      for (let i = 1; i < between; i++) place(motion.at(j - 1 + i / between).attitude);
    }
    place(here);
    ends.push(points.length / 3 - 1);
    last = here;
  }
  const found = { points, shown: 0 };
  if (motion.joined) {
    found.object = line(points, color, 2);
    found.show = (position) => drawPieces(found.object, (found.shown = ends[Math.floor(position)]));
  } else {
    found.object = specks(points, color, 3);
    found.show = (position) => found.object.geometry.setDrawRange(0, (found.shown = Math.floor(position)) + 1);
  }
  return found;
}
