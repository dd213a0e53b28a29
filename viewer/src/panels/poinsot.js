// Poinsot: the inertia ellipsoid Σ I x² = 1 rolls without slipping on the invariable plane, which lies below it here, so
// that it touches at x = −Ω/√(2E). The contact draws the polhode on the ellipsoid and the herpolhode on the plane.
import { Group, Vector3 } from "three";
import { arrow, dot, drawUpTo, ellipsoid, floor, hairline, path } from "../shapes.js";
import { newPanel } from "../stage.js";

export function poinsotPanel(motion, data, theme) {
  const start = motion.at(0).momentum;
  const { free: moments } = motion;
  if (!(start.length() > 0)) return newPanel(theme, { title: "Poinsot's ellipsoid", words: "at rest", update: () => {}, legend: [] });
  const energy = 0.5 * start.toArray().reduce((sum, value, k) => sum + (value * value) / moments[k], 0);
  const semiAxes = moments.map((moment) => 1 / Math.sqrt(moment));
  const unit = 1 / Math.max(...semiAxes);
  const inertia = { moments, energy };
  const distance = (unit * Math.sqrt(2 * energy)) / start.length();
  const contacts = contactPoints(motion, inertia, unit);
  const wide = Math.max(1.25 * reach(contacts, distance), 0.9);
  const height = 1.3; // of the tip of L
  const middle = 0.5 * (height - distance);
  const panel = newPanel(theme, {
    title: "Poinsot's ellipsoid",
    words: "rolls without slipping on the plane across L",
    radius: Math.hypot(Math.max(wide, 1), height - middle) * 1.04,
    target: new Vector3(0, 0, middle),
  });
  const space = new Group();
  space.quaternion.copy(motion.space);
  const body = ellipsoid(semiAxes.map((x) => x * unit), theme.body, theme.edge, 0.82);
  space.add(body);
  const plane = floor(wide, -distance, theme);
  panel.scene.add(space, plane);

  const inSpace = turned(motion, contacts);
  const polhode = path(motion, contacts, theme.motion, 3);
  const herpolhode = path(motion, inSpace, theme.herpolhode, 2.5);
  body.add(polhode);
  space.add(herpolhode);
  if (motion.joined) space.add(hairline(inSpace, theme.herpolhode, 0.45));
  const touch = dot(theme.velocity, theme.ground, 0.03);
  const axis = arrow(theme.velocity, 0.012);
  const normal = arrow(theme.momentum, 0.012);
  const foot = hairline([0, 0, -distance, 0, 0, 0], theme.edge);
  space.add(touch, axis);
  panel.scene.add(normal, foot);
  normal.point(new Vector3(0, 0, 1), height);
  let shown = 0;
  panel.legend = [
    { color: theme.motion, text: "polhode" },
    { color: theme.herpolhode, text: "herpolhode" },
    { color: theme.velocity, text: "contact, −Ω" },
  ];
  panel.update = (now) => {
    const k = Math.floor(now.position * motion.fine);
    body.quaternion.copy(now.attitude);
    touch.position.copy(contactOf(now.momentum, inertia, unit)).applyQuaternion(now.attitude);
    axis.point(touch.position, touch.position.length());
    drawUpTo(motion, polhode, k);
    drawUpTo(motion, herpolhode, k);
    shown = k;
  };
  panel.labels = () => [{ text: "L", color: theme.momentum, place: new Vector3(0, 0, height + 0.12) }];
  panel.probe = () => {
    for (const found of [body, plane, touch]) found.updateWorldMatrix(true, true);
    return {
      ellipsoid: [...body.userData.mesh.matrixWorld.elements],
      plane: [...plane.matrixWorld.elements],
      contact: new Vector3().setFromMatrixPosition(touch.matrixWorld).toArray(),
      bodyMatrix: [...body.matrixWorld.elements],
      spaceMatrix: [...space.matrixWorld.elements],
      polhode: [...contacts],
      herpolhode: [...inSpace],
      shown: shown / motion.fine, // in samples
    };
  };
  return panel;
}

function contactOf(momentum, { moments, energy }, unit) {
  const size = -unit / Math.sqrt(2 * energy);
  return new Vector3(...momentum.toArray().map((x, k) => (size * x) / moments[k]));
}

/** Return how far the contact gets from the foot of the perpendicular. */
function reach(contacts, distance) {
  let most = 0;
  for (let k = 0; k < contacts.length; k += 3) most = Math.max(most, Math.hypot(contacts[k], contacts[k + 1], contacts[k + 2]));
  return Math.sqrt(Math.max(0, most * most - distance * distance));
}

/** Return the points of the ellipsoid that touch the plane one after the other, in body axes. */
function contactPoints(motion, inertia, unit) {
  const found = new Float64Array(3 * motion.states.length);
  motion.states.forEach(({ momentum }, k) => contactOf(momentum, inertia, unit).toArray(found, 3 * k));
  return found;
}

/** Return the same points in space. */
function turned(motion, points) {
  const found = new Float64Array(points.length);
  motion.states.forEach(({ attitude }, k) => {
    new Vector3().fromArray(points, 3 * k).applyQuaternion(attitude).toArray(found, 3 * k);
  });
  return found;
}
