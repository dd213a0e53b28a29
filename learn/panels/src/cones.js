// A symmetric body: Ω, L, the axis, and the cone in the body that rolls on the cone in space.
import { mixed } from "./lib/colours.js";
import { Scene, drawCurve, write, writeAtTip } from "./lib/ink.js";
import { addFacets, ellipsoidFacets, turnedBy } from "./lib/meshes.js";
import { Panel } from "./lib/panel.js";
import { across, circle, degrees, radians, sum, times, unit } from "./lib/vectors.js";
import { conesOf, flatness, motionOf } from "./physics/cones.js";

const [LENGTH, BODY] = [1.18, 0.5]; // of a cone's side and of the body's largest half-axis
const UP = [0, 0, 1];

/** Add the mantle of a cone from the origin, marked so that its turning is seen. */
function addCone(scene, axis, angle, frame, colour, marks) {
  if (angle < 0.004) return;
  const [u, v] = frame;
  const count = 36;
  const out = (k) => {
    const turn = (2 * Math.PI * k) / count;
    const side = sum(times(u, Math.cos(turn)), times(v, Math.sin(turn)));
    return unit(sum(times(axis, Math.cos(angle)), times(side, Math.sin(angle))));
  };
  for (let k = 0; k < count; k++) {
    const [p, q] = [out(k), out(k + 1)];
    const shade = marks && k % 6 < 3 ? mixed(colour, "#ffffff", 0.3) : colour;
    for (const [from, to] of [[0.04, 0.55], [0.55, 1]]) {
      const corner = (direction, share) => times(direction, LENGTH * share);
      scene.facet([corner(p, from), corner(q, from), corner(q, to), corner(p, to)], shade, { opacity: 0.5 });
    }
  }
  scene.line(circle(times(axis, LENGTH * Math.cos(angle)), axis, LENGTH * Math.sin(angle), 64), { colour, width: 2 });
}

function draw(paper, { model, settings, theme, view, time, height }) {
  const { motion, cones, facets } = model;
  const { attitude } = motion.state(time);
  const turn = turnedBy(attitude);
  const axis = turn(UP);
  const velocity = unit(turn(motion.angularVelocity(time)));
  const scene = new Scene(paper, view);
  const [one, two] = [theme.body, mixed(theme.body, theme.ground, 0.35)];
  if (settings.body) addFacets(scene, facets, turn, ({ octant }) => (octant ? one : two));
  addCone(scene, UP, cones.spaceCone, across(UP), theme.family, false);
  addCone(scene, axis, cones.bodyCone, [turn([1, 0, 0]), turn([0, 1, 0])], theme.bodyCone, true);
  const tips = { L: [UP, 1.5, theme.momentum], Ω: [velocity, 1.42, theme.velocity], 3: [axis, 1.36, theme.axes[2]] };
  for (const [name, [direction, length, colour]] of Object.entries(tips)) {
    const tip = times(direction, length);
    if (name === "3") scene.line(Array.from({ length: 9 }, (_, k) => times(tip, k / 8)), { colour, width: 2.4 });
    else scene.arrow([0, 0, 0], tip, { colour, width: 4.5 });
  }
  const round = circle(times(UP, 1.36 * Math.cos(model.tilt)), UP, 1.36 * Math.sin(model.tilt));
  drawCurve(paper, view, round, { colour: theme.axes[2], width: 1, dash: [3, 4] });
  scene.paint();
  for (const [name, [direction, length, colour]] of Object.entries(tips)) {
    const options = { colour, ground: theme.ground, ...(name === "3" && { symbol: false, weight: "700", size: 15 }) };
    writeAtTip(paper, view, [0, 0, 0], times(direction, length), name, options, 15);
  }
  const shown = [["cone fixed in space", theme.family], ["cone fixed in the body", theme.bodyCone]];
  shown.forEach(([words, colour], k) => {
    const options = { colour: mixed(colour, theme.text, 0.25), size: 13, align: "left", weight: "600", ground: theme.ground };
    write(paper, words, [10, height - 30 + 19 * k], options);
  });
}

const shapeOf = (ratio) => {
  const height = flatness(ratio);
  const size = BODY / Math.max(1, height);
  return [size, size, Math.max(0.03, size * height)];
};
const kindOf = (ratio) => (ratio > 1 ? "oblate (disk)" : ratio < 1 ? "prolate (rod)" : "spherical");

new Panel({
  name: "cones",
  initial: { ratio: 1.6, tilt: 28, body: 1, turn: 0.5, lift: 0.25 },
  plays: true,
  controls: [
    { kind: "slider", key: "ratio", label: "I₃/I₁: rod to disk", least: 0.2, most: 2, step: 0.01, say: (value) => value.toFixed(2) },
    { kind: "slider", key: "tilt", label: "axis leans from L", least: 1, most: 80, step: 0.5, say: (value) => `${value}°` },
    { kind: "switch", key: "body", label: "show the body" },
  ],
  prepare({ ratio, tilt }) {
    const motion = motionOf(ratio, radians(tilt));
    return { motion, cones: conesOf(ratio, radians(tilt)), tilt: radians(tilt), facets: ellipsoidFacets(shapeOf(ratio), 20, 40) };
  },
  readings: ({ cones, motion }, { ratio }) => [
    ["shape", "body", kindOf(ratio)],
    ["precession", "axis round L in", (2 * Math.PI) / cones.precession, "s"],
    ["period", "Ω round axis in", ratio === 1 ? "Ω stays on L" : motion.period, "s"],
    ["sense", "in the body Ω goes", ratio > 1 ? "with the spin" : ratio < 1 ? "against the spin" : "nowhere"],
    ["bodyCone", "half-angle in body", degrees(cones.bodyCone), "°"],
    ["spaceCone", "half-angle in space", degrees(cones.spaceCone), "°"],
  ],
  describe: (model, { ratio, tilt }) =>
    `A body with I3/I1 = ${ratio} whose axis leans ${tilt} degrees from L: a cone round the axis rolls on a cone round L and touches it along Ω.`,
  frame: ({ width, height }) => ({ scale: Math.min(width / 2.7, height / 2.6), x: width / 2, y: height * 0.68 }),
  draw,
});
