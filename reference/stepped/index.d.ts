// SPDX-License-Identifier: MIT
// Types of the motions without a closed form; README.md beside this file lists what each constructor takes.
import type { Quaternion, Start, State, Vector } from "../index.js";

/** What a stepped motion has at one time; a balance is {value, received}, whose difference is constant. */
export interface SteppedState extends State {
  velocity: Vector;
  energy: number;
  invariants: Record<string, number>;
  balances?: Record<string, { value: number; received: number }>;
  [more: string]: unknown;
}

declare class SteppedMotion {
  state(t: number): SteppedState;
}

export class HeavyTop extends SteppedMotion {
  constructor(start: Start & { mgl: number; axis: readonly number[] });
}
export class Gyrostat extends SteppedMotion {
  constructor(start: Start & { rotor: readonly number[]; [more: string]: unknown });
}
export class TorquedGyrostat extends SteppedMotion {
  constructor(start: Start & { axis: readonly number[]; rotor_moment: number; torque: number; rotor_momentum: number });
}
export class DampedBody extends SteppedMotion {
  constructor(start: Start & { [more: string]: unknown });
}
export class EulerDisk extends SteppedMotion {
  constructor(given: { [name: string]: unknown });
}
export type { Quaternion, Vector };
