// The momentum sphere, in body axes: levels of the energy, separatrix, this motion, and where it is now.
import { Vector3 } from "three";
import { unpacked } from "../motion.js";
import { family, levels, pairThrough, polhodeThrough, rests, separatrix } from "../polhodes.js";
import { arrowhead, dot, drawUpTo, globe, line, mark, path, pieces, specks } from "../shapes.js";
import { newPanel } from "../stage.js";
import { energySurface } from "./energy.js";

const GRASP = 18; // pixels from the point within which a press takes hold of it
const SAMPLED = 1.012; // height of measured points, above the curves
const HEADS = 4; // arrowheads on this motion's polhode
const COLORS = { stable: "stable", unstable: "border", undecided: "undecided" };
const [VEIL, SEEN_THROUGH] = [0.8, 0.55]; // opacity of the sphere, without and with the ellipsoid over it
const NAMES = { stable: "stable", unstable: "unstable", undecided: "undecided" };

export function spherePanel(motion, data, theme) {
  const panel = newPanel(theme, { title: data.title, words: data.words, radius: 1.36 });
  const { scene } = panel;
  const color = data.families ? theme.text : theme.motion; // other curves have colours of their own there
  const ball = globe(theme);
  scene.add(ball);
  // a free body's curves are known in closed form, those of other systems come with the page
  const start = motion.free ? motion.at(0).momentum.toArray() : null;
  const [others, border] = start
    ? [data.families ? [] : family(motion.free), separatrix(motion.free)]
    : data.changed && motion.solver
      ? [levels(motion.moments, motion.solver.rotor ?? [0, 0, 0], motion.at(0).momentum.length()), []]
      : [unpacked(data.family) ?? [], unpacked(data.separatrix) ?? []];
  if (others.length) scene.add(pieces(others, theme.family, 1));
  for (const { starts, axis } of data.families ?? []) scene.add(pieces(starts.flatMap((unit) => pairThrough(motion.free, unit)), theme.axes[axis], 1, 0.75));
  if (border.length) scene.add(pieces(border, theme.border, 1.8));
  const own = start && Math.hypot(...start) > 0 ? polhodeThrough(motion.free, start) : null;
  const points = own ?? directions(motion);
  const trail = own ? line(own, color, 3.2) : path(motion, points, color, 2);
  scene.add(trail);
  if (own) for (const head of heads(motion.free, own, color)) scene.add(head);
  const measured = data.changed ? null : data.measured; // of a log, which a motion that was set here did not make
  if (measured) scene.add(specks(measured.map((value) => SAMPLED * value), theme.velocity, 6));
  const place = dot(color, theme.ground, 0.035);
  scene.add(place);
  const stubs = [0, 1, 2].map((k) => {
    const end = new Vector3().setComponent(k, 1.2);
    scene.add(line([...new Vector3().setComponent(k, 1).toArray(), ...end.toArray()], theme.axes[k], 2.5));
    return end;
  });
  const marks = motion.free ? rests(motion.free) : data.equilibria ?? [];
  for (const { at, verdict } of marks) scene.add(mark(new Vector3(...at), verdict, theme[COLORS[verdict]], theme.ground));
  const surface = energySurface(motion, data, theme);
  if (surface) scene.add(surface.object);
  const said = [...new Set(marks.map(({ verdict }) => verdict))];
  panel.legend = [
    { color, text: "this motion" },
    ...(measured ? [{ color: theme.velocity, text: "measured" }] : []),
    ...(border.length ? [{ color: theme.border, text: "separatrix" }] : []),
    ...(others.length ? [{ color: theme.family, text: data.legend }] : []),
    ...(data.families ?? []).map(({ axis, legend }) => ({ color: theme.axes[axis], text: legend })),
    ...said.map((verdict) => ({ color: theme[COLORS[verdict]], text: NAMES[verdict] })),
    ...(surface ? [surface.entry] : []),
  ];
  panel.update = (now) => {
    const norm = now.momentum.length();
    place.visible = norm > 0;
    if (norm > 0) place.position.copy(now.momentum).divideScalar(norm);
    if (!own) drawUpTo(motion, trail, Math.floor(now.position * motion.fine));
    ball.material.opacity = surface?.show(now) ? SEEN_THROUGH : VEIL;
  };
  panel.labels = () =>
    stubs.map((end, k) => ({ text: data.axes?.[k] ?? `L${"₁₂₃"[k]}`, color: theme.axes[k], place: end.clone().multiplyScalar(1.08) }));
  panel.grasp = ([x, y], width) => {
    const seen = place.position.clone().project(panel.camera);
    const facing = place.position.dot(panel.camera.position) > 1;
    return motion.free && facing && Math.hypot(seen.x - x, seen.y - y) * 0.5 * width < GRASP;
  };
  panel.under = (at) => onSphere(at, panel.camera);
  panel.probe = () => ({
    point: place.position.toArray(),
    path: [...points],
    closed: Boolean(own),
    measured,
    surface: surface?.probe() ?? null,
    seen: place.position.clone().project(panel.camera).toArray(),
  });
  return panel;
}

/** Return the direction of L at each point of a drawn curve. */
function directions(motion) {
  const found = new Float64Array(3 * motion.states.length);
  motion.states.forEach(({ momentum }, k) => momentum.clone().normalize().toArray(found, 3 * k)); // zeros at rest
  return found;
}

/** Return arrowheads on a polhode of points [x, y, z, …]: which way L runs, dL/dt = L × I⁻¹L. */
function heads(moments, points, color) {
  const found = [];
  const count = points.length / 3 - 1;
  for (let k = 0; k < HEADS; k++) {
    const unit = new Vector3().fromArray(points, 3 * Math.round(((k + 0.5) / HEADS) * count));
    const rate = unit.clone().cross(new Vector3(...unit.toArray().map((value, j) => value / moments[j])));
    if (rate.length() > 0) found.push(arrowhead(color, unit, rate.normalize(), 0.085));
  }
  return found;
}

/** Return the point of the unit sphere that is seen at a place of the picture, or the nearest on its rim; null for none. */
function onSphere([x, y], camera) {
  const eye = camera.position.clone();
  const ray = new Vector3(x, y, 0.5).unproject(camera).sub(eye).normalize();
  const along = -eye.dot(ray);
  const nearest = eye.clone().addScaledVector(ray, along);
  const gap = nearest.lengthSq();
  if (gap >= 1) return nearest.lengthSq() > 0 ? nearest.normalize().toArray() : null;
  return eye.addScaledVector(ray, along - Math.sqrt(1 - gap)).normalize().toArray();
}
