// Motions that have no closed form, by steps short enough that their invariants hold to 1e-11 over hundreds of turns.
export { DampedBody } from "./damped_body.js";
export { EulerDisk } from "./euler_disk.js";
export { Gyrostat, TorquedGyrostat } from "./gyrostat.js";
export { HeavyTop } from "./heavy_top.js";
export { Stepped } from "./integrate.js";
