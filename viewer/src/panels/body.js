// The body itself, turning in space, with L, Ω and the trace of one of its axes.
import { Group, Vector3 } from "three";
import { unpacked } from "../motion.js";
import { worded } from "../numbers.js";
import { arrow, box, circle, drawPieces, ellipsoid, floor, line, specks, surface } from "../shapes.js";
import { rotorOf } from "../rotor.js";
import { newPanel } from "../stage.js";

const REACH = 1.32; // how far axes and trace stand off from a body of size one
const HEIGHTS = { ground: 0, post: -REACH, hook: REACH }; // of the plane that holds the pivot
const LOW = 0.4; // height of the axis below which a top would dip into the ground
const LONGEST = 1.5; // of L and of the largest Ω
const GLASS = 0.35; // opacity of a body with a rotor inside
const FINE = 0.06; // rad between points of the trace

export function bodyPanel(motion, given, theme) {
  const data = given.pivot && motion.solver ? { ...given, pivot: holding(motion, given.pivot) } : given;
  const panel = newPanel(theme, { title: "The body in space", words: data.changed ? "box or ellipsoid of the same inertia" : data.shape, radius: data.pivot === "ground" ? 1.7 : 1.88 });
  if (!data.pivot) panel.target = new Vector3(0, 0, 0.08); // as arrows point up more often than down
  if (data.pivot === "ground") panel.target = new Vector3(0, 0, 0.5);
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
  const arrows = { L: motion.momenta && arrow(theme.momentum, 0.02), Ω: motion.velocities && arrow(theme.velocity, 0.017) };
  for (const found of Object.values(arrows)) if (found) space.add(found);
  let state = null;

  panel.legend = [
    { color, text: data.along ? "trace of the axis through the centre of mass" : `trace of axis ${data.axes?.[data.traced] ?? data.traced + 1}` },
    ...(arrows.L ? [{ color: theme.momentum, text: "L" }] : []),
    ...(arrows["Ω"] ? [{ color: theme.velocity, text: "Ω" }] : []),
    ...(rotor ? [{ color: theme.rotor, text: `rotor${turning(rotor.rate({ position: 0 }))}` }] : []),
  ];
  panel.update = (now) => {
    state = now;
    body.quaternion.copy(now.attitude);
    trace.show(now.position);
    rotor?.turn(now);
    point(arrows.L, now.momentum, now.attitude, largest(motion.momenta));
    point(arrows["Ω"], now.velocity, now.attitude, motion.fastest);
  };
  panel.labels = () => [
    ...tips.map((tip, k) => ({
      text: data.axes?.[k] ?? `${k + 1}`,
      color: theme.axes[k],
      place: tip.clone().multiplyScalar(1.07).applyQuaternion(state.attitude).applyQuaternion(motion.space),
    })),
    ...Object.entries(arrows)
      .filter(([, found]) => found?.visible)
      .map(([text, found]) => ({
        text,
        color: text === "L" ? theme.momentum : theme.velocity,
        place: found.userData.tip.clone().multiplyScalar(text === "L" ? 1.08 : 1.16).applyQuaternion(motion.space),
      })),
  ];
  panel.probe = () => {
    body.updateWorldMatrix(true, false);
    return {
      matrix: [...body.matrixWorld.elements],
      axisTip: end.clone().applyMatrix4(body.matrixWorld).toArray(),
      trace: [...trace.points].slice(0, 3 * (trace.shown + 1)),
      momentumTip: arrows.L?.userData.tip?.toArray() ?? null,
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

/** Return how fast a rotor turns at first, in words. */
function turning(rate) {
  if (rate === null) return ", drawn at rest: its moment is not given";
  return `, ${worded((rate * 30) / Math.PI, 4)} rpm against the body`;
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
    let size = 0;
    for (let k = 0; k < vertices.length; k += 3) {
      size = Math.max(size, Math.hypot(vertices[k], vertices[k + 1], vertices[k + 2]));
    }
    const colors = unpacked(data.surface.colors);
    found.add(surface(vertices.map((x) => x / size), unpacked(data.surface.faces), theme.body, theme.edge, colors));
  } else if (data.ellipsoid) {
    const size = Math.max(...data.ellipsoid);
    found.add(ellipsoid(data.ellipsoid.map((x) => x / size), theme.body, theme.edge));
  }
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

function point(found, vector, attitude, most) {
  if (!found) return;
  const size = most ? vector.length() / most : 0;
  if (size > 0) found.point(vector.clone().applyQuaternion(attitude), LONGEST * size);
  else found.visible = false;
}

function largest(values) {
  let found = 0;
  for (let k = 0; values && k < values.length; k += 3) found = Math.max(found, Math.hypot(values[k], values[k + 1], values[k + 2]));
  return found;
}
