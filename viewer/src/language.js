// Which language the page speaks: what its address says, else what the browser asks for, else English.
import words from "words";
import { knownOf, language, languages, learn, say, speak } from "./say.js";

const NAMED = ["aria-label", "title", "alt"]; // attributes with words
const element = (id) => document.getElementById(id);

export class Language {
  /** Called after another language was chosen by hand. */
  changed = () => {};

  constructor() {
    learn(words);
    this.places = placesOf(document.body);
    this.asked = null;
    this.select = element("language");
    this.select.append(...languages().map((name) => new Option(nameOf(name), name)));
    this.select.addEventListener("change", () => {
      this.take(this.select.value);
      this.changed();
    });
  }

  /** Speak a language that was asked for, or the browser's; unknown ones are as if nobody had asked. */
  take(asked) {
    this.asked = languages().includes(asked) ? asked : null;
    speak(this.asked ?? knownOf(navigator.languages ?? []));
    document.documentElement.lang = language();
    document.title = say(this.title ??= document.title);
    this.select.value = language();
    element("language-code").textContent = language().toUpperCase();
    for (const place of this.places) place.put(say(place.english));
  }
}

/** Return a language's own name. */
function nameOf(name) {
  try {
    const found = new Intl.DisplayNames([name], { type: "language" }).of(name);
    return found[0].toUpperCase() + found.slice(1);
  } catch {
    return name;
  }
}

/** Return the places of words that the page begins with: `english`, and `put(text)`. */
function placesOf(root) {
  const found = [];
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const english = node.data.trim();
    if (!isWord(english) || node.parentElement.closest("script, style, noscript")) continue;
    const here = node;
    const [before, after] = node.data.split(english);
    found.push({ english, put: (text) => (here.data = before + text + after) });
  }
  for (const one of root.querySelectorAll(NAMED.map((name) => `[${name}]`).join())) {
    for (const name of NAMED) {
      const english = one.getAttribute(name);
      if (english && isWord(english)) found.push({ english, put: (text) => one.setAttribute(name, text) });
    }
  }
  return found;
}

const isWord = (text) => /\p{L}{2}/u.test(text);
