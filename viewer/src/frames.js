// The frames that pictures stand in, with their captions, and the words of the page.
import { decimal, say } from "./say.js";
import { isOn, turn } from "./switches.js";

const element = (id) => document.getElementById(id);

/** Put the words of the page in their places, as text and never as markup. */
export function write({ name, title = name, summary, notes }) {
  element("name").textContent = say(title);
  element("summary").textContent = say(summary);
  element("notes").replaceChildren(...notes.map((note) => said("li", say(note))));
}

function said(tag, text, className = "") {
  const found = document.createElement(tag);
  found.textContent = text;
  if (className) found.className = className;
  return found;
}

/** Add an empty frame and return its canvas. */
export function addFrame(panel, view) {
  const frame = document.createElement("figure");
  frame.className = panel.flat ? "panel flat" : "panel";
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  if (!panel.flat) {
    canvas.tabIndex = 0;
    view.listen(canvas);
    canvas.addEventListener("keydown", (event) => {
      if (view.key(event.key)) event.preventDefault();
    });
  }
  const button = document.createElement("button");
  button.type = "button";
  button.className = "enlarge";
  frame.append(canvas, document.createElement("figcaption"), button);
  element("panels").append(frame);
  return canvas;
}

/**
 * Write what a picture shows above and below it, and on the button that makes it large.
 *
 * @param redraw called after a checkbox of the legend has shown or hidden something
 */
export function caption(canvas, panel, data, redraw = () => {}) {
  const place = canvas.nextElementSibling;
  const up = panel.title === "The body in space" && data.up === "L" ? "L points up" : "";
  const words = said("span", [panel.words, up].filter(Boolean).map((text) => say(text)).join("; "), "words");
  const legend = said("span", "", "legend");
  for (const entry of panel.legend) legend.append(legendItem(entry, redraw));
  const heading = said("span", "", "heading");
  heading.append(said("strong", say(panel.title)), words);
  place.replaceChildren(heading, legend);
  place.nextElementSibling.setAttribute("aria-label", say("Make large: {picture}", { picture: say(panel.title) }));
  const turns = panel.flat ? "" : ` ${say("Arrow keys turn the view, page up and down bring it closer.")}`;
  canvas.setAttribute("aria-label", `${[panel.title, panel.words].filter(Boolean).map((text) => say(text)).join(": ")}.${turns}`);
  canvas.parentElement.dataset.held = say("The wheel zooms. Esc lets go.");
}

/** Return an entry of a legend; one with a key has a checkbox, one with an action a button. */
function legendItem(entry, redraw) {
  const swatch = document.createElement("i");
  if (entry.color) swatch.style.background = entry.color;
  if (entry.press) {
    const button = said("button", say(entry.text));
    button.type = "button";
    button.setAttribute("aria-pressed", String(entry.pressed()));
    button.addEventListener("click", () => {
      entry.press();
      button.setAttribute("aria-pressed", String(entry.pressed()));
      redraw();
    });
    return button;
  }
  const item = document.createElement(entry.key ? "label" : "span");
  if (entry.key) {
    const box = document.createElement("input");
    Object.assign(box, { type: "checkbox", checked: isOn(entry) });
    box.dataset.part = entry.key;
    box.setAttribute("aria-label", say("show {part}", { part: say(entry.text) }));
    box.addEventListener("change", () => {
      turn(entry.key, box.checked);
      redraw();
    });
    item.append(box);
  }
  item.append(swatch, say(entry.text));
  return item;
}

/** Show pairs of a name and a value as a list. */
export function list(root, pairs) {
  root.replaceChildren(...pairs.map(([name, value]) => {
    const pair = document.createElement("div");
    pair.append(said("dt", say(name)), said("dd", decimal(say(value))));
    return pair;
  }));
}
