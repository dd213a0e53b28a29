// Point vortices with their tracks, on a globe or in a plane; their sense by colour, their strength by size.
(globalThis.polhodePanels ??= {}).vortices = (motion, data, theme, tools) => {
  const { Vector3, circle, dot, drawUpTo, globe, newPanel, path, unpacked } = tools;
  const [LEAST, MOST] = [0.018, 0.045]; // radii of dots
  const places = unpacked(data.place);
  const strengths = unpacked(data.strength);
  const words = data.flat ? "in the plane, from above" : "on the sphere";
  const panel = newPanel(theme, { title: "Point vortices", words, radius: 1.3 });
  const colors = [theme.motion, theme.border];
  const own = (k) => places.subarray(3 * motion.count * k, 3 * motion.count * (k + 1));
  if (!data.flat) panel.scene.add(globe(theme), circle(1, 0, theme.family));
  const found = [...strengths].map((strength, k) => {
    const color = colors[strength > 0 ? 0 : 1];
    const trail = path(motion, new Float64Array(own(k)), color, data.count > 12 ? 1 : 1.8);
    const place = dot(color, theme.ground, LEAST + (MOST - LEAST) * Math.sqrt(Math.abs(strength)));
    panel.scene.add(trail, place);
    return { trail, place, points: own(k) };
  });
  panel.legend = [
    { color: colors[0], text: "anticlockwise" },
    ...([...strengths].some((x) => x < 0) ? [{ color: colors[1], text: "clockwise" }] : []),
  ];
  if (data.flat) panel.flat = { wide: 1.12, high: 1.12 };
  panel.update = (now) => {
    const k = Math.floor(now.position);
    const part = now.position - k;
    const next = Math.min(k + 1, motion.count - 1);
    for (const { trail, place, points } of found) {
      const [here, there] = [new Vector3().fromArray(points, 3 * k), new Vector3().fromArray(points, 3 * next)];
      place.position.copy(here).lerp(there, part);
      if (!data.flat) place.position.normalize();
      drawUpTo(motion, trail, k);
    }
  };
  panel.probe = () => ({ points: found.map(({ place }) => place.position.toArray()) });
  return panel;
};
