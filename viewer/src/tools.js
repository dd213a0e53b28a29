// What scripts that bring a picture of their own are given to draw it with.
export {
  BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DataTexture,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  LinearFilter,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
export { endsLegend, mapGlobe, mappedGlobe } from "./map_globe.js";
export { unpacked } from "./motion.js";
export { pairThrough, polhodeThrough } from "./polhodes.js";
export { circle, dot, drawUpTo, floor, globe, line, path, pieces, specks } from "./shapes.js";
export { decimal, say } from "./say.js";
export { contactSound } from "./sound.js";
export { newPanel } from "./stage.js";
