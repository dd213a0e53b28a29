// Phase space of a plasma: position to the right, velocity upwards, bright where electrons are.
(globalThis.polhodePanels ??= {}).phase_space = (motion, data, theme, tools) => {
  const { DataTexture, LinearFilter, Mesh, MeshBasicMaterial, PlaneGeometry, newPanel, unpacked } = tools;
  const { rows, columns } = data;
  const levels = unpacked(data.levels);
  const frames = unpacked(data.frames);
  const size = rows * columns;
  const STOPS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]]; // viridis
  const colors = new Uint8Array(4 * 256);
  for (let level = 0; level < 256; level++) {
    const place = (level / 255) * (STOPS.length - 1);
    const k = Math.min(Math.floor(place), STOPS.length - 2);
    for (let j = 0; j < 3; j++) colors[4 * level + j] = Math.round(STOPS[k][j] + (place - k) * (STOPS[k + 1][j] - STOPS[k][j]));
    colors[4 * level + 3] = 255;
  }
  const pixels = new Uint8Array(4 * size);
  const texture = new DataTexture(pixels, columns, rows);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.colorSpace = "srgb";
  const panel = newPanel(theme, { title: "Phase space", words: "position to the right, velocity upwards", radius: 1.2 });
  panel.scene.add(new Mesh(new PlaneGeometry(2.4, 1.9), new MeshBasicMaterial({ map: texture })));
  panel.legend = [
    { color: "rgb(253, 231, 37)", text: "many electrons" },
    { color: "rgb(68, 1, 84)", text: "few" },
  ];
  panel.flat = { wide: 1.25, high: 1 };
  let drawn = -1;
  panel.update = (now) => {
    let k = 0;
    while (k < frames.length - 1 && frames[k + 1] <= now.position) k++;
    if (k === drawn) return;
    drawn = k;
    for (let j = 0; j < size; j++) pixels.set(colors.subarray(4 * levels[size * k + j], 4 * levels[size * k + j] + 4), 4 * j);
    texture.needsUpdate = true;
  };
  panel.probe = () => ({ frame: drawn, pixels: [...pixels.subarray(0, 16)] });
  return panel;
};
