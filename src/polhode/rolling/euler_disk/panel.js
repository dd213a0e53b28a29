// A disk rolling on a plane, with the path of its contact and of its centre. Lengths are in radii.
// Loaded before the page's own script, which hands over its tools.
(globalThis.polhodePanels ??= {}).disk = (motion, data, theme, tools) => {
  const { CylinderGeometry, Group, Mesh, MeshLambertMaterial, Vector3, contactSound, dot, drawUpTo, floor, line, newPanel, path, unpacked } = tools;
  const LARGEST = 7; // radii: a path wider than that is followed instead of shown whole
  const THINNEST = 0.02;

  function diskPanel(motion, data, theme) {
    const solver = motion.endless ? motion.solver : null; // of a disk that was set on the page
    const [contacts, centers] = solver ? followed(motion) : [unpacked(data.contact), unpacked(data.center)];
    if (solver) data = { ...data, radius: solver.radius, thickness: 2 * solver.halfThickness };
    const touched = new Float64Array(3 * motion.count);
    const middle = new Float64Array(3 * motion.count);
    for (let k = 0; k < motion.count; k++) {
      touched.set([contacts[2 * k] / data.radius, contacts[2 * k + 1] / data.radius, 0], 3 * k);
      middle.set([0, 1, 2].map((j) => (j < 2 ? centers[3 * k + j] / data.radius : 0)), 3 * k);
    }
    const [home, reach] = extent(touched);
    const follows = reach > LARGEST;
    const panel = newPanel(theme, {
      title: "The rolling disk",
      words: "with the path of its contact",
      radius: follows ? 3 : Math.max(1.7, 1.15 * reach),
      target: home.clone(),
    });
    const { scene } = panel;
    const ground = floor(follows ? 1.6 * reach : Math.max(1.9, 1.25 * reach), 0, theme, follows ? 12 : 4);
    ground.position.set(home.x, home.y, 0);
    const coin = coinOf(data, theme);
    const trail = path(motion, touched, theme.motion, 2.4);
    const heart = path(motion, middle, theme.border, 1.8);
    const touch = dot(theme.motion, theme.ground, 0.035);
    scene.add(ground, coin, trail, heart, touch);
    panel.legend = [
      { color: theme.motion, text: "contact" },
      { color: theme.border, text: "below the centre" },
      { text: "sound of the contact", press: () => contactSound.toggle(), pressed: () => contactSound.on },
    ];
    const rates = contactRates(motion);
    let heard = null; // a picture drawn again is silent
    panel.update = (now) => {
      const k = Math.floor(now.position);
      const part = now.position - k;
      const next = Math.min(k + 1, motion.count - 1);
      const mix = (values, width, j) => (1 - part) * values[width * k + j] + part * values[width * next + j];
      coin.quaternion.copy(now.attitude);
      coin.position.set(...[0, 1, 2].map((j) => mix(centers, 3, j) / data.radius));
      touch.position.set(mix(touched, 3, 0), mix(touched, 3, 1), 0);
      if (follows) panel.target.set(touch.position.x, touch.position.y, 0.4);
      for (const found of [trail, heart]) drawUpTo(motion, found, k);
      if (now.time !== heard) contactSound.follow(mix(rates, 1, 0));
      heard = now.time;
    };
    panel.probe = () => {
      coin.updateWorldMatrix(true, true);
      return { coin: [...coin.matrixWorld.elements], half: data.thickness / data.radius / 2, point: touch.position.toArray(), path: [...touched], sound: contactSound.probe() };
    };
    return panel;
  }

  /** Return the contacts and the centres at the motion's times. */
  function followed(motion) {
    const [contacts, centers] = [new Float64Array(2 * motion.count), new Float64Array(3 * motion.count)];
    motion.times.forEach((time, k) => {
      const { contact, center } = motion.solver.state(time);
      contacts.set(contact, 2 * k);
      centers.set(center, 3 * k);
    });
    return [contacts, centers];
  }

  /** Return how often the contact goes round per second at the motion's times: as the normal of the face does. */
  function contactRates(motion) {
    const found = new Float64Array(motion.count);
    const normal = (k) => new Vector3(0, 0, 1).applyQuaternion(motion.attitude(k));
    for (let k = 0; k < motion.count; k++) {
      const [before, after] = [Math.max(0, k - 1), Math.min(motion.count - 1, k + 1)];
      const [a, b] = [normal(before), normal(after)];
      const turned = Math.atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
      found[k] = after > before ? Math.abs(turned) / (2 * Math.PI * (motion.times[after] - motion.times[before]) || Infinity) : 0;
    }
    return found;
  }

  /** Return a coin of radius one about its third axis, with a mark on its faces that shows its turning. */
  function coinOf(data, theme) {
    const height = Math.max(data.thickness / data.radius, THINNEST);
    const side = new MeshLambertMaterial({ color: theme.edge });
    const face = new MeshLambertMaterial({ color: theme.body });
    const geometry = new CylinderGeometry(1, 1, height, 96);
    geometry.rotateX(Math.PI / 2);
    const found = new Group().add(new Mesh(geometry, [side, face, face]));
    const inlay = new MeshLambertMaterial({ color: theme.axes[1] });
    for (const turn of [0, Math.PI]) {
      const sector = new CylinderGeometry(0.86, 0.86, height + 0.006, 24, 1, false, turn, Math.PI / 2);
      sector.rotateX(Math.PI / 2);
      found.add(new Mesh(sector, inlay));
    }
    for (const z of [height / 2 + 0.004, -height / 2 - 0.004]) {
      const rim = [];
      for (let k = 0; k <= 64; k++) rim.push(0.86 * Math.cos((Math.PI * k) / 32), 0.86 * Math.sin((Math.PI * k) / 32), z);
      found.add(line(rim, theme.edge, 1.2), line([0.3, 0, z, 0.86, 0, z], theme.axes[1], 4), line([-0.1, 0, z, 0.1, 0, z], theme.edge, 1.5));
    }
    return found;
  }

  /** Return the middle of a path and how far it goes from there. */
  function extent(points) {
    const low = new Vector3(Infinity, Infinity, 0);
    const high = new Vector3(-Infinity, -Infinity, 0);
    for (let k = 0; k < points.length; k += 3) {
      const place = new Vector3(points[k], points[k + 1], 0);
      low.min(place);
      high.max(place);
    }
    const home = low.clone().add(high).multiplyScalar(0.5);
    return [home, 0.5 * high.distanceTo(low)];
  }
  return diskPanel(motion, data, theme);
};
