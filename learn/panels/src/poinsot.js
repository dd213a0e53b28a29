// The inertia ellipsoid rolls on its plane: polhode on the body, herpolhode on the plane.
import { mixed, channels } from "./lib/colours.js";
import { drawArrow, drawBall, drawCurve, writeAtTip, write } from "./lib/ink.js";
import { turnedBy } from "./lib/meshes.js";
import { Panel } from "./lib/panel.js";
import { Solid, drawSolids, ellipsoidForm } from "./lib/solids.js";
import { circle, degrees, times, unit } from "./lib/vectors.js";
import { LEAST, MOST } from "./physics/surfaces.js";
import { HALF_AXES, contactAt, herpolhodeRadii, motionOf, planeDistance } from "./physics/poinsot.js";

const PLANE = 1.02; // radius of the piece of the plane that is drawn
const SAMPLES = 500;

/** Where the planes of two axes cut the ellipsoid. */
const MERIDIANS = [0, 1, 2].map((k) => Array.from({ length: 73 }, (_, n) => {
  const point = [0, 0, 0];
  point[(k + 1) % 3] = HALF_AXES[(k + 1) % 3] * Math.cos((Math.PI * n) / 36);
  point[(k + 2) % 3] = HALF_AXES[(k + 2) % 3] * Math.sin((Math.PI * n) / 36);
  return point;
})); // prettier-ignore

/** Return a pattern of eighths, in the body's axes, for the camera's directions. */
function eighths(view, turn, colours) {
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => view.turned(turn(axis))); // prettier-ignore
  const [[a, b, c], [d, e, f], [g, h, i]] = axes;
  return (x, y, z) => colours[(a * x + b * y + c * z > 0) !== (d * x + e * y + f * z > 0) !== (g * x + h * y + i * z > 0) ? 1 : 0];
}

function drawPlane(paper, view, theme, depth, above) {
  const rim = circle([0, 0, -depth], [0, 0, 1], PLANE, 96).map((p) => view.pixel(p));
  paper.beginPath();
  rim.forEach(([x, y]) => paper.lineTo(x, y));
  paper.globalAlpha = above ? 1 : 0.55; // from below the plane is of glass
  paper.fillStyle = theme.plane;
  paper.fill();
  paper.globalAlpha = 1;
  paper.strokeStyle = theme.ring;
  paper.lineWidth = 1.2;
  paper.stroke();
  if (!above) return;
  const [x, y] = view.pixel([0, 0, -depth]);
  const flat = Math.abs(Math.sin(Math.asin(view.rows[2][2])));
  paper.save();
  paper.translate(x, y);
  paper.scale(1, Math.max(flat, 0.02));
  const shadow = paper.createRadialGradient(0, 0, 0, 0, 0, 0.75 * view.scale);
  shadow.addColorStop(0, theme.name === "dark" ? "#0009" : "#0003");
  shadow.addColorStop(1, "#0000");
  paper.fillStyle = shadow;
  paper.beginPath();
  paper.arc(0, 0, 0.75 * view.scale, 0, 2 * Math.PI);
  paper.fill();
  paper.restore();
}

function draw(paper, { model, settings, theme, view, time }) {
  const { motion, depth } = model;
  const now = contactAt(motion, time);
  const turn = turnedBy(now.attitude);
  const above = view.rows[2][2] > 0;
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(turn); // prettier-ignore
  const colours = [theme.body, mixed(theme.body, theme.ground, 0.42)].map(channels);
  const solid = new Solid({ view, form: ellipsoidForm(HALF_AXES, axes), colour: theme.body, opacity: 0.86, pattern: eighths(view, turn, colours) });
  const drawBelow = () => {
    drawPlane(paper, view, theme, depth, above);
    const solids = above ? [solid] : [];
    const past = [];
    const from = Math.max(0, time - model.span);
    for (let k = 0; k <= SAMPLES; k++) past.push(contactAt(motion, from + ((time - from) * k) / SAMPLES).inSpace);
    if (settings.whole) drawCurve(paper, view, model.curve, { colour: theme.family, width: 1.3, solids, faint: 0.16 });
    if (time > 0) drawCurve(paper, view, past, { colour: theme.herpolhode, width: 2.6, solids, faint: 0.3 });
  };
  const drawBody = () => {
    drawSolids(paper, view, [solid]);
    solid.drawEdge(paper, mixed(theme.body, theme.text, 0.4), 1.2);
    const thin = { colour: mixed(theme.body, theme.text, 0.25), width: 1, solids: [solid], faint: 0, margin: 0.01 };
    for (const meridian of MERIDIANS) drawCurve(paper, view, meridian.map(turn), thin);
    drawCurve(paper, view, model.polhode.map(turn), { colour: theme.motion, width: 3.2, solids: [solid], faint: 0.42, margin: 0.01 });
    axes.forEach((axis, k) => {
      const from = times(axis, HALF_AXES[k]);
      const to = times(axis, HALF_AXES[k] + 0.22);
      drawCurve(paper, view, [from, times(axis, HALF_AXES[k] + 0.11), to], { colour: theme.axes[k], width: 3, solids: [solid], faint: 0.15 });
      const behind = view.depth(axis) < -0.2; // a number seen through the body is pale, as its axis is
      const options = { colour: mixed(theme.axes[k], theme.ground, behind ? 0.35 : 0), ground: theme.ground, weight: "700", size: 14 };
      write(paper, String(k + 1), view.pixel(times(axis, HALF_AXES[k] + 0.31)), options);
    });
  };
  for (const drawPart of above ? [drawBelow, drawBody] : [drawBody, drawBelow]) drawPart();
  const solids = [solid];
  drawArrow(paper, view, [0, 0, 0], [0, 0, 1.25], { colour: theme.momentum, width: 4.5, solids });
  const velocity = times(unit(turn(motion.angularVelocity(time))), 1.2);
  drawArrow(paper, view, [0, 0, 0], velocity, { colour: theme.velocity, width: 4.5, solids });
  drawCurve(paper, view, [[0, 0, 0], now.inSpace], { colour: theme.velocity, width: 2.4, solids, dash: [4, 4], faint: 0.35 });
  drawBall(paper, view.pixel(now.inSpace), 5.5, theme.velocity, theme.ground);
  const [x, y] = view.pixel([0, 0, 1.25]);
  write(paper, "L", [x + (view.pixel(velocity)[0] < x ? 15 : -15), y + 4], { colour: theme.momentum, ground: theme.ground, symbol: true });
  writeAtTip(paper, view, [0, 0, 0], velocity, "Ω", { colour: theme.velocity, ground: theme.ground });
}

new Panel({
  name: "poinsot",
  initial: { energy: 1.86, whole: 1, turn: 0.4, lift: -0.3 },
  plays: true,
  controls: [
    { kind: "slider", key: "energy", label: "energy 2E", least: LEAST + 0.004, most: MOST - 0.02, step: 0.001, say: (value) => `${value.toFixed(3)} J` },
    { kind: "switch", key: "whole", label: "where the contact will run" },
  ],
  changed: (key, panel) => key === "energy" && panel.seek(0),
  prepare({ energy }) {
    const motion = motionOf(energy);
    const span = 12 * Math.min(motion.period, 30);
    const polhode = motion.along(241).map((L) => times(L.map((x, k) => x / motion.moments[k]), -1 / Math.sqrt(2 * motion.energy)));
    const curve = Array.from({ length: 1001 }, (_, k) => contactAt(motion, (0.5 * span * k) / 1000).inSpace);
    return { motion, span, polhode: [...polhode, polhode[0]], curve, depth: planeDistance(motion), radii: herpolhodeRadii(motion),
      scale: Math.sqrt(energy) }; // prettier-ignore
  },
  readings: ({ motion, depth, radii, scale }) => [
    ["along", "Ω along L", scale * depth, "rad/s"],
    ["period", "polhode closes in", motion.period, "s"],
    ["turn", "axis round L meanwhile", degrees(motion.precessionPerPeriod), "°"],
    ["inner", "Ω across L from", scale * radii[0], "rad/s"],
    ["outer", "to", scale * radii[1], "rad/s"],
    ["moments", "I₁, I₂, I₃", "1, 2, 3 kg m²"],
  ],
  describe: (model, { energy }) =>
    `An ellipsoid rolls on a plane below it; its contact draws a closed curve on the ellipsoid and a rosette on the plane. 2E is ${energy} J.`,
  frame: ({ width, height }) => ({ scale: Math.min(width / 2.2, height / 2.75), x: width / 2, y: height * 0.56 }),
  draw,
});
