// A top's axis on the sphere of directions, in space, z up, between the circles that bound its tilt.
import { Vector3 } from "three";
import { arrow, circle, dot, drawUpTo, globe, hairline, path } from "../shapes.js";
import { newPanel } from "../stage.js";

export function axisPanel(motion, data, theme) {
  const words = data.center ? "from the pivot towards the centre of mass" : "third principal axis";
  const panel = newPanel(theme, { title: "Path of the axis", words, radius: 1.4, target: new Vector3(0, 0, 0.12) });
  const { scene } = panel;
  const axis = new Vector3(...data.axis);
  const found = motion.solver?.nutationLimits ?? null;
  const limits = found ? found.filter((height) => height !== null && Math.abs(height) < 1) : data.limits;
  scene.add(globe(theme), circle(1, 0, theme.family));
  for (const height of limits) {
    scene.add(circle(Math.sqrt(Math.max(0, 1 - height * height)), height, theme.border, 1.5));
  }
  const points = new Float64Array(3 * motion.count);
  for (let k = 0; k < motion.count; k++) axis.clone().applyQuaternion(motion.attitude(k)).toArray(points, 3 * k);
  const trail = path(motion, points, theme.motion, 2.6);
  const faint = motion.joined ? hairline(points, theme.motion, 0.35) : null;
  const place = dot(theme.motion, theme.ground, 0.035);
  const up = arrow(theme.momentum, 0.012);
  up.position.set(0, 0, 1);
  up.point(new Vector3(0, 0, 1), 0.32);
  scene.add(trail, place, up);
  if (faint) scene.add(faint);
  panel.legend = [
    { color: theme.motion, text: "axis" },
    ...(limits.length ? [{ color: theme.border, text: "limits of its tilt" }] : []),
  ];
  panel.update = (now) => {
    place.position.copy(axis).applyQuaternion(now.attitude);
    drawUpTo(motion, trail, Math.floor(now.position));
  };
  panel.labels = () => [{ text: "up", color: theme.momentum, place: new Vector3(0, 0, 1.42) }];
  panel.probe = () => ({ point: place.position.toArray(), path: [...points], limits });
  return panel;
}
