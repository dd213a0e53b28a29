// Play, pause, seek, step and speed, by button, slider and key.
import { clock, worded } from "./numbers.js";

const FASTER = Math.SQRT2;
const EASY = 0.5; // turns of the body per second of watching, at first
const [SHORTEST, LONGEST] = [8, 240]; // s that the whole motion takes, at first
const [QUICKEST, SLOWEST] = [1, 3600]; // s that it takes at the ends of the scale of speeds
const LEAP = 20; // samples that page-wise steps go

export class Timebar {
  constructor(root, motion, { seek, closer }) {
    this.motion = motion;
    this.seek = seek;
    this.closer = closer;
    this.position = 0;
    this.playing = false;
    this.rate = firstRate(motion);
    this.slider = root.querySelector("#seek");
    this.slider.max = String(motion.count - 1);
    this.play = root.querySelector("#play");
    this.speed = root.querySelector("#speed");
    this.shown = root.querySelector("#now");
    const single = motion.count < 2 || !(motion.span > 0);
    for (const control of root.querySelectorAll("button, input")) control.disabled = single;
    const on = (id, act) => root.querySelector(id).addEventListener("click", act);
    on("#play", () => this.toggle());
    on("#back", () => this.step(-1));
    on("#forth", () => this.step(1));
    on("#slower", () => this.scale(1 / FASTER));
    on("#faster", () => this.scale(FASTER));
    this.slider.addEventListener("input", () => {
      this.pause();
      this.go(Number(this.slider.value));
    });
    if (!single) document.addEventListener("keydown", (event) => this.key(event));
    this.say();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const onSlider = event.target === this.slider;
    const onButton = event.target.closest?.("button, a, summary");
    if (event.target.closest?.("canvas") && event.key.startsWith("Arrow")) return; // turns the view
    const acts = {
      " ": () => !onButton && this.toggle(),
      k: () => this.toggle(),
      ArrowLeft: () => !onSlider && this.step(event.shiftKey ? -LEAP : -1),
      ArrowRight: () => !onSlider && this.step(event.shiftKey ? LEAP : 1),
      Home: () => !onSlider && this.to(0),
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
    if (this.position >= this.motion.count - 1) this.go(0);
    this.playing = true;
    this.begun = null;
    this.say();
    requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    this.playing = false;
    this.say();
  }

  tick(now) {
    if (!this.playing) return;
    const passed = this.begun === null ? 0 : Math.min((now - this.begun) / 1000, 0.25);
    this.begun = now;
    const time = this.time + passed * this.rate;
    const last = this.motion.count - 1;
    this.time = Math.min(time, this.motion.times[last]);
    const position = this.motion.positionOf(this.time);
    this.position = position;
    if (position >= last) this.pause();
    this.refresh();
    if (this.playing) requestAnimationFrame((next) => this.tick(next));
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

  refresh() {
    this.slider.value = String(Math.round(this.position));
    const text = clock(this.time, this.motion.span);
    this.slider.setAttribute("aria-valuetext", text);
    this.shown.textContent = text;
    this.seek(this.position);
  }

  scale(factor) {
    const { span } = this.motion;
    this.rate = Math.min(span / QUICKEST, Math.max(span / SLOWEST, this.rate * factor));
    this.say();
  }

  say() {
    this.play.setAttribute("aria-label", this.playing ? "Pause" : "Play");
    this.play.dataset.playing = String(this.playing);
    this.speed.textContent = Math.abs(this.rate - 1) < 0.05 ? "real time" : `×${worded(this.rate, 2)}`;
  }
}

/** Return seconds of motion per second of watching: turns slow enough to see, the whole not too long or short. */
function firstRate(motion) {
  if (!(motion.span > 0)) return 1;
  const turning = motion.fastest ? (2 * Math.PI * EASY) / motion.fastest : motion.span / 40;
  return Math.min(motion.span / SHORTEST, Math.max(motion.span / LONGEST, turning));
}
