// Maps of a function laid around a globe; between two of them it is blended.
import { DataTexture, LinearFilter, Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import { unpacked } from "./motion.js";
import { circle } from "./shapes.js";
import { newPanel } from "./stage.js";

const ENDS = [[33, 102, 172], [178, 24, 43]]; // of the colours, blue for negative and red for positive
const MIDDLE = 247;

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

/** Return a panel of maps: `levels` of frames, and where given `lines`, bands of another function whose borders show. */
export function mapGlobe(data, theme, { title, words, legend }) {
  const { rows, columns } = data;
  const levels = unpacked(data.levels);
  const lines = data.lines ? unpacked(data.lines) : null;
  const frames = unpacked(data.frames);
  const size = rows * columns;
  const colors = palette();
  const pixels = new Uint8Array(4 * size);
  const texture = new DataTexture(pixels, columns, rows);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.colorSpace = "srgb";
  const geometry = new SphereGeometry(1, 96, 64);
  geometry.rotateX(Math.PI / 2); // poles along z,
  geometry.rotateZ(Math.PI); // and the map's edge at longitude zero
  const panel = newPanel(theme, { title, words, radius: 1.3 });
  panel.scene.add(new Mesh(geometry, new MeshBasicMaterial({ map: texture })));
  for (const height of [-0.5, 0, 0.5]) panel.scene.add(circle(1.002 * Math.sqrt(1 - height * height), 1.002 * height, theme.family));
  panel.legend = [
    { color: `rgb(${ENDS[1].join(", ")})`, text: legend[1] },
    { color: `rgb(${ENDS[0].join(", ")})`, text: legend[0] },
  ];
  const darken = (start) => {
    for (let j = 0; j < size; j++) {
      const right = j % columns === columns - 1 ? j + 1 - columns : j + 1;
      const above = j + columns < size ? j + columns : j;
      if (lines[start + j] === lines[start + right] && lines[start + j] === lines[start + above]) continue;
      for (let i = 0; i < 3; i++) pixels[4 * j + i] *= 0.35;
    }
  };
  let drawn = -1;
  panel.update = (now) => {
    if (now.position === drawn) return;
    drawn = now.position;
    let k = 0;
    while (k < frames.length - 2 && frames[k + 1] <= now.position) k++;
    const next = Math.min(k + 1, frames.length - 1);
    const part = next > k ? Math.min(1, (now.position - frames[k]) / (frames[next] - frames[k])) : 0;
    for (let j = 0; j < size; j++) {
      const level = Math.round((1 - part) * levels[size * k + j] + part * levels[size * next + j]);
      pixels.set(colors.subarray(4 * level, 4 * level + 4), 4 * j);
    }
    if (lines) darken(size * (part < 0.5 ? k : next));
    texture.needsUpdate = true;
  };
  panel.probe = () => ({ shown: drawn, pixels: [...pixels.subarray(0, 16)] });
  return panel;
}
