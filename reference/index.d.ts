// SPDX-License-Identifier: MIT
// Types of polhode.js. SI units; quaternions [w, x, y, z] take body to space; momentum is along the body's principal axes.

export type Vector = [number, number, number];
export type Quaternion = [number, number, number, number];

/** Attitude and angular momentum [kg m²/s, body axes] at one time. */
export interface State {
  attitude: Quaternion;
  momentum: Vector;
}

/** What a motion starts with. */
export interface Start {
  /** Principal moments [kg m²], positive; of a top (I1, I1, I3) about the pivot. */
  moments: readonly number[];
  /** Angular momentum at the epoch [kg m²/s, body axes]. */
  momentum: readonly number[];
  /** Unit quaternion at the epoch; the identity if left out. */
  attitude?: readonly number[];
  /** Time at which these hold [s]; 0 if left out. */
  epoch?: number;
}

/** The version of the package. */
export const version: string;

/** Torque-free motion of a rigid body; throws a RangeError for values that cannot be one. */
export class FreeMotion {
  constructor(start: Start);
  readonly moments: Vector;
  readonly momentumAtEpoch: Vector;
  readonly attitudeAtEpoch: Quaternion;
  readonly epoch: number;
  readonly energy: number;
  readonly momentumNorm: number;
  readonly regime: string;
  readonly modulus: number | null;
  readonly encircledAxis: number | null;
  readonly period: number | null;
  readonly precessionRate: number | null;
  readonly precessionPerPeriod: number | null;
  readonly flipInterval: number | null;
  readonly solidAngle: number | null;
  state(t: number): State;
  angularVelocity(t: number): Vector;
  along(count: number): Vector[];
}

/** A heavy symmetric top on a fixed point; `mgl` [N m] is its weight times the distance to the centre of mass. */
export class LagrangeMotion {
  constructor(start: Start & { mgl: number });
  readonly moments: Vector;
  readonly mgl: number;
  readonly momentumAtEpoch: Vector;
  readonly attitudeAtEpoch: Quaternion;
  readonly epoch: number;
  readonly energy: number;
  readonly verticalMomentum: number;
  readonly axialMomentum: number;
  readonly regime: string;
  readonly nutationLimits: [number, number];
  readonly nutationPeriod: number | null;
  readonly precessionPerPeriod: number | null;
  readonly spinPerPeriod: number | null;
  readonly precessionRate: number | null;
  readonly spinRate: number | null;
  state(t: number): State;
  angularVelocity(t: number): Vector;
}

export namespace quaternion {
  const identity: Quaternion;
  function multiply(p: readonly number[], q: readonly number[]): Quaternion;
  function conjugate(q: readonly number[]): Quaternion;
  function norm(q: readonly number[]): number;
  function normalize(q: readonly number[]): Quaternion;
  function rotate(q: readonly number[], v: readonly number[]): Vector;
  function rotateBack(q: readonly number[], v: readonly number[]): Vector;
  function asMatrix(q: readonly number[]): [Vector, Vector, Vector];
  function fromAxisAngle(axis: readonly number[], angle: number): Quaternion;
  function angleBetween(p: readonly number[], q: readonly number[]): number;
}
