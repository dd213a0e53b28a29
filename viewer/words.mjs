// The words of the page in other languages: one file each in words/, by English text. The bundle holds each English text once.
import { readFile, readdir } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("words/", import.meta.url));

/** Return {languages, table}: the languages in order, and the translations of each English text, empty ones for none. */
async function gathered() {
  const languages = (await readdir(FOLDER)).filter((name) => name.endsWith(".json")).map((name) => name.slice(0, -5)).sort();
  const files = await Promise.all(languages.map(async (name) => JSON.parse(await readFile(`${FOLDER}${name}.json`, "utf8"))));
  const texts = [...new Set(files.flatMap(Object.keys))];
  const table = Object.fromEntries(texts.map((text) => [text, files.map((file) => file[text] ?? 0)]));
  return { languages, table };
}

/** Lets `import words from "words"` bring them. */
export const words = {
  name: "words",
  setup(build) {
    build.onResolve({ filter: /^words$/ }, ({ path }) => ({ path, namespace: "words" }));
    build.onLoad({ filter: /.*/, namespace: "words" }, async () => ({ contents: JSON.stringify(await gathered()), loader: "json" }));
  },
};
