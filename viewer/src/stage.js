// One WebGL context draws all panels, and each picture is copied to the panel's own canvas. Browsers allow few
// contexts, and so panels scroll and stack as any element does; names are written over the copy, where text is sharp.
import { AmbientLight, DirectionalLight, Scene, Vector3, WebGLRenderer } from "three";
import { say } from "./say.js";
import { FIELD, newCamera, ORIGIN } from "./camera.js";

const APART = 17; // pixels that a name is high
const SMALL = 200; // pixels: names do not fit into smaller pictures
const MOST_DOTS = 2; // device pixels per pixel drawn at most

export class Stage {
  constructor(view) {
    this.view = view;
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "low-power" });
    this.renderer.setClearColor(0x000000, 0);
    this.size = [0, 0];
  }

  /** Draw panels beside each other, each at its size on the page, and copy them there: waiting for the context once. */
  draw(panels, canvases, theme) {
    const dots = Math.min(window.devicePixelRatio || 1, MOST_DOTS);
    const sizes = canvases.map((canvas) => [canvas.clientWidth, canvas.clientHeight]);
    this.fit(sizes.reduce((sum, [width]) => sum + width, 0), Math.max(...sizes.map(([, height]) => height)), dots);
    let left = 0;
    const lefts = panels.map((panel, k) => {
      const [width, height] = sizes[k];
      if (width && height) this.render(panel, left, width, height);
      left += width;
      return left - width;
    });
    panels.forEach((panel, k) => this.copy(panel, canvases[k], lefts[k], sizes[k], dots, theme));
  }

  render(panel, left, width, height) {
    const { renderer } = this;
    if (!panel.flat) this.view.place(panel.camera, panel.target ?? ORIGIN, panel.radius, width / height);
    else lookDown(panel.camera, panel.flat, width / height);
    panel.lamp.position.copy(panel.camera.position).add(LAMP.clone().applyQuaternion(panel.camera.quaternion));
    panel.lamp.target.position.copy(panel.target ?? ORIGIN);
    panel.lamp.target.updateMatrixWorld();
    renderer.setViewport(left, 0, width, height);
    renderer.setScissor(left, 0, width, height);
    renderer.setScissorTest(true);
    renderer.render(panel.scene, panel.camera);
  }

  copy(panel, canvas, left, [width, height], dots, theme) {
    const [across, down] = [Math.round(width * dots), Math.round(height * dots)];
    if (!across || !down) return;
    if (canvas.width !== across || canvas.height !== down) [canvas.width, canvas.height] = [across, down];
    const paper = canvas.getContext("2d");
    const drawn = this.renderer.domElement;
    paper.clearRect(0, 0, across, down);
    paper.drawImage(drawn, left * dots, drawn.height - down, across, down, 0, 0, across, down);
    this.write(panel, paper, across, down, dots, theme);
  }

  /** Make the drawing buffer large enough; it never shrinks, as that would cost as much again. */
  fit(width, height, dots) {
    const wanted = [Math.max(this.size[0], width), Math.max(this.size[1], height)];
    if (this.dots === dots && wanted[0] === this.size[0] && wanted[1] === this.size[1]) return;
    [this.size, this.dots] = [wanted, dots];
    this.renderer.setPixelRatio(dots);
    this.renderer.setSize(...wanted, false);
  }

  write(panel, paper, across, down, dots, theme) {
    panel.boxes = [];
    if (Math.min(across, down) < SMALL * dots) return;
    paper.font = `600 ${13 * dots}px system-ui, sans-serif`;
    paper.textAlign = "center";
    paper.textBaseline = "middle";
    paper.lineJoin = "round";
    const taken = [];
    for (const { text: english, place, color } of panel.labels()) {
      const text = say(english);
      const seen = place.clone().project(panel.camera);
      const size = [paper.measureText(text).width + 4 * dots, APART * dots];
      const at = [0.5 * (1 + seen.x) * across, 0.5 * (1 - seen.y) * down];
      const box = free(at, size, taken, [across, down]);
      taken.push(box);
      const [x, y] = [box[0] + 0.5 * size[0], box[1] + 0.5 * size[1]];
      paper.lineWidth = 4 * dots;
      paper.strokeStyle = theme.ground;
      paper.strokeText(text, x, y);
      paper.fillStyle = color;
      paper.fillText(text, x, y);
    }
    panel.boxes = taken.map((box) => box.map((length) => length / dots));
  }
}

const AROUND = [[0, 0], [1, 0], [-1, 0], [0, -1], [0, 1], [1, -1], [-1, -1], [1, 1], [-1, 1]];
const RINGS = 4;

/** Return the box [left, top, width, height] of a name: about its place, or next to it where others stand, in the picture. */
function free([x, y], [width, height], taken, [across, down]) {
  const inside = (value, length, most) => Math.min(Math.max(value, 0), Math.max(0, most - length));
  const clear = ([left, top]) =>
    taken.every(([l, t, w, h]) => left >= l + w || l >= left + width || top >= t + h || t >= top + height);
  let first = null;
  for (let ring = 0; ring <= RINGS; ring++) {
    for (const [right, below] of ring ? AROUND.slice(1) : AROUND.slice(0, 1)) {
      const left = inside(x - 0.5 * width + ring * right * 0.55 * width, width, across);
      const top = inside(y - 0.5 * height + ring * below * 0.55 * height, height, down);
      first ??= [left, top];
      if (clear([left, top])) return [left, top, width, height];
    }
  }
  return [...first, width, height];
}

/** Look along −z, so that half widths and heights about a place on the x axis are in sight. */
function lookDown(camera, { wide, high, x = 0 }, aspect) {
  const distance = Math.max(high, wide / aspect) / Math.tan((FIELD * Math.PI) / 360);
  camera.position.set(x, 0, distance);
  camera.up.set(0, 1, 0);
  camera.aspect = aspect;
  camera.near = distance / 2;
  camera.far = 2 * distance;
  camera.lookAt(x, 0, 0);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

const LAMP = new Vector3(-2, 3, 1);

/** Return an empty panel with lights and a camera. */
export function newPanel(theme, fields) {
  const scene = new Scene();
  const lamp = new DirectionalLight(0xffffff, 2.1 * theme.lamp);
  scene.add(new AmbientLight(0xffffff, 1.3 * theme.lamp), lamp, lamp.target);
  return { scene, lamp, camera: newCamera(), radius: 1.5, labels: () => [], probe: () => ({}), ...fields };
}
