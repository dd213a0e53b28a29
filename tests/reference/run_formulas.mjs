// Calls printed formulas: JSON in on standard input, JSON out; what is not finite, and −0, is text. `argv[2]` is the address of
// their folder. Each call is [file, name of a function, arguments].
import { readFileSync } from "node:fs";

const WORDS = { NaN, Infinity, "-Infinity": -Infinity };
const calls = JSON.parse(readFileSync(0, "utf8"), (_, x) => (Object.hasOwn(WORDS, x) ? WORDS[x] : x));
const answers = [];
for (const [file, name, given] of calls) {
  const module = await import(new URL(file, process.argv[2]).href);
  answers.push(module[name](...given));
}
const plain = (x) => (Object.is(x, -0) ? "-0" : Number.isFinite(x) ? x : String(x));
console.log(JSON.stringify(answers, (_, x) => (typeof x === "number" ? plain(x) : x)));
