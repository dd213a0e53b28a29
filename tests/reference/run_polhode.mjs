// Answers cases of reference/polhode.js: JSON in on standard input, JSON out. `argv[2]` is the module's address.
// Each case: {kind: "free" or "top", given: what the constructor takes, times: [s], numbers: names of attributes, along: count
// of points}, or {kind: "quaternion", name of a function, its arguments}.
import { readFileSync } from "node:fs";

const polhode = await import(process.argv[2]);
const KINDS = { free: polhode.FreeMotion, top: polhode.LagrangeMotion };
const plain = (x) => (x === Infinity ? "inf" : x);

const WORDS = { nan: NaN, inf: Infinity };
const cases = JSON.parse(readFileSync(0, "utf8"), (_, x) => (Object.hasOwn(WORDS, x) ? WORDS[x] : x));
const answers = cases.map(({ kind, given, times, numbers, along, name, args }) => {
  if (kind === "quaternion") return polhode.quaternion[name](...args);
  try {
    const motion = new KINDS[kind](given);
    return {
      states: times.map((t) => {
        const { attitude, momentum } = motion.state(t);
        return [...attitude, ...momentum];
      }),
      numbers: (numbers ?? []).map((attribute) => [motion[attribute]].flat().map(plain)),
      along: along ? motion.along(along) : [],
    };
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return { refused: error.message };
  }
});
console.log(JSON.stringify(answers));
