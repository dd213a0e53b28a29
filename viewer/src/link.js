// What a link says after its #, for pages and panels alike. Links come from anywhere: names and numbers are checked here.
const LARGEST = 1e100; // of numbers in SI, and one over it the smallest but zero, as in a spec: their squares are doubles too
const QUOTED = 60; // characters of what came that a sentence repeats

/** What a number of a link, or of `set`, must be. */
export const NUMBER = `zero or of a size from ${1 / LARGEST} to ${LARGEST}`;

/** Whether a value is a number that a page can compute with. */
export const isInRange = (value) => value === 0 || (typeof value === "number" && Math.abs(value) >= 1 / LARGEST && Math.abs(value) <= LARGEST);

/** Return a value as a sentence repeats it. */
export function quoted(value) {
  const text = String(JSON.stringify(value, (_, one) => (typeof one === "number" && !Number.isFinite(one) ? String(one) : one)));
  return text.length > QUOTED ? `${text.slice(0, QUOTED)}…` : text;
}

/** Return what a table declares under a name; throw a RangeError for names that it only inherits or does not have. */
export function declared(table, name, what, within = "") {
  if (Object.hasOwn(table, name)) return table[name];
  throw new RangeError(`There is no ${what} ${(within + name).slice(0, QUOTED)} here; there are ${Object.keys(table).join(", ")}.`);
}

/** Return tables as text; numbers keep all their digits. */
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

/**
 * Return {tables, refused}: what a text names, in tables that inherit nothing, and errors that say what cannot be read.
 *
 * "#spin.rate=2&t=4" gives {spin: {rate: 2}, t: 4}. Which names and values have a use is for those to say who use them.
 */
export function fromFragment(text) {
  const tables = Object.create(null);
  const refused = [];
  for (const part of text.replace(/^#/, "").split("&").filter(Boolean)) {
    try {
      take(tables, part);
    } catch (error) {
      refused.push(error);
    }
  }
  return { tables, refused };
}

function take(tables, part) {
  const [name, ...rest] = part.split("=");
  const [table, key, ...more] = name.split(".");
  if (!table || key === "" || more.length) throw new RangeError(`The link must name what it sets, as in spin.rate=2; got ${quoted(part)}. Leave that out.`);
  const value = valueOf(name, rest.join("="));
  if (key === undefined) {
    tables[table] = value;
    return;
  }
  const found = (tables[table] ??= Object.create(null));
  if (typeof found !== "object" || Array.isArray(found)) throw new RangeError(`${table} must be a value or a table; got both in the link. Leave out ${table}, or ${quoted(name)}.`);
  found[key] = value;
}

/** Return the number, the list of numbers or the word that stands after a name. */
function valueOf(name, raw) {
  let text;
  try {
    text = decodeURIComponent(raw);
  } catch {
    throw new RangeError(`${name.slice(0, QUOTED)} must have whole escapes like %20; got ${quoted(raw)}. Write the value without %.`);
  }
  const numbers = text.split(",").map((one) => (one.trim() === "" ? NaN : Number(one)));
  if (numbers.length === 1 && !Number.isFinite(numbers[0])) return text; // a word
  if (numbers.every(isInRange)) return numbers.length === 1 ? numbers[0] : numbers;
  const wanted = numbers.length === 1 ? "" : "numbers between commas, each ";
  throw new RangeError(`${name.slice(0, QUOTED)} must be ${wanted}${NUMBER}; got ${quoted(text)}. Check the number, which is in SI units.`);
}
