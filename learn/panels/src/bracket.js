// A function H on the spheres |L| = const, its flow under either sign of the bracket, and what another function F does along it.
import { channels, mixed } from "./lib/colours.js";
import { drawArrow, drawBall, drawCurve, write, writeAtTip } from "./lib/ink.js";
import { inset, split } from "./lib/layout.js";
import { Panel } from "./lib/panel.js";
import { Plot } from "./lib/plot.js";
import { Solid, drawSolids, ellipsoidForm } from "./lib/solids.js";
import { circle, size, sum, times } from "./lib/vectors.js";
import { FUNCTIONS, bracketOf, fieldOf, flowFrom, rateAlong, startAt } from "./physics/bracket.js";
import { valueOf, worded } from "./physics/polynomials.js";

const NAMES = {
  L1: "L₁", L2: "L₂", L3: "L₃", body: "½L₁² + ¼L₂² + ⅙L₃²", twist: "½L₃²", saddle: "L₁L₂", tilted: "½L₁² + L₃", casimir: "½|L|²",
}; // prettier-ignore
const options = Object.entries(NAMES);
const SPHERES = [0.5, 1, 1.5, 2];
const [BANDS, PAST, WINDOW, LONGITUDE] = [11, 5, 12, 0.9]; // colours; s of trail; s of graph; rad
const LEVEL = 1e-9; // of its size, by which H must vary to have bands
const GOLDEN = Math.PI * (3 - Math.sqrt(5));
const scattered = Array.from({ length: 170 }, (_, k) => {
  const height = 1 - (2 * (k + 0.5)) / 170;
  const level = Math.sqrt(1 - height * height);
  return [level * Math.cos(k * GOLDEN), level * Math.sin(k * GOLDEN), height];
});

/** Return the bands' colours from low H to high. */
function palette(theme) {
  const [low, middle, high] = theme.name === "dark" ? ["#2f6690", "#3a4552", "#a8742a"] : ["#9cc9ea", "#f4f5f6", "#f6c27c"];
  return Array.from({ length: BANDS }, (_, k) => {
    const place = (2 * k) / (BANDS - 1) - 1;
    return channels(place < 0 ? mixed(middle, low, -place) : mixed(middle, high, place));
  });
}

/** Return the bands of H as a pattern on the sphere, in the camera's directions. */
function bandsOf(view, H, [least, most], theme) {
  const colours = palette(theme);
  const [[a, b, c], [d, e, f], [g, h, i]] = view.rows;
  const span = most - least;
  if (!(span > LEVEL * (Math.abs(most) + Math.abs(least)))) return () => colours[BANDS >> 1]; // H is a Casimir, but for rounding
  const L = [0, 0, 0];
  return (x, y, z) => {
    L[0] = a * x + d * y + g * z;
    L[1] = b * x + e * y + h * z;
    L[2] = c * x + f * y + i * z;
    return colours[Math.min(BANDS - 1, Math.max(0, Math.floor((BANDS * (valueOf(H, L) - least)) / span)))];
  };
}

/** Draw the flow as short strokes on the side that is seen, longest where it is fastest. */
function drawFlow(paper, view, radius, field, theme) {
  const ways = scattered.map((p) => field(times(p, radius)));
  const fastest = Math.max(...ways.map(size));
  if (!(fastest > 1e-9)) return;
  Object.assign(paper, { strokeStyle: mixed(theme.text, theme.ground, 0.25), lineWidth: 1.3, lineCap: "round", globalAlpha: 0.75 });
  paper.beginPath();
  scattered.forEach((p, k) => {
    if (view.depth(p) < 0.12) return;
    const [from, to] = [-0.5, 0.5].map((share) => view.pixel(sum(times(p, radius), times(ways[k], (share * 0.24 * radius) / fastest))));
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const head = 0.34;
    paper.moveTo(...from);
    paper.lineTo(...to);
    if (Math.hypot(dx, dy) < 4) return;
    paper.moveTo(to[0] - head * (dx + 0.6 * dy), to[1] - head * (dy - 0.6 * dx));
    paper.lineTo(...to);
    paper.lineTo(to[0] - head * (dx - 0.6 * dy), to[1] - head * (dy + 0.6 * dx));
  });
  paper.stroke();
  paper.globalAlpha = 1;
}

function drawSphere(paper, { model, settings, theme, view, time }) {
  const { radius, turn, lift, H: name } = settings;
  const { H, flow, range } = model;
  const pattern = bandsOf(view, H, range, theme);
  const sphere = new Solid({ view, form: ellipsoidForm([radius, radius, radius]), opacity: 0.97, pattern });
  // the leaves: other spheres, from the innermost to the outermost
  const leaf = (r) => mixed(theme.motion, theme.border, (r - SPHERES[0]) / (SPHERES.at(-1) - SPHERES[0]));
  const outer = SPHERES.filter((r) => r > radius + 0.02);
  outer.forEach((r) => {
    new Solid({ view, form: ellipsoidForm([r, r, r]) }).drawEdge(paper, leaf(r), 1.3);
    const place = 0.707 * r * view.scale + 3;
    write(paper, `|L| = ${r}`, [view.x + place, view.y + place], { colour: leaf(r), size: 11, align: "left" });
  });
  drawSolids(paper, view, [sphere], { key: [radius, name, turn, lift, theme.name].join() });
  sphere.drawEdge(paper, mixed(theme.momentumSphere, theme.text, 0.35), 1.3);
  const solids = [sphere];
  SPHERES.filter((r) => r < radius - 0.02).forEach((r) => {
    drawCurve(paper, view, circle([0, 0, 0], view.rows[2], r), { colour: leaf(r), width: 1.2, solids, faint: 0.5, dash: [3, 4] });
  });
  drawFlow(paper, view, radius, model.field, theme);
  [0, 1, 2].forEach((k) => {
    const tip = [0, 0, 0];
    tip[k] = radius + 0.35;
    drawCurve(paper, view, [times(tip, radius / (radius + 0.35)), tip], { colour: theme.axes[k], width: 2, solids, faint: 0.2 });
    const options = { colour: theme.axes[k], ground: theme.ground, symbol: true, size: 16 };
    if (view.depth(tip) > -0.64) write(paper, `L${"₁₂₃"[k]}`, view.pixel(times(tip, 1.08)), options);
  });
  const trail = model.between(time - PAST, time, (t) => Array.from(flow.at(t)));
  drawCurve(paper, view, trail, { colour: theme.motion, width: 3.4, solids, faint: 0.25, margin: 0.03 });
  const L = Array.from(flow.at(time));
  const way = model.field(L);
  if (size(way) > 1e-9) drawArrow(paper, view, L, sum(L, times(way, 0.55 / Math.max(1, size(way)))), { colour: theme.change, width: 4 });
  drawBall(paper, view.pixel(L), view.depth(L) > 0 ? 7 : 5, theme.momentum, theme.ground);
  writeAtTip(paper, view, [0, 0, 0], L, "L", { colour: theme.momentum, ground: theme.ground }, 15);
}

const boxesOf = (width, height) => split(width, height, height < 300 ? 0.52 : 0.64);
const say = (value) => value.toFixed(6).replace("-", "−");

function drawRate(paper, box, { model, theme, time }) {
  const { F, flow, bounds, bracket } = model;
  const L = Array.from(flow.at(time));
  const [now, slope] = [rateAlong(F, flow, time), valueOf(bracket, L)];
  const from = Math.max(0, time - 0.6 * WINDOW);
  const plot = new Plot(paper, { ...inset(box, 42, 46, 12, 36), x: [from, from + WINDOW], y: bounds, theme });
  plot.axes({ x: "F against time", y: "" });
  const curve = model.watched(from, from + WINDOW);
  plot.curve(curve, { colour: theme.motion, width: 2.6 });
  const reach = 1.6;
  plot.curve([[time - reach, now.value - reach * slope], [time + reach, now.value + reach * slope]], { colour: theme.change, width: 2.6 });
  drawBall(paper, [plot.atX(time), plot.atY(now.value)], 6, theme.momentum, theme.ground);
  const left = box.left + 6;
  const lines = [[`dF/dt = ${say(now.rate)}  from the motion`, theme.motion], [`{F, H} = ${say(slope)}  from the bracket`, theme.change]];
  lines.forEach(([words, colour], k) => write(paper, words, [left, box.top + 9 + 16 * k], { colour, align: "left", weight: "600", size: 12.5 }));
}

/** Return a function that gives values at multiples of a step between two times, each computed once, and at the ends. */
function sampled(step) {
  const kept = new Map();
  return (from, to, compute) => {
    const found = [compute(from)];
    for (let k = Math.floor(from / step) + 1; k * step < to; k++) {
      if (!kept.has(k)) kept.set(k, compute(k * step));
      found.push(kept.get(k));
    }
    return [...found, compute(to)];
  };
}

/** Return the least and the most of H on a sphere, from points all over it. */
function rangeOn(H, radius) {
  const poles = [1, -1].flatMap((side) => [[side, 0, 0], [0, side, 0], [0, 0, side]]); // prettier-ignore
  const values = [...scattered, ...poles].map((p) => valueOf(H, times(p, radius)));
  return [Math.min(...values), Math.max(...values)];
}

new Panel({
  name: "bracket",
  initial: { H: "body", F: "L3", sign: -1, radius: 1.5, height: 0.35, turn: 0.75, lift: 0.4 },
  plays: true,
  controls: [
    { kind: "choice", key: "H", label: "H moves", list: true, options },
    { kind: "choice", key: "F", label: "F watched", list: true, options },
    { kind: "choice", key: "sign", label: "bracket", options: [[-1, "− (bodies)"], [1, "+ (spins)"]] },
    { kind: "slider", key: "radius", label: "sphere |L|", least: 0.5, most: 2, step: 0.01, say: (value) => value.toFixed(2) },
    { kind: "slider", key: "height", label: "L₃/|L| at the start", least: -0.95, most: 0.95, step: 0.01, say: (value) => value.toFixed(2).replace("-", "−") },
  ],
  prepare({ H: h, F: f, sign, radius, height }) {
    const [H, F] = [FUNCTIONS[h], FUNCTIONS[f]];
    const start = startAt(radius, height, LONGITUDE);
    const flow = flowFrom(H, start, sign);
    const values = Array.from({ length: 160 }, (_, k) => valueOf(F, flow.at(0.25 * k)));
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const margin = Math.max(0.15 * (high - low), 0.1);
    const between = sampled(0.05);
    const value = sampled(0.05);
    const watched = (from, to) => value(from, to, (t) => [t, valueOf(F, flow.at(t))]);
    return { H, F, sign, start, flow, between, watched, field: fieldOf(H, sign),
      bracket: bracketOf(F, H, sign), range: rangeOn(H, radius), bounds: [low - margin, high + margin] }; // prettier-ignore
  },
  readings: ({ bracket, F, H, start, flow }, { radius }) => [
    ["bracket", "{F, H}", worded(bracket)],
    ["rate", "at the start", valueOf(bracket, start), "", 6],
    ["F", "F at the start", valueOf(F, start), "", 6],
    ["H", "H, which is kept", valueOf(H, start), "", 6],
    ["drift", "|L| after 20 s less |L|", Math.abs(size(Array.from(flow.at(20))) - radius) < 1e-11 ? "below 1e−11" : "above 1e−11"],
  ],
  describe: (model, { H, F, sign, radius }) =>
    `The sphere |L| = ${radius} coloured by H = ${NAMES[H]}; L runs along a level curve under the ${sign < 0 ? "minus" : "plus"} bracket, and a graph shows F = ${NAMES[F]} with the slope {F, H}.`,
  frame({ width, height }) {
    const [box] = boxesOf(width, height);
    return { scale: Math.min(box.width, box.height) / 4.8, x: box.left + box.width / 2, y: box.top + box.height / 2 };
  },
  draw(paper, scene) {
    const [, box] = boxesOf(scene.width, scene.height);
    drawSphere(paper, scene);
    drawRate(paper, box, scene);
  },
});
