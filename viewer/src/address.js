// A setting in the page's address, so that a link shows the same motion: #spin.rate=12.5&body.moments=1,2,3&t=4
/** Return tables in tables as text; numbers keep all their digits. */
export function asFragment(tables) {
  const parts = [];
  for (const [table, values] of Object.entries(tables)) {
    if (typeof values !== "object") parts.push(`${table}=${escaped(values)}`);
    else for (const [key, value] of Object.entries(values)) parts.push(`${table}.${key}=${escaped(value)}`);
  }
  return parts.join("&");
}

/** Return numbers as they are, for people to read, and words with everything escaped that an address has a use for. */
const escaped = (value) => [value].flat().map((one) => (typeof one === "number" ? String(one) : encodeURIComponent(one))).join(",");

/** Return the tables that a text names; null where it has none. */
export function fromFragment(text) {
  const tables = {};
  for (const part of text.replace(/^#/, "").split("&").filter(Boolean)) {
    const [name, ...rest] = part.split("=");
    let value;
    try {
      value = decodeURIComponent(rest.join("="));
    } catch {
      continue; // half an escape: not ours
    }
    const [table, key] = name.split(".");
    const read = value.includes(",") ? value.split(",").map(Number) : value !== "" && Number.isFinite(Number(value)) ? Number(value) : value;
    if ([read].flat().some((number) => typeof number === "number" && !Number.isFinite(number))) continue;
    if (key === undefined) tables[table] = read;
    else (tables[table] ??= {})[key] = read;
  }
  return Object.keys(tables).length ? tables : null;
}
