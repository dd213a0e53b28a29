// Ellipsoids as solid things: each pixel finds its surface, so that two of them part exactly where they meet.
import { LIGHT, channels } from "./colours.js";
import { formInView } from "./view.js";

/** Return the form of an ellipsoid with these semi-axes, whose axes are columns given in space. */
export function ellipsoidForm(semiAxes, axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) { // prettier-ignore
  return [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) => semiAxes.reduce((sum, half, k) => sum + (axes[k][i] * axes[k][j]) / (half * half), 0)),
  );
}

/** A surface xᵀ F x = 1 seen by a camera. */
export class Solid {
  /**
   * @param view the camera
   * @param form F, in space
   * @param centre of the surface, in space
   * @param colour "#rrggbb"
   * @param opacity 0 to 1
   * @param pattern function (right, up, towards) → "[r, g, b]" or null for the plain colour; in the camera's directions
   */
  constructor({ view, form, centre = [0, 0, 0], colour = "#888888", opacity = 1, pattern = null }) {
    Object.assign(this, { view, opacity, pattern });
    this.form = formInView(view, form);
    this.centre = view.turned(centre);
    this.colour = channels(colour);
    [this.x, this.y, this.z] = this.centre;
    // plain numbers, as arrays are slow to take apart at every pixel
    [[this.xx, this.xy, this.xz], [, this.yy, this.yz], [, , this.zz]] = this.form;
    // what remains of the form where the line of sight touches the surface
    this.p = this.xx - (this.xz * this.xz) / this.zz;
    this.q = this.xy - (this.xz * this.yz) / this.zz;
    this.r = this.yy - (this.yz * this.yz) / this.zz;
  }

  /** Return how near the front of the surface is at a place on the picture, −∞ beside it. */
  front(x, y) {
    const dx = x - this.x;
    const dy = y - this.y;
    const rest = 1 - (this.p * dx * dx + 2 * this.q * dx * dy + this.r * dy * dy);
    if (rest < 0) return -Infinity;
    return this.z + (-(this.xz * dx + this.yz * dy) + Math.sqrt(rest * this.zz)) / this.zz;
  }

  /** Return the half width and half height of the picture of the surface. */
  extent() {
    const { p, q, r } = this;
    const determinant = p * r - q * q;
    return [Math.sqrt(r / determinant), Math.sqrt(p / determinant)];
  }

  /** Draw the edge of the picture of the surface. */
  drawEdge(paper, colour, width) {
    const { p, q, r } = this;
    const low = q / p;
    const [first, second] = [1 / Math.sqrt(p), 1 / Math.sqrt(r - low * q)];
    const { view } = this;
    paper.beginPath();
    for (let k = 0; k <= 120; k++) {
      const angle = (2 * Math.PI * k) / 120;
      const y = second * Math.sin(angle);
      const x = first * Math.cos(angle) - low * y;
      paper.lineTo(view.x + view.scale * (x + this.centre[0]), view.y - view.scale * (y + this.centre[1]));
    }
    paper.closePath();
    paper.strokeStyle = colour;
    paper.lineWidth = width;
    paper.stroke();
  }
}

/** Return the solids whose front hides a point, given in the camera's directions. */
export const isHidden = (solids, [x, y, z], margin) => solids.some((solid) => solid.front(x, y) > z + margin);

const canvas = typeof document === "undefined" ? null : document.createElement("canvas");

const [QUICK, PATIENT, SETTLED] = [90_000, 500_000, 90]; // pixels while something moves, at rest; ms after which it rests
let last = { key: null, wanted: null, since: 0 };

/** Whether the picture that was drawn last could be finer. */
export const isCoarse = () => last.coarse;

/** Draw solids, each pixel by what lies in front. While `key` stays nothing is computed again, but once finer. */
export function drawSolids(paper, view, solids, { key = null } = {}) {
  const reach = solids.map((solid) => [solid.centre, solid.extent()]);
  const edge = (k, sign) => Math[sign < 0 ? "min" : "max"](...reach.map(([c, e]) => c[k] + sign * e[k]));
  const left = Math.floor(view.x + view.scale * edge(0, -1)) - 1;
  const top = Math.floor(view.y - view.scale * edge(1, 1)) - 1;
  const [across, down] = [view.scale * (edge(0, 1) - edge(0, -1)) + 3, view.scale * (edge(1, 1) - edge(1, -1)) + 3];
  if (!(across > 0 && down > 0 && across * down < 4e6)) return;
  const wanted = [key, left, top, across, down].join(" ");
  const same = key !== null && wanted === last.wanted;
  const now = performance.now();
  const rested = same && now - last.since > SETTLED;
  if (same && !(last.coarse && rested)) return void paper.drawImage(canvas, ...last.place);
  const grain = Math.max(1, Math.sqrt((across * down) / (rested ? PATIENT : QUICK)));
  const [width, height] = [Math.ceil(across / grain), Math.ceil(down / grain)];
  last = {
    wanted, since: now, coarse: key !== null && grain > 1 && !rested,
    place: [0, 0, width, height, left, top, width * grain, height * grain],
  }; // prettier-ignore
  if (canvas.width < width || canvas.height < height) [canvas.width, canvas.height] = [width, height];
  const ink = canvas.getContext("2d", { willReadFrequently: true });
  const image = ink.createImageData(width, height);
  const start = (left + 0.5 * grain - view.x) / view.scale;
  for (let row = 0; row < height; row++) {
    const y = (view.y - top - (row + 0.5) * grain) / view.scale;
    fillRow(image.data, 4 * row * width, width, solids, start, grain / view.scale, y);
  }
  ink.putImageData(image, 0, 0);
  paper.imageSmoothingEnabled = true;
  paper.drawImage(canvas, ...last.place);
}

function fillRow(data, at, width, solids, start, step, y) {
  for (let column = 0; column < width; column++, at += 4) {
    const x = start + column * step;
    let first = null;
    let second = null;
    let firstDepth = -Infinity;
    let secondDepth = -Infinity;
    for (let k = 0; k < solids.length; k++) {
      const depth = solids[k].front(x, y);
      if (depth > firstDepth) {
        second = first;
        secondDepth = firstDepth;
        first = solids[k];
        firstDepth = depth;
      } else if (depth > secondDepth) {
        second = solids[k];
        secondDepth = depth;
      }
    }
    if (!first) continue;
    shade(first, x, y, firstDepth);
    let r = shaded[0];
    let g = shaded[1];
    let b = shaded[2];
    let opacity = first.opacity;
    if (second && opacity < 1) {
      shade(second, x, y, secondDepth);
      const share = second.opacity * (1 - opacity);
      const all = opacity + share;
      r = (r * opacity + shaded[0] * share) / all;
      g = (g * opacity + shaded[1] * share) / all;
      b = (b * opacity + shaded[2] * share) / all;
      opacity = all;
    }
    data[at] = r;
    data[at + 1] = g;
    data[at + 2] = b;
    data[at + 3] = 255 * opacity;
  }
}

const [lx, ly, lz] = LIGHT;
const shaded = [0, 0, 0]; // one array for all pixels: making one each would double the time

function shade(solid, x, y, depth) {
  const dx = x - solid.x;
  const dy = y - solid.y;
  const dz = depth - solid.z;
  let nx = solid.xx * dx + solid.xy * dy + solid.xz * dz;
  let ny = solid.xy * dx + solid.yy * dy + solid.yz * dz;
  let nz = solid.xz * dx + solid.yz * dy + solid.zz * dz;
  const norm = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
  nx *= norm;
  ny *= norm;
  nz *= norm;
  const facing = Math.max(0, nx * lx + ny * ly + nz * lz);
  const light = 0.8 + 0.26 * facing - 0.17 * (1 - nz) * (1 - nz);
  const sharp = facing * facing * facing * facing;
  const glint = 30 * sharp * sharp * sharp * sharp * sharp;
  const colour = (solid.pattern && solid.pattern(dx, dy, dz)) || solid.colour;
  shaded[0] = colour[0] * light + glint;
  shaded[1] = colour[1] * light + glint;
  shaded[2] = colour[2] * light + glint;
}
