// Sphere ∩ ellipsoid: what the two conserved quantities leave to L.
import { drawArrow, drawBall, drawCurve, write, writeAtTip } from "./lib/ink.js";
import { Panel } from "./lib/panel.js";
import { Solid, drawSolids, ellipsoidForm } from "./lib/solids.js";
import { mixed } from "./lib/colours.js";
import { times } from "./lib/vectors.js";
import { CROSSING, LEAST, MOMENTS, MOST, NORM, momentumOf, motionAt, polhode } from "./physics/surfaces.js";
import { FreeMotion } from "../../../reference/polhode.js";

const FAMILY = [1.4, 1.55, 1.72, 1.88, 2.15, 2.45, 2.85, 3.4]; // 2E of the faint ones
const others = FAMILY.map((energy) => polhode(new FreeMotion({ moments: MOMENTS, momentum: momentumOf(energy) }), 120));
const WORDS = {
  "short-axis": "goes round axis 3",
  "long-axis": "goes round axis 1",
  separatrix: "separatrix",
  permanent: "steady spin",
};
/** What stands for the period and the cap where L runs round no curve. */
const ABSENT = {
  permanent: ["L stays on the axis", "—"],
  separatrix: ["never comes back", "—"],
};
const reach = (energy) => 1.22 * Math.max(2.1, Math.sqrt(energy * MOMENTS[2]));
const mirrored = (points) => points.map((p) => times(p, -1));

/** Return the four arcs of the separatrix, the great circles through axis 2. */
function separatrix() {
  const slope = Math.sqrt((1 / MOMENTS[0] - 1 / MOMENTS[1]) / (1 / MOMENTS[1] - 1 / MOMENTS[2]));
  return [1, -1].map((side) => Array.from({ length: 145 }, (_, k) => {
    const angle = (2 * Math.PI * k) / 144;
    const across = NORM * Math.cos(angle);
    return [across / Math.hypot(1, slope), NORM * Math.sin(angle), (side * slope * across) / Math.hypot(1, slope)];
  })); // prettier-ignore
}
const crossing = separatrix();

function drawAxes(paper, view, solids, theme, energy) {
  MOMENTS.forEach((moment, k) => {
    const out = Math.max(NORM, Math.sqrt(energy * moment)) * 1.07 + 0.12;
    const tip = [0, 0, 0];
    tip[k] = out;
    const line = Array.from({ length: 41 }, (_, n) => times(tip, n / 20 - 1));
    drawCurve(paper, view, line, { colour: theme.axes[k], width: 1.6, solids, faint: 0.12 });
    write(paper, String(k + 1), view.pixel(times(tip, 1.07)), { colour: theme.axes[k], ground: theme.ground, weight: "700", size: 15 });
  });
}

function draw(paper, { model, settings, theme, view, time }) {
  const { energy, show, family, turn, lift } = settings;
  const sphere = new Solid({ view, form: ellipsoidForm([NORM, NORM, NORM]), colour: theme.momentumSphere, opacity: 0.93 });
  const ellipsoid = new Solid({
    view, form: ellipsoidForm(MOMENTS.map((moment) => Math.sqrt(energy * moment))), colour: theme.energyEllipsoid, opacity: 0.93,
  }); // prettier-ignore
  const solids = { both: [sphere, ellipsoid], sphere: [sphere], ellipsoid: [ellipsoid] }[show];
  drawSolids(paper, view, solids, { key: [energy, show, turn, lift, theme.name].join() });
  for (const solid of solids) {
    solid.drawEdge(paper, mixed(solid === sphere ? theme.momentumSphere : theme.energyEllipsoid, theme.text, 0.3), 1.2);
  }
  drawAxes(paper, view, solids, theme, energy);
  if (family) {
    for (const curve of others) {
      for (const points of [curve, mirrored(curve)]) drawCurve(paper, view, points, { colour: theme.family, width: 1.1, solids, faint: 0.1 });
    }
    for (const arc of crossing) drawCurve(paper, view, arc, { colour: theme.border, width: 1.6, solids, faint: 0.12 });
  }
  const path = energy === CROSSING ? crossing : [model.curve, mirrored(model.curve)];
  for (const points of path) drawCurve(paper, view, points, { colour: theme.motion, width: 3.4, solids, faint: 0.22, margin: 0.012 });
  const L = model.motion.state(time).momentum;
  drawArrow(paper, view, [0, 0, 0], L, { colour: theme.momentum, width: 4, solids: solids.map(thinner), faint: 0.3 });
  drawBall(paper, view.pixel(L), view.depth(L) >= 0 ? 6 : 4, theme.momentum, theme.ground);
  writeAtTip(paper, view, [0, 0, 0], L, "L", { colour: theme.momentum, ground: theme.ground });
}

/** L ends on the surfaces: what hides it must lie clearly before it. */
const thinner = (solid) => ({ front: (x, y) => solid.front(x, y) - 0.02 });

new Panel({
  name: "surfaces",
  initial: { energy: 1.9, show: "both", family: 0, turn: 0.72, lift: 0.36 },
  plays: true,
  controls: [
    { kind: "slider", key: "energy", label: "energy 2E", least: LEAST, most: MOST, step: 0.001, say: (value) => `${value.toFixed(3)} J` },
    { kind: "choice", key: "show", label: "surfaces", options: [["both", "both"], ["sphere", "|L|"], ["ellipsoid", "energy"]] },
    { kind: "switch", key: "family", label: "other energies on the sphere" },
    { kind: "button", key: "cross", label: "let the curves cross: 2E = |L|²/I₂", press: (panel) => panel.set("energy", CROSSING) },
  ],
  prepare(settings) {
    const energy = Math.abs(settings.energy - CROSSING) < 5e-4 ? CROSSING : settings.energy; // the slider's nearest place
    const found = motionAt(energy);
    return { ...found, curve: polhode(found.motion, 240) };
  },
  readings: ({ motion, regime, period, cap }) => [
    ["regime", "L", WORDS[regime] ?? regime],
    ["norm", "|L|", motion.momentumNorm, "kg m²/s"],
    ["period", "back after", ABSENT[regime]?.[0] ?? period, "s"],
    ["cap", "cap cut off", ABSENT[regime]?.[1] ?? cap, "sr"],
    ["moments", "I₁, I₂, I₃", "1, 2, 3 kg m²"],
  ],
  describe: ({ regime }, { energy }) =>
    `A sphere and an ellipsoid that meet in a curve, along which L runs; 2E is ${energy} J: ${WORDS[regime] ?? regime}.`,
  frame: ({ width, height, settings }) => ({ scale: Math.min(width, height) / 2 / reach(settings.energy), x: width / 2, y: height / 2 }),
  draw,
});
