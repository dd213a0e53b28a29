// The surface of the momenta that have the motion's energy, over the sphere of |L|: an ellipsoid, which the sphere meets in
// the polhode. What lies far outside of the sphere is left out, as a slender body's ellipsoid would hide everything.
import { BufferAttribute, BufferGeometry, Mesh, MeshLambertMaterial } from "three";
import { GLOBE } from "../shapes.js";
import { isOn, switched } from "../switches.js";

const GLASS = 0.45; // opacity
const [ROWS, COLUMNS] = [72, 144];
const FARTHEST = 1.32; // radii of the sphere that the ellipsoid is drawn to
const ALIKE = 1.05; // largest moment over the smallest, below which sphere and ellipsoid cannot be told apart
const TURN = 2 * Math.PI;

/**
 * Return the ellipsoid ½ (L − h)·I⁻¹(L − h) = E as `object`, its `entry` in the legend and `show(now)`; null where the page
 * does not know I, or the energy is not of this form.
 */
export function energySurface(motion, data, theme) {
  const moments = motion.free ?? (motion.solver?.mgl === undefined ? motion.solver?.moments : null);
  if (!moments || data.families || !(motion.at(0).momentum.length() > 0)) return null;
  const inner = motion.solver?.rotor ?? [0, 0, 0];
  if (Math.max(...moments) < ALIKE * Math.min(...moments) && !inner.some(Boolean)) return null;
  const material = new MeshLambertMaterial({ color: theme.energy, transparent: true, opacity: GLASS, side: 2, depthWrite: false });
  const object = new Mesh(emptyGrid(), material);
  object.renderOrder = 2;
  object.frustumCulled = false;
  const entry = switched("energy", theme.energy, "ellipsoid of the same energy", false);
  let drawn = null;
  const show = (now) => {
    object.visible = isOn(entry) && now.momentum.length() > 0;
    if (!object.visible) return false;
    const found = ellipsoidOf(moments, inner, now.momentum);
    if (String([found.axes, found.center]) !== String(drawn && [drawn.axes, drawn.center])) fill(object.geometry, found);
    drawn = found;
    return true;
  };
  return { object, entry, show, probe: () => ({ ...drawn, shown: object.visible, corners: [...object.geometry.attributes.position.array] }) };
}

/** Return semi-axes and centre in units of |L|. */
function ellipsoidOf(moments, inner, momentum) {
  const size = momentum.length();
  const twice = momentum.toArray().reduce((sum, value, k) => sum + (value - inner[k]) ** 2 / moments[k], 0);
  return { axes: moments.map((moment) => Math.sqrt(twice * moment) / size), center: inner.map((value) => value / size) };
}

function emptyGrid() {
  const geometry = new BufferGeometry();
  for (const name of ["position", "normal"]) geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * (ROWS + 1) * (COLUMNS + 1)), 3));
  return geometry;
}

/** Place the grid: along rays from the sphere's middle where that is inside, so that it is fine near the sphere. */
function fill(geometry, { axes, center }) {
  const { position, normal } = geometry.attributes;
  const centred = !center.some(Boolean);
  const kept = [];
  for (let i = 0; i <= ROWS; i++) {
    for (let j = 0; j <= COLUMNS; j++) {
      const [down, around] = [(Math.PI * i) / ROWS, (TURN * j) / COLUMNS];
      const unit = [Math.sin(down) * Math.cos(around), Math.sin(down) * Math.sin(around), Math.cos(down)];
      const reach = centred ? 1 / Math.hypot(...unit.map((part, k) => part / axes[k])) : 0;
      const at = unit.map((part, k) => (centred ? Math.min(reach, FARTHEST) * part : center[k] + axes[k] * part));
      const out = at.map((part, k) => (part - center[k]) / axes[k] ** 2);
      const length = Math.hypot(...out) || 1;
      const k = i * (COLUMNS + 1) + j;
      position.setXYZ(k, ...at.map((part) => GLOBE * part)); // as the drawn sphere is smaller by so much
      normal.setXYZ(k, ...out.map((part) => part / length));
      kept.push(centred ? reach <= FARTHEST : Math.hypot(...at) <= FARTHEST);
    }
  }
  const faces = [];
  for (let i = 0; i < ROWS; i++) {
    for (let j = 0; j < COLUMNS; j++) {
      const a = i * (COLUMNS + 1) + j;
      const [b, c, d] = [a + 1, a + COLUMNS + 2, a + COLUMNS + 1];
      if ([a, b, c, d][centred ? "some" : "every"]((k) => kept[k])) faces.push(a, d, c, a, c, b);
    }
  }
  geometry.setIndex(faces);
  position.needsUpdate = true;
  normal.needsUpdate = true;
}
