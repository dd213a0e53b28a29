// One direction of view for all panels: a drag, or the arrow keys, in one of them turns them all.
import { PerspectiveCamera, Vector3 } from "three";

export const FIELD = 26; // degrees; narrow, so that shapes look as they are
const STEP = 0.1; // rad per key
const HIGHEST = 1.55;
const [FARTHEST, CLOSEST] = [0.4, 6];
const STILL = 5; // pixels that a click may move

export class View {
  constructor(onChange) {
    this.azimuth = 0.52;
    this.elevation = 0.38;
    this.zoom = 1;
    this.onChange = onChange;
    this.taken = null; // the picture that a click has taken hold of, whose wheel zooms
    document.addEventListener("pointerdown", (event) => event.target !== this.taken && this.letGo(), { capture: true });
    document.addEventListener("keydown", (event) => event.key === "Escape" && this.letGo());
  }

  take(canvas) {
    this.letGo();
    this.taken = canvas;
    canvas.parentElement.classList.add("held");
  }

  letGo() {
    this.taken?.parentElement?.classList.remove("held");
    this.taken = null;
  }

  turn(right, up) {
    this.azimuth -= right;
    this.elevation = Math.min(HIGHEST, Math.max(-HIGHEST, this.elevation + up));
    this.onChange();
  }

  closer(factor) {
    this.zoom = Math.min(CLOSEST, Math.max(FARTHEST, this.zoom * factor));
    this.onChange();
  }

  /** Place a camera so that a ball about a target fills a picture of this shape. */
  place(camera, target, radius, aspect) {
    const half = (FIELD * Math.PI) / 360;
    const fitted = Math.min(half, Math.atan(Math.tan(half) * aspect));
    const distance = radius / Math.sin(fitted) / this.zoom;
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    camera.position.set(ce * Math.cos(this.azimuth), ce * Math.sin(this.azimuth), se).multiplyScalar(distance).add(target);
    camera.up.set(0, 0, 1);
    camera.aspect = aspect;
    camera.near = Math.max(distance - 4 * radius, distance / 100);
    camera.far = distance + 8 * radius;
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Let a panel's picture turn the view, by mouse or finger, and two fingers or the wheel bring it closer. */
  listen(canvas) {
    const held = new Map();
    let first = null;
    const gap = () => {
      const [a, b] = [...held.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      first = [event.clientX, event.clientY];
      held.set(event.pointerId, first);
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("mousedown", (event) => event.preventDefault()); // keys stay with the time bar
    canvas.addEventListener("pointermove", (event) => {
      const last = held.get(event.pointerId);
      if (!last) return;
      const before = held.size === 2 ? gap() : 0;
      held.set(event.pointerId, [event.clientX, event.clientY]);
      if (held.size === 2) this.closer(gap() / Math.max(before, 1));
      else if (held.size === 1) this.turn((event.clientX - last[0]) * 0.008, (event.clientY - last[1]) * 0.008);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => held.delete(event.pointerId));
    canvas.addEventListener("pointerup", (event) => {
      const clicked = first && Math.hypot(event.clientX - first[0], event.clientY - first[1]) < STILL;
      if (clicked && event.pointerType === "mouse") this.take(canvas);
      first = null;
    });
    canvas.addEventListener("wheel", (event) => this.wheel(event, canvas), { passive: false });
  }

  /** Zoom by the wheel where a click has taken hold of the picture, or with Ctrl, as a pinch on a trackpad; else the page scrolls. */
  wheel(event, canvas) {
    if (this.taken !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    this.closer(Math.exp(-0.002 * (event.deltaY || event.deltaX)));
  }

  /** Return whether a key turned the view. */
  key(name) {
    const turns = { ArrowLeft: [STEP, 0], ArrowRight: [-STEP, 0], ArrowUp: [0, STEP], ArrowDown: [0, -STEP] };
    if (turns[name]) this.turn(...turns[name]);
    else if (name === "PageUp") this.closer(1.15);
    else if (name === "PageDown") this.closer(1 / 1.15);
    else return false;
    return true;
  }
}

export const newCamera = () => new PerspectiveCamera(FIELD, 1, 0.1, 100);
export const ORIGIN = new Vector3(0, 0, 0);
