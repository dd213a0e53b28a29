// Play, pause, seek, step, loop and speed, by button, slider and key.
import { clock, worded } from "./numbers.js";
import { say } from "./say.js";

const FASTER = Math.SQRT2;
const [EASY, TOPS] = [0.5, 8]; // turns of the body per second of watching, at first: of a free body, and of a top
const SWING = 1.5; // s of watching that a period of what it does should take, at first
const REAL = [0.5, 1.6]; // speeds between these begin in real time
const SEEN = 20; // s of watching within which what there is to see happens once, at first
const [SHORTEST, LONGEST] = [8, 240]; // s that the whole motion takes, at first
const [QUICKEST, SLOWEST] = [1, 3600]; // s that it takes at the ends of the scale of speeds
const LEAP = 20; // samples that page-wise steps go

export class Timebar {
  /**
   * @param root element with the controls
   * @param seek called with the position in samples
   * @param beyond called with a time outside of the samples of a motion that goes on for ever
   * @param told called when it plays, pauses, or takes another speed
   */
  constructor(root, { seek, beyond, told }) {
    this.root = root;
    this.seek = seek;
    this.beyond = beyond;
    this.told = told;
    this.position = 0;
    this.playing = false;
    this.looping = false;
    this.goesOn = false; // beyond samples that the page can continue itself
    this.slider = root.querySelector("#seek");
    this.play = root.querySelector("#play");
    this.loop = root.querySelector("#loop");
    this.speed = root.querySelector("#speed");
    this.shown = root.querySelector("#now");
    const on = (id, act) => root.querySelector(id).addEventListener("click", act);
    on("#play", () => this.toggle());
    on("#back", () => this.step(-1));
    on("#forth", () => this.step(1));
    on("#loop", () => this.repeat());
    on("#slower", () => this.scale(1 / FASTER));
    on("#faster", () => this.scale(FASTER));
    this.slider.addEventListener("input", () => {
      this.pause();
      this.go(Number(this.slider.value));
    });
    document.addEventListener("keydown", (event) => this.key(event));
  }

  /**
   * Take a motion: a new one from its beginning, or another window of the same at a time.
   *
   * @param event how long it takes until what there is to see has happened once [s], of a new one; null if nobody knows
   */
  take(motion, fresh, time = null, event = null) {
    this.motion = motion;
    this.slider.max = String(motion.count - 1);
    this.single = motion.count < 2 || !(motion.span > 0);
    for (const control of this.root.querySelectorAll("button, input")) control.disabled = this.single;
    this.loop.hidden = Boolean(motion.endless);
    if (fresh) {
      this.rate = firstRate(motion, event);
      this.pause();
    }
    if (time === null) this.go(0);
    else this.goTo(time);
  }

  key(event) {
    if (this.single || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target !== this.slider && event.target.closest?.("input, select, textarea")) return;
    const onSlider = event.target === this.slider;
    const onButton = event.target.closest?.("button, a, summary");
    if (event.target.closest?.("canvas") && event.key.startsWith("Arrow")) return; // turns the view
    const acts = {
      " ": () => !onButton && this.toggle(),
      k: () => this.toggle(),
      l: () => this.repeat(),
      ArrowLeft: () => !onSlider && this.step(event.shiftKey ? -LEAP : -1),
      ArrowRight: () => !onSlider && this.step(event.shiftKey ? LEAP : 1),
      Home: () => !onSlider && this.home(),
      End: () => !onSlider && this.to(this.motion.count - 1),
      "+": () => this.scale(FASTER),
      "=": () => this.scale(FASTER),
      "-": () => this.scale(1 / FASTER),
    };
    const act = acts[event.key];
    if (act && act() !== false) event.preventDefault();
  }

  toggle() {
    if (this.playing) return this.pause();
    if (this.position >= this.motion.count - 1 && !this.motion.endless && !this.goesOn) this.go(0);
    this.playing = true;
    this.begun = null;
    this.say();
    requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    this.playing = false;
    this.say();
  }

  repeat() {
    this.looping = !this.looping;
    this.say();
  }

  home() {
    if (!this.motion.endless) return this.to(0);
    this.pause();
    this.beyond(this.motion.solver.epoch);
  }

  tick(now) {
    if (!this.playing) return;
    const passed = this.begun === null ? 0 : Math.min((now - this.begun) / 1000, 0.25);
    this.begun = now;
    this.advance(this.time + passed * this.rate);
    if (this.playing) requestAnimationFrame((next) => this.tick(next));
  }

  advance(time) {
    const last = this.motion.times[this.motion.count - 1];
    if (time <= last) return this.goTo(time);
    if (this.motion.endless || (this.goesOn && !this.looping)) return this.beyond(time);
    if (this.looping) return this.goTo(this.motion.times[0] + ((time - last) % this.motion.span));
    this.goTo(last);
    this.pause();
  }

  step(by) {
    this.to(Math.round(this.position) + by);
  }

  to(index) {
    this.pause();
    this.go(index);
  }

  /** Go to a position in samples. */
  go(position) {
    this.position = Math.min(this.motion.count - 1, Math.max(0, position));
    this.time = this.motion.at(this.position).time;
    this.refresh();
  }

  /** Go to a time that the samples hold. */
  goTo(time) {
    this.time = time;
    this.position = this.motion.positionOf(time);
    this.refresh();
  }

  refresh() {
    this.slider.value = String(Math.round(this.position));
    this.slider.style.setProperty("--part", `${(100 * this.position) / Math.max(1, this.motion.count - 1)}%`);
    const text = clock(this.time, Math.max(this.motion.span, Math.abs(this.time)));
    this.slider.setAttribute("aria-valuetext", text);
    this.shown.textContent = text;
    this.seek(this.position, this.time);
  }

  scale(factor) {
    const { span } = this.motion;
    this.rate = Math.min(span / QUICKEST, Math.max(span / SLOWEST, this.rate * factor));
    this.say();
  }

  /** Go on so fast that what there is to see happens soon; never slower than now. */
  quicken(event) {
    if (event !== null && event > SEEN * this.rate) this.rate = roundedUp(event / SEEN);
    this.say();
  }

  say() {
    this.play.setAttribute("aria-label", say(this.playing ? "Pause" : "Play"));
    this.play.dataset.playing = String(this.playing);
    this.loop.setAttribute("aria-pressed", String(this.looping));
    if (this.rate) this.speed.textContent = Math.abs(this.rate - 1) < 0.05 ? say("real time") : `×${worded(this.rate, 2)}`;
    this.told();
  }
}

/** Return seconds of motion per second of watching: in real time where it can be followed, else a round number. */
function firstRate(motion, event) {
  if (!(motion.span > 0)) return 1;
  const turns = motion.hasUp ? TOPS : EASY;
  const turning = motion.fastest ? (2 * Math.PI * turns) / motion.fastest : motion.span / 40;
  const period = motion.solver?.nutationPeriod;
  const swinging = period && Number.isFinite(period) ? period / SWING : Infinity;
  const wanted = Math.min(motion.span / SHORTEST, Math.max(motion.span / LONGEST, Math.min(turning, swinging)));
  const needed = Math.min(motion.span / SHORTEST, (event ?? 0) / SEEN);
  if (wanted > REAL[0] && wanted < REAL[1] && needed <= 1) return 1;
  if (needed > wanted) return roundedUp(needed);
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = [5, 2, 1].find((value) => value * power <= wanted * 1.0001) ?? 1;
  return digit * power;
}

/** Return the next of 1, 2, 5 times a power of ten. */
function roundedUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].find((digit) => digit * power >= 0.9999 * value) * power;
}
