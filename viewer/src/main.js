// From the data in the page to its panels, and from each change of time, view, colours or setting to a new picture.
import { Address } from "./address.js";
import { View } from "./camera.js";
import { addFrame, caption, write } from "./frames.js";
import { Instrument } from "./instrument.js";
import { Language } from "./language.js";
import { Room, Views } from "./layout.js";
import { fromFragment, quoted } from "./link.js";
import { Motion, unpacked } from "./motion.js";
import { axisPanel } from "./panels/axis.js";
import { bodyPanel } from "./panels/body.js";
import { poinsotPanel } from "./panels/poinsot.js";
import { spherePanel } from "./panels/sphere.js";
import { Plots } from "./plots.js";
import { Playground } from "./playground.js";
import { Readouts } from "./readouts.js";
import { languages, say } from "./say.js";
import { Sharing } from "./sharing.js";
import { dispose } from "./shapes.js";
import { SolvedMotion } from "./solved.js";
import { Stage } from "./stage.js";
import { THEMES } from "./theme.js";
import { LogReader } from "./throw/reader.js";
import { Timebar } from "./timebar.js";
import * as tools from "./tools.js";

// pictures that fit any body, and those that scripts before this one have brought
const MAKERS = { axis: axisPanel, body: bodyPanel, poinsot: poinsotPanel, sphere: spherePanel, ...globalThis.polhodePanels };
const element = (id) => document.getElementById(id);

class Page {
  /**
   * @param data what Python wrote
   * @param language that is spoken, and its choice
   */
  constructor(data, language) {
    this.language = language;
    language.changed = () => this.retell();
    this.view = new View(() => this.draw());
    this.stage = new Stage(this.view);
    this.panels = [];
    this.outgoing = [];
    this.canvases = [];
    this.waiting = null;
    const system = window.matchMedia("(prefers-color-scheme: dark)");
    this.theme = system.matches ? THEMES.dark : THEMES.light;
    system.addEventListener("change", (event) => this.dress(event.matches ? THEMES.dark : THEMES.light));
    element("theme").addEventListener("click", () => this.dress(this.theme === THEMES.dark ? THEMES.light : THEMES.dark));
    element("reset").addEventListener("click", () => this.instrument?.reset());
    // a button that was pressed by hand gives the keys back to the time bar; one reached by key keeps them
    for (const button of document.querySelectorAll("button")) button.addEventListener("pointerup", () => button.blur());
    new ResizeObserver(() => this.sizes() !== this.shapes && this.draw()).observe(element("panels"));
    this.room = new Room(["summary", "refused", "facts", "notes", "readouts", "plots"].map(element));
    this.plots = new Plots(element("plots"), (time) => {
      this.timebar.pause();
      this.goTo(time);
    });
    this.timebar = new Timebar(element("timebar"), {
      seek: (position, time) => this.show(position, time),
      beyond: (time) => this.goTo(time),
      told: () => this.told(),
    });
    this.address = new Address(() => this.seen, (link) => this.follow(link, data));
    this.views = new Views(element("panels"), () => this.looked());
    this.sharing = new Sharing(this);
    this.playground = data.presets ? new Playground(data.presets, (preset) => this.open(preset), (step) => this.tell(step)) : null;
    if (data.presets) this.reader = new LogReader(element("share"), (found) => this.open(found));
    const link = this.address.read();
    this.open(this.playground?.find(link.tables.preset) ?? data, link);
  }

  /** Show what a link says, of the motions in `data`. */
  follow(link, data) {
    const { tables } = link;
    if (tables.lang !== (this.language.asked ?? undefined)) {
      this.language.take(tables.lang);
      this.playground?.write();
      this.reader?.write();
    }
    this.open(this.playground?.find(tables.preset) ?? data, link);
  }

  /** Show a motion: its words, its panels, and, where the page can solve it, what can be set; as a link says, if given. */
  open(data, link = null) {
    const lively = this.timebar.playing;
    this.data = data;
    write(data);
    this.room.release();
    this.view.letGo();
    this.view.elevation = data.panels[0].elevation ?? this.view.elevation;
    this.view.azimuth = data.panels[0].azimuth ?? this.view.azimuth;
    this.instrument = null;
    element("refused").textContent = ""; // what was said of another motion
    this.shaped = false;
    element("instrument").hidden = !data.model;
    element("facts").replaceChildren();
    if (data.model) {
      this.instrument = new Instrument(data.model, (shaped) => this.reset(shaped));
      this.epoch = this.instrument.setting.epoch;
    }
    // what is stepped on the page begins with Python's samples, which cost no steps
    this.motion = data.model && !data.attitude ? this.instrument.motion(timesOf(data), data.space) : new Motion(data);
    element("panels").replaceChildren();
    this.canvases = data.panels.map((panel) => addFrame(panel, this.view));
    this.canvases.forEach((canvas, k) => this.listen(canvas, k));
    this.views.take(data.panels.map(({ type }) => type));
    this.readouts = new Readouts(element("readouts"), this.motion, data);
    this.now = this.motion.at(0);
    this.build();
    this.timebar.goesOn = Boolean(this.instrument);
    this.timebar.take(this.motion, true, null, this.instrument?.event);
    this.sharing.take();
    if (link) this.restore(link);
    if (lively) this.timebar.toggle();
    this.address.write();
  }

  /** Show the same again, in the language that is spoken now. */
  retell() {
    const { position, time } = this.now;
    const tables = { ...this.seen, t: position || time !== this.begins ? time : null };
    this.playground?.write();
    this.reader?.write();
    this.open(this.data, { tables, refused: [] });
  }

  /** Take the setting, the large picture and the time that a link names, and say what of it cannot be had. */
  restore({ tables: { t = null, preset, view = null, lang, ...settings }, refused }) {
    const [place, found] = [element("refused"), [...refused]];
    const said = () => {
      if (place.textContent) found.push({ message: place.textContent });
      place.textContent = "";
    };
    const named = Object.keys(settings);
    if (named.length && !this.instrument) found.push(new RangeError(`This motion has nothing to set; got ${quoted(named.join(", "))} in the link. Leave that out.`));
    else if (named.length) this.instrument.set(settings);
    said();
    if (preset !== undefined && !this.playground) found.push(new RangeError(`This page shows one motion; got preset=${quoted(preset)} in the link. Leave that out.`));
    if (lang !== undefined && !languages().includes(lang)) found.push(new RangeError(`lang must be ${languages().join(" or ")}; got ${quoted(lang)}. Name one of these.`));
    if (view !== null && !this.views.enlarge(String(view))) found.push(new RangeError(`view must be ${this.views.types.join(" or ")}; got ${quoted(view)}. Name one of these.`));
    if (t !== null && typeof t !== "number") found.push(new RangeError(`t must be a time in seconds; got ${quoted(t)}. Write it as a number, as in t=4.`));
    else if (t !== null) this.goTo(t);
    said();
    place.textContent = found.map(({ message }) => message).join(" ");
  }

  /** What the address says: which motion, how it is set, which picture is large, and the time, once it stands still. */
  get seen() {
    const { key } = this.data;
    const { named } = this.views;
    const stands = !this.timebar.playing && this.now.time !== this.begins;
    return {
      ...(this.language.asked ? { lang: this.language.asked } : {}),
      ...(key ? { preset: key } : {}),
      ...this.instrument?.tables,
      ...(named ? { view: named } : {}),
      ...(stands ? { t: this.now.time } : {}),
    };
  }

  get begins() {
    return this.instrument?.setting.epoch ?? this.motion.times[0];
  }

  /** Do what the button in a sentence says, from the motion's beginning: set it, make a picture large, or show it as it was. */
  tell({ set, view }) {
    if (view) return this.views.enlarge(view);
    if (set && this.instrument?.set(set)) this.timebar.quicken(this.instrument.event);
    else if (!set) this.instrument?.reset();
    this.goTo(this.begins);
    if (!calm() && !this.timebar.playing) this.timebar.toggle();
    return this.address.write();
  }

  /** Follow another picture that is large now. */
  looked() {
    this.view.letGo();
    this.draw();
    this.address.write();
  }

  /** Follow the time bar, which plays, pauses, or has another speed. */
  told() {
    if (this.sharing && this.motion) this.sharing.suggest();
    if (this.instrument !== undefined) this.address.changed();
  }

  /** Solve and draw anew after the setting has changed, at the same time. */
  reset(shaped) {
    this.room.keep();
    const { epoch } = this.instrument.setting;
    const time = epoch === this.epoch ? this.now.time : epoch; // of a motion that begins anew
    this.epoch = epoch;
    this.shaped = shaped;
    // what Python said is of the motion as it was given
    element("summary").textContent = say(this.instrument.isAsGiven ? this.data.summary : "Set on this page.");
    const fresh = this.instrument.motion();
    this.motion = fresh.around(time);
    this.readouts.take(this.motion, this.data, true);
    this.build();
    this.timebar.take(this.motion, false, time);
    this.sharing.suggest();
    this.room.keep();
    this.address.changed();
  }

  build() {
    this.outgoing.push(...this.panels);
    document.documentElement.dataset.theme = this.theme.name;
    this.panels = this.data.panels.map((panel) => {
      const data = this.changedPanel(panel);
      return Object.assign(MAKERS[panel.type](this.motion, data, this.theme, tools), { type: panel.type });
    });
    this.panels.forEach((panel, k) => caption(this.canvases[k], panel, this.data, () => this.draw()));
    const changed = this.instrument && !this.instrument.isAsGiven;
    this.plots.take(this.motion, changed ? { ...this.data, scatters: [], plots: [] } : this.data, this.theme);
    this.draw();
  }

  /** Return the data of a panel, without what is no longer true of a motion that was changed here. */
  changedPanel(panel) {
    if (this.shaped && panel.type === "body") return { ...panel, surface: null, ellipsoid: null, changed: true };
    const set = this.instrument && !this.instrument.isAsGiven;
    return set && panel.type === "sphere" ? { ...panel, changed: true, equilibria: null } : panel;
  }

  dress(theme) {
    this.theme = theme;
    this.build();
  }

  show(position, time) {
    this.now = this.motion.endless ? { position, ...this.motion.solvedAt(time) } : this.motion.at(position);
    if (!this.timebar.playing) this.address.changed();
    this.draw();
  }

  /** Go to any time: to another window of a motion that goes on for ever, where it lies outside of this one; whether it can. */
  goTo(time) {
    let found;
    try {
      found = this.windowAt(time);
    } catch (error) {
      this.timebar.pause();
      element("refused").textContent = error.message;
      return false;
    }
    if (found !== this.motion) {
      this.motion = found;
      this.build();
      this.timebar.take(found, false, time);
    } else this.timebar.goTo(time);
    return true;
  }

  /** Return the motion in a window that has a time; throw a RangeError where there is none. */
  windowAt(time) {
    const { times, count, endless } = this.motion;
    if (!Number.isFinite(time)) throw new RangeError(`t must be a finite number of seconds; got ${quoted(time)}. Give a nearer time.`);
    if (endless) return this.motion.around(time);
    if (time >= times[0] && time <= times[count - 1]) return this.motion;
    if (this.instrument) return this.instrument.motion().around(time);
    throw new RangeError(`t must be from ${times[0]} to ${times[count - 1]} s, where this motion has samples; got ${time}. Give a time between these.`);
  }

  /** Draw all panels once before the next frame is shown; nothing is drawn while nothing changes. */
  draw() {
    this.waiting ??= requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    cancelAnimationFrame(this.waiting);
    this.waiting = null;
    this.shapes = this.sizes();
    for (const panel of this.panels) panel.update(this.now);
    this.stage.draw(this.panels, this.canvases, this.theme);
    this.clear();
    this.plots.draw(this.now);
    this.readouts.show(this.now);
    this.sharing.frame();
    window.polhode.drawn += 1;
    window.polhode.firstPicture ??= performance.now();
  }

  /**
   * Throw away the panels before these. Not before these are drawn: a program of the graphics card goes with the last
   * material that uses it, and to compile it anew takes longer than all else that follows a slider.
   */
  clear() {
    for (const panel of this.outgoing) dispose(panel.scene);
    this.outgoing = [];
  }

  /** Return the page with its last change drawn, for those who cannot wait for the next frame. */
  drawn() {
    if (this.waiting) this.drawNow();
    return this;
  }

  sizes() {
    return this.canvases.map((canvas) => `${canvas.clientWidth} ${canvas.clientHeight}`).join();
  }

  /** Let the momentum's point be dragged on the sphere: it chooses the polhode that the motion starts on. */
  listen(canvas, k) {
    const place = (event) => {
      const box = canvas.getBoundingClientRect();
      return [((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2];
    };
    canvas.addEventListener("pointerdown", (event) => {
      const panel = this.panels[k];
      if (event.button !== 0 || !panel.grasp || !this.instrument?.kind.dragged) return;
      if (!panel.grasp(place(event), canvas.clientWidth)) return;
      event.stopImmediatePropagation();
      this.timebar.pause();
      canvas.setPointerCapture(event.pointerId);
      const move = (moved) => {
        const unit = this.panels[k].under(place(moved));
        if (!unit) return;
        this.now = { ...this.now, time: this.instrument.setting.epoch };
        this.instrument.point(unit);
      };
      const end = () => {
        canvas.removeEventListener("pointermove", move);
        for (const name of ["pointerup", "pointercancel"]) canvas.removeEventListener(name, end);
      };
      canvas.addEventListener("pointermove", move);
      for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, end);
    }, { capture: true });
  }

  /** Return the large picture on its ground, on a canvas of its own or on one of an earlier shot. */
  shot(into = null) {
    if (!into) this.drawn();
    const canvas = this.canvases[this.views.large];
    const found = into ?? document.createElement("canvas");
    if (!into) [found.width, found.height] = [canvas.width, canvas.height].map((size) => size - (size % 2)); // as recorders ask
    const paper = found.getContext("2d");
    paper.fillStyle = this.theme.ground;
    paper.fillRect(0, 0, found.width, found.height);
    const scale = Math.min(found.width / canvas.width, found.height / canvas.height);
    const [width, height] = [canvas.width * scale, canvas.height * scale];
    paper.drawImage(canvas, 0.5 * (found.width - width), 0.5 * (found.height - height), width, height);
    return found;
  }
}

const calm = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;
const timesOf = (data) => unpacked(data.times);

/** What tests and those who embed the page use: set(tables of a spec, in SI), state(time), and where things are drawn. */
function offered(page) {
  return {
    drawn: 0,
    firstPicture: null,
    get count() {
      return page.motion.count;
    },
    get times() {
      return page.motion.times;
    },
    view: page.view,
    /** Make the picture of a type large, as "sphere"; whether there is one. */
    enlarge: (type) => page.views.enlarge(type),
    shown: () => ({ theme: page.theme.name, position: page.now.position, time: page.now.time }),
    seek(index) {
      page.timebar.to(index);
      page.drawNow();
    },
    /** Go to a time [s]; whether that could be done. */
    goTo(time) {
      const done = page.goTo(time);
      page.drawn();
      return done;
    },
    get playing() {
      return page.timebar.playing;
    },
    /** Change the motion to what tables of a spec say, in SI: set({ spin: { rate: 12, tilt: 0.1 } }). */
    set: (tables) => page.instrument?.set(tables) ?? false,
    /** Return the tables of the present setting. */
    settings: () => page.instrument?.kind.asSpec(page.instrument.setting) ?? null,
    /** Return attitude (wxyz, body to space) and momentum (body axes) at a time [s]. */
    state(time) {
      const solved = page.motion.endless ? page.motion : page.instrument?.motion([time]);
      const found = solved ? solved.solvedAt(time) : page.motion.at(page.motion.positionOf(time));
      const { w, x, y, z } = found.attitude ?? {};
      return { attitude: found.attitude ? [w, x, y, z] : null, momentum: found.momentum?.toArray() ?? null };
    },
    spec: () => page.instrument?.toml(page.motion.span) ?? null,
    plots: () => page.drawn().plots.probe(),
    /** Return the boxes [left, top, width, height] of the names in each picture, in its pixels. */
    names: () => page.drawn().panels.map((panel) => panel.boxes ?? []),
    /** Return what a panel of a type draws, or only the parts of that name. */
    measure(type, ...names) {
      page.drawn();
      const found = page.panels.find((panel) => panel.type === type)?.probe();
      return found && names.length ? Object.fromEntries(names.map((name) => [name, found[name]])) : found;
    },
  };
}

try {
  const data = JSON.parse(element("motion").textContent);
  window.polhode = { drawn: 0, firstPicture: null };
  const language = new Language();
  language.take(fromFragment(window.location.hash).tables.lang);
  write(data.presets ? data.presets[0] : data);
  const page = new Page(data, language);
  window.polhode = offered(page);
  window.seek = (index) => window.polhode.seek(index);
  page.draw();
  if (!calm() && page.motion.count > 1 && page.motion.span > 0) requestAnimationFrame(() => page.timebar.toggle());
} catch (error) {
  const words = element("failure");
  words.hidden = false;
  words.textContent = say("The pictures cannot be drawn ({why}). They need a browser with WebGL 2.", { why: error.message });
  throw error;
}
