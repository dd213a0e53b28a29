// A setting in the page's address, so that a link shows the same motion: #spin.rate=12.5&body.moments=1,2,3&t=4
const LATER = 300; // ms after the last change that the address follows: browsers refuse more than some hundred in half a minute

export class Address {
  /**
   * @param seen returns the tables of what is seen now
   * @param follow called with the tables of an address that a person, or another page, has given
   */
  constructor(seen, follow) {
    this.seen = seen;
    window.addEventListener("hashchange", () => {
      if (window.location.hash.slice(1) !== this.fragment) follow(this.tables);
    });
  }

  /** The tables that the address names; none of an address without any. */
  get tables() {
    return fromFragment(window.location.hash) ?? {};
  }

  get fragment() {
    return asFragment(this.seen());
  }

  /** The whole address of what is seen; null in a frame that has none of its own. */
  get whole() {
    const { protocol, href } = window.location;
    if (protocol === "about:") return null;
    const fragment = this.fragment;
    return href.split("#")[0] + (fragment ? `#${fragment}` : "");
  }

  /** Follow soon, as while a slider moves. */
  changed() {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.write(), LATER);
  }

  /** Follow at once. */
  write() {
    clearTimeout(this.waiting);
    const { whole } = this;
    if (whole === null || whole === window.location.href) return;
    try {
      window.history.replaceState(null, "", whole);
    } catch {
      // a page inside a frame may have no say in its address
    }
  }
}

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
