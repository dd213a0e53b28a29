// Builds what src/polhode/viewer/assets holds, and the course's panels. `--check` builds again and compares, so that neither can
// go stale.
import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { PANELS, coursePanels } from "./course_panels.mjs";
import { words } from "./words.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const ASSETS = here("../src/polhode/viewer/assets/");

const licence = await readFile(here("node_modules/three/LICENSE"), "utf8");

async function bundle() {
  const found = await build({
    entryPoints: [here("src/main.js")],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2022",
    charset: "ascii", // the same bytes in whatever encoding a page is read
    legalComments: "none",
    plugins: [words],
    // every page holds a copy of three.js, and so its licence
    banner: { js: `/* three.js: ${licence.trim()}\n\nThe rest is part of polhode, under the MIT licence. */` },
  });
  return found.outputFiles[0].text;
}

const wanted = [
  [ASSETS, "page.js", await bundle()],
  [ASSETS, "LICENSE.three.txt", licence],
  ...Object.entries(await coursePanels()).map(([name, text]) => [PANELS, name, text]),
];

let stale = 0;
for (const [folder, name, text] of wanted) {
  if (process.argv.includes("--check")) {
    const found = await readFile(folder + name, "utf8").catch(() => "");
    if (found !== text) {
      console.error(`${name} is not what its sources give: run \`npm run build\` in viewer/ and commit it`);
      stale = 1;
    }
  } else {
    await writeFile(folder + name, text);
    console.log(`${name}: ${Buffer.byteLength(text)} bytes`);
  }
}
process.exit(stale);
