// The panels of the course: each a page of one file without any request, whose policy allows its own script and style alone.
import { createHash } from "node:crypto";
import { readFile, readdir } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const SOURCES = new URL("../learn/panels/src/", import.meta.url);
export const PANELS = fileURLToPath(new URL("../learn/panels/", import.meta.url));

const bundled = async (path, options) => {
  const settings = { bundle: true, minify: true, write: false, target: "es2022", charset: "utf8", legalComments: "none" };
  const found = await build({ entryPoints: [fileURLToPath(new URL(path, SOURCES))], ...settings, ...options });
  return found.outputFiles[0].text.trim();
};

const hashed = (text) => `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");

/** Return the pages by their names, such as "surfaces.html". */
export async function coursePanels() {
  const names = (await readdir(SOURCES)).filter((name) => name.endsWith(".js")).map((name) => name.slice(0, -3)).sort();
  const frame = await readFile(new URL("lib/panel.html", SOURCES), "utf8");
  const style = await bundled("lib/panel.css", { loader: { ".css": "css" } });
  const titles = JSON.parse(await readFile(new URL("titles.json", SOURCES), "utf8"));
  const pages = {};
  for (const name of names) {
    const script = await bundled(`${name}.js`, { format: "iife" });
    if (/<\/script|<!--/i.test(script)) throw new Error(`${name}.js holds text that would end its own script element`);
    const { title, sentence, flat = false } = titles[name];
    const policy = `default-src 'none'; script-src ${hashed(script)}; style-src ${hashed(style)}; base-uri 'none'; form-action 'none'`;
    const parts = { policy, title: escaped(title), sentence: escaped(sentence), style, script, kind: flat ? "flat" : "turns" };
    pages[`${name}.html`] = frame.replace(/\{(\w+)\}/g, (_, key) => parts[key]);
  }
  return pages;
}
