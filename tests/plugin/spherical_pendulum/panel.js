// A mass on a rod; lengths are in rods.
(globalThis.polhodePanels ??= {}).pendulum = (motion, data, theme, tools) => {
  const { dot, drawUpTo, line, newPanel, path, unpacked } = tools;
  const places = unpacked(data.place);
  const panel = newPanel(theme, { title: "The pendulum", words: "with the path of its mass", radius: 1.4 });
  const rod = line([0, 0, 0, 0, 0, -1], theme.edge, 2);
  const mass = dot(theme.motion, theme.ground, 0.08);
  const trail = path(motion, new Float64Array(places), theme.motion, 1.6);
  panel.scene.add(rod, mass, trail);
  panel.legend = [{ color: theme.motion, text: "mass" }];
  panel.update = (now) => {
    const k = Math.round(now.position);
    mass.position.set(places[3 * k], places[3 * k + 1], places[3 * k + 2]);
    rod.geometry.setPositions([0, 0, 0, ...mass.position.toArray()]);
    drawUpTo(motion, trail, k);
  };
  panel.probe = () => ({ point: mass.position.toArray() });
  return panel;
};
