// The momentum sphere, in body axes: levels of the energy, separatrix, this motion, and where it is now.
import { Vector3 } from "three";
import { unpacked } from "../motion.js";
import { dot, drawUpTo, globe, line, path, pieces } from "../shapes.js";
import { newPanel } from "../stage.js";

export function spherePanel(motion, data, theme) {
  const panel = newPanel(theme, { title: data.title, words: data.words, radius: 1.36 });
  const { scene } = panel;
  scene.add(globe(theme));
  const [family, border] = [unpacked(data.family), unpacked(data.separatrix)];
  if (family?.length) scene.add(pieces(family, theme.family, 1));
  if (border?.length) scene.add(pieces(border, theme.border, 1.8));
  const own = unpacked(data.own);
  const points = own ?? directions(motion);
  const trail = own ? line(own, theme.motion, 3.2) : path(motion, points, theme.motion, 2);
  scene.add(trail);
  const place = dot(theme.motion, theme.ground, 0.035);
  scene.add(place);
  const stubs = [0, 1, 2].map((k) => {
    const end = new Vector3().setComponent(k, 1.2);
    const start = new Vector3().setComponent(k, 1);
    scene.add(line([...start.toArray(), ...end.toArray()], theme.axes[k], 2.5));
    return end;
  });
  panel.legend = [
    { color: theme.motion, text: "this motion" },
    ...(border?.length ? [{ color: theme.border, text: "separatrix" }] : []),
    ...(family?.length ? [{ color: theme.family, text: data.legend }] : []),
  ];
  panel.update = (now) => {
    const norm = now.momentum.length();
    place.visible = norm > 0;
    if (norm > 0) place.position.copy(now.momentum).divideScalar(norm);
    if (!own) drawUpTo(motion, trail, Math.floor(now.position * motion.fine));
  };
  panel.labels = () =>
    stubs.map((end, k) => ({ text: `L${"₁₂₃"[k]}`, color: theme.axes[k], place: end.clone().multiplyScalar(1.08) }));
  panel.probe = () => ({ point: place.position.toArray(), path: [...points], closed: Boolean(own) });
  return panel;
}

/** Return the direction of L at each point of a drawn curve. */
function directions(motion) {
  const found = new Float64Array(3 * motion.states.length);
  motion.states.forEach(({ momentum }, k) => momentum.clone().normalize().toArray(found, 3 * k));
  return found;
}
