// Mass points that can be dragged, their tensor as numbers, and the principal axes that it has.
import { between } from "./lib/address.js";
import { mixed } from "./lib/colours.js";
import { drawBall, drawCurve, write } from "./lib/ink.js";
import { Panel } from "./lib/panel.js";
import { Solid, drawSolids, ellipsoidForm } from "./lib/solids.js";
import { sum, times } from "./lib/vectors.js";
import { bodyOf, equalEllipsoid } from "./physics/inertia.js";

const NAMES = ["a", "b", "c", "d", "e"];
const MASSES = [0.1, 4]; // kg
const FAR = 1.2; // m that a coordinate may reach
const START = { a: [0.9, 0.25, 0.1], b: [-0.7, 0.55, 0], c: [-0.5, -0.75, 0.2], d: [0.3, 0.1, 0.65], e: [0.15, -0.35, -0.55] };
const START_MASS = { a: 1, b: 1.5, c: 1, d: 0.8, e: 1.2 };
const size = (mass) => 11 * Math.cbrt(mass);
const round = (x) => Number(Math.min(FAR, Math.max(-FAR, x)).toFixed(3));

const pointsOf = (settings) => NAMES.map((name) => settings[name]);
const massesOf = (settings) => NAMES.map((name) => settings[`m${name}`]);

function drawTensor(paper, theme, tensor, width) {
  const [x, y, column, line] = [width - 8, 16, 56, 18];
  const say = { ground: theme.ground, align: "right", size: 13 };
  write(paper, "inertia tensor, kg m²", [x, y], { ...say, colour: theme.quiet });
  tensor.forEach((row, i) => row.forEach((entry, j) => {
    const place = [x - column * (2 - j), y + line * (i + 1) + 2];
    write(paper, entry.toFixed(3).replace("-", "−"), place, { ...say, colour: i === j ? theme.text : theme.quiet, weight: i === j ? "600" : "" });
  })); // prettier-ignore
}

function drawFrame(paper, view, theme) {
  ["x", "y", "z"].forEach((name, k) => {
    const tip = [0, 0, 0];
    tip[k] = 1.35;
    drawCurve(paper, view, [times(tip, -1), tip], { colour: theme.line, width: 1 });
    write(paper, name, view.pixel(times(tip, 1.05)), { colour: theme.quiet, symbol: true, weight: "400", size: 15, ground: theme.ground });
  });
}

function draw(paper, { model, settings, theme, view, width }) {
  const { centre, axes, half } = model;
  drawFrame(paper, view, theme);
  const shown = half.map((x) => Math.max(x, 0.015));
  const solid = new Solid({ view, form: ellipsoidForm(shown, axes), centre, colour: theme.momentumSphere, opacity: 0.5 });
  const points = pointsOf(settings);
  const order = points.map((p, k) => [view.depth(p), k]).sort((a, b) => a[0] - b[0]);
  const middle = view.depth(centre);
  const drawMass = ([depth, k]) => {
    drawCurve(paper, view, [centre, points[k]], { colour: theme.family, width: 1.5, faint: 1 });
    const chosen = NAMES[k] === settings.mass;
    const radius = size(settings[`m${NAMES[k]}`]) * (1 + 0.1 * depth);
    drawBall(paper, view.pixel(points[k]), radius, chosen ? theme.border : theme.edge, theme.ground);
    write(paper, NAMES[k], view.pixel(points[k]), { colour: theme.ground, size: 13, weight: "700" });
  };
  order.filter(([depth]) => depth < middle).forEach(drawMass);
  drawSolids(paper, view, [solid]);
  solid.drawEdge(paper, mixed(theme.momentumSphere, theme.text, 0.35), 1);
  axes.forEach((axis, k) => {
    const out = times(axis, Math.max(0.9, half[k] + 0.25));
    const line = Array.from({ length: 25 }, (_, n) => sum(centre, times(out, n / 12 - 1)));
    drawCurve(paper, view, line, { colour: theme.axes[k], width: 3, solids: [solid], faint: 0.35 });
    write(paper, String(k + 1), view.pixel(sum(centre, times(out, 1.1))), { colour: theme.axes[k], ground: theme.ground, weight: "700", size: 16 });
  });
  order.filter(([depth]) => depth >= middle).forEach(drawMass);
  drawBall(paper, view.pixel(centre), 4, theme.text, theme.ground);
  drawTensor(paper, theme, model.tensor, width);
}

/** Show the chosen mass in the sliders. */
function follow(panel) {
  const { settings, shown } = panel;
  ["x", "y", "z"].forEach((key, k) => shown[key].show(settings[settings.mass][k]));
  shown.kilograms.show(settings[`m${settings.mass}`]);
}

function changed(key, panel) {
  const { settings } = panel;
  const k = ["x", "y", "z"].indexOf(key);
  if (k >= 0) {
    const point = [...settings[settings.mass]];
    point[k] = settings[key];
    panel.set(settings.mass, point);
  }
  if (key === "kilograms") panel.set(`m${settings.mass}`, settings.kilograms);
  for (const own of ["x", "y", "z", "kilograms"]) delete settings[own]; // they stand under the mass's own name
  panel.prepared = false;
}

const isPoint = (value) => Array.isArray(value) && value.length === 3 && value.every((x) => Math.abs(x) <= FAR);
const aPoint = { allows: (value) => (isPoint(value) ? value : undefined), wants: `three numbers from ${-FAR} to ${FAR}, in metres` };
const aMass = between(...MASSES);
const metres = (value) => `${value.toFixed(2).replace("-", "−")} m`;
const coordinate = (key) => ({ kind: "slider", key, label: `${key} of the mass`, least: -FAR, most: FAR, step: 0.01, say: metres });

new Panel({
  name: "inertia",
  initial: { mass: "a", ...START, ...Object.fromEntries(NAMES.map((name) => [`m${name}`, START_MASS[name]])), turn: 0.5, lift: 0.42 },
  hidden: { ...Object.fromEntries(NAMES.flatMap((name) => [[name, aPoint], [`m${name}`, aMass]])) },
  controls: [
    { kind: "choice", key: "mass", label: "mass", options: NAMES.map((name) => [name, name]) },
    coordinate("x"), coordinate("y"), coordinate("z"),
    { kind: "slider", key: "kilograms", label: "how heavy", least: MASSES[0], most: MASSES[1], step: 0.05, say: (value) => `${value.toFixed(2)} kg` },
  ],
  changed,
  prepare(settings) {
    const body = bodyOf(massesOf(settings), pointsOf(settings));
    if (globalThis.panel) follow(globalThis.panel);
    return { ...body, half: equalEllipsoid(body.mass, body.moments) };
  },
  readings: ({ moments, mass, tensor }) => [
    ["I1", "I₁, axis 1 (least)", moments[0], "kg m²"],
    ["I2", "I₂, axis 2", moments[1], "kg m²"],
    ["I3", "I₃, axis 3 (most)", moments[2], "kg m²"],
    ["Jxx", "Jxx", tensor[0][0], "kg m²"],
    ["Jxy", "Jxy", tensor[0][1], "kg m²"],
    ["mass", "whole mass", mass, "kg"],
  ],
  describe: ({ moments }) =>
    `Five masses, the ellipsoid with the same moments and its three axes; principal moments ${moments.map((x) => x.toFixed(3)).join(", ")} kg m².`,
  frame: ({ width, height }) => ({ scale: Math.min(width, height) / 2.75, x: width / 2, y: height * 0.53 }),
  grab(place, panel, look = false) {
    const { view, settings } = panel;
    if (!view) return null;
    const distance = (name) => {
      const [x, y] = view.pixel(settings[name]);
      return Math.hypot(x - place[0], y - place[1]);
    };
    const name = [...NAMES].sort((a, b) => distance(a) - distance(b))[0];
    if (distance(name) > Math.max(18, size(settings[`m${name}`]) + 5)) return null;
    if (look) return true;
    panel.set("mass", name);
    const start = settings[name];
    return { move: ([u, v]) => panel.set(name, sum(start, view.unproject(u - place[0], v - place[1])).map(round)) };
  },
  freely: true,
  keys(key, panel) {
    if (!NAMES.includes(key)) return false;
    panel.set("mass", key);
    return true;
  },
  draw,
});
globalThis.panel.set("mass", globalThis.panel.settings.mass);
