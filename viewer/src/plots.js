// Curves over time below the pictures, with a cursor that moves along; a press on one of them goes to that time.
import { Quaternion, Vector3 } from "three";
import { unpacked } from "./motion.js";
import { SUPERSCRIPTS, unitOf, worded } from "./numbers.js";
import { polhodeThrough } from "./polhodes.js";
import { decimal, say } from "./say.js";
import { seriesStyle } from "./theme.js";

const POINTS = 1600; // of a curve at most
const SMALL = 0.05; // rad from its axis up to which a polhode is also drawn magnified
const MARGIN = { left: 62, right: 12, top: 10, bottom: 24 };
const DEGREE = 180 / Math.PI;
const ARC = [[1 / DEGREE, "°"], [1 / DEGREE / 60, "′"], [1 / DEGREE / 3600, "″"], [1e-3 / DEGREE / 3600, "mas"]];

/** Return what is to be plotted of a motion: titles, units, and series (name, colour, values at rows). */
function plotsOf(motion, data, theme, rows) {
  const own = motion.solver?.plots?.(rows.map((row) => motion.times[row]));
  const styleOf = (one, k, along) => (one.role ? { color: theme[one.role] } : along ? { color: theme.axes[k] } : seriesStyle(theme, k));
  if (own) return own.map(({ series, along, ...more }) => ({ ...more, series: series.map((one, k) => ({ ...one, ...styleOf(one, k, along) })) }));
  const found = [];
  const vectors = motion.velocities ?? motion.momenta;
  const names = data.axes ?? ["axis 1", "axis 2", "axis 3"];
  if (vectors) {
    found.push({
      title: motion.velocities ? "Ω along the body's axes" : "L along the body's axes",
      unit: motion.velocities ? "rad/s" : "kg m²/s",
      series: names.map((name, k) => ({ name, color: theme.axes[k], values: rows.map((row) => vectors[3 * row + k]) })),
    });
  }
  const angles = anglesOf(motion, data, theme, rows, names);
  if (angles) found.push(angles);
  for (const { title, unit, series } of data.plots ?? []) {
    found.push({ title, unit, series: series.map(({ name, values }, k) => {
      const own = unpacked(values);
      return { name, ...seriesStyle(theme, k), values: rows.map((row) => own[row]) };
    }) });
  }
  return found;
}

/** Return the angles of the body's axes from L, or of a top's axis from the vertical; null without attitudes. */
function anglesOf(motion, data, theme, rows, names) {
  if (!motion.attitudes) return null;
  if (data.up === "L" && motion.momenta) {
    const lean = (row, k) => {
      const L = motion.momenta.subarray(3 * row, 3 * row + 3);
      return Math.atan2(Math.hypot(L[(k + 1) % 3], L[(k + 2) % 3]), L[k]) * DEGREE;
    };
    const series = names.map((name, k) => ({ name, color: theme.axes[k], values: rows.map((row) => lean(row, k)) }));
    return { title: "angles of the axes from L", unit: "°", series };
  }
  const axis = new Vector3(...(data.panels.find((panel) => panel.axis)?.axis ?? [0, 0, 1])).normalize();
  const tilt = (row) => {
    const [w, x, y, z] = motion.attitudes.subarray(4 * row, 4 * row + 4);
    const up = axis.clone().applyQuaternion(new Quaternion(x, y, z, w));
    return Math.atan2(Math.hypot(up.x, up.y), up.z) * DEGREE;
  };
  return { title: "tilt of the axis from the vertical", unit: "°", series: [{ name: "tilt", color: theme.motion, values: rows.map(tilt) }] };
}

export class Plots {
  constructor(root, goTo) {
    this.root = root;
    this.goTo = goTo;
    this.plots = [];
  }

  /** Make the plots of a motion anew. */
  take(motion, data, theme) {
    this.motion = motion;
    this.theme = theme;
    const step = Math.max(1, Math.ceil(motion.count / POINTS));
    const rows = [];
    for (let row = 0; row < motion.count; row += step) rows.push(row);
    if (rows.at(-1) !== motion.count - 1) rows.push(motion.count - 1);
    this.times = rows.map((row) => motion.times[row]);
    const wanted = motion.count > 1 && motion.span > 0 ? plotsOf(motion, data, theme, rows).map(withPower) : [];
    for (const { title, words, x, y } of data.scatters ?? []) {
      wanted.push({ title, words, scatter: [unpacked(x), unpacked(y)], color: theme.motion });
    }
    const small = magnified(motion, theme);
    if (small) wanted.push(small);
    if (wanted.length !== this.plots.length) {
      this.root.replaceChildren(...wanted.map(() => this.frame()));
      this.plots = wanted.map((_, k) => ({ figure: this.root.children[k], canvas: this.root.children[k].firstChild }));
    }
    this.plots.forEach((plot, k) => {
      plot.what = wanted[k];
      plot.still = null;
      caption(plot.figure, wanted[k]);
    });
  }

  frame() {
    const figure = document.createElement("figure");
    figure.className = "plot";
    const canvas = document.createElement("canvas");
    canvas.setAttribute("role", "img");
    const go = (event) => {
      const plot = this.plots.find((one) => one.canvas === canvas);
      if (!plot.what.series || (event.type === "pointermove" && !event.buttons)) return;
      const box = canvas.getBoundingClientRect();
      const part = (event.clientX - box.left - MARGIN.left) / (box.width - MARGIN.left - MARGIN.right);
      this.goTo(this.times[0] + Math.min(1, Math.max(0, part)) * (this.times.at(-1) - this.times[0]));
    };
    canvas.addEventListener("pointerdown", go);
    canvas.addEventListener("pointermove", go);
    figure.append(canvas, document.createElement("figcaption"));
    return figure;
  }

  draw(now) {
    for (const plot of this.plots) {
      const { canvas, what } = plot;
      const dots = Math.min(window.devicePixelRatio || 1, 2);
      const [width, height] = [canvas.clientWidth, canvas.clientHeight];
      if (!width || !height) continue;
      if (!plot.still || plot.width !== width || plot.dots !== dots) {
        Object.assign(plot, { width, dots, still: this.still(what, width, height, dots) });
        [canvas.width, canvas.height] = [plot.still.width, plot.still.height];
      }
      const paper = canvas.getContext("2d");
      paper.clearRect(0, 0, canvas.width, canvas.height);
      paper.drawImage(plot.still, 0, 0);
      paper.setTransform(dots, 0, 0, dots, 0, 0);
      if (what.path) this.dot(paper, what, now, width, height);
      else if (what.series) this.cursor(paper, now, width, height);
      paper.setTransform(1, 0, 0, 1, 0, 0);
    }
  }

  /** Return the picture of what does not move. */
  still(what, width, height, dots) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [Math.round(width * dots), Math.round(height * dots)];
    const paper = canvas.getContext("2d");
    paper.scale(dots, dots);
    paper.font = "12px system-ui, sans-serif";
    if (what.path) drawPath(paper, what, width, height, this.theme);
    else if (what.scatter) drawScatter(paper, what, width, height, this.theme);
    else this.drawCurves(paper, what, width, height);
    return canvas;
  }

  drawCurves(paper, { series, unit: named, power }, width, height) {
    const { times, theme } = this;
    const [low, high] = range(series);
    const place = placed(times[0], times.at(-1), low, high, width, height);
    paper.fillStyle = theme.text;
    paper.strokeStyle = theme.ring;
    paper.textBaseline = "middle";
    paper.textAlign = "right";
    for (const value of ticks(low, high, 4)) {
      const [, y] = place(times[0], value);
      stroke(paper, [[MARGIN.left, y], [width - MARGIN.right, y]]);
      paper.fillText(`${round(value / 10 ** power)}${named === "°" ? "°" : ""}`, MARGIN.left - 6, y);
    }
    paper.textBaseline = "top";
    paper.textAlign = "center";
    const span = times.at(-1) - times[0];
    const [unit, name] = unitOf(span) ?? [1, "s"];
    for (const value of ticks(times[0] / unit, times.at(-1) / unit, width > 500 ? 6 : 3)) {
      paper.fillText(`${round(value)} ${name}`, place(value * unit, low)[0], height - MARGIN.bottom + 7);
    }
    for (const { color, dash = [], values, times: own = times } of series) {
      [paper.strokeStyle, paper.fillStyle, paper.lineWidth] = [color, color, 1.6];
      paper.setLineDash(dash);
      const points = values.map((value, k) => place(own[k], value));
      if (this.motion.joined) stroke(paper, points);
      else for (const [x, y] of points) paper.fillRect(x - 1, y - 1, 2, 2);
    }
    paper.setLineDash([]);
  }

  cursor(paper, now, width, height) {
    const [first, last] = [this.times[0], this.times.at(-1)];
    const x = MARGIN.left + ((now.time - first) / (last - first || 1)) * (width - MARGIN.left - MARGIN.right);
    paper.strokeStyle = this.theme.text;
    paper.lineWidth = 1.2;
    stroke(paper, [[x, MARGIN.top], [x, height - MARGIN.bottom]]);
  }

  dot(paper, what, now, width, height) {
    const [x, y] = scaled(what, width, height)(what.flat(now.momentum.clone().normalize()));
    paper.fillStyle = this.theme.velocity;
    paper.beginPath();
    paper.arc(x, y, 5, 0, 2 * Math.PI);
    paper.fill();
  }

  /** Return what is plotted: titles, and the smallest and largest value of each series. */
  probe() {
    return this.plots.map(({ what }) => ({
      title: what.title,
      ranges: (what.series ?? []).map(({ values }) => [Math.min(...values), Math.max(...values)]),
      styles: (what.series ?? []).map(({ color, dash = [] }) => ({ color, dash })),
      across: what.across ?? null,
    }));
  }
}

/** Return a small polhode seen along its axis, in a unit of its size; null of those that the sphere shows well. */
function magnified(motion, theme) {
  if (!motion.free) return null;
  const start = motion.at(0).momentum;
  if (!(start.length() > 0)) return null;
  const curve = polhodeThrough(motion.free, start.toArray());
  const parts = start.clone().normalize().toArray();
  const axis = parts.reduce((best, value, k) => (Math.abs(value) > Math.abs(parts[best]) ? k : best), 0);
  if (!curve) return null;
  const sign = Math.sign(parts[axis]);
  const flat = (unit) => [unit.getComponent((axis + 1) % 3) * sign, unit.getComponent((axis + 2) % 3)];
  const points = [];
  for (let k = 0; k < curve.length; k += 3) points.push(flat(new Vector3(curve[k], curve[k + 1], curve[k + 2])));
  const most = Math.max(...points.map(([x, y]) => Math.hypot(x, y)));
  if (!(most < SMALL) || most < 1e-14) return null;
  const [unit, name] = ARC.find(([size]) => 2 * most >= size) ?? ARC.at(-1);
  const across = `${round((2 * most) / unit, 3)}${name.length > 1 ? " " : ""}${name}`;
  return { title: ["the polhode from above, {across} across: the sphere magnified {times} times", { across, times: worded(1 / most, 1) }], across, path: points, flat, most, color: theme.motion, unit, name };
}

const scaled = ({ most }, width, height) => {
  const size = (0.5 * Math.min(width, height) - 22) / most;
  return ([x, y]) => [0.5 * width + size * x, 0.5 * height - size * y];
};

/** Draw points of one number against another. */
function drawScatter(paper, { scatter: [x, y], color }, width, height, theme) {
  const [[left, right], [low, high]] = [x, y].map((values) => range([{ values }]));
  const place = placed(left, right, low, high, width, height);
  [paper.fillStyle, paper.textBaseline, paper.textAlign] = [theme.text, "middle", "right"];
  for (const value of ticks(low, high, 4)) paper.fillText(round(value), MARGIN.left - 6, place(left, value)[1]);
  [paper.textBaseline, paper.textAlign] = ["top", "center"];
  for (const value of ticks(left, right, 6)) paper.fillText(round(value), place(value, low)[0], height - MARGIN.bottom + 7);
  paper.strokeStyle = theme.ring;
  paper.strokeRect(MARGIN.left, MARGIN.top, width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom);
  paper.fillStyle = color;
  const size = x.length < 500 ? 3 : 1.6; // pixels
  for (let k = 0; k < x.length; k++) {
    const [across, down] = place(x[k], y[k]);
    paper.fillRect(across - 0.5 * size, down - 0.5 * size, size, size);
  }
}

function drawPath(paper, what, width, height, theme) {
  const place = scaled(what, width, height);
  paper.strokeStyle = theme.ring;
  stroke(paper, [[0.5 * width - 8, 0.5 * height], [0.5 * width + 8, 0.5 * height]]);
  stroke(paper, [[0.5 * width, 0.5 * height - 8], [0.5 * width, 0.5 * height + 8]]);
  [paper.strokeStyle, paper.lineWidth] = [what.color, 2];
  stroke(paper, what.path.map(place));
}

function caption(figure, { title, words: more = "", unit, series, path, power }) {
  const words = document.createElement("strong");
  const factor = power ? `10${[...String(power)].map((sign) => SUPERSCRIPTS[sign]).join("")} ` : "";
  words.textContent = unit && !path ? `${say(title)} [${factor}${say(unit)}]` : say(title);
  const legend = document.createElement("span");
  legend.className = "legend";
  for (const { name, color, dash = [] } of series?.length > 1 ? series : []) {
    const [item, swatch] = [document.createElement("span"), document.createElement("i")];
    swatch.style.background = swatchOf(color, dash);
    item.append(swatch, say(name));
    legend.append(item);
  }
  const quiet = document.createElement("span");
  quiet.className = "words";
  quiet.textContent = say(more);
  figure.lastChild.replaceChildren(words, quiet, legend);
  const kind = path ? say("with the point that moves") : series ? say("over time") : "";
  figure.firstChild.setAttribute("aria-label", `${[words.textContent, say(more), kind].filter(Boolean).join(", ")}.`);
}

/** Return the background of a legend's swatch, dashed as its curve is. */
function swatchOf(color, dash) {
  if (!dash.length) return color;
  let place = 0;
  const stops = dash.map((length, k) => {
    const [from, to] = [place, (place += length)];
    return `${k % 2 ? "transparent" : color} ${from}px ${to}px`;
  });
  return `repeating-linear-gradient(90deg, ${stops.join(", ")})`;
}

/** Return a plot with the power of ten that is taken out of its numbers, 0 for handy ones. */
function withPower(plot) {
  const most = Math.max(...range(plot.series).map(Math.abs));
  const handy = plot.unit === "°" || !(most > 0) || (most >= 1e-2 && most < 1e4);
  return { ...plot, power: handy ? 0 : Math.floor(Math.log10(most)) };
}

const round = (value, digits = 6) => String(Number(value.toPrecision(digits))).replace("-", "−");

function range(series) {
  let [low, high] = [Infinity, -Infinity];
  for (const { values } of series) {
    for (const value of values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  // what is constant but for rounding is drawn in the middle
  const around = high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)) ? 0.06 * (high - low) : 0.5 * Math.abs(high) || 1;
  return [low - around, high + around];
}

function placed(first, last, low, high, width, height) {
  const [across, down] = [width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom];
  return (time, value) => [
    MARGIN.left + ((time - first) / (last - first || 1)) * across,
    MARGIN.top + ((high - value) / (high - low)) * down,
  ];
}

/** Return round values inside a range. */
function ticks(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((digit) => digit * power >= rough) * power;
  const found = [];
  for (let k = Math.ceil(low / step); k * step <= high; k++) found.push(k * step);
  return found;
}

function stroke(paper, points) {
  paper.beginPath();
  points.forEach(([x, y], k) => (k ? paper.lineTo(x, y) : paper.moveTo(x, y)));
  paper.stroke();
}
