// Which of the pictures is the large one, and room that stays reserved, so that nothing moves under the pointer.
export class Views {
  /**
   * @param root element with the frames
   * @param changed called after another one has been made large
   */
  constructor(root, changed) {
    this.root = root;
    this.changed = changed;
    this.large = 0;
  }

  /** Take new frames, one for each picture, the first of them large. */
  take(types) {
    this.types = types;
    this.root.dataset.count = String(types.length);
    [...this.root.children].forEach((frame, k) => frame.querySelector(".enlarge").addEventListener("click", () => this.enlarge(k, true)));
    this.large = 0;
    this.mark();
  }

  /** The name of the large picture, for the address; null of the first, which is large at first. */
  get named() {
    return this.large ? this.types[this.large] : null;
  }

  /** Make a picture large, named or counted; whether there is one. The focus follows a press of its own button, which goes. */
  enlarge(which, pressed = false) {
    const k = typeof which === "number" ? which : this.types.indexOf(which);
    if (k < 0) return false;
    this.large = k;
    this.mark();
    if (pressed) this.root.children[k].querySelector("canvas").focus({ preventScroll: true });
    this.changed();
    return true;
  }

  mark() {
    [...this.root.children].forEach((frame, k) => frame.classList.toggle("large", k === this.large));
  }
}

/** Elements whose words come and go: each keeps the height that it once had, until another motion is shown. */
export class Room {
  constructor(elements) {
    this.elements = elements;
    window.addEventListener("resize", () => this.release());
  }

  keep() {
    for (const element of this.elements) {
      const { height } = element.getBoundingClientRect();
      if (height > parseFloat(element.style.minHeight || 0)) element.style.minHeight = `${height}px`;
    }
  }

  release() {
    for (const element of this.elements) element.style.minHeight = "";
  }
}
