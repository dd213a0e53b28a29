// The part of the page that takes a gyro log: a button, a place to drop it, and the choice of columns and units.
import { digits } from "../numbers.js";
import { say } from "../say.js";
import { mappingOf, openTable, readLog } from "./gyro_log.js";
import { RATE_UNITS, TIME_UNITS } from "./header_words.js";
import { dataOf } from "./page_data.js";
import { Refusal } from "./refusal.js";
import { counted } from "./table.js";
import { fitLog } from "./throw_fit.js";

const LARGEST = 64e6; // bytes
const HINT = "or drop it on this page: phyphox, Sensor Logger, AndroSensor, Betaflight, or any table with a time and three angular velocities. It stays on this computer.";

const made = (tag, fields = {}, ...children) => {
  const found = Object.assign(document.createElement(tag), fields);
  found.append(...children);
  return found;
};

export class LogReader {
  /**
   * @param after the element below which this one stands
   * @param open called with the data of a page, as Python writes them
   */
  constructor(after, open) {
    this.open = open;
    this.input = made("input", { type: "file", accept: ".csv,.txt,.tsv,text/csv,text/plain", hidden: true });
    this.input.addEventListener("change", () => {
      if (this.input.files.length) this.take(this.input.files[0]);
      this.input.value = ""; // the same file can be chosen again
    });
    this.button = made("button", { type: "button", className: "wide" });
    this.button.addEventListener("click", () => this.input.click());
    this.said = made("p", { id: "log-said" });
    this.said.setAttribute("role", "status");
    this.form = made("form", { id: "log-columns", hidden: true });
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.fit();
    });
    this.hint = made("span", { className: "hint" });
    this.root = made("section", { id: "log" }, made("p", {}, this.button, " ", this.hint), this.input, this.said, this.form);
    after.after(this.root);
    this.listen();
    this.write();
  }

  /** Write what stands here in the language that is spoken; a log that is shown is read again. */
  write() {
    this.button.textContent = say("Open a gyro log…");
    this.hint.textContent = say(HINT);
    this.root.setAttribute("aria-label", say("A log of your own"));
    if (!this.form.hidden) this.ask();
    if (this.found && !document.querySelector("#presets [aria-pressed=true]")) this.fit();
  }

  listen() {
    const holdsFile = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files");
    const mark = (on) => document.documentElement.classList.toggle("dropping", on);
    window.addEventListener("dragover", (event) => {
      if (!holdsFile(event)) return;
      event.preventDefault();
      mark(true);
    });
    window.addEventListener("dragleave", (event) => !event.relatedTarget && mark(false));
    window.addEventListener("drop", (event) => {
      if (!holdsFile(event)) return;
      event.preventDefault();
      mark(false);
      if (event.dataTransfer.files.length) this.take(event.dataTransfer.files[0]);
    });
  }

  /** Read a file, and fit it where its header says what its columns are; else ask. */
  async take(file) {
    this.form.hidden = true;
    this.name = file.name;
    try {
      if (file.size > LARGEST) throw new Refusal(say("it has {size} MB, and at most {most} MB are read. Cut the log to the throw.", { size: Math.round(file.size / 1e6), most: LARGEST / 1e6 }));
      const text = await file.text();
      if (text.startsWith("PK\u0003\u0004")) throw new Refusal(say("it is a zip archive. Unpack it, and choose the table inside, like Gyroscope.csv or Raw Data.csv."));
      this.table = openTable(text);
      this.mapping = mappingOf(this.table);
      this.ask();
      const { time, timeUnit, gyro, rateUnit } = this.mapping;
      if (time !== null && timeUnit && gyro && rateUnit) await this.fit();
      else this.say(say("no app that is known writes such a header. Choose what the columns are, and the units that the file does not say."));
    } catch (error) {
      this.refuse(error);
    }
  }

  /** Offer the columns and units for choice, with what the header says chosen. */
  ask() {
    const { form, dialect } = this.table;
    const { time, timeUnit, gyro, rateUnit } = this.mapping;
    const columns = Array.from({ length: form.width }, (_, k) => [k, form.names[k] || counted(k)]);
    const units = (table) => Object.keys(table).map((unit) => [unit, unit]);
    this.fields = {
      time: choice("time", columns, time), timeUnit: choice("unit of the time", units(TIME_UNITS), timeUnit),
      x: choice("angular velocity x", columns, gyro?.[0]), y: choice("angular velocity y", columns, gyro?.[1]),
      z: choice("angular velocity z", columns, gyro?.[2]), rateUnit: choice("its unit", units(RATE_UNITS), rateUnit),
    }; // prettier-ignore
    const words = made("summary", { textContent: say("Columns and units") });
    const details = made("details", { open: !dialect }, words, ...Object.values(this.fields), made("button", { type: "submit", className: "wide", textContent: say("Read the log") }));
    this.form.replaceChildren(details);
    this.form.hidden = false;
  }

  async fit() {
    const chosen = Object.fromEntries(Object.entries(this.fields).map(([key, label]) => [key, label.querySelector("select").value]));
    const place = (key) => (chosen[key] === "" ? null : Number(chosen[key]));
    const mapping = { time: place("time"), timeUnit: chosen.timeUnit, gyro: ["x", "y", "z"].map(place), rateUnit: chosen.rateUnit };
    this.mapping = mapping;
    this.say(say("fitting…"));
    await new Promise((resolve) => setTimeout(resolve, 30)); // lets the browser show that
    try {
      this.log = readLog(this.table, mapping);
      this.found = fitLog(this.log);
      this.show(longest(this.found.windows));
    } catch (error) {
      this.refuse(error);
    }
  }

  /** Show one of the throws. */
  show(which) {
    const data = dataOf(this.found, this.log, this.name, which);
    this.open(data);
    for (const button of document.querySelectorAll("#presets button")) button.setAttribute("aria-pressed", "false");
    document.getElementById("story").replaceChildren(...data.story.map((words) => made("li", { textContent: words })));
    this.say("");
    const { windows } = this.found;
    if (windows.length < 2) return;
    const options = windows.map(({ start, end }, k) => [k, say("{least} to {most}", { least: `${digits(start, 4)} s`, most: `${digits(end, 4)} s` })]);
    const label = choice("which throw", options, which);
    label.querySelector("select").addEventListener("change", (event) => this.show(Number(event.target.value)));
    this.said.replaceChildren(label);
  }

  refuse(error) {
    if (!(error instanceof Refusal || error instanceof RangeError)) throw error;
    this.say(error.message, true);
  }

  say(words, wrong = false) {
    this.said.textContent = words && `${this.name}: ${words}`;
    this.said.classList.toggle("wrong", wrong);
  }
}

function longest(windows) {
  let best = 0;
  windows.forEach(({ start, end }, k) => {
    if (end - start > windows[best].end - windows[best].start) best = k;
  });
  return best;
}

/** Return a labelled choice; without a value the first entry asks for one. */
function choice(words, options, value) {
  const select = made("select", { required: true });
  const known = value !== null && value !== undefined;
  if (!known) select.append(made("option", { value: "", textContent: say("choose…") }));
  select.append(...options.map(([key, text]) => made("option", { value: String(key), textContent: text, selected: known && key === value })));
  return made("label", {}, `${say(words)} `, select);
}
