// Sliders, choices and switches: each a labelled element of the page that keyboards and screen readers know.
import { between } from "./address.js";

/** Return an element with attributes and children. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== false) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

const STEPS = 1000; // of a slider on a logarithmic scale

/** A number between bounds; `say` words it, `log` spreads powers of ten evenly. */
function sliderOf(control, changed) {
  const { key, label, least, most, step = (most - least) / 400, log = false, whole = false, say } = control;
  const toPlace = (value) => (log ? (STEPS * Math.log(value / least)) / Math.log(most / least) : value);
  // the browser's last place lies below the end where the range is no multiple of the step
  const fromStep = (place) => (place + step > most + 1e-6 * step ? most : place);
  const fromPlace = (place) => (log ? Number((least * (most / least) ** (place / STEPS)).toPrecision(4)) : fromStep(place));
  const bounds = log ? { min: 0, max: STEPS, step: 1 } : { min: least, max: most, step };
  const input = element("input", { type: "range", id: key, ...bounds });
  const shown = element("output", { for: key, "aria-live": "off" });
  const row = element("div", { class: "slider" }, element("label", { for: key }, label), shown, input);
  input.addEventListener("input", () => changed(key, fromPlace(Number(input.value))));
  return {
    row,
    show(value) {
      input.value = toPlace(value);
      shown.textContent = say(value);
      input.setAttribute("aria-valuetext", say(value));
      const place = (toPlace(value) - Number(input.min)) / (Number(input.max) - Number(input.min));
      input.style.setProperty("--filled", `${100 * Math.min(1, Math.max(0, place))}%`);
    },
    rule: between(least, most, whole),
  };
}

/** One of several: short ones as buttons in a row, others as a list. */
function choiceOf({ key, label, options, list = false }, changed) {
  const allows = (value) => options.find(([name]) => name === value || (typeof value === "string" && String(name) === value))?.[0];
  const rule = { allows, wants: options.map(([name]) => name).join(" or ") };
  if (list) {
    const select = element("select", { id: key }, ...options.map(([value, words]) => element("option", { value }, words)));
    select.addEventListener("change", () => changed(key, allows(select.value)));
    const row = element("div", { class: "listed" }, element("label", { for: key }, label), select);
    return { row, rule, show: (value) => (select.value = value) };
  }
  const inputs = options.map(([value, words]) => {
    const input = element("input", { type: "radio", name: key, id: `${key}-${value}`, value });
    input.addEventListener("change", () => changed(key, value));
    return [input, element("label", { for: `${key}-${value}` }, words)];
  });
  const row = element("fieldset", { class: "choice" }, element("legend", {}, label),
    element("div", { class: "options" }, ...inputs.flat())); // prettier-ignore
  return { row, rule, show: (value) => inputs.forEach(([input]) => (input.checked = input.value === String(value))) };
}

/** On or off. */
function switchOf({ key, label }, changed) {
  const input = element("input", { type: "checkbox", id: key, role: "switch" });
  input.addEventListener("change", () => changed(key, input.checked ? 1 : 0));
  const row = element("div", { class: "switch" }, input, element("label", { for: key }, label));
  return { row, show: (value) => (input.checked = Boolean(value)), rule: between(0, 1, true) };
}

/** A button that does something with the panel. */
function buttonOf({ key, label, press }, changed, panel) {
  const button = element("button", { type: "button", id: key, class: "wide" }, label);
  button.addEventListener("click", () => press(panel, button));
  return { row: button, show() {} };
}

const KINDS = { slider: sliderOf, choice: choiceOf, switch: switchOf, button: buttonOf };

/** Return {row, show(value), rule of what a link may set, none of a button} for a description of a control. */
export const controlOf = (control, changed, panel) => KINDS[control.kind](control, changed, panel);
