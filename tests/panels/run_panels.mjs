// Answers calls of the panels' functions: [{module, call, args, keys, times, then}] on stdin, a list of answers on stdout.
import { readFileSync } from "node:fs";

const folder = process.argv[2];
const modules = {};
const plain = (key, value) => (typeof value === "number" && !Number.isFinite(value) ? String(value) : value);

async function answer({ module, call, args, keys, times, then, polynomials = [] }) {
  const found = (modules[module] ??= await import(`${folder}/physics/${module}.js`));
  const given = args.map((value, k) => (polynomials.includes(k) ? found.FUNCTIONS[value] : value));
  let result = found[call](...given);
  if (then) {
    const first = result;
    result = times.map((t) => found[then](...(then === "rateAlong" ? [given[0], first, t] : [first, t])));
  } else if (times) {
    const motion = result.motion ?? result;
    result = times.map((t) => (motion.at ? Array.from(motion.at(t)) : motion.state(t)));
  }
  return keys ? Object.fromEntries(keys.map((key) => [key, result[key] ?? null])) : result;
}

const calls = JSON.parse(readFileSync(0, "utf8"));
const answers = [];
for (const call of calls) answers.push((await answer(call)) ?? null);
process.stdout.write(JSON.stringify(answers, plain));
