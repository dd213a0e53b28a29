// A click for every turn of the contact, as a saw-tooth wave of that frequency, through a low pass.
const [LOUDNESS, SMOOTHING, HIGHEST] = [0.12, 0.02, 4000]; // of full scale, s, Hz

/** A sound that starts silent and only by a button, as browsers ask. */
export class Clicks {
  /** Switch the sound on or off. */
  switchTo(on) {
    if (on && !this.context) {
      this.context = new AudioContext();
      this.wave = new OscillatorNode(this.context, { type: "sawtooth", frequency: 1 });
      this.gain = new GainNode(this.context, { gain: 0 });
      const filter = new BiquadFilterNode(this.context, { type: "lowpass", frequency: 2500 });
      this.wave.connect(filter).connect(this.gain).connect(this.context.destination);
      this.wave.start();
    }
    this.on = on;
    if (on) this.context.resume();
    else this.silence();
  }

  /** Let it click so many times a second. */
  follow(frequency) {
    if (!this.on) return;
    const now = this.context.currentTime;
    this.wave.frequency.setTargetAtTime(Math.min(HIGHEST, frequency), now, SMOOTHING);
    this.gain.gain.setTargetAtTime(LOUDNESS, now, SMOOTHING);
  }

  silence() {
    this.gain?.gain.setTargetAtTime(0, this.context.currentTime, SMOOTHING);
  }
}
