// A thrown book: how long it waits before it turns over, against the logarithm of its tilt.
import { mixed } from "./lib/colours.js";
import { Scene, drawArrow, drawBall, drawCurve, write, writeAtTip } from "./lib/ink.js";
import { inset, split } from "./lib/layout.js";
import { boxFaces, turnedBy } from "./lib/meshes.js";
import { Panel } from "./lib/panel.js";
import { Plot } from "./lib/plot.js";
import { radians, times } from "./lib/vectors.js";
import { SIZE, flipTime, growthRate, motionOf, straightTime, timePerDecade } from "./physics/book.js";

const [LEAST, MOST] = [0.001, 60]; // degrees
const TURN = 2 * Math.PI;
const faces = boxFaces(SIZE);
const tilts = Array.from({ length: 121 }, (_, k) => LEAST * (MOST / LEAST) ** (k / 120));

/** Return a rectangle on the front or the back, in shares of the half height and half width. */
function onCover(side, [x0, x1], [y0, y1]) {
  const [a, b, c] = SIZE.map((x) => x / 2);
  return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(([x, y]) => [x * a, y * b, side * c * 1.001]); // prettier-ignore
}

function drawBook(scene, turn, theme) {
  const cover = { "2,1": theme.cover, "2,-1": mixed(theme.cover, "#000000", 0.22), "1,-1": mixed(theme.cover, "#000000", 0.1) };
  for (const { k, side, normal, points } of faces) {
    const colour = cover[`${k},${side}`] ?? theme.paper;
    scene.facet(points.map(turn), colour, { normal: turn(normal), oneSided: true, edge: mixed(colour, "#000000", 0.25) });
  }
  const [gold, white] = ["#e3b95a", theme.paper];
  const marks = [
    [1, [0.18, 0.66], [-0.6, 0.6], white], [1, [0.5, 0.58], [-0.42, 0.42], theme.cover], [1, [0.3, 0.36], [-0.3, 0.3], theme.cover],
    [1, [-0.8, -0.76], [-0.7, 0.7], gold], [1, [0.84, 0.88], [-0.7, 0.7], gold], [-1, [-0.75, -0.45], [0.2, 0.72], white],
  ]; // prettier-ignore
  for (const [side, x, y, colour] of marks) {
    scene.facet(onCover(side, x, y).map(turn), colour, { normal: turn([0, 0, side]), oneSided: true, nearer: 0.01 });
  }
}

function drawThrow(paper, { model, theme, view, time }) {
  const turn = turnedBy(model.motion.state(time).attitude);
  const scene = new Scene(paper, view);
  drawBook(scene, turn, theme);
  const reach = 0.135;
  const path = model.trail.map((p) => times(p, reach));
  drawCurve(paper, view, path, { colour: theme.axes[1], width: 1.2 });
    const tip = turn([0, reach, 0]);
  scene.line([turn([0, SIZE[1] / 2, 0]), tip], { colour: theme.axes[1], width: 3 });
  scene.paint();
  drawArrow(paper, view, [0, 0, 0.15], [0, 0, 0.215], { colour: theme.momentum, width: 4 }); // beyond the book, which it would pierce
  drawBall(paper, view.pixel(tip), 5, theme.axes[1], theme.ground);
  const [x, y] = view.pixel(tip);
  write(paper, "2", [x + 15, y], { colour: theme.axes[1], ground: theme.ground, weight: "700", size: 15 });
  writeAtTip(paper, view, [0, 0, 0], [0, 0, 0.215], "L", { colour: theme.momentum, ground: theme.ground }, 14);
}

function plotOf(paper, box, theme, settings) {
  const longest = flipTime(radians(LEAST), TURN * settings.rate);
  return new Plot(paper, { ...inset(box, 38, 26), x: [LEAST, MOST], y: [0, 1.06 * longest], logX: true, theme });
}

function drawPlot(paper, box, { model, settings, theme, time }) {
  const plot = plotOf(paper, box, theme, settings);
  plot.axes({ x: "angle of L from axis 2 at the throw, degrees", y: "time until it has turned over, s" });
  plot.curve(model.straight, { colour: theme.approximation, width: 1.6, dash: [5, 4] });
  plot.curve(model.curve, { colour: theme.motion, width: 3 });
  const x = plot.atX(settings.tilt);
  const [bottom, top] = [plot.top + plot.height, plot.atY(model.flip)];
  const waited = (time % model.flip) / model.flip;
  Object.assign(paper, { strokeStyle: theme.axes[1], lineWidth: 3, lineCap: "round" });
  paper.beginPath();
  paper.moveTo(x, bottom);
  paper.lineTo(x, bottom + waited * (top - bottom));
  paper.stroke();
  drawBall(paper, [x, top], 8, theme.motion, theme.ground);
  if (plot.width > 150) {
    write(paper, `10 times closer: +${model.decade.toFixed(2)} s`, [plot.left + plot.width, plot.top + 8],
      { colour: theme.approximation, ground: theme.ground, size: 12.5, align: "right" }); // prettier-ignore
  }
}

new Panel({
  name: "book",
  initial: { tilt: 1, rate: 1.5, speed: 0.2, turn: -0.5, lift: 0.34 },
  plays: true,
  controls: [
    { kind: "slider", key: "tilt", label: "L leans from axis 2 by", least: LEAST, most: MOST, log: true, say: (value) => `${Number(value.toPrecision(3))}°` },
    { kind: "slider", key: "rate", label: "spin", least: 0.5, most: 4, step: 0.1, say: (value) => `${value.toFixed(1)} turns/s` },
    { kind: "choice", key: "speed", label: "time runs", options: [[1, "as it is"], [0.2, "1/5"], [0.05, "1/20"]] },
  ],
  speed: ({ speed }) => speed,
  changed: (key, panel) => key !== "speed" && panel.seek(0),
  prepare({ tilt, rate }) {
    const spin = TURN * rate;
    const motion = motionOf(radians(tilt), spin);
    const trail = Array.from({ length: 801 }, (_, k) => turnedBy(motion.state((motion.period * k) / 800).attitude)([0, 1, 0]));
    return {
      motion, trail, flip: motion.flipInterval, growth: growthRate(spin), decade: timePerDecade(spin),
      curve: tilts.map((angle) => [angle, flipTime(radians(angle), spin)]),
      straight: tilts.map((angle) => [angle, straightTime(radians(angle), spin)]),
    }; // prettier-ignore
  },
  readings: ({ flip, growth, decade, motion }, { tilt, rate }) => [
    ["flip", "turned over after", flip, "s"],
    ["line", "the straight line says", straightTime(radians(tilt), TURN * rate), "s"],
    ["decade", "10 times closer adds", decade, "s"],
    ["growth", "a tilt grows by e in", 1 / growth, "s"],
    ["turns", "spins while it waits", flip * rate, "", 3],
    ["modulus", "modulus k", motion.modulus, "", 6],
  ],
  describe: ({ flip }, { tilt }) =>
    `A book spinning with its middle axis ${tilt} degrees from L turns over every ${flip.toFixed(2)} s; below, that time against the tilt.`,
  frame({ width, height }) {
    const [box] = split(width, height);
    return { scale: Math.min(box.width, box.height) / 0.42, x: box.left + box.width / 2, y: box.top + box.height * 0.6 };
  },
  grab([x, y], panel) {
    const [, box] = split(panel.canvas.clientWidth, panel.canvas.clientHeight);
    const plot = plotOf(panel.paper, box, panel.theme, panel.settings);
    if (!plot.holds([x, y])) return null;
    return { move: ([u]) => panel.set("tilt", Number(plot.valueX(u).toPrecision(3)), true) };
  },
  draw(paper, scene) {
    const [, box] = split(scene.width, scene.height);
    drawThrow(paper, scene);
    drawPlot(paper, box, scene);
  },
});
