// What can be set on a page: the setting, its sliders, and the motion that it makes.
import { Controls } from "./controls.js";
import { list } from "./frames.js";
import { declared, isInRange, NUMBER, quoted } from "./link.js";
import { inEnglish } from "./say.js";
import { SETTINGS } from "./settings/index.js";
import { SolvedMotion } from "./solved.js";

const FEW = 3; // controls that are in sight at first, of a kind that names none
const element = (id) => document.getElementById(id);

export class Instrument {
  /**
   * @param model what Python wrote of the motion: the solver's name and its numbers
   * @param changed called after each change, with whether the shape of the body has changed too
   */
  constructor(model, changed) {
    this.kind = SETTINGS[model.solver];
    this.given = model;
    this.changed = changed;
    this.setting = this.first = this.kind.from(model);
    this.solver = this.kind.make(this.setting);
    const roots = { first: element("controls"), more: element("more"), fold: element("folded") };
    this.controls = new Controls(roots, (key, value) => this.move(key, value), (why) => this.say(why));
    this.show();
  }

  /** Return the motion in a window of the page's own times, or in one that fits. */
  motion(times = null, space = null) {
    return new SolvedMotion(this.solver, times, space);
  }

  /** How long it takes until what there is to see has happened once [s]; null where the setting does not say. */
  get event() {
    return this.kind.event?.(this.setting, this.solver) ?? null;
  }

  show() {
    const controls = this.kind.controls(this.setting);
    this.controls.show(controls, this.kind.first ?? controls.slice(0, FEW).map(({ key }) => key));
    list(element("facts"), this.kind.facts(this.setting, this.solver));
  }

  /** Take a setting if a motion can be made of it; else say why not and stay. */
  take(setting) {
    const before = [this.solver, this.setting];
    try {
      this.solver = this.kind.make(setting);
    } catch (error) {
      return this.refuse(error);
    }
    this.say("");
    const shaped = String(setting.moments) !== String(this.first.moments);
    this.setting = setting;
    try {
      this.show();
      this.changed(shaped);
    } catch (error) {
      // what the solver takes at first may still lead nowhere
      [this.solver, this.setting] = before;
      this.show();
      this.changed(String(this.setting.moments) !== String(this.first.moments));
      return this.refuse(error);
    }
    return true;
  }

  /** Say why a setting is not taken; false. */
  refuse(error) {
    const known = error instanceof RangeError;
    const { message } = known ? error : new RangeError(`The page cannot draw this setting (${error.message}). Take numbers that are nearer to one.`);
    this.say(message);
    return false;
  }

  move(key, value) {
    if (key === null) return this.show();
    try {
      return this.take(this.kind.changed(this.setting, key, value));
    } catch (error) {
      return this.refuse(error); // no start belongs to it
    }
  }

  /** Set what tables of a spec say, in SI; whether that could be done. */
  set(tables) {
    try {
      check(tables, this.kind.keys);
      return this.take(this.kind.withSpec(this.setting, tables));
    } catch (error) {
      return this.refuse(error);
    }
  }

  point(unit) {
    this.take(this.kind.withDirection(this.setting, unit));
  }

  get isAsGiven() {
    return this.setting === this.first;
  }

  reset() {
    this.take(this.first);
  }

  say(text) {
    element("refused").textContent = text;
  }

  /** The setting as tables; none of the one that was given. */
  get tables() {
    return this.isAsGiven ? {} : this.kind.asSpec(this.setting);
  }

  toml(span) {
    return inEnglish(() => this.kind.toml?.(this.setting, span) ?? null);
  }
}

/** Throw a RangeError for what is not tables of known keys with numbers, or lists of numbers, as values. */
function check(tables, keys) {
  if (typeof tables !== "object" || tables === null || Array.isArray(tables)) throw new RangeError("set takes tables like {spin: {rate: 12}}.");
  for (const [table, values] of Object.entries(tables)) {
    const known = declared(keys, table, "table");
    if (typeof values !== "object" || values === null || Array.isArray(values)) throw new RangeError(`${table} must be a table of keys and values, like ${table}.${Object.keys(known)[0]}; got ${quoted(values)}.`);
    for (const [key, value] of Object.entries(values)) {
      const length = declared(known, key, "key", `${table}.`); // 0 for a word, 1 for a number, else of a list
      const numbers = [value].flat();
      const fits = length === 0 ? typeof value === "string" : numbers.length === length && Array.isArray(value) === length > 1;
      if (!fits || (length && !numbers.every(isInRange))) {
        const wanted = length === 0 ? "a word" : length === 1 ? `a number, ${NUMBER}` : `${length} numbers in a list, each ${NUMBER}`;
        throw new RangeError(`${table}.${key} must be ${wanted}; got ${quoted(value)}. Check the number, which is in SI units.`);
      }
    }
  }
}
