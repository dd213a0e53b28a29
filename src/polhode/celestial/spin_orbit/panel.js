// A moon on its orbit, seen from above, far too large: how its long axis stands to the planet.
// Loaded before the page's own script, which hands over its tools.
(globalThis.polhodePanels ??= {}).orbit = (motion, data, theme, tools) => {
  const { Group, Mesh, MeshLambertMaterial, SphereGeometry, dot, line, newPanel, unpacked } = tools;
  const [MOON, PLANET] = [0.2, 0.1]; // sizes, in semi-major axes
  const ROOM = 0.55; // of the least distance, that the moon may fill; half as much the planet

  function orbitPanel(motion, data, theme) {
    const panel = newPanel(theme, { title: "Spin on the orbit", words: "seen from above; the moon is drawn large", radius: 1.3 });
    const { scene } = panel;
    const angles = unpacked(data.angle);
    const places = unpacked(data.place);
    const e = data.eccentricity;
    const size = Math.min(MOON, ROOM * (1 - e));
    const ellipse = [];
    for (let k = 0; k <= 256; k++) {
      const anomaly = (Math.PI * k) / 128;
      ellipse.push(Math.cos(anomaly) - e, Math.sqrt(1 - e * e) * Math.sin(anomaly), 0);
    }
    const planet = new Mesh(new SphereGeometry(Math.min(PLANET, 0.5 * ROOM * (1 - e)), 32, 24), new MeshLambertMaterial({ color: theme.axes[1] }));
    // (B − A)/C = ω0²/3 of a prolate ellipsoid gives its axes' ratio
    const flat = Math.min(data.asphericity ** 2 / 3, 0.9);
    const ratio = Math.max(Math.sqrt((1 - flat) / (1 + flat)), 0.35);
    const moon = new Group();
    const rock = new Mesh(new SphereGeometry(size, 48, 32), new MeshLambertMaterial({ color: theme.body }));
    rock.scale.set(1, ratio, ratio);
    const mark = dot(theme.motion, theme.ground, 0.14 * size);
    mark.position.set(size, 0, 0.1 * size);
    moon.add(rock, mark, line([-size, 0, size, 1.5 * size, 0, size], theme.motion, 2.5));
    const ray = line([0, 0, 0, 1, 0, 0], theme.ring, 1.2);
    scene.add(line(ellipse, theme.family, 1.4), planet, moon, ray);
    panel.flat = { wide: 1 + 1.7 * size, high: Math.sqrt(1 - e * e) + 1.7 * size, x: -e };
    panel.legend = [
      { color: theme.motion, text: "long axis" },
      { color: theme.axes[1], text: "planet" },
    ];
    panel.update = (now) => {
      const k = Math.floor(now.position);
      const part = now.position - k;
      const next = Math.min(k + 1, motion.count - 1);
      const mix = (values, width, j) => (1 - part) * values[width * k + j] + part * values[width * next + j];
      moon.position.set(mix(places, 2, 0), mix(places, 2, 1), 0);
      moon.rotation.set(0, 0, mix(angles, 1, 0));
      ray.geometry.setPositions([0, 0, 0, moon.position.x, moon.position.y, 0]);
    };
    panel.probe = () => ({ point: moon.position.toArray(), angle: moon.rotation.z });
    return panel;
  }
  return orbitPanel(motion, data, theme);
};
