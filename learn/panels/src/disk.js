// Euler's disk: how it rolls at any moment of its life, its tilt and its contact's rate against time, and its sound.
import { mixed } from "./lib/colours.js";
import { Scene, drawBall, drawCurve, turnedFacets, write } from "./lib/ink.js";
import { inset, split } from "./lib/layout.js";
import { turnedBy } from "./lib/meshes.js";
import { Panel } from "./lib/panel.js";
import { Plot, decades, ticks } from "./lib/plot.js";
import { Clicks } from "./lib/sound.js";
import { circle, degrees, radians, sum, times } from "./lib/vectors.js";
import { HALF_THICKNESS, LOSSES, RADIUS, exponentAt, historyOf, lateRow, powerOfRate, stateAt } from "./physics/disk.js";

const a = RADIUS;
const THINNEST = 0.0009; // m: half of what is drawn of a thin disk
const [SHORTEST, FASTEST] = [1e-3, 100]; // s left and Hz that the graphs show
const PAUSE = 2; // s that it lies flat before it starts again
const turnsOf = (rate) => rate / (2 * Math.PI);
const clicks = new Clicks();
const edgeOf = (b) => [[0, b], [0.93 * a, b], [a, 0.8 * b], [a, -0.8 * b], [0.93 * a, -b], [0, -b]]; // prettier-ignore

/** Return the attitude Rz(φ) Rx(θ) Rz(ψ) as a quaternion, with ψ = face − φ. */
function attitudeOf({ tilt, heading, face }) {
  const [s, c] = [Math.sin(tilt / 2), Math.cos(tilt / 2)];
  const [half, other] = [face / 2, heading - face / 2];
  return [c * Math.cos(half), s * Math.cos(other), s * Math.sin(other), c * Math.sin(half)];
}

function drawTable(paper, view, theme, centre, turn) {
  const fill = (points, colour, opacity = 1) => {
    paper.globalAlpha = opacity;
    paper.fillStyle = colour;
    paper.beginPath();
    points.forEach((p) => paper.lineTo(...view.pixel(p)));
    paper.fill();
    paper.globalAlpha = 1;
  };
  fill(circle([0, 0, 0], [0, 0, 1], 1.62 * a), theme.plane);
  drawCurve(paper, view, circle([0, 0, 0], [0, 0, 1], 1.62 * a), { colour: theme.ring, width: 1.3 });
  fill(circle([0, 0, 0], [0, 0, 1], 1.5 * a), mixed(theme.plane, theme.ground, 0.35));
  const rim = circle([0, 0, 0], [0, 0, 1], a, 64).map((p) => sum(centre, turn(p)));
  for (const spread of [1.1, 1.05, 1]) fill(rim.map(([x, y, z]) => [spread * x - 0.25 * z, spread * y + 0.2 * z, 0]), "#000000", 0.09);
}

function drawDisk(paper, { model, settings, theme, view, time }) {
  const now = stateAt(model.history, time);
  const turn = turnedBy(attitudeOf(now));
  const b = settings.thick ? HALF_THICKNESS : THINNEST;
  const centre = [0, 0, a * Math.sin(now.tilt) + b * Math.cos(now.tilt)];
  drawTable(paper, view, theme, centre, turn);
  const contact = (heading, tilt) => [a * Math.cos(tilt) * Math.sin(heading), -a * Math.cos(tilt) * Math.cos(heading), 0];
  const trail = Array.from({ length: 49 }, (_, k) => contact(now.heading - (1.6 * Math.PI * (48 - k)) / 48, now.tilt));
  drawCurve(paper, view, trail, { colour: theme.velocity, width: 2.5 });
  const scene = new Scene(paper, view);
  const frame = [turn([1, 0, 0]), turn([0, 1, 0])];
  const axis = turn([0, 0, 1]);
  for (const { points, normal, j, k } of turnedFacets(centre, axis, edgeOf(b), 48, 0, frame)) {
    const mark = j === 3 && k % 12 === 0;
    scene.facet(points, mark ? theme.border : j === 1 ? mixed(theme.metal, "#ffffff", 0.2) : theme.metal, { normal, oneSided: true, shine: 0.6 });
  }
  const place = (radius, angle) => sum(centre, turn([radius * a * Math.cos(angle), radius * a * Math.sin(angle), b * 1.002]));
  const stripe = (from, to, angle, spread) => {
    const [left, right] = [angle - spread, angle + spread];
    return [place(from, left), place(to, left), place(to, right), place(from, right)];
  };
  for (let n = 0; n < 3; n++) {
    const angle = (2 * Math.PI * n) / 3;
    scene.facet(stripe(0.25, 0.82, angle, 0.11), n ? theme.motion : theme.border, { normal: axis, oneSided: true, nearer: 0.02 });
  }
  const spot = contact(now.heading, now.tilt);
  const near = view.depth(spot) > 0;
  if (!near) drawBall(paper, view.pixel(spot), 6, theme.velocity, theme.ground);
  scene.paint();
  if (near) drawBall(paper, view.pixel(spot), 6, theme.velocity, theme.ground);
  const moving = `tilt ${degrees(now.tilt).toPrecision(3)}°   contact ${turnsOf(now.rate).toFixed(1)} rounds/s`;
  const words = time >= model.history.end ? "it lies flat" : moving;
  write(paper, words, [view.x, 12], { colour: theme.text, ground: theme.ground, weight: "600" });
}

/** Return the graphs of tilt and rate in one box: both against the time, or both scales logarithmic against the time left. */
function plotsOf(paper, box, { model, settings, theme }) {
  const { history } = model;
  const log = settings.log;
  const place = { ...inset(box, 42, 26, 44), theme, logX: log, logY: log, x: log ? [history.end, SHORTEST] : [0, history.end] };
  const most = degrees(history.tilt[0]);
  const low = log ? model.at(history.end - SHORTEST) : null;
  return [
    new Plot(paper, { ...place, y: log ? [degrees(low.tilt), most] : [0, 1.05 * most] }),
    new Plot(paper, { ...place, y: log ? [turnsOf(history.rate[0]), turnsOf(low.rate)] : [0, FASTEST] }),
  ];
}

function drawHistory(paper, box, scene) {
  const { model, settings, theme, time } = scene;
  const { history } = model;
  const log = settings.log;
  const [tilts, rates] = plotsOf(paper, box, scene);
  const logTicks = ([low, high]) => decades([Math.min(low, high), Math.max(low, high)]);
  tilts.axes({ x: log ? "time left, s" : "time, s", y: "", ...(log && { xTicks: logTicks(tilts.xs) }) });
  const [left, right] = [tilts.left, tilts.left + tilts.width];
  for (const [value, words] of log ? logTicks(rates.ys) : ticks(...rates.ys, Math.max(3, tilts.height / 45)).map((x) => [x, String(x)])) {
    write(paper, words, [right + 6, rates.atY(value)], { colour: theme.velocity, size: 11.5, align: "left" });
  }
  write(paper, "tilt, degrees", [left - 30, box.top + 11], { colour: theme.motion, size: 12, align: "left", weight: "600" });
  write(paper, "contact, rounds/s", [right + 40, box.top + 11], { colour: theme.velocity, size: 12, align: "right", weight: "600" });
  const x = log ? history.left : history.time;
  tilts.curve(history.tilt.map((tilt, k) => [x[k], degrees(tilt)]), { colour: theme.motion, width: 3 });
  rates.curve(history.rate.map((rate, k) => [x[k], turnsOf(rate)]), { colour: theme.velocity, width: 3 });
  const now = stateAt(history, Math.min(time, history.end));
  const at = Math.min(right, Math.max(left, tilts.atX(log ? Math.max(SHORTEST, history.end - time) : Math.min(time, history.end))));
  Object.assign(paper, { strokeStyle: theme.quiet, lineWidth: 1 });
  paper.beginPath();
  paper.moveTo(at, tilts.top);
  paper.lineTo(at, tilts.top + tilts.height);
  paper.stroke();
  const inside = (y) => Math.min(tilts.top + tilts.height, Math.max(tilts.top, y));
  const lowest = degrees(now.tilt) > 0 ? tilts.atY(degrees(now.tilt)) : Infinity;
  drawBall(paper, [at, inside(lowest)], 6, theme.motion, theme.ground);
  drawBall(paper, [at, inside(rates.atY(turnsOf(now.rate)))], 6, theme.velocity, theme.ground);
}

const NAMES = { real: "air and rolling", air: "air alone", rolling: "rolling alone", friction: "contour friction" };
const boxesOf = (width, height) => split(width, height, 0.5);
const showLeft = (panel) => panel.shown.left.show(Math.max(SHORTEST, panel.model.history.end - panel.time));

new Panel({
  name: "disk",
  initial: { losses: "real", tilt: 12, thick: 0, log: 0, speed: 4, sound: 0, turn: -0.6, lift: 0.42 },
  plays: true,
  controls: [
    { kind: "choice", key: "losses", label: "loses to", list: true, options: Object.entries(NAMES) },
    { kind: "slider", key: "tilt", label: "tilt at the start", least: 3, most: 30, step: 0.5, say: (value) => `${value}°` },
    { kind: "slider", key: "left", label: "time left", least: SHORTEST, most: 6000, log: true, say: (value) => `${Number(value.toPrecision(3))} s` },
    { kind: "choice", key: "speed", label: "time runs", options: [[1, "as it is"], [4, "4 times"], [0.1, "1/10"]] },
    { kind: "switch", key: "log", label: "graph: logarithms" },
    { kind: "switch", key: "thick", label: "12.7 mm thick, as it is sold" },
    { kind: "switch", key: "sound", label: "sound: one click a round" },
  ],
  speed: ({ speed }) => speed,
  changed(key, panel) {
    if (key === "left") panel.seek(panel.model.history.end - panel.settings.left);
    if (["tilt", "losses", "thick"].includes(key)) panel.seek(0);
    if (key === "sound") clicks.switchTo(panel.settings.sound === 1);
    delete panel.settings.left; // it follows from the time, which is not part of the address
  },
  tick(panel) {
    const { end } = panel.model.history;
    if (panel.time > end + PAUSE * panel.settings.speed) panel.time = 0;
    showLeft(panel);
  },
  prepare({ losses, tilt, thick }) {
    const history = historyOf(LOSSES[losses], radians(tilt), thick ? HALF_THICKNESS : 0);
    return { history, exponent: exponentAt(history, lateRow(history)), at: (t) => stateAt(history, t) };
  },
  readings: ({ history, exponent, at }) => [
    ["end", "lies flat after", history.end, "s"],
    ["last", "contact 1 s before", turnsOf(at(history.end - 1).rate), "Hz", 4],
    ["exponent", "late tilt ∝ leftⁿ, n", exponent, "", 4],
    ["power", "contact ∝ tiltᵖ, p", powerOfRate(history), "", 4],
  ],
  describe: ({ history }, { tilt }) =>
    `A disk rolls from a tilt of ${tilt} degrees until it lies flat after ${history.end.toFixed(1)} s; a graph shows its tilt falling and the rate of its contact rising.`,
  frame({ width, height }) {
    const [box] = boxesOf(width, height);
    return { scale: Math.min(box.width / (3.5 * a), box.height / (2.2 * a)), x: box.left + box.width / 2, y: box.top + box.height * 0.6 };
  },
  grab([x, y], panel) {
    const [, box] = boxesOf(panel.canvas.clientWidth, panel.canvas.clientHeight);
    if (!panel.model) return null;
    const [plot] = plotsOf(panel.paper, box, panel);
    if (!plot.holds([x, y])) return null;
    const move = ([u]) => {
      const value = plot.valueX(u);
      panel.seek(panel.settings.log ? panel.model.history.end - value : value);
    };
    return { move };
  },
  draw(paper, scene) {
    const { panel, model, time } = scene;
    showLeft(panel);
    const audible = panel.running && time < model.history.end;
    if (audible) clicks.follow(turnsOf(stateAt(model.history, time).rate));
    else clicks.silence();
    drawDisk(paper, scene);
    drawHistory(paper, boxesOf(scene.width, scene.height)[1], scene);
  },
});
