// Answers what the page says of settings: standard input has a list of [module, function, arguments], standard output the answers.
import { readFileSync } from "node:fs";

const [folder] = process.argv.slice(2);
const asked = JSON.parse(readFileSync(0, "utf8"));
const answers = [];
for (const [module, name, given] of asked) {
  const found = await import(`${folder}/${module}`);
  if (name !== "facts") answers.push(found[name](...given));
  else {
    const setting = found.from(given[0]);
    answers.push(found.facts(setting, found.make(setting)));
  }
}
process.stdout.write(JSON.stringify(answers));
