// A film of a picture, recorded by the browser while it is drawn.
const KINDS = [["video/webm;codecs=vp9", "webm"], ["video/webm;codecs=vp8", "webm"], ["video/webm", "webm"], ["video/mp4", "mp4"]];
const RATE = 8e6; // bits per second: thin lines stay clean
const FRAMES = 30; // per second

export const canFilm = () =>
  typeof MediaRecorder !== "undefined" && typeof HTMLCanvasElement.prototype.captureStream === "function" && Boolean(kindOf());

const kindOf = () => KINDS.find(([type]) => MediaRecorder.isTypeSupported(type));

export class Film {
  /**
   * @param canvas that is filmed, the first picture on it
   * @param seconds how long
   * @param ended called with the film, null of an empty one, and the ending of its file's name
   */
  constructor(canvas, seconds, ended) {
    const [type, kind] = kindOf();
    this.canvas = canvas;
    this.begun = performance.now();
    const parts = [];
    const stream = canvas.captureStream(FRAMES);
    this.recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: RATE });
    this.recorder.addEventListener("dataavailable", ({ data }) => data.size && parts.push(data));
    this.recorder.addEventListener("stop", () => {
      for (const track of stream.getTracks()) track.stop();
      ended(parts.length ? new Blob(parts, { type }) : null, kind);
    });
    this.recorder.start();
    this.waiting = setTimeout(() => this.close(), 1000 * seconds);
  }

  get passed() {
    return (performance.now() - this.begun) / 1000;
  }

  paint(draw) {
    this.draw = draw;
    draw(this.canvas);
  }

  /** End with a picture: recorders count no time after the last one, however long it was shown. */
  close() {
    this.draw?.(this.canvas);
    this.waiting = setTimeout(() => this.stop(), 3000 / FRAMES);
  }

  stop() {
    clearTimeout(this.waiting);
    if (this.recorder.state !== "inactive") this.recorder.stop();
  }
}
