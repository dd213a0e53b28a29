// Maps of a function laid around a globe; between two of them it is blended.
import { DataTexture, LinearFilter, Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import { unpacked } from "./motion.js";
import { circle } from "./shapes.js";
import { newPanel } from "./stage.js";

const ENDS = [[33, 102, 172], [178, 24, 43]]; // of the colours, blue for negative and red for positive
const MIDDLE = 247;
const FINER = 6; // pixels a point of the map, along each side, where lines are drawn

function palette() {
  const colors = new Uint8Array(4 * 256);
  for (let level = 0; level < 256; level++) {
    const side = level < 127.5 ? 0 : 1;
    const share = Math.abs(level - 127.5) / 127.5;
    for (let j = 0; j < 3; j++) colors[4 * level + j] = Math.round(MIDDLE + (ENDS[side][j] - MIDDLE) * share ** 0.8);
    colors[4 * level + 3] = 255;
  }
  return colors;
}

/** Return a function that fills `found`, `scale` times as fine as a map, between its points; the map closes eastward. */
function refining(rows, columns, scale) {
  const wide = columns * scale;
  const places = (count, length, closes) =>
    Array.from({ length: count }, (_, j) => {
      const at = (j + 0.5) / scale - 0.5;
      const low = Math.floor(at);
      const within = (k) => (closes ? (k + length) % length : Math.min(Math.max(k, 0), length - 1));
      return [within(low), within(low + 1), at - low];
    });
  const across = places(wide, columns, true);
  const up = places(rows * scale, rows, false);
  return (map, start, found) => {
    up.forEach(([below, above, high], i) => {
      const first = start + below * columns;
      const second = start + above * columns;
      for (let j = 0; j < wide; j++) {
        const [left, right, far] = across[j];
        const lower = map[first + left] + far * (map[first + right] - map[first + left]);
        const upper = map[second + left] + far * (map[second + right] - map[second + left]);
        found[i * wide + j] = lower + high * (upper - lower);
      }
    });
  };
}

/**
 * Return a sphere of a map's points: `mesh`, and `paint(levels, darker)`, which colours it by levels from 0 to 255.
 *
 * Rows go from the south pole to the north pole, columns eastward from longitude 0; `darker` says of a point's index
 * whether a line runs through it.
 */
export function mappedGlobe(rows, columns) {
  const size = rows * columns;
  const colors = palette();
  const pixels = new Uint8Array(4 * size);
  const texture = new DataTexture(pixels, columns, rows);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.colorSpace = "srgb";
  const geometry = new SphereGeometry(1, 96, 64);
  geometry.rotateX(Math.PI / 2); // poles along z,
  geometry.rotateZ(Math.PI); // and the map's edge at longitude zero
  const mesh = new Mesh(geometry, new MeshBasicMaterial({ map: texture }));
  const paint = (levels, darker = null) => {
    for (let j = 0; j < size; j++) {
      const level = Math.round(levels[j]);
      pixels.set(colors.subarray(4 * level, 4 * level + 4), 4 * j);
      if (darker?.(j)) for (let i = 0; i < 3; i++) pixels[4 * j + i] *= 0.35;
    }
    texture.needsUpdate = true;
  };
  return { mesh, paint, pixels };
}

/** Return what the two ends of the colours mean. */
export const endsLegend = (legend) => [
  { color: `rgb(${ENDS[1].join(", ")})`, text: legend[1] },
  { color: `rgb(${ENDS[0].join(", ")})`, text: legend[0] },
];

/** Return a panel of maps: `levels` of frames, and where given `lines` of another function, drawn between its `bands`. */
export function mapGlobe(data, theme, { title, words, legend }) {
  const scale = data.lines ? FINER : 1;
  const [rows, columns] = [data.rows * scale, data.columns * scale];
  const levels = unpacked(data.levels);
  const lines = data.lines ? unpacked(data.lines) : null;
  const frames = unpacked(data.frames);
  const [own, size] = [data.rows * data.columns, rows * columns];
  const refined = refining(data.rows, data.columns, scale);
  const { mesh, paint, pixels } = mappedGlobe(rows, columns);
  const [before, after, banded] = [new Float32Array(size), new Float32Array(size), new Uint8Array(size)];
  const panel = newPanel(theme, { title, words, radius: 1.3 });
  panel.scene.add(mesh);
  for (const height of [-0.5, 0, 0.5]) panel.scene.add(circle(1.002 * Math.sqrt(1 - height * height), 1.002 * height, theme.family));
  panel.legend = endsLegend(legend);
  const blend = (map, k, next, part) => {
    refined(map, own * k, before);
    if (part === 0) return;
    refined(map, own * next, after);
    for (let j = 0; j < size; j++) before[j] += part * (after[j] - before[j]);
  };
  const onLine = (j) => {
    const right = j % columns === columns - 1 ? j + 1 - columns : j + 1;
    const above = j + columns < size ? j + columns : j;
    return banded[j] !== banded[right] || banded[j] !== banded[above];
  };
  let drawn = -1;
  panel.update = (now) => {
    if (now.position === drawn) return;
    drawn = now.position;
    let k = 0;
    while (k < frames.length - 2 && frames[k + 1] <= now.position) k++;
    const next = Math.min(k + 1, frames.length - 1);
    const part = next > k ? Math.min(1, (now.position - frames[k]) / (frames[next] - frames[k])) : 0;
    if (lines) {
      blend(lines, k, next, part);
      for (let j = 0; j < size; j++) banded[j] = Math.floor((before[j] / 256) * data.bands);
    }
    blend(levels, k, next, part);
    paint(before, lines && onLine);
  };
  panel.probe = () => ({ shown: drawn, pixels: [...pixels.subarray(0, 16)] });
  return panel;
}
