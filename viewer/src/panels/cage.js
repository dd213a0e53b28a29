// The frame that a gyroscope's wheel turns in: two rings about the axle, which lean with it and do not spin.
import { Group, Matrix4, Mesh, MeshPhongMaterial, TorusGeometry, Vector3 } from "three";

const THICKNESS = 0.035; // of the rings, over their radius

/**
 * Return the frame as `object`, and `turn(axis)` that leans it along a vector from the pivot.
 *
 * @param data cage: its radius and how far its centre is along the axis, in units of the body's size
 */
export function cageOf({ cage: { radius, center } }, theme) {
  const object = new Group();
  const material = new MeshPhongMaterial({ color: theme.edge, specular: "#ffffff", shininess: 60 });
  const ring = () => new Mesh(new TorusGeometry(radius, THICKNESS * radius, 12, 96), material);
  const [along, across] = [ring(), ring()];
  along.rotation.y = Math.PI / 2; // in the plane of the axle and the vertical
  for (const found of [along, across]) found.position.z = center;
  object.add(along, across);
  const turn = (axis) => {
    const z = axis.clone().normalize();
    const side = new Vector3(0, 0, 1).cross(z);
    const y = side.lengthSq() > 1e-12 ? side.normalize() : new Vector3(0, 1, 0);
    object.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(y, z.clone().cross(y), z));
    object.updateMatrix();
  };
  return { object, turn };
}
