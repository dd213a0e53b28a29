// The Wigner function of a quantum rotor's state on the sphere of L, with classical bodies that began as it did.
(globalThis.polhodePanels ??= {}).wigner = (motion, data, theme, tools) => {
  const { Vector3, circle, dot, endsLegend, mappedGlobe, newPanel, pairThrough, pieces, specks } = tools;
  const { solver } = motion;
  const { rows, columns } = solver.map;
  const { mesh, paint } = mappedGlobe(rows, columns);
  const levels = new Float32Array(rows * columns);
  const cloud = solver.cloud;
  const words = cloud.length ? "of the quantum state, and classical bodies that began as it did" : ["of the level {level}, and its polhodes", { level: solver.ladder[solver.level].name }];
  const panel = newPanel(theme, { title: "Wigner function", words, radius: 1.36 });
  // the spin's x, y, z are c, a, b
  mesh.geometry.rotateX(-Math.PI / 2).rotateY(-Math.PI / 2);
  panel.scene.add(mesh);
  for (const turned of [{}, { x: Math.PI / 2 }, { y: Math.PI / 2 }]) {
    const ring = circle(1.002, 0, theme.family);
    ring.rotation.set(turned.x ?? 0, turned.y ?? 0, 0);
    panel.scene.add(ring);
  }
  const raised = (points) => points.map((part) => 1.004 * part);
  if (!cloud.length) panel.scene.add(pieces(raised(pairThrough(motion.free, solver.direction)), theme.text, 2));
  const members = cloud.length ? specks(new Float32Array(3 * cloud.length), "#222222", 2.5) : null;
  if (members) panel.scene.add(members);
  const place = dot("#F0E442", "#222222", 0.03);
  panel.scene.add(place);
  const ends = [0, 1, 2].map((k) => new Vector3().setComponent(k, 1.12));
  panel.labels = () => ends.map((end, k) => ({ text: "abc"[k], color: theme.axes[k], place: end }));
  panel.legend = [...endsLegend(["negative", "positive"]), { color: "#F0E442", text: "classical L" }];
  let drawn = null;
  let largest = 0;
  const map = (time) => {
    const values = solver.map.of(solver.spinAt(time));
    largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    // rows of a globe go from the south pole to the north pole
    for (let r = 0; r < rows; r++) {
      for (let j = 0; j < columns; j++) levels[r * columns + j] = 127.5 + (127.5 * values[(rows - 1 - r) * columns + j]) / largest;
    }
    paint(levels);
    return values;
  };
  panel.update = (now) => {
    place.position.copy(now.momentum).normalize();
    if (drawn === now.time || (drawn !== null && !cloud.length)) return;
    drawn = now.time;
    map(now.time);
    if (!members) return;
    const points = members.geometry.getAttribute("position");
    cloud.forEach((member, k) => points.setXYZ(k, ...raised(member.at(now.time))));
    points.needsUpdate = true;
  };
  panel.probe = () => ({
    largest,
    rows,
    values: [...solver.map.of(solver.spinAt(drawn))],
    cloud: cloud.map((member) => member.at(drawn)),
    mean: solver.spin.mean(solver.spinAt(drawn)),
  });
  return panel;
};
