// Allowed polhodes on the sphere of J, the quanta that each encloses, and quantum levels beside the orbits' energies.
import { mixed } from "./lib/colours.js";
import { drawBall, drawCurve, write } from "./lib/ink.js";
import { inset, split } from "./lib/layout.js";
import { Panel } from "./lib/panel.js";
import { Plot } from "./lib/plot.js";
import { Solid, drawSolids, ellipsoidForm } from "./lib/solids.js";
import { times } from "./lib/vectors.js";
import { A, C, motionAt, pairedLevels, radiusOf } from "./physics/quanta.js";

const AXES = { a: 0, b: 1, c: 2 };
const closed = (motion, G) => {
  const points = motion.along(140).map((L) => times(L, 1 / G));
  return [...points, points[0]];
};

/** Return the great circles through axis b where the polhodes cross. */
function crossing(B) {
  const lean = Math.atan(Math.sqrt((B - C) / (A - B)));
  return [1, -1].map((side) => Array.from({ length: 121 }, (_, k) => {
    const angle = (Math.PI * k) / 60;
    return [side * Math.sin(lean) * Math.cos(angle), Math.sin(angle), Math.cos(lean) * Math.cos(angle)];
  })); // prettier-ignore
}

const colourOf = (theme, axis) => (axis === null ? theme.border : theme.axes[AXES[axis]]);

/** A sphere and a ladder of levels, beside each other or on narrow screens below. */
function boxesOf(width, height) {
  if (height > 1.15 * width) return split(width, height, 0.52);
  const ladder = Math.max(128, Math.min(320, 0.42 * width));
  return [{ left: 0, top: 0, width: width - ladder, height }, { left: width - ladder, top: 0, width: ladder, height }];
}

function drawSphere(paper, { model, settings, theme, view }) {
  const sphere = new Solid({ view, form: ellipsoidForm([1, 1, 1]), colour: theme.momentumSphere, opacity: 0.9 });
  drawSolids(paper, view, [sphere], { key: [settings.turn, settings.lift, theme.name].join() });
  sphere.drawEdge(paper, mixed(theme.momentumSphere, theme.text, 0.35), 1.2);
  const solids = [sphere];
  for (const arc of model.crossing) drawCurve(paper, view, arc, { colour: theme.border, width: 1.3, solids, faint: 0.12, dash: [5, 4] });
  const chosen = model.levels[model.chosen];
  for (const { curve, axis, key } of model.orbits) {
    const bold = key === `${chosen.axis}${chosen.quanta}`;
    for (const points of [curve, curve.map((p) => times(p, -1))]) {
      if (bold) fillCap(paper, view, points, axis, theme);
      drawCurve(paper, view, points, { colour: colourOf(theme, axis), width: bold ? 4 : 1.7, solids, faint: bold ? 0.3 : 0, margin: 0.01 });
    }
  }
  ["a", "b", "c"].forEach((name, k) => {
    const tip = [0, 0, 0];
    tip[k] = 1.2;
    drawCurve(paper, view, [times(tip, 1 / 1.2), tip], { colour: theme.axes[k], width: 2.4, solids, faint: 0.2 });
    write(paper, name, view.pixel(times(tip, 1.09)), { colour: theme.axes[k], ground: theme.ground, symbol: true, size: 17 });
  });
}

/** Tint the cap that a polhode cuts off, if all of it is seen. */
function fillCap(paper, view, points, axis, theme) {
  if (points.some((p) => view.depth(p) < 0)) return;
  paper.globalAlpha = 0.28;
  paper.fillStyle = colourOf(theme, axis);
  paper.beginPath();
  points.forEach((p) => paper.lineTo(...view.pixel(p)));
  paper.fill();
  paper.globalAlpha = 1;
}

const plotOf = (paper, box, theme, model) => new Plot(paper, { ...inset(box, 46, 24, 8, 26), x: [0, 1], y: model.span, theme });

function drawLadder(paper, box, { model, theme }) {
  const plot = plotOf(paper, box, theme, model);
  plot.axes({ x: "", y: "", xTicks: [[0.27, "levels"], [0.78, "orbits"]] });
  write(paper, "energy, cm⁻¹", [plot.left - 40, box.top + 10], { colour: theme.quiet, size: 12, align: "left" });
  const { left, width } = plot;
  const bar = (from, to, energy, colour, thickness, dash = []) => {
    Object.assign(paper, { strokeStyle: colour, lineWidth: thickness, lineCap: "butt" });
    paper.setLineDash(dash);
    paper.beginPath();
    paper.moveTo(left + from * width, plot.atY(energy));
    paper.lineTo(left + to * width, plot.atY(energy));
    paper.stroke();
    paper.setLineDash([]);
  };
  bar(0, 1, model.saddle, theme.border, 1.3, [5, 4]);
  model.levels.forEach(({ energy, axis, orbit }, k) => {
    const chosen = k === model.chosen;
    const colour = colourOf(theme, axis);
    bar(0.05, 0.5, energy, colour, chosen ? 4.5 : 2);
    if (orbit === null) return;
    bar(0.56, 1, orbit, colour, chosen ? 4.5 : 2);
    if (chosen) drawBall(paper, [left + 0.02 * width, plot.atY(energy)], 5, colour, theme.ground);
  });
}

const LABELS = { a: "round axis a", c: "round axis c" };

new Panel({
  name: "quanta",
  initial: { J: 6, B: 14, level: 3, turn: 0.62, lift: 0.5 },
  controls: [
    { kind: "slider", key: "J", label: "J", least: 1, most: 20, step: 1, whole: true, say: String },
    { kind: "slider", key: "B", label: "B (A = 27, C = 9)", least: 9.5, most: 26.5, step: 0.1, say: (value) => `${value.toFixed(1)} cm⁻¹` },
    { kind: "slider", key: "level", label: "level, from the lowest", least: 1, most: 41, step: 1, whole: true, say: (value) => String(value) },
  ],
  changed(key, panel) {
    const most = 2 * Math.round(panel.settings.J) + 1;
    if (panel.settings.level > most) panel.set("level", most);
  },
  prepare({ J: number, B, level }) {
    const J = Math.round(number);
    const G = radiusOf(J);
    const levels = pairedLevels(B, J);
    const seen = new Map(levels.filter(({ orbit }) => orbit !== null).map((found) => [`${found.axis}${found.quanta}`, found]));
    const orbits = [...seen].map(([key, { orbit, axis }]) => ({ key, axis, curve: closed(motionAt(orbit, B, G), G) }));
    const all = levels.flatMap(({ energy, orbit }) => [energy, orbit ?? energy]);
    const margin = 0.05 * (Math.max(...all) - Math.min(...all)) + 1;
    const span = [Math.min(...all) - margin, Math.max(...all) + margin];
    return { J, G, levels, orbits, crossing: crossing(B), saddle: B * G * G, span, chosen: Math.min(2 * J, Math.round(level) - 1) };
  },
  readings({ J, levels, chosen }) {
    const { energy, orbit, axis, quanta } = levels[chosen];
    return [
      ["energy", "quantum level", energy, "cm⁻¹", 7],
      orbit === null ? ["orbit", "orbit", "none: it crosses"] : ["orbit", "orbit's energy", orbit, "cm⁻¹", 7],
      axis ? ["quanta", `quanta ${LABELS[axis]}`, quanta, "", 2] : ["quanta", "quanta", "no room"],
      ["states", "levels, 2J + 1", 2 * J + 1, "", 2],
      ["half", "quanta at |L| = ħ(J + ½)", 2 * (J + 0.5), "", 4],
      ["root", "at |L| = ħ√(J(J + 1))", 2 * Math.sqrt(J * (J + 1)), "", 4],
    ];
  },
  describe: ({ J }, { B }) =>
    `A sphere with the allowed polhodes for J = ${J} and B = ${B}, and a ladder of the quantum levels beside the energies of the orbits.`,
  frame({ width, height }) {
    const [box] = boxesOf(width, height);
    return { scale: Math.min(box.width, box.height - 16) / 2.6, x: box.left + box.width / 2, y: 8 + box.height * 0.52 };
  },
  grab(place, panel, look = false) {
    if (!panel.model) return null;
    const [, box] = boxesOf(panel.canvas.clientWidth, panel.canvas.clientHeight);
    const plot = plotOf(panel.paper, box, panel.theme, panel.model);
    if (!plot.holds(place)) return null;
    const choose = ([, y]) => {
      const far = panel.model.levels.map(({ energy }) => Math.abs(plot.atY(energy) - y));
      panel.set("level", far.indexOf(Math.min(...far)) + 1);
    };
    if (!look) choose(place);
    return { move: choose };
  },
  draw(paper, scene) {
    const [, box] = boxesOf(scene.width, scene.height);
    drawSphere(paper, scene);
    drawLadder(paper, box, scene);
    const { G } = scene.model;
    write(paper, `|L| = ħ(J + ½) = ${G} ħ`, [8, 12], { colour: scene.theme.quiet, ground: scene.theme.ground, size: 12, align: "left" });
  },
});
