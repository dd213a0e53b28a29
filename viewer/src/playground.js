// Ready-made motions to play with, each with a few words that point at what to watch and buttons that set it.
const element = (id) => document.getElementById(id);

export class Playground {
  /**
   * @param presets the motions: data of a page each, with a short title, and a story of steps {say, set}
   * @param open called with the one that is chosen
   * @param set called with the tables that a step sets
   */
  constructor(presets, open, set) {
    this.presets = presets;
    this.set = set;
    const root = element("playground");
    root.hidden = false;
    this.buttons = presets.map((preset, k) => {
      const button = document.createElement("button");
      Object.assign(button, { type: "button", textContent: preset.title });
      button.addEventListener("click", () => {
        this.choose(k);
        open(presets[k]);
      });
      return button;
    });
    element("presets").replaceChildren(...this.buttons);
  }

  /** Return which motion to begin with: the one that the address names, or the first. */
  first() {
    const named = new URLSearchParams(window.location.hash.replace(/^#/, "")).get("preset");
    const found = this.presets.findIndex(({ key }) => key === named);
    this.choose(Math.max(0, found));
    if (named && found < 0) this.tell(`The playground has no motion called ${named}; it has ${this.presets.map(({ key }) => key).join(", ")}.`);
    return Math.max(0, found);
  }

  tell(words) {
    const note = document.createElement("li");
    note.textContent = words;
    element("story").prepend(note);
  }

  choose(k) {
    this.chosen = this.presets[k].key;
    this.buttons.forEach((button, j) => button.setAttribute("aria-pressed", String(j === k)));
    element("story").replaceChildren(...this.presets[k].story.map(({ say, set, label }) => {
      const step = document.createElement("li");
      step.textContent = say;
      if (set) {
        const button = document.createElement("button");
        Object.assign(button, { type: "button", textContent: label ?? "Show it" });
        button.addEventListener("click", () => this.set(set));
        step.append(" ", button);
      }
      return step;
    }));
  }
}
