// What the page can set and solve itself, by the name of the solver.
import * as FreeMotion from "./free_body.js";
import * as LagrangeMotion from "./lagrange_top.js";

export const SETTINGS = { FreeMotion, LagrangeMotion };
