// A gyroscope on its stand, with its weight, the torque of the weight, and what the torque adds to L.
import { mixed } from "./lib/colours.js";
import { Scene, drawArrow, drawCurve, turnedFacets, writeAtTip } from "./lib/ink.js";
import { turnedBy } from "./lib/meshes.js";
import { Panel } from "./lib/panel.js";
import { circle, degrees, radians, sum, times } from "./lib/vectors.js";
import { MGL, AXIAL, WHEEL, motionOf, steadyRate, vectorsAt } from "./physics/gyroscope.js";

const { radius, arm } = WHEEL;
const LENGTH = 2 * arm; // of the axle
const STAND = 0.052;
const RIM = Array.from({ length: 9 }, (_, k) => {
  const angle = (-2 * Math.PI * k) / 8;
  return [radius * (0.93 + 0.1 * Math.cos(angle)), arm + 0.0042 * Math.sin(angle)];
});
const AXLE = [[0, LENGTH], [0.0011, LENGTH], [0.0011, 0.001]]; // prettier-ignore
const POINT = [[0.0011, 0.0035], [0, 0]]; // prettier-ignore
const HUB = [[0, arm + 0.006], [0.005, arm + 0.006], [0.005, arm - 0.006], [0, arm - 0.006]]; // prettier-ignore
const FOOT = [[0.0016, -0.002], [0.0024, -STAND + 0.006], [0.017, -STAND + 0.003], [0.018, -STAND], [0, -STAND]]; // prettier-ignore
const CUP = [[0, -0.001], [0.003, 0], [0.003, -0.003], [0.0014, -0.006]]; // prettier-ignore
const TRAIL = 260;

function addGyroscope(scene, attitude, theme) {
  const turn = turnedBy(attitude);
  const [axis, frame] = [turn([0, 0, 1]), [turn([1, 0, 0]), turn([0, 1, 0])]];
  const { brass, metal: steel } = theme;
  const place = { frame, origin: [0, 0, 0] };
  const add = (profile, count, colourOf, shine = 0.3) => {
    for (const { points, normal, k } of turnedFacets(place.origin, axis, profile, count, 0, frame)) {
      scene.facet(points, colourOf(k), { normal, shine, oneSided: true });
    }
  };
  add(RIM, 42, (k) => (k % 14 < 2 ? mixed(brass, "#000000", 0.35) : brass), 0.5);
  add(AXLE, 8, () => steel);
  add(POINT, 8, () => steel);
  add(HUB, 14, () => mixed(brass, "#000000", 0.12));
  for (let k = 0; k < 6; k++) {
    const angle = (Math.PI * k) / 3;
    const out = [Math.cos(angle), Math.sin(angle)];
    const at = (share) => turn([out[0] * share * radius, out[1] * share * radius, arm]);
    scene.line([at(0.16), at(0.5), at(0.85)], { colour: mixed(brass, "#000000", 0.2), width: 3.2 });
  }
}

function addStand(scene, theme) {
  for (const profile of [FOOT, CUP]) {
    for (const { points, normal } of turnedFacets([0, 0, 0], [0, 0, 1], profile, 24)) {
      scene.facet(points, theme.wood, { normal, oneSided: false, shine: 0.15 });
    }
  }
}

function draw(paper, { model, settings, theme, view, time }) {
  const { motion } = model;
  const now = vectorsAt(motion, time);
  const floor = [0, 0, -STAND];
  drawCurve(paper, view, circle(floor, [0, 0, 1], 0.062, 72), { colour: theme.line, width: 1.2 });
  const scene = new Scene(paper, view);
  addStand(scene, theme);
  addGyroscope(scene, now.attitude, theme);
  const ahead = model.path;
  drawCurve(paper, view, ahead, { colour: theme.motion, width: 2.2 });
  const wheel = times(now.axis, arm);
  scene.paint();
  if (!settings.arrows) return;
  // lengths: L is drawn as long as the axle and a half, weight and torque to scales of their own
  const tip = times(now.momentum, (1.22 * LENGTH) / model.norm);
  const torque = times(now.torque, 0.05 / MGL);
  drawArrow(paper, view, wheel, sum(wheel, times(now.weight, 0.026)), { colour: theme.weight, width: 4.5 });
  drawArrow(paper, view, [0, 0, 0], torque, { colour: theme.torque, width: 4.5 });
  drawArrow(paper, view, wheel, tip, { colour: theme.momentum, width: 4.5 });
  const added = times(now.torque, (1.22 * LENGTH * model.share) / model.norm);
  drawArrow(paper, view, tip, sum(tip, added), { colour: theme.change, width: 4.5 });
  const ground = theme.ground;
  writeAtTip(paper, view, wheel, sum(wheel, times(now.weight, 0.026)), "mg", { colour: theme.weight, ground, size: 16 });
  writeAtTip(paper, view, [0, 0, 0], torque, "τ", { colour: theme.torque, ground });
  writeAtTip(paper, view, [0, 0, 0], tip, "L", { colour: theme.momentum, ground });
  writeAtTip(paper, view, tip, sum(tip, added), "dL = τ dt", { colour: theme.change, ground, size: 15 }, 34);
}

const WORDS = {
  steady: "steady precession", cusp: "nods with cusps", loop: "nods in loops", undulating: "nods in waves", planar: "swings like a pendulum",
}; // prettier-ignore
const turnsPerSecond = (spin) => (spin * 2 * Math.PI) / 60;

new Panel({
  name: "gyroscope",
  initial: { spin: 1500, lean: 75, push: 0, arrows: 1, speed: 0.1, turn: -0.5, lift: 0.3 },
  plays: true,
  controls: [
    { kind: "slider", key: "spin", label: "spin", least: 400, most: 4000, step: 10, say: (value) => `${value} rpm` },
    { kind: "slider", key: "lean", label: "leans by", least: 10, most: 120, step: 1, say: (value) => `${value}°` },
    { kind: "slider", key: "push", label: "push: 0 let go, 1 steady", least: -1.5, most: 2.5, step: 0.05, say: (value) => value.toFixed(2).replace("-", "−") },
    { kind: "choice", key: "speed", label: "time runs", options: [[1, "as it is"], [0.1, "1/10"], [0.02, "1/50"]] },
    { kind: "switch", key: "arrows", label: "arrows" },
  ],
  speed: ({ speed }) => speed,
  changed: (key, panel) => !["speed", "arrows"].includes(key) && panel.seek(0),
  prepare({ spin, lean, push }) {
    const rate = turnsPerSecond(spin);
    const motion = motionOf(radians(lean), rate, push);
    const span = Math.min(2.5, Number.isFinite(motion.nutationPeriod) ? 9 * motion.nutationPeriod : 1.2);
    const path = Array.from({ length: TRAIL + 1 }, (_, k) => times(vectorsAt(motion, (span * k) / TRAIL).axis, LENGTH));
    const norm = Math.hypot(...motion.momentumAtEpoch);
    return { motion, path, norm, share: (0.42 * norm) / MGL, estimate: MGL / (AXIAL * rate), steady: steadyRate(radians(lean), rate) };
  },
  readings: ({ motion, estimate }) => [
    ["regime", "the axle", WORDS[motion.regime] ?? motion.regime],
    ["precession", "goes round in", motion.precessionRate ? Math.abs((2 * Math.PI) / motion.precessionRate) : null, "s", 4],
    ["estimate", "mgl/L₃ says", (2 * Math.PI) / estimate, "s", 4],
    ["nutation", "nods once in", motion.nutationPeriod, "s", 4],
    ["highest", "leans at least", degrees(Math.acos(Math.min(1, motion.nutationLimits[1]))), "°", 4],
    ["lowest", "leans at most", degrees(Math.acos(Math.max(-1, motion.nutationLimits[0]))), "°", 4],
  ],
  describe: ({ motion }, { spin, lean }) =>
    `A gyroscope on a stand at ${spin} rpm, leaning ${lean} degrees: ${WORDS[motion.regime] ?? motion.regime}. Arrows show weight, torque, L and its change.`,
  frame: ({ width, height }) => ({ scale: Math.min(width / 0.19, height / 0.18), x: width / 2, y: height * 0.6 }),
  draw,
});
