// Lines, arrows, labels and facets on a canvas; what lies behind a solid is faint.
import { lightOn, lit } from "./colours.js";
import { isHidden } from "./solids.js";
import { across, circle, difference, size, sum, times, unit } from "./vectors.js";

const FAINT = 0.2;

/** Draw a line through points in space: parts behind solids are faint, or left out with `faint` 0. */
export function drawCurve(paper, view, points, { colour, width = 2, solids = [], faint = FAINT, dash = [], margin = 0.004 }) {
  const places = points.map((p) => view.turned(p));
  const hidden = places.map((place) => isHidden(solids, place, margin));
  paper.strokeStyle = colour;
  paper.lineWidth = width;
  paper.lineCap = dash.length ? "butt" : "round";
  paper.lineJoin = "round";
  paper.setLineDash(dash);
  for (const behind of [true, false]) {
    if (behind && !faint) continue;
    paper.globalAlpha = behind ? faint : 1;
    paper.beginPath();
    let down = false;
    places.forEach(([x, y], k) => {
      if (hidden[k] !== behind && (k === 0 || hidden[k - 1] !== behind)) return (down = false);
      const [px, py] = [view.x + view.scale * x, view.y - view.scale * y];
      if (down) paper.lineTo(px, py);
      else paper.moveTo(px, py);
      down = true;
      if (hidden[k] !== behind) down = false;
    });
    paper.stroke();
  }
  paper.globalAlpha = 1;
  paper.setLineDash([]);
}

/** Draw an arrow with a cone for its head; `width` [pixels]. */
export function drawArrow(paper, view, from, to, { colour, width = 4, solids = [], faint = FAINT }) {
  const way = difference(to, from);
  const length = size(way);
  const head = Math.min((3.6 * width) / view.scale, 0.6 * length);
  if (!(length * view.scale > 1.5)) return;
  const along = times(way, 1 / length);
  const neck = difference(to, times(along, head));
  const count = 24;
  const shaft = Array.from({ length: count + 1 }, (_, k) => sum(from, times(along, ((length - 0.9 * head) * k) / count)));
  const towards = view.turned(along)[2];
  const drawShaft = () => drawCurve(paper, view, shaft, { colour, width, solids, faint });
  const drawHead = () => drawCone(paper, view, neck, to, (0.42 * head * 3.6) / 3, colour, isHidden(solids, view.turned(to), 0.004) ? faint : 1);
  if (towards > 0) [drawShaft, drawHead].forEach((draw) => draw());
  else [drawHead, drawShaft].forEach((draw) => draw());
}

function drawCone(paper, view, base, apex, radius, colour, opacity) {
  const axis = unit(difference(apex, base));
  const rim = circle(base, axis, radius, 28).map((p) => view.pixel(p));
  paper.globalAlpha = opacity;
  paper.fillStyle = colour;
  fill(paper, hull([...rim, view.pixel(apex)]));
  if (view.turned(axis)[2] < 0) {
    paper.fillStyle = lit(colour, 0.72);
    fill(paper, rim);
  }
  paper.globalAlpha = 1;
}

function fill(paper, pixels) {
  paper.beginPath();
  pixels.forEach(([x, y]) => paper.lineTo(x, y));
  paper.closePath();
  paper.fill();
}

/** Return the convex hull of pixels, by Andrew's monotone chain. */
export function hull(pixels) {
  const sorted = [...pixels].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (points) => {
    const kept = [];
    for (const p of points) {
      while (kept.length > 1) {
        const [a, b] = kept.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        kept.pop();
      }
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** Draw a ball at a point, `radius` in pixels. */
export function drawBall(paper, [x, y], radius, colour, ground) {
  const glow = paper.createRadialGradient(x - 0.35 * radius, y - 0.4 * radius, 0.1 * radius, x, y, radius);
  glow.addColorStop(0, lit(colour, 1.45));
  glow.addColorStop(1, colour);
  paper.beginPath();
  paper.arc(x, y, radius, 0, 2 * Math.PI);
  paper.fillStyle = glow;
  paper.fill();
  if (ground) {
    paper.strokeStyle = ground;
    paper.lineWidth = 1.5;
    paper.stroke();
  }
}

/** Write a symbol or words with a rim of the ground's colour, so that they can be read over lines. */
export function write(paper, words, [x, y], { colour, ground, symbol = false, size: points = symbol ? 18 : 13, align = "center", weight = "" }) {
  paper.font = symbol
    ? `italic ${weight || "600"} ${points}px Georgia, "Times New Roman", "DejaVu Serif", serif`
    : `${weight} ${points}px system-ui, "Segoe UI", Roboto, "Helvetica Neue", "DejaVu Sans", sans-serif`;
  paper.textAlign = align;
  paper.textBaseline = "middle";
  if (ground) {
    paper.strokeStyle = ground;
    paper.lineWidth = 4;
    paper.lineJoin = "round";
    paper.strokeText(words, x, y);
  }
  paper.fillStyle = colour;
  paper.fillText(words, x, y);
}

/** Write a symbol beyond the tip of a vector. */
export function writeAtTip(paper, view, from, to, words, options, gap = 16) {
  const [a, b] = [view.pixel(from), view.pixel(to)];
  const way = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const [dx, dy] = way > 4 ? [(b[0] - a[0]) / way, (b[1] - a[1]) / way] : [0.7, -0.7];
  write(paper, words, [b[0] + gap * dx, b[1] + gap * dy], { symbol: true, ...options });
}

/** Facets, lines and arrows drawn from the farthest to the nearest. */
export class Scene {
  constructor(paper, view) {
    Object.assign(this, { paper, view, parts: [] });
  }

  add(depth, draw) {
    this.parts.push([depth, draw]);
  }

  /** Add a flat polygon; with `oneSided` it is left out where it turns its back. */
  facet(points, colour, { normal = null, oneSided = false, edge = null, opacity = 1, shine = 0, nearer = 0 } = {}) {
    const { paper, view } = this;
    const outward = view.turned(normal ?? normalOf(points));
    if (oneSided && outward[2] <= 0) return;
    const facing = outward[2] < 0 ? outward.map((x) => -x) : outward;
    const ink = lit(colour, lightOn(facing) + shine * Math.max(0, facing[1] * 0.6 + facing[2] * 0.5) ** 8);
    const depth = points.reduce((all, p) => all + view.depth(p), 0) / points.length + nearer;
    this.add(depth, () => {
      paper.globalAlpha = opacity;
      paper.fillStyle = ink;
      paper.strokeStyle = edge ?? ink; // without it the ground shines through between neighbours
      paper.lineWidth = edge ? 1 : 0.7;
      paper.lineJoin = "round";
      paper.beginPath();
      for (const p of points) paper.lineTo(...view.pixel(p));
      paper.closePath();
      paper.fill();
      if (opacity === 1 || edge) paper.stroke();
      paper.globalAlpha = 1;
    });
  }

  /** Add a line, cut into pieces so that each finds its place among the facets. */
  line(points, { colour, width = 2, cap = "round", opacity = 1, nearer = 0 }) {
    const { paper, view } = this;
    for (let k = 1; k < points.length; k++) {
      const [p, q] = [points[k - 1], points[k]];
      this.add(0.5 * (view.depth(p) + view.depth(q)) + nearer, () => {
        paper.strokeStyle = colour;
        paper.lineWidth = width;
        paper.lineCap = cap;
        paper.globalAlpha = opacity;
        paper.beginPath();
        paper.moveTo(...view.pixel(p));
        paper.lineTo(...view.pixel(q));
        paper.stroke();
        paper.globalAlpha = 1;
      });
    }
  }

  /** Add an arrow, its shaft in pieces. */
  arrow(from, to, { colour, width = 4 }) {
    const { paper, view } = this;
    const way = difference(to, from);
    const length = size(way);
    if (!(length * view.scale > 2)) return;
    const head = Math.min((3.6 * width) / view.scale, 0.6 * length);
    const neck = difference(to, times(way, head / length));
    const pieces = 10;
    this.line(Array.from({ length: pieces + 1 }, (_, k) => sum(from, times(difference(neck, from), (k / pieces) * 1.0))),
      { colour, width }); // prettier-ignore
    this.add(view.depth(times(sum(neck, to), 0.5)) + 0.01, () => drawCone(paper, view, neck, to, 0.5 * head, colour, 1));
  }

  paint() {
    this.parts.sort((a, b) => a[0] - b[0]);
    for (const [, draw] of this.parts) draw();
  }
}

function normalOf(points) {
  const [a, b, c] = [points[0], points[1], points[points.length - 1]];
  const [u, v] = [difference(b, a), difference(c, a)];
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = size(n);
  return length ? times(n, 1 / length) : [0, 0, 1];
}

/** Return quadrilaterals of a body of revolution with their normals, from a profile [[radius, height], …] that goes from top to bottom. */
export function turnedFacets(centre, axis, profile, count, phase = 0, frame = null) {
  const [u, v] = frame ?? across(axis);
  const at = (radius, height, k) => {
    const angle = phase + (2 * Math.PI * k) / count;
    const out = sum(times(u, Math.cos(angle)), times(v, Math.sin(angle)));
    return sum(centre, sum(times(out, radius), times(axis, height)));
  };
  const facets = [];
  for (let k = 0; k < count; k++) {
    const angle = phase + (2 * Math.PI * (k + 0.5)) / count;
    const out = sum(times(u, Math.cos(angle)), times(v, Math.sin(angle)));
    for (let j = 1; j < profile.length; j++) {
      const [[r, h], [s, g]] = [profile[j - 1], profile[j]];
      const normal = unit(sum(times(out, h - g), times(axis, s - r)));
      facets.push({ points: [at(r, h, k), at(r, h, k + 1), at(s, g, k + 1), at(s, g, k)], normal, k, j });
    }
  }
  return facets;
}
