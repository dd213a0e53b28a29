// A moon on its orbit, seen from above, far too large: how its long axis stands to the planet.
import { Group, Mesh, MeshLambertMaterial, SphereGeometry } from "three";
import { unpacked } from "../motion.js";
import { dot, line } from "../shapes.js";
import { newPanel } from "../stage.js";

const SIZE = 0.2; // of the moon, in semi-major axes

export function orbitPanel(motion, data, theme) {
  const panel = newPanel(theme, { title: "Spin on the orbit", words: "seen from above; the moon is drawn large", radius: 1.3 });
  const { scene } = panel;
  const angles = unpacked(data.angle);
  const places = unpacked(data.place);
  const e = data.eccentricity;
  const ellipse = [];
  for (let k = 0; k <= 256; k++) {
    const anomaly = (Math.PI * k) / 128;
    ellipse.push(Math.cos(anomaly) - e, Math.sqrt(1 - e * e) * Math.sin(anomaly), 0);
  }
  const planet = new Mesh(new SphereGeometry(0.1, 32, 24), new MeshLambertMaterial({ color: theme.axes[1] }));
  // (B − A)/C = ω0²/3 of a prolate ellipsoid gives its axes' ratio
  const flat = Math.min(data.asphericity ** 2 / 3, 0.9);
  const ratio = Math.max(Math.sqrt((1 - flat) / (1 + flat)), 0.35);
  const moon = new Group();
  const rock = new Mesh(new SphereGeometry(SIZE, 48, 32), new MeshLambertMaterial({ color: theme.body }));
  rock.scale.set(1, ratio, ratio);
  const mark = dot(theme.motion, theme.ground, 0.028);
  mark.position.set(SIZE, 0, 0.02);
  moon.add(rock, mark, line([-SIZE, 0, SIZE, 1.5 * SIZE, 0, SIZE], theme.motion, 2.5));
  const ray = line([0, 0, 0, 1, 0, 0], theme.ring, 1.2);
  scene.add(line(ellipse, theme.family, 1.4), planet, moon, ray);
  panel.flat = (camera, aspect) => {
    const distance = (1.45 + e) / Math.sin(0.22) / Math.min(1, aspect);
    camera.position.set(-e, 0, distance);
    camera.up.set(0, 1, 0);
    camera.aspect = aspect;
    camera.near = distance / 2;
    camera.far = 2 * distance;
    camera.lookAt(-e, 0, 0);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  };
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
