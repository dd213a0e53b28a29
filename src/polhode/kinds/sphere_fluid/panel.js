// The vorticity of a fluid, laid around a globe; between two maps it is blended.
(globalThis.polhodePanels ??= {}).vorticity = (motion, data, theme, tools) => {
  const { DataTexture, LinearFilter, Mesh, MeshBasicMaterial, SphereGeometry, circle, newPanel, unpacked } = tools;
  const { rows, columns } = data;
  const levels = unpacked(data.levels);
  const frames = unpacked(data.frames);
  const size = rows * columns;
  const ENDS = [[33, 102, 172], [178, 24, 43]]; // of the colours, blue for clockwise and red for anticlockwise
  const MIDDLE = 247;
  const colors = new Uint8Array(4 * 256);
  for (let level = 0; level < 256; level++) {
    const side = level < 127.5 ? 0 : 1;
    const share = Math.abs(level - 127.5) / 127.5;
    for (let j = 0; j < 3; j++) colors[4 * level + j] = Math.round(MIDDLE + (ENDS[side][j] - MIDDLE) * share ** 0.8);
    colors[4 * level + 3] = 255;
  }
  const pixels = new Uint8Array(4 * size);
  const texture = new DataTexture(pixels, columns, rows);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.colorSpace = "srgb";
  const geometry = new SphereGeometry(1, 96, 64);
  geometry.rotateX(Math.PI / 2); // poles along z,
  geometry.rotateZ(Math.PI); // and the map's edge at longitude zero
  const panel = newPanel(theme, { title: "Vorticity", words: "of the fluid against the sphere", radius: 1.3 });
  panel.scene.add(new Mesh(geometry, new MeshBasicMaterial({ map: texture })));
  for (const height of [-0.5, 0, 0.5]) panel.scene.add(circle(1.002 * Math.sqrt(1 - height * height), 1.002 * height, theme.family));
  panel.legend = [
    { color: "rgb(178, 24, 43)", text: "anticlockwise" },
    { color: "rgb(33, 102, 172)", text: "clockwise" },
  ];
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
    texture.needsUpdate = true;
  };
  panel.probe = () => ({ shown: drawn, pixels: [...pixels.subarray(0, 16)] });
  return panel;
};
