// Angles counted in turns: rates times times reduced to a fraction of a turn, their sines, and decay with all its digits.
import { upper } from "./double_double.js";

/** A time since the epoch: that itself. */
export const EPOCH = [0, 0, 0];

/** Return a double-double rate as two halves and a remainder, for exact products with times. */
export function splitRate([high, low]) {
  const half = upper(high);
  return [half, high - half, low];
}

/**
 * Reduce rate · time to a fraction of a turn: `into` becomes fraction, what the float leaves of it, and whole turns.
 *
 * The products of halves are exact, so each is reduced exactly.
 *
 * @param rate what `splitRate` gives [turns per time]
 * @param time in halves, and the rest where t − epoch is no double
 */
export function reducedPhase(rate, time, into) {
  const high = time[0];
  const low = time[1];
  const a = rate[0] * high;
  const b = rate[0] * low;
  const c = rate[1] * high;
  const na = Math.round(a);
  const nb = Math.round(b);
  const nc = Math.round(c);
  const d = rate[1] * low + rate[2] * (high + low) + (rate[0] + rate[1]) * time[2];
  // each remainder may reach half a turn: a plain sum would cost 1e-16 turns, and near the saddle 1e-13 of x
  const rb = b - nb;
  const rc = c - nc;
  const middle = rb + rc;
  const mt = middle - rb;
  const middleError = rb - (middle - mt) + (rc - mt);
  const ra = a - na;
  const fraction = ra + middle;
  const ft = fraction - ra;
  const error = ra - (fraction - ft) + (middle - ft);
  const more = Math.round(fraction);
  into[0] = fraction - more;
  into[1] = error + (middleError + d);
  into[2] = na + (nb + nc) + more;
}

/** Put sin 2πx and cos 2πx into the first two places, for |x| ≤ ½. */
export function sineCosine(x, into) {
  const t = Math.tan(x * Math.PI);
  const d = 2 / (t * t + 1);
  into[0] = t * d;
  into[1] = d - 1;
}

/** Return exp(−(x + rest)(high + low)) with the exponent's product exact in its leading part; `high` is half a double. */
export function exponentialDecay(x, rest, high, low) {
  const xh = upper(x);
  const xl = x - xh;
  const small = xh * low + xl * (high + low) + rest * high;
  return Math.exp(-(xh * high)) * (1 - small * (1 - 0.5 * small));
}

export const wrapped = (turns) => turns - Math.round(turns);
