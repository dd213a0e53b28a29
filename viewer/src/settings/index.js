// What the page can set and solve itself, by the name of the solver.
import * as DampedBody from "./damped_body.js";
import * as EulerDisk from "./euler_disk.js";
import * as FreeMotion from "./free_body.js";
import * as Gyrostat from "./gyrostat.js";
import * as HeavyTop from "./heavy_top.js";
import * as LagrangeMotion from "./lagrange_top.js";
import * as QuantumRotor from "./quantum_rotor.js";

export const SETTINGS = { DampedBody, EulerDisk, FreeMotion, Gyrostat, HeavyTop, LagrangeMotion, QuantumRotor };
