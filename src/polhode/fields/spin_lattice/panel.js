// Spins on a lattice from above: arrows in the plane, coloured by the component towards the reader.
(globalThis.polhodePanels ??= {}).spins = (motion, data, theme, tools) => {
  const { Color, ConeGeometry, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3, newPanel, unpacked } = tools;
  const places = unpacked(data.place);
  const frames = unpacked(data.frames);
  const levels = unpacked(data.spins);
  const count = places.length / 2;
  const length = 0.85 * data.apart;
  const panel = newPanel(theme, { title: "Spins", words: "from above, red towards the reader", radius: 1.2 });
  const arrows = new InstancedMesh(new ConeGeometry(0.3 * length, length, 10), new MeshBasicMaterial(), count);
  arrows.frustumCulled = false;
  panel.scene.add(arrows);
  const [up, down, middle] = [new Color("#b2182b"), new Color("#2166ac"), new Color("#9a9a9a")];
  const along = new Vector3(0, 1, 0); // of a cone
  const [matrix, turn, spin, color, scale] = [new Matrix4(), new Quaternion(), new Vector3(), new Color(), new Vector3(1, 1, 1)];
  const reach = [0, 1].map((j) => places.reduce((most, x, k) => (k % 2 === j ? Math.max(most, Math.abs(x)) : most), 0));
  panel.legend = [
    { color: "#b2182b", text: "towards the reader" },
    { color: "#2166ac", text: "away" },
  ];
  panel.flat = { wide: reach[0] + 2 * length, high: reach[1] + 2 * length };
  panel.update = (now) => {
    let k = 0;
    while (k < frames.length - 2 && frames[k + 1] <= now.position) k++;
    const next = Math.min(k + 1, frames.length - 1);
    const part = next > k ? Math.min(1, (now.position - frames[k]) / (frames[next] - frames[k])) : 0;
    for (let n = 0; n < count; n++) {
      const at = (frame, j) => levels[3 * (count * frame + n) + j] / 127.5 - 1;
      const blended = [0, 1, 2].map((j) => (1 - part) * at(k, j) + part * at(next, j));
      spin.set(...blended).normalize();
      turn.setFromUnitVectors(along, spin);
      matrix.compose(new Vector3(places[2 * n], places[2 * n + 1], 0), turn, scale);
      arrows.setMatrixAt(n, matrix);
      color.copy(middle).lerp(spin.z > 0 ? up : down, Math.abs(spin.z) ** 0.7);
      arrows.setColorAt(n, color);
    }
    arrows.instanceMatrix.needsUpdate = true;
    if (arrows.instanceColor) arrows.instanceColor.needsUpdate = true;
  };
  panel.probe = () => ({ spins: count });
  return panel;
};
