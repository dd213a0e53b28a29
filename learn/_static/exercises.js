// Exercises that check themselves. Numbers and answers come from polhode, computed while the page was built.
// A plain script: browsers load no modules from a disk.
const add = (parent, tag, properties = {}) => {
  const child = Object.assign(document.createElement(tag), properties);
  parent.append(child);
  return child;
};

const MIN_DIGITS = 2; // of an answer that is right to its digits
const NUMBER = /^[+-]?(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d+))?$/;

/** How many digits an answer needs so that its rounding stays within a relative tolerance. */
const wantedDigits = (tolerance) => 1 + Math.ceil(Math.log10(0.5 / tolerance) - 1e-9);

/** How many digits a number has, and half a unit of its last one; 1200 and 200 have two. */
function precision([, whole, part = "", power = "0"]) {
  const figures = (whole + part).replace(/^0+/, "");
  const zeros = part ? 0 : figures.length - figures.replace(/0+$/, "").length;
  const ending = Math.max(0, Math.min(zeros, figures.length - MIN_DIGITS));
  return [figures.length - ending, 0.5 * 10 ** (Number(power) - part.length + ending)];
}

/** The response of the course to an answer; equal to `respond` of polhode.course.responses. */
function respondTo(typed, answer, mistakes, hints, tolerance) {
  const text = typed.trim().replace(",", ".").replace("−", "-");
  const found = NUMBER.exec(text);
  const value = found && /\d/.test(text) ? Number(text) : NaN;
  if (!Number.isFinite(value)) return "Enter a number.";
  const [digits, half] = precision(found);
  const close = (known) => Math.abs(value - known) <= tolerance * Math.abs(known) + (known === 0 ? 1e-12 : 0);
  const rounds = (known) => digits >= MIN_DIGITS && Math.abs(value - known) <= half * (1 + 1e-9);
  if (close(answer)) return "Right.";
  const first = [mistakes.findIndex(close), mistakes.findIndex(rounds)].find((k) => k >= 0);
  if (rounds(answer)) {
    return first === undefined ? `Right to ${digits} digits.` : `To these digits other answers look alike: give ${wantedDigits(tolerance)}.`;
  }
  if (first !== undefined) return hints[first];
  if (Math.abs(value - answer) <= half) return `Give ${wantedDigits(tolerance)} digits.`;
  if (value * answer < 0) return close(-answer) || rounds(-answer) ? "The sign is wrong." : "Check the sign.";
  return Math.abs(value) > Math.abs(answer) ? "Too large." : "Too small.";
}

function showExercise(box, seed) {
  const { unit, tolerance, variants, hints } = JSON.parse(box.dataset.exercise);
  const text = box.querySelector("p");
  const row = add(box, "div");
  const input = add(row, "input", { type: "text", inputMode: "decimal", autocomplete: "off", ariaLabel: `Your answer${unit ? ` in ${unit}` : ""}` });
  row.append(` ${unit} (${wantedDigits(tolerance)} digits) `);
  const check = add(row, "button", { type: "button", textContent: "Check" });
  const other = add(row, "button", { type: "button", textContent: "Other numbers" });
  const solve = add(row, "button", { type: "button", textContent: "Show how", hidden: true });
  const said = add(box, "output", { role: "status" });
  let shown = seed % variants.length;
  const show = () => { text.textContent = variants[shown][0]; input.value = ""; said.textContent = ""; solve.hidden = true; };
  const judge = () => {
    const [, answer, mistakes] = variants[shown];
    said.textContent = respondTo(input.value, answer, mistakes, hints, tolerance);
    said.dataset.right = String(said.textContent.startsWith("Right"));
    solve.hidden = said.textContent === "Enter a number.";
  };
  check.onclick = judge;
  input.onkeydown = (event) => { if (event.key === "Enter") judge(); };
  other.onclick = () => { shown = (shown + 1) % variants.length; show(); input.focus(); };
  solve.onclick = () => { said.textContent = variants[shown][3]; said.dataset.right = "false"; };
  show();
}

function showChoice(box) {
  const { options } = JSON.parse(box.dataset.choice);
  const group = add(box, "div", { role: "radiogroup", ariaLabel: box.querySelector("p").textContent });
  options.forEach((option) => {
    const label = add(group, "label");
    const button = add(label, "input", { type: "radio", name: box.id });
    add(label, "span", { textContent: option.text });
    button.onchange = () => { said.textContent = option.response; said.dataset.right = String(option.right); };
  });
  const said = add(box, "output", { role: "status" });
}

/** Return what an address names; half an escape, as of a link that was cut off, names nothing. */
function named(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return "";
  }
}

/** Return the number of the set of numbers that an address asks for: a whole one that is not negative, or the first. */
function seedOf(search) {
  const seed = Number(new URLSearchParams(search).get("seed") ?? 0);
  return Number.isSafeInteger(seed) && seed >= 0 ? seed : 0;
}

/** Open the tab that holds what the address names. */
function openTarget() {
  const target = document.getElementById(named(location.hash.slice(1)));
  const tab = target?.closest(".sd-tab-content");
  if (!tab) return;
  document.getElementById(tab.previousElementSibling?.htmlFor)?.click();
  target.scrollIntoView();
}

if (typeof module !== "undefined") module.exports = { named, respondTo, seedOf };
else {
  const seed = seedOf(location.search);
  document.querySelectorAll(".exercise").forEach((box) => showExercise(box, seed));
  document.querySelectorAll(".choice").forEach(showChoice);
  addEventListener("hashchange", openTarget);
  openTarget();
}
