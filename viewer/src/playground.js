// Ready-made motions to play with, each with a few sentences that point at what to watch and have buttons in them.
import { say } from "./say.js";

const element = (id) => document.getElementById(id);

export class Playground {
  /**
   * @param presets the motions: data of a page each, with a short title, and a story of steps {say, set, view, label}
   * @param open called with the one that is chosen
   * @param act called with the step whose button is pressed
   */
  constructor(presets, open, act) {
    this.presets = presets;
    this.act = act;
    element("playground").hidden = false;
    document.documentElement.dataset.playground = "";
    this.buttons = presets.map((preset, k) => {
      const button = document.createElement("button");
      button.type = "button";
      button.addEventListener("click", () => open(this.choose(k)));
      return button;
    });
    element("presets").replaceChildren(...this.buttons);
    this.write();
  }

  /** Write the titles, and the story that is told, in the language that is spoken. */
  write() {
    this.buttons.forEach((button, k) => (button.textContent = say(this.presets[k].title)));
    const shown = this.buttons.findIndex((button) => button.getAttribute("aria-pressed") === "true");
    if (shown >= 0) this.choose(shown);
  }

  /** Return the motion of a name, or the first, and say so where the name is wrong. */
  find(named) {
    const found = this.presets.findIndex(({ key }) => key === named);
    const chosen = this.choose(Math.max(0, found));
    const [strip, button] = [element("presets"), this.buttons[Math.max(0, found)]]; // a row that scrolls on a phone
    strip.scrollLeft += button.getBoundingClientRect().left - 0.5 * (strip.clientWidth - button.offsetWidth);
    if (named && found < 0) this.tell(say("The playground has no motion called {named}; it has {keys}.", { named: String(named), keys: this.presets.map(({ key }) => key).join(", ") }));
    return chosen;
  }

  tell(words) {
    const note = document.createElement("li");
    note.textContent = words;
    element("story").prepend(note);
  }

  choose(k) {
    this.buttons.forEach((button, j) => button.setAttribute("aria-pressed", String(j === k)));
    element("story").replaceChildren(...this.presets[k].story.map((step) => this.sentence(step)));
    return this.presets[k];
  }

  /** Return a sentence with its button: the words in brackets, or, of a sentence without, its label at the end. */
  sentence(step) {
    const line = document.createElement("li");
    const told = say(step.say);
    const [, before, words, after] = /^(.*?)\[(.+?)\](.*)$/s.exec(told) ?? [null, `${told} `, step.set && say(step.label ?? "Show it"), ""];
    line.append(before);
    if (!words) return line;
    const button = document.createElement("button");
    Object.assign(button, { type: "button", textContent: words });
    button.addEventListener("click", () => this.act(step));
    button.addEventListener("pointerup", () => button.blur()); // so that space plays
    line.append(button, after);
    return line;
  }
}
