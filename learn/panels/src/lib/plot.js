// A graph with axes: ticks at round numbers, curves, and a place that follows the hand.
import { write } from "./ink.js";

const SHORT = 60; // times the least value that the greatest of a short range is

/** Return about `count` round numbers between two. */
export function ticks(low, high, count = 5) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

/** A graph in a box [pixels] over ranges, either of which may be on a logarithmic scale. */
export class Plot {
  constructor(paper, { left, top, width, height, x, y, logX = false, logY = false, theme }) {
    Object.assign(this, { paper, left, top, width, height, xs: x, ys: y, logX, logY, theme });
  }

  atX(value) {
    const [low, high] = this.xs;
    const share = this.logX ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
    return this.left + this.width * share;
  }

  atY(value) {
    const [low, high] = this.ys;
    const share = this.logY ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
    return this.top + this.height * (1 - share);
  }

  /** Return the value at a pixel's column. */
  valueX(pixel) {
    const share = Math.min(1, Math.max(0, (pixel - this.left) / this.width));
    const [low, high] = this.xs;
    return this.logX ? low * (high / low) ** share : low + share * (high - low);
  }

  holds([x, y], margin = 8) {
    return x > this.left - margin && x < this.left + this.width + margin && y > this.top - margin && y < this.top + this.height + margin;
  }

  /** Draw the axes with ticks [[value, words]] or numbers, and what they measure. */
  axes({ x, y, xTicks = null, yTicks = null }) {
    const { paper, theme, left, top, width, height } = this;
    const named = (list) => list.map((tick) => (Array.isArray(tick) ? tick : [tick, String(tick).replace("-", "−")]));
    paper.lineWidth = 1;
    paper.strokeStyle = theme.line;
    const say = { colour: theme.quiet, size: 11.5 };
    for (const [value, words] of named(yTicks ?? (this.logY ? decades(this.ys) : ticks(...this.ys, Math.max(3, height / 45))))) {
      line(paper, [[left, this.atY(value)], [left + width, this.atY(value)]]);
      write(paper, words, [left - 6, this.atY(value)], { ...say, align: "right" });
    }
    for (const [value, words] of named(xTicks ?? (this.logX ? decades(this.xs) : ticks(...this.xs, Math.max(3, width / 70))))) {
      line(paper, [[this.atX(value), top + height], [this.atX(value), top + height + 4]]);
      write(paper, words, [this.atX(value), top + height + 13], say);
    }
    paper.strokeStyle = theme.quiet;
    line(paper, [[left, top + height], [left + width, top + height]]);
    write(paper, x, [left + width, top + height + 28], { ...say, align: "right" });
    if (y) write(paper, y, [left - 2, top - 11], { ...say, align: "left" });
  }

  /** Draw a curve through [[x, y]], cut off at the box. */
  curve(points, { colour, width = 2.5, dash = [], opacity = 1 }) {
    const { paper } = this;
    paper.save();
    paper.beginPath();
    paper.rect(this.left, this.top - 4, this.width, this.height + 8);
    paper.clip();
    paper.setLineDash(dash);
    Object.assign(paper, { strokeStyle: colour, lineWidth: width, globalAlpha: opacity, lineJoin: "round", lineCap: dash.length ? "butt" : "round" });
    line(paper, points.map(([x, y]) => [this.atX(x), this.atY(y)]));
    paper.restore();
  }
}

function line(paper, pixels) {
  paper.beginPath();
  for (const [x, y] of pixels) paper.lineTo(x, y);
  paper.stroke();
}

/** Return powers of ten in a range with their words; in a short one also twice and five times those. */
export function decades([low, high]) {
  const found = [];
  if (high / low < SHORT) {
    for (let k = Math.floor(Math.log10(low)); k <= Math.log10(high); k++) {
      for (const value of [1, 2, 5].map((factor) => Number((factor * 10 ** k).toPrecision(3)))) {
        if (value >= low && value <= high) found.push([value, String(value)]);
      }
    }
    return found;
  }
  for (let k = Math.ceil(Math.log10(low) - 1e-9); k <= Math.log10(high) + 1e-9; k++) {
    found.push([10 ** k, k >= -3 && k <= 4 ? String(Number((10 ** k).toPrecision(3))) : `10${superscript(k)}`]);
  }
  return found;
}

const superscript = (k) => [...String(k)].map((sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign])).join("");
