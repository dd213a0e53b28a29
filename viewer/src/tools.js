// What scripts that bring a picture of their own are given to draw it with.
export {
  BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshLambertMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
export { unpacked } from "./motion.js";
export { circle, dot, drawUpTo, floor, globe, line, path } from "./shapes.js";
export { newPanel } from "./stage.js";
