// The state in the address, so that a link shows what was seen: #energy=1.9&turn=0.6
import { fromFragment } from "../../../../viewer/src/address.js";

/** Return the values of a fragment that a panel has a use for; what it cannot read is left out. */
export function readAddress(hash, allowed) {
  const found = fromFragment(hash) ?? {};
  return Object.fromEntries(Object.entries(found).flatMap(([key, value]) => {
    const checked = allowed[key]?.(value);
    return checked === undefined ? [] : [[key, checked]];
  })); // prettier-ignore
}

/** Return the fragment of values; those that are as at the start are left out, so that a link stays short. */
export function writeAddress(values, initial) {
  const changed = Object.entries(values).filter(([key, value]) => String(value) !== String(initial[key]));
  return changed.map(([key, value]) => `${key}=${[value].flat().map(encodeURIComponent).join(",")}`).join("&");
}
