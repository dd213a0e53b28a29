// The sound of a contact that goes round: a click for each round, which runs together to a hum, at the motion's own rate
// whatever the speed it is watched at. It is silent until a button is pressed, and while nothing moves.
const HARMONICS = 48; // as loud as each other: a click for each period
const LOUD = 0.25;
const RISE = 0.03; // s in which it swells and fades
const STALE = 150; // ms without news after which nothing moves
const HIGHEST = 2000; // Hz; a disk's last rounds go far above what is heard

class ContactSound {
  constructor() {
    this.on = false;
    this.context = null;
    this.rate = 0;
  }

  /** Begin or end; browsers let a page sound only from a press of the user's. */
  toggle() {
    this.on = !this.on;
    if (this.on && !this.context) this.make();
    if (this.on) this.context.resume();
    else this.quiet();
  }

  make() {
    this.context = new AudioContext();
    const ones = Float32Array.from({ length: HARMONICS + 1 }, (_, k) => (k ? 1 : 0));
    this.oscillator = this.context.createOscillator();
    this.oscillator.setPeriodicWave(this.context.createPeriodicWave(ones, new Float32Array(HARMONICS + 1)));
    this.gain = this.context.createGain();
    this.gain.gain.value = 0;
    this.oscillator.connect(this.gain).connect(this.context.destination);
    this.oscillator.start();
  }

  /** Sound at a rate [1/s] that the motion has now; without the next call soon it falls silent. */
  follow(rate) {
    this.rate = rate;
    if (!this.on) return;
    const { currentTime } = this.context;
    this.oscillator.frequency.setTargetAtTime(Math.min(rate, HIGHEST), currentTime, RISE);
    this.gain.gain.setTargetAtTime(rate > 0 ? LOUD : 0, currentTime, RISE);
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.quiet(), STALE);
  }

  quiet() {
    this.gain?.gain.setTargetAtTime(0, this.context.currentTime, RISE);
  }

  /** Return what sounds: the oscillator's frequency [Hz], and how loud it is to be. */
  probe() {
    return { on: this.on, rate: this.rate, frequency: this.oscillator?.frequency.value ?? null, gain: this.gain?.gain.value ?? null };
  }
}

export const contactSound = new ContactSound();
