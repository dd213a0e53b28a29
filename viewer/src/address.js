// A setting in the page's address, so that a link shows the same motion: #spin.rate=12.5&body.moments=1,2,3&t=4
import { asFragment, fromFragment } from "./link.js";

const LATER = 300; // ms after the last change that the address follows: browsers refuse more than some hundred in half a minute

export class Address {
  /**
   * @param seen returns the tables of what is seen now
   * @param follow called with what an address says that a person, or another page, has given
   */
  constructor(seen, follow) {
    this.seen = seen;
    window.addEventListener("hashchange", () => {
      if (window.location.hash.slice(1) !== this.fragment) follow(this.read());
    });
  }

  /** Return the tables that the address names, and what of it cannot be read. */
  read() {
    return fromFragment(window.location.hash);
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
