// Each axis from close by: the exact polhode and the linear motion, and both tilts against time.
import { mixed } from "./lib/colours.js";
import { drawBall, write } from "./lib/ink.js";
import { inset, split } from "./lib/layout.js";
import { Panel } from "./lib/panel.js";
import { Plot } from "./lib/plot.js";
import { degrees, radians } from "./lib/vectors.js";
import { across, exactAt, exponentOf, linearAt, motionOf, tiltAt } from "./physics/axes.js";

const SPAN = 16; // s that the graph shows
const COUNT = 640;
const stroke = (paper, pixels, colour, width, dash = []) => {
  Object.assign(paper, { strokeStyle: colour, lineWidth: width, lineCap: "round", lineJoin: "round" });
  paper.setLineDash(dash);
  paper.beginPath();
  pixels.forEach(([x, y]) => paper.lineTo(x, y));
  paper.stroke();
  paper.setLineDash([]);
};

/** Draw the sphere as seen along the axis, enlarged until the tilt is large in it. */
function drawMap(paper, box, { model, settings, theme, time }) {
  const { axis, motion, tilt, zoom } = model;
  const radius = Math.min(box.width, box.height - 22) / 2 - 8;
  const [x, y] = [box.left + box.width / 2, box.top + 20 + (box.height - 20) / 2];
  const at = ([a, b]) => [x + (radius * a) / zoom, y - (radius * b) / zoom];
  const glow = paper.createRadialGradient(x - 0.3 * radius, y - 0.4 * radius, 0, x, y, radius);
  const dark = theme.name === "dark";
  glow.addColorStop(0, dark ? mixed(theme.momentumSphere, theme.ground, 0.25) : theme.ground);
  glow.addColorStop(1, dark ? mixed(theme.momentumSphere, theme.ground, 0.7) : theme.momentumSphere);
  paper.save();
  paper.beginPath();
  paper.arc(x, y, radius, 0, 2 * Math.PI);
  paper.globalAlpha = 0.75;
  paper.fillStyle = glow;
  paper.fill();
  paper.globalAlpha = 1;
  paper.clip();
  const [i, j] = across(axis);
  stroke(paper, [[x - radius, y], [x + radius, y]], theme.axes[i], 1);
  stroke(paper, [[x, y - radius], [x, y + radius]], theme.axes[j], 1);
  for (const other of model.family) stroke(paper, other.map(at), theme.family, 1);
  stroke(paper, model.linear.map(at), theme.approximation, 2.2, [6, 5]);
  for (const points of model.seen) stroke(paper, points.map(at), theme.motion, 3.2);
  const straight = linearAt(axis, tilt, time);
  drawBall(paper, at(straight), 6, theme.approximation, theme.ground);
  const exact = exactAt(motion, axis, time);
  paper.globalAlpha = exact[2] >= 0 ? 1 : 0.35;
  drawBall(paper, at(exact), 7, theme.motion, theme.ground);
  paper.globalAlpha = 1;
  paper.restore();
  const rim = Array.from({ length: 97 }, (_, k) => (Math.PI * k) / 48);
  stroke(paper, rim.map((angle) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]), theme.ring, 1.2);
  const enlarged = zoom < 1 ? `enlarged ${(1 / zoom).toFixed(zoom > 0.1 ? 1 : 0)} times` : "the whole sphere";
  write(paper, `axis ${axis + 1} from outside, ${enlarged}`, [x, box.top + 9], { colour: theme.quiet, size: 12 });
  write(paper, String(i + 1), [x + radius - 11, y - 11], { colour: theme.axes[i], weight: "700", ground: theme.ground });
  write(paper, String(j + 1), [x + 11, y - radius + 12], { colour: theme.axes[j], weight: "700", ground: theme.ground });
  return settings;
}

function drawTilt(paper, box, { model, theme, time }) {
  const [low, high] = model.stable ? model.bounds : [0, 180];
  const begun = Math.max(0, Math.floor(time / SPAN) * SPAN);
  const plot = new Plot(paper, { ...inset(box, 38, 40), x: [begun, begun + SPAN], y: [low, high], theme });
  plot.axes({ x: "time, s", y: "tilt of L from the axis, degrees", yTicks: model.stable ? null : [0, 45, 90, 135, 180] });
  const times = Array.from({ length: COUNT + 1 }, (_, k) => begun + (SPAN * k) / COUNT);
  const straight = (t) => degrees(Math.atan(Math.hypot(...linearAt(model.axis, model.tilt, t))));
  const shown = model.stable ? straight : (t) => degrees(Math.hypot(...linearAt(model.axis, model.tilt, t)));
  plot.curve(times.map((t) => [t, Math.min(shown(t), 4 * high)]), { colour: theme.approximation, width: 2, dash: [6, 5] });
  plot.curve(times.map((t) => [t, degrees(tiltAt(model.motion, model.axis, t))]), { colour: theme.motion, width: 3 });
  const tilt = degrees(tiltAt(model.motion, model.axis, time));
  drawBall(paper, [plot.atX(time), plot.atY(tilt)], 6, theme.motion, theme.ground);
  const [right, line] = [box.left + box.width - 12, box.top + 10];
  write(paper, "exact", [right - 62, line], { colour: theme.motion, weight: "600", align: "right", ground: theme.ground });
  write(paper, "linear", [right, line], { colour: theme.approximation, weight: "600", align: "right", ground: theme.ground });
}

new Panel({
  name: "axes",
  initial: { axis: 2, tilt: 3, whole: 0 },
  plays: true,
  controls: [
    { kind: "choice", key: "axis", label: "spins about axis", options: [[1, "1"], [2, "2"], [3, "3"]] },
    { kind: "slider", key: "tilt", label: "tilt at the start", least: 0.01, most: 45, log: true, say: (value) => `${Number(value.toPrecision(3))}°` },
    { kind: "switch", key: "whole", label: "the whole sphere" },
  ],
  changed: (key, panel) => key !== "whole" && panel.seek(0),
  prepare({ axis: number, tilt: angle, whole }) {
    const [axis, tilt] = [number - 1, radians(angle)];
    const motion = motionOf(axis, tilt);
    const { stable, rate } = exponentOf(axis);
    const zoom = whole ? 1 : Math.min(1, (stable ? 2 : 8) * Math.sin(tilt));
    const curve = (body) => {
      const points = [...body.along(720), body.along(1)[0]].map((L) => [...across(axis), axis].map((k) => L[k] / body.momentumNorm));
      const pieces = [[]];
      for (const p of points) p[2] >= 0 ? pieces.at(-1).push(p) : pieces.at(-1).length && pieces.push([]);
      return [pieces.filter((piece) => piece.length > 1), pieces.filter((piece) => piece.length > 1).map((piece) => piece.map(([a, b]) => [-a, -b]))];
    };
    const [seen, opposite] = curve(motion);
    const span = stable ? (2 * Math.PI) / rate : Math.log((4 * zoom) / Math.sin(tilt) + 2) / rate;
    const linear = Array.from({ length: 241 }, (_, k) => linearAt(axis, tilt, (span * k) / 240));
    const family = [0.35, 0.65, 1.6, 2.4, 3.6].filter((share) => share * angle < 80).flatMap((share) => curve(motionOf(axis, share * tilt)).flat());
    const tilts = Array.from({ length: 60 }, (_, k) => degrees(tiltAt(motion, axis, (k * motion.period) / 60)));
    const bounds = [Math.min(...tilts), Math.max(...tilts)];
    const margin = 0.4 * (bounds[1] - bounds[0]);
    const period = stable ? (2 * Math.PI) / rate : null;
    return { axis, tilt, motion, stable, rate, zoom, seen, family: [...family, ...opposite], linear, period,
      bounds: [bounds[0] - margin, bounds[1] + margin] }; // prettier-ignore
  },
  readings: ({ motion, stable, rate, period, tilt }) => [
    ["verdict", "this axis is", stable ? "stable" : "unstable"],
    ["rate", stable ? "linear: circles at" : "linear: grows at", rate, stable ? "rad/s" : "1/s"],
    stable ? ["linear", "linear: round in", period, "s"] : ["growth", "tilt times e in", 1 / rate, "s"],
    ["exact", stable ? "exact: round in" : "exact: turned over in", stable ? motion.period : motion.flipInterval, "s"],
    stable && ["difference", "differs by", motion.period / period - 1, "", 3],
    !stable && ["reach", "linear: tilt 90° in", Math.asinh(Math.PI / 2 / Math.sin(tilt)) / rate, "s"],
    ["moments", "I₁, I₂, I₃", "1, 2, 3 kg m²"],
  ],
  describe: ({ axis, stable }, { tilt }) =>
    `Axis ${axis + 1} with a tilt of ${tilt} degrees: ${stable ? "L circles it" : "L leaves it and turns over"}; the exact motion and the linear one, on the sphere and against time.`,
  draw(paper, scene) {
    const [map, graph] = split(scene.width, scene.height, scene.width > 1.45 * scene.height ? 0.5 : 0.56);
    drawMap(paper, map, scene);
    drawTilt(paper, graph, scene);
  },
});
