// Copies the tables of motions and cases and the licence beside the package before npm packs it; git keeps one of each.
import { copyFileSync } from "node:fs";

const from = (path) => new URL(path, import.meta.url);
for (const name of ["reference_motions.json", "fixed_step_cases.json"]) {
  copyFileSync(from(`../src/polhode/judging/${name}`), from(name));
}
copyFileSync(from("../LICENSE"), from("LICENSE"));
