// Energy, |L| and |Ω| as they are now, and by how much what should be constant drifts over the whole motion.
import { worded } from "./numbers.js";
import { say } from "./say.js";

const NAMES = { momentum_norm: "|L|", momentum_space: "L in space", "|L|²": "|L|²" };

export class Readouts {
  constructor(list, motion, data) {
    this.list = list;
    this.take(motion, data);
  }

  /** Show the values of a motion; the drift is of the one that Python wrote, and not of one set on the page. */
  take(motion, data, changed = false) {
    this.data = data;
    this.rows = {};
    this.list.replaceChildren();
    for (const [key, name] of [
      ...(motion.energies ? [["energy", data.energyName]] : []),
      ...(motion.momenta ? [["momentum", "|L|"]] : []),
      ...(motion.velocities ? [["velocity", "|Ω|"]] : []),
    ]) {
      this.rows[key] = this.row(name);
    }
    const drifts = Object.entries(data.drift);
    if (!drifts.length || changed) return;
    const worst = drifts.reduce((a, b) => (b[1] > a[1] ? b : a));
    const words = (NAMES[worst[0]] ?? worst[0]).replaceAll("_", " ");
    this.row("largest drift").textContent = `${worded(worst[1], 2)} (${say(words)})`;
  }

  row(name) {
    const [label, value] = [document.createElement("dt"), document.createElement("dd")];
    label.textContent = say(name);
    const pair = document.createElement("div");
    pair.append(label, value);
    this.list.append(pair);
    return value;
  }

  show(now) {
    const put = (key, text) => {
      if (this.rows[key] && this.rows[key].textContent !== text) this.rows[key].textContent = text;
    };
    const { energy = [1, this.data.energyUnit], momentum = [1, "kg m²/s"] } = this.data.units ?? {};
    if (now.energy !== null) put("energy", `${worded(now.energy / energy[0])} ${energy[1]}`);
    if (now.momentum) put("momentum", `${worded(now.momentum.length() / momentum[0])} ${momentum[1]}`);
    if (now.velocity) put("velocity", `${worded(now.velocity.length(), 5)} rad/s`);
  }
}
