// Sliders and number fields for what can be set; values come and go in SI.
import { decimal, say } from "./say.js";

const STEPS = 1000;

export class Controls {
  /**
   * @param roots elements that they are put into: first, those that matter most; more, the rest; fold, which hides the rest
   * @param onChange called with the key and the new value
   * @param refuse called with why what was typed is not taken
   */
  constructor(roots, onChange, refuse) {
    this.roots = roots;
    this.onChange = onChange;
    this.refuse = refuse;
    this.rows = new Map();
  }

  /** Show what can be set, some first and the rest folded: new rows where the keys are new, new values everywhere. */
  show(controls, first) {
    const keys = controls.map(({ key }) => key);
    if (keys.join() !== this.keys) {
      this.keys = keys.join();
      const rows = new Map(controls.map((control) => [control.key, this.rows.get(control.key) ?? this.row(control)]));
      this.rows = rows;
      const ahead = first.filter((key) => rows.has(key));
      const rest = keys.filter((key) => !ahead.includes(key));
      stand(this.roots.first, ahead.map((key) => rows.get(key).line));
      stand(this.roots.more, rest.map((key) => rows.get(key).line));
      this.roots.fold.hidden = !rest.length;
    }
    for (const control of controls) this.refresh(control);
  }

  row(control) {
    const line = document.createElement("div");
    line.className = control.choices ? "control choice" : "control";
    const label = document.createElement("label");
    const id = `set-${control.key.replaceAll(".", "-")}`;
    label.htmlFor = id;
    line.append(label);
    const row = { label, line };
    if (control.choices) {
      row.choice = document.createElement("select");
      row.choice.id = id;
      for (const [value, text] of control.choices) row.choice.append(new Option(say(text), value));
      row.choice.addEventListener("change", () => this.onChange(control.key, Number(row.choice.value)));
      line.append(row.choice);
    } else {
      row.slider = document.createElement("input");
      Object.assign(row.slider, { type: "range", min: 0, max: STEPS, step: "any" });
      row.slider.addEventListener("input", () => this.onChange(control.key, valueAt(row.control, Number(row.slider.value) / STEPS)));
      // a new range would move under the finger: it is taken when the slider is let go
      row.slider.addEventListener("change", () => this.settle());
      row.field = document.createElement("input");
      Object.assign(row.field, { type: "text", inputMode: "decimal", id, autocomplete: "off" });
      row.field.addEventListener("change", () => this.typed(row));
      row.unit = document.createElement("span");
      line.append(row.field, row.unit, row.slider);
    }
    return row;
  }

  refresh(control) {
    const row = this.rows.get(control.key);
    const [label, unit] = [say(control.label), say(control.unit ?? "")];
    row.label.textContent = label;
    if (row.choice) {
      row.choice.value = String(control.value);
      return;
    }
    const held = row.slider === document.activeElement && row.slider.matches(":active");
    row.control = held ? { ...row.control, value: control.value } : control;
    row.slider.setAttribute("aria-label", label);
    if (!held) row.slider.value = String(STEPS * partAt(control, control.value));
    row.slider.style.setProperty("--part", `${(100 * Number(row.slider.value)) / STEPS}%`);
    const text = plain(control.value / (control.si ?? 1));
    row.slider.setAttribute("aria-valuetext", `${text} ${unit}`);
    if (document.activeElement !== row.field) row.field.value = text;
    row.unit.textContent = unit;
    row.field.setAttribute("aria-label", `${label} [${unit}]`);
    row.field.setCustomValidity("");
    row.field.removeAttribute("aria-invalid");
  }

  settle() {
    this.onChange(null);
  }

  typed(row) {
    const value = Number(row.field.value.trim().replace(",", ".")) * (row.control.si ?? 1);
    const { low, high, log, unit, si = 1 } = row.control;
    const wrong = !row.field.value.trim() || !Number.isFinite(value) ? say("A number is needed.") : log && !(value > 0) ? say("It must be greater than zero.") : "";
    const outside = row.control.key.startsWith("body.moments") && (value < low * 0.999 || value > high * 1.001);
    const said = wrong || (outside ? say("No body has this moment with the two others: {least} to {most} {unit}.", { least: plain(low / si), most: plain(high / si), unit }) : "");
    row.field.setCustomValidity(said);
    if (said) {
      row.field.setAttribute("aria-invalid", "true");
      row.field.reportValidity();
      this.refuse(said);
    } else this.onChange(row.control.key, value);
  }
}

/** Let lines stand in an element, in their order; those that stand there already stay untouched, and keep the focus. */
function stand(root, lines) {
  for (const old of [...root.children]) if (!lines.includes(old)) old.remove();
  lines.forEach((line, k) => root.children[k] !== line && root.insertBefore(line, root.children[k] ?? null));
}

/** Return the value at a part, 0 to 1, of a slider's way. */
function valueAt({ low, high, log, power = 1 }, part) {
  return log ? low * (high / low) ** part : low + (high - low) * part ** power;
}

function partAt({ low, high, log, power = 1 }, value) {
  const part = log ? Math.log(Math.max(value, Number.MIN_VALUE) / low) / Math.log(high / low) : ((value - low) / (high - low)) ** (1 / power);
  return Math.min(1, Math.max(0, Number.isFinite(part) ? part : 0));
}

/** Return a number as a field shows it, which reads it back. */
function plain(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return decimal(size >= 1e-3 && size < 1e6 ? String(Number(value.toPrecision(7))) : value.toExponential(5));
}
