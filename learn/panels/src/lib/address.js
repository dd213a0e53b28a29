// The state in the address, so that a link shows what was seen: #energy=1.9&turn=0.6
import { declared, fromFragment, quoted } from "../../../../viewer/src/link.js";

/**
 * Return {values, refused}: what a link sets of a panel, and a sentence on each part that it does not take.
 *
 * @param rules by key, {allows(value) → the value or undefined, wants: what it must be}
 */
export function readAddress(hash, rules) {
  const { tables, refused } = fromFragment(hash);
  const values = {};
  for (const [key, value] of Object.entries(tables)) {
    try {
      const { allows, wants } = declared(rules, key, "setting");
      const allowed = allows(value);
      if (allowed === undefined) throw new RangeError(`${key} must be ${wants}; got ${quoted(value)}. The panel keeps its own value; mend the link.`);
      values[key] = allowed;
    } catch (error) {
      refused.push(error);
    }
  }
  return { values, refused: refused.map(({ message }) => message) };
}

/** Return the rule of numbers between bounds. */
export const between = (least, most, whole = false) => ({
  allows: (value) => (typeof value === "number" && value >= least && value <= most && (!whole || Number.isInteger(value)) ? value : undefined),
  wants: `a ${whole ? "whole " : ""}number from ${least} to ${most}`,
});

/** Return the fragment of values; those that are as at the start are left out, so that a link stays short. */
export function writeAddress(values, initial) {
  const changed = Object.entries(values).filter(([key, value]) => String(value) !== String(initial[key]));
  return changed.map(([key, value]) => `${key}=${[value].flat().map(encodeURIComponent).join(",")}`).join("&");
}
