// A panel: a picture that answers to the hand, its controls, its numbers, and an address that is always what is seen.
import { between, readAddress, writeAddress } from "./address.js";
import { currentTheme } from "./colours.js";
import { controlOf, element } from "./controls.js";
import { addEmbedding } from "./embedding.js";
import { worded } from "../../../../viewer/src/numbers.js";
import { isCoarse } from "./solids.js";
import { View } from "./view.js";

const [TURN, KEY_TURN, STEEPEST, FARTHEST] = [0.009, 0.1, 1.5, 1e6]; // rad a pixel, rad a key, rad, rad
const LONGEST_STEP = 0.1; // s: a tab that comes back does not jump
const KEPT_TIMES = 240;
const FINER = 120; // ms after which a picture at rest is drawn finer
const SETTLING = 200; // ms after which a state stands in the address; browsers refuse it more often

const byId = (id) => document.getElementById(id);
const limited = (value, least, most) => Math.min(most, Math.max(least, value));

/**
 * Open a panel in the page.
 *
 * @param name its address
 * @param hidden rules of what else a link may set, as `readAddress` takes them
 * @param controls descriptions for `controlOf`
 * @param initial values of all settings, and `turn`, `lift` where the picture is of space
 * @param prepare function (settings) → model, called when a setting changed
 * @param readings function (model, settings) → [[key, label, value, unit, digits]], announced when they change
 * @param draw function (paper, {model, settings, theme, view, width, height, time, panel})
 * @param frame function ({width, height, settings}) → {scale, x, y} of the view; none for a flat picture
 * @param grab function ([x, y], panel) → {move([x, y]), end()} or null where nothing can be taken hold of
 * @param freely whether what is taken hold of moves up and down too
 * @param keys function (key, panel) → whether the key was for it
 * @param plays whether time runs
 * @param describe function (model, settings) → what the picture shows, for those who cannot see it
 */
export class Panel {
  constructor(description) {
    Object.assign(this, { frame: null, grab: () => null, keys: () => false, plays: false, controls: [], tick: () => {} }, description);
    this.title = document.querySelector("h1").textContent;
    this.settings = { ...this.initial };
    this.time = 0;
    this.running = this.plays && !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.visible = true;
    this.times = [];
    this.canvas = byId("picture");
    this.paper = this.canvas.getContext("2d");
    this.shown = Object.fromEntries(this.controls.map((c) => [c.key, controlOf(c, (k, v) => this.set(k, v, true), this)]));
    byId("controls").append(...this.controls.map((c) => this.shown[c.key].row));
    this.addButtons();
    this.addHand();
    this.watch();
    this.follow();
    globalThis.panel = this;
  }

  /** Change a setting. */
  set(key, value, byHand = false) {
    this.settings[key] = value;
    if (key !== "turn" && key !== "lift") this.prepared = false; // the camera changes nothing but the picture
    this.shown[key]?.show(value);
    if (byHand) {
      this.changed?.(key, this);
      this.say("");
    }
    this.redraw();
    this.remember();
  }

  /** Put the panel at a time [s]. */
  seek(time) {
    this.time = time;
    this.redraw();
  }

  /** Ask for a picture; several wishes before the next frame make one. */
  redraw() {
    this.asked ??= requestAnimationFrame((now) => this.picture(now));
  }

  picture(now) {
    this.asked = null;
    const step = this.before === undefined ? 0 : Math.min(LONGEST_STEP, (now - this.before) / 1000);
    const going = this.running && this.visible && !document.hidden;
    this.before = going ? now : undefined;
    const begun = performance.now();
    this.update();
    if (going) {
      this.time += step * (this.speed?.(this.settings, this.model) ?? 1);
      this.tick(this, step);
    }
    this.paint();
    this.times.push(performance.now() - begun);
    if (this.times.length > KEPT_TIMES) this.times.shift();
    if (going) this.redraw();
    else if (isCoarse()) setTimeout(() => this.redraw(), FINER);
  }

  update() {
    if (this.prepared) return;
    this.model = this.prepare(this.settings);
    this.prepared = true;
    const found = this.readings(this.model, this.settings).filter(Boolean);
    this.numbers = Object.fromEntries(found.map(([key, , value]) => [key, value]));
    byId("readings").replaceChildren(...found.map(([key, label, value, unit, digits]) =>
      element("div", { "data-key": key }, element("span", {}, label), element("b", {}, words(value, unit, digits))))); // prettier-ignore
    this.canvas.setAttribute("aria-label", this.describe(this.model, this.settings));
  }

  paint() {
    const { paper, canvas } = this;
    const ratio = Math.min(devicePixelRatio || 1, 3);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const [w, h] = [Math.round(ratio * width), Math.round(ratio * height)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    paper.setTransform(ratio, 0, 0, ratio, 0, 0);
    paper.clearRect(0, 0, width, height);
    const { settings, model, time } = this;
    if (this.frame) {
      this.view = new View({ turn: settings.turn, lift: settings.lift, ...this.frame({ width, height, settings, model }) });
    }
    this.draw(paper, { model, settings, theme: this.theme, view: this.view, width, height, time, panel: this });
  }

  /** Start or stop the clock. */
  run(running) {
    this.running = running && this.plays;
    const button = byId("play");
    button.setAttribute("aria-pressed", this.running);
    button.setAttribute("aria-label", this.running ? "pause" : "play");
    button.textContent = this.running ? "❚❚" : "►";
    this.redraw();
  }

  /** Put everything back to how the panel opened without an address. */
  reset() {
    for (const [key, value] of Object.entries(this.initial)) this.set(key, value);
    this.time = 0;
    this.restarted?.(this);
    this.redraw();
  }

  addButtons() {
    const play = byId("play");
    if (!this.plays) play.remove();
    else {
      play.addEventListener("click", () => this.run(!this.running));
      this.run(this.running);
    }
    byId("reset").addEventListener("click", () => this.reset());
    addEmbedding(this.title);
  }

  addHand() {
    const { canvas } = this;
    const place = (event) => [event.offsetX, event.offsetY];
    let held = null;
    canvas.addEventListener("pointerdown", (event) => {
      held = this.grab(place(event), this) ?? (this.frame && this.turning(event));
      if (!held) return;
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("held");
      held.move(place(event));
    });
    canvas.addEventListener("pointermove", (event) => {
      if (held) held.move(place(event));
      else canvas.classList.toggle("near", Boolean(this.grab(place(event), this, true)));
    });
    for (const kind of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(kind, () => {
        held?.end?.();
        held = null;
        canvas.classList.remove("held");
      });
    }
    // a finger on a point that can be dragged anywhere must not scroll the page; elsewhere it may
    canvas.addEventListener("touchstart", (event) => {
      const [box, touch] = [canvas.getBoundingClientRect(), event.touches[0]];
      if (this.freely && this.grab([touch.clientX - box.left, touch.clientY - box.top], this, true)) event.preventDefault();
    }, { passive: false }); // prettier-ignore
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (this.keys(event.key, this) || this.turnByKey(event.key)) event.preventDefault();
    });
  }

  turning(event) {
    const [x, y] = [event.offsetX, event.offsetY];
    const { turn, lift } = this.settings;
    return {
      move: ([u, v]) => {
        this.set("turn", round(turn - TURN * (u - x)));
        this.set("lift", round(limited(lift + TURN * (v - y), -STEEPEST, STEEPEST)));
      },
    };
  }

  turnByKey(key) {
    if (key === " " && this.plays) return this.run(!this.running), true;
    const [side, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key] ?? [0, 0];
    if (!this.frame || !(side || up)) return false;
    this.set("turn", round(this.settings.turn + KEY_TURN * side));
    this.set("lift", round(limited(this.settings.lift + KEY_TURN * up, -STEEPEST, STEEPEST)));
    return true;
  }

  /** Draw again when the window, the theme or what can be seen of the panel changes. */
  watch() {
    this.theme = currentTheme();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.theme = currentTheme();
      this.prepared = false;
      this.redraw();
    });
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
    new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      this.redraw();
    }).observe(this.canvas);
    document.addEventListener("visibilitychange", () => this.redraw());
  }

  /** Take the state from the address, now and whenever it changes. */
  follow() {
    const rules = { ...this.hidden, ...(this.frame && { turn: between(-FARTHEST, FARTHEST), lift: between(-STEEPEST, STEEPEST) }) };
    for (const { key } of this.controls) if (Object.hasOwn(this.initial, key)) rules[key] = this.shown[key].rule;
    const read = () => {
      if (location.hash.slice(1) === this.remembered) return;
      const { values, refused } = readAddress(location.hash, rules);
      for (const [key, value] of Object.entries({ ...this.initial, ...values })) this.set(key, value);
      this.say(refused.join(" "));
    };
    read();
    addEventListener("hashchange", read);
  }

  /** Say what of a link was not taken, until something is changed by hand. */
  say(text) {
    byId("refused").textContent = text;
  }

  remember() {
    clearTimeout(this.settling);
    this.settling = setTimeout(() => {
      this.remembered = writeAddress(this.settings, this.initial);
      history.replaceState(null, "", location.pathname + location.search + (this.remembered && `#${this.remembered}`));
    }, SETTLING);
  }
}

/** Return a value with its unit; words stay as they are. */
function words(value, unit, digits = 5) {
  if (typeof value === "string") return value;
  if (!Number.isFinite(value)) return value === null ? "undefined" : "infinite";
  return `${worded(value, digits)}${unit === "°" || !unit ? unit : ` ${unit}`}`;
}

const round = (value) => Number(value.toFixed(3));
