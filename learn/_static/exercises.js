// Exercises that check themselves. Numbers and answers come from polhode, computed while the page was built.
// A plain script: browsers load no modules from a disk.
const add = (parent, tag, properties = {}) => {
  const child = Object.assign(document.createElement(tag), properties);
  parent.append(child);
  return child;
};

const isClose = (value, known, tolerance) => Math.abs(value - known) <= tolerance * Math.abs(known) + (known === 0 ? 1e-12 : 0);

/** What the course says to an answer; the same as `Question.respond_to` of polhode.course. */
function respondTo(typed, answer, mistakes, hints, tolerance) {
  const text = typed.trim().replace(",", ".").replace("−", "-");
  const value = text === "" ? NaN : Number(text);
  if (!Number.isFinite(value)) return "Enter a number.";
  if (isClose(value, answer, tolerance)) return "Right.";
  const known = mistakes.findIndex((mistake) => isClose(value, mistake, tolerance));
  if (known >= 0) return hints[known];
  if (value * answer < 0) return isClose(-value, answer, tolerance) ? "The sign is wrong." : "Check the sign.";
  return Math.abs(value) > Math.abs(answer) ? "Too large." : "Too small.";
}

function showExercise(box, seed) {
  const { unit, tolerance, variants, hints } = JSON.parse(box.dataset.exercise);
  const text = box.querySelector("p");
  const row = add(box, "div");
  const input = add(row, "input", { type: "text", inputMode: "decimal", autocomplete: "off", ariaLabel: `Your answer${unit ? ` in ${unit}` : ""}` });
  row.append(` ${unit} `);
  const check = add(row, "button", { type: "button", textContent: "Check" });
  const other = add(row, "button", { type: "button", textContent: "Other numbers" });
  const solve = add(row, "button", { type: "button", textContent: "Show how", hidden: true });
  const said = add(box, "output", { role: "status" });
  let shown = seed % variants.length;
  const show = () => { text.textContent = variants[shown][0]; input.value = ""; said.textContent = ""; solve.hidden = true; };
  const judge = () => {
    const [, answer, mistakes] = variants[shown];
    said.textContent = respondTo(input.value, answer, mistakes, hints, tolerance);
    said.dataset.right = String(said.textContent === "Right.");
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

/** Open the tab that holds what the address names. */
function openTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const tab = target?.closest(".sd-tab-content");
  if (!tab) return;
  document.getElementById(tab.previousElementSibling?.htmlFor)?.click();
  target.scrollIntoView();
}

if (typeof module !== "undefined") module.exports = { respondTo };
else {
  const seed = Number(new URLSearchParams(location.search).get("seed") ?? 0) || 0;
  document.querySelectorAll(".exercise").forEach((box) => showExercise(box, seed));
  document.querySelectorAll(".choice").forEach(showChoice);
  addEventListener("hashchange", openTarget);
  openTarget();
}
