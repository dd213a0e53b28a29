// A motion by adaptive steps that can be asked for any time, again and again, near and far, forward and backward.
import { DormandPrince } from "./dormand_prince.js";

const TOLERANCE = 1e-12; // of a step, relative
const MOST_STEPS = 200_000; // in one call, which take about half a second
const MOST_KEPT = 2048; // places in one direction; where there are more, every second one is dropped
const FIRST_SPACING = 16; // steps from one kept place to the next at first
const [SAFETY, SHORTER, LONGER] = [0.9, 0.2, 8]; // the next step is the one that would just hold, within these bounds
const EXPONENT = -1 / 8;
const SHORTEST = 16 * Number.EPSILON; // of the time since the start: shorter steps do not move the clock
const HALVINGS = 60; // of a step in which the motion ends

/**
 * The solution of dy/dt = rates(t, y) from one state, by Dormand and Prince's method of order 8.
 *
 * Steps go from the start in either direction, each as long as the tolerance allows, and none depends on what was asked:
 * the answer is that of the last step before the time and one shorter step from there. The state at a time is therefore the
 * same to the last bit whatever was asked before. Places along the way are kept, ever sparser, so that going back is quick
 * and memory is bounded.
 */
export class Stepped {
  /**
   * @param rates function (t, state, out) that writes dy/dt into out
   * @param start state at `time`
   * @param time at which the motion starts [s]
   * @param scale of each component: its error is held to the tolerance times this and its own size
   * @param tolerance of a step
   * @param project function (state) that puts a state after a step back to where it belongs, in place
   * @param stops by name, functions (t, state) that are positive up to the end of the motion
   * @param mostSteps in one call
   */
  constructor({ rates, start, time = 0, scale, tolerance = TOLERANCE, project, stops = {}, mostSteps = MOST_STEPS }) {
    Object.assign(this, { time, tolerance, mostSteps });
    this.scale = Float64Array.from(scale);
    this.project = project ?? (() => {});
    this.stops = Object.entries(stops);
    this._method = new DormandPrince((elapsed, state, out) => rates(time + elapsed, state, out), start.length);
    this._rates = rates;
    this._begun = null; // the place at which the method's first stage stands
    this._forward = this._chain(1, start);
    this._backward = this._chain(-1, start);
  }

  /** Return the state at a time [s]: beyond the end of the motion, that at its end. Throw RangeError where it cannot be reached. */
  at(t) {
    const elapsed = t - this.time;
    const chain = elapsed < 0 ? this._backward : this._forward;
    const place = this._before(chain, Math.abs(elapsed));
    const state = place.state.slice();
    if (place === chain.end || place.elapsed === elapsed) return state;
    this._step(place, elapsed - place.elapsed, state);
    return state;
  }

  /** Return {time, event} of the end of the motion on one side of its start, or null as long as none has been met. */
  end(forward = true) {
    const { end } = forward ? this._forward : this._backward;
    return end && { time: this.time + end.elapsed, event: end.event };
  }

  _chain(sense, start) {
    const state = Float64Array.from(start);
    const first = { elapsed: 0, state, step: sense * this._firstStep(state), count: 0 };
    return { sense, kept: [first], spacing: FIRST_SPACING, from: first, to: null, end: null };
  }

  /** Return the last step's place before a time since the start, or the end of the motion if that is earlier. */
  _before(chain, distance) {
    const { end } = chain;
    if (end && distance >= Math.abs(end.elapsed)) return end;
    const kept = lastWithin(chain.kept, distance);
    if (distance < Math.abs(chain.from.elapsed) || kept.count > chain.from.count) [chain.from, chain.to] = [kept, null];
    for (let steps = 0; ; steps++) {
      chain.to ??= this._advance(chain, chain.from);
      if (Math.abs(chain.to.elapsed) > distance) return chain.from;
      if (chain.to === chain.end) return chain.end;
      if (steps >= this.mostSteps) this._tooFar(chain, distance);
      [chain.from, chain.to] = [chain.to, null];
      keep(chain, chain.from);
    }
  }

  /** Return the place after one step that holds. */
  _advance(chain, from) {
    const state = new Float64Array(from.state.length);
    let h = from.step;
    let longest = LONGER;
    for (;;) {
      if (!(Math.abs(h) > SHORTEST * Math.abs(from.elapsed)) || h === 0) this._stuck(from);
      this._step(from, h, state);
      const error = this._method.error(h, from.state, state, this.scale, this.tolerance);
      if (error <= 1) {
        const factor = error === 0 ? longest : Math.min(longest, Math.max(SHORTER, SAFETY * error ** EXPONENT));
        const place = { elapsed: from.elapsed + h, state, step: h * factor, count: from.count + 1 };
        return this._ended(chain, from, place) ?? place;
      }
      h *= error > 1 ? Math.max(SHORTER, SAFETY * error ** EXPONENT) : SHORTER; // NaN where the rates are none
      longest = 1;
    }
  }

  _step(from, h, out) {
    this._method.step(from.elapsed, from.state, h, out, this._begun === from);
    this._begun = from;
    this.project(out);
  }

  /** Return where the motion ends within a step, and remember it; null if it goes on. */
  _ended(chain, from, to) {
    const over = (elapsed, state) => this.stops.find(([, stop]) => !(stop(this.time + elapsed, state) > 0));
    let event = over(to.elapsed, to.state);
    if (!event) return null;
    const state = to.state.slice();
    let [before, after] = [0, to.elapsed - from.elapsed];
    for (let k = 0; k < HALVINGS; k++) {
      const middle = 0.5 * (before + after);
      this._step(from, middle, state);
      const found = over(from.elapsed + middle, state);
      if (found) [after, event] = [middle, found];
      else before = middle;
    }
    this._step(from, after, state);
    chain.end = { elapsed: from.elapsed + after, state, step: 0, count: to.count, event: event[0] };
    return chain.end;
  }

  /** Return a first step that is not far from one that holds: Hairer, Nørsett & Wanner, section II.4. */
  _firstStep(start) {
    const rate = new Float64Array(start.length);
    this._rates(this.time, start, rate);
    const size = (values) => Math.hypot(...values.map((x, k) => x / (this.scale[k] + Math.abs(start[k]))));
    const [place, speed] = [size(start), size(rate)];
    return place > 1e-5 && speed > 1e-5 ? (0.01 * place) / speed : 1e-6;
  }

  _tooFar(chain, distance) {
    const [t, reached] = [this.time + chain.sense * distance, this.time + chain.from.elapsed];
    throw new RangeError(
      `t = ${t} s is more than ${this.mostSteps} steps away; t = ${reached} s is reached, and kept. Ask again to go on, or ` +
        "ask for nearer times.",
    );
  }

  _stuck(from) {
    throw new RangeError(
      `the motion cannot be followed beyond t = ${this.time + from.elapsed} s, where it changes faster than any step. Check ` +
        "the parameters; losses cannot be followed far backward.",
    );
  }
}

/** Return the last of the places, which go outwards, at most so far from the start. */
function lastWithin(places, distance) {
  let [low, high] = [0, places.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (Math.abs(places[middle].elapsed) <= distance) low = middle;
    else high = middle;
  }
  return places[low];
}

/** Keep a place if it is its turn. */
function keep(chain, place) {
  const last = chain.kept[chain.kept.length - 1];
  if (place.count <= last.count || place.count % chain.spacing) return;
  chain.kept.push(place);
  if (chain.kept.length <= MOST_KEPT) return;
  chain.spacing *= 2;
  chain.kept = chain.kept.filter(({ count }) => count % chain.spacing === 0);
}
