// Answers cases of reference/stepped: JSON in on standard input, JSON out. `argv[2]` is the folder's address.
// Each case: {kind: class, given: what its constructor takes, times: [s], asked in this order}, {kind: "rollingStart", given},
// {kind: "tableau"} or {kind: "fixedSteps", given: of a gyrostat, until, counts of steps}.
import { readFileSync } from "node:fs";

const folder = process.argv[2];
const motions = await import(`${folder}/index.js`);
const method = await import(`${folder}/dormand_prince.js`);

/** Return the momenta after equal steps, from the rates of a gyrostat. */
function fixedSteps({ given, until, counts }) {
  const { _motion } = new motions.Gyrostat(given);
  const start = [...given.attitude, ...given.momentum];
  return counts.map((count) => {
    const steps = new method.DormandPrince(_motion._rates, start.length);
    let [state, next] = [Float64Array.from(start), new Float64Array(start.length)];
    for (let k = 0; k < count; k++) {
      steps.step(0, state, until / count, next);
      [state, next] = [next, state];
    }
    return Array.from(state);
  });
}

/** Return the states of a case's motion; with `tries` ask again after a refusal, which goes on from where it got. */
function states({ kind, given, times, tries = 0 }) {
  const motion = new motions[kind](given);
  const refusals = [];
  const found = times.map((t) => {
    for (;;) {
      try {
        return motion.state(t);
      } catch (error) {
        if (refusals.length >= tries) throw error;
        refusals.push(error.message);
      }
    }
  });
  const { _forward, _backward } = motion._motion;
  return { states: found, kept: [_forward.kept.length, _backward.kept.length], steps: _forward.from.count, refusals };
}

const WORDS = { nan: NaN, inf: Infinity };
const cases = JSON.parse(readFileSync(0, "utf8"), (_, x) => (Object.hasOwn(WORDS, x) ? WORDS[x] : x));
const answers = cases.map((asked) => {
  try {
    if (asked.kind === "tableau") return { STAGES: method.STAGES, WEIGHTS: method.WEIGHTS, TIMES: method.TIMES };
    if (asked.kind === "fixedSteps") return fixedSteps(asked);
    if (asked.kind === "rollingStart") return motions.EulerDisk.rollingStart(asked.given);
    return states(asked);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return { refused: error.message };
  }
});
console.log(JSON.stringify(answers));
