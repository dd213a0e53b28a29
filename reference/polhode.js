// SPDX-License-Identifier: MIT
// How rigid bodies rotate, exactly at any time: the free body and the Lagrange top. No dependencies.
// Conventions are those of docs/conventions.md: quaternions [w, x, y, z] take body to space, everything is in SI units.
import * as quaternion from "./quaternion.js";

export { FreeMotion } from "./free_body.js";
export { LagrangeMotion } from "./lagrange_top.js";
export { quaternion };
